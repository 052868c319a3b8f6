//! The factor kappa(n) by which the transform multiplies a power profile, as a number and exactly.

use num_bigint::BigInt;
use num_rational::BigRational;

use super::double_double::{DoubleDouble, Precise, two_sum};

/// The multiplier of a power profile: `f = r^n` has `g = kappa(n) x^n`.
///
/// `kappa(n) = sqrt(pi) Gamma(n/2 + 1) / Gamma(n/2 + 1/2)`, real `n > -1`.
///
/// Special cases: `kappa(0) = 1`, `kappa(1) = pi/2`, `kappa(2) = 2`, `kappa(inf) = inf`; NaN for `n <= -1` and NaN.
///
/// Accuracy: measured at most 0.51 ulp for `n` in `(-1, 1e300]`.
///
/// Source: MDR chapter (3.16); even asymptotic series of a gamma ratio, Tricomi and Erdélyi 1951.
///
/// ```
/// use sneddon_num::kappa::kappa;
/// assert_eq!(kappa(2.0), 2.0);
/// assert_eq!(kappa(1.0), std::f64::consts::FRAC_PI_2);
/// assert!(kappa(-1.0).is_nan());
/// ```
pub fn kappa(n: f64) -> f64 {
    if n.is_nan() || n <= -1.0 {
        return f64::NAN;
    }
    if n == f64::INFINITY {
        return n;
    }
    let x = 0.5 * n;
    if n > 1e9 {
        // The first correction, 1/(64 z^2), is below 2^-64.
        let scale = if n > 1e100 { 2.0_f64.powi(-600) } else { 1.0 };
        let root = two_sum(x * scale, 0.25 * scale).sqrt();
        return root.mul(ROOT_PI).value() / scale.sqrt();
    }
    // Γ(x+1)/Γ(x+1/2) is even in z = x + 1/4, so half as many terms reach as far; shift x up to z >= 12 first.
    // The offsets 1/2 and 1 stay exact: a rounded n/2 + 1/2 costs hundreds of ulp at large n.
    let shift = if x >= 12.0 { 0 } else { (12.0 - x).ceil() as u32 };
    let (mut above, mut below) = (DoubleDouble::ONE, DoubleDouble::ONE);
    for step in 0..shift {
        let step = f64::from(step);
        above = above.mul(two_sum(step + 0.5, x));
        below = below.mul(two_sum(step + 1.0, x));
    }
    let z = two_sum(f64::from(shift) + 0.25, x);
    let w = 1.0 / (z.hi * z.hi);
    let correction = RATIO_SERIES.iter().rev().fold(0.0, |sum, c| sum * w + c) * w;
    let series = two_sum(1.0, correction);
    z.sqrt().mul(series).mul(ROOT_PI).mul(above).div(below).value()
}

/// [`kappa`] with about 30 digits, `-1 < n < 1e100`.
///
/// Method: the recurrence `kappa(n) = kappa(n+2) (n+1)/(n+2)` up to 40, then
/// `kappa = sqrt(pi s/4) exp(Σ (-1)^(k+1) |E_2k| / (4k s^(2k)))`, `s = 2n + 1`, with Euler's numbers.
/// Accuracy: measured at most 1e-31 relative.
///
/// Source: Tricomi and Erdélyi 1951; the series envelops, so the first omitted term bounds the tail.
///
/// ```
/// use sneddon_num::kappa::kappa_precise;
/// assert!((kappa_precise(2.0.into()).value.value() - 2.0).abs() < 1e-15);
/// ```
pub fn kappa_precise(n: DoubleDouble) -> Precise {
    super::special::kappa_series(n)
}

/// `kappa(n)` for an integer, exactly: a rational, and whether it is to be multiplied by pi.
///
/// `kappa(2m) = 4^m (m!)^2 / (2m)!`, `kappa(2m+1) = pi (2m+1)!! / (2^(m+1) m!)`.
///
/// The work grows like `n^2` digit operations: exact, so meant for the exponents of written formulas.
///
/// Source: MDR chapter (3.16).
///
/// ```
/// use num_rational::BigRational;
/// use sneddon_num::kappa::kappa_exact;
/// assert_eq!(kappa_exact(4), (BigRational::new(8.into(), 3.into()), false));
/// assert_eq!(kappa_exact(3), (BigRational::new(3.into(), 4.into()), true));
/// ```
pub fn kappa_exact(n: u32) -> (BigRational, bool) {
    let odd = n % 2 == 1;
    let (mut above, mut below) = (BigInt::from(1), BigInt::from(if odd { 2 } else { 1 }));
    for j in 1..=u64::from(n / 2) {
        let (even, odd_above, odd_below) = (2 * j, 2 * j + 1, 2 * j - 1);
        above *= if odd { odd_above } else { even };
        below *= if odd { even } else { odd_below };
    }
    (BigRational::new(above, below), odd)
}

/// sqrt(pi) to 106 bits.
const ROOT_PI: DoubleDouble = DoubleDouble { hi: 1.772_453_850_905_516, lo: -7.666_586_499_825_799e-17 };

/// Coefficients of `z^-2, z^-4, ...` in `Γ(x+1) / (Γ(x+1/2) sqrt(z))`, `z = x + 1/4`; the first are 1/64, -19/8192.
const RATIO_SERIES: [f64; 9] = [
    0.015625,
    -0.002_319_335_937_5,
    0.001_203_536_987_304_687_5,
    -0.001_298_762_857_913_971,
    0.002_385_557_512_752_711_8,
    -0.006_670_963_462_056_534,
    0.026_412_154_660_064_857,
    -0.140_658_070_795_462_03,
    0.969_822_875_725_336_5,
];

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::ToPrimitive;

    /// `kappa(n) = (n/2) B(n/2, 1/2)`. The beta function of `statrs` is off by up to 2300 ulp below n = 100 and
    /// overflows far above: this holds the definition, not the digits.
    #[test]
    fn agrees_with_an_independent_beta_function() {
        for n in [0.01, 0.3, 1.0, 2.5, 7.0, 33.3, 90.0] {
            let beta = 0.5 * n * statrs::function::beta::beta(0.5 * n, 0.5);
            assert!((kappa(n) / beta - 1.0).abs() < 1e-12, "n = {n}");
        }
    }

    #[test]
    fn integers_agree_with_the_exact_value() {
        for n in 0..=200_u32 {
            let (rational, times_pi) = kappa_exact(n);
            let factor = if times_pi { std::f64::consts::PI } else { 1.0 };
            let exact = rational.to_f64().unwrap_or(f64::NAN) * factor;
            assert!((kappa(f64::from(n)) / exact - 1.0).abs() <= 3e-16, "n = {n}");
        }
    }

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(kappa(0.0), 1.0);
        assert_eq!(kappa(5e-324), 1.0);
        assert_eq!(kappa(f64::INFINITY), f64::INFINITY);
        assert!(kappa(f64::MAX).is_finite());
        for n in [-1.0, -2.0, f64::NEG_INFINITY, f64::NAN] {
            assert!(kappa(n).is_nan());
        }
    }
}
