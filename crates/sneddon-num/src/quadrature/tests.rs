//! Values against closed forms, errors never below the truth, evaluation counts.
#![allow(clippy::unwrap_used, clippy::panic, clippy::type_complexity)]

mod honesty;

use super::*;
use crate::{Bounded, Estimate, NumError};

/// A plain function of x with a generous bound on its own rounding.
fn plain(f: impl Fn(f64) -> f64) -> impl FnMut(Point) -> Bounded {
    move |p| {
        let value = f(p.x);
        Bounded { value, error: 4.0 * f64::EPSILON * value.abs() }
    }
}

fn by_distance() -> Options {
    Options { charge_x: false, ..Options::default() }
}

/// The estimate however the integration ended.
fn best(result: Result<Estimate, NumError>) -> Estimate {
    match result {
        Ok(found) => found,
        Err(NumError::ToleranceNotReached { value, error, evaluations, .. } | NumError::EvaluationLimit { value, error, evaluations }) => {
            Estimate::estimated(value, error, evaluations)
        }
        Err(other) => panic!("{other}"),
    }
}

fn assert_honest(found: Estimate, truth: f64, slack: f64) {
    let off = (found.value - truth).abs();
    assert!(off <= found.error + f64::EPSILON * truth.abs(), "off by {off:e}, claimed {:e}", found.error);
    assert!(found.error <= slack * truth.abs(), "claims {:e} of {truth:e}", found.error);
}

#[test]
fn smooth_functions_take_one_rule() {
    let cases: [(fn(f64) -> f64, f64, f64, f64); 4] = [
        (f64::exp, 0.0, 1.0, std::f64::consts::E - 1.0),
        (f64::sin, 0.0, std::f64::consts::FRAC_PI_2, 1.0),
        (|x| 1.0 / (1.0 + x), 0.0, 1.0, std::f64::consts::LN_2),
        (|x| x.powi(5), 1.0, 2.0, 10.5),
    ];
    for (f, lower, upper, truth) in cases {
        let found = integrate(&mut plain(f), &[Panel::smooth(lower, upper)], &Options::default()).unwrap();
        assert_honest(found, truth, 1e-12);
        assert_eq!(found.evaluations, 21);
        let loose = Options { rel_tol: 1e-8, ..Options::default() };
        let found = integrate(&mut plain(f), &[Panel::smooth(lower, upper)], &loose).unwrap();
        assert_honest(found, truth, 1e-8);
        assert_eq!(found.evaluations, 15);
    }
}

#[test]
fn powers_and_logarithms_at_a_told_end() {
    for alpha in [-0.9, -0.5, 0.3] {
        let mut f = |p: Point| p.bounded_from_lower().powf(Bounded::exact(alpha));
        let found = integrate(&mut f, &[Panel::singular(0.0, 1.0)], &by_distance()).unwrap();
        assert_honest(found, 1.0 / (1.0 + alpha), 1e-12);
        assert!(found.evaluations < 500, "{found:?}");
    }
    let mut ln = |p: Point| p.bounded_from_lower().apply(f64::ln, 1.0);
    let found = integrate(&mut ln, &[Panel::singular(0.0, 1.0)], &by_distance()).unwrap();
    assert_honest(found, -1.0, 1e-12);
    let mut product = |p: Point| {
        let x = p.bounded_from_lower();
        x.sqrt() * x.apply(f64::ln, 1.0)
    };
    let sharp = Options { rel_tol: 1e-13, ..by_distance() };
    assert_honest(integrate(&mut product, &[Panel::singular(0.0, 1.0)], &sharp).unwrap(), -4.0 / 9.0, 1e-13);
    // The same far from the origin, where only the distance locates the end accurately.
    let mut shifted = |p: Point| Bounded::exact(1.0) / p.bounded_from_upper().sqrt();
    let found = integrate(&mut shifted, &[Panel::singular(1e6, 1e6 + 0.25)], &by_distance()).unwrap();
    assert_honest(found, 1.0, 1e-12);
}

