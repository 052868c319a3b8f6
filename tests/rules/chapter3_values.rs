//! The source's chapter 3 as numbers: derived answers against 40-digit values of the defining integrals.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use num_complex::Complex64;
use sneddon::contact::{Edge, ElasticBody, TransverselyIsotropic, effective_modulus, relations};
use sneddon::num::kappa::kappa;
use sneddon_checks::decimal::Decimal;
use sneddon_checks::formulas::{contact, derived, value};
use sneddon_checks::rows::rows;
use std::collections::BTreeMap;

const PROFILES: [(&str, &str); 6] = [
    ("cone", "r*tan(theta)"),
    ("paraboloid", "r^2/(2*R)"),
    ("power", "C*r^n"),
    ("cone_paraboloid", "r^2/(2*R)+r*tan(theta)"),
    ("worn_paraboloid", "piecewise(0, r<b, (r^2-b^2)/(2*R))"),
    ("sphere", "R-sqrt(R^2-r^2)"),
];

/// The largest error in ulps for every quantity: measured, with a third of headroom.
const LIMITS: [(&str, f64); 7] = [("g", 3.6), ("F", 2.5), ("p", 6.5), ("a(d)", 3.4), ("F(d)", 6.1), ("kappa", 0.6), ("E", 2.9)];

fn arguments(text: &str) -> Vec<(&str, f64)> {
    text.split(' ').map(|pair| pair.split_once('=').unwrap()).map(|(name, v)| (name, v.parse().unwrap())).collect()
}

#[test]
fn every_value_is_right() {
    let mut worst: BTreeMap<&str, f64> = BTreeMap::new();
    for row in rows(include_str!("../oracle/chapter3.csv")) {
        let [profile, quantity, text, truth] = row[..] else { panic!("{row:?}") };
        let (values, truth) = (arguments(text), Decimal::read(truth));
        let get = |name: &str| values.iter().find(|(own, _)| *own == name).map(|(_, v)| *v).unwrap();
        let found = match (profile, quantity) {
            ("table", _) => kappa(get("n")),
            ("two bodies", _) => {
                let body = |e, nu| ElasticBody { young_modulus: get(e), poisson_ratio: get(nu) };
                effective_modulus(body("E1", "nu1"), body("E2", "nu2")).unwrap()
            }
            ("transverse", _) => medium(&get).effective_modulus().unwrap(),
            _ => {
                let solution = derived(PROFILES.iter().find(|(id, _)| *id == profile).unwrap().1);
                let own = contact(&solution, &values, 1.0, None);
                match quantity {
                    "g" => own.evaluator().equivalent(get("x")).unwrap().estimate.value,
                    "F" => own.force(get("a")).unwrap().estimate.value,
                    "p" => own.pressure(get("r"), get("a")).unwrap().unwrap().estimate.value,
                    _ => {
                        let relations = relations(&solution, &Edge::Smooth).unwrap();
                        let explicit = if quantity == "a(d)" { relations.contact_radius_of_depth } else { relations.force_of_depth };
                        let found = own.contact_radius(get("d")).unwrap().estimate;
                        if quantity == "a(d)" {
                            assert!(truth.distance(found.value).abs() <= found.error, "{profile} {text}: {found:?}");
                        }
                        match explicit {
                            Some(explicit) => {
                                let all: Vec<_> = values.iter().copied().chain([("E", 1.0)]).collect();
                                value(&explicit.formula, &all)
                            }
                            // The sphere has no explicit relation; near its equator a is conditioned better than F(a).
                            None if quantity == "a(d)" => found.value,
                            None => continue,
                        }
                    }
                }
            }
        };
        let (ulps, own) = (truth.ulps(found), worst.entry(quantity).or_default());
        *own = own.max(ulps);
        let limit = LIMITS.iter().find(|(name, _)| *name == quantity).unwrap().1;
        if ulps > limit {
            eprintln!("{profile} {quantity} {text}: {found:e} is {ulps:.1} ulp off");
        }
    }
    println!("{worst:?}");
    for (quantity, limit) in LIMITS {
        assert!(worst[quantity] <= limit, "{quantity}: {:.2} ulp", worst[quantity]);
    }
}

fn medium(get: &impl Fn(&str) -> f64) -> TransverselyIsotropic {
    TransverselyIsotropic { c11: get("c11"), c12: get("c12"), c13: get("c13"), c33: get("c33"), c44: get("c44") }
}

/// (3.65)–(3.69) with complex roots where I₀ < 0 equals (3.70).
#[test]
fn problem_7_both_forms_of_the_modulus() {
    let mut complex = 0;
    for row in rows(include_str!("../oracle/chapter3.csv")).iter().filter(|row| row[0] == "transverse") {
        let values = arguments(row[2]);
        let get = |name: &str| values.iter().find(|(own, _)| *own == name).map(|(_, v)| *v).unwrap();
        let TransverselyIsotropic { c11, c13, c33, c44, .. } = medium(&get);
        let mean = (c11 * c33).sqrt();
        let i0 = mean - c13 - 2.0 * c44;
        complex += usize::from(i0 < 0.0);
        let root = |z: f64| Complex64::new(z / (4.0 * c33 * c44), 0.0).sqrt();
        let (first, second) = (root((mean - c13) * (2.0 * mean - i0)), root((mean + c13) * i0));
        let (nu1, nu2) = (first + second, first - second);
        let modulus = 2.0 * (mean * mean - c13 * c13) / (mean * (nu1 + nu2));
        assert!(modulus.im.abs() < 1e-15);
        let own = medium(&get).effective_modulus().unwrap();
        assert!((modulus.re - own).abs() < 1e-14 * own, "{modulus} and {own}");
        // ν are the roots of C₃₃C₄₄ν⁴ − (C₁₁C₃₃ − C₁₃(C₁₃ + 2C₄₄))ν² + C₁₁C₄₄.
        for nu in [nu1, nu2] {
            let zero = c33 * c44 * nu.powi(4) - (c11 * c33 - c13 * (c13 + 2.0 * c44)) * nu * nu + c11 * c44;
            assert!(zero.norm() < 1e-11, "{zero}");
        }
    }
    assert!(complex >= 10);
}

/// The isotropic limit of (3.70) is E/(1 − ν²).
#[test]
fn isotropic_limit() {
    for nu in [-0.9, -0.3, 0.0, 0.2, 0.3, 0.45, 0.499] {
        let body = ElasticBody { young_modulus: 2.5, poisson_ratio: nu };
        let own = TransverselyIsotropic::isotropic(body).effective_modulus().unwrap();
        let expected = effective_modulus(body, ElasticBody::RIGID).unwrap();
        // λ grows as 1/(1 − 2ν): at 0.499 two and a half digits are lost in C₁₁ − C₁₃ alone.
        assert!((own / expected - 1.0).abs() < 1e-13, "nu = {nu}");
    }
    assert!(TransverselyIsotropic { c11: 1.0, c12: 2.0, c13: 0.1, c33: 1.0, c44: 1.0 }.effective_modulus().is_err());
}
