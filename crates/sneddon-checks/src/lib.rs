//! What the test files share: long decimals and ulps, seeded random numbers, formulas as numbers, rows of reference values.
// Every test binary compiles the whole crate but uses only a part of it.
#![allow(dead_code, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

pub mod accuracy;
pub mod chapter;
pub mod decimal;
pub mod estimates;
pub mod formulas;
pub mod functions;
pub mod laws;
pub mod profiles;
pub mod quantities;
pub mod random;
pub mod rows;
pub mod scenes;
pub mod seeds;
pub mod stability;
