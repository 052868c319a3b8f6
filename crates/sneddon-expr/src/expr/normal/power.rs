//! Powers in the recognition form: contents taken out, roots rationalised, degrees reduced.

use super::polynomial::{Frame, Monomial, Polynomial};
use super::{calls, content, division, factor, is_sum, logarithm, sparse, waves};
use crate::expr::{Expr, ExprError, Node, Number, Sign, sign};
use std::collections::BTreeMap;

/// q^(k+1/2) is written as a polynomial over √q up to this k + 1.
const MOST_HALVES: i64 = 24;
/// Powers of one term up to this one are multiplied out.
const FEW: u32 = 3;

/// `base`^`exponent`.
pub(super) fn raise(base: &Polynomial, exponent: &Expr) -> Result<Polynomial, ExprError> {
    let frame = base.frame().clone();
    if base.is_zero() {
        return Ok(if sign(exponent) == Sign::Positive { base.clone() } else { Polynomial::atom(Expr::zero(), exponent.clone(), &frame) });
    }
    // The power of one term is one term; its number remains an unevaluated power if it would be too long.
    if let Some(n) = exponent.as_integer().and_then(|n| u32::try_from(n).ok()).filter(|n| base.len() > 1 || *n <= FEW) {
        return base.whole_power(n);
    }
    if frame.is_canonical() && exponent.contains(frame.variable()) {
        return calls::to_variable_power(base, exponent);
    }
    if let Some((monomial, number)) = base.only() {
        return raise_monomial(monomial, number, exponent, &frame);
    }
    let whole = exponent.as_integer().is_some();
    if frame.is_canonical()
        && let Some(result) = raise_fraction(base, exponent)?
    {
        return Ok(result);
    }
    let (content, number, primitive) = split_content(base, whole);
    let outside = raise_monomial(&content, &number, exponent, &frame)?;
    let inside = raise_primitive(&primitive, exponent)?;
    outside.times(&inside)
}

/// (N/D)^p = N^p·D^−p, where N and D are positive if p is not whole.
fn raise_fraction(base: &Polynomial, exponent: &Expr) -> Result<Option<Polynomial>, ExprError> {
    let frame = base.frame();
    let (numerator, denominators) = content::over_one_denominator(base)?;
    if !denominators.keys().any(|atom| atom.contains(frame.variable())) {
        return Ok(None);
    }
    let mut unproven: Vec<&Expr> = denominators.keys().filter(|atom| sign(atom) != Sign::Positive).collect();
    if exponent.as_integer().is_none() {
        if let [only] = unproven.as_slice()
            && sign(&numerator.to_expr()) == Sign::Positive
            && denominators.get(only).and_then(Expr::as_integer).is_some_and(|n| n % 2 != 0)
        {
            unproven.clear();
        }
        if !unproven.is_empty() {
            return Ok(None);
        }
    }
    let mut result = raise(&numerator, exponent)?;
    for (atom, power) in &denominators {
        let total = Polynomial::expand(&-(power * exponent), frame)?.to_expr();
        let mut settled = Polynomial::zero(frame);
        settle(Monomial::power(atom.clone(), total), &Number::integer(1), &mut settled)?;
        result = result.times(&settled)?;
    }
    Ok(Some(result))
}

