//! Bessel functions of kr times powers of r: squares of Bessel functions of half the order at kx/2, elementary where that order is half.

use super::laurent::{Combination, Laurent, Law, Member, member};
use super::moments::{self, Moments};
use super::reading;
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::{Expr, Symbol};

const PARAMETERS: &[Parameter] = &[
    Parameter { name: "A", lowest: 0.1, highest: 2.0 },
    Parameter { name: "C", lowest: 0.1, highest: 2.0 },
    Parameter { name: "k", lowest: 0.3, highest: 2.0 },
];

pub(super) static FIRST_KIND: Rule = Rule {
    id: "bessel",
    title: "Bessel function of the first kind times a power",
    pattern: "A*(1-besselj(0,k*r))+C*besselj(1,k*r)",
    equivalent: "A*(1-cos(k*x))+C*pi/4*k*x*(besselj(0,k*x/2)^2-besselj(1,k*x/2)^2)",
    force: "2*E*(A*(sin(k*a)/k-a*cos(k*a))+C*pi/4*a*(k*a*(besselj(0,k*a/2)^2-besselj(1,k*a/2)^2)-2*besselj(0,k*a/2)*besselj(1,k*a/2)))",
    pressure: None,
    parameters: PARAMETERS,
    guard: "f′ = c r^m J_n(kr), whole n and m ≥ 0; any order μ > −1 − m for m = 0 and −1",
    reference: &["general formula, Popov & Heß (3.27)", "Watson, Theory of Bessel functions, 5.43"],
    specializes: None,
    apply: |term| apply(term, &Kind::FIRST),
};

pub(super) static MODIFIED: Rule = Rule {
    id: "modified-bessel",
    title: "Modified Bessel function times a power",
    pattern: "A*(besseli(0,k*r)-1)+C*besseli(1,k*r)",
    equivalent: "A*(cosh(k*x)-1)+C*pi/4*k*x*(besseli(0,k*x/2)^2+besseli(1,k*x/2)^2)",
    force: "2*E*(A*(a*cosh(k*a)-sinh(k*a)/k)+C*pi/4*a*(k*a*(besseli(0,k*a/2)^2+besseli(1,k*a/2)^2)-2*besseli(0,k*a/2)*besseli(1,k*a/2)))",
    pressure: None,
    parameters: PARAMETERS,
    guard: "f′ = c r^m I_n(kr), whole n and m ≥ 0; any order μ > −1 − m for m = 0 and −1",
    reference: &["general formula, Popov & Heß (3.27)", "Watson, Theory of Bessel functions, 5.43"],
    specializes: None,
    apply: |term| apply(term, &Kind::MODIFIED),
};

/// Either kind: its functions, those that half orders end in, and the sign ε of B_0′ = ε B_1.
pub(super) struct Kind {
    pub(super) bessel: &'static str,
    pub(super) struve: &'static str,
    pub(super) sine: &'static str,
    pub(super) cosine: &'static str,
    pub(super) epsilon: i64,
}

impl Kind {
    pub(super) const FIRST: Self = Self { bessel: "besselj", struve: "struveh", sine: "sin", cosine: "cos", epsilon: -1 };
    pub(super) const MODIFIED: Self = Self { bessel: "besseli", struve: "struvel", sine: "sinh", cosine: "cosh", epsilon: 1 };
}

/// f′ = c·r^m·B_n(kr).
fn apply(term: &Term, kind: &Kind) -> Option<Answer> {
    let part = term.single().filter(|_| term.segment.is_whole())?;
    let [order, argument] = reading::call(&part.kernel, kind.bessel)? else { return None };
    let (m, whole) = (part.exponent.as_integer()?, order.as_integer());
    if order.contains(&Symbol::new("r")) {
        return None;
    }
    if m == -1 || m == 0 && whole.is_none() {
        let (k, _) = moments::argument(argument, 1).filter(|(_, negative)| !negative)?;
        return any_order(&part.coefficient, m, order, &k, kind);
    }
    let (k, negative) = moments::wavenumber(argument)?;
    let (m, n) = (moments::exponent(part)?, whole.filter(|n| (-moments::HIGHEST..=moments::HIGHEST).contains(n))?);
    // J_(−n) = (−1)^n J_n, I_(−n) = I_n, and both kinds are odd for odd n.
    let flips = n % 2 != 0 && (negative != (n < 0 && kind.epsilon < 0));
    let coefficient = if flips { -&part.coefficient } else { part.coefficient.clone() };
    let n = n.abs();
    let moment = |m: i64| moment(m, n, kind);
    let members = |m: i64, y: &Expr| members(lowest_order(m, n), kind, y);
    Some(moments::answer(&coefficient, m, &Moments { scale: k, moment: &moment, members: &members, shown: &members, apart: false }))
}

/// Where n ends after m steps down, turning at 0.
fn lowest_order(m: i64, n: i64) -> i64 {
    if n >= m { n - m } else { (m + n) % 2 }
}

/// y^m W_(m,n) with W_(m,n) = ∫₀^(π/2) sin^m t B_n(y sin t) dt, from W_(0,n) = (π/2) B_(n/2)(y/2)² by
/// W_(m,n+1) = ε(W′ − (n/y) W) and W_(m,n−1) = W′ + (n/y) W of W = W_(m−1,n).
fn moment(m: i64, n: i64, kind: &Kind) -> Combination {
    let law = law(lowest_order(m, n), kind);
    let mut path = vec![n];
    let mut order = n;
    for _ in 0..m {
        order = if order > 0 { order - 1 } else { 1 };
        path.push(order);
    }
    let mut moment = base(order, kind);
    for pair in path.windows(2).rev() {
        let [next, own] = pair else { continue };
        let (slope, rest) = (moment.derivative(&law), moment.scaled(*own, 1, -1));
        moment = if next > own { slope.minus(&rest).scaled(kind.epsilon, 1, 0) } else { slope.plus(&rest) };
    }
    moment.scaled(1, 1, m)
}

