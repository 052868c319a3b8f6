//! The root family √(R² ± r²): sphere, ellipsoid, hyperboloid, and the same shapes worn flat at the tip.

use super::reading;
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::{Condition, Expr, Sign, sign};

pub(super) static SPHERE: Rule = Rule {
    id: "sphere",
    title: "Sphere and ellipsoid of revolution",
    pattern: "h*(1-sqrt(1-r^2/R^2))",
    equivalent: "h*x/R*atanh(x/R)",
    force: "E*h/R*((R^2+a^2)*atanh(a/R)-a*R)",
    pressure: Some(
        "E*h/(pi*R)*((a+sqrt(a^2-r^2))/(R+sqrt(R^2-r^2))*hyper([1/2,1/2,1],[3/2,3/2],((a+sqrt(a^2-r^2))/(R+sqrt(R^2-r^2)))^2)\
         -(a-sqrt(a^2-r^2))/(R+sqrt(R^2-r^2))*hyper([1/2,1/2,1],[3/2,3/2],((a-sqrt(a^2-r^2))/(R+sqrt(R^2-r^2)))^2)\
         +R/sqrt(R^2-r^2)*atanh(sqrt(a^2-r^2)/sqrt(R^2-r^2)))",
    ),
    parameters: &[Parameter { name: "h", lowest: 0.1, highest: 4.0 }, Parameter { name: "R", lowest: 3.2, highest: 6.0 }],
    guard: "r < R",
    reference: &["Popov & Heß (3.71)–(3.78)"],
    specializes: None,
    apply: |term| smooth(term, Sign::Negative),
};

pub(super) static WORN_SPHERE: Rule = Rule {
    id: "worn-sphere",
    title: "Sphere or ellipsoid from a radius outward",
    pattern: "piecewise(0, r<b, h*(sqrt(R^2-b^2)-sqrt(R^2-r^2)))",
    equivalent: "piecewise(0, x<b, h*x*atanh(sqrt(x^2-b^2)/sqrt(R^2-b^2)))",
    force: "piecewise(0, a<b, E*h*((R^2+a^2)*atanh(sqrt(a^2-b^2)/sqrt(R^2-b^2))-sqrt(a^2-b^2)*sqrt(R^2-b^2)))",
    pressure: None,
    parameters: &[
        Parameter { name: "h", lowest: 0.1, highest: 4.0 },
        Parameter { name: "R", lowest: 3.2, highest: 6.0 },
        Parameter { name: "b", lowest: 0.2, highest: 2.0 },
    ],
    guard: "b ≤ r < R",
    reference: &["Popov & Heß (3.71)–(3.78)", "wear rule for even profiles"],
    specializes: None,
    apply: |term| worn(term, Sign::Negative),
};

pub(super) static HYPERBOLOID: Rule = Rule {
    id: "hyperboloid",
    title: "Hyperboloid of revolution",
    pattern: "h*(sqrt(1+r^2/b^2)-1)",
    equivalent: "h*x/b*atan(x/b)",
    force: "E*h/b*((a^2-b^2)*atan(a/b)+a*b)",
    pressure: Some(
        "E*h/(pi*b)*((a+sqrt(a^2-r^2))/(b+sqrt(b^2+r^2))*hyper([1/2,1/2,1],[3/2,3/2],-((a+sqrt(a^2-r^2))/(b+sqrt(b^2+r^2)))^2)\
         -(a-sqrt(a^2-r^2))/(b+sqrt(b^2+r^2))*hyper([1/2,1/2,1],[3/2,3/2],-((a-sqrt(a^2-r^2))/(b+sqrt(b^2+r^2)))^2)\
         +b/sqrt(b^2+r^2)*atan(sqrt(a^2-r^2)/sqrt(b^2+r^2)))",
    ),
    parameters: &[Parameter { name: "h", lowest: 0.1, highest: 4.0 }, Parameter { name: "b", lowest: 3.2, highest: 6.0 }],
    guard: "h, b > 0",
    reference: &["general formula, Popov & Heß (3.27)"],
    specializes: None,
    apply: |term| smooth(term, Sign::Positive),
};

