//! Inverse circular functions.

use super::circular::sin_cos;
use super::{finite, frexp, ldexp};
use crate::double_double::DoubleDouble;

/// The angle of the point (x, y), in (−π, π], with a uniform relative error.
///
/// ```
/// use sneddon_num::precise::{PI, atan2};
/// let half = atan2(1.0.into(), 0.0.into());
/// assert!(half.sub(PI.scale(0.5)).value().abs() < 1e-31);
/// ```
pub fn atan2(y: DoubleDouble, x: DoubleDouble) -> DoubleDouble {
    let rough = y.hi.atan2(x.hi);
    if y.hi == 0.0 && x.hi > 0.0 || rough.is_nan() || !(x.hi.is_finite() && y.hi.is_finite()) || x.hi == 0.0 && y.hi == 0.0 {
        return rough.into();
    }
    let (_, size) = frexp(if x.hi.abs() > y.hi.abs() { x } else { y });
    if x.hi > 0.0 && y.hi.abs() < x.hi * 2.0_f64.powi(-60) {
        // The cube of the quotient is negligible.
        let ((up, shift), along) = (frexp(y), ldexp(x, -size));
        return finite(ldexp(up.div(along), shift - size));
    }
    let (x, y) = (ldexp(x, -size), ldexp(y, -size));
    let start = DoubleDouble::from(y.hi.atan2(x.hi));
    let (sine, cosine) = sin_cos(start);
    // The tangent of the remaining angle; its cube is negligible.
    start.add(y.mul(cosine).sub(x.mul(sine)).div(x.mul(cosine).add(y.mul(sine))))
}

/// The inverse of tan, in [−π/2, π/2].
pub fn atan(x: DoubleDouble) -> DoubleDouble {
    atan2(x, DoubleDouble::ONE)
}

/// The inverse of sin for |x| <= 1.
pub fn asin(x: DoubleDouble) -> DoubleDouble {
    atan2(x, leg(x))
}

/// The inverse of cos for |x| <= 1, with a small relative error also near 1.
pub fn acos(x: DoubleDouble) -> DoubleDouble {
    atan2(leg(x), x)
}

/// √(1 − x²).
fn leg(x: DoubleDouble) -> DoubleDouble {
    DoubleDouble::ONE.sub(x).mul(DoubleDouble::ONE.add(x)).sqrt()
}
