//! Adaptive quadrature: panels with singular ends, integrands that carry their rounding error.

mod adaptive;
mod refine;
mod rules;
mod sample;
#[cfg(test)]
mod tests;
mod transform;

pub use adaptive::{Options, integrate};
pub use transform::{EndBehaviour, Panel, Point};
