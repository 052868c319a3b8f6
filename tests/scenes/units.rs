//! Units: exact factors, and what is not a unit.
#![cfg(feature = "scene")]

use sneddon::expr::Expr;
use sneddon::scene::Unit;

#[test]
fn factors_are_exact() {
    let factor = |text: &str| Unit::parse(text).unwrap().factor().clone();
    assert_eq!(factor("nm"), Expr::ratio(1, 1_000_000_000));
    assert_eq!(factor("um^-0.5"), Expr::integer(1000));
    assert_eq!(factor("N/mm^2"), factor("MPa"));
    assert_eq!(factor("lbf/in^2"), factor("psi"));
    assert_eq!(factor("mN"), factor("µN") * Expr::integer(1000));
    assert_eq!(factor("m^(1/2) m^(-1/2)"), Expr::one());
    assert_eq!(factor("1/um"), Expr::integer(1_000_000));
}

#[test]
fn what_is_no_unit() {
    for text in ["", " ", "x", "um^", "um^x", "um^1/0", "kin", "um**2", "/", "m^1e99", "5 um"] {
        assert!(Unit::parse(text).is_err(), "{text}");
    }
}
