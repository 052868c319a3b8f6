//! Products of powers, which a factor can be multiplied into but never written over.

use crate::expr::Expr;
use std::collections::BTreeMap;
use std::ops::Deref;

/// A product of powers of distinct atoms; an atom is anything that the expansion does not look into.
///
/// It is read as the map from each atom to its exponent. The only way to put a factor in is [`Self::multiply`], so that a
/// factor which is there already can never be lost.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::expr::normal) struct Monomial(BTreeMap<Expr, Expr>);

impl Monomial {
    /// The empty product, which is 1.
    pub(in crate::expr::normal) fn new() -> Self {
        Self::default()
    }

    /// atom^power.
    pub(in crate::expr::normal) fn power(atom: Expr, power: Expr) -> Self {
        Self::from_iter([(atom, power)])
    }

    /// Multiplies by atom^power: exponents of one atom add up, and one that becomes 0 leaves.
    pub(in crate::expr::normal) fn multiply(&mut self, atom: Expr, power: Expr) {
        let total = match self.0.remove(&atom) {
            Some(before) => before + power,
            None => power,
        };
        if !total.is_zero() {
            self.0.insert(atom, total);
        }
    }

    /// The product of two.
    pub(in crate::expr::normal) fn times(&self, other: &Self) -> Self {
        let mut product = self.clone();
        product.extend(other.clone());
        product
    }

    /// Takes an atom out with its power.
    pub(in crate::expr::normal) fn remove(&mut self, atom: &Expr) -> Option<Expr> {
        self.0.remove(atom)
    }
}

impl Deref for Monomial {
    type Target = BTreeMap<Expr, Expr>;

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl Extend<(Expr, Expr)> for Monomial {
    fn extend<I: IntoIterator<Item = (Expr, Expr)>>(&mut self, factors: I) {
        for (atom, power) in factors {
            self.multiply(atom, power);
        }
    }
}

impl FromIterator<(Expr, Expr)> for Monomial {
    fn from_iter<I: IntoIterator<Item = (Expr, Expr)>>(factors: I) -> Self {
        let mut product = Self::new();
        product.extend(factors);
        product
    }
}

impl IntoIterator for Monomial {
    type Item = (Expr, Expr);
    type IntoIter = std::collections::btree_map::IntoIter<Expr, Expr>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'a> IntoIterator for &'a Monomial {
    type Item = (&'a Expr, &'a Expr);
    type IntoIter = std::collections::btree_map::Iter<'a, Expr, Expr>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}
