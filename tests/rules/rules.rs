//! Every rule of the list: recognised, stated as it is coded, right against quadrature, and right for any term it accepts.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::eval::{BoundedAlgebra, walk};
use sneddon::expr::normal::NormalTerm;
use sneddon::expr::{Bindings, Expr, shown};
use sneddon::num::Bounded;
use sneddon::transform::rules::{self, GENERAL, RULES};
use sneddon::transform::{Answer, Branches, Evaluator, Method, NumericProfile, Pair, Rule, Segment, Solution, Term};
use sneddon_checks::formulas::{bindings, derived, derived_with, formula, number, relative, value};
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;

/// Draws of the parameters for every rule.
const DRAWS: usize = 12;
/// Draws of the usual run.
fn draws() -> usize {
    cases(3, DRAWS)
}
/// Random terms made from the pattern of every rule.
fn terms() -> usize {
    cases(3, 60)
}
/// Shown and evaluated forms, statement and code agree to this at moderate arguments, where the plain forms cancel little.
const SAME: f64 = 1e-9;

/// Parameters of a rule's pattern, from the rule's own intervals.
fn draw(rule: &Rule, stream: &mut Stream) -> Vec<(&'static str, f64)> {
    rule.parameters.iter().map(|p| (p.name, stream.short(p.lowest, p.highest))).collect()
}

/// A contact radius well inside the profile and beyond its breakpoints, and radii below it.
fn places(evaluator: &Evaluator<'_>, stream: &mut Stream) -> (f64, f64) {
    let start = evaluator.breakpoints_below(f64::INFINITY).last().copied().unwrap_or(0.0);
    let end = if evaluator.limit().is_finite() { evaluator.limit() } else { 2.5 * start.max(1.0) };
    let a = stream.uniform(start + 0.1 * (end - start), start + 0.9 * (end - start));
    (a, a * stream.uniform(0.05, 0.95))
}

fn evaluator<'a>(solution: &'a Solution, values: &[(&str, f64)], method: Method) -> Evaluator<'a> {
    Evaluator::new(solution, &bindings(values), method, 1e-13).unwrap()
}

/// Every term of a rule's own pattern is answered by that rule and by no other, with symbols and with numbers.
#[test]
fn patterns_are_recognised_by_their_own_rule_only() {
    let mut stream = Stream::new(1);
    for rule in RULES {
        let mut solutions = vec![derived(rule.pattern)];
        for _ in 0..draws() {
            solutions.push(derived_with(rule.pattern, &draw(rule, &mut stream)));
        }
        for solution in &solutions {
            assert!(solution.terms().count() > 0, "{}: no terms", rule.id);
            for solved in solution.terms() {
                let found = solved.answer.as_ref().unwrap_or_else(|| panic!("{}: {:?} has no answer", rule.id, solved.term));
                assert_eq!(found.0.id, rule.id);
                let others = RULES.iter().filter(|other| ![rule.id, GENERAL.id].contains(&other.id) && Some(other.id) != rule.specializes);
                for other in others {
                    let also = (other.apply)(&solved.term).is_some() && other.specializes != Some(rule.id);
                    assert!(!also, "{} answers a term of {}", other.id, rule.id);
                }
            }
        }
    }
}

/// Names are unique, and a rule that specialises names one that exists.
#[test]
fn the_list_is_consistent() {
    for (index, rule) in RULES.iter().enumerate() {
        assert!(RULES.iter().skip(index + 1).all(|other| other.id != rule.id && other.title != rule.title));
        assert!(rule.specializes.is_none_or(|id| RULES.iter().any(|other| other.id == id)));
        assert!(!rule.reference.is_empty() && !rule.guard.is_empty());
        let names: Vec<&str> = rule.parameters.iter().map(|p| p.name).collect();
        let profile = derived(rule.pattern).profile;
        assert_eq!(profile.parameters().len(), names.len(), "{}: parameters", rule.id);
        assert!(profile.parameters().iter().all(|s| names.contains(&s.name())), "{}", rule.id);
    }
}

