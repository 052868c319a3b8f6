//! Powers whose exponent is a double plus a small correction.

use super::Bounded;
use super::bounded::UNIT;

/// Up to this rest of the exponent an estimate of the logarithm suffices.
const SHORT: f64 = 5e-16;
/// Up to this rest of the exponent its second-order effect on the power is negligible.
const LONG: f64 = 1e-13;
/// Bound on the error of [`estimated_ln`].
const ESTIMATE: f64 = 0.0061;

/// base^(nearest + rest) for base ≥ 0 and a rest below half an ulp of `nearest`; at most 1.6 ulp for exponents below 4.
///
/// Computes p = base^nearest, then p + p·rest·ln base, which avoids the cost of a second power.
///
/// ```
/// use sneddon_num::real_power;
/// // 2^2.7, whose nearest double is 2.7 + 1.8e-16
/// let value = real_power(2.0, 2.7, -1.776_356_839_400_250_5e-16);
/// assert!((value - 6.498_019_170_849_884).abs() < 1e-15);
/// ```
#[inline]
pub fn real_power(base: f64, nearest: f64, rest: f64) -> f64 {
    corrected_power(base.powf(nearest), base, rest)
}

/// base^(nearest + rest) from base^nearest.
#[inline(always)]
pub fn corrected_power(power: f64, base: f64, rest: f64) -> f64 {
    if rest.abs() <= SHORT && base >= f64::MIN_POSITIVE && power <= f64::MAX {
        return power + power * (rest * estimated_ln(base));
    }
    if !power.is_finite() || power == 0.0 {
        power
    } else if rest.abs() <= LONG {
        power + power * (rest * base.ln())
    } else {
        power * base.powf(rest)
    }
}

/// Relative error of [`real_power`] in addition to the error of base^nearest.
pub fn real_power_part(rest: f64, error_of_rest: f64) -> f64 {
    // No logarithm of a double is larger than 745.
    let unknown = 745.2 * error_of_rest;
    let own = if rest.abs() > LONG { 4.0 * UNIT } else { UNIT + ESTIMATE * rest.abs() };
    (own + unknown) * 1.001
}

/// ln x within 0.0061, from the bits of a normal x.
#[inline]
fn estimated_ln(x: f64) -> f64 {
    const MANTISSA: u64 = 0x000f_ffff_ffff_ffff;
    let bits = x.to_bits();
    let exponent = (bits >> 52) as i32 - 1023;
    let part = f64::from_bits((bits & MANTISSA) | 1.0_f64.to_bits()) - 1.0;
    std::f64::consts::LN_2 * (f64::from(exponent) + part + 0.3397 * part * (1.0 - part))
}

impl Bounded {
    /// self^(nearest + rest), where the rest carries an error; see [`real_power`].
    #[must_use]
    pub fn real_power(self, nearest: f64, rest: Self) -> Self {
        if self.value == 0.0 && nearest > 0.0 {
            // 0 to a tiny negative rest of the exponent would be infinite.
            return Self { value: 0.0, error: if self.error > 0.0 { self.error.powf(nearest) * (1.0 + 1e-9) } else { 0.0 } };
        }
        let power = self.powf(Self::exact(nearest));
        if power.value == 0.0 || !power.is_finite() || self.value < f64::MIN_POSITIVE {
            return power * self.powf(rest);
        }
        let value = real_power(self.value, nearest, rest.value);
        let error = power.error * (1.0 + 1e-9) + value.abs() * real_power_part(rest.value, rest.error);
        Self::checked(value, error * (1.0 + 16.0 * UNIT) + 8.0 * f64::from_bits(1))
    }
}

#[cfg(test)]
mod tests {
    use super::{ESTIMATE, estimated_ln};

    #[test]
    fn the_estimate_of_the_logarithm() {
        let worst = (0..100_000).map(|i| 1e-3 * 1.0002_f64.powi(i)).map(|x| (estimated_ln(x) - x.ln()).abs()).fold(0.0, f64::max);
        assert!(worst < ESTIMATE, "{worst}");
    }
}
