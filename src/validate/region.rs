//! The region in which pressures are compared, away from the apex, kinks and the edge, and the discretization error there.

use super::exact::Singularities;
use super::loads::BLIND;

/// Coefficient of (h/s)² at the distance s from an inner edge.
const INNER: f64 = 0.05;
/// Coefficient of h²/(a s) at the distance s ≥ h from a point where the curvature jumps.
const BEND: f64 = 0.02;

/// The region in which pressures are compared.
pub(super) struct Region {
    a: f64,
    margin: f64,
    apex: bool,
    kinks: Vec<f64>,
    bends: Vec<f64>,
}

impl Region {
    pub(super) fn new(a: f64, margin: f64, sharp: &Singularities) -> Self {
        Self {
            a,
            margin,
            apex: sharp.apex,
            kinks: sharp.kinks.iter().copied().filter(|own| *own < a).collect(),
            bends: sharp.bends.clone(),
        }
    }

    /// The margin; pixels exactly at this distance are outside the margin despite rounding.
    fn margin(&self) -> f64 {
        self.margin * (1.0 - 1e-6)
    }

    pub(super) fn holds(&self, r: f64) -> bool {
        let margin = self.margin();
        (r - self.a).abs() >= margin && !self.is_near_inner(r, margin)
    }

    /// Returns true within the margin of the apex or a kink, but at least one pixel away from it and outside the margin of the edge.
    ///
    /// The norms exclude such a point, but its error is limited to `HEADROOM` times the discretization error.
    pub(super) fn lies_between(&self, r: f64, pixel: Option<f64>) -> bool {
        let margin = self.margin();
        let near = |pixel: f64| self.is_near_inner(r, margin) && !self.is_near_inner(r, pixel * (1.0 - 1e-6));
        pixel.is_some_and(near) && (r - self.a).abs() >= margin
    }

    pub(super) fn is_near_inner(&self, r: f64, margin: f64) -> bool {
        (self.apex && r < margin) || self.kinks.iter().any(|kink| (r - kink).abs() < margin)
    }

    /// Returns true near the edge of the contact, and away from other singular points.
    pub(super) fn meets_edge(&self, r: f64) -> bool {
        let margin = self.margin();
        (self.a - r).abs() < margin && !self.is_near_inner(r, 2.0 * margin)
    }
}

/// Returns the relative discretization error of a pressure.
///
/// F has 0.25 (h/a)² for a smooth edge and 0.25 h/a for a rim, p slightly more; near the edge the length to be resolved is not a
/// but (a² − r²)/a, over which p changes by a factor of order 1.
///
/// At the distance s from an apex or a kink, where p is logarithmic, the mean over a pixel differs from p by a relative amount of order (h/s)².
pub(super) fn excused(r: f64, region: &Region, pixel: Option<f64>, rim: bool) -> f64 {
    let Some(pixel) = pixel else { return BLIND };
    let a = region.a;
    let share = pixel / (a * (1.0 - (r / a).powi(2)).abs());
    let inner = region.kinks.iter().copied().chain(region.apex.then_some(0.0)).map(|at| (pixel / (r - at)).powi(2)).sum::<f64>();
    // Where the curvature jumps, the slope of p is logarithmic, and the mean over the pixel has an error of first order.
    let bends = region.bends.iter().map(|at| pixel / a * pixel / (r - at).abs().max(pixel)).sum::<f64>();
    INNER * inner + BEND * bends + if rim { 0.3 * share } else { 0.25 * share * share }
}
