//! A table of points instead of the formula: monotone cubics, over the number of points.

use crate::contact::Quantity;
use crate::num::Estimate;
use crate::tradeoff::candidate::{Candidate, Ladder, Refused, Run};
use crate::tradeoff::problem::Problem;
use crate::transform::{Evaluator, Interpolation, Profile, Quantities, TableProfile, TransformError};

const METHOD: &str = "table of points";
const POINTS: [usize; 7] = [10, 32, 100, 320, 1_000, 3_200, 10_000];

pub(in crate::tradeoff) fn ladder<'a>(problem: &'a Problem<'a>, evaluator: &'a Evaluator<'a>) -> Ladder<'a> {
    let refused = |error: TransformError| Refused { method: METHOD, why: error.to_string() };
    let reach = problem.outermost();
    let mut steps = Vec::new();
    for points in POINTS {
        // The last point lies beyond the farthest place, because a table ends where its points do.
        // The farthest place is one of the points exactly; a quotient could fall short of it.
        let radius = |i: usize| if i + 1 == points { reach } else { reach * i as f64 / (points - 1) as f64 };
        let radii: Vec<f64> = (0..=points).map(radius).filter(|r| *r < evaluator.limit()).collect();
        let heights: Vec<f64> = radii.iter().map(|r| height(evaluator, *r)).collect::<Result<_, _>>().map_err(refused)?;
        let build = move || Profile::from_points(&radii, &heights, Interpolation::MonotoneCubic);
        let table = build().map_err(refused)?;
        steps.push(Candidate {
            method: METHOD,
            setting: format!("{points} points"),
            run: Run::Point(Box::new(move |_, at| read(problem, &table, at))),
            set_up: Box::new(move || {
                let fresh = build().map_err(|error| error.to_string())?;
                read(problem, &fresh, reach).map(|_| ())
            }),
        });
    }
    Ok(steps)
}

fn height(evaluator: &Evaluator<'_>, r: f64) -> Result<f64, TransformError> {
    Ok(evaluator.height(r)?.estimate.value)
}

/// The value of the table, without its bounds, which apply to its cubics and not to the formula.
fn read(problem: &Problem<'_>, table: &TableProfile, at: f64) -> Result<Estimate, String> {
    let found = match (problem.quantity, problem.radius) {
        (Quantity::Equivalent, _) => table.equivalent(at).map(Some),
        (Quantity::Force, _) => table.force(at).map(Some),
        (_, radius) => table.pressure(at, radius.unwrap_or(at)),
    };
    let found = found.map_err(|error| error.to_string())?.ok_or_else(|| "the value is infinite by theory".to_owned())?;
    Ok(Estimate { error: f64::INFINITY, ..found.estimate })
}
