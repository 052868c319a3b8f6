//! Numbers with 30 digits whose exponent cannot overflow, for formulas whose intermediate results leave the range of doubles.

use super::double_double::{DoubleDouble, Precise};
use super::precise::{self, frexp, ldexp};

/// Relative rounding errors in units of 2^-104, as for [`Precise`].
const SUM: f64 = 1.0;
const PRODUCT: f64 = 2.0;
const QUOTIENT: f64 = 4.0;
const ROOT: f64 = 1.0;
const EXPONENTIAL: f64 = 8.0;
/// 2^-104.
const UNIT: f64 = f64::EPSILON * f64::EPSILON;
/// A term that is smaller than the other by this many binary digits contributes only to the error.
const FAR: i32 = 900;
/// Numbers with larger exponents become NaN; the sum of two exponents still fits into an `i32`.
const MAX_EXPONENT: i32 = 1 << 29;

/// value · 2^exponent with 1 ≤ |value| < 2 or value = 0, and error · 2^exponent bounds the distance to the true value.
///
/// ```
/// use sneddon_num::{Precise, Wide};
/// let large = Wide::new(Precise::exact(1e300));
/// let root = large.mul(large).add(large.mul(large)).sqrt();
/// assert!((root.precise().value.hi / 1e300 - 2f64.sqrt()).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Wide {
    value: DoubleDouble,
    exponent: i32,
    error: f64,
}

#[allow(clippy::should_implement_trait)]
impl Wide {
    /// A number in the range of doubles.
    #[must_use]
    pub fn new(number: Precise) -> Self {
        Self::scaled(number, 0)
    }

    /// number · 2^exponent.
    #[must_use]
    pub fn scaled(number: Precise, exponent: i32) -> Self {
        if !number.is_finite() || exponent.abs() > MAX_EXPONENT {
            return Self::nan();
        }
        if number.value.hi == 0.0 {
            if number.error == 0.0 {
                return Self { value: number.value, exponent: 0, error: 0.0 };
            }
            let (size, own) = frexp(number.error.into());
            return Self { value: number.value, exponent: exponent.saturating_add(own), error: size.hi };
        }
        let (value, own) = frexp(number.value);
        // Subnormal errors must not vanish.
        let error = ldexp(number.error.into(), -own).hi;
        let error = if number.error > 0.0 { error.max(f64::MIN_POSITIVE) } else { 0.0 };
        Self { value, exponent: exponent.saturating_add(own), error }
    }

    /// No value.
    #[must_use]
    pub fn nan() -> Self {
        Self { value: f64::NAN.into(), exponent: 0, error: f64::NAN }
    }

    /// The number within the range of doubles: infinite beyond it, a zero with an error below.
    #[must_use]
    pub fn precise(self) -> Precise {
        if !self.is_number() {
            return Precise::nan();
        }
        let shift = self.exponent.clamp(-2200, 2200);
        // Account for digits lost to subnormal numbers.
        let lost = if self.value.hi != 0.0 && self.exponent < -900 { 4.0 * f64::from_bits(1) } else { 0.0 };
        let error = ldexp(self.error.into(), shift).hi;
        let least = if self.error > 0.0 { f64::from_bits(1) } else { 0.0 };
        Precise::checked(ldexp(self.value, shift), error.max(least) + lost)
    }

    fn is_number(self) -> bool {
        self.value.hi.is_finite() && self.error.is_finite() && self.exponent.abs() <= MAX_EXPONENT
    }

    fn is_exact_zero(self) -> bool {
        self.value.hi == 0.0 && self.error == 0.0
    }

    /// The binary exponent.
    #[must_use]
    pub fn exponent(self) -> i32 {
        self.exponent
    }

