//! Powers of the distance to the segment's lower end: rounded edges of any order, without an upper end.

use super::{moments, power, reading};
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::{Expr, Sign, Symbol, normal, sign};

pub(super) static RULE: Rule = Rule {
    id: "shifted-power",
    title: "Power of the distance to a radius",
    pattern: "piecewise(0, r<b, C*(r-b)^n)",
    equivalent: "piecewise(0, x<b, C*n*sqrt(pi)*gamma(n)/gamma(n+1/2)*sqrt(x/2)*(x-b)^(n-1/2)*hyp2f1(1/2,1/2,n+1/2,(x-b)/(2*x)))",
    force: "piecewise(0, a<b, 2*E*C*n*sqrt(pi)*gamma(n)/gamma(n+1/2)/sqrt(2*a)*(a-b)^(n-1/2)*(b^2*hyp2f1(1/2,1/2,n+1/2,(a-b)/(2*a))\
            +2*b*(a-b)*n/(n+1/2)*hyp2f1(1/2,1/2,n+3/2,(a-b)/(2*a))\
            +(a-b)^2*n*(n+1)/((n+1/2)*(n+3/2))*hyp2f1(1/2,1/2,n+5/2,(a-b)/(2*a))))",
    pressure: None,
    parameters: &[
        Parameter { name: "C", lowest: 0.1, highest: 2.0 },
        Parameter { name: "n", lowest: 1.2, highest: 4.0 },
        Parameter { name: "b", lowest: 0.2, highest: 2.0 },
    ],
    guard: "f′ = c·r^m·(r−b)^k on [b, ∞) with whole m ≥ 0, k > −1 not whole",
    reference: &["Euler's integral, DLMF 15.6.1, with r = x − (x−b) t"],
    specializes: None,
    apply,
};

fn apply(term: &Term) -> Option<Answer> {
    let part = term.single()?;
    let m = moments::exponent(part)?;
    let (base, k) = reading::power(&part.kernel);
    let (alpha, beta) = reading::linear(&base)?;
    let (b, radius) = (&term.segment.lower, Symbol::new("r"));
    let distance = normal::is_proven_zero(&(alpha + &beta * b), &radius);
    if b.is_zero()
        || term.segment.upper.is_some()
        || !distance
        || sign(&beta) != Sign::Positive
        || k.as_integer().is_some()
        || k.contains(&radius)
    {
        return None;
    }
    let conditions = reading::above(&k, -1)?;
    let c = &part.coefficient * beta.pow(&k);
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    // r^m = Σ binom(m, j) b^(m−j) (r−b)^j; written out, so that the terms of (r−b)^(5/2) = (r² − 2br + b²)(r−b)^(1/2) cancel.
    let moment = |m: i64, at: &Expr, factor: &Expr| {
        let mut binomial = Expr::one();
        let mut terms = Vec::new();
        for j in 0..=m {
            terms.push(factor * &binomial * b.power(m - j) * shifted(&(&k + Expr::integer(j)), b, at));
            binomial = binomial * Expr::ratio(m - j, j + 1);
        }
        Expr::sum(terms)
    };
    Some(Answer {
        equivalent: Branches::endless(Pair::same(moment(m, &x, &(&c * &x)))),
        force: Branches::endless(Pair::same(moment(m + 2, &a, &c))),
        pressure: None,
        conditions,
    })
}

/// ∫_b^x (r−b)^k/√(x²−r²) dr = B(1/2, k+1) (x−b)^(k+1/2)/√(2x) 2F1(1/2, 1/2; k+3/2; (x−b)/(2x)), all terms positive.
fn shifted(k: &Expr, b: &Expr, x: &Expr) -> Expr {
    let (half, two) = (Expr::ratio(1, 2), Expr::integer(2));
    let argument = (x - b) / (&two * x);
    let root = (&two * x).sqrt();
    if *k == -&half {
        return &two / root * Expr::call("ellipk", [argument]);
    }
    let series = Expr::call("hyp2f1", [half.clone(), half.clone(), k + Expr::ratio(3, 2), argument]);
    power::beta_of_half(k) * (x - b).pow(&(k + half)) / root * series
}
