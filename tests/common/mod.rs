//! What the test files share: long decimals and ulps, seeded random numbers, formulas as numbers, rows of reference values.
// Every test binary compiles all of this and uses its own part.
#![allow(dead_code, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

pub(crate) mod accuracy;
pub(crate) mod decimal;
pub(crate) mod estimates;
pub(crate) mod formulas;
pub(crate) mod laws;
pub(crate) mod profiles;
pub(crate) mod quantities;
pub(crate) mod random;
pub(crate) mod rows;
pub(crate) mod scenes;
pub(crate) mod seeds;
pub(crate) mod stability;
pub(crate) mod stability_page;
