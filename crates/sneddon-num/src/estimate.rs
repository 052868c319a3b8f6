//! A value together with a bound on its error and the work it cost.

use super::bounded::Bounded;

/// The kind of error bound of a number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Bound {
    /// It follows from IEEE arithmetic and the stated bounds of the functions that were computed.
    #[default]
    Proven,
    /// It rests on values at some places: a narrow feature between them may have been missed.
    Estimated,
}

impl Bound {
    /// The kind of bound of a number computed from two others.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        self.max(other)
    }

    /// `proven` or `estimated`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Proven => "proven",
            Self::Estimated => "estimated",
        }
    }
}

/// A computed number, an absolute bound on its distance to the true one, what the bound rests on, and the number of
/// function evaluations spent on it.
///
/// ```
/// use sneddon_num::{Bound, Bounded, Estimate};
/// let half = Estimate::estimated(0.5, 1e-16, 21);
/// let sum = half + half.scaled(2.0);
/// assert_eq!((sum.value, sum.evaluations), (1.5, 42));
/// assert!(sum.error >= 3e-16);
/// // A sum is proven where both of its parts are.
/// let exact = Estimate::from_bounded(Bounded::exact(1.0), 0);
/// assert_eq!((exact.bound, (exact + sum).bound), (Bound::Proven, Bound::Estimated));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The computed value.
    pub value: f64,
    /// Absolute bound on |value − true|; never negative, infinite where nothing is promised.
    pub error: f64,
    /// Calls of the user's function that the value cost.
    pub evaluations: u64,
    /// Whether the error is proven or rests on samples.
    pub bound: Bound,
    /// The key of the way that found the number; empty where nothing was computed, [`Self::SEVERAL`] where parts were found in different ways.
    pub way: &'static str,
}

impl Estimate {
    /// A proven error of at most this share of the value is better than any estimated one, however small the other claims to be: samples
    /// may miss what enclosures see.
    pub const TRUSTED: f64 = 1e-3;
    /// The way of a number whose parts were found in different ways.
    pub const SEVERAL: &'static str = "mixed";

    /// A number that is what it is said to be.
    #[must_use]
    pub fn exact(value: f64) -> Self {
        Self { value, error: 0.0, evaluations: 0, bound: Bound::Proven, way: "" }
    }

    /// A number whose error was judged by samples.
    #[must_use]
    pub fn estimated(value: f64, error: f64, evaluations: u64) -> Self {
        Self { value, error, evaluations, bound: Bound::Estimated, way: "" }
    }

    /// A proven number that cost `evaluations` calls, from an error-carrying number.
    #[must_use]
    pub fn from_bounded(number: Bounded, evaluations: u64) -> Self {
        Self { value: number.value, error: number.error, evaluations, bound: Bound::Proven, way: "" }
    }

    /// The same number, found in the way of this key.
    #[must_use]
    pub fn by(self, way: &'static str) -> Self {
        Self { way, ..self }
    }

    /// The same number without the count of evaluations and without what its error rests on, for further arithmetic.
    #[must_use]
    pub fn bounded(self) -> Bounded {
        Bounded { value: self.value, error: self.error }
    }

    /// The same number, computed from something with that bound too.
    #[must_use]
    pub fn resting_on(self, bound: Bound) -> Self {
        Self { bound: self.bound.and(bound), ..self }
    }

    /// The estimate of the true value times `factor`, which may have an error; evaluations and bound stay.
    #[must_use]
    pub fn times(self, factor: Bounded) -> Self {
        let Bounded { value, error } = self.bounded() * factor;
        Self { value, error, ..self }
    }

    /// The estimate of `factor` · true value, `factor` taken as exact. The count of evaluations stays.
    #[must_use]
    #[inline]
    pub fn scaled(self, factor: f64) -> Self {
        let value = self.value * factor;
        // The usual case: nothing is exact, nothing under- or overflows.
        let error = (self.error * factor.abs() + 0.5 * f64::EPSILON * value.abs()) * (1.0 + 4.0 * f64::EPSILON);
        if value.is_normal() && error.is_normal() && self.error > 0.0 {
            return Self { value, error, ..self };
        }
        self.times(Bounded::exact(factor))
    }

