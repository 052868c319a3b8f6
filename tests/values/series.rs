//! The series way: term by term as the source's Problem 8, with a remainder that is never below the true error.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::expr::Bindings;
use sneddon::num::Estimate;
use sneddon::transform::{Evaluator, Method, Profile, SeriesEvaluator, SeriesFailure};
use sneddon::{eval::SeriesError, parse};
use sneddon_checks::formulas::{bindings, derived_with};
use sneddon_checks::random::Stream;

fn profile(text: &str, values: &[(&str, f64)]) -> Profile {
    Profile::new(&parse::profile(text).unwrap().substitute(&bindings(values))).unwrap()
}

/// A profile with its parameters and how far out the series is asked for.
type Case = (&'static str, &'static [(&'static str, f64)], f64);

const CASES: &[Case] = &[
    ("R-sqrt(R^2-r^2)", &[("R", 2.0)], 1.8),
    ("r^2/(R+sqrt(R^2-r^2))", &[("R", 2.0)], 1.5),
    ("h*(1-exp(-r^2/w^2))", &[("h", 0.5), ("w", 1.25)], 2.5),
    ("h*(1-cos(k*r))", &[("h", 0.5), ("k", 2.0)], 3.0),
    ("sin(k*r)/(1+r)", &[("k", 1.5)], 0.7),
    ("1-sin(k*r)/(k*r)", &[("k", 1.5)], 2.0),
    ("h*ln(1+r/w)", &[("h", 0.5), ("w", 1.5)], 1.2),
    ("h*ln(1+r^2/w^2)", &[("h", 0.5), ("w", 1.5)], 1.2),
    ("C*atan(r/w)", &[("C", 0.75), ("w", 1.5)], 1.2),
    ("C*atan(1/2+r/w)", &[("C", 0.75), ("w", 1.5)], 1.0),
    ("C*r*asinh(r/w)", &[("C", 0.75), ("w", 1.5)], 1.2),
    ("asin(r/R)", &[("R", 2.0)], 1.5),
    ("artanh(r/R)", &[("R", 2.0)], 1.5),
    ("r*tanh(r)", &[], 0.8),
    ("tan(r/2)", &[], 1.0),
    ("erf(r/w)", &[("w", 1.5)], 2.0),
    ("1-besselj(0,k*r)", &[("k", 2.0)], 3.0),
    ("besselj(1,k*r)+besseli(2,r)", &[("k", 2.0)], 2.0),
    ("struveh(0,k*r)-struvel(1,r)", &[("k", 2.0)], 2.0),
    ("2*k*r/pi-struveh(0,k*r)", &[("k", 1.3)], 2.0),
    ("r*struvel(0,r^2)+struveh(2,k*r)", &[("k", 1.3)], 1.2),
    ("dawson(r/w)", &[("w", 1.5)], 2.0),
    ("r/w-dawson(r/w)", &[("w", 1.5)], 2.0),
    ("(1+r^2/b^2)^(1/3)-1", &[("b", 1.5)], 1.2),
    ("(1+r)^(5/2)-1", &[], 0.7),
    ("r^1.5*exp(-r)", &[], 2.0),
    ("r^1.5+r^2/4+r^0.5*sinh(r)", &[], 2.0),
    ("r^2*sqrt(1+r)/(2-r)", &[], 0.8),
    ("exp(sin(r))-1", &[], 1.5),
    ("r^6-r^3+r/2", &[], 3.0),
];

fn hold(what: &str, own: Estimate, other: Estimate) {
    let difference = (own.value - other.value).abs();
    assert!(difference <= own.error + other.error, "{what}: {own:?} against {other:?}, off by {difference:e}");
}

#[test]
fn the_error_is_never_below_the_true_one() {
    let mut stream = Stream::new(21);
    for (text, values, end) in CASES {
        let (shape, solution) = (profile(text, values), derived_with(text, values));
        let plain = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
        for order in [3, 8, 25] {
            let series = SeriesEvaluator::new(&shape, order).unwrap();
            for _ in 0..2 {
                let a = stream.short(0.05, *end);
                let what = |name: &str| format!("{name}({a}) of {text} to order {order}");
                let Ok(g) = series.equivalent(a) else { continue };
                hold(&what("g"), g.estimate, plain.equivalent(a).unwrap().estimate);
                hold(&what("F"), series.force(a).unwrap().estimate, plain.force(a).unwrap().estimate);
                hold(&what("G"), series.integral(a).unwrap().estimate, plain.integral(a).unwrap().estimate);
                hold(&what("f"), series.height(a).unwrap().estimate, plain.height(a).unwrap().estimate);
                let r = 0.5 * a;
                hold(&what("p"), series.pressure(r, a).unwrap().estimate, plain.pressure(r, a).unwrap().unwrap().estimate);
            }
        }
    }
}

/// The bound is of use: twenty-five terms give digits well inside the circle of convergence.
#[test]
fn the_error_is_small_where_the_series_is() {
    for (text, values, end) in CASES {
        let series = SeriesEvaluator::new(&profile(text, values), 25).unwrap();
        let g = series.equivalent(0.1 * end).unwrap().estimate;
        assert!(g.error <= 1e-9 * g.value.abs(), "{text}: {g:?}");
    }
}

/// Problem 8: g = x arsinh(x/√(R²−x²)) = Σ x^(2k)/((2k−1) R^(2k−1)); fifty digits of mpmath at R = 2, x = 1.
#[test]
fn a_sphere_to_rising_orders() {
    let exact = 0.549_306_144_334_054_8;
    let mut last = f64::INFINITY;
    for order in [4, 10, 20, 40, 60] {
        let series = SeriesEvaluator::new(&profile("R-sqrt(R^2-r^2)", &[("R", 2.0)]), order).unwrap();
        let g = series.equivalent(1.0).unwrap().estimate;
        let off = (g.value - exact).abs();
        assert!(off <= g.error && g.error < last, "order {order}: {g:?}");
        assert!(g.error < 40.0 * off + 1e-15, "order {order}: {g:?}, off by {off:e}");
        last = g.error;
    }
    assert!(last < 1e-15);
}

#[test]
fn what_has_no_series() {
    let failure = |text: &str, at: f64| SeriesEvaluator::new(&profile(text, &[]), 10).unwrap().equivalent(at).unwrap_err();
    for text in ["r^2*ln(r)", "abs(r-1)*0+r*exp(-r^0.5)", "r^(2^(1/2))"] {
        let error = failure(text, 0.5);
        assert!(matches!(error, SeriesFailure::NotAnalytic(SeriesError::NotAnalytic { .. })), "{text}: {error}");
    }
    let worn = failure("piecewise(r^2, r<1, 2*r-1)", 1.5);
    assert!(matches!(worn, SeriesFailure::BeyondFirstPiece { .. }), "{worn}");
    let inside = SeriesEvaluator::new(&profile("piecewise(r^2, r<1, 2*r-1)", &[]), 10).unwrap().equivalent(0.5).unwrap();
    assert_eq!(inside.estimate.value, 0.5);
    // Beyond the poles at ±i nothing is promised.
    let far = failure("atan(r)", 2.0);
    assert!(matches!(far, SeriesFailure::NoBound { .. }), "{far}");
}
