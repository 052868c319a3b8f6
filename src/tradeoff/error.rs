//! Why nothing can be measured.

use crate::transform::TransformError;
use thiserror::Error;

/// Errors of a study.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TradeoffError {
    /// An error of the profile.
    #[error(transparent)]
    Transform(#[from] TransformError),
    /// The methods are not compared for this quantity.
    #[error("{key} is not measured; expected g, F or p")]
    Quantity {
        /// The key of the quantity.
        key: &'static str,
    },
    /// No point has a reference value.
    #[error("no reference value was found in time at any point ({reason}); use other points or a larger budget")]
    NoReference {
        /// The error at the last point.
        reason: String,
    },
}
