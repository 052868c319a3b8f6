//! Powers of r times powers of ln r: on the whole axis with any exponent, on segments with whole ones.

use super::combination::{Combination, Form, tidy};
use super::{power, reading};
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::Expr;

pub(super) static RULE: Rule = Rule {
    id: "power-log",
    title: "Power times logarithm",
    pattern: "C*r^n*(ln(r)-1/n)",
    equivalent: "C*sqrt(pi)*gamma(n/2+1)/gamma(n/2+1/2)*x^n*(ln(x)+(digamma(n/2+1)-digamma(n/2+1/2))/2-1/n)",
    force: "2*E*C*sqrt(pi)*gamma(n/2+1)/gamma(n/2+1/2)*n/(n+1)*a^(n+1)*(ln(a)+(digamma(n/2+1)-digamma(n/2+1/2))/2-1/(n+1))",
    pressure: None,
    parameters: &[Parameter { name: "C", lowest: 0.1, highest: 4.0 }, Parameter { name: "n", lowest: 0.2, highest: 9.0 }],
    guard: "f′ = c·r^m·ln(r)^k with m > −1 and whole k; the pressure closes for whole m and k = 1",
    reference: &["derivative of Popov & Heß (3.16) with respect to the exponent"],
    specializes: None,
    apply: whole_axis,
};

pub(super) static ON_SEGMENT: Rule = Rule {
    id: "power-log-segment",
    title: "Power times logarithm on a segment",
    pattern: "piecewise(0, r<b, C*(r^2*(ln(r)-1/2)-b^2*(ln(b)-1/2)))",
    equivalent: "piecewise(0, x<b, 2*C*x*(sqrt(x^2-b^2)*(ln(b)-1)+x*acosh(x/b)))",
    force: "piecewise(0, a<b, 4/9*E*C*(sqrt(a^2-b^2)*(3*(2*a^2+b^2)*ln(b)-b^2-5*a^2)+6*a^3*acosh(a/b)))",
    pressure: None,
    parameters: &[Parameter { name: "C", lowest: 0.1, highest: 4.0 }, Parameter { name: "b", lowest: 0.2, highest: 2.0 }],
    guard: "f′ = c·r^m·ln(r) on [b, c) with whole m; for odd m only m > 0",
    reference: &["integration by parts", "Clausen's function for even m"],
    specializes: None,
    apply: on_segment,
};

/// Powers of the logarithm beyond this one fill pages.
const HIGHEST_POWER: i64 = 12;
/// Exponents beyond this one fill pages.
const HIGHEST_EXPONENT: i64 = 60;

/// c, m and k of c·r^m·ln(r)^k.
fn read(term: &Term) -> Option<(&Expr, &Expr, i64)> {
    let part = term.single()?;
    let (base, exponent) = reading::power(&part.kernel);
    let argument = reading::call(&base, "ln")?.first()?;
    let k = exponent.as_integer().filter(|k| (1..=HIGHEST_POWER).contains(k))?;
    (*argument == Expr::symbol("r")).then_some((&part.coefficient, &part.exponent, k))
}

/// ∫₀^x r^m/√(x²−r²) dr = M(m) x^m; its k-th derivative in m is M x^m B_k(ln x + λ₁, λ₂, …, λ_k).
fn whole_axis(term: &Term) -> Option<Answer> {
    let (c, m, k) = read(term)?;
    if !term.segment.is_whole() {
        return None;
    }
    let n = m + Expr::one();
    let conditions = reading::positive(&n)?;
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    let whole = m.as_integer().filter(|m| *m <= HIGHEST_EXPONENT);
    let next = &n + Expr::one();
    // M(m) = κ_n/n and M(m+2) = κ_n/(n+1).
    let kappa = c * power::kappa(&n);
    let pair = |at: &Expr, m: &Expr, power: &Expr| {
        let factor = &kappa / power * at.pow(power);
        match m.as_integer().filter(|_| whole.is_some()) {
            Some(m) => whole_exponent(&factor, m, k, at),
            None => Pair::same(&factor * bell(k, &logarithmic_derivatives(m, k, at))),
        }
    };
    Some(Answer {
        equivalent: Branches::endless(pair(&x, m, &n)),
        force: Branches::endless(pair(&a, &(m + Expr::integer(2)), &next)),
        pressure: whole.filter(|_| k == 1).map(|m| Branches::endless(pressure(c, m))),
        conditions,
    })
}

