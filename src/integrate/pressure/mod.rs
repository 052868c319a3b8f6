//! The ways to the pressure, straight from f′ and (r f′)′.
//!
//! `direct` chooses: pieces with proven rules, the Legendre expansion of a smooth odd f′, the integral of g′ over u, and the elliptic kernel.
//! `axis` has the pressure at r = 0.

pub(crate) mod axis;
pub(crate) mod direct;
pub(crate) mod legendre;
pub(crate) mod over_u;
pub(crate) mod pieces;
pub(crate) mod straight;
