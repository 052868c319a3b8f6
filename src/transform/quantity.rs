//! The quantities that superpose term by term, and the sum of their closed answers.

use super::engine::SolvedChain;
use super::{Answer, Branches, Pair};
use crate::expr::Expr;

/// The quantities that superpose term by term.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// g(x).
    Slope,
    /// F(a)/(2E*) under a smooth edge.
    Force,
    /// p(r)·π/E* under a smooth edge.
    Pressure,
}

impl Quantity {
    /// The symbol that reports use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Slope => "g",
            Self::Force => "F",
            Self::Pressure => "p",
        }
    }

    /// The symbol of the outer end: x for g, a for the others.
    pub(super) fn coordinate(self) -> &'static str {
        if self == Self::Slope { "x" } else { "a" }
    }

    fn branches(self, answer: &Answer) -> Option<&Branches> {
        match self {
            Self::Slope => Some(&answer.slope),
            Self::Force => Some(&answer.force),
            Self::Pressure => answer.pressure.as_ref(),
        }
    }
}

impl SolvedChain {
    /// The sum of the closed answers where the contact ends in the given interval.
    pub(super) fn closed(&self, interval: usize, quantity: Quantity, pick: impl Fn(&Pair) -> &Expr) -> Expr {
        let mut terms = Vec::new();
        for (index, own) in self.intervals.iter().enumerate().take(interval + 1) {
            for (_, answer) in own.terms.iter().filter_map(|t| t.answer.as_ref()) {
                if let Some(branches) = quantity.branches(answer) {
                    terms.push(pick(if index < interval { &branches.beyond } else { &branches.within }).clone());
                }
            }
        }
        Expr::sum(terms)
    }
}
