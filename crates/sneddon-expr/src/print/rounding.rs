//! Formulas with decimals and rounded numbers, which are read and not computed with.

use crate::expr::{Expr, Node, Number, rewritten};
use crate::num::{DoubleDouble, precise};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

/// Rounding to a number of significant digits.
///
/// Decimals and whole numbers are rounded, and fractions whose numerator or denominator has more digits; other fractions stay.
/// Exponents and constant arguments of functions stay exact, because a function may vanish or change its law when they are rounded.
/// A product with a rounded number, or with a root of a longer one, has a single number, its numbers and their roots multiplied.
/// The reciprocal of a decimal is the reciprocal of the rounded decimal.
/// The square of a fraction beside squares of symbols is the square of the rounded fraction, so that √(x² − b²) vanishes at the printed b.
#[derive(Clone, Copy)]
pub(super) struct Rounding {
    /// The largest number of significant digits.
    pub(super) digits: u32,
}

/// The most digits of a double.
pub(super) const MOST_DIGITS: u32 = 17;

impl Rounding {
    /// The expression with rounded numbers.
    pub(super) fn expr(self, expr: &Expr) -> Expr {
        match expr.node() {
            Node::Number(number) => Expr::number(self.number(number)),
            Node::Constant(_) | Node::Symbol(_) => expr.clone(),
            Node::Function(function, arguments) => {
                // Those of min and max are breakpoints.
                let is_exact =
                    |own: &Expr| own.symbols().is_empty() && (expr.symbols().is_empty() || !["min", "max"].contains(&function.name()));
                let one = |own: &Expr| if is_exact(own) { own.clone() } else { self.expr(own) };
                Expr::function(*function, arguments.iter().map(one).collect())
            }
            Node::Sum(terms) => self.sum(expr, terms),
            Node::Power(..) | Node::Product(_) => {
                let (numbers, others): (Vec<Expr>, Vec<Expr>) = expr.factors().into_iter().partition(|own| power(own).is_some());
                let others = others.iter().map(|own| match own.node() {
                    Node::Power(base, exponent) => self.expr(base).pow(exponent),
                    _ => self.expr(own),
                });
                Expr::product(self.coefficient(numbers).into_iter().chain(others))
            }
        }
    }

    /// A sum with at least so many digits that no two of its terms become alike.
    ///
    /// A number beside squares of symbols may be a square, too.
    fn sum(self, exact: &Expr, terms: &[Expr]) -> Expr {
        let is_square =
            |own: &Expr| matches!(own.node(), Node::Power(base, exponent) if base.as_symbol().is_some() && *exponent == Expr::integer(2));
        let with_squares = terms.iter().any(|own| own.factors().iter().any(is_square));
        let square = |own: &Expr| own.as_number().filter(|_| with_squares).and_then(|own| self.square(own));
        let rounded = Expr::sum(terms.iter().map(|own| square(own).map_or_else(|| self.expr(own), Expr::number)));
        match rounded.node() {
            Node::Sum(kept) if kept.len() >= terms.len() => rounded,
            _ if self.digits < MOST_DIGITS => Self { digits: self.digits + 1 }.sum(exact, terms),
            _ => exact.clone(),
        }
    }

    /// The square of a rounded fraction, or less than 0 its opposite, for the square of a fraction.
    fn square(self, number: &Number) -> Option<Number> {
        let side = self.number(&number.abs().root(2)?);
        let square = &side * &side;
        Some(if number.is_negative() { -&square } else { square })
    }

    /// Numbers and powers of numbers, as one number if any of them is rounded.
    fn coefficient(self, factors: Vec<Expr>) -> Vec<Expr> {
        let powers: Vec<(Number, Number)> = factors.iter().filter_map(power).collect();
        let is_rounded = |(base, exponent): &(Number, Number)| {
            let under_root = !exponent.is_one() && self.is_longer(base.value().numer());
            under_root || self.is_rounded(base)
        };
        if !powers.iter().any(is_rounded) {
            return factors;
        }
        let exact = powers.iter().try_fold(Number::integer(1), |product, (base, exponent)| exponent.is_one().then(|| &product * base));
        match exact.or_else(|| value(&powers)) {
            Some(value) => vec![Expr::number(self.rounded(&value))],
            // Beyond the range of doubles every number is rounded alone.
            None => powers.iter().map(|(base, exponent)| Expr::number(self.number(base)).pow(&exponent.clone().into())).collect(),
        }
    }

    fn number(self, number: &Number) -> Number {
        if self.is_rounded(number) { self.rounded(number) } else { number.clone() }
    }

    /// The reciprocal of a decimal stays one, so that a/R and R are rounded alike.
    fn rounded(self, number: &Number) -> Number {
        let (upper, lower) = number.printed_parts();
        let reciprocal = || self.nearest(&lower).reciprocal().map(|own| if number.is_negative() { -&own } else { own });
        let is_reciprocal = upper.value().abs().is_one() && !lower.is_one();
        reciprocal().filter(|_| is_reciprocal).unwrap_or_else(|| self.nearest(number))
    }

    fn is_rounded(self, number: &Number) -> bool {
        let (upper, lower) = number.printed_parts();
        if !number.is_integer() && upper.is_integer() && lower.is_integer() {
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
    rewritten(expr, &|own, _| own.as_number().map(|number| Expr::number(number.with_decimals())))
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
