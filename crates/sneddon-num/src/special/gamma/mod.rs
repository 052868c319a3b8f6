//! The gamma function and ratios of gamma functions with 30 digits.

pub(crate) mod digamma;
pub(crate) mod polygamma;

use super::ball::{Ball, UNIT};
use crate::special::ball::elementary::PI;
use crate::{DoubleDouble, Precise, work};

/// `Gamma(x)` with about 30 digits.
///
/// Domain: real `x` from -400 to 170.5, whole `x <= 0` excepted; no value elsewhere.
/// Method: the recurrence up to 32, then Stirling's series with the exact Bernoulli numbers.
/// Accuracy: measured at most 1.5e-30 relative for `x` from 1e-200 to 170; the bound is about twenty times wider.
///
/// Source: DLMF 5.5.1, 5.11.1; the first omitted term bounds the tail.
///
/// ```
/// use sneddon_num::special::gamma_precise;
/// let five = gamma_precise(5.0.into());
/// assert!((five.value.value() - 24.0).abs() < 1e-14 && five.error < 1e-26);
/// ```
pub fn gamma_precise(x: DoubleDouble) -> Precise {
    gamma_ball(Ball::exact(x)).precise()
}

/// Γ of a ball.
pub(super) fn gamma_ball(x: Ball) -> Ball {
    if x.hi() > 0.0 && x.hi() < 1e-200 {
        return x.recip();
    }
    let Some((sign, logarithm, below)) = parts(x) else { return Ball::NONE };
    // Multiplied last: the product of the recurrence is exact to a few units, its logarithm is not.
    let value = logarithm.exp() / below;
    if sign < 0.0 { -value } else { value }
}

/// `Π Γ(above) / Π Γ(below)`, zero where a lower argument is a pole and no upper one is.
///
/// The large parts meet as logarithms, so that no single gamma function overflows.
pub(super) fn gamma_ratio(above: &[Ball], below: &[Ball]) -> Ball {
    if below.iter().any(|x| is_pole(*x)) {
        return if above.iter().any(|x| is_pole(*x)) { Ball::NONE } else { Ball::ZERO };
    }
    let (mut sign, mut logarithm, mut product) = (1.0, Ball::ZERO, Ball::ONE);
    let (mut numerators, mut denominators) = (above.iter(), below.iter());
    // By turns, so that neither the product nor the logarithm leaves the range of doubles where there are many of both.
    loop {
        let (numerator, denominator) = (numerators.next(), denominators.next());
        for (x, direction) in [(numerator, 1.0), (denominator, -1.0)] {
            let Some(x) = x else { continue };
            let Some((own, part, steps)) = parts(*x) else { return Ball::NONE };
            sign *= own;
            logarithm = logarithm + part * direction;
            product = if direction > 0.0 { product / steps } else { product * steps };
        }
        if numerator.is_none() && denominator.is_none() {
            break;
        }
    }
    logarithm.exp() * product * sign
}

/// Exactly a whole number that is not positive.
pub(super) fn is_pole(x: Ball) -> bool {
    x.hi() <= 0.0 && is_whole(x)
}

/// Exactly a whole number.
pub(super) fn is_whole(x: Ball) -> bool {
    x.hi().fract() == 0.0 && x.value.lo == 0.0 && x.error < 1e-25 * (1.0 + x.hi().abs())
}

/// [`crate::kappa::kappa_precise`].
pub(crate) fn kappa_series(n: DoubleDouble) -> Precise {
    let n = Ball::exact(n);
    if (n + 1.0).hi() <= 0.0 || n.hi().is_nan() || n.hi() > 1e100 {
        return Precise::nan();
    }
    let steps = if n.hi() < 40.0 { ((40.0 - n.hi()) * 0.5).ceil() as u32 } else { 0 };
    let (mut above, mut below) = (Ball::ONE, Ball::ONE);
    for step in 0..steps {
        let shift = f64::from(2 * step);
        above = above * (n + (shift + 1.0));
        below = below * (n + (shift + 2.0));
    }
    let s = (n + f64::from(2 * steps)).scale(2.0) + 1.0;
    let square = s.square().recip();
    let (mut power, mut series) = (square, Ball::ZERO);
    for (k, euler) in (1_u32..).zip(EULER) {
        let term = power * Ball::exact(DoubleDouble { hi: euler.0, lo: euler.1 }).widened(euler.0.abs() * 1e-32) / f64::from(4 * k);
        series = series - term;
        if term.hi().abs() < UNIT * 1e-3 {
            break;
        }
        power = power * square;
    }
    let far = (PI * s).scale(0.25).sqrt() * series.widened(UNIT * 1e-2).exp();
    (far * above / below).precise()
}

