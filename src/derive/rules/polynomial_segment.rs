//! Polynomials on a segment: worn and truncated tips, caps, rounded edges, and every piece between two breakpoints.

use super::combination::tidy;
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::function::elliptic_moment_parts;
use crate::expr::normal;
use crate::expr::{Expr, Number, Sign, Symbol, derivative, sign};
use std::collections::BTreeMap;
use std::iter::successors;

pub(super) static RULE: Rule = Rule {
    id: "polynomial-segment",
    title: "Polynomial on a segment",
    pattern: "piecewise(0, r<b, A*(r-b)+C*(r^2-b^2))",
    equivalent: "piecewise(0, x<b, A*x*acos(b/x)+2*C*x*sqrt(x^2-b^2))",
    force: "piecewise(0, a<b, E*A*(a^2*acos(b/a)+b*sqrt(a^2-b^2))+4/3*E*C*(2*a^2+b^2)*sqrt(a^2-b^2))",
    pressure: None,
    parameters: &[
        Parameter { name: "A", lowest: 0.1, highest: 2.0 },
        Parameter { name: "C", lowest: 0.1, highest: 2.0 },
        Parameter { name: "b", lowest: 0.2, highest: 2.0 },
    ],
    guard: "f′ is a polynomial in r on [b, c), 0 ≤ b < c ≤ ∞; the pressure closes where f′ is odd",
    reference: &["Popov & Heß (3.28)–(3.35)", "integration by parts"],
    specializes: None,
    apply,
};

/// With more coefficients of f′ the pressure is left as an integral: its formula has some n² terms.
const MOST_COEFFICIENTS: usize = 40;

/// f′ = Σ c_m r^m on [b, c).
///
/// Shown by J_m = ∫ r^m/√(x²−r²) dr, m J_m = (m−1) x² J_(m−2) + b^(m−1) √(x²−b²), evaluated in powers of r − b,
/// whose integrals are all positive.
fn apply(term: &Term) -> Option<Answer> {
    if term.segment.is_whole() {
        return None;
    }
    let coefficients = term.polynomial()?;
    let lower = &term.segment.lower;
    let shifted = normal::shifted_coefficients(&coefficients, lower, &Symbol::new("r"))?;
    let (content, reduced) = normal::common_content(&coefficients);
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    let upper = term.segment.upper.as_ref();
    // Coefficients of one sign make all parts of the open moments positive: nothing cancels, and no integral is summed.
    let plain = coefficients.len() <= SHORT && [Sign::Positive, Sign::Negative].iter().any(|sign| have_sign(&coefficients, *sign));
    let open = |shift: usize, at: &Expr| &content * moments(&reduced, shift, lower, None, at, &stable_arc(lower, at));
    let equivalent = |end: Option<&Expr>| Pair {
        shown: &content * &x * moments(&reduced, 0, lower, end, &x, &shown_arc(lower, end, &x)),
        evaluated: match end {
            None if plain => &x * open(0, &x),
            _ => &x * evaluated("shifted_power", "shifted_power_between", &shifted, lower, end, &x),
        },
    };
    let force = |end: Option<&Expr>| Pair {
        shown: &content * moments(&reduced, 2, lower, end, &a, &shown_arc(lower, end, &a)),
        evaluated: match end {
            None if plain => open(2, &a),
            _ => evaluated("shifted_power_force", "shifted_power_force_between", &shifted, lower, end, &a),
        },
    };
    Some(Answer {
        equivalent: Branches { within: equivalent(None), beyond: equivalent(upper) },
        force: Branches { within: force(None), beyond: force(upper) },
        pressure: pressure(&coefficients, lower, upper),
        conditions: Vec::new(),
    })
}

/// Σ p_k K_k with the stable segment functions.
fn evaluated(open: &'static str, closed: &'static str, shifted: &[(i64, Expr)], b: &Expr, c: Option<&Expr>, x: &Expr) -> Expr {
    Expr::sum(shifted.iter().map(|(k, p)| {
        let form = match c {
            None => Expr::call(open, [Expr::integer(*k), b.clone(), x.clone()]),
            Some(c) => Expr::call(closed, [Expr::integer(*k), b.clone(), c.clone(), x.clone()]),
        };
        p * form
    }))
}

/// Up to this many coefficients the moments are short.
const SHORT: usize = 4;

fn have_sign(coefficients: &[Expr], wanted: Sign) -> bool {
    coefficients.iter().all(|c| c.is_zero() || sign(c) == wanted)
}

