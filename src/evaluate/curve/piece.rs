//! One piece of f′ as an expansion in s = r², and its shares of g, F and G within the piece and beyond it.

use super::source::power;
use crate::num::spectral::{Basis, Power, beyond, rule, times_distance};
use crate::num::work;

/// f′/(2r) = u^B Σ c_k P_k^{(0,B)}(2u/S − 1), u = r² − b², on b < r < c, S = c² − b².
pub(super) struct Piece {
    pub(super) lower: f64,
    pub(super) upper: f64,
    pub(super) exponent: f64,
    /// A bound on the error of the sum Σ c_k P_k.
    pub(super) noise: f64,
    /// The error at the lower end, in units of `noise`.
    peak: f64,
    length: f64,
    coefficients: Vec<f64>,
    root: Power,
    raised: Power,
    area: Power,
    far: Option<Far>,
}

/// Data for the quantities beyond a piece: the lower half by Gauss's rule if B ≠ 0, the rest as a Legendre expansion.
struct Far {
    /// u and ∫-weight times φ of the nodes.
    nodes: Vec<[f64; 2]>,
    middle: f64,
    coefficients: Vec<f64>,
    /// (s − m²) φ·2/S′ and (c² − s) φ·2/S′.
    rising: Vec<f64>,
    falling: Vec<f64>,
    length: f64,
}

/// A radius known by its square's distance to a breakpoint, which does not cancel next to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct SquaredRadius {
    pub(super) x: f64,
    pub(super) anchor: f64,
    pub(super) square: f64,
}

impl SquaredRadius {
    /// x = √(k² + square).
    pub(super) fn new(anchor: f64, square: f64) -> Self {
        let x = if anchor == 0.0 { square.sqrt() } else { (anchor * anchor + square).sqrt() };
        Self { x, anchor, square }
    }

    /// x² − c².
    pub(super) fn above(self, c: f64) -> f64 {
        if c == self.anchor {
            self.square
        } else if c < self.anchor {
            (self.anchor - c) * (self.anchor + c) + self.square
        } else {
            (self.x - c) * (self.x + c)
        }
    }
}

/// Number of terms of a share that take one step of work.
const TERMS_PER_STEP: usize = 4;

/// Which integral over s is wanted; φ = f′/(2r).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Integral {
    /// ∫ φ/√(x² − s) ds = g/x.
    Root,
    /// ∫ s φ/√(x² − s) ds = F/(2E*).
    Raised,
    /// ∫ φ √(x² − s) ds = G.
    Area,
}

/// A sum, the size of what was added, and the error that the expansion itself has.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Share {
    pub(super) value: f64,
    pub(super) size: f64,
    pub(super) noise: f64,
}

impl Piece {
    /// `ends_inside`: quantities beyond the piece are wanted too.
    pub(super) fn new(lower: f64, upper: f64, exponent: f64, coefficients: Vec<f64>, noise: f64, ends_inside: bool) -> Self {
        let length = (upper - lower) * (upper + lower);
        let root = Power::root(&coefficients, exponent);
        let raised = Power::raised(&coefficients, exponent);
        let area = Power::integral(&coefficients, exponent);
        let far = ends_inside.then(|| Far::new(lower, length, exponent, &coefficients));
        let peak = peak(coefficients.len(), exponent);
        Self { lower, upper, exponent, noise, peak, length, coefficients, root, raised, area, far }
    }

    /// The number of coefficients.
    pub(super) fn len(&self) -> usize {
        self.coefficients.len()
    }

    /// The largest power of u = x² − b² that can be taken out of the integral just above b.
    pub(super) fn front(&self, kind: Integral) -> f64 {
        match kind {
            Integral::Root => self.root.exponent(),
            Integral::Raised if self.lower == 0.0 => self.raised.exponent(),
            Integral::Raised => self.root.exponent(),
            Integral::Area => self.area.exponent(),
        }
    }

    /// The share of the integral at a place, divided by w^`front`, w = x² − k² over the place's breakpoint k.
    pub(super) fn share(&self, kind: Integral, place: SquaredRadius, front: f64) -> Share {
        let u = place.above(self.lower);
        if u <= 0.0 {
            // At the lower end itself only the first term is left.
            return if u == 0.0 { self.within(kind, place, 0.0, front) } else { Share::default() };
        }
        work::spend(1 + (self.coefficients.len() / TERMS_PER_STEP) as u64);
        let over = place.above(self.upper);
        match &self.far {
            Some(far) if over > 0.0 => {
                let scale = power(place.square, -front);
                let (value, size) = far.integral(kind, self.lower, u, over);
                let unit = 2.0 * self.length / (u.sqrt() + over.sqrt()) * self.weight_beyond(u);
                Share { value: value * scale, size: size * scale, noise: self.noise * unit * self.lever(kind, place.x, u) * scale }
            }
            _ => self.within(kind, place, u, front),
        }
    }

