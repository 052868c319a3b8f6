//! Special functions and stable forms against 50-digit values; see `tests/oracle/special.py`.
#![allow(missing_docs, clippy::expect_used, clippy::panic)]

use std::collections::BTreeMap;

use sneddon::num::forms::*;
use sneddon::num::kappa::kappa;
use sneddon::num::special::*;

/// Per function: the largest error in ulp, measured over this table and ten more of its kind with other random points.
const LIMITS: &[(&str, f64)] = &[
    ("angle_between", 2.6),
    ("artanh_ratio", 1.0),
    ("besseli", 0.51),
    ("besselj integer", 0.51),
    ("besselj real", 0.51),
    ("digamma", 2.7),
    ("ellipe", 3.8),
    ("ellipe_inc", 3.3),
    ("ellipf", 3.4),
    ("ellipk", 2.9),
    ("elliptic_moment", 6.6),
    ("elliptic_pole", 6.4),
    ("hyp2f1", 0.51),
    ("hyp2f1 slope", 0.51),
    ("hyper 1f2", 0.51),
    ("hyper 3f2", 0.51),
    ("hyper dilogarithm", 0.51),
    ("hyperboloid_force", 2.6),
    ("hyperboloid_integral", 3.2),
    ("hyperboloid_pressure", 2.7),
    ("inverse_tangent_integral", 1.4),
    ("kappa", 0.51),
    ("legendre_chi2", 1.2),
    ("polylog2", 1.7),
    ("pressure_power", 3.3),
    ("rc", 3.0),
    ("rd", 5.1),
    ("rf", 3.8),
    ("elliprj", 4.9),
    ("shifted_power", 4.0),
    ("shifted_power_force", 4.0),
    ("sphere_force", 4.2),
    ("sphere_integral", 5.4),
    ("sphere_pressure", 3.6),
    ("worn_hyperboloid_force", 4.4),
    ("worn_hyperboloid_slope", 1.9),
    ("worn_sphere_force", 5.6),
    ("worn_sphere_slope", 2.4),
];

fn call(name: &str, a: &[f64]) -> f64 {
    match (name, a) {
        ("kappa", [n]) => kappa(*n),
        ("angle_between", [b, c, x]) => angle_between(*b, *c, *x),
        ("shifted_power", [k, b, c, x]) => shifted_power(*k as u32, *b, *c, *x),
        ("shifted_power_force", [k, b, c, x]) => shifted_power_force(*k as u32, *b, *c, *x),
        ("pressure_power", [n, s, a]) => pressure_power(*n, *s, *a),
        ("artanh_ratio", [x, r]) => artanh_ratio(*x, *r),
        ("sphere_force", [a, r]) => sphere_force(*a, *r),
        ("sphere_integral", [a, r]) => sphere_integral(*a, *r),
        ("hyperboloid_force", [a, b]) => hyperboloid_force(*a, *b),
        ("hyperboloid_integral", [a, b]) => hyperboloid_integral(*a, *b),
        ("worn_sphere_slope", [b, x, r]) => worn_sphere_slope(*b, *x, *r),
        ("worn_sphere_force", [b, a, r]) => worn_sphere_force(*b, *a, *r),
        ("worn_hyperboloid_slope", [b, x, s]) => worn_hyperboloid_slope(*b, *x, *s),
        ("worn_hyperboloid_force", [b, a, s]) => worn_hyperboloid_force(*b, *a, *s),
        ("sphere_pressure", [s, a, r]) => sphere_pressure(*s, *a, *r),
        ("hyperboloid_pressure", [s, a, b]) => hyperboloid_pressure(*s, *a, *b),
        ("elliptic_pole", [sign, w, b, s, a]) => elliptic_pole(*sign, *w, *b, *s, *a),
        ("elliprj", [x, y, z, p]) => rj(*x, *y, *z, *p),
        ("elliptic_moment", [k, b, s, a]) => elliptic_moment(*k as i32, *b, *s, *a),
        ("rf", [x, y, z]) => rf(*x, *y, *z),
        ("rd", [x, y, z]) => rd(*x, *y, *z),
        ("rc", [x, y]) => rc(*x, *y),
        ("ellipk", [m]) => ellipk(*m),
        ("ellipe", [m]) => ellipe(*m),
        ("ellipf", [phi, m]) => ellipf(*phi, *m),
        ("ellipe_inc", [phi, m]) => ellipe_inc(*phi, *m),
        ("legendre_chi2", [z]) => legendre_chi2(*z),
        ("inverse_tangent_integral", [z]) => inverse_tangent_integral(*z),
        ("polylog2", [z]) => polylog2(*z),
        ("hyp2f1 slope" | "hyp2f1", [a, b, c, z]) => hyp2f1(*a, *b, *c, *z),
        ("hyper dilogarithm", [z]) => hyper(&[0.5, 1.0, 0.5], &[1.5, 1.5], *z),
        ("hyper 3f2", [a, b, c, d, e, z]) => hyper(&[*a, *b, *c], &[*d, *e], *z),
        ("hyper 1f2", [a, b, c, z]) => hyper(&[*a], &[*b, *c], *z),
        ("besselj integer" | "besselj real", [n, z]) => besselj(*n, *z),
        ("besseli", [n, z]) => besseli(*n, *z),
        ("digamma", [x]) => digamma(*x),
        _ => panic!("no function {name} with {} arguments", a.len()),
    }
}

