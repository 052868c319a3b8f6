//! Laurent polynomials before functions differentiate by the law of the functions.

use sneddon::expr::Expr;
use sneddon::transform::inner::{Combination, member};

#[test]
fn derivatives_follow_the_law() {
    // sin and cos: (y sin)″ = 2 cos − y sin
    let law = vec![Combination::single(1, 1, 1, 0), Combination::single(0, -1, 1, 0)];
    let second = Combination::single(0, 1, 1, 1).derivative(&law).derivative(&law);
    let y = Expr::symbol("y");
    let members = ["sin", "cos"].map(|name| member(Expr::one(), Expr::call(name, [y.clone()])));
    let expected = Expr::integer(2) * Expr::call("cos", [y.clone()]) - &y * Expr::call("sin", [y.clone()]);
    assert_eq!(second.written(&Expr::one(), &y, &members), expected);
}