/// The code gives what the rule states in words of the grammar.
#[test]
fn code_is_the_stated_formula() {
    let mut stream = Stream::new(2);
    for rule in RULES {
        let solution = derived(rule.pattern);
        let (slope, force) = (formula(rule.equivalent), formula(rule.force));
        let pressure = rule.pressure.map(formula);
        for _ in 0..draws() {
            let parameters = draw(rule, &mut stream);
            let own = evaluator(&solution, &parameters, Method::Exact);
            for _ in 0..6 {
                let (a, r) = places(&own, &mut stream);
                let mut values = parameters.clone();
                values.extend([("E", 1.0), ("x", a), ("a", a), ("r", r)]);
                let same = |what: &str, code: f64, stated: f64| {
                    assert!(relative(code, stated) < SAME, "{}: {what} is {code:e}, stated {stated:e} at {values:?}", rule.id);
                };
                same("g", own.equivalent(a).unwrap().estimate.value, value(&slope, &values));
                same("F", 2.0 * own.force(a).unwrap().estimate.value, value(&force, &values));
                if let Some(pressure) = &pressure {
                    let code = own.pressure(r, a).unwrap().unwrap().estimate.value / std::f64::consts::PI;
                    same("p", code, value(pressure, &values));
                }
            }
        }
    }
}

/// The code gives what quadrature of the typed pattern gives, within the two error estimates.
#[test]
fn code_is_quadrature() {
    let mut stream = Stream::new(3);
    for rule in RULES {
        let solution = derived(rule.pattern);
        for _ in 0..cases(1, DRAWS) {
            let parameters = draw(rule, &mut stream);
            let exact = evaluator(&solution, &parameters, Method::Exact);
            let plain = evaluator(&solution, &parameters, Method::Quadrature);
            for _ in 0..cases(2, 4) {
                let (a, r) = places(&exact, &mut stream);
                for (what, one, two) in [
                    ("g", Some(exact.equivalent(a).unwrap()), Some(plain.equivalent(a).unwrap())),
                    ("F", Some(exact.force(a).unwrap()), Some(plain.force(a).unwrap())),
                    (
                        "p",
                        exact.pressure(r, a).ok().flatten(),
                        plain.pressure(r, a).unwrap_or_else(|e| panic!("{}: {e} at {r} < {a}", rule.id)),
                    ),
                ] {
                    let (Some(one), Some(two)) = (one, two) else {
                        assert_eq!(what, "p");
                        continue;
                    };
                    let difference = (one.estimate.value - two.estimate.value).abs();
                    let allowed = one.estimate.error + two.estimate.error;
                    assert!(difference <= allowed, "{}: {what}({r}, {a}) differs by {difference:e} > {allowed:e}", rule.id);
                    // Estimates that allow everything would prove nothing.
                    assert!(allowed <= 1e-9 * two.estimate.value.abs(), "{}: {what} is only known to {allowed:e}", rule.id);
                }
            }
        }
    }
}

fn branches(answer: &Answer) -> Vec<(&'static str, &Branches)> {
    [("g", Some(&answer.equivalent)), ("F", Some(&answer.force)), ("p", answer.pressure.as_ref())]
        .into_iter()
        .filter_map(|(name, b)| Some((name, b?)))
        .collect()
}

