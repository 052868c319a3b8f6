//! Products of polynomials in one symbol, over whole numbers.

use super::monomial::Monomial;
use crate::expr::{Expr, Node, Number};
use crate::num::work;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};
use std::collections::BTreeMap;

/// The product of two polynomials with several terms each in one symbol; `None` for others.
///
/// Products of whole numbers are added up over a common denominator, and only the sums are reduced: the general way reduces a
/// fraction and looks up a monomial for each pair of terms.
pub(super) fn product(left: &BTreeMap<Monomial, Number>, right: &BTreeMap<Monomial, Number>) -> Option<BTreeMap<Monomial, Number>> {
    if left.len() < 2 || right.len() < 2 {
        return None;
    }
    let mut symbol = None;
    let (left, right) = (Dense::read(left, &mut symbol)?, Dense::read(right, &mut symbol)?);
    let mut sums: BTreeMap<u32, (BigInt, bool)> = BTreeMap::new();
    for (m, a, with_decimals) in &left.terms {
        for (n, b, other) in &right.terms {
            spend(a.bits() + b.bits());
            let (sum, has_decimals) = sums.entry(m.checked_add(*n)?).or_default();
            *sum += a * b;
            *has_decimals |= with_decimals | other;
        }
    }
    let denominator = &left.denominator * &right.denominator;
    let term = |(n, (sum, has_decimals)): (u32, (BigInt, bool))| {
        let monomial = if n == 0 { Monomial::new() } else { Monomial::power(symbol?.clone(), Expr::integer(n.into())) };
        Some((monomial, Number::computed(BigRational::new(sum, denominator.clone()), has_decimals)))
    };
    sums.into_iter().filter(|(_, (sum, _))| !sum.is_zero()).map(term).collect()
}

/// Counts a product of whole numbers of together so many bits.
fn spend(bits: u64) {
    let words = 1 + bits / 64;
    work::spend(6 + words + words * words / 16);
}

/// A polynomial in one symbol.
struct Dense {
    /// Exponents, numerators over the common denominator, and whether the coefficient has decimals.
    terms: Vec<(u32, BigInt, bool)>,
    denominator: BigInt,
}

impl Dense {
    /// `None` unless every term is a natural power of the symbol, which is set if it is not known.
    fn read<'a>(terms: &'a BTreeMap<Monomial, Number>, symbol: &mut Option<&'a Expr>) -> Option<Self> {
        let mut exponent =
            |monomial: &'a Monomial| match monomial.iter().next() {
                None => Some(0),
                Some((base, power)) if monomial.len() == 1 && matches!(base.node(), Node::Symbol(_)) => {
                    if *symbol.get_or_insert(base) == base { power.as_integer().and_then(|n| u32::try_from(n).ok()) } else { None }
                }
                Some(_) => None,
            };
        let exponents = terms.keys().map(&mut exponent).collect::<Option<Vec<_>>>()?;
        let denominator = terms.values().fold(BigInt::one(), |total, own| {
            spend(total.bits() + own.bits());
            total.lcm(own.value().denom())
        });
        let whole = |own: &Number| own.value().numer() * (&denominator / own.value().denom());
        let terms = exponents.into_iter().zip(terms.values()).map(|(n, own)| (n, whole(own), own.has_decimals())).collect();
        Some(Self { terms, denominator })
    }
}
