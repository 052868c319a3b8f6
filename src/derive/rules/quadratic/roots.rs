//! Powers −1/2, −3/2, … of the quadratic beyond sphere and hyperboloid: elementary for odd m, elliptic for even m.

use super::{BLANK, C, Extent, Family, H, R, RECURRENCE, Reading, Work, power, pressure};
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::rules::{abel, root};
use crate::derive::term::Term;
use crate::expr::{Expr, Number, Sign};
use crate::integrate::segment::Segment;

const S: Parameter = Parameter { name: "b", lowest: 0.5, highest: 4.0 };

const ELLIPTIC: &str = "Legendre's normal form with r = x sin t";
const WORN_ELLIPTIC: &str = "DLMF 19.7(iii), 19.29(i)";
const POSITIVE: &str = "b > 0";
const INSIDE: &str = "r < R";

/// The common part of the rules in this file.
const BASE: Rule = Rule { parameters: &[H, S], guard: POSITIVE, reference: &[RECURRENCE], ..BLANK };

pub(in crate::derive::rules) static ODD: Rule = Rule {
    id: "quadratic-root",
    title: "Odd powers of r over odd powers of √(b² + r²)",
    pattern: "h*(1-1/sqrt(1+r^2/b^2))",
    equivalent: "h*x^2/(b^2+x^2)",
    force: "2*E*h*(b*atan(a/b)-a*b^2/(a^2+b^2))",
    pressure: Some("E*h*b^2/pi*(sqrt(a^2-r^2)/((b^2+r^2)*(a^2+b^2))+atan(sqrt(a^2-r^2)/sqrt(b^2+r^2))/(b^2+r^2)^(3/2))"),
    apply: |term| apply(term, 1, true, Extent::Whole),
    ..BASE
};

pub(in crate::derive::rules) static ODD_BELOW: Rule = Rule {
    id: "quadratic-root-below",
    title: "Odd powers of r over odd powers of √(R² − r²)",
    pattern: "h*(1/sqrt(1-r^2/R^2)-1)",
    equivalent: "h*x^2/(R^2-x^2)",
    force: "2*E*h*(a*R^2/(R^2-a^2)-R*atanh(a/R))",
    pressure: Some("E*h*R^2/pi*(sqrt(a^2-r^2)/((R^2-r^2)*(R^2-a^2))+atanh(sqrt(a^2-r^2)/sqrt(R^2-r^2))/(R^2-r^2)^(3/2))"),
    parameters: &[H, R],
    guard: INSIDE,
    apply: |term| apply(term, -1, true, Extent::Whole),
    ..BASE
};

pub(in crate::derive::rules) static WORN_ODD: Rule = Rule {
    id: "worn-quadratic-root",
    title: "Odd powers of r over odd powers of √(b² + r²) on a segment",
    pattern: "piecewise(0, r<c, h*(1/sqrt(1+c^2/b^2)-1/sqrt(1+r^2/b^2)))",
    equivalent: "piecewise(0, x<c, h*b*x*sqrt(x^2-c^2)/(sqrt(b^2+c^2)*(b^2+x^2)))",
    force: "piecewise(0, a<c, 2*E*h*b*(atan(sqrt(a^2-c^2)/sqrt(b^2+c^2))-b^2*sqrt(a^2-c^2)/(sqrt(b^2+c^2)*(b^2+a^2))))",
    pressure: Some(
        "piecewise(0, a<c, E*h*b/(pi*(b^2+r^2)*sqrt(b^2+c^2))*(max(c,r)*(ellipf(asin(sqrt((a^2-max(c,r)^2)/(a^2-min(c\
             ,r)^2))),min(c,r)^2/max(c,r)^2)-ellipe(asin(sqrt((a^2-max(c,r)^2)/(a^2-min(c,r)^2))),min(c,r)^2/max(c,r)^2))\
             +a*sqrt((a^2-max(c,r)^2)/(a^2-min(c,r)^2))+b^2*ellipf(asin(sqrt((a^2-max(c,r)^2)/(a^2-min(c,r)^2))),min(c\
             ,r)^2/max(c,r)^2)/max(c,r)-a*sqrt(a^2-c^2)*sqrt(a^2-r^2)/(b^2+a^2)-b^2*(b^2+c^2)*sqrt((a^2-max(c,r)^2)/(a^2\
             -min(c,r)^2))/(max(c,r)*(b^2+max(c,r)^2))*(elliprf((max(c,r)^2-min(c,r)^2)/(a^2-min(c,r)^2)*a^2/max(c,r)^2,1\
             ,(max(c,r)^2-min(c,r)^2)/(a^2-min(c,r)^2))-(a^2-max(c,r)^2)*(max(c,r)^2-min(c,r)^2)/(a^2-min(c,r)^2)/(3*(b^2\
             +max(c,r)^2))*elliprj((max(c,r)^2-min(c,r)^2)/(a^2-min(c,r)^2)*a^2/max(c,r)^2,1,(max(c,r)^2-min(c,r)^2)/(a^2\
             -min(c,r)^2),(max(c,r)^2-min(c,r)^2)/(a^2-min(c,r)^2)*(b^2+a^2)/(b^2+max(c,r)^2)))))",
    ),
    parameters: &[H, S, C],
    guard: "r ≥ c",
    apply: |term| apply(term, 1, true, Extent::Segment),
    ..BASE
};

