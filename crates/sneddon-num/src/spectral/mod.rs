//! Expansions in Jacobi polynomials: rules, coefficients, half-order integrals, and short polynomials for fast evaluation.

mod abel;
mod contact;
mod jacobi;
mod local;
mod local_polynomials;
mod rule;

pub use abel::{Power, above, beyond, right_sided, times_distance};
pub use contact::{pressures, rise};
pub use jacobi::{Basis, chop};
pub use local::{LOCAL, Local, local_nodes};
pub use local_polynomials::{Dense, Exact, Plan};
pub use rule::{Node, Rule, rule};