/// What a reader is shown equals what is evaluated, branch by branch.
fn hold_shown(rule: &Rule, answer: &Answer, segment: &Segment, values: &[(&str, f64)], stream: &mut Stream) {
    let lower = number(&segment.lower, values);
    let upper = segment.upper.as_ref().map(|c| number(c, values));
    for (what, branches) in branches(answer) {
        for beyond in [false, true] {
            let Pair { shown: plain, evaluated } = if beyond { &branches.beyond } else { &branches.within };
            let (start, end) = match (beyond, upper) {
                (true, Some(c)) => (1.2 * c, 3.0 * c),
                (false, Some(c)) => (lower + 0.4 * (c - lower), c),
                // Below the equator of a sphere, which the rules' intervals put above 3.
                _ => (1.2 * lower.max(0.3), (3.0 * lower.max(0.6)).min(3.1)),
            };
            let a = stream.uniform(start, end);
            let mut all = values.to_vec();
            all.extend([("x", a), ("a", a), ("r", a * stream.uniform(0.1, 0.9))]);
            let (one, two) = (number(&shown(plain), &all), number(evaluated, &all));
            assert!(relative(one, two) < SAME, "{}: {what} shown {one:e}, evaluated {two:e} for {plain:?} at {all:?}", rule.id);
        }
    }
}

#[test]
fn shown_is_evaluated() {
    let mut stream = Stream::new(4);
    for rule in RULES {
        let symbolic = derived(rule.pattern);
        for _ in 0..draws() {
            let values = draw(rule, &mut stream);
            let set = derived_with(rule.pattern, &values);
            for (solution, own) in [(&symbolic, &values[..]), (&set, &[])] {
                for solved in solution.terms() {
                    let (rule, answer) = solved.answer.as_ref().unwrap();
                    hold_shown(rule, answer, &solved.term.segment, own, &mut stream);
                }
            }
        }
    }
}

/// A rational with few digits and random sign.
fn coefficient(stream: &mut Stream) -> Expr {
    Expr::ratio(stream.whole(1, 40) * if stream.unit() < 0.5 { -1 } else { 1 }, stream.whole(1, 9))
}

fn segment(stream: &mut Stream) -> Segment {
    let lower = if stream.unit() < 0.3 { Expr::zero() } else { Expr::ratio(stream.whole(1, 30), 10) };
    let upper = (stream.unit() < 0.6).then(|| &lower + Expr::ratio(stream.whole(1, 30), 10));
    Segment { lower, upper }
}

/// A term of the rule's own pattern, and what becomes of it by other coefficients, exponents, signs and segments.
fn term(rule: &Rule, stream: &mut Stream) -> Term {
    let solution = derived_with(rule.pattern, &draw(rule, stream));
    let terms: Vec<Term> = solution.terms().map(|solved| solved.term.clone()).collect();
    let mut term = stream.pick(&terms).clone();
    if stream.unit() < 0.3 {
        return term;
    }
    for part in &mut term.parts {
        part.coefficient = coefficient(stream);
        if stream.unit() < 0.4 {
            part.exponent = &part.exponent + Expr::integer(stream.whole(-1, 4));
        }
        if stream.unit() < 0.2 {
            part.kernel = mutated(&part.kernel, stream);
        }
    }
    if stream.unit() < 0.4 {
        term.segment = segment(stream);
    }
    term
}

/// A kernel like this one with another power or another sign of r².
fn mutated(kernel: &Expr, stream: &mut Stream) -> Expr {
    let r = Expr::symbol("r");
    let (base, exponent) = kernel.split_power();
    match stream.whole(0, 2) {
        0 => base.pow(&(exponent + Expr::ratio(stream.whole(-2, 2), 2))),
        1 => Bindings::one("r", r.power(2)).apply(kernel),
        _ => (base + coefficient(stream) * r).pow(&exponent),
    }
}

/// The evaluated answer with its running error bound.
fn bounded(expr: &Expr, values: &[(&str, f64)]) -> Bounded {
    walk(expr, &mut BoundedAlgebra, &mut |s| values.iter().find(|(n, _)| *n == s.name()).map(|(_, v)| Bounded::exact(*v))).unwrap()
}

