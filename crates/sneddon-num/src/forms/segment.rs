//! Powers of the distance to a kink, integrated over one segment of a profile.

use crate::double_double::{DoubleDouble, two_sum};
use crate::legendre;
use crate::stable::{exponent, ldexp};
use crate::work;

/// `K_k(b, c; x) = ∫_b^min(c,x) (r - b)^k / sqrt(x^2 - r^2) dr`, the slope of a power that starts at `b`.
///
/// Domain: integer `k >= 0`, `0 <= b < x` finite, `c >= b` (`INFINITY` means up to `x`). Zero for `x <= b` and for
/// `c = b`; NaN for `c < b`, `b < 0`, `x` infinite or NaN.
///
/// Special cases: `k = 0` is the angle [`angle_between`]; `k = 1`, `c >= x` is `sqrt(x^2-b^2) - b acos(b/x)`.
///
/// Accuracy: measured at most 4.0 ulp, also for thin segments, `c -> x`, `b -> x`, `k` up to 200, and `x` from
/// 1e-200 to 1e200 wherever the result is a normal number.
///
/// Source: MDR chapter (3.27) for the integral; method in `moment` below.
///
/// ```
/// use sneddon_num::forms::shifted_power;
/// let (b, x) = (3.0_f64, 5.0_f64);
/// let closed = 4.0 - b * (b / x).acos();
/// assert!((shifted_power(1, b, f64::INFINITY, x) - closed).abs() < 1e-15);
/// ```
pub fn shifted_power(k: u32, b: f64, c: f64, x: f64) -> f64 {
    if k == 0 { angle_between(b, c, x) } else { moment(k, b, c, x, false) }
}

/// `∫_b^min(c,a) (r - b)^k r^2 / sqrt(a^2 - r^2) dr`, the force of a power that starts at `b`.
///
/// Domain and special cases as for [`shifted_power`], with the contact radius `a` in place of `x`.
///
/// Accuracy: measured at most 4.0 ulp over the same range.
///
/// Source: MDR chapter, force of a smooth edge `F = 2E ∫ r^2 f'(r) / sqrt(a^2 - r^2) dr`.
///
/// ```
/// use sneddon_num::forms::shifted_power_force;
/// let whole = shifted_power_force(1, 0.0, f64::INFINITY, 2.0); // paraboloid: ∫ r^3 / sqrt(a^2 - r^2) dr = 2 a^3 / 3
/// assert!((whole - 16.0 / 3.0).abs() < 1e-14);
/// ```
pub fn shifted_power_force(k: u32, b: f64, c: f64, a: f64) -> f64 {
    moment(k, b, c, a, true)
}

/// `asin(min(c,x)/x) - asin(b/x) = ∫_b^min(c,x) dr / sqrt(x^2 - r^2)`, the angle that a segment spans.
///
/// Domain and special cases as for [`shifted_power`].
///
/// Accuracy: measured at most 2.6 ulp. Neither angle is formed, only sine and cosine of their difference, or the sine of its half.
///
/// ```
/// use sneddon_num::forms::angle_between;
/// assert_eq!(angle_between(0.0, f64::INFINITY, 3.0), std::f64::consts::FRAC_PI_2);
/// ```
pub fn angle_between(b: f64, c: f64, x: f64) -> f64 {
    if c >= x && b >= 0.0 && b < x && x < 1e140 && (x > 1e-140 || b <= FAR * x) {
        return angle_above(b, x);
    }
    let Some(segment) = Segment::new(b, c, x) else {
        return f64::NAN;
    };
    if segment.is_empty() {
        return 0.0;
    }
    let Segment { b, c, x, from_b, from_c, .. } = segment;
    let width = ldexp(segment.width.value(), segment.shift);
    if c < 1e-100 {
        return width / x; // the sine of a small angle, and b c / x^2 below would underflow
    }
    let (leg_b, leg_c) = ((from_b * (x + b)).sqrt(), (from_c * (x + c)).sqrt());
    if from_c == 0.0 {
        return leg_b.atan2(b);
    }
    let sine = x * x * (width * (c + b) / (c * leg_b + b * leg_c));
    sine.atan2(b * c + leg_b * leg_c)
}

/// The same for a segment from b on without an end.
#[inline]
pub fn angle_above(b: f64, x: f64) -> f64 {
    // Far from b the cosine is as good as the sine; nearer, nothing leaves the range of doubles.
    if b >= 0.0 && b <= FAR * x && x < 1e140 && x > 0.0 {
        return (b / x).acos();
    }
    if b >= 0.0 && b < x && x < 1e140 && x > 1e-140 {
        // Half the angle has the sine √((1 − b/x)/2).
        return 2.0 * ((x - b) / (x + x)).sqrt().asin();
    }
    angle_between(b, f64::INFINITY, x)
}

/// Up to this b/x, its rounding error changes the angle by at most the rounding error of the angle.
const FAR: f64 = 0.7;

/// A segment `[b, c]` below `x`, with `x` scaled by a power of two into `[1, 2)`.
struct Segment {
    b: f64,
    c: f64,
    x: f64,
    /// `x - b`, scaled.
    from_b: f64,
    /// `x - c`, scaled.
    from_c: f64,
    /// `c - b`, exact and *not* scaled: its powers are what would leave the range.
    width: DoubleDouble,
    /// The scaling exponent.
    shift: i64,
}

