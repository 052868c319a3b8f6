//! f′(r) in doubles, for condition numbers.

use crate::eval::{FloatAlgebra, Tape};
use crate::expr::{Bindings, Expr, Number, Symbol, derivative};
use crate::transform::{Chain, Solution};
use std::ops::Range;

/// f′ in doubles.
pub(super) struct Slopes {
    pieces: Vec<Piece>,
    /// The terms with coefficients that are rounded to doubles.
    pub(super) terms: Vec<Piece>,
}

/// A function from the lower end to the upper one, 0 elsewhere.
pub(super) struct Piece {
    range: Range<f64>,
    tape: Tape,
}

impl Slopes {
    pub(super) fn new(solution: &Solution, bindings: &Bindings) -> Self {
        let radius = Symbol::new("r");
        let number = |own: &Expr| bindings.apply(own).as_number().map(Number::to_f64);
        let (mut pieces, mut terms) = (Vec::new(), Vec::new());
        for (lower, upper, piece) in solution.profile.chains.iter().flat_map(Chain::intervals) {
            let (Some(lower), Some(upper)) = (number(&lower), upper.map_or(Some(f64::INFINITY), number)) else { continue };
            let f_prime = |own: &Expr| {
                let tape = Tape::compile(&[bindings.apply(&derivative(own, &radius).ok()?)], std::slice::from_ref(&radius)).ok()?;
                Some(Piece { range: lower..upper, tape })
            };
            pieces.extend(f_prime(piece));
            let is_rounded = |own: &Expr| {
                let (coefficient, rest) = own.split_coefficient();
                rest.contains(&radius) && Number::from_f64(coefficient.to_f64()).is_none_or(|double| double != coefficient)
            };
            terms.extend(piece.terms().iter().filter(|own| is_rounded(own)).filter_map(f_prime));
        }
        Self { pieces, terms }
    }

    pub(super) fn at(&self, r: f64) -> f64 {
        self.pieces.iter().map(|own| own.at(r)).sum()
    }
}

impl Piece {
    pub(super) fn at(&self, r: f64) -> f64 {
        let value = || self.tape.run(&mut FloatAlgebra, &[r], &mut Vec::new());
        if self.range.contains(&r) { value().unwrap_or(f64::NAN) } else { 0.0 }
    }
}
