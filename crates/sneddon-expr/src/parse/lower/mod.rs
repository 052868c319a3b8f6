//! From the parsed text to formulas: names are resolved, and operators call the canonical constructors.

mod align;
mod arithmetic;
mod call;
mod names;
mod piecewise;

pub(super) use names::{Names, is_function};

use super::syntax::{Item, Kind};
use super::{ParseError, Reason};
use crate::expr::{Expr, Formula};
use align::Breakpoints;
use arithmetic::Arithmetic;
use std::ops::Range;

/// One pass over the parsed text, with the work spent and the breakpoints found so far.
pub(super) struct Lowering<'t> {
    text: &'t str,
    names: Names,
    arithmetic: Arithmetic,
    breakpoints: Breakpoints,
}

/// An operand that waits for its operator, and its span.
struct Operand {
    value: Value,
    span: Range<usize>,
}

enum Value {
    Formula(Formula),
    /// The side that is smaller and the side that is larger, however it was typed.
    Comparison(Box<(Operand, Operand)>),
    List(Vec<Operand>),
}

impl Operand {
    fn formula(self) -> Result<Formula, ParseError> {
        let (what, accepted) = match self.value {
            Value::Formula(formula) => return Ok(formula),
            Value::Comparison(_) => {
                ("a comparison", "conditions such as r<b are allowed only between the values of piecewise(v0, r<b, v1)")
            }
            Value::List(_) => ("a list", "lists are allowed only in hyper([a], [b], z)"),
        };
        Err(ParseError::new(self.span, Reason::NotHere { what, place: "an expression" }, accepted))
    }

    /// The operand as an expression without pieces and integrals.
    fn closed(self, place: &'static str) -> Result<Expr, ParseError> {
        let span = self.span.clone();
        match self.formula()? {
            Formula::Closed(expr) => Ok(expr),
            other => {
                let what = if other.has_integral() { "an integral" } else { "piecewise" };
                Err(ParseError::new(span, Reason::NotHere { what, place }, "expected a plain expression"))
            }
        }
    }
}

impl<'t> Lowering<'t> {
    pub(super) fn new(names: Names, text: &'t str) -> Self {
        Self { text, names, arithmetic: Arithmetic::default(), breakpoints: Breakpoints::default() }
    }

    /// The closed expression of a whole text; `what` names its role in errors.
    pub(super) fn closed(self, items: Vec<Item>, what: &'static str) -> Result<Expr, ParseError> {
        let span = 0..self.text.len();
        Operand { value: Value::Formula(self.formula(items)?), span }.closed(what)
    }

    /// The formula of a whole text.
    pub(super) fn formula(mut self, items: Vec<Item>) -> Result<Formula, ParseError> {
        let mut operands: Vec<Operand> = Vec::new();
        for Item { kind, span } in items {
            let taken = match &kind {
                Kind::Number(_) | Kind::Name(_) => 0,
                Kind::Negation | Kind::Group => 1,
                Kind::Power | Kind::Comparison(_) => 2,
                Kind::Sum(marks) | Kind::Product(marks) => marks.len(),
                Kind::Call { arguments, .. } | Kind::List(arguments) => *arguments,
            };
            let taken = operands.split_off(operands.len().saturating_sub(taken));
            let value = self.apply(kind, taken, &span)?;
            operands.push(Operand { value, span });
        }
        match operands.pop() {
            Some(whole) => whole.formula(),
            None => Ok(Formula::zero()),
        }
    }

    fn apply(&mut self, kind: Kind, mut operands: Vec<Operand>, span: &Range<usize>) -> Result<Value, ParseError> {
        let formula = match kind {
            Kind::Number(number) => Formula::Closed(Expr::number(number)),
            Kind::Name(name) => Formula::Closed(self.names.resolve(&name, span)?),
            Kind::Sum(marks) => self.sum(operands, &marks, span)?,
            Kind::Product(marks) => self.product(operands, &marks, span)?,
            Kind::Power => self.power(operands)?,
            Kind::Call { name, name_span, .. } => self.call(&name, &name_span, operands, span)?,
            Kind::List(_) => return Ok(Value::List(operands)),
            Kind::Comparison(reversed) => {
                let (Some(second), Some(first)) = (operands.pop(), operands.pop()) else { return Ok(Value::List(operands)) };
                return Ok(Value::Comparison(Box::new(if reversed { (second, first) } else { (first, second) })));
            }
            Kind::Negation | Kind::Group => {
                let inner = operands.pop().map_or_else(|| Ok(Formula::zero()), Operand::formula)?;
                if matches!(kind, Kind::Group) { inner } else { inner.scaled(&Expr::integer(-1)) }
            }
        };
        Ok(Value::Formula(formula))
    }

