//! The nodes at which even integrands are evaluated, with precomputed functions of the nodes.

use super::super::super::stable::halves;
use super::patterson::{COSINE_RESTS, COSINES, NODES};
use super::{FEWEST, HALF_NODES, LEVELS};
use std::f64::consts::FRAC_PI_2;
use std::sync::LazyLock;

/// Nodes z in [0, 1) and functions of them, one slice each.
#[derive(Clone, Copy)]
pub struct Nodes<'a> {
    /// z.
    pub z: &'a [f64],
    /// √(1 − z²).
    pub cosine: &'a [f64],
    /// 1 − √(1 − z²), without cancellation.
    pub sine_versine: &'a [f64],
    /// 1/√(1 − z²).
    pub secant: &'a [f64],
    /// cos(πz/2).
    pub quarter: &'a [f64],
    /// 1 − cos(πz/2), without cancellation.
    pub versine: &'a [f64],
    /// √(1 − z²) to 26 binary digits, and the remainder; empty if only the double is kept.
    pub split: (&'a [f64], &'a [f64]),
}

impl<'a> Nodes<'a> {
    /// Some of them.
    #[inline(always)]
    pub(super) fn part(&self, from: usize, to: usize) -> Option<Nodes<'a>> {
        Some(Nodes {
            z: self.z.get(from..to)?,
            cosine: self.cosine.get(from..to)?,
            sine_versine: self.sine_versine.get(from..to)?,
            secant: self.secant.get(from..to)?,
            quarter: self.quarter.get(from..to)?,
            versine: self.versine.get(from..to)?,
            split: (self.split.0.get(from..to).unwrap_or_default(), self.split.1.get(from..to).unwrap_or_default()),
        })
    }
}

/// Nodes as lists that grow.
#[derive(Default)]
pub(super) struct Lists {
    all: [Vec<f64>; 6],
    split: [Vec<f64>; 2],
}

impl Lists {
    pub(super) fn push(&mut self, z: f64, cosine: f64) {
        // 1 − z from the cosine, which keeps its digits next to the end.
        let rest = FRAC_PI_2 * (cosine * cosine / (1.0 + z));
        let half = (0.5 * FRAC_PI_2 * z).sin();
        let quarter = if z < 0.5 { (FRAC_PI_2 * z).cos() } else { rest.sin() };
        let all = [z, cosine, z * z / (1.0 + cosine), 1.0 / cosine, quarter, 2.0 * half * half];
        for (list, value) in self.all.iter_mut().zip(all) {
            list.push(value);
        }
    }

    /// As above, with the remainder of the cosine beyond its double.
    pub(super) fn push_precise(&mut self, z: f64, cosine: f64, rest: f64) {
        self.push(z, cosine);
        let (high, low) = halves(cosine);
        let [highs, rests] = &mut self.split;
        highs.push(high);
        rests.push(low + rest);
    }

    #[inline]
    pub(super) fn all(&self) -> Nodes<'_> {
        let [z, cosine, sine_versine, secant, quarter, versine] = &self.all;
        let [high, rest] = &self.split;
        Nodes { z, cosine, sine_versine, secant, quarter, versine, split: (high, rest) }
    }
}

/// A number of nodes known at compile time, so that loops over them can be unrolled.
pub(super) struct Block<const N: usize>([[f64; N]; 6]);

impl<const N: usize> Block<N> {
    fn of(lists: &Lists, from: usize) -> Self {
        Self(lists.all.each_ref().map(|list| std::array::from_fn(|i| list[from + i])))
    }

    #[inline(always)]
    pub(super) fn all(&self) -> Nodes<'_> {
        let [z, cosine, sine_versine, secant, quarter, versine] = &self.0;
        Nodes { z, cosine, sine_versine, secant, quarter, versine, split: (&[], &[]) }
    }
}

/// Functions of the midpoints between neighbouring nodes.
#[derive(Clone, Copy)]
pub struct Middles<'a> {
    /// (1 − z²)/z.
    pub cotangents: &'a [f64],
    /// cot(πz/2).
    pub quarter_cotangents: &'a [f64],
    /// 1/z.
    pub reciprocals: &'a [f64],
}

/// Number of test points of a rule beyond its last node.
pub(super) const GUARDS: usize = 4;
/// The positions of the test points: angles from the end z = 1 in units of the angle of the last node.
const GUARD_PLACES: [f64; GUARDS] = [0.55, 0.2, 0.07, 1e-6];

/// Factor by which a feature may exceed the deviation found at the guards.
const BEYOND: f64 = 24.0;

/// The data of one rule of the ladder.
pub(super) struct Stage {
    /// The nodes that the previous rule does not have.
    pub(super) fresh: Lists,
    /// Places between the last node and the end.
    pub(super) guards: Block<GUARDS>,
    /// The values of the interpolating polynomial at the guards, as weights of the values at the nodes.
    pub(super) predict: [Vec<f64>; GUARDS],
    /// The sum of the magnitudes of these weights.
    pub(super) gain: [f64; GUARDS],
    /// About 50 times 1 − z at the last node: the integral of a feature near the end per unit of the height found at the guards.
    pub(super) beyond: f64,
    middles: [Vec<f64>; 3],
}