pub(in crate::derive::rules) static WORN_ODD_BELOW: Rule = Rule {
    id: "worn-quadratic-root-below",
    title: "Odd powers of r over odd powers of √(R² − r²) on a segment",
    pattern: "piecewise(0, r<c, h*(1/sqrt(1-r^2/R^2)-1/sqrt(1-c^2/R^2)))",
    equivalent: "piecewise(0, x<c, h*R*x*sqrt(x^2-c^2)/(sqrt(R^2-c^2)*(R^2-x^2)))",
    force: "piecewise(0, a<c, 2*E*h*R*(R^2*sqrt(a^2-c^2)/(sqrt(R^2-c^2)*(R^2-a^2))-atanh(sqrt(a^2-c^2)/sqrt(R^2-c^2))))",
    pressure: Some(
        "piecewise(0, a<c, E*h*R/(pi*(R^2-r^2)*sqrt(R^2-c^2))*(max(c,r)*(ellipf(asin(sqrt((a^2-max(c,r)^2)/(a^2-min(c\
             ,r)^2))),min(c,r)^2/max(c,r)^2)-ellipe(asin(sqrt((a^2-max(c,r)^2)/(a^2-min(c,r)^2))),min(c,r)^2/max(c,r)^2))\
             +a*sqrt((a^2-max(c,r)^2)/(a^2-min(c,r)^2))-R^2*ellipf(asin(sqrt((a^2-max(c,r)^2)/(a^2-min(c,r)^2))),min(c\
             ,r)^2/max(c,r)^2)/max(c,r)+a*sqrt(a^2-c^2)*sqrt(a^2-r^2)/(R^2-a^2)+R^2*(R^2-c^2)*sqrt((a^2-max(c,r)^2)/(a^2\
             -min(c,r)^2))/(max(c,r)*(R^2-max(c,r)^2))*(elliprf((max(c,r)^2-min(c,r)^2)/(a^2-min(c,r)^2)*a^2/max(c,r)^2,1\
             ,(max(c,r)^2-min(c,r)^2)/(a^2-min(c,r)^2))+(a^2-max(c,r)^2)*(max(c,r)^2-min(c,r)^2)/(a^2-min(c,r)^2)/(3*(R^2\
             -max(c,r)^2))*elliprj((max(c,r)^2-min(c,r)^2)/(a^2-min(c,r)^2)*a^2/max(c,r)^2,1,(max(c,r)^2-min(c,r)^2)/(a^2\
             -min(c,r)^2),(max(c,r)^2-min(c,r)^2)/(a^2-min(c,r)^2)*(R^2-a^2)/(R^2-max(c,r)^2)))))",
    ),
    parameters: &[H, R, C],
    guard: "c ≤ r < R",
    apply: |term| apply(term, -1, true, Extent::Segment),
    ..BASE
};

pub(in crate::derive::rules) static EVEN: Rule = Rule {
    id: "arsinh",
    title: "Even powers of r over odd powers of √(b² + r²)",
    pattern: "h*asinh(r/b)",
    equivalent: "h*x/b*ellipk(-x^2/b^2)",
    force: "2*E*h*b*(ellipe(-a^2/b^2)-ellipk(-a^2/b^2))",
    reference: &[RECURRENCE, ELLIPTIC],
    apply: |term| apply(term, 1, false, Extent::Whole),
    ..BASE
};

pub(in crate::derive::rules) static EVEN_BELOW: Rule = Rule {
    id: "arcsine",
    title: "Even powers of r over odd powers of √(R² − r²)",
    pattern: "h*asin(r/R)",
    equivalent: "h*x/R*ellipk(x^2/R^2)",
    force: "2*E*h*R*(ellipk(a^2/R^2)-ellipe(a^2/R^2))",
    parameters: &[H, R],
    guard: INSIDE,
    reference: &[RECURRENCE, ELLIPTIC],
    apply: |term| apply(term, -1, false, Extent::Whole),
    ..BASE
};

pub(in crate::derive::rules) static WORN_EVEN: Rule = Rule {
    id: "worn-arsinh",
    title: "Even powers of r over odd powers of √(b² + r²) on a segment",
    pattern: "piecewise(0, r<c, h*(asinh(r/b)-asinh(c/b)))",
    equivalent: "piecewise(0, x<c, h*x/b*ellipf(atan(b*sqrt(x^2-c^2)/(c*sqrt(b^2+x^2))),-x^2/b^2))",
    force: "piecewise(0, a<c, 2*E*h*(b*ellipe(atan(b*sqrt(a^2-c^2)/(c*sqrt(b^2+a^2))),-a^2/b^2)+c*sqrt(a^2-c^2)/sqrt(b^2+c^2)\
            -b*ellipf(atan(b*sqrt(a^2-c^2)/(c*sqrt(b^2+a^2))),-a^2/b^2)))",
    parameters: &[H, S, C],
    guard: "r ≥ c",
    reference: &[RECURRENCE, WORN_ELLIPTIC],
    apply: |term| apply(term, 1, false, Extent::Segment),
    ..BASE
};

