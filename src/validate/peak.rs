//! Clipped pressures: several points share the largest value although their exact pressures differ.

use super::Suspicion;
use super::norms::Outlier;

/// Relative difference up to which two pressures are considered equal.
const SAME: f64 = 1e-9;
/// Minimum number of points that share the largest pressure.
const FEWEST: u64 = 3;
/// Minimum relative difference of their exact pressures; rounding to two digits hides a difference of at most 0.095, between 1.05 and 1.15.
const APART: f64 = 0.12;
/// Minimum relative error of the largest exact pressure.
pub(super) const CUT: f64 = 0.05;

/// The largest pressure of the data and the exact pressures at its points.
#[derive(Default)]
pub(super) struct Peak {
    p: f64,
    places: u64,
    low: f64,
    high: f64,
    /// The point with the largest exact pressure.
    at: f64,
    /// Sums of squares: of the exact pressures, and of their differences from the data.
    exact: f64,
    lack: f64,
}

impl Peak {
    pub(super) fn add(&mut self, r: f64, p: f64, exact: f64) {
        if exact.is_nan() || p <= 0.0 || p < self.p * (1.0 - SAME) {
            return;
        }
        if p > self.p * (1.0 + SAME) {
            *self = Self { p, low: exact, ..Self::default() };
        }
        self.places += 1;
        self.exact += exact * exact;
        self.lack += (exact - p) * (exact - p);
        self.low = self.low.min(exact);
        if exact > self.high {
            (self.high, self.at) = (exact, r);
        }
    }

    /// Returns the point with the largest exact pressure if the data are clipped.
    pub(super) fn cut_off(&self) -> Option<Outlier> {
        let is_cut = self.places >= FEWEST && self.high > self.low * (1.0 + APART) && self.high - self.p > CUT * self.high;
        is_cut.then_some(Outlier { at: self.at, data: self.p, exact: self.high, allowed: 0.0 })
    }

    /// Creates the fault; `largest` writes a pressure with its unit, and `after` is the L2 error of the compared points.
    pub(super) fn suspicion(&self, largest: impl Fn(f64) -> String, after: f64) -> Option<Suspicion> {
        self.cut_off()?;
        let text = format!("clipped pressures: none is larger than {}", largest(self.p));
        Some(Suspicion { id: "cut-off", text, before: (self.lack / self.exact).sqrt(), after })
    }
}
