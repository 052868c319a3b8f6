//! exp(∓z) I_n(z) at z = r²/(2w²): what the inversion of a Gaussian leads to.

use super::laurent::{Combination, Member, member};
use super::moments::{self, Moments};
use super::reading;
use crate::derive::rule::{Answer, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::Expr;

pub(super) static RULE: Rule = Rule {
    id: "gaussian-bessel",
    title: "Gaussian times the modified Bessel function of the same argument",
    pattern: "h*(1-exp(-r^2/(2*w^2))*besseli(0,r^2/(2*w^2)))",
    equivalent: "h*(1-exp(-x^2/w^2))",
    force: "E*h*(sqrt(pi)*w*erf(a/w)-2*a*exp(-a^2/w^2))",
    pressure: None,
    parameters: &[Parameter { name: "h", lowest: 0.1, highest: 2.0 }, Parameter { name: "w", lowest: 0.5, highest: 3.0 }],
    guard: "f′ = c r^m exp(∓r²/(2w²)) I_n(r²/(2w²)), n = 0 or 1, odd m ≥ 1",
    reference: &["general formula, Popov & Heß (3.27)"],
    specializes: None,
    apply,
};

/// f′ = c·r^m·e^(∓z) I_n(z), z = κ²r²/2, y = κr.
fn apply(term: &Term) -> Option<Answer> {
    let (part, m) = moments::whole(term).filter(|(_, m)| m % 2 == 1)?;
    let (exponential, bessel) = reading::exponential_pair(&part.kernel)?;
    let ([u], [order, z]) = (reading::call(exponential, "exp")?, reading::call(bessel, "besseli")?) else { return None };
    let n = order.as_integer().filter(|n| (0..=1).contains(n))?;
    let ((own, decay), (half, false)) = (moments::argument(u, 2)?, moments::argument(z, 2)?) else { return None };
    if own != half {
        return None;
    }
    let moment = |m: i64| moment(m, n, if decay { 1 } else { -1 });
    let members = |_: i64, y: &Expr| members(y, decay);
    let scale = (Expr::integer(2) * half).sqrt();
    Some(moments::answer(&part.coefficient, m, &Moments { scale, moment: &moment, members: &members, shown: &members, apart: true }))
}

/// The moments over E = ∫₀^y e^(∓t²) dt, X = e^(∓y²) and 1: E for n = 0, ±E + (X − 1)/y for n = 1, then
/// M_(m+2) = y² M_m − ∫₀^y t M_m dt.
fn moment(m: i64, n: i64, sign: i64) -> Combination {
    let single = Combination::single;
    let mut moment = match n {
        0 => single(0, 1, 1, 0),
        _ => single(0, sign, 1, 0).plus(&single(1, 1, 1, -1)).plus(&single(2, -1, 1, -1)),
    };
    for _ in (1..m).step_by(2) {
        moment = moment.scaled(1, 1, 2).minus(&moment.scaled(1, 1, 1).integrated(&|position, j| integral(position, j, sign)));
    }
    moment
}

/// ∫₀^y t^j B dt for odd j before E, even j before X, any j before 1.
fn integral(position: usize, j: i64, sign: i64) -> Combination {
    let single = Combination::single;
    match position {
        0 => single(0, 1, j + 1, j + 1).minus(&integral(1, j + 1, sign).scaled(1, j + 1, 0)),
        1 if j <= 0 => single(0, 1, 1, 0),
        1 => integral(1, j - 2, sign).scaled(sign * (j - 1), 2, 0).minus(&single(1, sign, 2, j - 1)),
        _ => single(2, 1, j + 1, j + 1),
    }
}

fn members(y: &Expr, decay: bool) -> Vec<Member> {
    let (name, square) = if decay { ("erf", -y.power(2)) } else { ("erfi", y.power(2)) };
    vec![
        member(Expr::pi().sqrt() / Expr::integer(2), Expr::call(name, [y.clone()])),
        member(Expr::one(), Expr::call("exp", [square])),
        member(Expr::one(), Expr::one()),
    ]
}
