//! Unevaluated sums of two doubles: about 106 bits for places where one rounding would be multiplied.

/// A number `hi + lo` with `|lo| <= ulp(hi) / 2`.
///
/// Relative error of one operation: at most about `2^-102` for sum, product, quotient and square root of finite
/// numbers whose magnitudes lie in `[2^-480, 2^480]`; outside that range the splitting may overflow or lose the low
/// word, so callers scale by powers of two first.
/// Source: Dekker 1971, Knuth TAOCP 4.2.2.
///
/// ```
/// use sneddon_num::DoubleDouble;
/// let third = DoubleDouble::ONE.div(3.0.into());
/// assert!(third.mul(3.0.into()).sub(DoubleDouble::ONE).value().abs() < 1e-31);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DoubleDouble {
    /// The nearest double.
    pub hi: f64,
    /// The remainder beyond the nearest double.
    pub lo: f64,
}

/// `a + b` and its rounding error, exactly, for any order of magnitudes.
#[inline]
pub fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    let virtual_b = hi - a;
    let lo = (a - (hi - virtual_b)) + (b - virtual_b);
    DoubleDouble { hi, lo }
}

/// `a + b` and its rounding error, exactly, when `|a| >= |b|` or `a = 0`.
#[inline]
fn quick_two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    DoubleDouble { hi, lo: b - (hi - a) }
}

/// Halves of at most 26 bits; `mul_add` would do without them, but is a slow call where the target has no fma.
#[inline]
fn split(a: f64) -> (f64, f64) {
    let scaled = 134_217_729.0 * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

/// `a * b` and its rounding error, exactly while nothing over- or underflows.
#[inline]
pub fn two_prod(a: f64, b: f64) -> DoubleDouble {
    let hi = a * b;
    let (a_high, a_low) = split(a);
    let (b_high, b_low) = split(b);
    let lo = ((a_high * b_high - hi) + a_high * b_low + a_low * b_high) + a_low * b_low;
    DoubleDouble { hi, lo }
}

/// A constant by its two words.
#[inline]
pub(crate) const fn words(hi: f64, lo: f64) -> DoubleDouble {
    DoubleDouble { hi, lo }
}

// Operators would hide what an operation costs.
#[allow(clippy::should_implement_trait)]
impl DoubleDouble {
    /// The number one.
    pub const ONE: Self = Self { hi: 1.0, lo: 0.0 };

    /// The nearest double.
    #[inline]
    pub fn value(self) -> f64 {
        self.hi + self.lo
    }

    /// Negation, exact.
    #[inline]
    pub fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }

    /// Product by a power of two, exact.
    #[inline]
    pub fn scale(self, power_of_two: f64) -> Self {
        Self { hi: self.hi * power_of_two, lo: self.lo * power_of_two }
    }

    /// Sum.
    #[inline]
    pub fn add(self, other: Self) -> Self {
        let head = two_sum(self.hi, other.hi);
        let tail = two_sum(self.lo, other.lo);
        let once = quick_two_sum(head.hi, head.lo + tail.hi);
        quick_two_sum(once.hi, once.lo + tail.lo)
    }

    /// Difference.
    #[inline]
    pub fn sub(self, other: Self) -> Self {
        self.add(other.neg())
    }

    /// Product.
    #[inline]
    pub fn mul(self, other: Self) -> Self {
        let head = two_prod(self.hi, other.hi);
        quick_two_sum(head.hi, head.lo + (self.hi * other.lo + self.lo * other.hi))
    }

    /// Quotient.
    #[inline]
    pub fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let rest = self.sub(other.mul(first.into()));
        let second = rest.hi / other.hi;
        let rest = rest.sub(other.mul(second.into()));
        let third = rest.hi / other.hi;
        quick_two_sum(first, second).add(third.into())
    }

    /// Quotient by a double, in two steps: relative error at most about `2^-103`.
    #[inline]
    pub fn over(self, other: f64) -> Self {
        let first = self.hi / other;
        let rest = self.sub(two_prod(first, other));
        quick_two_sum(first, rest.hi / other)
    }

    /// Square root of a non-negative number: one Newton step from the double root.
    pub fn sqrt(self) -> Self {
        if self.hi <= 0.0 {
            return Self { hi: self.hi.sqrt(), lo: 0.0 };
        }
        let root = self.hi.sqrt();
        let rest = self.sub(two_prod(root, root));
        quick_two_sum(root, rest.hi / (2.0 * root))
    }
}

/// A double-double value and a bound on its distance to the true value.
#[derive(Clone, Copy, Debug)]
pub struct Precise {
    /// The value.
    pub value: DoubleDouble,
    /// Absolute bound on |value − true|; infinite or NaN where nothing is known.
    pub error: f64,
}

impl Precise {
    /// A value whose relative error is at most `units` times 2^-104; 0 counts as exact.
    #[must_use]
    pub fn relative(value: DoubleDouble, units: f64) -> Self {
        // Below 2^-900 the low word may be subnormal.
        let underflow = if value.hi != 0.0 && value.hi.abs() < 1e-270 { 64.0 * f64::from_bits(1) } else { 0.0 };
        Self { value, error: units * value.hi.abs() * (f64::EPSILON * f64::EPSILON) + underflow }
    }

    /// No value: outside the domain.
    #[must_use]
    pub fn nan() -> Self {
        Self { value: f64::NAN.into(), error: f64::NAN }
    }
}

impl From<f64> for DoubleDouble {
    fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 50-digit values: 1/3 and sqrt(2), as the nearest double and the double nearest to the rest.
    #[test]
    fn quotient_and_root_carry_about_106_bits() {
        let third = DoubleDouble::ONE.div(3.0.into());
        assert_eq!(third.hi, 0.333_333_333_333_333_3);
        assert!((third.lo - 1.850_371_707_708_594e-17).abs() < 1e-32);
        let root = DoubleDouble::from(2.0).sqrt();
        assert_eq!(root.hi, std::f64::consts::SQRT_2);
        assert!((root.lo - -9.667_293_313_452_913e-17).abs() < 1e-31);
        let back = root.mul(root).sub(2.0.into());
        assert!(back.value().abs() < 1e-31);
    }

    #[test]
    fn sums_and_products_are_exact() {
        let sum = two_sum(1e16, 1.0);
        assert_eq!((sum.hi, sum.lo), (1e16, 1.0));
        let product = two_prod(134_217_729.0, 134_217_727.0);
        assert_eq!(product.hi + product.lo, 18_014_398_509_481_983.0);
        assert_eq!(product.lo, (134_217_729_i64 * 134_217_727 - product.hi as i64) as f64);
    }
}
