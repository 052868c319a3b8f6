//! Numbers beyond the range of doubles: what a way through them brings back, and expressions whose parts overflow.

#![allow(clippy::expect_used)]

use sneddon::eval::{Tape, WideAlgebra};
use sneddon::expr::{Expr, Symbol};
use sneddon::num::{Precise, Wide};

fn wide(x: f64) -> Wide {
    Wide::new(Precise::exact(x))
}

/// What a long way through huge and tiny numbers brings back, within its bound.
#[test]
fn the_way_back_from_far_outside_is_exact() {
    for x in [1e-300, 3e-200, 0.7, 1e200, 1.7e308] {
        let square = wide(x).mul(wide(x)).mul(wide(x));
        let back = square.div(wide(x)).sqrt().precise();
        assert!((back.value.hi / x - 1.0).abs() < 1e-15 && back.error < 1e-22 * x, "{x}: {back:?}");
        let cube = square.pow(wide(1.0).div(wide(3.0))).precise();
        assert!((cube.value.hi / x - 1.0).abs() < 1e-15 && cube.error < 1e-22 * x, "{x}: {cube:?}");
    }
}

#[test]
fn sums_across_the_whole_range_keep_the_large_part() {
    let sum = wide(1e300).mul(wide(1e300)).add(wide(1e-300));
    assert!((sum.sqrt().precise().value.hi / 1e300 - 1.0).abs() < 1e-15);
    let nothing = wide(1e300).add(wide(1e-300)).add(wide(-1e300)).precise();
    assert!(nothing.value.hi == 0.0 && nothing.error >= 1e-300 && nothing.error.is_finite());
}

#[test]
fn exponentials_leave_the_range_and_return() {
    let product = wide(1000.0).exp().mul(wide(-1001.0).exp()).precise();
    // e^-1
    assert!((product.value.hi - 0.367_879_441_171_442_33).abs() < 1e-16 && product.error < 1e-28);
    let back = wide(-5000.0).exp().ln().precise();
    assert!((back.value.hi + 5000.0).abs() < 1e-12 && back.error < 1e-26);
}

/// Parts beyond the range of doubles, results within it.
#[test]
fn expressions_keep_their_digits_far_outside() {
    let (x, y) = (Expr::symbol("x"), Expr::symbol("y"));
    let third = x.pow(&Expr::ratio(7, 3)) / y.pow(&Expr::ratio(7, 3));
    let angle = Expr::call("asin", [&x / &y]) * (x.power(2) + y.power(2)).sqrt() / &y;
    let series = Expr::call("hyp2f1", [Expr::ratio(1, 2), Expr::one(), Expr::integer(2), x.power(2) / y.power(2)]);
    let logarithm = Expr::call("ln", [x.power(3)]) / Expr::call("ln", [x.clone()]);
    // 0.6^(7/3), asin(0.6)·√1.36, 2/(1 + 0.8), 3
    let expected = [0.303_635_759_508_629_73, 0.750_444_801_930_650_7, 1.0 / 0.9, 3.0];
    for size in [1e-200, 1e-30, 1.0, 1e150, 1e200] {
        for (expr, expected) in [&third, &angle, &series, &logarithm].into_iter().zip(expected) {
            let tape = Tape::compile(std::slice::from_ref(expr), &[Symbol::new("x"), Symbol::new("y")]).expect("two inputs");
            let inputs = [3.0, 5.0].map(|own| Wide::new(Precise::exact(own)).mul(Wide::new(Precise::exact(size))));
            let found = tape.run(&mut WideAlgebra, &inputs, &mut Vec::new()).expect("a value").precise();
            assert!((found.value.hi - expected).abs() < 4e-16 && found.error < 1e-25, "{expr:?} at {size}: {found:?}");
        }
    }
}