/// Whatever a rule accepts, it answers rightly; this catches guards that are too wide.
#[test]
fn any_term_that_a_rule_accepts_is_right() {
    let mut stream = Stream::new(5);
    let mut answered = vec![(0, 0); RULES.len()];
    for (_, source) in (0..terms()).flat_map(|round| RULES.iter().map(move |rule| (round, rule))) {
        let term = term(source, &mut stream);
        let Some((rule, answer)) = rules::answer(&term) else { continue };
        let count = &mut answered[RULES.iter().position(|own| own.id == rule.id).unwrap()];
        let numeric = NumericProfile::new(&[(term.segment.clone(), term.f_prime())], &Bindings::default()).unwrap();
        let upper = term.segment.upper.as_ref().map_or(f64::INFINITY, |c| number(c, &[]));
        let lower = number(&term.segment.lower, &[]);
        for _ in 0..cases(2, 3) {
            // Numbers with few bits, so that the walk and the quadrature mean the same point.
            let a = stream.short(lower + 0.01, if upper.is_finite() { 1.8 * upper } else { lower + 4.0 });
            let r = stream.short(0.05 * a, 0.97 * a);
            let values = [("x", a), ("a", a), ("r", r)];
            // Beyond a pole there is no integral, whatever the quadrature makes of it.
            let base = |part: &NormalTerm| part.kernel.split_power().0;
            if term.parts.iter().map(base).any(|q| q.terms().len() > 1 && number(&q, &[("r", a.min(upper))]) <= 0.0) {
                continue;
            }
            let pick = |branches: &Branches| if a > upper { branches.beyond.clone() } else { branches.within.clone() };
            let Ok(slope) = numeric.equivalent(a, 1e-12) else { continue };
            let mut pairs = vec![("g", pick(&answer.equivalent), slope), ("F", pick(&answer.force), numeric.force(a, 1e-12).unwrap())];
            if let (Some(branches), Ok(Some(found))) = (&answer.pressure, numeric.pressure(r, a, 1e-12)) {
                pairs.push(("p", pick(branches), found));
            }
            for (what, pair, plain) in pairs {
                let closed = bounded(&pair.evaluated, &values);
                // Beyond its series the general rule may have no number.
                if rule.id == GENERAL.id && closed.value.is_nan() {
                    continue;
                }
                let (difference, allowed) = ((closed.value - plain.value).abs(), closed.error + plain.error);
                assert!(difference <= allowed, "{}: {what} at {values:?} of {term:?}: {} against {}", rule.id, closed.value, plain.value);
                // Only a sharp comparison counts.
                if allowed <= 1e-9 * plain.value.abs() {
                    *(if what == "p" { &mut count.1 } else { &mut count.0 }) += 1;
                }
            }
        }
    }
    let (mut blunt, mut blunt_pressures) = (0, 0);
    for (rule, (count, pressures)) in RULES.iter().zip(answered) {
        blunt += u32::from(count == 0);
        blunt_pressures += u32::from(pressures == 0 && rule.pressure.is_some());
        assert!(count >= cases(0, terms() / 2), "{}: only {count} sharp values", rule.id);
        assert!(pressures >= cases(0, terms() / 6) || rule.pressure.is_none(), "{}: only {pressures} pressures", rule.id);
    }
    // With three draws, some rules may have no comparison sharp enough to count; the pressures of worn roots close for the lowest orders.
    assert!(blunt <= 2 && blunt_pressures <= 2, "{blunt} {blunt_pressures}");
}

