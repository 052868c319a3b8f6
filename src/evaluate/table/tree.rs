//! Sums over many pieces at once: clusters of pieces with Legendre moments over s = r², which replace distant pieces.
//!
//! With t running linearly over a cluster's s, x² − s = ½L²(X − t), and 1/√(X − t) = √(2h) Σ hᵏ P_k(t), h = X − √(X²−1), is the
//! generating function of the Legendre polynomials. f′ need not be smooth, and the truncation error after n terms
//! is below √(2h) hⁿ/(1 − h) ∫|f′|.

use super::Cubic;
use crate::num::legendre::{Node, rule_of};
use crate::num::stable::Total;
use crate::num::{Exhausted, work};
use std::sync::OnceLock;

/// Number of moments of a cluster; 0.31³³ is below a rounding error.
pub(super) const TERMS: usize = 33;
/// A cluster replaces its pieces if h is at most this.
pub(super) const OPENING: f64 = 0.31;
/// Clusters with at most this many pieces are not divided further.
const LEAF: usize = 4;

/// Consecutive pieces.
pub(super) struct Cluster {
    /// The pieces: first, and one after the last.
    pub(super) range: (usize, usize),
    pub(super) lower: f64,
    pub(super) upper: f64,
    /// The two halves.
    pub(super) parts: Option<(usize, usize)>,
}

/// Moments ∫ P_k(t) φ(r) dr of a density on one cluster.
pub(super) struct Moments {
    /// k = 0, 1, …
    pub(super) plain: [f64; TERMS],
    /// The moments of t φ.
    pub(super) first: [f64; TERMS],
    /// ∫ |φ| dr.
    pub(super) size: f64,
}

/// The division of all pieces; the first cluster is the whole.
pub(super) struct Tree {
    pub(super) clusters: Vec<Cluster>,
}

impl Tree {
    pub(super) fn new(pieces: &[Cubic]) -> Self {
        let mut clusters = Vec::new();
        divide(pieces, (0, pieces.len()), &mut clusters);
        Self { clusters }
    }

    /// The moments of a density, given per piece and δ, and of masses at the lower ends of pieces.
    ///
    /// # Errors
    /// [`Exhausted`] if the work was stopped; this takes seconds for hundreds of thousands of pieces.
    pub(super) fn moments(
        &self,
        pieces: &[Cubic],
        density: impl Fn(&Cubic, f64) -> f64,
        mass: impl Fn(usize) -> f64,
    ) -> Result<Vec<Moments>, Exhausted> {
        self.clusters.iter().map(|own| measured(own, pieces, &density, &mass)).collect()
    }
}

fn divide(pieces: &[Cubic], range: (usize, usize), clusters: &mut Vec<Cluster>) -> Option<usize> {
    let (first, last) = (pieces.get(range.0)?, pieces.get(range.1.checked_sub(1)?)?);
    let index = clusters.len();
    clusters.push(Cluster { range, lower: first.lower, upper: last.upper, parts: None });
    if range.1 - range.0 > LEAF {
        let middle = range.0 + (range.1 - range.0) / 2;
        let parts = (divide(pieces, (range.0, middle), clusters)?, divide(pieces, (middle, range.1), clusters)?);
        if let Some(own) = clusters.get_mut(index) {
            own.parts = Some(parts);
        }
    }
    Some(index)
}

/// X − t at t = 1 and at t = −1 give X without cancellation, and h from it, for a place outside the cluster.
pub(super) fn decay(cluster: &Cluster, at: f64) -> (f64, f64) {
    let (b, c) = (cluster.lower, cluster.upper);
    let (near, far) = if at >= c { (c, b) } else { (b, c) };
    let (short, long) = ((at - near).abs() * (at + near), (at - far).abs() * (at + far));
    let width = (c - b) * (c + b);
    let x = (short + long) / width;
    (x, 1.0 / (x + 2.0 * (short * long).sqrt() / width))
}

/// Gauss–Legendre rules by number of nodes.
pub(super) fn rule(nodes: usize) -> &'static [Node] {
    static RULES: [OnceLock<Vec<Node>>; 40] = [const { OnceLock::new() }; 40];
    RULES.get(nodes).map_or(&[], |rule| rule.get_or_init(|| rule_of(nodes)))
}

