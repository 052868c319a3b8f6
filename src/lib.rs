//! Exact and numeric transforms of contact mechanics by the method of dimensionality reduction.
//!
//! A profile is a formula ([`transform::Profile::new`], [`transform::derive`], [`transform::Evaluator`]), a Rust closure
//! ([`transform::Profile::from_fn`], [`transform::Closure`]) or a table of points ([`transform::Profile::from_points`]);
//! [`contact::Contact`] takes any of them.

#[cfg(feature = "cli")]
pub mod cli;
pub mod code;
pub mod contact;
pub use sneddon_expr::{eval, expr, parse, print};
pub use sneddon_num as num;
mod derive;
mod evaluate;
mod integrate;
pub mod report;
#[cfg(feature = "scene")]
pub mod scene;
#[cfg(feature = "cli")]
pub mod tradeoff;
pub mod transform;
#[cfg(feature = "data")]
pub mod validate;
