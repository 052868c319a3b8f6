//! Partial fractions in the variable, per product of the other factors.

use super::polynomial::{Frame, Monomial, Polynomial};
use super::univariate::Univariate;
use super::{calls, factor, is_sum, power};
use crate::expr::{Expr, ExprError, Number};
use std::collections::BTreeMap;

/// One term N·r^k·Π q^n over the factors that its group has in common.
struct Part {
    free: Polynomial,
    shift: i64,
    sums: Vec<(Expr, i64)>,
}

/// The sum with every rational function of the variable in partial fractions, one power of one factor per term.
///
/// Linear factors with rational roots are separated; R² − r² stays whole where both its factors occur.
/// Where the factors are beyond it, or the work is too much, a group stays as it is.
pub(super) fn reduced(sum: Polynomial) -> Result<Polynomial, ExprError> {
    let frame = sum.frame().clone();
    let (relevant, rest) = sum.split(|monomial| monomial.iter().any(|(atom, _)| is_sum(atom) && atom.contains(frame.variable())));
    if relevant.is_zero() {
        return Ok(sum);
    }
    let mut groups: BTreeMap<Monomial, Vec<Part>> = BTreeMap::new();
    // Polynomials are parts of the group without other factors, and may cancel against its fractions.
    for (monomial, number) in relevant.terms().chain(rest.terms()) {
        let (cofactor, part) = parted(monomial, number, &frame)?;
        groups.entry(cofactor).or_default().push(part);
    }
    let mut result = Polynomial::zero(&frame);
    for (cofactor, parts) in groups {
        let plain = parts.iter().all(|part| part.sums.is_empty());
        match if plain { None } else { fractions(&cofactor, &parts, &frame)? } {
            Some(done) => result.add(&done)?,
            None => unchanged(&cofactor, &parts, &mut result)?,
        }
    }
    Ok(result)
}

/// r^(k+f)·q^(k+f)… as a product with fixed powers and whole powers of r and of sums.
fn parted(monomial: &Monomial, number: &Number, frame: &Frame) -> Result<(Monomial, Part), ExprError> {
    let radius = Expr::from(frame.variable().clone());
    let (mut cofactor, mut free, mut shift, mut sums) = (Monomial::new(), Monomial::new(), 0, Vec::new());
    for (atom, power) in monomial {
        if power.contains(frame.variable()) {
            cofactor.insert(atom.clone(), power.clone());
        } else if *atom == radius {
            let (fixed, whole) = split_exponent(power, 0);
            shift = whole;
            if !fixed.is_zero() {
                cofactor.insert(atom.clone(), fixed);
            }
        } else if !atom.contains(frame.variable()) {
            free.insert(atom.clone(), power.clone());
        } else if is_sum(atom) && Univariate::read(&Polynomial::expand(atom, frame)?).is_some() {
            let (fixed, whole) = if power.as_integer().is_some() { split_exponent(power, 0) } else { split_exponent(power, -1) };
            if !fixed.is_zero() {
                cofactor.insert(atom.clone(), fixed);
            }
            if whole != 0 {
                sums.push((atom.clone(), whole));
            }
        } else {
            cofactor.insert(atom.clone(), power.clone());
        }
    }
    Ok((cofactor, Part { free: Polynomial::single(free, number.clone(), frame), shift, sums }))
}

/// An exponent as fixed + whole, where the number in `fixed` lies in [lowest, lowest + 1).
fn split_exponent(power: &Expr, lowest: i64) -> (Expr, i64) {
    let number = power.terms().iter().find_map(|term| term.as_number().cloned()).unwrap_or_else(|| Number::integer(0));
    let floor = Number::from(number.value().floor());
    match floor.to_i64().and_then(|n| n.checked_sub(lowest)).filter(|n| n.abs() <= 4000) {
        Some(whole) => (power - Expr::integer(whole), whole),
        None => (power.clone(), 0),
    }
}

/// The terms of a group as they were.
fn unchanged(cofactor: &Monomial, parts: &[Part], result: &mut Polynomial) -> Result<(), ExprError> {
    for part in parts {
        let mut total = cofactor.clone();
        raise_by(&mut total, &Expr::from(result.frame().variable().clone()), part.shift);
        for (atom, n) in &part.sums {
            raise_by(&mut total, atom, *n);
        }
        add_product(result, &part.free, &total);
    }
    Ok(())
}

fn raise_by(monomial: &mut Monomial, atom: &Expr, n: i64) {
    let total = monomial.remove(atom).map_or_else(|| Expr::integer(n), |own| own + Expr::integer(n));
    if !total.is_zero() {
        monomial.insert(atom.clone(), total);
    }
}

/// Adds coefficient · product, which have no atom in common.
fn add_product(result: &mut Polynomial, coefficient: &Polynomial, product: &Monomial) {
    for (monomial, number) in coefficient.terms() {
        let mut total = product.clone();
        total.extend(monomial.clone());
        result.add_term(total, number);
    }
}

