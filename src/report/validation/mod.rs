//! Reports of a validation: text for the screen, JSON, and a page with plots.

#[cfg(feature = "cli")]
pub mod html;
pub mod json;
#[cfg(feature = "cli")]
mod plot;
pub mod text;