pub(super) static WORN_HYPERBOLOID: Rule = Rule {
    id: "worn-hyperboloid",
    title: "Hyperboloid from a radius outward",
    pattern: "piecewise(0, r<c, h*(sqrt(b^2+r^2)-sqrt(b^2+c^2)))",
    equivalent: "piecewise(0, x<c, h*x*atan(sqrt(x^2-c^2)/sqrt(b^2+c^2)))",
    force: "piecewise(0, a<c, E*h*((a^2-b^2)*atan(sqrt(a^2-c^2)/sqrt(b^2+c^2))+sqrt(a^2-c^2)*sqrt(b^2+c^2)))",
    pressure: None,
    parameters: &[
        Parameter { name: "h", lowest: 0.1, highest: 4.0 },
        Parameter { name: "b", lowest: 0.3, highest: 4.0 },
        Parameter { name: "c", lowest: 0.2, highest: 2.0 },
    ],
    guard: "r ≥ c",
    reference: &["general formula, Popov & Heß (3.27)", "wear rule for even profiles"],
    specializes: None,
    apply: |term| worn(term, Sign::Positive),
};

/// f′ = C·r/√(R² ± r²) on the whole axis.
fn smooth(term: &Term, branch: Sign) -> Option<Answer> {
    if !term.segment.is_whole() {
        return None;
    }
    let Root { coefficient, radius, conditions } = recognise(term, branch)?;
    let (a, r) = (Expr::symbol("a"), Expr::symbol("r"));
    let (equivalent, force) = computed(branch, &radius);
    let pressure = if branch == Sign::Negative { "sphere_pressure" } else { "hyperboloid_pressure" };
    let pair = |expr: Expr| Branches::endless(Pair::same(&coefficient * expr));
    Some(Answer {
        equivalent: pair(equivalent),
        force: pair(force),
        pressure: Some(pair(Expr::call(pressure, [r, a, radius.clone()]))),
        conditions,
    })
}

/// g and F/(2E*) of f′ = r/√(R² ± r²) from the axis on, in forms without cancellation.
pub(super) fn computed(branch: Sign, radius: &Expr) -> (Expr, Expr) {
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    if branch == Sign::Negative {
        let equivalent = &x * Expr::call("artanh_ratio", [x.clone(), radius.clone()]);
        return (equivalent, Expr::call("sphere_force", [a, radius.clone()]));
    }
    (&x * Expr::call("atan", [&x / radius]), Expr::call("hyperboloid_force", [a, radius.clone()]))
}

/// The same from a radius b > 0 outward.
fn worn(term: &Term, branch: Sign) -> Option<Answer> {
    if term.segment.lower.is_zero() || term.segment.upper.is_some() {
        return None;
    }
    let Root { coefficient, radius, conditions } = recognise(term, branch)?;
    let (x, a, b) = (Expr::symbol("x"), Expr::symbol("a"), term.segment.lower.clone());
    let (equivalent, force) = if branch == Sign::Negative {
        ("worn_sphere_slope", "worn_sphere_force")
    } else {
        ("worn_hyperboloid_slope", "worn_hyperboloid_force")
    };
    let pair = |expr: Expr| Branches::endless(Pair::same(&coefficient * expr));
    Some(Answer {
        equivalent: pair(&x * Expr::call(equivalent, [b.clone(), x.clone(), radius.clone()])),
        force: pair(Expr::call(force, [b, a, radius.clone()])),
        pressure: None,
        conditions,
    })
}

/// C and R of C·r/√(R² ± r²).
struct Root {
    coefficient: Expr,
    radius: Expr,
    conditions: Vec<Condition>,
}

/// Reads c·r·(α + β r²)^(−1/2): R = √(α/|β|), C = c/√|β|.
fn recognise(term: &Term, branch: Sign) -> Option<Root> {
    let part = term.single()?;
    if !part.exponent.is_one() {
        return None;
    }
    let (base, exponent) = reading::power(&part.kernel);
    let (alpha, beta) = reading::quadratic(&base)?;
    if exponent != Expr::ratio(-1, 2) || sign(&beta) != branch {
        return None;
    }
    let conditions = reading::positive(&alpha)?;
    let magnitude = if branch == Sign::Negative { -beta } else { beta };
    Some(Root { coefficient: &part.coefficient / magnitude.sqrt(), radius: (alpha / magnitude).sqrt(), conditions })
}
