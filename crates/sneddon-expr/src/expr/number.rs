//! Exact rational numbers with a flag for numbers typed as decimals.

use super::divisor::common_divisor;
use crate::num::work;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Pow, Signed, ToPrimitive, Zero};
use std::cmp::Ordering;
use std::hash::{Hash, Hasher};
use std::ops::{Add, Mul, Neg, Sub};

/// An exact rational number; the flag `decimal` affects printing only and is ignored in comparisons.
///
/// `0.7` is 7/10 in every computation and prints as `0.7` because it was typed that way.
/// Sums and products with a decimal are decimals again if the decimal expansion terminates; otherwise they print as quotients.
///
/// ```
/// use sneddon_expr::expr::Number;
/// let typed = Number::parse_decimal("0.7").unwrap();
/// assert_eq!(typed, Number::ratio(7, 10));
/// assert!(typed.is_decimal() && !Number::ratio(7, 10).is_decimal());
/// ```
#[derive(Clone, Debug)]
pub struct Number {
    value: BigRational,
    decimal: bool,
}

/// The largest size, in bits, of a number that folding a power may produce.
const LARGEST_FOLD_BITS: u64 = 1 << 16;

impl Number {
    /// The integer `n`.
    pub fn integer(n: i64) -> Self {
        Self::from(BigRational::from_integer(BigInt::from(n)))
    }

    /// The fraction `p/q`; `q` must not be zero (a zero denominator gives `p`).
    pub fn ratio(p: i64, q: i64) -> Self {
        if q == 0 {
            return Self::integer(p);
        }
        Self::from(BigRational::new(BigInt::from(p), BigInt::from(q)))
    }

