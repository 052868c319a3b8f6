//! The quantities of a profile that is a table.

use super::pressure::{Bends, pressure};
use super::sums::{Kernel, transformed};
use super::tree::{Moments, Tree, rule};
use super::{Cubic, TableProfile};
use crate::evaluate::evaluator::Reading;
use crate::evaluate::quantities::Quantities;
use crate::evaluate::slopes::Slopes;
use crate::integrate::error::TransformError;
use crate::num::{Bounded, Estimate, Exhausted, work};

/// Nodes per piece for the energy; half as many judge them.
const ENERGY_NODES: usize = 8;
const FEWER_NODES: usize = 6;
/// The relative tolerance of every piece of the stress on the axis.
const AXIAL: f64 = 1e-13;

impl TableProfile {
    fn tree(&self) -> Result<&(Tree, Vec<Moments>), Exhausted> {
        if let Some(ready) = self.tree.get() {
            return Ok(ready);
        }
        work::check()?;
        let tree = Tree::new(&self.pieces);
        let moments = tree.moments(&self.pieces, Cubic::f_prime, |_| 0.0)?;
        Ok(self.tree.get_or_init(|| (tree, moments)))
    }

    fn bends(&self, tree: &Tree) -> Result<&Bends, Exhausted> {
        if let Some(ready) = self.bends.get() {
            return Ok(ready);
        }
        let bends = Bends::new(&self.pieces, tree)?;
        Ok(self.bends.get_or_init(|| bends))
    }

    fn transformed(&self, at: f64, kernel: Kernel) -> Result<Bounded, Exhausted> {
        let (tree, moments) = self.tree()?;
        Ok(transformed(&self.pieces, tree, moments, at, kernel))
    }

    /// g at many places, errors included; each costs the logarithm of the number of points, so that sorting does not pay.
    ///
    /// # Errors
    /// As [`Quantities::equivalent`], at the first place that fails.
    pub fn equivalents(&self, places: &[f64]) -> Result<Vec<Estimate>, TransformError> {
        places.iter().map(|x| Ok(self.equivalent(*x)?.estimate)).collect()
    }
}

fn exact(number: Bounded, evaluations: u64) -> Reading {
    Reading { estimate: Estimate::estimated(number.value, number.error, evaluations), method: "exact" }
}

impl Quantities for TableProfile {
    fn equivalent(&self, x: f64) -> Result<Reading, TransformError> {
        self.check_domain("x", x)?;
        Ok(exact(self.transformed(x, Kernel::Equivalent)? * Bounded::exact(x), 0))
    }

    fn force(&self, a: f64) -> Result<Reading, TransformError> {
        self.check_domain("a", a)?;
        Ok(exact(self.transformed(a, Kernel::Force)?, 0))
    }

    fn integral(&self, a: f64) -> Result<Reading, TransformError> {
        self.check_domain("a", a)?;
        Ok(exact(self.transformed(a, Kernel::Integral)?, 0))
    }

    fn pressure(&self, r: f64, a: f64) -> Result<Option<Reading>, TransformError> {
        self.check_domain("r", r)?;
        self.check_domain("a", a)?;
        if r >= a {
            return Ok(Some(exact(Bounded::exact(0.0), 0)));
        }
        let (tree, _) = self.tree()?;
        let bends = self.bends(tree)?;
        let steep = r == 0.0 && self.pieces.first().is_some_and(|piece| piece.f_prime(0.0) != 0.0);
        let on_kink = || self.piece(r).is_some_and(|i| self.pieces[i].lower == r && bends.kinks.get(i).is_some_and(|kink| *kink != 0.0));
        if steep || on_kink() {
            return Ok(None);
        }
        let (total, evaluations) = pressure(&self.pieces, tree, bends, r, a)?;
        Ok(Some(Reading { estimate: Estimate::estimated(total.value, total.error, evaluations), method: "quadrature" }))
    }

    fn axial(&self, z: f64, a: f64) -> Result<Reading, TransformError> {
        self.check_domain("a", a)?;
        let estimate = self.numeric().axial(z, a, AXIAL)?;
        Ok(Reading { estimate, method: "quadrature" })
    }

