//! The general rule names a series that has a name, and declines a kernel that is singular off the axis.
#![allow(clippy::unwrap_used)]

use sneddon::expr::Expr;
use sneddon::expr::normal::NormalTerm;
use sneddon::transform::rules::RULES;
use sneddon::transform::{Segment, Term};

fn slope(kernel: Expr, exponent: i64) -> Option<Expr> {
    let part = NormalTerm { coefficient: Expr::one(), exponent: Expr::integer(exponent), kernel };
    let rule = RULES.iter().find(|rule| rule.id == "hypergeometric").unwrap();
    let answer = (rule.apply)(&Term { parts: vec![part], segment: Segment::whole() })?;
    Some(answer.equivalent.within.shown)
}

#[test]
fn series_are_named_where_they_have_a_name() {
    let (r, x, k) = (Expr::symbol("r"), Expr::symbol("x"), Expr::symbol("k"));
    // r exp(−k r²): g = x² 1F1(1; 3/2; −k x²)
    let found = slope(Expr::call("exp", [-&k * r.power(2)]), 1).unwrap();
    let named = Expr::call("hyp1f1", [Expr::one(), Expr::ratio(3, 2), -&k * x.power(2)]);
    assert_eq!(found, x.power(2) * named);
    // A kernel with a singularity off the axis splits into parts that are singular on it.
    assert_eq!(slope((Expr::one() + &r).pow(&Expr::ratio(-1, 3)), 0), None);
    assert!(slope((Expr::one() - &r).pow(&Expr::ratio(-1, 3)), 0).is_some());
}
