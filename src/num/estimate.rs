//! A value together with a bound on its error and the work it cost.

use super::bounded::Bounded;

/// A computed number, an absolute bound on its distance to the true one, and the number of
/// function evaluations spent on it.
///
/// ```
/// use sneddon::num::Estimate;
/// let half = Estimate { value: 0.5, error: 1e-16, evaluations: 21 };
/// let sum = half + half.scaled(2.0);
/// assert_eq!(sum.value, 1.5);
/// assert!(sum.error >= 3e-16);
/// assert_eq!(sum.evaluations, 42);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The computed value.
    pub value: f64,
    /// Absolute bound on |value − true|; never negative, infinite where nothing is promised.
    pub error: f64,
    /// Calls of the user's function that the value cost.
    pub evaluations: u64,
}

impl Estimate {
    /// An estimate that cost `evaluations` calls, from an error-carrying number.
    #[must_use]
    pub fn from_bounded(number: Bounded, evaluations: u64) -> Self {
        Self { value: number.value, error: number.error, evaluations }
    }

    /// The same number without the count of evaluations, for further arithmetic.
    #[must_use]
    pub fn bounded(self) -> Bounded {
        Bounded { value: self.value, error: self.error }
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
        Self::from_bounded(self.bounded() * Bounded::exact(factor), self.evaluations)
    }

    /// error / |value|: 0 for an exact value (zero included), infinite for an inexact zero.
    ///
    /// ```
    /// use sneddon::num::Estimate;
    /// assert_eq!(Estimate { value: -4.0, error: 1.0, evaluations: 1 }.relative_error(), 0.25);
    /// assert_eq!(Estimate { value: 0.0, error: 0.0, evaluations: 1 }.relative_error(), 0.0);
    /// ```
    #[must_use]
    pub fn relative_error(self) -> f64 {
        if self.error == 0.0 { 0.0 } else { self.error / self.value.abs() }
    }
}

impl std::ops::Add for Estimate {
    type Output = Self;

    /// The sum of two independent estimates: errors and evaluations add up.
    fn add(self, other: Self) -> Self {
        Self::from_bounded(self.bounded() + other.bounded(), self.evaluations.saturating_add(other.evaluations))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn adding_counts_the_rounding_of_the_sum() {
        let tiny = Estimate { value: 1e-20, error: 0.0, evaluations: 1 };
        let one = Estimate { value: 1.0, error: 0.0, evaluations: 2 };
        let sum = one + tiny;
        assert_eq!(sum.value, 1.0);
        assert!(sum.error >= 1e-20 && sum.error < 1e-15);
        assert_eq!(sum.evaluations, 3);
    }

    #[test]
    fn relative_error_of_an_inexact_zero_is_infinite() {
        let zero = Estimate { value: 0.0, error: 1e-300, evaluations: 0 };
        assert_eq!(zero.relative_error(), f64::INFINITY);
    }
}
