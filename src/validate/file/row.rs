//! The numbers of one load.

/// One load; NaN for missing columns. In computing units and positive in compression.
#[derive(Clone, Copy, Debug)]
pub(in crate::validate) struct Row {
    pub(in crate::validate) depth: f64,
    pub(in crate::validate) force: f64,
    pub(in crate::validate) radius: f64,
}
