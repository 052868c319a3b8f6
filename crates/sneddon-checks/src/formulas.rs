//! Formulas as numbers: closed, piecewise, and with integrals.

use sneddon::eval::{FloatAlgebra, Tape, walk};
use sneddon::expr::{Bindings, Expr, Formula, Number, Symbol};
use sneddon::num::Bounded;
use sneddon::num::quadrature::{Options, Panel, Point, integrate};
use sneddon::{contact::Contact, parse, transform};

/// Names with their values.
pub type Values<'a> = [(&'a str, f64)];

/// The value of an expression; every symbol needs a value.
pub fn number(expr: &Expr, values: &Values<'_>) -> f64 {
    walk(expr, &mut FloatAlgebra, &mut |s| values.iter().rev().find(|(name, _)| *name == s.name()).map(|(_, v)| *v))
        .unwrap_or_else(|error| panic!("{error}"))
}

/// The value of a formula. Integrals lose half the digits where a root vanishes at an end: about 1e-8 remains.
pub fn value(formula: &Formula, values: &Values<'_>) -> f64 {
    match formula {
        Formula::Closed(expr) => number(expr, values),
        Formula::Sum(parts) => parts.iter().map(|part| value(part, values)).sum(),
        Formula::Scaled(factor, inner) => number(factor, values) * value(inner, values),
        Formula::Piecewise { variable, pieces, last } => {
            let at = number(&Expr::from(variable.clone()), values);
            let piece = pieces.iter().find(|(_, end)| at < number(end, values)).map_or(last.as_ref(), |(piece, _)| piece);
            value(piece, values)
        }
        Formula::Integral { integrand, variable, lower, upper } => {
            let (lower, upper) = (number(lower, values), number(upper, values));
            if lower >= upper {
                return 0.0;
            }
            // The bound variable hides a free one of the same name.
            let free = values.iter().filter(|(name, _)| *name != variable.name());
            let names: Vec<Symbol> = free.clone().map(|(name, _)| Symbol::new(name)).chain([variable.clone()]).collect();
            let mut inputs: Vec<f64> = free.map(|(_, v)| *v).chain([0.0]).collect();
            let Formula::Closed(integrand) = integrand.as_ref() else { panic!("an integral of pieces") };
            let (tape, mut slots) = (Tape::compile(std::slice::from_ref(integrand), &names).unwrap(), Vec::new());
            let mut inside = |point: Point| {
                *inputs.last_mut().unwrap() = point.x;
                let found = tape.run(&mut FloatAlgebra, &inputs, &mut slots).unwrap();
                // The node that rounding moved onto the singular end weighs nothing.
                Bounded::exact(if found.is_finite() { found } else { 0.0 })
            };
            let options = Options { rel_tol: 1e-8, charge_x: false, ..Options::default() };
            integrate(&mut inside, &[Panel::singular(lower, upper)], &options).map_or(f64::NAN, |found| found.value)
        }
    }
}

/// Parses a formula of the program's grammar.
pub fn formula(text: &str) -> Formula {
    parse::formula(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// The value of a formula typed in the program's grammar.
pub fn typed(text: &str, values: &Values<'_>) -> f64 {
    value(&formula(text), values)
}

/// Parameters as exact rationals.
pub fn bindings(values: &Values<'_>) -> Bindings {
    values.iter().map(|(name, v)| (*name, Expr::number(Number::from_f64(*v).unwrap()))).collect()
}

/// Reads and derives a profile, parameters left as symbols.
pub fn derived(profile: &str) -> transform::Solution {
    derived_with(profile, &[])
}

/// Reads and derives a profile with its parameters set.
pub fn derived_with(profile: &str, values: &Values<'_>) -> transform::Solution {
    let formula = parse::profile(profile).unwrap_or_else(|error| panic!("{profile}: {error}"));
    let profile = transform::Profile::new(&formula.substitute(&bindings(values))).unwrap_or_else(|error| panic!("{profile}: {error}"));
    transform::derive(&profile).unwrap()
}

/// A contact of a derived profile, parameters bound as numbers.
pub fn contact<'a>(solution: &'a transform::Solution, values: &Values<'_>, modulus: f64, depth: Option<f64>) -> Contact<'a> {
    let evaluator = transform::Evaluator::new(solution, &bindings(values), transform::Method::Auto, 1e-13).unwrap();
    Contact::new(evaluator, modulus, depth, 1e-13)
}

/// |u − v| relative to the larger; 0 for equal zeros, NaN kept.
pub fn relative(u: f64, v: f64) -> f64 {
    if u == v { 0.0 } else { (u - v).abs() / u.abs().max(v.abs()) }
}
