//! Logarithms of products split into logarithms of factors, each with constant term 1.

use super::polynomial::{Frame, Monomial, Polynomial};
use super::{factor, is_sum, power};
use crate::expr::{Expr, ExprError, Number, Sign, sign};

/// ln `u` as a sum of logarithms of single factors.
///
/// A factor is split off only if it is proven positive. At most one factor is unproven; it is positive because the product is.
pub(super) fn of(u: &Polynomial) -> Result<Polynomial, ExprError> {
    let frame = u.frame();
    let whole = || Polynomial::atom(Expr::call("ln", [u.to_expr()]), Expr::one(), frame);
    let (outside, inside) = without_denominators(u)?;
    let (content, number, primitive) = power::split_content(&inside, false);
    let (mut result, mut unproven) = (number_logarithm(&number, frame)?, Vec::new());
    for (atom, power) in outside.iter().chain(&content) {
        if power.as_integer().is_none() || sign(atom) == Sign::Positive {
            result.add(&of_positive(atom, frame)?.times(&Polynomial::expand(power, frame)?)?)?;
        } else {
            unproven.push((Polynomial::expand(atom, frame)?, power.as_integer().unwrap_or(1)));
        }
    }
    if let Some((monomial, number)) = primitive.only() {
        if !number.is_one() || !monomial.is_empty() {
            unproven.push((primitive, 1));
        }
    } else if let Some(inverse) = inverse_hyperbolic(&primitive)? {
        result.add(&inverse)?;
    } else {
        for (own, multiplicity) in factor::factors(&primitive, false)? {
            if sign(&own.to_expr()) == Sign::Positive {
                result.add(&normalised(&own)?.scaled(&Number::integer(multiplicity)))?;
            } else {
                unproven.push((own, multiplicity));
            }
        }
    }
    match unproven.as_slice() {
        [] => Ok(result),
        [(own, multiplicity)] if multiplicity % 2 != 0 => {
            result.add(&normalised(own)?.scaled(&Number::integer(*multiplicity)))?;
            Ok(result)
        }
        [(own, multiplicity)] => {
            result.add(&normalised(&own.whole_power(2)?)?.scaled(&Number::integer(multiplicity / 2)))?;
            Ok(result)
        }
        _ => Ok(whole()),
    }
}

/// ln of a positive atom.
fn of_positive(atom: &Expr, frame: &Frame) -> Result<Polynomial, ExprError> {
    if *atom == Expr::euler() {
        return Ok(Polynomial::constant(Number::integer(1), frame));
    }
    if is_sum(atom) {
        let expanded = Polynomial::expand(atom, frame)?;
        // The radicand is positive wherever the root is, even if its sign is not proven.
        return if sign(atom) == Sign::Positive { of(&expanded) } else { normalised(&expanded) };
    }
    match atom.as_number() {
        Some(number) => number_logarithm(number, frame),
        None => Ok(Polynomial::atom(Expr::call("ln", [atom.clone()]), Expr::one(), frame)),
    }
}

/// Splits `u` into its denominators and common roots, and the remaining factor.
fn without_denominators(u: &Polynomial) -> Result<(Monomial, Polynomial), ExprError> {
    let frame = u.frame();
    let mut outside = Monomial::new();
    for (monomial, _) in u.terms() {
        for (atom, _) in monomial.iter().filter(|(atom, power)| is_sum(atom) && power.as_number().is_some()) {
            if outside.contains_key(atom) {
                continue;
            }
            let powers: Vec<Number> =
                u.terms().map(|(m, _)| m.get(atom).and_then(Expr::as_number).cloned().unwrap_or_else(|| Number::integer(0))).collect();
            let Some(lowest) = powers.iter().min() else { continue };
            if !lowest.is_zero() && powers.iter().all(|p| (p - lowest).is_integer()) {
                outside.multiply(atom.clone(), Expr::number(lowest.clone()));
            }
        }
    }
    if outside.is_empty() {
        return Ok((outside, u.clone()));
    }
    let inverse: Monomial = outside.iter().map(|(atom, power)| (atom.clone(), -power)).collect();
    let inside = u.times(&Polynomial::single(inverse, Number::integer(1), frame))?;
    Ok((outside, inside))
}

