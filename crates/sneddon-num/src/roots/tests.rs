//! Roots down to the last digit, at extremes, with counted evaluations.
#![allow(clippy::unwrap_used, clippy::type_complexity)]

use proptest::prelude::*;

use super::*;

fn solve(f: impl Fn(f64) -> f64, lower: f64, upper: f64) -> Root {
    bracketed(|x| Ok::<f64, NumError>(f(x)), lower, upper, &RootOptions::default()).unwrap()
}

fn assert_ends(root: Root, truth: f64) {
    assert!((root.x - truth).abs() <= 2.0 * f64::EPSILON * truth.abs(), "{root:?} for {truth}");
    assert!(root.residual == 0.0 || root.upper == root.lower.next_up(), "{root:?}");
}

#[test]
fn known_roots_to_the_last_digit_in_few_steps() {
    let cases: [(fn(f64) -> f64, f64, f64, f64); 6] = [
        (|x| x * x - 2.0, 0.5, 2.0, std::f64::consts::SQRT_2),
        (f64::cos, 1.0, 2.0, std::f64::consts::FRAC_PI_2),
        (|x| x.ln() - 1.0, 1.0, 10.0, std::f64::consts::E),
        (|x| x - 0.75, 0.1, 1.0, 0.75),
        // x = e^(−x): the omega constant.
        (|x| x - (-x).exp(), 0.1, 1.0, 0.567_143_290_409_783_8),
        (|x| 1.0 / x - 3.0, 0.1, 100.0, 1.0 / 3.0),
    ];
    for (f, lower, upper, truth) in cases {
        let root = solve(f, lower, upper);
        assert_ends(root, truth);
        assert!(root.evaluations <= 22, "{root:?}");
        let backwards = solve(f, upper, lower);
        assert_ends(backwards, truth);
    }
}

#[test]
fn brackets_over_all_magnitudes() {
    for truth in [1e-290, 3e-7, 1.0, 2.5e11, 1e290] {
        let root = solve(|x| x - truth, 1e-300, 1e300);
        assert_ends(root, truth);
        assert!(root.evaluations <= 60, "{root:?}");
        // √x and x³ over the same range: x³ over- and underflows.
        assert!(solve(|x| x.sqrt() - truth.sqrt(), 1e-300, 1e300).evaluations <= 80);
        let cube = solve(|x| x.powi(3) - 8.0, 1e-300, 1e300);
        assert_ends(cube, 2.0);
    }
    let through_zero = solve(|x| x, -f64::MAX, f64::MAX);
    assert_eq!(through_zero.x, 0.0);
    let negative = solve(|x| x + 1e-200, -1e300, 1e300);
    assert_ends(negative, -1e-200);
}

#[test]
fn flat_steep_and_jumping_functions() {
    // Underflows to exactly 0 around the root.
    let flat = solve(|x| (x - 1.0).powi(21), 0.0, 3.0);
    assert!(flat.residual == 0.0 || (flat.x - 1.0).abs() < 1e-10);
    assert!(flat.evaluations <= 200, "{flat:?}");
    let step = solve(|x| if x < 0.3 { -1.0 } else { 1e300 }, 0.0, 1.0);
    assert_eq!((step.upper, step.lower), (0.3, 0.3f64.next_down()));
    let pole = solve(
        |x| {
            if x < 0.7 { 1.0 / (0.7 - x) } else { f64::NEG_INFINITY }
        },
        0.0,
        1.0,
    );
    assert_eq!(pole.upper, pole.lower.next_up());
    let essential = solve(|x| if x == 0.0 { 0.0 } else { x * (-1.0 / (x * x)).exp() } - 1e-280, 0.0, 5.0);
    assert!(essential.upper == essential.lower.next_up() && essential.evaluations <= 200, "{essential:?}");
}

#[test]
fn stops_at_the_tolerance_and_at_the_limit() {
    let loose = RootOptions { rel_tol: 1e-6, ..RootOptions::default() };
    let f = |x: f64| Ok::<f64, NumError>(x.exp() - 5.0);
    let root = bracketed(f, 0.5, 10.0, &loose).unwrap();
    assert!(root.upper - root.lower <= 1e-6 * root.x && root.evaluations <= 14, "{root:?}");
    assert!(root.lower <= 5f64.ln() && 5f64.ln() <= root.upper);
    let few = RootOptions { max_evaluations: 4, ..RootOptions::default() };
    let stopped = bracketed(f, 0.5, 10.0, &few).unwrap_err();
    assert!(matches!(stopped, NumError::EvaluationLimit { evaluations: 4, value, error }
        if (value - 5f64.ln()).abs() <= error));
}

#[test]
fn errors_name_the_place() {
    let solve = |f: fn(f64) -> f64, a, b| bracketed(|x| Ok(f(x)), a, b, &RootOptions::default()).unwrap_err();
    let none = NumError::NoBracket { lower: 1.0, upper: 2.0, at_lower: 1.0, at_upper: 4.0 };
    assert_eq!(solve(|x| x * x, 1.0, 2.0), none);
    assert!(matches!(solve(f64::sqrt, -1.0, 2.0), NumError::NotFinite { at: -1.0 }));
    assert!(matches!(solve(|x| x, -1.0, f64::INFINITY), NumError::NotFinite { .. }));
    let own = bracketed(|_| Err::<f64, NumError>(NumError::NotFinite { at: 7.0 }), 0.0, 1.0, &RootOptions::default());
    assert_eq!(own, Err(NumError::NotFinite { at: 7.0 }));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn random_monotone_functions(exponent in -250i32..250, m in 1.0..10.0f64, power in 0.05..20.0f64, below in 0..40i32, above in 0..40i32) {
        let truth = m * 10f64.powi(exponent);
        let f = |x: f64| (x / truth).powf(power) - 1.0;
        let root = solve(f, truth * 0.99 * 10f64.powi(-below), truth * 1.01 * 10f64.powi(above));
        prop_assert!(root.evaluations <= 120, "{:?}", root);
        // A flat power spreads its rounding error over 1/power units.
        prop_assert!((root.x / truth - 1.0).abs() <= 4.0 * f64::EPSILON * (1.0 + 1.0 / power), "{root:?} {truth:e}");
    }
}
