//! The force from the pressures on a lattice, summed over its shells.

use super::norms::ratio;
use crate::validate::file::lattice::{self, Lattice, Offset};
use crate::validate::file::pixel::Pixel;
use crate::validate::file::survey::Survey;
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Pressures summed over the shells of a lattice, which is complete if every pixel up to a distance is present.
pub(super) struct Shells {
    lattice: Option<Lattice>,
    reach: f64,
    /// 4 r²/h² of the outermost shell.
    outermost: u64,
    counts: BTreeMap<u64, (u64, u64)>,
    /// Sums of the pressures of the data and of the exact pressures, and the number of points with a pressure; NaN if one is missing.
    data: BTreeMap<u64, (f64, f64, f64)>,
    broken: bool,
    /// Smaller pressures are rounding errors of a solver.
    least: f64,
}

/// Maximum number of shells to store.
const MOST_SHELLS: f64 = 4e6;

impl Shells {
    pub(super) fn new(survey: &Survey<'_>, reach: f64, pixel: Pixel, least: f64) -> Self {
        let lattice = survey.lattice.filter(|own| own.offset != Offset::Line);
        let lattice = lattice.map(|own| Lattice { pixel: pixel.pixel.unwrap_or(own.pixel), ..own });
        let most = lattice.map_or(0.0, |own| 4.0 * (reach / own.pixel).powi(2));
        let usable = lattice.filter(|_| most < MOST_SHELLS);
        // Include the shell at the limit despite rounding.
        let outermost = (most * (1.0 + 1e-9)) as u64;
        let counts = usable.map_or_else(Default::default, |own| {
            lattice::shells(own.offset, outermost).into_iter().map(|(key, count)| (key, (count, 0))).collect()
        });
        Self { lattice: usable, reach, outermost, counts, data: Default::default(), broken: usable.is_none(), least }
    }

    /// Adds a pressure; an infinite exact pressure counts only if the data are means.
    pub(super) fn add(&mut self, (r, p): (f64, f64), exact: f64, means: bool) {
        let Some(lattice) = self.lattice else { return };
        let shell = lattice::quarters(r, lattice.pixel);
        if self.broken || shell.map_or(r > self.reach, |key| key > self.outermost) {
            return;
        }
        let Some((key, count)) = shell.and_then(|key| Some((key, self.counts.get_mut(&key)?))) else {
            // The point is not on the lattice.
            self.broken = true;
            return;
        };
        count.1 += 1;
        let sums = self.data.entry(key).or_insert((0.0, 0.0, 0.0));
        if means || !exact.is_nan() {
            let pressed = f64::from(u8::from(p > self.least));
            *sums = (sums.0 + p, sums.1 + exact, sums.2 + pressed);
        } else {
            sums.2 = f64::NAN;
        }
    }

    /// Returns the force of the data, the force of the exact pressures by the same sum, and the radius of the circle with the area of all pixels
    /// that have a pressure, NaN if an infinite exact pressure was skipped; `None` if a pixel is missing.
    pub(super) fn total(&self) -> Option<(f64, f64, f64)> {
        let lattice = self.lattice.filter(|_| !self.broken)?;
        let area = lattice.pixel * lattice.pixel;
        let mut total = (0.0, 0.0, 0.0);
        for (key, (pixels, seen)) in &self.counts {
            // Each shell may be complete or reduced by symmetry: a quarter, an octant, or one point.
            if *seen == 0 || *seen > *pixels {
                return None;
            }
            let (data, exact, pressed) = self.data.get(key).copied().unwrap_or_default();
            let weight = ratio(*pixels as f64, *seen as f64);
            total = (total.0 + weight * data * area, total.1 + weight * exact * area, total.2 + weight * pressed * area);
        }
        Some((total.0, total.1, (total.2 / PI).sqrt()))
    }
}