/// Raises one product; factors of unproven sign keep a fractional power as a whole.
pub(super) fn raise_monomial(monomial: &Monomial, number: &Number, exponent: &Expr, frame: &Frame) -> Result<Polynomial, ExprError> {
    let whole = exponent.as_integer();
    let mut raised = Monomial::new();
    let mut kept = vec![];
    let mut coefficient = Number::integer(1);
    match (whole.and_then(|n| number.power(n)), number.is_positive()) {
        (Some(power), _) => coefficient = power,
        (None, true) if frame.is_canonical() && exponent.as_number().is_none() => {
            for (prime, n) in logarithm::primes(number) {
                raised.multiply(Expr::number(prime), Polynomial::expand(&(exponent * Expr::integer(n)), frame)?.to_expr());
            }
        }
        (None, true) => {
            let folded = Expr::number(number.clone()).pow(exponent);
            let (outside, rest) = folded.split_coefficient();
            coefficient = outside;
            for factor in rest.factors() {
                if !factor.is_one() {
                    let (base, power) = factor.split_power();
                    raised.multiply(base, power);
                }
            }
        }
        (None, false) => kept.push(Expr::number(number.clone())),
    }
    // A single factor of unproven sign is positive, because the product is.
    let unproven = monomial.keys().filter(|atom| sign(atom) != Sign::Positive).count();
    let alone = frame.is_canonical() && unproven == 1 && number.is_positive();
    let positive = |atom: &Expr, power: &Expr| sign(atom) == Sign::Positive || (alone && power.as_integer().is_none_or(|n| n % 2 != 0));
    for (atom, power) in monomial {
        if whole.is_some() || positive(atom, power) {
            let total = power * exponent;
            let total = Polynomial::expand(&total, frame)?.to_expr();
            raised.multiply(atom.clone(), total);
        } else {
            kept.push(atom.pow(power));
        }
    }
    if !kept.is_empty() {
        raised.multiply(Expr::product(kept), exponent.clone());
    }
    let mut result = Polynomial::zero(frame);
    settle(raised, &coefficient, &mut result)?;
    Ok(result)
}

/// Content · number · primitive: the common powers of positive atoms, the common rational factor, and the remaining sum.
///
/// The number is positive unless `whole`; then the primitive's first term is positive.
pub(super) fn split_content(base: &Polynomial, whole: bool) -> (Monomial, Number, Polynomial) {
    let frame = base.frame();
    let mut content: Option<BTreeMap<Expr, Expr>> = None;
    let mut gcd = Number::integer(0);
    for (monomial, number) in base.terms() {
        gcd = gcd.common_factor(number);
        content = Some(match content {
            None => {
                monomial.iter().filter(|(atom, _)| whole || sign(atom) == Sign::Positive).map(|(a, p)| (a.clone(), p.clone())).collect()
            }
            Some(own) => own
                .into_iter()
                .filter_map(|(atom, power)| {
                    let other = monomial.get(&atom).cloned().unwrap_or_else(Expr::zero);
                    let lower = smaller(&power, &other)?;
                    (!lower.is_zero()).then_some((atom, lower))
                })
                .collect(),
        });
    }
    let mut content = content.unwrap_or_default();
    // Negative powers that only some terms have are taken out as well: 1 − r²/c² = c⁻²(c² − r²).
    let mut negative: BTreeMap<Expr, Expr> = BTreeMap::new();
    for (monomial, _) in base.terms() {
        for (atom, power) in monomial {
            if power.as_number().is_some_and(Number::is_negative) && (whole || sign(atom) == Sign::Positive) && !is_sum(atom) {
                let lowest = negative.get(atom).and_then(|own: &Expr| smaller(own, power)).unwrap_or_else(|| power.clone());
                negative.insert(atom.clone(), lowest);
            }
        }
    }
    content.extend(negative);
    let content = Monomial::from_iter(content);
    if whole && is_reversed(base) {
        gcd = -&gcd;
    }
    let number = gcd;
    let mut primitive = Polynomial::zero(frame);
    let inverse = number.reciprocal().unwrap_or_else(|| Number::integer(1));
    for (monomial, own) in base.terms() {
        let mut rest = monomial.clone();
        for (atom, power) in &content {
            rest.multiply(atom.clone(), -power);
        }
        primitive.add_term(rest, &(own * &inverse));
    }
    (content, number, primitive)
}

/// True if the primitive sum should be negated: R² − r², which is positive at the axis, is canonical, and r² − R² is not.
fn is_reversed(base: &Polynomial) -> bool {
    let frame = base.frame();
    if frame.is_canonical() {
        let (_, constant) = base.split(|monomial| calls::depends(monomial, frame));
        match sign(&constant.to_expr()) {
            Sign::Positive => return false,
            Sign::Negative => return true,
            // (R − b)² + r² keeps its sign.
            _ if sparse::square_root(&constant).is_some() => return false,
            _ if sparse::square_root(&constant.scaled(&Number::integer(-1))).is_some() => return true,
            _ => {}
        }
    }
    base.terms().next().is_some_and(|(_, number)| number.is_negative())
}

