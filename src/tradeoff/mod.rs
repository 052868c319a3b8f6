//! The trade of speed for accuracy, measured: every method at its ladder of settings, with true error, time and evaluations.

mod candidate;
mod clock;
mod error;
mod front;
mod measure;
pub(crate) mod methods;
mod problem;
mod study;
mod truth;

pub use crate::contact::Quantity;
pub use error::TradeoffError;
pub use front::{Advice, WANTED};
pub use measure::{Row, Skipped, Time};
pub use problem::Problem;
pub use study::{Options, Study, run};
pub use truth::{MARGIN, Truth};
