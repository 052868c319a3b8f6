//! Real and symbolic powers of the quadratic, by Gauss's hypergeometric function.

use super::{BLANK, C, Extent, H, R, field};
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::rules::{kappa, reading};
use crate::derive::term::Term;
use crate::expr::{Condition, Expr, Number, Sign, Symbol, normal, sign};
use crate::integrate::segment::Segment;

const S: Parameter = Parameter { name: "b", lowest: 0.8, highest: 4.0 };
const P: Parameter = Parameter { name: "p", lowest: 1.62, highest: 1.86 };

const GAUSS: &str = "Euler's integral of the hypergeometric function, DLMF 15.6.1";

/// The common part of the rules in this file.
const BASE: Rule = Rule { parameters: &[H, S, P], guard: "p neither whole nor half", reference: &[GAUSS], ..BLANK };

pub(in crate::derive::rules) static WHOLE: Rule = Rule {
    id: "binomial",
    title: "Powers of r times a real power of b² + r²",
    pattern: "h*((1+r^2/b^2)^p-1)",
    equivalent: "h*(hyp2f1(-p,1,1/2,-x^2/b^2)-1)",
    force: "2*E*h*a*(hyp2f1(-p,1,1/2,-a^2/b^2)-hyp2f1(-p,1,3/2,-a^2/b^2))",
    apply: |term| apply(term, Sign::Positive, Extent::Whole),
    ..BASE
};

pub(in crate::derive::rules) static WHOLE_BELOW: Rule = Rule {
    id: "binomial-below",
    title: "Powers of r times a real power of R² − r²",
    pattern: "h*(1-(1-r^2/R^2)^p)",
    equivalent: "h*(1-hyp2f1(-p,1,1/2,x^2/R^2))",
    force: "2*E*h*a*(hyp2f1(-p,1,3/2,a^2/R^2)-hyp2f1(-p,1,1/2,a^2/R^2))",
    parameters: &[H, R, P],
    guard: "r < R; p neither whole nor half",
    apply: |term| apply(term, Sign::Negative, Extent::Whole),
    ..BASE
};

pub(in crate::derive::rules) static WORN: Rule = Rule {
    id: "worn-binomial",
    title: "Odd powers of r times a real power of b² + r² on a segment",
    pattern: "piecewise(0, r<c, h*((1+r^2/b^2)^p-(1+c^2/b^2)^p))",
    equivalent: "piecewise(0, x<c, 2*h*p*x*sqrt(x^2-c^2)/b^2*(1+c^2/b^2)^(p-1)*hyp2f1(1-p,1,3/2,-(x^2-c^2)/(b^2+c^2)))",
    force: "piecewise(0, a<c, 4*E*h*p*sqrt(a^2-c^2)/b^2*(1+c^2/b^2)^(p-1)*(c^2*hyp2f1(1-p,1,3/2,-(a^2-c^2)/(b^2+c^2))\
            +2/3*(a^2-c^2)*hyp2f1(1-p,2,5/2,-(a^2-c^2)/(b^2+c^2))))",
    parameters: &[H, S, P, C],
    guard: "r ≥ c; p neither whole nor half",
    reference: &[GAUSS, "wear rule for even profiles"],
    apply: |term| apply(term, Sign::Positive, Extent::Segment),
    ..BASE
};

pub(in crate::derive::rules) static WORN_BELOW: Rule = Rule {
    id: "worn-binomial-below",
    title: "Odd powers of r times a real power of R² − r² on a segment",
    pattern: "piecewise(0, r<c, h*((1-c^2/R^2)^p-(1-r^2/R^2)^p))",
    equivalent: "piecewise(0, x<c, 2*h*p*x*sqrt(x^2-c^2)/R^2*(1-c^2/R^2)^(p-1)*hyp2f1(1-p,1,3/2,(x^2-c^2)/(R^2-c^2)))",
    force: "piecewise(0, a<c, 4*E*h*p*sqrt(a^2-c^2)/R^2*(1-c^2/R^2)^(p-1)*(c^2*hyp2f1(1-p,1,3/2,(a^2-c^2)/(R^2-c^2))\
            +2/3*(a^2-c^2)*hyp2f1(1-p,2,5/2,(a^2-c^2)/(R^2-c^2))))",
    parameters: &[H, R, P, C],
    guard: "c ≤ r < R; p neither whole nor half",
    reference: &[GAUSS, "wear rule for even profiles"],
    apply: |term| apply(term, Sign::Negative, Extent::Segment),
    ..BASE
};

/// c r^m (α + βr²)^p, with the quadratic unchanged.
struct Binomial {
    coefficient: Expr,
    m: Expr,
    alpha: Expr,
    beta: Expr,
    p: Expr,
}

