//! Line scans through the apex: centre, tilt, and average of both sides.

use super::note::Note;
use super::points::Points;
use super::{shown, six_digits};
use crate::scene::{SceneError, System};

/// The result of centring a line scan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scan {
    /// The position of the apex in the scan.
    pub apex_offset: f64,
    /// The slope of the odd part, which is the tilt of the sample.
    pub tilt: f64,
    /// The root mean square of half the difference between both sides, after the tilt is removed.
    pub asymmetry: f64,
}

/// Minimum fraction of half the scan on either side of the centre.
const SHORTEST: f64 = 0.2;
/// Number of trial positions of the centre before refinement.
const TRIES: usize = 400;
/// A tilt is removed if it reduces the asymmetry below this fraction and there are enough radii.
const BELIEVED: f64 = 0.5;
/// With fewer radii than this, a tilt may be due to chance.
const FEW_BELIEVED: f64 = 10.0;
/// An asymmetry below this fraction of the height is rounding error.
const ROUNDING: f64 = 1e-11;
/// Minimum number of radii at which both sides can be compared.
const FEWEST: usize = 3;

/// Centres a scan and averages its sides.
///
/// # Errors
/// [`SceneError`] if the apex is not inside the scan.
pub(super) fn folded(scan: &[(f64, f64)], system: &System, notes: &mut Vec<Note>) -> Result<(Points, Scan), SceneError> {
    let (Some(first), Some(last)) = (scan.first(), scan.last()) else { return Ok((Vec::new(), Scan::NONE)) };
    let half = 0.5 * (last.0 - first.0);
    let middle = 0.5 * (last.0 + first.0);
    let reach = (1.0 - SHORTEST) * half;
    let lowest = scan.iter().min_by(|one, other| one.1.total_cmp(&other.1)).unwrap_or(first);
    let highest = scan.iter().max_by(|one, other| one.1.total_cmp(&other.1)).unwrap_or(last);
    let height = highest.1 - lowest.1;
    let help = "expected a scan with the apex between its ends, or line_scan = false for radii of at least 0";
    let at_end = |own: &(f64, f64)| own.0 == first.0 || own.0 == last.0;
    if height > 0.0 && at_end(lowest) && at_end(highest) {
        let message = "the scan has no apex between its ends: the lowest and the highest point are the ends";
        return Err(SceneError::value(message).help(help));
    }
    // Search without a tilt first: a tilted paraboloid is a shifted paraboloid, and the two cannot be distinguished.
    let (level, level_rest) = best(scan, (middle - reach, middle + reach), height, false);
    let (tilted, tilted_rest) = best(scan, (middle - reach, middle + reach), height, true);
    let compared = Sides::new(scan, tilted).folds().len().max(1) as f64;
    let demanded = BELIEVED / (1.0 + FEW_BELIEVED / compared).sqrt();
    let believed = tilted_rest < demanded * level_rest && level_rest > ROUNDING * height;
    let apex_offset = snapped(scan, if believed { tilted } else { level });
    let sides = Sides::new(scan, apex_offset);
    let folds = sides.folds();
    let inside = folds.len() >= FEWEST && (apex_offset - middle).abs() < 0.999 * reach;
    if !inside {
        return Err(SceneError::value("the scan has no axis of symmetry between its ends").help(help));
    }
    let (tilt, asymmetry) = odd_part(&folds);
    let mut points: Points = folds.iter().map(|fold| (fold.r, 0.5 * (fold.near + fold.far))).collect();
    if let Some(own) = scan.iter().find(|own| own.0 == apex_offset)
        && points.first().is_some_and(|first| first.0 > 0.0)
    {
        points.insert(0, (0.0, own.1));
    }
    let found = Scan { apex_offset, tilt, asymmetry };
    let end = points.last().map_or(0.0, |own| own.0);
    let mut message = format!(
        "the scan was centred at x = {}, a tilt of {} was removed, and both sides were averaged up to r = {}; half their remaining difference is {} (root mean square)",
        shown(system, apex_offset),
        six_digits(tilt),
        shown(system, end),
        shown(system, asymmetry)
    );
    let longer = (last.0 - apex_offset).max(apex_offset - first.0);
    if longer > 1.01 * end {
        message.push_str(&format!("; the longer side continues to r = {} without a counterpart", shown(system, longer)));
    }
    notes.push(Note::new("tip_centred", message, None));
    Ok((points, found))
}

impl Scan {
    const NONE: Self = Self { apex_offset: 0.0, tilt: 0.0, asymmetry: 0.0 };
}

/// Both sides of a scan with increasing radii.
struct Sides {
    near: Points,
    far: Points,
}

/// Both heights at one radius; the sign makes the odd part follow the direction of the scan.
struct Fold {
    r: f64,
    near: f64,
    far: f64,
    sign: f64,
}

impl Sides {
    fn new(scan: &[(f64, f64)], centre: f64) -> Self {
        let split = scan.partition_point(|own| own.0 < centre);
        let (left, right) = scan.split_at(split);
        let left: Points = left.iter().rev().map(|(x, z)| (centre - x, *z)).collect();
        let mut right: Points = right.iter().map(|(x, z)| (x - centre, *z)).collect();
        // A point on the axis belongs to neither side.
        if right.first().is_some_and(|own| own.0 == 0.0) {
            right.remove(0);
        }
        Self { near: left, far: right }
    }

