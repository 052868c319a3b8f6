//! What the transform of sines and exponentials leads back to: Struve functions of kr, and Bessel functions of kr in pairs.

use super::bessel::Kind;
use super::laurent::{Combination, Law, member};
use super::moments::{self, Moments};
use super::reading;
use crate::derive::rule::{Answer, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::Expr;

const HEIGHT: Parameter = Parameter { name: "h", lowest: 0.1, highest: 2.0 };
const WAVENUMBER: Parameter = Parameter { name: "k", lowest: 0.3, highest: 1.5 };
const GENERAL: &[&str] = &["general formula, Popov & Heß (3.27)"];

pub(super) static STRUVE: Rule = Rule {
    id: "struve",
    title: "Struve function times a power",
    pattern: "h*(2/pi*k*r-struveh(0,k*r))",
    equivalent: "h*(k*x-sin(k*x))",
    force: "2*E*h*(k*a^2/2-a*sin(k*a)+(1-cos(k*a))/k)",
    pressure: None,
    parameters: &[HEIGHT, WAVENUMBER],
    guard: "f′ = c r^m H_n(kr), n = 0 or 1, whole m ≥ 0, m + n odd",
    reference: GENERAL,
    specializes: None,
    apply: |term| struve(term, &Kind::FIRST),
};

pub(super) static MODIFIED_STRUVE: Rule = Rule {
    id: "modified-struve",
    title: "Modified Struve function times a power",
    pattern: "h*(struvel(0,k*r)-2/pi*k*r)",
    equivalent: "h*(sinh(k*x)-k*x)",
    force: "2*E*h*(a*sinh(k*a)-(cosh(k*a)-1)/k-k*a^2/2)",
    pressure: None,
    parameters: &[HEIGHT, WAVENUMBER],
    guard: "f′ = c r^m L_n(kr), n = 0 or 1, whole m ≥ 0, m + n odd",
    reference: GENERAL,
    specializes: None,
    apply: |term| struve(term, &Kind::MODIFIED),
};

pub(super) static BESSEL_SQUARE: Rule = Rule {
    id: "bessel-square",
    title: "Square of a Bessel function",
    pattern: "h*(1-besselj(0,k*r)^2)",
    equivalent: "h*(1-besselj(0,2*k*x))",
    force: "pi*E*h*a*(besselj(1,2*k*a)*struveh(0,2*k*a)-besselj(0,2*k*a)*struveh(1,2*k*a))",
    pressure: None,
    parameters: &[HEIGHT, WAVENUMBER],
    guard: "f′ = c J_n(kr) J_(n+1)(kr), whole n ≥ 0",
    reference: GENERAL,
    specializes: None,
    apply: |term| square(term, &Kind::FIRST),
};

pub(super) static MODIFIED_BESSEL_SQUARE: Rule = Rule {
    id: "modified-bessel-square",
    title: "Square of a modified Bessel function",
    pattern: "h*(besseli(0,k*r)^2-1)",
    equivalent: "h*(besseli(0,2*k*x)-1)",
    force: "pi*E*h*a*(besseli(1,2*k*a)*struvel(0,2*k*a)-besseli(0,2*k*a)*struvel(1,2*k*a))",
    pressure: None,
    parameters: &[HEIGHT, WAVENUMBER],
    guard: "f′ = c I_n(kr) I_(n+1)(kr), whole n ≥ 0",
    reference: GENERAL,
    specializes: None,
    apply: |term| square(term, &Kind::MODIFIED),
};

/// f′ = c·r^m·H_n(kr) with m + n odd, or L_n.
fn struve(term: &Term, kind: &Kind) -> Option<Answer> {
    let (part, m) = moments::whole(term)?;
    let [order, argument] = reading::call(&part.kernel, kind.struve)? else { return None };
    let n = order.as_integer().filter(|n| (0..=1).contains(n) && (m + n) % 2 == 1)?;
    let (scale, negative) = moments::wavenumber(argument)?;
    // H_n(−z) = (−1)^(n+1) H_n(z), and the same for L.
    let coefficient = if negative && n == 0 { -&part.coefficient } else { part.coefficient.clone() };
    let moment = |m: i64| struve_moment(m, kind);
    let members = |_: i64, y: &Expr| {
        let [sine, cosine] = [kind.sine, kind.cosine].map(|name| Expr::call(name, [y.clone()]));
        [sine, cosine, Expr::one()].map(|function| member(Expr::one(), function)).into()
    };
    Some(moments::answer(&coefficient, m, &Moments { scale, moment: &moment, members: &members, shown: &members, apart: true }))
}

/// y^m W_(m,n) with n = 1 for even m, else 0, over sine, cosine and 1: W_(0,1) = ε(S/y − 1),
/// W_(m+1,0) = W_(m,1)′ + W_(m,1)/y and W_(m+1,1) = ε(W_(m,0)′ − m!!/(m+1)!!).
fn struve_moment(m: i64, kind: &Kind) -> Combination {
    let e = kind.epsilon;
    let single = Combination::single;
    let law: Law = vec![single(1, 1, 1, 0), single(0, e, 1, 0), Combination::default()];
    let mut moment = single(0, e, 1, -1).plus(&single(2, -e, 1, 0));
    let mut wallis = single(2, 1, 1, 0);
    for order in 1..=m {
        let slope = moment.derivative(&law);
        moment = if order % 2 == 1 {
            slope.plus(&moment.scaled(1, 1, -1))
        } else {
            wallis = wallis.scaled(order - 1, order, 0);
            slope.minus(&wallis).scaled(e, 1, 0)
        };
    }
    moment.scaled(1, 1, m)
}

/// f′ = c·B_n(kr) B_(n+1)(kr): B_n² has the transform B_2n(2kx).
fn square(term: &Term, kind: &Kind) -> Option<Answer> {
    let (part, m) = moments::whole(term).filter(|(_, m)| *m == 0)?;
    let (first, second) = reading::pair(&part.kernel)?;
    let ([one, u], [other, v]) = (reading::call(first, kind.bessel)?, reading::call(second, kind.bessel)?) else { return None };
    let (one, other) = (one.as_integer()?, other.as_integer()?);
    let n = one.min(other);
    if u != v || (one - other).abs() != 1 || !(0..=moments::HIGHEST).contains(&n) {
        return None;
    }
    let (scale, negative) = moments::wavenumber(u)?;
    let coefficient = if negative { -&part.coefficient } else { part.coefficient.clone() };
    let moment = |m: i64| if m == 0 { first_pair(n, kind) } else { second_pair(n, kind) };
    let members = |m: i64, y: &Expr| {
        let call = |name, order: i64| Expr::call(name, [Expr::integer(order), Expr::integer(2) * y]);
        let cross = || call(kind.bessel, 1) * call(kind.struve, 0) - call(kind.bessel, 0) * call(kind.struve, 1);
        let alone = if m == 0 { member(Expr::one(), Expr::one()) } else { member(Expr::pi() / Expr::integer(2), cross()) };
        std::iter::once(alone).chain((0..=2 * n).map(|order| member(Expr::one(), call(kind.bessel, order)))).collect()
    };
    Some(moments::answer(&coefficient, m, &Moments { scale, moment: &moment, members: &members, shown: &members, apart: true }))
}

/// ∫₀^(π/2) B_n B_(n+1) dt at y sin t over 1, B_0(2y), B_1(2y), …: from n − 1 by B_n² ↦ B_2n(2y).
fn first_pair(n: i64, kind: &Kind) -> Combination {
    let (e, single) = (kind.epsilon, Combination::single);
    let mut moment = single(1, e, 2, -1).plus(&single(0, -e, 2, -1));
    for i in 1..=n {
        moment = moment.minus(&single(1 + 2 * i as usize, 1, 1, -1)).scaled(-e, 1, 0);
    }
    moment
}

/// The same with y² sin² t, over (π/2)(B_1 S_0 − B_0 S_1)(2y), B_0(2y), B_1(2y), …, with the Struve function S:
/// from n − 1 by ∫ t dB_2n = t B_2n − Λ_2n, Λ_2n = ∫₀^2y B_2n dt = ε(2 B_(2n−1) − Λ_(2n−2)).
fn second_pair(n: i64, kind: &Kind) -> Combination {
    let (e, single) = (kind.epsilon, Combination::single);
    let bessel = |order: i64, p: i64, j: i64| single(1 + order as usize, p, 1, j);
    let mut moment = single(0, 1, 2, 1);
    let mut integral = bessel(0, 2, 1).plus(&single(0, -2 * e, 1, 1));
    for i in 1..=n {
        integral = bessel(2 * i - 1, 2, 0).minus(&integral).scaled(e, 1, 0);
        moment = bessel(2 * i, 1, 1).minus(&integral.scaled(1, 2, 0)).minus(&moment).scaled(e, 1, 0);
    }
    moment
}
