//! exp(±r²/w²) times powers of r: Dawson's integral or the error function for odd powers, Bessel functions for even ones.

use super::laurent::{Combination, Laurent, Member, member};
use super::moments::{self, Moments};
use super::reading;
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::Expr;

pub(super) static DECAY: Rule = Rule {
    id: "gaussian",
    title: "Gaussian times a power",
    pattern: "h*(1-exp(-r^2/w^2))",
    equivalent: "2*h*x/w*dawson(x/w)",
    force: "2*E*h*((w+2*a^2/w)*dawson(a/w)-a)",
    pressure: None,
    parameters: &[Parameter { name: "h", lowest: 0.1, highest: 2.0 }, Parameter { name: "w", lowest: 0.5, highest: 3.0 }],
    guard: "f′ = c r^m exp(−r²/w²), whole m ≥ 0",
    reference: &["general formula, Popov & Heß (3.27)", "DLMF 7.2.5 and 10.32.2"],
    specializes: None,
    apply: |term| whole(term, true),
};

pub(super) static GROWTH: Rule = Rule {
    id: "gaussian-growth",
    title: "Growing Gaussian times a power",
    pattern: "h*(exp(r^2/w^2)-1)",
    equivalent: "h*sqrt(pi)*x/w*exp(x^2/w^2)*erf(x/w)",
    force: "2*E*h*(a+sqrt(pi)/2*(2*a^2/w-w)*exp(a^2/w^2)*erf(a/w))",
    pressure: None,
    parameters: &[Parameter { name: "h", lowest: 0.1, highest: 2.0 }, Parameter { name: "w", lowest: 1.0, highest: 3.0 }],
    guard: "f′ = c r^m exp(r²/w²), whole m ≥ 0",
    reference: &["general formula, Popov & Heß (3.27)", "DLMF 7.2.1 and 10.32.2"],
    specializes: None,
    apply: |term| whole(term, false),
};

pub(super) static SEGMENT: Rule = Rule {
    id: "gaussian-segment",
    title: "Gaussian from a radius outward or on a segment",
    pattern: "piecewise(0, r<b, h*(exp(-b^2/w^2)-exp(-r^2/w^2)))",
    equivalent: "piecewise(0, x<b, 2*h*x/w*exp(-b^2/w^2)*dawson(sqrt(x^2-b^2)/w))",
    force: "piecewise(0, a<b, 2*E*h*exp(-b^2/w^2)*((w+2*a^2/w)*dawson(sqrt(a^2-b^2)/w)-sqrt(a^2-b^2)))",
    pressure: None,
    parameters: &[
        Parameter { name: "h", lowest: 0.1, highest: 2.0 },
        Parameter { name: "w", lowest: 0.5, highest: 3.0 },
        Parameter { name: "b", lowest: 0.2, highest: 1.5 },
    ],
    guard: "f′ = c r^m exp(±r²/w²) on [b, c), odd m ≥ 1",
    reference: &["general formula, Popov & Heß (3.27)", "wear rule for even profiles"],
    specializes: None,
    apply: segment,
};

/// κ and whether the exponential decays, for exp(∓κ²r²).
pub(super) fn scale(kernel: &Expr) -> Option<(Expr, bool)> {
    let [argument] = reading::call(kernel, "exp")? else { return None };
    let (square, falling) = moments::argument(argument, 2)?;
    Some((square.sqrt(), falling))
}

/// f′ = c·r^m·exp(∓κ²r²) on the whole axis, with y = κr.
fn whole(term: &Term, decay: bool) -> Option<Answer> {
    let (part, m) = moments::whole(term)?;
    let (scale, _) = scale(&part.kernel).filter(|(_, falling)| *falling == decay)?;
    let moment = |m: i64| if m % 2 == 0 { even_moment(m, decay) } else { odd_moment(m, decay, false) };
    let members = |m: i64, y: &Expr| if m % 2 == 0 { even_members(y, decay) } else { odd_members(y, decay) };
    let shown = |m: i64, y: &Expr| if m % 2 == 0 { even_shown(y, decay) } else { odd_members(y, decay) };
    Some(moments::answer(&part.coefficient, m, &Moments { scale, moment: &moment, members: &members, shown: &shown, apart: false }))
}

/// ∫₀^y u^m e^(∓u²)/√(y²−u²) du for even m, over [`even_members`]: the moments of order 0 and 2, then
/// ±2 J_(p+3) = (p + 1 ± 2y²) J_(p+1) − p y² J_(p−1).
pub(super) fn even_moment(m: i64, decay: bool) -> Combination {
    let sign = if decay { 1 } else { -1 };
    let single = Combination::single;
    let (mut before, mut own) = (single(0, 1, 1, 0), single(0, 1, 2, 2).plus(&single(1, -sign, 2, 2)));
    if m == 0 {
        return before;
    }
    for p in (1..m - 2).step_by(2) {
        let next = step(p, sign, &before, &own);
        before = std::mem::replace(&mut own, next);
    }
    own
}

