//! Every row of the function table: derivative, complex values, error bound, shown form; and the tape against the walk.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use num_complex::Complex64;
use sneddon::eval::{Algebra, BoundedAlgebra, ComplexAlgebra, FloatAlgebra, Tape, walk};
use sneddon::expr::function::Accuracy;
use sneddon::expr::{Expr, Function, Symbol, derivative, shown};
use sneddon::num::Bounded;
use sneddon_checks::formulas::{number, relative};
use sneddon_checks::functions::measure;
use sneddon_checks::random::Stream;

const NAMES: [&str; 8] = ["u_0", "u_1", "u_2", "u_3", "u_4", "u_5", "u_6", "u_7"];

/// Arguments inside the domain of a function.
fn arguments(function: Function, stream: &mut Stream) -> Vec<f64> {
    let mut between = |low: f64, high: f64| stream.uniform(low, high);
    match function.name() {
        "polygamma" => vec![between(1.0, 5.0).floor(), between(0.2, 3.0)],
        "polylog" | "clsin" => vec![2.0, between(0.1, 0.9)],
        "acosh" => vec![between(1.1, 4.0)],
        "gamma" | "digamma" => vec![between(0.3, 6.0)],
        "legendre_chi2" | "inverse_tangent_integral" => vec![between(0.05, 0.95)],
        "kappa" => vec![between(0.1, 9.0)],
        "besselj" | "besseli" | "besseli_scaled" | "struveh" | "struvel" | "bessel_struve" => {
            vec![between(0.0, 3.0).floor(), between(0.2, 4.0)]
        }
        "hyp2f1" => vec![between(0.2, 2.0), between(0.2, 2.0), between(0.5, 3.0), between(-0.9, 0.6)],
        "hyper" => vec![2.0, 1.0, between(0.2, 2.0), between(0.2, 2.0), between(0.5, 3.0), between(-0.9, 0.9)],
        "shifted_power" | "shifted_power_force" => vec![between(0.0, 5.0).floor(), between(0.1, 1.0), between(1.1, 3.0)],
        "shifted_power_between" | "shifted_power_force_between" => {
            vec![between(0.0, 5.0).floor(), between(0.1, 1.0), between(1.1, 2.0), between(2.1, 3.0)]
        }
        "worn_sphere_slope" | "worn_sphere_force" | "worn_hyperboloid_slope" | "worn_hyperboloid_force" => {
            vec![between(0.1, 1.0), between(1.1, 2.0), between(2.1, 3.0)]
        }
        "angle_from" => vec![between(0.1, 1.0), between(1.1, 3.0)],
        "pressure_power" => vec![between(-0.5, 6.0), between(0.1, 1.0), between(1.1, 2.0)],
        "ln_near_one" => {
            let u = between(-0.9, 2.0);
            vec![u, 1.0 + u]
        }
        "power_near_one" => vec![between(-0.9, 2.0), between(33.0, 40.0).floor()],
        "outside_power" => vec![between(0.5, 6.0), between(0.1, 1.0), between(1.1, 2.0)],
        "sphere_pressure" | "hyperboloid_pressure" | "capped_sphere_force" => vec![between(0.1, 1.0), between(1.1, 2.0), between(2.1, 3.0)],
        "artanh_ratio" | "sphere_force" | "hyperboloid_force" => vec![between(0.2, 1.0), between(1.1, 3.0)],
        "elliptic_pole" => {
            let sign = if between(0.0, 1.0) < 0.5 { 1.0 } else { -1.0 };
            vec![sign, between(2.1, 3.0), between(0.1, 1.0), between(0.1, 1.0), between(1.1, 2.0)]
        }
        "elliptic_moment" => vec![between(-1.0, 4.0).floor(), between(0.1, 1.0), between(0.1, 1.0), between(1.1, 2.0)],
        _ => (0..function.row().arity.0).map(|_| between(0.1, 0.9)).collect(),
    }
}

fn call(function: Function, count: usize) -> Expr {
    Expr::function(function, NAMES.iter().take(count).map(|name| Expr::symbol(name)).collect())
}

fn named(values: &[f64]) -> Vec<(&'static str, f64)> {
    NAMES.iter().copied().zip(values.iter().copied()).collect()
}

