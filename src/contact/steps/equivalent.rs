//! From f to g: the slope, its terms, the rule of each term, and their sum.

use super::Step;
use crate::contact::Relations;
use crate::expr::{Bindings, Condition, Expr, Formula, Relation, Symbol};
use crate::print::Prose;
use crate::transform::{Answer, Rule, Segment, Solution, SolvedTerm, TransformError, rules};

/// Profiles with at least this many terms are not shown term by term.
const MANY: usize = 12;

pub(super) fn steps(typed: &Formula, solution: &Solution, relations: &Relations) -> Result<Vec<Step>, TransformError> {
    let terms = sloped_terms(solution);
    let split = match terms.len() {
        0 => Prose::words("The slope vanishes, and so does the integral"),
        1 => Prose::words("Definition of the equivalent profile; the slope is a single term"),
        count => Prose::words(&format!(
            "Definition of the equivalent profile; the integral is linear in the slope, so that each of its {count} terms is transformed by itself"
        )),
    };
    let name = bound_name(solution);
    let parts =
        if terms.len() > MANY { Vec::new() } else { terms.iter().enumerate().map(|(at, own)| term(at, terms.len(), own, name)).collect() };
    let mut list = vec![
        shape(typed, solution),
        Step::new("Slope", "f'(r)", f_prime(solution)?, Prose::words("Differentiated piece by piece")),
        Step::new("Equivalent profile", "g(x)", definition(), split).from(&["Popov & Heß (3.27)"]).with(parts),
    ];
    if terms.len() != 1 || terms.iter().any(|own| !own.term.segment.is_whole()) {
        let added = Prose::words("The contributions are added; the contact radius is the same for all of them");
        list.push(Step::new("Sum", "g(x)", relations.g.formula.clone(), added).from(&["Popov & Heß (3.18)–(3.19), (3.25)–(3.26)"]));
    }
    Ok(list)
}

/// f(r), as it was typed.
pub(super) fn shape(typed: &Formula, solution: &Solution) -> Step {
    let shift = &solution.profile.shift;
    let start = if shift.is_zero() {
        Prose::read("The shape as it was typed, with $f(0)$ = 0")
    } else {
        Prose::read("The shape as it was typed; a contact does not see the constant $f(0)$ = ")
            .formula(shift.clone())
            .then(", which is subtracted")
    };
    Step::new("Shape", "f(r)", typed.clone(), start)
}

/// g(x) = x ∫₀^x f′(r)/√(x² − r²) dr.
pub(super) fn definition() -> Formula {
    x_times(over("r", Expr::symbol("f'(r)"), root("x", "r"), Expr::zero(), Expr::symbol("x")))
}

/// The terms of f′ that are not 0.
pub(super) fn sloped_terms(solution: &Solution) -> Vec<&SolvedTerm> {
    solution.terms().filter(|own| !own.term.f_prime().is_zero()).collect()
}

/// f′ of all chains together.
pub(super) fn f_prime(solution: &Solution) -> Result<Formula, TransformError> {
    let mut parts = Vec::new();
    for chain in &solution.profile.chains {
        let mut f_primes: Vec<Formula> = chain.f_primes()?.into_iter().map(Formula::Closed).collect();
        let Some(last) = f_primes.pop() else { continue };
        let pieces: Vec<(Formula, Expr)> = f_primes.into_iter().zip(chain.breakpoints.iter().cloned()).collect();
        parts.push(if pieces.is_empty() { last } else { Formula::Piecewise { variable: Symbol::new("r"), pieces, last: Box::new(last) } });
    }
    Ok(Formula::sum(parts))
}

fn term(at: usize, count: usize, solved: &SolvedTerm, name: &'static str) -> Step {
    let segment = &solved.term.segment;
    let (title, left, slope_name) = if count == 1 {
        ("The term".to_owned(), "g(x)".to_owned(), "f'(r)".to_owned())
    } else {
        (format!("Term {} of {count}", at + 1), format!("g_{}(x)", at + 1), format!("f_{}'(r)", at + 1))
    };
    let step = Step::new(&title, &slope_name, Formula::Closed(solved.term.f_prime()), place(segment));
    let Some((rule, answer)) = &solved.answer else {
        let open = x_times(over("r", solved.term.f_prime(), root("x", "r"), segment.lower.clone(), Expr::symbol("x")));
        let why = Prose::words("No rule has a closed form of this term, so that it stays the integral; numbers come from quadrature of it");
        return step.with(vec![Step::new("Integral", &left, open, within(segment, why))]);
    };
    let mut steps = Vec::new();
    if let Some(substituted) = substituted(solved, name) {
        let radius = Expr::symbol("x") * Expr::call("sin", [Expr::symbol(name)]);
        let why = Prose::words("The substitution ")
            .condition(Condition::equal(Expr::symbol("r"), radius))
            .then(", in which $dd r$ = ")
            .formula(root("x", "r"))
            .then(&format!(" $dd {name}$"));
        steps.push(Step::new("Substitution", &left, substituted, within(segment, why)).from(&["Popov & Heß (3.27)"]));
    }
    steps.extend(constant(solved, rule));
    steps.push(Step::new("Integral", &left, shown(answer, false), within(segment, by_rule(rule, answer))).from(rule.reference));
    if let Some(upper) = &segment.upper {
        let beyond = Prose::words("For ")
            .condition(Condition::less(upper.clone(), Expr::symbol("x")))
            .then(": the integral ends at the end of the segment");
        steps.push(Step::new("Beyond the segment", &left, shown(answer, true), beyond).from(rule.reference));
    }
    step.with(steps)
}

