//! Reports: plain records of the results, and one file per output format.

mod digits;
mod infinite_pressure;
#[cfg(feature = "data")]
pub mod inversion;
#[cfg(feature = "data")]
pub mod json;
#[cfg(feature = "data")]
mod npy;
mod open_pressure;
pub mod page;
#[cfg(feature = "cli")]
mod palette;
#[cfg(feature = "cli")]
pub mod picture;
#[cfg(feature = "data")]
pub mod power_constants;
mod record;
#[cfg(feature = "data")]
mod reference;
mod sheet;
#[cfg(feature = "scene")]
pub mod solved;
mod statement;
pub mod text;
#[cfg(feature = "cli")]
pub mod tradeoff;
#[cfg(feature = "data")]
pub mod validation;

pub use digits::Digits;
#[cfg(feature = "data")]
pub use inversion::{Inversion, Wanted};
pub use record::{Compared, Derivation, Entry, Evaluation, Shift, Unchecked, UnitNames};
#[cfg(feature = "data")]
pub use reference::Reference;
#[cfg(feature = "scene")]
pub use solved::{ASSUMPTIONS, Verdict};
pub use statement::Statement;
#[cfg(feature = "cli")]
pub use tradeoff::Tradeoff;

/// Private items used by tests in `tests/`; not part of the public interface.
#[cfg(feature = "data")]
#[doc(hidden)]
pub mod inner {
    pub use super::npy::header;
    #[cfg(feature = "cli")]
    pub use super::picture::axis::Axis;
}
