//! One rule applied to one piece of a panel: value, quadrature error and rounding noise.

use super::super::bounded::{Bounded, UNIT};
use super::super::error::NumError;
use super::rules::{KRONROD_15, KRONROD_21, KRONROD_31, KRONROD_61, Rule};
use super::transform::Map;
use super::{Integrand, Point};

/// Which rule: in order of cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    Points15,
    Points21,
    Points31,
    Points61,
}

impl Order {
    pub(super) fn points(self) -> u64 {
        match self {
            Self::Points15 => 15,
            Self::Points21 => 21,
            Self::Points31 => 31,
            Self::Points61 => 61,
        }
    }

    /// Steps of two degrees from this rule's last decay row to that of 31 points.
    pub(super) fn steps_to_the_largest(self) -> i32 {
        match self {
            Self::Points15 => 8,
            Self::Points21 => 5,
            Self::Points31 | Self::Points61 => 0,
        }
    }
}

/// A piece of a panel: the `index`-th of 2^`level` equal parts of the map's variable.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub(super) index: u64,
    pub(super) level: u32,
}

/// The result of applying a rule.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    /// The Kronrod value.
    pub(super) value: f64,
    /// Bound on the truncation error.
    pub(super) quadrature: f64,
    /// Bound on the effect of rounding in the integrand, the nodes and the sum.
    pub(super) noise: f64,
    /// The rule's value for |f|.
    pub(super) size: f64,
    /// Ratio of the integrand's coefficients two degrees apart: small where f is resolved.
    pub(super) rate: f64,
}

/// Applies the rule of the given order.
pub(super) fn sample(order: Order, map: &Map, place: Part, charge_x: bool, integrand: &mut Integrand<'_>) -> Result<Sample, NumError> {
    match order {
        Order::Points15 => apply(&KRONROD_15, map, place, charge_x, integrand),
        Order::Points21 => apply(&KRONROD_21, map, place, charge_x, integrand),
        Order::Points31 => apply(&KRONROD_31, map, place, charge_x, integrand),
        Order::Points61 => apply(&KRONROD_61, map, place, charge_x, integrand),
    }
}

/// Most points of a rule.
const MOST_NODES: usize = 61;

