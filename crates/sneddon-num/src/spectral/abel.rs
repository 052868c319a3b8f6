//! Half-order integrals of expansions: within the interval, beyond it, and from the right.

use super::jacobi::{Basis, next_weight};
use crate::kappa::kappa;

/// ∫_0^w u^B ψ(u) K(w − u) du over the left end of an interval of length S in s = r², for ψ = Σ c_k P_k^{(0,B)}(2u/S − 1).
///
/// Source: Bateman's integral, DLMF 18.17.9: order λ takes P_k^{(0,B)} to P_k^{(−λ, B+λ)}, weight u^B to u^(B+λ).
#[derive(Clone, Debug)]
pub struct Power {
    exponent: f64,
    coefficients: Vec<f64>,
    basis: Basis,
    /// The sum of the first coefficient alone, for errors that are a constant times the weight.
    pub unit: f64,
}

impl Power {
    /// With K = 1/√: the value is w^(B+1/2) Σ c_k m_k P_k^{(−1/2, B+1/2)}, m_k = √π Γ(k+B+1)/Γ(k+B+3/2).
    pub fn root(coefficients: &[f64], b: f64) -> Self {
        // √π Γ(B+1)/Γ(B+3/2) = κ(2B+2)/(B+1).
        Self::new(coefficients, b, 0.5, kappa(2.0 * b + 2.0) / (b + 1.0))
    }

    /// With K = √: the value is w^(B+3/2) Σ c_k n_k P_k^{(−3/2, B+3/2)}, n_k = (√π/2) Γ(k+B+1)/Γ(k+B+5/2).
    pub fn integral(coefficients: &[f64], b: f64) -> Self {
        Self::new(coefficients, b, 1.5, kappa(2.0 * b + 2.0) / (b + 1.0) / (2.0 * b + 3.0))
    }

    /// With K = 1/√ and u·ψ for ψ: the value is w^(B+3/2) times a sum.
    pub fn raised(coefficients: &[f64], b: f64) -> Self {
        Self::root(&next_weight(coefficients, b), b + 1.0)
    }

    fn new(coefficients: &[f64], b: f64, order: f64, first: f64) -> Self {
        let mut factor = first;
        let mut scaled = Vec::with_capacity(coefficients.len());
        for (k, c) in coefficients.iter().enumerate() {
            scaled.push(c * factor);
            let k = k as f64;
            factor *= (k + b + 1.0) / (k + b + 1.0 + order);
        }
        Self { exponent: b + order, coefficients: scaled, basis: Basis::new(-order, b + order, coefficients.len()), unit: first }
    }

    /// The power of w before the sum.
    pub fn exponent(&self) -> f64 {
        self.exponent
    }

    /// The sum without its power of w, at t = 2w/S − 1; and the size of what was added.
    pub fn sum(&self, t: f64) -> (f64, f64) {
        self.basis.sum(&self.coefficients, t)
    }
}

/// ∫ Σ c_k P_k /√(x² − s) ds over an interval that ends below x², from the distances of its ends to x².
///
/// Source: Neumann's integral for Legendre functions, DLMF 14.12: ∫ P_k(t)/√(X−t) dt = √(2h) h^k 2/(2k+1), h = 1/(X + √(X²−1)).
pub fn beyond(coefficients: &[f64], from_lower: f64, from_upper: f64, length: f64) -> (f64, f64) {
    let root = from_lower.sqrt() + from_upper.sqrt();
    geometric(coefficients, length / root, length / (root * root))
}

/// ∫ Σ c_k P_k /√(s − y) ds over an interval that begins above y, from the distances of its ends to y; c_k divided by 2k + 1.
pub fn above(divided: &[f64], to_lower: f64, to_upper: f64, length: f64) -> f64 {
    let root = to_lower.sqrt() + to_upper.sqrt();
    let h = -length / (root * root);
    2.0 * length / root * divided.iter().rev().fold(0.0, |sum, c| sum * h + c)
}

fn geometric(coefficients: &[f64], front: f64, h: f64) -> (f64, f64) {
    let (mut total, mut size, mut power, mut below) = (0.0, 0.0, 2.0 * front, 1.0);
    for c in coefficients {
        let own = c * power / below;
        total += own;
        size += own.abs();
        power *= h;
        below += 2.0;
    }
    (total, size)
}

