//! Exact coefficients of the recurrences: Laurent polynomials in x, ρ, s², an end e of the segment, and Q(e).

use crate::expr::{Expr, Number};
use std::collections::BTreeMap;

/// The variables of a coefficient, by their position among the exponents.
///
/// s² = ρ² + σx² and Q(e) = ρ² + σe² are independent variables until [`Laurent::to_expr`] expands their positive powers.
#[derive(Clone, Copy)]
pub(super) enum Variable {
    /// x, the argument of g or F.
    X,
    /// ρ, the length in Q = ρ² + σr².
    Length,
    /// s² = Q(x).
    Square,
    /// e, an end of the segment.
    End,
    /// Q(e).
    AtEnd,
}

type Exponents = [i32; 5];

/// A sum of rational numbers times whole powers, negative ones included, of the five variables.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Laurent(BTreeMap<Exponents, Number>);

/// The values of the variables when a coefficient is converted to an expression.
pub(super) struct Values {
    /// x.
    pub(super) x: Expr,
    /// ρ².
    pub(super) square_length: Expr,
    /// e.
    pub(super) end: Expr,
    /// σ, +1 or −1.
    pub(super) sigma: i64,
}

impl Laurent {
    /// The number p/q.
    pub(super) fn ratio(p: i64, q: i64) -> Self {
        let mut result = Self::default();
        result.add([0; 5], Number::ratio(p, q));
        result
    }

    /// 1.
    pub(super) fn one() -> Self {
        Self::ratio(1, 1)
    }

    /// True for the sum without terms.
    pub(super) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    fn add(&mut self, exponents: Exponents, number: Number) {
        let total = self.0.get(&exponents).map_or_else(|| number.clone(), |own| own + &number);
        if total.is_zero() {
            self.0.remove(&exponents);
        } else {
            self.0.insert(exponents, total);
        }
    }

    /// The sum of both.
    pub(super) fn plus(&self, other: &Self) -> Self {
        let mut result = self.clone();
        for (exponents, number) in &other.0 {
            result.add(*exponents, number.clone());
        }
        result
    }

    /// The product with p/q.
    pub(super) fn scaled(&self, p: i64, q: i64) -> Self {
        self.times_number(&Number::ratio(p, q))
    }

    /// The product with a power of one variable.
    pub(super) fn times(&self, variable: Variable, power: i32) -> Self {
        let shift = |exponents: &Exponents| {
            let mut next = *exponents;
            if let Some(own) = next.get_mut(variable as usize) {
                *own += power;
            }
            next
        };
        Self(self.0.iter().map(|(e, n)| (shift(e), n.clone())).collect())
    }

    /// The value at e = 0, where Q(e) is ρ².
    pub(super) fn at_axis(&self) -> Self {
        let mut result = Self::default();
        for ([x, length, square, end, at_end], number) in &self.0 {
            if *end == 0 {
                result.add([*x, length + 2 * at_end, *square, 0, 0], number.clone());
            }
        }
        result
    }

    /// Its terms as powers of s² alone, by x² = σ(s² − ρ²); `None` for odd or negative powers of x.
    pub(super) fn in_square(&self, sigma: i64) -> Option<BTreeMap<i32, Self>> {
        let mut rest = self.clone();
        while let Some((exponents, number)) = rest.0.iter().next_back().map(|(e, n)| (*e, n.clone())).filter(|(e, _)| e[0] > 0) {
            let [x, length, square, end, at_end] = exponents;
            rest.0.remove(&exponents);
            let number = &number * &Number::integer(sigma);
            rest.add([x - 2, length, square + 1, end, at_end], number.clone());
            rest.add([x - 2, length + 2, square, end, at_end], -&number);
        }
        let mut result: BTreeMap<i32, Self> = BTreeMap::new();
        for ([x, length, square, end, at_end], number) in rest.0 {
            if x != 0 {
                return None;
            }
            result.entry(square).or_default().add([0, length, 0, end, at_end], number);
        }
        result.retain(|_, own| !own.is_zero());
        Some(result)
    }

    /// Its terms by powers of x, where s² does not occur.
    pub(super) fn in_x(&self) -> Option<BTreeMap<i32, Self>> {
        let mut result: BTreeMap<i32, Self> = BTreeMap::new();
        for ([x, length, square, end, at_end], number) in &self.0 {
            if *square != 0 {
                return None;
            }
            result.entry(*x).or_default().add([0, *length, 0, *end, *at_end], number.clone());
        }
        Some(result)
    }

