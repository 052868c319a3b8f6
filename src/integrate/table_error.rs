//! What can be wrong with a table of points.

use thiserror::Error;

/// Why a table of points makes no profile; places count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum TableError {
    /// Two columns of different lengths.
    #[error("the table has {radii} radii but {heights} heights; as many of the one as of the other would be accepted")]
    Lengths {
        /// Number of radii.
        radii: usize,
        /// Number of heights.
        heights: usize,
    },
    /// Too few points.
    #[error("the table has {given} points; at least {needed} would be accepted")]
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
    #[error("point {index} of the table has the negative radius {radius:?}; r >= 0 would be accepted")]
    Negative {
        /// Which point.
        index: usize,
        /// Its radius.
        radius: f64,
    },
    /// Radii that do not rise.
    #[error("point {index} of the table has r = {radius:?} after r = {before:?}; rising radii would be accepted")]
    Unsorted {
        /// Which point.
        index: usize,
        /// Its radius.
        radius: f64,
        /// The radius of the point before.
        before: f64,
    },
    /// The same radius twice.
    #[error("points {before} and {index} of the table have the same radius {radius:?}; one of them, or their mean, would be accepted")]
    Duplicate {
        /// The later point.
        index: usize,
        /// The earlier point.
        before: usize,
        /// Their radius.
        radius: f64,
    },
    /// A penalty or noise that no spline has.
    #[error("the {what} is {got:?}; {accepted} would be accepted")]
    Penalty {
        /// What was given.
        what: &'static str,
        /// Its value.
        got: f64,
        /// What would be accepted.
        accepted: &'static str,
    },
    /// Pieces that do not join, or whose coefficients are not finite.
    #[error(
        "piece {index} of the table does not join the one before, is empty, or is not finite; pieces from one radius to the next would be accepted"
    )]
    Piece {
        /// Which piece.
        index: usize,
    },
    /// A spline whose equations left the range of doubles.
    #[error("the spline through these points leaves the range of doubles; other units would be accepted")]
    OutOfRange,
}
