//! The power series at the axis, over its orders.

use crate::contact::Quantity;
use crate::num::Estimate;
use crate::tradeoff::candidate::{Candidate, Ladder, Refused, Run};
use crate::tradeoff::problem::Problem;
use crate::transform::{Evaluator, SeriesEvaluator};

const METHOD: &str = "power series";
const ORDERS: [usize; 7] = [2, 4, 8, 16, 32, 64, 128];

pub(in crate::tradeoff) fn ladder<'a>(problem: &'a Problem<'a>, _: &'a Evaluator<'a>) -> Ladder<'a> {
    let refused = |why: String| Refused { method: METHOD, why };
    let mut steps = Vec::new();
    for order in ORDERS {
        let series = SeriesEvaluator::new(problem.profile, order).map_err(|error| refused(error.to_string()))?;
        if order == ORDERS[0] {
            let last = problem.points.iter().copied().fold(0.0, f64::max);
            read(problem, &series, last).map_err(refused)?;
        }
        steps.push(Candidate {
            method: METHOD,
            setting: format!("order {order}"),
            run: Run::Point(Box::new(move |_, at| read(problem, &series, at))),
            set_up: Box::new(move || SeriesEvaluator::new(problem.profile, order).map(|_| ()).map_err(|error| error.to_string())),
        });
    }
    Ok(steps)
}

fn read(problem: &Problem<'_>, series: &SeriesEvaluator, at: f64) -> Result<Estimate, String> {
    let reading = match (problem.quantity, problem.radius) {
        (Quantity::Equivalent, _) => series.equivalent(at),
        (Quantity::Force, _) => series.force(at),
        (_, radius) => series.pressure(at, radius.unwrap_or(at)),
    };
    reading.map(|own| own.estimate).map_err(|error| error.to_string())
}
