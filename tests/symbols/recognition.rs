//! However a profile is typed, its slope comes to the same terms.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon::expr::normal::{NormalTerm, normal_terms};
use sneddon::expr::{Expr, Formula, Symbol, derivative};
use sneddon_checks::formulas::{formula, number};
use sneddon_checks::random::Stream;
use std::collections::BTreeMap;

/// How many random profiles are spelled twice.
const DRAWS: usize = 300;

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

/// Functions of inverse functions, and the same without.
const INVERSES: &[&[&str]] = &[
    &[
        "r*sin(asin(r/b))",
        "r*cos(acos(r/b))",
        "r*tan(atan(r/b))",
        "r*sinh(asinh(r/b))",
        "r*cosh(acosh(r/b))",
        "r*tanh(atanh(r/b))",
        "r^2/b",
    ],
    &["r*cos(asin(r/b))", "r*sin(acos(r/b))", "r*sqrt(1-r^2/b^2)", "r/cosh(atanh(r/b))"],
    &["r*tan(asin(r/b))", "r*sinh(atanh(r/b))", "r^2/sqrt(b^2-r^2)", "r/tan(acos(r/b))"],
    &["r^2*tan(acos(r/b))", "r*sqrt(b^2-r^2)"],
    &["r*sin(atan(r/b))", "r*tanh(asinh(r/b))", "r^2/sqrt(b^2+r^2)"],
    &["r*cos(atan(r/b))", "r/cosh(asinh(r/b))", "b*r/sqrt(b^2+r^2)"],
    &["r*sin(2*asin(r/b))", "2*r^2/b*sqrt(1-r^2/b^2)", "-r*sin(-2*asin(r/b))"],
    &["r*cos(3*acos(r/b))", "r*(4*(r/b)^3-3*r/b)"],
    &["r*cosh(2*asinh(r/b))", "r*(1+2*(r/b)^2)"],
    &["r*tan(2*atan(r/b))", "2*r^2/b/(1-(r/b)^2)"],
    &["r*sin(asin(r/b)+pi/6)", "r^2/b*sqrt(3)/2+r/2*sqrt(1-r^2/b^2)"],
    &["r*tan(pi/2-r/b)", "-r*tan(r/b+pi/2)", "-r*tan(r/b-3*pi/2)"],
    &["r*tan(r/b+pi)", "r*tan(r/b-2*pi)", "r*tan(r/b)"],
    &["r*exp(asinh(r/b))", "r*(r/b+sqrt(1+(r/b)^2))"],
    &["r*exp(-2*asinh(r/b))", "r*(sqrt(1+(r/b)^2)-r/b)^2"],
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

#[test]
fn functions_of_inverse_functions_are_algebraic() {
    all_the_same(INVERSES);
}

/// Draws spellings: what it is asked for is fixed, how it is written is not.
struct Writer {
    stream: Stream,
    depth: u32,
}

impl Writer {
    fn one_of(&mut self, list: &[String]) -> String {
        list[self.stream.whole(0, list.len() as i64 - 1) as usize].clone()
    }

    fn flip(&mut self) -> bool {
        self.stream.whole(0, 1) == 1
    }

    /// r/w.
    fn ratio(&mut self, w: &str) -> String {
        self.one_of(&[
            format!("(r/{w})"),
            format!("(r*{w}^-1)"),
            format!("(1/{w}*r)"),
            format!("(2*r/(2*{w}))"),
            format!("(0.5*r/(0.5*{w}))"),
            format!("(1/({w}/r))"),
        ])
    }

    /// u².
    fn square(&mut self, u: &str) -> String {
        self.one_of(&[format!("({u})^2"), format!("(({u})*({u}))"), format!("(1/({u})^-2)"), format!("({u})^3/({u})")])
    }

    /// u + v in some order.
    fn sum(&mut self, u: &str, v: &str) -> String {
        self.one_of(&[
            format!("({u}+{v})"),
            format!("({v}+{u})"),
            format!("({v}-(-({u})))"),
            format!("(2*({u})+2*({v}))/2"),
            format!("({u}+3*r+{v}-r*3)"),
        ])
    }

    /// 1 ± (r/w)².
    fn one_and_square(&mut self, w: &str, sign: &str) -> String {
        let ratio = self.ratio(w);
        let square = self.square(&ratio);
        let mut list = vec![
            format!("(1{sign}{square})"),
            format!("({w}^2{sign}r^2)/{w}^2"),
            format!("(1{sign}r*r/{w}/{w})"),
            format!("(4*{w}^2{sign}4*r^2)/(4*{w}*{w})"),
        ];
        if sign == "-" {
            list.push(format!("(({w}-r)*({w}+r)/{w}^2)"));
            list.push(format!("(1-{ratio})*(1+r/{w})"));
        }
        self.one_of(&list)
    }

    /// √u.
    fn root(&mut self, u: &str) -> String {
        self.one_of(&[
            format!("sqrt({u})"),
            format!("({u})^0.5"),
            format!("(({u})/sqrt({u}))"),
            format!("1/sqrt(1/({u}))"),
            format!("sqrt(4*({u}))/2"),
        ])
    }

    fn logarithm(&mut self, u: &str) -> String {
        self.one_of(&[
            format!("ln({u})"),
            format!("(-ln(1/({u})))"),
            format!("ln(({u})^2)/2"),
            format!("2*ln(sqrt({u}))"),
            format!("(ln(3*({u}))-ln(3))"),
        ])
    }

    fn exponential(&mut self, u: &str) -> String {
        self.one_of(&[
            format!("exp({u})"),
            format!("e^({u})"),
            format!("exp(({u})/2)^2"),
            format!("1/exp(-({u}))"),
            format!("exp(1+{u})/e"),
            format!("exp(3*({u}))*exp(-2*({u}))"),
        ])
    }

    /// One of the families, by number; the same number is the same function.
    fn kernel(&mut self, family: i64) -> String {
        let (w, big) = ("w", "R");
        match family {
            0 => "1".into(),
            1 => self.logarithm("r"),
            2 => {
                let ratio = self.ratio("b");
                let own = self.sum("1", &ratio);
                if self.flip() { self.logarithm(&own) } else { "(ln(b+r)-ln(b))".into() }
            }
            3 => {
                let own = self.one_and_square(w, "+");
                self.logarithm(&own)
            }
            4 => {
                let own = self.one_and_square(big, "-");
                if self.flip() {
                    self.one_of(&[format!("ln({own})"), format!("(-ln(1/({own})))"), format!("2*ln(sqrt({own}))")])
                } else {
                    "(ln(1-r/R)+ln(R+r)-ln(R))".into()
                }
            }
            5 => {
                let own = self.one_and_square(w, "+");
                self.root(&own)
            }
            6 => {
                let own = self.one_and_square(big, "-");
                self.root(&own)
            }
            7 => {
                let own = self.one_and_square(w, "+");
                self.one_of(&[
                    format!("({own})^p"),
                    format!("({own})*({own})^(p-1)"),
                    format!("(1/({own}))^(-p)"),
                    "(w^2+r^2)^p*w^(-2*p)".into(),
                ])
            }
            8 => {
                let ratio = self.ratio(w);
                self.one_of(&[
                    format!("atan({ratio})"),
                    format!("(pi/2-atan(1/{ratio}))"),
                    "(pi/2-atan(w/r))".into(),
                    "asin(r/sqrt(r^2+w^2))".into(),
                    format!("(-atan(-{ratio}))"),
                ])
            }
            9 => {
                let ratio = self.ratio(w);
                self.one_of(&[format!("asinh({ratio})"), format!("ln({ratio}+sqrt(1+r^2/w^2))"), "(ln(r+sqrt(r^2+w^2))-ln(w))".into()])
            }
            10 => {
                let ratio = self.ratio(big);
                self.one_of(&[format!("asin({ratio})"), format!("(pi/2-acos({ratio}))"), "atan(r/sqrt(R^2-r^2))".into()])
            }
            11 => {
                let ratio = self.ratio(big);
                self.one_of(&[format!("atanh({ratio})"), "ln((R+r)/(R-r))/2".into(), "(ln(1+r/R)-ln(1-r/R))/2".into()])
            }
            12 => self.one_of(&[
                "cos(k*r)".into(),
                "(1-2*sin(k*r/2)^2)".into(),
                "sin(k*r+pi/2)".into(),
                "(cos(k*r/2)^2-sin(k*r/2)^2)".into(),
                "(2*cos(0.5*k*r)^2-1)".into(),
            ]),
            13 => self.one_of(&["sin(k*r)".into(), "2*sin(k*r/2)*cos(k*r/2)".into(), "cos(k*r-pi/2)".into(), "(-sin(-r*k))".into()]),
            14 => self.one_of(&["sin(k*r)^2".into(), "(1-cos(k*r)^2)".into(), "(1-cos(2*k*r))/2".into(), "sin(k*r)*sin(k*r)".into()]),
            15 => self.exponential("-k*r"),
            16 => {
                let ratio = self.ratio(w);
                let square = self.square(&ratio);
                self.exponential(&format!("-{square}"))
            }
            17 => self.one_of(&[
                "cosh(k*r)".into(),
                "(exp(k*r)+exp(-k*r))/2".into(),
                "(1+2*sinh(k*r/2)^2)".into(),
                "(2*cosh(k*r/2)^2-1)".into(),
            ]),
            18 => self.one_of(&["besselj(0,k*r)".into(), "besselj(0,r*k)".into()]),
            19 => self.one_of(&["besseli(1,k*r)".into(), "besseli(1,r/(1/k))".into()]),
            20 => self.one_of(&[
                "1/(b+r)".into(),
                "1/(b*(1+r/b))".into(),
                "(c+r)/((b+r)*(c+r))".into(),
                "(b+r)/(b^2+2*b*r+r^2)".into(),
                "(b-r)/(b^2-r^2)".into(),
            ]),
            21 => self.one_of(&["1/((b+r)*(c+r))".into(), "1/(b*c+(b+c)*r+r^2)".into(), "(1/(b+r)-1/(c+r))/(c-b)".into()]),
            22 => {
                let own = self.one_and_square(w, "+");
                self.one_of(&[
                    format!("1/({own})"),
                    "w^2/(r^2+w^2)".into(),
                    "(1-r^2/(r^2+w^2))".into(),
                    "w^2*(w^2+r^2)/(r^4+2*r^2*w^2+w^4)".into(),
                ])
            }
            23 => {
                let own = self.one_and_square(big, "-");
                self.one_of(&[format!("1/({own})"), "R/2*(1/(R-r)+1/(R+r))".into(), "(1+r^2/(R^2-r^2))".into()])
            }
            _ => self.one_of(&["erf(r/w)".into(), "erf(r*w^-1)".into()]),
        }
    }

    /// Coefficient · r^m · kernel, and what leaves its value unchanged.
    fn term(&mut self, coefficient: &str, m: i64, family: i64) -> String {
        let kernel = self.kernel(family);
        let power = if m == 0 {
            "1".into()
        } else {
            self.one_of(&[format!("r^{m}"), format!("r^{}*r", m - 1), format!("sqrt(r^{})", 2 * m), format!("(1/r^-{m})")])
        };
        let own = match self.stream.whole(0, 3) {
            0 => format!("{coefficient}*{power}*{kernel}"),
            1 => format!("({power}*({kernel})*{coefficient})"),
            2 => format!("({power}*({kernel}+1)-{power})*{coefficient}"),
            _ => format!("(w*{coefficient}*{power}*({kernel}))/w"),
        };
        if self.depth == 0 || self.flip() {
            return own;
        }
        self.depth -= 1;
        let stray = self.stream.whole(0, 24);
        let (once, again) = (self.kernel(stray), self.kernel(stray));
        format!("({own}+{once}-({again}))")
    }
}

/// Coefficients, powers of r and families.
fn plan(stream: &mut Stream) -> Vec<(String, i64, i64)> {
    let coefficients = ["h", "2", "0.75", "h/w", "1/3", "(h+2*q)", "sqrt(h)"];
    (0..stream.whole(1, 2)).map(|_| ((*stream.pick::<&str>(&coefficients)).to_owned(), stream.whole(0, 3), stream.whole(0, 24))).collect()
}

fn written(plan: &[(String, i64, i64)], seed: u64) -> String {
    let mut writer = Writer { stream: Stream::new(seed), depth: 1 };
    let mut parts: Vec<String> = plan.iter().map(|(c, m, family)| format!("({})", writer.term(c, *m, *family))).collect();
    if writer.flip() {
        parts.reverse();
    }
    parts.join("+")
}

/// Random profiles: the terms add up to f′, and another spelling has the same ones.
#[test]
fn random_spellings_have_one_form_and_the_value_of_the_slope() {
    let mut stream = Stream::new(41);
    let r = Symbol::new("r");
    let mut failures = Vec::new();
    for _ in 0..DRAWS {
        let plan = plan(&mut stream);
        let (first, second) = (written(&plan, stream.bits()), written(&plan, stream.bits()));
        let (one, two) = (terms(&first), terms(&second));
        if one != two {
            failures.push(format!("{first}\n{second}\n    {one:?}\n    {two:?}"));
        }
        for (text, list) in [(&first, &one), (&second, &two)] {
            let slope = derivative(&expression(text), &r).unwrap();
            let parts: Vec<Expr> = list.iter().map(|((m, kernel), c)| c * Expr::from(r.clone()).pow(m) * kernel).collect();
            for _ in 0..3 {
                let mut draw = |low: f64, high: f64| stream.short(low, high);
                let values = [
                    ("r", draw(0.2, 2.9)),
                    ("R", draw(3.1, 5.0)),
                    ("w", draw(0.6, 2.0)),
                    ("b", draw(0.4, 1.2)),
                    ("c", draw(1.4, 3.0)),
                    ("k", draw(0.4, 1.5)),
                    ("h", draw(0.1, 2.0)),
                    ("q", draw(0.2, 1.0)),
                    ("p", draw(0.3, 1.7)),
                ];
                let found: Vec<f64> = parts.iter().map(|part| number(part, &values)).collect();
                let (typed, total) = (number(&slope, &values), found.iter().sum::<f64>());
                let size =
                    slope.terms().iter().map(|part| number(part, &values).abs()).chain(found.iter().map(|part| part.abs())).sum::<f64>();
                assert!((typed - total).abs() <= 1e-9 * size, "{text} at {values:?}: {typed} is not {total}: {list:?}");
            }
        }
    }
    assert!(failures.is_empty(), "{} of {DRAWS} spellings differ\n{}", failures.len(), failures.join("\n"));
}
