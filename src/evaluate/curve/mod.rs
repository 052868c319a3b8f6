//! The whole curve: one profile turned into functions of x that are cheap by the million.

mod build;
mod piece;
mod pressure;
mod source;
mod table;

use crate::derive::stream::Stream;
use crate::integrate::error::TransformError;
use crate::integrate::integral::NumericProfile;
use crate::num::Estimate;
use build::Budget;
use piece::{Integral, Piece};
pub use pressure::PressureCurve;
use source::Source;
use std::sync::OnceLock;
use table::Table;

/// g, F and G of a profile over [0, reach] as piecewise polynomials, made from exact half-order integrals of an expansion of f′.
///
/// On pieces between breakpoints f′/(2r) = (s − b²)^B Σ c_k P_k^{(0,B)} over s = r²; Bateman's integral takes every term to
/// one term of g, F or G, within the piece and beyond it. Short polynomials through these values serve evaluation.
/// Lengths are those of the profile; g and the profile's heights share a unit.
///
/// ```
/// use sneddon::{expr::{Bindings, Expr}, parse, transform::{Curve, Evaluator, Method, Profile, derive}};
/// let profile = Profile::new(&parse::profile("r^2/(2*R)").unwrap()).unwrap();
/// let solution = derive(&profile).unwrap();
/// let set = Bindings::one("R", Expr::integer(2));
/// let evaluator = Evaluator::new(&solution, &set, Method::Auto, 1e-13).unwrap();
/// let curve = Curve::new(evaluator.typed().unwrap(), 3.0, 1e-13).unwrap();
/// let g = curve.equivalent(1.5).unwrap();
/// assert!((g.value - 1.5 * 1.5 / 2.0).abs() <= g.error && g.error < 1e-14);
/// let (places, mut values) = ([0.5, 1.0, 3.0], [0.0; 3]);
/// curve.equivalent_slice(&places, &mut values).unwrap();
/// assert!((values[2] - 4.5).abs() < 1e-14);
/// ```
pub struct Curve<'a> {
    profile: &'a NumericProfile,
    reach: f64,
    pieces: Vec<Piece>,
    breakpoints: Vec<f64>,
    /// Breakpoints that are known to their error only: place, error, jump of f′.
    smears: Vec<[f64; 3]>,
    evaluations: u64,
    equivalent: Table,
    force: OnceLock<Table>,
    integral: OnceLock<Table>,
    bound: f64,
}

impl<'a> Curve<'a> {
    /// Expands f′ up to `reach` and compares every polynomial with quadrature at a random place.
    ///
    /// `tolerance` is the error of g relative to the largest |g|.
    ///
    /// # Errors
    /// [`TransformError::NotComputable`] if f′ is not finite or too wild below `reach`,
    /// [`TransformError::CurveTooRough`] with the error that was reached.
    pub fn new(profile: &'a NumericProfile, reach: f64, tolerance: f64) -> Result<Self, TransformError> {
        if !(reach > 0.0 && reach.is_finite()) {
            return Err(TransformError::OutOfDomain { symbol: "reach", at: reach, limit: "; expected a positive length".to_owned() });
        }
        let mut budget = Budget::default();
        let (mut pieces, mut breakpoints, mut smears) = (Vec::new(), Vec::new(), Vec::new());
        for segment in &profile.segments {
            for end in [Some(segment.lower), segment.upper].into_iter().flatten().filter(|end| end.value < reach) {
                if end.value > 0.0 {
                    breakpoints.push(end.value);
                }
                if end.error > 0.0 {
                    let jump = segment.f_prime_at((end.value - segment.lower.value).max(0.0)).value.abs();
                    smears.push([end.value, end.error, jump]);
                }
            }
            for source in Source::of_slope(segment) {
                pieces.extend(build::pieces(&source, reach, &mut budget)?);
                budget.pieces = pieces.len();
            }
        }
        breakpoints.sort_by(f64::total_cmp);
        breakpoints.dedup();
        let equivalent = Table::new(&pieces, Integral::Root, &breakpoints, reach)?;
        let evaluations = budget.evaluations;
        let (force, integral) = (OnceLock::new(), OnceLock::new());
        let mut curve = Self { profile, reach, pieces, breakpoints, smears, evaluations, equivalent, force, integral, bound: 0.0 };
        curve.equivalent.examine(&mut Stream::new(reach.to_bits()), |x| profile.equivalent(x, CHECK));
        let (largest, error) = curve.equivalent.extremes();
        curve.bound = error + curve.smears.iter().map(|smeared| smear(*smeared, reach, Integral::Root)).sum::<f64>();
        if error.is_nan() || error > tolerance * largest {
            return Err(TransformError::CurveTooRough { quantity: "g", achieved: error / largest, requested: tolerance });
        }
        Ok(curve)
    }

    /// g(x).
    ///
    /// # Errors
    /// [`TransformError::OutOfDomain`] outside of [0, reach].
    pub fn equivalent(&self, x: f64) -> Result<Estimate, TransformError> {
        self.check("x", x)?;
        Ok(self.estimate(&self.equivalent, x, Integral::Root))
    }

    /// g at every place of a slice, sorted or not.
    ///
    /// # Errors
    /// [`TransformError::OutOfDomain`] if a place lies outside of [0, reach], or the slices differ in length.
    pub fn equivalent_slice(&self, x: &[f64], out: &mut [f64]) -> Result<(), TransformError> {
        self.fill(&self.equivalent, "x", x, out)
    }

