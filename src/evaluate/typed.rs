//! The profile as typed, as numbers: f′ of every piece, from its expression or, where that is 0/0 at the axis, from a series of f.

use crate::derive::domain::located::is_approximate;
use crate::evaluate::evaluator::Evaluator;
use crate::expr::{Expr, Symbol, derivative};
use crate::integrate::error::TransformError;
use crate::integrate::integral::{NumericProfile, prepared};
use crate::integrate::segment::Segment;
use crate::integrate::source::removable::AxisSeries;

/// An interval and f on it.
type Piece = (Segment, Expr);

impl Evaluator<'_> {
    /// Compiles the profile as typed, with series of f next to the axis, where f′ is 0/0 there.
    ///
    /// # Errors
    /// As [`Evaluator::new`].
    pub(crate) fn typed_profile(&self) -> Result<NumericProfile, TransformError> {
        self.typed_less(&[])
    }

    /// Compiles the profile as typed, less a slope times r in each chain, in the order of the chains.
    ///
    /// # Errors
    /// As [`Evaluator::new`].
    pub(crate) fn typed_less(&self, slopes: &[Expr]) -> Result<NumericProfile, TransformError> {
        let mut pieces: Vec<Piece> = Vec::new();
        for (index, chain) in self.solution.profile.chains.iter().enumerate() {
            let line = slopes.get(index).map_or(Expr::zero(), |f_prime| f_prime * Expr::symbol("r"));
            let own = |(lower, upper, f): (Expr, Option<&Expr>, &Expr)| (Segment { lower, upper: upper.cloned() }, f - &line);
            pieces.extend(chain.intervals().map(own));
        }
        let built = self.compiled(&pieces)?;
        if (built.is_ragged() || built.is_fractional())
            && let Some(parts) = self.parted(&pieces)?
        {
            return self.compiled(&parts);
        }
        Ok(built)
    }

    fn compiled(&self, pieces: &[Piece]) -> Result<NumericProfile, TransformError> {
        let slopes = pieces.iter().map(|(segment, f)| Ok((segment.clone(), derivative(f, &Symbol::new("r"))?)));
        let slopes: Vec<Piece> = slopes.collect::<Result<_, TransformError>>()?;
        let mut built = NumericProfile::new(&slopes, &self.bindings)?;
        // The nearest of several limits is where f′ ends.
        let nearest = self.limit();
        let ends = self.solution.profile.limits().zip(&self.limits).filter(|(limit, _)| !is_approximate(limit));
        if let Some((limit, _)) = ends.into_iter().find(|(_, own)| **own == nearest) {
            built = built.ending_at(limit, &self.bindings)?;
        }
        if !built.is_ragged() {
            return Ok(built);
        }
        let whole = |f_prime: &Expr| {
            let own = slopes.iter().position(|(segment, own)| segment.lower.is_zero() && prepared(own, &self.bindings) == *f_prime);
            own.and_then(|index| pieces.get(index)).map(|(_, f)| self.bindings.apply(f))
        };
        Ok(built.mended(whole))
    }

    /// Splits each piece at the axis into the terms that are 0/0 and analytic there and the others; `None` if nothing is split.
    fn parted(&self, pieces: &[Piece]) -> Result<Option<Vec<Piece>>, TransformError> {
        let mut parts = Vec::with_capacity(pieces.len() + 1);
        for (segment, f) in pieces {
            let (mut mended, mut others) = (Vec::new(), Vec::new());
            for term in f.terms().into_iter().filter(|_| segment.lower.is_zero()) {
                let f_prime = derivative(&term, &Symbol::new("r"))?;
                let own = NumericProfile::new(&[(segment.clone(), f_prime)], &self.bindings)?;
                let series = if own.is_ragged() { AxisSeries::of(&self.bindings.apply(&term)) } else { None };
                if series.is_some_and(|own| !own.has_fractions()) { mended.push(term) } else { others.push(term) }
            }
            if mended.is_empty() || others.is_empty() {
                parts.push((segment.clone(), f.clone()));
            } else {
                parts.extend([mended, others].map(|terms| (segment.clone(), Expr::sum(terms))));
            }
        }
        Ok((parts.len() > pieces.len()).then_some(parts))
    }
}
