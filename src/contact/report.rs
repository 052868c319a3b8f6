//! The derived relations of a contact: g, d, F, p, k, a(d) and F(d) with their rules and conditions.

use super::{ContactError, Explicit, explicit};
use crate::expr::{Bindings, Condition, Expr, Formula, Relation, Sign, Symbol, collected, derivative, in_lowest_terms, normal, sign};
use crate::num::work;
use crate::print::Prose;
use crate::transform::{Check, Derived, Solution, Status, TransformError};

/// The radius of the rim in a profile that contains it: a constant, as the contact radius a is a variable of the relations.
pub fn rim_radius() -> Symbol {
    Symbol::homonym("a")
}

/// How the contact ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Edge {
    /// The profile leaves the surface smoothly: d = g(a).
    Smooth,
    /// A rim at the contact radius: the depth is independent of a and has the given value.
    Rim(Expr),
}

/// Everything that is derived from a profile.
#[derive(Clone, Debug)]
pub struct Relations {
    /// g(x).
    pub g: Derived,
    /// d(a), or the given depth.
    pub d: Derived,
    /// F(a).
    pub force: Derived,
    /// p(r); `None` if f′ is so large at a breakpoint that it has no formula here.
    pub pressure: Option<Derived>,
    /// k(a) = 2E*a.
    pub stiffness: Derived,
    /// a(d), where it is explicit.
    pub contact_radius_of_depth: Option<Derived>,
    /// F(d), where it is explicit.
    pub force_of_depth: Option<Derived>,
    /// The conditions of validity, including those of the edge.
    pub conditions: Vec<Prose>,
}

impl Relations {
    /// Marks formulas as compared if the check passed and compared them, where the comparison during the derivation was
    /// inconclusive.
    pub fn confirm(&mut self, check: &Check) {
        let [equivalent, force, pressure] = check.compared.map(|own| own && check.passed());
        let confirm = |own: &mut Derived, compared: bool| {
            if compared && !own.split && own.status != Status::Numeric && own.compared == Some(false) {
                own.compared = Some(true);
            }
        };
        confirm(&mut self.g, equivalent);
        confirm(&mut self.d, equivalent);
        confirm(&mut self.force, force);
        self.pressure.iter_mut().for_each(|own| confirm(own, pressure));
        self.contact_radius_of_depth.iter_mut().for_each(|own| confirm(own, equivalent));
        self.force_of_depth.iter_mut().for_each(|own| confirm(own, equivalent && force));
    }
}

/// Collects the relations of a solution under the given edge.
///
/// ```
/// use sneddon::contact::{Edge, relations};
/// use sneddon::{expr::Expr, parse, print, transform::{Profile, derive}};
/// let flat = Profile::new(&parse::profile("0").unwrap()).unwrap();
/// let punch = relations(&derive(&flat).unwrap(), &Edge::Rim(Expr::symbol("d"))).unwrap();
/// assert_eq!(print::text(&punch.force.formula), "2*E*a*d");
/// ```
///
/// # Errors
/// [`TransformError::Flat`] for a flat profile without a depth.
pub fn relations(solution: &Solution, edge: &Edge) -> Result<Relations, ContactError> {
    work::bounded(|| collect(solution, edge))
}

