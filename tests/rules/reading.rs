//! What rules read from a term: kernels by their content, and conditions where a sign is not known.

use sneddon::expr::{Condition, Expr};
use sneddon::transform::inner::{above, exponential_pair, linear, monomial, pair, positive, power, quadratic};

#[test]
fn kernels_are_read_by_their_content() {
    let (r, w) = (Expr::symbol("r"), Expr::symbol("w"));
    let two = Expr::integer(2);
    assert_eq!(monomial(&(&r * &two / &w)), Some((&two / &w, Expr::one())));
    assert_eq!(linear(&(&w + &two * &r)), Some((w.clone(), two.clone())));
    assert_eq!(quadratic(&(w.power(2) - r.power(2))), Some((w.power(2), Expr::integer(-1))));
    for declined in [&r + &w, r.power(2), r.clone() + r.power(2)] {
        assert_eq!(quadratic(&declined), None, "{declined:?}");
    }
    assert_eq!(power(&r.power(3)), (r.clone(), Expr::integer(3)));
    assert_eq!(power(&w), (w.clone(), Expr::one()));
    let [exponential, error] = ["exp", "erf"].map(|name| Expr::call(name, [r.clone()]));
    let product = &exponential * &error;
    assert_eq!(exponential_pair(&product), Some((&exponential, &error)));
    assert_eq!(pair(&exponential), None);
}

#[test]
fn what_is_not_known_to_be_positive_becomes_a_condition() {
    let (n, zero) = (Expr::symbol("n"), Expr::zero());
    assert_eq!(positive(&n), Some(Vec::new()));
    assert_eq!(positive(&-&n), None);
    assert_eq!(positive(&zero), None);
    assert_eq!(above(&zero, -1), Some(Vec::new()));
    let open = &n - Expr::one();
    assert_eq!(positive(&open), Some(vec![Condition::less(zero, open.clone())]));
    assert_eq!(above(&open, -1), Some(Vec::new()));
    assert_eq!(above(&(&n - Expr::integer(3)), -1), Some(vec![Condition::less(Expr::integer(-1), n - Expr::integer(3))]));
}
