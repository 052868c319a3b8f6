//! Numbers from a solution: closed forms where they keep their digits, quadrature for the rest, and the error of both.
//!
//! `ways` has what is composed of closed forms and integrals; `curve`, `table` and `closure` are profiles that are no formula.
//! Checks and comparisons of closed forms with quadrature live here as well.

pub(crate) mod check;
pub(crate) mod closure;
pub(crate) mod curve;
pub(crate) mod evaluator;
pub(crate) mod inverse_numbers;
pub(crate) mod local_polynomials;
pub(crate) mod quantities;
pub(crate) mod reach;
pub(crate) mod reference;
pub(crate) mod series;
pub(crate) mod slices;
pub(crate) mod slopes;
pub(crate) mod superposition;
pub(crate) mod table;
pub(crate) mod tally;
pub(crate) mod typed;
pub(crate) mod ways;
