//! Miller's backward recurrence for J, which loses nothing to cancellation, and the Neumann sums that come with it.

use crate::double_double::{DoubleDouble, Precise};
use crate::special::bessel::leading::bessel_leading;
use crate::special::carried::{TINY, UNIT, exact, multiple, over, quotient, times};
use crate::work;

/// Beyond this the sequence is scaled down.
const LARGE: f64 = 1e180;
const SMALLER: f64 = 1.0 / (1_u128 << 120) as f64;

/// The result of one run of the recurrence.
pub(crate) struct Backward {
    /// J of the wanted order and of the next.
    pub(crate) wanted: [Precise; 2],
    /// J_0.
    pub(crate) zeroth: Precise,
    /// Σ J_(2k+1)/(2k+1) over k >= 0.
    pub(crate) odd: Precise,
    /// Σ J_(2k)/(4k²−1) over k >= 1.
    pub(crate) even: Precise,
}

/// J_(f+m)(z) for 0 <= f < 1, z >= 1; the Neumann sums are computed on request and are valid for f = 0 only.
///
/// Source: DLMF 3.6(v), 10.12.4, 10.23.15.
pub(crate) fn backward(f: DoubleDouble, m: u32, z: DoubleDouble, neumann: bool) -> Backward {
    let turning = z.hi.max(f64::from(m));
    // Beyond the turning point 24 widths are 36 digits.
    let top = 2 * ((turning + 24.0 * turning.cbrt() + 4.0) / 2.0).ceil() as u32;
    work::spend(26 + 5 * u64::from(top));
    let weights = weights(f, top / 2);
    let step = DoubleDouble::from(2.0).div(z);
    let (zero, whole) = (DoubleDouble::from(0.0), f.hi == 0.0);
    let (mut above, mut now) = (zero, DoubleDouble::from(1e-100));
    let (mut norm, mut odd, mut even) = (zero, zero, zero);
    let mut sizes = [0.0; 3];
    let mut wanted = [zero; 2];
    let mut index = top;
    loop {
        if let Some(slot) = index.checked_sub(m).and_then(|above| wanted.get_mut(above as usize)) {
            *slot = now;
        }
        if index % 2 == 1 {
            if neumann {
                let part = quotient(now, f64::from(index));
                odd = odd.add(part);
                sizes[1] += part.hi.abs();
            }
        } else {
            let part = match weights.get((index / 2) as usize) {
                Some(weight) => now.mul(*weight),
                None if index == 0 => now,
                None => now.scale(2.0),
            };
            norm = norm.add(part);
            sizes[0] += part.hi.abs();
            if neumann && index > 0 {
                let order = f64::from(index);
                let part = quotient(now, order * order - 1.0);
                even = even.add(part);
                sizes[2] += part.hi.abs();
            }
        }
        if index == 0 {
            break;
        }
        let factor = if whole { multiple(step, f64::from(index)) } else { step.mul(f.add(f64::from(index).into())) };
        let below = now.mul(factor).sub(above);
        (above, now) = (now, below);
        if now.hi.abs() > LARGE {
            for value in [&mut above, &mut now, &mut norm, &mut odd, &mut even].into_iter().chain(&mut wanted) {
                *value = value.scale(SMALLER);
            }
            sizes = sizes.map(|size| size * SMALLER);
        }
        index -= 1;
    }
    // Roundings of the recurrence stay bounded where J oscillates; measured below a quarter of this.
    let each = UNIT * (24.0 + f64::from(top));
    let sum = Precise { value: norm, error: each * sizes[0] };
    let scale = if whole { over(exact(DoubleDouble::ONE), sum) } else { over(bessel_leading(f, z.scale(0.5)), sum) };
    let envelope = (2.0 / z.hi.sqrt()).min(1.0) / scale.value.hi.abs();
    let ready = |value: DoubleDouble, size: f64| times(Precise { value, error: each * size + TINY }, scale);
    let of_order = |value: DoubleDouble, order: u32| {
        let size = if f64::from(order) > z.hi { value.hi.abs() } else { value.hi.abs().max(envelope) };
        ready(value, size)
    };
    Backward {
        wanted: [of_order(wanted[0], m), of_order(wanted[1], m + 1)],
        zeroth: of_order(now, 0),
        odd: ready(odd, sizes[1]),
        even: ready(even, sizes[2]),
    }
}

/// (f+2k) Γ(f+k)/(k! Γ(1+f)) for k = 0, 1, …, which weight J_(f+2k) to give (z/2)^f/Γ(1+f); none for f = 0, where they are 1, 2,
/// 2, ….
fn weights(f: DoubleDouble, count: u32) -> Vec<DoubleDouble> {
    if f.hi == 0.0 {
        return Vec::new();
    }
    let mut list = vec![DoubleDouble::ONE];
    let mut ratio = DoubleDouble::ONE;
    for k in 1..=count {
        let k = f64::from(k);
        list.push(ratio.mul(f.add((2.0 * k).into())));
        ratio = quotient(ratio.mul(f.add(k.into())), k + 1.0);
    }
    list
}
