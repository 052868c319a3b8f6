//! Roots, powers and arbitrary functions of error-carrying numbers.

use super::{Bounded, LEAST_INVERSE, TINY, half_ulp, widen};

/// Number of halvings of the step towards the edge of a domain before its limit is used.
const HALVINGS: u32 = 32;
/// Functions are assumed monotonic within this fraction of the argument, and of 1.
const CLOSE: f64 = 1e-3;
/// Most arguments that `apply_many` keeps without allocating memory.
const FEW: usize = 8;

impl Bounded {
    /// The square root. A slightly negative value whose error reaches 0 counts as 0 (the true
    /// value is taken to lie in the domain); below that the result is NaN.
    ///
    /// ```
    /// use sneddon_num::Bounded;
    /// let edge = Bounded { value: -1e-20, error: 4e-20 }.sqrt();
    /// assert_eq!(edge.value, 0.0);
    /// assert!(edge.error >= 1.7e-10 && edge.error < 1.8e-10); // √(3e-20)
    /// ```
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.value < 0.0 {
            let most = self.value + self.error;
            return if most >= 0.0 { Self::checked(0.0, widen(most.sqrt())) } else { Self::checked(f64::NAN, f64::NAN) };
        }
        let value = self.value.sqrt();
        if self.error == 0.0 {
            return Self::checked(value, half_ulp(value));
        }
        let least = self.value - self.error;
        let carried = if least >= 0.0 {
            self.error / (least.sqrt() + value)
        } else {
            value.max(self.error / ((self.value + self.error).sqrt() + value))
        };
        Self::checked(value, widen(carried + half_ulp(value)))
    }

    /// An integer power. Squares are one multiplication, everything else is [`Bounded::powf`].
    #[must_use]
    pub fn powi(self, exponent: i32) -> Self {
        match exponent {
            0 => Self::exact(1.0),
            1 => self,
            2 => self * self,
            _ => self.powf(Self::exact(f64::from(exponent))),
        }
    }

    /// base^exponent, both possibly inexact. A base whose error reaches 0 from above or below is
    /// taken to lie in the domain (0 ≤ base, unless the exponent is an exact integer).
    ///
    /// Accuracy: assumes that the platform's `pow` errs by at most one unit in the last place.
    ///
    /// ```
    /// use sneddon_num::Bounded;
    /// let root = Bounded::exact(2.0).powf(Bounded { value: 0.5, error: 1e-10 });
    /// assert!(root.error > 9.8e-11 && root.error < 1e-10); // √2·ln 2·1e-10
    /// ```
    #[must_use]
    pub fn powf(self, exponent: Self) -> Self {
        let integer = exponent.error == 0.0 && exponent.value.fract() == 0.0;
        let mut base = self;
        if base.value < 0.0 && !integer && base.value + base.error >= 0.0 {
            base = Self { value: 0.0, error: base.value + base.error };
        }
        let value = base.value.powf(exponent.value);
        if exponent.error == 0.0 && (base.is_beyond() || value.is_infinite()) {
            return base.power_beyond(exponent.value, value);
        }
        let own = ulps(value, 1.0);
        if base.error == 0.0 && exponent.error == 0.0 {
            let exact = base.value == 0.0 || base.value == 1.0 || exponent.value == 0.0;
            return Self::checked(value, if exact { 0.0 } else { own });
        }
        let size = base.value.abs();
        if size.is_nan() || exponent.value.is_nan() || size <= base.error {
            return Self::checked(value, widen(near_zero_base(base, exponent, value) + own));
        }
        // ln of the power moves by at most this much; |ln(1 ± t)| ≤ t/(1 − t).
        let stretch = base.error / (size - base.error);
        let log_size = if exponent.error == 0.0 { 0.0 } else { size.ln().abs() + stretch };
        let shift = exponent.value.abs() * stretch + exponent.error * log_size * (1.0 + f64::EPSILON);
        let scale = value.abs().max(f64::MIN_POSITIVE);
        Self::checked(value, widen((scale + own) * shift.exp_m1() * (1.0 + f64::EPSILON) + own))
    }

    /// A function of one number: the error of `f` is at most `own_ulps` units in the last place of its
    /// result. The argument's error is propagated by evaluating `f` at both ends of its interval, and between them
    /// if they are far apart, and doubling the largest change; an exact argument needs no extra evaluation.
    ///
    /// Domain: `f` must be free of poles within the argument's error. If one end lies outside the domain (NaN or an infinity),
    /// the edge is located by bisection; an edge at which `f` grows like a logarithm or a pole gives an infinite error.
    ///
    /// ```
    /// use sneddon_num::Bounded;
    /// let x = Bounded { value: 1.0, error: 1e-10 };
    /// let y = x.apply(f64::exp, 1.0);
    /// assert!(y.error > 2.7e-10 && y.error < 5.5e-10);
    /// let edge = Bounded { value: 1.0, error: 1e-10 }.apply(f64::acos, 1.0);
    /// assert!(edge.error > 1.4e-5 && edge.error < 3e-5); // acos(1 − 1e-10)
    /// ```
    #[must_use]
    pub fn apply(self, f: impl Fn(f64) -> f64, own_ulps: f64) -> Self {
        let value = f(self.value);
        if value.is_infinite() || self.is_beyond() {
            return self.apply_beyond(f, value, own_ulps);
        }
        if self.error == 0.0 {
            return Self::checked(value, ulps(value, own_ulps));
        }
        if value.is_nan() && !self.value.is_nan() {
            return beyond_the_edge(&f, self, own_ulps);
        }
        let own = ulps(value, own_ulps);
        Self::checked(value, widen(own + spread(f, self, value, own)))
    }

    /// The function of a number if its argument or its value overflows.
    fn apply_beyond(self, f: impl Fn(f64) -> f64, value: f64, own_ulps: f64) -> Self {
        // A function that is constant here has reached its limit, like tanh; one that is infinite on both sides has no pole here.
        let around = if self.is_beyond() {
            [1.0, 1e-10, 1e-20].map(|factor| f((factor / LEAST_INVERSE).copysign(self.value)))
        } else {
            let step = self.error.max(1e-6 * self.value.abs());
            [f(self.value - step), f(self.value + step), f(self.value)]
        };
        match around.iter().all(|own| *own == value) {
            true if value.is_infinite() && self.value != 0.0 => Self::beyond(value, 1.0 / f64::MAX * 2.0),
            true if value.is_finite() => Self::checked(value, ulps(value, own_ulps)),
            _ => Self::checked(value, f64::INFINITY),
        }
    }

    /// base^n if the power or the base overflows.
    fn power_beyond(self, n: f64, value: f64) -> Self {
        let inverse = self.most_inverse().powf(n.abs()) * (1.0 + 4.0 * f64::EPSILON) + TINY;
        match self.value > 0.0 || n.fract() == 0.0 {
            true if n > 0.0 => Self::beyond(value, inverse),
            true if n < 0.0 && self.is_beyond() => Self::checked(0.0, inverse),
            _ => Self::checked(value, f64::INFINITY),
        }
    }

    /// A function of several numbers: like [`Bounded::apply`], moving one inexact argument at a time.
    /// Exact arguments need no extra evaluation. The values of the arguments must lie in the domain.
    ///
    /// ```
    /// use sneddon_num::Bounded;
    /// let sides = [Bounded::exact(3.0), Bounded { value: 4.0, error: 1e-8 }];
    /// let long = Bounded::apply_many(|s| s[0].hypot(s[1]), &sides, 1.0);
    /// assert!(long.value == 5.0 && long.error > 0.8e-8 && long.error < 1.7e-8);
    /// ```
    #[must_use]
    pub fn apply_many(f: impl Fn(&[f64]) -> f64, args: &[Self], own_ulps: f64) -> Self {
        let mut few = [0.0; FEW];
        let mut many = Vec::new();
        let point: &mut [f64] = match few.get_mut(..args.len()) {
            Some(slice) => slice,
            None => {
                many.resize(args.len(), 0.0);
                &mut many
            }
        };
        for (slot, arg) in point.iter_mut().zip(args) {
            *slot = arg.value;
        }
        let value = f(point);
        let own = ulps(value, own_ulps);
        let mut error = own;
        for (index, arg) in args.iter().enumerate().filter(|(_, arg)| arg.error != 0.0) {
            let moved = |x: f64| {
                if let Some(slot) = point.get_mut(index) {
                    *slot = x;
                }
                f(point)
            };
            error += spread(moved, *arg, value, own);
            if let Some(slot) = point.get_mut(index) {
                *slot = arg.value;
            }
        }
        Self::checked(value, widen(error))
    }
}

