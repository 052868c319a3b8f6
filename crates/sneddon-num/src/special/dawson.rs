//! Dawson's integral and the error functions of both kinds.

use super::carried::{UNIT, exact, exponential, known, over, quotient, rounded, times};
use crate::double_double::{DoubleDouble, Precise};

/// 2/√π.
const TWO_OVER_ROOT_PI: DoubleDouble = DoubleDouble { hi: std::f64::consts::FRAC_2_SQRT_PI, lo: 1.533_545_961_316_588e-17 };
/// From here on e^(−z²) is below 10^-34.
const FAR: f64 = 9.0;

/// `D(z) = e^(-z^2) ∫_0^z e^(t^2) dt`, Dawson's integral.
///
/// Domain: all reals; odd. Accuracy: the 30-digit value rounded, at most 0.51 ulp measured.
///
/// ```
/// use sneddon_num::special::dawson;
/// assert!((dawson(1.0) - 0.538_079_506_912_768_4).abs() < 1e-16);
/// assert_eq!(dawson(1e300), 5e-301);
/// ```
pub fn dawson(z: f64) -> f64 {
    if z.is_infinite() {
        return 0.0_f64.copysign(z);
    }
    rounded(dawson_precise(z.into()))
}

/// `D(z)` to about 29 digits, with its error.
///
/// Method: `e^(-z^2) Σ z^(2k+1)/(k! (2k+1))`, all terms positive, up to `z = 9`; the asymptotic series beyond.
/// Source: DLMF 7.2.5, 7.6.4, 7.12.1 for imaginary argument.
///
/// ```
/// let value = sneddon_num::special::dawson_precise(1.0.into());
/// assert!((value.value.hi - 0.538_079_506_912_768_4).abs() < 1e-15 && value.error < 1e-29);
/// ```
pub fn dawson_precise(z: DoubleDouble) -> Precise {
    if !z.hi.is_finite() {
        return Precise::nan();
    }
    if z.hi.abs() > FAR {
        return asymptotic(z);
    }
    let square = z.mul(z);
    exponential(Precise { value: square.neg(), error: 2.0 * UNIT * square.hi }, rising(z))
}

/// `erfi(z) = (2/sqrt(pi)) ∫_0^z e^(t^2) dt`.
///
/// Domain: all reals; infinite beyond 26.64. Accuracy: the 30-digit value rounded, at most 0.51 ulp measured.
///
/// ```
/// use sneddon_num::special::erfi;
/// assert!((erfi(1.0) - 1.650_425_758_797_542_9).abs() < 3e-16);
/// ```
pub fn erfi(z: f64) -> f64 {
    if z.abs() > 27.0 {
        return f64::INFINITY.copysign(z);
    }
    let value = erfi_precise(z.into());
    if value.value.hi.is_infinite() { value.value.hi } else { rounded(value) }
}

/// `erfi(z)` to about 29 digits, with its error; infinite if a double overflows.
///
/// ```
/// let value = sneddon_num::special::erfi_precise(1.0.into());
/// assert!((value.value.hi - 1.650_425_758_797_542_9).abs() < 1e-15 && value.error < 1e-28);
/// ```
pub fn erfi_precise(z: DoubleDouble) -> Precise {
    if z.hi.is_nan() {
        return Precise::nan();
    }
    if z.hi.abs() > 27.0 {
        return Precise { value: f64::INFINITY.copysign(z.hi).into(), error: f64::INFINITY };
    }
    let factor = known(TWO_OVER_ROOT_PI, 1.0);
    if z.hi.abs() <= FAR {
        return times(factor, rising(z));
    }
    let square = z.mul(z);
    exponential(Precise { value: square, error: 2.0 * UNIT * square.hi }, times(factor, asymptotic(z)))
}

/// `erf(z) = (2/sqrt(pi)) ∫_0^z e^(-t^2) dt` to about 29 digits, with its error.
///
/// Domain: all reals. Method: `e^(-z^2) Σ 2^k z^(2k+1)/(1·3···(2k+1))`, all terms positive, up to `z = 9`; 1 beyond,
/// within `10^-36`. Source: DLMF 7.6.2.
///
/// ```
/// use sneddon_num::special::erf_precise;
/// assert_eq!(erf_precise(0.5.into()).value.value(), libm::erf(0.5));
/// ```
pub fn erf_precise(z: DoubleDouble) -> Precise {
    if z.hi.is_nan() {
        return Precise::nan();
    }
    if z.hi.abs() > FAR {
        return Precise { value: 1.0_f64.copysign(z.hi).into(), error: 1e-36 };
    }
    let square = z.mul(z);
    let (mut sum, mut term, mut units) = (z, z, 0.0);
    for k in 1..600_u32 {
        let odd = f64::from(2 * k + 1);
        term = quotient(term.mul(square), 0.5 * odd);
        sum = sum.add(term);
        units += 6.0 * f64::from(k) * term.hi.abs() + sum.hi.abs();
        if term.hi.abs() <= sum.hi.abs() * UNIT / 512.0 && odd > 4.0 * square.hi {
            break;
        }
    }
    let series = Precise { value: sum, error: UNIT * (units + sum.hi.abs() / 256.0) };
    let decay = Precise { value: square.neg(), error: 2.0 * UNIT * square.hi };
    exponential(decay, times(known(TWO_OVER_ROOT_PI, 1.0), series))
}

/// ∫_0^z e^(t²) dt = Σ z^(2k+1)/(k! (2k+1)).
fn rising(z: DoubleDouble) -> Precise {
    let square = z.mul(z);
    let (mut sum, mut power, mut units) = (z, z, 0.0);
    for k in 1..600_u32 {
        let whole = f64::from(k);
        power = quotient(power.mul(square), whole);
        let term = quotient(power, 2.0 * whole + 1.0);
        sum = sum.add(term);
        units += (6.0 * whole + 2.0) * term.hi.abs() + sum.hi.abs();
        if term.hi.abs() <= sum.hi.abs() * UNIT / 512.0 && whole > 2.0 * square.hi {
            break;
        }
    }
    Precise { value: sum, error: UNIT * (units + sum.hi.abs() / 256.0) }
}

/// 1/(2z) Σ (2k−1)!!/(2z²)^k.
fn asymptotic(z: DoubleDouble) -> Precise {
    let lead = over(exact(0.5), exact(z));
    if z.hi.abs() > 1e20 {
        return lead;
    }
    let inverse = DoubleDouble::from(0.5).div(z.mul(z));
    let (mut sum, mut term, mut units) = (DoubleDouble::ONE, DoubleDouble::ONE, 0.0);
    let mut rest = f64::INFINITY;
    for k in 1..400_u32 {
        let next = term.mul(inverse).mul(f64::from(2 * k - 1).into());
        if next.hi < UNIT / 512.0 || next.hi >= term.hi {
            rest = 4.0 * next.hi.min(term.hi);
            break;
        }
        term = next;
        sum = sum.add(term);
        units += 8.0 * f64::from(k) * term.hi + sum.hi;
    }
    times(lead, Precise { value: sum, error: UNIT * units + rest })
}
