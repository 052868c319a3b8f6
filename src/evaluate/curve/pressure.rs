//! The pressure curve of one contact: p as the right-sided half-order integral of Legendre expansions of g′ in x².

use super::build::{self, Budget};
use super::piece::{Integral, Piece, Share, SquaredRadius};
use super::source::Source;
use crate::derive::stream::Stream;
use crate::integrate::error::TransformError;
use crate::integrate::integral::NumericProfile;
use crate::integrate::pressure::direct::{Jump, kernel_at};
use crate::integrate::pressure::legendre::Expansion;
use crate::num::spectral::{above, chop, right_sided, rule};
use crate::num::stable::leg;
use crate::num::{Bounded, Estimate, work};
use std::ops::Deref;
use std::sync::Arc;

/// p(r)·π/E* = ∫_r^a g′/√(x² − r²) dx of one contact with a smooth edge, for many radii r.
///
/// g′ without the contribution of jumps is a half-order integral of (r f′)′; its Legendre expansion over pieces of x² gives p
/// term by term. The jumps δ of f′ at b add b δ K(b, r), with K by Carlson's R_F.
///
/// ```
/// use sneddon::{expr::{Bindings, Expr}, parse, transform::{Curve, Evaluator, Method, Profile, derive}};
/// let profile = Profile::new(&parse::profile("r^2/2").unwrap()).unwrap();
/// let solution = derive(&profile).unwrap();
/// let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
/// let curve = Curve::new(evaluator.typed().unwrap(), 1.0, 1e-13).unwrap();
/// let p = curve.pressures(1.0).unwrap().at(0.6).unwrap().unwrap();
/// assert!((p.value - 2.0 * 0.8).abs() <= p.error && p.error < 1e-13);
/// ```
pub struct PressureCurve<'a> {
    profile: Held<'a>,
    a: f64,
    /// In increasing order.
    parts: Vec<Part>,
    jumps: Vec<Jump>,
    steep: bool,
    evaluations: u64,
    doubt: f64,
    /// The error relative to 2√(a² − r²) at radii given by √(1 − r²/a²), in decreasing order; empty if every part has an error.
    relative: Vec<(f64, f64)>,
}

/// A profile that the curve borrows, or shares with its evaluator.
enum Held<'a> {
    Borrowed(&'a NumericProfile),
    Shared(Arc<NumericProfile>),
}

impl Deref for Held<'_> {
    type Target = NumericProfile;

    fn deref(&self) -> &NumericProfile {
        match self {
            Self::Borrowed(own) => own,
            Self::Shared(own) => own,
        }
    }
}

/// g′/(2x) = Σ c_k P_k on one piece of x².
struct Part {
    lower: f64,
    upper: f64,
    length: f64,
    /// c_k/(2k+1).
    divided: Vec<f64>,
    /// A bound on the error of the sum.
    noise: f64,
    /// False if the piece is an unresolved one next to a breakpoint, where the curve is not defined.
    fine: bool,
}

/// Maximum number of halvings of pieces next to a breakpoint.
const DEEPEST: u32 = 52;
/// Steps of work for a part besides its terms, and for the kernel of a jump.
const PART: u64 = 2;
const JUMP: u64 = 10;
const COUNTS: [usize; 3] = [16, 32, 64];
/// The tolerance of the quadrature used near breakpoints, and of the check.
const CHECK: f64 = 1e-13;

/// Points at which the error of a single expansion is evaluated; it grows towards the edge.
const SINES: [f64; 8] = [1.0, 0.5, 0.25, 0.12, 0.06, 0.03, 0.01, 1e-3];

impl<'a> PressureCurve<'a> {
    /// The pressure under a contact of radius a: a single expansion if f′ is odd and without a kink up to a, else pieces.
    ///
    /// # Errors
    /// [`TransformError::NotComputable`] if f′ is not finite or too irregular below a,
    /// [`TransformError::NoClosedForm`] if (r f′)′ is not known.
    pub fn new(profile: &'a NumericProfile, a: f64) -> Result<Self, TransformError> {
        Self::of(Held::Borrowed(profile), a)
    }

    fn of(profile: Held<'a>, a: f64) -> Result<Self, TransformError> {
        match profile.pressure_terms(a) {
            Some(expansion) => Ok(Self::whole(profile, a, &expansion)),
            None => Self::by_pieces(profile, a),
        }
    }

