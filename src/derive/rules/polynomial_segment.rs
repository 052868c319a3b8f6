//! Polynomials on a segment: worn and truncated tips, caps, rounded edges, and every piece between two breakpoints.

use super::combination::tidy;
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::function::elliptic_moment_parts;
use crate::expr::normal;
use crate::expr::{Expr, Number, Sign, Symbol, derivative, sign};
use crate::num::work;

pub(super) static RULE: Rule = Rule {
    id: "polynomial-segment",
    title: "Polynomial on a segment",
    pattern: "piecewise(0, r<b, A*(r-b)+C*(r^2-b^2))",
    slope: "piecewise(0, x<b, A*x*acos(b/x)+2*C*x*sqrt(x^2-b^2))",
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

/// Steps of work after which the pressure is left as an integral; that of `max(r,b)^40` takes fewer.
const LONGEST: u64 = 28_000_000;

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
    let slope = |end: Option<&Expr>| Pair {
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
        slope: Branches { within: slope(None), beyond: slope(upper) },
        force: Branches { within: force(None), beyond: force(upper) },
        // The pressure of a high power takes more work than g and F, which stay closed without it.
        pressure: work::share(LONGEST, || pressure(&coefficients, lower, upper)).flatten(),
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
    let combine = |parts: &[Vec<Expr>]| {
        let products = coefficients.iter().zip(parts.iter().skip(shift)).flat_map(|(c, list)| list.iter().map(move |part| c * part));
        tidy(&Expr::sum(products))
    };
    let root = |end: &Expr| (x.power(2) - end.power(2)).sqrt();
    let mut terms = vec![root(b) * combine(&root_parts(highest, b, x))];
    if let Some(c) = c {
        terms.push(-(root(c) * combine(&root_parts(highest, c, x))));
    }
    terms.push(angle * arc);
    Expr::sum(terms)
}

/// The terms of the factor of √(x²−e²) in J_m, for every m: α_m = ((m−1) x² α_(m−2) + e^(m−1))/m, a polynomial in x² and e.
fn root_parts(highest: usize, end: &Expr, x: &Expr) -> Vec<Vec<Expr>> {
    let mut numbers = vec![Vec::new(), vec![Number::integer(1)]];
    for m in 2..=highest {
        let factor = Number::ratio(m as i64 - 1, m as i64);
        let before = numbers.get(m - 2).into_iter().flatten().map(|own| own * &factor);
        numbers.push([Number::ratio(1, m as i64)].into_iter().chain(before).collect());
    }
    let part = |m: usize, (j, number): (usize, &Number)| {
        let (of_x, of_end) = (2 * j as i64, m as i64 - 1 - 2 * j as i64);
        Expr::product([Expr::number(number.clone()), x.power(of_x), end.power(of_end)])
    };
    numbers.iter().enumerate().map(|(m, list)| list.iter().enumerate().map(|own| part(m, own)).collect()).collect()
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
    if coefficients.iter().step_by(2).any(|c| !c.is_zero()) {
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
    let roots = root_parts(coefficients.len(), b, &x);
    let alpha = Expr::sum(coefficients.iter().zip(&roots).flat_map(|(c, parts)| parts.iter().map(move |part| c * part)));
    // g′ √(x²−b²) = (x²−b²)(α + x α′) + x² α
    let numerator = (x.power(2) - b.power(2)) * (&alpha + &x * derivative(&alpha, &symbol).ok()?) + x.power(2) * &alpha;
    let list = normal::polynomial_coefficients(&numerator, &symbol)?;
    let (r, a) = (Expr::symbol("r"), Expr::symbol("a"));
    let moment = |k: i64| Expr::call("elliptic_moment", [Expr::integer(k), b.clone(), r.clone(), a.clone()]);
    let (mut evaluated, mut parts) = (Vec::new(), [Expr::zero(), Expr::zero(), Expr::zero()]);
    for (power, c) in list.iter().enumerate().filter(|(_, c)| !c.is_zero()) {
        let k = power as i64 / 2;
        evaluated.push(c * moment(k));
        for (sum, part) in parts.iter_mut().zip(elliptic_moment_parts(k, b, &r, &a)) {
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
