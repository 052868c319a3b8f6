//! Hypergeometric series: every candidate form carries an error bound, the best one answers, or none.

use super::connection::{at_one, near_one};
use super::dilogarithm::{inverse_tangent_integral, legendre_chi2};
use crate::num::double_double::two_sum;
use crate::num::forms::pressure_power;

/// Gauss's `2F1(a, b; c; z) = Σ (a)_k (b)_k / (c)_k z^k / k!`.
///
/// Domain: real parameters, `z <= 1` (at `z = 1` only for `c - a - b > 0` or a polynomial). NaN where no method here
/// promises a relative error of about 1e-12: poles of `c`, strong cancellation, `c - a - b` close to an integer
/// without being one while `z` is close to 1, gamma functions beyond the range of doubles.
///
/// Special case: `(1, b; 3/2; z)` with `b < 1`, `0 <= z <= 1`, the slope of a worn power, by a positive integral.
///
/// Accuracy: measured at most 3.1 ulp for `(1, 1 - n/2; 3/2; z)`, `0 < n <= 200`; measured relative error at
/// most 1e-12 elsewhere whenever it is not NaN.
///
/// Source: DLMF 15.2.1, 15.8.1 (Euler, Pfaff), 15.8.4, 15.8.10.
///
/// ```
/// use sneddon::num::special::hyp2f1;
/// assert!((hyp2f1(1.0, 1.0, 2.0, 0.5) - 2.0 * 2.0_f64.ln()).abs() < 1e-14);
/// assert_eq!(hyp2f1(-2.0, 1.0, 1.0, 0.25), 0.5625);
/// ```
pub fn hyp2f1(a: f64, b: f64, c: f64, z: f64) -> f64 {
    if !(a.is_finite() && b.is_finite() && c.is_finite() && z.is_finite() && z <= 1.0) {
        return f64::NAN;
    }
    if z == 0.0 || a == 0.0 || b == 0.0 {
        return if not_positive_integer(c) && z != 0.0 { f64::NAN } else { 1.0 };
    }
    let degree = [a, b].into_iter().filter(|p| not_positive_integer(*p)).map(|p| -p).fold(f64::INFINITY, f64::min);
    if not_positive_integer(c) && degree > -c {
        return f64::NAN;
    }
    if c == 1.5 && (a == 1.0 || b == 1.0) && z > 0.0 && a.min(b) < 1.0 {
        return worn_slope(a.min(b), z);
    }
    if c == b {
        return (-a * (-z).ln_1p()).exp();
    }
    if c == a {
        return (-b * (-z).ln_1p()).exp();
    }
    if z == 1.0 {
        return if degree.is_finite() { series(a, b, c, z).checked() } else { at_one(a, b, c) };
    }
    let mut best = series(a, b, c, z);
    if z < 0.0 {
        // Pfaff: the argument moves into (0, 1), and 1 - w = 1/(1-z) is known exactly enough.
        let (w, rest, logarithm) = (z / (z - 1.0), 1.0 / (1.0 - z), (-z).ln_1p());
        for (kept, moved, excess) in [(a, c - b, b - a), (b, c - a, a - b)] {
            let factor = Value::power(-kept, logarithm);
            best = best.better(inside(kept, moved, c, w, rest, excess).times(factor));
        }
    } else {
        best = best.better(inside(a, b, c, z, 1.0 - z, two_sum(c, -a).add((-b).into()).value()));
    }
    best.checked()
}