    /// The powers of ρ with their numbers, for a coefficient that has no other variable.
    pub(super) fn monomials(&self) -> impl Iterator<Item = (i32, &Number)> {
        self.0.iter().map(|([_, length, ..], number)| (*length, number))
    }

    /// The product with a number.
    pub(super) fn times_number(&self, factor: &Number) -> Self {
        Self(self.0.iter().map(|(e, n)| (*e, n * factor)).filter(|(_, n)| !n.is_zero()).collect())
    }

    /// As an expression: powers of s² and Q(e) and a monomial, times a polynomial with whole coefficients.
    pub(super) fn to_expr(&self, values: &Values) -> Expr {
        if self.is_zero() {
            return Expr::zero();
        }
        let (rest, square) = self.clone().collected(Variable::Square, Variable::X, values.sigma);
        let (rest, at_end) = rest.collected(Variable::AtEnd, Variable::End, values.sigma);
        let mut least: Exponents = [i32::MAX; 5];
        let mut content: Option<Number> = None;
        for (exponents, number) in &rest.0 {
            for (low, own) in least.iter_mut().zip(exponents) {
                *low = (*low).min(*own);
            }
            content = Some(content.map_or_else(|| number.abs(), |c| c.common_factor(number)));
        }
        let content = content.unwrap_or_else(|| Number::integer(1));
        let inverse = content.reciprocal().unwrap_or_else(|| Number::integer(1));
        let monomial = |exponents: &Exponents| {
            let [x, length, _, end, _] = exponents;
            let length = values.square_length.pow(&Expr::ratio(i64::from(*length), 2));
            let end = if *end == 0 { Expr::one() } else { values.end.power(i64::from(*end)) };
            values.x.power(i64::from(*x)) * length * end
        };
        let polynomial = Expr::sum(rest.0.iter().map(|(exponents, number)| {
            let mut own = *exponents;
            for (power, low) in own.iter_mut().zip(&least) {
                *power -= low;
            }
            Expr::number(number * &inverse) * monomial(&own)
        }));
        let quadratic = |place: &Expr| &values.square_length + Expr::integer(values.sigma) * place.power(2);
        let at_end = if at_end == 0 { Expr::one() } else { quadratic(&values.end).power(i64::from(at_end)) };
        Expr::number(content) * monomial(&least) * quadratic(&values.x).power(i64::from(square)) * at_end * polynomial
    }

    /// Factors out the largest integer power of `quadratic` = ρ² + σ·place² and expands the remaining factor.
    fn collected(self, quadratic: Variable, place: Variable, sigma: i64) -> (Self, i32) {
        let (index, inner) = (quadratic as usize, place as usize);
        let power = |e: &Exponents, i: usize| e.get(i).copied().unwrap_or(0);
        let mut lowest = self.0.keys().map(|e| power(e, index)).min().unwrap_or(0);
        let mut rest = self.times(quadratic, -lowest);
        // Positive powers are expanded one by one.
        while let Some((exponents, number)) = rest.0.iter().find(|(e, _)| power(e, index) > 0).map(|(e, n)| (*e, n.clone())) {
            rest.0.remove(&exponents);
            let lower = Self(BTreeMap::from([(exponents, number)])).times(quadratic, -1);
            rest = rest.plus(&lower.times(Variable::Length, 2)).plus(&lower.times(place, 2).scaled(sigma, 1));
        }
        while let Some(quotient) = rest.divided(inner, sigma) {
            rest = quotient;
            lowest += 1;
        }
        (rest, lowest)
    }

    /// The quotient by ρ² + σ·place², if it is exact.
    fn divided(&self, place: usize, sigma: i64) -> Option<Self> {
        let (mut rest, mut quotient) = (self.clone(), Self::default());
        let power = |e: &Exponents| e.get(place).copied().unwrap_or(0);
        let lowest = self.0.keys().map(power).min()?;
        while let Some((exponents, number)) = rest.0.iter().max_by_key(|(e, _)| power(e)).map(|(e, n)| (*e, n.clone())) {
            let mut next = exponents;
            *next.get_mut(place)? -= 2;
            if power(&next) < lowest {
                return None;
            }
            let number = &number * &Number::integer(sigma);
            quotient.add(next, number.clone());
            rest.0.remove(&exponents);
            next[1] += 2;
            rest.add(next, -&number);
        }
        Some(quotient)
    }
}
