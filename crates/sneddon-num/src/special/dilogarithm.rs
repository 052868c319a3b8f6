//! The dilogarithm and its odd relatives, Legendre's chi function and the inverse tangent integral.

use super::ball::Ball;
use super::clausen::even_series;
use crate::special::ball::elementary::PI;
use crate::special::hypergeometric::continuation::pfaff_series;
use crate::special::hypergeometric::series::series;
use crate::{DoubleDouble, Precise, legendre};

/// Legendre's `chi_2(z) = Σ z^(2k+1)/(2k+1)^2 = ∫_0^z artanh(t)/t dt`.
///
/// Domain: `|z| <= 1`, odd; `chi_2(1) = pi^2/8`; NaN beyond. Accuracy: measured at most 1.2 ulp.
///
/// Source: Lewin 1981, (1.66)–(1.67).
///
/// ```
/// use sneddon_num::special::legendre_chi2;
/// assert_eq!(legendre_chi2(1.0), std::f64::consts::PI.powi(2) / 8.0);
/// ```
pub fn legendre_chi2(z: f64) -> f64 {
    let x = z.abs();
    if x.is_nan() || x > 1.0 {
        return f64::NAN;
    }
    let value = if x <= 0.7 {
        odd_series(x, x * x)
    } else if x == 1.0 {
        PI2_8
    } else {
        // Both subtracted terms are at most 0.4 of the result.
        let mirror = (1.0 - x) / (1.0 + x);
        PI2_8 - (0.5 * (x.ln() * mirror.ln()) + (odd_series(mirror, mirror * mirror) - PI2_8_REST))
    };
    value.copysign(z)
}

/// Inverse tangent integral `Ti_2(z) = ∫_0^z atan(t)/t dt = Σ (-1)^k z^(2k+1)/(2k+1)^2`, the imaginary part of
/// `Li_2(i z)`.
///
/// Domain: every real `z`, odd; `Ti_2(1)` is Catalan's constant; infinite at infinity.
/// Accuracy: measured at most 1.4 ulp.
///
/// Source: Lewin 1981, (2.1), (2.6): `Ti_2(z) = Ti_2(1/z) + (pi/2) ln z`, `z > 0`.
///
/// ```
/// use sneddon_num::special::inverse_tangent_integral;
/// assert!((inverse_tangent_integral(1.0) - 0.915_965_594_177_219).abs() < 1e-15);
/// ```
pub fn inverse_tangent_integral(z: f64) -> f64 {
    let x = z.abs();
    let value = if x.is_nan() || x == f64::INFINITY {
        x
    } else if x <= 1.0 {
        tangent_integral_below_one(x)
    } else {
        tangent_integral_below_one(1.0 / x) + std::f64::consts::FRAC_PI_2 * x.ln()
    };
    value.copysign(z)
}

/// Dilogarithm `Li_2(z) = Σ z^k/k^2 = -∫_0^z ln(1-t)/t dt`.
///
/// Domain: `z <= 1`, `Li_2(1) = pi^2/6`; NaN beyond, where it is complex. Accuracy: measured at most 1.7 ulp for
/// `z` from -1e300 to 1.
///
/// Source: Lewin 1981; Debye's series in `u = -ln(1-z)`.
///
/// ```
/// use sneddon_num::special::polylog2;
/// assert_eq!(polylog2(1.0), std::f64::consts::PI.powi(2) / 6.0);
/// assert!((polylog2(-1.0) + std::f64::consts::PI.powi(2) / 12.0).abs() < 1e-15);
/// ```
pub fn polylog2(z: f64) -> f64 {
    if z.is_nan() || z > 1.0 {
        return f64::NAN;
    }
    if z == 1.0 {
        return PI2_6;
    }
    if z < -4.0 {
        let logarithm = (-z).ln();
        return -(PI2_6 + (0.5 * (logarithm * logarithm) + debye(1.0 / z)));
    }
    if z > 0.8 {
        let rest = 1.0 - z;
        return PI2_6 - (z.ln() * rest.ln() + debye(rest));
    }
    debye(z)
}

/// [`polylog2`] with about 30 digits.
///
/// Method: Debye's series, with the reflection above 0.8 and the inversion below -4.
///
/// ```
/// use sneddon_num::special::polylog2_precise;
/// assert!(polylog2_precise((-1.0).into()).error < 1e-29);
/// ```
pub fn polylog2_precise(z: DoubleDouble) -> Precise {
    dilogarithm(Ball::exact(z)).precise()
}

/// [`legendre_chi2`] with about 30 digits: half the difference of two dilogarithms.
///
/// ```
/// use sneddon_num::special::legendre_chi2_precise;
/// assert!(legendre_chi2_precise(1.0.into()).error < 1e-28);
/// ```
pub fn legendre_chi2_precise(z: DoubleDouble) -> Precise {
    chi(Ball::exact(z)).precise()
}

/// [`inverse_tangent_integral`] with about 30 digits: `z 3F2(1/2, 1/2, 1; 3/2, 3/2; -z^2)` and the inversion.
///
/// ```
/// use sneddon_num::special::inverse_tangent_integral_precise;
/// assert!(inverse_tangent_integral_precise(2.0.into()).error < 1e-28);
/// ```
pub fn inverse_tangent_integral_precise(z: DoubleDouble) -> Precise {
    tangent(Ball::exact(z)).precise()
}

