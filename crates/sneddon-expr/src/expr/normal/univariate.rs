//! Polynomials in the variable whose coefficients are free of it.

use super::polynomial::{Frame, Polynomial};
use super::{calls, power};
use crate::expr::{Expr, ExprError, Number};

/// The coefficients in ascending powers; the last one is not zero.
#[derive(Clone, Debug)]
pub(super) struct Univariate {
    coefficients: Vec<Polynomial>,
    frame: Frame,
}

impl Univariate {
    /// The highest degree that is read.
    const HIGHEST: i64 = 400;

    pub(super) fn zero(frame: &Frame) -> Self {
        Self { coefficients: Vec::new(), frame: frame.clone() }
    }

    pub(super) fn constant(value: Polynomial) -> Self {
        let frame = value.frame().clone();
        Self { coefficients: vec![value], frame }.trimmed()
    }

    /// From the coefficients in ascending powers.
    pub(super) fn new(coefficients: Vec<Polynomial>, frame: &Frame) -> Self {
        Self { coefficients, frame: frame.clone() }.trimmed()
    }

    /// r itself.
    pub(super) fn radius(frame: &Frame) -> Self {
        Self::new(vec![Polynomial::zero(frame), Polynomial::constant(Number::integer(1), frame)], frame)
    }

    /// The coefficients by powers of the variable; `None` if the expression is not a polynomial.
    pub(super) fn read(polynomial: &Polynomial) -> Option<Self> {
        let frame = polynomial.frame();
        let radius = Expr::from(frame.variable().clone());
        let mut result = Self::zero(frame);
        for (monomial, number) in polynomial.terms() {
            let mut rest = monomial.clone();
            let k = rest.remove(&radius).map_or(Some(0), |p| p.as_integer()).filter(|k| (0..=Self::HIGHEST).contains(k))?;
            if calls::depends(&rest, frame) {
                return None;
            }
            result.add_at(k as usize, &Polynomial::single(rest, number.clone(), frame)).ok()?;
        }
        Some(result.trimmed())
    }

    pub(super) fn to_polynomial(&self) -> Polynomial {
        let radius = Expr::from(self.frame.variable().clone());
        let mut result = Polynomial::zero(&self.frame);
        for (k, coefficient) in self.coefficients.iter().enumerate() {
            for (monomial, number) in coefficient.terms() {
                let mut total = monomial.clone();
                total.multiply(radius.clone(), Expr::integer(k as i64));
                result.add_term(total, number);
            }
        }
        result
    }

    /// Adds to the coefficient of the k-th power.
    fn add_at(&mut self, k: usize, part: &Polynomial) -> Result<(), ExprError> {
        while self.coefficients.len() <= k {
            self.coefficients.push(Polynomial::zero(&self.frame));
        }
        self.coefficients.get_mut(k).map_or(Ok(()), |own| own.add(part))
    }

    pub(super) fn trimmed(mut self) -> Self {
        while self.coefficients.last().is_some_and(Polynomial::is_zero) {
            self.coefficients.pop();
        }
        self
    }

    pub(super) fn frame(&self) -> &Frame {
        &self.frame
    }

    pub(super) fn coefficients(&self) -> &[Polynomial] {
        &self.coefficients
    }

    pub(super) fn coefficient(&self, k: usize) -> Polynomial {
        self.coefficients.get(k).cloned().unwrap_or_else(|| Polynomial::zero(&self.frame))
    }

    /// The degree; 0 for constants, zero among them.
    pub(super) fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    pub(super) fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    pub(super) fn is_one(&self) -> bool {
        matches!(self.coefficients.as_slice(), [only] if only.only().is_some_and(|(m, n)| m.is_empty() && n.is_one()))
    }

    pub(super) fn times(&self, other: &Self) -> Result<Self, ExprError> {
        let mut result = Self::zero(&self.frame);
        for (i, a) in self.coefficients.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
            for (j, b) in other.coefficients.iter().enumerate().filter(|(_, b)| !b.is_zero()) {
                let product = a.times(b)?;
                result.add_at(i + j, &product)?;
            }
        }
        Ok(result.trimmed())
    }

    pub(super) fn power(&self, n: u32) -> Result<Self, ExprError> {
        let mut result = Self::constant(Polynomial::constant(Number::integer(1), &self.frame));
        for _ in 0..n {
            result = result.times(self)?;
        }
        Ok(result)
    }

    pub(super) fn add(&mut self, other: &Self) -> Result<(), ExprError> {
        for (k, coefficient) in other.coefficients.iter().enumerate() {
            self.add_at(k, coefficient)?;
        }
        *self = std::mem::replace(self, Self::zero(&other.frame)).trimmed();
        Ok(())
    }

    pub(super) fn minus(&self, other: &Self) -> Result<Self, ExprError> {
        let mut result = self.clone();
        let minus = Polynomial::constant(Number::integer(-1), &self.frame);
        result.add(&other.times(&Self::constant(minus))?)?;
        Ok(result)
    }

    /// Quotient and remainder.
    pub(super) fn divided_by(&self, divisor: &Self) -> Result<(Self, Self), ExprError> {
        let (mut left, mut quotient) = (self.clone(), Self::zero(&self.frame));
        let Some(lead) = divisor.coefficients.last() else { return Ok((quotient, left)) };
        let inverse = power::raise(lead, &Expr::integer(-1))?;
        while left.coefficients.len() >= divisor.coefficients.len() {
            self.frame.charge()?;
            let shift = left.coefficients.len() - divisor.coefficients.len();
            let Some(top) = left.coefficients.pop() else { break };
            if top.is_zero() {
                continue;
            }
            let factor = top.times(&inverse)?;
            for (k, own) in divisor.coefficients.iter().enumerate().take(divisor.degree()) {
                let part = own.times(&factor)?.scaled(&Number::integer(-1));
                left.add_at(k + shift, &part)?;
            }
            quotient.add_at(shift, &factor)?;
        }
        Ok((quotient.trimmed(), left.trimmed()))
    }

    /// The polynomial at −r.
    pub(super) fn mirrored(&self) -> Self {
        let sign = |k: usize| Number::integer(if k.is_multiple_of(2) { 1 } else { -1 });
        let coefficients = self.coefficients.iter().enumerate().map(|(k, c)| c.scaled(&sign(k))).collect();
        Self { coefficients, frame: self.frame.clone() }
    }
}
