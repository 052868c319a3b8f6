//! Hankel's asymptotic series of Bessel functions of large arguments.

use crate::double_double::{DoubleDouble, Precise};
use crate::precise::{PI, sin_cos};
use crate::special::carried::{TINY, TWO_OVER_PI, UNIT, exact, exponential, minus, plus, quotient, root, times};
use crate::work;

/// 1/√2.
const ROOT_HALF: DoubleDouble = DoubleDouble { hi: std::f64::consts::FRAC_1_SQRT_2, lo: -4.833_646_656_726_457e-17 };
/// Beyond this the series is 1 and z has no fraction.
const ENDLESS: f64 = 1e40;
/// Steps of work for a term of the series.
const STEPS_PER_TERM: u64 = 9;

/// J_n(z) and Y_n(z) for large z, any real n.
///
/// Source: DLMF 10.17.3, 10.17.4; the error is bounded by the first neglected term, which holds for k > n/2 (10.17(iii)).
pub(crate) fn oscillating(n: DoubleDouble, z: DoubleDouble) -> (Precise, Precise) {
    let (p, q) = if z.hi > ENDLESS { (exact(DoubleDouble::ONE), exact(0.0)) } else { pieces(n, z) };
    let (sine, cosine) = phase(n, z);
    let amplitude = amplitude(z);
    let j = times(amplitude, minus(times(p, cosine), times(q, sine)));
    let y = times(amplitude, plus(times(p, sine), times(q, cosine)));
    (j, y)
}

/// e^shift I_n(z) for large z; shift = −z gives the scaled function.
///
/// Source: DLMF 10.40.1; the neglected e^(−2z) is below 10^-34.
pub(crate) fn growing(n: DoubleDouble, z: DoubleDouble, scaled: bool) -> Precise {
    let sum = if z.hi > ENDLESS { exact(DoubleDouble::ONE) } else { alternating(n, z) };
    let factor = times(sum, times(amplitude(z), exact(0.5)));
    if scaled { factor } else { exponential(exact(z), factor) }
}

/// √(2/(π z)).
fn amplitude(z: DoubleDouble) -> Precise {
    let shift = if z.hi > 1e200 { 2.0_f64.powi(-600) } else { 1.0 };
    let ratio = Precise { value: TWO_OVER_PI.div(z.scale(shift)), error: 0.0 };
    let size = root(Precise { error: 5.0 * UNIT * ratio.value.hi, ..ratio });
    let back = shift.sqrt();
    Precise { value: size.value.scale(back), error: size.error * back + TINY }
}

/// a_k(n)/z^k for k = 1, 2, … until they are negligible, and the size of the first neglected term.
fn terms(n: DoubleDouble, z: DoubleDouble, mut take: impl FnMut(u32, DoubleDouble, f64)) -> f64 {
    let four = n.mul(n).scale(4.0);
    let (mut term, mut size) = (DoubleDouble::ONE, 1.0_f64);
    for k in 1..400_u32 {
        work::spend(STEPS_PER_TERM);
        let order = f64::from(k);
        let odd = 2.0 * order - 1.0;
        let next = quotient(term.mul(four.sub((odd * odd).into())), 8.0 * order).div(z);
        let (now, before) = (next.hi.abs(), term.hi.abs());
        if now == 0.0 {
            return 0.0;
        }
        size = size.max(now);
        // Past k = n/2 the terms bound the rest; the smallest is the last.
        if order > 0.5 * n.hi.abs() + 1.0 && (now >= before || now < size * UNIT / 1024.0) {
            return now.min(before);
        }
        if now > 1e60 {
            return f64::INFINITY;
        }
        term = next;
        take(k, term, 8.0 * order);
    }
    f64::INFINITY
}

/// P = Σ (−1)^k a_2k/z^2k and Q = Σ (−1)^k a_(2k+1)/z^(2k+1).
fn pieces(n: DoubleDouble, z: DoubleDouble) -> (Precise, Precise) {
    let (mut p, mut q) = (DoubleDouble::ONE, DoubleDouble::from(0.0));
    let (mut p_units, mut q_units) = (1.0, 0.0);
    let rest = terms(n, z, |k, term, units| {
        let signed = if k % 4 < 2 { term } else { term.neg() };
        if k % 2 == 0 {
            p = p.add(signed);
            p_units += units * term.hi.abs() + p.hi.abs();
        } else {
            q = q.add(signed);
            q_units += units * term.hi.abs() + q.hi.abs();
        }
    });
    (Precise { value: p, error: UNIT * p_units + rest }, Precise { value: q, error: UNIT * q_units + rest })
}

/// Σ (−1)^k a_k/z^k.
fn alternating(n: DoubleDouble, z: DoubleDouble) -> Precise {
    let (mut sum, mut units) = (DoubleDouble::ONE, 1.0);
    let rest = terms(n, z, |k, term, own| {
        sum = if k % 2 == 0 { sum.add(term) } else { sum.sub(term) };
        units += own * term.hi.abs() + sum.hi.abs();
    });
    Precise { value: sum, error: UNIT * units + 2.0 * rest }
}

/// sin χ and cos χ with χ = z − n π/2 − π/4.
fn phase(n: DoubleDouble, z: DoubleDouble) -> (Precise, Precise) {
    let (sine, cosine) = circular(z);
    // A quarter of π less.
    let eighth = exact(ROOT_HALF);
    let (sine, cosine) = (times(eighth, minus(sine, cosine)), times(eighth, plus(sine, cosine)));
    let whole = n.hi.round();
    let (sine, cosine) = match whole.rem_euclid(4.0) as u8 {
        0 => (sine, cosine),
        1 => (opposite(cosine), sine),
        2 => (opposite(sine), opposite(cosine)),
        _ => (cosine, opposite(sine)),
    };
    let fraction = n.sub(whole.into());
    if fraction.hi == 0.0 {
        return (sine, cosine);
    }
    let (s, c) = circular(PI.scale(0.5).mul(fraction));
    (minus(times(sine, c), times(cosine, s)), plus(times(cosine, c), times(sine, s)))
}

fn opposite(a: Precise) -> Precise {
    crate::special::carried::opposite(a)
}

/// sin z and cos z.
fn circular(z: DoubleDouble) -> (Precise, Precise) {
    let (sine, cosine) = sin_cos(z);
    let bound = |value: DoubleDouble| Precise { value, error: 4.0 * UNIT };
    (bound(sine), bound(cosine))
}
