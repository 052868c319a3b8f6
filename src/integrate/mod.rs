//! f′ as an expression, a closure or a table, and the integrals over it: g, F and G, the pressure, the displacement outside and the stress
//! on the axis, each with a bound on its error.
//!
//! It uses no rules and no formulas for g.
//! `source` evaluates and encloses f′, `abel` computes ∫ f′/√(x²−r²) dr, and `pressure` computes p.

pub(crate) mod abel;
pub(crate) mod admit;
pub(crate) mod ask;
pub(crate) mod error;
pub(crate) mod integral;
pub(crate) mod numbers;
pub(crate) mod pressure;
pub(crate) mod segment;
pub(crate) mod source;
pub(crate) mod table_error;
