//! Sine and cosine of kr² times powers of r: Fresnel integrals for odd powers, Bessel functions for even ones.

use super::laurent::{Combination, Member, member};
use super::moments::{self, Moments};
use super::reading;
use crate::expr::Expr;
use crate::transform::{Answer, Parameter, Rule, Term};

pub(super) static RULE: Rule = Rule {
    id: "quadratic-wave",
    title: "Sine or cosine of the squared radius times a power",
    pattern: "A*sin(k*r^2)+C*(1-cos(k*r^2))",
    slope: "sqrt(2*pi*k)*x*(A*(cos(k*x^2)*fresnelc(x*sqrt(2*k/pi))+sin(k*x^2)*fresnels(x*sqrt(2*k/pi)))\
            +C*(sin(k*x^2)*fresnelc(x*sqrt(2*k/pi))-cos(k*x^2)*fresnels(x*sqrt(2*k/pi))))",
    force: "2*E*(A*(sqrt(2*pi*k)*a^2*(cos(k*a^2)*fresnelc(a*sqrt(2*k/pi))+sin(k*a^2)*fresnels(a*sqrt(2*k/pi)))\
            -sqrt(pi/(2*k))*(sin(k*a^2)*fresnelc(a*sqrt(2*k/pi))-cos(k*a^2)*fresnels(a*sqrt(2*k/pi))))\
            +C*(sqrt(2*pi*k)*a^2*(sin(k*a^2)*fresnelc(a*sqrt(2*k/pi))-cos(k*a^2)*fresnels(a*sqrt(2*k/pi)))\
            +sqrt(pi/(2*k))*(cos(k*a^2)*fresnelc(a*sqrt(2*k/pi))+sin(k*a^2)*fresnels(a*sqrt(2*k/pi)))-a))",
    pressure: None,
    parameters: &[
        Parameter { name: "A", lowest: 0.1, highest: 2.0 },
        Parameter { name: "C", lowest: 0.1, highest: 2.0 },
        Parameter { name: "k", lowest: 0.2, highest: 1.0 },
    ],
    guard: "f′ = c r^m sin(kr²) or c r^m cos(kr²), whole m ≥ 0",
    reference: &["general formula, Popov & Heß (3.27)", "DLMF 7.2(iii) and 10.9.1"],
    specializes: None,
    apply,
};

/// f′ = c·r^m·cos(kr²) or c·r^m·sin(kr²), with y = √k·r.
fn apply(term: &Term) -> Option<Answer> {
    let (part, m) = moments::whole(term)?;
    let (argument, sine) = match (reading::call(&part.kernel, "cos"), reading::call(&part.kernel, "sin")) {
        (Some([u]), _) => (u, false),
        (_, Some([u])) => (u, true),
        _ => return None,
    };
    let (k, negative) = moments::argument(argument, 2)?;
    let coefficient = if negative && sine { -&part.coefficient } else { part.coefficient.clone() };
    let moment = |m: i64| {
        let (cosine, own) = moment(m);
        if sine { own } else { cosine }
    };
    Some(moments::answer(
        &coefficient,
        m,
        &Moments { scale: k.sqrt(), moment: &moment, members: &members, shown: &members, apart: m % 2 == 1 },
    ))
}

/// J_m = ∫₀^y u^m e^(iu²)/√(y²−u²) du as real and imaginary part, from J_0 and J_2 or J_1 by
/// 2i J_(p+3) = (2i y² − p − 1) J_(p+1) + p y² J_(p−1), with y added for p = 0.
fn moment(m: i64) -> (Combination, Combination) {
    let single = Combination::single;
    // e^(iz) J_0(z) and e^(iz) J_1(z) at z = y²/2 for even m, ∫₀^y e^(i(y²−u²)) du for odd m.
    let (mut before, mut own) = if m % 2 == 0 {
        let second = (single(0, 1, 2, 2).plus(&single(3, -1, 2, 2)), single(1, 1, 2, 2).plus(&single(2, 1, 2, 2)));
        ((single(0, 1, 1, 0), single(1, 1, 1, 0)), second)
    } else {
        (<(Combination, Combination)>::default(), (single(0, 1, 1, 0), single(1, 1, 1, 0)))
    };
    if m == 0 {
        return before;
    }
    let first = 2 - m % 2;
    for p in (first - 1..m - 2).step_by(2) {
        let half = |outer: &Combination, own: &Combination, before: &Combination| {
            outer.scaled(1, 1, 2).plus(&own.scaled(-p - 1, 2, 0)).plus(&before.scaled(p, 2, 2))
        };
        // Division by 2i turns (u + iv) into (v − iu)/2.
        let extra = if p == 0 { single(2, 1, 2, 1) } else { Combination::default() };
        let real = half(&own.0, &own.1, &before.1);
        let imaginary = half(&own.1, &own.0.scaled(-1, 1, 0), &before.0.scaled(-1, 1, 0)).minus(&extra);
        before = std::mem::replace(&mut own, (real, imaginary));
    }
    own
}

/// The functions of the moments at y = √k·x.
fn members(m: i64, y: &Expr) -> Vec<Member> {
    let square = y.power(2);
    let circular = ["cos", "sin"].map(|name| Expr::call(name, [if m % 2 == 0 { &square / Expr::integer(2) } else { square.clone() }]));
    let [cosine, sine] = &circular;
    let half_pi = Expr::pi() / Expr::integer(2);
    if m % 2 == 0 {
        let bessel = |order: i64| Expr::call("besselj", [Expr::integer(order), &square / Expr::integer(2)]);
        return [cosine * bessel(0), sine * bessel(0), cosine * bessel(1), sine * bessel(1)]
            .map(|function| member(half_pi.clone(), function))
            .into();
    }
    // ∫₀^y cos u² du = √(π/2) fresnelc(y √(2/π))
    let fresnel = ["fresnelc", "fresnels"].map(|name| Expr::call(name, [y * half_pi.recip().sqrt()]));
    let [c, s] = &fresnel;
    let root = half_pi.sqrt();
    vec![member(root.clone(), cosine * c + sine * s), member(root, sine * c - cosine * s), member(Expr::one(), Expr::one())]
}
