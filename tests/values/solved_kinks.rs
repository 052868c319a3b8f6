//! Kinks that solve with parameters, against the integral of f′ over the side that a bisection finds.

use sneddon::expr::{Symbol, derivative};
use sneddon::num::Bound;
use sneddon::parse;
use sneddon::print;
use sneddon::transform::{Evaluator, Method};
use sneddon_checks::formulas::{bindings, derived, number, relative, typed};
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;
use std::f64::consts::FRAC_PI_2;

/// A function that is compared with a height, increasing or decreasing, and its conditions; u is a height, R, b, w and c are lengths.
const ROWS: [(&str, &[&str]); 22] = [
    ("R-sqrt(R^2-r^2)-u", &["u < R"]),
    ("u-R+sqrt(R^2-r^2)", &["u < R"]),
    ("sqrt(R^2-b^2)-sqrt(R^2-r^2)", &["b < R"]),
    ("sqrt(w^2+r^2)-w-u", &[]),
    ("c*(1-exp(-r^2/w^2))-u", &["u < c"]),
    ("c*(1-1/(1+r^2/w^2))-u", &["u < c"]),
    ("c*r^2/(r^2+w^2)-u", &["u < c"]),
    ("c*(1-1/sqrt(1+r^2/w^2))-u", &["u < c"]),
    ("c*ln(1+r^2/w^2)-u", &[]),
    ("c*asinh(r/w)-u", &[]),
    ("c*sinh(r/w)-u", &[]),
    ("c*(cosh(r/w)-1)-u", &[]),
    ("c*atan(r/w)-u", &["u < pi/2*c"]),
    ("c*tanh(r/w)-u", &["u < c"]),
    ("c*atanh(r/w)-u", &[]),
    ("c*asin(r/w)-u", &["u < pi/2*c"]),
    ("r^2/(2*R)+c*r/w-u", &[]),
    ("c*((1+r^2/w^2)^(2/3)-1)-u", &[]),
    ("R-sqrt(R^2-r^2)-u*r/w", &["u < w"]),
    ("sqrt(R^2+r^2)-R-u*r/w", &["u < w"]),
    ("R-sqrt(R^2-r^2)-r*tan(u)", &["u < pi/4"]),
    ("R-sqrt(R^2-r^2)-r/tan(u)", &["pi/4 < u"]),
];

