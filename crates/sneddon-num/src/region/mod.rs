//! Rectangular complex intervals, which enclose the values of an analytic function on a rectangle.

mod functions;
mod interval;
mod special;

use interval::Interval;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// All z with Re z and Im z between bounds; unknown if an operation may not be analytic on its argument.
///
/// Every operation returns a rectangle that contains all of its values, rounding included, and is unknown if it meets a pole or
/// the cut of the principal branch. An expression with a known result is therefore bounded *and* analytic on the input rectangle.
///
/// ```
/// use sneddon_num::Region;
/// let z = Region::new((-1.0, 1.0), (-0.5, 0.5));
/// // |z²| is below 1.25, and 1 + z² is bounded away from 0; 1/z is unbounded.
/// assert!(z.powi(2).largest() < 1.5 && (Region::real(1.0) + z.powi(2)).recip().largest() < 2.0);
/// assert!(z.recip().largest().is_infinite());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Region {
    re: Interval,
    im: Interval,
    /// A lower bound on |z|, which may be sharper than the rectangle; 0 if unknown.
    least: f64,
    /// An upper bound on |z|, if it is a number.
    most: f64,
    /// Bounds on ln|z| if |z| leaves the range of doubles; NaN if the magnitudes suffice or nothing is known.
    logarithm: Interval,
}

/// Magnitudes between these bounds may be multiplied without overflow or underflow.
const LARGE: f64 = 1e150;
const SMALL: f64 = 1e-150;
/// e^(ln|z|) is accurate to this many units, because the argument of up to 745 is rounded.
const LOG_UNITS: f64 = 1024.0;

impl Region {
    /// The rectangle between these bounds, lowest first.
    pub fn new(re: (f64, f64), im: (f64, f64)) -> Self {
        Self::rectangle(Interval::new(re.0, re.1), Interval::new(im.0, im.1))
    }

    /// One real number.
    pub fn real(value: f64) -> Self {
        Self::new((value, value), (0.0, 0.0))
    }

    /// All real numbers between two.
    pub fn interval(low: f64, high: f64) -> Self {
        Self::new((low, high), (0.0, 0.0))
    }

    /// Restricts the region to real numbers, for a function with real values; an unknown region remains unknown, but keeps bounds on the magnitude.
    #[must_use]
    pub fn on_the_axis(self) -> Self {
        if self.is_known() { Self { im: Interval::point(0.0), ..self } } else { self }
    }

    /// The lowest and the highest real part; `None` if nothing is known.
    pub fn real_range(self) -> Option<(f64, f64)> {
        self.is_known().then_some((self.re.low, self.re.high))
    }

    /// All complex numbers: no bound is known, or the function is not analytic.
    pub fn unknown() -> Self {
        Self::rectangle(Interval::UNKNOWN, Interval::UNKNOWN)
    }

    /// A rectangle without sharper bounds on the magnitude.
    #[inline]
    fn rectangle(re: Interval, im: Interval) -> Self {
        Self { re, im, least: 0.0, most: f64::INFINITY, logarithm: Interval::UNKNOWN }
    }

    /// Every z with |z| ≤ `radius`, and more.
    fn within(radius: f64) -> Self {
        // NaN gives no bound.
        if radius.is_nan() || radius > f64::MAX {
            return Self::unknown();
        }
        let own = Interval::new(-radius, radius);
        Self { re: own, im: own, most: radius, ..Self::rectangle(own, own) }
    }

    /// The largest |z|; infinite if unknown.
    #[inline]
    pub fn largest(self) -> f64 {
        let size = magnitude(self.re.largest(), self.im.largest());
        if size.is_nan() { f64::INFINITY } else { (size * (1.0 + 2.0 * f64::EPSILON)).next_up().min(self.most) }
    }

