//! Clausen's integral, and the even zeta values that dilogarithms share.

use super::ball::{Ball, UNIT};
use crate::special::ball::ENOUGH;
use crate::special::ball::elementary::{LN_2, PI};
use crate::{DoubleDouble, Precise};

/// Clausen's integral `Cl_2(z) = Σ sin(k z)/k^2 = -∫_0^z ln|2 sin(t/2)| dt`, mpmath's `clsin(2, z)`.
///
/// Domain: finite `z` up to 1e15 in size, odd, of period 2π; NaN elsewhere.
/// Accuracy: measured at most 0.51 ulp for `|z| <= 2π`, NaN where the argument's own digits give no double.
///
/// Source: as [`clsin2_precise`].
///
/// ```
/// use sneddon_num::special::clsin2;
/// assert!((clsin2(std::f64::consts::FRAC_PI_2) - 0.915_965_594_177_219).abs() < 1e-15);
/// ```
pub fn clsin2(z: f64) -> f64 {
    if z == 0.0 {
        return 0.0;
    }
    clausen(z.into()).rounded(ENOUGH)
}

/// [`clsin2`] with about 30 digits.
///
/// Method: reduction to `[0, π]`; up to 2π/3 the series about 0 with its logarithm, beyond that the one about π.
///
/// Source: Lewin 1981, chapter 4; DLMF 25.12.9.
///
/// ```
/// use sneddon_num::special::clsin2_precise;
/// assert!(clsin2_precise(1.0.into()).error < 1e-29);
/// ```
pub fn clsin2_precise(z: DoubleDouble) -> Precise {
    clausen(Ball::exact(z)).precise()
}

pub(super) fn clausen(z: Ball) -> Ball {
    if !z.hi().is_finite() || z.hi().abs() > 1e15 {
        return Ball::NONE;
    }
    if z.hi() == 0.0 {
        return Ball { value: z.value, error: if z.error > 0.0 { f64::INFINITY } else { 0.0 } };
    }
    // The nearest multiple of π first, so that the distance to it keeps its digits.
    let halves = (z.hi() / FLAT[0]).round();
    let rest = reduced(z, FLAT, halves);
    if halves % 2.0 != 0.0 && rest.hi().abs() < 1.1 {
        return about_flat(-rest);
    }
    let angle = reduced(z, TURN, (z.hi() / TURN[0]).round());
    if angle.hi() < 0.0 { -half_turn(-angle) } else { half_turn(angle) }
}

/// `z` less a multiple of a period in three parts.
fn reduced(z: Ball, period: [f64; 3], times: f64) -> Ball {
    if times == 0.0 {
        return z;
    }
    period.iter().fold(z, |rest, part| rest - Ball::from(*part) * times).widened(times.abs() * 1e-48)
}

fn divisor(k: u32) -> f64 {
    f64::from(k) * f64::from(2 * k + 1)
}

/// `Cl_2` on [0, π]: up to 2.1 by `θ (1 - ln θ + Σ ζ(2k) (θ/2π)^(2k) / (k (2k+1)))`.
fn half_turn(angle: Ball) -> Ball {
    if angle.hi() == 0.0 {
        return Ball::ZERO.widened(angle.error.sqrt());
    }
    if angle.hi() > 2.1 {
        return about_flat(PI - angle);
    }
    let square = (angle / PI.scale(2.0)).square();
    angle * (Ball::ONE - angle.ln() + even_series(square, divisor))
}

/// `Cl_2(π - φ) = φ (ln 2 - Σ ζ(2k) (1 - 2^(-2k)) (φ/π)^(2k) / (k (2k+1)))`, odd in `φ`.
fn about_flat(rest: Ball) -> Ball {
    let square = (rest / PI).square();
    rest * (LN_2 - (even_series(square, divisor) - even_series(square.scale(0.25), divisor)))
}

