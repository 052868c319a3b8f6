//! The short derivations: one step per quantity, with its result, the definition it comes from and the rules of its closed form.

use super::{Step, equivalent, inverse, results};
use crate::contact::{Edge, Relations};
use crate::expr::{Expr, Formula};
use crate::print::Prose;
use crate::transform::{Derived, Solution, Status, TransformError};

/// The short derivation from f, as typed, to f′, g, d, F, p, k, a(d) and F(d): the results of [`steps`](super::steps) without
/// substeps.
///
/// The equation of a step is its result, and the reason states the definition, such as g(x) = x ∫₀^x f′(r)/√(x² − r²) dr.
///
/// ```
/// use sneddon::contact::{Edge, relations, short_steps};
/// use sneddon::{parse, print, transform::{Profile, derive}};
/// let f = parse::profile("r^2/(2*R)").unwrap();
/// let solution = derive(&Profile::new(&f).unwrap()).unwrap();
/// let found = relations(&solution, &Edge::Smooth).unwrap();
/// let steps = short_steps(&f, &solution, &Edge::Smooth, &found).unwrap();
/// assert_eq!(print::text(steps[2].right.as_ref().unwrap()), "x^2/R");
/// ```
///
/// # Errors
/// [`TransformError`] if f has no derivative.
pub fn short_steps(typed: &Formula, solution: &Solution, edge: &Edge, relations: &Relations) -> Result<Vec<Step>, TransformError> {
    let mut list = vec![
        equivalent::shape(typed, solution),
        f_prime(solution)?,
        equivalent_profile(solution, relations),
        depth(edge, relations),
        force(edge, relations),
        pressure(edge, relations),
        stiffness(edge, relations),
    ];
    list.extend(at_depth(solution, edge, relations));
    list.push(results::validity(relations));
    Ok(list)
}

/// The short derivation from g, a formula over x, to f.
pub fn short_inverse_steps(equivalent: &Formula, found: &Derived, at_axis: &Expr) -> Vec<Step> {
    let why =
        Prose::read("The definition of $g$ is an Abel integral over $f'(r)$, and its solution is $f(r)$ = ").formula(inverse::definition());
    vec![inverse::given(equivalent, at_axis), result("Profile", "f(r)", found, closed_by(why, found))]
}

fn result(title: &str, left: &str, found: &Derived, reason: Prose) -> Step {
    Step::new(title, left, found.formula.clone(), reason).from(&found.reference)
}

/// The reason, with the rules that close its integral, fully or in part.
fn closed_by(reason: Prose, found: &Derived) -> Prose {
    let rules = match found.rules.as_slice() {
        [] => String::new(),
        [only] => format!(" by the rule {only}"),
        [others @ .., last] => format!(" by the rules {} and {last}", others.join(", ")),
    };
    let more = match found.status {
        Status::Exact if rules.is_empty() => Prose::default(),
        Status::Exact => Prose::words(&format!(", in closed form{rules}")),
        Status::Partial => Prose::words(&format!(", partly in closed form{rules}; the remaining integral is evaluated numerically")),
        Status::Numeric => Prose::words("; no rule gives a closed form, so the integral remains"),
    };
    reason.followed_by(&more)
}

fn f_prime(solution: &Solution) -> Result<Step, TransformError> {
    let is_whole = solution.profile.chains.iter().all(|chain| chain.breakpoints.is_empty());
    let why = Prose::read("The derivative of $f(r)$").then(if is_whole { "" } else { ", piece by piece" });
    Ok(Step::new("Slope", "f'(r)", equivalent::f_prime(solution)?, why))
}

fn equivalent_profile(solution: &Solution, relations: &Relations) -> Step {
    let why = Prose::read("By definition $g(x)$ = ").formula(equivalent::definition());
    let why = match equivalent::sloped_terms(solution).len() {
        0 => why.then("; the slope vanishes, and so does the integral"),
        count if count > 1 && relations.g.status != Status::Numeric => {
            why.then(&format!("; the {count} terms of the slope are transformed one by one"))
        }
        _ => why,
    };
    result("Equivalent profile", "g(x)", &relations.g, closed_by(why, &relations.g))
}

fn depth(edge: &Edge, relations: &Relations) -> Step {
    let step = results::depth(edge, relations);
    // Omit the trivial d = d.
    if *edge == Edge::Rim(Expr::symbol("d")) { Step { left: None, right: None, ..step } } else { step }
}

fn force(edge: &Edge, relations: &Relations) -> Step {
    let why = Prose::read("Every spring between −$a$ and $a$ is compressed by $d$ − $g(x)$, so that $F(a)$ = ")
        .formula(results::force_definition(edge));
    result("Force", "F(a)", &relations.force, closed_by(why, &relations.force))
}

fn pressure(edge: &Edge, relations: &Relations) -> Step {
    let Some(found) = &relations.pressure else { return Step::remark("Pressure", Prose::read(results::NO_PRESSURE)) };
    let why = Prose::read("The line load of the springs is transformed back to $p(r)$ = ").formula(results::pressure_definition(edge));
    let why = closed_by(why, found).then(match edge {
        Edge::Smooth => "; $p$ is 0 for $r$ > $a$",
        Edge::Rim(_) => "; the term with $d$ − $g(a)$ is the step of the line load at the rim, and $p$ is 0 for $r$ > $a$",
    });
    result("Pressure", "p(r)", found, why)
}

fn stiffness(edge: &Edge, relations: &Relations) -> Step {
    let why = Prose::read("By definition $k$ = $dd F/dd d$").then(match edge {
        Edge::Smooth => "; an increment of depth acts as a flat punch of radius $a$, whatever the shape",
        Edge::Rim(_) => "; the contact radius equals the radius of the rim at every depth",
    });
    result("Stiffness", "k(a)", &relations.stiffness, why)
}

/// a(d) and F(d), if known.
fn at_depth(solution: &Solution, edge: &Edge, relations: &Relations) -> Vec<Step> {
    match (edge, &relations.contact_radius_of_depth, &relations.force_of_depth) {
        (Edge::Smooth, Some(radius), Some(force)) => {
            let why = Prose::read("$d$ = $g(a)$ is solved for $a$. ").then(results::equation(solution));
            vec![result("Contact radius at a depth", "a(d)", radius, why), results::force_at_depth(force)]
        }
        (Edge::Smooth, ..) => vec![results::unsolved()],
        (Edge::Rim(_), _, Some(force)) => {
            let why = Prose::read("The rim fixes $a$: $F(a)$ is the force at every depth");
            vec![result("Force at a depth", "F(d)", force, why)]
        }
        (Edge::Rim(_), _, None) => Vec::new(),
    }
}
