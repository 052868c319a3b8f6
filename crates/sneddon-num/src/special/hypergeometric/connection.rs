//! Gauss's function by its linear transformations: the argument moves to where the series converges fast.

use crate::special::ball::Ball;
use crate::special::gamma::digamma::digamma_ball;
use crate::special::gamma::{gamma_ball, gamma_ratio, is_pole, is_whole};
use crate::special::hypergeometric::series::series;

/// The parameters of `2F1(a, b; c; ·)` with the differences `c - a`, `c - b` and the excess `c - a - b`.
///
/// The differences travel along, because they become parameters and must then be exact: `c - (c - b)` is not `b`.
#[derive(Clone, Copy)]
pub(crate) struct Gauss {
    a: Ball,
    b: Ball,
    c: Ball,
    c_less_a: Ball,
    c_less_b: Ball,
    excess: Ball,
    /// `b - a`.
    gap: Ball,
}

impl Gauss {
    pub(crate) fn new(a: Ball, b: Ball, c: Ball) -> Self {
        Self { a, b, c, c_less_a: c - a, c_less_b: c - b, excess: (c - a) - b, gap: b - a }
    }

    /// Euler: `2F1(a, b; c; z) = (1-z)^(c-a-b) 2F1(c-a, c-b; c; z)`.
    fn euler(self) -> Self {
        let Self { a, b, c, c_less_a, c_less_b, excess, gap } = self;
        Self { a: c_less_a, b: c_less_b, c, c_less_a: a, c_less_b: b, excess: -excess, gap: -gap }
    }

    /// Pfaff: `2F1(a, b; c; z) = (1-z)^(-a) 2F1(a, c-b; c; z/(z-1))`.
    fn pfaff(self) -> Self {
        let Self { a, b, c, c_less_a, c_less_b, excess, gap } = self;
        Self { a, b: c_less_b, c, c_less_a, c_less_b: b, excess: gap, gap: excess }
    }

    /// With `a` and `b` exchanged.
    fn exchanged(self) -> Self {
        let Self { a, b, c, c_less_a, c_less_b, excess, gap } = self;
        Self { a: b, b: a, c, c_less_a: c_less_b, c_less_b: c_less_a, excess, gap: -gap }
    }

    /// With `b` greater by `step`.
    fn moved(self, step: Ball) -> Self {
        Self { b: self.b + step, c_less_b: self.c_less_b - step, excess: self.excess - step, gap: self.gap + step, ..self }
    }

    fn direct(self, z: Ball) -> Ball {
        series(&[self.a, self.b], &[self.c], z)
    }

    fn is_polynomial(self) -> bool {
        is_pole(self.a) || is_pole(self.b)
    }

    /// The value for real `z < 1`.
    pub(crate) fn value(self, z: Ball) -> Ball {
        if is_same(self.c, self.b) {
            return (-z).ln_1p_power(-self.a);
        }
        if is_same(self.c, self.a) {
            return (-z).ln_1p_power(-self.b);
        }
        let rest = Ball::ONE - z;
        if z.hi() > 0.0 {
            return self.inside(z, rest);
        }
        let mut best = Ball::NONE;
        if z.hi() >= -0.6 || self.is_polynomial() {
            best = self.direct(z);
        }
        let (moved, left) = (-z / rest, rest.recip());
        for form in [self, self.exchanged()] {
            if best.relative() < GOOD {
                break;
            }
            best = best.better(form.pfaff().inside(moved, left) * (-z).ln_1p_power(-form.a));
        }
        best
    }

    /// The value for `0 < z < 1`, `rest = 1 - z`.
    fn inside(self, z: Ball, rest: Ball) -> Ball {
        let mut best = if z.hi() > 0.55 { self.near_one(rest) } else { self.direct(z) };
        if best.relative() < GOOD {
            return best;
        }
        let power = (-z).ln_1p_power(self.excess);
        let euler = self.euler();
        best = best.better(if z.hi() > 0.55 { euler.near_one(rest) } else { euler.direct(z) } * power);
        if best.relative() < GOOD {
            return best;
        }
        if z.hi() > 0.55 {
            // Thousands of terms: only where nothing else has a double's digits and some.
            return if best.relative() < 1e-20 { best } else { best.better(self.direct(z)).better(euler.direct(z) * power) };
        }
        // z/(z-1) lies in (-1.3, 0): Pfaff's polynomials may be free of cancellation where Gauss's is not.
        let moved = -z / rest;
        for form in [self, self.exchanged()] {
            best = best.better(form.pfaff().direct(moved) * (-z).ln_1p_power(-form.a));
        }
        // Large parameters: every form around 0 cancels, while the one around 1 adds positive terms.
        if best.relative() < 1e-20 { best } else { best.better(self.near_one(rest)) }
    }

