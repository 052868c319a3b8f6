//! The methods that are compared: one file for each, with its ladder of settings.
//!
//! [`METHODS`] lists them.
//! A method returns values and counts the evaluations that they take.

pub(crate) mod closed;
pub(crate) mod curve;
pub(crate) mod foundation;
pub(crate) mod named_rule;
pub(crate) mod quadrature;
pub(crate) mod series;
pub(crate) mod table;

use super::Problem;
use super::candidate::Ladder;
use crate::transform::Evaluator;

/// The ladder of a method for a problem; the evaluator integrates the profile as typed, for methods that start from its f′.
type Method = for<'a> fn(&'a Problem<'a>, &'a Evaluator<'a>) -> Ladder<'a>;

/// Every method, one row each.
pub(super) const METHODS: &[Method] =
    &[closed::ladder, quadrature::ladder, named_rule::ladder, curve::ladder, series::ladder, table::ladder, foundation::ladder];
