//! Quotients of exponentials go where they are outgrown.

use sneddon::expr::{Expr, balanced};

#[test]
fn exponentials_go_where_they_are_outgrown() {
    let r = Expr::symbol("r");
    let exp = |k: i64| Expr::call("exp", [Expr::integer(k) * &r]);
    let logistic = exp(4) / (Expr::one() + exp(4)).power(2);
    let cosh = |u: Expr| Expr::call("cosh", [u]);
    assert_eq!(balanced(&logistic), Expr::ratio(1, 4) * cosh(Expr::integer(2) * &r).power(-2));
    let weighted = exp(4) / (Expr::one() + Expr::integer(9) * exp(4)).power(2);
    let shift = Expr::call("ln", [Expr::ratio(1, 9)]) / Expr::integer(-2);
    assert_eq!(balanced(&weighted), Expr::ratio(1, 36) * cosh(Expr::integer(2) * &r + shift).power(-2));
    // Nothing outgrows it here.
    let rising = exp(4) / (Expr::one() + exp(-1));
    assert_eq!(balanced(&rising), rising);
    assert_eq!(balanced(&(exp(-3) / (Expr::integer(2) + exp(-3)))), (Expr::integer(2) * exp(3) + Expr::one()).power(-1));
}