/// ∫_b^x dr/√(x²−r²) without loss next to b.
fn stable_arc(b: &Expr, x: &Expr) -> Expr {
    if b.is_zero() { Expr::pi() / Expr::integer(2) } else { Expr::call("angle_from", [b.clone(), x.clone()]) }
}

/// ∫_b^c dr/√(x²−r²), or up to x.
fn shown_arc(b: &Expr, c: Option<&Expr>, x: &Expr) -> Expr {
    match (b.is_zero(), c) {
        (true, None) => Expr::pi() / Expr::integer(2),
        (true, Some(c)) => Expr::call("asin", [c / x]),
        (false, None) => Expr::call("acos", [b / x]),
        (false, Some(c)) => Expr::call("acos", [b / x]) - Expr::call("acos", [c / x]),
    }
}

/// Σ c_m J_(m+shift)(b, c; x) as √(x²−b²)·A − √(x²−c²)·B + angle·D.
fn moments(coefficients: &[Expr], shift: usize, b: &Expr, c: Option<&Expr>, x: &Expr, arc: &Expr) -> Expr {
    let highest = coefficients.len() + shift;
    let angle_parts = angle_coefficients(highest, x);
    let angle = tidy(&Expr::sum(coefficients.iter().zip(angle_parts.iter().skip(shift)).map(|(c, part)| c * part)));
    let numbers = root_numbers(highest);
    let combine = |end: &Expr| tidy(&root_factor(coefficients, shift, &numbers, end, x));
    let root = |end: &Expr| (x.power(2) - end.power(2)).sqrt();
    let mut terms = vec![root(b) * combine(b)];
    if let Some(c) = c {
        terms.push(-(root(c) * combine(c)));
    }
    terms.push(angle * arc);
    Expr::sum(terms)
}

/// The numbers in the factor α_m of √(x²−e²) in J_m, for every m: α_m = ((m−1) x² α_(m−2) + e^(m−1))/m, so that
/// α_m = Σ_j n_j x^(2j) e^(m−1−2j).
fn root_numbers(highest: usize) -> Vec<Vec<Number>> {
    let mut numbers = vec![Vec::new(), vec![Number::integer(1)]];
    for m in 2..=highest {
        let factor = Number::ratio(m as i64 - 1, m as i64);
        let before = numbers.get(m - 2).into_iter().flatten().map(|own| own * &factor);
        numbers.push([Number::ratio(1, m as i64)].into_iter().chain(before).collect());
    }
    numbers
}

/// Σ c_m α_(m+shift). Coefficients c_m = C n_m b^(N−m) of a polynomial that is homogeneous in r and b have one term for each
/// power of x, and their numbers are added up before terms are built.
fn root_factor(coefficients: &[Expr], shift: usize, numbers: &[Vec<Number>], end: &Expr, x: &Expr) -> Expr {
    let next = |power: &Number| end.as_number().map(|own| power * own);
    let powers: Vec<Number> = successors(end.as_number().map(|_| Number::integer(1)), next).take(numbers.len()).collect();
    if powers.is_empty() && end.symbols().is_empty() {
        // Powers of one root of a number would not be one root again.
        let terms = (shift as i64..).zip(coefficients).zip(numbers.iter().skip(shift)).flat_map(|((m, c), list)| {
            let term = move |(j, number): (i64, &Number)| {
                Expr::product([Expr::number(number.clone()), c.clone(), x.power(2 * j), end.power(m - 1 - 2 * j)])
            };
            (0..).zip(list).map(term)
        });
        return Expr::sum(terms);
    }
    let mut sums: BTreeMap<Expr, Vec<Number>> = BTreeMap::new();
    for ((m, c), list) in (shift..).zip(coefficients).zip(numbers.iter().skip(shift)).filter(|((_, c), _)| !c.is_zero()) {
        // A symbolic end has its power at j = 0 here, and the division by e^(2j) follows with the sums.
        let (number, rest) = if powers.is_empty() { (c * end.power(m as i64 - 1)).split_coefficient() } else { c.split_coefficient() };
        let sum = sums.entry(rest).or_default();
        sum.resize(sum.len().max(list.len()), Number::integer(0));
        for (j, (own, part)) in sum.iter_mut().zip(list).enumerate() {
            let part = &number * part;
            *own = &*own + &powers.get(m - 1 - 2 * j).map_or_else(|| part.clone(), |power| &part * power);
        }
    }
    let term = |rest: &Expr, j: i64, number: Number| {
        let of_end = if powers.is_empty() { end.power(-2 * j) } else { Expr::one() };
        Expr::product([Expr::number(number), rest.clone(), x.power(2 * j), of_end])
    };
    Expr::sum(sums.iter().flat_map(|(rest, list)| (0..).zip(list).filter(|(_, n)| !n.is_zero()).map(|(j, n)| term(rest, j, n.clone()))))
}

