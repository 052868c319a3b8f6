//! The numbers of one load.

/// One load; NaN where the file has no such column. Computed units, positive in compression.
#[derive(Clone, Copy, Debug)]
pub(in crate::validate) struct Row {
    pub(in crate::validate) depth: f64,
    pub(in crate::validate) force: f64,
    pub(in crate::validate) radius: f64,
}
