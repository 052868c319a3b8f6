//! Reports: plain records of what was found, and one file per output format that writes them.

#[cfg(feature = "cli")]
pub mod json;
pub mod latex;
pub mod markdown;
mod record;
mod statement;
pub mod text;

pub use record::{Compared, Derivation, Entry, Evaluation, Shift};
pub use statement::Statement;
