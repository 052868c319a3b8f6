//! Smooth pieces between rising breakpoints.

use crate::expr::{Expr, Symbol, derivative};
use crate::integrate::error::TransformError;

/// Smooth pieces between rising breakpoints; a smooth function is a chain without breakpoints.
#[derive(Clone, Debug)]
pub struct Chain {
    /// The breakpoints, rising.
    pub breakpoints: Vec<Expr>,
    /// One expression more than there are breakpoints.
    pub pieces: Vec<Expr>,
}

impl Chain {
    /// The intervals of the chain: lower end, upper end, expression.
    pub fn intervals(&self) -> impl Iterator<Item = (Expr, Option<&Expr>, &Expr)> {
        self.pieces.iter().enumerate().map(|(i, piece)| {
            let lower = if i == 0 { Expr::zero() } else { self.breakpoints.get(i - 1).cloned().unwrap_or_else(Expr::zero) };
            (lower, self.breakpoints.get(i), piece)
        })
    }

    /// The derivative of every piece.
    ///
    /// # Errors
    /// Where a function of the table has no derivative.
    pub fn f_primes(&self) -> Result<Vec<Expr>, TransformError> {
        let radius = Symbol::new("r");
        Ok(self.pieces.iter().map(|piece| derivative(piece, &radius)).collect::<Result<_, _>>()?)
    }
}
