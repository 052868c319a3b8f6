//! However a profile is typed, its slope comes to the same terms.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use common::formulas::formula;
use sneddon::expr::normal::{NormalTerm, normal_terms};
use sneddon::expr::{Expr, Formula, Symbol, derivative};
use std::collections::BTreeMap;

/// Profiles; those on one line are spellings of one slope.
const SPELLINGS: &[&[&str]] = &[
    // Sines and cosines.
    &["1-cos(k*r)", "2*sin(k*r/2)^2", "1-cos(-k*r)", "sin(k*r/2)^2-cos(k*r/2)^2", "2-2*cos(k*r/2)^2", "1+sin(k*r-pi/2)"],
    &["h*(1-cos(k*r))", "h - h*cos(k*r)", "2*h*sin(k*r/2)^2", "h*(1-cos(k*r)^2)-h*cos(k*r)*(1-cos(k*r))"],
    &["sin(k*r)^2", "(1-cos(2*k*r))/2", "1-cos(k*r)^2", "sin(k*r)*sin(k*r)", "1/2-cos(k*r)^2+1/2"],
    &["sin(k*r)*cos(k*r)", "sin(2*k*r)/2", "cos(k*r)*sin(r*k)", "0.5*sin(2*r*k)"],
    &["r*sin(k*r)^3", "r*(3*sin(k*r)-sin(3*k*r))/4", "r*sin(k*r)-r*sin(k*r)*cos(k*r)^2"],
    &["sin(k*r+pi/6)", "sqrt(3)/2*sin(k*r)+cos(k*r)/2", "cos(k*r-pi/3)"],
    &["h*sin(k*r+q)", "h*sin(k*r)*cos(q)+h*cos(k*r)*sin(q)", "h*sin(q+k*r)"],
    &["tan(r/b)", "sin(r/b)/cos(r/b)"],
    // Hyperbolic functions and exponentials.
    &["cosh(k*r)-1", "2*sinh(k*r/2)^2", "(exp(k*r)+exp(-k*r))/2", "cosh(k*r/2)^2+sinh(k*r/2)^2", "(e^(k*r)+1/e^(k*r))/2"],
    &["sinh(k*r)", "2*sinh(k*r/2)*cosh(k*r/2)", "(exp(k*r)-exp(-k*r))/2", "exp(k*r)-cosh(k*r)"],
    &["exp(k*r)", "cosh(k*r)+sinh(k*r)", "exp(k*r/2)^2", "e^(k*r)", "exp(k*r+1)/e", "exp(2*k*r)*exp(-k*r)", "1/exp(-k*r)"],
    &["exp(-k*r)*sinh(c*r)", "(exp((c-k)*r)-exp(-(c+k)*r))/2"],
    &["1-exp(-r^2/w^2)", "1-e^(-(r/w)^2)", "1-1/exp((r/w)^2)", "-exp(-r^2/w^2)", "1-exp(-r/w)^(r/w)", "1-exp(1-r^2/w^2)*exp(-1)"],
    &["2^r", "exp(r*ln(2))", "4^(r/2)"],
    &["b^(r/w)", "exp(r*ln(b)/w)"],
    &["tanh(r/w)", "sinh(r/w)/cosh(r/w)", "1-2/(exp(2*r/w)+1)+tanh(r/w)-1+2/(exp(2*r/w)+1)"],
    &["tanh(r/w)^2", "1-1/cosh(r/w)^2", "tanh(r/w)*sinh(r/w)/cosh(r/w)"],
    // Logarithms.
    &["r^2*ln(r)", "r^2*ln(r^2)/2", "-r^2*ln(1/r)", "r^2*ln(2*r)-r^2*ln(2)", "r^2*ln(r/b)+r^2*ln(b)", "r^2*ln(sqrt(r))*2"],
    &["r^2*ln(r/b)", "r^2*(ln(r)-ln(b))", "-r^2*ln(b/r)", "r^2*ln(r^2/b^2)/2", "r^2*ln(3*r/b)-r^2*ln(3)"],
    &[
        "r^2*ln(1+r/b)",
        "r^2*ln((b+r)/b)",
        "r^2*(ln(b+r)-ln(b))",
        "-r^2*ln(b/(b+r))",
        "r^2*ln((b+r)^2/b^2)/2",
        "r^2*ln(6*b+6*r)-r^2*ln(6)-r^2*ln(b)",
    ],
    &["h*ln(1+r^2/w^2)", "h*ln(w^2+r^2)", "2*h*ln(sqrt(1+(r/w)^2))", "-h*ln(w^2/(r^2+w^2))"],
    &["r^2*ln(1-r/R)", "r^2*ln(R-r)-r^2*ln(R)", "r^2*ln((R-r)/R)", "-r^2*ln(1/(1-r/R))"],
    &["r^3*ln((R+r)/(R-r))", "2*r^3*atanh(r/R)", "r^3*ln(1+r/R)-r^3*ln(1-r/R)", "r^3*(ln(R+r)-ln(R-r))"],
    &["r^3*ln(1-r^2/R^2)", "r^3*ln(1+r/R)+r^3*ln(1-r/R)", "r^3*ln((R-r)*(R+r))-2*r^3*ln(R)", "2*r^3*ln(sqrt(1-r^2/R^2))"],
    &["r^3*ln(1+r/R)", "r^3*(ln(1-r^2/R^2)/2+atanh(r/R))", "r^3*ln(1-(r/R)^2)-r^3*ln(1-r/R)"],
    &["r*asinh(r/w)", "r*ln(r/w+sqrt(1+r^2/w^2))", "r*ln(r+sqrt(r^2+w^2))-r*ln(w)", "-r*ln(sqrt(1+r^2/w^2)-r/w)"],
    &["asinh(r/w)", "ln(r/w+sqrt(1+r^2/w^2))", "ln(r+sqrt(r^2+w^2))", "ln(r+sqrt(r^2+w^2))-ln(w)"],
    // Inverse functions.
    &["r*atan(r/w)", "r*(pi/2-atan(w/r))", "r*asin(r/sqrt(r^2+w^2))", "r*acos(w/sqrt(w^2+r^2))", "r*pi/2-r*atan(w*r^-1)"],
    &["r^2*asin(r/R)", "r^2*(pi/2-acos(r/R))", "r^2*atan(r/sqrt(R^2-r^2))", "-r^2*asin(-r/R)", "r^2*acos(sqrt(1-r^2/R^2))"],
    &["r^2*atanh(r/R)", "r^2*asinh(r/sqrt(R^2-r^2))"],
    &["atan(r/w)", "pi/2-atan(w/r)"],
    // Bessel functions.
    &["1-besselj(0,k*r)", "h-besselj(0,r*k)+1-h"],
    &["k*r*besselj(2,k*r)", "2*besselj(1,k*r)-k*r*besselj(0,k*r)"],
    &["r^2*besselj(3,k*r)", "r*4/k*besselj(2,k*r)-r^2*besselj(1,k*r)"],
    &["r^2*besseli(2,k*r)", "r^2*besseli(0,k*r)-2*r/k*besseli(1,k*r)"],
    // Decimals.
    &["0.5*r^1.5", "r^(3/2)/2", "5e-1*r*sqrt(r)"],
    &["r^2/(2*0.25)", "2*r^2", "r*(r+r)"],
];

