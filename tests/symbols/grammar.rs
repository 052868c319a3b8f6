//! The grammar: what reads as what, where errors point, and that every limit holds in little time and stack.
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)]

use sneddon::expr::{Expr, Formula};
use sneddon::num::work::{Budget, Exhausted, within};
use sneddon::parse::{self, ParseError, Reason};
use sneddon_checks::seeds::cases;

fn read(text: &str) -> Formula {
    parse::profile(text).unwrap_or_else(|error| panic!("{text}: {error} at {:?}", error.span()))
}

/// The error of a profile, and the text it points at.
fn error(text: &str) -> (ParseError, &str) {
    let error = parse::profile(text).err().unwrap_or_else(|| panic!("{text} was read"));
    let place = &text[error.span()];
    (error, place)
}

#[test]
fn different_spellings_are_one_expression() {
    for (left, right) in [
        ("-r^2", "-(r^2)"),
        ("r^2^3", "r^(2^3)"),
        ("r^-2", "1/r^2"),
        ("2/-r*3", "(2/(-r))*3"),
        ("b-r-c", "b-(r+c)"),
        ("b/r/c", "b/(r*c)"),
        ("2*-r^2", "-2*r^2"),
        ("--r", "r"),
        ("+-+r", "-r"),
        ("θ*r", "theta*r"),
        ("α_1*r", "alpha_1*r"),
        ("π*r", "pi*r"),
        ("2·r × R − 1", "2*r*R - 1"),
        ("0.5*r", "r/2"),
        (".5*r", "5e-1*r"),
        ("2.*r", "2*r"),
        ("1E2*r", "100*r"),
        ("2*e-3*r", "2*exp(1)-3*r"),
        ("e^(-r^2/w^2)", "exp(-(r/w)^2)"),
        ("sqrt(r)", "r^(1/2)"),
        ("log(r+1)", "ln(r+1)"),
        ("arctan(r)+arcsin(r/R)+arccos(r/R)", "atan(r)+asin(r/R)+acos(r/R)"),
        ("artanh(r/R)+arsinh(r)+arcosh(r+1)", "atanh(r/R)+asinh(r)+acosh(r+1)"),
        ("piecewise(0, r<b, r)", "piecewise(0, b>r, r)"),
        ("piecewise(0, r<=b, r)", "piecewise(0, b>=r, r)"),
        ("2*piecewise(0, r<b, r-b)", "piecewise(0, r<b, 2*(r-b))"),
        ("r/2*piecewise(0, r<b, r-b)", "piecewise(0, r<b, (r-b)/2*r)"),
        ("piecewise(1, r<b, r)^2", "piecewise(1, r<b, r^2)"),
        ("1/piecewise(1, r<b, r)", "piecewise(1, r<b, 1/r)"),
        ("sin(piecewise(0, r<b, r))", "piecewise(0, r<b, sin(r))"),
        ("sin(k*r + piecewise(0, r<b, r))", "piecewise(sin(k*r), r<b, sin(k*r+r))"),
        ("piecewise(0, r<b, r)*piecewise(1, r<b, r)", "piecewise(0, r<b, r^2)"),
        ("piecewise(2, r<1, r)*piecewise(3, r<2, r)", "piecewise(6, r<1, 3*r, r<2, r^2)"),
        ("piecewise(2, r<pi, r)*piecewise(3, r<3, r)", "piecewise(6, r<3, 2*r, r<pi, r^2)"),
        ("piecewise(2, r<2*b, r)*piecewise(3, r<b, r)", "piecewise(6, r<b, 2*r, r<2*b, r^2)"),
        ("piecewise(0, r<b, 1, r<c, 2)*piecewise(1, r<c, r)", "piecewise(0, r<b, 1, r<c, 2*r)"),
        ("piecewise(0, r<b, 1) + piecewise(r, r<b, 2)", "piecewise(r, r<b, 3)"),
        ("piecewise(0, r<2, piecewise(1, r<3, 2))", "piecewise(0, r<2, 1, r<3, 2)"),
        ("piecewise(piecewise(0, r<1, r, r<4, 5), r<2, 7)", "piecewise(0, r<1, r, r<2, 7)"),
        ("piecewise(0, r<2, piecewise(1, r<1, 2))", "piecewise(0, r<2, 2)"),
        ("piecewise(piecewise(0, r<2, 1), r<2, 7)", "piecewise(0, r<2, 7)"),
        ("0*piecewise(0, r<b, 1)", "0"),
    ] {
        assert_eq!(read(left), read(right), "{left} against {right}");
    }
}

