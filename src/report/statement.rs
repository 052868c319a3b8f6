//! One exact solution of the catalogue: its texts, and its formulas as parsed.

use crate::expr::Formula;
use crate::transform::Rule;

/// A rule and its parsed formulas.
pub struct Statement {
    /// The rule.
    pub rule: &'static Rule,
    /// f(r).
    pub pattern: Formula,
    /// g(x).
    pub equivalent: Formula,
    /// F(a).
    pub force: Formula,
    /// p(r), if there is a closed form.
    pub pressure: Option<Formula>,
}
