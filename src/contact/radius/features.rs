//! Radii at which g may have a maximum that is too narrow for samples of it: concave kinks, and ranges in which the profile bends down.

use crate::contact::indentation::cells::{Cells, around};
use crate::contact::indentation::curvature::Curvature;
use crate::num::work;
use crate::transform::Quantities;
use std::collections::BTreeMap;
use std::sync::{Mutex, OnceLock, PoisonError};

/// The narrow features of a profile, for all searches.
#[derive(Default)]
pub(in crate::contact) struct Features {
    /// Compiled by the first search; `None` for a profile that is not a formula.
    curvature: OnceLock<Option<Curvature<'static>>>,
    /// The radii that were found, by the bits of the ends of their range.
    found: Mutex<BTreeMap<(u64, u64), Vec<f64>>>,
}

/// Maximum number of steps for one range of radii.
const LOOKING: u64 = 3_000_000;
/// A range in which the profile bends down is narrow up to this width, relative to its radius.
const NARROW: f64 = 0.2;
/// Maximum number of features in one range of radii.
const MOST_FEATURES: usize = 64;
/// Relative distance from a concave kink, which is rounded itself, of a radius before it.
const BEFORE: f64 = 4.0 * f64::EPSILON;

impl Features {
    /// The radii between two others next to features of the profile, in increasing order.
    ///
    /// g′(x) = ∫₀^{π/2} (r f′)′|_{r = x sin t} dt is negative only where (r f′)′ is negative, or beyond a concave kink. Enclosures find
    /// every range with a negative (r f′)′ that is wider than a millionth of its radius.
    pub(in crate::contact) fn between<P: Quantities + ?Sized>(&self, shape: &P, lower: f64, upper: f64) -> Vec<f64> {
        let key = (lower.to_bits(), upper.to_bits());
        if let Some(known) = self.found.lock().unwrap_or_else(PoisonError::into_inner).get(&key) {
            return known.clone();
        }
        let compiled = || shape.formulas()?.iter().try_fold(Curvature::of(Vec::new()), |sum, own| sum.with(own).ok());
        let Some(curvature) = self.curvature.get_or_init(|| work::unbroken(compiled)) else { return Vec::new() };
        let found = work::unbroken(|| Self::next_to_bends(curvature, lower, upper));
        self.found.lock().unwrap_or_else(PoisonError::into_inner).insert(key, found.clone());
        found
    }

    fn next_to_bends(curvature: &Curvature<'_>, lower: f64, upper: f64) -> Vec<f64> {
        let kinks = curvature.kinks();
        let mut found: Vec<f64> =
            kinks.iter().filter(|kink| kink.jump < 0.0).flat_map(|kink| [kink.at * (1.0 - BEFORE), kink.at]).collect();
        let runs = work::share(LOOKING, || Cells::signs(curvature, &kinks, lower, upper).map(|cells| cells.falling_runs()));
        let is_narrow = |(from, to): &(f64, f64)| to - from < NARROW * to;
        found.extend(runs.flatten().unwrap_or_default().into_iter().filter(is_narrow).take(MOST_FEATURES).flat_map(around));
        found.retain(|r| *r > lower && *r < upper);
        found.sort_by(f64::total_cmp);
        found.dedup();
        found
    }
}
