//! Identities of single functions: phases, exponentials of logarithms, inverse functions in one of their spellings.

use super::polynomial::{Frame, Monomial, Polynomial};
use super::{content, is_sum, logarithm, power};
use crate::expr::{Expr, ExprError, Node, Number, Sign, sign};

/// The canonical spelling of a function of canonical arguments; `None` if the call itself is it.
///
/// Every identity holds wherever the call is real, for positive symbols.
pub(super) fn rewritten(name: &str, arguments: &[Polynomial]) -> Result<Option<Polynomial>, ExprError> {
    let [u] = arguments else { return Ok(None) };
    if let Some(result) = of_inverse(name, u)? {
        return Ok(Some(result));
    }
    match name {
        "exp" => exponential(u).map(Some),
        "ln" => logarithm::of(u).map(Some),
        "sin" | "cos" | "sinh" | "cosh" => phase(name, u),
        "tan" => quarter_phase(u),
        "acos" => complement(call("asin", &[u.to_expr()], u.frame())?).map(Some),
        "atan" | "asin" | "atanh" | "asinh" | "acosh" => inverse(name, u),
        _ => Ok(None),
    }
}

/// base^exponent with the variable in the exponent, as an exponential.
pub(super) fn to_variable_power(base: &Polynomial, exponent: &Expr) -> Result<Polynomial, ExprError> {
    exponential(&logarithm::of(base)?.times(&Polynomial::expand(exponent, base.frame())?)?)
}

/// e^u in one factor, with e^(p ln q) = q^p taken out.
fn exponential(u: &Polynomial) -> Result<Polynomial, ExprError> {
    let frame = u.frame();
    let (mut result, mut rest) = (Polynomial::constant(Number::integer(1), frame), Polynomial::zero(frame));
    for (monomial, number) in u.terms() {
        match logarithm_in(monomial, frame) {
            Some((argument, factor)) => {
                let exponent = Polynomial::single(factor, number.clone(), frame).to_expr();
                result = result.times(&power::raise(&Polynomial::expand(&argument, frame)?, &exponent)?)?;
            }
            None => match multiple_of_inverse(&Polynomial::single(monomial.clone(), number.clone(), frame), true) {
                // e^(nθ) = (cosh θ ± sinh θ)^|n|
                Some((inverse, v, n)) => {
                    let (sine, cosine) = sine_and_cosine(inverse, v, n.signum());
                    result = result.times(&Polynomial::expand(&(cosine + sine).power(n.abs()), frame)?)?;
                }
                None => rest.add_term(monomial.clone(), number),
            },
        }
    }
    if rest.is_zero() {
        return Ok(result);
    }
    result.times(&Polynomial::atom(Expr::euler(), rest.to_expr(), frame))
}

/// The argument of the only logarithm of a product whose other factors are free of the variable, and these.
fn logarithm_in(monomial: &Monomial, frame: &Frame) -> Option<(Expr, Monomial)> {
    let mut found = None;
    let mut rest = Monomial::new();
    for (atom, power) in monomial {
        match atom.node() {
            Node::Function(function, arguments) if function.name() == "ln" && power.is_one() && found.is_none() => {
                found = arguments.first().cloned();
            }
            _ if atom.contains(frame.variable()) || power.contains(frame.variable()) => return None,
            _ => {
                rest.multiply(atom.clone(), power.clone());
            }
        }
    }
    found.map(|argument| (argument, rest))
}

/// The largest phase of a hyperbolic function that is split off: e^−2φ of the two products remains.
const LARGEST_PHASE: f64 = 15.0;

/// sin(u + φ) = sin u cos φ + cos u sin φ and the other addition theorems, with φ free of the variable.
fn phase(name: &str, u: &Polynomial) -> Result<Option<Polynomial>, ExprError> {
    let frame = u.frame();
    let (dependent, constant) = u.split(|monomial| depends(monomial, frame));
    if dependent.is_zero() || constant.is_zero() {
        return Ok(None);
    }
    let (sine, cosine) = if name.ends_with('h') { ("sinh", "cosh") } else { ("sin", "cos") };
    let (of_u, of_phase) = (dependent.to_expr(), constant.to_expr());
    // cosh φ cosh u − sinh φ sinh u would have no digits next to u = φ.
    if name.ends_with('h') && of_phase.as_number().is_some_and(|phase| phase.to_f64().abs() > LARGEST_PHASE) {
        return Ok(None);
    }
    let first = |name: &'static str| Expr::call(name, [of_u.clone()]);
    let second = |name: &'static str| exact(name, &of_phase).unwrap_or_else(|| Expr::call(name, [of_phase.clone()]));
    let total = match name {
        "sin" | "sinh" => first(sine) * second(cosine) + first(cosine) * second(sine),
        "cos" => first(cosine) * second(cosine) - first(sine) * second(sine),
        _ => first(cosine) * second(cosine) + first(sine) * second(sine),
    };
    Polynomial::expand(&total, frame).map(Some)
}

