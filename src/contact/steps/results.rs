//! From g to depth, force, pressure, stiffness, and the relations in terms of the depth.

use super::Step;
use crate::contact::{Edge, Relations, explicit};
use crate::expr::{Expr, Formula, Symbol, derivative, shown};
use crate::print::Prose;
use crate::transform::{Derived, Solution};

pub(super) fn steps(solution: &Solution, edge: &Edge, relations: &Relations) -> Vec<Step> {
    let mut list = vec![depth(edge, relations), force(edge, relations)];
    list.push(pressure(edge, relations));
    let why = match edge {
        Edge::Smooth => {
            "An increment of depth acts as a flat punch of radius $a$, whatever the shape, so that $dd F/dd a$ = 2$E$ $a$ $dd d/dd a$"
        }
        Edge::Rim(_) => "The contact radius equals the radius of the rim at every depth",
    };
    list.push(Step::new("Stiffness", "k(a)", relations.stiffness.formula.clone(), Prose::read(why)).from(&relations.stiffness.reference));
    if *edge == Edge::Smooth {
        list.extend(solved(solution, relations));
    }
    list.push(validity(relations));
    list
}

/// The conditions of validity.
pub(super) fn validity(relations: &Relations) -> Step {
    let mut conditions = Prose::words("Conditions: ");
    for (place, own) in relations.conditions.iter().enumerate() {
        conditions = conditions.then(if place == 0 { "" } else { "; " }).followed_by(own);
    }
    Step::remark("Validity", conditions)
}

/// d(a) = g(a), or the depth that is given under a rim.
pub(super) fn depth(edge: &Edge, relations: &Relations) -> Step {
    let d = relations.d.formula.clone();
    match edge {
        Edge::Smooth => Step::new(
            "Depth",
            "d(a)",
            d,
            Prose::read("A smooth edge leaves no stress at $r$ = $a$: the outermost spring is just touched, $d$ = $g(a)$"),
        )
        .from(&["Popov & Heß (3.26)"]),
        Edge::Rim(_) => Step::new("Depth", "d", d, Prose::read("The rim fixes $a$, and the depth is free")).from(&["Popov & Heß (3.61)"]),
    }
}

fn force(edge: &Edge, relations: &Relations) -> Step {
    let by_parts = integral(Expr::symbol("x") * Expr::symbol("g'(x)"), "x", Expr::zero(), Expr::symbol("a"));
    let mut steps = Vec::new();
    if *edge == Edge::Smooth {
        steps.push(Step::new(
            "By parts",
            "F(a)",
            by_parts.scaled(&(Expr::integer(2) * Expr::symbol("E"))),
            Prose::read("The boundary term vanishes, because $d$ = $g(a)$"),
        ));
    }
    steps.push(
        Step::new("Result", "F(a)", relations.force.formula.clone(), Prose::words("The terms are integrated one by one"))
            .from(&relations.force.reference),
    );
    let why = Prose::read("Every spring between −$a$ and $a$ is compressed by $d$ − $g(x)$, and $g$ is even");
    Step::new("Force", "F(a)", force_definition(edge), why).from(&["Popov & Heß (3.7), (3.22)"]).with(steps)
}

/// F = 2E ∫₀^a (d − g(x)) dx.
pub(super) fn force_definition(edge: &Edge) -> Formula {
    let d = Expr::symbol(if *edge == Edge::Smooth { "d(a)" } else { "d" });
    let compressed = integral(d - Expr::symbol("g(x)"), "x", Expr::zero(), Expr::symbol("a"));
    compressed.scaled(&(Expr::integer(2) * Expr::symbol("E")))
}

/// The reason why p(r) may have no formula.
pub(super) const NO_PRESSURE: &str = "$g$ may jump where $f'(r)$ is infinite: $p(r)$ has no formula here";

fn pressure(edge: &Edge, relations: &Relations) -> Step {
    let mut steps = Vec::new();
    if let Some(g_prime) = relations.g.formula.as_closed().and_then(|g| derivative(&shown(g), &Symbol::new("x")).ok()) {
        steps.push(Step::new("Slope of the equivalent profile", "g'(x)", Formula::Closed(g_prime), Prose::words("Differentiated")));
    }
    match &relations.pressure {
        Some(found) => steps.push(
            Step::new("Result", "p(r)", found.formula.clone(), Prose::read("For $r$ < $a$; the pressure vanishes outside"))
                .from(&found.reference),
        ),
        None => steps.push(Step::remark("Result", Prose::read(NO_PRESSURE))),
    }
    let why = match edge {
        Edge::Smooth => "The line load of the foundation is transformed back; its end vanishes under a smooth edge",
        Edge::Rim(_) => "The line load of the foundation is transformed back; the last term is due to its step at the rim",
    };
    Step::new("Pressure", "p(r)", pressure_definition(edge), Prose::words(why)).from(&["Popov & Heß (3.37)"]).with(steps)
}

/// p(r) = E/π ∫_r^a g′(x)/√(x² − r²) dx, and under a rim E (d − g(a))/(π √(a² − r²)) as well.
pub(super) fn pressure_definition(edge: &Edge) -> Formula {
    let (x, r, a) = (Expr::symbol("x"), Expr::symbol("r"), Expr::symbol("a"));
    let factor = Expr::symbol("E") / Expr::pi();
    let root = (x.power(2) - r.power(2)).sqrt();
    let smooth = integral(Expr::symbol("g'(x)") / root, "x", r.clone(), a.clone()).scaled(&factor);
    if *edge == Edge::Smooth {
        return smooth;
    }
    let excess = Expr::symbol("d") - Expr::symbol("g(a)");
    Formula::sum([smooth, Formula::Closed(factor * excess / (a.power(2) - r.power(2)).sqrt())])
}

/// a(d) and F(d), if g(a) = d can be solved.
fn solved(solution: &Solution, relations: &Relations) -> Vec<Step> {
    let (Some(radius), Some(force)) = (&relations.contact_radius_of_depth, &relations.force_of_depth) else {
        return vec![unsolved()];
    };
    let steps = vec![Step::new("Equation", "d", relations.d.formula.clone(), Prose::words(equation(solution))), force_at_depth(force)];
    vec![
        Step::new("Contact radius at a depth", "a(d)", radius.formula.clone(), Prose::read("$d$ = $g(a)$ is solved for $a$"))
            .from(&radius.reference)
            .with(steps),
    ]
}

/// The remark if no closed form of a(d) is known.
pub(super) fn unsolved() -> Step {
    let why =
        Prose::read("$d$ = $g(a)$ has no solution for $a$ in closed form that is known here; numbers come from a bracketed root of it");
    Step::remark("Contact radius at a depth", why)
}

/// A sentence on the solution of g(a) = d for a.
pub(super) fn equation(solution: &Solution) -> &'static str {
    explicit(solution).map_or("", |found| found.equation)
}

/// F(d) = F(a(d)).
pub(super) fn force_at_depth(force: &Derived) -> Step {
    Step::new("Force at a depth", "F(d)", force.formula.clone(), Prose::read("$a(d)$ put into $F(a)$")).from(&force.reference)
}

fn integral(integrand: Expr, variable: &str, lower: Expr, upper: Expr) -> Formula {
    Formula::Integral { integrand: Box::new(Formula::Closed(integrand)), variable: Symbol::new(variable), lower, upper }
}
