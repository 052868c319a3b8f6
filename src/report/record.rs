//! The records that all output formats share: derived formulas, values and comparisons.

use super::{infinite_pressure, open_pressure};
use crate::contact::{Comparisons, Edge, Formulas, Measured, Quantity, Reason, Relations, WayResult};
use crate::expr::{Condition, Expr, Formula, Relation, Symbol};
use crate::print::{Presentation, Prose};
use crate::transform::{Check, Derived, Solution, TransformError};
use std::borrow::Cow;

/// The result of `derive`.
pub struct Derivation<'a> {
    /// The solution of the profile, with the given parameter values.
    pub solution: &'a Solution,
    /// f as typed, with the given parameter values.
    pub typed: &'a Formula,
    /// The edge of the contact.
    pub edge: &'a Edge,
    /// The derived relations.
    pub relations: &'a Relations,
    /// The requested quantities in this order; empty for the default.
    pub asked: &'a [Quantity],
    /// How formulas are printed: renamed symbols and rounding.
    pub presentation: &'a Presentation,
    /// The result of the check, or the reason why it was not possible.
    pub check: Result<Check, Unchecked>,
}

/// The reason why formulas were not compared with quadrature.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Unchecked {
    /// The budget was exhausted, so the result is incomplete.
    #[error("the work limit was reached")]
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
    /// Returns the reason why a result with this check is incomplete; `None` if it is complete.
    pub fn why(check: &Result<Check, Self>) -> Option<&'static str> {
        matches!(check, Err(Self::Cut)).then_some("the work limit was reached during the check")
    }
}

/// A derived quantity, or an entry for one without an explicit form.
pub struct Entry<'a> {
    /// The key in JSON.
    pub key: &'static str,
    /// The left side of the equation.
    pub left: &'static str,
    /// The right side with its sources.
    pub derived: Option<Cow<'a, Derived>>,
}

impl Derivation<'_> {
    /// Returns the quantities in reading order, or in the order in which they were requested.
    pub fn entries(&self) -> Vec<Entry<'_>> {
        let usual;
        let list = if self.asked.is_empty() {
            usual = Quantity::USUAL;
            usual.as_slice()
        } else {
            self.asked
        };
        let has_rim = self.has_rim();
        let all = Formulas { relations: self.relations, typed: self.typed, solution: self.solution, has_rim };
        list.iter().map(|own| Entry { key: own.relation(), left: own.left(has_rim), derived: own.formula(&all) }).collect()
    }

    /// Returns f(0) if it was subtracted.
    pub fn shift(&self) -> Option<&Expr> {
        Some(&self.solution.profile.shift).filter(|shift| !shift.is_zero())
    }

    /// Returns f as typed.
    pub fn formula(&self) -> &Formula {
        self.typed
    }

    /// Returns notes about the formulas of these entries.
    pub fn notes(&self, entries: &[Entry<'_>]) -> Vec<Prose> {
        let mut notes = Vec::new();
        if self.relations.pressure.is_none() {
            notes.push(
                "$f'(r)$ is infinite at a breakpoint and $g$ jumps there, or $g$ is not known to be continuous: $p(r)$ has no formula",
            );
        }
        if self.has_rim() {
            notes.push("$a$ is the radius of the rim at every depth");
        } else if self.relations.contact_radius_of_depth.is_none() {
            notes.push("no explicit form of $a(d)$ and $F(d)$ is known; $g(a)$ = $d$ is solved numerically");
        }
        let pressure = self.relations.pressure.as_ref().filter(|_| self.asked.is_empty() || self.asked.contains(&Quantity::Pressure));
        let reasons = pressure.map_or_else(Vec::new, |own| open_pressure::reasons(&own.formula));
        let infinite = pressure.and_then(|_| infinite_pressure::note(&self.solution.profile));
        if self.relations.conditions.iter().flat_map(Prose::conditions).any(may_hold_again) {
            notes.push("a condition on $r$ must hold at every radius from 0 to $a$");
        }
        notes.extend(entries.iter().filter_map(open_field));
        let notes = notes.into_iter().map(Prose::read);
        let all = conventions().into_iter().chain(notes).chain(reasons).chain(infinite).chain(rounding(self.presentation));
        all.map(|own| own.presented(self.presentation)).collect()
    }

    /// Returns the conditions with renamed symbols.
    pub fn conditions(&self) -> Vec<Prose> {
        self.relations.conditions.iter().map(|own| own.presented(self.presentation)).collect()
    }

    /// Returns true for a punch with a rim at the contact radius.
    pub(super) fn has_rim(&self) -> bool {
        matches!(self.edge, Edge::Rim(_))
    }
}

