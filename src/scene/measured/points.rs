//! Sorts the points by radius and merges equal radii; every correction is noted.

use super::columns::Sheet;
use super::note::Note;
use super::{shown, six_digits};
use crate::scene::{SceneError, System};

/// Radius and height in computing units, in increasing order of radius.
pub(super) type Points = Vec<(f64, f64)>;

/// Minimum number of points of a tip.
const FEWEST: usize = 4;
/// Maximum number of points.
const MOST_POINTS: usize = 200_000;
/// Radii closer than this fraction of the mean spacing are treated as equal.
const NEAR: f64 = 1e-6;
/// Steps are reported if at least one of this many intervals is level.
const STEPS_OF: usize = 20;

/// Sorts the points and merges duplicates.
///
/// # Errors
/// [`SceneError`] with a position in the file, for points that cannot be corrected.
pub(super) fn ordered(
    sheet: &Sheet,
    [r_scale, z_scale]: [f64; 2],
    line_scan: bool,
    system: &System,
    notes: &mut Vec<Note>,
) -> Result<Points, SceneError> {
    let name = &sheet.radius.name;
    let scaled = |value: f64, scale: f64| if scale >= 1.0 { value * scale } else { value / (1.0 / scale) };
    if !line_scan && let Some(row) = sheet.rows.iter().find(|row| row.r < 0.0) {
        let count = sheet.rows.iter().filter(|row| row.r < 0.0).count();
        let message = format!("{name} = {:?} is negative, as in {count} of {} rows", row.r, sheet.rows.len());
        let help = "expected radii of at least 0; set line_scan = true in [profile] for a line scan through the apex";
        return Err(SceneError::value(message).help(help).at(row.place.clone()));
    }
    let mut rows: Points = Vec::with_capacity(sheet.rows.len());
    for row in &sheet.rows {
        let (r, z) = (scaled(row.r, r_scale), scaled(row.z, z_scale));
        if !r.is_finite() || !z.is_finite() {
            let message = format!("{name} = {:?} overflows in the output units", row.r);
            return Err(SceneError::value(message).help("expected smaller numbers").at(row.place.clone()));
        }
        rows.push((r, z));
    }
    let unsorted = rows.windows(2).filter(|pair| matches!(pair, [one, other] if other.0 < one.0)).count();
    let falling = rows.windows(2).all(|pair| matches!(pair, [one, other] if other.0 <= one.0));
    if unsorted > 0 {
        rows.sort_by(|one, other| one.0.total_cmp(&other.0));
        let how = if falling { "falling".to_owned() } else { format!("out of order at {unsorted} places") };
        notes.push(Note::new("tip_sorted", format!("the rows were sorted by {name}, since they were {how}"), None));
    }
    let points = joined(&rows, name, system, notes);
    let last = sheet.rows.last().map_or(0..0, |row| row.place.clone());
    if points.len() < FEWEST {
        let message = format!("the file contains only {} different {name}", points.len());
        return Err(SceneError::value(message).help(format!("expected at least {FEWEST}")).at(last));
    }
    if points.len() > MOST_POINTS {
        let message = format!("the file contains {} different {name}, but the limit is {MOST_POINTS}", points.len());
        return Err(SceneError::value(message).help("use fewer points, such as every tenth row").at(last));
    }
    Ok(points)
}

/// Replaces points at the same radius by one point at their mean height.
fn joined(rows: &[(f64, f64)], name: &str, system: &System, notes: &mut Vec<Note>) -> Points {
    let extent = match (rows.first(), rows.last()) {
        (Some(first), Some(last)) => last.0 - first.0,
        _ => return Vec::new(),
    };
    let near = NEAR * extent / rows.len() as f64;
    let mut points: Points = Vec::with_capacity(rows.len());
    let (mut merged, mut averaged, mut spread, mut widest) = (0_usize, 0_usize, 0.0f64, 0.0);
    let mut at = 0;
    while let Some((r, z)) = rows.get(at).copied() {
        let group: Vec<f64> = rows.iter().skip(at).take_while(|own| own.0 - r <= near).map(|own| own.1).collect();
        at += group.len();
        if group.len() == 1 {
            points.push((r, z));
            continue;
        }
        let (low, high) = group.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(*z), high.max(*z)));
        if high == low {
            merged += group.len() - 1;
            points.push((r, z));
        } else {
            averaged += 1;
            if high - low > spread {
                (spread, widest) = (high - low, r);
            }
            points.push((r, z + group.iter().map(|own| own - z).sum::<f64>() / group.len() as f64));
        }
    }
    if merged > 0 {
        notes.push(Note::new("tip_merged", format!("{merged} duplicate rows were dropped"), None));
    }
    if averaged > 0 {
        let message = format!(
            "{averaged} values of {name} occur more than once with different heights, which were averaged; the heights differ by up to {}",
            shown(system, spread)
        );
        notes.push(Note::new("tip_averaged", message, Some(widest)));
    }
    points
}

