//! The displacement outside a contact, term by term: u(r) = (2/π) ∫₀^a g′(x) asin(x/r) dx in closed form.
//!
//! These solutions apply to terms, like rules, but are separate from them: many terms with a closed g have no closed u, and some
//! terms without a closed pressure have one.

use super::reading;
use crate::derive::domain::located::is_approximate;
use crate::derive::rule::{Branches, Pair};
use crate::derive::term::Term;
use crate::expr::{Expr, Sign, rewritten, sign};

/// The contribution of a term to u(r) for r > a under a smooth edge, over the symbols r and a; `None` if no closed form is known.
///
/// Powers (cone and paraboloid among them), sphere, ellipsoid and hyperboloid, and pieces whose f′ is c₀ + c₁ r: truncated
/// cones, worn and capped paraboloids.
pub fn outside(term: &Term) -> Option<Branches> {
    let two_over_pi = Expr::integer(2) / Expr::pi();
    if term.segment.is_whole() {
        return power(term).or_else(|| root(term)).map(|expr| Branches::endless(both(&(two_over_pi * expr), &Expr::zero())));
    }
    if is_approximate(&term.segment.lower) || term.segment.upper.as_ref().is_some_and(is_approximate) {
        return None;
    }
    let coefficients = term.polynomial()?;
    let (flat, rising) = match coefficients.as_slice() {
        [flat] => (flat.clone(), Expr::zero()),
        [flat, rising] => (flat.clone(), rising.clone()),
        _ => return None,
    };
    Some(Branches::from_ends(&term.segment, |end| both(&worn(&flat, &rising, end), end)).scaled(&two_over_pi))
}

/// The angles whose sine is a/r and whose cosine is b/a are shown as these, and evaluated from roots, which keep their digits at the edge.
fn both(evaluated: &Expr, b: &Expr) -> Pair {
    let (a, r) = (Expr::symbol("a"), Expr::symbol("r"));
    let (sine, cosine) = (Expr::call("atan", [&a / leg(&a, &r)]), Expr::call("atan", [leg(b, &a) / b]));
    let shown = rewritten(evaluated, &|own, _| match own {
        _ if *own == sine => Some(Expr::call("asin", [&a / &r])),
        _ if *own == cosine && !b.is_zero() => Some(Expr::call("acos", [b / &a])),
        _ => None,
    });
    Pair { shown, evaluated: evaluated.clone() }
}

/// √(r² − a²).
fn leg(a: &Expr, r: &Expr) -> Expr {
    (r.power(2) - a.power(2)).sqrt()
}

/// f′ = c r^(n−1): c κ_n/n ∫ n x^(n−1) asin(x/r) dx.
fn power(term: &Term) -> Option<Expr> {
    let part = term.single().filter(|part| part.kernel.is_one())?;
    let n = &part.exponent + Expr::one();
    let own = &part.coefficient * super::kappa(&n) / &n;
    (sign(&n) == Sign::Positive).then(|| own * Expr::call("outside_power", [n, Expr::symbol("a"), Expr::symbol("r")]))
}

/// f′ = c r/√(R² ∓ r²): sphere and hyperboloid, C x artanh(x/R) or C x arctan(x/R).
fn root(term: &Term) -> Option<Expr> {
    let part = term.single().filter(|part| part.exponent.is_one())?;
    let (base, exponent) = reading::power(&part.kernel);
    let (alpha, beta) = reading::quadratic(&base)?;
    if exponent != Expr::ratio(-1, 2) || sign(&alpha) != Sign::Positive {
        return None;
    }
    let (a, r) = (Expr::symbol("a"), Expr::symbol("r"));
    let leg = leg(&a, &r);
    let angle = Expr::call("atan", [&a / &leg]);
    let own = |magnitude: &Expr| (&part.coefficient / magnitude.sqrt(), (&alpha / magnitude).sqrt());
    match sign(&beta) {
        Sign::Negative => {
            let (scale, big) = own(&-&beta);
            let area = Expr::call("artanh_ratio", [a.clone(), big.clone()]);
            // k atan(a k/(R z)) with k² = R² − r², for either sign of it.
            let argument = r.power(2) * (big.power(2) - a.power(2)) / (big.power(2) * leg.power(2));
            let last = (big.power(2) - r.power(2)) * &a / (&big * &leg) * Expr::call("elliprc", [Expr::one(), argument]);
            Some(scale * (&a * &area * &angle + &leg * &area - &big * &angle + last))
        }
        Sign::Positive => {
            let (scale, b) = own(&beta);
            let slope = Expr::call("atan", [&a / &b]);
            let far = (r.power(2) + b.power(2)).sqrt();
            let last = &far * Expr::call("atan", [&a * &far / (&b * &leg)]);
            Some(scale * (&a * &slope * &angle + &leg * &slope + &b * &angle - last))
        }
        _ => None,
    }
}

/// f′ = c₀ + c₁ r from b on: g = x (c₀ arccos(b/x) + c₁ √(x²−b²)).
fn worn(flat: &Expr, rising: &Expr, b: &Expr) -> Expr {
    let (a, r) = (Expr::symbol("a"), Expr::symbol("r"));
    if b.is_zero() {
        let power = |n: i64| Expr::call("outside_power", [Expr::integer(n), a.clone(), r.clone()]);
        return flat * Expr::pi() / Expr::integer(2) * power(1) + rising * power(2);
    }
    let inner = leg(b, &a);
    let outer = leg(&a, &r);
    let (t, angle) = (&inner / &outer, Expr::call("atan", [&a / &outer]));
    let arc = Expr::call("atan", [&inner / b]);
    let turn = Expr::call("atan", [t.clone()]);
    // ∫_b^a g/√(r²−x²) dx of both parts.
    let kink = &r * Expr::call("atan", [&r * &t / b]) - b * &turn - &outer * &arc;
    let bowl = ((r.power(2) - b.power(2)) * &turn - &inner * &outer) / Expr::integer(2);
    flat * (&a * &arc * &angle - kink) + rising * (&a * &inner * &angle - bowl)
}