    /// Returns the heights of both sides at the radii of the side that begins farther out, so that nothing is extrapolated inward.
    fn folds(&self) -> Vec<Fold> {
        let begin = |side: &Points| side.first().map_or(f64::INFINITY, |own| own.0);
        let end = |side: &Points| side.last().map_or(0.0, |own| own.0);
        let (own, other, sign) =
            if begin(&self.near) > begin(&self.far) { (&self.near, &self.far, -1.0) } else { (&self.far, &self.near, 1.0) };
        let limit = end(other) * (1.0 + 1e-9);
        let mut at = 0;
        own.iter()
            .take_while(|(r, _)| *r <= limit)
            .filter_map(|(r, z)| Some(Fold { r: *r, near: interpolated(other, *r, &mut at)?, far: *z, sign }))
            .collect()
    }
}

/// Evaluates the cubic through four neighbours; `at` keeps the position, since radii increase.
fn interpolated(side: &[(f64, f64)], r: f64, at: &mut usize) -> Option<f64> {
    while side.get(*at).is_some_and(|own| own.0 < r) {
        *at += 1;
    }
    let from = at.saturating_sub(2).min(side.len().saturating_sub(4));
    let four = side.get(from..(from + 4).min(side.len())).filter(|four| !four.is_empty())?;
    if let Some(exact) = four.iter().find(|own| own.0 == r) {
        return Some(exact.1);
    }
    let base = four.first()?.1;
    let weight = |i: usize, own: f64| -> f64 {
        four.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, (other, _))| (r - other) / (own - other)).product()
    };
    Some(base + four.iter().enumerate().map(|(i, (own, z))| (z - base) * weight(i, *own)).sum::<f64>())
}

/// Returns the slope of the odd part, and the root mean square of its residual.
fn odd_part(folds: &[Fold]) -> (f64, f64) {
    let half = |fold: &Fold| 0.5 * fold.sign * (fold.far - fold.near);
    let (product, square) = folds.iter().fold((0.0, 0.0), |(p, s), own| (p + own.r * half(own), s + own.r * own.r));
    let tilt = if square > 0.0 { product / square } else { 0.0 };
    let rest: f64 = folds.iter().map(|own| (half(own) - tilt * own.r).powi(2)).sum();
    (tilt, (rest / folds.len().max(1) as f64).sqrt())
}

/// Returns the asymmetry about a centre, with or without a tilt.
fn rest(scan: &[(f64, f64)], centre: f64, with_tilt: bool) -> f64 {
    let folds = Sides::new(scan, centre).folds();
    if folds.len() < FEWEST {
        return f64::INFINITY;
    }
    if with_tilt {
        return odd_part(&folds).1;
    }
    let all: f64 = folds.iter().map(|own| (0.5 * (own.far - own.near)).powi(2)).sum();
    (all / folds.len() as f64).sqrt()
}

/// Finds the centre with the smallest asymmetry relative to the rise of the sides.
fn best(scan: &[(f64, f64)], (from, to): (f64, f64), height: f64, with_tilt: bool) -> (f64, f64) {
    // Long scans are thinned for the search.
    let step = (scan.len() / (2 * TRIES)).max(1);
    let thin: Points = scan.iter().step_by(step).copied().collect();
    let rated = |points: &[(f64, f64)], centre: f64| {
        let folds = Sides::new(points, centre).folds();
        let mean = folds.iter().map(|own| own.near + own.far).sum::<f64>() / folds.len().max(1) as f64;
        let rise: f64 = folds.iter().map(|own| (own.near + own.far - mean).powi(2)).sum();
        let own = rest(points, centre, with_tilt);
        let rise = (rise / folds.len().max(1) as f64).sqrt();
        // On a flank, which is nearly straight, both sides agree trivially.
        if rise > ROUNDING * height { own / rise } else { f64::INFINITY }
    };
    let place = |step: f64| from + (to - from) * step / TRIES as f64;
    let mut found = (f64::INFINITY, 0.5 * (from + to));
    for step in 0..=TRIES {
        let centre = place(step as f64);
        let own = rated(&thin, centre);
        // Ties, as on a flat, are resolved in favour of the middle.
        let middle = 0.5 * (from + to);
        let nearer = own == found.0 && (centre - middle).abs() < (found.1 - middle).abs();
        if own < found.0 || nearer {
            found = (own, centre);
        }
    }
    let width = (to - from) / TRIES as f64;
    let (mut low, mut high) = (found.1 - width, found.1 + width);
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    for _ in 0..60 {
        let (one, two) = (high - golden * (high - low), low + golden * (high - low));
        if rated(scan, one) < rated(scan, two) { high = two } else { low = one }
    }
    let mut centre = 0.5 * (low + high);
    if rated(scan, found.1) <= rated(scan, centre) {
        centre = found.1;
    }
    (centre, rest(scan, centre, with_tilt))
}

/// Returns the scan point that the centre agrees with to the accuracy of the search, if there is one.
fn snapped(scan: &[(f64, f64)], centre: f64) -> f64 {
    let spacing = match (scan.first(), scan.last()) {
        (Some(first), Some(last)) => (last.0 - first.0) / scan.len() as f64,
        _ => return centre,
    };
    let nearest = scan.iter().map(|own| own.0).min_by(|one, other| (one - centre).abs().total_cmp(&(other - centre).abs()));
    nearest.filter(|own| (own - centre).abs() <= 1e-6 * spacing).unwrap_or(centre)
}
