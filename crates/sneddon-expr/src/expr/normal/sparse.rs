//! Sums of products in one order of their monomials, for exact division and square roots.

use super::polynomial::{Monomial, Polynomial};
use crate::expr::{Expr, Number};
use crate::num::work;
use std::collections::BTreeMap;

/// The finest step of exponents: 1/60.
const STEP: i64 = 60;
/// The most terms that a quotient or a root may have.
const LONGEST: usize = 60;

/// A sum of products, its monomials ordered by the exponents of the atoms one after another.
#[derive(Clone, Debug)]
pub(super) struct Sparse {
    atoms: Vec<Expr>,
    terms: BTreeMap<Vec<i64>, Number>,
}

impl Sparse {
    /// Two polynomials over the same atoms; `None` if an exponent is not a multiple of 1/60.
    pub(super) fn pair(first: &Polynomial, second: &Polynomial) -> Option<(Self, Self)> {
        let mut atoms: Vec<Expr> = first.terms().chain(second.terms()).flat_map(|(m, _)| m.keys().cloned()).collect();
        atoms.sort();
        atoms.dedup();
        Some((Self::read(first, &atoms)?, Self::read(second, &atoms)?))
    }

    fn read(polynomial: &Polynomial, atoms: &[Expr]) -> Option<Self> {
        let step = Number::integer(STEP);
        let mut terms = BTreeMap::new();
        for (monomial, number) in polynomial.terms() {
            let exponents = atoms.iter().map(|atom| monomial.get(atom).map_or(Some(0), |p| (p.as_number()? * &step).to_i64()));
            terms.insert(exponents.collect::<Option<Vec<i64>>>()?, number.clone());
        }
        Some(Self { atoms: atoms.to_vec(), terms })
    }

    /// Converts back to a polynomial in the frame of the given polynomial.
    pub(super) fn to_polynomial(&self, like: &Polynomial) -> Polynomial {
        let mut result = Polynomial::zero(like.frame());
        for (exponents, number) in &self.terms {
            let powers = self.atoms.iter().zip(exponents).filter(|(_, e)| **e != 0);
            let monomial: Monomial = powers.map(|(atom, e)| (atom.clone(), Expr::ratio(*e, STEP))).collect();
            result.add_term(monomial, number);
        }
        result
    }

    fn add(&mut self, exponents: Vec<i64>, number: &Number) {
        let entry = self.terms.entry(exponents).or_insert_with(|| Number::integer(0));
        *entry = &*entry + number;
    }

    fn clean(&mut self) {
        self.terms.retain(|_, number| !number.is_zero());
    }

    /// The lowest and the highest exponent of every atom.
    fn ranges(&self) -> Vec<(i64, i64)> {
        let of = |atom: usize| {
            let exponents = || self.terms.keys().filter_map(|list| list.get(atom).copied());
            (exponents().min().unwrap_or(0), exponents().max().unwrap_or(0))
        };
        (0..self.atoms.len()).map(of).collect()
    }

    /// The quotient, where the division is exact.
    pub(super) fn divided_by(&self, divisor: &Self) -> Option<Self> {
        let (lead, lead_number) = divisor.terms.last_key_value()?;
        let inverse = lead_number.reciprocal()?;
        let (whole, part) = (self.ranges(), divisor.ranges());
        let mut left = self.clone();
        let mut quotient = Self { atoms: self.atoms.clone(), terms: BTreeMap::new() };
        while let Some((exponents, number)) = left.terms.last_key_value() {
            // Products beyond the work limit are 0 and cancel nothing.
            if quotient.terms.len() >= LONGEST || work::is_exhausted() {
                return None;
            }
            let (shift, factor) = (difference(exponents, lead), number * &inverse);
            // The ranges of exponents add up in a product.
            let mut ranges = shift.iter().zip(whole.iter().zip(&part));
            if !ranges.all(|(e, ((low, high), (least, most)))| (low - least..=high - most).contains(e)) {
                return None;
            }
            for (own, own_number) in &divisor.terms {
                left.add(own.iter().zip(&shift).map(|(a, b)| a + b).collect(), &-&(own_number * &factor));
            }
            left.clean();
            quotient.add(shift, &factor);
        }
        Some(quotient)
    }

    /// s with s² = self and a positive leading coefficient, exponents whole.
    pub(super) fn square_root(&self) -> Option<Self> {
        let (lead, number) = self.terms.last_key_value()?;
        if lead.iter().any(|e| e % (2 * STEP) != 0) || !number.is_positive() {
            return None;
        }
        let lead: Vec<i64> = lead.iter().map(|e| e / 2).collect();
        let lead_number = number.root(2)?;
        let inverse = (&lead_number + &lead_number).reciprocal()?;
        let mut root = Self { atoms: self.atoms.clone(), terms: BTreeMap::from([(lead.clone(), lead_number.clone())]) };
        let ranges = self.ranges();
        let mut left = self.clone();
        left.terms.pop_last();
        // left = self − root², whose leading term fixes the next term of the root.
        while let Some((exponents, number)) = left.terms.last_key_value() {
            let (next, factor) = (difference(exponents, &lead), number * &inverse);
            if work::is_exhausted() || root.terms.len() >= LONGEST || root.terms.first_key_value().is_none_or(|(lowest, _)| next >= *lowest)
            {
                return None;
            }
            if !next.iter().zip(&ranges).all(|(e, (low, high))| (*low..=*high).contains(&(2 * e))) {
                return None;
            }
            for (own, own_number) in &root.terms {
                let twice = own_number + own_number;
                left.add(own.iter().zip(&next).map(|(a, b)| a + b).collect(), &-&(&twice * &factor));
            }
            left.add(next.iter().map(|e| 2 * e).collect(), &-&(&factor * &factor));
            left.clean();
            root.add(next, &factor);
        }
        Some(root)
    }
}

fn difference(a: &[i64], b: &[i64]) -> Vec<i64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// The exact quotient of two polynomials.
pub(super) fn quotient(dividend: &Polynomial, divisor: &Polynomial) -> Option<Polynomial> {
    let (upper, lower) = Sparse::pair(dividend, divisor)?;
    Some(upper.divided_by(&lower)?.to_polynomial(dividend))
}

/// The exact square root of a polynomial.
pub(super) fn square_root(polynomial: &Polynomial) -> Option<Polynomial> {
    let (own, _) = Sparse::pair(polynomial, polynomial)?;
    Some(own.square_root()?.to_polynomial(polynomial))
}
