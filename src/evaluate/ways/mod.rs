//! Quantities that are composed of closed forms and integrals: sums, pressures, heights and energies.
//!
//! Each extends the evaluator by one quantity.
//! `combine` takes whichever way has more digits.

pub(crate) mod closed_slope;
pub(crate) mod combine;
pub(crate) mod energy;
pub(crate) mod height;
pub(crate) mod pressure;
