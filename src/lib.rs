//! Exact and numeric transforms of contact mechanics by the method of dimensionality reduction.

#[cfg(feature = "cli")]
pub mod cli;
pub mod contact;
pub mod eval;
pub mod expr;
pub mod num;
pub mod parse;
pub mod print;
pub mod report;
pub mod scene;
#[cfg(feature = "cli")]
pub mod tradeoff;
pub mod transform;
