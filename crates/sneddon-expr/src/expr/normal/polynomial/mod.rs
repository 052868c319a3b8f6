//! Sums of products of powers over exact numbers, the arithmetic behind the recognition form.

mod dense;
mod monomial;

use super::{calls, gather, power};
use crate::expr::{Expr, ExprError, Node, Number, Symbol};
use crate::num::work;
use std::cell::Cell;
use std::collections::BTreeMap;
use std::rc::Rc;

pub(in crate::expr::normal) use monomial::Monomial;

/// The data shared by one expansion: the variable whose roots are brought to canonical form, and the remaining work.
///
/// A canonical frame applies the identities of functions as well; a plain one only expands.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    variable: Symbol,
    left: Rc<Cell<u32>>,
    canonical: bool,
}

/// Work of one step of an expansion, in addition to the nodes that it creates.
const STEP: u64 = 24;

impl Frame {
    fn new(variable: &Symbol, canonical: bool) -> Self {
        Self { variable: variable.clone(), left: Rc::new(Cell::new(Polynomial::WORK)), canonical }
    }

    pub(super) fn is_canonical(&self) -> bool {
        self.canonical
    }

    pub(super) fn variable(&self) -> &Symbol {
        &self.variable
    }

    /// Takes one step off the budget.
    pub(super) fn charge(&self) -> Result<(), ExprError> {
        work::spend(STEP);
        work::check()?;
        let left = self.left.get().checked_sub(1).ok_or(ExprError::TooLarge { limit: Polynomial::LIMIT })?;
        self.left.set(left);
        Ok(())
    }
}

/// A sum of numbers times products of powers, collected and without zero terms.
#[derive(Clone, Debug)]
pub struct Polynomial {
    terms: BTreeMap<Monomial, Number>,
    frame: Frame,
}

impl Polynomial {
    /// The largest number of terms that an expansion may have.
    pub const LIMIT: usize = 2000;
    /// The largest number of steps that an expansion may take, intermediate ones included.
    const WORK: u32 = 40_000;

    /// Expands an expression; `variable` is the one whose roots are brought to canonical form.
    ///
    /// # Errors
    /// [`ExprError::TooLarge`] beyond [`Self::LIMIT`] terms.
    pub fn from_expr(expr: &Expr, variable: &Symbol) -> Result<Self, ExprError> {
        Self::expand(expr, &Frame::new(variable, false))
    }

    /// The canonical form: expanded, with the identities of functions and partial fractions applied.
    ///
    /// # Errors
    /// As [`Self::from_expr`].
    pub fn canonical(expr: &Expr, variable: &Symbol) -> Result<Self, ExprError> {
        Self::canonical_within(expr, &Frame::new(variable, true))
    }

    /// The canonical form within the frame of a larger expansion; a plain frame only expands.
    pub(super) fn canonical_within(expr: &Expr, frame: &Frame) -> Result<Self, ExprError> {
        let expanded = Self::expand(expr, frame)?;
        if frame.is_canonical() { gather::gathered(expanded) } else { Ok(expanded) }
    }

