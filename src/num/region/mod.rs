//! Rectangles of complex numbers: where the values of an analytic function on a rectangle lie.

mod functions;
mod interval;

use interval::Interval;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// All z with Re z and Im z between bounds; unknown where an operation is, or may be, not analytic on what it is given.
///
/// Every operation returns a rectangle that holds all of its values, rounding included, and is unknown where it meets a pole or
/// the cut of the principal branch. What is computed so from an expression is therefore bounded *and* analytic on the rectangle
/// that was put in.
///
/// ```
/// use sneddon::num::Region;
/// let z = Region::new((-1.0, 1.0), (-0.5, 0.5));
/// // |z²| stays below 1.25, and 1 + z² keeps away from 0; 1/z does not exist.
/// assert!(z.powi(2).largest() < 1.5 && (Region::real(1.0) + z.powi(2)).recip().largest() < 2.0);
/// assert!(z.recip().largest().is_infinite());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Region {
    re: Interval,
    im: Interval,
}

impl Region {
    /// The rectangle between these bounds, lowest first.
    pub fn new(re: (f64, f64), im: (f64, f64)) -> Self {
        Self { re: Interval::new(re.0, re.1), im: Interval::new(im.0, im.1) }
    }

    /// One real number.
    pub fn real(value: f64) -> Self {
        Self::new((value, value), (0.0, 0.0))
    }

    /// Everything, or what is not analytic.
    pub fn unknown() -> Self {
        Self { re: Interval::UNKNOWN, im: Interval::UNKNOWN }
    }

    /// Every z with |z| ≤ `radius`, and more.
    fn within(radius: f64) -> Self {
        // Not a number is no bound.
        if radius.is_nan() || radius > f64::MAX {
            return Self::unknown();
        }
        let own = Interval::new(-radius, radius);
        Self { re: own, im: own }
    }

    /// The largest |z|; infinite where it is not known.
    pub fn largest(self) -> f64 {
        let size = self.re.largest().hypot(self.im.largest()).next_up();
        if size.is_nan() { f64::INFINITY } else { size.next_up() }
    }

    /// Whether all bounds are numbers.
    fn is_known(self) -> bool {
        self.re.is_known() && self.im.is_known()
    }

    /// A bound from below on |z|.
    fn least(self) -> f64 {
        let size = self.re.least().hypot(self.im.least());
        if size > 0.0 { (size * (1.0 - 4.0 * f64::EPSILON)).max(0.0) } else { 0.0 }
    }

    /// The real number that this is.
    pub fn as_real(self) -> Option<f64> {
        (self.im.is(0.0) && self.re.is(self.re.low)).then_some(self.re.low)
    }

    /// z².
    fn square(self) -> Self {
        let re = self.re.square().add(self.im.square().negated());
        Self { re, im: self.re.multiply(self.im).scaled(2.0) }
    }

    /// 1/z.
    #[must_use]
    pub fn recip(self) -> Self {
        let size = self.re.square().add(self.im.square());
        if !(self.least() > 0.0 && size.low > 0.0) {
            return Self::unknown();
        }
        // Each part as a fraction of |z|², and never more than 1/|z|.
        let most = (1.0 / self.least()).next_up();
        let inverse = size.inverse();
        let part = |own: Interval| own.multiply(inverse).cut(most);
        Self { re: part(self.re), im: part(self.im).negated() }
    }

    /// zⁿ.
    #[must_use]
    pub fn powi(self, n: i32) -> Self {
        if n < 0 {
            return self.powi(n.saturating_neg()).recip();
        }
        let (mut power, mut result, mut rest) = (self, Self::real(1.0), n);
        while rest > 0 {
            if rest & 1 == 1 {
                result = if result.as_real() == Some(1.0) { power } else { result * power };
            }
            rest >>= 1;
            if rest > 0 {
                power = power.square();
            }
        }
        result
    }
}

impl Add for Region {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { re: self.re.add(other.re), im: self.im.add(other.im) }
    }
}

impl Neg for Region {
    type Output = Self;
    fn neg(self) -> Self {
        Self { re: self.re.negated(), im: self.im.negated() }
    }
}

impl Sub for Region {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Region {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let re = self.re.multiply(other.re).add(self.im.multiply(other.im).negated());
        let im = self.re.multiply(other.im).add(self.im.multiply(other.re));
        Self { re, im }
    }
}

impl Div for Region {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        other.recip().mul(self)
    }
}

#[cfg(test)]
mod tests;
