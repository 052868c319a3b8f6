//! Expansions in Jacobi polynomials: rules, coefficients, half-order integrals, and short polynomials for fast evaluation.

mod abel;
mod contact;
mod dense;
mod jacobi;
mod local;
mod rule;

pub(crate) use abel::{Power, above, beyond, right_sided, times_distance};
pub(crate) use contact::{pressures, rise};
pub(crate) use dense::{Dense, Exact, Plan};
pub(crate) use jacobi::{Basis, chop};
pub(crate) use local::{LOCAL, Local, local_nodes};
pub(crate) use rule::{Node, Rule, rule};