    /// Expands within the frame of a larger expansion, whose budget it shares.
    pub(super) fn expand(expr: &Expr, frame: &Frame) -> Result<Self, ExprError> {
        frame.charge()?;
        match expr.node() {
            Node::Number(number) => Ok(Self::constant(number.clone(), frame)),
            Node::Constant(_) | Node::Symbol(_) => Ok(Self::atom(expr.clone(), Expr::one(), frame)),
            Node::Sum(terms) => {
                let mut total = Self::zero(frame);
                for term in terms {
                    total.add(&Self::expand(term, frame)?)?;
                }
                Ok(total)
            }
            Node::Product(factors) => {
                let (waves, others) = if frame.is_canonical() { joint_waves(factors, frame)? } else { (Monomial::new(), factors.clone()) };
                let mut total = Self::zero(frame);
                power::settle(waves, &Number::integer(1), &mut total)?;
                for factor in &others {
                    total = total.times(&Self::expand(factor, frame)?)?;
                }
                Ok(total)
            }
            Node::Power(base, exponent) => {
                let exponent = Self::expand(exponent, frame)?.to_expr();
                power::raise(&Self::expand(base, frame)?, &exponent)
            }
            Node::Function(function, arguments) => {
                let arguments = arguments.iter().map(|a| Self::canonical_within(a, frame)).collect::<Result<Vec<_>, ExprError>>()?;
                if frame.is_canonical()
                    && let Some(rewritten) = calls::rewritten(function.name(), &arguments)?
                {
                    return Ok(rewritten);
                }
                let rebuilt = Expr::function(*function, arguments.iter().map(Self::to_expr).collect());
                match rebuilt.node() {
                    Node::Function(..) => {
                        let (base, exponent) = rebuilt.split_power();
                        Ok(Self::atom(base, exponent, frame))
                    }
                    _ => Self::expand(&rebuilt, frame),
                }
            }
        }
    }

    pub(super) fn zero(frame: &Frame) -> Self {
        Self { terms: BTreeMap::new(), frame: frame.clone() }
    }

    pub(super) fn constant(number: Number, frame: &Frame) -> Self {
        let mut result = Self::zero(frame);
        if !number.is_zero() {
            result.terms.insert(Monomial::new(), number);
        }
        result
    }

    pub(super) fn atom(base: Expr, exponent: Expr, frame: &Frame) -> Self {
        Self::single(Monomial::power(base, exponent), Number::integer(1), frame)
    }

    pub(super) fn single(monomial: Monomial, coefficient: Number, frame: &Frame) -> Self {
        let mut result = Self::zero(frame);
        if !coefficient.is_zero() {
            result.terms.insert(monomial, coefficient);
        }
        result
    }

    /// The monomials with their numbers, in canonical order.
    pub(super) fn terms(&self) -> impl Iterator<Item = (&Monomial, &Number)> {
        self.terms.iter()
    }

    pub(super) fn frame(&self) -> &Frame {
        &self.frame
    }

    pub(super) fn len(&self) -> usize {
        self.terms.len()
    }

    /// The only term, where there is exactly one.
    pub(super) fn only(&self) -> Option<(&Monomial, &Number)> {
        if self.terms.len() == 1 { self.terms.iter().next() } else { None }
    }

    /// True for the sum without terms.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The expanded expression.
    pub fn to_expr(&self) -> Expr {
        Expr::sum(self.terms.iter().map(|(monomial, number)| {
            Expr::product(std::iter::once(Expr::number(number.clone())).chain(monomial.iter().map(|(atom, power)| atom.pow(power))))
        }))
    }

    /// The terms that the test picks, and the others.
    pub(super) fn split(&self, picked: impl Fn(&Monomial) -> bool) -> (Self, Self) {
        let (mut yes, mut no) = (Self::zero(&self.frame), Self::zero(&self.frame));
        for (monomial, number) in &self.terms {
            let part = if picked(monomial) { &mut yes } else { &mut no };
            part.terms.insert(monomial.clone(), number.clone());
        }
        (yes, no)
    }

    pub(super) fn add(&mut self, other: &Self) -> Result<(), ExprError> {
        for (monomial, number) in &other.terms {
            self.add_term(monomial.clone(), number);
        }
        self.check()
    }

    pub(super) fn minus(&self, other: &Self) -> Result<Self, ExprError> {
        let mut result = self.clone();
        result.add(&other.scaled(&Number::integer(-1)))?;
        Ok(result)
    }

    pub(super) fn scaled(&self, factor: &Number) -> Self {
        let mut result = Self::zero(&self.frame);
        if !factor.is_zero() {
            result.terms = self.terms.iter().map(|(monomial, number)| (monomial.clone(), number * factor)).collect();
        }
        result
    }

