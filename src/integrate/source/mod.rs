//! What f′ is on a segment: values in blocks, enclosures, its behaviour at the ends, and what is known of its continuation.
//!
//! A source is a compiled expression, or any type that computes f′ and (r f′)′.
//! The integrals are computed in `abel` and `pressure`.

pub(crate) mod analytic_bound;
pub(crate) mod centred;
pub(crate) mod enclosures;
pub(crate) mod endpoint;
pub(crate) mod ends;
pub(crate) mod f_prime;
pub(crate) mod leading_power;
pub(crate) mod limit;
pub(crate) mod over_angle;
pub(crate) mod parity;
pub(crate) mod removable;
