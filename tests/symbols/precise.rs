//! Elementary functions with about 30 digits against 40-digit values; see `tests/oracle/precise.py`.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use sneddon::num::precise::*;
use sneddon::num::{DoubleDouble, Precise};
use sneddon_checks::decimal::Decimal;
use std::collections::BTreeMap;

/// Per function: the largest error in units of 2^-104 of the value, measured over this table.
const LIMITS: &[(&str, f64)] = &[
    ("acos", 0.5),
    ("acosh", 0.9),
    ("asin", 0.4),
    ("asinh", 0.7),
    ("atan", 0.3),
    ("atan2", 0.6),
    ("atanh", 0.9),
    ("cos", 0.6),
    ("cosh", 0.4),
    ("exp", 0.3),
    ("expm1", 0.6),
    ("ln", 0.8),
    ("ln1p", 1.0),
    ("pow", 3.0),
    ("pow large", 120.0),
    ("powi", 2.0),
    ("powi large", 10.0),
    ("sin", 1.6),
    ("sinh", 0.8),
    ("sqrt", 0.3),
    ("tan", 5.2),
    ("tanh", 0.8),
];

fn call(name: &str, a: &[DoubleDouble]) -> DoubleDouble {
    match (name, a) {
        ("exp", [x]) => exp(*x),
        ("expm1", [x]) => expm1(*x),
        ("sinh", [x]) => sinh(*x),
        ("cosh", [x]) => cosh(*x),
        ("tanh", [x]) => tanh(*x),
        ("ln", [x]) => ln(*x),
        ("ln1p", [x]) => ln1p(*x),
        ("asinh", [x]) => asinh(*x),
        ("acosh", [x]) => acosh(*x),
        ("atanh", [x]) => atanh(*x),
        ("sin", [x]) => sin(*x),
        ("cos", [x]) => cos(*x),
        ("tan", [x]) => tan(*x),
        ("asin", [x]) => asin(*x),
        ("acos", [x]) => acos(*x),
        ("atan", [x]) => atan(*x),
        ("atan2", [y, x]) => atan2(*y, *x),
        ("sqrt", [x]) => sqrt(*x),
        ("pow" | "pow large", [x, y]) => pow(*x, *y).value,
        ("powi" | "powi large", [x, n]) => powi(*x, n.hi as i32),
        _ => panic!("no function {name} with {} arguments", a.len()),
    }
}

/// The error in units of 2^-104 of the true value.
fn units(value: DoubleDouble, truth: &Decimal) -> f64 {
    truth.relative_of(&[value.hi, value.lo]) * 2.0_f64.powi(104)
}

fn rows() -> impl Iterator<Item = (&'static str, Vec<DoubleDouble>, Decimal)> {
    include_str!("../oracle/precise.csv").lines().skip(1).map(|line| {
        let [name, arguments, value] = line.split(',').collect::<Vec<_>>().try_into().unwrap();
        let pair = |text: &str| {
            let (hi, lo) = text.split_once(':').unwrap();
            DoubleDouble { hi: hi.parse().unwrap(), lo: lo.parse().unwrap() }
        };
        (name, arguments.split(';').map(pair).collect(), Decimal::read(value))
    })
}

#[test]
fn elementary_functions_have_thirty_digits() {
    let mut worst: BTreeMap<&str, (f64, f64, String, usize)> = BTreeMap::new();
    for (name, arguments, truth) in rows() {
        let got = call(name, &arguments);
        let error = units(got, &truth);
        let entry = worst.entry(name).or_insert((0.0, 0.0, String::new(), 0));
        entry.1 += error;
        entry.3 += 1;
        if error >= entry.0 {
            (entry.0, entry.2) = (error, format!("{arguments:?}: {got:?}, not {truth:?}"));
        }
    }
    let mut failed = String::new();
    for (name, (error, sum, place, rows)) in &worst {
        println!("{name:12} mean {:8.3} max {error:8.2} in {rows:4} rows", sum / *rows as f64);
        match LIMITS.iter().find(|(known, _)| known == name) {
            Some((_, limit)) if error <= limit => {}
            Some((_, limit)) => failed += &format!("{name}: {error:.2} > {limit} at {place}\n"),
            None => failed += &format!("{name}: no limit, measured {error:.2}\n"),
        }
    }
    for (name, _) in LIMITS {
        assert!(worst.contains_key(name), "{name} has a limit but no reference values");
    }
    assert!(failed.is_empty(), "\n{failed}");
}

/// The bound of a power covers its error, however large the exponent.
#[test]
fn bounds_of_powers_are_honest() {
    for (name, arguments, truth) in rows().filter(|row| row.0.starts_with("pow")) {
        let Precise { value, error } = pow(arguments[0], arguments[1]);
        let distance = truth.distance_of(&[value.hi, value.lo]).abs();
        assert!(distance <= error, "{name} {arguments:?}: {distance:e} > {error:e}");
    }
}

#[test]
fn constants_have_106_bits() {
    for (constant, digits) in [
        (PI, "3.14159265358979323846264338327950288419717"),
        (E, "2.71828182845904523536028747135266249775725"),
        (LN_2, "0.693147180559945309417232121458176568075500"),
        (ROOT_PI, "1.77245385090551602729816748334114518279755"),
        (EULER_GAMMA, "0.577215664901532860606512090082402431042159"),
    ] {
        assert!(units(constant, &Decimal::read(digits)) < 0.13, "{digits}");
    }
}

#[test]
fn outside_the_domain_there_is_no_value() {
    let nan = |value: DoubleDouble| assert!(value.hi.is_nan(), "{value:?}");
    let two = DoubleDouble::from(2.0);
    for value in
        [ln(two.neg()), asin(two), acos(two), acosh(0.5.into()), atanh(two), ln1p(two.neg()), sqrt(two.neg()), sin(f64::INFINITY.into())]
    {
        nan(value);
    }
    for f in [exp, expm1, ln, ln1p, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh, sqrt] {
        nan(f(f64::NAN.into()));
    }
    nan(pow(two.neg(), 0.5.into()).value);
    assert_eq!(exp(1000.0.into()), f64::INFINITY.into());
    assert_eq!(exp((-1000.0).into()), 0.0.into());
    assert_eq!(ln(0.0.into()).hi, f64::NEG_INFINITY);
    assert_eq!(tanh(1000.0.into()), DoubleDouble::ONE);
    assert_eq!(sinh((-1000.0).into()).hi, f64::NEG_INFINITY);
    assert_eq!(atan2(0.0.into(), 1.0.into()).hi, 0.0);
    assert_eq!(atan2(0.0.into(), 0.0.into()).hi, 0.0);
}
