//! Products of sines, cosines, hyperbolic functions and Bessel functions, reduced to sums.

use super::polynomial::{Frame, Monomial, Polynomial};
use crate::expr::{Expr, ExprError, Node, Number};

/// The highest power of one function that is expanded; higher powers are atoms.
const HIGHEST: i64 = 64;

/// A function of the variable with its whole power inside a product.
struct Wave<'a> {
    name: &'static str,
    arguments: &'a [Expr],
    atom: &'a Expr,
    power: i64,
}

/// Applies one step of the reduction to a product; `None` if no step applies.
///
/// Products and positive powers of sin and cos become sums of sin and cos; those of sinh and cosh become exponentials,
/// also if multiplied by an exponential;
/// quotients become tan and tanh with powers of 1/cos and 1/cosh; r·J_n and r·I_n with n ≥ 2 are lowered to orders 0 and 1.
pub(super) fn reduced(monomial: &Monomial, frame: &Frame) -> Result<Option<Polynomial>, ExprError> {
    let waves: Vec<Wave<'_>> = monomial.iter().filter_map(|(atom, power)| read(atom, power, frame)).collect();
    if waves.is_empty() {
        return Ok(None);
    }
    if let Some(result) = quotient(monomial, &waves, frame)? {
        return Ok(Some(result));
    }
    let mut hyperbolic = waves.iter().filter(|w| matches!(w.name, "sinh" | "cosh") && (1..=HIGHEST).contains(&w.power));
    if let Some(wave) = hyperbolic.next() {
        let among_exponentials = monomial.get(&Expr::euler()).is_some_and(|u| u.contains(frame.variable()));
        if wave.power > 1 || among_exponentials || hyperbolic.next().is_some() {
            let exponentials = exponentials(wave, frame)?.whole_power(wave.power as u32)?;
            return Ok(Some(exponentials.times(&without(monomial, &[wave], frame))?));
        }
    }
    let mut circular = waves.iter().filter(|w| matches!(w.name, "sin" | "cos") && (1..=HIGHEST).contains(&w.power));
    if let Some(wave) = circular.clone().find(|w| w.power > 1) {
        let square = product_to_sum(wave, wave, frame)?;
        let mut result = square.whole_power((wave.power / 2) as u32)?;
        if wave.power % 2 == 1 {
            result = result.times(&Polynomial::atom(wave.atom.clone(), Expr::one(), frame))?;
        }
        return Ok(Some(result.times(&without(monomial, &[wave], frame))?));
    }
    if let (Some(first), Some(second)) = (circular.next(), circular.next()) {
        return Ok(Some(product_to_sum(first, second, frame)?.times(&without(monomial, &[first, second], frame))?));
    }
    waves.iter().find_map(|wave| bessel(monomial, wave, frame).transpose()).transpose()
}

fn read<'a>(atom: &'a Expr, power: &Expr, frame: &Frame) -> Option<Wave<'a>> {
    let Node::Function(function, arguments) = atom.node() else { return None };
    let name = function.name();
    if !matches!(name, "sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh" | "besselj" | "besseli") {
        return None;
    }
    let power = power.as_integer()?;
    arguments.last().filter(|u| u.contains(frame.variable())).map(|_| Wave { name, arguments, atom, power })
}

