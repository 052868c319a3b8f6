//! What comparisons of closed forms with quadrature found so far.

use crate::num::Estimate;

/// Where the two bounds add up to more than this share of the value, agreement proves nothing.
const TELLING: f64 = 1e-6;

/// How a check ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Closed forms were compared, and every difference stays within the sum of both error bounds.
    Passed,
    /// A difference exceeds the sum of both error bounds.
    Failed,
    /// Nothing closed could be compared with an independent value that has digits.
    NotCompared,
}

impl Verdict {
    /// True or false; `None` where nothing was compared.
    pub fn passed(self) -> Option<bool> {
        match self {
            Self::Passed => Some(true),
            Self::Failed => Some(false),
            Self::NotCompared => None,
        }
    }

    /// The words that reports use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "failed",
            Self::NotCompared => "not compared",
        }
    }
}

/// What was compared so far.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    /// Number of points at which something was compared; the caller counts them.
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
        // Written so that a bound that is no number is not telling.
        let telling = bound <= TELLING * size;
        if !telling {
            return;
        }
        self.compared += 1;
        if size > 0.0 && (self.at.is_none() || difference / size > self.largest) {
            (self.largest, self.at) = (difference / size, Some(at));
        }
        // Written so that a NaN fails.
        let within = difference <= bound;
        self.failed |= !within;
    }

    /// Passed where every difference stays within the sum of both bounds; not compared where only zeros met.
    pub fn verdict(&self) -> Verdict {
        match self {
            Self { at: None, .. } => Verdict::NotCompared,
            Self { failed: true, .. } => Verdict::Failed,
            _ => Verdict::Passed,
        }
    }
}
