//! Powers of r times atan(r/w), atanh(r/R), asinh(r/w) and asin(r/R).

use super::{B, BLANK, Extent, Field, H, Kernel, R, W, kernel};
use crate::derive::rule::{Answer, Parameter, Rule};
use crate::derive::rules::reading;
use crate::derive::term::Term;
use crate::expr::{Expr, Sign, sign};

const PARTS: &str = "integration by parts";
const POSITIVE: &str = "w > 0";
const OUTWARD: &str = "r ≥ b";
const INSIDE: &str = "r < R";
const WORN_INSIDE: &str = "b ≤ r < R";

/// The common part of the rules in this file.
const BASE: Rule = Rule { parameters: &[H, W], guard: POSITIVE, reference: &[PARTS], ..BLANK };

pub(in crate::derive::rules) static ATAN_EVEN: Rule = Rule {
    id: "even-arctangent",
    title: "Even powers of r times atan(r/w)",
    pattern: "h*(r*atan(r/w)-w/2*ln(1+r^2/w^2))",
    equivalent: "2*h*x*(x/(w+sqrt(w^2+x^2)))*hyper([1/2,1/2,1],[3/2,3/2],(x/(w+sqrt(w^2+x^2)))^2)",
    force: "E*h*(2*a^2*(a/(w+sqrt(w^2+a^2)))*hyper([1/2,1/2,1],[3/2,3/2],(a/(w+sqrt(w^2+a^2)))^2)\
            +w*(sqrt(w^2+a^2)*asinh(a/w)-a))",
    apply: |term| apply(term, Kernel::Arctangent, "atan", false, Extent::Whole),
    ..BASE
};

pub(in crate::derive::rules) static ATAN_ODD: Rule = Rule {
    id: "odd-arctangent",
    title: "Odd powers of r times atan(r/w)",
    pattern: "h*((w^2+r^2)*atan(r/w)-w*r)",
    equivalent: "pi*h*x*(sqrt(w^2+x^2)-w)",
    force: "2*pi/3*E*h*((2*a^2-w^2)*sqrt(w^2+a^2)+w^3-3/2*w*a^2)",
    pressure: Some(
        "E*h*((w^2+2*r^2)/r*ellipf(atan(sqrt(a^2-r^2)/sqrt(w^2+r^2)),-w^2/r^2)\
         -2*r*ellipe(atan(sqrt(a^2-r^2)/sqrt(w^2+r^2)),-w^2/r^2)+2*a*sqrt(a^2-r^2)/sqrt(w^2+a^2)-w*acosh(a/r))",
    ),
    apply: |term| apply(term, Kernel::Arctangent, "atan", true, Extent::Whole),
    ..BASE
};

pub(in crate::derive::rules) static ATANH_EVEN: Rule = Rule {
    id: "even-artanh",
    title: "Even powers of r times artanh(r/R)",
    pattern: "h*(r*atanh(r/R)+R/2*ln(1-r^2/R^2))",
    equivalent: "2*h*x*(x/(R+sqrt(R^2-x^2)))*hyper([1/2,1/2,1],[3/2,3/2],-(x/(R+sqrt(R^2-x^2)))^2)",
    force: "E*h*(2*a^2*(a/(R+sqrt(R^2-a^2)))*hyper([1/2,1/2,1],[3/2,3/2],-(a/(R+sqrt(R^2-a^2)))^2)\
            +R*(a-sqrt(R^2-a^2)*asin(a/R)))",
    parameters: &[H, R],
    guard: INSIDE,
    apply: |term| apply(term, Kernel::Arctangent, "atanh", false, Extent::Whole),
    ..BASE
};

pub(in crate::derive::rules) static ATANH_ODD: Rule = Rule {
    id: "odd-artanh",
    title: "Odd powers of r times artanh(r/R)",
    pattern: "h*(R*r-(R^2-r^2)*atanh(r/R))",
    equivalent: "pi*h*x*(R-sqrt(R^2-x^2))",
    force: "2*pi/3*E*h*(R^3+3/2*R*a^2-(2*a^2+R^2)*sqrt(R^2-a^2))",
    parameters: &[H, R],
    guard: INSIDE,
    pressure: Some(
        "E*h*(R*acosh(a/r)-R^2/r*ellipf(atan(sqrt(a^2-r^2)/sqrt(R^2-a^2)),1-R^2/r^2)\
         +2*r*ellipe(atan(sqrt(a^2-r^2)/sqrt(R^2-a^2)),1-R^2/r^2))",
    ),
    apply: |term| apply(term, Kernel::Arctangent, "atanh", true, Extent::Whole),
    ..BASE
};

