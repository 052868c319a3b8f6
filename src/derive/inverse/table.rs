//! The inverse table: f(r) = (2/π) ∫₀^{π/2} g(r sin t) dt in closed form, for equivalent profiles that are not the g of any rule.

use crate::derive::rule::Parameter;

/// An exact pair of g(x) and f(r), given by its statement alone.
pub struct InverseRule {
    /// Short name, as reports cite it.
    pub id: &'static str,
    /// A description of the profiles.
    pub title: &'static str,
    /// g(x).
    pub pattern: &'static str,
    /// f(r).
    pub result: &'static str,
    /// The pattern's parameters with the intervals that tests sample.
    pub parameters: &'static [Parameter],
    /// The conditions of validity, for the documentation.
    pub guard: &'static str,
    /// References.
    pub reference: &'static [&'static str],
}

/// The common reference.
const REFERENCE: &[&str] = &["inverse Abel transform"];

const K: &[Parameter] = &[Parameter { name: "k", lowest: 0.5, highest: 3.0 }];
const W: &[Parameter] = &[Parameter { name: "w", lowest: 0.5, highest: 2.0 }];
const OUTER: &[Parameter] = &[Parameter { name: "w", lowest: 3.2, highest: 6.0 }];

const fn rule(
    id: &'static str,
    title: &'static str,
    pattern: &'static str,
    result: &'static str,
    parameters: &'static [Parameter],
    guard: &'static str,
) -> InverseRule {
    InverseRule { id, title, pattern, result, parameters, guard, reference: REFERENCE }
}

/// Every entry; the entries are pure data.
pub static TABLE: &[InverseRule] = &[
    rule("inverse-sine", "Sine", "sin(k*x)", "struveh(0,k*r)", K, "k > 0"),
    rule("inverse-cosine", "Cosine", "1-cos(k*x)", "1-besselj(0,k*r)", K, "k > 0"),
    rule("inverse-sinh", "Hyperbolic sine", "sinh(k*x)", "struvel(0,k*r)", K, "k > 0"),
    rule("inverse-cosh", "Hyperbolic cosine", "cosh(k*x)-1", "besseli(0,k*r)-1", K, "k > 0"),
    rule("inverse-exp", "Exponential growth", "exp(k*x)-1", "besseli(0,k*r)+struvel(0,k*r)-1", K, "k > 0"),
    rule("inverse-exp-decay", "Exponential saturation", "1-exp(-k*x)", "1-(besseli(0,k*r)-struvel(0,k*r))", K, "k > 0"),
    rule("inverse-gaussian", "Gaussian", "1-exp(-x^2/w^2)", "1-exp(-r^2/(2*w^2))*besseli(0,r^2/(2*w^2))", W, "w > 0"),
    rule("inverse-gaussian-growth", "Growing Gaussian", "exp(x^2/w^2)-1", "exp(r^2/(2*w^2))*besseli(0,r^2/(2*w^2))-1", W, "w > 0"),
    rule("inverse-log-quadratic", "Logarithm of 1 + x²/w²", "ln(1+x^2/w^2)", "2*ln((1+sqrt(1+r^2/w^2))/2)", W, "w > 0"),
    rule("inverse-log-quadratic-minus", "Logarithm of 1 − x²/w²", "ln(1-x^2/w^2)", "2*ln((1+sqrt(1-r^2/w^2))/2)", OUTER, "r < w"),
    rule("inverse-asinh", "Area hyperbolic sine", "asinh(x/w)", "2/pi*r/w*hyper([1/2,1/2,1],[3/2,3/2],-r^2/w^2)", W, "w > 0"),
    rule("inverse-asin", "Arc sine", "asin(x/w)", "2/pi*r/w*hyper([1/2,1/2,1],[3/2,3/2],r^2/w^2)", OUTER, "r < w"),
    rule(
        "inverse-arctan",
        "Arc tangent",
        "atan(x/w)",
        "2/pi*(asinh(r/w)*ln(r/(w+sqrt(w^2+r^2)))+pi^2/4-2*w/(r+sqrt(w^2+r^2))*hyper([1/2,1/2,1],[3/2,3/2],w^2/(r+sqrt(w^2+r^2))^2))",
        W,
        "w > 0",
    ),
    rule("inverse-lorentzian", "Lorentzian", "x^2/(w^2+x^2)", "1-1/sqrt(1+r^2/w^2)", W, "w > 0"),
    rule("inverse-pole", "Pole beyond the contact", "w^2/(w^2-x^2)-1", "1/sqrt(1-r^2/w^2)-1", OUTER, "r < w"),
    rule("inverse-rational", "Saturation x/(w + x)", "x/(w+x)", "1-2/pi*elliprc(r^2/w^2,1)", W, "w > 0"),
    rule("inverse-hyperbola", "Hyperbola", "sqrt(1+x^2/w^2)-1", "2/pi*ellipe(-r^2/w^2)-1", W, "w > 0"),
    rule("inverse-circle", "Circle", "1-sqrt(1-x^2/w^2)", "1-2/pi*ellipe(r^2/w^2)", OUTER, "r < w"),
    rule("inverse-root", "Inverse root", "1-1/sqrt(1+x^2/w^2)", "1-2/pi*ellipk(-r^2/w^2)", W, "w > 0"),
    rule("inverse-bessel", "Bessel function J₀", "1-besselj(0,k*x)", "1-besselj(0,k*r/2)^2", K, "k > 0"),
    rule("inverse-bessel-growth", "Bessel function I₀", "besseli(0,k*x)-1", "besseli(0,k*r/2)^2-1", K, "k > 0"),
    rule("inverse-x-arctan", "Hyperboloid's x·arctan x", "x*atan(x/w)", "sqrt(w^2+r^2)-w", W, "w > 0"),
    rule("inverse-x-artanh", "Sphere's x·artanh x", "x*atanh(x/w)", "w-sqrt(w^2-r^2)", OUTER, "r < w"),
    rule(
        "inverse-binomial",
        "Binomial of any power",
        "(1+x^2/w^2)^p-1",
        "hyp2f1(-p,1/2,1,-r^2/w^2)-1",
        &[Parameter { name: "w", lowest: 0.6, highest: 2.0 }, Parameter { name: "p", lowest: 0.1, highest: 1.5 }],
        "w > 0",
    ),
];
