//! The fallback: every quantity as one integral over f′, by quadrature.

use crate::eval::{Tape, constant_value};
use crate::expr::{Bindings, Expr, Node, Symbol, balanced, derivative, joined_powers, normal, rewritten};
use crate::integrate::abel::angle_substitution::NEAR_THE_LIMIT;
use crate::integrate::ask::{BISECTION, By, GAUSS, NESTED, PIECES, by, not_this_way};
use crate::integrate::error::TransformError;
use crate::integrate::segment::Segment;
use crate::integrate::source::analytic_bound::AnalyticBound;
use crate::integrate::source::centred::centred;
use crate::integrate::source::endpoint::Endpoint;
use crate::integrate::source::f_prime::{NO_BEND, Numbers, Scratch};
use crate::integrate::source::leading_power::LeadingPower;
use crate::integrate::source::limit::Limit;
use crate::integrate::source::parity::{Parity, parity};
use crate::integrate::source::removable::{AxisSeries, Removable, is_ragged};
use crate::num::quadrature::{Options, Panel, Point, Rule, integrate_blocks};
use crate::num::stable::leg;
use crate::num::{Bound, Bounded, Estimate, NumError, forms, work};
use std::sync::OnceLock;

/// A profile as numbers: f′ on every interval, compiled over the distance to the interval's lower end.
pub struct NumericProfile {
    pub(crate) segments: Vec<NumericSegment>,
}

/// One interval [lower, upper) with f′(lower + δ).
pub struct NumericSegment {
    /// The lower end.
    pub lower: Bounded,
    pub(crate) upper: Option<Bounded>,
    /// Both ends with all known digits.
    pub(crate) ends: (Endpoint, Option<Endpoint>),
    /// f′ over δ.
    pub(crate) f_prime: Numbers,
    /// f′ and its interval's lower end as expressions in r, for tapes that are compiled on demand.
    pub(crate) source: Option<(Expr, Expr)>,
    /// f′ over δ for enclosures, compiled when they are first needed.
    pub(crate) enclosing: OnceLock<Option<Tape>>,
    /// f′ = δ^s h(δ) with h finite at the lower end: s, and h for enclosures.
    pub(crate) power: OnceLock<Option<LeadingPower>>,
    /// (r f′)′ over δ, compiled at the first pressure.
    pub(crate) bend: OnceLock<Option<Numbers>>,
    /// The upper end as an expression.
    pub(crate) end: Option<Expr>,
    /// (r f′)′ over the distance to the upper end, if it is infinite there.
    pub(crate) falling: OnceLock<Option<Numbers>>,
    pub(crate) bend_enclosing: OnceLock<Option<Tape>>,
    /// As `power` for (r f′)′.
    pub(crate) bend_power: OnceLock<Option<LeadingPower>>,
    /// True if f′ behaves like a fractional power of δ at the lower end.
    pub(crate) singular: bool,
    /// True if f′ continues to an odd function of r.
    pub(crate) odd: bool,
    /// The end of f′, if known.
    pub(crate) limit: Option<Limit>,
    /// The sufficient number of nodes.
    pub(crate) continued: AnalyticBound,
    /// True if f′ begins at the axis and its expression is 0/0 there.
    pub(crate) ragged: bool,
    /// The series that is accurate near the axis.
    pub(crate) near: Option<AxisSeries>,
}

/// The factor of f′ in the integral over t, r = x sin t.
#[derive(Clone, Copy, Debug)]
pub enum Weight {
    /// 1: g(x) = x ∫ f′ dt.
    Equivalent,
    /// sin²t: F(a)/(2E*) = a² ∫ f′ sin²t dt.
    Force,
    /// cos²t: G(a) = a² ∫ f′ cos²t dt.
    Integral,
    /// The smooth part of the displacement outside, u(r) = (2a/π) ∫ f′ [(α − A) + (1 − cos t) A] dt.
    Outside(f64),
}