pub(in crate::derive::rules) static WORN_ATAN: Rule = Rule {
    id: "worn-odd-arctangent",
    title: "Odd powers of r times atan(r/w) on a segment",
    pattern: "piecewise(0, r<b, h*((w^2+r^2)*atan(r/w)-w*r-(w^2+b^2)*atan(b/w)+w*b))",
    equivalent: "piecewise(0, x<b, 2*h*x*(sqrt(w^2+x^2)*atan(w*sqrt(x^2-b^2)/(b*sqrt(w^2+x^2)))-w*acos(b/x)+sqrt(x^2-b^2)*atan(b/w)))",
    force: "piecewise(0, a<b, 4/3*E*h*((2*a^2-w^2)*sqrt(w^2+a^2)*atan(w*sqrt(a^2-b^2)/(b*sqrt(w^2+a^2)))\
            +(w^3-3/2*w*a^2)*acos(b/a)+(2*a^2+b^2)*sqrt(a^2-b^2)*atan(b/w)-w*b*sqrt(a^2-b^2)/2))",
    parameters: &[H, W, B],
    guard: OUTWARD,
    apply: |term| apply(term, Kernel::Arctangent, "atan", true, Extent::Segment),
    ..BASE
};

pub(in crate::derive::rules) static WORN_ATANH: Rule = Rule {
    id: "worn-odd-artanh",
    title: "Odd powers of r times artanh(r/R) on a segment",
    pattern: "piecewise(0, r<b, h*(R*r-(R^2-r^2)*atanh(r/R)-R*b+(R^2-b^2)*atanh(b/R)))",
    equivalent: "piecewise(0, x<b, 2*h*x*(R*acos(b/x)-sqrt(R^2-x^2)*atan(R*sqrt(x^2-b^2)/(b*sqrt(R^2-x^2)))+sqrt(x^2-b^2)*atanh(b/R)))",
    force: "piecewise(0, a<b, 4/3*E*h*((R^3+3/2*R*a^2)*acos(b/a)+(2*a^2+b^2)*sqrt(a^2-b^2)*atanh(b/R)+R*b*sqrt(a^2-b^2)/2\
            -(2*a^2+R^2)*sqrt(R^2-a^2)*atan(R*sqrt(a^2-b^2)/(b*sqrt(R^2-a^2)))))",
    parameters: &[H, R, B],
    guard: WORN_INSIDE,
    apply: |term| apply(term, Kernel::Arctangent, "atanh", true, Extent::Segment),
    ..BASE
};

pub(in crate::derive::rules) static ASINH_EVEN: Rule = Rule {
    id: "even-arsinh",
    title: "Even powers of r times arsinh(r/w)",
    pattern: "h*(r*asinh(r/w)-sqrt(w^2+r^2)+w)",
    equivalent: "h*x*(x/w)*hyper([1/2,1/2,1],[3/2,3/2],-(x/w)^2)",
    force: "E*h*(a^2*(a/w)*hyper([1/2,1/2,1],[3/2,3/2],-(a/w)^2)+((w^2+a^2)*atan(a/w)-w*a)/2)",
    // Below w, where the series of the statement converges.
    parameters: &[H, Parameter { name: "w", lowest: 3.2, highest: 6.0 }],
    apply: |term| apply(term, Kernel::Arcsine, "asinh", false, Extent::Whole),
    ..BASE
};

pub(in crate::derive::rules) static ASINH_ODD: Rule = Rule {
    id: "odd-arsinh",
    title: "Odd powers of r times arsinh(r/w)",
    pattern: "h*((w^2+2*r^2)*asinh(r/w)-r*sqrt(w^2+r^2))",
    equivalent: "4*h*x*((w^2+x^2)*ellipk(-x^2/w^2)-w^2*ellipe(-x^2/w^2))/w",
    force: "8/9*E*h/w*(2*(3*a^2-w^2)*(w^2+a^2)*ellipk(-a^2/w^2)+w^2*(2*w^2-5*a^2)*ellipe(-a^2/w^2))",
    apply: |term| apply(term, Kernel::Arcsine, "asinh", true, Extent::Whole),
    ..BASE
};

pub(in crate::derive::rules) static ASIN_EVEN: Rule = Rule {
    id: "even-arcsine",
    title: "Even powers of r times asin(r/R)",
    pattern: "h*(r*asin(r/R)+sqrt(R^2-r^2)-R)",
    equivalent: "h*x*(x/R)*hyper([1/2,1/2,1],[3/2,3/2],(x/R)^2)",
    force: "E*h*(a^2*(a/R)*hyper([1/2,1/2,1],[3/2,3/2],(a/R)^2)+(R*a-(R^2-a^2)*atanh(a/R))/2)",
    parameters: &[H, R],
    guard: INSIDE,
    apply: |term| apply(term, Kernel::Arcsine, "asin", false, Extent::Whole),
    ..BASE
};