/// ∫_y^{top} Σ c_k P_k /√(s − y) ds inside an interval of length S, with the distance top − y; c_k already divided by 2k + 1.
///
/// It is 2√S Σ (−1)^k c_k T_{2k+1}(z)/(2k+1) with z = √((top − y)/S).
pub fn right_sided(divided: &[f64], to_top: f64, length: f64) -> f64 {
    let square = to_top / length;
    // U_k = cos-like recurrence for T_{2k+1}: T_{2k+3} = 2 T_2 T_{2k+1} − T_{2k−1}; the sign (−1)^k goes into T_2.
    let twice = 2.0 * (1.0 - 2.0 * square);
    let (mut after, mut current) = (0.0, 0.0);
    for c in divided.iter().rev() {
        let own = c + twice * current - after;
        after = current;
        current = own;
    }
    // T_{−1} = T_1 gives b_0 − (−1)·…: with alternating signs the sum is z (b_0 + b_1).
    2.0 * to_top.sqrt() * (current + after)
}

/// (1 ± t) Σ c_k P_k as a sum of one term more, from t P_k = ((k+1) P_{k+1} + k P_{k−1})/(2k+1).
pub fn times_distance(coefficients: &[f64], sign: f64) -> Vec<f64> {
    let mut out = vec![0.0; coefficients.len() + 1];
    for (index, c) in coefficients.iter().enumerate() {
        let k = index as f64;
        let own = sign * c / (2.0 * k + 1.0);
        let places = [(Some(index), *c), (Some(index + 1), own * (k + 1.0)), (index.checked_sub(1), own * k)];
        for (place, value) in places {
            if let Some(slot) = place.and_then(|i| out.get_mut(i)) {
                *slot += value;
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫_0^w u^B (1 + u)/√(w−u) du by beta functions, at B = −1/2 and 0.
    #[test]
    fn powers_are_beta_functions() {
        let pi = std::f64::consts::PI;
        // S = 2: u = 1 + t, so 1 + u = 2 + t. P_1^{(0,−1/2)} = (3/2 t + 1/2)/2 = 0.75 t + 0.25; P_1^{(0,0)} = t.
        let half = Power::root(&[2.0 - 0.25 / 0.75, 1.0 / 0.75], -0.5);
        let w: f64 = 0.7;
        let exact = pi + pi * w / 2.0;
        assert!((half.sum(w - 1.0).0 * w.powf(half.exponent()) / exact - 1.0).abs() < 1e-15);
        let plain = Power::root(&[2.0, 1.0], 0.0);
        let exact = 2.0 * w.sqrt() + 4.0 / 3.0 * w.powf(1.5);
        assert!((plain.sum(w - 1.0).0 * w.sqrt() / exact - 1.0).abs() < 1e-15);
        let area = Power::integral(&[2.0, 1.0], 0.0);
        let exact = 2.0 / 3.0 * w.powf(1.5) + 4.0 / 15.0 * w.powf(2.5);
        assert!((area.sum(w - 1.0).0 * w.powf(1.5) / exact - 1.0).abs() < 1e-15);
        let raised = Power::raised(&[2.0, 1.0], 0.0);
        let exact = 4.0 / 3.0 * w.powf(1.5) + 16.0 / 15.0 * w.powf(2.5);
        assert!((raised.sum(w - 1.0).0 * w.powf(1.5) / exact - 1.0).abs() < 1e-15);
    }

    /// ∫_1^3 (s − 2)/√(5 − s) ds = ∫ (3 − v)/√v dv, and its mirror image.
    #[test]
    fn outside_an_interval() {
        let anti = |v: f64| 6.0 * v.sqrt() - 2.0 / 3.0 * v.powf(1.5);
        let exact = anti(4.0) - anti(2.0);
        assert!((beyond(&[0.0, 1.0], 4.0, 2.0, 2.0).0 - exact).abs() < 1e-15);
        assert!((above(&[0.0, 1.0 / 3.0], 2.0, 4.0, 2.0) + exact).abs() < 1e-15);
    }

    /// ∫_y^2 (s − 1 + 2)/√(s − y) ds with s − 1 = t.
    #[test]
    fn from_the_right() {
        let y: f64 = 0.4;
        let top = 2.0 - y;
        let exact = 2.0 / 3.0 * top.powf(1.5) + (y + 1.0) * 2.0 * top.sqrt();
        assert!((right_sided(&[2.0, 1.0 / 3.0], top, 2.0) - exact).abs() < 2e-15, "{} {exact}", right_sided(&[2.0, 1.0 / 3.0], top, 2.0));
    }
}
