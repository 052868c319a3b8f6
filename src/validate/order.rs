//! Orders of convergence: one slope for all loads, one intercept per load, and confidence intervals.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// An order q in |e| ≈ C h^q, with the 95 % confidence interval, or with the range of the ratios between neighbours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order {
    /// q.
    pub value: f64,
    /// The lower end; `None` if two files with one load do not allow an interval.
    pub low: Option<f64>,
    /// The upper end.
    pub high: Option<f64>,
    /// Number of files whose errors are above the floor.
    pub files: usize,
    /// The error below which refinement has no effect, if it was reached.
    pub floor: Option<f64>,
}

/// Errors of one file: its pixel, and relative errors by load, in the same order for all files.
pub struct Level {
    /// The side of a pixel.
    pub pixel: f64,
    /// Relative errors; `None` for loads that were not compared.
    pub errors: Vec<Option<f64>>,
    /// The same errors with their signs, which may cancel; for fields, the error of the amplitude.
    pub signed: Vec<Option<f64>>,
}

/// Possible orders of a discretization error.
const ORDERS: [f64; 6] = [0.5, 0.75, 1.0, 1.5, 2.0, 3.0];

/// The error e₀ on an infinitely fine grid, e = e₀ + C hᵠ with a C per load: an interval that contains e₀ for all orders q that a discretization
/// error may have. `None` for fewer than two files.
pub fn limit_error(levels: &[Level]) -> Option<(f64, f64)> {
    let loads = levels.iter().map(|level| level.signed.len()).max()?;
    let finest = levels.last()?.pixel;
    let intervals = ORDERS.iter().filter_map(|order| {
        let at = |load: usize| {
            let points = levels.iter().filter_map(|level| Some(((level.pixel / finest).powf(*order), level.signed.get(load).copied()??)));
            intercept(&points.collect::<Vec<_>>())
        };
        interval(&(0..loads).filter_map(at).collect::<Vec<_>>())
    });
    intervals.reduce(|one, other| (one.0.min(other.0), one.1.max(other.1)))
}

/// Returns the value at 0 of the least-squares line through points; `None` if all abscissas are equal.
fn intercept(points: &[(f64, f64)]) -> Option<f64> {
    let n = points.len() as f64;
    let mean = points.iter().fold((0.0, 0.0), |sum, own| (sum.0 + own.0 / n, sum.1 + own.1 / n));
    let (sxx, sxy) = points.iter().fold((0.0, 0.0), |sum, (x, y)| (sum.0 + (x - mean.0).powi(2), sum.1 + (x - mean.0) * (y - mean.1)));
    (sxx > 0.0).then(|| mean.1 - sxy / sxx * mean.0)
}

/// Returns the 95 % confidence interval of a mean; for a single value it is the value itself.
fn interval(values: &[f64]) -> Option<(f64, f64)> {
    let n = values.len() as f64;
    if values.is_empty() {
        return None;
    }
    let mean = values.iter().sum::<f64>() / n;
    if values.len() < 2 {
        return Some((mean, mean));
    }
    let spread = (values.iter().map(|own| (own - mean).powi(2)).sum::<f64>() / (n - 1.0) / n).sqrt();
    let half = StudentsT::new(0.0, 1.0, n - 1.0).ok()?.inverse_cdf(0.975) * spread;
    Some((mean - half, mean + half))
}

impl Level {
    fn typical(&self, floor: f64) -> f64 {
        let logs: Vec<f64> = self.errors.iter().flatten().map(|e| e.abs().max(floor).ln()).collect();
        (logs.iter().sum::<f64>() / logs.len().max(1) as f64).exp()
    }
}

