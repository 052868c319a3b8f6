//! Errors of contact problems.

use crate::num::{Exhausted, NumError};
use crate::transform::TransformError;
use thiserror::Error;

/// Errors of the contact layer.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ContactError {
    /// A material constant is out of its range.
    #[error("{name} = {value} is not possible: {accepted}")]
    Material {
        /// The constant.
        name: &'static str,
        /// Its value.
        value: f64,
        /// The expected value.
        accepted: &'static str,
    },
    /// A quantity needs something that was not given.
    #[error("{quantity} needs {needs}")]
    Missing {
        /// The quantity.
        quantity: &'static str,
        /// The missing input, and how to specify it.
        needs: &'static str,
    },
    /// No contact radius exists for the depth.
    #[error("no contact radius belongs to d = {depth:?}: {reason}")]
    Unreachable {
        /// The indentation depth.
        depth: f64,
        /// Why not.
        reason: &'static str,
    },
    /// The search found no contact radius for the depth, but cannot exclude one.
    #[error("no contact radius was found for d = {depth:?}: {reason}")]
    NotFound {
        /// The indentation depth.
        depth: f64,
        /// Where the search ended.
        reason: &'static str,
    },
    /// No contact radius was found for the force.
    #[error("no contact radius was found for F = {force:?}: {reason}")]
    ForceUnreachable {
        /// The normal force.
        force: f64,
        /// Why not.
        reason: &'static str,
    },
    /// The number of springs is out of range.
    #[error("a spring foundation cannot have {springs} springs; expected 1 to {limit}")]
    Springs {
        /// The requested number.
        springs: usize,
        /// The largest number.
        limit: usize,
    },
    /// The transform failed.
    #[error(transparent)]
    Transform(#[from] TransformError),
}

impl From<NumError> for ContactError {
    fn from(error: NumError) -> Self {
        Self::Transform(error.into())
    }
}

impl From<Exhausted> for ContactError {
    fn from(error: Exhausted) -> Self {
        Self::Transform(error.into())
    }
}