    /// Whether this is the better answer to the question that `other` answers too.
    ///
    /// Of two numbers whose errors rest on the same ground the smaller error is better.
    /// A proven error of at most [`Self::TRUSTED`] of the value, or one that shows that the estimate is wrong, is better than any estimated one.
    /// An estimate whose value or error is NaN is never the better one, and any other estimate is better than it.
    ///
    /// ```
    /// use sneddon_num::{Bound, Estimate};
    /// let proven = Estimate { error: 1e-10, ..Estimate::exact(1.0) };
    /// assert!(proven.is_better_than(Estimate::estimated(1.1, 1e-15, 21)));
    /// let rough = Estimate { error: 1e-2, ..proven };
    /// assert!(Estimate::estimated(1.0001, 1e-15, 21).is_better_than(rough));
    /// assert!(rough.is_better_than(Estimate::estimated(1.1, 1e-15, 21)));
    /// let not_a_number = Estimate::estimated(f64::NAN, f64::NAN, 21);
    /// assert!(rough.is_better_than(not_a_number) && !not_a_number.is_better_than(not_a_number));
    /// ```
    #[must_use]
    pub fn is_better_than(self, other: Self) -> bool {
        let is_number = |own: Self| !own.value.is_nan() && !own.error.is_nan();
        if !(is_number(self) && is_number(other)) {
            return is_number(self);
        }
        let wins = |proven: Self, estimated: Self| {
            proven.relative_error() <= Self::TRUSTED
                || proven.error <= estimated.error
                || (proven.value - estimated.value).abs() > proven.error
        };
        match (self.bound, other.bound) {
            (Bound::Proven, Bound::Estimated) if self.error.is_finite() => wins(self, other),
            (Bound::Estimated, Bound::Proven) if other.error.is_finite() => !wins(other, self),
            _ => self.error < other.error,
        }
    }

    /// This proven number with the value of an estimate that lies within its error and claims a smaller one; else this number.
    ///
    /// The error grows by the distance of both values, so that it stays proven.
    #[must_use]
    pub fn sharpened_by(self, other: Self) -> Self {
        let distance = (self.value - other.value).abs();
        if self.bound == Bound::Proven && other.bound == Bound::Estimated && other.error < self.error && distance <= self.error {
            Self { value: other.value, error: (self.error + distance).next_up(), ..self }
        } else {
            self
        }
    }

    /// Returns true if the relative error is at most the tolerance; false for NaN.
    #[must_use]
    #[inline]
    pub fn meets(self, tolerance: f64) -> bool {
        self.relative_error() <= tolerance
    }

    /// error / |value|: 0 for an exact value (zero included), infinite for an inexact zero.
    ///
    /// ```
    /// use sneddon_num::Estimate;
    /// assert_eq!(Estimate::estimated(-4.0, 1.0, 1).relative_error(), 0.25);
    /// assert_eq!(Estimate::exact(0.0).relative_error(), 0.0);
    /// ```
    #[must_use]
    pub fn relative_error(self) -> f64 {
        if self.error == 0.0 { 0.0 } else { self.error / self.value.abs() }
    }
}

impl std::ops::Add for Estimate {
    type Output = Self;

    /// The sum of two independent estimates: errors and evaluations add up, and it is proven where both are.
    fn add(self, other: Self) -> Self {
        let Bounded { value, error } = self.bounded() + other.bounded();
        let way = match (self.way, other.way) {
            (own, "") => own,
            ("", own) => own,
            (own, next) => {
                if own == next {
                    own
                } else {
                    Self::SEVERAL
                }
            }
        };
        let evaluations = self.evaluations.saturating_add(other.evaluations);
        Self { value, error, evaluations, bound: self.bound.and(other.bound), way }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn adding_counts_the_rounding_of_the_sum() {
        let tiny = Estimate { evaluations: 1, ..Estimate::exact(1e-20) };
        let one = Estimate { evaluations: 2, ..Estimate::exact(1.0) };
        let sum = one + tiny;
        assert_eq!(sum.value, 1.0);
        assert!(sum.error >= 1e-20 && sum.error < 1e-15);
        assert_eq!(sum.evaluations, 3);
    }

    #[test]
    fn relative_error_of_an_inexact_zero_is_infinite() {
        let zero = Estimate::estimated(0.0, 1e-300, 0);
        assert_eq!(zero.relative_error(), f64::INFINITY);
    }
}
