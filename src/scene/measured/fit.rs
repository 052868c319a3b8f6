//! Fits the named shapes to a measured tip by least squares.

use crate::num::work;
use crate::scene::Dimension;

/// A named shape with its best parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// The name of the shape in scene files.
    pub shape: &'static str,
    /// The parameters.
    pub parameters: Vec<FitParameter>,
    /// The root mean square deviation in height.
    pub rms: f64,
    /// The largest deviation in height.
    pub largest: f64,
}

/// A fitted parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitParameter {
    /// The name.
    pub name: &'static str,
    /// The value in computing units.
    pub value: f64,
    /// The dimension; angles are in radians.
    pub dimension: Dimension,
}

/// Number of trial values of the shape parameter before refinement.
const TRIES: i32 = 96;

/// A shape with one nonlinear parameter q, a length relative to the last radius; height and slope are fitted linearly.
struct Model {
    shape: &'static str,
    /// f at s = r/r_last.
    value: fn(f64, f64) -> f64,
    /// The range of ln q; a single value for shapes without q.
    range: (f64, f64),
    /// Computes the parameters from q, the linear factor, and r_last.
    parameters: fn(f64, f64, f64) -> Vec<FitParameter>,
    /// Number of free parameters, for model selection.
    count: f64,
}

fn length(name: &'static str, value: f64) -> FitParameter {
    FitParameter { name, value, dimension: Dimension::LENGTH }
}

fn angle(value: f64) -> FitParameter {
    FitParameter { name: "theta", value, dimension: Dimension::NONE }
}

const MODELS: [Model; 5] = [
    Model {
        shape: "paraboloid",
        value: |s, _| 0.5 * s * s,
        range: (0.0, 0.0),
        parameters: |_, c, end| vec![length("R", end * end / c)],
        count: 1.0,
    },
    Model { shape: "cone", value: |s, _| s, range: (0.0, 0.0), parameters: |_, c, end| vec![angle((c / end).atan())], count: 1.0 },
    // q = R/r_last is at least 1; R is not a linear factor, and c should be close to q.
    Model {
        shape: "sphere",
        value: |s, q| s * s / (q + ((q - s) * (q + s)).max(0.0).sqrt()),
        range: (0.0, 16.0),
        parameters: |q, _, end| vec![length("R", q * end)],
        count: 1.0,
    },
    // c (√(b² + r²) − b) has the slope c at large r and the radius b/c at the apex.
    Model {
        shape: "hyperboloid",
        value: |s, q| s * s / (q + s.hypot(q)),
        range: (-7.0, 4.0),
        parameters: |q, c, end| vec![length("h", c * q), length("b", q * end), angle((c / end).atan()), length("R", q * end * end / c)],
        count: 2.0,
    },
    Model {
        shape: "power",
        value: |s, q| s.powf(q),
        range: (-1.2, 3.0),
        parameters: |q, c, end| {
            let n = FitParameter { name: "n", value: q, dimension: Dimension::NONE };
            vec![n, FitParameter { name: "C", value: c / end.powf(q), dimension: Dimension::NONE }]
        },
        count: 2.0,
    },
];

/// Returns every shape that fits, the best first.
pub(super) fn fits(points: &[(f64, f64)]) -> Vec<Fit> {
    let Some(end) = points.last().map(|own| own.0).filter(|end| *end > 0.0) else { return Vec::new() };
    let count = points.len() as f64;
    let mean = points.iter().map(|own| own.1).sum::<f64>() / count;
    let scaled: Vec<(f64, f64)> = points.iter().map(|(r, z)| (r / end, z - mean)).collect();
    let size = scaled.iter().fold(0.0f64, |most, own| most.max(own.1.abs()));
    let mut found: Vec<(f64, Fit)> = MODELS.iter().filter_map(|model| fitted(model, &scaled, end, size)).collect();
    found.sort_by(|one, other| one.0.total_cmp(&other.0));
    found.into_iter().map(|(_, fit)| fit).collect()
}

/// Returns the fit and its information criterion, which is smaller for better fits.
fn fitted(model: &Model, points: &[(f64, f64)], end: f64, size: f64) -> Option<(f64, Fit)> {
    let deviation = |log: f64| linear(model, points, log.exp(), end).map_or(f64::INFINITY, |own| own.2);
    let (low, high) = model.range;
    let mut best = (deviation(low), low);
    let step = (high - low) / f64::from(TRIES);
    if step > 0.0 {
        for index in 1..=TRIES {
            let log = low + step * f64::from(index);
            let own = deviation(log);
            if own < best.0 {
                best = (own, log);
            }
        }
        let (mut from, mut to) = ((best.1 - step).max(low), (best.1 + step).min(high));
        let golden = 0.5 * (5f64.sqrt() - 1.0);
        for _ in 0..70 {
            let (one, two) = (to - golden * (to - from), from + golden * (to - from));
            if deviation(one) < deviation(two) { to = two } else { from = one }
        }
        let refined = 0.5 * (from + to);
        if deviation(refined) <= best.0 {
            best = (deviation(refined), refined);
        }
    }
    // At an end of the range of q a shape degenerates to a simpler one; only a sphere may be a full hemisphere.
    let at_end = step > 0.0 && (best.1 >= high - 1e-6 || (best.1 <= low + 1e-6 && model.shape != "sphere"));
    if at_end {
        return None;
    }
    let q = best.1.exp();
    let (factor, constant, rms) = linear(model, points, q, end)?;
    let largest = points.iter().fold(0.0f64, |most, (s, z)| most.max((z - constant - factor * (model.value)(*s, q)).abs()));
    let parameters = (model.parameters)(q, factor, end);
    // A shape that is convex in the opposite direction is not a fit.
    let possible = factor > 0.0 && parameters.iter().all(|own| own.value.is_finite());
    let count = points.len() as f64;
    // The Bayesian information criterion penalizes additional parameters.
    let rating = 2.0 * count * rms.max(1e-14 * size).max(f64::MIN_POSITIVE).ln() + model.count * count.ln();
    possible.then_some((rating, Fit { shape: model.shape, parameters, rms, largest }))
}

/// Returns factor, constant and root mean square of the best fit for this q; the factor of a sphere is fixed.
fn linear(model: &Model, points: &[(f64, f64)], q: f64, end: f64) -> Option<(f64, f64, f64)> {
    // Check the budget, since a long table needs thousands of fits.
    if work::is_stopped() {
        return None;
    }
    let count = points.len() as f64;
    let value = |s: f64| (model.value)(s, q);
    let mean = points.iter().map(|own| value(own.0)).sum::<f64>() / count;
    let factor = if model.shape == "sphere" {
        end
    } else {
        let (product, square) = points.iter().fold((0.0, 0.0), |(p, v), (s, z)| {
            let own = value(*s) - mean;
            (p + own * z, v + own * own)
        });
        if square > 0.0 { product / square } else { return None }
    };
    let middle = points.iter().map(|(s, z)| z - factor * value(*s)).sum::<f64>() / count;
    let rest: f64 = points.iter().map(|(s, z)| (z - middle - factor * value(*s)).powi(2)).sum();
    let rms = (rest / count).sqrt();
    rms.is_finite().then_some((factor, middle, rms))
}
