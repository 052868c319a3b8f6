//! The closed form: over a slice without bounds, in doubles with bounds, and with 30 digits.

use crate::contact::Quantity;
use crate::expr::Bindings;
use crate::num::Estimate;
use crate::tradeoff::candidate::{Candidate, Ladder, Refused, Run};
use crate::tradeoff::problem::Problem;
use crate::transform::{Evaluator, Method, Slice, derive};

pub(in crate::tradeoff) const METHOD: &str = "closed form";

pub(in crate::tradeoff) fn ladder<'a>(problem: &'a Problem<'a>, _: &'a Evaluator<'a>) -> Ladder<'a> {
    let refused = |why: String| Refused { method: METHOD, why };
    let new = || Evaluator::new(problem.solution, &Bindings::default(), Method::Exact, 1e-13).map_err(|error| refused(error.to_string()));
    let (doubles, digits) = (new()?, new()?);
    // Known at any point: an open term stays open.
    let first = problem.points.first().copied().unwrap_or(1.0);
    problem.read(&doubles, first).map_err(refused)?;
    let set_up = move || {
        let solution = derive(problem.profile).map_err(|error| error.to_string())?;
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Exact, 1e-13).map_err(|error| error.to_string())?;
        problem.read(&evaluator, first).map(|_| ())
    };
    let quantity = problem.superposed();
    let by_digits = move |_: usize, at: f64| {
        let value = digits.with_30_digits(quantity, &problem.inputs(at)).map_err(|error| error.to_string())?;
        value.map(|value| Estimate::from_bounded(value.bounded(), 0)).ok_or_else(|| "an open term".to_owned())
    };
    let slices = new()?;
    let radius = problem.radius;
    let by_slices = move |at: &[f64], out: &mut [f64]| {
        let out = Slice::values(out);
        let done = match (problem.quantity, radius) {
            (Quantity::Equivalent, _) => slices.equivalents(at, out),
            (Quantity::Force, _) => slices.forces(at, out),
            (_, radius) => slices.pressures(at, radius.unwrap_or(1.0), out),
        };
        done.map_err(|error| error.to_string())
    };
    Ok(vec![
        Candidate {
            method: METHOD,
            setting: "slice of doubles".to_owned(),
            run: Run::Slice(Box::new(by_slices)),
            set_up: Box::new(set_up),
        },
        Candidate {
            method: METHOD,
            setting: "doubles with bounds".to_owned(),
            run: Run::Point(Box::new(move |_, at| problem.read(&doubles, at))),
            set_up: Box::new(set_up),
        },
        Candidate { method: METHOD, setting: "30 digits".to_owned(), run: Run::Point(Box::new(by_digits)), set_up: Box::new(set_up) },
    ])
}
