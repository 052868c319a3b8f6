//! The ways to ∫ f′/√(x²−r²) dr and its companions, over the angle t with r = x sin t.
//!
//! `angle_substitution` applies nested rules; `bisected` divides the range until enclosures of f′ prove the error of every piece;
//! `over_root` takes a root of the variable where f′ begins with a fractional power.
//! `axial` computes the stress on the axis.

pub(crate) mod angle_substitution;
pub(crate) mod axial;
pub(crate) mod bisected;
pub(crate) mod over_root;
pub(crate) mod pieces;
