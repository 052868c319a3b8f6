//! Integrals of powers of r − b over a segment, with about 30 digits.

use super::atan2;
use crate::double_double::{DoubleDouble, Precise};

/// Bound on the error of the series, in units of 2^-104: a hundred sums at most.
const SERIES: f64 = 100.0;
/// Bound on the error of the angle, in the same units: at most 1.3 against mpmath at 20,000 pairs of ends.
const ANGLE: f64 = 4.0;
/// Larger powers on a segment with an upper end are left to double precision.
const LARGEST: u32 = 24;

/// ∫_b^x (r−b)^k/√(x²−r²) dr, at exact arguments.
///
/// With h = x − b this is h^(k+1/2)/√(2x) B(k+1, 1/2) ₂F₁(1/2, 1/2; k+3/2; h/(2x)): every term is positive, the ratio at most 1/2.
/// Source: Euler's integral with r = b + h t, Pfaff's transformation.
///
/// ```
/// use sneddon_num::precise::{acos, shifted_power};
/// let angle = shifted_power(0, 0.25.into(), None, 1.0.into());
/// assert!(angle.value.sub(acos(0.25.into())).value().abs() <= angle.error && angle.error < 1e-28);
/// ```
pub fn shifted_power(k: u32, b: DoubleDouble, c: Option<DoubleDouble>, x: DoubleDouble) -> Precise {
    between(k, b, c, x, open)
}

/// ∫_b^min(c,a) (r−b)^k r²/√(a²−r²) dr, at exact arguments.
pub fn shifted_power_force(k: u32, b: DoubleDouble, c: Option<DoubleDouble>, a: DoubleDouble) -> Precise {
    between(k, b, c, a, |k, e, a| {
        // r² = (r−e)² + 2e(r−e) + e²
        let end = Precise { value: e, error: 0.0 };
        let first = open(k + 1, e, a).mul(Precise::exact(2.0)).add(open(k, e, a).mul(end));
        open(k + 2, e, a).add(first.mul(end))
    })
}

/// The integral from b less the one from c, in powers of r − c.
fn between(
    k: u32,
    b: DoubleDouble,
    c: Option<DoubleDouble>,
    x: DoubleDouble,
    open: impl Fn(u32, DoubleDouble, DoubleDouble) -> Precise,
) -> Precise {
    if !(b.hi >= 0.0 && x.hi > 0.0 && x.hi.is_finite()) {
        return Precise::nan();
    }
    let whole = open(k, b, x);
    let Some(c) = c.filter(|c| c.sub(x).hi < 0.0) else { return whole };
    if k > LARGEST {
        return Precise::nan();
    }
    let width = Precise::relative(c.sub(b), 1.0);
    let (mut rest, mut binomial) = (Precise::exact(0.0), 1.0);
    for j in 0..=k {
        let factor = width.pow(Precise::exact(f64::from(k - j))).mul(Precise::exact(binomial));
        rest = rest.add(factor.mul(open(j, c, x)));
        binomial = binomial * f64::from(k - j) / f64::from(j + 1);
    }
    whole.sub(rest)
}

fn open(k: u32, b: DoubleDouble, x: DoubleDouble) -> Precise {
    let height = x.sub(b);
    if height.hi.is_nan() || height.hi <= 0.0 {
        return Precise::exact(0.0);
    }
    if k == 0 {
        // acos(b/x) from the sides of its triangle, which keeps the digits of x − b.
        let (short, long) = (height.div(x), x.add(b).div(x));
        return Precise::relative(atan2(short.mul(long).sqrt(), b.div(x)), ANGLE);
    }
    let height = Precise::relative(height, 1.0);
    let across = Precise { value: x.scale(2.0), error: 0.0 };
    let series = Precise::relative(series(k, height.div(across).value), SERIES);
    let beta = (1..=k)
        .fold(Precise::exact(2.0), |beta, j| beta.mul(Precise::exact(2.0 * f64::from(j))).div(Precise::exact(2.0 * f64::from(j) + 1.0)));
    let power = height.pow(Precise::exact(f64::from(k)));
    power.mul(height.div(across).sqrt()).mul(beta).mul(series)
}

/// ₂F₁(1/2, 1/2; k + 3/2; z) for 0 <= z <= 1/2; terms below 2^-60 of the sum, whose own rounding counts no more, in single words.
fn series(k: u32, z: DoubleDouble) -> DoubleDouble {
    let ratio = |n: f64| ((n + 0.5) * (n + 0.5), (f64::from(k) + 1.5 + n) * (n + 1.0));
    let (mut sum, mut term) = (DoubleDouble::ONE, DoubleDouble::ONE);
    let mut n = 0.0;
    while term.hi >= sum.hi * 2.0_f64.powi(-60) && n < 120.0 {
        let (above, below) = ratio(n);
        term = term.mul(z).mul(above.into()).over(below);
        sum = sum.add(term);
        n += 1.0;
    }
    let (mut tail, mut last) = (0.0, term.hi);
    while last >= sum.hi * 2.0_f64.powi(-110) && n < 120.0 {
        let (above, below) = ratio(n);
        last *= z.hi * above / below;
        tail += last;
        n += 1.0;
    }
    sum.add(tail.into())
}
