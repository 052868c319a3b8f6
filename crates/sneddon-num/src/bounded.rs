//! Running error analysis: numbers with an absolute error bound.

mod functions;
#[cfg(test)]
mod tests;

pub use functions::{is_far, reach_between};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A computed value and a bound on its distance to the value in exact arithmetic.
///
/// Every operation propagates the errors of its arguments and adds its rounding error.
/// The four operations and `sqrt` are rigorous; correlations between the arguments' errors are ignored,
/// so that x − x has a valid but wide bound.
/// NaN gives NaN with error NaN; overflow gives an infinite value. Callers turn both into errors.
/// After a certain overflow the error is finite: it bounds the reciprocal of the true value, which has the sign of the infinity.
/// Therefore 1/cosh 1000 is 0 with a finite error bound.
///
/// ```
/// use sneddon_num::Bounded;
/// let third = Bounded::exact(1.0) / Bounded::exact(3.0);
/// let rest = Bounded::exact(1.0) - third - third - third;
/// assert!(rest.value.abs() <= rest.error && rest.error < 1e-15);
/// assert_eq!((Bounded::exact(2.0) + Bounded::exact(3.0)).error, 0.0);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Bounded {
    /// The computed value.
    pub value: f64,
    /// Absolute bound on |value − true|.
    pub error: f64,
}

/// Half the spacing of the numbers just above 1: the relative rounding error of one operation.
pub const UNIT: f64 = f64::EPSILON / 2.0;
/// The smallest positive number, which bounds the error of an underflow.
const TINY: f64 = f64::from_bits(1);
/// Bounds on the reciprocal of an overflowing value are kept only below this.
const LEAST_INVERSE: f64 = 1e-280;
/// Below this the spacing no longer shrinks with the number.
const UNIFORM: f64 = 2.0 * f64::MIN_POSITIVE;

impl Bounded {
    /// The least error of a value that underflowed to zero in a block of numbers, 2^-1000.
    ///
    /// Most products with it do not underflow, and processors are slow with products that do.
    pub const VANISHED: f64 = f64::from_bits((1023 - 1000) << 52);

    /// An exact number.
    #[must_use]
    #[inline]
    pub const fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// A number that was correctly rounded to `value`: the error is half a unit in the last place.
    #[must_use]
    #[inline]
    pub fn rounded(value: f64) -> Self {
        Self::checked(value, half_ulp(value))
    }

    /// `value` with the given error; restores the rules for NaN and infinity.
    #[must_use]
    #[inline]
    pub fn checked(value: f64, error: f64) -> Self {
        if value.is_nan() {
            return Self { value, error: f64::NAN };
        }
        let unknown = error.is_nan() || value.is_infinite();
        Self { value, error: if unknown { f64::INFINITY } else { error } }
    }

    /// Whether both the value and its error bound are numbers.
    #[must_use]
    #[inline]
    pub fn is_finite(self) -> bool {
        self.value.is_finite() && self.error.is_finite()
    }

    /// Whether the value overflows for certain.
    #[inline]
    fn is_beyond(self) -> bool {
        self.value.is_infinite() && self.error.is_finite()
    }

    /// An overflow; its reciprocal is at most `inverse`, which counts only where it is small.
    fn beyond(value: f64, inverse: f64) -> Self {
        let error = if inverse < LEAST_INVERSE { widen_inexact(inverse) } else { f64::INFINITY };
        Self { value, error }
    }

    /// A bound on 1/|true value|; infinite if there is none.
    fn most_inverse(self) -> f64 {
        if self.is_beyond() {
            return self.error;
        }
        let least = self.value.abs() - self.error;
        if least > 0.0 { (1.0 / least) * (1.0 + 4.0 * UNIT) + TINY } else { f64::INFINITY }
    }

    /// The sum if one of the terms certainly overflows.
    fn plus_beyond(self, other: Self) -> Self {
        let value = self.value + other.value;
        let (large, other) = if self.is_beyond() { (self, other) } else { (other, self) };
        // At least half of the larger term remains if the other is at most half as large.
        let enough = other.value == large.value || (other.value.abs() + other.error) * large.error <= 0.5;
        Self::beyond(value, if enough { 2.0 * large.error } else { f64::INFINITY })
    }

