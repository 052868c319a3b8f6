//! Pointwise quadrature by one Gauss–Kronrod rule and bisection, as in general-purpose libraries.

use crate::contact::Quantity;
use crate::num::Estimate;
use crate::num::quadrature::Rule;
use crate::tradeoff::candidate::{Candidate, Ladder, Refused, Run};
use crate::tradeoff::problem::Problem;
use crate::transform::Evaluator;

const METHOD: &str = "one rule";
const TOLERANCES: [f64; 3] = [1e-4, 1e-8, 1e-12];

pub(in crate::tradeoff) fn ladder<'a>(problem: &'a Problem<'a>, evaluator: &'a Evaluator<'a>) -> Ladder<'a> {
    let refused = |why: String| Refused { method: METHOD, why };
    if problem.quantity == Quantity::Pressure {
        return Err(refused("the pressure requires special rules for its logarithmic singularity".to_owned()));
    }
    let typed = evaluator.typed().map_err(|error| refused(error.to_string()))?;
    let value = move |at: f64, tolerance: f64, rule: Rule| -> Result<Estimate, String> {
        let found = match problem.quantity {
            Quantity::Force => typed.force_by(at, tolerance, rule),
            _ => typed.equivalent_by(at, tolerance, rule),
        };
        found.map_err(|error| error.to_string())
    };
    let mut steps = Vec::new();
    for rule in Rule::NAMED {
        for tolerance in TOLERANCES {
            steps.push(Candidate {
                method: METHOD,
                setting: format!("{} points at tolerance {tolerance:e}", rule.points()),
                run: Run::Point(Box::new(move |_, at| value(at, tolerance, rule))),
                set_up: Box::new(|| Ok(())),
            });
        }
    }
    Ok(steps)
}