pub(in crate::derive::rules) static ASIN_ODD: Rule = Rule {
    id: "odd-arcsine",
    title: "Odd powers of r times asin(r/R)",
    pattern: "h*((2*r^2-R^2)*asin(r/R)+r*sqrt(R^2-r^2))",
    equivalent: "4*h*x*(R^2*ellipe(x^2/R^2)-(R^2-x^2)*ellipk(x^2/R^2))/R",
    force: "8/9*E*h/R*(R^2*(2*R^2+5*a^2)*ellipe(a^2/R^2)-2*(3*a^2+R^2)*(R^2-a^2)*ellipk(a^2/R^2))",
    parameters: &[H, R],
    guard: INSIDE,
    apply: |term| apply(term, Kernel::Arcsine, "asin", true, Extent::Whole),
    ..BASE
};

pub(in crate::derive::rules) static WORN_ASINH: Rule = Rule {
    id: "worn-odd-arsinh",
    title: "Odd powers of r times arsinh(r/w) on a segment",
    pattern: "piecewise(0, r<b, h*((w^2+2*r^2)*asinh(r/w)-r*sqrt(w^2+r^2)-(w^2+2*b^2)*asinh(b/w)+b*sqrt(w^2+b^2)))",
    equivalent: "piecewise(0, x<b, 4*h*x*((w^2+x^2)/w*ellipf(atan(w*sqrt(x^2-b^2)/(b*sqrt(w^2+x^2))),-x^2/w^2)\
            -w*ellipe(atan(w*sqrt(x^2-b^2)/(b*sqrt(w^2+x^2))),-x^2/w^2)-b*sqrt(x^2-b^2)/sqrt(w^2+b^2)+sqrt(x^2-b^2)*asinh(b/w)))",
    force: "piecewise(0, a<b, 8/9*E*h*(2*(3*a^2-w^2)*(w^2+a^2)/w*ellipf(atan(w*sqrt(a^2-b^2)/(b*sqrt(w^2+a^2))),-a^2/w^2)\
            +(2*w^2-5*a^2)*(w*ellipe(atan(w*sqrt(a^2-b^2)/(b*sqrt(w^2+a^2))),-a^2/w^2)+b*sqrt(a^2-b^2)/sqrt(w^2+b^2))\
            -b*sqrt(a^2-b^2)*sqrt(w^2+b^2)+3*(2*a^2+b^2)*sqrt(a^2-b^2)*asinh(b/w)))",
    parameters: &[H, W, B],
    guard: OUTWARD,
    apply: |term| apply(term, Kernel::Arcsine, "asinh", true, Extent::Segment),
    ..BASE
};

pub(in crate::derive::rules) static WORN_ASIN: Rule = Rule {
    id: "worn-odd-arcsine",
    title: "Odd powers of r times asin(r/R) on a segment",
    pattern: "piecewise(0, r<b, h*((2*r^2-R^2)*asin(r/R)+r*sqrt(R^2-r^2)-(2*b^2-R^2)*asin(b/R)-b*sqrt(R^2-b^2)))",
    equivalent: "piecewise(0, x<b, 4*h*x*(R*ellipe(atan(R*sqrt(x^2-b^2)/(b*sqrt(R^2-x^2))),x^2/R^2)-b*sqrt(x^2-b^2)/sqrt(R^2-b^2)\
            -(R^2-x^2)/R*ellipf(atan(R*sqrt(x^2-b^2)/(b*sqrt(R^2-x^2))),x^2/R^2)+sqrt(x^2-b^2)*asin(b/R)))",
    force: "piecewise(0, a<b, 8/9*E*h*((2*R^2+5*a^2)*(R*ellipe(atan(R*sqrt(a^2-b^2)/(b*sqrt(R^2-a^2))),a^2/R^2)\
            -b*sqrt(a^2-b^2)/sqrt(R^2-b^2))+b*sqrt(a^2-b^2)*sqrt(R^2-b^2)\
            -2*(3*a^2+R^2)*(R^2-a^2)/R*ellipf(atan(R*sqrt(a^2-b^2)/(b*sqrt(R^2-a^2))),a^2/R^2)+3*(2*a^2+b^2)*sqrt(a^2-b^2)*asin(b/R)))",
    parameters: &[H, R, B],
    guard: WORN_INSIDE,
    apply: |term| apply(term, Kernel::Arcsine, "asin", true, Extent::Segment),
    ..BASE
};

/// c r^m K(k r): m ≥ 0 odd or even; odd on segments.
fn apply(term: &Term, own: Kernel, name: &str, odd: bool, extent: Extent) -> Option<Answer> {
    if (term.single()?.exponent.as_integer()? % 2 != 0) != odd {
        return None;
    }
    let plus = matches!(name, "atan" | "asinh");
    kernel(term, own, extent, |function| {
        let [argument] = reading::call(function, name)? else { return None };
        let (k, exponent) = reading::monomial(argument)?;
        // All four functions are odd.
        let (direction, k) = match sign(&k) {
            Sign::Positive => (1, k),
            Sign::Negative => (-1, -k),
            Sign::Zero | Sign::Unknown => return None,
        };
        let field = Field { sigma: if plus { 1 } else { -1 }, square_length: k.power(-2) };
        exponent.is_one().then_some((Expr::integer(direction), field))
    })
}