impl NumericProfile {
    /// Compiles f′ on the given intervals, parameters replaced by the bindings.
    ///
    /// # Errors
    /// [`TransformError::Evaluation`] if a parameter has no value.
    pub fn new(pieces: &[(Segment, Expr)], bindings: &Bindings) -> Result<Self, TransformError> {
        let mut segments = Vec::new();
        for (segment, f_prime) in pieces {
            if f_prime.is_zero() {
                continue;
            }
            let lower_expr = bindings.apply(&segment.lower);
            let lower = constant_value(&lower_expr, &Bindings::default())?;
            let upper = segment.upper.as_ref().map(|upper| constant_value(upper, bindings)).transpose()?;
            let f_prime_expr = prepared(f_prime, bindings);
            let tape = compile_shifted(&f_prime_expr, &lower_expr)?;
            let f_prime = Numbers::Tape(tape);
            // Cancellation in a polynomial of high degree must not count as a singularity.
            let singular =
                typed_degree(&f_prime_expr, &Symbol::new("r")).is_none() && is_singular(&f_prime, lower.value, upper.map(|u| u.value));
            let scale = upper.map_or(1.0, |upper| upper.value);
            let ragged = lower_expr.is_zero() && matches!(&f_prime, Numbers::Tape(tape) if is_ragged(&f_prime_expr, tape, singular, scale));
            let odd = parity(&f_prime_expr, &Symbol::new("r")) == Some(Parity::Odd);
            let end = segment.upper.as_ref().map(|upper| bindings.apply(upper));
            let last = end.as_ref().zip(upper).map(|(end, upper)| Endpoint::of(end, upper)).transpose()?;
            let ends = (Endpoint::of(&lower_expr, lower)?, last);
            let source = Some((f_prime_expr, lower_expr));
            segments.push(NumericSegment {
                lower,
                upper,
                ends,
                f_prime,
                source,
                enclosing: OnceLock::new(),
                power: OnceLock::new(),
                bend: OnceLock::new(),
                end,
                falling: OnceLock::new(),
                bend_enclosing: OnceLock::new(),
                bend_power: OnceLock::new(),
                singular,
                odd,
                limit: None,
                continued: AnalyticBound::default(),
                ragged,
                near: None,
            });
        }
        Ok(Self { segments })
    }

    /// Sets the end of the profile: near the end, f′ is computed from the distance to it.
    ///
    /// # Errors
    /// [`TransformError::Evaluation`] if a parameter has no value.
    pub fn ending_at(mut self, limit: &Expr, bindings: &Bindings) -> Result<Self, TransformError> {
        let limit = bindings.apply(limit);
        let value = constant_value(&limit, &Bindings::default())?;
        for segment in self.segments.iter_mut().filter(|segment| segment.upper.is_none()) {
            let Some((f_prime, _)) = &segment.source else { continue };
            let below = shifted(f_prime, &limit, &-Expr::from(Symbol::new("δ")));
            segment.limit = Some(Limit::new(value, below)?);
        }
        Ok(self)
    }

    /// True if the profile has no terms to integrate.
    pub fn is_empty(&self) -> bool {
        self.segments.is_empty()
    }

    /// Returns true if quadrature of f′ up to x can serve as a reference.
    ///
    /// It cannot if more than 1e-9 of ∫ f′ dr may lie below the smallest doubles at a lower end, because f′ is a power just above
    /// −1.
    pub fn is_seen(&self, x: f64) -> bool {
        const UNSEEN: f64 = 1e-9;
        // Use the second radius if f′ as typed is out of range at the first.
        const TINY: [f64; 2] = [1e-290, 1e-100];
        let share = |segment: &NumericSegment| {
            let reach = segment.upper.map_or(x, |upper| upper.value.min(x)) - segment.lower.value;
            if !segment.singular || reach <= 0.0 {
                return 0.0;
            }
            let far = segment.f_prime.plain(reach);
            let near = TINY.into_iter().map(|tiny| segment.f_prime.plain(tiny * reach) * tiny).find(|near| near.is_finite());
            near.filter(|near| *near != 0.0).map_or(0.0, |near| (near / far).abs())
        };
        self.segments.iter().map(share).fold(0.0, f64::max) <= UNSEEN
    }

    /// True if a piece that is not flat lies below the contact's end, so that an integral is 0 only by underflow.
    pub(crate) fn reaches(&self, contact: f64) -> bool {
        self.segments.iter().any(|segment| segment.lower.value < contact)
    }
}

/// Near the end of f′, the rules use this fraction of the tolerance, within these limits.
const SHARPER: f64 = 1e-3;
const SHARP: (f64, f64) = (1e-14, 1e-12);
/// Elsewhere, the rules use this fraction if it is looser than the limit, because the error of barely resolved features is the
/// hardest to estimate.
const STRICTER: f64 = 1e-2;
const STRICT: f64 = 1e-8;

