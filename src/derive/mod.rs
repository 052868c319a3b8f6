//! From a profile to its exact solution: chains of smooth pieces, their terms, the rules that answer them, and the formulas put together.
//!
//! The gate (`verification`) compares every closed form with quadrature before anything uses it; `inverse` goes from g back to f.
//! Of `integrate` it uses the numeric profile that a term makes.

pub(crate) mod angles;
pub(crate) mod assemble;
pub(crate) mod chain;
pub(crate) mod closed_form;
pub(crate) mod domain;
pub(crate) mod engine;
pub(crate) mod inverse;
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