    /// g′(x), by the derivative of the polynomials: three digits fewer than g, and infinite at a kink.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub fn equivalent_derivative(&self, x: f64) -> Result<f64, TransformError> {
        self.check("x", x)?;
        let value = self.equivalent.derivative(x);
        if value.is_finite() { Ok(value) } else { Err(TransformError::Overflow { symbol: "x", at: x, is_negative: value < 0.0 }) }
    }

    /// F(a)/(2E*) under a smooth edge.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub fn force(&self, a: f64) -> Result<Estimate, TransformError> {
        self.check("a", a)?;
        Ok(self.estimate(self.forces()?, a, Integral::Raised))
    }

    /// F/(2E*) at every radius of a slice.
    ///
    /// # Errors
    /// As [`Self::equivalent_slice`].
    pub fn force_slice(&self, a: &[f64], out: &mut [f64]) -> Result<(), TransformError> {
        self.fill(self.forces()?, "a", a, out)
    }

    /// G(a) = ∫₀^a g dx.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub fn integral(&self, a: f64) -> Result<Estimate, TransformError> {
        self.check("a", a)?;
        Ok(self.estimate(self.integrals()?, a, Integral::Area))
    }

    /// G at every radius of a slice.
    ///
    /// # Errors
    /// As [`Self::equivalent_slice`].
    pub fn integral_slice(&self, a: &[f64], out: &mut [f64]) -> Result<(), TransformError> {
        self.fill(self.integrals()?, "a", a, out)
    }

    /// The pressure curve of the contact with radius a, for many places.
    ///
    /// # Errors
    /// As [`Self::equivalent`], and where (r f′)′ is not known or too wild.
    pub fn pressures(&self, a: f64) -> Result<PressureCurve<'a>, TransformError> {
        self.check("a", a)?;
        PressureCurve::new(self.profile, a)
    }

    /// A bound on the absolute error of g anywhere on [0, reach].
    pub fn error_bound(&self) -> f64 {
        self.bound
    }

    /// The end of the curve.
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// Evaluations of f′ that the expansion cost.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// The number of expansions of f′, their largest number of coefficients, and the number of polynomials of g.
    pub fn size(&self) -> (usize, usize, usize) {
        (self.pieces.len(), self.pieces.iter().map(Piece::len).max().unwrap_or(0), self.equivalent.len())
    }

    fn forces(&self) -> Result<&Table, TransformError> {
        self.table(&self.force, Integral::Raised, |a| self.profile.force(a, CHECK))
    }

    fn integrals(&self) -> Result<&Table, TransformError> {
        self.table(&self.integral, Integral::Area, |a| self.profile.integral(a, CHECK))
    }

    fn table<'s>(
        &'s self,
        cell: &'s OnceLock<Table>,
        kind: Integral,
        exact: impl Fn(f64) -> Result<Estimate, TransformError>,
    ) -> Result<&'s Table, TransformError> {
        if let Some(ready) = cell.get() {
            return Ok(ready);
        }
        let mut built = Table::new(&self.pieces, kind, &self.breakpoints, self.reach)?;
        built.examine(&mut Stream::new(self.reach.to_bits()), exact);
        Ok(cell.get_or_init(|| built))
    }

    fn estimate(&self, table: &Table, x: f64, kind: Integral) -> Estimate {
        let (value, error) = table.at(x);
        let moved: f64 = self.smears.iter().map(|smeared| smear(*smeared, x, kind)).sum();
        Estimate::estimated(value, error + moved, 0)
    }

    fn check(&self, symbol: &'static str, at: f64) -> Result<(), TransformError> {
        let inside = (0.0..=self.reach).contains(&at);
        let outside = || TransformError::OutOfDomain { symbol, at, limit: format!(" of the curve, which ends at {:?}", self.reach) };
        if inside { Ok(()) } else { Err(outside()) }
    }

    fn fill(&self, table: &Table, symbol: &'static str, places: &[f64], out: &mut [f64]) -> Result<(), TransformError> {
        // One pass over all: NaN fails the comparison too.
        if !places.iter().fold(true, |fine, x| fine & (*x >= 0.0) & (*x <= self.reach)) {
            for at in places {
                self.check(symbol, *at)?;
            }
        }
        if places.len() != out.len() {
            let limit = "; expected slices of equal length".to_owned();
            return Err(TransformError::OutOfDomain { symbol: "length", at: out.len() as f64, limit });
        }
        table.fill(places, out);
        Ok(())
    }
}

/// The change of an integral when a breakpoint moves by its error; `smeared` is the breakpoint, its error and the jump of f′.
fn smear(smeared: [f64; 3], x: f64, kind: Integral) -> f64 {
    let [b, error, jump] = smeared;
    if x < b - error {
        return 0.0;
    }
    // ∫ dr/√(x² − r²) over the doubt, with the half unit that is lost in b ± error.
    let (from, to) = ((b - error).next_down().max(0.0), (b + error).next_up());
    let end = if to < x { to } else { f64::INFINITY };
    let arc = if from < x { crate::num::forms::angle_between(from, end, x) } else { 0.0 };
    let weight = match kind {
        Integral::Root => x,
        Integral::Raised => to * to,
        Integral::Area => ((x - from) * (x + from)).max(0.0),
    };
    2.0 * jump * weight * arc
}

impl Curve<'_> {
    /// p(r)·π/E* under a smooth edge of radius a; `None` if it is infinite by theory.
    ///
    /// # Errors
    /// As [`Self::pressures`].
    pub fn pressure(&self, r: f64, a: f64) -> Result<Option<Estimate>, TransformError> {
        self.pressures(a)?.at(r)
    }
}

/// The tolerance of the quadrature that a curve is compared with.
const CHECK: f64 = 1e-13;