pub(in crate::derive::rules) static WORN_EVEN_BELOW: Rule = Rule {
    id: "worn-arcsine",
    title: "Even powers of r over odd powers of √(R² − r²) on a segment",
    pattern: "piecewise(0, r<c, h*(asin(r/R)-asin(c/R)))",
    equivalent: "piecewise(0, x<c, h*x/R*ellipf(atan(R*sqrt(x^2-c^2)/(c*sqrt(R^2-x^2))),x^2/R^2))",
    force: "piecewise(0, a<c, 2*E*h*(R*ellipf(atan(R*sqrt(a^2-c^2)/(c*sqrt(R^2-a^2))),a^2/R^2)+c*sqrt(a^2-c^2)/sqrt(R^2-c^2)\
            -R*ellipe(atan(R*sqrt(a^2-c^2)/(c*sqrt(R^2-a^2))),a^2/R^2)))",
    parameters: &[H, R, C],
    guard: "c ≤ r < R",
    reference: &[RECURRENCE, WORN_ELLIPTIC],
    apply: |term| apply(term, -1, false, Extent::Segment),
    ..BASE
};

/// c r^m Q^(1/2−k) with whole k > 0; the unbounded sphere and hyperboloid on the whole axis have separate rules.
fn apply(term: &Term, sigma: i64, odd: bool, extent: Extent) -> Option<Answer> {
    if !extent.fits(&term.segment) {
        return None;
    }
    let (reading, exponent) = power(term.single()?)?;
    let k = (&Number::ratio(1, 2) - exponent.as_number()?).to_i64().filter(|k| *k > 0)?;
    let m = reading.exponent;
    let known = m == 1 && k == 1 && term.segment.upper.is_none();
    let singular = m < 0 && term.segment.lower.is_zero();
    if reading.field.sigma != sigma || (m % 2 != 0) != odd || known || singular {
        return None;
    }
    let family = Family { sigma, half: true };
    let tip = (m == 1 && k == 1 && term.segment.lower.is_zero()).then(|| Tip::of(&reading, term.segment.upper.as_ref()));
    let work = Work { reading, segment: &term.segment, family, kernel: None };
    let mut answer = work.answer(|m| family.moment(m, k), (odd && extent == Extent::Whole).then_some(pressure::rooted))?;
    if odd && extent == Extent::Segment && !term.segment.lower.is_zero() {
        answer.pressure = worn_pressure(term, sigma, &answer);
    }
    if let Some(Tip { equivalent, force, cap }) = tip {
        answer.equivalent.within.evaluated = equivalent;
        answer.force.within.evaluated = force;
        answer.force.beyond.evaluated = cap.unwrap_or(answer.force.beyond.evaluated);
    }
    Some(answer)
}

/// The pressure of a segment off the axis by the g that begins at its lower end, less that of the g that begins at its upper end.
fn worn_pressure(term: &Term, sigma: i64, answer: &Answer) -> Option<Branches> {
    let within = Pair::same(abel::beyond_kink(&answer.equivalent.within.shown, &term.segment.lower)?);
    let Some(upper) = &term.segment.upper else { return Some(Branches::endless(within)) };
    if sigma < 0 {
        // The contact may reach beyond the pole.
        return None;
    }
    let rest = Term { parts: term.parts.clone(), segment: Segment { lower: upper.clone(), upper: None } };
    let beyond = apply(&rest, sigma, true, Extent::Segment)?.pressure?;
    Some(Branches { beyond: within.minus(&beyond.within), within })
}

/// The evaluated forms for a sphere or a hyperboloid that ends at a radius: the pieces of the recurrence cancel by (R/a)².
struct Tip {
    /// g within the end, as on the whole axis.
    equivalent: Expr,
    /// F/(2E*) within it.
    force: Expr,
    /// F/(2E*) beyond it, of a sphere.
    cap: Option<Expr>,
}

impl Tip {
    fn of(reading: &Reading, end: Option<&Expr>) -> Self {
        let radius = reading.field.square_length.sqrt();
        let scaled = |own: Expr| &reading.coefficient * own;
        let below = reading.field.sigma < 0;
        let (equivalent, force) = root::computed(if below { Sign::Negative } else { Sign::Positive }, &radius);
        let cap = end.filter(|_| below).map(|end| Expr::call("capped_sphere_force", [end.clone(), Expr::symbol("a"), radius]));
        Self { equivalent: scaled(equivalent), force: scaled(force), cap: cap.map(scaled) }
    }
}
