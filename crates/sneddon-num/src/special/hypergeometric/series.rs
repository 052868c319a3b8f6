//! The hypergeometric series in ball arithmetic, with bounds for cancellation and truncation.

use crate::special::ball::{Ball, UNIT};
use crate::special::gamma::{is_pole, is_whole};
use crate::work;

/// Direct summation of `Σ Π (upper)_k / Π (lower)_k z^k / k!`; the result is unknown if the series does not converge in time.
///
/// The bound includes the rounding of every term, the uncertainty of the parameters, and a geometric bound of the tail.
pub(crate) fn series(upper: &[Ball], lower: &[Ball], z: Ball) -> Ball {
    let polynomial = upper.iter().any(|p| is_pole(*p));
    if z.hi() == 0.0 && z.error == 0.0 {
        return Ball::ONE;
    }
    let growing = upper.len() > lower.len() + 1 || (upper.len() == lower.len() + 1 && z.hi().abs() > 0.995);
    if !polynomial && growing {
        return Ball::NONE;
    }
    // Treat a computed difference that is a whole number as exact.
    let doubt_of = |p: &Ball| if is_whole(*p) { 0.0 } else { p.error };
    let doubtful = upper.iter().chain(lower).any(|p| doubt_of(p) > 0.0);
    let operations = (2 * upper.len() + 2 * lower.len() + 4) as f64 * UNIT * 0.5 + z.error / z.hi().abs();
    let largest = upper.iter().chain(lower).fold(0.0_f64, |most, p| most.max(p.hi().abs()));
    let (mut sum, mut term) = (Ball::ONE.value, Ball::ONE.value);
    let (mut doubt, mut error) = (0.0_f64, 0.0_f64);
    let each = (upper.len() + lower.len()) as u64 / 2 + 3;
    for step in 0..MAX_TERMS {
        work::spend(each);
        if work::is_exhausted() {
            return Ball::NONE;
        }
        let k = f64::from(step);
        let mut below = Ball::from(k + 1.0).value;
        term = term.mul(z.value);
        for p in upper {
            let factor = p.value.add(k.into());
            term = term.mul(factor);
            if doubtful {
                doubt += doubt_of(p) / factor.hi.abs();
            }
        }
        for p in lower {
            let factor = p.value.add(k.into());
            below = below.mul(factor);
            if doubtful {
                doubt += doubt_of(p) / factor.hi.abs();
            }
        }
        if term.hi == 0.0 {
            if !doubt.is_finite() {
                return Ball::NONE;
            }
            break;
        }
        let before = term;
        term = term.div(below);
        doubt += operations;
        sum = sum.add(term);
        let size = term.hi.abs();
        error += size * doubt + sum.hi.abs() * UNIT * 0.5 + 1e-322;
        if !size.is_finite() || before.hi.is_nan() || doubt.is_nan() {
            return Ball::NONE;
        }
        // From here on the ratio of terms stays below (1 + ratio)/2, or below half of it where it tends to 0.
        if k > 2.0 * largest {
            let ratio = ratio(upper, lower, z.hi(), k + 1.0);
            let tail = if ratio < 0.9999 { 2.0 * size * ratio / (1.0 - ratio) } else { f64::INFINITY };
            if tail < sum.hi.abs() * UNIT * 0.01 || tail < 1e-3 * error {
                error += tail;
                break;
            }
        }
        if step + 1 == MAX_TERMS {
            return Ball::NONE;
        }
    }
    Ball { value: sum, error }
}

/// Size of the ratio of two neighbouring terms.
fn ratio(upper: &[Ball], lower: &[Ball], z: f64, k: f64) -> f64 {
    let above: f64 = upper.iter().map(|p| p.hi() + k).product();
    let below: f64 = lower.iter().map(|p| p.hi() + k).product();
    (above / below / (k + 1.0) * z).abs()
}

/// Work limit of one series: |z| = 0.99 needs 7200 terms.
const MAX_TERMS: u32 = 12_000;
