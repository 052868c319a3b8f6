//! Odd powers of r times ln(1 ± r/w), on the whole axis and on segments.

use super::combination::{Combination, Form};
use super::linear::branches;
use super::pole::{Pole, Reach};
use super::reading;
use crate::derive::rule::{Answer, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::Expr;

pub(super) static RULE: Rule = Rule {
    id: "log-linear",
    title: "Power times logarithm of a linear function",
    pattern: "C*((r^2-w^2)*ln(1+r/w)-r^2/2+w*r)",
    equivalent: "2*C*x*((x^2-w^2)*elliprc(x^2,w^2)-x+pi*w/2)",
    force: "4*E*C*((2*a^4-w^2*a^2-w^4)/3*elliprc(a^2,w^2)-a/9*(5*a^2+3*w^2)+pi*w/12*(3*a^2+2*w^2))",
    pressure: None,
    parameters: &[Parameter { name: "C", lowest: 0.1, highest: 4.0 }, Parameter { name: "w", lowest: 0.3, highest: 4.0 }],
    guard: "f′ = c·r^m·ln(1 ± r/w) with odd m ≥ 1, w ± r > 0",
    reference: &["integration by parts", "DLMF 19.2.17 (R_C)"],
    specializes: None,
    apply,
};

/// Exponents beyond this one fill pages.
const HIGHEST: i64 = 41;

fn apply(term: &Term) -> Option<Answer> {
    let part = term.single()?;
    let m = part.exponent.as_integer().filter(|m| (1..=HIGHEST).contains(m) && m % 2 == 1)?;
    let argument = reading::call(&part.kernel, "ln")?.first()?;
    let (alpha, beta) = reading::linear(argument)?;
    let (pole, conditions) = Pole::new(&alpha, &beta, false, &term.segment)?;
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    let branches = |m: i64, at: &Expr, factor: &Expr| {
        let part = |e: &Expr, reach: Reach, form: Form| {
            let [root, arc, integral, _] = pole.basis(e, at, reach, form);
            let logarithm = Expr::call("ln", [&alpha + &beta * e]);
            let boundary = &root * logarithm;
            moment(&pole, m, e, at, reach, form).over(&[root, arc, integral, Expr::zero(), boundary])
        };
        branches(&term.segment.lower, term.segment.upper.as_ref(), factor, part)
    };
    let c = &part.coefficient;
    Some(Answer { equivalent: branches(m, &x, &(c * &x)), force: branches(m + 2, &a, c), pressure: None, conditions })
}

/// m Λ_m = (m−1) x² Λ_(m−2) + √(x²−e²) e^(m−1) ln q(e) + x² R_(m−1) − R_(m+1), R_j = ∫ r^j q′/q/√(x²−r²) dr.
fn moment(pole: &Pole, m: i64, e: &Expr, x: &Expr, reach: Reach, form: Form) -> Combination {
    let square = x.power(2);
    // q′/q = 1/(w + r) or −1/(w − r)
    let orientation = Expr::integer(if pole.above { -1 } else { 1 });
    let quotient = |j: i64| pole.moment(j, 1, e, x, reach, form).times(&orientation).extended();
    let mut log = Combination::zero(5);
    for n in (1..=m).step_by(2) {
        let boundary = if n == 1 { Expr::one() } else { e.power(n - 1) };
        let sum = log.times(&(Expr::integer(n - 1) * &square)).plus(&Combination::unit(4, 5).times(&boundary));
        let sum = sum.plus(&quotient(n - 1).times(&square)).plus(&quotient(n + 1).times(&Expr::integer(-1)));
        log = sum.times(&Expr::ratio(1, n)).tidied();
    }
    log
}
