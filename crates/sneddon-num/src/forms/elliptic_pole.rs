//! Elliptic integrals of the third kind: the contribution to the pressure of a pole beside the root of a kink.

use crate::special::{rf, rj};
use crate::stable::{exponent, ldexp};

/// `∫_M^a dx / ((x^2 ± w^2) sqrt((x^2 - M^2)(x^2 - m^2)))`, `M = max(s, b)`, `m = min(s, b)`; `sign` is 1 or -1.
///
/// Domain: `w > 0`, `b, s >= 0`, `a` finite, and `w > a` for `sign = -1`. Zero for `a <= M`; infinite at `s = b < a`; NaN elsewhere.
///
/// Accuracy: measured at most 3.2 ulp, also for `s -> b`, `s -> a`, `a -> b`, `a -> w` and `m = 0`.
///
/// Source: Carlson 1995; with q = ± w² it is (N/(M (M²+q))) (R_F(δ, 1, c) - (a²-M²) c/(3 (M²+q)) R_J(δ, 1, c, c (a²+q)/(M²+q))),
/// N² = (a²-M²)/(a²-m²), c = (M²-m²)/(a²-m²), δ = c a²/M².
///
/// ```
/// use sneddon_num::forms::elliptic_pole;
/// // s = 0: ∫_b^a dx / ((x^2 + w^2) x sqrt(x^2 - b^2))
/// let law = ((0.75_f64.sqrt() / 0.5).atan() / 0.5 - (0.75 / 1.25_f64).sqrt().atan() / 1.25_f64.sqrt());
/// assert!((elliptic_pole(1.0, 1.0, 0.5, 0.0, 1.0) - law).abs() < 1e-14);
/// ```
pub fn elliptic_pole(sign: f64, w: f64, b: f64, s: f64, a: f64) -> f64 {
    let is_inside = w > 0.0 && b >= 0.0 && s >= 0.0 && a >= 0.0 && a.is_finite() && w.is_finite();
    if !(is_inside && (sign == 1.0 || sign == -1.0 && a < w)) {
        return f64::NAN;
    }
    let (large, small) = (s.max(b), s.min(b));
    if a <= large {
        return 0.0;
    }
    if large == small {
        return f64::INFINITY;
    }
    let e = i64::from(exponent(a));
    // In units of 2^e; the differences are taken before scaling, so they stay exact to half an ulp.
    let [upper_gap, lower_gap, inner_gap] = [a - large, a - small, large - small].map(|gap| ldexp(gap, -e));
    let from_pole = [a, large].map(|length| ldexp(w - length, -e));
    let [a, large, small, w] = [a, large, small, w].map(|length| ldexp(length, -e));
    if large < f64::MIN_POSITIVE {
        return f64::NAN;
    }
    let beside = |length: f64, gap: f64| if sign > 0.0 { length.hypot(w).powi(2) } else { -gap * (w + length) };
    let (at_edge, at_large) = (beside(a, from_pole[0]), beside(large, from_pole[1]));
    let (upper, lower) = (upper_gap * (a + large), lower_gap * (a + small));
    let cosine = inner_gap * (large + small) / lower;
    let delta = (inner_gap / large) * ((large + small) / large) * (a * a / lower);
    let bracket = rf(delta, 1.0, cosine) - upper * cosine / (3.0 * at_large) * rj(delta, 1.0, cosine, cosine * (at_edge / at_large));
    ldexp((upper / lower).sqrt() / large / at_large * bracket, -3 * e)
}
