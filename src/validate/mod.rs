//! A solver's data beside the exact solution: errors, order of convergence, a verdict, and what the fault looks like.

mod array;
mod column;
mod data;
mod diagnosis;
mod displacement;
mod error;
mod exact;
mod field;
mod hypothesis;
mod lattice;
mod layout;
mod loads;
mod norms;
mod order;
mod pixel;
mod placing;
mod record;
mod run;
mod score;
mod stacked;
mod survey;
mod table;
mod units;
mod verdict;

pub use data::Source;
pub use error::ValidationError;
pub use layout::{Layout, Origin};
pub use order::Order;
pub use record::{Beyond, Column, Excluded, FileReport, Plot, Suspicion, Validation};
pub use run::{Request, validate};

/// Private parts that tests in `tests/` look at; not part of the interface.
#[doc(hidden)]
pub mod inner {
    pub use super::array::array;
    pub use super::displacement::Displacements;
    pub use super::lattice::{Offset, of_areas, of_distances};
    pub use super::order::{Level, limit_error, order};
    pub use super::placing::{Extent, placings};
}