/// If the range is split, features may hide between nodes in every part, so the rules use this fraction of the tolerance.
const CUT: f64 = 0.1;

/// The tolerance of the rules away from ends, stricter than the reported one.
pub(crate) fn stricter(tolerance: f64) -> f64 {
    tolerance.min((STRICTER * tolerance).max(STRICT))
}

/// If f′ is not analytic sufficiently far around the contact, or grows too fast there, it has a narrow feature: the rules use
/// this fraction of the tolerance, down to a limit.
const INTRICATE: f64 = 1e-2;
const FINEST: f64 = 1e-13;

/// The tolerance of the rules for an f′ with a narrow feature.
pub(crate) fn intricate(tolerance: f64) -> f64 {
    stricter(tolerance).min((INTRICATE * tolerance).max(FINEST))
}

/// Reports at least the requested tolerance as the error if the truncation error exceeds the rounding noise, that is, if the
/// error is of the size of the tolerance of the rules.
pub(crate) fn modest(found: Estimate, own: f64, asked: f64) -> Estimate {
    let least = if found.error >= 0.5 * own { 0.95 * asked } else { 0.0 };
    Estimate { error: found.error.max(least), ..found }
}

/// Points at which the range is split before any bisection, as fractions of the range: the feature that the nested rules did not
/// resolve may be a core at the lower end, narrower than the distance to the first node of a rule over the whole range.
/// The points are close enough for a tail that begins at one of them to be detected from the next.
pub(crate) const GRADES: &[f64] = &[1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1];

/// Angles from the edge at which the range of a displacement outside is split, relative to that within which its weight turns.
const TURNS: [f64; 3] = [1.0, 30.0, 1000.0];

/// Most points of a rule.
pub(crate) const MOST_POINTS: usize = 61;

impl NumericSegment {
    /// The part of the integral on this interval; 0 if it begins beyond x.
    pub(crate) fn over_angle(&self, x: f64, weight: Weight, tolerance: f64, by: By) -> Result<Estimate, TransformError> {
        let smear = self.smear(x);
        if self.lower.value >= x {
            return Ok(Estimate { error: smear, ..Estimate::exact(0.0) });
        }
        let found = match by {
            By::Cheapest => self.in_the_cheapest_way(x, weight, tolerance)?,
            By::Rule(rule) => self.by_bisection(x, weight, tolerance, Some(rule), &[])?,
            By::Only(key) => self.in_the_way(key, x, weight, tolerance)?.ok_or(not_this_way(key))?,
        };
        self.seen(Estimate { error: found.error + smear + self.shifted(&found, x), ..found }, x)
    }

    /// The error of the integral up to x from the error of its lower end, if that is more than a thousandth of the distance to x.
    fn shifted(&self, found: &Estimate, x: f64) -> f64 {
        /// Beyond this distance, the change at the ends suffices.
        const FAR: f64 = 1e3;
        let (error, reach) = (self.lower.error, x - self.lower.value);
        if error == 0.0 || reach > FAR * error {
            return 0.0;
        }
        // f′ ~ δ^m gives g ~ δ^(m + 1/2), F ~ δ^(m + 1/2) and G ~ δ^(m + 3/2).
        let size = |delta: f64| self.f_prime_at(delta).value.abs();
        let power = (size(reach) / size(0.5 * reach)).log2();
        if power.is_nan() {
            return f64::INFINITY;
        }
        found.value.abs() * ((1.0 + error / reach).powf(power.max(0.0) + 1.5) - 1.0)
    }

    /// The estimate, unless every sample of a formula vanished and no enclosure proves that the formula vanishes.
    fn seen(&self, found: Estimate, at: f64) -> Result<Estimate, TransformError> {
        let nothing = found.value == 0.0 && found.bound == Bound::Estimated && found.evaluations > 0 && self.source.is_some();
        if nothing { Err(TransformError::NoDigits { at, value: 0.0, error: found.error }) } else { Ok(found) }
    }