/// What no rule may answer: exponents without a finite profile, roots of another sign or degree.
#[test]
fn terms_without_a_solution_are_declined() {
    let r = Expr::symbol("r");
    let kernel = |kernel: Expr, exponent: i64| Term {
        parts: vec![NormalTerm { coefficient: Expr::one(), exponent: Expr::integer(exponent), kernel }],
        segment: Segment::whole(),
    };
    let root = |base: Expr| base.pow(&Expr::ratio(-1, 2));
    for term in [
        kernel(Expr::one(), -1),
        kernel(Expr::one(), -3),
        kernel(Expr::call("ln", [r.clone()]), -1),
        kernel(Expr::call("ln", [Expr::one() + &r]), 2),
        kernel(root(Expr::one() + &r + r.power(2)), 1),
        kernel(root(Expr::integer(-1) - r.power(2)), 1),
        kernel(root(Expr::integer(-1) + r.power(2)), 1),
        kernel((Expr::integer(-1) + r.power(2)).recip(), 1),
        kernel((Expr::one() + &r + r.power(2)).sqrt().recip(), 2),
        kernel(Expr::call("exp", [r.power(2) + &r]), 1),
        kernel((Expr::one() + &r).pow(&r), 1),
        kernel((Expr::one() + r.power(2)).pow(&(&r - Expr::one())), 2),
        kernel(Expr::call("exp", [-&r]) * Expr::call("cos", [r.clone()]), 1),
        kernel(Expr::call("sin", [&r + Expr::one()]), 1),
        kernel(Expr::call("cos", [r.clone()]), -1),
        kernel(Expr::call("sin", [r.clone()]).recip(), 1),
        kernel(Expr::call("erf", [r.clone()]) * Expr::call("exp", [-r.power(2)]), 1),
        kernel(Expr::call("erf", [r.clone()]) * Expr::call("exp", [Expr::integer(2) * r.power(2)]), 1),
        kernel(Expr::call("besselj", [Expr::zero(), r.clone()]), -1),
        kernel(Expr::call("besselj", [Expr::zero(), r.clone()]) * Expr::call("besselj", [Expr::one(), Expr::integer(2) * &r]), 0),
        // The series has a radius of convergence that the kernel itself has not.
        kernel((Expr::one() + &r).pow(&Expr::ratio(-1, 3)), 1),
        kernel(Expr::call("atan", [r.pow(&Expr::ratio(1, 2))]), 1),
        kernel(Expr::call("tanh", [r.clone()]), 1),
        kernel((Expr::integer(3) - &r).pow(&r.power(2)), 1),
        kernel(Expr::call("besselj", [r.clone(), r.power(4)]), 1),
    ] {
        let found = rules::answer(&term).map(|(rule, _)| rule.id);
        assert_eq!(found, None, "{term:?}");
    }
}

/// Where the general rule would answer a term of another one, it agrees with that.
#[test]
fn the_general_rule_agrees_with_every_other() {
    let mut stream = Stream::new(6);
    let mut compared = 0;
    for (rule, round) in RULES.iter().flat_map(|rule| (0..draws()).map(move |round| (rule, round))) {
        let solution = derived_with(rule.pattern, &draw(rule, &mut stream));
        for solved in solution.terms() {
            let (Some((own, answer)), Some(general)) = (&solved.answer, (GENERAL.apply)(&solved.term)) else { continue };
            let a = stream.uniform(0.1, 1.2);
            let values = [("x", a), ("a", a)];
            for (what, one, two) in [("g", &answer.equivalent, &general.equivalent), ("F", &answer.force, &general.force)] {
                let (one, two) = (number(&one.within.evaluated, &values), number(&two.within.evaluated, &values));
                // Beyond its series the general form may have no number.
                if two.is_finite() {
                    assert!(
                        relative(one, two) < SAME,
                        "{} {round}: {what} is {one:e}, in general {two:e} at {a} of {:?}",
                        own.id,
                        solved.term
                    );
                    compared += usize::from(own.id != GENERAL.id);
                }
            }
        }
    }
    assert!(compared >= 4 * draws(), "{compared}");
}

/// With a symbol in the exponent or under the root, what the answer needs is a condition.
#[test]
fn unknown_signs_become_conditions() {
    let conditions = |text: &str| derived(text).conditions.len();
    assert_eq!(conditions("C*r^3"), 0);
    assert!(conditions("h*(sqrt(b-c+r^2)-sqrt(b-c))") > 0);
    assert_eq!(conditions("h*(sqrt(b^2+r^2)-b)"), 0);
}
