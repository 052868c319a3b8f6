//! This crate at the same places: expressions as typed, at the same tolerance.

use peers::{Place, line, median_ns, places};
use sneddon::expr::{Bindings, Expr, Number};
use sneddon::parse;
use sneddon::transform::{Evaluator, Method, Profile, Solution, derive};

const TOLERANCE: f64 = 1e-12;

/// The profiles as a user types them, with the doubles that stand for their numbers.
fn typed(profile: &str) -> (&'static str, &'static [(&'static str, f64)]) {
    match profile {
        "sphere" => ("R-sqrt(R^2-r^2)", &[("R", 2.0)]),
        "power" => ("r^2.7", &[]),
        "worn" => ("piecewise(0, r<b, (r^2-b^2)/(2*R))", &[("b", 0.6), ("R", 2.0)]),
        "cosine" => ("h*(1-cos(k*r))", &[("h", 0.4), ("k", 2.2)]),
        "root" => ("h*sqrt(r)", &[("h", 0.7)]),
        "ln_cosh" => ("ln(cosh(r))", &[]),
        "gaussian" => ("h*(1-exp(-r^2/q))", &[("h", 0.4), ("q", 1.69)]),
        "kink" => ("h*max(0, r-b)", &[("h", 0.3), ("b", 0.6)]),
        other => panic!("no profile {other}"),
    }
}

fn solution(profile: &str) -> Solution {
    let (text, numbers) = typed(profile);
    let exact = |value: f64| Expr::number(Number::from_f64(value).expect("a finite number"));
    let bindings: Bindings = numbers.iter().map(|(name, value)| (*name, exact(*value))).collect();
    let profile = Profile::new(&parse::profile(text).expect("a profile").substitute(&bindings)).expect("a profile");
    derive(&profile).expect("a solution")
}

fn main() {
    let file = std::env::args().nth(1).expect("the file of points");
    for place in places(&file) {
        let solution = solution(&place.profile);
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Quadrature, TOLERANCE).expect("numbers");
        pointwise(&place, &evaluator);
    }
}

/// One value by quadrature of the profile as typed.
fn pointwise(place: &Place, evaluator: &Evaluator<'_>) {
    let x = place.x;
    match place.work.split('@').next() {
        Some("force") => {
            let twice = |a: f64| evaluator.force(a).map(|own| (2.0 * own.estimate.value, own.estimate.evaluations));
            show(place, "typed", || twice(x).ok());
        }
        Some("pressure") => {
            const RADIUS: f64 = 3.0;
            let one = |s: f64| evaluator.pressure(s, RADIUS).ok().flatten().map(|own| (own.estimate.value, own.estimate.evaluations));
            show(place, "typed", || one(x));
        }
        _ => show(place, "typed", || evaluator.slope(x).ok().map(|own| (own.estimate.value, own.estimate.evaluations))),
    }
}

fn show(place: &Place, form: &str, call: impl Fn() -> Option<(f64, u64)>) {
    let Some((value, evaluations)) = call() else { return };
    line(&place.work, "ours", form, median_ns(&call), place.error(value), evaluations);
}