/// ln q for a primitive sum q: ln q(0) + ln(q/q(0)), where q(0) is positive.
fn normalised(q: &Polynomial) -> Result<Polynomial, ExprError> {
    let frame = q.frame();
    let radius = Expr::from(frame.variable().clone());
    let plain = |q: &Polynomial| Ok(Polynomial::atom(Expr::call("ln", [q.to_expr()]), Expr::one(), frame));
    let (dependent, mut constant) = q.split(|monomial| super::calls::depends(monomial, frame));
    // The value at the axis is available only for polynomials in the variable.
    let polynomial = dependent.terms().all(|(m, _)| {
        m.iter().all(|(a, p)| if *a == radius { p.as_integer().is_some_and(|k| k > 0) } else { !a.contains(frame.variable()) })
    });
    if dependent.is_zero() || constant.is_zero() || !polynomial {
        return plain(q);
    }
    match sign(&constant.to_expr()) {
        Sign::Positive => {}
        Sign::Negative => constant = constant.scaled(&Number::integer(-1)),
        _ => return plain(q),
    }
    let scaled = super::gather::gathered(q.times(&power::raise(&constant, &Expr::integer(-1))?)?)?;
    let mut result = plain(&scaled)?;
    result.add(&if let Some((monomial, number)) = constant.only() {
        let mut total = number_logarithm(number, frame)?;
        for (atom, power) in monomial {
            total.add(&of_positive(atom, frame)?.times(&Polynomial::expand(power, frame)?)?)?;
        }
        total
    } else {
        of(&constant)?
    })?;
    Ok(result)
}

/// ln of a rational number, by its small prime factors.
fn number_logarithm(number: &Number, frame: &Frame) -> Result<Polynomial, ExprError> {
    let atom = |n: &Number| Polynomial::atom(Expr::call("ln", [Expr::number(n.as_fraction())]), Expr::one(), frame);
    if number.is_one() {
        return Ok(Polynomial::zero(frame));
    }
    if !number.is_positive() {
        return Ok(atom(number));
    }
    let mut result = Polynomial::zero(frame);
    for (prime, n) in primes(number) {
        result.add(&atom(&prime).scaled(&Number::integer(n)))?;
    }
    Ok(result)
}

/// The small prime factors of a positive rational number with their powers, and the cofactors of numerator and denominator.
pub(super) fn primes(number: &Number) -> Vec<(Number, i64)> {
    let whole = |n: &num_bigint::BigInt| Number::from(num_rational::BigRational::from_integer(n.clone()));
    let mut found = Vec::new();
    for (part, sign) in [(whole(number.value().numer()), 1), (whole(number.value().denom()), -1)] {
        let mut left = part;
        for prime in [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37] {
            let inverse = Number::ratio(1, prime);
            let mut count = 0;
            // A product beyond the work limit is 0.
            while !left.is_zero() && left.bits() < 512 && (&left * &inverse).is_integer() {
                left = &left * &inverse;
                count += 1;
            }
            if count > 0 {
                found.push((Number::integer(prime), sign * count));
            }
        }
        if !left.is_one() {
            found.push((left, sign));
        }
    }
    found
}

/// ln(A + B/√q) with m² = B²/q − A² free of the variable: u = A/m gives ln m + asinh u.
fn inverse_hyperbolic(sum: &Polynomial) -> Result<Option<Polynomial>, ExprError> {
    let frame = sum.frame();
    let minus_half = Expr::ratio(-1, 2);
    let mut roots = sum.terms().flat_map(|(m, _)| m.iter()).filter(|(a, p)| is_sum(a) && a.contains(frame.variable()) && **p == minus_half);
    let Some((root, _)) = roots.next() else { return Ok(None) };
    let (with_root, plain) = sum.split(|monomial| monomial.get(root) == Some(&minus_half));
    let inverse = Polynomial::atom(root.clone(), Expr::ratio(1, 2), frame);
    let (a, b, q) = (plain, with_root.times(&inverse)?, Polynomial::expand(root, frame)?);
    let other_roots = |p: &Polynomial| p.terms().any(|(m, _)| m.iter().any(|(a, p)| is_sum(a) && p.as_integer().is_none()));
    if other_roots(&a) || other_roots(&b) {
        return Ok(None);
    }
    let square = b.times(&b)?.minus(&a.times(&a)?.times(&q)?)?;
    let constant = |p: &Polynomial| p.split(|monomial| super::calls::depends(monomial, frame)).1;
    let Some((monomial, number)) = constant(&q).only().map(|(m, n)| (m.clone(), n.clone())) else { return Ok(None) };
    let inverse = power::raise(&Polynomial::single(monomial, number, frame), &Expr::integer(-1))?;
    let m_squared = constant(&square).times(&inverse)?;
    if !square.minus(&m_squared.times(&q)?)?.is_zero()
        || sign(&m_squared.to_expr()) != Sign::Positive
        || sign(&b.to_expr()) != Sign::Positive
    {
        return Ok(None);
    }
    let argument = a.times(&power::raise(&m_squared, &minus_half)?)?;
    let mut result = Polynomial::expand(&Expr::call("asinh", [argument.to_expr()]), frame)?;
    result.add(&of(&m_squared)?.scaled(&Number::ratio(1, 2)))?;
    Ok(Some(result))
}