fn apply<const H: usize>(
    rule: &Rule<H>,
    map: &Map,
    place: Part,
    charge_x: bool,
    integrand: &mut Integrand<'_>,
) -> Result<Sample, NumError> {
    // Integer positions: the fractions 0 … 1 of the panel keep full relative accuracy at both ends.
    let width = 0.5f64.powi(place.level as i32);
    let before = place.index as f64;
    let after = ((1u64 << place.level) - 1 - place.index) as f64;
    // All points first, so that the integrand sees them as one block: the lower half, the upper half, the centre.
    let nowhere = Point { x: 0.0, from_lower: 0.0, from_upper: 0.0 };
    let (mut points, mut slopes, mut heights) = ([nowhere; MOST_NODES], [0.0; MOST_NODES], [Bounded::exact(0.0); MOST_NODES]);
    let count = 2 * H - 1;
    for (i, &near) in rule.distance.iter().enumerate().take(H - 1) {
        let far = 1.0 - near;
        (points[i], slopes[i]) = map.point((before + near) * width, (after + far) * width);
        (points[H - 1 + i], slopes[H - 1 + i]) = map.point((before + far) * width, (after + near) * width);
    }
    (points[count - 1], slopes[count - 1]) = map.point((before + 0.5) * width, (after + 0.5) * width);
    integrand(&points[..count], &mut heights[..count]);
    let mut noise = 0.0;
    let mut at = |index: usize, weight: f64| -> Result<f64, NumError> {
        let (height, slope) = (heights[index], slopes[index]);
        if !height.value.is_finite() {
            return Err(NumError::NotFinite { at: points[index].x });
        }
        let carried = weight * slope * height.error;
        // Treat an unknown error as unbounded.
        noise += if carried.is_nan() { f64::INFINITY } else { carried };
        Ok(height.value * slope)
    };
    let (mut low, mut high) = ([0.0; H], [0.0; H]);
    for (i, &weight) in rule.kronrod.iter().enumerate().take(H - 1) {
        low[i] = at(i, weight)?;
        high[i] = at(H - 1 + i, weight)?;
    }
    let centre = at(count - 1, rule.kronrod[H - 1])?;
    // The centre counts once: as a sum with nothing, and as no difference.
    (low[H - 1], high[H - 1]) = (centre, 0.0);

    let sums: [f64; H] = std::array::from_fn(|i| low[i] + high[i]);
    let differences: [f64; H] = std::array::from_fn(|i| high[i] - low[i]);
    let sizes: [f64; H] = std::array::from_fn(|i| low[i].abs() + high[i].abs());
    let kronrod = dot(&rule.kronrod, &sums);
    let size = dot(&rule.kronrod, &sizes);
    let steps = |from: &[f64; H]| -> f64 {
        let inner = if H > 1 { (from[H - 2] - centre).abs() } else { 0.0 };
        from.windows(2).take(H - 2).map(|pair| (pair[1] - pair[0]).abs()).sum::<f64>() + inner
    };
    let variation = steps(&low) + steps(&high);

    let scale = 0.5 * width;
    let shift = map.displacement(before * width, (before + 1.0) * width, charge_x);
    // Weights, products and the four-lane sum cost at most 8 roundings; the map's slope another 8.
    let roundings = if map.is_smooth() { 8.0 } else { 16.0 };
    let rounding = roundings * UNIT * size;
    let [a, b, c, d, e, f] = &rule.decay;
    let levels =
        [dot(a, &differences).hypot(dot(b, &sums)), dot(c, &differences).hypot(dot(d, &sums)), dot(e, &differences).hypot(dot(f, &sums))];
    let gap = (kronrod - dot(&rule.gauss, &sums)).abs();
    let (left_out, rate) = truncation(levels, gap, rounding + noise);
    let found = Sample {
        value: kronrod * scale,
        quadrature: left_out * scale,
        noise: (noise + rounding) * scale + shift * variation,
        size: size * scale,
        rate,
    };
    if found.value.is_finite() && found.size.is_finite() && found.quadrature.is_finite() {
        Ok(found)
    } else {
        // The values are finite but their sum is not.
        let (point, _) = map.point((before + 0.5) * width, (after + 0.5) * width);
        Err(NumError::NotFinite { at: point.x })
    }
}

/// Smallest rate of decay to assume: next to r⁵ the step of erf(r/w) with a narrow w affects only the last coefficients, and
/// the following coefficients decrease slowly.
const LEAST_FALL: f64 = 0.1;

/// The truncation error of the Kronrod rule, from the last three pairs of coefficients and the difference to
/// the Gauss rule; and the rate at which the coefficients decay over two degrees.
///
/// The difference estimates the error of the *Gauss* rule. The Kronrod rule, exact to 1.6 times the
/// degree, is much more accurate only if the coefficients continue to decrease, so they must decrease at
/// every step that the points can resolve. The bound is ten times the difference, reduced by the rate of
/// one such step. A geometric decay gains five steps and an algebraic decay (a kink in some derivative)
/// more than three; this margin covers a slowly decaying part hidden under a fast one.
fn truncation(levels: [f64; 3], gap: f64, floor: f64) -> (f64, f64) {
    let [first, second, third] = levels;
    let fall = |now: f64, before: f64| {
        if now <= floor { 0.0 } else { now / before.max(floor) }
    };
    let rate = fall(second, first).max(fall(third, second));
    let seen = gap.max(third);
    let left_out = 10.0 * seen * rate.clamp(LEAST_FALL, 1.0);
    // Coefficients at the level of rounding noise cannot decrease further.
    (if seen <= floor { left_out.min(seen) } else { left_out }, rate)
}

/// Σ a·b in four lanes, which shortens the chains of roundings and of dependent operations.
fn dot<const H: usize>(a: &[f64; H], b: &[f64; H]) -> f64 {
    let mut lanes = [0.0; 4];
    for (i, (x, y)) in a.iter().zip(b).enumerate() {
        lanes[i & 3] += x * y;
    }
    (lanes[0] + lanes[1]) + (lanes[2] + lanes[3])
}
