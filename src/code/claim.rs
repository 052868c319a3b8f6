//! What a program claims of its accuracy: the largest running error bound at seeded points of its domain.

use super::accuracy::{ELEMENTARY_ULPS, Machine};
use super::program::{Claim, Program, needs_modulus, routine_name};
use crate::contact::Quantity;
use crate::num::Bounded;
use crate::transform::{Evaluator, Method, Sampler, Solution, reach};

/// Sets of parameters.
const DRAWS: usize = 12;
/// Points for each of them.
const POINTS: u32 = 14;
/// Up to here a claim needs no condition number.
const PLAIN: f64 = 16.0;
/// Bounds between the points may be larger.
const ROOM: f64 = 1.25;
/// The step of relative differences, for condition numbers.
const STEP: f64 = 1e-6;

/// Writes the claims into the comments of the routines.
pub(super) fn state(program: &mut Program, solution: &Solution) {
    for quantity in program.quantities.clone() {
        let claim = of(program, quantity, solution);
        program.claims.push((quantity, claim));
        let lines = text(program, claim, quantity);
        if let Some(routine) = program.routines.iter_mut().find(|own| own.name == routine_name(quantity)) {
            routine.comment.extend(lines);
        }
    }
}

fn text(program: &Program, claim: Option<Claim>, quantity: Quantity) -> Vec<String> {
    let Some(claim) = claim else {
        return vec!["Accuracy: nothing is claimed, because no point with a bound was found.".to_owned()];
    };
    let mut assumed = vec![format!("elementary functions right to {ELEMENTARY_ULPS} ulp")];
    for name in &program.library {
        if let Some((written, ulps)) = program.language.target().library(name) {
            assumed.push(format!("{written} right to {ulps} ulp"));
        }
    }
    let times = match claim.condition {
        Some(_) => " times the condition number",
        None => "",
    };
    let mut lines = vec![format!("Accuracy: at most {} ulp{times}, for {}.", claim.ulps, assumed.join(" and "))];
    if let Some(condition) = claim.condition {
        lines.push(format!(
            "The condition number is 1 + the sum of |v df/dv|/|f| over the arguments v; it was {} at most.",
            if condition < 1e6 { format!("{condition:.0}") } else { format!("{condition:.0e}") }
        ));
    }
    let what = match quantity {
        Quantity::Radius => "depths that belong to radii",
        Quantity::Pressure => "radii r < a",
        _ => "points",
    };
    let parameters = if program.parameters.is_empty() { "" } else { ", with parameters between 1/4 and 4" };
    lines.push(format!(
        "The largest running error bound at {} seeded {what} over six decades of the domain{parameters}, and a quarter more.",
        claim.points
    ));
    lines
}

/// The claim of a quantity; `None` where no point gives a bound.
fn of(program: &Program, quantity: Quantity, solution: &Solution) -> Option<Claim> {
    let library = |name: &str| program.language.target().library(name).map(|(_, ulps)| ulps);
    let mut machine = Machine::new(&program.routines, &library);
    let searched = program.searches(quantity);
    let mut sampler = Sampler::new(0x5eed);
    let mut found: Vec<(f64, f64)> = Vec::new();
    for _ in 0..DRAWS {
        let Some(bindings) = sampler.parameters(solution) else { continue };
        let Ok(evaluator) = Evaluator::new(solution, &bindings, Method::Auto, 1e-13) else { continue };
        let value =
            |name: &str| bindings.iter().find(|(own, _)| own.name() == name).and_then(|(_, own)| own.as_number().map(|n| n.to_f64()));
        let Some(values) = program.parameters.iter().map(|(own, _)| value(own)).collect::<Option<Vec<f64>>>() else { continue };
        for place in places(&mut sampler, &evaluator) {
            for coordinates in arguments_at(quantity, place, &evaluator) {
                let mut arguments = coordinates.clone();
                if needs_modulus(quantity) {
                    arguments.push(1.0);
                }
                arguments.extend(&values);
                let bound = if searched {
                    root(&mut machine, place, &values)
                } else {
                    machine
                        .run(&routine_name(quantity), &arguments)
                        .map(|own| (own, condition(&mut machine, &routine_name(quantity), &arguments, own)))
                };
                let Some((bound, condition)) = bound else { continue };
                if bound.is_finite() && bound.value != 0.0 && bound.value.abs() > 1e-280 {
                    found.push((bound.error / spacing(bound.value), condition));
                }
            }
        }
    }
    let plain = found.iter().map(|(ulps, _)| *ulps).fold(0.0, f64::max);
    if found.is_empty() || !plain.is_finite() {
        return None;
    }
    let whole = |ulps: f64| (ulps * ROOM).ceil();
    if whole(plain) <= PLAIN {
        return Some(Claim { ulps: whole(plain), condition: None, points: found.len() });
    }
    let relative = found.iter().map(|(ulps, condition)| ulps / condition).fold(0.0, f64::max);
    let largest = found.iter().map(|(_, condition)| *condition).fold(1.0, f64::max);
    Some(Claim { ulps: whole(relative), condition: Some(largest), points: found.len() })
}