    /// `2F1(a, b; c; 1) = Γ(c) Γ(c-a-b) / (Γ(c-a) Γ(c-b))` for a positive excess, `(c-b)_n / (c)_n` for `a = -n`.
    pub(crate) fn at_one(self) -> Ball {
        if is_pole(self.b) && (!is_pole(self.a) || self.b.hi() > self.a.hi()) {
            return self.exchanged().at_one();
        }
        if is_pole(self.a) && self.a.hi() >= -10_000.0 {
            let degree = -self.a.hi() as u32;
            return (0..degree).map(f64::from).fold(Ball::ONE, |product, k| product * (self.c_less_b + k) / (self.c + k));
        }
        if self.excess.hi() > 0.0 { gamma_ratio(&[self.c, self.excess], &[self.c_less_a, self.c_less_b]) } else { Ball::NONE }
    }

    /// The value at `1 - rest` for small `rest`, DLMF 15.8.4 and its limits.
    fn near_one(self, rest: Ball) -> Ball {
        if self.is_polynomial() {
            return self.polynomial(rest);
        }
        let nearest = self.excess.hi().round();
        let distance = self.excess - nearest;
        if is_whole(self.excess) {
            return self.whole(rest);
        }
        if distance.hi().abs() > NEAR_WHOLE {
            return self.generic(rest);
        }
        // F is analytic in b: from b₀, where the excess is whole, to b by Taylor, with derivatives from central differences.
        let centre = Self { excess: Ball::from(nearest), ..self.moved(distance) };
        let step = 2.0_f64.powi(-4) / (1.0 + rest.hi().ln().abs()).log2().ceil().exp2();
        let at = |k: f64| centre.moved(Ball::from(k * step)).generic(rest);
        let middle = centre.whole(rest);
        let (mut slope, mut coarse, mut bend) = (Ball::ZERO, Ball::ZERO, middle * (-205.0 / 72.0));
        for (k, (fine, rough, second)) in (1_u32..).zip(DIFFERENCES) {
            let (above, below) = (at(f64::from(k)), at(-f64::from(k)));
            slope = slope + (above - below) * fine;
            coarse = coarse + (above - below) * rough;
            bend = bend + (above + below) * second;
        }
        let shift = (-distance) / step;
        let doubt = ((slope - coarse).hi().abs() + slope.hi().abs() * 1e-15) * shift.hi().abs() + (bend * shift * shift).hi().abs() * 1e-3;
        (middle + slope * shift + bend * shift * shift * 0.5).widened(doubt)
    }

    /// A polynomial in powers of z, or in powers of `rest`, DLMF 15.8.7.
    fn polynomial(self, rest: Ball) -> Ball {
        let direct = self.direct(Ball::ONE - rest);
        let lower = Ball::ONE - self.excess;
        let degree = [self.a, self.b].iter().filter(|p| is_pole(**p)).map(|p| -p.hi()).fold(f64::INFINITY, f64::min);
        if direct.relative() < GOOD || (is_pole(lower) && degree > -lower.hi()) {
            return direct;
        }
        direct.better(self.at_one() * series(&[self.a, self.b], &[lower], rest))
    }

    /// DLMF 15.8.4 itself; its two parts have poles at a whole excess.
    fn generic(self, rest: Ball) -> Ball {
        let Self { a, b, c, c_less_a, c_less_b, excess, .. } = self;
        let regular = gamma_ratio(&[c, excess], &[c_less_a, c_less_b]);
        let singular = gamma_ratio(&[c, -excess], &[a, b]);
        let mut sum = Ball::ZERO;
        if regular.hi() != 0.0 {
            sum = regular * series(&[a, b], &[Ball::ONE - excess], rest);
        }
        if singular.hi() != 0.0 {
            sum = sum + singular * series(&[c_less_a, c_less_b], &[excess + 1.0], rest) * rest.pow(excess);
        }
        sum
    }