#[test]
fn tails_that_are_cut_are_accounted_for() {
    // ∫ x^(−0.999): half of it lies below 1e−300.
    let mut f = |p: Point| p.bounded_from_lower().powf(Bounded::exact(-0.999));
    let found = best(integrate(&mut f, &[Panel::singular(0.0, 1.0)], &by_distance()));
    assert!((found.value - 1000.0).abs() <= found.error && found.error < 2000.0, "{found:?}");
    // 1/x is not integrable, so the result must not claim a small error.
    let mut pole = |p: Point| Bounded::exact(1.0) / p.bounded_from_lower();
    let found = integrate(&mut pole, &[Panel::singular(0.0, 1.0)], &by_distance());
    assert!(matches!(found, Err(NumError::ToleranceNotReached { error, .. }) if error > 1e3), "{found:?}");
}

#[test]
fn kinks_told_by_panels_and_untold() {
    let truth = 5.0 / 18.0;
    let mut f = plain(|x| (x - 1.0 / 3.0).abs());
    let third = 1.0 / 3.0;
    let told = [Panel::smooth(0.0, third), Panel::smooth(third, 1.0)];
    let found = integrate(&mut f, &told, &Options::default()).unwrap();
    assert_honest(found, truth, 1e-12);
    assert_eq!(found.evaluations, 42);
    let untold = integrate(&mut f, &[Panel::smooth(0.0, 1.0)], &Options::default()).unwrap();
    assert_honest(untold, truth, 1e-12);
    assert!(untold.evaluations < 3000);
}

#[test]
fn oscillation_spike_and_blank_panels() {
    let options = Options { abs_tol: 1e-13, ..Options::default() };
    let found = integrate(&mut plain(|x| (220.0 * x).cos()), &[Panel::smooth(0.0, 1.0)], &options);
    let truth = 220f64.sin() / 220.0;
    let found = best(found);
    assert!((found.value - truth).abs() <= found.error && found.error < 3e-13, "{found:?}");
    assert!(found.evaluations < 2500, "{found:?}");
    // Underflows to zero at every node of the first rule.
    let spike = |x: f64| (-((x - 0.3) / 1e-3).powi(2)).exp();
    let found = integrate(&mut plain(spike), &[Panel::smooth(0.0, 1.0)], &Options::default()).unwrap();
    assert_honest(found, 1e-3 * std::f64::consts::PI.sqrt(), 1e-12);
    let zero = integrate(&mut plain(|_| 0.0), &[Panel::smooth(0.0, 1.0)], &Options::default()).unwrap();
    assert!(zero.value == 0.0 && zero.error == 0.0 && zero.evaluations < 400, "{zero:?}");
}

#[test]
fn a_pole_close_to_an_end_is_zoomed_in_on() {
    // 1/(s² + ε²), ε = 1e−8: needs the exact distance and some 25 bisections, without giving up.
    let mut f = |p: Point| {
        let s = p.bounded_from_lower();
        Bounded::exact(1.0) / (s * s + Bounded::exact(1e-16))
    };
    let found = integrate(&mut f, &[Panel::smooth(1.0, 2.0)], &by_distance()).unwrap();
    assert_honest(found, 1e8f64.atan() * 1e8, 1e-12);
    assert!(found.evaluations < 2000, "{found:?}");
    // The rounded x loses the same digits, and the estimate reflects this.
    let careless = |x: f64| 1.0 / ((x - 1.0).powi(2) + 1e-16);
    let found = best(integrate(&mut plain(careless), &[Panel::smooth(1.0, 2.0)], &Options::default()));
    assert_honest(found, 1e8f64.atan() * 1e8, 1e-5);
}

