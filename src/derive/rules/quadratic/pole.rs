//! Whole negative powers of the quadratic: Lorentzian, log-quadratic, arctangent, and the same from a radius outward.

use super::{B, Extent, Family, H, R, RECURRENCE, W, Work, power, pressure};
use crate::derive::rule::{Answer, Rule};
use crate::derive::term::Term;

const WEAR: &str = "wear rule for even profiles";
const OUTWARD: &str = "r ≥ b";
const BELOW: &str = "r < R";

pub(in crate::derive::rules) static ODD: Rule = Rule {
    id: "quadratic-pole",
    title: "Odd powers of r over powers of w² + r²",
    pattern: "h*ln(1+r^2/w^2)",
    equivalent: "2*h*x*asinh(x/w)/sqrt(w^2+x^2)",
    force: "4*E*h*(a-w^2*asinh(a/w)/sqrt(w^2+a^2))",
    pressure: None,
    parameters: &[H, W],
    guard: "w > 0",
    reference: &[RECURRENCE],
    specializes: None,
    apply: |term| apply(term, 1, true, Extent::Whole),
};

pub(in crate::derive::rules) static ODD_BELOW: Rule = Rule {
    id: "quadratic-pole-below",
    title: "Odd powers of r over powers of R² − r²",
    pattern: "-h*ln(1-r^2/R^2)",
    equivalent: "2*h*x*asin(x/R)/sqrt(R^2-x^2)",
    force: "4*E*h*(R^2*asin(a/R)/sqrt(R^2-a^2)-a)",
    pressure: None,
    parameters: &[H, R],
    guard: BELOW,
    reference: &[RECURRENCE],
    specializes: None,
    apply: |term| apply(term, -1, true, Extent::Whole),
};

pub(in crate::derive::rules) static EVEN: Rule = Rule {
    id: "arctangent",
    title: "Even powers of r over powers of w² + r²",
    pattern: "h*atan(r/w)",
    equivalent: "h*pi/2*x/sqrt(w^2+x^2)",
    force: "E*h*pi*w*(1-w/sqrt(w^2+a^2))",
    pressure: Some(
        "E*h/2*(ellipf(atan(sqrt(a^2-r^2)/sqrt(w^2+r^2)),-w^2/r^2)/r-r*ellipe(atan(sqrt(a^2-r^2)/sqrt(w^2+r^2)),-w^2/r^2)/(w^2+r^2))",
    ),
    parameters: &[H, W],
    guard: "w > 0",
    reference: &[RECURRENCE],
    specializes: None,
    apply: |term| apply(term, 1, false, Extent::Whole),
};

pub(in crate::derive::rules) static EVEN_BELOW: Rule = Rule {
    id: "artanh",
    title: "Even powers of r over powers of R² − r²",
    pattern: "h*atanh(r/R)",
    equivalent: "h*pi/2*x/sqrt(R^2-x^2)",
    force: "E*h*pi*R*(R/sqrt(R^2-a^2)-1)",
    pressure: Some(
        "E*h/(2*(R^2-r^2))*(R^2/r*ellipf(atan(sqrt(a^2-r^2)/sqrt(R^2-a^2)),1-R^2/r^2)\
         -r*ellipe(atan(sqrt(a^2-r^2)/sqrt(R^2-a^2)),1-R^2/r^2)+a*sqrt(a^2-r^2)/sqrt(R^2-a^2))",
    ),
    parameters: &[H, R],
    guard: BELOW,
    reference: &[RECURRENCE],
    specializes: None,
    apply: |term| apply(term, -1, false, Extent::Whole),
};

