//! Powers of r times ln(1 ± r²/ρ²).

use super::{B, Extent, H, Kernel, R, W, kernel};
use crate::derive::rule::{Answer, Rule};
use crate::derive::rules::reading;
use crate::derive::term::Term;
use crate::expr::Expr;

const PARTS: &str = "integration by parts";

pub(in crate::derive::rules) static ABOVE: Rule = Rule {
    id: "log-quadratic",
    title: "Powers of r times ln(1 + r²/w²)",
    pattern: "h*((w^2+r^2)*ln(1+r^2/w^2)-r^2)",
    equivalent: "4*h*x*(sqrt(w^2+x^2)*asinh(x/w)-x)",
    force: "8*E*h/3*((2*a^2-w^2)*sqrt(w^2+a^2)*asinh(a/w)-5/3*a^3+w^2*a)",
    pressure: None,
    parameters: &[H, W],
    guard: "w > 0",
    reference: &[PARTS],
    specializes: None,
    apply: |term| apply(term, 1, Extent::Whole),
};

pub(in crate::derive::rules) static BELOW: Rule = Rule {
    id: "log-quadratic-below",
    title: "Powers of r times ln(1 − r²/R²)",
    pattern: "h*((R^2-r^2)*ln(1-r^2/R^2)+r^2)",
    equivalent: "4*h*x*(x-sqrt(R^2-x^2)*asin(x/R))",
    force: "8*E*h/3*(5/3*a^3+R^2*a-(2*a^2+R^2)*sqrt(R^2-a^2)*asin(a/R))",
    pressure: None,
    parameters: &[H, R],
    guard: "r < R",
    reference: &[PARTS],
    specializes: None,
    apply: |term| apply(term, -1, Extent::Whole),
};

pub(in crate::derive::rules) static WORN_ABOVE: Rule = Rule {
    id: "worn-log-quadratic",
    title: "Odd powers of r times ln(1 + r²/w²) on a segment",
    pattern: "piecewise(0, r<b, h*((w^2+r^2)*ln(1+r^2/w^2)-r^2-(w^2+b^2)*ln(1+b^2/w^2)+b^2))",
    equivalent: "piecewise(0, x<b, 2*h*x*(sqrt(x^2-b^2)*ln(1+b^2/w^2)+2*sqrt(w^2+x^2)*asinh(sqrt(x^2-b^2)/sqrt(w^2+b^2))-2*sqrt(x^2-b^2)))",
    force: "piecewise(0, a<b, 4*E*h/3*((b^2+2*a^2)*sqrt(a^2-b^2)*ln(1+b^2/w^2)\
            +2*(2*a^2-w^2)*sqrt(w^2+a^2)*asinh(sqrt(a^2-b^2)/sqrt(w^2+b^2))\
            -2*(5*a^2-3*w^2+b^2)/3*sqrt(a^2-b^2)))",
    pressure: None,
    parameters: &[H, W, B],
    guard: "r ≥ b",
    reference: &[PARTS],
    specializes: None,
    apply: |term| apply(term, 1, Extent::Segment),
};

pub(in crate::derive::rules) static WORN_BELOW: Rule = Rule {
    id: "worn-log-quadratic-below",
    title: "Odd powers of r times ln(1 − r²/R²) on a segment",
    pattern: "piecewise(0, r<b, h*((R^2-r^2)*ln(1-r^2/R^2)+r^2-(R^2-b^2)*ln(1-b^2/R^2)-b^2))",
    equivalent: "piecewise(0, x<b, 2*h*x*(2*sqrt(x^2-b^2)-sqrt(x^2-b^2)*ln(1-b^2/R^2)-2*sqrt(R^2-x^2)*asin(sqrt(x^2-b^2)/sqrt(R^2-b^2))))",
    force: "piecewise(0, a<b, 4*E*h/3*(2*(5*a^2+3*R^2+b^2)/3*sqrt(a^2-b^2)-(b^2+2*a^2)*sqrt(a^2-b^2)*ln(1-b^2/R^2)\
            -2*(2*a^2+R^2)*sqrt(R^2-a^2)*asin(sqrt(a^2-b^2)/sqrt(R^2-b^2))))",
    pressure: None,
    parameters: &[H, R, B],
    guard: "b ≤ r < R",
    reference: &[PARTS],
    specializes: None,
    apply: |term| apply(term, -1, Extent::Segment),
};

/// c r^m ln(1 + βr²): m ≥ 0 and m = −2 on the whole axis, odd m on segments.
fn apply(term: &Term, sigma: i64, extent: Extent) -> Option<Answer> {
    kernel(term, Kernel::Logarithm, extent, |own| {
        let [argument] = reading::call(own, "ln")? else { return None };
        let (field, magnitude, conditions) = super::field(argument)?;
        // The argument must be 1 at the axis: 1 ± r²/ρ².
        let plain = (&field.square_length * magnitude).is_one() && conditions.is_empty();
        (plain && field.sigma == sigma).then_some((Expr::one(), field))
    })
}