/// Derivatives against a complex step, which does not cancel, or against central differences of sixth order.
#[test]
fn derivatives() {
    let mut stream = Stream::new(21);
    let (mut by_step, mut by_difference) = (0, 0);
    for function in Function::all().filter(|f| f.row().derivative.is_some()) {
        for _ in 0..10 {
            let point = arguments(function, &mut stream);
            let expr = call(function, point.len());
            for index in 0..point.len() {
                let Ok(prime) = derivative(&expr, &Symbol::new(NAMES[index])) else { continue };
                let own = number(&prime, &named(&point));
                if function.row().complex.is_some() {
                    let h = 1e-30;
                    let values: Vec<Complex64> =
                        point.iter().enumerate().map(|(i, v)| Complex64::new(*v, if i == index { h } else { 0.0 })).collect();
                    let step = ComplexAlgebra.call(function, &values).im / h;
                    if step.is_finite() && step != 0.0 {
                        // Complex tanh and the inverse functions of the library keep 14 digits.
                        assert!(relative(own, step) < 1e-13, "{function:?} at {point:?}: {own:e} and {step:e}");
                        by_step += 1;
                        continue;
                    }
                }
                let at = |shift: f64| {
                    let mut moved = point.clone();
                    moved[index] += shift;
                    (function.row().value)(&moved)
                };
                let h = 4e-3 * point[index];
                let pair = |k: f64| at(k * h) - at(-k * h);
                let difference = (45.0 * pair(1.0) - 9.0 * pair(2.0) + pair(3.0)) / (60.0 * h);
                assert!(relative(own, difference) < 1e-8, "{function:?} at {point:?}: {own:e} and {difference:e}");
                by_difference += 1;
            }
        }
    }
    assert!(by_step >= 100 && by_difference >= 20, "{by_step} and {by_difference}");
}

/// On the real axis the complex value is the real one.
#[test]
fn complex_values_continue_the_real_ones() {
    let mut stream = Stream::new(22);
    for function in Function::all().filter(|f| f.row().complex.is_some()) {
        for _ in 0..20 {
            let point = arguments(function, &mut stream);
            let values: Vec<Complex64> = point.iter().map(|v| Complex64::new(*v, 0.0)).collect();
            let (complex, real) = (ComplexAlgebra.call(function, &values), (function.row().value)(&point));
            assert!(relative(complex.re, real) < 1e-14 && complex.im.abs() < 1e-14, "{function:?} at {point:?}: {complex} and {real}");
        }
    }
}

/// What a reader is shown has the value of the function that stands behind it.
#[test]
fn shown_forms_have_the_value() {
    let mut stream = Stream::new(23);
    let mut seen = 0;
    for function in Function::all().filter(|f| f.row().shown.is_some()) {
        for _ in 0..10 {
            let point = arguments(function, &mut stream);
            let mut expr = call(function, point.len());
            if let "elliptic_moment" | "elliptic_pole" = function.name() {
                // Its order or its sign must be known for it to be shown.
                let rest = NAMES.iter().take(point.len()).skip(1).map(|name| Expr::symbol(name));
                expr = Expr::function(function, std::iter::once(Expr::integer(point[0] as i64)).chain(rest).collect());
            }
            let plain = shown(&expr);
            let (one, two) = (number(&plain, &named(&point)), (function.row().value)(&point));
            assert!(relative(one, two) < 1e-10, "{function:?} at {point:?}: shown {one:e}, is {two:e}");
            seen += 1;
        }
    }
    assert!(seen >= 100, "{seen}");
}

/// Values keep the bound that their row states, which feeds every error estimate, against 30 digits: half of it where it was measured.
#[test]
fn values_keep_the_stated_bound() {
    let tables = [
        include_str!("../oracle/special.csv"),
        include_str!("../oracle/waves.csv"),
        include_str!("../oracle/hypergeometric.csv"),
        include_str!("../oracle/functions.csv"),
        include_str!("../oracle/forms.csv"),
    ];
    let figures = measure(tables).unwrap();
    let mut faults = Vec::new();
    for function in Function::all() {
        let (row, found) = (function.row(), figures.get(function.name()).copied().unwrap_or_default());
        let (fewest, most) = match row.accuracy {
            Accuracy::Exact | Accuracy::Defined(_) => continue,
            Accuracy::Bounded(ulps) => (50, ulps),
            Accuracy::Measured(ulps) => (50, 0.5 * ulps),
        };
        if found.count < fewest || found.largest > most {
            faults.push(format!("{}: {} places, {:.2} ulp of {most}", row.name, found.count, found.largest));
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

/// NaN in, NaN out; no arguments or too many give NaN and never a panic.
#[test]
fn bad_arguments_give_nan() {
    let mut stream = Stream::new(24);
    for function in Function::all() {
        let point = arguments(function, &mut stream);
        let (value, most) = (function.row().value, function.row().arity.1);
        assert!(value(&point).is_finite(), "{function:?} at {point:?}");
        for index in 0..point.len() {
            let mut bad = point.clone();
            bad[index] = f64::NAN;
            assert!(value(&bad).is_nan(), "{function:?} ignores argument {index}");
        }
        assert!(value(&[]).is_nan() && value(&vec![0.5; most.min(20) + 1]).is_nan(), "{function:?}");
    }
}

/// Names and spellings are unique, and every name that the sources call exists.
#[test]
fn names_are_unique_and_exist() {
    let mut names: Vec<&str> = Function::all().flat_map(|f| f.row().spellings.iter().copied().chain([f.name()])).collect();
    let count = names.len();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), count);
    let mut seen = 0;
    let mut folders = vec![std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let text = std::fs::read_to_string(&path).unwrap();
                for part in text.split("call(\"").skip(1) {
                    let name = part.split('"').next().unwrap();
                    assert!(Function::named(name).is_some(), "{name} in {}", path.display());
                    seen += 1;
                }
            }
        }
    }
    assert!(seen >= 40, "{seen}");
}