#[test]
fn sums_of_unrelated_pieces_need_no_order() {
    assert!(matches!(read("r + piecewise(0, r<b, 1) + piecewise(0, r<c, 1)"), Formula::Sum(parts) if parts.len() == 3));
}

#[test]
fn decimals_are_exact_and_stay_decimals() {
    let Formula::Closed(expr) = read("0.7") else { panic!() };
    assert_eq!(expr, Expr::ratio(7, 10));
    assert!(expr.as_number().unwrap().is_decimal());
    assert_eq!(parse::constant("1e-6").unwrap(), Expr::ratio(1, 1_000_000));
}

#[test]
fn formulas_know_all_variables_and_integrals() {
    for text in ["2*E*a*d", "integral(r^2/sqrt(a^2-r^2), r, 0, a)", "piecewise(0, x<b, x)", "2*integral(exp(-t), t, 0, x)"] {
        parse::formula(text).unwrap();
    }
    let pieces = parse::formula("piecewise(piecewise(1, a<c, 2), r<b, 3)").unwrap();
    assert!(matches!(pieces, Formula::Piecewise { .. }), "pieces in another variable stay inside");
    assert!(matches!(parse::formula("sin(integral(t, t, 0, x))").unwrap_err().reason(), Reason::IntegralInside));
    assert!(matches!(parse::formula("piecewise(0, b<x, x)").unwrap_err().reason(), Reason::LowerBound));
}

#[test]
fn constants_are_closed() {
    for text in ["0.3", "3/2", "1e-6", "-1", "pi/6", "sqrt(2)", "e", "-pi"] {
        parse::constant(text).unwrap();
    }
    for text in ["nan", "inf", "-inf", "NaN", "", " ", "R", "r", "E"] {
        let error = parse::constant(text).unwrap_err();
        assert!(!error.accepted().is_empty(), "{text}: {error}");
    }
    assert!(parse::constant("inf").unwrap_err().to_string().contains("3/2"));
}

