//! Parsing and printing together: what is printed reads back as the same expression, and LaTeX is well formed.
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)]

use proptest::prelude::*;
use sneddon::expr::{self, Expr, Formula, Function, Number, Symbol};
use sneddon::{parse, print};
use sneddon_checks::seeds::cases;

/// Expressions of every kind of node, as rules and users build them; no negative number below a root.
fn expression() -> impl Strategy<Value = Expr> {
    let decimal = |text: &&str| Expr::number(Number::parse_decimal(text).unwrap());
    let leaf = prop_oneof![
        4 => prop::sample::select(vec!["r", "x", "a", "d", "E", "R", "b", "theta", "c_1", "R_tip", "n"]).prop_map(Expr::symbol),
        3 => (-9i64..10).prop_map(Expr::integer),
        2 => (-9i64..10, 1i64..10).prop_map(|(p, q)| Expr::ratio(p, q)),
        1 => prop::sample::select(vec!["0.7", "12.5", "1e-6", "2.5e-7", "1e20", "0.001"]).prop_map(move |text| decimal(&text)),
        1 => Just(Expr::pi()),
        1 => Just(Expr::euler()),
    ];
    leaf.prop_recursive(5, 40, 4, |inner| {
        let names: Vec<&'static str> = Function::all()
            .filter(|f| f.row().shown.is_none() && f.row().arity == (1, 1) && f.name() != "gamma")
            .map(Function::name)
            .collect();
        prop_oneof![
            3 => prop::collection::vec(inner.clone(), 2..4).prop_map(Expr::sum),
            3 => prop::collection::vec(inner.clone(), 2..4).prop_map(Expr::product),
            1 => (inner.clone(), inner.clone()).prop_map(|(u, v)| u - v),
            2 => (inner.clone(), inner.clone()).prop_map(|(u, v)| if v.is_zero() { u } else { u / v }),
            1 => inner.clone().prop_map(|u| -u),
            2 => (inner.clone(), -3i64..5).prop_map(|(u, n)| if u.is_zero() { u } else { u.power(n) }),
            2 => (inner.clone(), prop::sample::select(vec![(1, 2), (-1, 2), (3, 2), (1, 3), (-2, 3)]))
                .prop_map(|(u, (p, q))| (u.power(2) + Expr::one()).pow(&Expr::ratio(p, q))),
            1 => (inner.clone(), inner.clone()).prop_map(|(u, v)| (u.power(2) + Expr::one()).pow(&v)),
            2 => (inner.clone(), prop::sample::select(names)).prop_map(|(u, name)| Expr::call(name, [u])),
            1 => (inner.clone(), inner).prop_map(|(u, v)| Expr::call("max", [u, v])),
        ]
    })
}

/// Sums, multiples, pieces and integrals of expressions.
fn formula() -> impl Strategy<Value = Formula> {
    let variable = prop::sample::select(vec!["r", "x"]);
    let closed = expression().prop_map(Formula::Closed).boxed();
    let integral = (expression(), variable.clone()).prop_map(|(integrand, variable)| Formula::Integral {
        integrand: Box::new(integrand.into()),
        variable: Symbol::new(variable),
        lower: Expr::zero(),
        upper: Expr::symbol("a"),
    });
    let part = prop_oneof![closed.clone(), (expression(), integral).prop_map(|(scale, integral)| integral.scaled(&scale))].boxed();
    let pieces = (part.clone(), part.clone(), part.clone(), variable).prop_map(|(u, v, w, variable)| Formula::Piecewise {
        variable: Symbol::new(variable),
        pieces: vec![(u, Expr::symbol("b")), (v, Expr::integer(2) * Expr::symbol("b"))],
        last: Box::new(w),
    });
    prop_oneof![closed, pieces.clone(), prop::collection::vec(prop_oneof![part, pieces], 2..4).prop_map(Formula::sum)]
}

/// True where the grammar refuses a part of the expression because it has no real value or its numbers are beyond the limits.
fn refused(error: &parse::ParseError) -> bool {
    use parse::Reason;
    matches!(
        error.reason(),
        Reason::Domain { .. }
            | Reason::NegativeBase { .. }
            | Reason::ZeroToNegative
            | Reason::DivisionByZero
            | Reason::NumberTooLarge
            | Reason::TooManyDigits { .. }
            | Reason::DecimalExponent
            | Reason::NumberWork
            | Reason::Exponent
    )
}

fn balanced(latex: &str) -> bool {
    let count = |part: &str| latex.matches(part).count();
    let mut depth = 0i64;
    let nested = latex.chars().all(|c| {
        depth += i64::from(c == '{') - i64::from(c == '}');
        depth >= 0
    });
    nested
        && depth == 0
        && count("(") == count(")")
        && count("\\left") == count("\\right")
        && count("\\begin{cases}") == count("\\end{cases}")
}

/// Marks of careless typesetting.
const UGLY: [&str; 7] = ["--", "+-", "- -", "+ -", "{}{", "\\frac{1}{1}", "  "];

