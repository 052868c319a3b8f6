//! Sums, products and powers with their limits: numbers cannot grow without bound, and undefined powers are refused.

use super::super::{ParseError, Reason, limits};
use crate::expr::{Expr, Node, Number, Sign, known_sign};
use std::ops::Range;

/// Checked constructors of expressions, and the work spent on long numbers so far.
#[derive(Default)]
pub(super) struct Arithmetic {
    number_work: u64,
}

/// The length of 10^[`limits::DIGITS`] in bits.
const LONGEST: u64 = 33_220;

/// The largest power that is folded, by the estimate of its length in bits.
const LONGEST_POWER: f64 = 65_536.0;

/// Numbers that together have fewer bits are folded at once.
const AT_ONCE: u64 = 512;

impl Arithmetic {
    pub(super) fn sum(&mut self, terms: &[Expr], span: &Range<usize>) -> Result<Expr, ParseError> {
        self.folded(terms, |terms| Expr::sum(terms.iter().cloned()), span)
    }

    pub(super) fn product(&mut self, factors: &[Expr], span: &Range<usize>) -> Result<Expr, ParseError> {
        self.folded(factors, |factors| Expr::product(factors.iter().cloned()), span)
    }

    /// 1/`divisor`.
    pub(super) fn reciprocal(&mut self, divisor: &Expr, span: &Range<usize>) -> Result<Expr, ParseError> {
        if divisor.is_zero() {
            return Err(ParseError::new(span.clone(), Reason::DivisionByZero, "expected a nonzero divisor"));
        }
        checked(divisor.recip(), span)
    }

    pub(super) fn power(
        &mut self,
        base: &Expr,
        base_span: &Range<usize>,
        exponent: &Expr,
        exponent_span: &Range<usize>,
    ) -> Result<Expr, ParseError> {
        let span = base_span.start..exponent_span.end;
        let magnitude = exponent.as_number().map_or(0.0, |number| number.to_f64().abs());
        if magnitude > limits::EXPONENT as f64 {
            return Err(ParseError::new(exponent_span.clone(), Reason::Exponent, "expected a smaller exponent"));
        }
        let (coefficient, _) = base.split_coefficient();
        let unit = coefficient.is_zero() || coefficient.abs().is_one();
        if !unit && coefficient.bits() as f64 * magnitude > LONGEST_POWER {
            return Err(too_large(&span));
        }
        if base.is_zero() && known_sign(exponent) == Sign::Negative {
            return Err(ParseError::new(span, Reason::ZeroToNegative, "expected a positive exponent"));
        }
        if exponent.as_number().is_some_and(|number| !number.is_integer()) && known_sign(base) == Sign::Negative {
            let power = if exponent.as_number() == Some(&Number::ratio(1, 2)) { "square root" } else { "fractional power" };
            let accepted = "expected a nonnegative base; -r^2 means -(r^2)";
            return Err(ParseError::new(base_span.clone(), Reason::NegativeBase { power }, accepted));
        }
        checked(base.pow(exponent), &span)
    }

    /// Folds parts at once while their numbers are short, else half by half, so that every intermediate result is checked.
    fn folded(&mut self, parts: &[Expr], build: fn(&[Expr]) -> Expr, span: &Range<usize>) -> Result<Expr, ParseError> {
        if let [only] = parts {
            return Ok(only.clone());
        }
        let bits: u64 = parts.iter().map(longest).sum();
        if bits <= AT_ONCE {
            return Ok(build(parts));
        }
        if let [_, _] = parts {
            self.number_work += (bits / 64 + 1).pow(2);
            if self.number_work > limits::NUMBER_WORK {
                return Err(ParseError::new(span.clone(), Reason::NumberWork, "expected fewer or shorter numbers"));
            }
            return checked(build(parts), span);
        }
        let (left, right) = parts.split_at(parts.len() / 2);
        let halves = [self.folded(left, build, span)?, self.folded(right, build, span)?];
        self.folded(&halves, build, span)
    }
}

/// The result, unless a number in it has become too long or an exponent too large.
fn checked(expr: Expr, span: &Range<usize>) -> Result<Expr, ParseError> {
    let too_long = |number: &Number| number.value().numer().bits().max(number.value().denom().bits()) > LONGEST;
    let too_high = |expr: &Expr| match expr.node() {
        Node::Power(_, exponent) => exponent.as_number().is_some_and(|number| number.to_f64().abs() > limits::EXPONENT as f64),
        _ => false,
    };
    let (long, high) = match expr.node() {
        Node::Number(number) => (too_long(number), false),
        Node::Product(factors) => (factors.first().and_then(Expr::as_number).is_some_and(too_long), factors.iter().any(too_high)),
        Node::Sum(terms) => (terms.iter().any(|term| term.factors().first().and_then(Expr::as_number).is_some_and(too_long)), false),
        _ => (false, too_high(&expr)),
    };
    if high {
        return Err(ParseError::new(span.clone(), Reason::Exponent, "expected a smaller exponent"));
    }
    if long { Err(too_large(span)) } else { Ok(expr) }
}

fn too_large(span: &Range<usize>) -> ParseError {
    ParseError::new(span.clone(), Reason::NumberTooLarge, "expected smaller numbers or exponents")
}

/// The bits of the longest numeric factor of a term.
fn longest(expr: &Expr) -> u64 {
    match expr.node() {
        Node::Number(number) => number.bits(),
        Node::Product(factors) => factors.first().and_then(Expr::as_number).map_or(0, Number::bits),
        Node::Sum(terms) => terms.iter().map(longest).max().unwrap_or(0),
        _ => 0,
    }
}