    /// The intersection of two rectangles that both enclose all values of the same function.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        if self.is_known() && other.is_known() {
            Self {
                re: self.re.and(other.re),
                im: self.im.and(other.im),
                ..Self::sized(self.least.max(other.least), self.most.min(other.most))
            }
        } else if self.is_known() {
            self
        } else {
            other
        }
    }

    /// The nonnegative part of a real region.
    #[must_use]
    pub fn above_zero(self) -> Self {
        if self.im.is(0.0) && self.re.low < 0.0 && self.re.high >= 0.0 {
            Self { re: Interval::new(0.0, self.re.high), ..self }
        } else {
            self
        }
    }

    /// The largest |arg z| of numbers with a positive real part, 0 on the real axis; `None` if others are in the region.
    pub fn largest_angle(self) -> Option<f64> {
        if self.is_on_the_axis() && self.re.high > 0.0 {
            return Some(0.0);
        }
        let own = (self.im.largest() / self.re.low).atan() * (1.0 + 8.0 * f64::EPSILON);
        (self.is_known() && self.re.low > 0.0).then_some(own)
    }

    /// Whether the region is part of the real axis.
    fn is_on_the_axis(self) -> bool {
        self.im.is(0.0) && self.re.low <= self.re.high
    }

    /// Numbers with known bounds on the magnitude only.
    fn sized(least: f64, most: f64) -> Self {
        let (least, most) = rounded(least, most);
        let own = Interval::new(-most, most);
        Self { least, most, ..Self::rectangle(own, own) }
    }

    /// Returns the result of an operation from its real and imaginary part and bounds on its magnitude, which are widened for a few roundings.
    /// Where |z| may leave the range of doubles, the result has bounds on ln|z| as well.
    #[inline]
    fn result(re: Interval, im: Interval, magnitude: (f64, f64), is_extreme: bool, logarithm: impl FnOnce() -> Interval) -> Self {
        let (least, most) = rounded(magnitude.0, magnitude.1);
        // Built in each branch, so that the usual result is written in place instead of copied.
        if is_extreme || leaves_the_range(most) {
            Self { re, im, least, most, logarithm: Interval::UNKNOWN }.or_by_logarithm(logarithm())
        } else {
            Self { re, im, least, most, logarithm: Interval::UNKNOWN }
        }
    }

    /// Numbers with these bounds on ln|z|.
    fn sized_by_logarithm(logarithm: Interval) -> Self {
        let sized =
            Self::sized(logarithm.low.exp() * (1.0 - LOG_UNITS * f64::EPSILON), logarithm.high.exp() * (1.0 + LOG_UNITS * f64::EPSILON));
        Self { logarithm, ..sized }
    }

    /// Whether ln|z| has sharper bounds than |z|.
    #[inline]
    fn is_extreme(self) -> bool {
        !self.logarithm.high.is_nan()
    }

    /// Bounds on ln|z|, infinite if unknown.
    fn logarithm(self) -> Interval {
        let Interval { low, high } = self.logarithm;
        let or = |own: f64, other: f64| if own.is_nan() { other } else { own };
        let largest = self.largest();
        let by_size = Interval::loose(self.least().ln(), largest.ln());
        let most = if largest == 0.0 { f64::NEG_INFINITY } else { or(by_size.high, f64::INFINITY) };
        Interval::new(or(low, or(by_size.low, f64::NEG_INFINITY)), or(high, most))
    }

    /// Whether all bounds are numbers.
    #[inline]
    fn is_known(self) -> bool {
        self.re.is_known() && self.im.is_known()
    }

    /// A bound from below on |z|.
    #[inline]
    fn least(self) -> f64 {
        let size = magnitude(self.re.least(), self.im.least());
        if size > 0.0 { (size * (1.0 - 4.0 * f64::EPSILON)).max(self.least) } else { self.least }
    }

    /// The single real number of the region, if it contains only one.
    pub fn as_real(self) -> Option<f64> {
        (self.im.is(0.0) && self.re.is(self.re.low)).then_some(self.re.low)
    }

    /// z².
    fn square(self) -> Self {
        let re = self.re.square().add(self.im.square().negated());
        let im = self.re.multiply(self.im).scaled(2.0);
        let (least, largest) = (self.least(), self.largest());
        Self::result(re, im, (least * least, largest * largest), self.is_extreme(), || self.logarithm().scaled(2.0))
    }

    /// The product with bounds on ln|z|, which remain finite after overflow, or for a product of overflow and underflow.
    #[cold]
    fn or_by_logarithm(self, logarithm: Interval) -> Self {
        let sized = Self::sized_by_logarithm(logarithm);
        if sized.most < self.largest() {
            // The signs of the parts remain known.
            return Self { re: sized.re.and(self.re), im: sized.im.and(self.im), ..sized };
        }
        Self { logarithm, least: self.least.max(sized.least), ..self }
    }

    /// 1/z.
    #[must_use]
    pub fn recip(self) -> Self {
        let size = self.re.square().add(self.im.square());
        let logarithm = if leaves_the_range(self.largest()) || self.is_extreme() { self.logarithm().negated() } else { Interval::UNKNOWN };
        if self.least() <= 0.0 {
            return if logarithm.high < f64::INFINITY { Self::sized_by_logarithm(logarithm) } else { Self::unknown() };
        }
        let sized = Self { logarithm, ..Self::sized(1.0 / self.largest(), 1.0 / self.least()) };
        if !(size.low > 0.0 && size.high < f64::MAX) {
            return sized;
        }
        // Each part as a fraction of |z|², and never more than 1/|z|.
        let most = (1.0 / self.least()).next_up();
        let inverse = size.inverse();
        let part = |own: Interval| own.multiply(inverse).cut(most);
        Self { re: part(self.re), im: part(self.im).negated(), ..sized }
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
        let (re, im) = (self.re.add(other.re), self.im.add(other.im));
        let (low, high, other_low, other_high) = (self.least(), self.largest(), other.least(), other.largest());
        let least = (low - other_high).max(other_low - high);
        // The difference is rounded.
        let magnitude = (least - 2.0 * f64::EPSILON * (low + other_low), high + other_high);
        Self::result(re, im, magnitude, false, || {
            let (a, b) = (self.logarithm(), other.logarithm());
            // |z + w| is at most twice the larger magnitude, and more than half of it if it is e times the other.
            let (large, small) = if a.low >= b.low { (a, b) } else { (b, a) };
            let low = if large.low > small.high + 1.0 { large.low - 0.5 } else { f64::NEG_INFINITY };
            Interval::loose(low, a.high.max(b.high) + std::f64::consts::LN_2)
        })
    }
}

