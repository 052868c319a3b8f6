//! Laurent polynomials in front of a few functions: what the recurrences of moments are made of, exact at every step.

use crate::expr::{Expr, Number};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::BTreeMap;

/// Σ Λ_i(y)·B_i(y): Laurent polynomials Λ_i with rational coefficients before functions B_i that are named when written.
#[derive(Clone, Debug, Default)]
pub struct Combination(Vec<Laurent>);

/// Σ c_j y^j with whole j of either sign.
#[derive(Clone, Debug, Default)]
pub(super) struct Laurent(BTreeMap<i64, BigRational>);

/// A function B_i as it is written: a constant factor, which is kept apart, and the rest.
pub struct Member {
    /// Free of the variable.
    pub(super) factor: Expr,
    /// The function itself.
    pub(super) function: Expr,
}

/// How the functions differentiate: the row i has the parts of B_i′.
pub(super) type Law = Vec<Combination>;

/// A function with its constant factor.
pub fn member(factor: Expr, function: Expr) -> Member {
    Member { factor, function }
}

impl Laurent {
    /// (p/q)·y^j.
    pub(super) fn term(p: i64, q: i64, j: i64) -> Self {
        let coefficient = if q == 0 { BigRational::zero() } else { BigRational::new(p.into(), q.into()) };
        Self(BTreeMap::from([(j, coefficient)])).pruned()
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        for (j, c) in &other.0 {
            *sum.0.entry(*j).or_insert_with(BigRational::zero) += c;
        }
        sum.pruned()
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        let mut product = Self::default();
        for (i, c) in &self.0 {
            for (j, d) in &other.0 {
                *product.0.entry(i + j).or_insert_with(BigRational::zero) += c * d;
            }
        }
        product.pruned()
    }

    pub(super) fn derivative(&self) -> Self {
        Self(self.0.iter().map(|(j, c)| (j - 1, c * BigRational::from_integer(BigInt::from(*j)))).collect()).pruned()
    }

    fn pruned(mut self) -> Self {
        self.0.retain(|_, c| !c.is_zero());
        self
    }
}

impl Combination {
    /// (p/q)·y^j before the function at a position.
    pub fn single(position: usize, p: i64, q: i64, j: i64) -> Self {
        let mut parts = vec![Laurent::default(); position];
        parts.push(Laurent::term(p, q, j));
        Self(parts)
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        let length = self.0.len().max(other.0.len());
        let part = |of: &Self, i: usize| of.0.get(i).cloned().unwrap_or_default();
        Self((0..length).map(|i| part(self, i).plus(&part(other, i))).collect())
    }

    pub(super) fn times(&self, factor: &Laurent) -> Self {
        Self(self.0.iter().map(|part| part.times(factor)).collect())
    }

    /// (p/q)·y^j times this.
    pub(super) fn scaled(&self, p: i64, q: i64, j: i64) -> Self {
        self.times(&Laurent::term(p, q, j))
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.scaled(-1, 1, 0))
    }

    /// d/dy, by the law of the functions.
    pub fn derivative(&self, law: &[Self]) -> Self {
        let outer = Self(self.0.iter().map(Laurent::derivative).collect());
        self.0.iter().zip(law).fold(outer, |sum, (part, own)| sum.plus(&own.times(part)))
    }

    /// The combination with y^j B_i replaced by its integral from 0.
    pub(super) fn integrated(&self, integral: &dyn Fn(usize, i64) -> Self) -> Self {
        let parts = self.0.iter().enumerate().flat_map(|(position, part)| part.0.iter().map(move |(j, c)| (position, *j, c)));
        parts.fold(Self::default(), |sum, (position, j, c)| {
            sum.plus(&integral(position, j).times(&Laurent(BTreeMap::from([(0, c.clone())]))))
        })
    }

    /// `factor` times the combination at y, with common powers of y, numbers and constants taken out.
    pub fn written(&self, factor: &Expr, y: &Expr, members: &[Member]) -> Expr {
        let present: Vec<(&Laurent, &Member)> = self.0.iter().zip(members).filter(|(part, _)| !part.0.is_empty()).collect();
        let coefficients: Vec<&BigRational> = present.iter().flat_map(|(part, _)| part.0.values()).collect();
        let (Some(low), Some(content)) = (present.iter().filter_map(|(part, _)| part.0.keys().next()).min(), common_number(&coefficients))
        else {
            return Expr::zero();
        };
        let common = match present.as_slice() {
            [(_, first), rest @ ..] if rest.iter().all(|(_, other)| other.factor == first.factor) => first.factor.clone(),
            _ => Expr::one(),
        };
        let sum = Expr::sum(present.iter().map(|(part, member)| {
            // Move the common factor and the sign of a polynomial to the front.
            let own = common_number(&part.0.values().collect::<Vec<_>>()).unwrap_or_else(BigRational::one);
            let first = part.0.keys().next().unwrap_or(low);
            let polynomial = Expr::sum(part.0.iter().map(|(j, c)| number(c / &own) * y.power(j - first)));
            let factors = [number(&own / &content), y.power(first - low), &member.factor / &common, polynomial, member.function.clone()];
            Expr::product(factors)
        }));
        Expr::product([factor.clone(), y.power(*low), common, number(content), sum])
    }

    /// The same function by function, and power by power before the function 1.
    pub(super) fn written_apart(&self, factor: &Expr, y: &Expr, members: &[Member]) -> Expr {
        let mut pieces = Vec::new();
        for (position, (part, member)) in self.0.iter().zip(members).enumerate() {
            let monomials: Vec<Laurent> = if member.function.is_one() {
                part.0.iter().map(|(j, c)| Laurent(BTreeMap::from([(*j, c.clone())]))).collect()
            } else {
                vec![part.clone()]
            };
            pieces.extend(monomials.into_iter().map(|own| Self::single(position, 1, 1, 0).times(&own).written(factor, y, members)));
        }
        Expr::sum(pieces)
    }
}

fn number(value: BigRational) -> Expr {
    Expr::number(Number::from(value))
}

/// The largest rational that leaves whole coefficients, negative where most of them are.
fn common_number(coefficients: &[&BigRational]) -> Option<BigRational> {
    let numerator = coefficients.iter().fold(BigInt::zero(), |common, c| common.gcd(c.numer()));
    let denominator = coefficients.iter().fold(BigInt::one(), |common, c| common.lcm(c.denom()));
    let negative = coefficients.iter().filter(|c| c.is_negative()).count();
    let content = BigRational::new(numerator, denominator);
    (!content.is_zero()).then(|| if 2 * negative > coefficients.len() { -content } else { content })
}
