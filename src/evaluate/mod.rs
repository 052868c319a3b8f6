//! Numbers from a solution: closed forms where they keep their digits, quadrature for the rest, and the error of both.
//!
//! `ways` contains the quantities that combine closed forms with integrals; `curve`, `table` and `closure` contain profiles that are not
//! given by a formula.
//! `check` compares closed forms with quadrature.

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
pub(crate) mod waves;
pub(crate) mod ways;
