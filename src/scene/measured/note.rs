//! Notes about the corrections to the points of a measured tip.

/// A correction of the points, or a property of them that affects the results.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// A short name: `tip_sorted`, `tip_merged`, `tip_averaged`, `tip_not_monotone`, `tip_extrapolated`, `tip_centred`, …
    pub rule: &'static str,
    /// A sentence for users.
    pub message: String,
    /// The affected radius, in computing units.
    pub at: Option<f64>,
}

impl Note {
    pub(super) fn new(rule: &'static str, message: String, at: Option<f64>) -> Self {
        Self { rule, message, at }
    }
}