/// Returns the order of errors as a function of the pixel; levels from coarse to fine. Errors up to `noise` are not discretization errors.
///
/// `None` if fewer than two levels are above the noise.
pub fn order(levels: &[Level], noise: f64) -> Option<Order> {
    let typical: Vec<f64> = levels.iter().map(|level| level.typical(noise)).collect();
    let mut above = typical.iter().take_while(|e| **e > 2.0 * noise).count();
    let mut floor = (above < levels.len()).then_some(noise);
    // A plateau after a decrease is a floor, unless all levels are on the plateau.
    while above >= 3 {
        let ratio = |i: usize| match (typical.get(i.wrapping_sub(1)), typical.get(i), levels.get(i.wrapping_sub(1)), levels.get(i)) {
            (Some(coarse), Some(fine), Some(one), Some(other)) => (coarse / fine).ln() / (one.pixel / other.pixel).ln(),
            _ => f64::NAN,
        };
        // Errors that increase again are not a floor.
        if (-0.25..0.15).contains(&ratio(above - 1)) && ratio(above - 2) > 0.5 {
            above -= 1;
            floor = typical.get(above).copied();
        } else {
            break;
        }
    }
    let levels = levels.get(..above)?;
    if levels.len() < 2 {
        return None;
    }
    let fitted = pooled(levels, noise).or_else(|| ratios(levels, noise))?;
    Some(Order { files: levels.len(), floor, ..fitted })
}

/// Least squares of ln|e| over ln h with an intercept per load; `None` if there are too few errors for an interval.
fn pooled(levels: &[Level], noise: f64) -> Option<Order> {
    let loads = levels.iter().map(|level| level.errors.len()).max()?;
    let (mut sxx, mut sxy, mut count, mut used) = (0.0, 0.0, 0usize, 0usize);
    let mut groups = Vec::new();
    for load in 0..loads {
        let at = |level: &Level| {
            let e = level.errors.get(load).copied().flatten()?.abs();
            (e > noise).then(|| (level.pixel.ln(), e.ln()))
        };
        let points: Vec<(f64, f64)> = levels.iter().filter_map(at).collect();
        if points.len() < 2 {
            continue;
        }
        let n = points.len() as f64;
        let mean = points.iter().fold((0.0, 0.0), |sum, own| (sum.0 + own.0 / n, sum.1 + own.1 / n));
        for (x, y) in &points {
            sxx += (x - mean.0).powi(2);
            sxy += (x - mean.0) * (y - mean.1);
        }
        count += points.len();
        used += 1;
        groups.push((points, mean));
    }
    if used < 2 || sxx == 0.0 || count < used + 2 {
        return None;
    }
    let slope = sxy / sxx;
    let left: f64 = groups.iter().flat_map(|(points, mean)| points.iter().map(|(x, y)| (y - mean.1 - slope * (x - mean.0)).powi(2))).sum();
    let freedom = (count - used - 1) as f64;
    let student = StudentsT::new(0.0, 1.0, freedom).ok()?.inverse_cdf(0.975);
    let half = student * (left / freedom / sxx).sqrt();
    let (low, high) = (Some(slope - half), Some(slope + half));
    Some(Order { value: slope, low, high, files: levels.len(), floor: None })
}

/// Returns successive ratios of norms over all loads.
fn ratios(levels: &[Level], noise: f64) -> Option<Order> {
    let ratio = |pair: &[Level]| {
        let [one, other] = pair else { return f64::NAN };
        (one.typical(noise) / other.typical(noise)).ln() / (one.pixel / other.pixel).ln()
    };
    let all: Vec<f64> = levels.windows(2).map(ratio).filter(|q| q.is_finite()).collect();
    let whole = ratio_of_ends(levels, noise)?;
    let several = all.len() >= 2;
    let low = several.then(|| all.iter().copied().fold(f64::INFINITY, f64::min));
    let high = several.then(|| all.iter().copied().fold(f64::NEG_INFINITY, f64::max));
    Some(Order { value: whole, low, high, files: levels.len(), floor: None })
}

fn ratio_of_ends(levels: &[Level], noise: f64) -> Option<f64> {
    let (first, last) = (levels.first()?, levels.last()?);
    let value = (first.typical(noise) / last.typical(noise)).ln() / (first.pixel / last.pixel).ln();
    value.is_finite().then_some(value)
}