/// ln x + λ₁, λ₂, …, λ_k with λ_j = (ψ^(j−1)((m+1)/2) − ψ^(j−1)(m/2+1))/2^j.
fn logarithmic_derivatives(m: &Expr, k: i64, x: &Expr) -> Vec<Expr> {
    let low = (m + Expr::one()) / Expr::integer(2);
    let high = &low + Expr::ratio(1, 2);
    let psi = |order: i64, z: &Expr| match order {
        0 => Expr::call("digamma", [z.clone()]),
        _ => Expr::call("polygamma", [Expr::integer(order), z.clone()]),
    };
    (1..=k)
        .map(|j| {
            let own = (psi(j - 1, &low) - psi(j - 1, &high)) / Expr::integer(2).power(j);
            if j == 1 { Expr::call("ln", [x.clone()]) + own } else { own }
        })
        .collect()
}

/// The complete Bell polynomial B_k(x₁, …, x_k): B_(n+1) = Σ binom(n, i) B_(n−i) x_(i+1).
fn bell(k: i64, arguments: &[Expr]) -> Expr {
    let mut list = vec![Expr::one()];
    for n in 0..k {
        let next = (0..=n).zip(arguments).map(|(i, argument)| {
            let before = list.get((n - i) as usize).cloned().unwrap_or_else(Expr::zero);
            binomial(n, i) * before * argument
        });
        list.push(Expr::sum(next.collect::<Vec<_>>()));
    }
    list.pop().unwrap_or_else(Expr::one)
}

fn binomial(n: i64, i: i64) -> Expr {
    (1..=i).fold(Expr::one(), |product, j| product * Expr::ratio(n - i + j, j))
}

/// The same for whole m, in powers of L = ln 2x for odd and ln(x/2) for even m, with rational constants, π and ζ(odd).
fn whole_exponent(factor: &Expr, m: i64, k: i64, x: &Expr) -> Pair {
    let (logarithm, constants) = (Expr::call("ln", [doubled(m) * x]), constants(m, k));
    let terms = (0..=k).map(|i| factor * binomial(k, i) * tidy(&bell(i, &constants)) * logarithm.power(k - i));
    let mut arguments = constants.clone();
    if let Some(first) = arguments.first_mut() {
        *first = &*first + &logarithm;
    }
    Pair { shown: Expr::sum(terms), evaluated: factor * bell(k, &arguments) }
}

/// The factor of x in the logarithm: λ₁(m) is its logarithm plus a rational number.
fn doubled(m: i64) -> Expr {
    if m % 2 == 0 { Expr::ratio(1, 2) } else { Expr::integer(2) }
}

/// λ₁ without its ln 2, λ₂, …, λ_k, from ψ at whole and half-odd arguments.
fn constants(m: i64, k: i64) -> Vec<Expr> {
    (1..=k)
        .map(|j| {
            // ψ^(j−1)(z) = (−1)^j (j−1)! [ζ(j) − Σ i^(−j)] at whole z, with (2^j − 1) ζ(j) and 2^j Σ (2i−1)^(−j) at half-odd z.
            let whole = |n: i64| Expr::sum((1..n).map(|i| Expr::integer(i).power(-j)));
            let half = |n: i64| Expr::integer(2).power(j) * Expr::sum((1..=n).map(|i| Expr::integer(2 * i - 1).power(-j)));
            let (rational, zetas) = if m % 2 == 0 {
                (whole(m / 2 + 1) - half(m / 2), Expr::integer(2).power(j) - Expr::integer(2))
            } else {
                (half((m + 1) / 2) - whole((m + 1) / 2), Expr::integer(2) - Expr::integer(2).power(j))
            };
            let constant = if j == 1 { rational } else { rational + zetas * zeta(j) };
            let factorial = Expr::product((1..j).map(Expr::integer));
            let sign = if j % 2 == 0 { Expr::one() } else { Expr::integer(-1) };
            tidy(&(sign * factorial * constant / Expr::integer(2).power(j)))
        })
        .collect()
}

