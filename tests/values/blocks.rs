//! Tapes over blocks of points: the values of the scalar tape bit for bit, and bounds that cover the truth without being wasteful.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

use sneddon::eval::inner::above_inverse;
use sneddon::eval::{BlockInput, BlockScratch, BoundedAlgebra, FloatAlgebra, PreciseAlgebra, Tape};
use sneddon::expr::{Expr, Formula, Symbol, shown_to_30_digits};
use sneddon::num::double_double::two_sum;
use sneddon::num::{Bounded, Precise};
use sneddon::parse;
use sneddon_checks::decimal::Decimal;
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;

fn expression(text: &str) -> Expr {
    match parse::formula(text).unwrap_or_else(|error| panic!("{text}: {error}")) {
        Formula::Closed(expr) => expr,
        other => panic!("{text}: {other:?}"),
    }
}

/// Places that are easy, small, large, and at what may be an edge.
fn places(stream: &mut Stream, count: usize) -> Vec<f64> {
    let edges = [0.0, 1.0, 0.5, 2.0, 1e-300, 1e-20, 1e20, 1e300, f64::MIN_POSITIVE, 5e-324];
    let mut draw = |_| match stream.whole(0, 9) {
        0 => *stream.pick(&edges),
        1 => stream.log_uniform(1e-30, 1e30),
        _ => stream.log_uniform(1e-3, 1e3),
    };
    (0..count).map(&mut draw).collect()
}

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

/// The random expressions of `tests/oracle/second.py`, each at its own point with a reference of 60 digits, and at others.
#[test]
fn values_are_those_of_the_scalar_tape_and_bounds_cover_the_truth() {
    let inputs = [Symbol::new("x"), Symbol::new("y")];
    let mut stream = Stream::new(4);
    let (mut scratch, mut slots, mut plain_slots) = (BlockScratch::default(), Vec::new(), Vec::new());
    let (mut compared, mut apart, mut held, mut ratios, mut precise_slots) = (0, 0, 0, Vec::new(), Vec::new());
    for line in include_str!("../oracle/second.csv").lines().step_by(cases(3, 1)) {
        let [text, x, y, value] = line.split(';').collect::<Vec<_>>().try_into().unwrap();
        let truth = Decimal::read(value);
        let tape = Tape::compile(&[expression(text)], &inputs).unwrap();
        let count = stream.whole(1, 300) as usize;
        let (mut xs, mut ys) = (places(&mut stream, count), places(&mut stream, count));
        (xs[0], ys[0]) = (x.parse().unwrap(), y.parse().unwrap());
        let inexact = stream.whole(0, 1) == 1;
        let mut errors = |values: &[f64]| -> Vec<f64> {
            let error = |x: &f64| if inexact { x * stream.log_uniform(1e-17, 1e-9) } else { 0.0 };
            values.iter().map(error).collect()
        };
        let (x_errors, y_errors) = (errors(&xs), errors(&ys));

        let mut out = vec![0.0; count];
        tape.run_block(&[&xs, &ys], &mut out, &mut scratch).unwrap();
        for index in 0..count {
            let scalar = tape.run(&mut FloatAlgebra, &[xs[index], ys[index]], &mut plain_slots).unwrap();
            assert!(same(out[index], scalar), "{text} at {}, {}: {} and {scalar}", xs[index], ys[index], out[index]);
        }

        let mut bounds = vec![0.0; count];
        tape.run_block_bounded(
            &[BlockInput { values: &xs, errors: &x_errors }, BlockInput { values: &ys, errors: &y_errors }],
            &mut out,
            &mut bounds,
            &mut scratch,
        )
        .unwrap();
        for index in 0..count {
            let at = [Bounded { value: xs[index], error: x_errors[index] }, Bounded { value: ys[index], error: y_errors[index] }];
            let scalar = tape.run(&mut BoundedAlgebra, &at, &mut slots).unwrap();
            let found = Bounded { value: out[index], error: bounds[index] };
            // Where both errors are known the values are the same; at an edge they depend on the error.
            if scalar.is_finite() && found.is_finite() && scalar.error < 1e-3 * scalar.value.abs() {
                compared += 1;
                if !same(found.value, scalar.value) {
                    apart += 1;
                    assert!((found.value - scalar.value).abs() <= found.error + scalar.error, "{text} {at:?}: {found:?} {scalar:?}");
                }
            }
            if scalar.error > 0.0 && scalar.is_finite() {
                ratios.push((found.error / scalar.error, format!("{text} {at:?}: {found:?} {scalar:?}")));
            }
        }
        // The true inputs are anywhere within their errors.
        let precise = Tape::compile(&[shown_to_30_digits(&expression(text))], &inputs).unwrap();
        for index in (0..count).step_by(5) {
            let mut inside = |value: f64, error: f64| {
                let moved = two_sum(value, error * stream.uniform(-1.0, 1.0));
                Precise { value: moved, error: 0.0 }
            };
            let at = [inside(xs[index], x_errors[index]), inside(ys[index], y_errors[index])];
            let exact = precise.run(&mut PreciseAlgebra, &at, &mut precise_slots).unwrap();
            // Far out an oscillating function turns many times within the error of its argument, which the scalar bound does not see.
            let ordinary = !text.contains("besselj") && at.iter().all(|place| (1e-25..1e6).contains(&place.value.hi));
            if ordinary && exact.is_finite() && bounds[index].is_finite() {
                let error = ((exact.value.hi - out[index]) + exact.value.lo).abs();
                assert!(error <= bounds[index] + exact.error, "{text} at {at:?}: {} ± {}, {exact:?}", out[index], bounds[index]);
                held += 1;
            }
        }
        let error = truth.distance(out[0]).abs();
        // The given errors are those of inputs that are exact in truth.
        assert!(bounds[0].is_nan() || error <= bounds[0] + 1e-59 * truth.to_f64().abs(), "{line}: {} ± {}", out[0], bounds[0]);
    }
    ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
    let share = |part: f64| &ratios[((ratios.len() - 1) as f64 * part) as usize];
    for part in [0.01, 0.5, 0.9, 0.99, 0.999] {
        println!("bound over the scalar bound, share {part}: {:.3} {}", share(part).0, share(part).1);
    }
    println!("{compared} values compared, {apart} differ; {held} bounds held against 30 digits");
    assert!(compared > cases(90_000, 300_000) && share(0.5).0 <= 1.0 && share(0.9).0 <= 1.01 && share(0.99).0 <= 4.0);
}

#[test]
fn the_inverse_without_division_is_above_the_true_one() {
    for exponent in [-500, -321, -1, 0, 1, 77, 499] {
        for step in 0..4096 {
            let size = 2.0f64.powi(exponent) * (1.0 + f64::from(step) / 4096.0);
            let product = size * above_inverse(size);
            assert!((1.0001..1.006).contains(&product), "{size:e}: {product}");
        }
    }
}
