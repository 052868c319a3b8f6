//! The quantities for which `derive` states a formula, by key: those of the relations, and what follows from them by definition.

use super::Relations;
use crate::expr::{Bindings, Expr, Formula, Symbol, derivative, shown};
use crate::transform::{Derived, Profile};
use std::borrow::Cow;

/// A quantity as a key of what is derived.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RelationKey {
    /// f(r), shifted so that f(0) = 0.
    Profile,
    /// g(x).
    Equivalent,
    /// G(x) = ∫₀ˣ g.
    Integral,
    /// d(a).
    Depth,
    /// F(a).
    Force,
    /// a(d).
    ContactRadius,
    /// F(d).
    ForceOfDepth,
    /// p(r).
    Pressure,
    /// u(r).
    Displacement,
    /// k(a).
    Stiffness,
    /// U(a), the strain energy.
    Energy,
    /// F/(πa²).
    MeanPressure,
    /// σ_zz(z) on the axis.
    AxialStress,
    /// q(x), the line load of the one-dimensional model.
    LineLoad,
    /// The displacement d − g(x) of the one-dimensional model.
    LineDisplacement,
}

impl RelationKey {
    /// What `derive` answers where nothing is asked for.
    pub const USUAL: [Self; 7] =
        [Self::Equivalent, Self::Depth, Self::Force, Self::Pressure, Self::Stiffness, Self::ContactRadius, Self::ForceOfDepth];

    /// The key that machines read.
    pub fn key(self) -> &'static str {
        match self {
            Self::Profile => "f",
            Self::Equivalent => "g",
            Self::Integral => "G",
            Self::Depth => "d",
            Self::Force => "F",
            Self::ContactRadius => "a_of_d",
            Self::ForceOfDepth => "F_of_d",
            Self::Pressure => "p",
            Self::Displacement => "u",
            Self::Stiffness => "k",
            Self::Energy => "U",
            Self::MeanPressure => "p_mean",
            Self::AxialStress => "sigma_zz",
            Self::LineLoad => "q",
            Self::LineDisplacement => "u_1d",
        }
    }

    /// The left side of its equation.
    pub fn left(self, has_rim: bool) -> &'static str {
        match self {
            Self::Profile => "f(r)",
            Self::Equivalent => "g(x)",
            Self::Integral => "G(x)",
            Self::Depth if has_rim => "d",
            Self::Depth => "d(a)",
            Self::Force => "F(a)",
            Self::ContactRadius => "a(d)",
            Self::ForceOfDepth => "F(d)",
            Self::Pressure => "p(r)",
            Self::Displacement => "u(r)",
            Self::Stiffness => "k(a)",
            Self::Energy => "U(a)",
            Self::MeanPressure => "p_m(a)",
            Self::AxialStress => "sigma_zz(z)",
            Self::LineLoad => "q(x)",
            Self::LineDisplacement => "u_1d(x)",
        }
    }

    /// Its formula; `None` where it has none.
    pub fn of<'a>(self, all: &'a Relations, typed: &Formula, profile: &Profile, has_rim: bool) -> Option<Cow<'a, Derived>> {
        let (x, r, a) = (Expr::symbol("x"), Expr::symbol("r"), Expr::symbol("a"));
        let modulus = Expr::symbol("E");
        let by_definition = |formula: Formula, from: &Derived| {
            let status = if holds_integral(&formula) { from.status.integrated() } else { from.status };
            Some(Cow::Owned(Derived { formula, status, ..from.clone() }))
        };
        let compressed = || Formula::sum([all.d.formula.clone(), all.g.formula.clone().scaled(&Expr::integer(-1))]);
        match self {
            Self::Equivalent => Some(Cow::Borrowed(&all.g)),
            Self::Depth => Some(Cow::Borrowed(&all.d)),
            Self::Force => Some(Cow::Borrowed(&all.force)),
            Self::Pressure => all.pressure.as_ref().map(Cow::Borrowed),
            Self::Stiffness => Some(Cow::Borrowed(&all.stiffness)),
            Self::ContactRadius => all.contact_radius_of_depth.as_ref().map(Cow::Borrowed),
            Self::ForceOfDepth => all.force_of_depth.as_ref().map(Cow::Borrowed),
            Self::Profile => {
                let formula = Formula::sum([typed.clone(), Formula::Closed(-&profile.shift)]);
                Some(Cow::Owned(Derived::given(formula)))
            }
            // F = 2E (a d − G(a)), under a smooth edge and under a rim.
            Self::Integral => {
                let below = all.d.formula.clone().scaled(&a);
                let force = all.force.formula.clone().scaled(&-(Expr::integer(2) * modulus).recip());
                by_definition(over_x(Formula::sum([below, force])), &all.force)
            }
            Self::MeanPressure => by_definition(all.force.formula.clone().scaled(&(Expr::pi() * a.power(2)).recip()), &all.force),
            Self::LineDisplacement => by_definition(compressed(), &all.g),
            Self::LineLoad => by_definition(compressed().scaled(&modulus), &all.g),
            // Every spring holds E w²/2 per length, on either side of the axis.
            Self::Energy => {
                let work = compressed().as_closed()?.power(2);
                by_definition(integral(Formula::Closed(work), "x", Expr::zero(), a).scaled(&modulus), &all.g)
            }
            Self::Displacement => {
                let inside =
                    Formula::sum([all.d.formula.clone(), typed.clone().scaled(&Expr::integer(-1)), Formula::Closed(profile.shift.clone())]);
                let root = (r.power(2) - x.power(2)).sqrt();
                let load = compressed().as_closed()? / root;
                let outside = integral(Formula::Closed(load), "x", Expr::zero(), a.clone());
                let outside = outside.scaled(&(Expr::integer(2) / Expr::pi()));
                let formula = Formula::Piecewise { variable: Symbol::new("r"), pieces: vec![(inside, a)], last: Box::new(outside) };
                by_definition(formula, &all.g)
            }
            // The edge of a rim adds a term of its own, which is left to numbers.
            Self::AxialStress if has_rim => None,
            Self::AxialStress => {
                let slope = derivative(&shown(all.g.formula.as_closed()?), &Symbol::new("x")).ok()?;
                let z = Expr::symbol("z");
                let (square, depth) = (x.power(2), z.power(2));
                let weight = x * (&square + Expr::integer(3) * &depth) / (square + depth).power(2);
                let formula = integral(Formula::Closed(slope * weight), "x", Expr::zero(), a).scaled(&-(modulus / Expr::pi()));
                by_definition(formula, &all.g)
            }
        }
    }
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
