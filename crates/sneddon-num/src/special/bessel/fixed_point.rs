//! The alternating series of Bessel and Struve functions in whole numbers, for arguments next to a zero.

use crate::double_double::DoubleDouble;
use num_bigint::BigInt;
use num_traits::{FromPrimitive, ToPrimitive, Zero};

/// Beyond this the doubles lie so far apart that the nearest one to a zero keeps its digits in double-double.
const FARTHEST: f64 = 600.0;

/// Σ (−z²/4)^k / ((a)_k (b)_k) to 2^-250 for 1 <= z <= 600 and half-whole a, b.
///
/// The terms grow to about e^z before they fall; as many bits are added.
pub(crate) fn exact_series(z: f64, a: f64, b: f64) -> Option<DoubleDouble> {
    let (double_a, double_b) = (2.0 * a, 2.0 * b);
    if !(1.0..=FARTHEST).contains(&z) || double_a.fract() != 0.0 || double_b.fract() != 0.0 || double_b > 1e6 {
        return None;
    }
    let bits = 260 + (3.0 * z) as usize;
    // Every double from 1 on is a multiple of 2^-52.
    let mantissa = BigInt::from((z * 2.0_f64.powi(52)).to_i128()?);
    let square = &mantissa * &mantissa;
    let (mut double_a, mut double_b) = (double_a.to_i64()?, double_b.to_i64()?);
    let mut term = BigInt::from(1) << bits;
    let mut sum = BigInt::zero();
    while !term.is_zero() {
        sum += &term;
        // z² = square/2^104, and a·b = (2a)(2b)/4.
        term = -((term * &square) >> 104_usize) / (double_a * double_b);
        double_a += 2;
        double_b += 2;
    }
    words(sum, bits)
}

/// number · 2^-bits, of which 500 bits are kept so that they stay in the range of doubles.
fn words(number: BigInt, bits: usize) -> Option<DoubleDouble> {
    const KEPT: usize = 500;
    let kept = number >> bits.saturating_sub(KEPT);
    let hi = kept.to_f64()?;
    let lo = (kept - BigInt::from_f64(hi)?).to_f64()?;
    Some(DoubleDouble { hi, lo }.scale(2.0_f64.powi(-(KEPT.min(bits) as i32))))
}
