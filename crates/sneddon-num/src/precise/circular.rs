//! Circular functions, with π to 212 bits for the reduction of their arguments.

use super::constants::{HALF_PI, INVERSE_FACTORIAL};
use crate::double_double::{DoubleDouble, two_prod, two_sum};

/// Arguments beyond this are NaN: the quarter turns could no longer be counted.
const LARGEST: f64 = (1_u64 << 50) as f64;
/// Below this the square of the argument does not count.
const SMALLEST: f64 = 1.0 / (1_u64 << 60) as f64;

/// sin x, |x| <= 2^50; with its relative error next to its zeros too.
///
/// ```
/// use sneddon_num::precise::{PI, sin};
/// // π rounded to a double-double is off by 2.99e-33.
/// assert!((sin(PI).value() + 2.994_769_809_718_34e-33).abs() < 1e-46);
/// ```
pub fn sin(x: DoubleDouble) -> DoubleDouble {
    sin_cos(x).0
}

/// cos x, |x| <= 2^50.
pub fn cos(x: DoubleDouble) -> DoubleDouble {
    sin_cos(x).1
}

/// tan x, |x| <= 2^50.
pub fn tan(x: DoubleDouble) -> DoubleDouble {
    let (sine, cosine) = sin_cos(x);
    sine.div(cosine)
}

/// sin x and cos x, |x| <= 2^50; NaN beyond.
pub fn sin_cos(x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    if x.hi.abs() < SMALLEST {
        return (x, DoubleDouble::ONE);
    }
    if x.hi.is_nan() || x.hi.abs() > LARGEST {
        return (f64::NAN.into(), f64::NAN.into());
    }
    let quarters = (x.hi * std::f64::consts::FRAC_2_PI).round();
    let rest = reduced(x, quarters);
    let (sine, cosine) = (sine(rest), cosine(rest));
    match (quarters as i64).rem_euclid(4) {
        0 => (sine, cosine),
        1 => (cosine, sine.neg()),
        2 => (sine.neg(), cosine.neg()),
        _ => (cosine.neg(), sine),
    }
}

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