/// ζ(j): a rational times π^j for even j, by ψ^(j−1)(1) for odd j.
fn zeta(j: i64) -> Expr {
    if j % 2 == 1 {
        let factorial = Expr::product((1..j).map(Expr::integer));
        return -Expr::call("polygamma", [Expr::integer(j - 1), Expr::one()]) / factorial;
    }
    // (n + 1/2) ζ(2n) = Σ_(i=1)^(n−1) ζ(2i) ζ(2n−2i), ζ(2) = π²/6.
    let mut rationals = vec![Expr::ratio(1, 6)];
    for n in 2..=j / 2 {
        let products = rationals.iter().zip(rationals.iter().rev()).map(|(one, two)| one * two);
        rationals.push(Expr::ratio(2, 2 * n + 1) * Expr::sum(products.collect::<Vec<_>>()));
    }
    rationals.pop().unwrap_or_else(Expr::zero) * Expr::pi().power(j)
}

/// p π/E* = c M [(m+1) ∫ x^m (L + λ)/√(x²−r²) dx + ∫ x^m/√(x²−r²) dx], L = ln(2x) or ln(x/2).
fn pressure(c: &Expr, m: i64) -> Pair {
    let n = Expr::integer(m + 1);
    let factor = c * power::kappa(&n) / &n;
    let rational = constants(m, 1).pop().unwrap_or_else(Expr::zero);
    let (with_log, without) = stress_moments(m);
    let sum = with_log.times(&n).plus(&without.times(&(&n * rational + Expr::one()))).tidied();
    let form = |form: Form| &factor * sum.over(&stress_basis(m, form));
    Pair { shown: form(Form::Shown), evaluated: form(Form::Evaluated) }
}

/// √(a²−r²), √(a²−r²) ln(σa), and what the recurrences start from.
fn stress_basis(m: i64, form: Form) -> [Expr; 4] {
    let (r, a) = (Expr::symbol("r"), Expr::symbol("a"));
    let (root, scale) = (form.root(&a, &r), doubled(m));
    let logarithm = Expr::call("ln", [&scale * &a]);
    let arc = match form {
        Form::Shown if m % 2 == 0 => Expr::call("acosh", [&a / &r]),
        Form::Evaluated if m % 2 == 0 => Expr::call("asinh", [&root / &r]),
        Form::Shown => &r * Expr::call("acos", [&r / &a]),
        Form::Evaluated => &r * Expr::call("atan2", [root.clone(), r.clone()]),
    };
    let start = if m % 2 == 0 {
        // ∫ ln(x/2)/√(x²−r²) dx with U = acosh(a/r): U ln(r/4) + U²/2 + Li₂(−e^(−2U))/2 + π²/24
        let ratio = &r / (&a + &root);
        let dilogarithm = Expr::call("polylog", [Expr::integer(2), -ratio.power(2)]);
        let half = Expr::ratio(1, 2);
        &arc * Expr::call("ln", [&r / Expr::integer(4)])
            + &half * arc.power(2)
            + half * dilogarithm
            + Expr::pi().power(2) / Expr::integer(24)
    } else {
        Expr::zero()
    };
    [root.clone(), root * logarithm, arc, start]
}

/// ∫_r^a x^m ln(σx)/√(x²−r²) dx and ∫_r^a x^m/√(x²−r²) dx over the basis.
///
/// m S_m = a^(m−1) w + (m−1) r² S_(m−2) and its derivative with respect to m.
fn stress_moments(m: i64) -> (Combination, Combination) {
    let (r, a) = (Expr::symbol("r"), Expr::symbol("a"));
    let unit = |i| Combination::unit(i, 4);
    // For odd m from r² S_(−1) = r acos(r/a), whose logarithmic partner has the factor 0.
    let (mut plain, mut log, mut n) = if m % 2 == 0 { (unit(2), unit(3), 0) } else { (unit(2).times(&r.power(-2)), unit(3), -1) };
    while n < m {
        n += 2;
        let (over, lead) = (Expr::ratio(1, n), a.power(n - 1));
        let next = unit(0).times(&lead).plus(&plain.times(&(Expr::integer(n - 1) * r.power(2)))).times(&over).tidied();
        let terms = unit(1).times(&lead).plus(&plain.times(&r.power(2))).plus(&next.times(&Expr::integer(-1)));
        log = terms.plus(&log.times(&(Expr::integer(n - 1) * r.power(2)))).times(&over).tidied();
        plain = next;
    }
    (log, plain)
}

