//! The layout of a product: its sign, a fraction, and the factors after the fraction.

use super::order::{self, Rank};
use super::{decimal_roots, roots};
use crate::expr::{Expr, Node, Number, Sign, sign};

/// A base and its exponent, which is 1 for a plain factor and never negative in a layout.
#[derive(Clone, PartialEq, Eq)]
pub(super) struct Factor {
    pub(super) base: Expr,
    pub(super) exponent: Expr,
}

/// −? upper/lower · behind; if `lower` is empty, all factors are in `upper`.
pub(super) struct Layout {
    pub(super) negative: bool,
    pub(super) upper: Vec<Factor>,
    pub(super) lower: Vec<Factor>,
    pub(super) behind: Vec<Factor>,
}

impl Factor {
    fn plain(base: Expr) -> Self {
        Self { base, exponent: Expr::one() }
    }

    /// The exponent's number, where it is a fraction or a whole number, 5.0 included.
    pub(super) fn fraction(&self) -> Option<&Number> {
        self.exponent.as_number().filter(|number| !number.is_decimal() || number.is_integer())
    }

    /// k, where the factor is the k-th root of its base.
    pub(super) fn root(&self) -> Option<i64> {
        let number = self.fraction().filter(|number| !number.is_integer())?;
        number.reciprocal()?.to_i64()
    }

    /// n, where the factor is a whole power of its base.
    pub(super) fn whole(&self) -> Option<i64> {
        self.fraction()?.to_i64()
    }
}

/// The layout of a product; any other expression is treated as a product of one factor.
pub(super) fn layout(expr: &Expr) -> Layout {
    layout_for(expr, true)
}

/// The same; `reads_back` demands that parsing restores the factors.
pub(super) fn layout_for(expr: &Expr, reads_back: bool) -> Layout {
    let factors = expr.factors();
    let (mut upper, mut lower) = (Vec::new(), Vec::new());
    let (mut negative, mut has_decimals) = (false, false);
    for factor in factors {
        match factor.node() {
            Node::Number(number) => {
                negative = number.is_negative();
                has_decimals = number.has_decimals();
                let (number, denominator) = number.abs().printed_parts();
                if !number.is_one() {
                    upper.push(Factor::plain(Expr::number(number)));
                }
                if !denominator.is_one() {
                    lower.push(Factor::plain(Expr::number(denominator)));
                }
            }
            Node::Power(base, exponent) if exponent.split_coefficient().0.is_negative() => {
                lower.push(Factor { base: base.clone(), exponent: -exponent });
            }
            Node::Power(base, exponent) => upper.push(Factor { base: base.clone(), exponent: exponent.clone() }),
            _ => upper.push(Factor::plain(factor)),
        }
    }
    decimal_roots::gather(&mut upper, &mut lower, has_decimals, reads_back);
    roots::gather(&mut upper, &mut lower);
    let (mut upper, mut lower) = (under_one_root(upper), under_one_root(lower));
    upper.sort_by(order::factors);
    lower.sort_by(order::factors);
    let (upper, behind) = if lower.is_empty() { (upper, Vec::new()) } else { divide(upper, &lower) };
    Layout { negative, upper, lower, behind }
}

/// Decides which factors go into the numerator and which after the fraction: π/2 x tan θ, x/R √(…), r²/(2R), sin(kr)/r.
fn divide(mut upper: Vec<Factor>, lower: &[Factor]) -> (Vec<Factor>, Vec<Factor>) {
    let numeric = |factor: &Factor| Rank::of(factor) <= Rank::Constant;
    if lower.iter().any(|factor| Rank::of(factor) == Rank::Function) {
        return (upper, Vec::new());
    }
    let line = if lower.iter().all(numeric) && upper.first().is_some_and(numeric) { Rank::Constant } else { Rank::Variable };
    for line in [line, Rank::Root] {
        let above = upper.partition_point(|factor| Rank::of(factor) <= line);
        if above > 0 {
            let behind = upper.split_off(above);
            return (upper, behind);
        }
    }
    (upper, Vec::new())
}

/// Joins roots, √2 √R to √(2R), if parsing restores the same factors: at most one number and at most one base of unknown sign.
fn under_one_root(factors: Vec<Factor>) -> Vec<Factor> {
    let mut joined: Vec<Factor> = Vec::with_capacity(factors.len());
    for factor in factors {
        let number = |base: &Expr| base.factors().iter().any(|part| part.as_number().is_some());
        let unknown = |base: &Expr| base.factors().iter().any(|part| sign(part) != Sign::Positive);
        let partner = joined.iter_mut().find(|own| {
            let both = |is: &dyn Fn(&Expr) -> bool| is(&own.base) && is(&factor.base);
            let atom = |factor: &Factor| Rank::of(factor) <= Rank::Variable;
            let power = |factor: &Factor| matches!(factor.base.node(), Node::Power(..));
            own.root() == factor.root() && atom(own) == atom(&factor) && !power(own) && !power(&factor) && !both(&number) && !both(&unknown)
        });
        match partner.filter(|_| factor.root().is_some()) {
            Some(own) => own.base = &own.base * &factor.base,
            None => joined.push(factor),
        }
    }
    joined
}
