//! `piecewise(v0, r<b, v1, …)`: conditions read and checked, pieces inside pieces flattened.

use super::super::{ParseError, Reason, limits};
use super::{Lowering, Names, Operand, Value, align};
use crate::expr::{Expr, Formula, Sign, Symbol, is_known_below as below, known_sign};
use std::ops::Range;

const FORM: &str = "write piecewise(v0, r<b, v1), with more pairs of condition and value as needed";

impl Lowering<'_> {
    pub(super) fn piecewise(&mut self, arguments: Vec<Operand>, span: &Range<usize>) -> Result<Formula, ParseError> {
        if arguments.len() < 3 || arguments.len().is_multiple_of(2) {
            let expected = "an odd number of arguments, at least 3".to_owned();
            let reason = Reason::Arguments { name: "piecewise".to_owned(), expected, found: arguments.len() };
            return Err(ParseError::new(span.clone(), reason, FORM));
        }
        let mut variable: Option<Symbol> = None;
        let (mut breaks, mut values): (Vec<Expr>, Vec<Formula>) = (Vec::new(), Vec::new());
        for (i, argument) in arguments.into_iter().enumerate() {
            if i % 2 == 0 {
                values.push(argument.formula()?);
                continue;
            }
            let place = argument.span.clone();
            let (own, breakpoint) = self.condition(argument)?;
            if let Some(expected) = variable.replace(own.clone())
                && expected != own
            {
                let reason = Reason::OtherVariable { expected: expected.to_string(), found: own.to_string() };
                return Err(ParseError::new(place, reason, "expected conditions on one variable"));
            }
            let falls = |before: &Expr| *before == breakpoint || below(&breakpoint, before);
            let last_number = breaks.iter().rev().find(|before| before.as_number().is_some());
            if breaks.last().is_some_and(falls) || last_number.is_some_and(falls) {
                return Err(ParseError::new(place, Reason::BreakpointsNotRising, "expected breakpoints in increasing order"));
            }
            breaks.push(breakpoint);
        }
        let Some(variable) = variable else { return Ok(Formula::zero()) };
        self.flattened(variable, breaks, values, span)
    }

    /// Variable and breakpoint of a condition.
    fn condition(&mut self, condition: Operand) -> Result<(Symbol, Expr), ParseError> {
        let place = condition.span;
        let error = |reason, accepted: &str| Err(ParseError::new(place.clone(), reason, accepted));
        let Value::Comparison(sides) = condition.value else { return error(Reason::Condition, FORM) };
        let (smaller, larger) = *sides;
        let accepted = "write r<b: the value before it holds up to b, the value after it beyond";
        let is_variable = |name: &str| self.names.is_variable(name);
        let span = larger.span.clone();
        let (smaller, breakpoint) = (smaller.closed("a condition")?, larger.closed("a breakpoint")?);
        let Some(variable) = smaller.as_symbol().filter(|own| self.names == Names::Formula || is_variable(own.name())).cloned() else {
            let reversed = breakpoint.as_symbol().is_some_and(|symbol| is_variable(symbol.name()));
            return error(if reversed { Reason::LowerBound } else { Reason::Condition }, accepted);
        };
        if !is_variable(variable.name()) && breakpoint.as_symbol().is_some_and(|symbol| is_variable(symbol.name())) {
            return error(Reason::LowerBound, accepted);
        }
        let at = |reason, accepted: &str| Err(ParseError::new(span.clone(), reason, accepted));
        if breakpoint.contains(&variable) {
            let reason = Reason::BreakpointContainsVariable { variable: variable.to_string() };
            return at(reason, "expected a breakpoint made of numbers and parameters");
        }
        if matches!(known_sign(&breakpoint), Sign::Negative | Sign::Zero) {
            return at(Reason::BreakpointNotPositive, "expected a positive breakpoint");
        }
        let typed = self.text.get(span.clone()).unwrap_or("");
        if self.breakpoints.record(&breakpoint, typed) > limits::BREAKPOINTS {
            return at(Reason::TooManyBreakpoints, "expected fewer breakpoints");
        }
        Ok((variable, breakpoint))
    }

    /// Pieces whose values have no pieces in the same variable themselves.
    fn flattened(&self, variable: Symbol, breaks: Vec<Expr>, values: Vec<Formula>, span: &Range<usize>) -> Result<Formula, ParseError> {
        let (mut flat_breaks, mut flat_values) = (Vec::new(), Vec::new());
        let mut lower: Option<&Expr> = None;
        for (value, upper) in values.into_iter().zip(breaks.iter().map(Some).chain([None])) {
            if self.has_pieces(&value, &variable) {
                let inner = align::align(vec![value], &self.breakpoints, span)?;
                let mut cells = inner.cells.into_iter().map(Formula::sum);
                let mut reaching = None;
                for breakpoint in inner.breaks {
                    let Some(cell) = cells.next() else { break };
                    if lower.is_some_and(|lower| lower == &breakpoint || below(&breakpoint, lower)) {
                        continue;
                    }
                    if let Some(lower) = lower.filter(|lower| !below(lower, &breakpoint)) {
                        return Err(self.breakpoints.unknown_order(lower, &breakpoint, span));
                    }
                    let beyond = upper.is_some_and(|upper| upper == &breakpoint || below(upper, &breakpoint));
                    if let Some(upper) = upper.filter(|upper| !beyond && !below(&breakpoint, upper)) {
                        return Err(self.breakpoints.unknown_order(&breakpoint, upper, span));
                    }
                    if beyond {
                        reaching = Some(cell);
                        break;
                    }
                    flat_values.push(cell);
                    flat_breaks.push(breakpoint);
                }
                flat_values.extend(reaching.or_else(|| cells.next()));
            } else {
                flat_values.push(value);
            }
            flat_breaks.extend(upper.cloned());
            lower = upper;
        }
        Ok(align::piecewise(Some(variable), flat_breaks, flat_values))
    }

    fn has_pieces(&self, value: &Formula, variable: &Symbol) -> bool {
        match value {
            Formula::Piecewise { variable: own, .. } => self.names != Names::Formula || own == variable,
            Formula::Sum(parts) => parts.iter().any(|part| self.has_pieces(part, variable)),
            _ => false,
        }
    }
}
