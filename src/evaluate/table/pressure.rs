//! The pressure of a table: ∫ (r f′)′ K(r, s) dr, with point masses for clusters that are far from s and from the edge.

use super::Cubic;
use super::sums::{MASSES, NARROW};
use super::tree::{Cluster, Moments, Tree, decay, masses, rule};
use crate::integrate::pressure::direct::{Distances, kernel, kernel_at};
use crate::integrate::source::endpoint::Endpoint;
use crate::num::quadrature::{Options, Panel, Point, integrate};
use crate::num::{Bounded, Exhausted, NumError};
use std::sync::OnceLock;

/// Data of a table for the pressure: the jumps of f′, and the masses of every cluster, computed on first use.
pub(super) struct Bends {
    /// b times the jump of f′ at the lower end b of every piece; 0 if it is within rounding.
    pub(super) kinks: Vec<f64>,
    moments: Vec<Moments>,
    masses: Vec<OnceLock<Vec<(f64, f64)>>>,
}

/// Roundings of one value of the kernel and of the masses, in units of ε.
const ROUNDINGS: f64 = 64.0;
/// Nodes for a piece that is at least 0.4 of its length away from s and from the edge: the error is below 3.3⁻³².
const REGULAR_NODES: usize = 16;
const REGULAR: f64 = 0.4;

impl Bends {
    pub(super) fn new(pieces: &[Cubic], tree: &Tree) -> Result<Self, Exhausted> {
        let kinks: Vec<f64> = (0..pieces.len()).map(|index| kink(pieces, index)).collect();
        let density = |piece: &Cubic, delta: f64| piece.f_prime(delta) + (piece.lower + delta) * piece.second(delta);
        let moments = tree.moments(pieces, density, |index| kinks.get(index).copied().unwrap_or(0.0))?;
        let masses = moments.iter().map(|_| OnceLock::new()).collect();
        Ok(Self { kinks, moments, masses })
    }

    /// The masses of a cluster.
    fn masses(&self, index: usize, cluster: &Cluster, moment: &Moments) -> &[(f64, f64)] {
        self.masses.get(index).map_or(&[], |own| own.get_or_init(|| masses(cluster, moment, MASSES)))
    }
}

/// b times the jump of f′ where the piece begins.
pub(super) fn kink(pieces: &[Cubic], index: usize) -> f64 {
    let Some((before, own)) = index.checked_sub(1).and_then(|i| Some((pieces.get(i)?, pieces.get(index)?))) else { return 0.0 };
    let length = before.upper - before.lower;
    let jump = own.f_prime(0.0) - before.f_prime(length);
    let rounding = 8.0 * f64::EPSILON * (before.f_prime_size(length) + own.f_prime_size(0.0));
    if jump.abs() <= rounding { 0.0 } else { own.lower * jump }
}

/// p(s)·π/E* under a smooth edge of radius a; neither s on a kink nor s = 0 under a pointed tip.
pub(super) fn pressure(pieces: &[Cubic], tree: &Tree, bends: &Bends, s: f64, a: f64) -> Result<(Bounded, u64), NumError> {
    let mut work = Work { pieces, tree, bends, s, a, total: Bounded::exact(0.0), evaluations: 0 };
    work.gather(0)?;
    Ok((work.total, work.evaluations))
}

struct Work<'a> {
    pieces: &'a [Cubic],
    tree: &'a Tree,
    bends: &'a Bends,
    s: f64,
    a: f64,
    total: Bounded,
    evaluations: u64,
}

