//! Tests of the bounds against exact rational arithmetic: they are valid and not excessively wide.

#![allow(clippy::unwrap_used)]

use num_rational::BigRational;
use num_traits::{Signed, Zero};
use proptest::prelude::*;

use super::*;

fn exactly(value: f64) -> BigRational {
    BigRational::from_float(value).unwrap()
}

fn holds(computed: Bounded, truth: &BigRational) -> bool {
    if !computed.is_finite() {
        return computed.error == f64::INFINITY || computed.error.is_nan();
    }
    (exactly(computed.value) - truth).abs() <= exactly(computed.error)
}

/// A random number of any common size, exact or with a known disturbance.
fn operand() -> impl Strategy<Value = (Bounded, BigRational)> {
    (-1.0..1.0f64, -40i32..40, -1.0..1.0f64, 0usize..3).prop_map(|(m, e, shift, kind)| {
        let value = m * 2f64.powi(e);
        let error = [0.0, value.abs() * 1e-10, value.abs() * 0.3][kind];
        (Bounded { value, error }, exactly(value) + exactly(error) * exactly(shift))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn chains_never_err_more_than_they_say(
        first in operand(),
        steps in prop::collection::vec((operand(), 0usize..4), 1..14),
    ) {
        let (mut number, mut truth) = first;
        for ((other, exact), operation) in steps {
            if operation == 3 && exact.is_zero() { continue; }
            (number, truth) = match operation {
                0 => (number + other, truth + exact),
                1 => (number - other, truth - exact),
                2 => (number * other, truth * exact),
                _ => (number / other, truth / exact),
            };
            prop_assert!(holds(number, &truth), "{number:?}");
        }
    }

    #[test]
    fn subnormal_products_and_quotients_keep_the_bound(
        a in -1.0..1.0f64, b in -1.0..1.0f64, ea in -560i32..-480, eb in -560i32..-480, wobble in 0usize..2,
    ) {
        let x = Bounded { value: a * 2f64.powi(ea), error: [0.0, (a * 2f64.powi(ea - 9)).abs()][wobble] };
        let y = Bounded::exact(b * 2f64.powi(eb));
        let truth = (exactly(x.value) + exactly(x.error)) * exactly(y.value);
        prop_assert!(holds(x * y, &truth));
        let small = Bounded::exact(f64::MIN_POSITIVE * a);
        if b != 0.0 {
            prop_assert!(holds(small / Bounded::exact(1.0 + b.abs()), &(exactly(small.value) / exactly(1.0 + b.abs()))));
        }
    }

    #[test]
    fn root_encloses_the_truth((x, exact) in operand()) {
        // value − error ≤ √truth ≤ value + error, compared after squaring.
        let root = Bounded { value: x.value.abs(), error: x.error }.sqrt();
        let truth = if exact.is_negative() == x.value.is_sign_negative() { exact.abs() } else { -exact.abs() };
        prop_assume!(!truth.is_negative());
        let (low, high) = (exactly(root.value) - exactly(root.error), exactly(root.value) + exactly(root.error));
        prop_assert!(!low.is_positive() || &low * &low <= truth);
        prop_assert!(&high * &high >= truth);
    }

    #[test]
    fn sums_hold_and_are_tight(terms in prop::collection::vec((-1.0..1.0f64, -60i32..60), 1..40)) {
        let terms: Vec<f64> = terms.into_iter().map(|(m, e)| m * 2f64.powi(e)).collect();
        let sum = Bounded::sum(terms.iter().copied().map(Bounded::exact));
        let truth: BigRational = terms.iter().copied().map(exactly).sum();
        prop_assert!(holds(sum, &truth));
        let size: f64 = terms.iter().map(|t| t.abs()).sum();
        prop_assert!(sum.error <= sum.value.abs() * UNIT * 1.01 + size * 1e-28);
    }

    #[test]
    fn powers_hold_against_repeated_products(m in 0.5..2.0f64, rel in 0.0..0.5f64, shift in -1.0..1.0f64, n in -7i32..8) {
        let base = Bounded { value: m, error: m * rel };
        let exact = exactly(m) + exactly(base.error) * exactly(shift);
        let truth = num_traits::pow::Pow::pow(&exact, n);
        prop_assert!(holds(base.powi(n), &truth));
        prop_assert!(holds(base.powf(Bounded::exact(f64::from(n))), &truth));
        let negative = Bounded { value: -m, error: base.error }.powi(n);
        let sign = if n % 2 == 0 { truth.clone() } else { -truth };
        prop_assert!(holds(negative, &sign));
    }

    #[test]
    fn applied_functions_hold_and_are_tight(x in 0.1..5.0f64, digits in 1.0..15.0f64, shift in -1.0..1.0f64) {
        // 1/x through `apply`, whose truth is known exactly.
        let arg = Bounded { value: x, error: x * 10f64.powf(-digits) };
        let truth = (exactly(x) + exactly(arg.error) * exactly(shift)).recip();
        let result = arg.apply(|v| 1.0 / v, 0.5);
        prop_assert!(holds(result, &truth));
        prop_assert!(result.error <= 6.0 * (arg.error / x + UNIT) / (x - arg.error));
    }
}

#[test]
fn benign_chains_stay_within_twenty_times_the_truth() {
    // Σ 1/k², all terms positive: the worst case of 200 roundings is far from the usual one,
    // so the measure is the truth of the worst of several chains.
    let (mut worst_true, mut worst_bound) = (0.0f64, 0.0f64);
    for start in 1..30u32 {
        let (mut number, mut truth) = (Bounded::exact(1.0), exactly(1.0));
        for k in start..start + 4 {
            let k = f64::from(k);
            number = number + Bounded::exact(1.0) / (Bounded::exact(k) * Bounded::exact(k + 0.1));
            truth += (exactly(k) * exactly(k + 0.1)).recip();
        }
        let off = (exactly(number.value) - truth).abs();
        worst_true = worst_true.max(num_traits::ToPrimitive::to_f64(&off).unwrap());
        worst_bound = worst_bound.max(number.error);
    }
    assert!(worst_bound >= worst_true && worst_bound <= 20.0 * worst_true, "{worst_bound:e} {worst_true:e}");
}

#[test]
fn exact_steps_stay_exact() {
    let two = Bounded::exact(2.0);
    for number in [two + two, two * Bounded::exact(0.3), two - two, Bounded::exact(0.3) / two, Bounded::exact(0.0) * two] {
        assert_eq!(number.error, 0.0, "{number:?}");
    }
}

#[test]
fn edges_of_domains() {
    // √ at 0: the truth may lie anywhere in 0 … 2e-20.
    let root = Bounded { value: 1e-20, error: 1e-20 }.apply(f64::sqrt, 0.5);
    assert!(root.error >= 1e-10 && root.error < 4e-10);
    // A tenth root rises so steeply that the inner side alone would say a tenth of the truth.
    let steep = Bounded { value: 1e-20, error: 2e-20 }.apply(|x| x.powf(0.1), 1.0);
    assert!(steep.error >= 0.88 * 1e-2 && steep.error < 3e-2, "{steep:?}");
    // ln of something that may be 0 has no bound.
    assert_eq!(Bounded { value: 1e-20, error: 1e-20 }.apply(f64::ln, 1.0).error, f64::INFINITY);
    // acos just beyond 1: the value at the edge, the rest of the interval as error.
    let beyond = Bounded { value: 1.0 + 4e-16, error: 1e-15 }.apply(f64::acos, 1.0);
    assert!(beyond.value < 1e-7 && beyond.error >= 3.4e-8, "{beyond:?}");
    assert!(Bounded { value: 2.0, error: 1e-3 }.apply(f64::acos, 1.0).value.is_nan());
    // 1 + n with an n that is lost in the rounding: anything between 0 and the spacing of the numbers.
    let near_pole = Bounded { value: -1.0, error: 1e-16 }.apply(|x| if x > -1.0 { x + 1.0 } else { f64::NAN }, 1.0);
    assert!(near_pole.error >= near_pole.value, "{near_pole:?}");
}

#[test]
fn powers_at_zero_and_with_inexact_exponents() {
    let zeroish = Bounded { value: 1e-12, error: 3e-12 };
    let power = zeroish.powf(Bounded::exact(1.5));
    assert!(power.error >= 7e-18 && power.error <= 2e-17);
    assert_eq!(zeroish.powf(Bounded::exact(-0.5)).error, f64::INFINITY);
    assert_eq!(zeroish.powi(0).error, 0.0);
    // 3^(2 ± 1e-9) is 9 ± 9·ln 3·1e-9.
    let third = Bounded::exact(3.0).powf(Bounded { value: 2.0, error: 1e-9 });
    assert!(third.error >= 9.0 * 1.0986e-9 && third.error < 9.0 * 1.0987e-9);
}

#[test]
fn nan_and_overflow_show() {
    let nan = Bounded::exact(f64::NAN);
    for number in [nan + nan, nan * Bounded::exact(1.0), nan.sqrt(), nan.apply(f64::exp, 1.0), nan.powi(3)] {
        assert!(number.value.is_nan() && number.error.is_nan());
    }
    // A pole shows no bound: the function is finite near by, or the divisor may be anything.
    let pole = |x: f64| if x == 1.0 { f64::INFINITY } else { 1.0 / (x - 1.0) };
    for number in [
        Bounded::exact(1.0).apply(pole, 1.0),
        Bounded::exact(1.0) / Bounded::exact(0.0),
        Bounded::exact(1e300) / Bounded { value: 1e-100, error: 1e-90 },
        Bounded { value: 1e300, error: 2e300 } * Bounded::exact(1e300),
    ] {
        assert!(number.value == f64::INFINITY && number.error == f64::INFINITY, "{number:?}");
    }
}

#[test]
fn the_reciprocal_of_a_certain_overflow_is_bounded() {
    let (huge, one) = (Bounded { value: 1e300, error: 1e290 }, Bounded::exact(1.0));
    let cosh = |x: f64| Bounded { value: x, error: 1e-3 }.apply(f64::cosh, 1.0);
    // With the true value's decimal logarithm, or less: cosh 1000 = 10^434.0, 0.999^4 and 0.998 of the others.
    for (over, logarithm) in [
        (huge * huge, 599.9),
        (huge * huge * Bounded::exact(1e-2), 597.9),
        (huge * huge + huge, 599.9),
        (huge * huge - Bounded::exact(7.0), 599.9),
        (huge.powi(3), 899.9),
        (cosh(1000.0), 433.9),
        (-cosh(-1000.0), 433.9),
        (cosh(1000.0) * cosh(500.0), 650.5),
    ] {
        assert!(over.value.is_infinite() && over.error.is_finite(), "{over:?}");
        assert!(over.error >= 10_f64.powf(-logarithm) && over.error < 1e-280, "{over:?}");
        let inverse = one / over;
        assert!(inverse.value == 0.0 && inverse.error >= over.error && inverse.error < 1e-280, "{inverse:?}");
        assert!((inverse * Bounded::exact(5.0)).error >= 5.0 * over.error);
        let limit = over.apply(f64::tanh, 1.0);
        assert!(limit.value.abs() == 1.0 && limit.error < 1e-15, "{limit:?}");
    }
    // Differences of overflows, and products of an overflow and an underflow, are unknown.
    let over = huge * huge;
    for unknown in [over - over, over * (one / over), over * Bounded::exact(0.0), over / over, over.apply(f64::sin, 1.0)] {
        assert!(!unknown.is_finite(), "{unknown:?}");
    }
}

#[test]
fn exact_arguments_cost_one_evaluation() {
    let calls = std::cell::Cell::new(0);
    let count = |x: &[f64]| {
        calls.set(calls.get() + 1);
        x.iter().sum::<f64>()
    };
    let mut args = [Bounded::exact(1.0); 12];
    let _ = Bounded::apply_many(count, &args, 1.0);
    assert_eq!(calls.get(), 1);
    args[7].error = 1e-3;
    let sum = Bounded::apply_many(count, &args, 1.0);
    assert_eq!(calls.get(), 4);
    assert!(sum.error >= 1e-3 && sum.error <= 2.1e-3);
}

/// An argument of 1e160 with a small relative error took 480 evaluations, all but a few of them at the argument itself.
#[test]
fn huge_arguments_cost_few_evaluations() {
    let calls = std::cell::Cell::new(0);
    let count = |x: &[f64]| {
        calls.set(calls.get() + 1);
        x[0].ln()
    };
    let argument = Bounded { value: 1e160, error: 3e144 };
    let found = Bounded::apply_many(count, &[argument], 1.0);
    assert!(calls.get() < 8 && found.error < 1e-12, "{calls:?} {found:?}");
}

/// Between distant ends: a function that decays on both sides, and one that oscillates.
#[test]
fn ends_that_are_far_apart_do_not_tell_alone() {
    let bell = |x: f64| x / (1.0 + x * x);
    for reach in [1.0, 1e3, 1e39, 1e300] {
        let found = Bounded { value: 0.0, error: reach }.apply(bell, 1.0);
        assert!(found.error >= 0.4, "{found:?}");
    }
    for value in [1e3, 1e9] {
        let found = Bounded { value, error: 100.0 * std::f64::consts::PI }.apply(f64::cos, 1.0);
        assert!(found.error >= 1.0 + found.value.abs(), "{found:?}");
    }
}
