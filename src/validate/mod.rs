//! Compares a solver's data with the exact solution: errors, order of convergence, verdict, and diagnosis.

mod diagnosis;
mod error;
mod exact;
mod field;
pub(crate) mod file;
mod loads;
mod mirrored;
mod neighbours;
mod norms;
mod order;
mod peak;
mod record;
mod region;
mod rim;
mod run;
mod shells;
mod verdict;

pub use error::ValidationError;
pub use file::data::Source;
pub use file::layout::{Layout, Origin};
pub use file::points::points;
pub use order::Order;
pub use record::{Beyond, Column, Excluded, FileReport, Plot, Suspicion, Validation};
pub use run::{Request, validate};

/// Private items used by tests in `tests/`; not part of the public interface.
#[doc(hidden)]
pub mod inner {
    pub use super::diagnosis::displacement::Displacements;
    pub use super::diagnosis::placing::{Extent, placings};
    pub use super::file::array::array;
    pub use super::file::lattice::{Offset, of_areas, of_distances};
    pub use super::order::{Level, limit_error, order};
}
