//! The formulas of the quantities: the derived relations, and what follows from them by definition.

use crate::contact::Relations;
use crate::contact::report::{at_rim, excess, together};
use crate::expr::{Bindings, Expr, Formula, Symbol, in_lowest_terms};
use crate::transform::{Derived, Solution, Superposed, axial_weight};
use std::borrow::Cow;

/// The inputs of the formulas of a contact.
#[derive(Clone, Copy)]
pub struct Formulas<'a> {
    /// The derived relations.
    pub relations: &'a Relations,
    /// f as it was typed.
    pub typed: &'a Formula,
    /// The solution of the profile.
    pub solution: &'a Solution,
    /// True for a punch with a rim at the contact radius.
    pub has_rim: bool,
}

type Stated<'a> = Cow<'a, Derived>;

impl<'a> Formulas<'a> {
    /// f(r) − f(0).
    pub(super) fn profile(&self) -> Stated<'a> {
        let formula = Formula::sum([self.typed.clone(), Formula::Closed(-&self.solution.profile.shift)]);
        Cow::Owned(Derived::given(formula))
    }

    /// G = a d − F/(2E), under a smooth edge and under a rim.
    pub(super) fn integral(&self) -> Stated<'a> {
        let Relations { d, force, .. } = self.relations;
        let below = d.formula.clone().scaled(&a());
        let part = force.formula.clone().scaled(&-(Expr::integer(2) * modulus()).recip());
        by_definition(over_x(Formula::sum([below, part])), force)
    }

    /// A = πa².
    pub(super) fn area(&self) -> Stated<'a> {
        let stiffness = &self.relations.stiffness;
        let formula = Formula::Closed(Expr::pi() * a().power(2));
        Cow::Owned(Derived { formula, reference: Vec::new(), ..stiffness.clone() })
    }

    /// F/(πa²).
    pub(super) fn mean_pressure(&self) -> Stated<'a> {
        let force = &self.relations.force;
        by_definition(force.formula.clone().scaled(&(Expr::pi() * a().power(2)).recip()), force)
    }

    /// d − g(x).
    pub(super) fn line_displacement(&self) -> Stated<'a> {
        by_definition(self.compressed(), &self.relations.g)
    }

    /// E*(d − g(x)).
    pub(super) fn line_load(&self) -> Stated<'a> {
        by_definition(self.compressed().scaled(&modulus()), &self.relations.g)
    }

    /// Every spring holds E w²/2 per length, on either side of the axis.
    pub(super) fn energy(&self) -> Option<Stated<'a>> {
        let work = self.compressed().as_closed()?.power(2);
        Some(by_definition(integral(Formula::Closed(work), "x", Expr::zero(), a()).scaled(&modulus()), &self.relations.g))
    }

    /// d − f(r) within the contact; outside, (2/π) [∫₀^a g′(x) arcsin(x/r) dx + (d − g(a)) arcsin(a/r)].
    pub(super) fn displacement(&self) -> Option<Stated<'a>> {
        let (d, shift) = (self.relations.d.formula.clone(), Formula::Closed(self.solution.profile.shift.clone()));
        let inside = Formula::sum([d, self.typed.clone().scaled(&Expr::integer(-1)), shift]);
        let angle = Expr::call("asin", [a() / Expr::symbol("r")]);
        let (field, outside) = self.field(Superposed::Outside, &Expr::one(), &(Expr::integer(2) / Expr::pi() * angle))?;
        let formula = Formula::Piecewise { variable: Symbol::new("r"), pieces: vec![(inside, a())], last: Box::new(outside) };
        Some(Cow::Owned(Derived { formula, ..field }))
    }

    /// −(E*/π) [∫₀^a g′(x) W(x) dx + (d − g(a)) W(a)], W(x) = x(x²+3z²)/(x²+z²)².
    pub(super) fn axial_stress(&self) -> Option<Stated<'a>> {
        let factor = -(modulus() / Expr::pi());
        let (field, formula) = self.field(Superposed::Axial, &factor, &(&factor * axial_weight(&a())))?;
        Some(Cow::Owned(Derived { formula, ..field }))
    }

    /// A field of the smooth profile times a factor, and under a rim another factor times d − g(a).
    fn field(&self, field: Superposed, factor: &Expr, at_edge: &Expr) -> Option<(Derived, Formula)> {
        let found = self.solution.field(field)?;
        let smooth = found.formula.clone().scaled(factor);
        let formula = if self.has_rim {
            together(Formula::sum([at_rim(smooth), excess(self.relations).scaled(at_edge)]))
        } else {
            smooth.map(&in_lowest_terms)
        };
        Some((found, formula))
    }

    /// d − g(x).
    fn compressed(&self) -> Formula {
        let Relations { d, g, .. } = self.relations;
        Formula::sum([d.formula.clone(), g.formula.clone().scaled(&Expr::integer(-1))])
    }
}

fn a() -> Expr {
    Expr::symbol("a")
}

fn modulus() -> Expr {
    Expr::symbol("E")
}

/// A formula that follows from a relation.
fn by_definition<'a>(formula: Formula, from: &Derived) -> Stated<'a> {
    let status = if holds_integral(&formula) { from.status.integrated() } else { from.status };
    Cow::Owned(Derived { formula, status, ..from.clone() })
}

fn integral(integrand: Formula, variable: &str, lower: Expr, upper: Expr) -> Formula {
    Formula::Integral { integrand: Box::new(integrand), variable: Symbol::new(variable), lower, upper }
}

/// A formula over a as one over x.
fn over_x(formula: Formula) -> Formula {
    let renamed = Bindings::one("a", Expr::symbol("x"));
    match formula {
        Formula::Piecewise { pieces, last, .. } => Formula::Piecewise {
            variable: Symbol::new("x"),
            pieces: pieces.into_iter().map(|(value, end)| (value.substitute(&renamed), end)).collect(),
            last: Box::new(last.substitute(&renamed)),
        },
        Formula::Sum(parts) => Formula::sum(parts.into_iter().map(over_x)),
        other => other.substitute(&renamed),
    }
}

fn holds_integral(formula: &Formula) -> bool {
    match formula {
        Formula::Closed(_) => false,
        Formula::Sum(parts) => parts.iter().any(holds_integral),
        Formula::Scaled(_, inner) => holds_integral(inner),
        Formula::Piecewise { pieces, last, .. } => holds_integral(last) || pieces.iter().any(|(value, _)| holds_integral(value)),
        Formula::Integral { .. } => true,
    }
}