/// Each stage is computed when it is first needed.
pub(super) static STAGES: [LazyLock<Stage>; LEVELS.len()] = [
    LazyLock::new(|| Stage::new(0)),
    LazyLock::new(|| Stage::new(1)),
    LazyLock::new(|| Stage::new(2)),
    LazyLock::new(|| Stage::new(3)),
    LazyLock::new(|| Stage::new(4)),
    LazyLock::new(|| Stage::new(5)),
];

impl Stage {
    fn new(level: usize) -> Self {
        let count = LEVELS[level].weights.len();
        let stride = HALF_NODES / count;
        let all: Vec<(f64, f64)> = (0..count).map(|i| (NODES[i * stride], COSINES[i * stride])).collect();
        let mut fresh = Lists::default();
        for (i, (z, c)) in all.iter().enumerate().filter(|(i, _)| level == 0 || i % 2 == 1) {
            fresh.push_precise(*z, *c, COSINE_RESTS[i * stride]);
        }
        let last = all[count - 1].1.asin();
        let mut guards = Lists::default();
        let predict = GUARD_PLACES.map(|part| {
            let (sine, cosine) = (part * last).sin_cos();
            guards.push(cosine, sine);
            prediction(&all, sine)
        });
        let gain = std::array::from_fn(|i| predict[i].iter().map(|q| q.abs()).sum());
        let middles = between(all.iter().map(|(z, _)| *z));
        let guards = Block::of(&guards, 0);
        Self { fresh, guards, predict, gain, beyond: BEYOND * last * last, middles }
    }

    #[inline]
    pub(super) fn middles(&self) -> Middles<'_> {
        let [cotangents, quarter_cotangents, reciprocals] = &self.middles;
        Middles { cotangents, quarter_cotangents, reciprocals }
    }
}

/// Sums over the values of the first rule: the rule, the three coefficients, and the interpolating polynomial at the guards.
pub(super) const SUMS: usize = 4 + GUARDS;

/// The first rule, with a number of nodes and sums known at compile time.
pub(super) struct First {
    pub(super) nodes: Block<FEWEST>,
    pub(super) guards: Block<GUARDS>,
    /// Nodes and guards, for integrands that evaluate both in one block.
    pub(super) together: Block<{ FEWEST + GUARDS }>,
    /// The weights of one value in every sum.
    pub(super) shares: [[f64; SUMS]; FEWEST],
    pub(super) weights: [f64; FEWEST],
    /// Weights of the rule of 7 points, which has every second node.
    pub(super) seven: [f64; FEWEST / 2],
    pub(super) gain: [f64; GUARDS],
    pub(super) beyond: f64,
    middles: [[f64; FEWEST - 1]; 3],
}

/// The first stage as arrays.
pub(super) static FIRST: LazyLock<First> = LazyLock::new(|| {
    let stage = &*STAGES[0];
    let rule = &LEVELS[0];
    let mut together = Lists::default();
    let (nodes, guards) = (stage.fresh.all(), stage.guards.all());
    for (z, cosine) in nodes.z.iter().chain(guards.z).zip(nodes.cosine.iter().chain(guards.cosine)) {
        together.push(*z, *cosine);
    }
    let coarse = super::patterson::PATTERSON_7.plain().weights;
    let shares = std::array::from_fn(|i| {
        let [_, a, b, c] = rule.decay.map(|row| row[i]);
        let [p, q, r, s] = std::array::from_fn(|guard| stage.predict[guard][i]);
        [rule.weights[i], a, b, c, p, q, r, s]
    });
    First {
        nodes: Block::of(&stage.fresh, 0),
        guards: Block::of(&together, FEWEST),
        together: Block::of(&together, 0),
        shares,
        weights: std::array::from_fn(|i| rule.weights[i]),
        seven: std::array::from_fn(|i| coarse[i]),
        gain: stage.gain,
        beyond: stage.beyond,
        middles: stage.middles.each_ref().map(|list| std::array::from_fn(|i| list[i])),
    }
});

impl First {
    #[inline(always)]
    pub(super) fn middles(&self) -> Middles<'_> {
        let [cotangents, quarter_cotangents, reciprocals] = &self.middles;
        Middles { cotangents, quarter_cotangents, reciprocals }
    }
}

/// The functions of [`Middles`] between neighbours.
pub(super) fn between(nodes: impl Iterator<Item = f64> + Clone) -> [Vec<f64>; 3] {
    let middles = || nodes.clone().zip(nodes.clone().skip(1)).map(|(z, next)| 0.5 * (z + next));
    [
        middles().map(|z| (1.0 - z) * (1.0 + z) / z).collect(),
        middles().map(|z| 1.0 / (FRAC_PI_2 * z).tan()).collect(),
        middles().map(|z| 1.0 / z).collect(),
    ]
}

/// Weights of the values for the polynomial in z² through all nodes, at the place with the given √(1 − z²).
fn prediction(all: &[(f64, f64)], cosine: f64) -> Vec<f64> {
    // Lagrange's products in y = 1 − z², which are accurate near the end.
    let weight = |i: usize| {
        let own = all[i];
        all.iter().enumerate().filter(|(j, _)| *j != i).fold(1.0, |product, (_, other)| {
            // y_i − y_j = (z_j − z_i)(z_j + z_i), or by the cosines if these are smaller.
            let gap =
                if own.1 < 0.7 && other.1 < 0.7 { (own.1 - other.1) * (own.1 + other.1) } else { (other.0 - own.0) * (other.0 + own.0) };
            product * ((cosine - other.1) * (cosine + other.1) / gap)
        })
    };
    (0..all.len()).map(weight).collect()
}