/// True where a factor 1 is written out before another factor.
fn has_idle_one(latex: &str) -> bool {
    let tokens: Vec<&str> = latex.split(' ').collect();
    let begins_factor = |next: &str| {
        next.starts_with(|c: char| c.is_ascii_alphabetic())
            || ["\\sin", "\\frac", "\\sqrt", "\\int", "\\left", "\\theta", "\\pi", "\\operatorname", "\\mathrm"]
                .iter()
                .any(|factor| next.starts_with(factor))
    };
    tokens
        .windows(2)
        .any(|pair| matches!(pair, [one, next] if (*one == "1" || one.ends_with("(1") || one.ends_with("{1")) && begins_factor(next)))
}

/// Whole decimals in exponents and powers of ten in denominators have one printed form.
#[test]
fn what_was_printed_prints_the_same_again() {
    for typed in [
        "ellipk(a^2)^5.0",
        "sin(a)^2.0",
        "sqrt(a)^3.0",
        "a^2.0",
        "9145049221509676025181914925780525387*pi/1.6e15*a",
        "7/2.5e20*a + 3/1e21",
        "12345678901234567890/3.2e18*a",
        "1.6e15*a",
        "2.5e-7*a^1.50",
    ] {
        let printed = print::text(&parse::formula(typed).unwrap());
        assert_eq!(print::text(&parse::formula(&printed).unwrap()), printed, "{typed}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(400, 1000), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn text_reads_back_as_the_same_expression(tree in expression()) {
        let text = print::text_expr(&tree);
        match parse::formula(&text) {
            Ok(back) => prop_assert_eq!(back.as_closed(), Some(&expr::shown(&tree)), "{}", text),
            Err(error) => prop_assert!(refused(&error), "{}: {}", text, error),
        }
    }

    #[test]
    fn formulas_read_back(formula in formula()) {
        let text = print::text(&formula);
        match parse::formula(&text) {
            Ok(back) => prop_assert_eq!(back, formula.map(&expr::shown), "{}", text),
            Err(error) => prop_assert!(refused(&error), "{}: {}", text, error),
        }
    }

    #[test]
    fn latex_is_balanced_and_tidy(formula in formula()) {
        let latex = print::latex(&formula);
        prop_assert!(balanced(&latex), "{}", latex);
        prop_assert!(!has_idle_one(&latex), "{}", latex);
        for ugly in UGLY {
            prop_assert!(!latex.contains(ugly), "{:?} in {}", ugly, latex);
        }
    }

    #[test]
    fn equal_expressions_print_alike(u in expression(), v in expression(), w in expression()) {
        let (left, right) = (Expr::sum([u.clone(), v.clone(), w.clone()]), Expr::sum([w.clone(), v.clone(), u.clone()]));
        // Whether a sum stays a decimal may depend on the order in which it was added up; its look is then not compared.
        let decimal = print::text_expr(&left).contains('.') || print::text_expr(&right).contains('.');
        if left == right && !decimal {
            prop_assert_eq!(print::latex_expr(&left), print::latex_expr(&right));
            prop_assert_eq!(print::text_expr(&left), print::text_expr(&right));
        }
    }
}

#[test]
fn functions_for_stable_evaluation_are_shown_as_what_they_equal() {
    for function in Function::all().filter(|function| function.row().shown.is_some()) {
        let names = ["x", "b", "R", "c"];
        let arguments: Vec<Expr> = names.iter().take(function.row().arity.0).map(|name| Expr::symbol(name)).collect();
        let text = print::text_expr(&Expr::function(function, arguments));
        assert!(!text.contains(function.name()), "{text}");
        parse::formula(&text).unwrap_or_else(|error| panic!("{text}: {error}"));
    }
}

#[test]
fn general_hypergeometric_functions_keep_their_lists() {
    if Function::named("hyper").is_none() {
        return;
    }
    let text = "hyper([1/2, 1], [3/2], -x^2/b^2)";
    let formula = parse::formula(text).unwrap();
    assert_eq!(print::text(&formula), text);
    assert_eq!(print::latex(&formula), r"{}_{2}\mathrm{F}_{1}\left(\frac{1}{2}, 1; \frac{3}{2}; -\frac{x^{2}}{b^{2}}\right)");
}

#[test]
fn the_deepest_expressions_print_on_the_stack_of_a_program() {
    let texts: [(&str, String); 4] = [
        ("calls", format!("{}r{}", "sin(".repeat(999), ")".repeat(999))),
        ("roots", format!("{}r{}", "sqrt(1+".repeat(999), ")".repeat(999))),
        ("products", format!("{}r{}", "2*(1+".repeat(999), ")".repeat(999))),
        // Printed with parentheses around every exponent, which count as levels too.
        ("powers", "k^".repeat(499) + "r"),
    ];
    for (what, text) in texts.into_iter().step_by(cases(2, 1)) {
        let run = move || {
            let formula = parse::profile(&text).unwrap();
            assert!(balanced(&print::latex(&formula)), "{what}");
            for written in [print::unicode(&formula), print::typst(&formula), print::mathml(&formula)] {
                assert!(written.contains('k') || written.contains('r'), "{what}");
            }
            assert_eq!(parse::formula(&print::text(&formula)).unwrap(), formula, "{what}");
        };
        std::thread::Builder::new().stack_size(8 << 20).spawn(run).unwrap().join().unwrap();
    }
}
