//! The trade of speed for accuracy, measured: every method at its ladder of settings, with true error, time and evaluations.

mod candidate;
mod clock;
mod closed;
mod curve;
mod error;
mod foundation;
mod front;
mod measure;
mod named_rule;
mod problem;
mod quadrature;
mod series;
mod study;
mod table;
mod truth;

pub use crate::contact::Quantity;
pub use error::TradeoffError;
pub use front::{Advice, WANTED};
pub use measure::{Row, Skipped, Time};
pub use problem::Problem;
pub use study::{Options, Study, run};
pub use truth::{MARGIN, Truth};
