//! f′ as an expression, a closure or a table, and the integrals over it: g, F and G, the pressure, the displacement outside and the stress
//! on the axis, each with a bound on its error.
//!
//! It knows no rule and no formula of g.
//! `source` says what f′ is, `abel` has the ways to ∫ f′/√(x²−r²) dr, `pressure` those to p.

pub(crate) mod abel;
pub(crate) mod admit;
pub(crate) mod error;
pub(crate) mod integral;
pub(crate) mod pressure;
pub(crate) mod segment;
pub(crate) mod source;
pub(crate) mod table_error;