/// `Σ ζ(2k) square^k / d_k`, `|square| <= 1/8`.
pub(super) fn even_series(square: Ball, divisor: impl Fn(u32) -> f64) -> Ball {
    let (mut power, mut sum) = (square, Ball::ZERO);
    for (k, (hi, lo)) in (1_u32..).zip(EVEN_ZETA) {
        let zeta = Ball::exact(DoubleDouble { hi, lo }).widened(hi * 1e-32) + 1.0;
        let term = zeta * power / divisor(k);
        sum = sum + term;
        if term.hi().abs() < 1e-3 * UNIT * sum.hi().abs() {
            break;
        }
        power = power * square;
    }
    // What is left out: |square| <= 1/8, so less than twice the last power.
    sum.widened(power.hi().abs() * 2.0)
}

/// 2π in three parts.
const TURN: [f64; 3] = [std::f64::consts::TAU, 2.449_293_598_294_706_4e-16, -5.989_539_619_436_679e-33];
/// π in three parts.
const FLAT: [f64; 3] = [std::f64::consts::PI, 1.224_646_799_147_353_2e-16, -2.994_769_809_718_339_7e-33];

/// `ζ(2k) - 1` as the nearest double and the rest, k = 1, 2, …
const EVEN_ZETA: [(f64, f64); 35] = [
    (0.6449340668482264, 3.040672350398476e-17),
    (0.08232323371113819, 5.851757005110278e-18),
    (0.01734306198444914, -4.414770097141147e-19),
    (0.00407735619794434, -2.2242833400456106e-19),
    (0.0009945751278180853, 8.155271993117836e-20),
    (0.0002460865533080483, -2.126804481899407e-20),
    (6.124813505870483e-05, 1.5932044187197156e-21),
    (1.528225940865187e-05, 7.677620188142347e-22),
    (3.81729326499984e-06, -3.619576661891535e-22),
    (9.539620338727962e-07, -9.885419869008806e-23),
    (2.38450502727733e-07, -1.4348855177581243e-23),
    (5.960818905125948e-08, -4.84489270891793e-25),
    (1.4901554828365043e-08, -1.4462631435868446e-24),
    (3.725334024788457e-09, -2.2838109257068324e-25),
    (9.313274324196682e-10, 1.7251523768776834e-26),
    (2.3283118336765053e-10, 1.5614446225186379e-26),
    (5.820772087902701e-11, -5.609266140509216e-27),
    (1.4551921891041985e-11, -6.5815767720265535e-28),
    (3.637979547378651e-12, 3.2757482504856895e-28),
    (9.094947840263888e-13, 8.752915335828258e-29),
    (2.2737368458246524e-13, 7.510141332821777e-30),
    (5.684341987627585e-14, 1.9239561017173886e-30),
    (1.4210854828031608e-14, -1.5517661487563433e-30),
    (3.552713691337114e-15, -2.605702063609657e-31),
    (8.881784210930816e-16, -2.8972264863617053e-32),
    (2.220446050798042e-16, 7.73646017791737e-33),
    (5.551115124845481e-17, 2.5715123863172194e-33),
    (1.3877787809725232e-17, 8.207028574837895e-34),
    (3.4694469521659225e-18, 8.182699569203936e-35),
    (8.673617380119933e-19, 7.270441620769218e-35),
    (2.16840434499722e-19, -2.6579133519761065e-36),
    (5.421010862456646e-20, -4.309963443321265e-36),
    (1.3552527156101164e-20, 5.240608303185653e-37),
    (3.388131789020797e-21, 1.418107620820519e-37),
    (8.470329472546998e-22, 1.5756193314051866e-38),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(clsin2(0.0), 0.0);
        assert_eq!(clsin2(-1.0), -clsin2(1.0));
        assert!(clsin2(f64::INFINITY).is_nan() && clsin2(f64::NAN).is_nan());
        // Cl₂ ≈ ε (1 - ln ε) next to 0, and π - (the double nearest to π) is known.
        assert!(clsin2(1e-300) > 6.9e-298);
        assert!((clsin2(std::f64::consts::PI) / (1.224_646_799_147_353_2e-16 * std::f64::consts::LN_2) - 1.0).abs() < 1e-15);
    }
}
