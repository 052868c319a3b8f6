//! The notations of a formula: text, Unicode, LaTeX, Typst and MathML, one writer for each.
//!
//! Each writes the tree of `print::math`.
//! The submodules also contain the names of Greek letters and LaTeX symbols.

pub(crate) mod greek;
pub(crate) mod latex;
pub(crate) mod latex_symbol;
pub(crate) mod mathml;
pub(crate) mod text;
pub(crate) mod typst;
pub(crate) mod unicode;
