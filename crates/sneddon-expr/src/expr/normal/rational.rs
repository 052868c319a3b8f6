//! Partial fractions in the variable, per product of the other factors.

use super::polynomial::{Frame, Monomial, Polynomial};
use super::univariate::Univariate;
use super::{factor, is_sum, power};
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
            cofactor.multiply(atom.clone(), power.clone());
        } else if *atom == radius {
            let (fixed, whole) = split_exponent(power, 0);
            shift = whole;
            cofactor.multiply(atom.clone(), fixed);
        } else if !atom.contains(frame.variable()) {
            free.multiply(atom.clone(), power.clone());
        } else if is_sum(atom) && Univariate::read(&Polynomial::expand(atom, frame)?).is_some() {
            let (fixed, whole) = if power.as_integer().is_some() { split_exponent(power, 0) } else { split_exponent(power, -1) };
            cofactor.multiply(atom.clone(), fixed);
            if whole != 0 {
                sums.push((atom.clone(), whole));
            }
        } else {
            cofactor.multiply(atom.clone(), power.clone());
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
        total.multiply(Expr::from(result.frame().variable().clone()), Expr::integer(part.shift));
        for (atom, n) in &part.sums {
            total.multiply(atom.clone(), Expr::integer(*n));
        }
        add_product(result, &part.free, &total);
    }
    Ok(())
}

/// Adds coefficient · product.
fn add_product(result: &mut Polynomial, coefficient: &Polynomial, product: &Monomial) {
    for (monomial, number) in coefficient.terms() {
        result.add_term(product.times(monomial), number);
    }
}

/// A denominator: an irreducible polynomial and its power.
struct Divisor {
    own: Univariate,
    power: u32,
}

/// Remainders over powers of irreducible polynomials, and a polynomial.
struct Fractions {
    over: BTreeMap<Expr, (Univariate, BTreeMap<u32, Univariate>)>,
    polynomial: Univariate,
}

/// The partial fractions of a group; `None` if a factor is beyond the method.
///
/// They are unique, so that each term is decomposed separately.
fn fractions(cofactor: &Monomial, parts: &[Part], frame: &Frame) -> Result<Option<Polynomial>, ExprError> {
    let mut cache = BTreeMap::new();
    let mut found = Fractions { over: BTreeMap::new(), polynomial: Univariate::zero(frame) };
    for part in parts {
        let Some((numerator, divisors)) = numerator_and_divisors(part, &mut cache, frame)? else { return Ok(None) };
        if !found.take_apart(numerator, divisors)? {
            return Ok(None);
        }
    }
    found.tidied()?;
    found.join_mirrored(frame)?;
    let mut result = Polynomial::zero(frame);
    for (own, remainders) in found.over.values() {
        for (power, remainder) in remainders {
            add_fraction(&mut result, cofactor, remainder, own, *power)?;
        }
    }
    for (k, coefficient) in found.polynomial.coefficients().iter().enumerate() {
        let mut total = cofactor.clone();
        total.multiply(Expr::from(frame.variable().clone()), Expr::integer(k as i64));
        add_product(&mut result, coefficient, &total);
    }
    Ok(Some(result))
}

type Factors = Vec<(Univariate, i64)>;

/// The numerator of a term and its irreducible denominators.
fn numerator_and_divisors(
    part: &Part,
    cache: &mut BTreeMap<Expr, Factors>,
    frame: &Frame,
) -> Result<Option<(Univariate, Vec<Divisor>)>, ExprError> {
    let mut powers: BTreeMap<Expr, (Univariate, i64)> = BTreeMap::new();
    let radius = Univariate::radius(frame);
    powers.insert(Expr::from(frame.variable().clone()), (radius, part.shift));
    for (atom, n) in &part.sums {
        if !cache.contains_key(atom) {
            let list = factor::factors(&Polynomial::expand(atom, frame)?, true)?;
            let list: Option<Factors> = list.into_iter().map(|(own, m)| Some((Univariate::read(&own)?, m))).collect();
            let Some(list) = list else { return Ok(None) };
            cache.insert(atom.clone(), list);
        }
        for (own, multiplicity) in cache.get(atom).into_iter().flatten() {
            let name = own.to_polynomial().to_expr();
            powers.entry(name).or_insert_with(|| (own.clone(), 0)).1 += n * multiplicity;
        }
    }
    let (mut numerator, mut divisors) = (Univariate::constant(part.free.clone()), Vec::new());
    for (own, n) in powers.into_values() {
        let Some(power) = u32::try_from(n.unsigned_abs()).ok().filter(|n| *n <= 400) else { return Ok(None) };
        if n > 0 {
            numerator = numerator.times(&own.power(power)?)?;
        } else if n < 0 {
            divisors.push(Divisor { own, power });
        }
    }
    Ok(Some((numerator, divisors)))
}

