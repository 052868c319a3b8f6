//! The inverse transform: every statement of the table and every rule's g read backwards, against quadrature and against the rule itself.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::expr::{Bindings, Expr, Formula};
use sneddon::parse;
use sneddon::transform::rules::RULES;
use sneddon::transform::{
    Evaluator, Inverse, InverseNumbers, Method, Parameter, Status, TABLE, TransformError, check_inverse, equivalent_of_pressure, invert,
};
use sneddon_checks::formulas::{bindings, derived_with, formula, relative, value};
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::{cases, takes};

const DRAWS: usize = 4;

fn read(text: &str) -> Option<Formula> {
    parse::formula(text).ok()
}

fn inverted(g: &Formula) -> Inverse {
    invert(g, read).unwrap_or_else(|error| panic!("{g:?}: {error}"))
}

fn of(text: &str) -> Inverse {
    inverted(&parse::equivalent(text).unwrap())
}

fn draw(parameters: &[Parameter], stream: &mut Stream) -> Vec<(&'static str, f64)> {
    parameters.iter().map(|p| (p.name, stream.short(p.lowest, p.highest))).collect()
}

fn numbers(inverse: &Inverse, values: &[(&str, f64)], method: Method) -> InverseNumbers {
    InverseNumbers::new(inverse, &bindings(values), method, 1e-13).unwrap()
}

/// Every entry of the table: exact, equal to its statement, equal to quadrature, and undone by the transform.
#[test]
fn the_table_is_right() {
    let mut stream = Stream::new(11);
    for rule in TABLE {
        let (Some(pattern), Some(result)) = (read(rule.pattern), read(rule.result)) else {
            // Until its functions have rows.
            continue;
        };
        let symbolic = inverted(&pattern);
        assert_eq!(symbolic.profile().status, Status::Exact, "{}", rule.id);
        assert!(check_inverse(&symbolic).unwrap().passed(), "{}", rule.id);
        for _ in 0..DRAWS {
            let values = draw(rule.parameters, &mut stream);
            let set = inverted(&pattern.substitute(&bindings(&values)));
            assert_eq!(set.profile().status, Status::Exact, "{} at {values:?}", rule.id);
            let plain = numbers(&symbolic, &values, Method::Quadrature);
            for _ in 0..4 {
                let r = stream.short(0.1, 3.0);
                let mut all = values.clone();
                all.push(("r", r));
                let stated = value(&result, &all);
                let other = plain.value(r).unwrap().estimate;
                assert!((stated - other.value).abs() <= 1e-9 * other.value.abs(), "{}: {stated:e}, {other:?} at {all:?}", rule.id);
                for own in [numbers(&symbolic, &values, Method::Exact), numbers(&set, &[], Method::Auto)] {
                    let own = own.value(r).unwrap().estimate;
                    let allowed = own.error + other.error;
                    assert!((own.value - other.value).abs() <= allowed, "{}: {own:?}, {other:?} at {all:?}", rule.id);
                }
            }
        }
    }
}

/// f of the g of every rule is the rule's pattern.
#[test]
fn every_rule_reads_backwards() {
    let mut stream = Stream::new(12);
    let mut exact = 0;
    for (index, rule) in RULES.iter().enumerate().step_by(cases(3, 1)) {
        let slope = formula(rule.equivalent);
        for _ in 0..cases(1, 2) {
            let values = draw(rule.parameters, &mut stream);
            let inverse = inverted(&slope.substitute(&bindings(&values)));
            exact += usize::from(inverse.profile().status == Status::Exact);
            let (own, shape) = (numbers(&inverse, &[], Method::Auto), derived_with(rule.pattern, &values));
            let evaluator = Evaluator::new(&shape, &Bindings::default(), Method::Auto, 1e-13).unwrap();
            for _ in 0..cases(1, 3) {
                let r = stream.short(0.1, 3.0);
                let (found, f) = (
                    own.value(r).unwrap_or_else(|error| panic!("{}: {error} at {r}, {values:?}", rule.id)).estimate,
                    evaluator.height(r).unwrap().estimate,
                );
                // The parameters inside g are rounded where the pattern's formula is not.
                let allowed = found.error + f.error + 1e-13 * f.value.abs();
                assert!((found.value - f.value).abs() <= allowed, "{}: {found:?}, {f:?} at r = {r}, {values:?}", rule.id);
            }
        }
        // With symbols as well: what is claimed to be exact passes the check, which takes up to three seconds.
        if takes(index, 24) {
            let symbolic = inverted(&slope);
            let exact = symbolic.profile().status == Status::Exact;
            assert!(!exact || check_inverse(&symbolic).unwrap().passed(), "{}", rule.id);
        }
    }
    assert!(cases(6, 1) * exact >= RULES.len(), "only {exact} are exact");
}