    fn whole(profile: Held<'a>, a: f64, expansion: &Expansion) -> Self {
        let relative = SINES.iter().map(|sine| (*sine, expansion.relative_doubt(*sine))).collect();
        let part = Part { lower: 0.0, upper: a, length: a * a, divided: divided(&expansion.rise()), noise: 0.0, fine: true };
        let evaluations = expansion.evaluations;
        let mut curve = Self { profile, a, parts: vec![part], jumps: Vec::new(), steep: false, evaluations, doubt: 1.0, relative };
        curve.doubt = curve.check();
        curve
    }

    fn by_pieces(profile: Held<'a>, a: f64) -> Result<Self, TransformError> {
        let mut budget = Budget::default();
        let (mut pieces, mut ends) = (Vec::new(), Vec::new());
        for segment in &profile.segments {
            ends.extend(
                [Some(segment.lower), segment.upper].into_iter().flatten().map(|end| end.value).filter(|end| *end > 0.0 && *end < a),
            );
            if segment.lower.value >= a {
                continue;
            }
            let sources = Source::of_bend(segment);
            if sources.is_empty() {
                return Err(TransformError::NoClosedForm { quantity: "the derivative (r f′)′" });
            }
            for source in sources {
                pieces.extend(build::pieces(&source, a, &mut budget)?);
                budget.pieces = pieces.len();
            }
        }
        ends.push(a);
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let mut parts = Vec::new();
        let mut from = 0.0;
        for to in ends {
            let mut work = Work { pieces: &pieces, anchor: from, parts: &mut parts, end: a };
            if pieces.iter().any(|piece| piece.lower < to) {
                work.cover(from, to, 0)?;
            }
            from = to;
        }
        let (jumps, steep) = (profile.jumps(a), profile.starts_steeply(a));
        let mut curve = Self { profile, a, parts, jumps, steep, evaluations: budget.evaluations, doubt: 1.0, relative: Vec::new() };
        curve.doubt = curve.check();
        Ok(curve)
    }

    /// The factor by which errors must grow to agree with the quadrature at a random radius.
    fn check(&self) -> f64 {
        let s = self.a * Stream::new(self.a.to_bits()).uniform();
        let (Ok(Some(own)), Ok(Some(exact))) = (self.at(s), self.profile.pressure(s, self.a, CHECK)) else { return 1.0 };
        let beyond = (own.value - exact.value).abs() - exact.error;
        if own.error > 0.0 && beyond > own.error { 3.0 * beyond / own.error } else { 1.0 }
    }

    /// p(r)·π/E*; `None` if it is theoretically infinite: at a kink, and at the axis under a tip with f′(0) ≠ 0.
    ///
    /// Quadrature is used near a breakpoint, and near the axis if f′ is not smooth there.
    ///
    /// # Errors
    /// [`TransformError`] if that quadrature has no reliable digit.
    pub fn at(&self, r: f64) -> Result<Option<Estimate>, TransformError> {
        if r >= self.a {
            return Ok(Some(Estimate::exact(0.0)));
        }
        if (r == 0.0 && self.steep) || self.jumps.iter().any(|jump| jump.at.value == r && jump.height.value != 0.0) {
            return Ok(None);
        }
        if self.parts.iter().any(|part| !part.fine && part.lower <= r && r < part.upper) {
            return self.profile.pressure(r, self.a, CHECK);
        }
        let (mut value, mut error) = (0.0, 0.0);
        work::spend(JUMP * self.jumps.len() as u64);
        for part in self.parts.iter().rev() {
            let Some((own, doubt)) = part.share(r) else { break };
            work::spend(PART + part.divided.len() as u64 / 2);
            value += own;
            error += doubt;
        }
        if !self.relative.is_empty() {
            let root = leg(self.a, r);
            // Errors increase towards the edge, so the error of the next tabulated radius outward is a bound.
            let outer = self.relative.iter().find(|(sine, _)| sine * self.a <= root).or(self.relative.last());
            error = 2.0 * root * outer.map_or(f64::INFINITY, |(_, relative)| 1.5 * relative);
        }
        let smooth = Bounded { value, error: self.doubt * (error + 8.0 * f64::EPSILON * value.abs()) };
        let jumps = self.jumps.iter().filter(|jump| jump.height.value != 0.0);
        let total = jumps.fold(smooth, |sum, jump| sum + jump.at * jump.height * kernel_at(jump.end, r, self.a));
        Ok(Some(Estimate::estimated(total.value, total.error, 0)))
    }

