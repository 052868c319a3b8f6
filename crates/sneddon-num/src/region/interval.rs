//! Intervals of real numbers, every bound rounded outwards.

/// Numbers from `low` to `high`; bounds that are not numbers mean that nothing is known.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interval {
    pub(super) low: f64,
    pub(super) high: f64,
}

/// More than a few roundings of a function of the platform.
const LOOSE: f64 = 8.0 * f64::EPSILON;

impl Interval {
    pub(super) const UNKNOWN: Self = Self { low: f64::NAN, high: f64::NAN };

    #[inline]
    pub(super) fn new(low: f64, high: f64) -> Self {
        Self { low, high }
    }

    #[inline]
    pub(super) fn point(value: f64) -> Self {
        Self::new(value, value)
    }

    #[inline]
    pub(super) fn is(self, value: f64) -> bool {
        self.low == value && self.high == value
    }

    #[inline]
    pub(super) fn has_zero(self) -> bool {
        // True if nothing is known.
        !(self.low > 0.0 || self.high < 0.0)
    }

    /// The largest magnitude.
    #[inline]
    pub(super) fn largest(self) -> f64 {
        if self.low.is_nan() || self.high.is_nan() { f64::NAN } else { self.low.abs().max(self.high.abs()) }
    }

    /// The smallest magnitude.
    #[inline]
    pub(super) fn least(self) -> f64 {
        if self.has_zero() { 0.0 } else { self.low.abs().min(self.high.abs()) }
    }

    /// Bounds that are each right to half an ulp.
    #[inline]
    fn rounded(low: f64, high: f64) -> Self {
        Self { low: low.next_down(), high: high.next_up() }
    }

    /// Bounds by functions of the platform.
    pub(super) fn loose(low: f64, high: f64) -> Self {
        let tiny = f64::MIN_POSITIVE;
        Self { low: low - LOOSE * low.abs() - tiny, high: high + LOOSE * high.abs() + tiny }
    }

    #[inline]
    pub(super) fn add(self, other: Self) -> Self {
        if self.is(0.0) {
            return other;
        }
        if other.is(0.0) {
            return self;
        }
        Self::rounded(self.low + other.low, self.high + other.high)
    }

    #[inline]
    pub(super) fn negated(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }

    #[inline]
    pub(super) fn scaled(self, by: f64) -> Self {
        if self.is(0.0) {
            return self;
        }
        if by >= 0.0 { Self::rounded(self.low * by, self.high * by) } else { self.negated().scaled(-by) }
    }

    #[inline]
    pub(super) fn multiply(self, other: Self) -> Self {
        if (self.is(0.0) && other.is_known()) || (other.is(0.0) && self.is_known()) {
            return Self::point(0.0);
        }
        if self.low >= 0.0 && other.low >= 0.0 {
            // The product of what is not negative is not negative either.
            return Self { low: (self.low * other.low).next_down().max(0.0), high: (self.high * other.high).next_up() };
        }
        let [a, b, c, d] = [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        // Zero times infinity is not a number, and must stay none.
        if a.partial_cmp(&b).is_none() || c.partial_cmp(&d).is_none() {
            return Self::UNKNOWN;
        }
        let least = |v: f64, w: f64| if v < w { v } else { w };
        let largest = |v: f64, w: f64| if v > w { v } else { w };
        Self::rounded(least(least(a, b), least(c, d)), largest(largest(a, b), largest(c, d)))
    }

    #[inline]
    pub(super) fn square(self) -> Self {
        let (least, largest) = (self.least(), self.largest());
        if largest == 0.0 {
            Self::point(0.0)
        } else {
            Self { low: (least * least).next_down().max(0.0), high: (largest * largest).next_up() }
        }
    }

    /// 1/v for positive v.
    #[inline]
    pub(super) fn inverse(self) -> Self {
        Self::rounded(1.0 / self.high, 1.0 / self.low)
    }

    /// The intersection with [−`most`, `most`].
    #[inline]
    pub(super) fn cut(self, most: f64) -> Self {
        if self.is_known() { Self { low: self.low.max(-most), high: self.high.min(most) } } else { self }
    }

    /// The intersection of both.
    pub(super) fn and(self, other: Self) -> Self {
        let own = Self { low: self.low.max(other.low), high: self.high.min(other.high) };
        if own.low <= own.high { own } else { self }
    }

    /// From the lowest to the highest of both.
    pub(super) fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    #[inline]
    pub(super) fn is_known(self) -> bool {
        self.low >= f64::MIN && self.high <= f64::MAX && self.low <= self.high
    }

    /// Without its negative numbers.
    pub(super) fn above_zero(self) -> Self {
        Self { low: self.low.max(0.0), high: self.high }
    }

    /// A function that rises.
    pub(super) fn rising(self, f: fn(f64) -> f64) -> Self {
        Self::loose(f(self.low), f(self.high))
    }

    /// cosh v.
    pub(super) fn cosh(self) -> Self {
        Self::loose(self.least().cosh(), self.largest().cosh())
    }

    /// cos v.
    pub(super) fn cos(self) -> Self {
        use std::f64::consts::{PI, TAU};
        const WIDE: f64 = 1e6;
        if self.largest().is_nan() || self.largest() > WIDE {
            return if self.is_known() { Self::new(-1.0, 1.0) } else { Self::UNKNOWN };
        }
        // A hair more than the interval, so that no extreme at its ends is missed.
        let hair = 1e-9;
        let (low, high) = (self.low - hair, self.high + hair);
        let holds = |place: f64| ((low - place) / TAU).ceil() <= ((high - place) / TAU).floor();
        let (a, b) = (self.low.cos(), self.high.cos());
        let ends = Self::loose(a.min(b), a.max(b));
        Self { low: if holds(PI) { -1.0 } else { ends.low.max(-1.0) }, high: if holds(0.0) { 1.0 } else { ends.high.min(1.0) } }
    }

    /// sin v.
    pub(super) fn sin(self) -> Self {
        // Up to π/2 it rises, and keeps its digits next to 0.
        if self.largest() <= 1.57 {
            return if self.is(0.0) { self } else { self.rising(f64::sin) };
        }
        // The shift is rounded; the hair of the cosine is larger for all that it looks at.
        let quarter = Self::point(std::f64::consts::FRAC_PI_2);
        let own = Self::loose(self.low, self.high).add(quarter.negated()).cos();
        if self.is(0.0) { Self::point(0.0) } else { own }
    }
}
