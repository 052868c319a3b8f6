//! The digamma function, accurate also at its zero.

use crate::special::ball::Ball;
use crate::special::gamma::{BERNOULLI, FAR, is_pole};
use crate::{DoubleDouble, Precise, work};

/// `psi(x) = Gamma'(x)/Gamma(x)`.
///
/// Domain: `x > 0`; infinite at infinity, NaN for `x <= 0`. Its zero is 1.46163….
///
/// Accuracy: measured at most 2.7 ulp for `x` from 1e-300 to 1e300, the neighbourhood of the zero included.
///
/// Source: DLMF 5.5.2 and 5.11.2; Taylor series about the zero, which is carried to 106 bits.
///
/// ```
/// use sneddon_num::special::digamma;
/// assert!((digamma(1.0) + 0.577_215_664_901_532_9).abs() < 1e-15);
/// ```
pub fn digamma(x: f64) -> f64 {
    if x.is_nan() || x <= 0.0 {
        return f64::NAN;
    }
    if x == f64::INFINITY {
        return x;
    }
    let from_zero = (x - ZERO) - ZERO_REST;
    if from_zero.abs() < 0.6 {
        return from_zero * AROUND_ZERO.iter().rev().fold(0.0, |sum, c| sum * from_zero + c);
    }
    // Steps of psi(x+1) = psi(x) + 1/x into the Taylor range: no large logarithm is subtracted from, so the result
    // keeps its digits.
    if x < ZERO {
        return digamma(x + 1.0) - 1.0 / x;
    }
    if x < 4.0 {
        return digamma(x - 1.0) + 1.0 / (x - 1.0);
    }
    // Upward to the asymptotic series: psi(x) = psi(x + n) - Σ 1/(x+j). The reciprocals are summed from the smallest, 1/x last: it is the largest.
    let steps = if x < SHIFT { (SHIFT - x).ceil() as u32 } else { 0 };
    let y = x + f64::from(steps);
    let square = 1.0 / (y * y);
    let series = ASYMPTOTIC.iter().rev().fold(0.0, |sum, c| sum * square + c) * square;
    let mut sum = 0.0;
    for j in (1..steps).rev() {
        sum += 1.0 / (x + f64::from(j));
    }
    let far = y.ln() - (0.5 / y + series) - sum;
    if steps > 0 { far - 1.0 / x } else { far }
}

/// `psi(x)` with about 30 digits; the bound is absolute next to the zeros.
///
/// Domain: real `x > -1000`, whole `x <= 0` excepted; no value elsewhere.
/// Method: the recurrence up to 32, then the asymptotic series with the exact Bernoulli numbers.
/// Accuracy: measured at most 2e-31 absolute or relative, whichever is larger.
///
/// Source: DLMF 5.5.2 and 5.11.2; the first omitted term bounds the tail.
///
/// ```
/// use sneddon_num::special::digamma_precise;
/// let one = digamma_precise(1.0.into());
/// assert!((one.value.value() + 0.577_215_664_901_532_9).abs() < 1e-15 && one.error < 1e-28);
/// ```
pub fn digamma_precise(x: DoubleDouble) -> Precise {
    digamma_ball(Ball::exact(x)).precise()
}

/// ψ of a ball.
pub(crate) fn digamma_ball(x: Ball) -> Ball {
    if is_pole(x) || x.hi().is_nan() || x.hi() < -1000.0 {
        return Ball::NONE;
    }
    let steps = if x.hi() < FAR { (FAR - x.hi()).ceil() as u32 } else { 0 };
    work::spend(100 + 10 * u64::from(steps));
    let mut before = Ball::ZERO;
    for step in (0..steps).rev() {
        before = before + (x + f64::from(step)).recip();
    }
    let y = x + f64::from(steps);
    let square = y.square().recip();
    let (mut power, mut series) = (square, Ball::ZERO);
    for (k, (above, below)) in (1_u32..).zip(BERNOULLI) {
        let term = power * above / (below * f64::from(2 * k));
        if term.hi().abs() < 1e-36 {
            break;
        }
        series = series + term;
        power = power * square;
    }
    (y.ln() - y.recip().scale(0.5) - series - before).widened(1e-34)
}

/// The asymptotic series starts here: its eighth term is below 2^-60.
const SHIFT: f64 = 10.0;
const ZERO: f64 = 1.461_632_144_968_362_2;
const ZERO_REST: f64 = 9.549_995_429_965_697e-17;

/// `B_2k / (2k)`, k = 1, 2, …
const ASYMPTOTIC: [f64; 9] =
    [1.0 / 12.0, -1.0 / 120.0, 1.0 / 252.0, -1.0 / 240.0, 1.0 / 132.0, -691.0 / 32760.0, 1.0 / 12.0, -3617.0 / 8160.0, 43867.0 / 14364.0];

/// Taylor coefficients `psi^(k)(zero)/k!`, k = 1, 2, …
const AROUND_ZERO: [f64; 44] = [
    0.967_672_245_447_621_2,
    -0.442_763_168_983_592_1,
    0.258_499_760_955_651,
    -0.163_942_705_442_406_52,
    0.107_824_050_691_262_37,
    -0.072_199_561_256_454_71,
    0.048_804_288_164_143_11,
    -0.033_161_126_474_847_36,
    0.022_597_648_232_218_104,
    -0.015_424_765_904_948_96,
    0.010_538_791_616_612_175,
    -0.007_204_534_386_356_869,
    0.004_926_781_395_729_853,
    -0.003_369_801_655_439_328,
    0.002_305_126_326_734_928,
    -0.001_576_936_771_430_197_2,
    0.001_078_825_201_916_296_7,
    -0.000_738_070_938_996_005_2,
    0.000_504_953_265_834_602,
    -0.000_345_468_025_106_307_7,
    0.000_236_356_015_640_270_53,
    -0.000_161_706_220_919_748_03,
    0.000_110_633_727_687_474_1,
    -7.569_179_582_195_066e-5,
    5.178_575_795_222_081e-5,
    -3.543_007_094_765_960_4e-5,
    2.424_006_611_860_132e-5,
    -1.658_424_227_185_413_5e-5,
    1.134_638_458_466_385e-5,
    -7.762_817_668_462_094e-6,
    5.311_060_920_889_863_6e-6,
    -3.633_650_789_801_045_6e-6,
    2.486_022_733_129_538e-6,
    -1.700_853_885_433_260_7e-6,
    1.163_667_536_354_884_3e-6,
    -7.961_425_431_241_97e-7,
    5.446_941_930_669_446e-7,
    -3.726_616_128_343_822_7e-7,
    2.549_626_552_021_554e-7,
    -1.744_369_511_772_774_5e-7,
    1.193_439_482_983_024_4e-7,
    -8.165_115_189_488_409e-8,
    5.586_299_683_532_171e-8,
    -3.821_960_061_917_494e-8,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        assert!(digamma(0.0).is_nan() && digamma(-0.5).is_nan() && digamma(f64::NAN).is_nan());
        assert_eq!(digamma(f64::INFINITY), f64::INFINITY);
        assert!(digamma(1e-300) < -9e299);
        assert!(digamma(ZERO).abs() < 1e-16);
    }
}