    /// Reads digits with an optional point and an optional exponent, exactly.
    ///
    /// `None` if the text is not such a number or its exponent lies beyond ±10 000.
    pub fn parse_decimal(text: &str) -> Option<Self> {
        let (mantissa, exponent) = match text.find(['e', 'E']) {
            Some(at) => (&text[..at], text[at + 1..].parse::<i64>().ok()?),
            None => (text, 0),
        };
        if exponent.abs() > 10_000 {
            return None;
        }
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits: String = [whole, fraction].concat();
        if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
            return None;
        }
        let scale = exponent - i64::try_from(fraction.len()).ok()?;
        let power = BigInt::from(10).pow(u32::try_from(scale.unsigned_abs()).ok()?);
        let integer: BigInt = digits.parse().ok()?;
        let value = if scale >= 0 { BigRational::from_integer(integer * power) } else { BigRational::new(integer, power) };
        // A whole number with an exponent, as in 1.6e15, does not count as a decimal: it may be the denominator of a fraction.
        let decimal = !value.is_integer() || (mantissa.contains('.') && exponent == 0);
        Some(Self { value, decimal })
    }

    /// The exact rational value of a finite `f64`; `None` for NaN and infinities.
    pub fn from_f64(value: f64) -> Option<Self> {
        BigRational::from_float(value).map(|value| Self { value, decimal: true })
    }

    /// The exact value.
    pub fn value(&self) -> &BigRational {
        &self.value
    }

    /// True if the number should print as a decimal fraction.
    pub fn is_decimal(&self) -> bool {
        self.decimal && (self.is_integer() || ends_in_decimals(&self.value))
    }

    /// Numerator and denominator as they are printed: 0.7 over 1, and for decimals without an end 7 over 30 or 1 over 12.73.
    ///
    /// Both parts are divided by their factors of ten, and a long denominator is written with one digit before the point: 1.853 over 5.024.
    /// Short parts are whole numbers.
    ///
    /// ```
    /// use sneddon_expr::expr::Number;
    /// let number = |text| Number::parse_decimal(text).unwrap();
    /// let inverse = number("12.73").reciprocal().unwrap();
    /// assert_eq!(inverse.printed_parts(), (number("1"), number("12.73")));
    /// ```
    pub fn printed_parts(&self) -> (Self, Self) {
        let (p, q) = (self.value.numer(), self.value.denom());
        if self.is_decimal() {
            return (self.clone(), Self::integer(1));
        }
        let scale = if self.decimal && !self.is_short() { decimal_scale(p, q) } else { BigInt::one() };
        let part = |own: &BigInt| {
            let value = BigRational::new(own.clone(), scale.clone());
            Self { decimal: !value.is_integer(), value }
        };
        (part(p), part(q))
    }

    /// True for decimals and for numbers computed from them, such as 0.7/3, even if the decimal expansion does not terminate.
    pub fn has_decimals(&self) -> bool {
        self.decimal
    }

    /// True for whole numbers, and for fractions whose numerator and denominator have at most two digits.
    pub fn is_short(&self) -> bool {
        let is_short = |own: &BigInt| own.bits() <= 7 && *own.magnitude() < 100u32.into();
        self.is_integer() || (is_short(self.value.numer()) && is_short(self.value.denom()))
    }

    /// The same number, printed with decimals unless it is short.
    pub fn with_decimals(&self) -> Self {
        Self { value: self.value.clone(), decimal: self.decimal || !self.is_short() }
    }

    /// The same number, printed as a fraction.
    pub fn as_fraction(&self) -> Self {
        Self { value: self.value.clone(), decimal: false }
    }

    /// True for 0.
    pub fn is_zero(&self) -> bool {
        self.value.is_zero()
    }

    /// True for 1.
    pub fn is_one(&self) -> bool {
        self.value.is_one()
    }

    /// True for whole numbers.
    pub fn is_integer(&self) -> bool {
        self.value.is_integer()
    }

    /// True below 0.
    pub fn is_negative(&self) -> bool {
        self.value.is_negative()
    }

    /// True above 0.
    pub fn is_positive(&self) -> bool {
        self.value.is_positive()
    }

    /// The value as a machine integer, where it is one.
    pub fn to_i64(&self) -> Option<i64> {
        if self.is_integer() { self.value.to_integer().to_i64() } else { None }
    }

    /// The nearest `f64` (ties to even), infinite beyond the range.
    pub fn to_f64(&self) -> f64 {
        nearest_f64(&self.value)
    }

    /// True if [`Self::to_f64`] is the number itself.
    pub fn is_exact_f64(&self) -> bool {
        BigRational::from_float(self.to_f64()).is_some_and(|back| back == self.value)
    }

    /// The size of numerator and denominator together, in bits.
    pub fn bits(&self) -> u64 {
        self.value.numer().bits() + self.value.denom().bits()
    }

    /// The reciprocal; `None` for 0.
    pub fn reciprocal(&self) -> Option<Self> {
        (!self.is_zero()).then(|| Self::computed(self.value.recip(), self.decimal))
    }

    /// The integer power, where it is defined and not larger than a fold may be.
    pub fn power(&self, exponent: i64) -> Option<Self> {
        if self.is_zero() && exponent < 0 {
            return None;
        }
        let magnitude = exponent.unsigned_abs();
        let unit = self.value.numer().magnitude().is_one() && self.value.denom().is_one();
        if !unit && !self.is_zero() && self.bits().saturating_mul(magnitude) > LARGEST_FOLD_BITS {
            return None;
        }
        let exponent = if unit { exponent % 2 } else { exponent };
        let value = Pow::pow(&self.value, i32::try_from(exponent).ok()?);
        Some(Self::computed(value, self.decimal))
    }

    /// The exact k-th root of a positive number, where it is rational.
    pub fn root(&self, k: u32) -> Option<Self> {
        if !self.is_positive() || k == 0 || self.bits() > LARGEST_FOLD_BITS {
            return None;
        }
        let (p, q) = (self.value.numer().nth_root(k), self.value.denom().nth_root(k));
        let exact = Pow::pow(&p, k) == *self.value.numer() && Pow::pow(&q, k) == *self.value.denom();
        exact.then(|| Self::computed(BigRational::new(p, q), self.decimal))
    }

    /// The largest positive rational of which both numbers are integer multiples; the magnitude of the other if one is 0.
    pub fn common_factor(&self, other: &Self) -> Self {
        let (p, q) = (self.value.numer().gcd(other.value.numer()), self.value.denom().lcm(other.value.denom()));
        Self::computed(BigRational::new(p, q), self.decimal || other.decimal)
    }

    /// The absolute value.
    pub fn abs(&self) -> Self {
        Self { value: self.value.abs(), decimal: self.decimal }
    }

    /// Numerator and denominator where both are below 2^62, so that sums of their products stay below 2^127.
    fn small(&self) -> Option<(i128, i128)> {
        const LARGEST: i64 = 1 << 62;
        let part = |own: &BigInt| own.to_i64().filter(|n| (-LARGEST..=LARGEST).contains(n)).map(i128::from);
        Some((part(self.value.numer())?, part(self.value.denom())?))
    }

    /// A number computed from others, some of which had decimals.
    pub(super) fn computed(value: BigRational, decimal: bool) -> Self {
        let decimal = decimal && !value.is_integer();
        Self { value, decimal }
    }
}

