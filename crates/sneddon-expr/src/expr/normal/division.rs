//! Division step by step, for expansions that stay near what was typed.

use super::polynomial::{Monomial, Polynomial};
use super::power::raise_monomial;
use crate::expr::{Expr, ExprError, Number};

/// One step of a partial fraction for r^m·q^p with p ≤ −1.
///
/// With q = c r^k + rest and m ≥ k: r^m q^p = r^(m−k)/c · (q^(p+1) − rest·q^p), which lowers the degree.
/// With q = c + rest and m < 0: r^m q^p = r^m/c · (q^(p+1) − rest·q^p), which raises the negative power.
pub(super) fn divide(monomial: &Monomial, atom: &Expr, power: &Expr, number: &Number, result: &mut Polynomial) -> Result<bool, ExprError> {
    let frame = result.frame().clone();
    let radius = Expr::from(frame.variable().clone());
    let Some(m) = monomial.get(&radius).and_then(Expr::as_integer) else { return Ok(false) };
    let polynomial = Polynomial::expand(atom, &frame)?;
    let mut degrees = Vec::new();
    for (own, _) in polynomial.terms() {
        if own.iter().any(|(a, p)| *a != radius && (a.contains(frame.variable()) || p.contains(frame.variable()))) {
            return Ok(false);
        }
        match own.get(&radius).map_or(Some(0), Expr::as_integer).filter(|k| *k >= 0) {
            Some(k) => degrees.push(k),
            None => return Ok(false),
        }
    }
    let degree = if m < 0 { 0 } else { degrees.iter().copied().max().unwrap_or(0) };
    // A leading or constant coefficient that is a sum has no simple inverse: leave the term as it is.
    if (m >= 0 && (degree == 0 || m < degree)) || degrees.iter().filter(|k| **k == degree).count() != 1 {
        return Ok(false);
    }
    let (mut leading, mut rest) = (None, Polynomial::zero(&frame));
    for ((own, coefficient), k) in polynomial.terms().zip(&degrees) {
        if *k == degree {
            leading = Some((own.clone(), coefficient.clone()));
        } else {
            rest.add_term(own.clone(), coefficient);
        }
    }
    let Some((mut own, coefficient)) = leading else { return Ok(false) };
    own.remove(&radius);
    let inverse = raise_monomial(&own, &coefficient, &Expr::integer(-1), &frame)?;
    let mut others = monomial.clone();
    others.remove(atom);
    others.multiply(radius.clone(), Expr::integer(-degree));
    let front = Polynomial::single(others, number.clone(), &frame).times(&inverse)?;
    let next = power + Expr::one();
    let raised =
        if next.is_zero() { Polynomial::constant(Number::integer(1), &frame) } else { Polynomial::atom(atom.clone(), next, &frame) };
    result.add(&front.times(&raised)?)?;
    let second = front.scaled(&Number::integer(-1)).times(&rest)?.times(&Polynomial::atom(atom.clone(), power.clone(), &frame))?;
    result.add(&second)?;
    Ok(true)
}
