//! The accumulated results of comparing closed forms with quadrature.

use crate::num::Estimate;

/// If the sum of both bounds exceeds this fraction of the value, a comparison is inconclusive.
const TELLING: f64 = 1e-6;

/// The verdict of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Closed forms were compared, and every difference is within the sum of both error bounds.
    Passed,
    /// A difference exceeds the sum of both error bounds.
    Failed,
    /// No closed form could be compared with an accurate independent value.
    NotCompared,
}

impl Verdict {
    /// True or false; `None` if nothing was compared.
    pub fn passed(self) -> Option<bool> {
        match self {
            Self::Passed => Some(true),
            Self::Failed => Some(false),
            Self::NotCompared => None,
        }
    }

    /// The text for reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "failed",
            Self::NotCompared => "not compared",
        }
    }
}

/// The comparisons so far.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    /// Number of points with a comparison, counted by the caller.
    pub points: u32,
    /// Number of comparisons.
    pub compared: u32,
    /// The largest |one − other| relative to the size of the value.
    pub largest: f64,
    /// The coordinate at which it is largest; `None` if every value compared was 0.
    pub at: Option<f64>,
    failed: bool,
}

impl Tally {
    /// Compares two values, unless their bounds are too loose for that.
    pub fn take(&mut self, at: f64, own: Estimate, other: Estimate) {
        let difference = (own.value - other.value).abs();
        let size = own.value.abs().max(other.value.abs());
        let bound = own.error + other.error;
        // The comparison is written so that a NaN bound is inconclusive.
        let telling = bound <= TELLING * size;
        if !telling {
            return;
        }
        self.compared += 1;
        if size > 0.0 && (self.at.is_none() || difference / size > self.largest) {
            (self.largest, self.at) = (difference / size, Some(at));
        }
        // The comparison is written so that NaN fails.
        let within = difference <= bound;
        self.failed |= !within;
    }

    /// Passed if every difference is within the sum of both bounds; not compared if all values were zero.
    pub fn verdict(&self) -> Verdict {
        match self {
            Self { at: None, .. } => Verdict::NotCompared,
            Self { failed: true, .. } => Verdict::Failed,
            _ => Verdict::Passed,
        }
    }
}