impl Fractions {
    /// Adds numerator/Π divisors; false if a factor is beyond the method.
    fn take_apart(&mut self, mut numerator: Univariate, mut divisors: Vec<Divisor>) -> Result<bool, ExprError> {
        let frame = numerator.frame().clone();
        for index in 0..divisors.len() {
            let mut others = Univariate::constant(Polynomial::constant(Number::integer(1), &frame));
            for (_, other) in divisors.iter().enumerate().filter(|(i, _)| *i != index) {
                // Factors that were dealt with are divided out of the numerator already.
                others = others.times(&other.own.power(other.power)?)?;
            }
            let Some(divisor) = divisors.get_mut(index) else { break };
            let Some(inverse) = inverse(&others.divided_by(&divisor.own)?.1, &divisor.own)? else { return Ok(false) };
            while divisor.power > 0 {
                let remainder = tidy_all(&numerator.times(&inverse)?.divided_by(&divisor.own)?.1)?;
                self.add(&divisor.own, divisor.power, &remainder)?;
                numerator = tidy_all(&numerator.minus(&remainder.times(&others)?)?.divided_by(&divisor.own)?.0)?;
                divisor.power -= 1;
            }
        }
        self.polynomial.add(&numerator)?;
        Ok(true)
    }

    fn add(&mut self, own: &Univariate, power: u32, remainder: &Univariate) -> Result<(), ExprError> {
        let name = own.to_polynomial().to_expr();
        let (_, remainders) = self.over.entry(name).or_insert_with(|| (own.clone(), BTreeMap::new()));
        remainders.entry(power).or_insert_with(|| Univariate::zero(own.frame())).add(remainder)
    }

    /// Every coefficient without common factors, and nothing that is zero.
    fn tidied(&mut self) -> Result<(), ExprError> {
        for (_, remainders) in self.over.values_mut() {
            for remainder in remainders.values_mut() {
                *remainder = tidy_all(remainder)?;
            }
            remainders.retain(|_, remainder| !remainder.is_zero());
        }
        self.over.retain(|_, (_, remainders)| !remainders.is_empty());
        self.polynomial = tidy_all(&self.polynomial)?;
        Ok(())
    }

    /// Fractions over R − r and over R + r become fractions over R² − r².
    fn join_mirrored(&mut self, frame: &Frame) -> Result<(), ExprError> {
        let linear: Vec<Expr> = self.over.iter().filter(|(_, (own, _))| own.degree() == 1).map(|(name, _)| name.clone()).collect();
        for name in linear {
            let Some((first, _)) = self.over.get(&name) else { continue };
            if first.coefficient(0).is_zero() {
                continue;
            }
            let mirrored = first.mirrored().to_polynomial();
            let (plus, minus) = (mirrored.to_expr(), mirrored.scaled(&Number::integer(-1)).to_expr());
            let Some(partner) = [plus, minus].into_iter().find(|other| self.over.contains_key(other)) else { continue };
            let (Some((first, upper)), Some((second, lower))) = (self.over.remove(&name), self.over.remove(&partner)) else { continue };
            let highest = upper.keys().chain(lower.keys()).copied().max().unwrap_or(0);
            let mut numerator = Univariate::zero(frame);
            for (own, other, remainders) in [(&first, &second, &upper), (&second, &first, &lower)] {
                for (power, remainder) in remainders {
                    numerator.add(&remainder.times(&own.power(highest - power)?)?.times(&other.power(highest)?)?)?;
                }
            }
            // The orientation of a denominator is that of every other one.
            let product = first.times(&second)?.to_polynomial();
            let (_, number, primitive) = power::split_content(&product, true);
            let Some(own) = Univariate::read(&primitive) else { continue };
            if number.is_negative() && highest % 2 == 1 {
                numerator = Univariate::zero(frame).minus(&numerator)?;
            }
            for power in (1..=highest).rev() {
                let (quotient, remainder) = numerator.divided_by(&own)?;
                self.add(&own, power, &tidy_all(&remainder)?)?;
                numerator = quotient;
            }
        }
        Ok(())
    }
}

/// The polynomial with every coefficient cancelled.
fn tidy_all(own: &Univariate) -> Result<Univariate, ExprError> {
    let coefficients = own.coefficients().iter().map(|c| tidy(c.clone())).collect::<Result<Vec<_>, _>>()?;
    Ok(Univariate::new(coefficients, own.frame()))
}

/// The inverse of u modulo q, for q of degree 1 or 2, or u = 1, or u = c·r^k.
fn inverse(u: &Univariate, q: &Univariate) -> Result<Option<Univariate>, ExprError> {
    let minus_one = Expr::integer(-1);
    if u.is_one() {
        return Ok(Some(u.clone()));
    }
    if u.degree() == 0 {
        let value = u.coefficient(0);
        let value = tidy(value)?;
        return Ok(if value.is_zero() { None } else { Some(Univariate::constant(power::raise(&value, &minus_one)?)) });
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
    let polynomial = q.to_polynomial();
    let (mut atom, mut sign) = (polynomial.to_expr(), 1);
    // A root keeps the sign that makes it real; its whole powers join it.
    let negated = polynomial.scaled(&Number::integer(-1)).to_expr();
    if cofactor.contains_key(&negated) {
        (atom, sign) = (negated, if k.is_multiple_of(2) { 1 } else { -1 });
    }
    for (m, coefficient) in remainder.coefficients().iter().enumerate() {
        let mut total = cofactor.clone();
        total.multiply(radius.clone(), Expr::integer(m as i64));
        total.multiply(atom.clone(), Expr::integer(-i64::from(k)));
        add_product(result, &coefficient.scaled(&Number::integer(sign)), &total);
    }
    Ok(())
}
