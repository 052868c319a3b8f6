//! Special functions of real arguments, one family per file; NaN outside the stated domain.
//!
//! The error function and the gamma function come from `libm` ([`erf`], [`gamma`]): 0.74 and 4.7 ulp.

mod backward;
pub mod bessel;
pub mod carlson;
mod carried;
mod connection;
pub mod dawson;
pub mod digamma;
pub mod dilogarithm;
pub mod elliptic;
pub mod fresnel;
mod hankel;
pub mod hypergeometric;
mod leading;
pub mod struve;
mod taylor;
mod trigamma;

pub use bessel::{besseli, besseli_precise, besseli_scaled, besseli_scaled_precise, besselj, besselj_precise};
pub use carlson::{rc, rd, rf};
pub use dawson::{dawson, dawson_precise, erf_precise, erfi, erfi_precise};
pub use digamma::digamma;
pub use dilogarithm::{inverse_tangent_integral, legendre_chi2, polylog2};
pub use elliptic::{ellipe, ellipe_inc, ellipf, ellipk};
pub use fresnel::{fresnelc, fresnelc_precise, fresnels, fresnels_precise};
pub use hypergeometric::{hyp2f1, hyper};
pub use libm::{erf, tgamma as gamma};
pub use struve::{bessel_struve, bessel_struve_precise, struveh, struveh_precise, struvel, struvel_precise};
pub use trigamma::trigamma;
