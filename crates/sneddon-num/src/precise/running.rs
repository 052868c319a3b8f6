//! Running error analysis with about 30 digits: arithmetic on numbers that carry a bound on their error.

use super::{finite, frexp, ldexp, pow, sqrt};
use crate::Bounded;
use crate::double_double::{DoubleDouble, Precise};

/// Relative rounding errors in units of 2^-104: proven bounds of Joldes, Muller and Popescu 2017 (sum 3, product 7,
/// quotient 15 units of 2^-106) and Lefèvre et al. 2023 (root 3.2 of them), rounded up.
const SUM: f64 = 1.0;
const PRODUCT: f64 = 2.0;
const QUOTIENT: f64 = 4.0;
const ROOT: f64 = 1.0;
/// 2^-104.
const UNIT: f64 = f64::EPSILON * f64::EPSILON;
/// More than the low words of one operation lose by underflow.
const UNDERFLOW: f64 = 64.0 * f64::from_bits(1);
/// Products of numbers within these sizes lose nothing by underflow.
const SMALL: f64 = 1e-130;
const LARGE: f64 = 1e130;

#[allow(clippy::should_implement_trait)]
impl Precise {
    /// An exact number.
    #[must_use]
    pub fn exact(value: f64) -> Self {
        Self { value: value.into(), error: 0.0 }
    }

    /// `value` with the given error; restores the rules for NaN and infinity.
    #[must_use]
    pub fn checked(value: DoubleDouble, error: f64) -> Self {
        let value = finite(value);
        if value.hi.is_nan() {
            return Self::nan();
        }
        let unknown = error.is_nan() || value.hi.is_infinite();
        Self { value, error: if unknown { f64::INFINITY } else { error * (1.0 + 32.0 * f64::EPSILON) } }
    }

    /// The nearest double; the remainder is added to the error.
    ///
    /// ```
    /// use sneddon_num::Precise;
    /// let third = Precise::exact(1.0).div(Precise::exact(3.0));
    /// let rounded = third.bounded();
    /// assert!(rounded.value == 1.0 / 3.0 && rounded.error < 1.9e-17 && third.error < 1e-31);
    /// ```
    #[must_use]
    pub fn bounded(self) -> Bounded {
        let error = self.error + self.value.lo.abs();
        Bounded::checked(self.value.hi, error * (1.0 + 4.0 * f64::EPSILON))
    }

    /// Whether both the value and its bound are numbers.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.value.hi.is_finite() && self.error.is_finite()
    }

    fn is_exact_zero(self) -> bool {
        self.value.hi == 0.0 && self.error == 0.0
    }

    fn size(self) -> f64 {
        self.value.hi.abs() * (1.0 + f64::EPSILON)
    }

    /// a + b.
    #[must_use]
    pub fn add(self, other: Self) -> Self {
        if other.is_exact_zero() {
            return self;
        }
        if self.is_exact_zero() {
            return other;
        }
        let value = self.value.add(other.value);
        Self::checked(value, self.error + other.error + SUM * UNIT * value.hi.abs())
    }

    /// a − b.
    #[must_use]
    pub fn sub(self, other: Self) -> Self {
        self.add(other.neg())
    }

    /// −a.
    #[must_use]
    pub fn neg(self) -> Self {
        Self { value: self.value.neg(), error: self.error }
    }

    /// a·b.
    #[must_use]
    pub fn mul(self, other: Self) -> Self {
        if self.is_exact_zero() && other.is_finite() || other.is_exact_zero() && self.is_finite() {
            return Self::exact(0.0);
        }
        let value = product(self.value, other.value);
        let carried = self.size() * other.error + other.size() * self.error + self.error * other.error;
        Self::checked(value, carried + PRODUCT * UNIT * value.hi.abs() + UNDERFLOW)
    }

    /// a/b.
    #[must_use]
    pub fn div(self, other: Self) -> Self {
        let least = other.value.hi.abs() * (1.0 - f64::EPSILON) - other.error;
        if self.is_exact_zero() && least > 0.0 {
            return Self::exact(0.0);
        }
        let value = quotient(self.value, other.value);
        if least.is_nan() || least <= 0.0 {
            return Self::checked(value, f64::INFINITY);
        }
        let rounding = QUOTIENT * UNIT * value.hi.abs() + UNDERFLOW;
        let carried = (self.error + (value.hi.abs() * (1.0 + f64::EPSILON) + rounding) * other.error) / least;
        Self::checked(value, carried + rounding)
    }

    /// √a; a slightly negative value whose error reaches 0 counts as 0, as for [`Bounded::sqrt`].
    #[must_use]
    pub fn sqrt(self) -> Self {
        let most = self.value.hi + self.error;
        if self.value.hi < 0.0 {
            return if most >= 0.0 { Self::checked(0.0.into(), most.sqrt()) } else { Self::nan() };
        }
        let value = sqrt(self.value);
        let rounding = ROOT * UNIT * value.hi;
        if self.error == 0.0 {
            return Self::checked(value, rounding);
        }
        let least = self.value.hi * (1.0 - f64::EPSILON) - self.error;
        let carried = if least >= 0.0 { self.error / (least.sqrt() + value.hi * (1.0 - f64::EPSILON)) } else { most.sqrt() };
        Self::checked(value, carried + rounding)
    }

    /// base^exponent; the domain is the same as for [`Bounded::powf`].
    #[must_use]
    pub fn pow(self, exponent: Self) -> Self {
        let whole = exponent.error == 0.0 && exponent.value.lo == 0.0 && exponent.value.hi.fract() == 0.0;
        if self.error == 0.0 && exponent.error == 0.0 {
            let own = pow(self.value, exponent.value);
            // A power that underflows is an inexact 0.
            let lost = if own.value.hi == 0.0 && self.value.hi != 0.0 { UNDERFLOW } else { 0.0 };
            return Self::checked(own.value, own.error + lost);
        }
        let size = self.size();
        let least = size * (1.0 - 2.0 * f64::EPSILON) - self.error;
        if least <= 0.0 || (self.value.hi < 0.0 && !whole) {
            // The base may be 0: the value lies between 0 and the value at the far end.
            let most = Bounded { value: 0.0, error: size + self.error };
            let reach = most.powf(exponent.bounded());
            let inside = least <= 0.0 && reach.is_finite() && exponent.value.hi > 0.0;
            return if inside { Self::checked(0.0.into(), reach.error) } else { Self::nan() };
        }
        let own = pow(self.value, exponent.value);
        let own = Self { error: own.error + if own.value.hi == 0.0 { UNDERFLOW } else { 0.0 }, ..own };
        let stretch = self.error / least;
        let log_size = if exponent.error == 0.0 { 0.0 } else { size.ln().abs() + stretch + f64::EPSILON };
        let shift = exponent.size() * stretch + exponent.error * log_size;
        let carried = (own.value.hi.abs() * (1.0 + f64::EPSILON) + own.error) * shift.exp_m1();
        Self::checked(own.value, carried * (1.0 + 8.0 * f64::EPSILON) + own.error)
    }
}