pub(in crate::derive::rules) static WORN_ODD: Rule = Rule {
    id: "worn-quadratic-pole",
    title: "Odd powers of r over powers of w² + r² on a segment",
    pattern: "piecewise(0, r<b, h*ln((w^2+r^2)/(w^2+b^2)))",
    equivalent: "piecewise(0, x<b, 2*h*x*asinh(sqrt(x^2-b^2)/sqrt(w^2+b^2))/sqrt(w^2+x^2))",
    force: "piecewise(0, a<b, 4*E*h*(sqrt(a^2-b^2)-w^2*asinh(sqrt(a^2-b^2)/sqrt(w^2+b^2))/sqrt(w^2+a^2)))",
    pressure: None,
    parameters: &[H, W, B],
    guard: OUTWARD,
    reference: &[RECURRENCE, WEAR],
    specializes: None,
    apply: |term| apply(term, 1, true, Extent::Segment),
};

pub(in crate::derive::rules) static WORN_ODD_BELOW: Rule = Rule {
    id: "worn-quadratic-pole-below",
    title: "Odd powers of r over powers of R² − r² on a segment",
    pattern: "piecewise(0, r<b, h*ln((R^2-b^2)/(R^2-r^2)))",
    equivalent: "piecewise(0, x<b, 2*h*x*asin(sqrt(x^2-b^2)/sqrt(R^2-b^2))/sqrt(R^2-x^2))",
    force: "piecewise(0, a<b, 4*E*h*(R^2*asin(sqrt(a^2-b^2)/sqrt(R^2-b^2))/sqrt(R^2-a^2)-sqrt(a^2-b^2)))",
    pressure: None,
    parameters: &[H, R, B],
    guard: "b ≤ r < R",
    reference: &[RECURRENCE, WEAR],
    specializes: None,
    apply: |term| apply(term, -1, true, Extent::Segment),
};

pub(in crate::derive::rules) static WORN_EVEN: Rule = Rule {
    id: "worn-arctangent",
    title: "Even powers of r over powers of w² + r² on a segment",
    pattern: "piecewise(0, r<b, h*(atan(r/w)-atan(b/w)))",
    equivalent: "piecewise(0, x<b, h*x*atan(w*sqrt(x^2-b^2)/(b*sqrt(w^2+x^2)))/sqrt(w^2+x^2))",
    force: "piecewise(0, a<b, 2*E*h*w*(acos(b/a)-w*atan(w*sqrt(a^2-b^2)/(b*sqrt(w^2+a^2)))/sqrt(w^2+a^2)))",
    pressure: None,
    parameters: &[H, W, B],
    guard: OUTWARD,
    reference: &[RECURRENCE],
    specializes: None,
    apply: |term| apply(term, 1, false, Extent::Segment),
};

pub(in crate::derive::rules) static WORN_EVEN_BELOW: Rule = Rule {
    id: "worn-artanh",
    title: "Even powers of r over powers of R² − r² on a segment",
    pattern: "piecewise(0, r<b, h*(atanh(r/R)-atanh(b/R)))",
    equivalent: "piecewise(0, x<b, h*x*atan(R*sqrt(x^2-b^2)/(b*sqrt(R^2-x^2)))/sqrt(R^2-x^2))",
    force: "piecewise(0, a<b, 2*E*h*R*(R*atan(R*sqrt(a^2-b^2)/(b*sqrt(R^2-a^2)))/sqrt(R^2-a^2)-acos(b/a)))",
    pressure: None,
    parameters: &[H, R, B],
    guard: "b ≤ r < R",
    reference: &[RECURRENCE],
    specializes: None,
    apply: |term| apply(term, -1, false, Extent::Segment),
};

/// c r^m Q^(−k) with whole k > 0 and m ≥ 0, odd or even.
fn apply(term: &Term, sigma: i64, odd: bool, extent: Extent) -> Option<Answer> {
    if !extent.fits(&term.segment) {
        return None;
    }
    let (reading, exponent) = power(term.single()?)?;
    let k = -exponent.as_integer().filter(|p| *p < 0)?;
    if reading.field.sigma != sigma || (reading.exponent % 2 != 0) != odd {
        return None;
    }
    let family = Family { sigma, half: false };
    let work = Work { reading, segment: &term.segment, family, kernel: None };
    work.answer(|m| family.moment(m, k), (!odd && extent == Extent::Whole).then_some(pressure::elliptic))
}
