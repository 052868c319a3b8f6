//! Closed forms where a slice has many points close together: short polynomials made from 30 digits, kept for later slices.

use crate::derive::superposed::Superposed;
use crate::eval::Tape;
use crate::evaluate::evaluator::Evaluator;
use crate::num::spectral::{Dense, Exact, Plan};
use crate::num::{Bounded, Precise};
use std::sync::{Arc, Mutex, PoisonError};

/// Values with 30 digits that one polynomial takes, and a share of those for parts that have to be divided.
const VALUES: f64 = 16.0;
/// Nanoseconds of a point by a polynomial.
const POINT: f64 = 8.0;
/// Minimum gain, in steps per point, that justifies a polynomial.
const WORTH: f64 = 2.0;
/// Polynomials are for forms that take more nanoseconds than this.
const CHEAP: f64 = 6.0;
/// Fewest points for which a polynomial is made.
const LEAST: f64 = 64.0;
/// Quantities, at as many contact radii, whose polynomials are kept.
const KEPT: usize = 8;

/// The polynomials of the slices so far.
#[derive(Default)]
pub(crate) struct PolynomialCache(Mutex<Vec<CachedPolynomials>>);

/// The polynomials of a quantity at a contact radius, whose bits are the key.
type CachedPolynomials = (Superposed, Option<u64>, Arc<Dense>);

impl PolynomialCache {
    fn of(&self, quantity: Superposed, radius: Option<f64>) -> Arc<Dense> {
        let radius = radius.map(f64::to_bits);
        // Nothing is left half done in the list.
        let mut list = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((.., found)) = list.iter().find(|(of, at, _)| (*of, *at) == (quantity, radius)) {
            return Arc::clone(found);
        }
        if list.len() >= KEPT {
            list.remove(0);
        }
        let fresh = Arc::new(Dense::default());
        list.push((quantity, radius, Arc::clone(&fresh)));
        fresh
    }
}

/// The closed forms of one quantity, at one contact radius.
struct Closed<'e> {
    evaluator: &'e Evaluator<'e>,
    quantity: Superposed,
    radius: Option<f64>,
}

/// The polynomials for a slice of closed forms; `None` if no part has enough points to justify computing them.
///
/// Which points they answer depends on the slice alone, not on those before it.
pub(crate) fn plan<'t>(
    evaluator: &Evaluator<'_>,
    quantity: Superposed,
    radius: Option<f64>,
    tapes: impl Iterator<Item = &'t Tape>,
    points: &[f64],
) -> Option<Plan> {
    // Use the most expensive interval of the most expensive chain; there are few chains.
    let (cost, exact) = tapes.map(Tape::cost).fold((0.0_f64, 0.0_f64), |(a, b), (c, d)| (a.max(c), b.max(d)));
    if cost <= CHEAP || radius.is_some_and(|a| a >= evaluator.limit_up_to(a)) {
        return None;
    }
    let least = (VALUES * exact / (cost - POINT).max(WORTH)).max(LEAST);
    if points.len() < least as usize {
        return None;
    }
    evaluator.polynomials.of(quantity, radius).plan(&Closed { evaluator, quantity, radius }, points, least as u32)
}

impl Exact for Closed<'_> {
    fn exact(&self, x: f64) -> Precise {
        let both = [x, self.radius.unwrap_or(x)];
        let inputs = both.get(..1 + usize::from(self.radius.is_some())).unwrap_or_default();
        self.evaluator.with_30_digits(self.quantity, inputs).ok().flatten().unwrap_or(Precise::nan())
    }

    fn is_smooth(&self, from: f64, to: f64) -> bool {
        let ends = self.radius.unwrap_or(f64::INFINITY).min(self.evaluator.limit());
        let meets = |b: &Bounded| b.value + b.error >= from && b.value - b.error <= to;
        to <= ends && !self.evaluator.chains.iter().any(|chain| chain.breakpoints.iter().any(meets))
    }
}
