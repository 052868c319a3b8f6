//! Numbers of an inverse: closed forms with error bounds, quadrature for the remaining terms, and comparisons of the two.

use crate::derive::closed_form::{ClosedForm, for_second_pass, good_enough, total};
use crate::derive::engine::Solution;
use crate::derive::inverse::Inverse;
use crate::derive::sample::Sampler;
use crate::derive::verification::Verification;
use crate::eval::constant_value;
use crate::evaluate::check::Check;
use crate::evaluate::check::{NO_REFERENCE, NOT_ADMISSIBLE};
use crate::evaluate::evaluator::{Method, Reading};
use crate::evaluate::tally::Tally;
use crate::expr::{Bindings, Expr, Symbol};
use crate::integrate::error::TransformError;
use crate::integrate::integral::NumericProfile;
use crate::integrate::segment::Segment;
use crate::num::{Bounded, Estimate, work};

/// Points of a check, and the random sets of parameters over which they are distributed.
const POINTS: u32 = 64;
const DRAWS: u32 = 4;
/// The tolerance of the quadrature of a check.
const TOLERANCE: f64 = 1e-12;

/// An inverse with numbers for its parameters.
pub struct InverseNumbers {
    chains: Vec<NumericChain>,
    whole: NumericProfile,
    at_axis: Bounded,
    limit: f64,
    method: Method,
    tolerance: f64,
}

struct NumericChain {
    breakpoints: Vec<Bounded>,
    closed: Vec<Option<ClosedForm>>,
    open: NumericProfile,
}

impl InverseNumbers {
    /// Binds the parameters to numbers.
    ///
    /// # Errors
    /// [`TransformError::Evaluation`] if a parameter has no value.
    pub fn new(inverse: &Inverse, bindings: &Bindings, method: Method, tolerance: f64) -> Result<Self, TransformError> {
        let radius = [Symbol::new("r")];
        let mut chains = Vec::new();
        for chain in &inverse.chains {
            let breakpoints = chain.breakpoints.iter().map(|b| constant_value(b, bindings)).collect::<Result<_, _>>()?;
            let mut closed = Vec::new();
            for interval in 0..chain.intervals.len() {
                let expr = bindings.apply(&chain.closed(interval, |pair| &pair.evaluated));
                let second = bindings.apply(&chain.closed(interval, for_second_pass));
                closed.push(if expr.is_zero() { None } else { Some(ClosedForm::with_second(&expr, second, &radius)?) });
            }
            let open: Vec<(Segment, Expr)> = chain.intervals.iter().map(|own| (own.segment.clone(), own.open.clone())).collect();
            chains.push(NumericChain { breakpoints, closed, open: NumericProfile::new(&open, bindings)? });
        }
        let mut pieces = Vec::new();
        for chain in &inverse.equivalent.chains {
            pieces.extend(chain.intervals().map(|(lower, upper, g)| (Segment { lower, upper: upper.cloned() }, g.clone())));
        }
        let limits = inverse.equivalent.limits().map(|expr| constant_value(expr, bindings).map(|b| b.value));
        let limit = limits.collect::<Result<Vec<f64>, _>>()?.into_iter().fold(f64::INFINITY, f64::min);
        let at_axis = constant_value(inverse.at_axis(), bindings)?;
        Ok(Self { chains, whole: NumericProfile::new(&pieces, bindings)?, at_axis, limit, method, tolerance })
    }