/// The 30-digit value as a double and the rest, so that errors far below one ulp are seen.
fn reference(text: &str) -> (f64, f64) {
    let head: f64 = text.parse().expect("a number");
    if head == 0.0 {
        return (0.0, 0.0);
    }
    // Rest = (decimal text) - (exact decimal expansion of head), through exact big rationals.
    use num_bigint::BigInt;
    use num_rational::BigRational;
    use num_traits::{Pow, ToPrimitive};
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let mut exponent: i32 = exponent.parse().expect("an exponent");
    let mut digits = mantissa.to_string();
    if let Some(dot) = mantissa.find('.') {
        exponent -= (mantissa.len() - dot - 1) as i32;
        digits.remove(dot);
    }
    let number = BigInt::parse_bytes(digits.as_bytes(), 10).expect("digits");
    let ten = BigRational::from_integer(10.into());
    let exact = BigRational::from_integer(number) * Pow::pow(&ten, exponent);
    let nearest = BigRational::from_float(head).expect("finite");
    let ulp = BigRational::from_float(ulp(head)).expect("finite");
    (head, ((exact - nearest) / ulp).to_f64().expect("small"))
}

fn ulp(x: f64) -> f64 {
    let x = x.abs();
    x.next_up() - x
}

#[test]
fn functions_agree_with_fifty_digit_values() {
    let table = include_str!("../oracle/special.csv");
    let mut worst: BTreeMap<&str, (f64, String, usize)> = BTreeMap::new();
    for line in table.lines().skip(1) {
        let [name, arguments, value] = line.split(',').collect::<Vec<_>>().try_into().expect("three columns");
        let a: Vec<f64> = arguments.split(';').map(|text| text.parse().expect("a double")).collect();
        let (head, rest) = reference(value);
        let got = call(name, &a);
        let error = if got == head && rest == 0.0 { 0.0 } else { ((got - head) / ulp(head) - rest).abs() };
        let error = if error.is_nan() { f64::INFINITY } else { error };
        let entry = worst.entry(name).or_insert((0.0, String::new(), 0));
        entry.2 += 1;
        if error >= entry.0 {
            (entry.0, entry.1) = (error, format!("{arguments}: {got:e}, not {value}"));
        }
    }
    let mut failed = String::new();
    for (name, (error, place, rows)) in &worst {
        println!("{name:26} {error:8.2} ulp in {rows:4} rows, at {place}");
        match LIMITS.iter().find(|(known, _)| known == name) {
            Some((_, limit)) if error <= limit => {}
            Some((_, limit)) => failed += &format!("{name}: {error:.2} ulp > {limit} at {place}\n"),
            None => failed += &format!("{name}: no limit, measured {error:.2}\n"),
        }
    }
    for (name, _) in LIMITS {
        assert!(worst.contains_key(name), "{name} has a limit but no reference values");
    }
    assert!(failed.is_empty(), "\n{failed}");
}