/// The factor of the angle in J_m: β_m = (m−1)/m x² β_(m−2), β_0 = 1.
fn angle_coefficients(highest: usize, x: &Expr) -> Vec<Expr> {
    let mut list = vec![Expr::one(), Expr::zero()];
    for m in 2..=highest as i64 {
        let before = list.get(m as usize - 2).cloned().unwrap_or_else(Expr::zero);
        list.push(Expr::ratio(m - 1, m) * x.power(2) * before);
    }
    list
}

/// The pressure of odd f′, by elliptic integrals: with g = x √(x²−b²) α(x²) the integrand g′ is even over √(x²−b²).
fn pressure(coefficients: &[Expr], lower: &Expr, upper: Option<&Expr>) -> Option<Branches> {
    if coefficients.len() > MOST_COEFFICIENTS || coefficients.iter().step_by(2).any(|c| !c.is_zero()) {
        return None;
    }
    let from = |end: &Expr| if end.is_zero() { Some(power_pressure(coefficients)) } else { worn_pressure(coefficients, end) };
    let within = from(lower)?;
    let beyond = match upper {
        Some(upper) => within.minus(&from(upper)?),
        None => within.clone(),
    };
    Some(Branches { within, beyond })
}

/// Σ c_m κ_(m+1) S_m: the pressure of the same polynomial without lower end.
fn power_pressure(coefficients: &[Expr]) -> Pair {
    let (r, a) = (Expr::symbol("r"), Expr::symbol("a"));
    Pair::same(Expr::sum(coefficients.iter().enumerate().map(|(m, c)| {
        let m = m as i64;
        c * super::power::kappa(&Expr::integer(m + 1)) * Expr::call("pressure_power", [Expr::integer(m), r.clone(), a.clone()])
    })))
}

/// ∫_max(b,r)^a g′/√(x²−r²) dx with g = Σ c_m x J_m(b; x), all m odd, as Σ q_k E_k.
///
/// Shown as α E_0 + β E_1 + γ √((a²−b²)(a²−r²)) with polynomials α, β, γ.
fn worn_pressure(coefficients: &[Expr], b: &Expr) -> Option<Pair> {
    let symbol = Symbol::new("x");
    let x = Expr::from(symbol.clone());
    let alpha = root_factor(coefficients, 0, &root_numbers(coefficients.len()), b, &x);
    // g′ √(x²−b²) = (x²−b²)(α + x α′) + x² α
    let numerator = (x.power(2) - b.power(2)) * (&alpha + &x * derivative(&alpha, &symbol).ok()?) + x.power(2) * &alpha;
    let list = normal::polynomial_coefficients(&numerator, &symbol)?;
    let (r, a) = (Expr::symbol("r"), Expr::symbol("a"));
    let moment = |k: i64| Expr::call("elliptic_moment", [Expr::integer(k), b.clone(), r.clone(), a.clone()]);
    let (mut evaluated, mut parts) = (Vec::new(), [Expr::zero(), Expr::zero(), Expr::zero()]);
    let moments = elliptic_moment_parts(list.len() as i64 / 2, b, &r, &a);
    // All powers are even.
    for ((k, c), own) in (0..).zip(list.iter().step_by(2)).zip(moments).filter(|((_, c), _)| !c.is_zero()) {
        evaluated.push(c * moment(k));
        for (sum, part) in parts.iter_mut().zip(own) {
            *sum = &*sum + c * part;
        }
    }
    let [first, second, root] = parts.map(|part| factored(&part));
    let edge = (a.power(2) - b.power(2)).sqrt() * (a.power(2) - r.power(2)).sqrt();
    Some(Pair { shown: first * moment(0) + second * moment(1) + root * edge, evaluated: Expr::sum(evaluated) })
}

/// The expanded form, with the common factor of all terms in front.
fn factored(expr: &Expr) -> Expr {
    let expanded = normal::expanded(expr, &Symbol::new("r")).unwrap_or_else(|_| expr.clone());
    let (content, reduced) = normal::common_content(&expanded.terms());
    if reduced.iter().all(|term| term.split_coefficient().0.is_negative()) {
        return -content * Expr::sum(reduced.iter().map(|term| -term));
    }
    content * Expr::sum(reduced)
}