/// A denominator: an irreducible polynomial and its power.
struct Divisor {
    own: Univariate,
    power: u32,
}

/// The partial fractions of a group; `None` where a factor is beyond the method.
fn fractions(cofactor: &Monomial, parts: &[Part], frame: &Frame) -> Result<Option<Polynomial>, ExprError> {
    let Some((mut numerator, lowest, mut divisors)) = over_common_denominator(parts, frame)? else { return Ok(None) };
    numerator = numerator.times(&Univariate::radius(frame).power(u32::try_from(lowest.clamp(0, 400)).unwrap_or(0))?)?;
    let mut shift = lowest.min(0);
    while shift < 0 && numerator.coefficients().first().is_some_and(Polynomial::is_zero) && !numerator.is_zero() {
        numerator = numerator.divided_by(&Univariate::radius(frame))?.0;
        shift += 1;
    }
    for divisor in &mut divisors {
        while divisor.power > 0 {
            let (quotient, remainder) = numerator.divided_by(&divisor.own)?;
            if !vanishes(&remainder)? {
                break;
            }
            numerator = quotient;
            divisor.power -= 1;
        }
    }
    divisors.retain(|divisor| divisor.power > 0);
    join_mirrored(&mut divisors, &mut numerator)?;
    if shift < 0 {
        divisors.push(Divisor { own: Univariate::radius(frame), power: shift.unsigned_abs().min(4000) as u32 });
    }
    let mut result = Polynomial::zero(frame);
    for index in 0..divisors.len() {
        let mut others = Univariate::constant(Polynomial::constant(Number::integer(1), frame));
        for (_, other) in divisors.iter().enumerate().filter(|(i, _)| *i != index) {
            // Factors that were dealt with are divided out of the numerator already.
            others = others.times(&other.own.power(other.power)?)?;
        }
        let Some(divisor) = divisors.get_mut(index) else { break };
        let Some(inverse) = inverse(&others.divided_by(&divisor.own)?.1, &divisor.own)? else { return Ok(None) };
        while divisor.power > 0 {
            let remainder = numerator.times(&inverse)?.divided_by(&divisor.own)?.1;
            add_fraction(&mut result, cofactor, &remainder, &divisor.own, divisor.power)?;
            numerator = numerator.minus(&remainder.times(&others)?)?.divided_by(&divisor.own)?.0;
            divisor.power -= 1;
        }
    }
    for (k, coefficient) in numerator.coefficients().iter().enumerate() {
        let mut total = cofactor.clone();
        raise_by(&mut total, &Expr::from(frame.variable().clone()), k as i64);
        add_product(&mut result, coefficient, &total);
    }
    Ok(Some(result))
}