/// Γ(x) = sign · exp(logarithm) / below, where `below` is the size of the product of the recurrence.
fn parts(x: Ball) -> Option<(f64, Ball, Ball)> {
    if is_pole(x) || x.hi().is_nan() || x.hi() < -400.0 {
        return None;
    }
    let steps = if x.hi() < FAR { (FAR - x.hi()).ceil() as u32 } else { 0 };
    work::spend(100 + 3 * u64::from(steps));
    if work::is_exhausted() {
        return None;
    }
    let mut below = Ball::ONE;
    for step in 0..steps {
        below = below * (x + f64::from(step));
        if below.hi().abs() > 1e250 {
            // Only far to the left; the quotient would be too small for a double anyway.
            return None;
        }
    }
    let sign = if below.hi() < 0.0 { -1.0 } else { 1.0 };
    Some((sign, stirling(x + f64::from(steps)), below.abs()))
}

/// ln Γ(x) for x of at least 32.
fn stirling(x: Ball) -> Ball {
    let inverse = x.recip();
    let square = inverse.square();
    let mut power = inverse;
    let mut series = Ball::ZERO;
    for (hi, lo) in STIRLING {
        let term = power * Ball::exact(DoubleDouble { hi, lo }).widened(hi.abs() * 1e-32);
        if term.hi().abs() < 1e-36 {
            break;
        }
        series = series + term;
        power = power * square;
    }
    ((x - 0.5) * x.ln() - x + HALF_LN_TWO_PI + series).widened(UNIT)
}

/// Stirling's series begins here; its sixteenth term is below 1e-38.
pub(super) const FAR: f64 = 32.0;
const HALF_LN_TWO_PI: Ball = Ball { value: DoubleDouble { hi: 0.918_938_533_204_672_8, lo: -3.878_294_158_067_241_4e-17 }, error: 1e-32 };

/// `B_2k/(2k(2k-1))` for k = 1, 2, …, 17, the coefficients of Stirling's series.
const STIRLING: [(f64, f64); 17] = [
    (0.08333333333333333, 4.625929269271485e-18),
    (-0.002777777777777778, 1.0601087908747154e-19),
    (0.0007936507936507937, 6.883823317368282e-22),
    (-0.0005952380952380953, 5.36938218754726e-20),
    (0.0008417508417508417, 3.6870174889237694e-20),
    (-0.0019175269175269176, 1.0675702776872475e-19),
    (0.00641025641025641, 2.2240044563805217e-19),
    (-0.029550653594771242, 4.861760957508855e-19),
    (0.17964437236883057, -6.401600482710946e-19),
    (-1.3924322169059011, 1.5837056989230303e-17),
    (13.402864044168393, -6.154114101993966e-16),
    (-156.84828462600203, 9.391823141715389e-15),
    (2193.1033333333335, -1.3339255626002948e-13),
    (-36108.77125372499, 5.897583353514365e-13),
    (691472.268851313, 2.5585296305158e-11),
    (-15238221.539407415, -8.76774522490625e-10),
    (382900751.39141417, -2.4082684757733585e-08),
];

/// Numerators and denominators of `B_2, B_4, …, B_34`.
pub(super) const BERNOULLI: [(f64, f64); 17] = [
    (1.0, 6.0),
    (-1.0, 30.0),
    (1.0, 42.0),
    (-1.0, 30.0),
    (5.0, 66.0),
    (-691.0, 2730.0),
    (7.0, 6.0),
    (-3617.0, 510.0),
    (43867.0, 798.0),
    (-174611.0, 330.0),
    (854513.0, 138.0),
    (-236364091.0, 2730.0),
    (8553103.0, 6.0),
    (-23749461029.0, 870.0),
    (8615841276005.0, 14322.0),
    (-7709321041217.0, 510.0),
    (2577687858367.0, 6.0),
];

/// Euler's numbers `E_2, E_4, …, E_34`, each as the nearest double and the rest.
const EULER: [(f64, f64); 17] = [
    (-1.0, 0.0),
    (5.0, 0.0),
    (-61.0, 0.0),
    (1385.0, 0.0),
    (-50521.0, 0.0),
    (2702765.0, 0.0),
    (-199360981.0, 0.0),
    (19391512145.0, 0.0),
    (-2404879675441.0, 0.0),
    (370371188237525.0, 0.0),
    (-6.93488743931379e+16, 3.0),
    (1.5514534163557087e+19, -327.0),
    (-4.087072509293124e+21, 232311.0),
    (1.25225964140363e+24, -59571843.0),
    (-4.415438932490231e+26, 7818344571.0),
    (1.775193915795393e+29, -15070703486303.0),
    (-8.07232992358879e+31, 5878602840479.0),
];