    fn in_the_cheapest_way(&self, x: f64, weight: Weight, tolerance: f64) -> Result<Estimate, TransformError> {
        let cuts = self.places_to_cut(x, weight, tolerance);
        if cuts.is_empty() {
            if let Some(found) = by(GAUSS, self.by_known_rule(x, weight, tolerance))? {
                return Ok(found);
            }
            if let Some(found) = self.by_pieces_or_nested(x, weight, tolerance)? {
                return Ok(found);
            }
        }
        self.by_bisection(x, weight, tolerance, None, &cuts)
    }

    /// The integral by the way with the given key; `None` if the way does not apply.
    fn in_the_way(&self, key: &'static str, x: f64, weight: Weight, tolerance: f64) -> Result<Option<Estimate>, TransformError> {
        let found = match key {
            BISECTION => self.by_bisection(x, weight, tolerance, None, &self.places_to_cut(x, weight, tolerance)).map(Some),
            // A rule over the whole range would extend across the ends of the parts of f′.
            _ if !self.places_to_cut(x, weight, tolerance).is_empty() => Ok(None),
            GAUSS => self.by_known_rule(x, weight, tolerance),
            PIECES => self.by_pieces(x, weight, tolerance),
            NESTED => self.by_nested_rules(x, weight, tolerance),
            _ => Ok(None),
        };
        by(key, found)
    }

    /// Points within the interval below x, measured from the lower end, at which f′ is split into parts, or into resolved pieces
    /// for an integral without a proven bound.
    fn places_to_cut(&self, x: f64, weight: Weight, tolerance: f64) -> Vec<f64> {
        if matches!(weight, Weight::Outside(_)) && self.f_prime.is_expression() {
            return self.features(x, tolerance);
        }
        self.f_prime.cuts(self.upper.map_or(x, |upper| upper.value.min(x)) - self.lower.value)
    }

    /// By adaptive quadrature over the angle, with the default rule unless another is named.
    fn by_bisection(&self, x: f64, weight: Weight, tolerance: f64, rule: Option<Rule>, cuts: &[f64]) -> Result<Estimate, TransformError> {
        let lower = self.lower.value;
        let end = self.upper.map_or(f64::INFINITY, |u| u.value);
        let width = forms::angle_between(lower, end, x);
        let beyond = if end < x { leg(x, end).atan2(end) } else { 0.0 };
        let mut scratch = Scratch::take();
        let grades = if rule.is_none() && !self.singular && end >= x { GRADES } else { &[] };
        // The angles from the lower end and to the upper end; points are measured from the ends of their panels.
        let mut ends: Vec<f64> = grades.iter().map(|share| share * width).collect();
        ends.extend(cuts.iter().map(|cut| forms::angle_between(lower, lower + cut, x)).filter(|angle| *angle > 0.0 && *angle < width));
        if let Weight::Outside(r) = weight {
            // Next to the edge the weight turns within an angle of this size at the upper end.
            let turn = (r - x).sqrt() * (r + x).sqrt() / x;
            ends.extend(TURNS.map(|share| width - (share * turn - beyond)).into_iter().filter(|angle| *angle > 0.0 && *angle < width));
        }
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let (first, last) = (ends.first().copied(), ends.last().copied());
        ends.push(width);
        let place = |point: &Point| {
            let last = last.is_none_or(|end| point.x > end);
            let v = if first.is_none_or(|end| point.x < end) { point.from_lower } else { point.x };
            (v, beyond + if last { point.from_upper } else { width - v })
        };
        let mut integrand = |points: &[Point], heights: &mut [Bounded]| {
            let nodes = self.f_prime_over_angle(lower, x, points.iter().map(place), &mut scratch);
            let known = nodes.slopes.into_iter().zip(nodes.distances).zip(nodes.doubts);
            for ((height, point), ((f_prime, distance), doubt)) in heights.iter_mut().zip(points).zip(known) {
                let (_, rest) = place(point);
                *height = match weight {
                    Weight::Equivalent => f_prime,
                    Weight::Force => {
                        let share = (self.lower + Bounded { value: distance, error: doubt }) / Bounded::exact(x);
                        f_prime * share * share
                    }
                    Weight::Integral => {
                        let cosine = with_ulps(rest.sin(), 8.0);
                        f_prime * cosine * cosine
                    }
                    Weight::Outside(r) => {
                        // Multiply the roots separately: the product under one root may leave the range of doubles.
                        let ratio = x / (r - x).sqrt() / (r + x).sqrt();
                        let (q, s) = (rest.sin(), (lower + distance) / x);
                        let short = s * s / (1.0 + q);
                        let angle = (q * ratio).atan();
                        f_prime * with_ulps((short * ratio).atan2(1.0 + q * ratio * ratio) + short * angle, 24.0)
                    }
                };
            }
        };
        let singular = |from: f64, to: f64| if self.singular { Panel::singular(from, to) } else { Panel::smooth(from, to) };
        let from = std::iter::once(0.0).chain(ends.iter().copied());
        let panels: Vec<Panel> = from.zip(ends.iter().copied()).map(|(from, to)| singular(from, to)).collect();
        // Just below the end of f′, a pole or a root is too narrow for widely spaced nodes.
        let near_the_end = self.limit.as_ref().is_some_and(|limit| x > 0.7 * limit.value.value);
        let rel_tol = if near_the_end {
            (SHARPER * tolerance).clamp(SHARP.0, SHARP.1).min(tolerance)
        } else {
            stricter(tolerance).min(CUT * tolerance)
        };
        let options = Options { rel_tol, charge_x: false, rule: rule.unwrap_or_default(), ..Options::default() };
        let result = integrate_blocks(&mut integrand, &panels, &options);
        let inner = |v: f64| {
            let mut found = [Bounded::exact(0.0)];
            integrand(&[Point { x: v, from_lower: v, from_upper: width - v }], &mut found);
            found[0].value
        };
        let found = settle(result, x, || magnitude(width, inner))?;
        let mut found = modest(found, rel_tol * found.value.abs(), tolerance * found.value.abs());
        // The rounding of the angle.
        found.error += 8.0 * f64::EPSILON * found.value.abs();
        Ok(found.by(BISECTION))
    }