/// `count` units in the last place of a function value; a zero may be an underflow.
fn ulps(value: f64, count: f64) -> f64 {
    if count == 0.0 { 0.0 } else { count * (value.abs() * f64::EPSILON).max(TINY) }
}

/// The change of `f` while its argument runs over value ± error, doubled for safety.
fn spread(mut f: impl FnMut(f64) -> f64, x: Bounded, value: f64, own: f64) -> f64 {
    // An overflowing argument carries no information: exp(−∞) = 0 would look exact.
    if !(x.value.is_finite() && x.error.is_finite()) {
        return f64::INFINITY;
    }
    // A step below the spacing of the numbers would not move the argument at all.
    let grid = (x.value.abs() * f64::EPSILON).max(TINY);
    let step = x.error.max(grid);
    let (up, down) = (f(x.value + step), f(x.value - step));
    let ends = match (up.is_finite(), down.is_finite()) {
        (true, true) => {
            let change = (up - value).abs().max((down - value).abs());
            // The difference of two computed values contains the errors of both.
            (2.0 * change + 2.0 * own) * (x.error / step)
        }
        (true, false) => one_sided(&mut f, x.value, -step, value, (up - value).abs(), own),
        (false, true) => one_sided(&mut f, x.value, step, value, (down - value).abs(), own),
        (false, false) => f64::INFINITY,
    };
    if is_far(x.value, x.error) { ends.max(2.0 * reach_between(f, x, value) + 2.0 * own) } else { ends }
}

