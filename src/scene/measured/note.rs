//! What was done to the points of a measured tip.

/// Something that was done to the points, or is worth knowing about them.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// A short name: `tip_sorted`, `tip_merged`, `tip_averaged`, `tip_not_monotone`, `tip_extrapolated`, `tip_centred`, …
    pub rule: &'static str,
    /// A sentence.
    pub message: String,
    /// The radius that is meant, in computed units.
    pub at: Option<f64>,
}

impl Note {
    pub(super) fn new(rule: &'static str, message: String, at: Option<f64>) -> Self {
        Self { rule, message, at }
    }
}
