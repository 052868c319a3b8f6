//! Exact and numeric transforms of contact mechanics by the method of dimensionality reduction.

pub mod expr;
pub mod num;
