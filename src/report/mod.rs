//! Reports: plain records of what was found, and one file per output format that writes them.

#[cfg(feature = "cli")]
pub mod inversion;
#[cfg(feature = "cli")]
pub mod json;
pub mod latex;
pub mod markdown;
pub mod mathml;
#[cfg(feature = "cli")]
mod npy;
mod record;
#[cfg(feature = "cli")]
mod reference;
#[cfg(feature = "scene")]
mod solved;
#[cfg(feature = "cli")]
pub mod solved_json;
#[cfg(feature = "cli")]
pub mod solved_npz;
#[cfg(feature = "scene")]
pub mod solved_text;
#[cfg(feature = "scene")]
mod solved_tip;
#[cfg(feature = "cli")]
mod solved_tip_json;
mod statement;
pub mod text;
#[cfg(feature = "cli")]
pub mod tradeoff;
pub mod typst;
#[cfg(feature = "cli")]
pub mod validation;

#[cfg(feature = "cli")]
pub use inversion::{Inversion, Wanted};
pub use record::{Compared, Derivation, Entry, Evaluation, Shift};
#[cfg(feature = "cli")]
pub use reference::Reference;
#[cfg(feature = "scene")]
pub use solved::{ASSUMPTIONS, Verdict};
pub use statement::Statement;
#[cfg(feature = "cli")]
pub use tradeoff::Tradeoff;
