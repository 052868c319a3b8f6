//! Elliptic moments: the contribution to the pressure at radius s of an even or negative power worn flat to radius b.

use crate::special::{rd, rf};
use crate::stable::{exponent, ldexp};

/// `E_k(s; b, a) = ∫_M^a x^(2k) / sqrt((x^2 - M^2)(x^2 - m^2)) dx`, `M = max(s, b)`, `m = min(s, b)`, `k >= -1`.
///
/// A paraboloid worn flat to `b` has the pressure `(E/(pi R)) (2 E_1 - b^2 E_0)`.
///
/// Domain: `b, s >= 0`, `a` finite. Zero for `a <= M`; infinite at `s = b < a`, where the kink makes a logarithm
/// (and at `s = b = 0`, `k <= 0`; for `s = b = 0`, `k >= 1` it is `a^(2k-1)/(2k-1)`); NaN elsewhere, for `k > 500`, and
/// for `k <= 0` where `M/a` is below the normal numbers.
///
/// Accuracy: measured at most 6.6 ulp for `-1 <= k <= 8`, also for `s -> b`, `s -> a`, `a -> b` and `m = 0`.
/// Every term is positive for `k <= 1`.
///
/// Source: Carlson 1995; MDR chapter, pressure from g.
///
/// ```
/// use sneddon_num::forms::elliptic_moment;
/// // s = 0: ∫_b^a x / sqrt(x^2 - b^2) dx
/// assert!((elliptic_moment(1, 3.0, 0.0, 5.0) - 4.0).abs() < 1e-15);
/// ```
pub fn elliptic_moment(k: i32, b: f64, s: f64, a: f64) -> f64 {
    if !(b >= 0.0 && s >= 0.0 && a >= 0.0 && a.is_finite()) {
        return f64::NAN;
    }
    let (large, small) = (s.max(b), s.min(b));
    if a <= large {
        return 0.0;
    }
    if !(-1..=MAX_ORDER).contains(&k) {
        return f64::NAN;
    }
    if large == small {
        if large > 0.0 || k <= 0 {
            return f64::INFINITY;
        }
        return a.powf(f64::from(2 * k - 1)) / f64::from(2 * k - 1);
    }
    let e = i64::from(exponent(a));
    // In units of 2^e; the differences are taken before scaling, so they stay exact to half an ulp.
    let [upper_gap, lower_gap, inner_gap] = [a - large, a - small, large - small].map(|gap| ldexp(gap, -e));
    let [a, large, small] = [a, large, small].map(|length| ldexp(length, -e));
    if large < f64::MIN_POSITIVE {
        // M/a below the normal numbers: the whole power for k >= 1; no caller needs E_0 and E_(-1) there.
        let whole = a.powf(f64::from(k) * 2.0 - 1.0) / (2.0 * f64::from(k) - 1.0);
        return if k <= 0 { f64::NAN } else { ldexp(whole, e * (2 * i64::from(k) - 1)) };
    }
    let lower = lower_gap * (a + small);
    let q = (upper_gap * (a + large) / lower).sqrt();
    let fraction = (inner_gap / large) * ((large + small) / large); // 1 - (m/M)^2
    let delta = fraction * (a * a / lower);
    let cosine = inner_gap * (large + small) / lower;
    if k == -1 {
        // M^3 E_(-1) = int sin^2 t/D dt + sin p cos p/D(p), t from 0 to p, with D^2 = 1 - (m/M)^2 sin^2 t.
        let inverse = q * q * q / 3.0 * rd(cosine, delta, 1.0) + q * (large / a);
        // In units of a power of two next to M, whose cube neither overflows nor underflows.
        let own = i64::from(exponent(large));
        let large = ldexp(large, -own);
        return ldexp(inverse / (large * large * large), -3 * (e + own));
    }
    let first = q * rf(cosine, delta, 1.0); // F
    let moment_0 = first / large;
    if k == 0 {
        return ldexp(moment_0, -e);
    }
    // The recurrence is applied to D_k = E_k - M^2 E_(k-1) > 0: D_1 is a Carlson integral, and
    // (2k-1) D_k = a^(2k-3) sqrt((a^2-M^2)(a^2-m^2)) + (2k-3) m^2 D_(k-1) - (M^2-m^2) E_(k-1)
    // cancels little wherever D_k is significant relative to M^2 E_(k-1). In the three-term recurrence of E_k, errors
    // would grow with k when s, b and a are close.
    let inner = inner_gap * (large + small);
    // For M << a, inner and the cosine underflow together; there D_1 = a to all digits.
    let vanishing = cosine < 1e-290;
    let mut difference = if vanishing { a * q } else { inner / large * (q * q * q) / 3.0 * rd(delta, 1.0, cosine) };
    let (large2, small2) = (large * large, small * small);
    let mut moment = difference + large2 * moment_0;
    let mut boundary = a * q * lower;
    for order in 2..=k {
        let n = f64::from(order);
        difference = (boundary + (2.0 * n - 3.0) * small2 * difference - inner * moment) / (2.0 * n - 1.0);
        moment = difference + large2 * moment;
        boundary *= a * a;
    }
    ldexp(moment, e * (2 * i64::from(k) - 1))
}

/// Longest recurrence; an even power of 1000 is far beyond any tip.
const MAX_ORDER: i32 = 500;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(elliptic_moment(1, 1.0, 1.0, 2.0), f64::INFINITY);
        assert_eq!(elliptic_moment(2, 0.0, 0.0, 2.0), 8.0 / 3.0);
        assert_eq!(elliptic_moment(2, 3.0, 0.0, 2.0), 0.0);
        assert_eq!(elliptic_moment(-1, 0.0, 0.0, 2.0), f64::INFINITY);
        assert!(elliptic_moment(-2, 1.0, 0.0, 2.0).is_nan());
        assert!(elliptic_moment(0, -1.0, 0.0, 2.0).is_nan());
        assert!(elliptic_moment(0, 1.0, f64::NAN, 2.0).is_nan());
    }

    /// `s = 0`: `E_0 = acos(b/a)/b`, and `E_(-1) = acos(b/a)/(2 b^3) + sqrt(a^2-b^2)/(2 a^2 b^2)`.
    #[test]
    fn centre_is_elementary() {
        let value = elliptic_moment(0, 0.3, 0.0, 1.0);
        assert!((value / ((0.3_f64).acos() / 0.3) - 1.0).abs() < 1e-15);
        let (value, law) = (elliptic_moment(-1, 0.6, 0.0, 1.0), 0.6_f64.acos() / 0.432 + 0.8 / 0.72);
        assert!((value / law - 1.0).abs() < 1e-15, "{value} {law}");
        // pi/(4 b^3) where b is far below a.
        for (b, a) in [(1.0, 1e120), (1e-90, 1e90), (1e90, 1e200)] {
            let (value, law) = (elliptic_moment(-1, b, 0.0, a), std::f64::consts::FRAC_PI_4 / b / b / b);
            assert!((value / law - 1.0).abs() < 1e-15, "{b} {a}: {value} {law}");
        }
    }
}
