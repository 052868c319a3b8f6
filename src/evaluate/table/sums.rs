//! g, F, G and u of a table: distant pieces by clusters, near pieces by a Gauss rule in √(x − r).

use super::Cubic;
use super::tree::{Cluster, Moments, OPENING, TERMS, Tree, decay, masses, rule};
use crate::num::Bounded;
use crate::num::stable::leg;

/// Rounding errors of a near piece and of a cluster, in units of ε ∫|…|; the measured errors are at most a fifth.
const NEAR_ROUNDINGS: f64 = 6.0;
const FAR_ROUNDINGS: f64 = 8.0;
/// Nodes of the rule for near pieces; after substitution of the root, its error is below 3.3⁻³².
const NEAR_NODES: usize = 16;
/// Number of point masses that replace a cluster without a series, and the largest relative size of such a cluster: 0.2²⁴ is
/// below a rounding error.
pub(super) const MASSES: usize = 24;
pub(super) const NARROW: f64 = 0.2;

/// The factor of f′ dr/√(x²−r²) in the integral.
#[derive(Clone, Copy)]
pub(super) enum Kernel {
    /// 1: g(x)/x.
    Equivalent,
    /// r²: F/(2E*).
    Force,
    /// x² − r²: G.
    Integral,
    /// The factor for the displacement at this radius outside; see [`outside`].
    Outside(f64),
}

/// A sum with the sum of magnitudes, to which the rounding error is proportional.
#[derive(Default)]
struct Sum {
    value: f64,
    error: f64,
}

/// ∫₀^x f′ · kernel/√(x²−r²) dr over all pieces.
pub(super) fn transformed(pieces: &[Cubic], tree: &Tree, moments: &[Moments], x: f64, kernel: Kernel) -> Bounded {
    let mut sum = Sum::default();
    gather(pieces, tree, moments, 0, x, kernel, &mut sum);
    // The clusters are added one after the other, each with a rounding error of half an ε of the partial sum.
    Bounded::checked(sum.value, sum.error)
}

fn gather(pieces: &[Cubic], tree: &Tree, moments: &[Moments], index: usize, x: f64, kernel: Kernel, sum: &mut Sum) {
    let (Some(own), Some(moment)) = (tree.clusters.get(index), moments.get(index)) else { return };
    if own.lower >= x || moment.size == 0.0 {
        return;
    }
    if own.upper < x {
        let (ratio, h) = decay(own, x);
        let narrow = if matches!(kernel, Kernel::Outside(_)) { NARROW } else { OPENING };
        if h <= narrow {
            far(own, moment, x, (ratio, h), kernel, sum);
            return;
        }
    }
    match own.parts {
        Some((left, right)) => {
            gather(pieces, tree, moments, left, x, kernel, sum);
            gather(pieces, tree, moments, right, x, kernel, sum);
        }
        None => {
            for piece in pieces.get(own.range.0..own.range.1).unwrap_or(&[]) {
                if piece.lower < x {
                    near(piece, x, kernel, sum);
                }
            }
        }
    }
}

/// A cluster as a whole.
fn far(own: &Cluster, moment: &Moments, x: f64, (ratio, h): (f64, f64), kernel: Kernel, sum: &mut Sum) {
    let half = 0.5 * (own.upper - own.lower) * (own.upper + own.lower);
    let middle = 0.5 * (own.lower * own.lower + own.upper * own.upper);
    if let Kernel::Outside(r) = kernel {
        let (mut value, mut size) = (0.0, 0.0f64);
        for (at, mass) in masses(own, moment, MASSES) {
            let root = leg(x, at);
            let height = outside(at, root, x, r) / root;
            value += mass * height;
            size = size.max(height);
        }
        sum.value += value;
        // The interpolation error is of the order of h²⁴ times the largest value; the masses add up to a few times the size.
        sum.error +=
            (8.0 * FAR_ROUNDINGS * f64::EPSILON + 8.0 * h.powi(MASSES as i32) / (1.0 - h)) * size * moment.size + half_ulp(sum.value);
        return;
    }
    let count = terms(h);
    let series = |list: &[f64; TERMS]| list[..count].iter().rev().fold(0.0, |sum, c| sum * h + c);
    let (factor, largest, value) = match kernel {
        Kernel::Equivalent => (1.0, 1.0, series(&moment.plain)),
        Kernel::Force => (1.0, own.upper * own.upper, middle * series(&moment.plain) + half * series(&moment.first)),
        _ => (half, ratio + 1.0, ratio * series(&moment.plain) - series(&moment.first)),
    };
    let front = (2.0 * h / half).sqrt() * factor;
    sum.value += front * value;
    let rest = FAR_ROUNDINGS * f64::EPSILON + h.powi(count as i32);
    sum.error += front * largest * moment.size * rest / (1.0 - h) + half_ulp(sum.value);
}

/// Terms after which hⁿ is below a rounding error.
fn terms(h: f64) -> usize {
    ((-38.0 / h.ln()).ceil() as usize).clamp(2, TERMS)
}

/// Half the spacing of doubles at a sum.
fn half_ulp(value: f64) -> f64 {
    0.5 * f64::EPSILON * value.abs()
}

/// One piece below x, or its part below x: the substitution r = x − (x−b)τ² removes the root at any distance.
fn near(piece: &Cubic, x: f64, kernel: Kernel, sum: &mut Sum) {
    let (b, c) = (piece.lower, piece.upper.min(x));
    let (from_b, from_c) = (x - b, x - c);
    let root = (from_c / from_b).sqrt();
    let span = (c - b) / from_b / (1.0 + root);
    let (mut value, mut size) = (0.0, 0.0);
    for node in rule(NEAR_NODES) {
        // 1 − τ = span · (1 − t), τ² (x−b) is the distance to x.
        let below = span * node.rest;
        let tau = 1.0 - below;
        let delta = from_b * below * (1.0 + tau);
        let distance = from_b * tau * tau;
        let r = x - distance;
        let weight = match kernel {
            Kernel::Equivalent => 1.0,
            Kernel::Force => r * r,
            Kernel::Integral => distance * (x + r),
            Kernel::Outside(other) => outside(r, distance.sqrt() * (x + r).sqrt(), x, other),
        };
        let common = node.weight * weight / (x + r).sqrt();
        value += common * piece.f_prime(delta);
        size += common * piece.f_prime_size(delta);
    }
    let factor = 2.0 * from_b.sqrt() * span;
    sum.value += factor * value;
    sum.error += NEAR_ROUNDINGS * f64::EPSILON * factor * size + half_ulp(sum.value);
}

/// The kernel of u(R) = (2a/π) ∫ f′ [(α − A) + (1 − cos t) A] dt, r = a sin t, as in the quadrature of profiles; `root` is √(a² −
/// r²).
fn outside(r: f64, root: f64, a: f64, at: f64) -> f64 {
    let ratio = a / leg(at, a);
    let (q, s) = (root / a, r / a);
    let short = s * s / (1.0 + q);
    let angle = (q * ratio).atan();
    (short * ratio).atan2(1.0 + q * ratio * ratio) + short * angle
}
