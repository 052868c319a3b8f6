//! Pointwise quadrature of the profile as typed, over its tolerances.

use crate::expr::Bindings;
use crate::tradeoff::Problem;
use crate::tradeoff::candidate::{Candidate, Ladder, Refused, Run};
use crate::transform::{Evaluator, Method};

const METHOD: &str = "quadrature";
const TOLERANCES: [f64; 7] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14];

pub(in crate::tradeoff) fn ladder<'a>(problem: &'a Problem<'a>, _: &'a Evaluator<'a>) -> Ladder<'a> {
    let new = |tolerance| Evaluator::new(problem.solution, &Bindings::default(), Method::Quadrature, tolerance);
    let first = problem.points.first().copied().unwrap_or(1.0);
    let mut steps = Vec::new();
    for tolerance in TOLERANCES {
        let evaluator = new(tolerance).map_err(|error| Refused { method: METHOD, why: error.to_string() })?;
        let set_up = move || {
            let fresh = new(tolerance).map_err(|error| error.to_string())?;
            problem.read(&fresh, first).map(|_| ())
        };
        steps.push(Candidate {
            method: METHOD,
            setting: format!("tolerance {tolerance:e}"),
            run: Run::Point(Box::new(move |_, at| problem.read(&evaluator, at))),
            set_up: Box::new(set_up),
        });
    }
    Ok(steps)
}
