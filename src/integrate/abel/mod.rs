//! The ways to ∫ f′/√(x²−r²) dr and its companions, over the angle t with r = x sin t.
//!
//! Nested rules answer where f′ is smooth enough; pieces with enclosures prove what they leave out.
//! The stress on the axis has a weight of its own.

pub(crate) mod angle_substitution;
pub(crate) mod axial;
pub(crate) mod bisected;
pub(crate) mod pieces;