fn shown(answer: &Answer, beyond: bool) -> Formula {
    Formula::Closed(if beyond { answer.equivalent.beyond.shown.clone() } else { answer.equivalent.within.shown.clone() })
}

fn by_rule(rule: &Rule, answer: &Answer) -> Prose {
    let mut reason = Prose::words(&format!("{}, by the verified statement of the rule {}", rule.title, rule.id));
    for (place, condition) in answer.conditions.iter().enumerate() {
        reason = reason.then(if place == 0 { ", where " } else { " and " }).condition(condition.clone());
    }
    reason
}

/// κ_n, if the rule is `heß-power`.
fn constant(solved: &SolvedTerm, rule: &Rule) -> Option<Step> {
    if rule.id != "heß-power" {
        return None;
    }
    let n = &solved.term.single()?.exponent + Expr::one();
    let t = Expr::symbol("t");
    let integral = over("t", Expr::call("sin", [t]).pow(&(&n - Expr::one())), Expr::one(), Expr::zero(), Expr::pi() / Expr::integer(2));
    let value = rules::kappa(&n);
    let name = match (n.as_integer(), n.as_symbol()) {
        (Some(n), _) => format!("kappa_{n}"),
        (_, Some(symbol)) => format!("kappa_{}", symbol.name()),
        _ => "kappa".to_owned(),
    };
    let m = Expr::symbol("n");
    let half = |numerator: i64| (&m + Expr::integer(numerator)) / Expr::integer(2);
    let in_general = Expr::pi().sqrt() * Expr::call("gamma", [half(2)]) / Expr::call("gamma", [half(1)]);
    let why = Prose::read(&format!("${name}$ = "))
        .formula(integral.scaled(&n))
        .then("; for every exponent the Gamma function gives $kappa_n$ = ")
        .formula(in_general);
    Some(Step::new("Constant of the power", &name, Formula::Closed(value), why).from(&["Popov & Heß (3.16)–(3.17)"]))
}

fn place(segment: &Segment) -> Prose {
    let r = Expr::symbol("r");
    match (&segment.upper, segment.lower.is_zero()) {
        (None, true) => Prose::words("On the whole axis"),
        (None, false) => Prose::words("For ").condition(less_or_equal(segment.lower.clone(), r)).then(", 0 below"),
        (Some(upper), true) => Prose::words("For ").condition(Condition::less(r, upper.clone())).then(", 0 beyond"),
        (Some(upper), false) => Prose::words("For ")
            .condition(less_or_equal(segment.lower.clone(), r.clone()))
            .then(" and ")
            .condition(Condition::less(r, upper.clone()))
            .then(", 0 elsewhere"),
    }
}

fn within(segment: &Segment, reason: Prose) -> Prose {
    let x = Expr::symbol("x");
    let reason =
        if segment.lower.is_zero() { reason } else { reason.then("; for ").condition(Condition::less(segment.lower.clone(), x.clone())) };
    match &segment.upper {
        Some(upper) => reason.then(if segment.lower.is_zero() { "; for " } else { " and " }).condition(less_or_equal(x, upper.clone())),
        None => reason,
    }
}

fn less_or_equal(left: Expr, right: Expr) -> Condition {
    Condition { left, relation: Relation::LessOrEqual, right }
}

/// x ∫ f′(x sin t) dt from asin(b/x) to π/2, for x within the segment.
fn substituted(solved: &SolvedTerm, name: &'static str) -> Option<Formula> {
    let (x, t) = (Expr::symbol("x"), Expr::symbol(name));
    let radius = &x * Expr::call("sin", [t]);
    let f_prime = Bindings::one("r", radius).apply(&solved.term.f_prime());
    let lower = &solved.term.segment.lower;
    let start = if lower.is_zero() { Expr::zero() } else { Expr::call("asin", [lower / &x]) };
    Some(x_times(over(name, f_prime, Expr::one(), start, Expr::pi() / Expr::integer(2))))
}

/// √(one² − other²).
fn root(one: &str, other: &str) -> Expr {
    (Expr::symbol(one).power(2) - Expr::symbol(other).power(2)).sqrt()
}

/// ∫ upper/lower.
fn over(variable: &str, above: Expr, below: Expr, lower: Expr, upper: Expr) -> Formula {
    Formula::Integral { integrand: Box::new(Formula::Closed(above / below)), variable: Symbol::new(variable), lower, upper }
}

fn x_times(formula: Formula) -> Formula {
    formula.scaled(&Expr::symbol("x"))
}

/// A name for the angle that is not a parameter.
fn bound_name(solution: &Solution) -> &'static str {
    let taken = solution.profile.parameters();
    ["t", "tau", "varphi", "t_0", "t_1"].into_iter().find(|name| !taken.iter().any(|own| own.name() == *name)).unwrap_or("t_bound")
}