#[test]
fn what_a_careful_author_writes() {
    for (g, f) in [
        ("x^2/R", "r^2/(2*R)"),
        ("pi/2*x*tan(theta)", "r*tan(theta)"),
        ("C*x^n", "C*r^n*gamma(n/2 + 1/2)/(sqrt(pi)*gamma(n/2 + 1))"),
        ("x*atanh(x/R)", "R - sqrt(R^2 - r^2)"),
        ("h*(1-cos(k*x))", "h*(1 - besselj(0, k*r))"),
        ("C*pi/2*x/sqrt(w^2+x^2)", "C*atan(r/w)"),
        ("h*x^2/(w^2+x^2)", "h*(1 - 1/sqrt(1 + r^2/w^2))"),
        ("3+x^4", "3/8*r^4 + 3"),
        ("piecewise(0, x<b, x*sqrt(x^2-b^2)/R)", "piecewise(0, r < b, (r^2 - b^2)/(2*R))"),
    ] {
        let found = of(g).profile();
        assert_eq!(found.status, Status::Exact, "{g}");
        // Short where it is known to be short, equal everywhere.
        let text = sneddon::print::text(&found.formula);
        let values = [("r", 0.7), ("R", 2.5), ("theta", 0.4), ("C", 1.3), ("n", 1.7), ("h", 0.6), ("k", 1.1), ("w", 0.9), ("b", 0.3)];
        let (one, two) = (value(&found.formula, &values), value(&formula(f), &values));
        assert!(relative(one, two) < 1e-13, "{g}: {text}");
        assert!(text.len() <= f.len() + 12, "{g}: {text}");
    }
}

/// The constant is kept, stated, and does not come back from the profile.
#[test]
fn a_constant_is_its_own_inverse() {
    let inverse = of("c+x");
    assert_eq!(*inverse.at_axis(), Expr::symbol("c"));
    let own = numbers(&inverse, &[("c", 2.0)], Method::Auto);
    assert_eq!(own.value(0.0).unwrap().estimate.value, 2.0);
    assert!(relative(own.value(1.0).unwrap().estimate.value, 2.0 + 2.0 / std::f64::consts::PI) < 1e-15);
}

/// Without a formula the numbers come from quadrature, with kinks known and errors that hold.
#[test]
fn quadrature_answers_where_no_rule_does() {
    let open = of("exp(sin(x))-1");
    assert_ne!(open.profile().status, Status::Exact);
    assert!(matches!(numbers(&open, &[], Method::Exact).value(1.0), Err(TransformError::NoClosedForm { .. })));
    // mpmath: 2/pi*quad(lambda t: exp(sin(sin(t)))-1, [0, pi/2])
    let found = numbers(&open, &[], Method::Auto).value(1.0).unwrap().estimate;
    assert!((found.value - 0.820_298_995_690_800_4).abs() <= found.error, "{found:?}");
    assert!(found.error < 1e-12);
    // A kink that no rule knows.
    let kinked = of("abs(x-1/2)*exp(-x^3)");
    let own = numbers(&kinked, &[], Method::Auto);
    let found = own.value(2.0).unwrap().estimate;
    assert!((found.value - 0.088_101_327_295_928_72).abs() <= found.error, "{found:?}");
    assert!(found.error < 1e-11);
}

