//! Sine and cosine of kr² times powers of r: Fresnel integrals for odd powers, Bessel functions for even ones.

use super::laurent::{Combination, Member, member};
use super::moments::{self, Moments};
use super::reading;
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::Expr;
use crate::expr::normal::NormalTerm;

pub(super) static WHOLE: Rule = Rule {
    id: "quadratic-wave",
    title: "Sine or cosine of the squared radius times a power",
    pattern: "A*sin(k*r^2)+B*(1-cos(k*r^2))",
    equivalent: "sqrt(2*pi*k)*x*(A*(cos(k*x^2)*fresnelc(x*sqrt(2*k/pi))+sin(k*x^2)*fresnels(x*sqrt(2*k/pi)))\
            +B*(sin(k*x^2)*fresnelc(x*sqrt(2*k/pi))-cos(k*x^2)*fresnels(x*sqrt(2*k/pi))))",
    force: "2*E*(A*(sqrt(2*pi*k)*a^2*(cos(k*a^2)*fresnelc(a*sqrt(2*k/pi))+sin(k*a^2)*fresnels(a*sqrt(2*k/pi)))\
            -sqrt(pi/(2*k))*(sin(k*a^2)*fresnelc(a*sqrt(2*k/pi))-cos(k*a^2)*fresnels(a*sqrt(2*k/pi))))\
            +B*(sqrt(2*pi*k)*a^2*(sin(k*a^2)*fresnelc(a*sqrt(2*k/pi))-cos(k*a^2)*fresnels(a*sqrt(2*k/pi)))\
            +sqrt(pi/(2*k))*(cos(k*a^2)*fresnelc(a*sqrt(2*k/pi))+sin(k*a^2)*fresnels(a*sqrt(2*k/pi)))-a))",
    pressure: None,
    parameters: &[
        Parameter { name: "A", lowest: 0.1, highest: 2.0 },
        Parameter { name: "B", lowest: 0.1, highest: 2.0 },
        Parameter { name: "k", lowest: 0.2, highest: 1.0 },
    ],
    guard: "f′ = c r^m sin(kr²) or c r^m cos(kr²), whole m ≥ 0",
    reference: &["general formula, Popov & Heß (3.27)", "DLMF 7.2(iii) and 10.9.1"],
    specializes: None,
    apply: whole,
};

pub(super) static SEGMENT: Rule = Rule {
    id: "quadratic-wave-segment",
    title: "Sine or cosine of the squared radius from a radius outward or on a segment",
    pattern: "piecewise(0, r<b, h*(sin(k*r^2)-sin(k*b^2)))",
    equivalent: "piecewise(0, x<b, h*sqrt(2*pi*k)*x*(cos(k*x^2)*fresnelc(sqrt(x^2-b^2)*sqrt(2*k/pi))+sin(k*x^2)*fresnels(sqrt(x^2-b^2)*sqrt(2*k/pi))))",
    force: "piecewise(0, a<b, 2*E*h*(sqrt(2*pi*k)*a^2*(cos(k*a^2)*fresnelc(sqrt(a^2-b^2)*sqrt(2*k/pi))+sin(k*a^2)*fresnels(sqrt(a^2-b^2)*sqrt(2*k/pi)))\
            -sqrt(pi/(2*k))*(sin(k*a^2)*fresnelc(sqrt(a^2-b^2)*sqrt(2*k/pi))-cos(k*a^2)*fresnels(sqrt(a^2-b^2)*sqrt(2*k/pi)))+sin(k*b^2)*sqrt(a^2-b^2)))",
    pressure: None,
    parameters: &[
        Parameter { name: "h", lowest: 0.1, highest: 2.0 },
        Parameter { name: "k", lowest: 0.2, highest: 1.0 },
        Parameter { name: "b", lowest: 0.2, highest: 1.5 },
    ],
    guard: "f′ = c r^m sin(kr²) or c r^m cos(kr²) on [b, c), odd m ≥ 1",
    reference: &["general formula, Popov & Heß (3.27)", "wear rule for even profiles"],
    specializes: None,
    apply: segment,
};

/// c, √k and whether the function is a sine, for c·r^m·cos(kr²) or c·r^m·sin(kr²).
fn read(part: &NormalTerm) -> Option<(Expr, Expr, bool)> {
    let (argument, sine) = match (reading::call(&part.kernel, "cos"), reading::call(&part.kernel, "sin")) {
        (Some([u]), _) => (u, false),
        (_, Some([u])) => (u, true),
        _ => return None,
    };
    let (k, negative) = moments::argument(argument, 2)?;
    let coefficient = if negative && sine { -&part.coefficient } else { part.coefficient.clone() };
    Some((coefficient, k.sqrt(), sine))
}

/// On the whole axis, with y = √k·r.
fn whole(term: &Term) -> Option<Answer> {
    let (part, m) = moments::whole(term)?;
    let (coefficient, scale, sine) = read(part)?;
    let moment = |m: i64| moment(m, sine, false);
    let members = |m: i64, y: &Expr| if m % 2 == 0 { even_members(y) } else { odd_members(y) };
    let apart = m % 2 == 1;
    Some(moments::answer(&coefficient, m, &Moments { scale, moment: &moment, members: &members, shown: &members, apart }))
}

