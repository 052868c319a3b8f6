//! Profiles, solutions and their numbers: the public names of the rooms `derive`, `evaluate` and `integrate`.

pub(crate) use crate::derive::assemble::axial_weight;
pub use crate::derive::assemble::{Derived, Status};
pub use crate::derive::chain::Chain;
pub use crate::derive::closed_form::ClosedForm;
pub(crate) use crate::derive::domain::above_zero::above_zero;
pub use crate::derive::engine::{Solution, derive};
pub use crate::derive::inverse::{FromPressure, Inverse, InverseRule, Reader, TABLE, equivalent_of_pressure, invert};
pub use crate::derive::profile::Profile;
pub use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
pub use crate::derive::rules;
pub use crate::derive::sample::Sampler;
pub use crate::derive::solved::{Agreement, SolvedTerm};
pub use crate::derive::superposed::{EvaluatedChain, Superposed};
pub use crate::derive::term::Term;
pub use crate::derive::verification::{Demotion, Verification};
pub use crate::evaluate::check::{Check, NO_REFERENCE, check};
pub use crate::evaluate::closure::{Closure, ClosureProfile, Parity};
pub use crate::evaluate::curve::{Curve, PressureCurve};
pub use crate::evaluate::evaluator::{Evaluator, Method, Reading};
pub use crate::evaluate::inverse_numbers::{InverseNumbers, check_inverse};
pub use crate::evaluate::quantities::Quantities;
pub use crate::evaluate::reach::reach;
pub use crate::evaluate::reference::PreciseProfile;
pub use crate::evaluate::series::{HIGHEST_ORDER, SeriesEvaluator, SeriesFailure};
pub use crate::evaluate::slices::{Origin, Slice};
pub use crate::evaluate::slopes::{Over, Slopes};
pub use crate::evaluate::superposition::Superposition;
pub use crate::evaluate::table::{Cubic, Interpolation, Penalty, TableProfile};
pub use crate::evaluate::tally::{Tally, Verdict};
pub(crate) use crate::evaluate::waves::wave_numbers;
pub use crate::evaluate::ways::{WAYS, Way};
pub(crate) use crate::integrate::admit::finite_and_not_negative;
pub use crate::integrate::error::TransformError;
pub use crate::integrate::integral::NumericProfile;
pub use crate::integrate::segment::Segment;
pub(crate) use crate::integrate::source::enclosures::sum_of_ranges;
pub use crate::integrate::source::f_prime::FPrimeSource;
pub use crate::integrate::table_error::TableError;

/// Private parts that tests in `tests/` look at; not part of the interface.
#[doc(hidden)]
pub mod inner {
    pub use crate::derive::rules::laurent::{Combination, member};
    pub use crate::derive::rules::reading::{above, exponential_pair, linear, monomial, pair, positive, power, quadratic};
    pub use crate::derive::verification::Gate;
    pub use crate::evaluate::closure::cells::Cells;
    pub use crate::evaluate::table::smoothing::solve as smoothed;
    pub use crate::integrate::integral::Weight;
    pub use crate::integrate::source::centred::centred;
    pub use crate::integrate::source::ends::{Growth, growth};
    pub use crate::integrate::source::leading_power::LeadingPower;
    pub use crate::integrate::source::limit::Limit;
    pub use crate::integrate::source::parity::{Parity, parity};

    /// The intervals of a profile.
    pub fn segments(profile: &crate::integrate::integral::NumericProfile) -> &[crate::integrate::integral::NumericSegment] {
        &profile.segments
    }
}