/// Spellings that need partial fractions, roots in one form, or factors of polynomials.
const ALGEBRA: &[&[&str]] = &[
    // Whole powers in denominators.
    &["r^3/(r^2+w^2)", "r-w^2*r/(r^2+w^2)", "r/(1+w^2/r^2)", "r*(r/w)^2/(1+(r/w)^2)"],
    &["1/(b+r)", "(c+r)/((b+r)*(c+r))", "(c+r)/(b*c+(b+c)*r+r^2)", "1/b/(1+r/b)", "2/(2*b+2*r)"],
    &["A/(b+r)+C/(c+r)", "(A*(c+r)+C*(b+r))/((b+r)*(c+r))", "(A*c+C*b+(A+C)*r)/(b*c+b*r+c*r+r^2)"],
    &["1/((b+r)*(c+r))", "(1/(b+r)-1/(c+r))/(c-b)", "1/(b*c+b*r+c*r+r^2)"],
    &["1/(r+b)^2", "1/(r^2+2*b*r+b^2)", "(1/(r+b))^2", "1/b^2/(1+r/b)^2"],
    &["1-w^4/(r^2+w^2)^2", "1-w^4/(r^4+2*r^2*w^2+w^4)", "1-1/(1+(r/w)^2)^2", "r^2*(r^2+2*w^2)/(r^2+w^2)^2"],
    &["r^2/(R^2-r^2)", "r^2/((R-r)*(R+r))", "R/2*(1/(R-r)+1/(R+r))-1", "R^2/(R^2-r^2)", "-r^2/(r^2-R^2)"],
    &["r/(R-r)", "R/(R-r)-1", "r*(R+r)/(R^2-r^2)", "r/R/(1-r/R)"],
    &["r^4/(w^4-r^4)", "r^4/((w^2-r^2)*(w^2+r^2))", "w^2/2*(1/(w^2-r^2)+1/(w^2+r^2))-1"],
    &["r^2/(b+r)", "r-b+b^2/(b+r)", "r^2/b/(1+r/b)", "r-b*r/(b+r)"],
    &["1/(r*(b+r))", "(1/r-1/(b+r))/b", "1/(r^2+b*r)"],
    &["r/(b+r)/(w^2+r^2)", "(w^2+b*r)/(b^2+w^2)/(w^2+r^2)-b/(b^2+w^2)/(b+r)"],
    &["1/(2-3*r+r^2)", "1/(r-2)-1/(r-1)", "1/((1-r)*(2-r))"],
    &["C*r^2/(alpha+beta*r^2)", "C/beta-C*alpha/beta/(alpha+beta*r^2)"],
    // Roots.
    &[
        "R-sqrt(R^2-r^2)",
        "R*(1-sqrt(1-(r/R)^2))",
        "r^2/(R+sqrt(R^2-r^2))",
        "-sqrt((R-r)*(R+r))",
        "-sqrt(R-r)*sqrt(R+r)",
        "-R*sqrt((R-r)/R)*sqrt((R+r)/R)",
    ],
    &["h*sqrt(1+r^2/b^2)", "h/b*sqrt(b^2+r^2)", "h/(2*b)*sqrt(4*b^2+4*r^2)", "h*(1+r^2/b^2)/sqrt(1+r^2/b^2)", "h*r/b*sqrt(1+b^2/r^2)"],
    &["sqrt((R-r)/(R+r))", "(R-r)/sqrt(R^2-r^2)", "sqrt(R-r)/sqrt(R+r)", "sqrt(R^2-r^2)/(R+r)"],
    &["1/sqrt(1+r^2/w^2)", "w/sqrt(w^2+r^2)", "sqrt(w^2/(w^2+r^2))", "1/((w^2+r^2)/w^2)^0.5", "w*sqrt(w^2+r^2)/(w^2+r^2)"],
    &["(1+r^2/b^2)^p", "b^(-2*p)*(b^2+r^2)^p", "(b^2/(b^2+r^2))^(-p)", "(1+r^2/b^2)*(1+r^2/b^2)^(p-1)"],
    &["r^2*(b^2+r^2)^p", "(b^2+r^2)^(p+1)-b^2*(b^2+r^2)^p", "r^2*(b^2+r^2)*(b^2+r^2)^(p-1)"],
    &["(1+r/b)^0.3", "b^(-3/10)*(b+r)^(3/10)", "(b/(b+r))^-0.3"],
    &["sqrt(b+r)", "sqrt(b)*sqrt(1+r/b)", "(b+r)/sqrt(b+r)"],
    &["r^3*sqrt(1-r^2/R^2)", "r^3*(1-r^2/R^2)/sqrt(1-r^2/R^2)", "r^3/R*sqrt(R-r)*sqrt(R+r)"],
    &["sqrt(r^2/(b+r))", "r/sqrt(b+r)", "r*sqrt(1/(b+r))"],
    &["sqrt(r^2+2*b*r+b^2)", "b+r"],
    &["r^n/(w^2+r^2)", "r^(n-2)-w^2*r^(n-2)/(w^2+r^2)"],
    &["r*sqrt(r)", "r^(3/2)", "sqrt(r^3)", "r^1.5"],
    // Logarithms of factors.
    &["r*ln(r^2+2*b*r+b^2)/2", "r*ln(b+r)"],
    &["r*ln((b+r)*(c+r))", "r*ln(b+r)+r*ln(c+r)", "r*ln(b*c+(b+c)*r+r^2)"],
    &["r*ln(w^4-r^4)", "r*ln(w^2-r^2)+r*ln(w^2+r^2)"],
    &["r*ln((1+r/b)/(1+r/c))", "r*ln(1+r/b)-r*ln(1+r/c)", "r*ln(c*(b+r)/(b*(c+r)))"],
    // Expanded and not.
    &["(r-b)^2/(2*R)", "(r^2-2*b*r+b^2)/(2*R)", "(b-r)*(b-r)/2/R"],
    &["h*(1+r/b)^3", "h*(b+r)^3/b^3", "h+3*h*r/b+3*h*r^2/b^2+h*r^3/b^3"],
];