/// tan(u + nπ) = tan u and tan(u + π/2 + nπ) = −1/tan u.
fn quarter_phase(u: &Polynomial) -> Result<Option<Polynomial>, ExprError> {
    let frame = u.frame();
    let (dependent, constant) = u.split(|monomial| depends(monomial, frame));
    let (quarters, rest) = (constant.to_expr() * Expr::integer(2)).split_coefficient();
    let Some(quarters) = quarters.to_i64().filter(|_| rest == Expr::pi() && !dependent.is_zero()) else { return Ok(None) };
    let tangent = Expr::call("tan", [dependent.to_expr()]);
    let result = if quarters % 2 == 0 { tangent } else { -tangent.recip() };
    Polynomial::expand(&result, frame).map(Some)
}

/// The largest multiple of an inverse function whose sine and cosine are written out.
const HIGHEST_MULTIPLE: i64 = 8;

/// Functions of a multiple of an inverse function, without it; a phase beside the multiple is split off by the addition theorems first.
///
/// The identities hold wherever the inverse function is real.
fn of_inverse(name: &str, u: &Polynomial) -> Result<Option<Polynomial>, ExprError> {
    if !matches!(name, "sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh") {
        return Ok(None);
    }
    let Some((inverse, v, n)) = multiple_of_inverse(u, name.ends_with('h')) else { return Ok(None) };
    let (sine, cosine) = sine_and_cosine(inverse, v, n);
    let result = match name {
        "sin" | "sinh" => sine,
        "cos" | "cosh" => cosine,
        _ => sine / cosine,
    };
    Polynomial::expand(&result, u.frame()).map(Some)
}

/// sin nθ and cos nθ, or sinh nθ and cosh nθ, for an inverse function θ of v: polynomials in sin θ and cos θ, which are algebraic in v.
fn sine_and_cosine(inverse: &str, v: Expr, n: i64) -> (Expr, Expr) {
    let (one, square) = (Expr::one(), v.power(2));
    let (cosine, sine) = match inverse {
        "asin" => ((one - square).sqrt(), v),
        "asinh" => ((one + square).sqrt(), v),
        "acosh" => (v, (square - one).sqrt()),
        _ => {
            let root = if inverse == "atan" { one + square } else { one - square }.sqrt();
            (root.recip(), v / root)
        }
    };
    // (cos θ + sin θ)ⁿ: terms with odd powers of the sine, and the others. i² = −1 belongs to the square of a circular sine.
    let (mut odd, mut even, mut choices) = (Vec::new(), Vec::new(), Number::integer(1));
    for k in 0..=n.abs() {
        let sign = if !inverse.ends_with('h') && k % 4 >= 2 { -1 } else { 1 };
        let number = Expr::number(&choices * &Number::integer(sign));
        let part = if k % 2 == 1 { &mut odd } else { &mut even };
        part.push(number * cosine.power(n.abs() - k) * sine.power(k));
        choices = &choices * &Number::ratio(n.abs() - k, k + 1);
    }
    (Expr::integer(n.signum()) * Expr::sum(odd), Expr::sum(even))
}

