//! Circular functions, with π to 212 bits for the reduction of their arguments, and 2/π to 1280 bits for large ones.

use super::constants::{HALF_PI, INVERSE_FACTORIAL};
use crate::double_double::{DoubleDouble, two_prod, two_sum};

/// Up to here the quarter turns are counted in one double.
const LARGEST: f64 = (1_u64 << 50) as f64;
/// Below this the square of the argument does not count.
const SMALLEST: f64 = 1.0 / (1_u64 << 60) as f64;

/// sin x; with its relative error next to its zeros too.
///
/// ```
/// use sneddon_num::precise::{PI, sin};
/// // π rounded to a double-double is off by 2.99e-33.
/// assert!((sin(PI).value() + 2.994_769_809_718_34e-33).abs() < 1e-46);
/// ```
pub fn sin(x: DoubleDouble) -> DoubleDouble {
    sin_cos(x).0
}

/// cos x.
pub fn cos(x: DoubleDouble) -> DoubleDouble {
    sin_cos(x).1
}

/// tan x.
pub fn tan(x: DoubleDouble) -> DoubleDouble {
    let (sine, cosine) = sin_cos(x);
    sine.div(cosine)
}

/// sin x and cos x; NaN for infinities.
pub fn sin_cos(x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    if x.hi.abs() < SMALLEST {
        return (x, DoubleDouble::ONE);
    }
    if !x.hi.is_finite() {
        return (f64::NAN.into(), f64::NAN.into());
    }
    if x.hi.abs() > LARGEST {
        let (sine, cosine) = large(x.hi);
        let (small_sine, small_cosine) = sin_cos(x.lo.into());
        let sum = (sine.mul(small_cosine).add(cosine.mul(small_sine)), cosine.mul(small_cosine).sub(sine.mul(small_sine)));
        return if x.lo == 0.0 { (sine, cosine) } else { sum };
    }
    let quarters = (x.hi * std::f64::consts::FRAC_2_PI).round();
    turned(reduced(x, quarters), quarters as i64)
}

/// sin and cos of rest + quarters · π/2.
fn turned(rest: DoubleDouble, quarters: i64) -> (DoubleDouble, DoubleDouble) {
    let (sine, cosine) = (sine(rest), cosine(rest));
    match quarters.rem_euclid(4) {
        0 => (sine, cosine),
        1 => (cosine, sine.neg()),
        2 => (sine.neg(), cosine.neg()),
        _ => (cosine.neg(), sine),
    }
}

/// sin x and cos x for |x| >= 2^50: of x · 2/π only the words of 2/π are taken whose product is neither a multiple of 4 nor below 2^-200
/// (Payne and Hanek 1983).
fn large(x: f64) -> (DoubleDouble, DoubleDouble) {
    const WORDS: usize = 5;
    let bits = x.abs().to_bits();
    // |x| = mantissa · 2^power.
    let (mantissa, power) = ((bits & ((1 << 52) - 1)) | (1 << 52), (bits >> 52) as i64 - 1075);
    // The last bit of the product with the word at index i counts 2^(power − 64(i + 1)).
    let first = usize::try_from((power - 2).div_euclid(64)).unwrap_or(0);
    // The product, lowest word first.
    let (mut product, mut carry) = ([0_u64; WORDS + 1], 0_u128);
    for (index, place) in product.iter_mut().enumerate() {
        let word = (WORDS - 1).checked_sub(index).and_then(|back| TWO_OVER_PI.get(first + back)).copied().unwrap_or(0);
        let sum = u128::from(mantissa) * u128::from(word) + carry;
        (*place, carry) = (sum as u64, sum >> 64);
    }
    // Its point stands so many bits above its lowest one.
    let point = (64 * (first + WORDS) as i64 - power) as usize;
    let word = |index: usize| product.get(index).copied().unwrap_or(0);
    // 64 bits from a bit on.
    let from = |bit: usize| {
        let (index, shift) = (bit / 64, bit % 64);
        if shift == 0 { word(index) } else { (word(index) >> shift) | (word(index + 1) << (64 - shift)) }
    };
    let mut quarters = (from(point) & 3) as i64;
    // Three words of the fraction, of which the first one may be 0 next to a multiple of π/2; in halves that doubles hold.
    let mut fraction = DoubleDouble::from(0.0);
    for index in 1..=3_i32 {
        let own = from(point - 64 * index as usize);
        let (high, low) = ((own >> 32) as f64, (own & 0xffff_ffff) as f64);
        let scale = 2.0_f64.powi(-64 * index);
        fraction = fraction.add((high * 4_294_967_296.0 * scale).into()).add((low * scale).into());
        if index == 1 && own >> 63 == 1 {
            (quarters, fraction) = (quarters + 1, fraction.sub(DoubleDouble::ONE));
        }
    }
    let [head, tail, ..] = HALF_PI;
    let (sine, cosine) = turned(fraction.mul(DoubleDouble { hi: head, lo: tail }), quarters);
    if x < 0.0 { (sine.neg(), cosine) } else { (sine, cosine) }
}

/// The binary digits of 2/π.
const TWO_OVER_PI: [u64; 20] = [
    0xa2f9_836e_4e44_1529,
    0xfc27_57d1_f534_ddc0,
    0xdb62_9599_3c43_9041,
    0xfe51_63ab_debb_c561,
    0xb724_6e3a_424d_d2e0,
    0x0649_2eea_09d1_921c,
    0xfe1d_eb1c_b129_a73e,
    0xe882_35f5_2ebb_4484,
    0xe99c_7026_b45f_7e41,
    0x3991_d639_8353_39f4,
    0x9c84_5f8b_bdf9_283b,
    0x1ff8_97ff_de05_980f,
    0xef2f_118b_5a0a_6d1f,
    0x6d36_7ecf_27cb_09b7,
    0x4f46_3f66_9e5f_ea2d,
    0x7527_bac7_ebe5_f17b,
    0x3d07_39f7_8a52_92ea,
    0x6bfb_5fb1_1f8d_5d08,
    0x5603_3046_fc7b_6bab,
    0xf0cf_bc20_9af4_361d,
];

