//! The quantities that superpose term by term, and the sum of their closed answers.

use super::engine::{SolvedChain, SolvedTerm};
use super::{Branches, Pair, rules};
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
    /// u(r) outside a contact with a smooth edge.
    Outside,
}

impl Quantity {
    /// The symbol that reports use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Slope => "g",
            Self::Force => "F",
            Self::Pressure => "p",
            Self::Outside => "u outside the contact",
        }
    }

    /// The symbol of the outer end: x for g, a for the others.
    pub(super) fn coordinate(self) -> &'static str {
        if self == Self::Slope { "x" } else { "a" }
    }

    fn branches(self, solved: &SolvedTerm) -> Option<Branches> {
        let answer = || solved.answer.as_ref().map(|(_, answer)| answer);
        match self {
            Self::Slope => Some(answer()?.slope.clone()),
            Self::Force => Some(answer()?.force.clone()),
            Self::Pressure => answer()?.pressure.clone(),
            // Known for terms, whatever their rules say.
            Self::Outside => rules::outside(&solved.term),
        }
    }

    /// True where the term's share of the quantity is left as an integral.
    pub(super) fn is_open(self, solved: &SolvedTerm) -> bool {
        match self {
            Self::Slope | Self::Force => solved.is_open(),
            Self::Pressure => solved.has_open_pressure(),
            Self::Outside => rules::outside(&solved.term).is_none(),
        }
    }
}

impl SolvedChain {
    /// The sum of the closed answers where the contact ends in the given interval.
    pub(super) fn closed(&self, interval: usize, quantity: Quantity, pick: impl Fn(&Pair) -> &Expr) -> Expr {
        let mut terms = Vec::new();
        for (index, own) in self.intervals.iter().enumerate().take(interval + 1) {
            for branches in own.terms.iter().filter_map(|term| quantity.branches(term)) {
                terms.push(pick(if index < interval { &branches.beyond } else { &branches.within }).clone());
            }
        }
        Expr::sum(terms)
    }
}