impl Neg for Region {
    type Output = Self;
    fn neg(self) -> Self {
        Self { re: self.re.negated(), im: self.im.negated(), ..self }
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
        // The product of real numbers is real, even if a factor overflows.
        let (re, im) = if self.is_on_the_axis() && other.is_on_the_axis() {
            (self.re.multiply(other.re), Interval::point(0.0))
        } else {
            let re = self.re.multiply(other.re).add(self.im.multiply(other.im).negated());
            (re, self.re.multiply(other.im).add(self.im.multiply(other.re)))
        };
        let magnitude = (self.least() * other.least(), self.largest() * other.largest());
        Self::result(re, im, magnitude, self.is_extreme() || other.is_extreme(), || self.logarithm().add(other.logarithm()))
    }
}

impl Div for Region {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        other.recip().mul(self)
    }
}

/// Bounds on a magnitude, moved outwards by more than a few roundings.
#[inline]
fn rounded(least: f64, most: f64) -> (f64, f64) {
    // NaN gives no bound.
    let least = if least > 0.0 { (least * (1.0 - 4.0 * f64::EPSILON)).min(f64::MAX) } else { 0.0 };
    let most = if most < f64::MAX { most * (1.0 + 4.0 * f64::EPSILON) + f64::MIN_POSITIVE } else { f64::INFINITY };
    (least, most)
}

/// √(x² + y²) of numbers that are not negative, within a relative error of 2^-52.
#[inline]
fn magnitude(x: f64, y: f64) -> f64 {
    let squares = x * x + y * y;
    if y == 0.0 {
        x
    } else if squares > SMALL && squares < LARGE {
        squares.sqrt()
    } else {
        x.hypot(y)
    }
}

/// Whether a magnitude up to this may be part of a product that overflows or underflows.
#[inline]
fn leaves_the_range(most: f64) -> bool {
    !(SMALL..LARGE).contains(&most)
}

#[cfg(test)]
mod tests;
