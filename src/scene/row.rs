//! What a load gives: its state, the numbers that were asked for, and what speaks against them.

use super::{Quantity, Regime};
use crate::contact::{Indented, Severity};
use crate::num::Estimate;

/// One solved load, in the units of the answers.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The load as it was given, in the units of the answers.
    pub load: f64,
    /// The state in computed units, with all findings.
    pub indented: Indented,
    /// The displacement since the first touch, where it differs from d.
    pub depth_from_touch: Option<f64>,
    /// The numbers that were asked for; `None` with a reason where there is none.
    pub values: Vec<(Quantity, Result<f64, &'static str>)>,
    /// The numbers that take more than d, F and a, such as the strain energy: in computed units, at the radius of the state.
    pub computed: Vec<(Quantity, Estimate)>,
    /// The nearest simple shape, where the profile is none itself and the row is valid.
    pub regime: Option<Regime>,
}

impl Row {
    /// True where no finding is an error.
    pub fn is_valid(&self) -> bool {
        self.indented.is_valid()
    }

    /// The number of a datum, where there is one.
    pub fn value(&self, datum: Quantity) -> Option<f64> {
        self.values.iter().find(|(own, _)| *own == datum).and_then(|(_, value)| value.ok())
    }

    /// The first error's message.
    pub fn why(&self) -> Option<&str> {
        self.indented.findings.iter().find(|own| own.severity == Severity::Error).map(|own| own.message.as_str())
    }
}

/// How often each kind of number was asked of the engine.
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
