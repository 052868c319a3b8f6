//! Powers of r on a segment with negative integer or real exponents.

use super::combination::{Combination, Form};
use super::power;
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::{Condition, Expr, Sign, sign};

pub(super) static NEGATIVE: Rule = Rule {
    id: "negative-power-segment",
    title: "Negative power on a segment",
    pattern: "piecewise(0, r<b, A*ln(r/b)+C*(1/b-1/r))",
    equivalent: "piecewise(0, x<b, A*acosh(x/b)+C*sqrt(x^2-b^2)/(b*x))",
    force: "piecewise(0, a<b, 2*E*(A*sqrt(a^2-b^2)+C*acos(b/a)))",
    pressure: Some(
        "piecewise(0, a<b, E/pi*(A*ellipf(asin(sqrt((a^2-max(b,r)^2)/(a^2-min(b,r)^2))),(min(b,r)/max(b,r))^2)/max(b,r)\
         +b*C*((ellipf(asin(sqrt((a^2-max(b,r)^2)/(a^2-min(b,r)^2))),(min(b,r)/max(b,r))^2)\
         -ellipe(asin(sqrt((a^2-max(b,r)^2)/(a^2-min(b,r)^2))),(min(b,r)/max(b,r))^2))/(min(b,r)^2*max(b,r))\
         +sqrt((a^2-max(b,r)^2)/(a^2-min(b,r)^2))/(a*max(b,r)^2))))",
    ),
    parameters: &[
        Parameter { name: "A", lowest: 0.1, highest: 2.0 },
        Parameter { name: "C", lowest: 0.1, highest: 2.0 },
        Parameter { name: "b", lowest: 0.2, highest: 2.0 },
    ],
    guard: "f′ = c·r^m on [b, c) with whole m < 0 and b > 0; the pressure closes for m = −1 and m = −2",
    reference: &["integration by parts", "DLMF 19.25(i)"],
    specializes: None,
    apply: negative,
};

pub(super) static REAL: Rule = Rule {
    id: "real-power-segment",
    title: "Real power on a segment",
    pattern: "piecewise(0, r<b, C*(r^n-b^n))",
    equivalent: "piecewise(0, x<b, C*n/2*x^n*betainc(n/2,1/2,b^2/x^2,1))",
    force: "piecewise(0, a<b, E*C*n*a^(n+1)*betainc(n/2+1,1/2,b^2/a^2,1))",
    pressure: None,
    parameters: &[
        Parameter { name: "C", lowest: 0.1, highest: 2.0 },
        Parameter { name: "n", lowest: 0.3, highest: 5.0 },
        Parameter { name: "b", lowest: 0.2, highest: 2.0 },
    ],
    guard: "f′ = c·r^m on [b, c) with m not whole; m > −1 where b = 0",
    reference: &["Popov & Heß (3.28)", "DLMF 8.17.1 with t = r²/x²"],
    specializes: None,
    apply: real,
};

/// Smallest exponent; the formulas for smaller exponents are too long.
const LOWEST: i64 = -40;

fn negative(term: &Term) -> Option<Answer> {
    let part = term.single()?;
    let m = part.exponent.as_integer().filter(|m| (LOWEST..0).contains(m))?;
    if !part.kernel.is_one() || term.segment.lower.is_zero() {
        return None;
    }
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    let pieces = |m: i64, at: &Expr, factor: &Expr| {
        let piece = |e: &Expr, form: Form| moment(m, e, at).over(&basis(m, e, at, form));
        let pair = |e: &Expr| Pair { shown: piece(e, Form::Shown), evaluated: piece(e, Form::Evaluated) };
        Branches::from_ends(&term.segment, pair).scaled(factor)
    };
    let c = &part.coefficient;
    let pressure = pressure_from(m, &Expr::symbol("r"), &a).map(|from| Branches::from_ends(&term.segment, from).scaled(c));
    Some(Answer { equivalent: pieces(m, &x, &(c * &x)), force: pieces(m + 2, &a, c), pressure, conditions: Vec::new() })
}

