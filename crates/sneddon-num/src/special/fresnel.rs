//! Fresnel integrals.

use super::carried::{UNIT, exact, known, minus, multiple, opposite, over, plus, quotient, rounded, times};
use crate::double_double::{DoubleDouble, Precise, two_sum};
use crate::precise::{PI, sin_cos};

/// From u = π z²/2 = 82 on the asymptotic series, whose smallest term is e^(−u), has 30 digits.
const FAR: f64 = 82.0;
/// Beyond this 1/2 is right to 40 digits.
const ENDLESS: f64 = 1e40;

/// `C(z) = ∫_0^z cos(pi t^2/2) dt`.
///
/// Domain: all reals; odd. Accuracy: the 30-digit value rounded, at most 0.51 ulp measured.
///
/// ```
/// use sneddon_num::special::fresnelc;
/// assert!((fresnelc(1.0) - 0.779_893_400_376_822_8).abs() < 2e-16);
/// ```
pub fn fresnelc(z: f64) -> f64 {
    finished(z, fresnelc_precise)
}

/// `S(z) = ∫_0^z sin(pi t^2/2) dt`.
///
/// Domain: all reals; odd. Accuracy: the 30-digit value rounded, at most 0.51 ulp measured.
///
/// ```
/// use sneddon_num::special::fresnels;
/// assert!((fresnels(1.0) - 0.438_259_147_390_354_8).abs() < 1e-16);
/// ```
pub fn fresnels(z: f64) -> f64 {
    finished(z, fresnels_precise)
}

/// `C(z)` to about 29 digits, with its error.
///
/// Method: `z Σ j_(2k)(u)` over spherical Bessel functions of `u = pi z^2/2`, which does not cancel, by Miller's
/// recurrence; the power series for `u < 1`, the auxiliary functions f and g for `u > 82`.
/// Source: DLMF 7.6.10, 7.6.4, 7.12.2, 7.5.3.
///
/// ```
/// let value = sneddon_num::special::fresnelc_precise(1.0.into());
/// assert!((value.value.hi - 0.779_893_400_376_822_8).abs() < 1e-15 && value.error < 1e-29);
/// ```
pub fn fresnelc_precise(z: DoubleDouble) -> Precise {
    odd(z, 0)
}

/// `S(z)` to about 29 digits, with its error; as [`fresnelc_precise`] with `z Σ j_(2k+1)(u)`.
///
/// ```
/// let value = sneddon_num::special::fresnels_precise(1.0.into());
/// assert!((value.value.hi - 0.438_259_147_390_354_8).abs() < 1e-15 && value.error < 1e-29);
/// ```
pub fn fresnels_precise(z: DoubleDouble) -> Precise {
    odd(z, 1)
}

fn finished(z: f64, precise: fn(DoubleDouble) -> Precise) -> f64 {
    if z.is_infinite() { 0.5_f64.copysign(z) } else { rounded(precise(z.into())) }
}

fn odd(z: DoubleDouble, parity: u32) -> Precise {
    if !z.hi.is_finite() {
        return Precise::nan();
    }
    if z.hi < 0.0 {
        return opposite(positive(z.neg(), parity));
    }
    positive(z, parity)
}

/// C for parity 0, S for parity 1.
fn positive(z: DoubleDouble, parity: u32) -> Precise {
    if z.hi > ENDLESS {
        return Precise { value: 0.5.into(), error: 0.5 / ENDLESS };
    }
    let u = PI.scale(0.5).mul(z.mul(z));
    if u.hi < 1.0 {
        return power_series(z, u, parity);
    }
    if u.hi < FAR {
        return spherical(z, u, parity);
    }
    let ((f, g), (sine, cosine)) = (auxiliary(z), turned(z));
    let wave = if parity == 0 { minus(times(f, sine), times(g, cosine)) } else { opposite(plus(times(f, cosine), times(g, sine))) };
    plus(exact(0.5), wave)
}