/// The product without the given factors.
fn without(monomial: &Monomial, waves: &[&Wave<'_>], frame: &Frame) -> Polynomial {
    let mut rest = monomial.clone();
    for wave in waves {
        rest.remove(wave.atom);
    }
    Polynomial::single(rest, Number::integer(1), frame)
}

fn argument(wave: &Wave<'_>) -> Expr {
    wave.arguments.last().cloned().unwrap_or_else(Expr::zero)
}

/// sinh u and cosh u as (e^u ∓ e^−u)/2.
fn exponentials(wave: &Wave<'_>, frame: &Frame) -> Result<Polynomial, ExprError> {
    let u = argument(wave);
    let mut result = Polynomial::atom(Expr::euler(), u.clone(), frame);
    let mirrored = Polynomial::atom(Expr::euler(), -u, frame);
    result.add(&mirrored.scaled(&Number::integer(if wave.name == "sinh" { -1 } else { 1 })))?;
    Ok(result.scaled(&Number::ratio(1, 2)))
}

/// sin u sin v = (cos(u−v) − cos(u+v))/2 and the other product-to-sum identities.
fn product_to_sum(first: &Wave<'_>, second: &Wave<'_>, frame: &Frame) -> Result<Polynomial, ExprError> {
    let (u, v) = (argument(first), argument(second));
    let (name, minus, plus) = match (first.name, second.name) {
        ("sin", "sin") => ("cos", 1, -1),
        ("cos", "cos") => ("cos", 1, 1),
        ("sin", _) => ("sin", 1, 1),
        _ => ("sin", -1, 1),
    };
    let half = |sign: i64, angle: Expr| Expr::ratio(sign, 2) * Expr::call(name, [angle]);
    Polynomial::expand(&(half(minus, &u - &v) + half(plus, u + v)), frame)
}

/// Quotients of sine and cosine, circular or hyperbolic, by tan = sin/cos and cos² ± sin² = 1.
fn quotient(monomial: &Monomial, waves: &[Wave<'_>], frame: &Frame) -> Result<Option<Polynomial>, ExprError> {
    for wave in waves {
        let (sine, cosine, tangent, sign) = match wave.name {
            "sin" | "cos" | "tan" => ("sin", "cos", "tan", 1),
            "sinh" | "cosh" | "tanh" => ("sinh", "cosh", "tanh", -1),
            _ => continue,
        };
        let partner = |name: &str| waves.iter().find(|w| w.name == name && w.arguments == wave.arguments);
        let call = |name: &'static str| Expr::call(name, wave.arguments.to_vec());
        let (cosines, tangents) = (partner(cosine), partner(tangent));
        // The product with its powers of sine, cosine and tangent raised by the given amounts.
        let raised = |by: [i64; 3]| {
            let mut rest = monomial.clone();
            for (name, n) in [sine, cosine, tangent].into_iter().zip(by) {
                let atom = call(name);
                rest.multiply(atom, Expr::integer(n));
            }
            Polynomial::single(Monomial::new(), Number::integer(1), frame).times(&Polynomial::single(rest, Number::integer(1), frame))
        };
        let power = |wave: Option<&Wave<'_>>| wave.map_or(0, |w| w.power);
        if wave.name == sine && (1..=HIGHEST).contains(&wave.power) && power(cosines) < 0 {
            if wave.power == 1 {
                return raised([-1, 1, 1]).map(Some);
            }
            // sin² = ±(1 − cos²)
            let (one, square) = (raised([-2, 0, 0])?, raised([-2, 2, 0])?);
            let difference = one.minus(&square)?;
            return Ok(Some(difference.scaled(&Number::integer(sign))));
        }
        if wave.name == cosine && (2..=HIGHEST).contains(&wave.power) && power(partner(sine)) < 0 {
            // cos² = 1 ∓ sin²
            let (mut one, square) = (raised([0, -2, 0])?, raised([2, -2, 0])?);
            one.add(&square.scaled(&Number::integer(-sign)))?;
            return Ok(Some(one));
        }
        if wave.name != tangent || !(1..=HIGHEST).contains(&power(tangents)) {
            continue;
        }
        if power(cosines) > 0 {
            return raised([1, -1, -1]).map(Some);
        }
        if power(partner(sine)) > 0 {
            // tan·sin = ±(1/cos − cos)
            let (one, square) = (raised([-1, -1, -1])?, raised([-1, 1, -1])?);
            return Ok(Some(one.minus(&square)?.scaled(&Number::integer(sign))));
        }
        if wave.power >= 2 {
            // tan² = ±(1/cos² − 1)
            let (square, one) = (raised([0, -2, -2])?, raised([0, 0, -2])?);
            return Ok(Some(square.minus(&one)?.scaled(&Number::integer(sign))));
        }
    }
    Ok(None)
}

/// k r J_n = 2(n−1) J_(n−1) − k r J_(n−2) for n ≥ 2, and J_n/r = k (J_(n−1) + J_(n+1))/(2n); for I_n with the other sign.
fn bessel(monomial: &Monomial, wave: &Wave<'_>, frame: &Frame) -> Result<Option<Polynomial>, ExprError> {
    let sign = match wave.name {
        "besselj" => 1,
        "besseli" => -1,
        _ => return Ok(None),
    };
    let radius = Expr::from(frame.variable().clone());
    let [order, u] = wave.arguments else { return Ok(None) };
    let (Some(n), Some(m)) = (order.as_integer(), monomial.get(&radius).and_then(Expr::as_integer)) else { return Ok(None) };
    let k = u / &radius;
    if k.contains(frame.variable()) || wave.power != 1 {
        return Ok(None);
    }
    // Multiply by the power of r and the new order before the next step.
    let part = |factor: Expr, shift: i64, n: i64| {
        let mut rest = monomial.clone();
        rest.remove(wave.atom);
        rest.multiply(Expr::call(wave.name, [Expr::integer(n), u.clone()]), Expr::one());
        rest.multiply(radius.clone(), Expr::integer(shift));
        Polynomial::expand(&factor, frame)?.times(&Polynomial::single(rest, Number::integer(1), frame))
    };
    let mut result;
    if (2..=HIGHEST).contains(&n) && m >= 1 {
        result = part(Expr::integer(2 * sign * (n - 1)) / k, -1, n - 1)?;
        result.add(&part(Expr::integer(-sign), 0, n - 2)?)?;
    } else if n >= 1 && (-HIGHEST..=-1).contains(&m) {
        let factor = k / Expr::integer(2 * n);
        result = part(factor.clone(), 1, n - 1)?;
        result.add(&part(Expr::integer(sign) * factor, 1, n + 1)?)?;
    } else {
        return Ok(None);
    }
    Ok(Some(result))
}