/// a·b, on mantissas where the sizes would lose the low words.
fn product(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble {
    if usual(a) && usual(b) {
        return a.mul(b);
    }
    if special(a) || special(b) {
        return (a.hi * b.hi).into();
    }
    let ((a, shift), (b, other)) = (frexp(a), frexp(b));
    ldexp(a.mul(b), shift + other)
}

/// a/b, likewise.
fn quotient(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble {
    if usual(a) && usual(b) {
        return a.div(b);
    }
    if special(a) || special(b) {
        return (a.hi / b.hi).into();
    }
    let ((a, shift), (b, other)) = (frexp(a), frexp(b));
    ldexp(a.div(b), shift - other)
}

fn usual(z: DoubleDouble) -> bool {
    (SMALL..LARGE).contains(&z.hi.abs())
}

/// Zeros, infinities and NaN follow the rules of doubles.
fn special(z: DoubleDouble) -> bool {
    z.hi == 0.0 || !z.hi.is_finite()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_near_the_ends_of_the_range_keep_their_digits() {
        let third = Precise::exact(1.0).div(Precise::exact(3.0));
        for size in [1e-270, 1e-200, 1e200, 1e300] {
            let back = third.mul(Precise::exact(size)).div(Precise::exact(size)).sub(third);
            assert!(back.value.hi.abs() <= back.error && back.error < 1e-29, "{size}: {back:?}");
            let root = Precise::exact(size).sqrt();
            let back = root.mul(root).div(Precise::exact(size)).sub(Precise::exact(1.0));
            assert!(back.value.hi.abs() <= back.error && back.error < 1e-30, "{size}: {back:?}");
        }
    }

    #[test]
    fn nothing_is_promised_where_a_divisor_or_a_base_may_be_zero() {
        let doubtful = Precise::checked(1e-30.into(), 2e-30);
        assert!(!Precise::exact(1.0).div(doubtful).error.is_finite());
        assert!(!doubtful.pow(Precise::exact(-0.5)).error.is_finite());
        let root = doubtful.sqrt();
        assert!(root.error >= 1e-15 && root.error < 3e-15);
        let power = doubtful.pow(Precise::exact(1.5));
        assert!(power.error >= 5e-45 && power.error < 1e-44);
        assert_eq!(doubtful.mul(Precise::exact(0.0)).error, 0.0);
        assert!(!Precise::exact(1e308).add(Precise::exact(1e308)).is_finite());
    }

    #[test]
    fn errors_of_arguments_grow_through_powers() {
        let base = Precise::checked(2.0.into(), 1e-25);
        let cube = base.pow(Precise::exact(3.0));
        assert!(cube.error >= 1.2e-24 && cube.error < 1.3e-24);
        let exponent = Precise::exact(2.0).pow(Precise::checked(0.5.into(), 1e-20));
        assert!(exponent.error > 9.8e-21 && exponent.error < 1e-20);
    }
}
