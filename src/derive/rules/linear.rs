//! Poles and roots of linear functions: r^m/(w ± r)^k and r^m (w ± r)^(±k/2), on the whole axis and on segments.

use super::combination::Form;
use super::moments::{self, HIGHEST};
use super::pole::{Pole, Reach};
use super::reading;
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::{Expr, Sign, sign};

pub(super) static RATIONAL: Rule = Rule {
    id: "linear-pole",
    title: "Rational with a pole at −w or beyond the contact",
    pattern: "h*ln(1+r/w)",
    equivalent: "h*x*elliprc(x^2,w^2)",
    force: "2*E*h*(a-pi*w/2+w^2*elliprc(a^2,w^2))",
    pressure: None,
    parameters: &[Parameter { name: "h", lowest: 0.1, highest: 4.0 }, Parameter { name: "w", lowest: 0.3, highest: 4.0 }],
    guard: "f′ = c·r^m/(w ± r)^k on [b, c) with whole m ≥ 0 and k ≥ 1, w ± r not 0 there",
    reference: &["integration by parts", "DLMF 19.2.17 (R_C)"],
    specializes: None,
    apply: |term| apply(term, false),
};

pub(super) static ROOT: Rule = Rule {
    id: "linear-root",
    title: "Square root of a linear function",
    pattern: "h*(sqrt(1+r/w)-1)",
    equivalent: "h*x/sqrt(w)*elliprf(w+x,2*w,2*(w+x))",
    force: "E*h/sqrt(w)*(2/3*sqrt(w)*a+8/9*w*a*(a+w)*elliprd(a+w,2*w,2*(a+w))+2/3*(a^2-2*w*a)*elliprf(a+w,2*w,2*(a+w)))",
    pressure: None,
    parameters: &[Parameter { name: "h", lowest: 0.1, highest: 4.0 }, Parameter { name: "w", lowest: 0.3, highest: 4.0 }],
    guard: "f′ = c·r^m·(w ± r)^(k/2) on [b, c) with whole m ≥ 0 and odd k, w ± r > 0 there",
    reference: &["integration by parts", "DLMF 19.16.1, 19.16.5 (R_F, R_D)"],
    specializes: None,
    apply: |term| apply(term, true),
};

fn apply(term: &Term, half: bool) -> Option<Answer> {
    let part = term.single()?;
    let m = moments::exponent(part)?;
    let (base, exponent) = reading::power(&part.kernel);
    let (alpha, beta) = reading::linear(&base)?;
    // (α + βr)^(−κ) with κ = n, or n − 1/2.
    let level = if half { Expr::ratio(1, 2) - &exponent } else { -&exponent };
    let lowest = if half { -HIGHEST } else { 1 };
    let n = level.as_integer().filter(|n| (lowest..=HIGHEST).contains(n))?;
    let (pole, conditions) = Pole::new(&alpha, &beta, half, &term.segment)?;
    let steepness = if pole.above { -&beta } else { beta };
    if half && sign(&steepness) != Sign::Positive {
        return None;
    }
    let c = &part.coefficient * steepness.pow(&exponent);
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    let branches = |m: i64, at: &Expr, factor: &Expr| {
        let part = |e: &Expr, reach: Reach, form: Form| pole.moment(m, n, e, at, reach, form).over(&pole.basis(e, at, reach, form));
        branches(&term.segment.lower, term.segment.upper.as_ref(), factor, part)
    };
    Some(Answer { equivalent: branches(m, &x, &(&c * &x)), force: branches(m + 2, &a, &c), pressure: None, conditions })
}

/// The integral from the lower end to the rim, and that between the ends as a difference.
pub(super) fn branches(lower: &Expr, upper: Option<&Expr>, factor: &Expr, part: impl Fn(&Expr, Reach, Form) -> Expr) -> Branches {
    let within = |form| factor * part(lower, Reach::ToRim, form);
    let within = Pair { shown: within(Form::Shown), evaluated: within(Form::Evaluated) };
    let beyond = match upper {
        None => within.clone(),
        Some(upper) => {
            let between = |form| factor * (part(lower, Reach::Between, form) - part(upper, Reach::Between, form));
            Pair { shown: between(Form::Shown), evaluated: between(Form::Evaluated) }
        }
    };
    Branches { within, beyond }
}
