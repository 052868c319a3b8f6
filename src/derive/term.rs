//! The normal form of a profile: terms of f′ on segments.

use crate::expr::normal::NormalTerm;
use crate::expr::{Expr, Symbol};
use crate::integrate::segment::Segment;

/// One term of f′: coefficient · r^m · kernel(r) on a segment, or a polynomial in r on a bounded one.
///
/// The parts of a polynomial on a segment stay together, because they cancel next to the segment's lower end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Term {
    /// One summand; several only for a polynomial.
    pub parts: Vec<NormalTerm>,
    /// Where it acts.
    pub segment: Segment,
}

impl Term {
    /// The term as an expression in r.
    pub fn f_prime(&self) -> Expr {
        let radius = Symbol::new("r");
        Expr::sum(self.parts.iter().map(|part| part.to_expr(&radius)))
    }

    /// The only summand, where there is exactly one.
    pub fn single(&self) -> Option<&NormalTerm> {
        match self.parts.as_slice() {
            [only] => Some(only),
            _ => None,
        }
    }

    /// The coefficients of a polynomial in r, by rising power; `None` for anything else.
    pub fn polynomial(&self) -> Option<Vec<Expr>> {
        let mut coefficients = Vec::new();
        for part in &self.parts {
            let power = part.whole_power()? as usize;
            if power > 300 {
                return None;
            }
            while coefficients.len() <= power {
                coefficients.push(Expr::zero());
            }
            if let Some(own) = coefficients.get_mut(power) {
                *own = &*own + &part.coefficient;
            }
        }
        Some(coefficients)
    }
}

/// The terms of one interval: each part separately, except that polynomials on a bounded segment are combined.
pub(crate) fn split(parts: Vec<NormalTerm>, segment: &Segment) -> Vec<Term> {
    let single = |part| Term { parts: vec![part], segment: segment.clone() };
    if segment.is_whole() {
        return parts.into_iter().map(single).collect();
    }
    let (polynomial, others): (Vec<_>, Vec<_>) = parts.into_iter().partition(|part| part.whole_power().is_some());
    let mut terms = Vec::new();
    if !polynomial.is_empty() {
        terms.push(Term { parts: polynomial, segment: segment.clone() });
    }
    terms.extend(others.into_iter().map(single));
    terms
}
