//! Numbers and names as they are printed.

use sneddon::expr::{Expr, Number};
use sneddon::print::latex_expr;
use sneddon::{parse, print};

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
        ("d^(2/3)*gamma(5/4)^(2/3)/(pi^(1/3)*C^(2/3)*gamma(7/4)^(2/3))", "(gamma(5/4)*d/(sqrt(pi)*gamma(7/4)*C))^(2/3)"),
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

/// Class "decimals beside roots": numbers stay under the root where that takes fewer digits, and parsing restores the formula.
#[test]
fn decimals_stay_under_their_root() {
    for (typed, printed) in [
        ("sqrt(2546*d)/254.6", "sqrt(d/25.46)"),
        ("(66076738814000.0*d)^(1/6)/254.0", "(d/4.064)^(1/6)"),
        ("2*sqrt(2546)/381.9*E*d^(3/2)", "4/3*E*d*sqrt(d/25.46)"),
        ("sqrt(2*R*d)/2", "sqrt(2*R*d)/2"),
        ("3*sqrt(3)*d/4", "3*sqrt(3)/4*d"),
        // The decimal would not be seen, and the formula would be printed in another way after it was read.
        ("0.5625*pi*sqrt(2*x)", "0.5625*pi*sqrt(2*x)"),
    ] {
        let own = parse::formula(typed).unwrap();
        let shown = print::text(&own);
        assert_eq!(shown, printed, "{typed}");
        let again = parse::formula(&shown).unwrap();
        assert_eq!(again, own, "{typed}");
        assert_eq!(print::text(&again), shown, "{typed}");
    }
    // Where parsing would not restore it, only the other notations write the short form.
    let own = parse::formula("0.12*63500^(5/6)/889*E*d^(7/6)").unwrap();
    assert_eq!(print::latex(&own), r"\frac{6}{7} E^{*} d \sqrt[6]{\frac{2}{0.127} d}");
    assert_eq!(parse::formula(&print::text(&own)).unwrap(), own);
}

/// Outside of the program's own grammar, the terms of a difference are exchanged instead of a leading minus; in it the formula reads back.
#[test]
fn differences_have_no_leading_minus() {
    let own = parse::formula("-x^2/(R_1-R_2)").unwrap();
    assert_eq!(print::latex(&own), r"\frac{x^{2}}{R_{2} - R_{1}}");
    assert_eq!(parse::formula(&print::text(&own)).unwrap(), own);
    let own = parse::formula("-x^2*(a+b-c)^2").unwrap();
    assert!(print::latex(&own).starts_with('-'));
}

/// Polynomials fall in the contact radius, and values of functions stand with the numbers.
#[test]
fn polynomials_and_constants_are_in_order() {
    let own = parse::formula("4*a^2*r^2+8*r^4+3*a^4").unwrap();
    assert_eq!(print::text(&own), "3*a^4 + 4*a^2*r^2 + 8*r^4");
    let own = parse::formula("6*sqrt(pi)*E*C*a^(5/2)*gamma(7/4)/(5*gamma(5/4))").unwrap();
    assert_eq!(print::text(&own), "6*sqrt(pi)*gamma(7/4)/(5*gamma(5/4))*E*C*a^(5/2)");
}