/// On [b, c), for odd m.
fn segment(term: &Term) -> Option<Answer> {
    let part = term.single()?;
    let m = moments::exponent(part).filter(|m| m % 2 == 1 && !term.segment.is_whole())?;
    let (coefficient, scale, sine) = read(part)?;
    let from = |order: i64, factor: &Expr, at: &Expr, begin: &Expr| {
        let factor = &coefficient * scale.power(-order) * factor;
        let y = &scale * at;
        if begin.is_zero() {
            return moment(order, sine, false).written_apart(&factor, &y, &odd_members(&y));
        }
        let beta = &scale * begin;
        let v = &scale * (at.power(2) - begin.power(2)).sqrt();
        let [cosine, own] = ["cos", "sin"].map(|name| Expr::call(name, [beta.power(2)]));
        let edges = (0..order / 2).flat_map(|j| [&cosine, &own].map(|wave| member(Expr::one(), wave * &v * beta.power(2 * j))));
        let members: Vec<Member> = fresnel_members(&y, &v).into_iter().chain(edges).collect();
        moment(order, sine, true).written_apart(&factor, &y, &members)
    };
    let branches =
        |order: i64, factor: &Expr, at: &Expr| Branches::from_ends(&term.segment, |end| Pair::same(from(order, factor, at, end)));
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    Some(Answer { equivalent: branches(m, &x, &x), force: branches(m + 2, &Expr::one(), &a), pressure: None, conditions: Vec::new() })
}

/// Real or imaginary part of J_m = ∫ u^m e^(iu²)/√(y²−u²) du, from J_0 and J_2 or J_1 by
/// 2i J_(p+3) = (2i y² − p − 1) J_(p+1) + p y² J_(p−1) + β^p √(y²−β²) e^(iβ²) with the lower end β, which is 0 or,
/// on a segment, is part of the functions.
fn moment(m: i64, imaginary: bool, segment: bool) -> Combination {
    let single = Combination::single;
    let pair = |position| (single(position, 1, 1, 0), single(position + 1, 1, 1, 0));
    // e^(iz) J_0(z) and e^(iz) J_1(z) at z = y²/2 for even m, ∫ e^(i(y²−u²)) du for odd m.
    let (mut before, mut own) = if m % 2 == 0 {
        let second = (single(0, 1, 2, 2).plus(&single(3, -1, 2, 2)), single(1, 1, 2, 2).plus(&single(2, 1, 2, 2)));
        (pair(0), second)
    } else {
        (<(Combination, Combination)>::default(), pair(0))
    };
    if m == 0 {
        std::mem::swap(&mut before, &mut own);
    }
    for p in (1 - m % 2..m - 2).step_by(2) {
        let half = |outer: &Combination, own: &Combination, before: &Combination| {
            outer.scaled(1, 1, 2).plus(&own.scaled(-p - 1, 2, 0)).plus(&before.scaled(p, 2, 2))
        };
        // Division by 2i turns (u + iv) into (v − iu)/2.
        let mut real = half(&own.0, &own.1, &before.1);
        let mut other = half(&own.1, &own.0.scaled(-1, 1, 0), &before.0.scaled(-1, 1, 0));
        if segment {
            let edge = pair(2 + p as usize);
            real = real.plus(&edge.1.scaled(1, 2, 0));
            other = other.minus(&edge.0.scaled(1, 2, 0));
        } else if p == 0 {
            other = other.minus(&single(2, 1, 2, 1));
        }
        before = std::mem::replace(&mut own, (real, other));
    }
    if imaginary { own.1 } else { own.0 }
}

/// Cosine and sine of z times J_0 and J_1 of z = y²/2, with the factor π/2 of every moment.
fn even_members(y: &Expr) -> Vec<Member> {
    let z = y.power(2) / Expr::integer(2);
    let [cosine, sine] = ["cos", "sin"].map(|name| Expr::call(name, [z.clone()]));
    let [zero, one] = [0, 1].map(|order| Expr::call("besselj", [Expr::integer(order), z.clone()]));
    let half_pi = Expr::pi() / Expr::integer(2);
    [&cosine * &zero, sine.clone() * zero, cosine * &one, sine * one].map(|function| member(half_pi.clone(), function)).into()
}

fn odd_members(y: &Expr) -> Vec<Member> {
    let mut members = fresnel_members(y, y);
    members.push(member(Expr::one(), Expr::one()));
    members
}

/// Real and imaginary part of e^(iy²) ∫₀^v e^(−iu²) du, with ∫₀^v cos u² du = √(π/2) fresnelc(v √(2/π)).
fn fresnel_members(y: &Expr, v: &Expr) -> Vec<Member> {
    let half_pi = Expr::pi() / Expr::integer(2);
    let [cosine, sine] = ["cos", "sin"].map(|name| Expr::call(name, [y.power(2)]));
    let [c, s] = ["fresnelc", "fresnels"].map(|name| Expr::call(name, [v / half_pi.sqrt()]));
    [&cosine * &c + &sine * &s, sine * c - cosine * s].map(|function| member(half_pi.sqrt(), function)).into()
}
