//! The largest pressure: where several places have it although the exact pressures differ, the data are cut off.

use super::Suspicion;
use super::norms::Outlier;

/// Pressures that agree within this share are one number.
const SAME: f64 = 1e-9;
/// Places that must have it; pixels that lie symmetrically to the axis have one exact pressure.
const FEWEST: u64 = 3;
/// The share by which the exact pressures must differ, several times what is lost by printing two digits.
const APART: f64 = 0.1;
/// The part of the largest exact pressure that must be missing.
pub(super) const CUT: f64 = 0.05;

/// The largest pressure of the data and the exact pressures at its places.
#[derive(Default)]
pub(super) struct Peak {
    p: f64,
    places: u64,
    low: f64,
    high: f64,
    /// Where the exact pressure is largest.
    at: f64,
    /// Sums of the squares of the exact pressures and of what the data lack of them.
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

    /// The place with the largest exact pressure, where the data are cut off.
    pub(super) fn cut_off(&self) -> Option<Outlier> {
        let is_cut = self.places >= FEWEST && self.high > self.low * (1.0 + APART) && self.high > self.p;
        is_cut.then_some(Outlier { at: self.at, data: self.p, exact: self.high, allowed: 0.0 })
    }

    /// Names the fault; the largest pressure is given in the unit of the column, and `after` is the error of the other places.
    pub(super) fn suspicion(&self, largest: impl Fn(f64) -> f64, after: f64) -> Option<Suspicion> {
        self.cut_off()?;
        let text = format!("pressures are cut off: none is larger than {:.6e}", largest(self.p));
        Some(Suspicion { id: "cut-off", text, before: (self.lack / self.exact).sqrt(), after })
    }
}
