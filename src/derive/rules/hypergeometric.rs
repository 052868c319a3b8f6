//! The general rule: r^m times a kernel whose power series is hypergeometric, on the whole axis.

use super::series::Series;
use super::{power, reading};
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::Expr;

pub(super) static RULE: Rule = Rule {
    id: "hypergeometric",
    title: "Power times a hypergeometric kernel",
    pattern: "h*(1-(1-r^4/R^4)^p)",
    equivalent: "h*(1-hyper([-p,1/2,1],[1/4,3/4],x^4/R^4))",
    force: "2*E*h*a*(hyper([-p,1/2,1],[3/4,5/4],a^4/R^4)-hyper([-p,1/2,1],[1/4,3/4],a^4/R^4))",
    pressure: None,
    parameters: &[
        Parameter { name: "h", lowest: 0.1, highest: 4.0 },
        Parameter { name: "R", lowest: 3.4, highest: 6.0 },
        Parameter { name: "p", lowest: 0.2, highest: 3.0 },
    ],
    guard: "f′ = c·r^m·K(z r^α), m > −1, with K = pFq and rational α; asked where no other rule answers",
    reference: &["Popov & Heß (3.14)–(3.17) term by term", "DLMF 16.2.1"],
    specializes: None,
    apply,
};

fn apply(term: &Term) -> Option<Answer> {
    let part = term.single()?;
    if !term.segment.is_whole() || part.kernel.is_one() {
        return None;
    }
    let series = Series::of(&part.kernel)?;
    let exponent = &part.exponent + &series.offset;
    let n = &exponent + Expr::one();
    let mut conditions = series.conditions.clone();
    conditions.extend(reading::positive(&n)?);
    let c = &part.coefficient * &series.factor;
    let parts = series.with_even_step()?;
    let transformed = |shift: i64, at: &Expr, factor: &Expr| {
        let terms = parts.iter().map(|part| {
            // ∫₀^x r^m/√(x²−r²) dr = x^m κ_(m+1)/(m+1), and its ratio from term to term.
            let n = &exponent + &part.offset + Expr::integer(1 + shift);
            let weight = power::kappa(&n) / &n * at.pow(&(&n - Expr::one()));
            factor * weight * part.transformed(&n, at)
        });
        Branches::endless(Pair::same(Expr::sum(terms.collect::<Vec<_>>())))
    };
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    Some(Answer { equivalent: transformed(0, &x, &(&c * &x)), force: transformed(2, &a, &c), pressure: None, conditions })
}
