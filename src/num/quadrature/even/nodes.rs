//! The places at which even integrands are asked, with what of them does not depend on the integrand.

use super::patterson::{COSINES, NODES};
use super::{LEVELS, MOST};
use std::f64::consts::FRAC_PI_2;
use std::sync::LazyLock;

/// Nodes z in [0, 1) and functions of them, one slice each.
#[derive(Default)]
pub(crate) struct Nodes {
    /// z.
    pub(crate) z: Vec<f64>,
    /// √(1 − z²).
    pub(crate) cosine: Vec<f64>,
    /// 1 − √(1 − z²), without cancellation.
    pub(crate) sine_versine: Vec<f64>,
    /// 1/√(1 − z²).
    pub(crate) secant: Vec<f64>,
    /// cos(πz/2).
    pub(crate) quarter: Vec<f64>,
    /// 1 − cos(πz/2), without cancellation.
    pub(crate) versine: Vec<f64>,
}

/// Beyond its last node a rule is tested at this many places.
pub(super) const GUARDS: usize = 4;
/// Where they are: angles from the end z = 1 in units of that of the last node.
const GUARD_PLACES: [f64; GUARDS] = [0.55, 0.2, 0.07, 1e-6];

/// What belongs to one rule of the ladder.
pub(crate) struct Stage {
    /// The nodes that the rule before does not have; those of the first rule are followed by its guards.
    pub(super) fresh: Nodes,
    /// Places between the last node and the end.
    pub(super) guards: Nodes,
    /// The value there of the polynomial through all nodes, as weights of the values.
    pub(super) predict: [Vec<f64>; GUARDS],
    /// The sum of the magnitudes of these weights.
    pub(super) gain: [f64; GUARDS],
    /// 1 − z at the last node, twice: what a feature between it and the end can make of its height.
    pub(super) beyond: f64,
    /// (1 − z²)/z midway between neighbours.
    pub(crate) cotangents: Vec<f64>,
    /// cot(πz/2) there.
    pub(crate) quarter_cotangents: Vec<f64>,
    /// 1/z there.
    pub(crate) reciprocals: Vec<f64>,
}

/// Each is made when it is first needed.
pub(super) static STAGES: [LazyLock<Stage>; LEVELS.len()] = [
    LazyLock::new(|| Stage::new(0)),
    LazyLock::new(|| Stage::new(1)),
    LazyLock::new(|| Stage::new(2)),
    LazyLock::new(|| Stage::new(3)),
    LazyLock::new(|| Stage::new(4)),
    LazyLock::new(|| Stage::new(5)),
];

impl Nodes {
    fn push(&mut self, z: f64, cosine: f64) {
        // 1 − z from the cosine, which keeps its digits next to the end.
        let rest = FRAC_PI_2 * (cosine * cosine / (1.0 + z));
        let half = (0.5 * FRAC_PI_2 * z).sin();
        self.z.push(z);
        self.cosine.push(cosine);
        self.sine_versine.push(z * z / (1.0 + cosine));
        self.secant.push(1.0 / cosine);
        self.quarter.push(if z < 0.5 { (FRAC_PI_2 * z).cos() } else { rest.sin() });
        self.versine.push(2.0 * half * half);
    }
}

impl Stage {
    fn new(level: usize) -> Self {
        let count = LEVELS[level].weights.len();
        let stride = MOST / count;
        let all: Vec<(f64, f64)> = (0..count).map(|i| (NODES[i * stride], COSINES[i * stride])).collect();
        let mut fresh = Nodes::default();
        for (_, (z, c)) in all.iter().enumerate().filter(|(i, _)| level == 0 || i % 2 == 1) {
            fresh.push(*z, *c);
        }
        let last = all[count - 1].1.asin();
        let mut guards = Nodes::default();
        let predict = GUARD_PLACES.map(|part| {
            let (sine, cosine) = (part * last).sin_cos();
            guards.push(cosine, sine);
            prediction(&all, sine)
        });
        if level == 0 {
            for (z, c) in guards.z.iter().zip(&guards.cosine) {
                fresh.push(*z, *c);
            }
        }
        let gain = std::array::from_fn(|i| predict[i].iter().map(|q| q.abs()).sum());
        let middles = || all.windows(2).map(|pair| 0.5 * (pair[0].0 + pair[1].0));
        let cotangents = middles().map(|z| (1.0 - z) * (1.0 + z) / z).collect();
        let quarter_cotangents = middles().map(|z| 1.0 / (FRAC_PI_2 * z).tan()).collect();
        let reciprocals = middles().map(|z| 1.0 / z).collect();
        Self { fresh, guards, predict, gain, beyond: last * last, cotangents, quarter_cotangents, reciprocals }
    }
}

/// Weights of the values for the polynomial in z² through all nodes, at the place with the given √(1 − z²).
fn prediction(all: &[(f64, f64)], cosine: f64) -> Vec<f64> {
    // Lagrange's products in y = 1 − z²: exact to the last digits next to the end.
    let weight = |i: usize| {
        let own = all[i];
        all.iter().enumerate().filter(|(j, _)| *j != i).fold(1.0, |product, (_, other)| {
            // y_i − y_j = (z_j − z_i)(z_j + z_i), or by the cosines where those are the smaller ones.
            let gap =
                if own.1 < 0.7 && other.1 < 0.7 { (own.1 - other.1) * (own.1 + other.1) } else { (other.0 - own.0) * (other.0 + own.0) };
            product * ((cosine - other.1) * (cosine + other.1) / gap)
        })
    };
    (0..all.len()).map(weight).collect()
}