    /// f(r), by its formula if that is accurate, else by quadrature of g as typed.
    ///
    /// # Errors
    /// [`TransformError`] outside the domain, without a required closed form, or without a reliable digit.
    pub fn value(&self, r: f64) -> Result<Reading, TransformError> {
        if r >= self.limit {
            return Err(TransformError::OutOfDomain { symbol: "r", at: r, limit: format!(", which ends at r = {}", self.limit) });
        }
        if r == 0.0 {
            return Ok(Reading { estimate: Estimate::from_bounded(self.at_axis, 0), method: "exact" });
        }
        let whole = || Ok(Reading { estimate: transformed(&self.whole, r, self.tolerance)?, method: "quadrature" });
        if self.method == Method::Quadrature {
            return whole();
        }
        let (mut open, mut any_open) = (Estimate::exact(0.0), false);
        let mut forms = Vec::new();
        for chain in &self.chains {
            // A breakpoint that may lie below r counts, because the error of the formula beyond it includes its uncertainty.
            let interval = chain.breakpoints.iter().filter(|b| b.value - b.error < r).count();
            forms.extend(chain.closed.get(interval).and_then(Option::as_ref));
            if !chain.open.is_empty() {
                if self.method == Method::Exact {
                    return Err(TransformError::NoClosedForm { quantity: "f" });
                }
                // The recognition form of the open part may cancel where the typed g does not.
                let Ok(found) = transformed(&chain.open, r, self.tolerance) else { return whole() };
                open = open + found;
                any_open = true;
            }
        }
        // A special function may need thousands of terms here; switch to quadrature before that.
        let special = self.method == Method::Auto && forms.iter().any(|form| form.tape().is_special());
        let sum = || total(&forms, &[r], good_enough(self.tolerance));
        let in_time = if special { work::share(DEAR, sum) } else { Some(sum()) };
        let closed = match in_time {
            Some(closed) => closed,
            None => match whole() {
                Ok(other) if other.estimate.relative_error() <= self.tolerance => return Ok(other),
                _ => sum(),
            },
        };
        let estimate = if any_open { closed + open } else { closed };
        let method = match (!forms.is_empty(), any_open) {
            (true, true) => "mixed",
            (false, true) => "quadrature",
            _ => "exact",
        };
        let own = Reading { estimate, method };
        let enough = self.method == Method::Exact || method == "quadrature" || estimate.relative_error() <= self.tolerance;
        let best = match if enough { None } else { Some(whole()) } {
            Some(Ok(other)) if own.estimate.error.is_nan() || own.estimate.error > other.estimate.error => other,
            Some(Err(error)) if estimate.value.is_nan() => return Err(error),
            _ => own,
        };
        match best.estimate.value {
            value if value.is_finite() => Ok(best),
            value if value.is_infinite() => Err(TransformError::Overflow { symbol: "r", at: r, is_negative: value < 0.0 }),
            _ => Err(TransformError::OutOfDomain { symbol: "r", at: r, limit: String::new() }),
        }
    }

    /// The largest radius of a check.
    fn reach(&self) -> f64 {
        if self.limit.is_finite() {
            return 0.98 * self.limit;
        }
        let last = self.chains.iter().flat_map(|chain| &chain.breakpoints).map(|b| b.value).fold(0.0, f64::max);
        if last > 0.0 { 2.5 * last } else { 3.0 }
    }
}

/// Steps of work after which a closed form with special functions is abandoned in favour of quadrature.
const DEAR: u64 = 500_000;

/// (2/π) ∫₀^{π/2} g(r sin t) dt.
fn transformed(g: &NumericProfile, r: f64, tolerance: f64) -> Result<Estimate, TransformError> {
    let found = g.equivalent(r, tolerance)?;
    let factor = Bounded::exact(2.0) / (Bounded::rounded(std::f64::consts::PI) * Bounded::exact(r));
    Ok(found.times(factor))
}

/// Compares the closed form with quadrature of g as typed, at the set values or at seeded random admissible ones.
///
/// # Errors
/// [`TransformError`] if g cannot be evaluated at any admissible values of its parameters.
pub fn check_inverse(inverse: &Inverse) -> Result<Check, TransformError> {
    let mut sampler = Sampler::new(0x0c4e_c4ed);
    let solution = Solution {
        profile: inverse.equivalent.clone(),
        chains: Vec::new(),
        conditions: inverse.conditions.clone(),
        verification: Verification::default(),
    };
    let draws = if solution.profile.parameters().is_empty() { 1 } else { DRAWS };
    let (mut tally, mut visited, mut trouble) = (Tally::default(), 0, None);
    for _ in 0..2 * draws {
        let Some(bindings) = sampler.parameters(&solution) else { return Ok(tally.outcome(NOT_ADMISSIBLE)) };
        match compare(inverse, &bindings, POINTS / draws, &mut sampler, &mut tally) {
            Ok(()) => visited += POINTS / draws,
            Err(error) => trouble = Some(error),
        }
        if visited >= POINTS {
            break;
        }
    }
    match trouble {
        Some(error) if visited == 0 => Err(error),
        _ => Ok(tally.outcome(NO_REFERENCE)),
    }
}

fn compare(inverse: &Inverse, bindings: &Bindings, points: u32, sampler: &mut Sampler, tally: &mut Tally) -> Result<(), TransformError> {
    let closed = InverseNumbers::new(inverse, bindings, Method::Auto, TOLERANCE)?;
    let plain = InverseNumbers::new(inverse, bindings, Method::Quadrature, TOLERANCE)?;
    let numeric = closed.chains.iter().all(|chain| !chain.open.is_empty());
    for r in sampler.points(closed.reach(), points) {
        let (one, other) = (closed.value(r)?, plain.value(r)?);
        if numeric && one.method == "quadrature" {
            continue;
        }
        let before = tally.compared;
        tally.take(r, one.estimate, other.estimate);
        tally.points += u32::from(tally.compared > before);
    }
    Ok(())
}
