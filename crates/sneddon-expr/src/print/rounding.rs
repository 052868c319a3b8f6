//! Formulas with decimals and rounded numbers, which are read and not computed with.

use crate::expr::{Expr, Node, Number};
use crate::num::{DoubleDouble, precise};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

/// How numbers are rounded.
///
/// Rounded are decimals, and fractions whose numerator or denominator has more digits; other fractions stay.
/// A product with such a number, or with a root of a longer one, has a single number, its numbers and their roots multiplied.
#[derive(Clone, Copy)]
pub(super) struct Rounding {
    /// The largest number of significant digits.
    pub(super) digits: u32,
    /// Whether whole numbers are rounded too; those that are exponents or arguments of functions stay.
    pub(super) whole: bool,
}

impl Rounding {
    /// The expression with rounded numbers.
    pub(super) fn expr(self, expr: &Expr) -> Expr {
        match expr.node() {
            Node::Number(number) => Expr::number(self.number(number)),
            Node::Constant(_) | Node::Symbol(_) => expr.clone(),
            Node::Function(function, arguments) => {
                let one = |own: &Expr| if own.as_integer().is_some() { own.clone() } else { self.expr(own) };
                Expr::function(*function, arguments.iter().map(one).collect())
            }
            Node::Sum(terms) => Expr::sum(terms.iter().map(|own| self.expr(own))),
            Node::Power(..) | Node::Product(_) => {
                let (numbers, others): (Vec<Expr>, Vec<Expr>) = expr.factors().into_iter().partition(|own| power(own).is_some());
                let others = others.iter().map(|own| match own.node() {
                    Node::Power(base, exponent) => self.expr(base).pow(&self.exponent(exponent)),
                    _ => self.expr(own),
                });
                Expr::product(self.coefficient(numbers).into_iter().chain(others))
            }
        }
    }

    fn exponent(self, exponent: &Expr) -> Expr {
        Self { whole: false, ..self }.expr(exponent)
    }

    /// Numbers and powers of numbers, as one number if any of them is rounded.
    fn coefficient(self, factors: Vec<Expr>) -> Vec<Expr> {
        let powers: Vec<(Number, Number)> = factors.iter().filter_map(power).collect();
        let is_rounded = |(base, exponent): &(Number, Number)| {
            let under_root = !exponent.is_one() && (self.is_longer(base.value().numer()) || self.is_rounded(exponent));
            under_root || self.is_rounded(base)
        };
        if !powers.iter().any(is_rounded) {
            return factors;
        }
        let exact = powers.iter().try_fold(Number::integer(1), |product, (base, exponent)| exponent.is_one().then(|| &product * base));
        match exact.or_else(|| value(&powers)) {
            Some(value) => vec![Expr::number(self.nearest(&value))],
            // Beyond the range of doubles every number is rounded alone.
            None => powers
                .iter()
                .map(|(base, exponent)| Expr::number(self.number(base)).pow(&self.exponent(&exponent.clone().into())))
                .collect(),
        }
    }

    fn number(self, number: &Number) -> Number {
        if self.is_rounded(number) { self.nearest(number) } else { number.clone() }
    }

    fn is_rounded(self, number: &Number) -> bool {
        if number.is_integer() {
            return self.whole && self.nearest(number) != *number;
        }
        let (upper, lower) = number.printed_parts();
        if upper.is_integer() && lower.is_integer() {
            [upper, lower].iter().any(|own| self.is_longer(own.value().numer()))
        } else {
            self.nearest(number) != *number
        }
    }

    fn is_longer(self, whole: &BigInt) -> bool {
        whole.abs() >= BigInt::from(10).pow(self.digits)
    }

    /// The nearest decimal with this many significant digits, away from 0 at a tie.
    fn nearest(self, number: &Number) -> Number {
        let magnitude = number.value().abs();
        let ten = |power: i64| BigRational::from_integer(BigInt::from(10)).pow(i32::try_from(power).unwrap_or(0));
        // The power of ten of the first digit, from the number of bits: at most one off.
        let bits = magnitude.numer().bits() as f64 - magnitude.denom().bits() as f64;
        let estimate = (bits * std::f64::consts::LOG10_2).floor() as i64;
        let first = (estimate - 1..=estimate + 1).rev().find(|power| magnitude >= ten(*power)).unwrap_or(estimate);
        let last = first + 1 - i64::from(self.digits);
        let decimal = Number::parse_decimal(&format!("{}e{last}", (magnitude / ten(last)).round().to_integer()));
        decimal.map_or_else(|| number.clone(), |own| if number.is_negative() { -&own } else { own })
    }
}

/// The expression with long fractions as decimals.
pub(super) fn with_decimals(expr: &Expr) -> Expr {
    match expr.node() {
        Node::Number(number) => Expr::number(number.with_decimals()),
        Node::Constant(_) | Node::Symbol(_) => expr.clone(),
        Node::Function(function, arguments) => Expr::function(*function, arguments.iter().map(with_decimals).collect()),
        Node::Sum(terms) => Expr::sum(terms.iter().map(with_decimals)),
        Node::Product(factors) => Expr::product(factors.iter().map(with_decimals)),
        Node::Power(base, exponent) => with_decimals(base).pow(&with_decimals(exponent)),
    }
}

/// Base and exponent of a number or of a power of a positive number.
fn power(factor: &Expr) -> Option<(Number, Number)> {
    match factor.node() {
        Node::Number(number) => Some((number.clone(), Number::integer(1))),
        Node::Power(base, exponent) => base.as_number().filter(|own| own.is_positive()).cloned().zip(exponent.as_number().cloned()),
        _ => None,
    }
}

/// The product of the powers with about 30 digits; `None` if it or a factor is far from the range of doubles.
fn value(powers: &[(Number, Number)]) -> Option<Number> {
    let in_range = |own: &DoubleDouble| (1e-140..1e140).contains(&own.hi.abs());
    let double = |own: &Number| {
        let hi = own.to_f64();
        Some(DoubleDouble { hi, lo: (own - &Number::from_f64(hi)?).to_f64() }).filter(in_range)
    };
    let product = powers.iter().try_fold(DoubleDouble::ONE, |product, (base, exponent)| {
        let factor = Some(precise::pow(double(base)?, double(exponent)?).value).filter(in_range)?;
        Some(product.mul(factor)).filter(in_range)
    })?;
    Some(&Number::from_f64(product.hi)? + &Number::from_f64(product.lo)?)
}