/// Radii over six decades, next to breakpoints, and next to the end of the profile.
fn places(sampler: &mut Sampler, evaluator: &Evaluator<'_>) -> Vec<f64> {
    let end = reach(evaluator);
    let mut list: Vec<f64> = sampler.points(6.0, POINTS).into_iter().map(|decades| end * 10f64.powf(-decades)).collect();
    list.extend(sampler.points(end, POINTS));
    for place in evaluator.breakpoints_below(end) {
        list.extend([1.0 - 1e-6, 1.0 - 1e-2, 1.0 + 1e-9, 1.0 + 1e-6, 1.0 + 1e-3, 1.1, 1.5].map(|factor| place * factor));
    }
    let limit = evaluator.limit();
    if limit.is_finite() {
        list.extend([1e-2, 1e-4, 1e-8].map(|gap| limit * (1.0 - gap)));
    }
    list.retain(|place| *place < limit);
    list
}

fn arguments_at(quantity: Quantity, place: f64, evaluator: &Evaluator<'_>) -> Vec<Vec<f64>> {
    match quantity {
        Quantity::Pressure => [1e-4, 0.1, 0.4, 0.7, 0.95, 0.9999].map(|part| vec![place * part, place]).to_vec(),
        Quantity::Radius => match evaluator.slope(place) {
            Ok(depth) if depth.estimate.value > 0.0 => vec![vec![depth.estimate.value]],
            _ => Vec::new(),
        },
        _ => vec![vec![place]],
    }
}

/// 1 + Σ |v ∂f/∂v|/|f|.
fn condition(machine: &mut Machine<'_>, name: &str, arguments: &[f64], at: Bounded) -> f64 {
    let mut total = 1.0;
    for index in 0..arguments.len() {
        let mut moved = |factor: f64| {
            let changed: Vec<f64> = arguments.iter().enumerate().map(|(i, own)| if i == index { own * factor } else { *own }).collect();
            machine.run(name, &changed).map(|own| own.value)
        };
        if let (Some(more), Some(less)) = (moved(1.0 + STEP), moved(1.0 - STEP)) {
            let share = ((more - less) / (2.0 * STEP * at.value)).abs();
            if share.is_finite() {
                total += share;
            }
        }
    }
    total
}

/// The radius a of g(a) = d with its bound, and the condition number of a: an error of g moves the root by itself over g′.
fn root(machine: &mut Machine<'_>, a: f64, values: &[f64]) -> Option<(Bounded, f64)> {
    let mut at = |a: f64| machine.run("sneddon_g", &[&[a], values].concat());
    let (own, more, less) = (at(a)?, at(a * (1.0 + STEP))?, at(a * (1.0 - STEP))?);
    let slope = (more.value - less.value) / (2.0 * STEP * a);
    let positive = slope > 0.0 && own.value > 0.0;
    let error = (own.error + spacing(own.value)) / slope + 2.0 * spacing(a);
    positive.then(|| (Bounded { value: a, error }, 1.0 + own.value / (slope * a)))
}

/// The distance of neighbouring doubles.
fn spacing(value: f64) -> f64 {
    value.abs().next_up() - value.abs()
}
