//! Error bounds of fields that follow from the errors of the contact radius and the depth.

use super::{Control, Dimension, Quantity, Run};
use crate::contact::{Boundary, Estimates, Kind, State};
use crate::num::Bound;
use crate::num::stable::leg;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The errors of a contact state that affect its fields.
#[derive(Clone, Copy, Debug)]
pub(super) struct Doubt {
    /// E*/π.
    factor: f64,
    /// The contact radius and its error.
    a: f64,
    radius: f64,
    /// g′(a), or 0 if the radius and the coordinates are exact or the edge is a rim.
    rise: f64,
    /// The relative rounding error of coordinates, from unit conversion.
    rounding: f64,
    /// The error of the depth, or of g at the contact radius.
    slack: f64,
    /// The error of the depth of a flat-ended punch.
    rim: f64,
    /// The error of the depth.
    depth: f64,
    /// Whether the errors are proven or estimated.
    pub(super) bound: Bound,
}

/// Relative error of E*, a factor of every pressure, and of coordinates converted from other units.
const ROUNDED: f64 = 2.0 * f64::EPSILON;
/// Relative step of the difference quotient for g′.
const STEP: f64 = 1e-6;
/// Allows for terms of second order.
const MARGIN: f64 = 1.0 + 1e-6;

impl Run<'_> {
    /// Returns the errors of a state; `None` if the errors of its radius or depth are unknown.
    pub(super) fn doubt(&self, state: &State) -> Option<Doubt> {
        let known = self.estimates_of(state)?;
        let Estimates { depth, radius, slack, .. } = known;
        let (a, rounding) = (state.radius, self.rounding_of_places());
        let (rim, slack) = if state.boundary == Boundary::Rim { (depth.error, 0.0) } else { (0.0, slack + depth.error) };
        let g = |x: f64| Some(self.indentation.shape().depth(x).ok()?.estimate.value);
        let rise = match state.boundary {
            Boundary::Smooth if radius.error > 0.0 => slack / radius.error,
            Boundary::Smooth if rounding > 0.0 => (g(a)? - g(a * (1.0 - STEP))?).abs() / (STEP * a) * (1.0 + 2.0 * STEP),
            _ => 0.0,
        };
        let factor = self.scene().effective_modulus / PI;
        let doubt =
            Doubt { factor, a, radius: radius.error, rise, rounding, slack, rim, depth: depth.error, bound: radius.bound.and(depth.bound) };
        Some(doubt).filter(|own| [own.radius, own.rise, own.slack, own.rim].iter().all(|own| own.is_finite()))
    }

    fn estimates_of(&self, state: &State) -> Option<Estimates> {
        if let Some((_, own)) = self.doubt.get().filter(|own| own.0 == *state) {
            return own;
        }
        let given = match self.scene().control {
            Control::Depth => state.depth,
            Control::Force => state.force,
            Control::ContactRadius => state.radius,
        };
        let found = self.bounds_under(self.scene().control.load(given), state);
        self.doubt.set(Some((*state, found)));
        found
    }

    fn rounding_of_places(&self) -> f64 {
        if self.scene().system.has_units() && self.scene().system.out(Dimension::LENGTH) != 1.0 { f64::EPSILON } else { 0.0 }
    }
}

impl Doubt {
    /// Returns a bound on the change of a field at r (or at depth z below the surface) that these errors can cause.
    ///
    /// ∂p/∂a = E* g′(a)/(π √(a²−r²)); displacements change by at most the error of the depth.
    pub(super) fn of_point(&self, curve: Quantity, at: f64, value: f64) -> f64 {
        match curve {
            Quantity::Pressure => self.of_pressure(at) + ROUNDED * value.abs(),
            Quantity::AxialStress => {
                let (a, z) = (self.a, at);
                let kernel = a * (a * a + 3.0 * z * z) / (a * a + z * z).powi(2);
                self.factor * (self.slack + self.rim) * kernel * MARGIN + ROUNDED * value.abs()
            }
            Quantity::Displacement => (self.slack + self.rim) * MARGIN,
            Quantity::LineDisplacement => self.depth,
            Quantity::LineLoad => PI * self.factor * self.depth * MARGIN + ROUNDED * value.abs(),
            // Nothing is known of a field that is not in this list.
            other if other.kind() == Kind::Field => f64::INFINITY,
            _ => 0.0,
        }
    }

    fn of_pressure(&self, r: f64) -> f64 {
        let rim = if self.rim > 0.0 && r < self.a { self.rim / leg(self.a, r) } else { 0.0 };
        // The errors of the edge and of the coordinate add up.
        let moved = self.radius + self.rounding * (r + self.a);
        let reach = self.a - 2.0 * moved;
        let smooth = if moved == 0.0 || r > self.a + moved {
            0.0
        } else {
            // Bounds ∫ dx/√(x²−r²) over the error interval, near the edge by its maximum.
            let near = self.rise * (2.0 * moved / r.max(0.25 * self.a)).sqrt();
            if r < reach { near.min(self.rise * moved / leg(reach, r)) } else { near }
        };
        self.factor * (smooth + rim) * MARGIN
    }

    /// Returns the bound for the mean pressure over a cell between two radii with this diagonal; a ring has no diagonal.
    pub(super) fn of_mean(&self, [inner, outer]: [f64; 2], diagonal: Option<f64>, area: f64, value: f64) -> f64 {
        if inner >= self.a + self.radius {
            return 0.0;
        }
        let end = self.a + self.radius;
        let angle = diagonal.map_or(TAU, |own| if inner > 0.0 { (FRAC_PI_2 * own / inner).min(TAU) } else { TAU });
        let whole = self.rise * self.radius + self.rim;
        let of_area = whole * angle * leg(end, inner) / area;
        let largest = self.a - 2.0 * self.radius;
        let of_place = if outer < largest { whole / leg(largest, outer) } else { f64::INFINITY };
        self.factor * of_area.min(of_place) * MARGIN + ROUNDED * value.abs()
    }
}