/// Whether a function may have an extremum within value ± error, so that the values at the ends do not bound its change:
/// functions vary over lengths of the size of their argument, or of 1.
pub fn is_far(value: f64, error: f64) -> bool {
    error > close(value)
}

/// The distance over which a function is assumed monotonic; around 0 it is a fraction of 1.
fn close(value: f64) -> f64 {
    CLOSE * if value == 0.0 { 1.0 } else { value.abs().min(1.0) }
}

/// The largest change of `f` between value ± error and the value, sampled at quarters; infinite for an infinite error.
pub fn reach_between(mut f: impl FnMut(f64) -> f64, x: Bounded, value: f64) -> f64 {
    let nearest = close(x.value);
    let (mut step, mut reach) = (x.error, 0.0_f64);
    if step.is_infinite() {
        return step;
    }
    // A step below the spacing of the numbers leads back to the value.
    let moves = |step: f64| x.value + step != x.value || x.value - step != x.value;
    while step > nearest && moves(step) {
        for moved in [f(x.value + step), f(x.value - step)] {
            // Points beyond the edge of the domain do not contribute.
            if moved.is_finite() {
                reach = reach.max((moved - value).abs());
            }
        }
        step *= 0.25;
    }
    reach
}

/// The change towards an edge of the domain if x + step lies outside.
fn one_sided(f: &mut impl FnMut(f64) -> f64, x: f64, step: f64, value: f64, inward: f64, own: f64) -> f64 {
    let (halfway, edge) = edge_values(f, x, step, value);
    let (first, last) = ((halfway - value).abs(), (edge - value).abs());
    // From 16 to 32 halvings, the change of a logarithm doubles and near a pole grows faster; for a power it converges.
    if last > 1.6 * first + 4.0 * own {
        return f64::INFINITY;
    }
    2.0 * inward.max(last) + 2.0 * own
}

/// `f` near the last point of the domain between `inside` and `inside + step`, which is outside:
/// after half of the bisection, and after all of it.
fn edge_values(f: &mut impl FnMut(f64) -> f64, inside: f64, step: f64, at_inside: f64) -> (f64, f64) {
    let (mut good, mut bad) = (0.0, 1.0);
    let (mut value, mut halfway) = (at_inside, at_inside);
    for halving in 0..HALVINGS {
        let middle = 0.5 * (good + bad);
        let trial = f(inside + middle * step);
        if trial.is_finite() {
            good = middle;
            value = trial;
        } else {
            bad = middle;
        }
        if halving == HALVINGS / 2 {
            halfway = value;
        }
    }
    (halfway, value)
}

/// The value at the edge of the domain if the argument lies outside but its error interval reaches inside; the error covers the
/// part of the interval inside the domain.
fn beyond_the_edge(f: &impl Fn(f64) -> f64, x: Bounded, own_ulps: f64) -> Bounded {
    // Near the edge the spacing of doubles may be as large as the error; measure the change over a few spacings.
    let reach = x.error.max(4.0 * x.value.abs() * f64::EPSILON);
    for step in [reach, -reach] {
        let inside = x.value + step;
        let far = f(inside);
        if far.is_finite() {
            let mut f = f;
            let (_, edge) = edge_values(&mut f, inside, -step, far);
            let own = ulps(edge, own_ulps);
            let mut reach = one_sided(&mut f, inside, -step, far, 0.0, own);
            if is_far(x.value, x.error) {
                reach = reach.max(2.0 * reach_between(f, x, edge));
            }
            return Bounded::checked(edge, widen(reach + own));
        }
    }
    Bounded::checked(f64::NAN, f64::NAN)
}

/// The change of a power whose base may be 0 within its error.
fn near_zero_base(base: Bounded, exponent: Bounded, value: f64) -> f64 {
    let most = base.value.abs() + base.error;
    let (low, high) = (exponent.value - exponent.error, exponent.value + exponent.error);
    if low < 0.0 || low.is_nan() || (low == 0.0 && exponent.error > 0.0) {
        return f64::INFINITY;
    }
    let reach = most.powf(low).max(most.powf(high));
    // An exact exponent 0 means 1 everywhere.
    if high == 0.0 { 0.0 } else { value.abs() + reach + ulps(reach, 1.0) }
}
