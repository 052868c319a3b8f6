//! Calls that the function table answers at once: one form for both signs, and values in closed form.

use sneddon::expr::{Expr, Node};

#[test]
fn an_odd_function_has_one_form_for_both_signs() {
    let (x, y) = (Expr::symbol("x"), Expr::symbol("y"));
    for u in [&x - &y, Expr::integer(2) * &y - Expr::integer(3) * &x, -&x - &y, Expr::one() - &x] {
        assert_eq!(Expr::call("sin", [-&u]), -Expr::call("sin", [u.clone()]));
        assert_eq!(Expr::call("cos", [-&u]), Expr::call("cos", [u]));
    }
}

#[test]
fn one_form_for_both_signs() {
    let z = Expr::symbol("k") * Expr::symbol("x");
    let call = |name: &'static str, n: i64, z: &Expr| Expr::call(name, [Expr::integer(n), z.clone()]);
    assert_eq!(call("besselj", 1, &-&z), -call("besselj", 1, &z));
    assert_eq!(call("besselj", -1, &z), -call("besselj", 1, &z));
    assert_eq!(call("besseli", -1, &-&z), -call("besseli", 1, &z));
    assert_eq!(call("struveh", 0, &-&z), -call("struveh", 0, &z));
    assert_eq!(call("struvel", -1, &-&z), call("struvel", -1, &z));
    assert_eq!(call("struveh", -1, &Expr::zero()), Expr::integer(2) / Expr::pi());
    assert_eq!(Expr::call("erf", [-&z]), -Expr::call("erf", [z.clone()]));
    assert_eq!(call("besselj", 0, &Expr::zero()), Expr::one());
}

#[test]
fn gamma_of_whole_and_half_numbers_is_folded() {
    let gamma = |p, q| Expr::call("gamma", [Expr::ratio(p, q)]);
    assert_eq!(gamma(5, 1), Expr::integer(24));
    assert_eq!(gamma(1, 1), Expr::one());
    assert_eq!(gamma(1, 2), Expr::pi().sqrt());
    assert_eq!(gamma(7, 2), Expr::ratio(15, 8) * Expr::pi().sqrt());
    assert!(matches!(gamma(1, 3).node(), Node::Function(..)));
}

#[test]
fn trivial_arguments_are_folded() {
    let [a, b, z] = ["p", "q", "z"].map(Expr::symbol);
    // The numbers of upper and lower parameters stand first.
    let (one, two) = (Expr::one(), Expr::integer(2));
    let call = |name, list: &[&Expr]| Expr::call(name, list.iter().map(|u| (*u).clone()));
    assert_eq!(call("hyp2f1", &[&a, &b, &a, &z]), (Expr::one() - &z).pow(&-&b));
    assert_eq!(call("hyp1f1", &[&a, &a, &z]), call("exp", &[&z]));
    let reduced = call("hyper", &[&two, &two, &a, &b, &b, &z, &z]);
    assert_eq!(reduced, call("hyper", &[&one, &one, &a, &z, &z]));
    assert_eq!(call("hyper", &[&one, &one, &a, &b, &Expr::zero()]), Expr::one());
    assert_eq!(call("betainc", &[&a, &b, &z, &z]), Expr::zero());
    assert_eq!(call("acosh", &[&one]), Expr::zero());
    assert_eq!(call("polylog", &[&Expr::integer(2), &Expr::one()]), Expr::pi().power(2) / Expr::integer(6));
}
