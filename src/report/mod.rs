//! Reports: plain records of what was found, and one file per output format that writes them.

#[cfg(feature = "cli")]
pub mod json;
pub mod latex;
mod record;
pub mod text;

pub use record::{Compared, Derivation, Entry, Evaluation, Shift};
