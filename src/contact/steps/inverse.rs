//! From g to f: the Abel integral that is solved, the substitution in it, and the result.

use super::Step;
use crate::expr::{Bindings, Condition, Expr, Formula, Symbol};
use crate::print::Prose;
use crate::transform::Derived;

/// The steps from g, a formula over x, to f.
pub fn inverse_steps(equivalent: &Formula, found: &Derived, at_axis: &Expr) -> Vec<Step> {
    let (x, r, t) = (Expr::symbol("x"), Expr::symbol("r"), Expr::symbol("t"));
    let mut steps = Vec::new();
    if let Some(closed) = equivalent.as_closed() {
        let substituted = Bindings::one("x", &r * Expr::call("sin", [t.clone()])).apply(closed);
        steps.push(Step::new(
            "Substitution",
            "f(r)",
            over(substituted, "t", Expr::pi() / Expr::integer(2)),
            Prose::words("The substitution ")
                .condition(Condition::equal(x.clone(), &r * Expr::call("sin", [t])))
                .then(", in which $dd x$ = ")
                .formula(root())
                .then(" $dd t$"),
        ));
    }
    let rules = match found.rules.as_slice() {
        [] => Prose::words("No statement answers: the integral stays, and numbers come from quadrature of it"),
        rules => Prose::words(&format!("By {}, read from the equivalent profile to the profile", rules.join(", "))),
    };
    steps.push(Step::new("Result", "f(r)", found.formula.clone(), rules).from(&found.reference));
    vec![
        given(equivalent, at_axis),
        Step::new(
            "Profile",
            "f(r)",
            definition(),
            Prose::words("The integral that defines the equivalent profile is an Abel integral; this is its solution"),
        )
        .from(&["Popov & Heß (3.27)"])
        .with(steps),
    ]
}

/// g(x), as it was given.
pub(super) fn given(equivalent: &Formula, at_axis: &Expr) -> Step {
    let start = Prose::read("A constant is its own inverse, and a contact does not see it: $f(0)$ = $g(0)$ = ").formula(at_axis.clone());
    Step::new("Equivalent profile", "g(x)", equivalent.clone(), start)
}

/// f(r) = 2/π ∫₀^r g(x)/√(r² − x²) dx.
pub(super) fn definition() -> Formula {
    over(Expr::symbol("g(x)") / root(), "x", Expr::symbol("r"))
}

/// 2/π ∫₀^upper.
fn over(integrand: Expr, variable: &str, upper: Expr) -> Formula {
    let integrand = Box::new(Formula::Closed(integrand));
    let integral = Formula::Integral { integrand, variable: Symbol::new(variable), lower: Expr::zero(), upper };
    integral.scaled(&(Expr::integer(2) / Expr::pi()))
}

/// √(r² − x²).
fn root() -> Expr {
    (Expr::symbol("r").power(2) - Expr::symbol("x").power(2)).sqrt()
}