#[test]
fn what_is_no_equivalent_profile() {
    for text in ["1/x", "ln(x)", "piecewise(0, x<b, 1)"] {
        let g = parse::equivalent(text).unwrap();
        let error = invert(&g, read).map(|_| ()).unwrap_err();
        assert!(matches!(error, TransformError::SingularAtAxis { .. } | TransformError::Jump { .. }), "{text}: {error}");
    }
}

/// p → g → p, and the force under it.
#[test]
fn a_wanted_pressure_is_reached() {
    let one = |text: &str| equivalent_of_pressure(&parse::pressure(text).unwrap());
    let mut stream = Stream::new(13);
    for text in
        ["p_0*sqrt(1-r^2/a^2)", "p_0*(1-r^2/a^2)^(3/2)+q*sqrt(a^2-r^2)", "p_0*r^2*sqrt(a^2-r^2)", "p_0*(a^2-r^2)", "p_0*(1-r^4/a^4)"]
    {
        let found = one(text).unwrap();
        let values =
            [("p_0", stream.short(0.5, 2.0)), ("q", stream.short(0.5, 2.0)), ("a", stream.short(0.5, 2.0)), ("E", stream.short(1.0, 3.0))];
        let (a, modulus) = (values[2].1, values[3].1);
        let shape = inverted(&Formula::Closed(found.equivalent.clone()));
        let f = Formula::Closed(found.equivalent.clone());
        // p(r) = (E/π) ∫_r^a g′/√(x²−r²) dx, by the substitution x² = r² + (a²−r²) s² in 2000 midpoints.
        let slope = f.derivative(&sneddon::expr::Symbol::new("x")).unwrap();
        let r = 0.6 * a;
        let mut all = values.to_vec();
        all.extend([("r", r), ("x", 0.0)]);
        let wanted = value(&formula(text), &all);
        let (width, mut total) = ((a * a - r * r).sqrt(), 0.0);
        for i in 0..2000 {
            let s = (f64::from(i) + 0.5) / 2000.0;
            // s = 1 − u² resolves the root of g′ at the edge.
            let (y, weight) = (width * (1.0 - s * s), width * 2.0 * s);
            let x = (r * r + y * y).sqrt();
            all.push(("x", x));
            total += value(&slope, &all) / x * weight / 2000.0;
            all.pop();
        }
        assert!(relative(modulus / std::f64::consts::PI * total, wanted) < 1e-5, "{text}");
        // F = 2E(a d − ∫₀^a g dx) and d = g(a) where the pressure vanishes at the edge.
        all.push(("x", a));
        assert!(relative(value(&f, &all), value(&Formula::Closed(found.depth.clone()), &all)) < 1e-12, "{text}");
        assert!(shape.at_axis().is_zero(), "{text}");
    }
    // The flat punch: p = F/(2π a √(a²−r²)), d = F/(2 E a), f = 0.
    let flat = one("F_0/(2*pi*a*sqrt(a^2-r^2))").unwrap();
    assert!(flat.equivalent.is_zero());
    assert_eq!(sneddon::print::text_expr(&flat.force), "F_0");
    assert_eq!(sneddon::print::text_expr(&flat.depth), "F_0/(2*E*a)");
    for text in ["p_0*exp(-r^2)", "p_0*r", "p_0/(a^2-r^2)", "p_0*sqrt(1-r^2)"] {
        assert!(matches!(one(text), Err(TransformError::NoProfileForPressure { .. })), "{text}");
    }
}

/// An argument outside the domain of its function at the axis is an error, whatever its form away from it.
#[test]
fn what_is_not_real_at_the_axis_is_refused() {
    for kernel in ["atanh(x/R - 9)", "asin(x - 8)", "acos(2 + x^2)", "ln(x/R - 8)", "sqrt(x - 8)", "acosh(x/R)"] {
        let (g, f) = (format!("x*{kernel}"), format!("r*{}", kernel.replace('x', "r")));
        let inverse = invert(&parse::equivalent(&g).unwrap(), read);
        assert!(matches!(inverse, Err(TransformError::NotReal { .. })), "{g}");
        let derived = sneddon::transform::Profile::new(&parse::profile(&f).unwrap());
        assert!(matches!(derived, Err(TransformError::NotReal { .. })), "{f}");
    }
}
