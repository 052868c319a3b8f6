//! The hypergeometric function near its singular point z = 1, through series in 1 - z.

use super::digamma::digamma_any;
use super::hypergeometric::{Value, not_positive_integer, series};

/// `2F1(a, b; c; 1) = Gamma(c) Gamma(c-a-b) / (Gamma(c-a) Gamma(c-b))`, `c - a - b > 0`; else NaN.
pub(super) fn at_one(a: f64, b: f64, c: f64) -> f64 {
    let excess = (c - a) - b;
    if excess > 0.0 { gamma_ratio([c, excess], [c - a, c - b]).checked() } else { f64::NAN }
}

/// `2F1(a, b; c; 1 - rest)` for small `rest`, with `excess = c - a - b`.
pub(super) fn near_one(a: f64, b: f64, c: f64, rest: f64, excess: f64) -> Value {
    let distance = (excess - excess.round()).abs();
    if distance == 0.0 {
        // Where a gamma function has a pole, psi has one too and the logarithmic form needs a limit; there Gauss's or
        // Euler's series is a polynomial anyway.
        let polynomial = [a, b, c - a, c - b].into_iter().any(not_positive_integer);
        let reached = (0.0..=100.0).contains(&excess) && !polynomial;
        return if reached { logarithmic(a, b, c, rest, excess as u32) } else { Value::NONE };
    }
    // DLMF 15.8.4; both terms have poles where the excess is an integer, and plus() sees what then cancels.
    let regular = gamma_ratio([c, excess], [c - a, c - b]).times(series(a, b, 1.0 - excess, rest));
    let singular = gamma_ratio([c, -excess], [a, b]).times(series(c - a, c - b, 1.0 + excess, rest)).times(Value::power(excess, rest.ln()));
    regular.plus(singular)
}

/// `Γ(p) Γ(q) / (Γ(r) Γ(s))`, zero at the poles of the denominator.
fn gamma_ratio(above: [f64; 2], below: [f64; 2]) -> Value {
    if below.into_iter().any(not_positive_integer) {
        return Value { value: 0.0, error: 0.0 };
    }
    let [p, q] = above.map(libm::tgamma);
    let [r, s] = below.map(libm::tgamma);
    // Each argument carries half an ulp, which its distance to a pole and the size of psi multiply.
    let condition: f64 = above.into_iter().chain(below).map(|x| (x * digamma_any(x)).abs()).sum();
    Value { value: (p / r) * (q / s), error: f64::EPSILON * (12.0 + condition) }
}

/// DLMF 15.8.10, `c = a + b + m`: a finite sum and a series with a logarithm.
fn logarithmic(a: f64, b: f64, c: f64, rest: f64, m: u32) -> Value {
    let order = f64::from(m);
    let logarithm = rest.ln();
    let unit = f64::EPSILON;
    let mut finite = Value { value: 0.0, error: 0.0 };
    if m > 0 {
        let (mut term, mut sum, mut size) = (libm::tgamma(order), 0.0_f64, 0.0_f64);
        for k in 0..m {
            sum += term;
            size += term.abs();
            let k = f64::from(k);
            if order - k - 1.0 > 0.0 {
                term *= (a + k) * (b + k) / ((k + 1.0) * (order - k - 1.0)) * -rest;
            }
        }
        let scale = gamma_ratio([c, 1.0], [a + order, b + order]);
        finite = scale.times(Value { value: sum, error: unit * (4.0 + 4.0 * order) * size / sum.abs() });
    }
    let (mut sum, mut size) = (0.0_f64, 0.0_f64);
    let mut factor = (0..m).fold(1.0, |product, k| product * -rest / f64::from(k + 1));
    for k in 0..400 {
        let k = f64::from(k);
        let parts =
            [logarithm, -digamma_any(k + 1.0), -digamma_any(k + order + 1.0), digamma_any(a + k + order), digamma_any(b + k + order)];
        let bracket: f64 = parts.iter().sum();
        sum += factor * bracket;
        size += factor.abs() * parts.iter().map(|part| part.abs()).sum::<f64>() * (1.0 + k);
        factor *= (a + order + k) * (b + order + k) / ((k + 1.0) * (k + order + 1.0)) * rest;
        if factor.abs() * 1e3 < unit * 0.01 * sum.abs() && k > a.abs() + b.abs() {
            break;
        }
        if k >= 399.0 || !factor.is_finite() {
            return Value::NONE;
        }
    }
    let series = Value { value: -sum, error: 4.0 * unit * size / sum.abs() };
    let infinite = gamma_ratio([c, 1.0], [a, b]).times(series);
    if m == 0 { infinite } else { finite.plus(infinite) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `2F1(1, 1; 2; z) = -ln(1-z)/z`: the logarithmic case with m = 0.
    #[test]
    fn logarithm_itself() {
        let rest = 1e-3_f64;
        let value = near_one(1.0, 1.0, 2.0, rest, 0.0).checked();
        assert!((value / (-rest.ln() / (1.0 - rest)) - 1.0).abs() < 1e-14);
        assert!((at_one(0.5, 0.5, 1.5) - std::f64::consts::FRAC_PI_2).abs() < 1e-14);
        assert!(at_one(1.0, 1.0, 2.0).is_nan());
    }
}
