//! What became of the terms of a profile: the answers of rules, interval by interval.

use crate::derive::rule::{Answer, Rule};
use crate::derive::term::Term;
use crate::expr::Expr;
use crate::integrate::segment::Segment;

/// A chain whose intervals are split into terms.
#[derive(Clone)]
pub struct SolvedChain {
    /// The breakpoints, rising.
    pub breakpoints: Vec<Expr>,
    /// The intervals between them, in order.
    pub intervals: Vec<SolvedInterval>,
}

/// The terms of f′ on one interval.
#[derive(Clone)]
pub struct SolvedInterval {
    /// Where the interval lies.
    pub segment: Segment,
    /// f′ there, as it follows from the typed expression where nothing was taken out of it.
    pub f_prime: Expr,
    /// The terms with their answers.
    pub terms: Vec<SolvedTerm>,
}

/// A term and its answer, if a rule has one.
#[derive(Clone)]
pub struct SolvedTerm {
    /// The term.
    pub term: Term,
    /// The rule that answered, and what it said.
    pub answer: Option<(&'static Rule, Answer)>,
    /// Which of its closed forms agreed with quadrature when it was derived.
    pub agreement: Agreement,
}

/// Which closed forms of a term agreed with quadrature when the term was derived.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Agreement {
    /// g, within the segment and beyond it.
    pub equivalent: bool,
    /// F, within the segment and beyond it.
    pub force: bool,
    /// p, within the segment and beyond it.
    pub pressure: bool,
}