/// Generalised `pFq(a; b; z) = Σ Π (a_i)_k / Π (b_j)_k z^k / k!`.
///
/// Domain: `p <= q + 1` and `|z| < 1` for `p = q + 1`, by the direct series; `2F1` goes to [`hyp2f1`], and
/// `([1/2, 1/2, 1], [3/2, 3/2])`, `|z| <= 1`, to the dilogarithm: `chi_2(y)/y` at `z = y^2`, `Ti_2(y)/y` at `-y^2`
/// (there every `z <= 1` is allowed). NaN elsewhere and where the series cannot promise about 1e-12 in 5000 terms.
///
/// Accuracy: measured at most 1.2 ulp for the dilogarithm case; relative error at most 1e-12 elsewhere.
///
/// Source: DLMF 16.2.1.
///
/// ```
/// use sneddon::num::special::hyper;
/// let catalan = hyper(&[0.5, 0.5, 1.0], &[1.5, 1.5], -1.0);
/// assert!((catalan - 0.915_965_594_177_219).abs() < 1e-15);
/// ```
pub fn hyper(a: &[f64], b: &[f64], z: f64) -> f64 {
    if z.is_nan() || a.iter().chain(b).any(|p| !p.is_finite()) || a.len() > b.len() + 1 {
        return f64::NAN;
    }
    if z == 0.0 {
        return 1.0;
    }
    match (a, b) {
        ([p, q], [c]) => return hyp2f1(*p, *q, *c, z),
        ([_, _, _], [c, d]) if *c == 1.5 && *d == 1.5 && is_dilogarithm(a) => {
            let y = z.abs().sqrt();
            return if z > 0.0 { legendre_chi2(y) / y } else { inverse_tangent_integral(y) / y };
        }
        _ => {}
    }
    general_series(a, b, z).checked()
}

fn is_dilogarithm(a: &[f64]) -> bool {
    a.iter().filter(|p| **p == 0.5).count() == 2 && a.contains(&1.0)
}

/// `2F1(1, b; 3/2; z) = ∫_0^1 (1 - z (1 - t^2))^(-b) dt = S_n(s, 1)/sqrt(z)`, `n = 1 - 2b`, `s = sqrt(1-z)`.
fn worn_slope(b: f64, z: f64) -> f64 {
    let n = 1.0 - 2.0 * b;
    if z < 1e-300 {
        return 1.0;
    }
    let s = (1.0 - z).sqrt();
    let sum = if n >= pressure_power::STEEP || s * pressure_power::FAR >= 1.0 {
        pressure_power::unit(n, s, z / (1.0 + s))
    } else {
        pressure_power::pressure_power(n, s, 1.0)
    };
    sum / z.sqrt()
}

/// A number with a bound of its relative error.
#[derive(Clone, Copy)]
pub(super) struct Value {
    pub(super) value: f64,
    pub(super) error: f64,
}

impl Value {
    /// No answer.
    pub(super) const NONE: Self = Self { value: f64::NAN, error: f64::INFINITY };

    /// `exp(n logarithm)`, the logarithm known to an ulp.
    pub(super) fn power(n: f64, logarithm: f64) -> Self {
        let exponent = n * logarithm;
        Self { value: exponent.exp(), error: f64::EPSILON * (1.0 + 2.0 * exponent.abs()) }
    }

    pub(super) fn times(self, other: Self) -> Self {
        Self { value: self.value * other.value, error: self.error + other.error + f64::EPSILON }
    }

    /// Sum; the bound grows by what cancels.
    pub(super) fn plus(self, other: Self) -> Self {
        let value = self.value + other.value;
        let error = (self.value * self.error).abs() + (other.value * other.error).abs();
        Self { value, error: error / value.abs() + f64::EPSILON }
    }

    /// The one with the smaller bound.
    pub(super) fn better(self, other: Self) -> Self {
        if other.value.is_finite() && other.error < self.error { other } else { self }
    }

    /// The value, or NaN where the bound is too wide.
    pub(super) fn checked(self) -> f64 {
        if self.error < 2e-12 { self.value } else { f64::NAN }
    }
}

