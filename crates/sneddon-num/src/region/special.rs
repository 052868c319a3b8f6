//! Special functions on rectangles of complex numbers, by bounds on the integrals that define them.

use super::Region;
use super::interval::Interval;
use crate::special;
use std::f64::consts::{FRAC_2_PI, FRAC_2_SQRT_PI, FRAC_PI_2};

/// More than the roundings of a bound that is computed from bounds.
const UP: f64 = 1.0 + 1e-12;

impl Region {
    /// ln(1 + z), which keeps its digits for small z: ln(1 + z) = z ∫₀¹ dt/(1 + t z).
    #[must_use]
    pub fn ln_1p(self) -> Self {
        // Re ln(1 + z) = ln|1 + z| rises with Re z where z is real.
        if self.is_on_the_axis() && self.re.low > -1.0 {
            return Self::rectangle(self.re.rising(f64::ln_1p), Interval::point(0.0));
        }
        let whole = (Self::real(1.0) + self).ln();
        let least = (Self::real(1.0) + self.with_zero()).least();
        if least > 0.0 && whole.is_known() { whole.and(Self::within(self.largest() / least * UP)) } else { whole }
    }

    /// arcosh z = ln(z + √(z − 1) √(z + 1)).
    #[must_use]
    pub fn acosh(self) -> Self {
        let one = Self::real(1.0);
        (self + (self - one).sqrt() * (self + one).sqrt()).ln()
    }

    /// z where Re z > 0 and −z where Re z < 0, which continue |r| from the real axis; unknown where the rectangle has both, unless it is
    /// real itself.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.re.low >= 0.0 {
            self
        } else if self.re.high <= 0.0 {
            -self
        } else if self.is_on_the_axis() {
            Self::rectangle(Interval::new(0.0, self.re.largest()), Interval::point(0.0))
        } else {
            Self::unknown()
        }
    }

    /// erfi z = (2/√π) z ∫₀¹ e^(t² z²) dt.
    #[must_use]
    pub fn erfi(self) -> Self {
        self.times_mean(FRAC_2_SQRT_PI, self.powi(2).re.high.max(0.0).exp())
    }

    /// Dawson's integral, z ∫₀¹ e^((t² − 1) z²) dt.
    #[must_use]
    pub fn dawson(self) -> Self {
        self.times_mean(1.0, (-self.powi(2).re.low).max(0.0).exp())
    }

    /// The Fresnel integrals, z ∫₀¹ cos(π t² z²/2) dt and with the sine.
    #[must_use]
    pub fn fresnel(self) -> Self {
        self.times_mean(1.0, (FRAC_PI_2 * self.powi(2).im.largest()).cosh())
    }

    /// H_n(z), n = 0, 1, 2, …, DLMF 11.5.1, where |sin(z t)| ≤ |z| t cosh(Im z).
    #[must_use]
    pub fn struveh(self, n: f64) -> Self {
        if !(n >= 0.0 && n.fract() == 0.0 && n <= 100.0) {
            return Self::unknown();
        }
        // 2 (|z|/2)ⁿ/(√π Γ(n + ½)(2n + 1)): 2/π for n = 0, and |z|/(2n + 1) more for each.
        let power = (1..=n as u32).fold(FRAC_2_PI, |product, k| product * self.largest() / f64::from(2 * k + 1));
        self.times_mean(power, self.im.largest().cosh())
    }

    /// L_n(z), whose magnitude is that of H_n(i z).
    #[must_use]
    pub fn struvel(self, n: f64) -> Self {
        Self { re: self.im, im: self.re, ..self }.struveh(n)
    }

    /// K(m) = ∫₀^{π/2} dθ/√(1 − m sin²θ).
    #[must_use]
    pub fn ellipk(self) -> Self {
        let root = (Self::real(1.0) - self.with_zero()).sqrt();
        if root.least() > 0.0 { Self::within(FRAC_PI_2 / root.least() * UP) } else { Self::unknown() }
    }

    /// E(m) = ∫₀^{π/2} √(1 − m sin²θ) dθ.
    #[must_use]
    pub fn ellipe(self) -> Self {
        let root = (Self::real(1.0) - self.with_zero()).sqrt();
        if root.is_known() { Self::within(FRAC_PI_2 * root.largest() * UP) } else { Self::unknown() }
    }

    /// Carlson's R_F, whose integrand ½ ((t + x)(t + y)(t + z))^(−1/2) is largest where every argument is its real part.
    #[must_use]
    pub fn elliprf(x: Self, y: Self, z: Self) -> Self {
        Self::below(x.re.low.min(y.re.low).min(z.re.low), special::rf(x.re.low, y.re.low, z.re.low))
    }

    /// Carlson's R_D, as [`Self::elliprf`].
    #[must_use]
    pub fn elliprd(x: Self, y: Self, z: Self) -> Self {
        Self::below(x.re.low.min(y.re.low).min(z.re.low), special::rd(x.re.low, y.re.low, z.re.low))
    }

    /// Everything up to a magnitude, where the least argument is positive.
    fn below(least: f64, most: f64) -> Self {
        if least > 0.0 { Self::within(most * UP) } else { Self::unknown() }
    }

    /// The hull of the rectangle and 0.
    #[must_use]
    pub fn with_zero(self) -> Self {
        let zero = Interval::point(0.0);
        if self.is_known() { Self::rectangle(self.re.hull(zero), self.im.hull(zero)) } else { Self::unknown() }
    }

    /// `factor` z times the mean of something that is nowhere larger than `most`.
    fn times_mean(self, factor: f64, most: f64) -> Self {
        if self.is_known() { Self::within(factor * self.largest() * most * UP) } else { Self::unknown() }
    }
}