    fn sum(&mut self, terms: Vec<Operand>, subtracted: &[bool], span: &Range<usize>) -> Result<Formula, ParseError> {
        let mut closed = Vec::with_capacity(terms.len());
        let mut rest = Vec::new();
        for (term, subtracted) in terms.into_iter().zip(subtracted) {
            match (term.formula()?, *subtracted) {
                (Formula::Closed(expr), false) => closed.push(expr),
                (Formula::Closed(expr), true) => closed.push(-expr),
                (other, false) => rest.push(other),
                (other, true) => rest.push(other.scaled(&Expr::integer(-1))),
            }
        }
        let closed = Formula::Closed(self.arithmetic.sum(&closed, span)?);
        Ok(if rest.is_empty() { closed } else { Formula::sum(std::iter::once(closed).chain(rest)) })
    }

    fn product(&mut self, factors: Vec<Operand>, divides: &[bool], span: &Range<usize>) -> Result<Formula, ParseError> {
        let mut closed = Vec::with_capacity(factors.len());
        let mut rest = Vec::new();
        for (factor, divides) in factors.into_iter().zip(divides) {
            let place = factor.span.clone();
            match (factor.formula()?, *divides) {
                (Formula::Closed(expr), false) => closed.push(expr),
                (Formula::Closed(expr), true) => closed.push(self.arithmetic.reciprocal(&expr, &place)?),
                (other, false) => rest.push(other),
                (other, true) => rest.push(self.lifted(vec![other], &place, |own, values| match values {
                    [value] => own.arithmetic.reciprocal(value, &place),
                    _ => Ok(Expr::one()),
                })?),
            }
        }
        let closed = self.arithmetic.product(&closed, span)?;
        match (rest.pop(), rest.is_empty()) {
            (None, _) => Ok(Formula::Closed(closed)),
            (Some(only), true) => Ok(only.scaled(&closed)),
            (Some(last), false) => {
                rest.push(last);
                let product = self.lifted(rest, span, |own, values| own.arithmetic.product(values, span))?;
                Ok(product.scaled(&closed))
            }
        }
    }

    fn power(&mut self, operands: Vec<Operand>) -> Result<Formula, ParseError> {
        let spans: Vec<Range<usize>> = operands.iter().map(|operand| operand.span.clone()).collect();
        let parts = operands.into_iter().map(Operand::formula).collect::<Result<Vec<_>, _>>()?;
        let [base_span, exponent_span] = spans.as_slice() else { return Ok(Formula::zero()) };
        self.lifted(parts, &(base_span.start..exponent_span.end), |own, values| match values {
            [base, exponent] => own.arithmetic.power(base, base_span, exponent, exponent_span),
            _ => Ok(Expr::one()),
        })
    }

    /// Applies `build` to closed formulas, or piece by piece to the common refinement of piecewise ones.
    fn lifted(
        &mut self,
        parts: Vec<Formula>,
        span: &Range<usize>,
        mut build: impl FnMut(&mut Self, &[Expr]) -> Result<Expr, ParseError>,
    ) -> Result<Formula, ParseError> {
        let aligned = align::align(parts, &self.breakpoints, span)?;
        let mut values = Vec::with_capacity(aligned.cells.len());
        for cell in aligned.cells {
            let operands = cell.into_iter().map(|part| align::closed(part, span)).collect::<Result<Vec<Expr>, _>>()?;
            values.push(Formula::Closed(build(self, &operands)?));
        }
        Ok(align::piecewise(aligned.variable, aligned.breaks, values))
    }
}