/// The smaller of two exponents where the order is known.
fn smaller(a: &Expr, b: &Expr) -> Option<Expr> {
    if a == b {
        return Some(a.clone());
    }
    match sign(&(a - b)) {
        Sign::Negative => Some(a.clone()),
        Sign::Positive => Some(b.clone()),
        _ => None,
    }
}

/// Raises a primitive sum to a power that is not a natural number.
fn raise_primitive(primitive: &Polynomial, exponent: &Expr) -> Result<Polynomial, ExprError> {
    let frame = primitive.frame().clone();
    if let Some((monomial, number)) = primitive.only() {
        return raise_monomial(monomial, number, exponent, &frame);
    }
    if frame.is_canonical()
        && exponent.as_integer().is_none()
        && let Some(result) = raise_squares(primitive, exponent)?
    {
        return Ok(result);
    }
    if frame.is_canonical() && exponent.as_integer().is_some() && !calls::any_depends(primitive) {
        let minus = Number::integer(-1);
        let twice = exponent * Expr::integer(2);
        if let Some(root) = sparse::square_root(primitive) {
            return raise(&root, &twice);
        }
        if let Some(root) = sparse::square_root(&primitive.scaled(&minus)) {
            let odd = exponent.as_integer().is_some_and(|n| n % 2 != 0);
            return Ok(raise(&root, &twice)?.scaled(&if odd { minus } else { Number::integer(1) }));
        }
    }
    if exponent.as_integer().is_some_and(|n| n < 0)
        && let Some(rationalised) = rationalise(primitive)?
    {
        return raise(&rationalised, &(-exponent));
    }
    let mut result = Polynomial::zero(&frame);
    settle(Monomial::power(primitive.to_expr(), exponent.clone()), &Number::integer(1), &mut result)?;
    Ok(result)
}

/// (s²t)^p = s^(2p)·t^p for positive s.
fn raise_squares(primitive: &Polynomial, exponent: &Expr) -> Result<Option<Polynomial>, ExprError> {
    let frame = primitive.frame();
    let (mut result, mut rest) = (Polynomial::constant(Number::integer(1), frame), Polynomial::constant(Number::integer(1), frame));
    let mut found = false;
    for (own, multiplicity) in factor::factors(primitive, false)? {
        if multiplicity > 1 && sign(&own.to_expr()) == Sign::Positive {
            result = result.times(&raise(&own, &(exponent * Expr::integer(multiplicity)))?)?;
            found = true;
        } else {
            rest = rest.times(&own.whole_power(multiplicity as u32)?)?;
        }
    }
    if found { Ok(Some(result.times(&raise(&rest, exponent)?)?)) } else { Ok(None) }
}

/// 1/(A + B·Q^(−1/2)) = (A − B·Q^(−1/2))·Q/(A²Q − B²), where exactly one root of a sum occurs.
fn rationalise(primitive: &Polynomial) -> Result<Option<Polynomial>, ExprError> {
    let frame = primitive.frame();
    let minus_half = Expr::ratio(-1, 2);
    let mut root: Option<Expr> = None;
    for (monomial, _) in primitive.terms() {
        for (atom, power) in monomial {
            if is_sum(atom) && atom.contains(frame.variable()) && power.as_integer().is_none() {
                if *power != minus_half || root.as_ref().is_some_and(|own| own != atom) {
                    return Ok(None);
                }
                root = Some(atom.clone());
            }
        }
    }
    let Some(root) = root else { return Ok(None) };
    let (mut plain, mut with_root) = (Polynomial::zero(frame), Polynomial::zero(frame));
    for (monomial, number) in primitive.terms() {
        let mut rest = monomial.clone();
        if rest.remove(&root).is_some() {
            with_root.add_term(rest, number);
        } else {
            plain.add_term(rest, number);
        }
    }
    let radicand = Polynomial::expand(&root, frame)?;
    let inverse_root = Polynomial::atom(root, minus_half, frame);
    let conjugate = plain.minus(&with_root.times(&inverse_root)?)?.times(&radicand)?;
    let norm = plain.times(&plain)?.times(&radicand)?.minus(&with_root.times(&with_root)?)?;
    if norm.is_zero() {
        return Ok(None);
    }
    Ok(Some(conjugate.times(&raise(&norm, &Expr::integer(-1))?)?))
}