    fn displacement(&self, r: f64, a: f64) -> Result<Reading, TransformError> {
        self.check_domain("a", a)?;
        if r.is_nan() || r <= a || r.is_infinite() {
            return Err(TransformError::OutOfDomain { symbol: "r", at: r, limit: format!(", which begins at a = {a:?} here") });
        }
        let factor = Bounded::exact(2.0) / Bounded::rounded(std::f64::consts::PI) * Bounded::exact(a);
        Ok(exact(self.transformed(a, Kernel::Outside(r))? * factor, 0))
    }

    /// The cubic of the piece, less f(0).
    fn height(&self, r: f64) -> Result<Reading, TransformError> {
        self.check_domain("r", r)?;
        let (Some(piece), Some(first)) = (self.piece(r).and_then(|i| self.pieces.get(i)), self.pieces.first()) else {
            return Ok(exact(Bounded::exact(0.0), 0));
        };
        let delta = Bounded::exact(r) - Bounded::exact(piece.lower);
        let [c0, c1, c2, c3] = piece.coefficients.map(Bounded::exact);
        Ok(exact(c0 - Bounded::exact(first.coefficients[0]) + delta * (c1 + delta * (c2 + delta * c3)), 0))
    }

    /// The last radius of the table, which still belongs to it.
    fn limit(&self) -> f64 {
        self.pieces.last().map_or(0.0, |piece| piece.upper.next_up())
    }

    fn breakpoints_below(&self, end: f64) -> Vec<f64> {
        self.pieces.iter().map(|piece| piece.lower).filter(|b| *b > 0.0 && *b < end).collect()
    }

    fn check_domain(&self, symbol: &'static str, at: f64) -> Result<(), TransformError> {
        let last = self.pieces.last().map_or(0.0, |piece| piece.upper);
        if at.is_nan() || at < 0.0 {
            return Err(TransformError::OutOfDomain { symbol, at, limit: ", which begins at r = 0".to_owned() });
        }
        if at > last {
            return Err(TransformError::OutOfDomain { symbol, at, limit: format!(", whose last point is at r = {last:?}") });
        }
        Ok(())
    }

    fn flat_radius(&self) -> Result<f64, TransformError> {
        let flat = |piece: &&Cubic| piece.coefficients[1..].iter().all(|c| *c == 0.0);
        Ok(self.pieces.iter().take_while(flat).last().map_or(0.0, |piece| piece.upper))
    }

    fn f_prime_over(&self, lower: f64, upper: f64) -> Option<(f64, f64)> {
        Slopes::over(self, lower, upper).map(|own| own.f_prime)
    }

    /// A Gauss rule per piece in √(x − b), in which g is smooth up to the roots of the pieces before.
    fn squared_gap(&self, a: f64, depth: Bounded) -> Option<Result<Reading, TransformError>> {
        if let Err(error) = self.check_domain("a", a) {
            return Some(Err(error));
        }
        let (tree, moments) = match self.tree() {
            Ok(ready) => ready,
            Err(error) => return Some(Err(error.into())),
        };
        let mut total = Bounded::exact(0.0);
        let (mut doubt, mut evaluations) = (0.0, 0);
        for piece in self.pieces.iter().take_while(|piece| piece.lower < a) {
            if let Err(error) = work::check() {
                return Some(Err(error.into()));
            }
            let length = piece.upper.min(a) - piece.lower;
            let measured = |nodes: usize| {
                let mut sum = Bounded::exact(0.0);
                for node in rule(nodes) {
                    let x = (piece.lower + length * node.t * node.t).min(a);
                    let gap = depth - transformed(&self.pieces, tree, moments, x, Kernel::Equivalent) * Bounded::exact(x);
                    let weight = 2.0 * length * node.t * node.weight;
                    sum = sum + gap * gap * Bounded { value: weight, error: 4.0 * f64::EPSILON * weight };
                }
                sum
            };
            let (own, fewer) = (measured(ENERGY_NODES), measured(FEWER_NODES));
            evaluations += (ENERGY_NODES + FEWER_NODES) as u64;
            doubt += (own.value - fewer.value).abs();
            total = total + own;
        }
        total.error += doubt;
        Some(Ok(Reading { estimate: Estimate::estimated(total.value, total.error, evaluations), method: "quadrature" }))
    }
}
