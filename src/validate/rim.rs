//! Forces under a rim beside the contact radius that a solver counts in pixels.

use super::exact::Exact;
use super::norms::{Outlier, ratio};
use crate::contact::{Boundary, State};
use std::f64::consts::PI;

/// A solver fills whole pixels, whose area is that of a circle of the radius a' = √(N h²/π), and F is that of about the radius a' − 0.116 h:
/// it was 0.105 to 0.119 in 14 fields of three solvers. The limits are those of the difference in h; other elements may have another one.
const LIMITS: [f64; 2] = [0.25, 0.05];
/// Part of a pixel by which a number of pixels may be no whole one, as in a printed radius.
const WHOLE: f64 = 0.02;

/// The force that belongs to a radius, and by how much the one of the data may differ from it.
pub(super) struct Expected {
    force: f64,
    bound: f64,
    /// dF/dd = 2E* a.
    stiffness: f64,
}

impl Expected {
    /// `None` unless the contact ends at a rim, N is a whole number, and the force is too far from that of a'.
    ///
    /// At a given depth, dF/da = 2E*(d − g(a)).
    pub(super) fn missed(exact: &Exact<'_>, state: &State, (force, radius): (f64, f64), pixel: f64) -> Option<Self> {
        let count = PI * (radius / pixel).powi(2);
        if radius.is_nan() || state.boundary != Boundary::Rim || (count - count.round()).abs() > WHOLE {
            return None;
        }
        let shape = exact.shape();
        let twice = 2.0 * shape.effective_modulus();
        let slope = twice * (state.depth - shape.depth(state.radius).ok()?.estimate.value);
        let expected = state.force + slope * (radius - state.radius);
        let [below, above] = LIMITS.map(|own| own * slope * pixel);
        let bound = if force > expected { above } else { below };
        ((force - expected).abs() > bound).then_some(Self { force: expected, bound, stiffness: twice * radius })
    }

    /// The force as an outlier, with its limit.
    pub(super) fn of_force(&self, at: f64, data: f64) -> (Outlier, f64) {
        let limit = ratio(self.bound, self.force);
        (Outlier { at, data, exact: self.force, allowed: limit }, limit)
    }

    /// The same as an error of the depth at a given force.
    pub(super) fn of_depth(&self, at: f64, (force, depth): (f64, f64)) -> (Outlier, f64) {
        let exact = depth + (force - self.force) / self.stiffness;
        let limit = ratio(self.bound, self.stiffness * exact);
        (Outlier { at, data: depth, exact, allowed: limit }, limit)
    }
}