impl Segment {
    /// None outside the domain.
    fn new(b: f64, c: f64, x: f64) -> Option<Self> {
        if !(b >= 0.0 && c >= b && x >= 0.0 && x.is_finite()) {
            return None;
        }
        let c = c.min(x);
        let shift = -i64::from(exponent(x));
        let width = two_sum(c, -b);
        let scaled = |value: f64| ldexp(value, shift);
        Some(Self { b: scaled(b), c: scaled(c), x: scaled(x), from_b: scaled(x - b), from_c: scaled(x - c), width, shift })
    }

    fn is_empty(&self) -> bool {
        self.width.hi <= 0.0
    }
}

/// Both integrals, by Gauss–Legendre in `t = sqrt((x - r)/(x - b))`.
///
/// With `t` running linearly, `t = t_c + (1 - t_c) s`, the root at `r = x` disappears and
/// `r - b = (c - b) q`, `q = (1 - s)(1 + rho s)`, `rho = (1 - t_c)/(1 + t_c)`, a product of positive factors;
/// `K = 2 (c-b)^(k+1) / (sqrt(x-b) + sqrt(x-c)) ∫_0^1 q^k / sqrt(x + r) ds`. The integrand is analytic far beyond
/// the interval for every b, c, x. Large `k`: the range is cut where `q^k` falls below `e^-44`.
fn moment(k: u32, b: f64, c: f64, x: f64, with_square: bool) -> f64 {
    let Some(segment) = Segment::new(b, c, x) else {
        return f64::NAN;
    };
    if segment.is_empty() {
        return 0.0;
    }
    work::spend(RULE);
    let Segment { b, x, from_b, from_c, .. } = segment;
    let order = f64::from(k);
    let width = ldexp(segment.width.value(), segment.shift);
    let root = (from_c / from_b).sqrt();
    let linear = 2.0 * root / (1.0 + root); // 1 - rho
    let rho = width / from_b / ((1.0 + root) * (1.0 + root));
    let range = if k <= SMALL {
        1.0
    } else {
        let depth = -(-44.0 / order).exp_m1();
        (2.0 * depth / (linear + (linear * linear + 4.0 * rho * depth).sqrt())).min(1.0)
    };
    let integral = legendre::integrate(|t, rest| {
        let s = t * range;
        let (q, power) = if k <= SMALL {
            let q = rest * (1.0 + rho * t);
            (q, (0..k).fold(1.0, |product, _| product * q))
        } else {
            // 1 - q as a sum of positive terms: the logarithm stays relatively accurate where q^k matters.
            let defect = s * (linear + rho * s);
            (1.0 - defect, (order * (-defect).ln_1p()).exp())
        };
        let r = b + width * q;
        let density = power / (x + r).sqrt();
        if with_square { density * r * r } else { density }
    });
    let (mantissa, power_exponent) = power(segment.width, u64::from(k) + 1);
    let head = 2.0 * range * integral / (from_b.sqrt() + from_c.sqrt());
    let shift = if with_square { -segment.shift } else { segment.shift };
    ldexp(head * mantissa, power_exponent + shift)
}

/// The steps of the rule, in addition to those of a function.
const RULE: u64 = 10;
/// Up to this `k`, plain products are as accurate as the exponential.
const SMALL: u32 = 4;

/// `base^n` as mantissa and binary exponent: in double-double, since `n` multiplies every rounding of the base.
fn power(base: DoubleDouble, n: u64) -> (f64, i64) {
    let normal = |value: DoubleDouble| {
        let e = i64::from(exponent(value.hi));
        (DoubleDouble { hi: ldexp(value.hi, -e), lo: ldexp(value.lo, -e) }, e)
    };
    let (mut square, mut square_exponent) = normal(base);
    let (mut result, mut result_exponent) = (DoubleDouble::ONE, 0_i64);
    let mut rest = n;
    while rest > 0 {
        if rest & 1 == 1 {
            let (product, e) = normal(result.mul(square));
            result = product;
            result_exponent += square_exponent + e;
        }
        let (product, e) = normal(square.mul(square));
        square = product;
        square_exponent = 2 * square_exponent + e;
        rest >>= 1;
    }
    (result.value(), result_exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(shifted_power(3, 2.0, 3.0, 1.0), 0.0);
        assert_eq!(shifted_power(3, 2.0, 2.0, 5.0), 0.0);
        assert_eq!(shifted_power(0, 0.0, f64::INFINITY, 0.0), 0.0);
        for (b, c, x) in [(-1.0, 2.0, 3.0), (2.0, 1.0, 3.0), (1.0, 2.0, f64::INFINITY), (f64::NAN, 2.0, 3.0)] {
            assert!(shifted_power(2, b, c, x).is_nan());
            assert!(angle_between(b, c, x).is_nan());
        }
        assert!(shifted_power(u32::MAX, 0.0, 1.0, 2.0).is_finite());
    }

    /// The force is the sum of three slopes: r^2 = (r-b)^2 + 2b(r-b) + b^2, all terms positive.
    #[test]
    fn force_is_a_sum_of_slopes() {
        for (k, b, c, x) in [(0, 0.5, 0.9, 1.0), (3, 0.1, 7.0, 2.0), (40, 1.0, 1.5, 1.6)] {
            let sum = b * b * shifted_power(k, b, c, x) + 2.0 * b * shifted_power(k + 1, b, c, x) + shifted_power(k + 2, b, c, x);
            assert!((shifted_power_force(k, b, c, x) / sum - 1.0).abs() < 3e-15);
        }
    }
}