/// True for a polynomial that is zero, whichever form its coefficients have.
fn vanishes(polynomial: &Univariate) -> Result<bool, ExprError> {
    for coefficient in polynomial.coefficients() {
        if !super::content::over_one_denominator(coefficient)?.0.is_zero() {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Numerator, lowest power of r, and the irreducible denominators with their powers.
fn over_common_denominator(parts: &[Part], frame: &Frame) -> Result<Option<(Univariate, i64, Vec<Divisor>)>, ExprError> {
    let mut factors: BTreeMap<Expr, Vec<(Expr, i64)>> = BTreeMap::new();
    let mut divisors: BTreeMap<Expr, (Univariate, i64)> = BTreeMap::new();
    let mut split: Vec<BTreeMap<Expr, i64>> = Vec::new();
    for part in parts {
        let mut powers: BTreeMap<Expr, i64> = BTreeMap::new();
        for (atom, n) in &part.sums {
            if !factors.contains_key(atom) {
                let mut list = Vec::new();
                for (own, multiplicity) in factor::factors(&Polynomial::expand(atom, frame)?, true)? {
                    let Some(univariate) = Univariate::read(&own) else { return Ok(None) };
                    let name = own.to_expr();
                    divisors.entry(name.clone()).or_insert((univariate, 0));
                    list.push((name, multiplicity));
                }
                factors.insert(atom.clone(), list);
            }
            for (name, multiplicity) in factors.get(atom).into_iter().flatten() {
                *powers.entry(name.clone()).or_insert(0) += n * multiplicity;
            }
        }
        for (name, n) in &powers {
            if let Some((_, deepest)) = divisors.get_mut(name) {
                *deepest = (*deepest).max(-n);
            }
        }
        split.push(powers);
    }
    let lowest = parts.iter().map(|part| part.shift).min().unwrap_or(0);
    let mut numerator = Univariate::zero(frame);
    for (part, powers) in parts.iter().zip(&split) {
        let Ok(raised) = u32::try_from(part.shift - lowest) else { return Ok(None) };
        if raised > 400 || lowest > 400 {
            return Ok(None);
        }
        let mut own = Univariate::constant(part.free.clone()).times(&Univariate::radius(frame).power(raised)?)?;
        for (name, (univariate, deepest)) in &divisors {
            let n = powers.get(name).copied().unwrap_or(0) + deepest;
            own = own.times(&univariate.power(u32::try_from(n).unwrap_or(0))?)?;
        }
        numerator.add(&own)?;
    }
    let list = divisors.into_values().filter(|(_, n)| *n > 0);
    Ok(Some((numerator, lowest, list.map(|(own, n)| Divisor { own, power: n.unsigned_abs().min(4000) as u32 }).collect())))
}

/// R − r and R + r become R² − r².
fn join_mirrored(divisors: &mut Vec<Divisor>, numerator: &mut Univariate) -> Result<(), ExprError> {
    let mut index = 0;
    while index < divisors.len() {
        let Some(first) = divisors.get(index).filter(|d| d.own.degree() == 1) else {
            index += 1;
            continue;
        };
        let mirrored = first.own.mirrored().to_polynomial()?;
        let mut partner = None;
        for (j, other) in divisors.iter().enumerate().skip(index + 1).filter(|(_, other)| other.own.degree() == 1) {
            let polynomial = other.own.to_polynomial()?;
            let mut sum = polynomial.clone();
            sum.add(&mirrored)?;
            if sum.is_zero() || polynomial.minus(&mirrored)?.is_zero() {
                partner = Some(j);
                break;
            }
        }
        if let Some(j) = partner {
            let second = divisors.remove(j);
            if let Some(first) = divisors.get_mut(index) {
                let power = first.power.max(second.power);
                *numerator = numerator.times(&first.own.power(power - first.power)?)?.times(&second.own.power(power - second.power)?)?;
                *first = Divisor { own: first.own.times(&second.own)?, power };
                // The orientation of a denominator is that of every other one.
                let (_, number, primitive) = power::split_content(&first.own.to_polynomial()?, true);
                if number.is_negative()
                    && let Some(own) = Univariate::read(&primitive)
                {
                    first.own = own;
                    if power % 2 == 1 {
                        *numerator = Univariate::zero(primitive.frame()).minus(numerator)?;
                    }
                }
            }
        }
        index += 1;
    }
    Ok(())
}

/// The inverse of u modulo q, for q of degree 1 or 2, or u = 1, or u = c·r^k.
fn inverse(u: &Univariate, q: &Univariate) -> Result<Option<Univariate>, ExprError> {
    let minus_one = Expr::integer(-1);
    if u.is_one() {
        return Ok(Some(u.clone()));
    }
    if u.degree() == 0 {
        let value = u.coefficient(0);
        return Ok(if vanishes(u)? { None } else { Some(Univariate::constant(tidy(power::raise(&tidy(value)?, &minus_one)?)?)) });
    }
    if q.degree() != 2 {
        return Ok(None);
    }
    // (v + w r)·(v − w γ/β − w r) = v² − v w γ/β + w² α/β modulo α + γ r + β r².
    let (v, w) = (u.coefficient(0), u.coefficient(1));
    let inverse_lead = power::raise(&q.coefficient(2), &minus_one)?;
    let (middle, constant) = (q.coefficient(1).times(&inverse_lead)?, q.coefficient(0).times(&inverse_lead)?);
    let conjugate = v.minus(&w.times(&middle)?)?;
    let mut norm = v.times(&conjugate)?;
    norm.add(&w.times(&w)?.times(&constant)?)?;
    let norm = tidy(norm)?;
    if norm.is_zero() {
        return Ok(None);
    }
    let scale = power::raise(&norm, &minus_one)?;
    let coefficients = vec![conjugate.times(&scale)?, w.times(&scale)?.scaled(&Number::integer(-1))];
    Ok(Some(Univariate::new(coefficients, q.frame())))
}

/// A coefficient with its denominators cancelled.
fn tidy(coefficient: Polynomial) -> Result<Polynomial, ExprError> {
    super::content::cancelled(coefficient)
}

/// Adds remainder/q^k · cofactor.
fn add_fraction(result: &mut Polynomial, cofactor: &Monomial, remainder: &Univariate, q: &Univariate, k: u32) -> Result<(), ExprError> {
    let frame = result.frame().clone();
    let radius = Expr::from(frame.variable().clone());
    let polynomial = q.to_polynomial()?;
    let (mut atom, mut sign) = (polynomial.to_expr(), 1);
    // A root keeps the sign that makes it real; its whole powers join it.
    let negated = polynomial.scaled(&Number::integer(-1)).to_expr();
    if cofactor.contains_key(&negated) {
        (atom, sign) = (negated, if k % 2 == 0 { 1 } else { -1 });
    }
    for (m, coefficient) in remainder.coefficients().iter().enumerate() {
        let mut total = cofactor.clone();
        raise_by(&mut total, &radius, m as i64);
        raise_by(&mut total, &atom, -i64::from(k));
        add_product(result, &tidy(coefficient.clone())?.scaled(&Number::integer(sign)), &total);
    }
    // Free factors that remain are no part of the polynomial ring's variable.
    debug_assert!(!remainder.coefficients().iter().any(|c| c.terms().any(|(m, _)| calls::depends(m, &frame))));
    Ok(())
}
