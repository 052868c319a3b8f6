//! The program of a profile: its routines, their parameters and claims.

use super::build::ParameterDimension;
use super::tree::{Routine, Statement, Value};
use crate::contact::{self, Quantity};

/// The quantities for which code can be generated.
pub const QUANTITIES: [Quantity; 6] =
    [Quantity::Equivalent, Quantity::Force, Quantity::Pressure, Quantity::Depth, Quantity::Radius, Quantity::ForceOfDepth];

/// The routine that returns the length of a step of the search for a(d), for profiles with waves.
pub(super) const STEP: &str = "sneddon_step";

/// The routines that compute the quantities of a profile.
#[derive(Clone, Debug)]
pub struct Program {
    pub(super) language: Language,
    /// Every routine, after the routines that it calls.
    pub(super) routines: Vec<Routine>,
    /// The requested quantities.
    pub(super) quantities: Vec<Quantity>,
    /// The parameters with their identifiers.
    pub(super) parameters: Vec<(String, String)>,
    /// The functions of the language's library that are called.
    pub(super) library: Vec<String>,
    /// What each parameter measures.
    pub(super) dimensions: Vec<ParameterDimension>,
    /// Values of the parameters under which the conditions on them hold, in metres and radians.
    pub(super) starting_values: Vec<f64>,
    /// f(r) as text.
    pub(super) profile: String,
    /// The shape, if it is a named one.
    pub(super) shape: Option<NamedShape>,
    pub(super) claims: Vec<(Quantity, Option<Claim>)>,
}

/// A named shape, as models for fits show it.
#[derive(Clone, Debug)]
pub struct NamedShape {
    /// The name.
    pub name: String,
    /// A phrase that describes the shape.
    pub title: String,
    /// The parameters with their descriptions.
    pub meanings: Vec<(String, String)>,
}

impl Language {
    /// Every language.
    pub(super) const ALL: [Self; 6] = [Self::C, Self::Fortran, Self::Python, Self::Matlab, Self::Rust, Self::Nanite];
}

impl Program {
    /// Sets the shape, which models for fits show.
    #[must_use]
    pub fn named(mut self, shape: NamedShape) -> Self {
        self.shape = Some(shape);
        self
    }

    /// Sets the unit of lengths, which comments state; without it, all lengths are in one unit.
    #[must_use]
    pub fn with_length_unit(mut self, length: &str) -> Self {
        for quantity in QUANTITIES {
            let of_quantity = self.routines.iter_mut().filter(|own| own.name == routine_name(quantity));
            let lines = of_quantity.flat_map(|own| &mut own.comment).filter(|own| **own == unit(quantity, None));
            lines.for_each(|own| *own = unit(quantity, Some(length)));
        }
        self
    }
}

/// The units, in words, with the unit of lengths if it is known.
pub(super) fn unit(quantity: Quantity, length: Option<&str>) -> String {
    let lengths = length.map_or_else(|| "lengths in one unit".to_owned(), |own| format!("lengths in {own}"));
    let area = length.map_or_else(|| "length squared".to_owned(), |own| format!("{own}^2"));
    match quantity {
        Quantity::Force | Quantity::ForceOfDepth => {
            format!("Units: {lengths}; E is the effective modulus, a pressure; F in the unit of E times {area}.")
        }
        Quantity::Pressure => format!("Units: {lengths}; E is the effective modulus, a pressure; p in the unit of E."),
        _ => length.map_or_else(
            || "Units: all lengths and the result in the same unit.".to_owned(),
            |own| format!("Units: all lengths in {own}."),
        ),
    }
}

impl Program {
    /// Whether two programs have the same operations.
    pub(super) fn computes_as(&self, other: &Self) -> bool {
        self.routines.iter().map(|own| &own.body).eq(other.routines.iter().map(|own| &own.body))
    }

    /// Whether d(a) is g(a), without more operations.
    pub(super) fn depth_is_g(&self) -> bool {
        let (depth, g) = (routine_name(Quantity::Depth), routine_name(Quantity::Equivalent));
        let body = self.routines.iter().find(|own| own.name == depth).map(|own| own.body.as_slice());
        matches!(body, Some([Statement::Return(Value::Call(name, _))]) if *name == g)
    }

    /// Whether two programs compute a quantity with the same operations.
    pub(super) fn computes_alike(&self, other: &Self, quantity: Quantity) -> bool {
        self.operations_of(quantity).eq(&other.operations_of(quantity))
    }

    /// The routine of a quantity and those that it calls, with their names.
    fn operations_of(&self, quantity: Quantity) -> Vec<(String, &[Statement])> {
        let (mut open, mut found) = (vec![routine_name(quantity)], Vec::<(String, &[Statement])>::new());
        while let Some(name) = open.pop() {
            let routine = self.routines.iter().find(|own| own.name == name);
            let Some(routine) = routine.filter(|_| found.iter().all(|own| own.0 != name)) else { continue };
            open.extend(routine.calls());
            found.push((name, &routine.body));
        }
        found
    }
}

/// Whether the effective modulus is an argument.
pub(super) fn needs_modulus(quantity: Quantity) -> bool {
    [contact::Dimension::FORCE, contact::Dimension::PRESSURE].contains(&quantity.dimension())
}

/// Whether a quantity is a function of the depth.
pub(super) fn is_of_depth(quantity: Quantity) -> bool {
    quantity.coordinate() == "d"
}

/// The quantities whose series a quantity is computed from: d and a from that of g.
pub(super) fn series_of(quantity: Quantity) -> &'static [Quantity] {
    match quantity {
        Quantity::Force => &[Quantity::Force],
        Quantity::Pressure => &[Quantity::Pressure],
        Quantity::ForceOfDepth => &[Quantity::Equivalent, Quantity::Force],
        _ => &[Quantity::Equivalent],
    }
}

/// A sum from which g or F is computed where it converges fast.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sum {
    /// The power series at the axis.
    Series,
    /// The Gauss–Kronrod rule.
    Quadrature,
}

/// The name of the routine of a quantity.
pub(super) fn routine_name(quantity: Quantity) -> String {
    format!("sneddon_{}", quantity.key())
}

/// A bound on the error of a generated function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Claim {
    /// Units in the last place.
    pub ulps: f64,
    /// Where the ulps are times the condition number: the largest bound at the points, with that number.
    pub conditional: Option<f64>,
    /// At how many points.
    pub points: usize,
    /// The coordinates between which the points lie; the second one is infinite if the points reach to the end of the profile.
    pub range: (f64, f64),
    /// The coordinate at which the error is largest.
    pub worst_at: f64,
}

/// A language that code is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// C99.
    C,
    /// Fortran 2008, free form.
    Fortran,
    /// Python 3.
    Python,
    /// MATLAB and GNU Octave.
    Matlab,
    /// Rust.
    Rust,
    /// A model file for nanite and PyJibe, in Python.
    Nanite,
}
