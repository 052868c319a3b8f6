//! Adaptive quadrature: panels with singular ends, integrands that carry their rounding error.

mod abel;
mod adaptive;
mod even;
mod refine;
mod rules;
mod sample;
#[cfg(test)]
mod tests;
mod transform;

pub use abel::{AbelOptions, AbelTransform, Radii, Start, Strip, abel, abel_force};
pub use abel::{CHUNK, Extent, Form, Wish, from_the_axis, growth_below_normal};
pub use adaptive::{Options, Rule, integrate, integrate_blocks};
pub use even::{EvenIntegrand, Known, Mean, Middles, Nodes, mean};
pub use transform::{EndBehaviour, Panel, Point};

/// An integrand over blocks of points, as a trait object so that the rules are compiled once rather than for every integrand.
type Integrand<'a> = dyn FnMut(&[Point], &mut [crate::Bounded]) + 'a;