/// Adds number · monomial to `result` after bringing its powers to canonical form.
///
/// Numbers under roots are folded; natural powers of sums are expanded; q^(k+1/2) with k ≥ 0 becomes
/// q^(k+1)·q^(−1/2); r^m·q^p with p ≤ −1 is brought to partial fractions.
pub(super) fn settle(mut monomial: Monomial, number: &Number, result: &mut Polynomial) -> Result<(), ExprError> {
    if number.is_zero() {
        return Ok(());
    }
    result.frame().charge()?;
    let frame = result.frame().clone();
    if frame.is_canonical()
        && let Some(reduced) = waves::reduced(&monomial, &frame)?
    {
        return result.add(&reduced.scaled(number));
    }
    for (atom, power) in &monomial {
        if let Node::Number(base) = atom.node() {
            // 4^(p+1) = 4·4^p.
            let whole = power.terms().iter().find_map(Expr::as_integer).filter(|_| power.as_number().is_none());
            if let Some(outside) = whole.filter(|_| frame.is_canonical()).and_then(|n| base.power(n)) {
                let mut others = monomial.clone();
                others.multiply(atom.clone(), Expr::integer(-whole.unwrap_or(0)));
                return settle(others, &(number * &outside), result);
            }
            let folded = atom.pow(power);
            let (coefficient, rest) = folded.split_coefficient();
            if coefficient.is_one() && rest.split_power() == (atom.clone(), power.clone()) {
                continue;
            }
            let mut others = monomial.clone();
            others.remove(atom);
            for factor in rest.factors().into_iter().filter(|f| !f.is_one()) {
                let (base, exponent) = factor.split_power();
                others.multiply(base, exponent);
            }
            return settle(others, &(number * &coefficient), result);
        }
        if !is_sum(atom) {
            continue;
        }
        let Some(exponent) = power.as_number() else { continue };
        let depends = atom.contains(frame.variable());
        let natural = if exponent.is_integer() {
            exponent.to_i64().filter(|n| *n > 0)
        } else if depends && exponent.value().denom() == &num_bigint::BigInt::from(2) && exponent.is_positive() {
            // Keep larger powers unexpanded.
            (exponent + &Number::ratio(1, 2)).to_i64().filter(|n| *n <= MOST_HALVES)
        } else {
            None
        };
        if let Some(n) = natural.and_then(|n| u32::try_from(n).ok()) {
            let mut others = monomial.clone();
            others.multiply(atom.clone(), Expr::integer(-i64::from(n)));
            let expanded = Polynomial::expand(atom, &frame)?.whole_power(n)?;
            let rest = Polynomial::single(others, number.clone(), &frame);
            return result.add(&expanded.times(&rest)?);
        }
        if depends && !frame.is_canonical() && exponent <= &Number::integer(-1) && division::divide(&monomial, atom, power, number, result)?
        {
            return Ok(());
        }
    }
    if let Some((left, right)) = twins(&monomial, &frame) {
        let (first, second) = (monomial.remove(&left).unwrap_or_else(Expr::zero), monomial.remove(&right).unwrap_or_else(Expr::zero));
        // The difference of the exponents remains as an integer power of its base.
        monomial.multiply(right.clone(), &second - &first);
        let exponent = first;
        let product = Polynomial::expand(&left, &frame)?.times(&Polynomial::expand(&right, &frame)?)?;
        let rest = Polynomial::single(monomial, number.clone(), &frame);
        return result.add(&raise(&product, &exponent)?.times(&rest)?);
    }
    result.add_term(monomial, number);
    Ok(())
}

/// Two sums under the same root, which belong under one: √(R−r)·√(R+r) = √(R²−r²).
fn twins(monomial: &Monomial, frame: &Frame) -> Option<(Expr, Expr)> {
    let roots: Vec<(&Expr, &Expr)> =
        monomial.iter().filter(|(atom, power)| is_sum(atom) && power.as_integer().is_none() && atom.contains(frame.variable())).collect();
    roots.iter().enumerate().find_map(|(i, (left, power))| {
        let (right, _) = roots.iter().skip(i + 1).find(|(_, other)| (*other - *power).as_integer().is_some())?;
        Some(((*left).clone(), (*right).clone()))
    })
}