/// W_(0,n): the square itself for even n; for odd n by B_(−1/2) = C√(2/πz), B_(1/2) = S√(2/πz) at z = y/2.
fn base(n: i64, kind: &Kind) -> Combination {
    if n % 2 == 0 {
        return Combination::single(0, 1, 1, 0);
    }
    // B_(n/2) = √(2/πz)·(p S + q C), by B_(ν+1) = ε(B_(ν−1) − (2ν/z) B_ν).
    let e = kind.epsilon;
    let (mut before, mut own) = ((Laurent::default(), Laurent::term(1, 1, 0)), (Laurent::term(1, 1, 0), Laurent::default()));
    for order in (1..n).step_by(2) {
        let step =
            |before: &Laurent, own: &Laurent| before.times(&Laurent::term(e, 1, 0)).plus(&own.times(&Laurent::term(-2 * e * order, 1, -1)));
        let next = (step(&before.0, &own.0), step(&before.1, &own.1));
        before = std::mem::replace(&mut own, next);
    }
    // With S² = ε(cos y − 1)/2, C² = (cos y + 1)/2, 2SC = sin y, times 1/z = 2/y.
    let (p, q) = own;
    let (pp, pq, qq) = (p.times(&p), p.times(&q), q.times(&q));
    let parts = [(0, pq, 2), (1, pp.clone(), e), (1, qq.clone(), 1), (2, pp, -e), (2, qq, 1)];
    parts
        .into_iter()
        .fold(Combination::default(), |sum, (position, part, factor)| sum.plus(&Combination::single(position, factor, 1, -1).times(&part)))
}

/// The functions of the moments: B_ν², B_ν B_(ν+1), B_(ν+1)² at y/2 with ν = n/2, for odd n sine, cosine and 1.
fn members(n: i64, kind: &Kind, y: &Expr) -> Vec<Member> {
    if n % 2 != 0 {
        return vec![
            member(Expr::one(), Expr::call(kind.sine, [y.clone()])),
            member(Expr::one(), Expr::call(kind.cosine, [y.clone()])),
            member(Expr::one(), Expr::one()),
        ];
    }
    let [own, next] = [n / 2, n / 2 + 1].map(|order| Expr::call(kind.bessel, [Expr::integer(order), y / Expr::integer(2)]));
    let half_pi = Expr::pi() / Expr::integer(2);
    [own.power(2), &own * &next, next.power(2)].map(|function| member(half_pi.clone(), function)).into()
}

/// From B_ν′ = (ν/z) B_ν + ε B_(ν+1) and B_(ν+1)′ = B_ν − ((ν+1)/z) B_(ν+1) at z = y/2; for odd n of sine and cosine.
fn law(n: i64, kind: &Kind) -> Law {
    let e = kind.epsilon;
    let single = Combination::single;
    if n % 2 != 0 {
        return vec![single(1, 1, 1, 0), single(0, e, 1, 0), Combination::default()];
    }
    vec![
        single(0, n, 1, -1).plus(&single(1, e, 1, 0)),
        single(0, 1, 2, 0).plus(&single(1, -1, 1, -1)).plus(&single(2, e, 2, 0)),
        single(1, 1, 1, 0).plus(&single(2, -n - 2, 1, -1)),
    ]
}

/// f′ = c·B_μ(kr) or c·B_μ(kr)/r of any order, with ν = μ/2 and z = kx/2: W_(0,μ) = (π/2) B_ν²,
/// W_(2,μ) = (π/4) [B_ν² + ε B_(ν+1)² + (2ν/z) B_ν B_(ν+1)], and with ν = (μ−1)/2
/// W_(−1,μ) = (πz/2μ) [B_ν² − ε B_(ν+1)²], W_(1,μ) = (π/2) B_ν B_(ν+1).
fn any_order(coefficient: &Expr, m: i64, order: &Expr, k: &Expr, kind: &Kind) -> Option<Answer> {
    let conditions = reading::positive(&(order + Expr::integer(m + 1)))?;
    let (x, a, two) = (Expr::symbol("x"), Expr::symbol("a"), Expr::integer(2));
    let own = order + Expr::integer(if m == 0 { 0 } else { -1 });
    let pair = |at: &Expr| [&own, &(&own + &two)].map(|twice| Expr::call(kind.bessel, [twice / &two, k * at / &two]));
    let epsilon = Expr::integer(kind.epsilon);
    let [first, second] = pair(&x);
    let equivalent = match m {
        0 => first.power(2) / &two,
        _ => k * (first.power(2) - &epsilon * second.power(2)) / (Expr::integer(4) * order),
    };
    let [first, second] = pair(&a);
    let force = match m {
        0 => (k * &a * (first.power(2) + &epsilon * second.power(2)) + &two * order * &first * &second) / (Expr::integer(4) * k),
        _ => &first * &second / &two,
    };
    let same = |factor: Expr, expr: Expr| Branches::endless(Pair::same(coefficient * Expr::pi() * factor * expr));
    Some(Answer { equivalent: same(x, equivalent), force: same(a, force), pressure: None, conditions })
}
