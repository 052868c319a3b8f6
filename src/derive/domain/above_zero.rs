//! The condition that an expression in the parameters is positive, solved for one of them.

use crate::derive::domain::first_zero::last_root;
use crate::expr::{Condition, Expr, Sign, Symbol, normal, sign};

/// The highest odd power of a difference that is recognized when it is written out.
const HIGHEST: usize = 9;

/// 0 < expr, solved for a parameter where that leaves a parameter alone on either side, as in b < R; `None` where no parameters meet it.
///
/// Factors of known sign are dropped, every real power of u but a whole one is positive where u is, 1/u has the sign of u, and a square must
/// only not be zero.
pub(crate) fn above_zero(expr: &Expr) -> Option<Condition> {
    let (mut open, mut squares) = (Vec::new(), Vec::new());
    let mut is_negative = false;
    for factor in expr.factors() {
        let (base, exponent) = factor.split_power();
        match (sign(&factor), exponent.as_integer()) {
            (Sign::Positive, _) => {}
            (Sign::Negative, _) => is_negative = !is_negative,
            (_, Some(n)) if n % 2 == 0 => squares.push(base.power(2)),
            (_, Some(_)) => open.push(base),
            (_, None) if exponent.as_number().is_some() => open.push(base),
            _ => open.push(factor),
        }
    }
    if open.is_empty() && !squares.is_empty() {
        return (!is_negative).then(|| Condition::less(Expr::zero(), Expr::product(squares)));
    }
    let sides = Expr::product(open.into_iter().chain(squares));
    let own = if is_negative { -sides } else { sides };
    if let Some((root, _)) = last_root(&own) {
        return Some(Condition::less(Expr::zero(), root.power(2)));
    }
    if normal::square_root(&-&own).is_some() {
        return None;
    }
    Some(solved_for_a_parameter(&own).unwrap_or_else(|| Condition::less(Expr::zero(), own)))
}

/// A condition with a parameter alone on one side, if the expression has one or two terms in that parameter.
fn solved_for_a_parameter(expr: &Expr) -> Option<Condition> {
    for symbol in expr.symbols() {
        let Ok(terms) = normal::normal_terms(expr, &symbol) else { continue };
        let own = Expr::from(symbol.clone());
        if let Some((factor, limit)) = power_of_a_difference(&terms, &symbol) {
            let room = if sign(&factor) == Sign::Negative { limit - own } else { own - limit };
            return Some(solved_for_a_parameter(&room).unwrap_or_else(|| Condition::less(Expr::zero(), room)));
        }
        let [one, other] = terms.as_slice() else { continue };
        let (constant, power) = if one.exponent.is_zero() { (one, other) } else { (other, one) };
        let plain = constant.exponent.is_zero() && constant.kernel.is_one() && power.kernel.is_one();
        if !plain || sign(&power.exponent) != Sign::Positive {
            continue;
        }
        let limit = (-&constant.coefficient / &power.coefficient).pow(&power.exponent.recip());
        if limit.as_symbol().is_none() && limit.as_number().is_none() {
            continue;
        }
        return Some(match sign(&power.coefficient) {
            Sign::Negative => Condition::less(own, limit),
            _ => Condition::less(limit, own),
        });
    }
    None
}

/// c and b of c (s − b)^n for an odd n above 1, where c has a known sign.
fn power_of_a_difference(terms: &[normal::NormalTerm], symbol: &Symbol) -> Option<(Expr, Expr)> {
    let coefficients = normal::coefficients(terms)?;
    let degree = coefficients.len().checked_sub(1).filter(|n| n % 2 == 1 && (3..=HIGHEST).contains(n))?;
    let (highest, next) = (coefficients.get(degree)?, coefficients.get(degree - 1)?);
    if sign(highest) == Sign::Unknown {
        return None;
    }
    let (n, place) = (degree as i64, normal::expanded(&(-next / (Expr::integer(degree as i64) * highest)), symbol).ok()?);
    let power = normal::expanded(&(highest * (Expr::from(symbol.clone()) - &place).power(n)), symbol).ok()?;
    let typed = Expr::sum(terms.iter().map(|term| term.to_expr(symbol)));
    (normal::expanded(&typed, symbol).ok()? == power).then(|| (highest.clone(), place))
}
