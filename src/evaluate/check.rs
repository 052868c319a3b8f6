//! Checks closed forms against quadrature of the profile as typed, at up to 64 points.

use crate::derive::engine::Solution;
use crate::derive::sample::Sampler;
use crate::evaluate::evaluator::{Evaluator, Method, Reading};
use crate::evaluate::reach::reach;
use crate::evaluate::tally::{Tally, Verdict};
use crate::expr::Bindings;
use crate::integrate::error::TransformError;
use crate::num::work;

/// The outcome of a check.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Check {
    /// Points at which a closed form was compared.
    pub points: u32,
    /// The largest |closed − quadrature| relative to the size of the quantity, over all comparisons.
    pub max_relative_difference: f64,
    /// The verdict.
    pub verdict: Verdict,
    /// Why nothing was compared, if so.
    pub why: Option<&'static str>,
    /// Whether closed forms of g, F and p, in this order, were compared.
    pub compared: [bool; 3],
}

/// Points of a check.
const POINTS: u32 = 64;
/// Random sets of parameters over which the points are distributed.
const DRAWS: u32 = 8;
/// F and p are compared at one of as many points as the profile has terms, within these limits.
const EVERY: (usize, usize) = (4, 32);
/// The relative tolerance of the quadratures of a check.
const TOLERANCE: f64 = 1e-12;
/// Steps of work after which no new point is started; for an expensive profile, fewer points suffice.
const ENOUGH: u64 = 60_000_000;

/// Compares g at up to 64 points, at the set values or at seeded random admissible ones, and F and p at up to 16 of these points,
/// fewer for a profile of more than four terms.
///
/// A point counts if a closed form is compared with a quadrature whose bound is small enough to contradict it.
///
/// ```
/// use sneddon::{parse, transform::{Profile, Verdict, check, derive}};
/// let of = |text| check(&derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap()).unwrap();
/// let outcome = of("R - sqrt(R^2 - r^2)");
/// assert!(outcome.verdict == Verdict::Passed && outcome.points == 64);
/// assert_eq!(of("ln(cosh(r))").verdict, Verdict::NotCompared);
/// ```
///
/// # Errors
/// [`TransformError`] if the profile cannot be evaluated at any admissible value of its parameters.
pub fn check(solution: &Solution) -> Result<Check, TransformError> {
    work::bounded(|| compared(solution))
}

fn compared(solution: &Solution) -> Result<Check, TransformError> {
    let closed_pressure = solution.terms().any(|term| !term.has_open_pressure());
    if solution.terms().all(|term| term.is_open()) && !closed_pressure {
        return Ok(Check::not_compared(if solution.terms().next().is_some() { NOTHING_CLOSED } else { FLAT }));
    }
    let mut sampler = Sampler::new(0x0c4e_c4ed);
    let draws = if solution.profile.parameters().is_empty() { 1 } else { DRAWS };
    // For a long profile, fewer of the expensive forces and pressures suffice.
    let every = solution.terms().count().clamp(EVERY.0, EVERY.1);
    let (mut tally, mut visited, mut trouble) = (Tally::default(), 0, None);
    let mut seen = [false; 3];
    let before = work::left();
    let is_enough = || before - work::left() > ENOUGH;
    // Some draws may fail, so there are twice as many as needed.
    for _ in 0..2 * draws {
        let Some(bindings) = sampler.parameters(solution) else {
            return Ok(tally.outcome(NOT_ADMISSIBLE));
        };
        match compare(solution, &bindings, POINTS / draws, every, &is_enough, &mut sampler, (&mut tally, &mut seen)) {
            Ok(()) => visited += POINTS / draws,
            Err(error) => trouble = Some(error),
        }
        if visited >= POINTS || is_enough() {
            break;
        }
    }
    match trouble {
        Some(error) if visited == 0 => Err(error),
        _ => Ok(Check { compared: seen, ..tally.outcome(NO_REFERENCE) }),
    }
}

pub(crate) const NOTHING_CLOSED: &str = "no part of the answer is closed, and quadrature is not compared with itself";
pub(crate) const FLAT: &str = "f is constant, and there is nothing to compare";
pub(crate) const NOT_ADMISSIBLE: &str = "no values of the parameters were found that meet the conditions";
/// Why nothing was compared although there are closed forms.
pub const NO_REFERENCE: &str = "no point has both a closed form and a quadrature with digits enough to contradict it";

fn compare(
    solution: &Solution,
    bindings: &Bindings,
    points: u32,
    every: usize,
    is_enough: &dyn Fn() -> bool,
    sampler: &mut Sampler,
    (tally, seen): (&mut Tally, &mut [bool; 3]),
) -> Result<(), TransformError> {
    // If only some terms have a closed form, `Auto` compares them together with the integrals of the others.
    let strict = Evaluator::new(solution, bindings, Method::Exact, TOLERANCE)?;
    let closed = Evaluator::new(solution, bindings, Method::Auto, TOLERANCE)?;
    let plain = Evaluator::new(solution, bindings, Method::Quadrature, TOLERANCE)?;
    let typed = plain.typed()?;
    let closed_pressure = solution.terms().any(|term| !term.has_open_pressure());
    // If the pressure has open terms, both sides of the comparison are expensive.
    let every_pressure = if solution.terms().any(|term| term.has_open_pressure()) { 4 * every } else { every };
    for (index, x) in sampler.points(reach(&closed), points).into_iter().enumerate() {
        let share = sampler.fraction();
        if is_enough() {
            break;
        }
        // A quadrature that does not resolve the profile near the axis is inconclusive.
        if !typed.is_seen(x) {
            continue;
        }
        let before = tally.compared;
        // Skip values that one side refuses.
        let [equivalent_seen, force_seen, pressure_seen] = &mut *seen;
        let mut take = |seen: &mut bool, own: Result<Reading, TransformError>, other: &dyn Fn() -> Result<Reading, TransformError>| {
            if let Ok(own) = own
                && own.method != "quadrature"
                && let Ok(other) = other()
            {
                let before = tally.compared;
                tally.take(x, own.estimate, other.estimate);
                *seen |= tally.compared > before;
            }
        };
        take(equivalent_seen, strict.equivalent(x).or_else(|_| closed.equivalent(x)), &|| plain.equivalent(x));
        if index % every == 0 {
            take(force_seen, strict.force(x).or_else(|_| closed.force(x)), &|| plain.force(x));
            if closed_pressure && index % every_pressure == 0 {
                let r = x * share;
                let own = match strict.pressure(r, x) {
                    Ok(Some(own)) => Ok(Some(own)),
                    _ => closed.pressure(r, x),
                };
                if let (Ok(Some(one)), Ok(Some(other))) = (own, plain.pressure(r, x)) {
                    take(pressure_seen, Ok(one), &|| Ok(other));
                }
            }
        }
        tally.points += u32::from(tally.compared > before);
    }
    Ok(())
}

impl Tally {
    /// The outcome; `why` gives the reason if nothing was compared.
    pub(crate) fn outcome(&self, why: &'static str) -> Check {
        match self.verdict() {
            Verdict::NotCompared => Check::not_compared(why),
            verdict => Check { points: self.points, max_relative_difference: self.largest, verdict, why: None, compared: [false; 3] },
        }
    }
}

impl Check {
    /// Nothing was compared.
    pub(crate) fn not_compared(why: &'static str) -> Self {
        Self { points: 0, max_relative_difference: f64::NAN, verdict: Verdict::NotCompared, why: Some(why), compared: [false; 3] }
    }

    /// True if closed forms were compared and agree.
    pub fn passed(&self) -> bool {
        self.verdict == Verdict::Passed
    }
}