    /// By pieces with a proven bound, or by nested rules, which have a special variable near the end of f′. Nested rules come
    /// first if no narrow feature is possible; otherwise they are used if they are more accurate and consistent with the proven
    /// bound.
    fn by_pieces_or_nested(&self, x: f64, weight: Weight, tolerance: f64) -> Result<Option<Estimate>, TransformError> {
        let nested = || by(NESTED, self.by_nested_rules(x, weight, tolerance));
        let end = self.limit.as_ref().filter(|limit| x > NEAR_THE_LIMIT * limit.value.value);
        if end.is_some_and(|end| end.is_featureless(self.lower.value))
            && let Ok(Some(found)) = nested()
        {
            return Ok(Some(found));
        }
        let near_the_end = end.is_some();
        let proven = by(PIECES, self.by_pieces(x, weight, tolerance)).ok().flatten();
        let nested = match proven {
            Some(proven) if !near_the_end || proven.error <= tolerance * proven.value.abs() => return Ok(Some(proven)),
            _ if near_the_end => nested().ok().flatten(),
            _ => nested()?,
        };
        Ok(match (proven, nested) {
            (Some(proven), Some(nested)) => Some(if nested.is_better_than(proven) { nested } else { proven }),
            (proven, nested) => proven.or(nested),
        })
    }

    /// The change of the integral due to the uncertainty of the ends of the interval.
    pub(crate) fn smear(&self, x: f64) -> f64 {
        let arc = |end: Bounded| {
            // Adding it to the end causes an error of half a unit.
            let (from, to) = ((end.value - end.error).next_down().max(0.0), (end.value + end.error).next_up());
            if end.error == 0.0 || from >= x { 0.0 } else { forms::angle_between(from, if to < x { to } else { f64::INFINITY }, x) }
        };
        let (lower, upper) = (arc(self.lower), self.upper.map_or(0.0, arc));
        if lower + upper == 0.0 {
            return 0.0;
        }
        let end = self.upper.map_or(x, |u| u.value.min(x));
        let size = |delta: f64| self.f_prime_at(delta).value.abs();
        let at_lower = if lower == 0.0 { 0.0 } else { self.mean_size(2.0 * self.lower.error) };
        // Doubled, because f′ is evaluated at the ends and the weights are below 2.
        2.0 * (lower * at_lower + upper * size((end - self.lower.value).max(f64::MIN_POSITIVE)))
    }

