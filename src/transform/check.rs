//! The program's own check: closed forms against quadrature of the profile as typed, at 64 points.

use super::evaluator::{Evaluator, Method, Reading};
use super::sample::{Sampler, reach};
use super::{Solution, TransformError};
use crate::expr::Bindings;
use crate::num::{Estimate, work};

/// How a check ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Closed forms were compared, and every difference stays within the sum of both error bounds.
    Passed,
    /// A difference exceeds the sum of both error bounds.
    Failed,
    /// Nothing closed could be compared with an independent value that has digits.
    NotCompared,
}

impl Verdict {
    /// True or false; `None` where nothing was compared.
    pub fn passed(self) -> Option<bool> {
        match self {
            Self::Passed => Some(true),
            Self::Failed => Some(false),
            Self::NotCompared => None,
        }
    }

    /// The words that reports use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "failed",
            Self::NotCompared => "not compared",
        }
    }
}

/// The outcome of a check.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Check {
    /// Points at which something closed was compared.
    pub points: u32,
    /// The largest |closed − quadrature| relative to the size of the quantity, over what was compared.
    pub max_relative_difference: f64,
    /// How it ended.
    pub verdict: Verdict,
    /// Why nothing was compared, where that is so.
    pub why: Option<&'static str>,
}

/// Points of a check.
const POINTS: u32 = 64;
/// Draws of the parameters among which the points are shared.
const DRAWS: u32 = 8;
/// More terms than this make a profile long.
const MANY_TERMS: usize = 40;
/// The relative tolerance that the quadratures of a check are asked for.
const TOLERANCE: f64 = 1e-12;
/// Where the two bounds add up to more than this share of the value, agreement proves nothing.
const TELLING: f64 = 1e-6;
/// Where f′ leaves more than this share of its integral below the smallest doubles, its quadrature is no reference.
const UNSEEN: f64 = 1e-9;

/// Compares g at 64 points, F and p at up to 16 of them, at the set values or at seeded random admissible ones.
///
/// A point counts where something closed meets a quadrature whose bound is small enough to contradict it.
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
/// [`TransformError`] where the profile cannot be evaluated at any admissible value of its parameters.
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
    // A long profile is as well tested by fewer of the dear pressures.
    let every = if solution.terms().count() > MANY_TERMS { 32 } else { 4 };
    let (mut tally, mut visited, mut trouble) = (Tally::default(), 0, None);
    // Some draws may fail: there are twice as many as are needed.
    for _ in 0..2 * draws {
        let Some(bindings) = sampler.parameters(solution) else {
            return Ok(tally.outcome(NOT_ADMISSIBLE));
        };
        match compare(solution, &bindings, POINTS / draws, every, &mut sampler, &mut tally) {
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

pub(super) const NOTHING_CLOSED: &str = "no part of the answer is closed, and quadrature is not compared with itself";
pub(super) const FLAT: &str = "f is constant, and there is nothing to compare";
pub(super) const NOT_ADMISSIBLE: &str = "no values of the parameters were found that meet the conditions";
pub(super) const NO_REFERENCE: &str = "no point has both a closed form and a quadrature with digits enough to contradict it";

fn compare(
    solution: &Solution,
    bindings: &Bindings,
    points: u32,
    every: usize,
    sampler: &mut Sampler,
    tally: &mut Tally,
) -> Result<(), TransformError> {
    let closed = Evaluator::new(solution, bindings, Method::Auto, TOLERANCE)?;
    let plain = Evaluator::new(solution, bindings, Method::Quadrature, TOLERANCE)?;
    let typed = plain.typed()?;
    let closed_pressure = solution.terms().any(|term| !term.has_open_pressure());
    // Where integrals stand beside closed terms of the pressure, both sides are dear.
    let every_pressure = if solution.terms().any(|term| term.has_open_pressure()) { 4 * every } else { every };
    for (index, x) in sampler.points(reach(&closed), points).into_iter().enumerate() {
        let share = sampler.fraction();
        // A quadrature that cannot see what lies next to the axis refutes nothing.
        if typed.unseen_share(x) > UNSEEN {
            continue;
        }
        let before = tally.compared;
        // A value that one side refuses is not compared; where it should exist, other points show it.
        let mut take = |own: Result<Reading, TransformError>, other: &dyn Fn() -> Result<Reading, TransformError>| {
            if let Ok(own) = own
                && own.method != "quadrature"
                && let Ok(other) = other()
            {
                tally.take(own.estimate, other.estimate);
            }
        };
        take(closed.slope(x), &|| plain.slope(x));
        if index % every == 0 {
            take(closed.force(x), &|| plain.force(x));
            if closed_pressure && index % every_pressure == 0 {
                let r = x * share;
                if let (Ok(Some(one)), Ok(Some(other))) = (closed.pressure(r, x), plain.pressure(r, x)) {
                    take(Ok(one), &|| Ok(other));
                }
            }
        }
        tally.points += u32::from(tally.compared > before);
    }
    Ok(())
}

/// What was compared so far.
#[derive(Default)]
pub(in crate::transform) struct Tally {
    pub(super) points: u32,
    pub(super) compared: u32,
    /// Comparisons of values that are not both 0.
    telling: u32,
    largest: f64,
    failed: bool,
}

impl Tally {
    /// Compares two values, unless their bounds are too loose for that.
    pub(in crate::transform) fn take(&mut self, own: Estimate, other: Estimate) {
        let difference = (own.value - other.value).abs();
        let size = own.value.abs().max(other.value.abs());
        let bound = own.error + other.error;
        // Written so that a bound that is no number is not telling.
        let telling = bound <= TELLING * size;
        if !telling {
            return;
        }
        self.compared += 1;
        if size > 0.0 {
            self.telling += 1;
            self.largest = self.largest.max(difference / size);
        }
        // Written so that a NaN fails.
        let within = difference <= bound;
        self.failed |= !within;
    }

    /// The outcome; `why` tells why nothing was compared, if so.
    pub(super) fn outcome(&self, why: &'static str) -> Check {
        if self.telling == 0 {
            return Check { points: 0, ..Check::not_compared(why) };
        }
        let verdict = if self.failed { Verdict::Failed } else { Verdict::Passed };
        Check { points: self.points, max_relative_difference: self.largest, verdict, why: None }
    }
}

impl Check {
    /// Nothing was compared.
    pub(super) fn not_compared(why: &'static str) -> Self {
        Self { points: 0, max_relative_difference: f64::NAN, verdict: Verdict::NotCompared, why: Some(why) }
    }

    /// True where something closed was compared and agrees.
    pub fn passed(&self) -> bool {
        self.verdict == Verdict::Passed
    }
}
