//! Reports of a validation: text for the screen, JSON, and a page with plots.

pub mod html;
pub mod json;
mod plot;
pub mod text;