/// p/q reduced, q > 0; most numbers of a derivation are small enough for this.
fn fraction(p: i128, q: i128) -> BigRational {
    work::spend(if q == 1 { 14 } else { 20 });
    let common = match (u64::try_from(p.unsigned_abs()), u64::try_from(q)) {
        _ if q == 1 => 1,
        // Arithmetic on one word is cheaper than on two.
        (Ok(p), Ok(q)) => i128::from(p.gcd(&q)),
        _ => p.gcd(&q),
    };
    BigRational::new_raw(BigInt::from(p / common), BigInt::from(q / common))
}

/// True if the denominator has no prime factor besides 2 and 5 and few enough digits to print.
fn ends_in_decimals(value: &BigRational) -> bool {
    let (twos, fives, rest) = factors_of_ten(value.denom());
    rest.is_one() && twos.abs_diff(fives) <= 64
}

/// The exponents of the factors 2 and 5 of a positive number, and the remaining factor.
fn factors_of_ten(number: &BigInt) -> (u64, u64, BigInt) {
    let twos = number.trailing_zeros().unwrap_or(0);
    let mut rest = number >> twos;
    // 5, 5², 5⁴, … as far as they divide the remainder; then each of them once more from the largest down.
    let mut powers = vec![(1, BigInt::from(5))];
    let mut fives = 0;
    while let Some((count, power)) = powers.last().filter(|(_, power)| (&rest % power).is_zero()) {
        fives += count;
        rest /= power;
        powers.push((2 * count, power * power));
    }
    for (count, power) in powers.iter().rev() {
        if (&rest % power).is_zero() {
            fives += count;
            rest /= power;
        }
    }
    (twos, fives, rest)
}

/// The common divisor of numerator and denominator in a printed quotient of decimals.
fn decimal_scale(p: &BigInt, q: &BigInt) -> BigInt {
    let hundred = BigInt::from(100);
    let fives = fives(p) * fives(q);
    if !fives.is_one() || p.abs() < hundred || *q < hundred {
        return fives;
    }
    let digits = q.to_string().len();
    BigInt::from(10).pow(digits - 1)
}

/// All factors 5 of a number, each with a factor 2 as far as there are any.
fn fives(number: &BigInt) -> BigInt {
    let (twos, fives, _) = factors_of_ten(number);
    BigInt::from(5).pow(fives) << twos.min(fives)
}

/// Rounds to the nearest `f64` by integer division of scaled operands.
fn nearest_f64(value: &BigRational) -> f64 {
    if value.is_zero() {
        return 0.0;
    }
    let (p, q) = (value.numer().magnitude(), value.denom().magnitude());
    // 66 quotient bits: 53 for the result, the rest and a sticky bit decide the rounding.
    let shift = 66 - (p.bits() as i64 - q.bits() as i64);
    let (n, d) = if shift >= 0 { (p << shift as u64, q.clone()) } else { (p.clone(), q << (-shift) as u64) };
    let quotient = &n / &d;
    let sticky = !(&n - &quotient * &d).is_zero();
    let mut bits = quotient.to_u128().unwrap_or(0) << 1 | u128::from(sticky);
    let mut exponent = -shift - 1;
    let length = 128 - i64::from(bits.leading_zeros());
    // Subnormal results keep fewer bits, so that the one rounding happens at the right place.
    let kept = (length + exponent + 1074).clamp(0, 53);
    let drop = length - kept;
    if drop > 0 {
        let drop = drop.min(127) as u32;
        let (rest, half) = (bits & ((1 << drop) - 1), 1u128 << (drop - 1));
        bits >>= drop;
        exponent += i64::from(drop);
        if rest > half || (rest == half && bits & 1 == 1) {
            bits += 1;
        }
    }
    let magnitude = if exponent > 1100 {
        f64::INFINITY
    } else {
        // `bits` has at most 54 bits and the product is exact: the rounding is done.
        let exponent = exponent.max(-1200) as i32;
        let half = exponent / 2;
        bits as f64 * 2f64.powi(half) * 2f64.powi(exponent - half)
    };
    if value.is_negative() { -magnitude } else { magnitude }
}

