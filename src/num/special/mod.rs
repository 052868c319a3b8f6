//! Special functions of real arguments, one family per file; NaN outside the stated domain.
//!
//! The error function and the gamma function come from `libm` ([`erf`], [`gamma`]): 0.74 and 4.7 ulp.

pub mod bessel;
pub mod carlson;
mod connection;
pub mod digamma;
pub mod dilogarithm;
pub mod elliptic;
pub mod hypergeometric;
mod trigamma;

pub use bessel::{besseli, besselj};
pub use carlson::{rc, rd, rf};
pub use digamma::digamma;
pub use dilogarithm::{inverse_tangent_integral, legendre_chi2, polylog2};
pub use elliptic::{ellipe, ellipe_inc, ellipf, ellipk};
pub use hypergeometric::{hyp2f1, hyper};
pub use libm::{erf, tgamma as gamma};
pub use trigamma::trigamma;
