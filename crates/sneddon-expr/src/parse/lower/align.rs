//! Piecewise operands brought to common breakpoints, so that an operation applies piece by piece.

use super::super::{ParseError, Reason};
use crate::expr::{Expr, Formula, Symbol, is_known_below as below};
use std::ops::Range;

/// Every breakpoint of the text, as typed.
#[derive(Default)]
pub(super) struct Breakpoints(Vec<(Expr, String)>);

impl Breakpoints {
    /// Records a breakpoint and returns the number of breakpoints so far.
    pub(super) fn record(&mut self, breakpoint: &Expr, typed: &str) -> usize {
        self.0.push((breakpoint.clone(), typed.to_owned()));
        self.0.len()
    }

    /// The error for two breakpoints without a known order.
    pub(super) fn unknown_order(&self, left: &Expr, right: &Expr, span: &Range<usize>) -> ParseError {
        let typed = |expr: &Expr| self.0.iter().find(|(own, _)| own == expr).map_or_else(String::new, |(_, text)| text.clone());
        let (left, right) = (typed(left), typed(right));
        let accepted = "give them numbers, write one piecewise with both breakpoints in order, or add the two instead";
        ParseError::new(span.clone(), Reason::UnknownOrder { left, right }, accepted)
    }
}

/// Operands on common pieces: `cells[i]` holds every operand's value on piece i, one more than there are breakpoints.
pub(super) struct Aligned {
    pub(super) variable: Option<Symbol>,
    pub(super) breaks: Vec<Expr>,
    pub(super) cells: Vec<Vec<Formula>>,
}

/// Brings the operands to the union of their breakpoints.
pub(super) fn align(operands: Vec<Formula>, known: &Breakpoints, span: &Range<usize>) -> Result<Aligned, ParseError> {
    let operands = operands.into_iter().map(|operand| Cases::of(operand, known, span)).collect::<Result<Vec<_>, _>>()?;
    let mut variables = operands.iter().filter_map(|cases| cases.variable.clone());
    let variable = variables.next();
    if variables.any(|other| Some(&other) != variable.as_ref()) {
        return Err(ParseError::new(span.clone(), Reason::MixedPieces, "expected pieces in one variable"));
    }
    let breaks = merge(&operands, known, span)?;
    let mut cells = Vec::with_capacity(breaks.len() + 1);
    let mut at = vec![0; operands.len()];
    for end in breaks.iter().map(Some).chain([None]) {
        cells.push(operands.iter().zip(&at).filter_map(|(cases, i)| cases.cells.get(*i).cloned()).collect());
        for (cases, i) in operands.iter().zip(&mut at) {
            *i += usize::from(end.is_some() && cases.breaks.get(*i) == end);
        }
    }
    Ok(Aligned { variable, breaks, cells })
}

/// The piecewise formula of the values between breakpoints; without breakpoints the value itself.
pub(super) fn piecewise(variable: Option<Symbol>, breaks: Vec<Expr>, mut values: Vec<Formula>) -> Formula {
    let last = values.pop().unwrap_or_else(Formula::zero);
    match variable {
        Some(variable) if !breaks.is_empty() => {
            Formula::Piecewise { variable, pieces: values.into_iter().zip(breaks).collect(), last: Box::new(last) }
        }
        _ => last,
    }
}

/// The closed expression of one operand on one piece.
pub(super) fn closed(part: Formula, span: &Range<usize>) -> Result<Expr, ParseError> {
    match part {
        Formula::Closed(expr) => Ok(expr),
        _ => {
            let accepted = "an integral may stand alone, in a sum, in a piece, or times a closed expression";
            Err(ParseError::new(span.clone(), Reason::IntegralInside, accepted))
        }
    }
}

/// One operand as breakpoints and the values between them.
struct Cases {
    variable: Option<Symbol>,
    breaks: Vec<Expr>,
    cells: Vec<Formula>,
}

impl Cases {
    fn of(formula: Formula, known: &Breakpoints, span: &Range<usize>) -> Result<Self, ParseError> {
        match formula {
            Formula::Piecewise { variable, pieces, last } => {
                let (mut cells, breaks): (Vec<_>, Vec<_>) = pieces.into_iter().unzip();
                cells.push(*last);
                Ok(Self { variable: Some(variable), breaks, cells })
            }
            Formula::Sum(parts) if parts.iter().any(|part| matches!(part, Formula::Piecewise { .. })) => {
                let Aligned { variable, breaks, cells } = align(parts, known, span)?;
                Ok(Self { variable, breaks, cells: cells.into_iter().map(Formula::sum).collect() })
            }
            plain => Ok(Self { variable: None, breaks: Vec::new(), cells: vec![plain] }),
        }
    }
}

/// The union of rising lists of breakpoints, rising.
fn merge(lists: &[Cases], known: &Breakpoints, span: &Range<usize>) -> Result<Vec<Expr>, ParseError> {
    let mut rests: Vec<&[Expr]> = lists.iter().map(|cases| cases.breaks.as_slice()).filter(|breaks| !breaks.is_empty()).collect();
    let mut merged = Vec::new();
    while let Some(first) = rests.first().and_then(|rest| rest.first()) {
        // A later head may replace `least`; it must then be smaller, or the order of the two is unknown.
        let mut least = first;
        for head in rests.iter().filter_map(|rest| rest.first()) {
            if head == least || comes_before(least, head, &rests) {
                continue;
            }
            if !comes_before(head, least, &rests) {
                return Err(known.unknown_order(least, head, span));
            }
            least = head;
        }
        let least = least.clone();
        for rest in &mut rests {
            if let Some((head, tail)) = rest.split_first()
                && *head == least
            {
                *rest = tail;
            }
        }
        rests.retain(|rest| !rest.is_empty());
        merged.push(least);
    }
    Ok(merged)
}

/// True if `left` < `right` by value or because one operand lists them in that order.
fn comes_before(left: &Expr, right: &Expr, lists: &[&[Expr]]) -> bool {
    let listed = |list: &&[Expr]| {
        let place = |of: &Expr| list.iter().position(|own| own == of);
        matches!((place(left), place(right)), (Some(i), Some(j)) if i < j)
    };
    below(left, right) || lists.iter().any(listed)
}