impl From<BigRational> for Number {
    fn from(value: BigRational) -> Self {
        Self { value, decimal: false }
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        // Fractions are always reduced.
        self.value.numer() == other.value.numer() && self.value.denom() == other.value.denom()
    }
}

impl Eq for Number {}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Number {
    fn cmp(&self, other: &Self) -> Ordering {
        match (self.small(), other.small()) {
            (Some((p, q)), Some((n, m))) => (p * m).cmp(&(n * q)),
            _ => self.value.cmp(&other.value),
        }
    }
}

impl Hash for Number {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.value.numer().hash(state);
        self.value.denom().hash(state);
    }
}

/// p/q ± n/m in machine words, by the sign of the second.
fn small_sum(one: &Number, other: &Number, sign: i128) -> Option<BigRational> {
    one.small().zip(other.small()).map(|((p, q), (n, m))| fraction(p * m + sign * n * q, q * m))
}

/// p/q ± n/m for numbers of many words: only the common divisor of the denominators can be common to the sum.
fn long_sum(one: &Number, other: &Number, subtract: bool) -> BigRational {
    if !charge(one, other) {
        return BigRational::zero();
    }
    let ((p, q), (n, m)) = (parts(one), parts(other));
    let combined = |left: BigInt, right: BigInt| if subtract { left - right } else { left + right };
    let common = common_divisor(q, m);
    if common.is_one() {
        return BigRational::new_raw(combined(p * m, n * q), q * m);
    }
    let (own, others) = (q / &common, m / &common);
    let sum = combined(p * &others, n * &own);
    if sum.is_zero() {
        return BigRational::zero();
    }
    let rest = common_divisor(&sum, &common);
    BigRational::new_raw(sum / &rest, own * (m / &rest))
}

/// p/q · n/m for numbers of many words, reduced before they are multiplied.
fn long_product(one: &Number, other: &Number) -> BigRational {
    if !charge(one, other) || one.is_zero() || other.is_zero() {
        return BigRational::zero();
    }
    let ((p, q), (n, m)) = (parts(one), parts(other));
    let (first, second) = (common_divisor(p, m), common_divisor(n, q));
    BigRational::new_raw((p / &first) * (n / &second), (q / &second) * (m / &first))
}

fn parts(own: &Number) -> (&BigInt, &BigInt) {
    (own.value.numer(), own.value.denom())
}

/// Counts the work of an operation on numbers of many words; false if the budget is used up.
fn charge(one: &Number, other: &Number) -> bool {
    let words = 1 + (one.bits() + other.bits()) / 64;
    work::spend(120 + words + words * words / 16);
    !work::is_exhausted()
}

impl Add for &Number {
    type Output = Number;
    fn add(self, other: Self) -> Number {
        let small = small_sum(self, other, 1);
        Number::computed(small.unwrap_or_else(|| long_sum(self, other, false)), self.decimal || other.decimal)
    }
}

impl Sub for &Number {
    type Output = Number;
    fn sub(self, other: Self) -> Number {
        let small = small_sum(self, other, -1);
        Number::computed(small.unwrap_or_else(|| long_sum(self, other, true)), self.decimal || other.decimal)
    }
}

impl Mul for &Number {
    type Output = Number;
    fn mul(self, other: Self) -> Number {
        let small = self.small().zip(other.small()).map(|((p, q), (n, m))| fraction(p * n, q * m));
        Number::computed(small.unwrap_or_else(|| long_product(self, other)), self.decimal || other.decimal)
    }
}

impl Neg for &Number {
    type Output = Number;
    fn neg(self) -> Number {
        Number { value: -&self.value, decimal: self.decimal }
    }
}
