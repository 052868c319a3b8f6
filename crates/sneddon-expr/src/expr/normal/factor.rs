//! Factors of polynomials in the variable, as far as square roots find them.

use super::polynomial::{Frame, Polynomial};
use super::univariate::Univariate;
use super::{power, sparse};
use crate::expr::{ExprError, Number, Sign, sign};

/// The factors of a primitive polynomial with their multiplicities; their product is the polynomial.
///
/// Perfect squares are roots twice, quadratics in a power of r split where their discriminant is a square;
/// α − β r² splits only if `pure` is set.
pub(super) fn factors(polynomial: &Polynomial, pure: bool) -> Result<Vec<(Polynomial, i64)>, ExprError> {
    let whole = || vec![(polynomial.clone(), 1)];
    let Some(univariate) = Univariate::read(polynomial) else { return Ok(whole()) };
    let mut found = Vec::new();
    split(&univariate, pure, 1, &mut found)?;
    if found.len() == 1 && found.iter().all(|(_, n)| *n == 1) {
        return Ok(whole());
    }
    // Contents were dropped on the way; the primitive polynomial has none, so only the sign can differ.
    let mut product = Polynomial::constant(Number::integer(1), polynomial.frame());
    for (own, multiplicity) in &found {
        product = product.times(&own.whole_power(*multiplicity as u32)?)?;
    }
    if product.minus(polynomial)?.is_zero() {
        return Ok(found);
    }
    let mut negated = product;
    negated.add(polynomial)?;
    let odd = |(own, n): &&mut (Polynomial, i64)| n % 2 != 0 && sign(&own.to_expr()) != Sign::Positive;
    if negated.is_zero()
        && let Some((own, _)) = found.iter_mut().find(odd)
    {
        *own = own.scaled(&Number::integer(-1));
        return Ok(found);
    }
    Ok(whole())
}

fn split(own: &Univariate, pure: bool, multiplicity: i64, found: &mut Vec<(Polynomial, i64)>) -> Result<(), ExprError> {
    let polynomial = own.to_polynomial();
    for factor in two_factors(own, &polynomial, pure)? {
        match factor {
            Factored::Itself => match found.iter_mut().find(|(other, _)| other.to_expr() == polynomial.to_expr()) {
                Some((_, n)) => *n += multiplicity,
                None => found.push((polynomial.clone(), multiplicity)),
            },
            Factored::Factor(part, n) => split(&part, pure, multiplicity * n, found)?,
        }
    }
    Ok(())
}

enum Factored {
    Itself,
    Factor(Univariate, i64),
}

/// One step: the two factors, the root of a square, or nothing.
fn two_factors(own: &Univariate, polynomial: &Polynomial, pure: bool) -> Result<Vec<Factored>, ExprError> {
    let frame = polynomial.frame();
    frame.charge()?;
    let present = own.coefficients().iter().enumerate().filter(|(_, c)| !c.is_zero()).map(|(k, _)| k);
    let step = present.fold(0, num_integer::gcd);
    let degree = own.degree();
    if degree <= 1 || step == 0 || own.coefficient(0).is_zero() {
        return Ok(vec![Factored::Itself]);
    }
    let half = if degree == step && step % 2 == 0 {
        step / 2
    } else if degree == 2 * step {
        step
    } else {
        return Ok(match sparse::square_root(polynomial).and_then(|root| Univariate::read(&root)) {
            Some(root) if degree.is_multiple_of(2) => vec![Factored::Factor(root, 2)],
            _ => vec![Factored::Itself],
        });
    };
    let (c, b, a) = (own.coefficient(0), own.coefficient(half), own.coefficient(2 * half));
    if b.is_zero() && half == 1 && !pure {
        return Ok(vec![Factored::Itself]);
    }
    let discriminant = b.times(&b)?.minus(&a.times(&c)?.scaled(&Number::integer(4)))?;
    let twice = a.scaled(&Number::integer(2));
    let linear = |constant: Polynomial| -> Result<Univariate, ExprError> {
        let mut coefficients = vec![Polynomial::zero(frame); half + 1];
        if let Some(first) = coefficients.first_mut() {
            *first = constant;
        }
        if let Some(last) = coefficients.last_mut() {
            *last = twice.clone();
        }
        primitive(&Univariate::new(coefficients, frame), frame)
    };
    if discriminant.is_zero() {
        return Ok(vec![Factored::Factor(linear(b)?, 2)]);
    }
    let Some(root) = sparse::square_root(&discriminant) else { return Ok(vec![Factored::Itself]) };
    let mut sum = b.clone();
    sum.add(&root)?;
    Ok(vec![Factored::Factor(linear(b.minus(&root)?)?, 1), Factored::Factor(linear(sum)?, 1)])
}

/// The polynomial without its content, oriented as denominators are.
fn primitive(own: &Univariate, frame: &Frame) -> Result<Univariate, ExprError> {
    let (_, _, rest) = power::split_content(&own.to_polynomial(), true);
    Ok(Univariate::read(&rest).unwrap_or_else(|| Univariate::zero(frame)))
}