/// ∫ g′/√(x²−r²) dx for f′ = r^m from e on: g′ is 1/√(x²−e²) for m = −1, e/(x² √(x²−e²)) for m = −2.
fn pressure_from<'a>(m: i64, r: &'a Expr, a: &'a Expr) -> Option<impl Fn(&Expr) -> Pair + 'a> {
    let order = match m {
        -1 => 0,
        -2 => -1,
        _ => return None,
    };
    Some(move |e: &Expr| {
        Pair::same(e.power(-order) * Expr::call("elliptic_moment", [Expr::integer(order), e.clone(), r.clone(), a.clone()]))
    })
}

/// √(x²−b²), and ∫_b^x of 1/√(x²−r²) for even m, of 1/(r √(x²−r²)) for odd m.
fn basis(m: i64, b: &Expr, x: &Expr, form: Form) -> [Expr; 2] {
    let root = form.root(x, b);
    let start = match form {
        _ if m % 2 == 0 => form.arc(x, b),
        Form::Shown => Expr::call("acosh", [x / b]) / x,
        Form::Evaluated => Expr::call("asinh", [&root / b]) / x,
    };
    [root, start]
}

/// J_m over the basis, by J_(m−2) = (m J_m − b^(m−1) √(x²−b²))/((m−1) x²); all parts are positive.
fn moment(m: i64, b: &Expr, x: &Expr) -> Combination {
    if m == 1 {
        return Combination::unit(0, 2);
    }
    let mut sum = Combination::unit(1, 2);
    // From J_0 or J_(−1) downward.
    for n in ((m + 2)..=(-(m % 2).abs())).rev().step_by(2) {
        let boundary = Combination::unit(0, 2).times(&-b.power(n - 1));
        sum = sum.times(&Expr::integer(n)).plus(&boundary).times(&(Expr::integer(n - 1) * x.power(2)).recip()).tidied();
    }
    sum
}

fn real(term: &Term) -> Option<Answer> {
    let part = term.single()?;
    let m = &part.exponent;
    if !part.kernel.is_one() || term.segment.is_whole() || m.as_integer().is_some() {
        return None;
    }
    let n = m + Expr::one();
    let lower = &term.segment.lower;
    let conditions = match sign(&n) {
        Sign::Unknown if lower.is_zero() => vec![Condition::less(Expr::zero(), n.clone())],
        Sign::Zero | Sign::Negative if lower.is_zero() => return None,
        _ => Vec::new(),
    };
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    // ∫ r^m/√(x²−r²) dr with m = n − 1
    let integral = |n: &Expr, at: &Expr, factor: &Expr| {
        let whole = at.pow(&(n - Expr::one()));
        let between = |from: &Expr, to: Option<&Expr>| {
            if let (true, None) = (from.is_zero(), to) {
                return Pair::same(factor * power::kappa(n) / n * &whole);
            }
            let half = factor / Expr::integer(2) * &whole;
            let place = |e: &Expr| e.power(2) / at.power(2);
            let end = to.map_or_else(Expr::one, place);
            let (order, other) = (n / Expr::integer(2), Expr::ratio(1, 2));
            let shown = Expr::call("betainc", [order.clone(), other.clone(), place(from), end]);
            let rest = |e: &Expr| (at - e) * (at + e) / at.power(2);
            let stable = Expr::call("betainc", [other, order, to.map_or_else(Expr::zero, rest), rest(from)]);
            let evaluated = if from.is_zero() { shown.clone() } else { stable };
            Pair { shown: &half * shown, evaluated: half * evaluated }
        };
        let within = between(lower, None);
        let beyond = match &term.segment.upper {
            Some(upper) => between(lower, Some(upper)),
            None => within.clone(),
        };
        Branches { within, beyond }
    };
    let c = &part.coefficient;
    let equivalent = integral(&n, &x, &(c * &x));
    let force = integral(&(&n + Expr::integer(2)), &a, c);
    Some(Answer { equivalent, force, pressure: None, conditions })
}
