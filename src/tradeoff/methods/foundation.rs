//! The discrete spring foundation, over its spacings: the force at the depth that belongs to each contact radius.

use crate::contact::Quantity;
use crate::contact::SpringFoundation;
use crate::expr::Bindings;
use crate::num::Estimate;
use crate::tradeoff::candidate::{Candidate, Ladder, Refused, Run};
use crate::tradeoff::problem::Problem;
use crate::transform::{Evaluator, Method};

const METHOD: &str = "spring foundation";
const SPRINGS: [usize; 7] = [10, 32, 100, 320, 1_000, 10_000, 100_000];

pub(in crate::tradeoff) fn ladder<'a>(problem: &'a Problem<'a>, _: &'a Evaluator<'a>) -> Ladder<'a> {
    let refused = |why: &str| Refused { method: METHOD, why: why.to_owned() };
    if problem.quantity != Quantity::Force {
        return Err(refused("it answers forces: --quantity F"));
    }
    let evaluator = Evaluator::new(problem.solution, &Bindings::default(), Method::Auto, 1e-13).map_err(|e| refused(&e.to_string()))?;
    let g = move |x: f64| evaluator.equivalent(x).map(|own| own.estimate.value);
    let depths: Vec<f64> = problem.points.iter().map(|a| g(*a)).collect::<Result<_, _>>().map_err(|e| refused(&e.to_string()))?;
    let mut order: Vec<(f64, f64)> = problem.points.iter().copied().zip(depths.iter().copied()).collect();
    order.sort_by(|one, other| one.0.total_cmp(&other.0));
    if order.iter().zip(order.iter().skip(1)).any(|((_, before), (_, beyond))| before > beyond) {
        return Err(refused("g does not rise throughout, and springs far out would touch as well"));
    }
    let reach = problem.outermost();
    let g = std::rc::Rc::new(g);
    let mut steps = Vec::new();
    for springs in SPRINGS {
        let build = {
            let g = g.clone();
            move || SpringFoundation::new(|x| g(x).unwrap_or(f64::NAN), reach, springs, 1.0).map_err(|error| error.to_string())
        };
        let (mut foundation, own, depths) = (None, build.clone(), depths.clone());
        let run = move |index: usize, _: f64| {
            let depth = depths.get(index).copied().ok_or_else(|| "no such point".to_owned())?;
            let ready: &SpringFoundation = match &foundation {
                Some(ready) => ready,
                None => foundation.insert(own()?),
            };
            // The value of the transform is multiplied by 2E* with E* = 1.
            Ok(Estimate::estimated(0.5 * ready.indent(depth).force, f64::INFINITY, springs as u64))
        };
        steps.push(Candidate {
            method: METHOD,
            setting: format!("dx = a_max/{springs}"),
            run: Run::Point(Box::new(run)),
            set_up: Box::new(move || build().map(|_| ())),
        });
    }
    Ok(steps)
}
