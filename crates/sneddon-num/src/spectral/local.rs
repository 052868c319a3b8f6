//! Short polynomials over a small interval, for values by the million.

use super::super::chebyshev::cosine;
use super::super::double_double::DoubleDouble;
use super::super::precise;
use std::sync::OnceLock;

/// Coefficients of a short polynomial: degree 11.
pub const LOCAL: usize = 12;

/// The Chebyshev nodes of [−1, 1], rising.
pub fn local_nodes() -> &'static [f64; LOCAL] {
    static NODES: OnceLock<[f64; LOCAL]> = OnceLock::new();
    NODES.get_or_init(|| std::array::from_fn(|j| -cosine(2 * j + 1, LOCAL)))
}

/// A polynomial through the values at the nodes, as monomials of the local variable.
#[derive(Clone, Copy, Debug)]
pub struct Local {
    coefficients: [f64; LOCAL],
}

impl Local {
    /// The interpolant, with a bound on what lies beyond its degree, and the largest coefficient over Chebyshev polynomials.
    ///
    /// The bound takes the last coefficients of the expansion for the size of those that follow.
    pub fn fit(values: &[f64; LOCAL]) -> (Self, f64, f64) {
        let mut chebyshev = [0.0; LOCAL];
        for (k, slot) in chebyshev.iter_mut().enumerate() {
            let factor = if k == 0 { 1.0 } else { 2.0 } / LOCAL as f64;
            // T_k(−cos θ) = (−1)^k cos kθ.
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            *slot = values.iter().enumerate().map(|(j, v)| v * cosine(k * (2 * j + 1), LOCAL)).sum::<f64>() * factor * sign;
        }
        let (tail, largest) = beyond(&chebyshev, 0.0);
        (Self { coefficients: monomials(&chebyshev) }, tail, largest)
    }

    /// The same from values to more digits, without the largest coefficient: every coefficient is rounded once, and those below
    /// `noise` say nothing about how the others fall.
    pub fn fit_precise(values: &[DoubleDouble; LOCAL], noise: f64) -> (Self, f64) {
        let table = precise_table();
        let mut chebyshev = [DoubleDouble::from(0.0); LOCAL];
        for (k, slot) in chebyshev.iter_mut().enumerate() {
            let term =
                |(j, v): (usize, &DoubleDouble)| table.cosines.get(k * (2 * j + 1) % (4 * LOCAL)).map_or(*v, |cosine| v.mul(*cosine));
            let sum = values.iter().enumerate().map(term).fold(DoubleDouble::from(0.0), DoubleDouble::add);
            let doubled = sum.scale(if k == 0 { 1.0 } else { 2.0 } * if k % 2 == 0 { 1.0 } else { -1.0 });
            *slot = doubled.div((LOCAL as f64).into());
        }
        let mut coefficients = [DoubleDouble::from(0.0); LOCAL];
        for (c, row) in chebyshev.iter().zip(&table.rows) {
            for (slot, t) in coefficients.iter_mut().zip(row) {
                *slot = slot.add(c.mul((*t).into()));
            }
        }
        (Self { coefficients: coefficients.map(DoubleDouble::value) }, beyond(&chebyshev.map(|c| c.hi), noise).0)
    }

    /// The polynomial and a constant.
    pub fn raised(mut self, by: f64) -> Self {
        self.coefficients[0] += by;
        self
    }

    /// The value at u in [−1, 1].
    #[inline]
    pub fn at(&self, u: f64) -> f64 {
        let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11] = self.coefficients;
        // Estrin's scheme: short chains, so that neighbouring points overlap.
        let (v, w) = (u * u, (u * u) * (u * u));
        let low = (c0 + c1 * u) + (c2 + c3 * u) * v;
        let middle = (c4 + c5 * u) + (c6 + c7 * u) * v;
        let high = (c8 + c9 * u) + (c10 + c11 * u) * v;
        low + (middle + high * w) * w
    }

    /// The derivative by u.
    #[inline]
    pub fn slope(&self, u: f64) -> f64 {
        self.coefficients.iter().enumerate().skip(1).rev().fold(0.0, |sum, (k, c)| sum * u + c * k as f64)
    }
}

