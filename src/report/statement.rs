//! The record of one exact solution as the catalogue states it: its texts, and its formulas as read from them.

use crate::expr::Formula;
use crate::transform::Rule;

/// A rule and its stated formulas.
pub struct Statement {
    /// The rule.
    pub rule: &'static Rule,
    /// f(r).
    pub pattern: Formula,
    /// g(x).
    pub slope: Formula,
    /// F(a).
    pub force: Formula,
    /// p(r), where it closes.
    pub pressure: Option<Formula>,
}
