//! Pressures at mirrored points of a lattice: a round contact has the same pressure at all of them.

use super::norms::Outlier;
use std::collections::HashMap;

/// Smallest difference from the mirrored points for which a point is an outlier, relative to the pressure or to half of the mean pressure, …
const CLEAR: f64 = 0.02;
/// … and as a multiple of the differences at most points.
const USUAL: f64 = 20.0;
/// Minimum number of mirrored points, of which most are right.
const FEWEST: usize = 4;
/// Maximum number of points with the same |x| and |y| in either order.
const IMAGES: usize = 8;

/// The pressures of a field, grouped by |x| and |y| in either order.
pub(super) struct Mirrored {
    /// The part of a pixel up to which coordinates are the same.
    unit: f64,
    groups: HashMap<(u64, u64), Vec<Outlier>>,
    repeated: u64,
}

/// A point whose pressure differs from those at the mirrored points, relative to the larger of these and of half the mean pressure.
pub(super) struct Unequal {
    pub(super) own: Outlier,
    pub(super) difference: f64,
    pub(super) limit: f64,
}

impl Mirrored {
    /// Without a pixel, nothing is compared.
    pub(super) fn new(pixel: Option<f64>) -> Self {
        Self { unit: pixel.map_or(0.0, |own| own / 64.0), groups: HashMap::new(), repeated: 0 }
    }

    pub(super) fn add(&mut self, x: f64, y: f64, own: Outlier) {
        if self.unit == 0.0 || !(x.is_finite() && y.is_finite()) {
            return;
        }
        let [x, y] = [x, y].map(|own| (own.abs() / self.unit).round() as u64);
        let group = self.groups.entry((x.min(y), x.max(y))).or_default();
        let expected = match (x.min(y), x.max(y)) {
            (0, 0) => 1,
            (0, _) => IMAGES / 2,
            (least, most) if least == most => IMAGES / 2,
            _ => IMAGES,
        };
        if group.len() < expected {
            group.push(own);
        } else {
            self.repeated += 1;
        }
    }

    /// The number of points that are there more than once.
    pub(super) fn repeated(&self) -> u64 {
        self.repeated
    }

    /// The points that differ from their mirrored points by more than `least`; `mean` is the mean pressure.
    pub(super) fn unequal(&self, mean: f64, least: f64) -> Vec<Unequal> {
        let groups = self.groups.values().filter(|own| own.len() >= FEWEST);
        let mut all: Vec<(&Outlier, f64)> = Vec::new();
        let mut spreads = Vec::new();
        for group in groups {
            let mut values: Vec<f64> = group.iter().map(|own| own.data).collect();
            values.sort_by(f64::total_cmp);
            let half = values.len() / 2;
            let (Some(one), Some(other)) = (values.get((values.len() - 1) / 2), values.get(half)) else { continue };
            let middle = 0.5 * (one + other);
            let scale = middle.abs().max(0.5 * mean);
            let difference = |own: &Outlier| (own.data - middle).abs() / scale;
            if middle > 0.0 {
                spreads.push(group.iter().map(difference).fold(0.0, f64::max));
            }
            all.extend(group.iter().map(|own| (own, difference(own))));
        }
        spreads.sort_by(f64::total_cmp);
        let limit = spreads.get(spreads.len() / 2).map_or(CLEAR, |usual| CLEAR.max(USUAL * usual)).max(least);
        let beyond = all.into_iter().filter(|own| own.1 > limit);
        beyond.map(|(own, difference)| Unequal { own: *own, difference, limit }).collect()
    }
}
