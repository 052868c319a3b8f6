//! The whole curve: f′ expanded once, then values point by point with bounds, or over a slice.

use crate::contact::Quantity;
use crate::expr::Bindings;
use crate::num::Estimate;
use crate::tradeoff::candidate::{Candidate, Ladder, Refused, Run};
use crate::tradeoff::problem::Problem;
use crate::transform::{Curve, Evaluator, Method, PressureCurve, TransformError};

const METHOD: &str = "whole curve";
/// The tolerance that the expansion must meet, relative to the largest value.
const TOLERANCE: f64 = 1e-12;

/// The curve of the quantity.
enum Built<'a> {
    Along(Curve<'a>),
    Pressure(PressureCurve<'a>),
}

pub(in crate::tradeoff) fn ladder<'a>(problem: &'a Problem<'a>, evaluator: &'a Evaluator<'a>) -> Ladder<'a> {
    let refused = |error: TransformError| Refused { method: METHOD, why: error.to_string() };
    let set_up = move || {
        let fresh = Evaluator::new(problem.solution, &Bindings::default(), Method::Quadrature, TOLERANCE);
        fresh.and_then(|own| Built::new(problem, &own).map(|_| ())).map_err(|error| error.to_string())
    };
    let by_point = Built::new(problem, evaluator).map_err(refused)?;
    let mut steps = vec![Candidate {
        method: METHOD,
        setting: "points with bounds".to_owned(),
        run: Run::Point(Box::new(move |_, at| by_point.at(problem.quantity, at))),
        set_up: Box::new(set_up),
    }];
    if problem.quantity != Quantity::Pressure {
        let by_slice = Built::new(problem, evaluator).map_err(refused)?;
        steps.push(Candidate {
            method: METHOD,
            setting: "slice".to_owned(),
            run: Run::Slice(Box::new(move |at, out| by_slice.fill(problem.quantity, at, out).map_err(|error| error.to_string()))),
            set_up: Box::new(set_up),
        });
    }
    Ok(steps)
}

impl<'a> Built<'a> {
    fn new(problem: &Problem<'_>, evaluator: &'a Evaluator<'_>) -> Result<Self, TransformError> {
        let curve = Curve::new(evaluator.typed()?, problem.outermost(), TOLERANCE)?;
        match problem.radius {
            Some(a) => Ok(Self::Pressure(curve.pressures(a)?)),
            None => Ok(Self::Along(curve)),
        }
    }

    fn at(&self, quantity: Quantity, at: f64) -> Result<Estimate, String> {
        let found = match (self, quantity) {
            (Self::Along(curve), Quantity::Force) => curve.force(at).map(Some),
            (Self::Along(curve), _) => curve.equivalent(at).map(Some),
            (Self::Pressure(curve), _) => curve.at(at),
        };
        found.map_err(|error| error.to_string())?.ok_or_else(|| "the value is infinite by theory".to_owned())
    }

    fn fill(&self, quantity: Quantity, at: &[f64], out: &mut [f64]) -> Result<(), TransformError> {
        match (self, quantity) {
            (Self::Along(curve), Quantity::Force) => curve.force_slice(at, out),
            (Self::Along(curve), _) => curve.equivalent_slice(at, out),
            (Self::Pressure(curve), _) => {
                for (at, out) in at.iter().zip(out) {
                    *out = curve.at(*at)?.map_or(f64::NAN, |own| own.value);
                }
                Ok(())
            }
        }
    }
}