    /// The radius of the contact.
    pub fn radius(&self) -> f64 {
        self.a
    }

    /// Evaluations of (r f′)′ used to build the curve.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }
}

impl PressureCurve<'static> {
    /// The same curve, which keeps the profile.
    ///
    /// # Errors
    /// As [`PressureCurve::new`].
    pub(crate) fn shared(profile: Arc<NumericProfile>, a: f64) -> Result<Self, TransformError> {
        Self::of(Held::Shared(profile), a)
    }
}

impl Part {
    /// The contribution to p at r and its error; `None` if the piece lies below r.
    fn share(&self, r: f64) -> Option<(f64, f64)> {
        let to_upper = (self.upper - r) * (self.upper + r);
        if to_upper <= 0.0 {
            return None;
        }
        let to_lower = (self.lower - r) * (self.lower + r);
        if to_lower <= 0.0 {
            return Some((right_sided(&self.divided, to_upper, self.length), 2.0 * self.noise * to_upper.sqrt()));
        }
        let weight = 2.0 * self.length / (to_lower.sqrt() + to_upper.sqrt());
        Some((above(&self.divided, to_lower, to_upper, self.length), self.noise * weight))
    }
}

struct Work<'a> {
    pieces: &'a [Piece],
    anchor: f64,
    parts: &'a mut Vec<Part>,
    end: f64,
}

impl Work<'_> {
    fn cover(&mut self, lower: f64, upper: f64, depth: u32) -> Result<(), TransformError> {
        work::check()?;
        let length = (upper - lower) * (upper + lower);
        let below = (lower - self.anchor) * (lower + self.anchor);
        let mut last = None;
        for count in COUNTS {
            let rule = rule(count, 0.0);
            let (mut values, mut noise, mut scale) = (Vec::with_capacity(count), 0.0_f64, 0.0_f64);
            for node in rule.nodes() {
                let place = SquaredRadius::new(self.anchor, below + length * node.unit);
                let sum = self.pieces.iter().fold(Share::default(), |sum, piece| sum + piece.share(Integral::Root, place, 0.0));
                let over = 0.5 / place.x;
                // Towards the lower end, the contribution of every node to the integral decreases.
                noise = noise.max(over * (sum.noise + 4.0 * f64::EPSILON * sum.size) * node.unit.sqrt());
                scale = scale.max(over * sum.value.abs());
                values.push(over * sum.value);
            }
            if !values.iter().all(|value| value.is_finite()) {
                return Err(TransformError::NotComputable { at: self.end });
            }
            let mut coefficients = rule.coefficients(&values);
            let plateau = (4.0 * f64::EPSILON).max(if scale > 0.0 { noise / scale } else { 0.0 });
            let dropped = if scale == 0.0 { Some(0.0) } else { chop(&mut coefficients, scale, plateau) };
            let fine = dropped.is_some();
            let tail = dropped.map_or_else(|| 4.0 * coefficients.iter().skip(count / 2).map(|c| c.abs()).sum::<f64>(), |own| 2.0 * own);
            let noise = 2.0 * noise + tail + 4.0 * f64::EPSILON * scale;
            last = Some(Part { lower, upper, length, divided: divided(&coefficients), noise, fine });
            if fine {
                break;
            }
        }
        let part = last.ok_or(TransformError::NotComputable { at: self.end })?;
        if part.fine || depth >= DEEPEST {
            self.parts.push(part);
            return Ok(());
        }
        let middle = (0.5 * (lower * lower + upper * upper)).sqrt();
        if !(middle > lower && middle < upper) {
            self.parts.push(part);
            return Ok(());
        }
        self.cover(lower, middle, depth + 1)?;
        self.cover(middle, upper, depth + 1)
    }
}

fn divided(coefficients: &[f64]) -> Vec<f64> {
    coefficients.iter().enumerate().map(|(k, c)| c / (2.0 * k as f64 + 1.0)).collect()
}
