//! Checks that f has the dimension of a length, and finds the term that does not.

use crate::expr::{Expr, Formula, Node, Symbol};
use crate::print;
use crate::scene::error::Reason;
use crate::scene::{Dimension, SceneError};
use num_rational::Ratio;
use num_traits::ToPrimitive;
use std::collections::BTreeMap;

/// The dimensions of the parameters; r and the x of g(x) are lengths, and numbers are dimensionless.
pub(in crate::scene) type Dimensions = BTreeMap<Symbol, Dimension>;

/// Returns an error for the first term that is not a length.
///
/// # Errors
/// [`SceneError`] with the term and its dimension.
pub(in crate::scene) fn refuse_other_than_length(formula: &Formula, known: &Dimensions) -> Result<(), SceneError> {
    let own = |expr: &Expr| of(expr, known);
    match formula {
        Formula::Closed(expr) => length(expr, known),
        Formula::Sum(parts) => parts.iter().try_for_each(|part| refuse_other_than_length(part, known)),
        Formula::Scaled(factor, inner) => {
            if own(factor)?.is_none() {
                refuse_other_than_length(inner, known)
            } else {
                Err(fault(factor, "is a factor of a case distinction and must be a plain number"))
            }
        }
        Formula::Piecewise { pieces, last, .. } => {
            for (value, end) in pieces {
                refuse_other_than_length(value, known)?;
                length(end, known)?;
            }
            refuse_other_than_length(last, known)
        }
        Formula::Integral { integrand, .. } => refuse_other_than_length(integrand, known),
    }
}

fn length(expr: &Expr, known: &Dimensions) -> Result<(), SceneError> {
    for term in expr.terms() {
        if term.is_zero() {
            continue;
        }
        let found = of(&term, known)?;
        if found != Dimension::LENGTH {
            return Err(fault(&term, &format!("is {found}, not a length")));
        }
    }
    Ok(())
}

fn fault(expr: &Expr, what: &str) -> SceneError {
    let message = format!("the term {} {what}", print::text_expr(expr));
    SceneError::new(Reason::Dimension(message)).help(
        "give every parameter its unit, such as R = \"10 um\", or fix the unit of bare numbers with length_unit = \"um\" in [profile]",
    )
}

fn of(expr: &Expr, known: &Dimensions) -> Result<Dimension, SceneError> {
    let overflow = || fault(expr, "has too large an exponent");
    match expr.node() {
        Node::Number(_) | Node::Constant(_) => Ok(Dimension::NONE),
        Node::Symbol(symbol) => {
            let coordinate = if matches!(symbol.name(), "r" | "x") { Dimension::LENGTH } else { Dimension::NONE };
            Ok(known.get(symbol).copied().unwrap_or(coordinate))
        }
        Node::Product(factors) => factors.iter().try_fold(Dimension::NONE, |all, own| all.times(of(own, known)?).ok_or_else(overflow)),
        Node::Power(base, exponent) => {
            let (own, raised) = (of(base, known)?, of(exponent, known)?);
            if !raised.is_none() {
                return Err(fault(exponent, &format!("is in an exponent and is {raised}, not a plain number")));
            }
            if own.is_none() {
                return Ok(own);
            }
            let exact = exponent.as_number().and_then(|n| Some(Ratio::new(n.value().numer().to_i64()?, n.value().denom().to_i64()?)));
            let exact = exact.ok_or_else(|| fault(expr, "has an exponent that is not a fraction, so its dimension is undefined"))?;
            own.power(exact).ok_or_else(overflow)
        }
        Node::Sum(terms) => {
            let mut all: Option<(Dimension, &Expr)> = None;
            for term in terms {
                let own = of(term, known)?;
                match all {
                    None => all = Some((own, term)),
                    Some((first, other)) if first != own => {
                        let what = format!("is {own}, but is added to {}, which is {first}", print::text_expr(other));
                        return Err(fault(term, &what));
                    }
                    Some(_) => {}
                }
            }
            Ok(all.map_or(Dimension::NONE, |(own, _)| own))
        }
        Node::Function(function, arguments) => {
            let mut result = Dimension::NONE;
            for argument in arguments {
                let own = of(argument, known)?;
                if matches!(function.name(), "abs" | "min" | "max") {
                    result = own;
                } else if !own.is_none() {
                    let what = format!("is an argument of {}(…) and is {own}, not a plain number", function.name());
                    return Err(fault(argument, &what));
                }
            }
            Ok(result)
        }
    }
}