#[test]
fn errors_point_at_their_place_and_say_what_was_expected() {
    for (text, place, says) in [
        ("2r", "r", "write 2*r"),
        ("2 r", "r", "write 2*r"),
        ("r(r+1)", "r", "write r*(r+1)"),
        ("(r+1)(r+2)", "(", "write (r+1)*(r+2)"),
        ("r^2 + ", "", "unexpected end"),
        ("", "", "the expression is empty"),
        ("r + * 2", "*", "a number, a name"),
        ("(r", "(", "close it with )"),
        ("r)", ")", "remove it"),
        ("0,3*r", ",", "point"),
        ("r^2.5.1", "2.5", "at most one point"),
        ("x^2", "x", "x_0"),
        ("r*a", "a", "a_0"),
        ("d+r", "d", "d_0"),
        ("E*r", "E", "E_0"),
        ("gamma*r", "gamma", "gamma_0"),
        ("γ*r", "γ", "gamma_0"),
        ("sin + 1", "sin", "sin(…)"),
        ("sin r", "r", "write sin(r)"),
        ("sine(r)", "sine", "sin"),
        ("sqr(r)", "sqr", "sqrt"),
        ("arctg(r)", "arctg", "expected"),
        ("sin(r, 2)", "sin(r, 2)", "1 argument"),
        ("r^2 $ 3", "$", "'$'"),
        ("r**2", "**", "r^2"),
        ("|r|", "|", "abs(r)"),
        ("r\0", "\0", "U+0000"),
        ("1/0", "0", "divisor"),
        ("r/(r-r)", "(r-r)", "divisor"),
        ("0^(-1)", "0^(-1)", "negative power"),
        ("sqrt(-4)", "-4", "not real"),
        ("sqrt(1-pi)", "1-pi", "not real"),
        ("(-8)^(1/3)", "(-8)", "not real"),
        ("ln(0)", "0", "ln"),
        ("ln(3-e)+ln(2-e)", "2-e", "ln"),
        ("asin(2)*r", "2", "asin"),
        ("atanh(1)*r", "1", "atanh"),
        ("gamma(0)", "0", "gamma"),
        ("r<b", "<", "piecewise"),
        ("sin(r<b)", "r<b", "piecewise"),
        ("piecewise(0, r<b)", "piecewise(0, r<b)", "odd number"),
        ("piecewise(0, b, r)", "b", "condition"),
        ("piecewise(0, r>b, r)", "r>b", "r<b"),
        ("piecewise(0, b<r, r)", "b<r", "r<b"),
        ("piecewise(0, b<r<c, r)", "<", "one comparison"),
        ("piecewise(0, s<b, r)", "s<b", "r<b"),
        ("piecewise(0, r<2, r, r<1, r)", "r<1", "increasing"),
        ("piecewise(0, r<b, r, r<b, r)", "r<b", "increasing"),
        ("piecewise(0, r<2*b, r, r<b, r)", "r<b", "increasing"),
        ("piecewise(0, r<2*r, r)", "2*r", "parameters"),
        ("piecewise(0, r<0, r)", "0", "positive"),
        ("piecewise(0, r<-b, r)", "-b", "positive"),
        ("piecewise(0, r<b, r)*piecewise(0, r<c, r)", "piecewise(0, r<b, r)*piecewise(0, r<c, r)", "b and c"),
        ("integral(r, r, 0, 1)", "integral", "without integrals"),
        ("[r]", "[", "hyper"),
        ("1e10001*r", "1e10001", "10000"),
        ("1e99999999999999999999*r", "1e99999999999999999999", "10000"),
        ("r^(10^400)", "(10^400)", "1000000"),
        ("r^1000001", "1000001", "1000000"),
        ("(r^1000000)^1000000", "(r^1000000)^1000000", "1000000"),
        ("9^9^9", "9^9", "1000000"),
        ("9^999999", "9^999999", "10000 digits"),
        ("(2*r)^1000000", "(2*r)^1000000", "10000 digits"),
        ("((2*r)^9999)^9999", "((2*r)^9999)^9999", "10000 digits"),
    ] {
        let (error, found) = error(text);
        // Only the beginning of an unclosed or missing place is compared where the place is a whole construct.
        assert_eq!(found, place, "{text}: {error}");
        assert!(error.to_string().contains(says), "{text}: {error}");
        assert!(!error.accepted().is_empty());
    }
}

/// Runs on a small stack, as threads have it, and in few steps of work, which are counted alike on every machine.
fn quickly<T: Send + 'static>(what: &str, run: impl FnOnce() -> T + Send + 'static) -> T {
    let counted = move || within(Budget::seconds(1.0), || Ok::<_, Exhausted>(run()));
    let found = std::thread::Builder::new().stack_size(2 << 20).spawn(counted).unwrap().join().expect("no overflow");
    found.unwrap_or_else(|error| panic!("{what}: {error}"))
}

