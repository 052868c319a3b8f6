//! From a profile to its exact solution: chains of smooth pieces, their terms, the rules for the terms, the assembled formulas.
//!
//! `verification` compares every closed form with quadrature before it is used; `inverse` computes f from g.
//! From `integrate`, this module uses only the numeric profile of a term.

pub(crate) mod angles;
pub(crate) mod assemble;
pub(crate) mod chain;
pub(crate) mod closed_form;
pub(crate) mod domain;
pub(crate) mod engine;
pub(crate) mod inverse;
mod jumps;
pub(crate) mod kinks;
pub(crate) mod profile;
pub(crate) mod rule;
pub mod rules;
pub(crate) mod sample;
pub(crate) mod solved;
pub(crate) mod stream;
pub(crate) mod superposed;
pub(crate) mod term;
pub(crate) mod verification;