/// Candidates for `0 < z < 1`, `rest = 1 - z`; `excess = c - a - b` comes from the caller, who may know it exactly.
fn inside(a: f64, b: f64, c: f64, z: f64, rest: f64, excess: f64) -> Value {
    let mut best = series(a, b, c, z);
    let logarithm = if z < 0.5 { (-z).ln_1p() } else { rest.ln() };
    let euler = Value::power(excess, logarithm);
    best = best.better(series(c - a, c - b, c, z).times(euler));
    if z > 0.5 {
        best = best.better(near_one(a, b, c, rest, excess));
        if excess < 0.0 {
            best = best.better(near_one(c - a, c - b, c, rest, -excess).times(euler));
        }
    } else {
        // z/(z-1) lies in (-1, 0): Pfaff's polynomials may be free of cancellation where Gauss's is not.
        let w = -z / rest;
        best = best.better(series(a, c - b, c, w).times(Value::power(-a, logarithm)));
        best = best.better(series(b, c - a, c, w).times(Value::power(-b, logarithm)));
    }
    best
}

/// Gauss's series as it stands.
pub(super) fn series(a: f64, b: f64, c: f64, z: f64) -> Value {
    general_series(&[a, b], &[c], z)
}

/// The direct series with its running error bound: rounding of the terms times their size, plus the neglected tail.
fn general_series(a: &[f64], b: &[f64], z: f64) -> Value {
    let polynomial = a.iter().any(|p| not_positive_integer(*p));
    if a.len() == b.len() + 1 && z.abs() >= 0.995 && !polynomial {
        return Value::NONE;
    }
    let unit = 0.5 * f64::EPSILON;
    let operations = (a.len() + b.len() + 2) as f64;
    let (mut sum, mut rest, mut term, mut error) = (1.0_f64, 0.0, 1.0_f64, unit);
    for k in 0..MAX_TERMS {
        let k = f64::from(k);
        let above: f64 = a.iter().map(|p| p + k).product();
        let below: f64 = b.iter().map(|p| p + k).product::<f64>() * (k + 1.0);
        let ratio = above / below * z;
        term *= ratio;
        let next = two_sum(sum, term);
        sum = next.hi;
        rest += next.lo;
        // Rounding walks at random along the recurrence, about 0.6 units an operation: three deviations and a half.
        error += term.abs() * unit * (2.0 * (operations * (k + 1.0)).sqrt());
        if term == 0.0 || !term.is_finite() {
            break;
        }
        // Beyond this index the ratio stays below (1 + |ratio|)/2, so the tail is bounded by a geometric series.
        let settled = ratio.abs() < 0.999 && a.iter().chain(b).all(|p| k > 2.0 * p.abs());
        if settled && term.abs() / (1.0 - ratio.abs()) < 0.1 * unit * sum.abs() {
            break;
        }
        if k + 1.0 == f64::from(MAX_TERMS) {
            return Value::NONE;
        }
    }
    let value = sum + rest;
    Value { value, error: error / value.abs() }
}

/// Work limit of one series.
const MAX_TERMS: u32 = 5000;

pub(super) fn not_positive_integer(x: f64) -> bool {
    x <= 0.0 && x == x.trunc()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(hyp2f1(1.3, 0.2, 0.7, 0.0), 1.0);
        assert_eq!(hyp2f1(0.0, 0.2, 0.7, 0.9), 1.0);
        assert!(hyp2f1(1.0, 1.0, -2.0, 0.5).is_nan());
        assert_eq!(hyp2f1(-1.0, 1.0, -2.0, 0.5), 1.25);
        assert!(hyp2f1(1.0, 1.0, 1.0, 1.0).is_nan() || hyp2f1(1.0, 1.0, 1.0, 1.0).is_infinite());
        assert!(hyp2f1(1.0, 1.0, 2.0, 1.5).is_nan() && hyp2f1(f64::NAN, 1.0, 2.0, 0.5).is_nan());
        assert!(hyp2f1(1e300, -1e300, 1e-300, 0.99).is_nan());
        assert!(hyper(&[1.0, 2.0, 3.0], &[1.0], 0.5).is_nan());
        assert_eq!(hyper(&[], &[], 0.0), 1.0);
        assert!((hyper(&[], &[], 1.0) - std::f64::consts::E).abs() < 1e-15);
    }
}
