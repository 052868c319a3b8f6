//! Bessel, Struve, Dawson and Fresnel functions against 45-digit values, and the error bounds that they claim; see `tests/oracle/waves.py`.
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon::expr::Function;
use sneddon::num::DoubleDouble;
use sneddon_checks::decimal::Decimal;
use sneddon_checks::rows::rows;
use std::collections::BTreeMap;

/// Per function: the largest error of the double in ulp, and the largest claimed error of the 30-digit value relative to
/// the value or, for the oscillating functions, to the amplitude.
const LIMITS: &[(&str, f64, f64)] = &[
    ("bessel_struve", 0.51, 1e-22),
    ("besseli", 0.51, 1e-27),
    ("besseli_scaled", 0.51, 1e-27),
    ("besselj", 0.51, 1e-26),
    ("dawson", 0.51, 1e-27),
    ("erf", 0.75, 1e-27),
    ("erfi", 0.51, 1e-27),
    ("fresnelc", 0.51, 1e-27),
    ("fresnels", 0.51, 1e-27),
    ("struveh", 0.51, 1e-22),
    ("struvel", 0.51, 1e-27),
];

/// Arguments of circular functions beyond this are known to 15 digits.
const REDUCED: f64 = (1_u64 << 50) as f64;

#[derive(Default)]
struct Worst {
    rows: usize,
    ulps: (f64, String),
    claimed: (f64, String),
    used: (f64, String),
}

fn raise(slot: &mut (f64, String), value: f64, place: &str) {
    if value.is_nan() || value > slot.0 {
        *slot = (if value.is_nan() { f64::INFINITY } else { value }, place.to_owned());
    }
}

/// What an error is compared with: the value, or the amplitude where that is larger.
fn scale(name: &str, order: f64, z: f64, value: f64) -> f64 {
    match name {
        "besselj" | "struveh" if order <= z.abs() => value.abs().max((std::f64::consts::FRAC_2_PI / z.abs()).sqrt().min(1.0)),
        _ => value.abs(),
    }
}

#[test]
fn values_and_their_bounds_are_honest() {
    let mut worst: BTreeMap<&str, Worst> = BTreeMap::new();
    for row in rows(include_str!("../oracle/waves.csv")) {
        let [name, arguments, truth] = row[..] else { panic!("{row:?}") };
        let words = |text: &str| match text.split_once(':') {
            Some((hi, lo)) => DoubleDouble { hi: hi.parse().unwrap(), lo: lo.parse().unwrap() },
            None => DoubleDouble::from(text.parse::<f64>().unwrap()),
        };
        let exact: Vec<DoubleDouble> = arguments.split(';').map(words).collect();
        let (order, z) = (exact[0].hi, exact.last().unwrap().hi);
        let truth = Decimal::read(truth);
        let function = Function::named(name).unwrap();
        let entry = worst.entry(name).or_default();
        entry.rows += 1;
        let size = scale(name, order, z, truth.to_f64());
        if exact.iter().all(|word| word.lo == 0.0) {
            let point: Vec<f64> = exact.iter().map(|word| word.hi).collect();
            let value = (function.row().value)(&point);
            if z.abs() > REDUCED {
                let off = if value.is_finite() { truth.distance(value).abs() } else { f64::INFINITY };
                assert!(off <= 2.0 * f64::EPSILON * size, "{name} at {arguments}: {value:e}");
            } else {
                raise(&mut entry.ulps, truth.ulps(value), arguments);
            }
        }
        let precise = function.row().precise.unwrap()(&exact);
        let distance = truth.distance_of(&[precise.value.hi, precise.value.lo]).abs();
        raise(&mut entry.used, distance / precise.error, arguments);
        if z.abs() <= REDUCED && size > 1e-290 {
            raise(&mut entry.claimed, precise.error / size, arguments);
        }
    }
    let mut failed = String::new();
    for (name, found) in &worst {
        println!(
            "{name:14} {:5} rows; {:6.3} ulp at {}; claimed {:8.1e} at {}; of which used {:6.3} at {}",
            found.rows, found.ulps.0, found.ulps.1, found.claimed.0, found.claimed.1, found.used.0, found.used.1
        );
        let Some((_, ulps, claimed)) = LIMITS.iter().find(|(known, ..)| known == name) else { panic!("{name} has no limit") };
        if found.ulps.0 > *ulps || found.claimed.0 > *claimed || found.used.0 > 1.0 {
            failed += &format!("{name} misses its limits\n");
        }
        assert!(found.ulps.0 <= Function::named(name).unwrap().row().ulps());
    }
    assert_eq!(worst.len(), LIMITS.len());
    assert!(failed.is_empty(), "\n{failed}");
}

fn value(name: &str, a: &[f64]) -> f64 {
    (Function::named(name).unwrap().row().value)(a)
}

#[test]
fn limits_are_reached_and_the_rest_is_nan() {
    let infinity = f64::INFINITY;
    for (name, a, expected) in [
        ("besselj", [0.0, 0.0], 1.0),
        ("besselj", [2.5, 0.0], 0.0),
        ("besselj", [-0.5, 0.0], infinity),
        ("besselj", [0.0, infinity], 0.0),
        ("besselj", [1e9, 1.0], 0.0),
        ("besseli", [0.0, 0.0], 1.0),
        ("besseli", [1.0, -800.0], -infinity),
        ("besseli", [0.0, 1e300], infinity),
        ("besseli_scaled", [0.0, infinity], 0.0),
        ("struveh", [0.0, 0.0], 0.0),
        ("struveh", [-1.0, 0.0], std::f64::consts::FRAC_2_PI),
        ("struvel", [0.0, 1e300], infinity),
        ("bessel_struve", [0.0, 0.0], 1.0),
        ("bessel_struve", [1.0, 1e300], std::f64::consts::FRAC_2_PI),
    ] {
        assert_eq!(value(name, &a), expected, "{name} at {a:?}");
    }
    for (name, z, expected) in [
        ("erfi", 27.0, infinity),
        ("erfi", -1e300, -infinity),
        ("dawson", 1e300, 5e-301),
        ("dawson", 5e-324, 5e-324),
        ("fresnelc", infinity, 0.5),
        ("fresnels", -1e300, -0.5),
        ("fresnels", 5e-324, 0.0),
    ] {
        assert_eq!(value(name, &[z]), expected, "{name} at {z}");
    }
    for (name, a) in [
        ("besselj", [0.5, -1.0]),
        ("besselj", [-1.5, 1.0]),
        ("besselj", [2e4, 3e4]),
        ("besseli", [0.5, -1.0]),
        ("besseli_scaled", [0.0, -1.0]),
        ("struveh", [0.5, 1.0]),
        ("struveh", [-2.0, 1.0]),
        ("struvel", [-2.0, 1.0]),
        ("bessel_struve", [0.0, -1.0]),
    ] {
        assert!(value(name, &a).is_nan(), "{name} at {a:?}");
    }
}