#[test]
fn impossible_tolerances_end_quickly_and_honestly() {
    let tight = Options { rel_tol: 1e-17, ..Options::default() };
    let result = integrate(&mut plain(f64::exp), &[Panel::smooth(0.0, 1.0)], &tight);
    let found = best(result);
    assert!(matches!(result, Err(NumError::ToleranceNotReached { .. })));
    assert!(found.evaluations <= 63);
    assert_honest(found, std::f64::consts::E - 1.0, 1e-14);
    // Noise of 1e−9 that the integrand does not confess: still seen, and not chased for ever.
    let mut state = 1u64;
    let mut noisy = |p: Point| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        Bounded::exact(p.x.exp() + 1e-9 * ((state >> 40) as f64 / 16_777_216.0 - 0.5))
    };
    let found = best(integrate(&mut noisy, &[Panel::smooth(0.0, 1.0)], &Options::default()));
    assert_honest(found, std::f64::consts::E - 1.0, 1e-7);
    assert!(found.evaluations < 20_000, "{found:?}");
    // Confessed noise ends the work at once.
    let mut confessed = |p: Point| Bounded { value: p.x.exp(), error: 1e-9 };
    let found = best(integrate(&mut confessed, &[Panel::smooth(0.0, 1.0)], &Options::default()));
    assert_honest(found, std::f64::consts::E - 1.0, 1e-9);
    assert!(found.evaluations <= 63);
}

#[test]
fn limits_bad_values_and_bad_panels() {
    let few = Options { max_evaluations: 300, ..Options::default() };
    let result = integrate(&mut plain(|x| x.sqrt()), &[Panel::smooth(0.0, 1.0)], &few);
    assert!(matches!(result, Err(NumError::EvaluationLimit { .. })));
    let found = best(result);
    assert!((found.value - 2.0 / 3.0).abs() <= found.error && found.evaluations <= 300);
    let pole = integrate(&mut plain(|x| 1.0 / (x - 0.5)), &[Panel::smooth(0.0, 1.0)], &few);
    assert_eq!(pole, Err(NumError::NotFinite { at: 0.5 }));
    for (lower, upper) in [(1.0, 0.0), (0.0, f64::INFINITY), (f64::NAN, 1.0), (-f64::MAX, f64::MAX)] {
        let wrong = integrate(&mut plain(|x| x), &[Panel::smooth(lower, upper)], &few);
        assert!(matches!(wrong, Err(NumError::OutOfDomain { .. })));
    }
    let empty = integrate(&mut plain(|x| x), &[Panel::smooth(2.0, 2.0)], &few).unwrap();
    assert!(empty.value == 0.0 && empty.evaluations == 0);
    let many = vec![Panel::smooth(0.0, 1.0); 1000];
    let stopped = integrate(&mut plain(|x| x), &many, &few);
    assert!(matches!(stopped, Err(NumError::EvaluationLimit { error: f64::INFINITY, evaluations: ..400, .. })));
    let huge = vec![Panel::smooth(0.0, 1.0); 4];
    let sum = integrate(&mut plain(|_| 8e307), &huge, &few);
    assert!(matches!(sum, Err(NumError::OutOfDomain { .. })));
    // Panels near the ends of the range of numbers.
    let tiny = integrate(&mut plain(|_| 1.0), &[Panel::smooth(0.0, 1e-300)], &few).unwrap();
    assert_honest(tiny, 1e-300, 1e-12);
    let mut narrow = |p: Point| Bounded::exact(1.0) / p.bounded_from_lower().sqrt();
    let found = best(integrate(&mut narrow, &[Panel::singular(0.0, 1e-200)], &by_distance()));
    assert_honest(found, 2e-100, 1e-12);
}

#[test]
fn scale_does_not_matter() {
    for scale in [1e-150, 1e-3, 1e150] {
        let f = |x: f64| (x / scale).exp();
        let found = integrate(&mut plain(f), &[Panel::smooth(0.0, scale)], &Options::default()).unwrap();
        assert_honest(found, scale * (std::f64::consts::E - 1.0), 1e-12);
        assert_eq!(found.evaluations, 21);
    }
}