fn expression(text: &str) -> Expr {
    match formula(text) {
        Formula::Closed(expr) => expr,
        _ => panic!("{text} has pieces"),
    }
}

/// The terms of the slope by exponent and kernel.
fn terms(text: &str) -> BTreeMap<(Expr, Expr), Expr> {
    let r = Symbol::new("r");
    let slope = derivative(&expression(text), &r).unwrap();
    let list = normal_terms(&slope, &r).unwrap_or_else(|error| panic!("{text}: {error}"));
    list.into_iter().map(|NormalTerm { coefficient, exponent, kernel }| ((exponent, kernel), coefficient)).collect()
}

fn all_the_same(table: &[&[&str]]) {
    let mut failures = Vec::new();
    for group in table {
        let expected = terms(group[0]);
        for other in &group[1..] {
            let found = terms(other);
            if found != expected {
                failures.push(format!("{} and {other}:\n    {expected:?}\n    {found:?}", group[0]));
            }
        }
    }
    assert!(failures.is_empty(), "{} spellings differ\n{}", failures.len(), failures.join("\n"));
}

#[test]
fn spellings_of_one_profile_have_one_form() {
    all_the_same(SPELLINGS);
}

#[test]
fn algebraic_spellings_of_one_profile_have_one_form() {
    all_the_same(ALGEBRA);
}