fn collect(solution: &Solution, edge: &Edge) -> Result<Relations, ContactError> {
    if solution.profile.is_flat() && *edge == Edge::Smooth {
        return Err(TransformError::Flat.into());
    }
    let (modulus, a) = (Expr::symbol("E"), Expr::symbol("a"));
    let at_edge = Bindings::one("x", a.clone());
    let rim_is_edge = Bindings::one(rim_radius().name(), a.clone());
    let at_rim = |derived: Derived| Derived { formula: at_rim(derived.formula), ..derived };
    let g = at_rim(solution.equivalent_profile());
    let g_at_edge = at_edge_of(&g.formula, &at_edge);
    let at_rim_of = |own: &Condition| {
        let side = |expr: &Expr| rim_is_edge.apply(expr);
        Condition { left: side(&own.left), relation: own.relation, right: side(&own.right) }
    };
    let mut conditions: Vec<Condition> = solution.conditions.clone();
    let stiffness = Derived {
        formula: Formula::Closed(Expr::integer(2) * &modulus * &a),
        status: Status::Exact,
        compared: Some(true),
        split: false,
        rules: Vec::new(),
        reference: vec!["Popov & Heß (3.1), (3.22)"],
    };
    let inverse: Option<Explicit> = if *edge == Edge::Smooth { explicit(solution) } else { None };
    if let Some(found) = &inverse {
        conditions.extend(found.conditions.iter().cloned());
    }
    let closed = |expr: &Expr, found: &Explicit, compared: Option<bool>| Derived {
        formula: Formula::Closed(in_lowest_terms(expr)),
        status: Status::Exact,
        compared,
        split: false,
        rules: g.rules.clone(),
        reference: found.reference.clone(),
    };
    let mut stated: Vec<Condition> = conditions.iter().map(at_rim_of).collect();
    stated.sort();
    stated.dedup();
    let mut stated: Vec<Prose> = stated.into_iter().map(|own| Prose::default().condition(own)).collect();
    let (d, force, pressure) = match edge {
        Edge::Smooth => {
            let on_the_surface = Condition::equal(Expr::symbol("d"), Expr::symbol("g(a)"));
            stated.push(Prose::words("smooth edge: ").condition(on_the_surface));
            let d = Derived { formula: g_at_edge, reference: with_first(&g.reference, "Popov & Heß (3.26)"), ..g.clone() };
            (d, solution.force(), solution.pressure())
        }
        Edge::Rim(depth) => {
            let rim = Condition::equal(Expr::symbol("r"), a.clone());
            stated.push(Prose::words("rim at ").condition(rim).then(": the depth ").formula(depth.clone()).then(" is free"));
            stated.extend(complete_contact(solution, depth, &g_at_edge));
            let d = Derived::given(Formula::Closed(depth.clone()));
            let excess = above(&d, g_at_edge);
            let (force, pressure) = (at_rim(solution.force()), solution.pressure().map(at_rim));
            let extra = excess.clone().scaled(&(Expr::integer(2) * &modulus * &a));
            let edge_term = excess.scaled(&(&modulus / (Expr::pi() * (a.power(2) - Expr::symbol("r").power(2)).sqrt())));
            let force = Derived {
                formula: together(simplified(Formula::sum([force.formula, extra]), "a")),
                reference: with_first(&force.reference, "Popov & Heß (3.61)"),
                ..force
            };
            let pressure = pressure.map(|pressure| Derived {
                formula: together(Formula::sum([pressure.formula, edge_term])),
                reference: with_first(&pressure.reference, "Popov & Heß (3.56), (3.62)–(3.63)"),
                ..pressure
            });
            (d, force, pressure)
        }
    };
    Ok(Relations {
        contact_radius_of_depth: inverse.as_ref().map(|found| closed(&found.contact_radius, found, g.compared)),
        // Under a rim the contact radius does not change, and F(a) is the answer for every depth.
        force_of_depth: match edge {
            Edge::Smooth => inverse
                .as_ref()
                .map(|found| closed(&found.force, found, if force.compared == Some(true) { g.compared } else { force.compared })),
            Edge::Rim(_) => Some(force.clone()),
        },
        g,
        d,
        force,
        pressure,
        stiffness,
        conditions: stated,
    })
}

/// A formula of a profile with a rim at the contact radius.
pub(super) fn at_rim(formula: Formula) -> Formula {
    formula.substitute(&Bindings::one(rim_radius().name(), Expr::symbol("a"))).without_decided_pieces()
}

