//! Powers of r² − b² from b on, times odd powers of r: flat punches with edges that rise like a power of the distance.

use super::{power, reading};
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::{Expr, Sign, Symbol, normal, sign};

pub(super) static RULE: Rule = Rule {
    id: "difference-of-squares",
    title: "Power of r² − b² from b on",
    pattern: "piecewise(0, r<b, C*(r^2-b^2)^(3/2))",
    equivalent: "piecewise(0, x<b, 3/4*pi*C*x*(x^2-b^2))",
    force: "piecewise(0, a<b, 3/8*pi*E*C*(a^2-b^2)*(3*a^2+b^2))",
    pressure: None,
    parameters: &[Parameter { name: "C", lowest: 0.1, highest: 2.0 }, Parameter { name: "b", lowest: 0.2, highest: 2.0 }],
    guard: "f′ = c·r^m·(r²−b²)^k on [b, ∞) with odd m > 0, k > −1 not whole",
    reference: &["Euler's beta function, DLMF 5.12.1, with u = r² − b²"],
    specializes: None,
    apply,
};

/// Largest exponent of r; higher ones have long sums.
const HIGHEST: i64 = 12;

fn apply(term: &Term) -> Option<Answer> {
    let part = term.single()?;
    let m = part.exponent.as_integer().filter(|m| (1..=HIGHEST).contains(m) && m % 2 == 1)?;
    let (base, k) = reading::power(&part.kernel);
    let (alpha, beta) = reading::quadratic(&base)?;
    let (b, radius) = (&term.segment.lower, Symbol::new("r"));
    let begins_here = !b.is_zero() && normal::is_proven_zero(&(alpha + &beta * b.power(2)), &radius);
    if !begins_here || term.segment.upper.is_some() || sign(&beta) != Sign::Positive || k.as_integer().is_some() || k.contains(&radius) {
        return None;
    }
    let conditions = reading::above(&k, -1)?;
    let c = &part.coefficient * beta.pow(&k);
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    let pair = |m: i64, at: &Expr, factor: &Expr| {
        let own = |square: Expr| factor * moment((m - 1) / 2, &k, b, &square);
        Pair { shown: own(at.power(2) - b.power(2)), evaluated: own((at - b) * (at + b)) }
    };
    Some(Answer {
        equivalent: Branches::endless(pair(m, &x, &(&c * &x))),
        force: Branches::endless(pair(m + 2, &a, &c)),
        pressure: None,
        conditions,
    })
}

/// ∫_b^x r^(2j+1) (r²−b²)^k/√(x²−r²) dr = ½ Σ binom(j, i) b^(2j−2i) B(1/2, k+i+1) X^(k+i+1/2) with X = x² − b².
fn moment(j: i64, k: &Expr, b: &Expr, square: &Expr) -> Expr {
    let (mut binomial, mut terms) = (Expr::one(), Vec::new());
    for i in 0..=j {
        let own = k + Expr::integer(i);
        let factor = Expr::ratio(1, 2) * &binomial * b.power(2 * (j - i));
        terms.push(factor * power::beta_of_half(&own) * square.pow(&(own + Expr::ratio(1, 2))));
        binomial = binomial * Expr::ratio(j - i, i + 1);
    }
    Expr::sum(terms)
}
