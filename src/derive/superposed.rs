//! The quantities that superpose term by term, and the sum of their closed forms.

use crate::derive::engine::Solution;
use crate::derive::rule::{Branches, Pair};
use crate::derive::rules;
use crate::derive::solved::{SolvedChain, SolvedTerm};
use crate::expr::Expr;

/// The quantities that superpose term by term.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Superposed {
    /// g(x).
    Equivalent,
    /// F(a)/(2E*) under a smooth edge.
    Force,
    /// p(r)·π/E* under a smooth edge.
    Pressure,
    /// u(r) outside a contact with a smooth edge.
    Outside,
    /// −σ_zz(z)·π/E* on the axis under a smooth edge.
    Axial,
}

impl Superposed {
    /// The symbol that reports use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Equivalent => "g",
            Self::Force => "F",
            Self::Pressure => "p",
            Self::Outside => "u outside the contact",
            Self::Axial => "the stress below the surface",
        }
    }

    /// The symbol of the outer end: x for g, a for the others.
    pub(crate) fn coordinate(self) -> &'static str {
        if self == Self::Equivalent { "x" } else { "a" }
    }

    /// The arguments of its closed forms: a radius and the contact radius, or the contact radius alone.
    pub(crate) fn inputs(self, coordinates: &[f64; 2]) -> &[f64] {
        match self {
            Self::Pressure | Self::Outside | Self::Axial => coordinates,
            Self::Equivalent | Self::Force => coordinates.split_at(1).1,
        }
    }

    pub(crate) fn branches(self, solved: &SolvedTerm) -> Option<Branches> {
        let answer = || solved.answer.as_ref().map(|(_, answer)| answer);
        match self {
            Self::Equivalent => Some(answer()?.equivalent.clone()),
            Self::Force => Some(answer()?.force.clone()),
            Self::Pressure => answer()?.pressure.clone(),
            // The solutions are independent of the rules of the terms.
            Self::Outside => rules::outside(&solved.term),
            Self::Axial => rules::axial(&solved.term),
        }
    }

    /// True if the closed form of the term agreed with quadrature when it was derived; false for fields, which are compared when their
    /// formula is put together.
    pub(crate) fn agrees(self, solved: &SolvedTerm) -> bool {
        match self {
            Self::Equivalent => solved.agreement.equivalent,
            Self::Force => solved.agreement.force,
            Self::Pressure => solved.agreement.pressure,
            Self::Outside | Self::Axial => false,
        }
    }

    /// True if the term's contribution to the quantity remains an integral.
    pub(crate) fn is_open(self, solved: &SolvedTerm) -> bool {
        match self {
            Self::Equivalent | Self::Force => solved.is_open(),
            Self::Pressure => solved.has_open_pressure(),
            Self::Outside | Self::Axial => self.branches(solved).is_none(),
        }
    }
}

impl SolvedChain {
    /// The sum of the closed forms for a contact that ends in the given interval.
    pub(crate) fn closed(&self, interval: usize, quantity: Superposed, pick: impl Fn(&Pair) -> &Expr) -> Expr {
        let mut terms = Vec::new();
        for (index, own) in self.intervals.iter().enumerate().take(interval + 1) {
            for branches in own.terms.iter().filter_map(|term| quantity.branches(term)) {
                terms.push(pick(if index < interval { &branches.beyond } else { &branches.within }).clone());
            }
        }
        Expr::sum(terms)
    }
}

/// The evaluated closed forms of a chain, for a contact that ends in each of its intervals.
#[derive(Clone, Debug)]
pub struct EvaluatedChain {
    /// The breakpoints, in increasing order.
    pub breakpoints: Vec<Expr>,
    /// The values, one more than there are breakpoints; each holds up to its breakpoint.
    pub values: Vec<Expr>,
}

impl Solution {
    /// Returns true if at least one term has a closed form for `quantity`, or for a solution without terms.
    pub(crate) fn has_closed(&self, quantity: Superposed) -> bool {
        self.terms().next().is_none() || self.terms().any(|term| !quantity.is_open(term))
    }

    /// The evaluated forms of a quantity, chain by chain, to be summed; `None` if an integral remains.
    ///
    /// g(x) is over x, F/(2E*) over a, p π/E* and u over r and a, and −σ_zz π/E* over z and a.
    ///
    /// ```
    /// use sneddon::{parse, transform::{Profile, Superposed, derive}};
    /// let solution = derive(&Profile::new(&parse::profile("r^2/2").unwrap()).unwrap()).unwrap();
    /// let chains = solution.evaluated(Superposed::Equivalent).unwrap();
    /// assert_eq!(sneddon::print::text_expr(&chains[0].values[0]), "x^2");
    /// ```
    pub fn evaluated(&self, quantity: Superposed) -> Option<Vec<EvaluatedChain>> {
        if self.terms().any(|term| quantity.is_open(term)) {
            return None;
        }
        let evaluated = |chain: &SolvedChain| EvaluatedChain {
            breakpoints: chain.breakpoints.clone(),
            values: (0..chain.intervals.len()).map(|index| chain.closed(index, quantity, |pair| &pair.evaluated)).collect(),
        };
        Some(self.chains.iter().map(evaluated).collect())
    }
}
