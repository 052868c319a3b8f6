//! Normal forms: several ways of typing are one, quotients are divided, and expansion is bounded.
#![allow(clippy::unwrap_used)]

use sneddon::expr::normal::{NormalTerm, expanded, is_proven_zero, normal_terms, shifted_coefficients};
use sneddon::expr::{Bindings, Expr, ExprError, Symbol, derivative};
use sneddon::{parse, print};

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

/// Products in one symbol are multiplied as lists of whole numbers: the value stays, and so do the decimals.
#[test]
fn products_in_one_symbol_keep_their_value() {
    let r = Symbol::new("r");
    let product = Expr::product((1..=30).map(|i| Expr::ratio(i, 7) - s("r").power(1 + i % 3) / Expr::integer(i)));
    let at = Bindings::one("r", Expr::ratio(-5, 3));
    assert_eq!(at.apply(&expanded(&product, &r).unwrap()), at.apply(&product));
    let expanded_text = |text: &str| print::text_expr(&expanded(parse::profile(text).unwrap().as_closed().unwrap(), &r).unwrap());
    assert_eq!(expanded_text("(r+0.5)*(r+1)*(r+1.25)"), "r^3 + 2.75*r^2 + 2.375*r + 0.625");
    assert_eq!(expanded_text("(r-1)*(r+1)*(r^2+1)"), "r^4 - 1");
}

/// Σ c_m v^m = Σ p_k (v−b)^k, with terms that are homogeneous in v and b and others.
#[test]
fn shifted_coefficients_keep_the_value() {
    let (b, c, v) = (s("b"), s("c"), Symbol::new("v"));
    let homogeneous = |n: i64| (0..=n).map(|m| Expr::ratio(m + 1, 3) * b.power(n - m) * &c).collect::<Vec<_>>();
    let mixed = vec![&b + &c, Expr::ratio(1, 2), Expr::zero(), c.clone() * (&b - Expr::one()), b.power(-2)];
    let values = [("b", Expr::ratio(2, 3)), ("c", Expr::ratio(-7, 5)), ("v", Expr::ratio(9, 4))];
    let at: Bindings = values.into_iter().collect();
    for (list, about) in
        [(homogeneous(12), b.clone()), (homogeneous(7), Expr::zero()), (mixed.clone(), &b * Expr::ratio(3, 2)), (mixed, &b + &c)]
    {
        let direct = Expr::sum((0..).zip(&list).map(|(m, own)| own * s("v").power(m)));
        let shifted = shifted_coefficients(&list, &about, &v).unwrap();
        let other = Expr::sum(shifted.iter().map(|(k, own)| own * (s("v") - &about).power(*k)));
        assert_eq!(at.apply(&direct), at.apply(&other));
    }
}
