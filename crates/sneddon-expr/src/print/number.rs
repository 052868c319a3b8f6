//! Whole numbers and decimals as digits.

use crate::expr::Number;
use num_bigint::BigInt;
use num_traits::{Signed, Zero};

/// Digits, perhaps with a point, and the power of ten that they are multiplied with.
pub(super) struct Digits {
    pub(super) mantissa: String,
    pub(super) exponent: Option<i64>,
}

/// Whole numbers with more digits than this, most of them trailing zeros, are written with a power of ten.
const LONG: usize = 15;

/// Decimals below 10 to minus this power are written with a power of ten.
const SMALL: usize = 4;

/// The magnitude of a whole or decimal number; numbers of other kinds are written as fractions by the caller.
pub(super) fn digits(number: &Number) -> Digits {
    let (numerator, denominator) = (number.value().numer().abs(), number.value().denom().clone());
    let places = decimal_places(denominator.clone());
    let scaled = numerator * BigInt::from(10).pow(places) / denominator;
    let digits = scaled.to_string();
    let places = places as usize;
    let significant = digits.trim_end_matches('0');
    // The value is 0.digits · 10^power.
    let power = digits.len() as i64 - places as i64;
    let whole_and_long = places == 0 && digits.len() > LONG && significant.len() < digits.len() / 2;
    if whole_and_long || (places > 0 && power <= -(SMALL as i64)) {
        let (first, rest) = significant.split_at(significant.len().min(1));
        let mantissa = if rest.is_empty() { first.to_owned() } else { format!("{first}.{rest}") };
        return Digits { mantissa, exponent: Some(power - 1) };
    }
    if places == 0 {
        return Digits { mantissa: digits, exponent: None };
    }
    let padded = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = padded.split_at(padded.len() - places);
    Digits { mantissa: format!("{whole}.{fraction}"), exponent: None }
}

/// The number of decimal places of 1/`denominator`, which has no prime factor besides 2 and 5.
fn decimal_places(denominator: BigInt) -> u32 {
    let twos = denominator.trailing_zeros().unwrap_or(0);
    let mut rest = denominator >> twos;
    let five = BigInt::from(5);
    let mut fives = 0;
    while (&rest % &five).is_zero() && !rest.is_zero() {
        rest /= &five;
        fives += 1;
    }
    u32::try_from(twos).unwrap_or(u32::MAX).max(fives)
}