    /// Returns an upper bound on the mean of |f′| over a short distance from the lower end, at which f′ may be infinite.
    fn mean_size(&self, distance: f64) -> f64 {
        const RATIO: f64 = 0.25;
        let size = |delta: f64| self.f_prime_at(delta).value.abs();
        let (at_end, far) = (size(f64::MIN_POSITIVE), size(distance));
        if at_end.is_nan() || at_end <= 2.0 * far {
            return at_end.max(far);
        }
        let (mut sum, mut outer) = (0.0, (distance, far));
        while outer.0 > f64::MIN_POSITIVE {
            let inner = (RATIO * outer.0).max(f64::MIN_POSITIVE);
            let inner = (inner, size(inner));
            sum += inner.1.max(outer.1) * (outer.0 - inner.0);
            outer = inner;
        }
        sum / distance
    }

    /// (r f′)′ over δ.
    pub(crate) fn bend(&self) -> Result<&Numbers, TransformError> {
        let derive = || {
            let (_, lower) = self.source.as_ref()?;
            let tape = compile_shifted(&self.bend_source()?, lower).ok()?;
            Some(match &self.near {
                Some(near) => Numbers::Removable(Box::new(Removable::bend(tape, near))),
                None => Numbers::Tape(tape),
            })
        };
        self.bend.get_or_init(|| work::prepared(derive)).as_ref().ok_or(NO_BEND)
    }

    /// (r f′)′ in r.
    pub(crate) fn bend_source(&self) -> Option<Expr> {
        let (_, lower) = self.source.as_ref()?;
        let bend = self.bend_expression()?;
        // On a segment from the axis, join powers of r that would overflow separately: r·r^(−3/2) = r^(−1/2). Do not divide:
        // r¹⁷/(R² − r²) as a polynomial plus a remainder would cancel.
        Some(if lower.is_zero() { joined_powers(&bend, &Symbol::new("r")) } else { bend })
    }

    fn bend_expression(&self) -> Option<Expr> {
        let (f_prime, _) = self.source.as_ref()?;
        derivative(&(Expr::symbol("r") * f_prime), &Symbol::new("r")).ok().map(|bend| balanced(&bend))
    }

    /// (r f′)′ over the distance to the upper end, if it is infinite there, as for |r − b|^(3/2) at b.
    pub(crate) fn falling_bend(&self) -> Option<&Numbers> {
        let derive = || {
            let (upper, end, bend) = (self.upper?, self.end.as_ref()?, self.bend().ok()?);
            let regular = bend.at(upper - self.lower, &mut Vec::new()).is_finite();
            if regular {
                return None;
            }
            let rest = Symbol::new("δ");
            let below = shifted(&self.bend_expression()?, end, &-Expr::from(rest.clone()));
            Tape::compile(&[below], &[rest]).ok().map(Numbers::Tape)
        };
        self.falling.get_or_init(|| work::prepared(derive)).as_ref()
    }
}

/// Compiles an expression in r over δ with r = lower + δ.
pub(crate) fn compile_shifted(expr: &Expr, lower: &Expr) -> Result<Tape, TransformError> {
    let delta = Symbol::new("δ");
    Ok(Tape::compile(&[shifted(expr, lower, &Expr::from(delta.clone()))], &[delta])?)
}

/// The expression from which f′ is compiled.
pub(crate) fn prepared(f_prime: &Expr, bindings: &Bindings) -> Expr {
    centred(&balanced(&bindings.apply(f_prime)))
}

/// Substitutes lower + δ for r; the constant term of polynomials that vanish at the lower end is removed before any
/// rounding, so that neither r − b nor 3r² − 3b² cancels.
pub(crate) fn shifted(expr: &Expr, lower: &Expr, delta: &Expr) -> Expr {
    const HIGHEST: usize = 6;
    let radius = Symbol::new("r");
    rewritten(expr, &|own, _| match own.node() {
        _ if !own.contains(&radius) => Some(own.clone()),
        Node::Symbol(_) => Some(lower + delta),
        Node::Sum(_) => {
            let vanishing = Some(own)
                .filter(|own| typed_degree(own, &radius).is_some_and(|degree| degree < HIGHEST))
                .and_then(|own| normal::polynomial_coefficients(own, &radius))
                .and_then(|list| normal::shifted_coefficients(&list, lower, &radius))
                .filter(|list| list.first().is_some_and(|(k, _)| *k > 0))?;
            Some(Expr::sum(vanishing.iter().map(|(k, c)| c * delta.power(*k))))
        }
        _ => None,
    })
}

