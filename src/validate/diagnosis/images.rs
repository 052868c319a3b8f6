//! Periodic boxes: the deformation of the surface below a contact by its images on a square lattice.

use crate::contact::State;
use crate::validate::exact::Exact;
use crate::validate::field::Spot;
use std::f64::consts::{FRAC_2_PI, PI};

/// Number of powers r², r⁴, … in the deformed surface, and of moments of the pressure.
const POWERS: usize = 6;
const MOMENTS: usize = 6;
/// Σρ^−q over the points of a square lattice with the period 1, without the origin, for q = 3, 5, …, 23: 4 ζ(q/2) β(q/2), where β is Dirichlet's.
const SUMS: [f64; POWERS + MOMENTS - 1] = [
    9.033_621_683_100_95,
    5.090_258_233_665_483,
    4.423_117_787_678_166,
    4.191_268_362_756_331,
    4.091_587_313_352_138,
    4.044_922_538_171_443,
    4.022_266_205_514_979,
    4.011_088_363_949_824,
    4.005_533_749_667_024,
    4.002_764_411_540_935,
    4.001_381_618_274_438,
];
/// Σ cos(4φ) ρ^−q over the same points for q = 5, 7, 9, 11, by direct summation.
const FOURFOLD: [f64; 4] = [3.373_865_696, 3.669_000_850_5, 3.829_323_736_8, 3.913_227_593_8];
/// Number of intervals of Simpson's rule for the moments.
const INTERVALS: u32 = 32;

/// The images of a contact in a box.
///
/// An image at the distance ρ, whose pressure has the moments Mₖ = ∫p s²ᵏ dA/(πE*), lowers the surface at r, averaged over all angles, by
/// Σ Mₖ ((2N−1)!!)²/(4ᴺ m!² k!²) r²ᵐ ρ^−(2N+1) with N = m + k. This follows from I₀(r∇) I₀(s∇) applied to 1/ρ, and Δ ρ^−q = q² ρ^−(q+2).
/// The term with m = 0 is constant and changes only the depth.
///
/// The largest term that depends on the angle θ is r⁴ cos 4θ Σ (35/64) Mₖ Π(q² − 16)/(4ᵏ k!²) ρ^−(2k+5) cos 4φ, with the product over
/// q = 5, 7, … below 2k + 5. The displacement w rⁿ cos nθ belongs to the pressure (E* w/π) n!/(1/2)ₙ rⁿ cos nθ/√(a² − r²).
#[derive(Clone, Copy, Debug)]
pub(super) struct Images {
    pub(super) side: f64,
    pub(super) moments: [f64; MOMENTS],
}

/// Returns the moments of the pressure of a state; `None` if g is not known up to the contact radius.
///
/// p is a superposition of flat punches of the radii x ≤ a with the forces 2E* x dg and, for a rim, a punch with the radius a and the
/// force 2E* a (d − g(a)), so that
/// Mₖ = (2/π) cₖ (d a²ᵏ⁺¹ − (2k + 1) ∫g x²ᵏ dx), where cₖ x²ᵏ is the mean of s²ᵏ under a flat punch.
pub(super) fn moments(exact: &Exact<'_>, state: &State) -> Option<[f64; MOMENTS]> {
    let a = state.radius;
    let step = a / f64::from(INTERVALS);
    let mut integrals = [0.0; MOMENTS];
    for index in 0..=INTERVALS {
        let x = f64::from(index) * step;
        let weight = if index == 0 || index == INTERVALS { 1.0 } else { 2.0 + 2.0 * f64::from(index % 2) };
        let g = if index == 0 { 0.0 } else { exact.shape().depth(x).ok()?.estimate.value };
        for (k, own) in (0..).zip(&mut integrals) {
            *own += weight * step / 3.0 * g * x.powi(2 * k);
        }
    }
    let mut mean = FRAC_2_PI;
    let mut found = [0.0; MOMENTS];
    for ((k, own), integral) in (0..).zip(&mut found).zip(integrals) {
        mean *= if k == 0 { 1.0 } else { f64::from(k) / (f64::from(k) + 0.5) };
        *own = mean * (state.depth * a.powi(2 * k + 1) - f64::from(2 * k + 1) * integral);
    }
    Some(found)
}

impl Images {
    /// Returns the mean displacement caused by the images as a formula in r.
    pub(super) fn surface(&self) -> String {
        let coefficient = |m: usize| -> f64 {
            let one = |(k, moment): (usize, &f64)| {
                // ((2N − 1)!!)²/(4ᴺ m!² k!²) as a product of ratios.
                let odd: f64 = (1..=m + k).map(|n| n as f64 - 0.5).product();
                let factorials: f64 = (1..=m).chain(1..=k).map(|n| n as f64).product();
                let sum = SUMS.get(m + k - 1).copied().unwrap_or(4.0);
                moment * (odd / factorials).powi(2) * sum / self.side.powi(2 * (m + k) as i32 + 1)
            };
            self.moments.iter().enumerate().map(one).sum()
        };
        let terms: Vec<String> = (1..=POWERS).map(|m| format!("{:e}*r^{}", coefficient(m), 2 * m)).collect();
        terms.join("+")
    }

    /// Returns the points with the fourfold part of the pressure removed.
    pub(super) fn without_fourfold(&self, spots: &[Spot], a: f64, effective_modulus: f64) -> Vec<Spot> {
        let mut factor = 1.0;
        let mut strength = 0.0;
        for ((k, sum), moment) in (0..).zip(FOURFOLD).zip(self.moments) {
            if k > 0 {
                let q = f64::from(2 * k + 3);
                factor *= (q * q - 16.0) / f64::from(4 * k * k);
            }
            strength += factor * moment * sum / self.side.powi(2 * k + 5);
        }
        // 35/64 · 4!/(1/2)₄ = 2.
        let strength = 2.0 * effective_modulus / PI * strength;
        let one = |spot: &Spot| {
            let Spot { x, y, r, p } = *spot;
            let (square, room) = (r * r, a * a - r * r);
            if x.is_nan() || y.is_nan() || room <= 0.0 {
                return *spot;
            }
            // r⁴ cos 4θ
            let angular = square * square - 8.0 * (x * y).powi(2);
            Spot { p: p + strength * angular / room.sqrt(), ..*spot }
        };
        spots.iter().map(one).collect()
    }
}
