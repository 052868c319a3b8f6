//! The methods that are compared: one file for each, with its ladder of settings.
//!
//! The list is in `tradeoff::candidate`.
//! A method gives values and counts what they cost.

pub(crate) mod closed;
pub(crate) mod curve;
pub(crate) mod foundation;
pub(crate) mod named_rule;
pub(crate) mod quadrature;
pub(crate) mod series;
pub(crate) mod table;