    fn within(&self, kind: Integral, place: SquaredRadius, u: f64, front: f64) -> Share {
        let t = 2.0 * (u / self.length).min(1.0) - 1.0;
        let divided = |exponent: f64| match self.lower == place.anchor {
            true => power(u, exponent - front),
            false => power(u, exponent) * power(place.square, -front),
        };
        let scaled = |own: &Power| {
            let factor = divided(own.exponent());
            let (value, size) = own.sum(t);
            (value * factor, size * factor)
        };
        let (value, size) = match kind {
            Integral::Root => scaled(&self.root),
            Integral::Area => scaled(&self.area),
            Integral::Raised => {
                let (value, size) = scaled(&self.raised);
                if self.lower == 0.0 {
                    (value, size)
                } else {
                    let (own, own_size) = scaled(&self.root);
                    let square = self.lower * self.lower;
                    (value + square * own, size + square * own_size)
                }
            }
        };
        let noise = self.noise * self.growth(u) * self.root.unit * divided(self.root.exponent()) * self.lever(kind, place.x, u);
        Share { value, size, noise }
    }

    /// How much larger the error is next to the lower end, where |P_k^{(0,B)}| grows to (k+B over k).
    ///
    /// The coefficients have errors of about √((2k+1)/n) of one value's; away from the end P_k falls like (k²u/S)^(−B/2 − 1/4).
    fn growth(&self, u: f64) -> f64 {
        let n = self.coefficients.len() as f64;
        let away = (n * n * u / self.length).max(1.0);
        (self.peak * away.powf(-0.5 * self.exponent.max(0.0) - 0.25)).max(1.0)
    }

    /// The largest factor of φ for each kind, apart from the root.
    fn lever(&self, kind: Integral, x: f64, u: f64) -> f64 {
        match kind {
            Integral::Root => 1.0,
            Integral::Raised => x * x,
            Integral::Area => u,
        }
    }

    /// u^B is at most this much, in the mean over the root, beyond the piece.
    fn weight_beyond(&self, u: f64) -> f64 {
        if self.exponent < 0.0 { power(self.length, self.exponent) * self.root.unit } else { power(self.length.min(u), self.exponent) }
    }
}

impl Far {
    fn new(lower: f64, length: f64, exponent: f64, coefficients: &[f64]) -> Self {
        if exponent == 0.0 {
            return Self::legendre(Vec::new(), lower, length, coefficients.to_vec());
        }
        // u^B is analytic on the upper half, and 1/√ of the distance on the lower one.
        let basis = Basis::new(0.0, exponent, coefficients.len());
        let count = if coefficients.len() > 24 { 64 } else { 32 };
        let half = 0.5 * length;
        let weight = power(half, exponent + 1.0);
        let node = |own: &crate::num::spectral::Node| {
            let u = half * own.unit;
            [u, weight * own.share * basis.sum(coefficients, 2.0 * (u / length) - 1.0).0]
        };
        let nodes = rule(count, exponent).nodes().iter().map(node).collect();
        let legendre = rule(count, 0.0);
        let value = |own: &crate::num::spectral::Node| {
            let u = half * (1.0 + own.unit);
            power(u, exponent) * basis.sum(coefficients, 2.0 * (u / length) - 1.0).0
        };
        let values: Vec<f64> = legendre.nodes().iter().map(value).collect();
        let middle = (lower * lower + half).sqrt();
        Self::legendre(nodes, middle, half, legendre.coefficients(&values))
    }

    fn legendre(nodes: Vec<[f64; 2]>, middle: f64, length: f64, coefficients: Vec<f64>) -> Self {
        let (rising, falling) = (times_distance(&coefficients, 1.0), times_distance(&coefficients, -1.0));
        Self { nodes, middle, coefficients, rising, falling, length }
    }

    fn integral(&self, kind: Integral, lower: f64, u: f64, over: f64) -> (f64, f64) {
        let from_middle = if self.nodes.is_empty() { u } else { over + self.length };
        let own = |list: &[f64]| beyond(list, from_middle, over, self.length);
        let (mut value, mut size) = match kind {
            Integral::Root => own(&self.coefficients),
            Integral::Raised => combine(own(&self.coefficients), self.middle * self.middle, own(&self.rising), 0.5 * self.length),
            Integral::Area => combine(own(&self.coefficients), over, own(&self.falling), 0.5 * self.length),
        };

        for [node, weight] in &self.nodes {
            let root = (u - node).sqrt();
            let term = match kind {
                Integral::Root => weight / root,
                Integral::Raised => weight * (lower * lower + node) / root,
                Integral::Area => weight * root,
            };
            value += term;
            size += term.abs();
        }
        (value, size)
    }
}

/// Twice √(Σ (2k+1)/n (k+B over k)²) over n coefficients.
fn peak(count: usize, exponent: f64) -> f64 {
    let (mut own, mut total) = (1.0, 0.0);
    for k in 0..count {
        let k = k as f64;
        total += (2.0 * k + 1.0) / count as f64 * own * own;
        own *= (k + 1.0 + exponent) / (k + 1.0);
    }
    2.0 * total.sqrt()
}

fn combine(first: (f64, f64), factor: f64, second: (f64, f64), other: f64) -> (f64, f64) {
    (first.0 * factor + second.0 * other, first.1 * factor + second.1 * other)
}
