//! One method at one setting, ready to be run.

use crate::num::Estimate;

/// A method at one step of its ladder.
pub(super) struct Candidate<'a> {
    /// The method's name, the same for its whole ladder.
    pub(super) method: &'static str,
    /// The step of the ladder.
    pub(super) setting: String,
    /// How a value is computed.
    pub(super) run: Run<'a>,
    /// Everything that comes before the first value, from the profile on.
    pub(super) set_up: Box<dyn Fn() -> Result<(), String> + 'a>,
}

/// How a candidate computes: the transform's values, F/(2E*) and p π/E* among them.
pub(super) enum Run<'a> {
    /// Point by point; the index counts the points of the problem.
    Point(Box<dyn FnMut(usize, f64) -> Result<Estimate, String> + 'a>),
    /// A slice of points at once, without error estimates.
    Slice(Slices<'a>),
}

/// Points in, values out.
pub(super) type Slices<'a> = Box<dyn FnMut(&[f64], &mut [f64]) -> Result<(), String> + 'a>;

/// A method that is left out as a whole, and why.
pub(super) struct Refused {
    pub(super) method: &'static str,
    pub(super) why: String,
}

/// The candidates of one method.
pub(super) type Ladder<'a> = Result<Vec<Candidate<'a>>, Refused>;
