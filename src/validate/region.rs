//! Where pressures are compared: away from apex, kinks and edge, and how much the grid excuses there.

use super::exact::Sharp;
use super::loads::BLIND;

/// The share of (h/s)² at the distance s from an inner edge.
const INNER: f64 = 0.05;
/// The share of h²/(a s) at the distance s ≥ h from a place where the curvature jumps.
const BEND: f64 = 0.02;

/// Where pressures are compared.
pub(super) struct Region {
    a: f64,
    margin: f64,
    apex: bool,
    kinks: Vec<f64>,
    bends: Vec<f64>,
}

impl Region {
    pub(super) fn new(a: f64, margin: f64, sharp: &Sharp) -> Self {
        Self {
            a,
            margin,
            apex: sharp.apex,
            kinks: sharp.kinks.iter().copied().filter(|own| *own < a).collect(),
            bends: sharp.bends.clone(),
        }
    }

    /// The margin; pixels exactly so far away lie outside of it, whatever their last digit.
    fn margin(&self) -> f64 {
        self.margin * (1.0 - 1e-6)
    }

    pub(super) fn holds(&self, r: f64) -> bool {
        let margin = self.margin();
        (r - self.a).abs() >= margin && !self.is_near_inner(r, margin)
    }

    /// Returns true within the margin of the apex or a kink, but at least one pixel away from it and outside the margin of the edge.
    ///
    /// The norms leave such a place out, but it has a limit of its own: `HEADROOM` times what the grid excuses there.
    pub(super) fn lies_between(&self, r: f64, pixel: Option<f64>) -> bool {
        let margin = self.margin();
        let near = |pixel: f64| self.is_near_inner(r, margin) && !self.is_near_inner(r, pixel * (1.0 - 1e-6));
        pixel.is_some_and(near) && (r - self.a).abs() >= margin
    }

    pub(super) fn is_near_inner(&self, r: f64, margin: f64) -> bool {
        (self.apex && r < margin) || self.kinks.iter().any(|kink| (r - kink).abs() < margin)
    }

    /// True inside of the contact next to its edge, and away from other sharp places.
    pub(super) fn meets_edge(&self, r: f64) -> bool {
        let margin = self.margin();
        r < self.a && self.a - r < margin && !self.is_near_inner(r, 2.0 * margin)
    }
}

/// The relative error of a pressure that the grid excuses.
///
/// F has 0.25 (h/a)² under a smooth edge and 0.25 h/a under a rim, p a little more there; next to the edge the length that the pixel must resolve is not a
/// but (a² − r²)/a, over which p changes by itself.
///
/// At the distance s from an apex or a kink, where p has a logarithm, the mean over a pixel differs from p by a share of (h/s)².
pub(super) fn excused(r: f64, region: &Region, pixel: Option<f64>, rim: bool) -> f64 {
    let Some(pixel) = pixel else { return BLIND };
    let a = region.a;
    let share = pixel / (a * (1.0 - (r / a).powi(2)).abs());
    let inner = region.kinks.iter().copied().chain(region.apex.then_some(0.0)).map(|at| (pixel / (r - at)).powi(2)).sum::<f64>();
    // Where the curvature jumps, the slope of p is logarithmic, and the mean over the pixel is off in first order.
    let bends = region.bends.iter().map(|at| pixel / a * pixel / (r - at).abs().max(pixel)).sum::<f64>();
    INNER * inner + BEND * bends + if rim { 0.3 * share } else { 0.25 * share * share }
}
