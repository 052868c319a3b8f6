//! The result for one load: its state, the requested quantities and the findings.

use super::{Quantity, Regime};
use crate::contact::{Indented, Severity};
use crate::num::Estimate;

/// One solved load, in output units.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The load as given, in output units.
    pub load: f64,
    /// The state in computing units, with all findings.
    pub indented: Indented,
    /// The displacement since first touch, if it differs from d.
    pub depth_from_touch: Option<f64>,
    /// The requested quantities; a missing value has a reason.
    pub values: Vec<(Quantity, Result<f64, &'static str>)>,
    /// Quantities that require more than d, F and a, such as the strain energy: in computing units, at the radius of the state.
    pub computed: Vec<(Quantity, Estimate)>,
    /// The closest simple shape, if the profile is not simple itself and the row is valid.
    pub regime: Option<Regime>,
}

/// The rule of the finding that says that the budget was exhausted.
pub(super) const UNFINISHED: &str = "unfinished";

impl Row {
    /// Returns true if no finding is an error.
    pub fn is_valid(&self) -> bool {
        self.indented.is_valid()
    }

    /// Returns whether the load has a valid contact; `None` if the budget was exhausted before that was known.
    pub fn validity(&self) -> Option<bool> {
        let is_cut = self.indented.findings.iter().any(|own| own.rule == UNFINISHED);
        (!is_cut).then(|| self.is_valid())
    }

    /// Returns the value of a quantity, if there is one.
    pub fn value(&self, datum: Quantity) -> Option<f64> {
        self.values.iter().find(|(own, _)| *own == datum).and_then(|(_, value)| value.ok())
    }

    /// Returns the message of the first error.
    pub fn why(&self) -> Option<&str> {
        self.indented.findings.iter().find(|own| own.severity == Severity::Error).map(|own| own.message.as_str())
    }
}

/// Counts the evaluations of each kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Loads solved.
    pub loads: u64,
    /// Values of p.
    pub pressures: u64,
    /// Values of u.
    pub displacements: u64,
    /// Values of the stress on the axis.
    pub stresses: u64,
    /// Values of f and g for curves.
    pub shapes: u64,
    /// Strain energies.
    pub energies: u64,
}