/// Why a displacement outside the contact, or a stress on the axis, has an integral or no formula.
fn open_field(entry: &Entry<'_>) -> Option<&'static str> {
    let has_integral = entry.derived.as_ref().map(|own| own.formula.has_integral());
    Some(match (entry.key, has_integral) {
        ("u", Some(true)) => {
            "the integral in $u(r)$ is over $g'(x)$; outside the contact, the program has closed forms for powers, spheres, ellipsoids and \
             hyperboloids, and for pieces with $f'(r)$ = $c_0 + c_1*r$"
        }
        ("sigma_zz", Some(true)) => {
            "the integral in $sigma_zz(z)$ is over $g'(x)$; on the axis, the program has closed forms for powers, and for pieces with $f'(r)$ = \
             $c*r$"
        }
        ("u", None) => "a part of $g(x)$ has no closed form, so $u(r)$ outside the contact has no formula over $g'(x)$",
        ("sigma_zz", None) => "a part of $g(x)$ has no closed form, so $sigma_zz(z)$ has no formula over $g'(x)$",
        _ => return None,
    })
}

/// True for a condition on r that may hold again beyond the end of the profile, as 0 < cos(c)*cos(r/b + c) does; r < b does not.
fn may_hold_again(condition: &Condition) -> bool {
    let r = Symbol::new("r");
    condition.right.contains(&r) || (condition.left.contains(&r) && condition.left.as_symbol() != Some(&r))
}

/// The conventions of every answer.
fn conventions() -> [Prose; 3] {
    let share = |body: &str| (Expr::one() - Expr::symbol(&format!("nu_{body}")).power(2)) / Expr::symbol(&format!("E_{body}"));
    let modulus = Condition::equal(Expr::one() / Expr::symbol("E"), share("1") + share("2"));
    let positive = Condition { left: Expr::zero(), relation: Relation::LessOrEqual, right: Expr::symbol("x") };
    [
        Prose::words("the formulas apply for ").condition(positive).then("; $g$ is even"),
        Prose::read("$E$ is the effective modulus: ").condition(modulus).then(" for the moduli and Poisson's ratios of the two bodies"),
        Prose::default()
            .condition(Condition::equal(Expr::symbol("p"), -Expr::symbol("sigma_zz")))
            .then(" is positive in compression and 0 for ")
            .condition(Condition::less(Expr::symbol("a"), Expr::symbol("r"))),
    ]
}

/// Returns a note about rounded formulas.
pub(super) fn rounding(presentation: &Presentation) -> Option<Prose> {
    let digits = presentation.digits?;
    Some(Prose::words(&format!("numbers are rounded to {digits} significant digit{}", if digits == 1 { "" } else { "s" })))
}

/// The result of `eval`.
pub struct Evaluation<'a> {
    /// The symbol of the quantity.
    pub quantity: &'static str,
    /// The symbol of the coordinate.
    pub coordinate: &'static str,
    /// The profile as typed.
    pub profile: &'a Formula,
    /// The parameters with their values.
    pub parameters: Vec<(String, f64)>,
    /// E*.
    pub effective_modulus: f64,
    /// The contact radius, if the quantity requires one.
    pub radius: Option<f64>,
    /// The depth of a punch with a rim.
    pub depth: Option<f64>,
    /// f(0), if it was subtracted.
    pub shift: Option<Shift>,
    /// The coordinates.
    pub at: Vec<f64>,
    /// The readings, one per coordinate.
    pub readings: Vec<Measured>,
    /// The results of all methods at each coordinate, if requested.
    pub ways: Option<Vec<Vec<WayResult>>>,
    /// The units of all values.
    pub units: UnitNames,
}

/// Names of units, empty for numbers without units.
#[derive(Default)]
pub struct UnitNames {
    /// The unit of the coordinates, the radius and the depth.
    pub at: String,
    /// The unit of the values.
    pub value: String,
    /// The unit of the effective modulus.
    pub modulus: String,
    /// The units of the parameters, in the same order.
    pub parameters: Vec<String>,
}

/// f(0), which was subtracted.
pub struct Shift {
    /// As an exact expression.
    pub expr: Expr,
    /// As a number.
    pub value: f64,
}

impl Evaluation<'_> {
    /// Returns true if the work budget was exhausted at a point, or before all ways were asked.
    pub fn is_cut(&self) -> bool {
        let ways = self.ways.iter().flatten().flatten();
        self.readings.iter().any(|own| matches!(own, Err(Reason::Unfinished))) || ways.into_iter().any(WayResult::is_cut)
    }

    /// Returns the method of all finite values, or `mixed`.
    pub fn method(&self) -> &'static str {
        let mut methods = self.readings.iter().filter_map(|reading| reading.as_ref().ok()).map(|reading| reading.method);
        match methods.next() {
            None => "exact",
            Some(first) if methods.all(|method| method == first) => first,
            Some(_) => "mixed",
        }
    }
}

/// The result of `compare`.
pub struct Compared<'a> {
    /// The profile as typed.
    pub profile: &'a Formula,
    /// The comparisons.
    pub comparisons: &'a Comparisons,
}

impl Compared<'_> {
    /// Returns the reason why the comparison is incomplete; `None` if it is complete.
    pub fn why(&self) -> Option<&'static str> {
        (!self.comparisons.is_complete).then_some("the work limit was reached during the comparison")
    }
}
