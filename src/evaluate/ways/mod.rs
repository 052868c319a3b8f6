//! Quantities that combine closed forms with integrals: sums, pressures, heights and energies.
//!
//! Each file extends the evaluator by one quantity.
//! `combine` returns the more accurate of the available results.

pub(crate) mod closed_slope;
pub(crate) mod combine;
pub(crate) mod energy;
pub(crate) mod height;
pub(crate) mod pressure;
