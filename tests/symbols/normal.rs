//! Normal forms: several ways of typing are one, quotients are divided, and expansion is bounded.
#![allow(clippy::unwrap_used)]

use sneddon::expr::normal::{NormalTerm, is_proven_zero, normal_terms};
use sneddon::expr::{Expr, ExprError, Symbol, derivative};

fn s(name: &str) -> Expr {
    Expr::symbol(name)
}

fn slope(f: &Expr) -> Vec<NormalTerm> {
    let r = Symbol::new("r");
    normal_terms(&derivative(f, &r).unwrap(), &r).unwrap()
}

#[test]
fn four_ways_of_typing_a_sphere_are_one() {
    let (r, big) = (s("r"), s("R"));
    let root = (big.power(2) - r.power(2)).sqrt();
    let plain = slope(&(&big - &root));
    assert_eq!(plain.len(), 1);
    assert_eq!(plain[0].kernel, root.recip());
    let scaled = slope(&(&big * (Expr::one() - (Expr::one() - (&r / &big).power(2)).sqrt())));
    let rationalised = slope(&(r.power(2) / (&big + &root)));
    let product = slope(&(&big - ((&big - &r) * (&big + &r)).sqrt()));
    assert_eq!(plain, scaled);
    assert_eq!(plain, rationalised);
    // Factors under the root of unproven sign stay together, hence expand first.
    assert_eq!(plain, product);
}

#[test]
fn quotients_are_divided() {
    let (r, w) = (s("r"), s("w"));
    // r³/(r² + w²) = r − w² r/(r² + w²)
    let terms = normal_terms(&(r.power(3) / (r.power(2) + w.power(2))), &Symbol::new("r")).unwrap();
    assert_eq!(terms.len(), 2);
    assert!(terms.iter().all(|t| t.exponent.is_one()));
}

#[test]
fn expansion_is_bounded() {
    let big = (Expr::one() + s("r")).power(1_000_000);
    assert!(matches!(normal_terms(&big, &Symbol::new("r")), Err(ExprError::TooLarge { .. })));
    assert!(is_proven_zero(&((s("r") + s("b")).power(3) - (s("r") + s("b")) * (s("b") + s("r")).power(2)), &Symbol::new("r")));
}