/// `Li_2` of a ball, `z <= 1`.
fn dilogarithm(z: Ball) -> Ball {
    let rest = Ball::ONE - z;
    if z.hi().is_nan() || rest.hi() < 0.0 {
        return Ball::NONE;
    }
    if rest.hi() == 0.0 {
        return ZETA_2;
    }
    if z.hi() < -4.0 {
        let logarithm = (-z).ln();
        return -(ZETA_2 + logarithm.square().scale(0.5) + debye_ball(z.recip()));
    }
    if z.hi() > 0.8 { ZETA_2 - (z.ln() * rest.ln() + debye_ball(rest)) } else { debye_ball(z) }
}

/// [`debye`] with `B_2k/(2k+1)! = (-1)^(k+1) 2 ζ(2k)/((2k+1) (2π)^(2k))`.
fn debye_ball(z: Ball) -> Ball {
    let u = -(-z).ln_1p();
    let square = -(u / PI.scale(2.0)).square();
    let sum = even_series(square, |k| f64::from(2 * k + 1));
    u - u.square().scale(0.25) - u * sum.scale(2.0)
}

/// `χ_2` of a ball, `|z| <= 1`.
pub(super) fn chi(z: Ball) -> Ball {
    (dilogarithm(z) - dilogarithm(-z)).scale(0.5)
}

/// `Ti_2` of a ball.
pub(super) fn tangent(z: Ball) -> Ball {
    if z.hi() < 0.0 {
        return -tangent(-z);
    }
    if z.hi() > 1.0 {
        return tangent(z.recip()) + PI.scale(0.5) * z.ln();
    }
    let [half, more] = [0.5, 1.5].map(Ball::from);
    let argument = -z.square();
    let (upper, lower) = ([half, half, Ball::ONE], [more, more]);
    z * if z.hi() < 0.6 { series(&upper, &lower, argument) } else { pfaff_series(&upper, &lower, argument) }
}

const ZETA_2: Ball = Ball { value: DoubleDouble { hi: PI2_6, lo: 3.040_672_350_398_476e-17 }, error: 2e-32 };
const PI2_6: f64 = 1.644_934_066_848_226_4;
const PI2_8: f64 = 1.233_700_550_136_169_7;
/// pi^2/8 minus its nearest double.
const PI2_8_REST: f64 = 7.831_619_385_924_639e-17;

/// `Σ square^k x/(2k+1)^2`, `|square| <= 1/2`, from the smallest term up.
fn odd_series(x: f64, square: f64) -> f64 {
    let terms = if square.abs() < 1e-3 {
        6
    } else if square.abs() < 0.05 {
        14
    } else {
        54
    };
    let mut sum = 0.0;
    for k in (1..terms).rev() {
        let odd = f64::from(2 * k + 1);
        sum = square * (1.0 / (odd * odd) + sum);
    }
    x + x * sum
}

/// `Ti_2` on [0, 1]: the series while it is fast, then `∫_0^1 atan(z t)/t dt`, whose integrand is positive.
fn tangent_integral_below_one(z: f64) -> f64 {
    if z <= 0.5 {
        return odd_series(z, -z * z);
    }
    legendre::integrate(|t, _| (z * t).atan() / t)
}

/// `Li_2(z) = u - u^2/4 + Σ B_2k u^(2k+1)/(2k+1)!`, `u = -ln(1-z)`, `-4 <= z <= 0.8`, so `|u| < 1.61`.
fn debye(z: f64) -> f64 {
    if z.abs() < 1e-17 {
        return z;
    }
    let u = -(-z).ln_1p();
    let square = u * u;
    let tail = DEBYE.iter().rev().fold(0.0, |sum, c| sum * square + c);
    u + (u * square * tail - 0.25 * square)
}

/// `B_2k / (2k+1)!`, k = 1, 2, …
const DEBYE: [f64; 14] = [
    0.027_777_777_777_777_776,
    -0.000_277_777_777_777_777_8,
    4.724_111_866_969_01e-6,
    -9.185_773_074_661_964e-8,
    1.897_886_998_897_1e-9,
    -4.064_761_645_144_225_6e-11,
    8.921_691_020_456_452e-13,
    -1.993_929_586_072_107_4e-14,
    4.518_980_029_619_918e-16,
    -1.035_651_761_218_124_7e-17,
    2.395_218_621_026_187e-19,
    -5.581_785_874_325_009e-21,
    1.309_150_755_418_321_3e-22,
    -3.087_419_802_426_740_3e-24,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(legendre_chi2(0.0), 0.0);
        assert_eq!(legendre_chi2(-0.3), -legendre_chi2(0.3));
        assert_eq!(inverse_tangent_integral(f64::INFINITY), f64::INFINITY);
        assert!(inverse_tangent_integral(1e300).is_finite());
        assert!(polylog2(-1e300).is_finite());
        assert!(legendre_chi2(1.1).is_nan() && polylog2(1.1).is_nan() && inverse_tangent_integral(f64::NAN).is_nan());
    }
}