/// Sufficient number of nodes for a quadratic times P_k over a piece that spans this part of the cluster, given its weight hᵏ.
///
/// P_k grows like exp(k√(2wρ)) on the piece's Bernstein ellipse ρ, w the part; with hᵏ that stays bounded while wρ < 0.68.
fn nodes_for(part: f64) -> usize {
    match part {
        p if p > 0.2 => 34,
        p if p > 0.1 => 16,
        p if p > 0.05 => 10,
        p if p > 0.02 => 8,
        p if p > 0.005 => 6,
        p if p > 0.0005 => 4,
        _ => 3,
    }
}

fn measured(
    own: &Cluster,
    pieces: &[Cubic],
    density: &impl Fn(&Cubic, f64) -> f64,
    mass: &impl Fn(usize) -> f64,
) -> Result<Moments, Exhausted> {
    let (b, width) = (own.lower, (own.upper - own.lower) * (own.upper + own.lower));
    let mut sums: [Total; TERMS + 1] = std::array::from_fn(|_| Total::default());
    let mut size = 0.0;
    for index in own.range.0..own.range.1 {
        let Some(piece) = pieces.get(index) else { continue };
        work::check()?;
        let length = piece.upper - piece.lower;
        let mut part = [0.0; TERMS + 1];
        // t + 1 from the distances to the cluster's lower end.
        let lifted = |r: f64| 2.0 * (r - b) * (r + b) / width;
        for node in rule(nodes_for(length * (piece.upper + piece.lower) / width)) {
            let delta = length * node.t;
            let weight = length * node.weight * density(piece, delta);
            size += weight.abs();
            add(&mut part, weight, lifted(piece.lower + delta) - 1.0);
        }
        let mass = mass(index);
        if mass != 0.0 {
            size += mass.abs();
            add(&mut part, mass, lifted(piece.lower) - 1.0);
        }
        for (sum, part) in sums.iter_mut().zip(part) {
            sum.add(part);
        }
    }
    let all = sums.map(|sum| sum.value());
    let plain = std::array::from_fn(|k| all[k]);
    // t P_k = ((k+1) P_(k+1) + k P_(k−1))/(2k+1)
    let first = std::array::from_fn(|k| {
        let n = k as f64;
        let below = if k == 0 { 0.0 } else { n * all[k - 1] };
        ((n + 1.0) * all[k + 1] + below) / (2.0 * n + 1.0)
    });
    Ok(Moments { plain, first, size })
}

/// k/(k+1) for k = 0, 1, …
const SHARES: [f64; TERMS + 1] = {
    let mut shares = [0.0; TERMS + 1];
    let mut k = 0;
    while k <= TERMS {
        shares[k] = k as f64 / (k + 1) as f64;
        k += 1;
    }
    shares
};

/// Adds weight · P_k(t) for every k: P_(k+1) = t P_k + k/(k+1) (t P_k − P_(k−1)).
fn add(sums: &mut [f64; TERMS + 1], weight: f64, t: f64) {
    let (mut before, mut own) = (0.0, weight);
    for (sum, share) in sums.iter_mut().zip(SHARES) {
        *sum += own;
        let next = t * own;
        (before, own) = (own, next + share * (next - before));
    }
}

/// Point masses at the nodes of a Gauss rule, in t, with the same moments; they replace the cluster for smooth kernels.
pub(super) fn masses(own: &Cluster, moments: &Moments, count: usize) -> Vec<(f64, f64)> {
    let (b, c) = (own.lower, own.upper);
    rule(count)
        .iter()
        .map(|node| {
            let t = node.t - node.rest;
            // Σ (2k+1)/2 m_k P_k(t), times the weight on [−1, 1].
            let (mut before, mut p, mut sum) = (0.0, 1.0, 0.0);
            for (k, moment) in moments.plain.iter().enumerate().take(count) {
                let n = k as f64;
                sum += (2.0 * n + 1.0) * moment * p;
                (before, p) = (p, ((2.0 * n + 1.0) * t * p - n * before) / (n + 1.0));
            }
            let r = (b * b * node.rest + c * c * node.t).sqrt();
            (r, sum * node.weight)
        })
        .collect()
}
