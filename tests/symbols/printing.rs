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

/// In lowest terms an expression is the same number at random places, and no sum under a factor shares a number or a symbol any more.
#[test]
fn lowest_terms_are_the_same_numbers() {
    use sneddon::eval::constant_value;
    use sneddon::expr::{Bindings, Formula, in_lowest_terms};
    use sneddon_checks::random::Stream;
    for (text, expected) in [
        ("2*E*(a^2/2*acos(b/a) + b/2*sqrt(a^2 - b^2))", "E*(a^2*acos(b/a) + b*sqrt(a^2 - b^2))"),
        ("-a*(-5*a^2 - 3*b^2)", "a*(5*a^2 + 3*b^2)"),
        ("sqrt(4*b^2*d^2 + 4*a^2*b^2)", "2*b*sqrt(a^2 + d^2)"),
        ("sqrt(8*b^2 + 8*a^2)", "sqrt(8*a^2 + 8*b^2)"),
        ("2*E*(2*a^3/(3*b) + pi/4*a^2*d)", "E*a^2*(4*a/(3*b) + pi/2*d)"),
        ("2*a*(0.5*a + 1.25*b)", "a*(a + 2.5*b)"),
        ("a/2 + b/2", "a/2 + b/2"),
    ] {
        let closed = |text: &str| match sneddon::parse::formula(text).unwrap() {
            Formula::Closed(expr) => expr,
            other => panic!("{other:?}"),
        };
        let (typed, found) = (closed(text), in_lowest_terms(&closed(text)));
        assert_eq!(found, closed(expected), "{text}: {}", sneddon::print::text_expr(&found));
        let mut stream = Stream::new(17);
        for _ in 0..8 {
            let values = [("E", 0.2), ("b", 0.2), ("d", 0.2), ("a", 1.0)].map(|(name, least)| (name, stream.uniform(least, 2.0 * least)));
            let set = sneddon_checks::formulas::bindings(&values);
            let value = |expr: &Expr| constant_value(&set.apply(expr), &Bindings::default()).unwrap();
            let (one, two) = (value(&typed), value(&found));
            assert!((one.value - two.value).abs() <= one.error + two.error, "{text}: {one:?} {two:?}");
        }
    }
}

/// Roots of one exponent are one root in print, which reads back as the same expression; powers of whole numbers are reduced.
#[test]
fn roots_of_one_exponent_are_one_root() {
    use sneddon::{parse, print};
    use sneddon_checks::formulas::number;
    let values = [("d", 0.37), ("C", 2.9), ("w", 1.3), ("E", 4.1), ("h", 0.6)];
    for (typed, printed) in [
        ("20^(1/6)*d^(1/6)/(2*C^(1/6))", "(20*d/C)^(1/6)/2"),
        ("3*50000^(5/6)*E*d^(7/6)/(17500*C^(1/6))", "6/7*E*d*(20*d/C)^(1/6)"),
        ("d^(2/3)*gamma(5/4)^(2/3)/(pi^(1/3)*C^(2/3)*gamma(7/4)^(2/3))", "(d*gamma(5/4)/(sqrt(pi)*C*gamma(7/4)))^(2/3)"),
        ("w^(3/5)*d^(8/5)/h^(3/5)", "d*(w*d/h)^(3/5)"),
        ("36^(2/3)*d", "6*6^(1/3)*d"),
        ("2^(2/3)*d", "2^(2/3)*d"),
        ("12870^(15/16)*d", "12870^(15/16)*d"),
        ("sqrt(d)/sqrt(C)", "sqrt(d)/sqrt(C)"),
        ("(w - d)^(1/3)/C^(1/3)", "(w - d)^(1/3)/C^(1/3)"),
    ] {
        let expr = parse::formula(typed).unwrap();
        let text = print::text(&expr);
        assert_eq!(parse::formula(&text).unwrap(), expr, "{typed}: {text}");
        let (one, other) =
            (number(expr.as_closed().unwrap(), &values), number(parse::formula(printed).unwrap().as_closed().unwrap(), &values));
        assert!((one - other).abs() <= 4e-16 * one.abs(), "{typed}: {one} and {other}");
        assert_eq!(text, printed, "{typed}");
    }
}
