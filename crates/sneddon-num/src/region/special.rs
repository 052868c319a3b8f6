//! Special functions on rectangles of complex numbers, by bounds on the integrals that define them.

use super::Region;
use super::interval::Interval;
use crate::special;
use std::f64::consts::{FRAC_2_PI, FRAC_2_SQRT_PI, FRAC_PI_2, FRAC_PI_8};

/// More than the roundings of a bound that is computed from bounds.
const UP: f64 = 1.0 + 1e-12;
/// More than the error of a value as a share: the largest that was measured is 3.9 ulps, of gamma (`docs/accuracy.md`).
const VALUE: f64 = 16.0 * f64::EPSILON;

/// Whether n is a whole order for which the bounds are meant.
fn is_an_order(n: f64) -> bool {
    n >= 0.0 && n.fract() == 0.0 && n <= 100.0
}

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

    /// erf z = (2/√π) z ∫₀¹ e^(−t² z²) dt.
    #[must_use]
    pub fn erf(self) -> Self {
        if self.is_on_the_axis() {
            return self.rising(special::erf);
        }
        let rough = self.through(|square| 0.88 / (-square).exp().largest());
        self.by_mean_value(rough, special::erf, |z| Self::real(FRAC_2_SQRT_PI) * (-z.powi(2)).exp())
    }

    /// erfi z = (2/√π) z ∫₀¹ e^(t² z²) dt.
    #[must_use]
    pub fn erfi(self) -> Self {
        let rough = self.times_mean(FRAC_2_SQRT_PI, self.powi(2).re.high.max(0.0).exp());
        self.by_mean_value(rough, special::erfi, |z| Self::real(FRAC_2_SQRT_PI) * z.powi(2).exp())
    }

    /// Dawson's integral, z ∫₀¹ e^((t² − 1) z²) dt, with the derivative 1 − 2 z D(z).
    #[must_use]
    pub fn dawson(self) -> Self {
        let rough = |z: Self| z.times_mean(1.0, (-z.powi(2).re.low).max(0.0).exp());
        self.by_mean_value(rough(self), special::dawson, |z| Self::real(1.0) - Self::real(2.0) * z * rough(z))
    }

    /// The Fresnel integral z ∫₀¹ cos(π t² z²/2) dt.
    #[must_use]
    pub fn fresnelc(self) -> Self {
        self.by_mean_value(self.rough_fresnel(), special::fresnelc, |z| z.half_turns().cos())
    }

    /// The Fresnel integral z ∫₀¹ sin(π t² z²/2) dt.
    #[must_use]
    pub fn fresnels(self) -> Self {
        self.by_mean_value(self.rough_fresnel(), special::fresnels, |z| z.half_turns().sin())
    }

    /// Both Fresnel integrals: |cos w| and |sin w| are at most cosh(Im w).
    fn rough_fresnel(self) -> Self {
        self.times_mean(1.0, (FRAC_PI_2 * self.powi(2).im.largest()).cosh())
    }

    /// π z²/2.
    fn half_turns(self) -> Self {
        Self::real(FRAC_PI_2) * self.powi(2)
    }

    /// J_n(z), n = 0, 1, 2, …, with the derivative (J_{n−1} − J_{n+1})/2, DLMF 10.6.1.
    #[must_use]
    pub fn besselj(self, n: f64) -> Self {
        // |J_{−n}| = |J_n|.
        let rough = |z: Self, n: f64| z.rough_besselj(n.abs());
        self.by_mean_value(rough(self, n), |c| special::besselj(n, c), |z| Self::real(0.5) * (rough(z, n - 1.0) - rough(z, n + 1.0)))
    }

    /// I_n(z) = i^(−n) J_n(i z), with the derivative (I_{n−1} + I_{n+1})/2, DLMF 10.29.1.
    #[must_use]
    pub fn besseli(self, n: f64) -> Self {
        let rough = |z: Self, n: f64| z.turned().rough_besselj(n.abs());
        self.by_mean_value(rough(self, n), |c| special::besseli(n, c), |z| Self::real(0.5) * (rough(z, n - 1.0) + rough(z, n + 1.0)))
    }

    /// |J_n(z)| ≤ |z/2|ⁿ e^|Im z|/n!, DLMF 10.14.4.
    fn rough_besselj(self, n: f64) -> Self {
        if !(is_an_order(n) && self.is_known()) {
            return Self::unknown();
        }
        let power = (1..=n as u32).fold(1.0, |product, k| product * (0.5 * self.largest() / f64::from(k)));
        Self::within(power * self.im.largest().exp() * (1.0 + 1e-9))
    }

    /// H_n(z), n = 0, 1, 2, …, with the derivative (H_{n−1} − H_{n+1} + h_n)/2 where h_n = (z/2)ⁿ/(√π Γ(n + 3/2)), DLMF 11.4.25.
    #[must_use]
    pub fn struveh(self, n: f64) -> Self {
        self.by_mean_value(
            self.rough_struveh(n),
            |c| special::struveh(n, c),
            |z| {
                // H_{−1} = h₀ − H₁.
                let below = if n == 0.0 { z.struve_power(0.0) - z.rough_struveh(1.0) } else { z.rough_struveh(n - 1.0) };
                Self::real(0.5) * (below - z.rough_struveh(n + 1.0) + z.struve_power(n))
            },
        )
    }

    /// L_n(z), n = 0, 1, 2, …, with the derivative (L_{n−1} + L_{n+1} + h_n)/2, DLMF 11.4.27.
    #[must_use]
    pub fn struvel(self, n: f64) -> Self {
        // The magnitude is that of H_n(i z).
        let rough = |z: Self, n: f64| z.turned().rough_struveh(n);
        self.by_mean_value(
            rough(self, n),
            |c| special::struvel(n, c),
            |z| {
                // L_{−1} = h₀ + L₁.
                let below = if n == 0.0 { z.struve_power(0.0) + rough(z, 1.0) } else { rough(z, n - 1.0) };
                Self::real(0.5) * (below + rough(z, n + 1.0) + z.struve_power(n))
            },
        )
    }

    /// |H_n(z)| by DLMF 11.5.1, where |sin(z t)| ≤ |z| t cosh(Im z).
    fn rough_struveh(self, n: f64) -> Self {
        if !is_an_order(n) {
            return Self::unknown();
        }
        // 2 (|z|/2)ⁿ/(√π Γ(n + ½)(2n + 1)): 2/π for n = 0, and |z|/(2n + 1) more for each.
        self.times_mean(self.struve_power(n).largest(), self.im.largest().cosh())
    }

    /// Every z with a magnitude up to |z/2|ⁿ/(√π Γ(n + 3/2)).
    fn struve_power(self, n: f64) -> Self {
        Self::within((1..=n as u32).fold(FRAC_2_PI, |product, k| product * self.largest() / f64::from(2 * k + 1)) * UP)
    }

    /// Γ(z), Re z > 0: |Γ(z)| ≤ Γ(Re z), which is convex, and Γ′ = Γ ψ.
    #[must_use]
    pub fn gamma(self) -> Self {
        if !(self.is_known() && self.re.low > 0.0) {
            return Self::unknown();
        }
        let rough = |z: Self| Self::within(special::gamma(z.re.low).max(special::gamma(z.re.high)) * UP);
        self.by_mean_value(rough(self), special::gamma, |z| rough(z) * z.digamma())
    }

    /// ψ(z), Re z > 0, with |ψ′(z)| ≤ ψ′(Re z).
    #[must_use]
    pub fn digamma(self) -> Self {
        self.polygamma(0.0)
    }

    /// ψ^(m)(z), Re z > 0: for m ≥ 1 a sum of (z + k)^(−m−1), whose magnitude is largest where z is real.
    #[must_use]
    pub fn polygamma(self, m: f64) -> Self {
        if !(self.is_known() && self.re.low > 0.0 && is_an_order(m)) {
            return Self::unknown();
        }
        let most = |m: f64| Self::within(special::polygamma(m, self.re.low).abs() * UP);
        let rough = if m == 0.0 { Self::unknown() } else { most(m) };
        self.by_mean_value(rough, |c| special::polygamma(m, c), |_| most(m + 1.0))
    }

    /// K(m) = ∫₀^{π/2} dθ/√(1 − m sin²θ), with the derivative ½ ∫₀^{π/2} sin²θ (1 − m sin²θ)^(−3/2) dθ.
    #[must_use]
    pub fn ellipk(self) -> Self {
        self.by_mean_value(self.over_the_root(FRAC_PI_2, 1), special::ellipk, |m| m.over_the_root(FRAC_PI_8, 3))
    }

    /// E(m) = ∫₀^{π/2} √(1 − m sin²θ) dθ, with the derivative −½ ∫₀^{π/2} sin²θ/√(1 − m sin²θ) dθ.
    #[must_use]
    pub fn ellipe(self) -> Self {
        let root = (Self::real(1.0) - self.with_zero()).sqrt();
        let rough = if root.is_known() { Self::within(FRAC_PI_2 * root.largest() * UP) } else { Self::unknown() };
        self.by_mean_value(rough, special::ellipe, |m| m.over_the_root(FRAC_PI_8, 1))
    }

    /// Every z with a magnitude up to `factor` |√(1 − m t)|^−n, 0 ≤ t ≤ 1.
    fn over_the_root(self, factor: f64, n: i32) -> Self {
        let root = (Self::real(1.0) - self.with_zero()).sqrt();
        if root.least() > 0.0 { Self::within(factor / root.least().powi(n) * UP) } else { Self::unknown() }
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

    /// What of `rough` is also in f(c) + (z − c) f′, where c is the middle of the real parts, and f′ a rectangle that holds the derivative
    /// on the hull of the rectangle and the real axis: the mean of f′ from c to z lies in it.
    ///
    /// It closes in on the values as the rectangle shrinks, which a bound on the magnitude does not.
    fn by_mean_value(self, rough: Self, value: impl Fn(f64) -> f64, slope: impl Fn(Self) -> Self) -> Self {
        let middle = 0.5 * (self.re.low + self.re.high);
        if !(self.is_known() && middle.is_finite()) {
            return rough;
        }
        let at_middle = value(middle);
        if !at_middle.is_finite() {
            return rough;
        }
        let error = VALUE * at_middle.abs() + f64::MIN_POSITIVE;
        let around = Self::rectangle(self.re, self.im.hull(Interval::point(0.0)));
        let near = Self::interval(at_middle - error, at_middle + error) + (self - Self::real(middle)) * slope(around);
        rough.and(near)
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
