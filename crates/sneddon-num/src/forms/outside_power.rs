//! The displacement outside a contact that a power term of g gives, without the cancellation of its closed form far away.

use crate::kappa::kappa;

/// `∫_0^a n x^(n-1) asin(x/r) dx = a^n asin(a/r) - ∫_0^a x^n/sqrt(r^2-x^2) dx`.
///
/// Domain: real `n >= 1/20`, `0 < a < r`. NaN elsewhere.
///
/// A series of positive terms in `(a/r)^2`; next to the edge, where it is slow unless `n` is large, the complement of the second integral by
/// `∫_z^1 t^n/sqrt(1-t^2) dt = w z^(n+1) 2F1(1, 1+n/2; 3/2; w^2)` with `w^2 = 1 - z^2`, whose terms are positive too.
///
/// Accuracy: measured at most 14 ulp for `n` from 0.05 to 40 and `a/r` from 1e-12 to `1 - 1e-12`.
///
/// Source: displacement by parts, `u = (2/pi) ∫_0^a g' asin(x/r) dx`.
///
/// ```
/// use sneddon_num::forms::outside_power;
/// // n = 1: a asin(a/r) - (r - sqrt(r^2-a^2))
/// assert!((outside_power(1.0, 3.0, 5.0) - (3.0 * 0.6_f64.asin() - 1.0)).abs() < 1e-15);
/// ```
pub fn outside_power(n: f64, a: f64, r: f64) -> f64 {
    if !(n >= LEAST && n.is_finite() && a > 0.0 && a < r && r.is_finite()) {
        return f64::NAN;
    }
    // Quotients first: squares of lengths may leave the range of doubles.
    let z = a / r;
    let w = ((r - a) / r * (1.0 + z)).sqrt();
    let square = z * z;
    if square < SLOW || n * w * w > 1.0 {
        let (mut term, mut sum, mut k) = (1.0, 1.0 / (n + 1.0), 0.0);
        // term = (1/2)_k/k! z^(2k)
        loop {
            k += 1.0;
            term *= (k - 0.5) / k * square;
            let own = term / ((2.0 * k + 1.0) * (n + 2.0 * k + 1.0));
            sum += own;
            if own <= 1e-18 * sum {
                return n * z * sum * a.powf(n);
            }
        }
    }
    let square = w * w;
    let (mut term, mut sum, mut k) = (1.0, 1.0, 0.0);
    while term > 1e-18 * sum {
        term *= (1.0 + 0.5 * n + k) / (1.5 + k) * square;
        sum += term;
        k += 1.0;
    }
    // ∫_0^a x^n/√(r²−x²) dx = r^n (π/(2 κ_n)) − a^n w z Σ, everything over a^n.
    let whole = std::f64::consts::FRAC_PI_2 / kappa(n) * z.powf(-n);
    a.powf(n) * (z.atan2(w) - whole + w * z * sum)
}

/// Below this exponent the two parts next to the edge cancel.
const LEAST: f64 = 0.05;
/// The series in (a/r)² is used below this.
const SLOW: f64 = 0.8;