    /// A whole excess: polynomials, or the form with a logarithm.
    fn whole(self, rest: Ball) -> Ball {
        if self.is_polynomial() {
            return self.polynomial(rest);
        }
        let order = self.excess.hi();
        if is_pole(self.c_less_a) || is_pole(self.c_less_b) {
            return self.euler().direct(Ball::ONE - rest) * rest.pow(self.excess);
        }
        if order < 0.0 {
            return self.euler().whole(rest) * rest.pow(self.excess);
        }
        if order <= 120.0 { self.logarithmic(rest, order as u32) } else { Ball::NONE }
    }

    /// DLMF 15.8.10, `c = a + b + m`: a finite sum and a series with a logarithm.
    fn logarithmic(self, rest: Ball, m: u32) -> Ball {
        let Self { a, b, c, c_less_a, c_less_b, .. } = self;
        let order = f64::from(m);
        let mut finite = Ball::ZERO;
        if m > 0 {
            let mut term = gamma_ball(Ball::from(order));
            for k in 0..m {
                finite = finite + term;
                let k = f64::from(k);
                if order - k - 1.0 > 0.0 {
                    term = -(term * (a + k) * (b + k) * rest) / ((k + 1.0) * (order - k - 1.0));
                }
            }
            finite = finite * gamma_ratio(&[c], &[c_less_a, c_less_b]);
        }
        // c - b = a + m and c - a = b + m are the parameters of the endless part.
        let mut bracket =
            rest.ln() + digamma_ball(c_less_b) + digamma_ball(c_less_a) - digamma_ball(Ball::ONE) - digamma_ball(Ball::from(order + 1.0));
        let mut factor = (1..=m).fold(Ball::ONE, |product, k| -(product * rest) / f64::from(k));
        let scale = gamma_ratio(&[c], &[a, b]);
        if factor.hi().abs() < 1e-250 {
            return finite.widened(scale.hi().abs() * 1e-240);
        }
        let mut sum = Ball::ZERO;
        let largest = a.hi().abs() + b.hi().abs() + order;
        for k in 0..2000_u32 {
            let k = f64::from(k);
            let term = factor * bracket;
            sum = sum + term;
            let (left, right) = (c_less_b + k, c_less_a + k);
            let size = factor.hi().abs() * (1.0 + bracket.hi().abs());
            if k > 2.0 * largest && size < 1e-35 * sum.hi().abs() {
                return finite - scale * sum.widened(8.0 * size);
            }
            factor = factor * left * right * rest / ((k + 1.0) * (k + order + 1.0));
            bracket = bracket + left.recip() + right.recip() - Ball::from(k + 1.0).recip() - Ball::from(k + order + 1.0).recip();
        }
        Ball::NONE
    }
}

impl Ball {
    /// `(1 + self)^exponent`.
    fn ln_1p_power(self, exponent: Ball) -> Ball {
        if exponent.hi() == 0.0 && exponent.error == 0.0 {
            return Ball::ONE;
        }
        let size = exponent.hi().abs();
        if exponent.error == 0.0 && exponent.value.lo == 0.0 && size.fract() == 0.0 && size <= 64.0 {
            let power = (self + 1.0).powi(size as u32);
            return if exponent.hi() < 0.0 { power.recip() } else { power };
        }
        (self.ln_1p() * exponent).exp()
    }
}

fn is_same(one: Ball, other: Ball) -> bool {
    one.value == other.value && one.error == 0.0 && other.error == 0.0
}

/// A relative bound that needs no other form.
const GOOD: f64 = 1e-26;
/// Nearer than this to a whole excess the generic form would lose too many digits.
const NEAR_WHOLE: f64 = 1e-10;
/// Central differences over ±1 … ±4 steps: first derivative of order 8 and of order 6, second derivative of order 8.
const DIFFERENCES: [(f64, f64, f64); 4] = [
    (4.0 / 5.0, 3.0 / 4.0, 8.0 / 5.0),
    (-1.0 / 5.0, -3.0 / 20.0, -1.0 / 5.0),
    (4.0 / 105.0, 1.0 / 60.0, 8.0 / 315.0),
    (-1.0 / 280.0, 0.0, -1.0 / 560.0),
];
