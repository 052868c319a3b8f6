//! Analytic functions on rectangles of complex numbers.

use super::Region;
use super::interval::Interval;
use super::{leaves_the_range, magnitude};

/// From here on, 1 − tanh x is smaller than the rounding error of tanh x.
const NEAR_ONE: f64 = 18.0;

impl Region {
    /// √z, the principal branch: unknown where the rectangle meets (−∞, 0].
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.is_on_the_axis() && self.re.low >= 0.0 {
            return Self::rectangle(self.re.rising(f64::sqrt).above_zero(), Interval::point(0.0));
        }
        if self.meets_the_cut() {
            return Self::unknown();
        }
        // Re √z = √((|z| + x)/2) rises with x and with |y|; Im √z = y/(2 Re √z).
        let part = |x: f64, y: f64| {
            let size = magnitude(x.abs(), y.abs());
            if x >= 0.0 { (0.5 * (size + x)).sqrt() } else { y / (2.0 * (size - x)).sqrt() }
        };
        let re = Interval::loose(part(self.re.low, self.im.least()), part(self.re.high, self.im.largest()));
        if re.low.is_nan() || re.low <= 0.0 {
            return Self::unknown();
        }
        let im = self.im.multiply(re.scaled(2.0).inverse());
        Self { re, im, ..Self::sized(self.least().sqrt(), self.largest().sqrt()) }
    }

    /// ln z, the principal branch: unknown where the rectangle meets (−∞, 0].
    #[must_use]
    pub fn ln(self) -> Self {
        if self.meets_the_cut() {
            return Self::unknown();
        }
        Self::rectangle(Interval::loose(self.least().ln(), self.largest().ln()), self.angle())
    }

    /// e^z.
    #[must_use]
    pub fn exp(self) -> Self {
        // |e^z| is known where the argument may be anything and where it overflows.
        let own = Self::polar(self.re.rising(f64::exp), self.im);
        if !(self.re.low <= self.re.high && self.im.low <= self.im.high) {
            return Self::unknown();
        }
        let sizes = Self::sized(self.re.low.exp() * (1.0 - 8.0 * f64::EPSILON), self.re.high.exp() * (1.0 + 8.0 * f64::EPSILON));
        let logarithm = if leaves_the_range(sizes.most) { self.re } else { Interval::UNKNOWN };
        Self { logarithm, ..if own.is_known() { Self { least: sizes.least, most: sizes.most, ..own } } else { sizes } }
    }

    /// z^w.
    #[must_use]
    pub fn power(self, exponent: Self) -> Self {
        let Some(own) = exponent.as_real() else {
            let (base, by) = (self.re, exponent.re);
            if self.is_on_the_axis() && exponent.is_on_the_axis() && base.low == 0.0 && by.low > 0.0 {
                let most = base.high.powf(by.low).max(base.high.powf(by.high));
                return Self::rectangle(Interval::loose(0.0, most).above_zero(), Interval::point(0.0));
            }
            return (exponent * self.ln()).exp();
        };
        const LARGEST_POWER: f64 = 1e6;
        if own.fract() == 0.0 && own.abs() <= LARGEST_POWER {
            return self.powi(own as i32);
        }
        if self.is_on_the_axis() && self.re.low >= 0.0 && own > 0.0 {
            let power = Interval::loose(self.re.low.powf(own), self.re.high.powf(own)).above_zero();
            return Self::rectangle(power, Interval::point(0.0));
        }
        if self.meets_the_cut() {
            return Self::unknown();
        }
        let (a, b) = (self.least().powf(own), self.largest().powf(own));
        Self::polar(Interval::loose(a.min(b), a.max(b)), self.angle().scaled(own))
    }

    /// sin z = sin x cosh y + i cos x sinh y.
    #[must_use]
    pub fn sin(self) -> Self {
        if self.is_on_the_axis() {
            return Self::rectangle(self.re.sin(), Interval::point(0.0));
        }
        // |sin z| lies between |sinh y| and cosh y.
        let sizes = Self::between(self.im);
        Self { re: self.re.sin().multiply(self.im.cosh()), im: self.re.cos().multiply(self.im.rising(f64::sinh)), ..sizes }
    }

    /// cos z = cos x cosh y − i sin x sinh y.
    #[must_use]
    pub fn cos(self) -> Self {
        if self.is_on_the_axis() {
            return Self::rectangle(self.re.cos(), Interval::point(0.0));
        }
        let sizes = Self::between(self.im);
        Self { re: self.re.cos().multiply(self.im.cosh()), im: self.re.sin().multiply(self.im.rising(f64::sinh)).negated(), ..sizes }
    }

    /// sinh z = −i sin(i z).
    #[must_use]
    pub fn sinh(self) -> Self {
        self.turned().sin().turned_back()
    }

    /// cosh z = cos(i z).
    #[must_use]
    pub fn cosh(self) -> Self {
        self.turned().cos()
    }

    /// tanh z, by |tanh z|² = (cosh 2x − cos 2y)/(cosh 2x + cos 2y), and by |tanh z| ≤ tan |z| for small z.
    #[must_use]
    pub fn tanh(self) -> Self {
        if self.is_on_the_axis() && self.re.least() < NEAR_ONE {
            return self.rising(f64::tanh);
        }
        let (size, turn) = (self.re.scaled(2.0).cosh().low, self.im.scaled(2.0).cos().low);
        // Away from the imaginary axis ±1 is near: tanh z = 1 − 2/(e^(2z) + 1).
        let near = (-2.0 * self.re.least()).exp() * (1.0 + 8.0 * f64::EPSILON);
        if near < 0.1 && self.re.largest() <= f64::MAX && self.im.largest() <= f64::MAX {
            let off = 2.0 * near / (1.0 - near) * (1.0 + 8.0 * f64::EPSILON);
            return Self::real(if self.re.low > 0.0 { 1.0 } else { -1.0 }) + Self::within(off);
        }
        // The quotient rises as either falls, to 1 where the cosine is 0.
        let below = size + turn - 4.0 * f64::EPSILON * size;
        if !(below > 0.0 && self.is_known()) {
            return Self::unknown();
        }
        let square = if turn >= 0.0 { 1.0 } else { (size - turn) / below };
        let small = if self.largest() < 1.2 { self.largest().tan() } else { f64::INFINITY };
        Self::within(square.sqrt().min(small) * (1.0 + 8.0 * f64::EPSILON))
    }

    /// tan z = −i tanh(i z).
    #[must_use]
    pub fn tan(self) -> Self {
        if self.is_on_the_axis() && self.re.largest() < 1.57 {
            return self.rising(f64::tan);
        }
        self.turned().tanh().turned_back()
    }

    /// arctan z = z ∫₀¹ dt/(1 + t² z²).
    #[must_use]
    pub fn atan(self) -> Self {
        if self.is_on_the_axis() {
            return self.rising(f64::atan);
        }
        self.through(|square| (Self::real(1.0) + square).least())
    }

    /// artanh z = z ∫₀¹ dt/(1 − t² z²).
    #[must_use]
    pub fn atanh(self) -> Self {
        if self.is_on_the_axis() && self.re.low > -1.0 && self.re.high < 1.0 {
            return self.rising(f64::atanh);
        }
        self.through(|square| (Self::real(1.0) - square).least())
    }

    /// arsinh z = z ∫₀¹ dt/√(1 + t² z²).
    #[must_use]
    pub fn asinh(self) -> Self {
        if self.is_on_the_axis() {
            return self.rising(libm::asinh);
        }
        self.through(|square| (Self::real(1.0) + square).sqrt().least())
    }

    /// arcsin z = z ∫₀¹ dt/√(1 − t² z²); its real part lies within ±π/2, and its imaginary part is ±arcosh((|z + 1| + |z − 1|)/2).
    #[must_use]
    pub fn asin(self) -> Self {
        if self.is_on_the_axis() && self.re.low > -1.0 && self.re.high < 1.0 {
            return self.rising(f64::asin);
        }
        let found = self.through(|square| (Self::real(1.0) - square).sqrt().least());
        let sum = 0.5 * ((self + Self::real(1.0)).largest() + (self - Self::real(1.0)).largest());
        let (re, im) = (std::f64::consts::FRAC_PI_2, (sum.max(1.0) * (1.0 + 1e-12)).acosh() * (1.0 + 1e-12));
        if found.is_known() { found.and(Self::rectangle(Interval::loose(-re, re), Interval::loose(-im, im))) } else { found }
    }

    /// |f(z)| ≤ |z|/m where f(z) = z ∫₀¹ h(t² z²) dt and |h| ≤ 1/m on the hull of 0 and z².
    pub(super) fn through(self, least: impl FnOnce(Self) -> f64) -> Self {
        let square = self.square();
        let zero = Interval::point(0.0);
        let hull = Self::rectangle(square.re.hull(zero), square.im.hull(zero));
        let least = if square.is_known() { least(hull) } else { 0.0 };
        if least > 0.0 { Self::within(self.largest() / least * (1.0 + 8.0 * f64::EPSILON)) } else { Self::unknown() }
    }

    /// Whether a number that is 0 or negative is, or may be, in the rectangle.
    fn meets_the_cut(self) -> bool {
        !self.is_known() || (self.re.low <= 0.0 && self.im.has_zero())
    }

    /// The argument, away from the cut: its extremes are at corners.
    fn angle(self) -> Interval {
        let Interval { low, high } = self.re;
        let corners = [(low, self.im.low), (low, self.im.high), (high, self.im.low), (high, self.im.high)].map(|(x, y)| y.atan2(x));
        Interval::loose(corners.into_iter().fold(f64::INFINITY, f64::min), corners.into_iter().fold(f64::NEG_INFINITY, f64::max))
    }

    /// Numbers of these magnitudes and arguments.
    fn polar(size: Interval, angle: Interval) -> Self {
        Self { re: size.multiply(angle.cos()), im: size.multiply(angle.sin()), ..Self::sized(size.low, size.high) }
    }

    /// Numbers whose magnitude lies between |sinh y| and cosh y.
    fn between(y: Interval) -> Self {
        let (least, most) = (y.least(), y.largest());
        let sized = Self::sized(least.sinh() * (1.0 - 8.0 * f64::EPSILON), most.cosh() * (1.0 + 8.0 * f64::EPSILON));
        // e^|y|/2 < cosh y, and sinh |y| is more than half of it where |y| ≥ 1.
        let logarithm = || Interval::loose(if least >= 1.0 { least - 2.0 * std::f64::consts::LN_2 } else { f64::NEG_INFINITY }, most);
        if sized.most < f64::MAX { sized } else { Self { logarithm: logarithm(), ..sized } }
    }

    /// A function that rises, on a part of the real axis.
    pub(super) fn rising(self, f: fn(f64) -> f64) -> Self {
        Self::rectangle(self.re.rising(f), Interval::point(0.0))
    }

    /// i z.
    pub(super) fn turned(self) -> Self {
        Self { re: self.im.negated(), im: self.re, ..self }
    }

    /// −i z.
    fn turned_back(self) -> Self {
        Self { re: self.im, im: self.re.negated(), ..self }
    }
}
