//! Numbers and names as they are printed.

use sneddon::expr::{Expr, Number};
use sneddon::print::latex_expr;

#[test]
fn numbers_keep_the_look_they_were_typed_with() {
    for (typed, mantissa, exponent) in [
        ("0.7", "0.7", None),
        ("12.50", "12.5", None),
        ("0.001", "0.001", None),
        ("0.0001", "0.0001", None),
        ("1e-5", "1", Some(-5)),
        ("1e-6", "1", Some(-6)),
        ("2.5e-7", "2.5", Some(-7)),
        ("123", "123", None),
        ("1000000", "1000000", None),
        ("1e20", "1", Some(20)),
        ("1.5e20", "1.5", Some(20)),
        ("0", "0", None),
    ] {
        let expected = match (mantissa, exponent) {
            (mantissa, None) => mantissa.to_owned(),
            ("1", Some(exponent)) => format!("10^{{{exponent}}}"),
            (mantissa, Some(exponent)) => format!("{mantissa} \\cdot 10^{{{exponent}}}"),
        };
        assert_eq!(latex_expr(&Expr::number(Number::parse_decimal(typed).unwrap())), expected, "{typed}");
    }
}

#[test]
fn names_are_set_as_an_author_sets_them() {
    for (name, latex) in [
        ("r", "r"),
        ("E", "E^{*}"),
        ("E_0", "E_{0}"),
        ("theta", "\\theta"),
        ("theta_0", "\\theta_{0}"),
        ("c_1", "c_{1}"),
        ("c12", "c_{12}"),
        ("R_tip", "R_{\\mathrm{tip}}"),
        ("R_t", "R_{t}"),
        ("R_theta", "R_{\\theta}"),
        ("R_tip_1", "R_{\\mathrm{tip},1}"),
        ("width", "\\mathrm{width}"),
        ("Deltah", "\\Delta h"),
        ("R_", "R"),
        ("Alpha", "\\mathrm{A}"),
    ] {
        assert_eq!(latex_expr(&Expr::symbol(name)), latex, "{name}");
    }
}
