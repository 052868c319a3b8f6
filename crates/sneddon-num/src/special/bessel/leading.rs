//! The first terms of the series of Bessel and Struve functions, and what they need of the gamma function.

use crate::double_double::{DoubleDouble, Precise, words};
use crate::special::carried::{TINY, TWO_OVER_PI, UNIT, exact, known, over, quotient, times};
use crate::{precise, work};

/// (z/2)^n/Γ(n+1) for n > −1, half = z/2 > 0; 0 by underflow for n > 10^4, where z is below 1500 or n.
pub(crate) fn bessel_leading(n: DoubleDouble, half: DoubleDouble) -> Precise {
    let whole = n.hi.floor();
    let fraction = n.sub(whole.into());
    if whole < 0.0 {
        // Γ(n+2) = (n+1) Γ(n+1).
        let above = fractional(fraction, half);
        return over(times(above, exact(fraction)), exact(half));
    }
    if whole > 1e4 {
        return Precise { value: 0.0.into(), error: TINY };
    }
    let start = if fraction.hi == 0.0 { exact(DoubleDouble::ONE) } else { fractional(fraction, half) };
    let (mut product, mut steps) = (start.value, 0.0);
    for j in 1..=(whole as u32) {
        let divisor = fraction.add(f64::from(j).into());
        product = product.mul(half);
        product = if divisor.lo == 0.0 { quotient(product, divisor.hi) } else { product.div(divisor) };
        steps += 1.0;
        if product.hi == 0.0 {
            break;
        }
    }
    work::spend(6 * steps as u64);
    let own = if product.hi == 0.0 { 0.0 } else { start.error / start.value.hi.abs() };
    Precise { value: product, error: product.hi.abs() * (own + 5.0 * steps * UNIT) + (1.0 + steps) * TINY }
}

/// (2/π)(z/2)^(n+1)/((1/2)(3/2)…(n+1/2)) for whole n >= −1: the first term of the Struve functions.
pub(crate) fn struve_leading(n: f64, half: DoubleDouble) -> Precise {
    let (mut product, mut steps) = (TWO_OVER_PI, 0.0);
    for j in 0..((n + 1.0).min(1e4) as u32) {
        product = quotient(product.mul(half), f64::from(j) + 0.5);
        steps += 1.0;
        if product.hi == 0.0 {
            break;
        }
    }
    work::spend(6 * steps as u64);
    Precise { value: product, error: product.hi.abs() * (1.0 + 5.0 * steps) * UNIT + (1.0 + steps) * TINY }
}

/// (z/2)^f/Γ(1+f) for 0 <= f < 1.
fn fractional(f: DoubleDouble, half: DoubleDouble) -> Precise {
    times(precise::pow(half, f), reciprocal_gamma(f))
}

/// 1/Γ(1+f) for 0 <= f < 1: its Taylor series about 1/2, whose coefficients sum to less than 1.4 in size.
pub(crate) fn reciprocal_gamma(f: DoubleDouble) -> Precise {
    let t = f.sub(0.5.into());
    let sum = RECIPROCAL_GAMMA.iter().rev().fold(DoubleDouble::from(0.0), |sum, c| sum.mul(t).add(*c));
    known(sum, 4.0)
}

/// Taylor coefficients of 1/Γ(1+f) about f = 1/2, to 32 digits.
const RECIPROCAL_GAMMA: [DoubleDouble; 33] = [
    words(std::f64::consts::FRAC_2_SQRT_PI, 1.533_545_961_316_588e-17),
    words(-0.041_174_526_445_283_1, -3.375_213_015_737_574_5e-18),
    words(-0.526_654_435_525_544_5, -6.112_036_385_608_127e-18),
    words(0.175_102_026_043_934_57, -1.065_747_126_851_441_2e-17),
    words(0.050_966_860_247_706_074, 3.124_722_471_894_442_7e-18),
    words(-0.042_155_169_368_535_604, 3.097_634_210_373_447_7e-18),
    words(0.006_612_897_826_824_127, 3.573_455_638_859_823e-19),
    words(0.002_120_731_442_572_938, 1.378_129_797_522_014_5e-19),
    words(-0.001_110_730_254_594_890_6, -9.753_454_144_222_531e-20),
    words(0.000_152_357_620_767_476_88, -1.090_652_086_132_933_8e-20),
    words(2.535_520_492_381_416_5e-5, 4.893_956_349_690_275e-22),
    words(-1.389_680_571_791_375_6e-5, 2.153_354_312_130_703_6e-22),
    words(2.156_203_290_514_172_4e-6, 8.714_226_745_633_228e-23),
    words(5.794_264_054_052_672_6e-8, -7.454_341_938_541_845e-25),
    words(-8.913_551_118_311_116e-8, -3.639_776_989_356_635e-24),
    words(1.710_346_941_591_537_4e-8, 1.127_485_784_649_773_9e-25),
    words(-9.313_686_445_241_901e-10, -3.474_969_316_158_858e-26),
    words(-2.680_474_103_349_662_3e-10, -2.361_258_419_463_929_8e-26),
    words(7.458_932_233_316_326e-11, 2.437_347_875_405_621_8e-27),
    words(-8.012_807_061_414_718e-12, -7.570_390_468_804_759e-28),
    words(-8.382_343_033_451_855e-14, 3.885_823_863_175_652e-30),
    words(1.694_634_090_432_052_2e-13, 2.265_350_945_215_833_4e-30),
    words(-2.787_575_670_712_575_3e-14, 6.524_116_911_441_165e-31),
    words(1.867_039_469_506_530_6e-15, -4.254_392_590_878_746e-32),
    words(1.304_949_900_858_798_8e-16, -9.270_238_560_188_959e-33),
    words(-4.858_874_144_187_786_4e-17, -1.339_620_604_759_889e-33),
    words(5.829_542_692_459_468e-18, -7.523_759_917_630_262e-35),
    words(-2.592_909_417_993_784e-19, 4.829_592_907_826_018_4e-36),
    words(-3.326_754_010_285_789e-20, 1.625_134_568_986_323_5e-36),
    words(7.944_961_635_768_106e-21, -3.661_196_591_132_274e-37),
    words(-7.755_543_288_437_357e-22, -3.001_439_691_199_397e-38),
    words(2.553_373_629_132_969_6e-23, 1.078_876_594_247_345_8e-40),
    words(4.274_520_160_147_173e-24, 2.765_468_901_595_289_5e-40),
];