/// x − quarters · π/2.
fn reduced(x: DoubleDouble, quarters: f64) -> DoubleDouble {
    if quarters == 0.0 {
        return x;
    }
    let [first, second, third, fourth] = HALF_PI;
    let (head, middle) = (two_prod(-quarters, first), two_prod(-quarters, second));
    let rest = two_sum(x.lo, head.lo).add(middle).add((-quarters * third).into());
    let near = two_sum(x.hi, head.hi).add(rest);
    if near.hi.abs() > x.hi.abs() * 2.0_f64.powi(-45) {
        return near;
    }
    // Next to a multiple of π/2: every word counts, so they are added without any rounding.
    let last = two_prod(-quarters, third);
    exact_sum(&[x.hi, x.lo, head.hi, head.lo, middle.hi, middle.lo, last.hi, last.lo, -quarters * fourth])
}

/// The sum of at most sixteen words, rounded once at the end (Shewchuk 1997, grow-expansion).
fn exact_sum(words: &[f64]) -> DoubleDouble {
    let mut expansion = [0.0_f64; 16];
    for (count, word) in words.iter().enumerate() {
        let mut carry = *word;
        for slot in expansion.iter_mut().take(count) {
            let sum = two_sum(carry, *slot);
            (carry, *slot) = (sum.hi, sum.lo);
        }
        if let Some(slot) = expansion.get_mut(count) {
            *slot = carry;
        }
    }
    // Smallest first; adding upwards loses nothing that two words could hold.
    expansion.iter().fold(DoubleDouble::from(0.0), |sum, word| sum.add((*word).into()))
}

/// sin r for |r| <= 0.79 by its series.
fn sine(r: DoubleDouble) -> DoubleDouble {
    let square = r.mul(r);
    r.sub(r.mul(square).mul(alternating(square, 3)))
}

/// cos r for |r| <= 0.79 by its series.
fn cosine(r: DoubleDouble) -> DoubleDouble {
    let square = r.mul(r);
    DoubleDouble::ONE.sub(square.mul(alternating(square, 2)))
}

/// 1/first! − u/(first+2)! + u²/(first+4)! − …, the last terms, which count less than 2^-52, in single words.
fn alternating(u: DoubleDouble, first: usize) -> DoubleDouble {
    const LONG: usize = 8;
    let coefficient = |index: usize| INVERSE_FACTORIAL.get(first + 2 * index).copied().unwrap_or(0.0.into());
    let tail = (LONG..(INVERSE_FACTORIAL.len() - first).div_ceil(2)).rev().fold(0.0, |sum, index| coefficient(index).hi - u.hi * sum);
    (0..LONG).rev().fold(DoubleDouble::from(tail), |sum, index| coefficient(index).sub(u.mul(sum)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of 36 digits by mpmath; the last one is the double that is nearest to a multiple of π/2.
    #[test]
    fn large_arguments_keep_thirty_digits() {
        let cases = [
            (1407374883553280.0_f64, (0.604631790432123, 1.822299905662373e-17), (0.7965051148604416, -2.2165589842039097e-17)),
            (1e16_f64, (0.7796880066069788, -3.933442259574261e-17), (-0.6261681981330862, 4.6130820789045176e-17)),
            (-7.3e18_f64, (-0.6511257192189964, 1.8840760115043503e-18), (0.7589698925329941, 4.0732784458944996e-17)),
            (1e20_f64, (-0.6452512852657808, -5.0185382399526676e-17), (0.7639704044417283, 4.349442753957891e-17)),
            (1.8446744073709552e19_f64, (0.023598509904439558, 5.129963650235035e-19), (-0.9997215163885841, -3.4345490272471883e-17)),
            (3.1e45_f64, (-0.37928085789559524, -1.6605977147675997e-17), (0.9252815954259446, -4.6659885617019826e-17)),
            (1e100_f64, (-0.3806377310050287, 1.2782658365978341e-17), (0.9247242387519338, 1.669232482156043e-17)),
            (-5e150_f64, (0.8907298081522333, -5.4404480822190306e-18), (0.4545331768629058, -9.729231237102766e-18)),
            (1e300_f64, (-0.8178819121159085, -4.78135837440326e-17), (-0.5753861119575491, 2.6770761918787068e-17)),
            (1.7976931348623157e308_f64, (0.004961954789184062, -2.5049377676494104e-19), (-0.9999876894265599, -2.6032890267216748e-17)),
            (5.319372648326541e255_f64, (1.0, -1.098476220074687e-37), (-4.687165924254628e-19, 4.3720557429382733e-36)),
        ];
        for (x, sine, cosine) in cases {
            let found = sin_cos(x.into());
            for (own, (hi, lo)) in [(found.0, sine), (found.1, cosine)] {
                let error = own.sub(DoubleDouble { hi, lo }).hi.abs();
                assert!(error <= 1e-30 * hi.abs(), "{x:e}: {own:?} for {hi:e} + {lo:e}");
            }
        }
    }

    #[test]
    fn a_large_argument_with_a_rest_is_a_sum_of_angles() {
        let x = DoubleDouble { hi: 1e20, lo: 3.75 };
        let ((sine, cosine), (s, c)) = (sin_cos(1e20.into()), sin_cos(3.75.into()));
        let expected = sine.mul(c).add(cosine.mul(s));
        assert!(sin_cos(x).0.sub(expected).hi.abs() < 1e-31);
    }
}
