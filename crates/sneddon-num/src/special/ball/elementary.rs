//! Elementary functions of balls: exponential, logarithm, sine and cosine.

use crate::special::ball::{Ball, UNIT};
use crate::{DoubleDouble, precise};

pub(crate) const LN_2: Ball = Ball { value: precise::LN_2, error: 1e-32 };
pub(crate) const PI: Ball = Ball { value: precise::PI, error: 4e-32 };

impl Ball {
    /// The error of an elementary function, and the propagated uncertainty of its argument.
    fn elementary(value: DoubleDouble, carried: f64) -> Self {
        Self { value, error: carried + value.hi.abs() * OWN }
    }

    /// e^self; nothing is known beyond the range in which products keep both words.
    pub(crate) fn exp(self) -> Self {
        if self.value.hi.is_nan() || self.value.hi > 700.0 || self.error.is_nan() {
            return Self::NONE;
        }
        if self.value.hi < -700.0 {
            return Self { value: 0.0.into(), error: 1e-300 };
        }
        let value = precise::exp(self.value);
        Self::elementary(value, value.hi * self.error.exp_m1())
    }

    /// Natural logarithm of a positive number.
    pub(crate) fn ln(self) -> Self {
        if !(self.value.hi > self.error && self.value.hi.is_finite()) {
            return Self::NONE;
        }
        Self::elementary(precise::ln(self.value), self.error / (self.value.hi - self.error))
    }

    /// ln(1 + self), accurate also for small arguments.
    pub(crate) fn ln_1p(self) -> Self {
        let room = 1.0 + self.value.hi - self.error;
        if !(room > 0.0 && self.value.hi.is_finite()) {
            return Self::NONE;
        }
        Self::elementary(precise::ln1p(self.value), self.error / room)
    }

    /// Sine and cosine.
    pub(crate) fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = precise::sin_cos(self.value);
        (Self::elementary(sine, self.error), Self::elementary(cosine, self.error))
    }
}

/// Relative error of an elementary function, above what `tests/symbols/precise.rs` measures.
const OWN: f64 = 2.0 * UNIT;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponential_and_logarithm_are_inverse() {
        for x in [-600.0, -30.0, -1.3, -1e-9, 0.0, 1e-20, 0.4, 3.0, 88.0, 600.0] {
            let back = Ball::from(x).exp().ln() - x;
            assert!(back.value.hi.abs() <= back.error && back.error < 1e-26, "{x}: {back:?}");
            if x.abs() < 1.0 {
                let twice = (Ball::from(x).ln_1p().exp() - 1.0) - x;
                assert!(twice.value.hi.abs() <= twice.error && twice.error < 1e-29, "{x}: {twice:?}");
            }
        }
    }
}
