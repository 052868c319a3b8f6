//! Exact and numeric transforms of contact mechanics by the method of dimensionality reduction.

pub mod num;
