//! How far out comparisons look.

use crate::evaluate::evaluator::Evaluator;

/// How far out points go: below the domain's limit, else beyond the last breakpoint, and never where g overflows.
pub fn reach(evaluator: &Evaluator<'_>) -> f64 {
    let limit = evaluator.limit();
    if limit.is_finite() {
        return 0.98 * limit;
    }
    let mut end = evaluator.breakpoints_below(f64::INFINITY).last().map_or(3.0, |last| 2.5 * last);
    for _ in 0..SHRINKINGS {
        // Room for the square of the radius in F and G.
        if evaluator.equivalent(end).is_ok_and(|g| (g.estimate.value * end * end).is_finite()) {
            break;
        }
        end *= 0.25;
    }
    end
}

/// How often the range of points is quartered before the trouble is left to show.
const SHRINKINGS: u32 = 20;