impl Work<'_> {
    fn gather(&mut self, index: usize) -> Result<(), NumError> {
        let (tree, bends) = (self.tree, self.bends);
        let (Some(own), Some(moment)) = (tree.clusters.get(index), bends.moments.get(index)) else { return Ok(()) };
        if own.lower >= self.a || moment.size == 0.0 {
            return Ok(());
        }
        if let Some(h) = self.separation(own).filter(|h| *h <= NARROW) {
            self.far(moment, bends.masses(index, own, moment), h);
            return Ok(());
        }
        if let Some((left, right)) = own.parts {
            self.gather(left)?;
            return self.gather(right);
        }
        for index in own.range.0..own.range.1 {
            let Some(piece) = self.pieces.get(index).filter(|piece| piece.lower < self.a) else { continue };
            let kink = bends.kinks.get(index).copied().unwrap_or(0.0);
            if kink != 0.0 {
                let own = Bounded { value: kink, error: 4.0 * f64::EPSILON * kink.abs() };
                self.total = self.total + own * self.kernel_at(piece.lower);
            }
            let end = piece.upper.min(self.a);
            if self.s > piece.lower && self.s < end {
                self.near(piece, piece.lower, self.s)?;
                self.near(piece, self.s, end)?;
            } else {
                self.near(piece, piece.lower, end)?;
            }
        }
        Ok(())
    }

    /// The larger h of s and of the edge; `None` if one of them lies within the cluster.
    fn separation(&self, own: &Cluster) -> Option<f64> {
        let outside = own.upper < self.a && (self.s < own.lower || self.s > own.upper);
        outside.then(|| decay(own, self.a).1.max(decay(own, self.s).1))
    }

    fn far(&mut self, moment: &Moments, masses: &[(f64, f64)], h: f64) {
        let (mut value, mut largest) = (0.0, 0.0f64);
        for (r, mass) in masses {
            let kernel = self.kernel_at(*r).value;
            value += mass * kernel;
            largest = largest.max(kernel);
        }
        self.evaluations += masses.len() as u64;
        let rest = ROUNDINGS * f64::EPSILON + 8.0 * h.powi(MASSES as i32) / (1.0 - h);
        self.total = self.total + Bounded { value, error: rest * largest * moment.size };
    }

    /// The kernel at a radius without error.
    fn kernel_at(&self, r: f64) -> Bounded {
        kernel_at(Endpoint::exact(r), self.s, self.a)
    }

    /// A piece, or part of it without s in its inside.
    fn near(&mut self, piece: &Cubic, from: f64, to: f64) -> Result<(), NumError> {
        let (s, a, length) = (self.s, self.a, to - from);
        let mut integrand = |point: Point| {
            let (up, down) = (point.from_lower, point.from_upper);
            let delta = (from - piece.lower) + up;
            let difference = if s <= from { (from - s) + up } else { (s - to) + down };
            let r = if up < down { from + up } else { to - down };
            let (f_prime, second) = (piece.f_prime(delta), piece.second(delta));
            let size = piece.f_prime_size(delta) + r * piece.second_size(delta);
            let distances = Distances { difference, below_edge: (a - to) + down, is_beyond: s <= from };
            Bounded { value: f_prime + r * second, error: 8.0 * f64::EPSILON * size } * kernel(r, s, a, &distances)
        };
        let distance = (a - to).min(if s <= from { from - s } else { s - to });
        if distance >= REGULAR * length {
            let mut sum = Bounded::exact(0.0);
            for node in rule(REGULAR_NODES) {
                let own = integrand(Point { x: from, from_lower: length * node.t, from_upper: length * node.rest });
                sum = sum + own * Bounded { value: length * node.weight, error: 2.0 * f64::EPSILON * length * node.weight };
            }
            self.evaluations += REGULAR_NODES as u64;
            self.total = self.total + sum;
            return Ok(());
        }
        let options = Options { rel_tol: 1e-13, charge_x: false, ..Options::default() };
        let (value, error, evaluations) = match integrate(&mut integrand, &[Panel::singular(from, to)], &options) {
            Ok(found) => (found.value, found.error, found.evaluations),
            Err(
                NumError::ToleranceNotReached { value, error, evaluations, .. } | NumError::EvaluationLimit { value, error, evaluations },
            ) => (value, error, evaluations),
            Err(other) => return Err(other),
        };
        self.evaluations += evaluations;
        self.total = self.total + Bounded { value, error };
        Ok(())
    }
}
