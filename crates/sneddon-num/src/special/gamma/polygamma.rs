//! The polygamma functions, the derivatives of digamma.

use crate::precise::ldexp;
use crate::special::ball::{Ball, UNIT};
use crate::special::gamma::BERNOULLI;
use crate::special::gamma::digamma::{digamma, digamma_ball};
use crate::{DoubleDouble, Precise, work};

/// `psi^(m)(x) = d^m psi / dx^m = (-1)^(m+1) m! Σ_k (x + k)^(-m-1)`, and `psi` itself for `m = 0`.
///
/// Domain: whole `m` from 0 to 170, `x > 0`; NaN elsewhere and if the value is outside the range of doubles.
/// Method: the sum up to 32 + 2m, then Euler and Maclaurin, in double-double; all terms have one sign.
/// Accuracy: measured at most 0.51 ulp for `m >= 1` and `x` from 1e-90 to 1e90, 3 ulp beyond; `m = 0` is [`digamma`].
///
/// Source: DLMF 5.15.1, 2.10.1.
///
/// ```
/// use sneddon_num::special::polygamma;
/// assert!((polygamma(1.0, 1.0) - std::f64::consts::PI.powi(2) / 6.0).abs() < 1e-15);
/// assert!((polygamma(2.0, 1.0) + 2.0 * 1.202_056_903_159_594_3).abs() < 1e-15);
/// ```
pub fn polygamma(m: f64, x: f64) -> f64 {
    let Some(order) = whole_order(m) else { return f64::NAN };
    if order == 0 {
        return digamma(x);
    }
    if !(x > 0.0 && x < f64::INFINITY) {
        return f64::NAN;
    }
    let precise = polygamma_ball(order, Ball::from(x)).rounded(1e-16);
    if precise.is_finite() {
        return precise;
    }
    // Near 0 and for very large x a single power is exact to working precision.
    let (from, power) = if x < 1.0 { (order, m + 1.0) } else { (order - 1, m) };
    let factorial: f64 = (1..=from).map(f64::from).product();
    let value = factorial * x.powf(-power);
    if (1e-60..=1e60).contains(&x) || !value.is_normal() {
        return f64::NAN;
    }
    if order % 2 == 0 { -value } else { value }
}

/// [`polygamma`] with about 30 digits, at an exact whole order.
///
/// Accuracy: measured at most 1e-30 relative; the bound is about twenty times wider.
///
/// ```
/// use sneddon_num::special::polygamma_precise;
/// assert!(polygamma_precise(1.0.into(), 1.0.into()).error < 1e-28);
/// ```
pub fn polygamma_precise(m: DoubleDouble, x: DoubleDouble) -> Precise {
    match whole_order(m.hi) {
        Some(0) if m.lo == 0.0 && x.hi > 0.0 => digamma_ball(Ball::exact(x)).precise(),
        Some(order) if m.lo == 0.0 && x.hi > 0.0 => polygamma_ball(order, Ball::exact(x)).precise(),
        _ => Precise::nan(),
    }
}

fn whole_order(m: f64) -> Option<u32> {
    (m.fract() == 0.0 && (0.0..=170.0).contains(&m)).then_some(m as u32)
}

/// ψ^(m)(x), m ≥ 1, x > 0.
fn polygamma_ball(m: u32, x: Ball) -> Ball {
    if !(1e-90..1e90).contains(&x.hi()) {
        return Ball::NONE;
    }
    let far = 32.0 + 2.0 * f64::from(m);
    let steps = if x.hi() < far { (far - x.hi()).ceil() as u32 } else { 0 };
    // A reciprocal with 30 digits and a power for each step.
    work::spend(100 + u64::from(steps) * (15 + u64::from(m.ilog2())));
    let y = x + f64::from(steps);
    let inverse = y.recip();
    let square = inverse.square();
    // Σ_(k≥0) (y+k)^(-m-1) = y^(-m) (1/m + 1/(2y) + Σ B_2k/(2k)! (m+1)…(m+2k-1) y^(-2k)).
    let mut tail = Ball::ONE / f64::from(m) + inverse.scale(0.5);
    let mut factor = square * f64::from(m + 1) * 0.5;
    let mut last = 0.0;
    for (k, (above, below)) in (1_u32..).zip(BERNOULLI) {
        let term = factor * above / below;
        tail = tail + term;
        last = term.hi().abs();
        if last < UNIT * 0.01 * tail.hi() {
            break;
        }
        factor = factor * square * (f64::from(m + 2 * k) * f64::from(m + 2 * k + 1)) / (f64::from(2 * k + 1) * f64::from(2 * k + 2));
    }
    // Powers of (x + k)/2^e, so that none leaves the range of doubles before the factorial meets it.
    let exponent = x.hi().log2().floor() as i32;
    let unit = 2.0_f64.powi(exponent);
    let mut sum = inverse.scale(unit).powi(m) * tail.widened(last).scale(unit);
    for step in (0..steps).rev() {
        sum = sum + (x + f64::from(step)).recip().scale(unit).powi(m + 1);
    }
    let factorial = (2..=m).fold(Ball::from(2.0_f64.powi(-500)), |product, k| product * f64::from(k));
    let (value, back) = (sum * factorial, 500 - exponent * (m as i32 + 1));
    if !(-950..=950).contains(&(value.hi().abs().log2() as i32 + back)) {
        return Ball::NONE;
    }
    let value = Ball { value: ldexp(value.value, back), error: ldexp(value.error.into(), back).hi };
    if m.is_multiple_of(2) { -value } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        for value in [polygamma(1.0, 0.0), polygamma(-1.0, 1.0), polygamma(0.5, 1.0), polygamma(1.0, f64::NAN), polygamma(200.0, 1.0)] {
            assert!(value.is_nan());
        }
        assert_eq!(polygamma(1.0, 1e-150), 1e300);
        assert!((polygamma(1.0, 1e200) * 1e200 - 1.0).abs() < 1e-15);
    }
}