/// Notes where heights decrease.
pub(super) fn note_falls(points: &[(f64, f64)], through_all: bool, system: &System, notes: &mut Vec<Note>) {
    let falls = |pair: &&[(f64, f64)]| matches!(pair, [one, other] if other.1 < one.1);
    let Some([first, _]) = points.windows(2).find(falls) else { return };
    let count = points.windows(2).filter(falls).count();
    let mut highest = f64::NEG_INFINITY;
    let mut deepest = 0.0f64;
    for (_, z) in points {
        highest = highest.max(*z);
        deepest = deepest.max(highest - z);
    }
    let share = six_digits(100.0 * count as f64 / (points.len().max(2) - 1) as f64);
    let mut message = format!(
        "the heights are not monotone: they decrease from r = {} on, in {share} % of the intervals, by at most {}",
        shown(system, first.0),
        shown(system, deepest)
    );
    if through_all {
        message.push_str("; if this is noise, smooth it with interpolation = \"smoothing-spline\" in [profile]");
    }
    notes.push(Note::new("tip_not_monotone", message, Some(first.0)));
}

/// Notes intervals of constant height beyond a flat end, which are caused by digitization or rounding.
pub(super) fn note_steps(points: &[(f64, f64)], notes: &mut Vec<Note>) {
    let rising = points.windows(2).skip_while(|pair| matches!(pair, [one, other] if other.1 == one.1));
    let (mut count, mut level) = (0_usize, 0_usize);
    let mut first = None;
    for pair in rising {
        let [one, other] = pair else { continue };
        count += 1;
        if one.1 == other.1 {
            level += 1;
            first.get_or_insert(one.0);
        }
    }
    if level * STEPS_OF >= count && level > 1 {
        let message = format!(
            "{level} of {count} intervals have the same height at both ends: the profile has steps, and so has the pressure; \
             interpolation = \"smoothing-spline\" in [profile] smooths them"
        );
        notes.push(Note::new("tip_steps", message, first));
    }
}

/// Extrapolates to f(0) if the first point is off the axis: with the even polynomial through the first points, or with a general polynomial for a pointed tip.
pub(super) fn extended(points: &mut Points, rounded: bool, system: &System, notes: &mut Vec<Note>) {
    let [first, second, third, ..] = *points.as_slice() else { return };
    if first.0 <= 0.0 {
        return;
    }
    // A gap at the axis wider than the spacing does not support a polynomial of higher order.
    let count = if first.0 <= 1.5 * (second.0 - first.0) { 3 } else { 2 };
    let abscissas = [first, second, third].map(|(r, z)| if rounded { (r * r, z) } else { (r, z) });
    let height = polynomial_at_axis(abscissas.get(..count).unwrap_or_default());
    let how = if rounded { "evenly, with a level apex," } else { "evenly, with the pointed apex that the first points show," };
    let message = format!(
        "there was no point at r = 0: the profile was extrapolated {how} from r = {} to the axis, by {}",
        shown(system, first.0),
        shown(system, first.1 - height)
    );
    notes.push(Note::new("tip_extrapolated", message, Some(first.0)));
    points.insert(0, (0.0, height));
}

/// Evaluates the polynomial through these points at 0.
fn polynomial_at_axis(points: &[(f64, f64)]) -> f64 {
    let base = points.first().map_or(0.0, |own| own.1);
    let weight = |i: usize, s: f64| -> f64 {
        points.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, (other, _))| other / (other - s)).product()
    };
    base + points.iter().enumerate().map(|(i, (s, z))| (z - base) * weight(i, *s)).sum::<f64>()
}
