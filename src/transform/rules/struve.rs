//! What the transform of sines and exponentials leads back to: Struve functions of kr, and Bessel functions of kr in pairs.

use super::laurent::{Combination, Law, member};
use super::moments::{self, Moments};
use super::reading;
use crate::expr::{Expr, Node};
use crate::transform::{Answer, Branches, Pair, Parameter, Rule, Term};

const HEIGHT: Parameter = Parameter { name: "h", lowest: 0.1, highest: 2.0 };
const WAVENUMBER: Parameter = Parameter { name: "k", lowest: 0.3, highest: 1.5 };
const GENERAL: &[&str] = &["general formula, Popov & Heß (3.27)"];

pub(super) static STRUVE: Rule = Rule {
    id: "struve",
    title: "Struve function times a power",
    pattern: "h*(2/pi*k*r-struveh(0,k*r))",
    slope: "h*(k*x-sin(k*x))",
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
    slope: "h*(sinh(k*x)-k*x)",
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
    title: "Square of the Bessel function of order 0",
    pattern: "h*(1-besselj(0,k*r)^2)",
    slope: "h*(1-besselj(0,2*k*x))",
    force: "pi*E*h*a*(besselj(1,2*k*a)*struveh(0,2*k*a)-besselj(0,2*k*a)*struveh(1,2*k*a))",
    pressure: None,
    parameters: &[HEIGHT, WAVENUMBER],
    guard: "f′ = c J_0(kr) J_1(kr)",
    reference: GENERAL,
    specializes: None,
    apply: |term| square(term, &Kind::FIRST),
};

pub(super) static MODIFIED_BESSEL_SQUARE: Rule = Rule {
    id: "modified-bessel-square",
    title: "Square of the modified Bessel function of order 0",
    pattern: "h*(besseli(0,k*r)^2-1)",
    slope: "h*(besseli(0,2*k*x)-1)",
    force: "pi*E*h*a*(besseli(1,2*k*a)*struvel(0,2*k*a)-besseli(0,2*k*a)*struvel(1,2*k*a))",
    pressure: None,
    parameters: &[HEIGHT, WAVENUMBER],
    guard: "f′ = c I_0(kr) I_1(kr)",
    reference: GENERAL,
    specializes: None,
    apply: |term| square(term, &Kind::MODIFIED),
};

/// Either kind: names, and the sign ε of B_0′ = ε B_1.
struct Kind {
    bessel: &'static str,
    struve: &'static str,
    sine: &'static str,
    cosine: &'static str,
    epsilon: i64,
}

impl Kind {
    const FIRST: Self = Self { bessel: "besselj", struve: "struveh", sine: "sin", cosine: "cos", epsilon: -1 };
    const MODIFIED: Self = Self { bessel: "besseli", struve: "struvel", sine: "sinh", cosine: "cosh", epsilon: 1 };
}

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

/// f′ = c·B_0(kr) B_1(kr): g = c (B_0(2kx) − 1)/(2εk), F/(2E*) = c πa/(4k) (B_1 S_0 − B_0 S_1)(2ka).
fn square(term: &Term, kind: &Kind) -> Option<Answer> {
    let (part, m) = moments::whole(term)?;
    let Node::Product(factors) = part.kernel.node() else { return None };
    let [first, second] = factors.as_slice() else { return None };
    let ([zero, u], [one, v]) = (reading::call(first, kind.bessel)?, reading::call(second, kind.bessel)?) else { return None };
    if m != 0 || u != v || !(zero.is_zero() && one.is_one() || one.is_zero() && zero.is_one()) {
        return None;
    }
    let (k, negative) = moments::wavenumber(u)?;
    let coefficient = if negative { -&part.coefficient } else { part.coefficient.clone() };
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    let own = |name, order: i64, at: &Expr| Expr::call(name, [Expr::integer(order), Expr::integer(2) * &k * at]);
    let rise = (own(kind.bessel, 0, &x) - Expr::one()) * Expr::integer(kind.epsilon);
    let slope = &coefficient / (Expr::integer(2) * &k) * rise;
    let cross = own(kind.bessel, 1, &a) * own(kind.struve, 0, &a) - own(kind.bessel, 0, &a) * own(kind.struve, 1, &a);
    let force = coefficient * Expr::pi() * a / (Expr::integer(4) * k) * cross;
    let same = |expr| Branches::endless(Pair::same(expr));
    Some(Answer { slope: same(slope), force: same(force), pressure: None, conditions: Vec::new() })
}
