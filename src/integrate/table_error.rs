//! Errors in a table of points.

use thiserror::Error;

/// Why a table of points does not define a profile; indices count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum TableError {
    /// Two columns of different lengths.
    #[error("the table has {radii} radii but {heights} heights; expected equal numbers")]
    Lengths {
        /// Number of radii.
        radii: usize,
        /// Number of heights.
        heights: usize,
    },
    /// Too few points.
    #[error("the table has {given} points; expected at least {needed}")]
    TooFew {
        /// Number of points.
        given: usize,
        /// The smallest number.
        needed: usize,
    },
    /// NaN or an infinity.
    #[error("point {index} of the table is not a pair of finite numbers (r = {radius:?}, z = {height:?})")]
    NotFinite {
        /// Which point.
        index: usize,
        /// Its radius.
        radius: f64,
        /// Its height.
        height: f64,
    },
    /// A negative radius.
    #[error("point {index} of the table has the negative radius {radius:?}; expected r >= 0")]
    Negative {
        /// Which point.
        index: usize,
        /// Its radius.
        radius: f64,
    },
    /// Radii that do not increase.
    #[error("point {index} of the table has r = {radius:?} after r = {before:?}; expected increasing radii")]
    Unsorted {
        /// Which point.
        index: usize,
        /// Its radius.
        radius: f64,
        /// The radius of the point before.
        before: f64,
    },
    /// The same radius twice.
    #[error(
        "points {before} and {index} of the table have the same radius {radius:?}; expected distinct radii: keep one point, or take the mean"
    )]
    Duplicate {
        /// The later point.
        index: usize,
        /// The earlier point.
        before: usize,
        /// Their radius.
        radius: f64,
    },
    /// An invalid penalty or noise of a spline.
    #[error("the {what} is {got:?}; expected {accepted}")]
    Penalty {
        /// The parameter.
        what: &'static str,
        /// Its value.
        got: f64,
        /// The expected value.
        accepted: &'static str,
    },
    /// Pieces that do not join, or whose coefficients are not finite.
    #[error("piece {index} of the table does not join the previous piece, is empty, or is not finite; expected contiguous pieces")]
    Piece {
        /// Which piece.
        index: usize,
    },
    /// A spline whose equations left the range of doubles.
    #[error("the spline through these points leaves the range of doubles; use other units")]
    OutOfRange,
}