/// The same for odd m over [`odd_members`]. On a segment from β, the last function is √(y²−β²) e^(∓β²), followed by one function
/// for each further power β^p.
fn odd_moment(m: i64, decay: bool, segment: bool) -> Combination {
    let sign = if decay { 1 } else { -1 };
    let (mut before, mut own) = (Combination::default(), Combination::single(0, 1, 1, 0));
    for p in (0..m - 2).step_by(2) {
        let next = step(p, sign, &before, &own);
        let next = match (segment, p) {
            (true, _) => next.minus(&Combination::single(1 + p as usize / 2, sign, 2, 0)),
            (false, 0) => next.minus(&Combination::single(1, sign, 2, 1)),
            _ => next,
        };
        before = std::mem::replace(&mut own, next);
    }
    own
}

/// J_(p+3) without its boundary term.
fn step(p: i64, sign: i64, before: &Combination, own: &Combination) -> Combination {
    own.times(&Laurent::term(sign * (p + 1), 2, 0).plus(&Laurent::term(1, 1, 2))).minus(&before.scaled(sign * p, 2, 2))
}

/// (π/2) e^(∓z) I_0(z) and (π/2) e^(∓z) I_1(z) at z = y²/2, without overflow for the decaying exponential.
pub(super) fn even_members(y: &Expr, decay: bool) -> Vec<Member> {
    if !decay {
        return even_shown(y, decay);
    }
    let z = y.power(2) / Expr::integer(2);
    [0, 1].map(|order| member(Expr::pi() / Expr::integer(2), Expr::call("besseli_scaled", [Expr::integer(order), z.clone()]))).into()
}

/// The same with the exponential as a factor.
pub(super) fn even_shown(y: &Expr, decay: bool) -> Vec<Member> {
    let z = y.power(2) / Expr::integer(2);
    let exponential = Expr::call("exp", [if decay { -&z } else { z.clone() }]);
    let factor = Expr::pi() / Expr::integer(2) * exponential;
    [0, 1].map(|order| member(factor.clone(), Expr::call("besseli", [Expr::integer(order), z.clone()]))).into()
}

/// ∫₀^y e^(∓(y²−u²)) du, which is D(y) or (√π/2) e^(y²) erf(y), and 1.
fn odd_members(y: &Expr, decay: bool) -> Vec<Member> {
    vec![odd_member(y, y, decay), member(Expr::one(), Expr::one())]
}

/// e^(−(y²−v²)) D(v) without its exponential, or (√π/2) e^(y²) erf(v).
fn odd_member(y: &Expr, v: &Expr, decay: bool) -> Member {
    if decay {
        return member(Expr::one(), Expr::call("dawson", [v.clone()]));
    }
    member(Expr::pi().sqrt() / Expr::integer(2), Expr::call("exp", [y.power(2)]) * Expr::call("erf", [v.clone()]))
}

/// f′ = c·r^m·exp(∓κ²r²) with odd m on [b, c).
fn segment(term: &Term) -> Option<Answer> {
    let part = term.single()?;
    let m = moments::exponent(part)?;
    if term.segment.is_whole() || m % 2 == 0 {
        return None;
    }
    let (scale, decay) = scale(&part.kernel)?;
    let from = |order: i64, factor: &Expr, at: &Expr, begin: &Expr| {
        let factor = &part.coefficient * scale.power(-order) * factor;
        let y = &scale * at;
        if begin.is_zero() {
            return odd_moment(order, decay, false).written(&factor, &y, &odd_members(&y, decay));
        }
        let root = (at.power(2) - begin.power(2)).sqrt();
        let (v, beta) = (&scale * &root, &scale * begin);
        let edge = Expr::call("exp", [if decay { -beta.power(2) } else { beta.power(2) }]);
        // The exponential of the lower end is common to all parts of a falling Gaussian.
        let (factor, inner) = if decay { (factor * edge, Expr::one()) } else { (factor, edge) };
        let powers = (0..order / 2).map(|j| member(Expr::one(), &inner * &v * beta.power(2 * j)));
        let members: Vec<Member> = std::iter::once(odd_member(&y, &v, decay)).chain(powers).collect();
        odd_moment(order, decay, true).written(&factor, &y, &members)
    };
    let branches =
        |order: i64, factor: &Expr, at: &Expr| Branches::from_ends(&term.segment, |end| Pair::same(from(order, factor, at, end)));
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    Some(Answer { equivalent: branches(m, &x, &x), force: branches(m + 2, &Expr::one(), &a), pressure: None, conditions: Vec::new() })
}
