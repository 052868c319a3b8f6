//! Code in other languages: the closed forms of a profile as functions that keep their digits, with a bound on their error.
//!
//! An expression is walked as it is for numbers, in its evaluated form, and becomes a small program (`tree.rs`); the stable forms that it
//! calls are written down once in a language of their own (`forms.txt`, `special.txt`, `quadrature.txt`); every target writes that program with its own words.
//! The same program runs with running error bounds (`accuracy.rs`), and the largest of them is what its comment claims.

mod accuracy;
mod build;
mod claim;
mod error;
mod gaussian;
mod languages;
mod lower;
mod names;
mod program;
mod read;
mod search;
mod series;
mod summed;
mod tree;
mod truth;

use std::sync::LazyLock;

pub use build::program;
pub use error::CodeError;
pub use languages::write;
pub use program::{Claim, Language, NamedShape, Program, QUANTITIES};

/// The stable forms, and the special functions; `None` if their text cannot be read.
static FORMS: LazyLock<Option<Vec<tree::Routine>>> =
    LazyLock::new(|| read::routines(concat!(include_str!("forms.txt"), include_str!("special.txt"), include_str!("quadrature.txt"))));

/// Private parts that tests in `tests/` look at; not part of the interface.
#[doc(hidden)]
pub mod inner {
    pub use super::names::identifiers;
}