#[test]
fn hostile_texts_are_refused_quickly() {
    for (what, text) in [
        ("parentheses", format!("{}r{}", "(".repeat(100_000), ")".repeat(100_000))),
        ("open parentheses", "(".repeat(100_000)),
        ("signs", format!("{}r", "-".repeat(5000))),
        ("calls", format!("{}r{}", "sin(".repeat(50_000), ")".repeat(50_000))),
        ("powers", "r^".repeat(100_000) + "2"),
        ("digits", "1".repeat(1 << 20)),
        ("fraction digits", "0.".to_owned() + &"1".repeat(1 << 19)),
        ("long text", "r+".repeat(1 << 20) + "r"),
        ("product of numbers", "9999999999*".repeat(90_000) + "1"),
        ("product of decimals", "1e9999*".repeat(100_000) + "r"),
        ("sum of small decimals", "1e-10000+".repeat(100_000) + "r"),
        ("towers", "9^9^9^9^9^9^9".to_owned()),
        ("nested sums", format!("{}{}r{}", "1+(".repeat(990), "r+".repeat(400_000), ")".repeat(990))),
        ("brackets", format!("hyper({}", "[".repeat(100_000))),
        ("harmonic sum", (1..60_000).map(|n| format!("1/{n}+")).collect::<String>() + "r"),
    ] {
        let error = quickly(what, move || parse::profile(&text).err());
        assert!(error.is_some(), "{what} was read");
    }
}

#[test]
fn large_but_fair_texts_are_read_quickly() {
    let texts = [
        ("sum of ones", "1+".repeat(500_000) + "1"),
        ("sum of symbols", "r+".repeat(100_000) + "r"),
        ("product of symbols", "r*".repeat(100_000) + "r"),
        ("differences", "r-1-".repeat(50_000) + "r"),
        ("quotients", "r/2/".repeat(10_000) + "r"),
        ("polynomial", (1..80_000).map(|n| format!("r^{n}+")).collect::<String>() + "r"),
        ("high power", "(1+r)^1000000".to_owned()),
        ("deep parentheses", format!("{}r{}", "(".repeat(999), ")".repeat(999))),
        ("deep signs", format!("{}r", "-".repeat(999))),
        ("deep calls", format!("{}r{}", "sin(".repeat(999), ")".repeat(999))),
        ("deep roots", format!("{}r{}", "sqrt(1+".repeat(999), ")".repeat(999))),
        ("deep fractions", format!("{}r{}", "1/(1+".repeat(999), ")".repeat(999))),
        ("deep products", format!("{}r{}", "2*(1+".repeat(999), ")".repeat(999))),
        ("deep powers", "k^".repeat(999) + "r"),
        ("deep comparisons", format!("2*{0}r{1}+{0}r{1}", "sin(1+2*".repeat(900), ")".repeat(900))),
        ("deep pieces", format!("{}r{}", "sin(".repeat(900) + "piecewise(1, r<b, ", ")".repeat(901))),
        ("many parameters", (1..80_000).map(|n| format!("c_{n}*r+")).collect::<String>() + "r"),
        ("long name", "r".repeat(1_000_000)),
        ("many pieces", format!("piecewise({}1)", (1..1000).map(|n| format!("r^{n}, r<{n}, ")).collect::<String>())),
        ("sums of pieces", (1..1000).map(|n| format!("piecewise(0, r<{n}, r)+")).collect::<String>() + "r"),
        ("product of pieces", (1..200).map(|n| format!("piecewise(1, r<{n}, r+{n})*")).collect::<String>() + "r"),
    ];
    for (what, text) in texts.into_iter().step_by(cases(2, 1)) {
        let error = quickly(what, move || parse::profile(&text).err());
        assert_eq!(error, None, "{what}");
    }
}

#[test]
fn no_text_panics() {
    let mut seed = 1u64;
    let pieces = [
        "r",
        "2",
        "0",
        "(",
        ")",
        "+",
        "-",
        "*",
        "/",
        "^",
        ",",
        "<",
        ">",
        "piecewise(",
        "sin(",
        "sqrt(",
        "ln(",
        "b",
        "1e",
        ".",
        "0.5",
        "θ",
        "²",
        "[",
        "]",
        "hyper(",
        "e",
        "max(",
        "abs(",
        " ",
        "\n",
    ];
    for _ in 0..20_000 {
        let mut text = String::new();
        for _ in 0..12 {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            text.push_str(pieces[(seed >> 33) as usize % pieces.len()]);
        }
        if let Err(error) = parse::profile(&text) {
            assert!(text.get(error.span()).is_some(), "{text}: {:?}", error.span());
        }
        drop((parse::formula(&text), parse::constant(&text)));
    }
}
