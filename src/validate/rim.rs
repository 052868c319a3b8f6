//! Forces under a rim as a function of the contact radius that a solver counts in pixels.

use super::exact::Exact;
use super::norms::{Outlier, ratio};
use crate::contact::{Boundary, State};
use std::f64::consts::PI;

/// Limits of the radius that corresponds to F, below and above a' = √(N h²/π), in pixels.
///
/// A solver fills N whole pixels, and its force corresponds to a radius of about a' − 0.116 h: in 14 runs of three solvers the difference was
/// 0.105 h to 0.119 h. The limits allow for solvers with other elements.
const LIMITS: [f64; 2] = [0.25, 0.05];
/// Maximum distance of N from a whole number; radii may be printed with few digits.
const WHOLE: f64 = 0.02;

/// The force that corresponds to the counted radius, and the maximum difference of the data from it.
pub(super) struct Expected {
    force: f64,
    bound: f64,
    /// dF/dd = 2E* a.
    stiffness: f64,
}

impl Expected {
    /// Returns the expected force if the contact ends at a rim, N is a whole number, and the force is outside its limits.
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

    /// Returns the force as an outlier with its limit.
    pub(super) fn of_force(&self, at: f64, data: f64) -> (Outlier, f64) {
        let limit = ratio(self.bound, self.force);
        (Outlier { at, data, exact: self.force, allowed: limit }, limit)
    }

    /// Returns the same as an error of the depth at the force of the data.
    pub(super) fn of_depth(&self, at: f64, (force, depth): (f64, f64)) -> (Outlier, f64) {
        let exact = depth + (force - self.force) / self.stiffness;
        let limit = ratio(self.bound, self.stiffness * exact);
        (Outlier { at, data: depth, exact, allowed: limit }, limit)
    }
}