/// z Σ (−1)^k u^(2k+p)/((2k+p)! (4k+2p+1)).
fn power_series(z: DoubleDouble, u: DoubleDouble, parity: u32) -> Precise {
    let square = u.mul(u).neg();
    let start = if parity == 0 { DoubleDouble::ONE } else { u };
    if start.hi == 0.0 {
        return known(start, 0.0);
    }
    let p = f64::from(parity);
    let (mut power, mut units) = (start, 4.0);
    let mut sum = quotient(start, 2.0 * p + 1.0);
    for k in 1..40_u32 {
        let order = f64::from(2 * k) + p;
        power = quotient(power.mul(square), order * (order - 1.0));
        let term = quotient(power, 2.0 * order + 1.0);
        sum = sum.add(term);
        units += (12.0 * order * term.hi.abs() + sum.hi.abs()) / start.hi;
        if term.hi.abs() < start.hi * UNIT / 1024.0 {
            break;
        }
    }
    times(exact(z), Precise { value: sum, error: UNIT * units * start.hi })
}

/// z Σ j_(2k+p)(u) by Miller's recurrence, scaled by the larger of j_0 and j_1.
fn spherical(z: DoubleDouble, u: DoubleDouble, parity: u32) -> Precise {
    let top = (u.hi + 24.0 * u.hi.cbrt() + 8.0).ceil() as u32;
    let inverse = DoubleDouble::ONE.div(u);
    let zero = DoubleDouble::from(0.0);
    let (mut above, mut now, mut sum, mut size) = (zero, DoubleDouble::from(1e-60), zero, 0.0);
    for order in (1..=top).rev() {
        if order % 2 == parity {
            sum = sum.add(now);
            size += now.hi.abs();
        }
        let below = now.mul(multiple(inverse, f64::from(2 * order + 1))).sub(above);
        (above, now) = (now, below);
    }
    if parity == 0 {
        sum = sum.add(now);
        size += now.hi.abs();
    }
    let (sine, cosine) = turned(z);
    let (u_known, each) = (known(u, 4.0), UNIT * (24.0 + f64::from(top)));
    let zeroth = over(sine, u_known);
    let first = over(minus(zeroth, cosine), u_known);
    // Roundings of the recurrence are relative to its envelope.
    let envelope = now.hi.abs().max(above.hi.abs());
    let scale = if now.hi.abs() > above.hi.abs() {
        over(zeroth, Precise { value: now, error: each * envelope })
    } else {
        over(first, Precise { value: above, error: each * envelope })
    };
    times(exact(z), times(Precise { value: sum, error: each * size.max(envelope) }, scale))
}

/// sin(π z²/2) and cos(π z²/2); whole turns are taken off the square, which has no error where z is one double.
fn turned(z: DoubleDouble) -> (Precise, Precise) {
    let square = z.mul(z);
    let rest = two_sum(square.hi % 4.0, square.lo % 4.0);
    let rest = if rest.hi > 2.0 { rest.sub(4.0.into()) } else { rest };
    let own = if z.lo == 0.0 { 0.0 } else { 2.0 * square.hi };
    let (sine, cosine) = sin_cos(PI.scale(0.5).mul(rest));
    let bound = |value: DoubleDouble| Precise { value, error: UNIT * (2.0 * own + 8.0 * rest.hi.abs() + 2.0) };
    (bound(sine), bound(cosine))
}

/// f(z) = (1/(π z)) Σ (−1)^m (4m−1)!!/(π z²)^(2m), g(z) = (1/(π² z³)) Σ (−1)^m (4m+1)!!/(π z²)^(2m).
fn auxiliary(z: DoubleDouble) -> (Precise, Precise) {
    let lead = over(exact(DoubleDouble::ONE), times(known(PI, 1.0), exact(z)));
    let inverse = over(lead, exact(z));
    let square = inverse.value.mul(inverse.value);
    let sum = |first: f64| {
        let (mut sum, mut term, mut units) = (DoubleDouble::ONE, DoubleDouble::ONE, 0.0);
        for m in 0..200_u32 {
            let low = f64::from(4 * m) + first;
            let next = term.mul(square).mul((-low * (low + 2.0)).into());
            let (now, before) = (next.hi.abs(), term.hi.abs());
            if now < UNIT / 512.0 || now >= before {
                return Precise { value: sum, error: UNIT * units + now.min(before) };
            }
            term = next;
            sum = sum.add(term);
            units += 16.0 * f64::from(m + 1) * now + sum.hi.abs();
        }
        Precise::nan()
    };
    (times(lead, sum(1.0)), times(times(lead, inverse), sum(3.0)))
}
