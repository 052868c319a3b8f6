//! The pressure integral of a power: what a term of g contributes at the radius s inside the contact.

use crate::legendre;
use crate::stable::{asinh, leg};

/// `S_n(s, a) = ∫_s^a x^n / sqrt(x^2 - s^2) dx`, the pressure integral of `g'(x) = x^n`.
///
/// Domain: real `n > -1`, `0 <= s <= a` finite. Zero for `s >= a`. At `s = 0`: `a^n / n` for `n > 0`, infinite for
/// `n <= 0`. NaN elsewhere.
///
/// Special cases: `S_0 = asinh(w/s)`, `S_1 = w`, with `w = sqrt((a-s)(a+s))`.
///
/// Accuracy: measured at most 3.3 ulp for `n` in `(-1, 1e4]` and `s/a` from 1e-300 to `1 - 1e-16`,
/// wherever `a^n` is a normal number.
///
/// Source: MDR chapter, pressure of a power profile `p = (E/pi) C n kappa(n) S_(n-1)(s, a)`.
///
/// ```
/// use sneddon_num::forms::pressure_power;
/// assert_eq!(pressure_power(1.0, 3.0, 5.0), 4.0);
/// assert!((pressure_power(3.0, 3.0, 5.0) - 4.0 * (25.0 + 18.0) / 3.0).abs() < 1e-13);
/// ```
pub fn pressure_power(n: f64, s: f64, a: f64) -> f64 {
    if !(n > -1.0 && n.is_finite() && s >= 0.0 && a >= 0.0 && a.is_finite()) {
        return f64::NAN;
    }
    if s >= a {
        return 0.0;
    }
    if s == 0.0 {
        return if n > 0.0 { times_power(1.0 / n, a, n) } else { f64::INFINITY };
    }
    if n == 0.0 {
        let quotient = leg(a, s) / s;
        return if quotient < 1e100 { asinh(quotient) } else { a.ln() - s.ln() + std::f64::consts::LN_2 };
    }
    if n == 1.0 {
        return leg(a, s);
    }
    if n >= STEEP || s * FAR >= a {
        return times_power(unit(n, s / a, (a - s) / a), a, n);
    }
    let near = s * EDGE;
    times_power(head(n), near, n) + tail(n, s, near, a)
}

/// `S_n(s, 1)` from `s` and `gap = 1 - s`, for `n >= 60` or `s >= 1/64`: there one Gauss–Legendre rule reaches
/// 1e-18. In `y = sqrt((x - s)/(1 - s))` the root disappears; `d = 1 - y` keeps `1 - x` a product. For large `n` the
/// range is cut where `x^n` falls below `e^-44`.
pub(crate) fn unit(n: f64, s: f64, gap: f64) -> f64 {
    let depth = if n > 0.0 { (-(-44.0 / n).exp_m1() / gap).min(1.0) } else { 1.0 };
    let range = depth / (1.0 + (1.0 - depth).sqrt());
    let integral = legendre::integrate(|t, rest| {
        let d = range * t;
        let defect = gap * (d * (2.0 - d));
        // At full range y = 1 - t is known better than 1 - d.
        let y = if range == 1.0 { rest } else { 1.0 - d };
        let x = s + gap * (y * y);
        let logarithm = if defect < 0.5 { (-defect).ln_1p() } else { x.ln() };
        (n * logarithm).exp() / (x + s).sqrt()
    });
    2.0 * range * gap.sqrt() * integral
}

/// From this `n` on, what lies below `x = a e^(-44/n) > 0.47 a` does not count.
pub(crate) const STEEP: f64 = 60.0;
/// Up to this `a/s` one rule covers all of `[s, a]`.
pub(crate) const FAR: f64 = 64.0;
/// Beyond, `[s, 32 s]` is integrated by the rule and `[32 s, a]` by a series in `(s/x)^2`.
const EDGE: f64 = 32.0;

/// `∫_s^X x^n / sqrt(x^2 - s^2) dx / X^n` with `X = 32 s`.
fn head(n: f64) -> f64 {
    let integral = legendre::integrate(|y, _| {
        let x = 1.0 + (EDGE - 1.0) * (y * y);
        (x / EDGE).powf(n) / (x + 1.0).sqrt()
    });
    2.0 * (EDGE - 1.0).sqrt() * integral
}

/// `∫_X^a x^n / sqrt(x^2 - s^2) dx` with `X = 32 s`, from the binomial series of `(1 - s^2/x^2)^(-1/2)`: all terms
/// positive, each an elementary integral of `x^(n-1-2j)` written from the end where it is large.
fn tail(n: f64, s: f64, near: f64, a: f64) -> f64 {
    let quotient = a / near;
    let span = if quotient.is_finite() { quotient.ln() } else { a.ln() - near.ln() };
    let (far_ratio, near_ratio) = ((s / a) * (s / a), 1.0 / (EDGE * EDGE));
    let (mut from_far, mut from_near) = (0.0, 0.0);
    let (mut far_factor, mut near_factor) = (1.0, 1.0);
    for j in 0..12 {
        let j = f64::from(j);
        let e = n - 2.0 * j;
        if e > 0.0 {
            from_far += far_factor * (-(-e * span).exp_m1() / e);
        } else if e < 0.0 {
            from_near += near_factor * ((e * span).exp_m1() / e);
        } else {
            from_near += near_factor * span;
        }
        let binomial = (2.0 * j + 1.0) / (2.0 * j + 2.0);
        far_factor *= binomial * far_ratio;
        near_factor *= binomial * near_ratio;
    }
    times_power(from_far, a, n) + times_power(from_near, near, n)
}

/// `factor base^n`, also when `base^n` alone leaves the range.
fn times_power(factor: f64, base: f64, n: f64) -> f64 {
    if factor == 0.0 {
        return 0.0;
    }
    let power = base.powf(n);
    if power.is_normal() {
        return factor * power;
    }
    let half = base.powf(0.5 * n);
    factor * half * half
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(pressure_power(2.0, 0.0, 3.0), 4.5);
        assert_eq!(pressure_power(0.0, 0.0, 3.0), f64::INFINITY);
        assert_eq!(pressure_power(2.5, 3.0, 3.0), 0.0);
        assert!(pressure_power(-1.0, 1.0, 2.0).is_nan());
        assert!(pressure_power(2.0, -1.0, 2.0).is_nan());
        assert!(pressure_power(f64::NAN, 1.0, 2.0).is_nan());
        assert!(pressure_power(1e300, 1.0, 2.0).is_infinite());
    }

    /// `n S_n = a^(n-1) w + (n-1) s^2 S_(n-2)` joins the branches.
    #[test]
    fn recurrence_holds_across_the_branches() {
        for (s, a) in [(0.5, 1.0_f64), (0.01, 1.0), (1.0 / 64.0, 1.0), (1e-5, 2.0)] {
            for n in [1.5_f64, 2.0, 3.7, 4.0, 59.9, 61.0, 61.9] {
                let right = a.powf(n - 1.0) * leg(a, s) + (n - 1.0) * s * s * pressure_power(n - 2.0, s, a);
                let left = n * pressure_power(n, s, a);
                assert!((left / right - 1.0).abs() < 4e-15, "n={n} s={s} a={a}");
            }
        }
    }
}
