//! How far the fields of a contact may be off because its radius and depth are known to an error only.

use super::{Control, Dimension, Quantity, Run};
use crate::contact::{Boundary, Estimates, State};
use crate::num::Bound;
use crate::num::stable::leg;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The errors of a state that its fields inherit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Doubt {
    /// E*/π.
    factor: f64,
    /// The contact radius and its error.
    a: f64,
    radius: f64,
    /// g′(a), or 0 where the radius and the places are exact, or the edge is a rim.
    rise: f64,
    /// The relative error of places, which units have rounded.
    rounding: f64,
    /// What the depth may be off by, or g at the contact radius.
    slack: f64,
    /// The error of the depth of a punch with a rim.
    rim: f64,
    /// What the errors rest on.
    pub(super) bound: Bound,
}

/// Relative errors of E*, which is a factor of every pressure, and of places that were converted from units.
const ROUNDED: f64 = 2.0 * f64::EPSILON;
/// The relative step of g′.
const STEP: f64 = 1e-6;
/// Terms of second order.
const MARGIN: f64 = 1.0 + 1e-6;

impl Run<'_> {
    /// The doubt of a state; `None` where the errors of its radius or depth are unknown.
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
        let doubt = Doubt { factor, a, radius: radius.error, rise, rounding, slack, rim, bound: radius.bound.and(depth.bound) };
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
    /// A bound on the change of a field at r (or at the depth z below the surface) within the errors.
    ///
    /// ∂p/∂a = E* g′(a)/(π √(a²−r²)); displacements move by at most what the depth moves by.
    pub(super) fn of_point(&self, curve: Quantity, at: f64, value: f64) -> f64 {
        match curve {
            Quantity::Pressure => self.of_pressure(at) + ROUNDED * value.abs(),
            Quantity::AxialStress => {
                let (a, z) = (self.a, at);
                let kernel = a * (a * a + 3.0 * z * z) / (a * a + z * z).powi(2);
                self.factor * (self.slack + self.rim) * kernel * MARGIN + ROUNDED * value.abs()
            }
            Quantity::Displacement => (self.slack + self.rim) * MARGIN,
            _ => 0.0,
        }
    }

    fn of_pressure(&self, r: f64) -> f64 {
        let rim = if self.rim > 0.0 && r < self.a { self.rim / leg(self.a, r) } else { 0.0 };
        // A place that is rounded moves towards the edge as the edge moves away from it.
        let moved = self.radius + self.rounding * (r + self.a);
        let reach = self.a - 2.0 * moved;
        let smooth = if moved == 0.0 || r > self.a + moved {
            0.0
        } else {
            // ∫ dx/√(x²−r²) over the error, next to the edge by its largest value.
            let near = self.rise * (2.0 * moved / r.max(0.25 * self.a)).sqrt();
            if r < reach { near.min(self.rise * moved / leg(reach, r)) } else { near }
        };
        self.factor * (smooth + rim) * MARGIN
    }

    /// The same for the mean of the pressure over a cell between two radii with a diagonal, or a ring that has none.
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
