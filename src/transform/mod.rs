//! The heart: from a profile to its terms, from terms to exact answers or integrals, and from both to numbers.

mod assemble;
mod check;
mod closed;
mod domain;
mod engine;
mod error;
mod evaluator;
mod integral;
mod inverse;
mod kinks;
mod profile;
mod quantity;
mod rule;
pub mod rules;
mod sample;
mod series;
mod slope_source;
mod stream;
mod stress;
mod term;

pub use assemble::{Derived, Status};
pub use check::{Check, check};
pub use closed::ClosedForm;
pub use engine::{Solution, derive};
pub use error::TransformError;
pub use evaluator::{Evaluator, Method, Reading};
pub use integral::NumericProfile;
pub use inverse::{FromPressure, Inverse, InverseNumbers, InverseRule, Reader, TABLE, check_inverse, equivalent_of_pressure, invert};
pub use profile::{Chain, Profile};
pub use quantity::Quantity;
pub use rule::{Answer, Branches, Pair, Parameter, Rule};
pub use sample::{Sampler, reach};
pub use series::{HIGHEST_ORDER, SeriesEvaluator, SeriesFailure};
pub use slope_source::SlopeSource;
pub use term::{Segment, Term};