/// d − g(a).
pub(super) fn excess(relations: &Relations) -> Formula {
    above(&relations.d, at_edge_of(&relations.g.formula, &Bindings::one("x", Expr::symbol("a"))))
}

fn above(d: &Derived, g_at_edge: Formula) -> Formula {
    Formula::sum([d.formula.clone(), g_at_edge.scaled(&Expr::integer(-1))])
}

/// The part of a smooth edge and the part of the rim as one closed form, if both are closed.
pub(super) fn together(formula: Formula) -> Formula {
    let parts: Option<Vec<Expr>> = match &formula {
        Formula::Sum(parts) => parts.iter().map(|own| own.as_closed().cloned()).collect(),
        Formula::Closed(own) => Some(vec![own.clone()]),
        _ => None,
    };
    parts.map_or(formula, |parts| Formula::Closed(collected(&Expr::sum(parts))))
}

/// The conditions of a complete contact up to the rim: no gap at the rim, d ≥ g(a), and no tension inside.
///
/// Under a rising g the first is enough. A concave parabola −h r²/c² is in tension first at the centre, which gives
/// d ≥ 2h a²/c² (3.63); elsewhere the place is not known beforehand and the demand is stated as it is.
fn complete_contact(solution: &Solution, depth: &Expr, g_at_edge: &Formula) -> Vec<Prose> {
    if let Some(own) = g_at_edge.as_closed()
        && sign(own) == Sign::Negative
    {
        let terms: Vec<_> = solution.terms().collect();
        if let [only] = terms.as_slice()
            && only.term.single().is_some_and(|part| part.exponent.is_one() && part.kernel.is_one())
        {
            let enough = Condition { left: -own, relation: Relation::LessOrEqual, right: depth.clone() };
            return vec![Prose::default().condition(enough)];
        }
    }
    let edge = match g_at_edge.as_closed() {
        Some(own) => Prose::default().condition(Condition { left: own.clone(), relation: Relation::LessOrEqual, right: depth.clone() }),
        None => Prose::default().formula(g_at_edge.clone()).then(" <= ").formula(depth.clone()),
    };
    // (r f′)′ ≥ 0 makes g rise, and a rising g presses everywhere.
    let radius = Symbol::new("r");
    let rising = solution.terms().all(|solved| {
        let bend = derivative(&(Expr::symbol("r") * solved.term.f_prime()), &radius);
        bend.is_ok_and(|bend| bend.terms().iter().all(|term| sign(term) == Sign::Positive))
    });
    if rising {
        vec![edge]
    } else {
        {
            let pressed = Condition { left: Expr::zero(), relation: Relation::LessOrEqual, right: Expr::symbol("p(r)") };
            let inside = Condition::less(Expr::symbol("r"), Expr::symbol("a"));
            vec![edge, Prose::words("complete contact: ").condition(pressed).then(" for every ").condition(inside)]
        }
    }
}

/// g with x = a, its pieces over a.
fn at_edge_of(formula: &Formula, at_edge: &Bindings) -> Formula {
    match formula.substitute(at_edge) {
        Formula::Piecewise { pieces, last, .. } => Formula::Piecewise { variable: Symbol::new("a"), pieces, last }.without_decided_pieces(),
        Formula::Sum(parts) => Formula::sum(parts.iter().map(|part| at_edge_of(part, at_edge))),
        other => other,
    }
}

/// Closed sums are expanded once, so that the edge's share and the smooth share cancel where they can.
fn simplified(formula: Formula, variable: &str) -> Formula {
    match &formula {
        Formula::Closed(expr) => {
            normal::expanded(expr, &Symbol::new(variable)).map_or(formula, |own| Formula::Closed(in_lowest_terms(&own)))
        }
        _ => formula,
    }
}

fn with_first(list: &[&'static str], first: &'static str) -> Vec<&'static str> {
    std::iter::once(first).chain(list.iter().copied().filter(|r| *r != first)).collect()
}
