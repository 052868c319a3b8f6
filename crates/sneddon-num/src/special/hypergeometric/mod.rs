//! Hypergeometric functions: every candidate form carries an error bound, the best one answers, or none.

pub mod confluent;
pub(crate) mod connection;
pub(crate) mod continuation;
pub(crate) mod series;

use super::ball::{Ball, ENOUGH};
use super::dilogarithm::{chi, tangent};
use super::gamma::is_pole;
use crate::special::hypergeometric::confluent::confluent;
use crate::special::hypergeometric::connection::Gauss;
use crate::special::hypergeometric::continuation::{asymptotic, continued, kummer_series};
use crate::special::hypergeometric::series::series;
use crate::{DoubleDouble, Precise};

/// Gauss's `2F1(a, b; c; z) = Σ (a)_k (b)_k / (c)_k z^k / k!`.
///
/// Domain: real parameters, `z <= 1` (at `z = 1` only for `c - a - b > 0` or a polynomial); NaN elsewhere, at poles
/// of `c`, and where the 30 digits of [`hyp2f1_precise`] are not enough for a double.
///
/// Accuracy: the value is within 2.5 ulp wherever it is not NaN, by its own bound; measured at most 0.51 ulp.
///
/// Source: as [`hyp2f1_precise`].
///
/// ```
/// use sneddon_num::special::hyp2f1;
/// assert!((hyp2f1(1.0, 1.0, 2.0, 0.5) - 2.0 * 2.0_f64.ln()).abs() < 1e-15);
/// assert_eq!(hyp2f1(-2.0, 1.0, 1.0, 0.25), 0.5625);
/// ```
pub fn hyp2f1(a: f64, b: f64, c: f64, z: f64) -> f64 {
    gauss([a, b, c, z].map(Ball::from)).rounded(ENOUGH)
}

/// [`hyp2f1`] with about 30 digits and a bound that has everything that cancels.
///
/// Method: the series at the argument itself, or Euler's, Pfaff's or the connection to `1 - z`, until one keeps 26
/// digits; a whole `c - a - b` by the form with a logarithm, one next to whole numbers by Taylor from there.
/// Accuracy: 27 to 31 digits where no form cancels.
///
/// Source: DLMF 15.2.1, 15.8.1 (Euler, Pfaff), 15.8.4, 15.8.10.
///
/// ```
/// use sneddon_num::special::hyp2f1_precise;
/// let log = hyp2f1_precise([1.0, 1.0, 2.0, 0.5].map(Into::into));
/// assert!(log.error < 1e-27);
/// ```
pub fn hyp2f1_precise(arguments: [DoubleDouble; 4]) -> Precise {
    gauss(arguments.map(Ball::exact)).precise()
}

/// Generalised `pFq(a; b; z) = Σ Π (a_i)_k / Π (b_j)_k z^k / k!`.
///
/// Domain: `p <= q + 1`; for `p = q + 1` also `z < 0.995` or a polynomial. Large negative `z` with `p < q` only
/// while the alternating series keeps a double. NaN elsewhere.
///
/// Accuracy: within 2.5 ulp wherever it is not NaN, by its own bound; measured at most 0.51 ulp.
///
/// Source: as [`hyper_precise`].
///
/// ```
/// use sneddon_num::special::hyper;
/// let catalan = hyper(&[0.5, 0.5, 1.0], &[1.5, 1.5], -1.0);
/// assert!((catalan - 0.915_965_594_177_219).abs() < 1e-15);
/// ```
pub fn hyper(a: &[f64], b: &[f64], z: f64) -> f64 {
    general(a.iter().map(|p| Ball::from(*p)).collect(), b.iter().map(|p| Ball::from(*p)).collect(), z.into()).rounded(ENOUGH)
}

/// [`hyper`] with about 30 digits and a bound that has everything that cancels.
///
/// Method: equal upper and lower parameters cancel; `2F1` and `1F1` by their own methods; else the series, and for
/// `p = q + 1` its continuation along the negative axis, for `p = q` the form
/// with `e^z` taken out and the asymptotic expansion.
///
/// Source: DLMF 16.2.1, 16.3.1, 16.8.8, 16.11.7.
///
/// ```
/// use sneddon_num::special::hyper_precise;
/// assert!(hyper_precise(&[1.0.into()], &[1.5.into(), 2.0.into()], (-2.0).into()).error < 1e-29);
/// ```
pub fn hyper_precise(a: &[DoubleDouble], b: &[DoubleDouble], z: DoubleDouble) -> Precise {
    general(a.iter().map(|p| Ball::exact(*p)).collect(), b.iter().map(|p| Ball::exact(*p)).collect(), Ball::exact(z)).precise()
}