/// The degree of a polynomial in the variable as it is typed, of which expansion may cancel the highest terms; `None` for what is not a
/// sum, product or integer power of the variable and of constants.
pub(crate) fn typed_degree(expr: &Expr, variable: &Symbol) -> Option<usize> {
    match expr.node() {
        _ if !expr.contains(variable) => Some(0),
        Node::Symbol(_) => Some(1),
        Node::Sum(list) => list.iter().try_fold(0, |degree, own| Some(degree.max(typed_degree(own, variable)?))),
        Node::Product(list) => list.iter().try_fold(0_usize, |degree, own| Some(degree.saturating_add(typed_degree(own, variable)?))),
        Node::Power(base, exponent) => {
            let n = exponent.as_integer().and_then(|n| usize::try_from(n).ok())?;
            Some(typed_degree(base, variable)?.saturating_mul(n))
        }
        Node::Number(_) | Node::Constant(_) | Node::Function(..) => None,
    }
}

/// True if f′ behaves like a fractional or negative power of δ near 0.
pub(crate) fn is_singular(f_prime: &Numbers, lower: f64, upper: Option<f64>) -> bool {
    let scale = match upper {
        Some(upper) => upper - lower,
        None if lower > 0.0 => lower,
        None => 1.0,
    };
    // Below the smallest normal number f′ is not accurate enough.
    let near = (1e-12 * scale).max(f64::MIN_POSITIVE);
    if near > 1e-6 * scale {
        return true;
    }
    let at = |delta: f64| f_prime.at(Bounded::exact(delta), &mut Vec::new()).value;
    let (u, v) = (at(1e3 * near), at(near));
    // What vanishes nearer, as exp(−w/r) does, is smooth there.
    if v == 0.0 && u.is_finite() {
        return false;
    }
    if !(u.is_finite() && v.is_finite()) || u == 0.0 {
        return true;
    }
    let exponent = (u / v).abs().log10() / 3.0;
    exponent < -0.01 || (exponent - exponent.round()).abs() > 0.004
}

/// A value with a bound of the given number of ulps.
pub(crate) fn with_ulps(value: f64, ulps: f64) -> Bounded {
    Bounded { value, error: ulps * 0.5 * f64::EPSILON * value.abs() }
}

/// A quadrature that stopped early still has a value and an error bound; poles and infinite errors are failures.
///
/// `scale` is the size of ∫|integrand|: a larger error is a failure.
pub(crate) fn settle(result: Result<Estimate, NumError>, at: f64, scale: impl FnOnce() -> f64) -> Result<Estimate, TransformError> {
    settled(reached(result, at)?, at, scale)
}

/// The result of a quadrature, even if it missed the tolerance.
pub(crate) fn reached(result: Result<Estimate, NumError>, at: f64) -> Result<Estimate, TransformError> {
    match result {
        Ok(found) => Ok(found),
        Err(NumError::ToleranceNotReached { value, error, evaluations, .. } | NumError::EvaluationLimit { value, error, evaluations }) => {
            Ok(Estimate::estimated(value, error, evaluations))
        }
        Err(NumError::NotFinite { .. }) => Err(TransformError::NotComputable { at }),
        Err(other) => Err(other.into()),
    }
}

/// The estimate, or an error if no digit is reliable.
pub(crate) fn settled(found: Estimate, at: f64, scale: impl FnOnce() -> f64) -> Result<Estimate, TransformError> {
    let Estimate { value, error, .. } = found;
    let lost = !(value.is_finite() && error.is_finite()) || (error > LOST * value.abs() && error > BEYOND * scale().max(value.abs()));
    if lost { Err(TransformError::NoDigits { at, value, error }) } else { Ok(found) }
}

/// Relative error above which no digit of a value is reliable.
const LOST: f64 = 0.01;
/// An error above this fraction of the integral of the magnitude, or of the value if the samples are smaller, indicates a pole or
/// an unresolved feature instead of rounding noise.
const BEYOND: f64 = 0.1;

/// The integral of |f| over (0, width) by its values at 32 midpoints.
pub(crate) fn magnitude(width: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let step = width / 32.0;
    let total: f64 = (0..32).map(|i| f(step * (f64::from(i) + 0.5)).abs()).filter(|v| v.is_finite()).sum();
    total * step
}