/// A bound on what follows the coefficients, and the largest of them.
fn beyond(chebyshev: &[f64; LOCAL], noise: f64) -> (f64, f64) {
    let size = |from: usize, to: usize| chebyshev.iter().skip(from).take(to - from).fold(0.0_f64, |m, c| m.max(c.abs()));
    let (last, before, largest) = (size(LOCAL - 2, LOCAL), size(LOCAL - 4, LOCAL - 2), size(0, LOCAL));
    // The expansion falls geometrically: the next pair of coefficients is smaller by the same ratio.
    let ratio = if before > noise { (last / before).min(0.9) } else { 0.0 };
    (2.0 * last * (ratio / (1.0 - ratio)).max(0.05) + 2.0 * last.min(f64::EPSILON * largest), largest)
}

/// Data for [`Local::fit_precise`]: cos(πm/(2·LOCAL)), and the monomials of every Chebyshev polynomial.
struct PreciseTable {
    cosines: [DoubleDouble; 4 * LOCAL],
    rows: [[f64; LOCAL]; LOCAL],
}

fn precise_table() -> &'static PreciseTable {
    static TABLE: OnceLock<PreciseTable> = OnceLock::new();
    TABLE.get_or_init(|| PreciseTable {
        cosines: std::array::from_fn(|m| precise::cos(precise::PI.mul((m as f64).into()).div((2.0 * LOCAL as f64).into()))),
        rows: std::array::from_fn(|k| monomials(&std::array::from_fn(|other| f64::from(u8::from(other == k))))),
    })
}

/// From Chebyshev polynomials to monomials.
fn monomials(chebyshev: &[f64; LOCAL]) -> [f64; LOCAL] {
    // Rows of T_k by T_{k+1} = 2u T_k − T_{k−1}; all entries are whole numbers.
    let (mut before, mut current) = ([0.0; LOCAL], [0.0; LOCAL]);
    before[0] = 1.0;
    current[1] = 1.0;
    let mut out = [0.0; LOCAL];
    for c in chebyshev {
        for (slot, t) in out.iter_mut().zip(&before) {
            *slot += c * t;
        }
        let mut next = [0.0; LOCAL];
        for (index, slot) in next.iter_mut().enumerate() {
            let up = index.checked_sub(1).and_then(|i| current.get(i)).copied().unwrap_or(0.0);
            *slot = 2.0 * up - before.get(index).copied().unwrap_or(0.0);
        }
        before = current;
        current = next;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_polynomial_has_nearly_all_digits() {
        let values: [f64; LOCAL] = std::array::from_fn(|j| (0.3 * local_nodes()[j]).exp());
        let (local, tail, _) = Local::fit(&values);
        assert!(tail < 1e-15, "{tail}");
        for u in [-1.0, -0.3, 0.0, 0.9, 1.0_f64] {
            let (value, slope) = (local.at(u) - (0.3 * u).exp(), local.slope(u) - 0.3 * (0.3 * u).exp());
            assert!(value.abs() < 9e-16 && slope.abs() < 3e-14, "{u}: {value} {slope}");
        }
    }

    #[test]
    fn the_tail_tells_what_is_missing() {
        let values: [f64; LOCAL] = std::array::from_fn(|j| 1.0 / (1.5 - local_nodes()[j]));
        let (local, tail, _) = Local::fit(&values);
        let worst = (0..=200).map(|i| f64::from(i) / 100.0 - 1.0).map(|u| (local.at(u) - 1.0 / (1.5 - u)).abs()).fold(0.0, f64::max);
        assert!(worst < tail && tail < 20.0 * worst, "{worst} {tail}");
    }
}