fn gauss([a, b, c, z]: [Ball; 4]) -> Ball {
    if [a, b, c, z].iter().any(|p| !p.hi().is_finite()) || z.hi() > 1.0 || (z.hi() == 1.0 && z.value.lo > 0.0) {
        return Ball::NONE;
    }
    let degree = [a, b].iter().filter(|p| is_pole(**p)).map(|p| -p.hi()).fold(f64::INFINITY, f64::min);
    if z.hi() == 0.0 || a.hi() == 0.0 || b.hi() == 0.0 {
        return if is_pole(c) && z.hi() != 0.0 { Ball::NONE } else { Ball::ONE };
    }
    if is_pole(c) && degree > -c.hi() {
        return Ball::NONE;
    }
    if is_pole(c) {
        return series(&[a, b], &[c], z);
    }
    let form = Gauss::new(a, b, c);
    if (Ball::ONE - z).hi() == 0.0 { form.at_one() } else { form.value(z) }
}

fn general(mut upper: Vec<Ball>, mut lower: Vec<Ball>, z: Ball) -> Ball {
    if upper.iter().chain(&lower).chain([&z]).any(|p| !p.hi().is_finite()) {
        return Ball::NONE;
    }
    upper.retain(|p| match lower.iter().position(|q| q.value == p.value && !is_pole(*q)) {
        Some(place) => {
            lower.swap_remove(place);
            false
        }
        None => true,
    });
    if z.hi() == 0.0 || upper.iter().any(|p| p.hi() == 0.0) {
        return Ball::ONE;
    }
    let degree = upper.iter().filter(|p| is_pole(**p)).map(|p| -p.hi()).fold(f64::INFINITY, f64::min);
    if lower.iter().any(|q| is_pole(*q) && degree > -q.hi()) {
        return Ball::NONE;
    }
    match (upper.as_slice(), lower.as_slice()) {
        ([], []) => z.exp(),
        ([p], []) if z.hi() < 1.0 || is_pole(*p) => Gauss::new(*p, Ball::ONE, Ball::ONE).value(z),
        ([p, q], [c]) => gauss([*p, *q, *c, z]),
        ([p], [c]) => confluent(*p, *c, z),
        ([_, _, _], [c, d]) if c.is(1.5) && d.is(1.5) && is_dilogarithm(&upper) => dilogarithm(z),
        _ if upper.len() == lower.len() + 1 && degree.is_infinite() && z.hi() < -0.4 => continued(&upper, &lower, z),
        _ => {
            let value = series(&upper, &lower, z);
            if upper.len() != lower.len() || degree.is_finite() || z.hi() > -1.0 || value.relative() < 1e-24 {
                return value;
            }
            let value = if z.hi() > -200.0 { value.better(kummer_series(&upper, &lower, z)) } else { value };
            if value.relative() < 1e-20 { value } else { value.better(asymptotic(&upper, &lower, z)) }
        }
    }
}

/// `3F2(1/2, 1/2, 1; 3/2, 3/2; ·)`, which is `χ_2(y)/y` at `y^2` and `Ti_2(y)/y` at `-y^2`.
fn is_dilogarithm(upper: &[Ball]) -> bool {
    upper.iter().filter(|p| p.is(0.5)).count() == 2 && upper.iter().any(|p| p.is(1.0))
}

fn dilogarithm(z: Ball) -> Ball {
    let y = z.abs().sqrt();
    if z.hi() > 0.0 { chi(y) / y } else { tangent(y) / y }
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
        assert!(hyp2f1(1.0, 1.0, 1.0, 1.0).is_nan());
        assert!(hyp2f1(1.0, 1.0, 2.0, 1.5).is_nan() && hyp2f1(f64::NAN, 1.0, 2.0, 0.5).is_nan());
        assert!(hyp2f1(1e300, -1e300, 1e-300, 0.99).is_nan());
        assert!(hyper(&[1.0, 2.0, 3.0], &[1.5], 0.5).is_nan());
        assert_eq!(hyper(&[], &[], 0.0), 1.0);
        assert!((hyper(&[], &[], 1.0) - std::f64::consts::E).abs() < 1e-15);
        assert_eq!(hyper(&[2.0, 3.0], &[3.0, 2.0], 1.0), 1.0_f64.exp());
    }
}