    /// True for a value that is 0, exactly or within its error.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.value.hi == 0.0
    }

    /// True below 0.
    #[must_use]
    pub fn is_negative(self) -> bool {
        self.value.hi < 0.0
    }

    /// The number times 2^by, exactly.
    #[must_use]
    pub fn shifted(self, by: i32) -> Self {
        if self.is_exact_zero() { self } else { Self { exponent: self.exponent.saturating_add(by), ..self } }
    }

    /// The same value with a further relative error.
    #[must_use]
    pub fn within(self, relative: f64) -> Self {
        Self { error: (self.error + relative * self.value.hi.abs()) * (1.0 + f64::EPSILON), ..self }
    }

    /// −a.
    #[must_use]
    pub fn neg(self) -> Self {
        Self { value: self.value.neg(), ..self }
    }

    /// a + b.
    #[must_use]
    pub fn add(self, other: Self) -> Self {
        if self.is_exact_zero() {
            return other;
        }
        if other.is_exact_zero() {
            return self;
        }
        if !self.is_number() || !other.is_number() {
            return Self::nan();
        }
        let (large, small) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        let shift = small.exponent - large.exponent;
        let near = if shift < -FAR {
            // 2^-FAR is far below every digit, and covers the value and error of the small term unless its error is huge.
            if small.error > 1.0 {
                return Self::nan();
            }
            Precise { value: 0.0.into(), error: 4.0 * f64::MIN_POSITIVE.sqrt() * f64::EPSILON }
        } else {
            Precise { value: ldexp(small.value, shift), error: ldexp(small.error.into(), shift).hi + f64::MIN_POSITIVE }
        };
        let value = large.value.add(near.value);
        let error = large.error + near.error + SUM * UNIT * value.hi.abs();
        Self::scaled(Precise { value, error: error * (1.0 + 8.0 * f64::EPSILON) }, large.exponent)
    }

    /// a·b.
    #[must_use]
    pub fn mul(self, other: Self) -> Self {
        if self.is_exact_zero() && other.is_number() || other.is_exact_zero() && self.is_number() {
            return Self::new(Precise::exact(0.0));
        }
        if !self.is_number() || !other.is_number() {
            return Self::nan();
        }
        let value = self.value.mul(other.value);
        let carried = self.value.hi.abs() * other.error + other.value.hi.abs() * self.error + self.error * other.error;
        let error = (carried + PRODUCT * UNIT * value.hi.abs()) * (1.0 + 16.0 * f64::EPSILON);
        Self::scaled(Precise { value, error }, self.exponent + other.exponent)
    }

    /// a/b.
    #[must_use]
    pub fn div(self, other: Self) -> Self {
        let least = other.value.hi.abs() * (1.0 - f64::EPSILON) - other.error;
        if !self.is_number() || !other.is_number() || least <= 0.0 {
            return Self::nan();
        }
        if self.is_exact_zero() {
            return self;
        }
        let value = self.value.div(other.value);
        let rounding = QUOTIENT * UNIT * value.hi.abs();
        let carried = (self.error + (value.hi.abs() * (1.0 + f64::EPSILON) + rounding) * other.error) / least;
        let error = (carried + rounding) * (1.0 + 16.0 * f64::EPSILON);
        Self::scaled(Precise { value, error }, self.exponent - other.exponent)
    }

    /// √a.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if !self.is_number() || self.value.hi < 0.0 {
            return Self::nan();
        }
        let odd = self.exponent.rem_euclid(2);
        let inner = Precise { value: ldexp(self.value, odd), error: self.error * f64::from(1 + odd) };
        let root = inner.sqrt();
        Self::scaled(Precise { error: root.error + ROOT * UNIT * root.value.hi, ..root }, (self.exponent - odd) / 2)
    }

    /// ln a of a positive number.
    #[must_use]
    pub fn ln(self) -> Self {
        if !self.is_number() || self.value.hi - self.error <= 0.0 {
            return Self::nan();
        }
        let own = Precise::relative(precise::ln(self.value), EXPONENTIAL);
        let carried = self.error / (self.value.hi * (1.0 - f64::EPSILON) - self.error);
        let whole = ln_2().mul(Precise::exact(f64::from(self.exponent)));
        Self::new(Precise::checked(own.value, own.error + carried).add(whole))
    }

    /// e^a.
    #[must_use]
    pub fn exp(self) -> Self {
        if !self.is_number() {
            return Self::nan();
        }
        let own = if self.exponent < -FAR { Precise::checked(0.0.into(), f64::MIN_POSITIVE) } else { self.precise() };
        let steps = (own.value.hi / std::f64::consts::LN_2).round();
        if steps.is_nan() || steps.abs() > f64::from(MAX_EXPONENT) || own.error > 0.1 {
            return Self::nan();
        }
        let rest = own.sub(ln_2().mul(Precise::exact(steps)));
        let value = precise::exp(rest.value);
        let error = value.hi * (EXPONENTIAL * UNIT + rest.error.exp_m1() * (1.0 + 8.0 * f64::EPSILON));
        Self::scaled(Precise { value, error }, steps as i32)
    }

    /// a^b: by products for small whole b, else e^(b ln a).
    #[must_use]
    pub fn pow(self, exponent: Self) -> Self {
        let own = exponent.precise();
        let whole = own.error == 0.0 && own.value.lo == 0.0 && own.value.hi.fract() == 0.0;
        if whole && own.value.hi.abs() <= 64.0 {
            let mut power = Self::new(Precise::exact(1.0));
            for _ in 0..own.value.hi.abs() as u32 {
                power = power.mul(self);
            }
            return if own.value.hi < 0.0 { Self::new(Precise::exact(1.0)).div(power) } else { power };
        }
        if self.is_exact_zero() && own.value.hi - own.error > 0.0 {
            return self;
        }
        let negative = self.is_negative();
        if negative && !whole {
            return Self::nan();
        }
        let size = if negative { self.neg() } else { self };
        let power = exponent.mul(size.ln()).exp();
        if negative && own.value.hi.rem_euclid(2.0) == 1.0 { power.neg() } else { power }
    }
}

/// ln 2 with its error.
fn ln_2() -> Precise {
    Precise { value: precise::LN_2, error: 1e-33 }
}