/// Every real m > −1 on the whole axis, odd m ≥ 1 on segments.
fn apply(term: &Term, branch: Sign, extent: Extent) -> Option<Answer> {
    let part = term.single()?;
    if !extent.fits(&term.segment) {
        return None;
    }
    let (base, p) = reading::power(&part.kernel);
    let (own, magnitude, mut conditions) = field(&base)?;
    let closes_better = p.as_number().is_some_and(|p| (p * &Number::integer(2)).is_integer()) && part.exponent.as_integer().is_some();
    if (own.sigma > 0) != (branch == Sign::Positive) || closes_better || p.contains(&Symbol::new("r")) {
        return None;
    }
    let (alpha, beta) = (&own.square_length * &magnitude, Expr::integer(own.sigma) * magnitude);
    let m = part.exponent.clone();
    let binomial = Binomial { coefficient: part.coefficient.clone(), m: m.clone(), alpha, beta, p };
    if extent == Extent::Segment {
        return binomial.worn(&term.segment, conditions);
    }
    conditions.extend(reading::above(&m, -1)?);
    let pair = |expr: Expr| Branches::endless(Pair::same(expr));
    let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
    let equivalent = &x * binomial.whole(&binomial.m, &x);
    let force = binomial.whole(&(&binomial.m + Expr::integer(2)), &a);
    Some(Answer { equivalent: pair(equivalent), force: pair(force), pressure: None, conditions })
}

impl Binomial {
    /// c ∫₀ˣ r^m (α+βr²)^p/√(x²−r²) dr = c α^p κ_(m+1)/(m+1) x^m 2F1(−p, (m+1)/2; (m+2)/2; −βx²/α).
    fn whole(&self, m: &Expr, x: &Expr) -> Expr {
        let (next, two) = (m + Expr::one(), Expr::integer(2));
        let argument = -(&self.beta * x.power(2) / &self.alpha);
        let series = Expr::call("hyp2f1", [-&self.p, &next / &two, (m + &two) / &two, argument]);
        tidy(&(&self.coefficient * self.alpha.pow(&self.p))) * kappa(&next) / next * x.pow(m) * series
    }

    /// From b outward; the part beyond an upper end is taken away, which needs a quadratic that stays positive there.
    fn worn(&self, segment: &Segment, conditions: Vec<Condition>) -> Option<Answer> {
        let m = self.m.as_integer().filter(|m| *m > 0 && m % 2 == 1 && *m < 40)?;
        if segment.upper.is_some() && sign(&self.beta) != Sign::Positive {
            return None;
        }
        let branches = |name: &str, m: i64, factor: i64| {
            let x = Expr::symbol(name);
            let outside = if factor == 1 { x.clone() } else { Expr::one() };
            Branches::from_ends(segment, |end| Pair::same(self.from(end, m, &x))).scaled(&outside)
        };
        Some(Answer { equivalent: branches("x", m, 1), force: branches("a", m + 2, 0), pressure: None, conditions })
    }

    /// c ∫_b^x r^(2n+1) (α+βr²)^p/√(x²−r²) dr, w² = x² − b², q = α + βb²:
    /// c q^p Σ_j C(n,j) b^(2n−2j) w^(2j+1) B_j 2F1(−p, j+1; j+3/2; −βw²/q) with B_j = ∫₀¹ t^(2j+1)/√(1−t²) dt.
    fn from(&self, b: &Expr, m: i64, x: &Expr) -> Expr {
        if b.is_zero() {
            return self.whole(&Expr::integer(m), x);
        }
        let n = m / 2;
        let square = x.power(2) - b.power(2);
        let q = &self.alpha + &self.beta * b.power(2);
        let argument = -(&self.beta * &square / &q);
        let (mut terms, mut choose, mut beta) = (Vec::new(), Expr::one(), Expr::one());
        for j in 0..=n {
            let parameters = [-&self.p, Expr::integer(j + 1), Expr::ratio(2 * j + 3, 2), argument.clone()];
            terms.push(&choose * &beta * b.power(2 * (n - j)) * square.power(j) * Expr::call("hyp2f1", parameters));
            choose = choose * Expr::ratio(n - j, j + 1);
            beta = beta * Expr::ratio(2 * j + 2, 2 * j + 3);
        }
        tidy(&self.coefficient) * q.pow(&self.p) * square.sqrt() * Expr::sum(terms)
    }
}

/// A product whose exponents are expanded, so that b^(2p−2(p−1)) becomes b².
fn tidy(product: &Expr) -> Expr {
    let factors = product.factors().into_iter().map(|factor| {
        let (base, exponent) = factor.split_power();
        base.pow(&normal::expanded(&exponent, &Symbol::new("r")).unwrap_or(exponent))
    });
    Expr::product(factors)
}
