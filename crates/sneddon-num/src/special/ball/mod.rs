//! Ball arithmetic: double-double numbers that carry a bound of their error through every operation.

pub(crate) mod elementary;

use crate::{DoubleDouble, Precise};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value of about 106 bits and a bound of |value − true|.
///
/// Every operation adds what it loses itself, at most [`UNIT`] relative, so the bound of a long computation needs no
/// analysis; it is some ten times too wide. An infinite or NaN bound means that nothing is known.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ball {
    pub(crate) value: DoubleDouble,
    pub(crate) error: f64,
}

/// Largest relative bound with which a value counts as a double: at most 2 ulp, and half a one for rounding.
pub(crate) const ENOUGH: f64 = 2.2e-16;

/// Relative loss of one double-double operation, 2⁻¹⁰², as `DoubleDouble` promises.
pub(crate) const UNIT: f64 = 1.0 / (1_u128 << 102) as f64;
/// The error of a product below the normal range.
const TINY: f64 = 1e-322;

impl Ball {
    pub(crate) const ZERO: Self = Self { value: DoubleDouble { hi: 0.0, lo: 0.0 }, error: 0.0 };
    pub(crate) const ONE: Self = Self { value: DoubleDouble::ONE, error: 0.0 };
    /// Nothing is known.
    pub(crate) const NONE: Self = Self { value: DoubleDouble { hi: f64::NAN, lo: 0.0 }, error: f64::INFINITY };

    /// A number without error.
    pub(crate) fn exact(value: DoubleDouble) -> Self {
        Self { value, error: 0.0 }
    }

    /// The nearest double.
    pub(crate) fn hi(self) -> f64 {
        self.value.hi
    }

    /// The bound relative to the value; infinite at 0.
    pub(crate) fn relative(self) -> f64 {
        if self.value.hi.is_finite() && !self.error.is_nan() { self.error / self.value.hi.abs() } else { f64::INFINITY }
    }

    /// The same with more doubt.
    pub(crate) fn widened(self, by: f64) -> Self {
        Self { value: self.value, error: self.error + by }
    }

    /// The one with the smaller bound.
    pub(crate) fn better(self, other: Self) -> Self {
        let known = |ball: Self| if ball.value.hi.is_finite() && !ball.error.is_nan() { ball.error } else { f64::INFINITY };
        if known(other) < known(self) { other } else { self }
    }

    /// Exactly this number.
    pub(crate) fn is(self, number: f64) -> bool {
        self.value.hi == number && self.value.lo == 0.0 && self.error == 0.0
    }

    /// Product by a power of two, exact while nothing underflows.
    pub(crate) fn scale(self, power_of_two: f64) -> Self {
        Self { value: self.value.scale(power_of_two), error: self.error * power_of_two + TINY }
    }

    /// Absolute value.
    pub(crate) fn abs(self) -> Self {
        if self.value.hi < 0.0 { -self } else { self }
    }

    pub(crate) fn square(self) -> Self {
        self * self
    }

    /// 1/self.
    pub(crate) fn recip(self) -> Self {
        Self::ONE / self
    }

    /// Square root of a non-negative number.
    pub(crate) fn sqrt(self) -> Self {
        if self.value.hi == 0.0 {
            return Self { value: self.value, error: self.error.sqrt() };
        }
        let value = self.value.sqrt();
        Self { value, error: self.error / value.hi + value.hi * UNIT }
    }

    /// A whole power, by squaring.
    pub(crate) fn powi(self, n: u32) -> Self {
        let (mut result, mut square, mut left) = (Self::ONE, self, n);
        while left > 0 {
            if left & 1 == 1 {
                result = result * square;
            }
            left >>= 1;
            if left > 0 {
                square = square.square();
            }
        }
        result
    }

    /// `self^exponent` for a positive base.
    pub(crate) fn pow(self, exponent: Self) -> Self {
        if exponent.value.hi == 0.0 && exponent.error == 0.0 {
            return Self::ONE;
        }
        (self.ln() * exponent).exp()
    }

    /// The value rounded to a double, or NaN where the bound exceeds `tolerance`, relative.
    pub(crate) fn rounded(self, tolerance: f64) -> f64 {
        if self.relative() <= tolerance || (self.value.hi == 0.0 && self.error < 1e-300) { self.value.value() } else { f64::NAN }
    }

    /// For a function row.
    pub(crate) fn precise(self) -> Precise {
        if self.error.is_nan() || !self.value.hi.is_finite() {
            return Precise { value: self.value, error: f64::INFINITY };
        }
        Precise { value: self.value, error: self.error }
    }
}

impl From<f64> for Ball {
    fn from(value: f64) -> Self {
        Self { value: value.into(), error: 0.0 }
    }
}

impl Add for Ball {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let value = self.value.add(other.value);
        // The sum of two doubles is exact.
        let own = if self.value.lo == 0.0 && other.value.lo == 0.0 { 0.0 } else { value.hi.abs() * UNIT };
        Self { value, error: self.error + other.error + own }
    }
}

impl Sub for Ball {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Ball {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: self.value.neg(), error: self.error }
    }
}

impl Mul for Ball {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let value = self.value.mul(other.value);
        let carried = self.value.hi.abs() * other.error + other.value.hi.abs() * self.error + self.error * other.error;
        // So is the product.
        let own = if self.value.lo == 0.0 && other.value.lo == 0.0 { 0.0 } else { value.hi.abs() * UNIT };
        Self { value, error: carried + own + TINY }
    }
}

impl Div for Ball {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value.div(other.value);
        let room = other.value.hi.abs() - other.error;
        if room.is_nan() || room <= 0.0 {
            return Self::NONE;
        }
        let carried = (self.error + value.hi.abs() * other.error + TINY) / room;
        Self { value, error: carried + value.hi.abs() * UNIT }
    }
}

impl Add<f64> for Ball {
    type Output = Self;
    fn add(self, other: f64) -> Self {
        self + Self::from(other)
    }
}

impl Sub<f64> for Ball {
    type Output = Self;
    fn sub(self, other: f64) -> Self {
        self + Self::from(-other)
    }
}

impl Mul<f64> for Ball {
    type Output = Self;
    fn mul(self, other: f64) -> Self {
        self * Self::from(other)
    }
}

impl Div<f64> for Ball {
    type Output = Self;
    fn div(self, other: f64) -> Self {
        self / Self::from(other)
    }
}