/// n·θ for a whole n and an inverse function θ of the given kind, as its name, its argument and n.
fn multiple_of_inverse(u: &Polynomial, is_hyperbolic: bool) -> Option<(&'static str, Expr, i64)> {
    let (monomial, number) = u.only()?;
    let n = number.to_i64().filter(|n| n.abs() <= HIGHEST_MULTIPLE)?;
    let (atom, power) = monomial.iter().next().filter(|_| monomial.len() == 1)?;
    let Node::Function(function, arguments) = atom.node() else { return None };
    let kinds: &[&'static str] = if is_hyperbolic { &["asinh", "acosh", "atanh"] } else { &["asin", "atan"] };
    let inverse = kinds.iter().find(|own| **own == function.name())?;
    power.is_one().then(|| Some((*inverse, arguments.first()?.clone(), n))).flatten()
}

/// sin and cos at multiples of π/6 and π/4.
fn exact(name: &str, angle: &Expr) -> Option<Expr> {
    let (number, rest) = angle.split_coefficient();
    if rest != Expr::pi() || !matches!(name, "sin" | "cos") {
        return None;
    }
    let twelfths = (&number * &Number::integer(12)).to_i64()?;
    let twelfths = if name == "cos" { twelfths.checked_add(6)? } else { twelfths }.rem_euclid(24);
    let (sign, twelfths) = if twelfths >= 12 { (-1, twelfths - 12) } else { (1, twelfths) };
    let value = match twelfths.min(12 - twelfths) {
        0 => Expr::zero(),
        2 => Expr::ratio(1, 2),
        3 => Expr::ratio(1, 2).sqrt(),
        4 => Expr::integer(3).sqrt() / Expr::integer(2),
        6 => Expr::one(),
        _ => return None,
    };
    Some(Expr::integer(sign) * value)
}

/// True if a factor depends on the variable.
pub(super) fn depends(monomial: &Monomial, frame: &Frame) -> bool {
    monomial.iter().any(|(atom, power)| atom.contains(frame.variable()) || power.contains(frame.variable()))
}

/// True if a term depends on the variable.
pub(super) fn any_depends(sum: &Polynomial) -> bool {
    sum.terms().any(|(monomial, _)| depends(monomial, sum.frame()))
}

/// The call expanded, with its identities applied.
fn call(name: &'static str, arguments: &[Expr], frame: &Frame) -> Result<Polynomial, ExprError> {
    Polynomial::expand(&Expr::call(name, arguments.to_vec()), frame)
}

/// π/2 − u.
fn complement(u: Polynomial) -> Result<Polynomial, ExprError> {
    Polynomial::atom(Expr::pi(), Expr::one(), u.frame()).scaled(&Number::ratio(1, 2)).minus(&u)
}

/// atan(w/r) = π/2 − atan(r/w), and arguments with a root that another inverse function has without.
fn inverse(name: &str, u: &Polynomial) -> Result<Option<Polynomial>, ExprError> {
    let frame = u.frame();
    let radius = Expr::from(frame.variable().clone());
    if name == "atan"
        && let Some((monomial, number)) = u.only()
        && monomial.get(&radius).and_then(Expr::as_number).is_some_and(Number::is_negative)
        && monomial.iter().all(|(atom, _)| *atom == radius || !atom.contains(frame.variable()))
        && sign(&u.to_expr()) != Sign::Unknown
    {
        let inverted = call("atan", &[power::raise(u, &Expr::integer(-1))?.to_expr()], frame)?;
        let quarter = Polynomial::atom(Expr::pi(), Expr::one(), frame).scaled(&Number::ratio(if number.is_negative() { -1 } else { 1 }, 2));
        return quarter.minus(&inverted).map(Some);
    }
    if !u.terms().any(|(monomial, _)| monomial.iter().any(|(atom, power)| is_root(atom, power, frame))) {
        return Ok(None);
    }
    without_root(name, u)
}

/// True for a fractional power of a sum that depends on the variable.
fn is_root(atom: &Expr, power: &Expr, frame: &Frame) -> bool {
    is_sum(atom) && atom.contains(frame.variable()) && power.as_integer().is_none()
}

/// With t = 1 ± u²: asin u = atan(u/√t) = π/2 − asin √t, atan u = asin(u/√t) = π/2 − asin(1/√t),
/// atanh u = asinh(u/√t), asinh u = atanh(u/√t), acosh u = asinh √(u² − 1), where the new argument is a plain monomial.
fn without_root(name: &str, u: &Polynomial) -> Result<Option<Polynomial>, ExprError> {
    let frame = u.frame();
    let square = super::gather::gathered(u.times(u)?)?;
    let one = Polynomial::constant(Number::integer(1), frame);
    let t = match name {
        "asin" | "atanh" => one.minus(&square)?,
        "acosh" => square.minus(&one)?,
        _ => {
            let mut t = one;
            t.add(&square)?;
            t
        }
    };
    let (numerator, _) = content::over_one_denominator(&t)?;
    if !numerator.only().is_some_and(|(_, number)| number.is_positive()) {
        return Ok(None);
    }
    let half = Expr::ratio(1, 2);
    let root = power::raise(&t, &half)?;
    if name == "acosh" {
        return if is_plain(&root) { call("asinh", &[root.to_expr()], frame).map(Some) } else { Ok(None) };
    }
    let inverse_root = power::raise(&t, &-half)?;
    let other = super::gather::gathered(u.times(&inverse_root)?)?;
    if is_plain(&other) {
        let name = match name {
            "atan" => "asin",
            "asin" => "atan",
            "atanh" => "asinh",
            _ => "atanh",
        };
        return call(name, &[other.to_expr()], frame).map(Some);
    }
    let complementary = match name {
        "asin" if is_plain(&root) => root,
        "atan" if is_plain(&inverse_root) => inverse_root,
        _ => return Ok(None),
    };
    if !is_positive_root(u)? {
        return Ok(None);
    }
    complement(call("asin", &[complementary.to_expr()], frame)?).map(Some)
}

/// True for one product without sums of the variable.
fn is_plain(u: &Polynomial) -> bool {
    u.only().is_some_and(|(monomial, _)| !monomial.keys().any(|atom| is_sum(atom) && atom.contains(u.frame().variable())))
}

/// True for a positive multiple of √q.
fn is_positive_root(u: &Polynomial) -> Result<bool, ExprError> {
    let frame = u.frame();
    let mut roots = u.terms().flat_map(|(monomial, _)| monomial.iter()).filter(|(atom, power)| is_root(atom, power, frame));
    let Some((root, _)) = roots.next() else { return Ok(false) };
    let outside = u.times(&Polynomial::atom(root.clone(), Expr::ratio(-1, 2), frame))?;
    Ok(sign(&super::gather::gathered(outside)?.to_expr()) == Sign::Positive)
}
