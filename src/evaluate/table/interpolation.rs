//! From points to cubic pieces: monotone interpolation and smoothing splines.

use super::Cubic;
use super::smoothing::{Penalty, smoothing_spline};
use crate::integrate::table_error::TableError;

/// How a table of points becomes a function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Interpolation {
    /// A cubic between every two points, through all of them, with a continuous slope, rising where they rise and falling
    /// where they fall.
    ///
    /// The slopes at the points are those of the polynomial through five neighbours (exact for a quartic), cut to
    /// [0, 3 min(Δ₋, Δ₊)], Δ the rises on either side: the sufficient condition of Fritsch and Carlson (1980), with the
    /// better slopes of Hyman (1983). The error falls as the fourth power of the spacing, next to an extremum as the second.
    MonotoneCubic,
    /// The same for an even f, f′(0) = 0: slopes near the axis know the mirror images of the points. For smooth tips, not for
    /// cones.
    EvenMonotoneCubic,
    /// The natural cubic spline that minimises Σ (z − f)² + λ ∫ f″² dr (Reinsch 1967), for points with noise.
    SmoothingSpline(Penalty),
    /// The same for an even f, f′(0) = 0: the points are mirrored at the axis. For smooth tips, not for cones.
    EvenSmoothingSpline(Penalty),
}

/// Checks the points.
pub(super) fn check(r: &[f64], z: &[f64], needed: usize) -> Result<(), TableError> {
    if r.len() != z.len() {
        return Err(TableError::Lengths { radii: r.len(), heights: z.len() });
    }
    if r.len() < needed {
        return Err(TableError::TooFew { given: r.len(), needed });
    }
    let mut last: Option<f64> = None;
    for (index, (radius, height)) in r.iter().copied().zip(z.iter().copied()).enumerate() {
        if !radius.is_finite() || !height.is_finite() {
            return Err(TableError::NotFinite { index, radius, height });
        }
        if radius < 0.0 {
            return Err(TableError::Negative { index, radius });
        }
        match last {
            Some(before) if radius < before => return Err(TableError::Unsorted { index, radius, before }),
            Some(before) if radius == before => return Err(TableError::Duplicate { index, before: index - 1, radius }),
            _ => last = Some(radius),
        }
    }
    Ok(())
}

/// The cubic pieces from the axis to the last radius.
pub(super) fn interpolate(r: &[f64], z: &[f64], how: Interpolation) -> Result<Vec<Cubic>, TableError> {
    check(r, z, if matches!(how, Interpolation::MonotoneCubic | Interpolation::EvenMonotoneCubic) { 2 } else { 3 })?;
    let mut pieces = match how {
        Interpolation::MonotoneCubic => hermite(r, z, &monotone_slopes(r, z)),
        Interpolation::EvenMonotoneCubic => hermite(r, z, &even_slopes(r, z)),
        Interpolation::SmoothingSpline(penalty) => {
            let (values, slopes) = smoothing_spline(r, z, penalty)?;
            hermite(r, &values, &slopes)
        }
        Interpolation::EvenSmoothingSpline(penalty) => {
            let (values, slopes) = mirrored(r, z, penalty)?;
            hermite(r, &values, &slopes)
        }
    };
    extend_to_axis(&mut pieces);
    if pieces.iter().any(|piece| !piece.is_finite()) {
        return Err(TableError::OutOfRange);
    }
    Ok(pieces)
}

/// From a first point beyond the axis an even parabola with the same slope leads to the axis.
fn extend_to_axis(pieces: &mut Vec<Cubic>) {
    let Some(first) = pieces.first().copied() else { return };
    let (radius, [height, f_prime, ..]) = (first.lower, first.coefficients);
    if radius > 0.0 {
        let coefficients = [height - 0.5 * f_prime * radius, 0.0, 0.5 * f_prime / radius, 0.0];
        pieces.insert(0, Cubic { lower: 0.0, upper: radius, coefficients });
    }
}

/// The mirror images beyond the axis, followed by the list itself.
fn beyond_axis(list: &[f64], sign: f64, at_axis: bool) -> Vec<f64> {
    list.iter().skip(usize::from(at_axis)).rev().map(|v| sign * v).chain(list.iter().copied()).collect()
}