fn on_segment(term: &Term) -> Option<Answer> {
    let (c, m, k) = read(term)?;
    let m = m.as_integer().filter(|m| m.abs() <= HIGHEST_EXPONENT)?;
    let lower = &term.segment.lower;
    if term.segment.is_whole() || k != 1 || (m < 0 && (m % 2 != 0 || lower.is_zero())) {
        return None;
    }
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    let from = |m: i64, end: &Expr, at: &Expr| {
        if end.is_zero() {
            return whole_exponent(&(power::kappa(&Expr::integer(m + 1)) / Expr::integer(m + 1) * at.power(m)), m, 1, at);
        }
        let sum = segment_moment(m, end, at);
        let form = |form: Form| sum.over(&segment_basis(m, end, at, form));
        Pair { shown: form(Form::Shown), evaluated: form(Form::Evaluated) }
    };
    let branches = |m: i64, at: &Expr, factor: &Expr| Branches::from_ends(&term.segment, |end| from(m, end, at)).scaled(factor);
    Some(Answer { equivalent: branches(m, &x, &(c * &x)), force: branches(m + 2, &a, c), pressure: None, conditions: Vec::new() })
}

/// √(x²−b²), √(x²−b²) ln b, and what the recurrences start from.
fn segment_basis(m: i64, b: &Expr, x: &Expr, form: Form) -> [Expr; 4] {
    let root = form.root(x, b);
    let logarithm = Expr::call("ln", [b.clone()]);
    let (arc, start) = if m % 2 == 0 {
        // ∫ ln r/√(x²−r²) dr = acos(b/x) ln(x/2) + Cl₂(2 asin(b/x))/2
        let arc = form.arc(x, b);
        let angle = Expr::integer(2) * Expr::call("asin", [b / x]);
        let clausen = Expr::call("clsin", [Expr::integer(2), angle]) / Expr::integer(2);
        (arc.clone(), arc * Expr::call("ln", [x / Expr::integer(2)]) + clausen)
    } else {
        let hyperbolic = match form {
            Form::Shown => Expr::call("acosh", [x / b]),
            Form::Evaluated => Expr::call("asinh", [&root / b]),
        };
        (hyperbolic / x, Expr::zero())
    };
    [root.clone(), root * logarithm, arc, start]
}

/// ∫_b^x r^m ln r/√(x²−r²) dr over the basis: m J_m = (m−1) x² J_(m−2) + b^(m−1) w and its derivative with respect to m.
fn segment_moment(m: i64, b: &Expr, x: &Expr) -> Combination {
    let unit = |i| Combination::unit(i, 4);
    let square = x.power(2);
    let (mut plain, mut log, mut n) = (unit(2), unit(3), if m % 2 == 0 { 0 } else { -1 });
    while n < m {
        n += 2;
        let (over, lead) = (Expr::ratio(1, n), b.power(n - 1));
        let next = unit(0).times(&lead).plus(&plain.times(&(Expr::integer(n - 1) * &square))).times(&over).tidied();
        let terms = unit(1).times(&lead).plus(&plain.times(&square)).plus(&next.times(&Expr::integer(-1)));
        log = terms.plus(&log.times(&(Expr::integer(n - 1) * &square))).times(&over).tidied();
        plain = next;
    }
    while n > m {
        let (over, lead) = ((Expr::integer(n - 1) * &square).recip(), -b.power(n - 1));
        let next = unit(0).times(&lead).plus(&plain.times(&Expr::integer(n))).times(&over).tidied();
        let terms = unit(1).times(&lead).plus(&plain).plus(&next.times(&-&square));
        log = terms.plus(&log.times(&Expr::integer(n))).times(&over).tidied();
        plain = next;
        n -= 2;
    }
    log
}
