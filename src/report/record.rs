//! The records that every output format reads: what was derived, evaluated and compared.

use super::open_pressure;
use crate::contact::{Asked, Comparisons, Edge, Formulas, Measured, Quantity, Reason, Relations};
use crate::expr::{Expr, Formula};
use crate::print::{Presentation, Prose};
use crate::transform::{Check, Derived, Profile, TransformError};
use std::borrow::Cow;

/// Everything that `derive` found.
pub struct Derivation<'a> {
    /// The profile, with set parameters in place.
    pub profile: &'a Profile,
    /// f as it was typed, with set parameters in place.
    pub typed: &'a Formula,
    /// How the contact ends.
    pub edge: &'a Edge,
    /// The derived relations.
    pub relations: &'a Relations,
    /// The quantities that were asked for, in this order; empty for the usual ones.
    pub asked: &'a [Quantity],
    /// What is changed in the formulas when they are printed.
    pub presentation: &'a Presentation,
    /// The outcome of the check, or why it could not be made.
    pub check: Result<Check, Unchecked>,
}

/// Why formulas were not compared with quadrature.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Unchecked {
    /// The budget was exhausted, so the answer is incomplete.
    #[error("the budget of work did not suffice")]
    Cut,
    /// The comparison returned this error.
    #[error("{0}")]
    Refused(String),
}

impl From<TransformError> for Unchecked {
    fn from(error: TransformError) -> Self {
        match error {
            TransformError::Exhausted(_) => Self::Cut,
            other => Self::Refused(other.to_string()),
        }
    }
}

impl Unchecked {
    /// The reason why an answer with this check is incomplete; `None` if it is complete.
    pub fn why(check: &Result<Check, Self>) -> Option<&'static str> {
        matches!(check, Err(Self::Cut)).then_some("the budget of work did not suffice for the check")
    }
}

/// One derived quantity, or the place of one that has no explicit form.
pub struct Entry<'a> {
    /// The key that machines read.
    pub key: &'static str,
    /// The left side of the equation.
    pub left: &'static str,
    /// The right side with its sources.
    pub derived: Option<Cow<'a, Derived>>,
}

impl Derivation<'_> {
    /// The quantities in the order of reading, or in that in which they were asked for.
    pub fn entries(&self) -> Vec<Entry<'_>> {
        let usual;
        let list = if self.asked.is_empty() {
            usual = Quantity::USUAL;
            usual.as_slice()
        } else {
            self.asked
        };
        let has_rim = self.has_rim();
        let all = Formulas { relations: self.relations, typed: self.typed, shape: self.profile, has_rim };
        list.iter().map(|own| Entry { key: own.relation(), left: own.left(has_rim), derived: own.formula(&all) }).collect()
    }

    /// f(0), where something had to be subtracted.
    pub fn shift(&self) -> Option<&Expr> {
        Some(&self.profile.shift).filter(|shift| !shift.is_zero())
    }

    /// f as it was typed.
    pub fn formula(&self) -> &Formula {
        self.typed
    }

    /// What a reader of the formulas must know.
    pub fn notes(&self) -> Vec<Prose> {
        let mut notes = vec![
            "the formulas hold for $x$ >= 0; $g$ is even",
            "$E$ is the effective modulus E*",
            "$p$ = -$sigma_zz$ is positive in compression and 0 for $r$ > $a$",
        ];
        if self.relations.pressure.is_none() {
            notes
                .push("$f'$ is infinite at a breakpoint and $g$ jumps there, or is not known to be continuous: $p(r)$ has no formula here");
        }
        if self.has_rim() {
            notes.push("$a$ is the radius of the rim, whatever the depth is");
        } else if self.relations.contact_radius_of_depth.is_none() {
            notes.push("$a(d)$ and $F(d)$ have no explicit form that is known here; $g(a)$ = $d$ is solved in numbers");
        }
        let pressure = self.relations.pressure.as_ref().filter(|_| self.asked.is_empty() || self.asked.contains(&Quantity::Pressure));
        let reasons = pressure.map_or_else(Vec::new, |own| open_pressure::reasons(&own.formula));
        let all = notes.into_iter().map(Prose::read).chain(reasons).chain(rounding(self.presentation));
        all.map(|own| own.presented(self.presentation)).collect()
    }

    /// The conditions as they are presented.
    pub fn conditions(&self) -> Vec<Prose> {
        self.relations.conditions.iter().map(|own| own.presented(self.presentation)).collect()
    }

    /// True for a punch with a rim at the contact radius.
    pub(super) fn has_rim(&self) -> bool {
        matches!(self.edge, Edge::Rim(_))
    }
}

/// What a reader of rounded formulas must know.
pub(super) fn rounding(presentation: &Presentation) -> Option<Prose> {
    let digits = presentation.digits?;
    Some(Prose::words(&format!("numbers are rounded to {digits} significant digit{}", if digits == 1 { "" } else { "s" })))
}

/// The numbers that `eval` found.
pub struct Evaluation<'a> {
    /// The quantity's symbol.
    pub quantity: &'static str,
    /// The symbol of the coordinate at which it was asked for.
    pub coordinate: &'static str,
    /// The profile as it was typed.
    pub profile: &'a Formula,
    /// The parameters with the numbers that stand for them.
    pub parameters: Vec<(String, f64)>,
    /// E*.
    pub effective_modulus: f64,
    /// The contact radius, where the quantity needs one.
    pub radius: Option<f64>,
    /// The depth of a punch with a rim.
    pub depth: Option<f64>,
    /// f(0), where something had to be subtracted.
    pub shift: Option<Shift>,
    /// The coordinates.
    pub at: Vec<f64>,
    /// The readings, one per coordinate.
    pub readings: Vec<Measured>,
    /// The results of all ways at each coordinate, if requested.
    pub ways: Option<Vec<Vec<Asked>>>,
    /// The units in which all of these are counted.
    pub units: Units,
}

/// Names of units, empty where numbers are bare.
#[derive(Default)]
pub struct Units {
    /// Of the coordinates, the radius and the depth.
    pub at: String,
    /// Of the values.
    pub value: String,
    /// Of the effective modulus.
    pub modulus: String,
    /// Of the parameters, in their order.
    pub parameters: Vec<String>,
}

/// f(0), which was subtracted.
pub struct Shift {
    /// As an expression of what was typed.
    pub expr: Expr,
    /// As a number.
    pub value: f64,
}

impl Evaluation<'_> {
    /// True where the budget of work did not suffice for a point.
    pub fn is_cut(&self) -> bool {
        self.readings.iter().any(|own| matches!(own, Err(Reason::Unfinished)))
    }

    /// The way that all finite values were found, or `mixed`.
    pub fn method(&self) -> &'static str {
        let mut methods = self.readings.iter().filter_map(|reading| reading.as_ref().ok()).map(|reading| reading.method);
        match methods.next() {
            None => "exact",
            Some(first) if methods.all(|method| method == first) => first,
            Some(_) => "mixed",
        }
    }
}

/// The outcome of `compare`.
pub struct Compared<'a> {
    /// The profile as it was typed.
    pub profile: &'a Formula,
    /// What was compared.
    pub comparisons: &'a Comparisons,
}

impl Compared<'_> {
    /// The reason why the comparison is incomplete; `None` if it is complete.
    pub fn why(&self) -> Option<&'static str> {
        (!self.comparisons.is_complete).then_some("the budget of work did not suffice for the comparison")
    }
}