/// Monotone slopes of the points with their mirror images.
fn even_slopes(r: &[f64], z: &[f64]) -> Vec<f64> {
    let at_axis = r.first() == Some(&0.0);
    if !at_axis {
        // Between the first point and its image the chord is level: it would cut the slope to 0.
        return monotone_slopes(r, z);
    }
    let mut slopes = monotone_slopes(&beyond_axis(r, -1.0, true), &beyond_axis(z, 1.0, true));
    slopes.split_off(slopes.len() - r.len())
}

/// The right half of the spline through the points and their mirror images. The piece across the axis is the even parabola.
fn mirrored(r: &[f64], z: &[f64], penalty: Penalty) -> Result<(Vec<f64>, Vec<f64>), TableError> {
    let at_axis = r.first() == Some(&0.0);
    let (mut values, mut slopes) = smoothing_spline(&beyond_axis(r, -1.0, at_axis), &beyond_axis(z, 1.0, at_axis), penalty)?;
    let left = values.len() - r.len();
    let (values, mut slopes) = (values.split_off(left), slopes.split_off(left));
    if let Some(first) = slopes.first_mut().filter(|_| at_axis) {
        *first = 0.0;
    }
    Ok((values, slopes))
}

/// The cubics with these values and slopes at their ends: f′ is continuous whatever rounding did to them.
fn hermite(r: &[f64], z: &[f64], slopes: &[f64]) -> Vec<Cubic> {
    let mut pieces = Vec::with_capacity(r.len());
    for i in 1..r.len() {
        let h = r[i] - r[i - 1];
        let (rise, m, n) = ((z[i] - z[i - 1]) / h, slopes[i - 1], slopes[i]);
        let coefficients = [z[i - 1], m, (3.0 * rise - 2.0 * m - n) / h, (m + n - 2.0 * rise) / (h * h)];
        pieces.push(Cubic { lower: r[i - 1], upper: r[i], coefficients });
    }
    pieces
}

fn monotone_slopes(r: &[f64], z: &[f64]) -> Vec<f64> {
    let rises: Vec<f64> = r.windows(2).zip(z.windows(2)).map(|(r, z)| (z[1] - z[0]) / (r[1] - r[0])).collect();
    (0..r.len())
        .map(|i| {
            let from = i.saturating_sub(2).min(r.len().saturating_sub(5));
            let to = (from + 5).min(r.len());
            let wanted = polynomial_slope(&r[from..to], &z[from..to], i - from);
            let before = i.checked_sub(1).and_then(|i| rises.get(i)).or(rises.first()).copied().unwrap_or(0.0);
            let after = rises.get(i).or(rises.last()).copied().unwrap_or(0.0);
            limited(wanted, before, after)
        })
        .collect()
}

/// The slope at one of its points of the polynomial through all of them, from differences to that point.
fn polynomial_slope(r: &[f64], z: &[f64], at: usize) -> f64 {
    // p′(r_i) = Σ_j (z_j − z_i) ℓ_j′(r_i), ℓ_j′(r_i) = Π_(k≠i,j) (r_i − r_k)/(r_j − r_k) / (r_j − r_i).
    let others = |j: usize| (0..r.len()).filter(move |k| *k != at && *k != j);
    (0..r.len())
        .filter(|j| *j != at)
        .map(|j| (z[j] - z[at]) / (r[j] - r[at]) * others(j).map(|k| (r[at] - r[k]) / (r[j] - r[k])).product::<f64>())
        .sum()
}

/// Fritsch and Carlson's sufficient condition; a slope within rounding of zero is zero.
fn limited(wanted: f64, before: f64, after: f64) -> f64 {
    const ROUNDING: f64 = 1e-13;
    if before * after <= 0.0 {
        return 0.0;
    }
    let least = before.abs().min(after.abs());
    let size = (wanted * before.signum()).clamp(0.0, 3.0 * least);
    if size <= ROUNDING * before.abs().max(after.abs()) { 0.0 } else { size * before.signum() }
}
