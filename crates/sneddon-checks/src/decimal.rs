//! Decimals with more digits than an `f64` holds, and distances to them in units of the last place.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

/// A decimal number, exactly.
#[derive(Clone, Debug)]
pub struct Decimal(BigRational);

impl Decimal {
    /// Reads `-1.25e-7` and the like.
    pub fn read(text: &str) -> Self {
        let (negative, rest) = text.strip_prefix('-').map_or((false, text), |rest| (true, rest));
        let (mantissa, exponent) = rest.split_once(['e', 'E']).map_or((rest, 0), |(m, e)| (m, e.parse::<i64>().unwrap()));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits: BigInt = format!("{whole}{fraction}").parse().unwrap();
        let scale = exponent - fraction.len() as i64;
        let power = BigInt::from(10).pow(scale.unsigned_abs() as u32);
        let value = if scale >= 0 { BigRational::from_integer(digits * power) } else { BigRational::new(digits, power) };
        Self(if negative { -value } else { value })
    }

    /// The nearest `f64`.
    pub fn to_f64(&self) -> f64 {
        self.0.to_f64().unwrap()
    }

    /// How far `value` lies from here, as an `f64`; exact before that rounding.
    pub fn distance(&self, value: f64) -> f64 {
        (exact(value) - &self.0).to_f64().unwrap()
    }

    /// How far the exact sum of the words lies from here.
    pub fn distance_of(&self, words: &[f64]) -> f64 {
        if words.iter().any(|word| !word.is_finite()) {
            return f64::NAN;
        }
        (words.iter().map(|word| exact(*word)).sum::<BigRational>() - &self.0).to_f64().unwrap()
    }

    /// The same as a part of this number; infinite for NaN, 0 for equal zeros.
    pub fn relative_of(&self, words: &[f64]) -> f64 {
        if words.iter().any(|word| !word.is_finite()) {
            return f64::INFINITY;
        }
        let difference = words.iter().map(|word| exact(*word)).sum::<BigRational>() - &self.0;
        if difference.is_zero() {
            return 0.0;
        }
        if self.0.is_zero() { f64::INFINITY } else { (difference / &self.0).abs().to_f64().unwrap_or(f64::INFINITY) }
    }

    /// The number moved by a small amount.
    pub fn moved(&self, by: f64) -> Self {
        Self(&self.0 + exact(by))
    }

    /// |value − self| in units of the last place of `self`; 0 for equal zeros, infinite for NaN.
    pub fn ulps(&self, value: f64) -> f64 {
        if !value.is_finite() {
            return f64::INFINITY;
        }
        let difference = (exact(value) - &self.0).abs();
        if difference.is_zero() {
            return 0.0;
        }
        let near = self.to_f64().abs();
        // Division before rounding: a difference of many ulps of a tiny number stays in range.
        (difference / exact(near.next_up() - near)).to_f64().unwrap_or(f64::INFINITY)
    }

    /// |value − self|/|self|; infinite for NaN, 0 for equal zeros.
    pub fn relative(&self, value: f64) -> f64 {
        if !value.is_finite() {
            return f64::INFINITY;
        }
        if self.0.is_zero() {
            return if value == 0.0 { 0.0 } else { f64::INFINITY };
        }
        ((exact(value) - &self.0) / &self.0).abs().to_f64().unwrap_or(f64::INFINITY)
    }
}

fn exact(value: f64) -> BigRational {
    BigRational::from_float(value).unwrap()
}