    /// The sum of many terms, compensated: rounded as if summed with twice the digits.
    ///
    /// ```
    /// use sneddon_num::Bounded;
    /// let terms = [1e16, 1.0, -1e16].map(Bounded::exact);
    /// let sum = Bounded::sum(terms);
    /// assert_eq!(sum.value, 1.0);
    /// assert!(sum.error < 1e-14);
    /// ```
    #[must_use]
    pub fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        let (mut high, mut low, mut error, mut size, mut count) = (0.0, 0.0, 0.0, 0.0, 0.0);
        let mut every_step_exact = true;
        for term in terms {
            let (sum, rest) = two_sum(high, term.value);
            every_step_exact &= rest == 0.0;
            high = sum;
            low += rest;
            error += term.error;
            size += term.value.abs();
            count += 1.0;
        }
        if every_step_exact {
            return Self::checked(high, widen(error * (1.0 + count * UNIT)));
        }
        if !low.is_finite() {
            return Self::checked(high, f64::INFINITY);
        }
        // Ogita, Rump and Oishi (2005), proposition 4.5; the factor covers the roundings of `error`.
        let value = high + low;
        let second_order = (count * UNIT) * (count * UNIT) * size;
        let error = error * (1.0 + count * UNIT) + half_ulp(value) + 2.0 * second_order;
        Self::checked(value, widen(error))
    }
}

impl Add for Bounded {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        let (value, rest) = two_sum(self.value, other.value);
        // The rest is the rounding error itself; it is NaN only next to the overflow threshold.
        let rounding = if rest.is_nan() { half_ulp(value) } else { rest.abs() };
        if value.is_infinite() && (self.is_beyond() || other.is_beyond()) {
            return self.plus_beyond(other);
        }
        Self::checked(value, widen(self.error + other.error + rounding))
    }
}

impl Sub for Bounded {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Bounded {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, error: self.error }
    }
}

impl Mul for Bounded {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        if value.is_infinite() {
            return Self::beyond(value, self.most_inverse() * other.most_inverse());
        }
        let exact_zero = (self.value == 0.0 && self.error == 0.0) || (other.value == 0.0 && other.error == 0.0);
        if exact_zero && value == 0.0 {
            return Self::exact(value);
        }
        let scaling = is_power_of_two(self.value) || is_power_of_two(other.value);
        let rounding = if scaling && value.abs() >= f64::MIN_POSITIVE { 0.0 } else { half_ulp_of_zero_too(value) };
        if self.error == 0.0 && other.error == 0.0 {
            return Self::checked(value, rounding);
        }
        let carried = self.value.abs() * other.error + other.value.abs() * self.error + self.error * other.error;
        Self::checked(value, widen_inexact(carried + rounding))
    }
}

impl Div for Bounded {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        if other.is_beyond() && self.is_finite() {
            return Self { value: 0.0, error: widen_inexact((self.value.abs() + self.error) * other.error) };
        }
        if self.value == 0.0 && self.error == 0.0 && other.value.abs() > other.error {
            return Self::exact(value);
        }
        let scaling = is_power_of_two(other.value);
        let rounding = if scaling && value.abs() >= f64::MIN_POSITIVE { 0.0 } else { half_ulp_of_zero_too(value) };
        if self.error == 0.0 && other.error == 0.0 {
            return Self::checked(value, rounding);
        }
        let least = other.value.abs() - other.error;
        if least.is_nan() || least <= 0.0 {
            return Self::checked(value, f64::INFINITY);
        }
        // a/b changes by (δa − (a/b)·δb)/(b + δb).
        let carried = (self.error + (value.abs() + rounding) * other.error) / least;
        Self::checked(value, widen_inexact(carried + rounding))
    }
}

/// a + b rounded, and the exact rounding error (Knuth); NaN after overflow.
#[inline]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let from_b = sum - a;
    let from_a = sum - from_b;
    (sum, (a - from_a) + (b - from_b))
}

/// Bound on the rounding error of a correctly rounded sum, root or scaled value; 0 for 0.
#[inline]
fn half_ulp(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { half_ulp_of_zero_too(value) }
}

/// Bound on the rounding error of a product or quotient, which may be a zero by underflow.
#[inline]
fn half_ulp_of_zero_too(value: f64) -> f64 {
    if value.abs() < UNIFORM {
        return TINY;
    }
    // Only the exponent bits are kept: the power of two below |value|.
    f64::from_bits(value.to_bits() & 0x7ff0_0000_0000_0000) * UNIT
}

/// Whether multiplying by the value only shifts the exponent.
#[inline]
fn is_power_of_two(value: f64) -> bool {
    value.to_bits() & 0x000f_ffff_ffff_ffff == 0 && value.is_normal()
}

/// Enlarges an error bound by more than the few roundings made in computing it; 0 stays 0.
#[inline]
fn widen(error: f64) -> f64 {
    // Near the underflow threshold a relative margin rounds away.
    let margin = if error > 0.0 && error < f64::MIN_POSITIVE { 8.0 * TINY } else { 0.0 };
    error * (1.0 + 16.0 * UNIT) + margin
}

/// The same for a bound made of products, which may each have underflowed to zero.
#[inline]
fn widen_inexact(error: f64) -> f64 {
    if error < f64::MIN_POSITIVE { error + 8.0 * TINY } else { widen(error) }
}