/// The first root on r > 0 of a function that increases or decreases up to the end of its domain.
fn root(text: &str, values: &[(&'static str, f64)]) -> Option<f64> {
    let at = |r: f64| typed(text, &[values, &[("r", r)]].concat());
    let starts = at(1e-6) > 0.0;
    let (mut lower, mut upper) = (1e-6, 1e-6);
    while (at(upper) > 0.0) == starts && upper < 1e8 {
        lower = upper;
        upper *= 1.05;
        if !at(upper).is_finite() {
            // The last number before the end of the domain.
            let (mut inside, mut outside) = (lower, upper);
            for _ in 0..100 {
                let middle = 0.5 * (inside + outside);
                if at(middle).is_finite() { inside = middle } else { outside = middle }
            }
            if (at(inside) > 0.0) == starts {
                return None;
            }
            upper = inside;
        }
    }
    for _ in 0..200 {
        let middle = 0.5 * (lower + upper);
        if (at(middle) > 0.0) == starts { lower = middle } else { upper = middle }
    }
    (upper < 1e8).then_some(upper)
}

fn simpson(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    const STEPS: u32 = 400;
    let step = (to - from) / f64::from(2 * STEPS);
    let at = |i: u32| f(from + step * f64::from(i));
    (0..STEPS).map(|i| at(2 * i) + 4.0 * at(2 * i + 1) + at(2 * i + 2)).sum::<f64>() * step / 3.0
}

#[test]
fn kinks_of_functions_in_which_r_occurs_once_solve() {
    let mut stream = Stream::new(33);
    let mut compared = 0;
    for (difference, conditions) in ROWS {
        let profile = format!("max({difference}, 0)");
        let general = derived(&profile);
        let stated: Vec<String> = general.conditions.iter().map(print::text_condition).collect();
        for own in conditions {
            assert!(stated.iter().any(|other| other == own), "{profile}: {own} is not among {stated:?}");
        }
        for _ in 0..cases(2, 20) {
            let mut values: Vec<(&str, f64)> =
                ["R", "b", "w", "c", "u"].into_iter().map(|name| (name, stream.log_uniform(0.3, 3.0))).collect();
            values.retain(|(name, _)| general.profile.parameters().iter().any(|own| own.name() == *name));
            let evaluator = Evaluator::new(&general, &bindings(&values), Method::Auto, 1e-13);
            let Some(kink) = root(difference, &values) else {
                // There is none before the end of the domain: the formulas do not apply.
                assert!(evaluator.is_err(), "{profile} with {values:?}");
                continue;
            };
            let evaluator = evaluator.unwrap_or_else(|error| panic!("{profile} with {values:?}: {error}"));
            let is_rising = typed(difference, &[&values[..], &[("r", 1e-6)]].concat()) < 0.0;
            let f_prime = derivative(&parse::profile(difference).unwrap().as_closed().unwrap().clone(), &Symbol::new("r")).unwrap();
            let f_prime = |r: f64| number(&f_prime, &[&values[..], &[("r", r)]].concat());
            let is_inside = |x: &f64| typed(difference, &[&values[..], &[("r", 1.02 * x)]].concat()).is_finite();
            for x in [0.4, 1.02, 1.1].map(|factor| kink * factor).into_iter().filter(is_inside) {
                let side = (kink / x).min(1.0).asin();
                let (from, to) = if is_rising { (side, FRAC_PI_2) } else { (0.0, side) };
                let truth = x * simpson(from, to, |angle| f_prime(x * angle.sin()));
                let own = evaluator.equivalent(x).unwrap().estimate.value;
                assert!(relative(own, truth) < 1e-11, "{profile} with {values:?}: {own} is not {truth} at {x}");
                compared += 1;
            }
        }
    }
    assert!(compared > 60 * cases(1, 10), "{compared} values");
}

/// The kink of a sphere worn to the height h is exact, and √(R² - 2hR + h²) is printed as R - h because h < R.
#[test]
fn a_worn_sphere_may_be_typed_with_the_height_that_is_missing() {
    let formula = |text: &str| print::text(&derived(text).equivalent_profile().formula);
    assert_eq!(formula("max(0,R-sqrt(R^2-r^2)-h)"), "piecewise(0, x < sqrt(2*h*R - h^2), x*atanh(sqrt(x^2 - 2*h*R + h^2)/(R - h)))");
    assert_eq!(formula("max(0,5-sqrt(25-r^2)-0.3)"), "piecewise(0, x < sqrt(291)/10, x*atanh(sqrt(100*x^2 - 291)/47))");
}

/// Class "a limit that is too small for ordinary input": under sixty kinks, the pressure of each kink is an integral.
#[test]
fn pressures_under_many_kinks_are_proven() {
    let text: String = std::iter::once("r".to_owned()).chain((1..60).map(|i| format!("+abs(r-{i}/61)"))).collect();
    let solution = derived(&text);
    let ask = |method| Evaluator::new(&solution, &bindings(&[]), method, 1e-13).unwrap();
    let (own, other) = (ask(Method::Auto), ask(Method::Quadrature));
    for r in [0.1, 0.37, 0.7] {
        let [own, other] = [&own, &other].map(|evaluator| evaluator.pressure(r, 0.9).unwrap().unwrap().estimate);
        assert!(own.bound == Bound::Proven && own.error < 1e-11 * own.value.abs(), "{r}: {own:?}");
        assert!((own.value - other.value).abs() <= own.error + other.error, "{r}: {own:?} {other:?}");
    }
}
