//! The part of the axis on which a term or a piece of f′ acts.

use crate::expr::Expr;

/// The part [lower, upper) of the axis on which a term acts; without `upper` it reaches as far as the profile.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Segment {
    /// Where the term begins; 0 for an ordinary one.
    pub lower: Expr,
    /// Where it ends, if it does.
    pub upper: Option<Expr>,
}

impl Segment {
    /// The whole axis r ≥ 0.
    pub fn whole() -> Self {
        Self { lower: Expr::zero(), upper: None }
    }

    /// True for the whole axis.
    pub fn is_whole(&self) -> bool {
        self.lower.is_zero() && self.upper.is_none()
    }
}
