//! Carlson's symmetric elliptic integrals, from which the others are built without cancellation.

use super::ball::Ball;
use crate::stable::asinh;
use crate::{DoubleDouble, Precise};

/// `R_F(x, y, z) = (1/2) ∫_0^∞ dt / sqrt((t+x)(t+y)(t+z))`.
///
/// Domain: `x, y, z >= 0` finite, at most one zero (infinite with two); NaN elsewhere.
///
/// Accuracy: measured at most 3.8 ulp for arguments from 1e-300 to 1e300.
///
/// Source: Carlson 1995, duplication theorem; DLMF 19.36.1.
///
/// ```
/// use sneddon_num::special::rf;
/// assert!((rf(4.0, 4.0, 4.0) - 0.5).abs() < 1e-15);
/// assert!((rf(0.0, 1.0, 1.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// ```
pub fn rf(x: f64, y: f64, z: f64) -> f64 {
    if !in_domain(x) || !in_domain(y) || !in_domain(z) {
        return f64::NAN;
    }
    let zeros = [x, y, z].iter().filter(|v| **v == 0.0).count();
    if zeros >= 2 {
        return f64::INFINITY;
    }
    let (unit, root) = units(x.max(y).max(z));
    let (mut x, mut y, mut z) = (x * unit, y * unit, z * unit);
    for _ in 0..ROUNDS {
        let mean = x / 3.0 + y / 3.0 + z / 3.0;
        let (dx, dy) = (1.0 - x / mean, 1.0 - y / mean);
        let dz = -(dx + dy);
        if dx.abs().max(dy.abs()).max(dz.abs()) < CLOSE {
            let e2 = dx * dy - dz * dz;
            let e3 = dx * dy * dz;
            let series = e2 * (-1.0 / 10.0 + e2 / 24.0 - 3.0 / 44.0 * e3 - 5.0 / 208.0 * e2 * e2)
                + e3 * (1.0 / 14.0 + 3.0 / 104.0 * e3 + e2 * e2 / 16.0);
            return (1.0 + series) / mean.sqrt() * root;
        }
        let (rx, ry, rz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let lambda = rx * ry + rx * rz + ry * rz;
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
        z = 0.25 * (z + lambda);
    }
    f64::NAN
}

/// `R_D(x, y, z) = (3/2) ∫_0^∞ dt / (sqrt((t+x)(t+y)) (t+z)^(3/2))`.
///
/// Domain: `x, y >= 0` not both zero (infinite then), `z > 0` (infinite at 0), finite; NaN elsewhere.
///
/// Accuracy: measured at most 5.1 ulp for arguments from 1e-100 to 1e100; wider where the result is a normal number.
///
/// Source: Carlson 1995, duplication theorem; DLMF 19.36.2.
///
/// ```
/// use sneddon_num::special::rd;
/// assert!((rd(4.0, 4.0, 4.0) - 0.125).abs() < 1e-15);
/// ```
pub fn rd(x: f64, y: f64, z: f64) -> f64 {
    if !in_domain(x) || !in_domain(y) || !in_domain(z) {
        return f64::NAN;
    }
    if z == 0.0 || (x == 0.0 && y == 0.0) {
        return f64::INFINITY;
    }
    let (unit, root) = units(x.max(y).max(z));
    let (mut x, mut y, mut z) = (x * unit, y * unit, z * unit);
    let (mut sum, mut factor) = (0.0, 1.0);
    for _ in 0..ROUNDS {
        let mean = 0.2 * x + 0.2 * y + 0.6 * z;
        let (dx, dy) = (1.0 - x / mean, 1.0 - y / mean);
        let dz = -(dx + dy) / 3.0;
        if dx.abs().max(dy.abs()).max(dz.abs()) < CLOSE {
            let (product, square) = (dx * dy, dz * dz);
            let e2 = product - 6.0 * square;
            let e3 = (3.0 * product - 8.0 * square) * dz;
            let e4 = 3.0 * (product - square) * square;
            let e5 = product * square * dz;
            let series = e2 * (-3.0 / 14.0 + 9.0 / 88.0 * e2 - 9.0 / 52.0 * e3 - e2 * e2 / 16.0)
                + e3 * (1.0 / 6.0 + 3.0 / 40.0 * e3 + 45.0 / 272.0 * e2 * e2)
                + e4 * (-3.0 / 22.0 + 3.0 / 20.0 * e2 - 9.0 / 68.0 * e3)
                + e5 * (3.0 / 26.0 - 9.0 / 68.0 * e2);
            return (3.0 * sum + factor * (1.0 + series) / mean / mean.sqrt()) * unit * root;
        }
        let (rx, ry, rz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let lambda = rx * ry + rx * rz + ry * rz;
        sum += factor / rz / (z + lambda);
        factor *= 0.25;
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
        z = 0.25 * (z + lambda);
    }
    f64::NAN
}

/// `R_J(x, y, z, p) = (3/2) ∫_0^∞ dt / (sqrt((t+x)(t+y)(t+z)) (t+p))`.
///
/// Domain: `x, y, z >= 0` with at most one zero (infinite with two), `p > 0` (infinite at 0), finite; NaN elsewhere.
///
/// Accuracy: measured at most 2.5 ulp for arguments from 1e-90 to 1e90.
///
/// Source: Carlson 1995, duplication theorem; DLMF 19.36.1. `1 + e` of its `R_C(1, 1 + e)` is a product of positive factors here.
///
/// ```
/// use sneddon_num::special::rj;
/// assert!((rj(4.0, 4.0, 4.0, 4.0) - 0.125).abs() < 1e-15);
/// ```
pub fn rj(x: f64, y: f64, z: f64, p: f64) -> f64 {
    if ![x, y, z, p].into_iter().all(in_domain) {
        return f64::NAN;
    }
    if p == 0.0 || [x, y, z].iter().filter(|v| **v == 0.0).count() >= 2 {
        return f64::INFINITY;
    }
    let largest = x.max(y).max(z);
    if p / largest > FAR {
        return rj_far(x, y, z, p);
    }
    let (unit, root) = units(largest.max(p));
    let (mut x, mut y, mut z, mut p) = (x * unit, y * unit, z * unit, p * unit);
    let (mut sum, mut factor) = (0.0, 1.0);
    for _ in 0..ROUNDS {
        let mean = 0.2 * x + 0.2 * y + 0.2 * z + 0.4 * p;
        let (dx, dy, dz) = (1.0 - x / mean, 1.0 - y / mean, 1.0 - z / mean);
        let dp = -0.5 * (dx + dy + dz);
        if dx.abs().max(dy.abs()).max(dz.abs()).max(dp.abs()) < CLOSE {
            let (product, square) = (dx * dy * dz, dp * dp);
            let e2 = dx * dy + dx * dz + dy * dz - 3.0 * square;
            let e3 = product + 2.0 * e2 * dp + 4.0 * dp * square;
            let e4 = (2.0 * product + e2 * dp + 3.0 * dp * square) * dp;
            let e5 = product * square;
            let series = e2 * (-3.0 / 14.0 + 9.0 / 88.0 * e2 - 9.0 / 52.0 * e3 - e2 * e2 / 16.0)
                + e3 * (1.0 / 6.0 + 3.0 / 40.0 * e3 + 45.0 / 272.0 * e2 * e2)
                + e4 * (-3.0 / 22.0 + 3.0 / 20.0 * e2 - 9.0 / 68.0 * e3)
                + e5 * (3.0 / 26.0 - 9.0 / 68.0 * e2);
            return (6.0 * sum + factor * (1.0 + series) / mean / mean.sqrt()) * unit * root;
        }
        let (rx, ry, rz, rp) = (x.sqrt(), y.sqrt(), z.sqrt(), p.sqrt());
        let lambda = rx * ry + rx * rz + ry * rz;
        // d = (√p + √x)(√p + √y)(√p + √z) and 1 + e = 2 √p (p + λ)/d.
        let (one, two, three) = (rp + rx, rp + ry, rp + rz);
        let rest = 2.0 * (rp / one) * ((p + lambda) / two / three);
        sum += factor / one / two / three * rc(1.0, rest);
        factor *= 0.25;
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
        z = 0.25 * (z + lambda);
        p = 0.25 * (p + lambda);
    }
    f64::NAN
}

/// The ratio of p to the other arguments beyond which it would take many duplications to reach them.
const FAR: f64 = 1e6;

/// R_J for p far above the largest argument z: with (p - z)(q - z) = (z - x)(z - y), q is next to z (DLMF 19.21.12).
fn rj_far(x: f64, y: f64, z: f64, p: f64) -> f64 {
    let mut list = [x, y, z];
    list.sort_by(f64::total_cmp);
    let [x, y, z] = list;
    let beyond = (z - x) * ((z - y) / (p - z));
    let near = if beyond > 0.0 { beyond * rj(x, y, z, z + beyond) } else { 0.0 };
    (3.0 * (rf(x, y, z) - rc(x * (y / z), p * ((z + beyond) / z))) - near) / (p - z)
}

/// `R_C(x, y) = R_F(x, y, y) = (1/2) ∫_0^∞ dt / (sqrt(t+x) (t+y))`: arctangent, logarithm and the step between.
///
/// Domain: `x >= 0`, `y > 0` finite (infinite at `y = 0`); NaN elsewhere.
///
/// Accuracy: measured at most 3.0 ulp for arguments from 1e-300 to 1e300.
///
/// Source: DLMF 19.2.17–19.2.20; the forms below have no cancellation at `x = y`.
///
/// ```
/// use sneddon_num::special::rc;
/// assert_eq!(rc(0.25, 0.25), 2.0);
/// assert!((rc(0.0, 1.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// ```
pub fn rc(x: f64, y: f64) -> f64 {
    if !in_domain(x) || !in_domain(y) {
        return f64::NAN;
    }
    if y == 0.0 {
        return f64::INFINITY;
    }
    if x == y {
        return 1.0 / x.sqrt();
    }
    let root = (x - y).abs().sqrt();
    if x < y { root.atan2(x.sqrt()) / root } else { asinh(root / y.sqrt()) / root }
}

/// [`rf`] with about 30 digits: duplication until the spread is below 4e-5, then the series of seventh order.
///
/// Source: DLMF 19.36.1; the first neglected terms bound what the series leaves out.
///
/// ```
/// use sneddon_num::special::rf_precise;
/// assert!(rf_precise([1.0, 2.0, 3.0].map(Into::into)).error < 1e-27);
/// ```
pub fn rf_precise(arguments: [DoubleDouble; 3]) -> Precise {
    let [x, y, z] = arguments.map(Ball::exact);
    rf_ball(x, y, z).precise()
}

/// [`rd`] with about 30 digits, as [`rf_precise`].
///
/// Source: DLMF 19.36.2.
///
/// ```
/// use sneddon_num::special::rd_precise;
/// assert!(rd_precise([1.0, 2.0, 3.0].map(Into::into)).error < 1e-27);
/// ```
pub fn rd_precise(arguments: [DoubleDouble; 3]) -> Precise {
    let [x, y, z] = arguments.map(Ball::exact);
    rd_ball(x, y, z).precise()
}

/// [`rc`] with about 30 digits, as `R_F(x, y, y)`.
///
/// ```
/// use sneddon_num::special::rc_precise;
/// assert!(rc_precise([1.0, 2.0].map(Into::into)).error < 1e-27);
/// ```
pub fn rc_precise([x, y]: [DoubleDouble; 2]) -> Precise {
    rf_ball(Ball::exact(x), Ball::exact(y), Ball::exact(y)).precise()
}

/// A power of four of the size of the largest argument, and its root: everything else happens about 1.
fn sized(arguments: [Ball; 3]) -> Option<(f64, f64)> {
    let largest = arguments.iter().fold(0.0_f64, |most, x| most.max(x.hi()));
    let known = arguments.iter().all(|x| in_domain(x.hi()) && x.error.is_finite());
    let half = (largest.log2() * 0.5).round();
    (known && (-240.0..240.0).contains(&half)).then(|| (2.0_f64.powf(-2.0 * half), 2.0_f64.powf(-half)))
}

pub(super) fn rf_ball(x: Ball, y: Ball, z: Ball) -> Ball {
    let Some((unit, root)) = sized([x, y, z]) else { return Ball::NONE };
    if [x, y, z].iter().filter(|v| v.hi() == 0.0).count() >= 2 {
        return Ball::NONE;
    }
    let (mut x, mut y, mut z) = (x.scale(unit), y.scale(unit), z.scale(unit));
    for _ in 0..PRECISE_ROUNDS {
        let mean = (x + y + z) / 3.0;
        let (dx, dy) = (Ball::ONE - x / mean, Ball::ONE - y / mean);
        let dz = -(dx + dy);
        let spread = dx.hi().abs().max(dy.hi().abs()).max(dz.hi().abs());
        if spread < PRECISE_CLOSE {
            let e2 = dx * dy - dz.square();
            let e3 = dx * dy * dz;
            let series = e2 * (e2 / 24.0 - e3 * 3.0 / 44.0 - e2.square() * 5.0 / 208.0 - Ball::ONE / 10.0)
                + e3 * (Ball::ONE / 14.0 + e3 * 3.0 / 104.0 + e2.square() / 16.0);
            return ((series + 1.0) / mean.sqrt() * root).widened(spread.powi(8) / mean.hi().sqrt() * root);
        }
        let (rx, ry, rz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let lambda = rx * ry + rx * rz + ry * rz;
        (x, y, z) = ((x + lambda).scale(0.25), (y + lambda).scale(0.25), (z + lambda).scale(0.25));
    }
    Ball::NONE
}

pub(super) fn rd_ball(x: Ball, y: Ball, z: Ball) -> Ball {
    let Some((unit, root)) = sized([x, y, z]) else { return Ball::NONE };
    if z.hi() == 0.0 || (x.hi() == 0.0 && y.hi() == 0.0) {
        return Ball::NONE;
    }
    let (mut x, mut y, mut z) = (x.scale(unit), y.scale(unit), z.scale(unit));
    let (mut sum, mut factor) = (Ball::ZERO, 1.0);
    for _ in 0..PRECISE_ROUNDS {
        let mean = (x + y + z * 3.0) / 5.0;
        let (dx, dy) = (Ball::ONE - x / mean, Ball::ONE - y / mean);
        let dz = -(dx + dy) / 3.0;
        let spread = dx.hi().abs().max(dy.hi().abs()).max(dz.hi().abs());
        if spread < PRECISE_CLOSE {
            let (product, square) = (dx * dy, dz.square());
            let e2 = product - square * 6.0;
            let e3 = (product * 3.0 - square * 8.0) * dz;
            let e4 = (product - square) * square * 3.0;
            let e5 = product * square * dz;
            let series = e2 * (e2 * 9.0 / 88.0 - e3 * 9.0 / 52.0 - e2.square() / 16.0 - Ball::from(3.0) / 14.0)
                + e3 * (Ball::ONE / 6.0 + e3 * 3.0 / 40.0 + e2.square() * 45.0 / 272.0)
                + e4 * (e2 * 3.0 / 20.0 - e3 * 9.0 / 68.0 - Ball::from(3.0) / 22.0)
                + e5 * (Ball::from(3.0) / 26.0 - e2 * 9.0 / 68.0);
            let last = ((series + 1.0) * factor / mean / mean.sqrt()).widened(spread.powi(8) * 4.0 * factor * mean.hi().powf(-1.5));
            return (sum * 3.0 + last) * unit * root;
        }
        let (rx, ry, rz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let lambda = rx * ry + rx * rz + ry * rz;
        sum = sum + Ball::from(factor) / rz / (z + lambda);
        factor *= 0.25;
        (x, y, z) = ((x + lambda).scale(0.25), (y + lambda).scale(0.25), (z + lambda).scale(0.25));
    }
    Ball::NONE
}

/// The eighth power of this is below 2^-116.
const PRECISE_CLOSE: f64 = 4e-5;
/// Some 25 rounds for the spread of exponents, 8 for the spread itself.
const PRECISE_ROUNDS: u32 = 400;

/// Relative spread below which the seventh-order series is exact to 1e-17.
const CLOSE: f64 = 0.008;
/// The exponents' spread halves in each round, then the spread quarters: 25 rounds from 1e-300 to 1e300.
const ROUNDS: u32 = 60;

/// A power of four that takes the largest argument away from the ends of the range, and its square root.
fn units(largest: f64) -> (f64, f64) {
    if largest > 1e300 {
        (1.0 / 16.0, 0.25)
    } else if largest < 1e-290 {
        (2.0_f64.powi(80), 2.0_f64.powi(40))
    } else {
        (1.0, 1.0)
    }
}

fn in_domain(x: f64) -> bool {
    (0.0..f64::INFINITY).contains(&x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(rf(0.0, 0.0, 1.0), f64::INFINITY);
        assert_eq!(rd(1.0, 1.0, 0.0), f64::INFINITY);
        assert_eq!(rc(1.0, 0.0), f64::INFINITY);
        assert!(rf(-1.0, 1.0, 1.0).is_nan() && rd(1.0, 1.0, -1.0).is_nan() && rc(1.0, f64::NAN).is_nan());
        assert!(rf(1e-300, 1e-300, f64::MAX).is_finite());
        assert!(rd(1e-300, 1e-300, f64::MAX) >= 0.0);
    }
}
