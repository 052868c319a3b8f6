//! How far out comparisons look.

use crate::evaluate::evaluator::Evaluator;

/// How far out points go: below the domain's limit, else beyond the last breakpoint, else to 3 or, where the tip is far steeper there than
/// next to the axis, as one with lengths in metres, to where it is not; and never where g overflows.
pub fn reach(evaluator: &Evaluator<'_>) -> f64 {
    let limit = evaluator.limit();
    if limit.is_finite() {
        return 0.98 * limit;
    }
    let mut end = match evaluator.breakpoints_below(f64::INFINITY).last() {
        Some(last) => 2.5 * last,
        None => gentle(evaluator),
    };
    for _ in 0..SHRINKINGS {
        // Room for the square of the radius in F and G.
        if evaluator.equivalent(end).is_ok_and(|g| (g.estimate.value * end * end).is_finite()) {
            break;
        }
        end *= 0.25;
    }
    end
}

/// The first of 3e-3, 3e-4, … at which |g| is at most the radius, if it is more than a hundred times the radius at 3, and more than the
/// radius at 3e-2, as it is not for high powers; else 3.
fn gentle(evaluator: &Evaluator<'_>) -> f64 {
    const USUAL: f64 = 3.0;
    const STEEP: f64 = 100.0;
    let slope = |x: f64| evaluator.equivalent(x).map_or(f64::INFINITY, |g| (g.estimate.value / x).abs());
    if slope(USUAL) <= STEEP || slope(0.01 * USUAL) <= 1.0 {
        return USUAL;
    }
    (3..=DECADES).map(|step| USUAL * 0.1_f64.powi(step)).find(|x| slope(*x) <= 1.0).unwrap_or(USUAL)
}

/// How many decades below 3 are tried.
const DECADES: i32 = 15;
/// How often the range of points is quartered before the trouble is left to show.
const SHRINKINGS: u32 = 20;