    /// The product, expanded; powers of sums that became whole are expanded too.
    pub(super) fn times(&self, other: &Self) -> Result<Self, ExprError> {
        if self.len().saturating_mul(other.len()) > 40 * Self::LIMIT {
            return Err(ExprError::TooLarge { limit: Self::LIMIT });
        }
        if let Some(terms) = dense::product(&self.terms, &other.terms) {
            work::check()?;
            return Ok(Self { terms, frame: self.frame.clone() });
        }
        let mut result = Self::zero(&self.frame);
        for (left, a) in &self.terms {
            for (right, b) in &other.terms {
                power::settle(left.times(right), &(a * b), &mut result)?;
            }
            result.check()?;
        }
        Ok(result)
    }

    pub(super) fn whole_power(&self, n: u32) -> Result<Self, ExprError> {
        let mut result = Self::constant(Number::integer(1), &self.frame);
        if n as usize > Self::LIMIT && self.len() > 1 {
            return Err(ExprError::TooLarge { limit: Self::LIMIT });
        }
        if let (2, Some((one, other))) = (self.len(), self.terms.iter().zip(self.terms.iter().skip(1)).next()) {
            return self.binomial(one, other, n);
        }
        let (mut square, mut rest) = (self.clone(), n);
        while rest > 0 {
            if rest & 1 == 1 {
                result = result.times(&square)?;
            }
            rest >>= 1;
            if rest > 0 {
                square = square.times(&square)?;
            }
        }
        Ok(result)
    }

    /// Σ C(n, k) one^(n−k) other^k, in a number of operations that grows like n and not like n².
    fn binomial(&self, one: (&Monomial, &Number), other: (&Monomial, &Number), n: u32) -> Result<Self, ExprError> {
        let powers = |(monomial, number): (&Monomial, &Number)| {
            let next = |(power, value): &(Monomial, Number)| Some((power.times(monomial), value * number));
            std::iter::successors(Some((Monomial::new(), Number::integer(1))), next).take(n as usize + 1).collect::<Vec<_>>()
        };
        let mut result = Self::zero(&self.frame);
        let mut choices = Number::integer(1);
        for (k, ((left, a), (right, b))) in (0..i64::from(n) + 1).zip(powers(one).iter().rev().zip(&powers(other))) {
            power::settle(left.times(right), &(&choices * &(a * b)), &mut result)?;
            result.check()?;
            choices = &choices * &Number::ratio(i64::from(n) - k, k + 1);
        }
        Ok(result)
    }

    pub(super) fn add_term(&mut self, monomial: Monomial, number: &Number) {
        match self.terms.entry(monomial) {
            std::collections::btree_map::Entry::Vacant(entry) => {
                if !number.is_zero() {
                    entry.insert(number.clone());
                }
            }
            std::collections::btree_map::Entry::Occupied(mut entry) => {
                let total = entry.get() + number;
                if total.is_zero() {
                    entry.remove();
                } else {
                    entry.insert(total);
                }
            }
        }
    }

    fn check(&self) -> Result<(), ExprError> {
        if self.terms.len() > Self::LIMIT { Err(ExprError::TooLarge { limit: Self::LIMIT }) } else { Ok(()) }
    }
}

/// Whole powers of functions in a product, which are reduced together, and the other factors.
fn joint_waves(factors: &[Expr], frame: &Frame) -> Result<(Monomial, Vec<Expr>), ExprError> {
    let (mut joint, mut others) = (Monomial::new(), Vec::new());
    for factor in factors {
        let (base, exponent) = factor.split_power();
        if matches!(base.node(), Node::Function(..)) && base.contains(frame.variable()) && exponent.as_integer().is_some() {
            let expanded = Polynomial::expand(&base, frame)?;
            if let Some((monomial, number)) = expanded.only()
                && number.is_one()
                && let [(atom, power)] = monomial.iter().collect::<Vec<_>>().as_slice()
                && power.is_one()
                && matches!(atom.node(), Node::Function(..))
            {
                joint.multiply((*atom).clone(), exponent);
                continue;
            }
        }
        others.push(factor.clone());
    }
    Ok((joint, others))
}
