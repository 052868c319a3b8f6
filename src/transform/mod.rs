//! The heart: from a profile to its terms, from terms to exact answers or integrals, and from both to numbers.

mod admit;
mod analytic_bound;
mod angle_substitution;
mod angles;
mod assemble;
mod axial;
mod axis_pieces;
mod barrier;
mod bisected;
mod centred;
mod check;
mod closed;
mod closed_slope;
mod closure;
mod combine;
mod curve;
mod demands;
mod domain;
mod enclosures;
mod endpoint;
mod ends;
mod energy;
mod engine;
mod error;
mod evaluator;
mod first_zero;
mod height;
mod integral;
mod inverse;
mod kinks;
mod leading_power;
mod limit;
mod local_polynomials;
mod over_angle;
mod parity;
mod pieces;
mod pressure;
mod profile;
mod quantities;
mod reference;
mod removable;
mod rule;
pub mod rules;
mod sample;
mod series;
mod slices;
mod slope_source;
mod slopes;
mod stream;
mod stress;
mod stress_pieces;
mod stress_series;
mod stress_slopes;
mod superposed;
mod superposition;
mod table;
mod tally;
mod term;
mod typed;
mod verification;

pub(crate) use admit::finite_and_not_negative;
pub use assemble::{Derived, Status};
pub use check::{Check, NO_REFERENCE, check};
pub use closed::ClosedForm;
pub use closure::{Closure, ClosureProfile, Parity};
pub use curve::{Curve, PressureCurve};
pub use engine::{Solution, SolvedTerm, derive};
pub use error::TransformError;
pub use evaluator::{Evaluator, Method, Reading};
pub use integral::NumericProfile;
pub use inverse::{FromPressure, Inverse, InverseNumbers, InverseRule, Reader, TABLE, check_inverse, equivalent_of_pressure, invert};
pub use profile::{Chain, Profile};
pub use quantities::Quantities;
pub use reference::PreciseProfile;
pub use rule::{Answer, Branches, Pair, Parameter, Rule};
pub use sample::{Sampler, reach};
pub use series::{HIGHEST_ORDER, SeriesEvaluator, SeriesFailure};
pub use slices::Slice;
pub use slope_source::SlopeSource;
pub use slopes::{Over, Slopes};
pub use superposed::{EvaluatedChain, Superposed};
pub use superposition::Superposition;
pub use table::{Cubic, Interpolation, Penalty, TableError, TableProfile};
pub use tally::{Tally, Verdict};
pub use term::{Segment, Term};
pub use verification::{Agreement, Demotion, Verification};

/// Private parts that tests in `tests/` look at; not part of the interface.
#[doc(hidden)]
pub mod inner {
    pub use super::centred::centred;
    pub use super::closure::cells::Cells;
    pub use super::ends::{Growth, growth};
    pub use super::integral::Weight;
    pub use super::leading_power::LeadingPower;
    pub use super::limit::Limit;
    pub use super::parity::{Parity, parity};
    pub use super::rules::laurent::{Combination, member};
    pub use super::rules::reading::{above, exponential_pair, linear, monomial, pair, positive, power, quadratic};
    pub use super::table::smoothing::solve as smoothed;
    pub use super::verification::Gate;

    /// The intervals of a profile.
    pub fn segments(profile: &super::NumericProfile) -> &[super::integral::NumericSegment] {
        &profile.segments
    }
}
