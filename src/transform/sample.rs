//! Seeded random places for comparisons: admissible values of the parameters, and points within the profile's reach.

use super::stream::Stream;
use super::{Evaluator, Solution};
use crate::expr::{Bindings, Condition, Expr};

/// A seeded source of admissible parameters and points; the same on every machine.
pub struct Sampler {
    stream: Stream,
}

/// How often the range of points is quartered before the trouble is left to show.
const SHRINKINGS: u32 = 20;
/// Draws of parameters before a profile counts as one without admissible values.
const TRIES: u32 = 40;

impl Sampler {
    /// A source that depends on the seed alone.
    pub fn new(seed: u64) -> Self {
        Self { stream: Stream::new(seed) }
    }

    /// Values for every parameter that the conditions of the solution admit; `None` where none was found.
    pub fn parameters(&mut self, solution: &Solution) -> Option<Bindings> {
        let parameters = solution.profile.parameters();
        for _ in 0..TRIES {
            let bindings: Bindings = parameters.iter().map(|s| (s.name(), Expr::number(self.stream.dyadic()))).collect();
            if solution.conditions.iter().all(|condition| admissible(&condition.substitute(&bindings))) {
                return Some(bindings);
            }
        }
        None
    }

    /// So many points of (0, end), one in each of as many equal parts.
    pub fn points(&mut self, end: f64, count: u32) -> Vec<f64> {
        (0..count).map(|index| end * (f64::from(index) + self.stream.uniform()) / f64::from(count)).collect()
    }

    /// A number of (0, 1) that keeps away from both ends.
    pub fn fraction(&mut self) -> f64 {
        0.05 + 0.9 * self.stream.uniform()
    }
}

/// Conditions on parameters alone decide; those on r are met by the choice of points.
fn admissible(condition: &Condition) -> bool {
    condition.decided().unwrap_or_else(|| super::domain::numeric_sign(&(&condition.right - &condition.left)).is_none_or(|s| s > 0.0))
}

/// How far out points go: below the domain's limit, else beyond the last breakpoint, and never where g overflows.
pub fn reach(evaluator: &Evaluator<'_>) -> f64 {
    let limit = evaluator.limit();
    if limit.is_finite() {
        return 0.98 * limit;
    }
    let mut end = evaluator.breakpoints_below(f64::INFINITY).last().map_or(3.0, |last| 2.5 * last);
    for _ in 0..SHRINKINGS {
        // Room for the square of the radius in F and G.
        if evaluator.slope(end).is_ok_and(|g| (g.estimate.value * end * end).is_finite()) {
            break;
        }
        end *= 0.25;
    }
    end
}