/// A random expression over x and y, with shared parts.
fn expression(stream: &mut Stream, depth: u32) -> Expr {
    if depth == 0 {
        return match stream.whole(0, 3) {
            0 => Expr::symbol("x"),
            1 => Expr::symbol("y"),
            2 => Expr::ratio(stream.whole(-20, 20), stream.whole(1, 12)),
            _ => Expr::pi(),
        };
    }
    let mut inner = || expression(stream, depth - 1);
    let (u, v) = (inner(), inner());
    match stream.whole(0, 8) {
        0 => u + v,
        1 => u - v,
        2 => u * v,
        3 => u / (v.power(2) + Expr::one()),
        4 => u.power(stream.whole(-3, 6)),
        5 => (u.power(2) + Expr::ratio(1, 3)).pow(&Expr::ratio(stream.whole(-5, 5), 2)),
        6 => {
            let name = *stream.pick(&["sin", "atan", "asinh", "cosh", "exp", "erf"]);
            Expr::call(name, [u])
        }
        7 => (u.power(2) + Expr::one()).pow(&v),
        _ => &u * &u - v.power(2) * u,
    }
}

/// The tape does what the walk over the tree does, bit for bit, in every algebra.
#[test]
fn tape_is_walk() {
    let mut stream = Stream::new(25);
    let inputs = [Symbol::new("x"), Symbol::new("y")];
    let (mut slots, mut bounded, mut complex, mut numbers) = (Vec::new(), Vec::new(), Vec::new(), 0);
    for _ in 0..600 {
        let expr = expression(&mut stream, 4);
        let tape = Tape::compile(std::slice::from_ref(&expr), &inputs).unwrap();
        let (x, y) = (stream.uniform(-2.0, 2.0), stream.uniform(-2.0, 2.0));
        let walked = walk(&expr, &mut FloatAlgebra, &mut |s| Some(if s.name() == "x" { x } else { y })).unwrap();
        let taped = tape.run(&mut FloatAlgebra, &[x, y], &mut slots).unwrap();
        assert!(walked.to_bits() == taped.to_bits() || walked.is_nan() && taped.is_nan(), "{expr:?} at {x}, {y}");
        numbers += usize::from(taped.is_finite());
        let (bx, by) = (Bounded::exact(x), Bounded::exact(y));
        let walked = walk(&expr, &mut BoundedAlgebra, &mut |s| Some(if s.name() == "x" { bx } else { by })).unwrap();
        let taped_too = tape.run(&mut BoundedAlgebra, &[bx, by], &mut bounded).unwrap();
        assert!(walked.value.to_bits() == taped_too.value.to_bits() || walked.value.is_nan() && taped_too.value.is_nan());
        assert!(
            walked.error.to_bits() == taped_too.error.to_bits() || walked.error.is_nan() && taped_too.error.is_nan(),
            "{expr:?} at {x} {y}: {walked:?} {taped_too:?}"
        );
        // The value with a bound is the value without one.
        assert!(taped_too.value == taped || taped.is_nan(), "{expr:?}");
        let (cx, cy) = (Complex64::new(x, 0.25), Complex64::new(y, -0.5));
        let walked = walk(&expr, &mut ComplexAlgebra, &mut |s| Some(if s.name() == "x" { cx } else { cy })).unwrap();
        let taped = tape.run(&mut ComplexAlgebra, &[cx, cy], &mut complex).unwrap();
        assert!(walked == taped || walked.is_nan() && taped.is_nan());
    }
    assert!(numbers >= 500, "{numbers}");
    assert!(Tape::compile(&[Expr::symbol("z")], &inputs).is_err());
}
