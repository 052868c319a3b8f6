//! Rows of the special functions that users type or answers show, spelled as in mpmath.

use super::elementary::{binary, first, unary};
use super::{Latex, PLAIN, Row};
use crate::expr::{Expr, Number, Sign, sign};
use crate::num::special;

pub(super) static ROWS: &[Row] = &[
    Row {
        name: "gamma",
        latex: Latex::Operator("\\Gamma"),
        value: |a| unary(a, libm::tgamma),
        ulps: 10.0,
        derivative: Some(|a, _| Some(Expr::call("gamma", a.to_vec()) * Expr::call("digamma", a.to_vec()))),
        fold: Some(|a| known_gamma(&first(a))),
        sign: Some(|a| match sign(&first(a)) {
            Sign::Positive => Sign::Positive,
            _ => Sign::Unknown,
        }),
        ..PLAIN
    },
    Row {
        name: "digamma",
        latex: Latex::Operator("\\psi"),
        value: |a| unary(a, special::digamma),
        ulps: 6.0,
        derivative: Some(|a, _| Some(Expr::call("polygamma", [Expr::one(), first(a)]))),
        ..PLAIN
    },
    // χ₂(z) = Σ z^(2k+1)/(2k+1)², for |z| ≤ 1.
    Row {
        name: "legendre_chi2",
        latex: Latex::Operator("\\chi_{2}"),
        value: |a| unary(a, special::legendre_chi2),
        ulps: 3.0,
        sign: Some(|a| sign(&first(a))),
        shown: Some(|a| dilogarithm(a, 1)),
        in_latex: true,
        ..PLAIN
    },
    // Ti₂(z) = ∫₀^z atan(t)/t dt.
    Row {
        name: "inverse_tangent_integral",
        latex: Latex::Operator("\\operatorname{Ti}_{2}"),
        value: |a| unary(a, special::inverse_tangent_integral),
        ulps: 3.0,
        sign: Some(|a| sign(&first(a))),
        shown: Some(|a| dilogarithm(a, -1)),
        in_latex: true,
        ..PLAIN
    },
    // ψ^(m)(z); the value is known for m = 1, which second derivatives of gamma need.
    Row {
        name: "polygamma",
        arity: (2, 2),
        latex: Latex::Custom(|a| match a {
            [m, z] => format!("\\psi^{{({m})}}\\left({z}\\right)"),
            _ => String::new(),
        }),
        value: |a| match a {
            [m, z] if *m == 1.0 => special::trigamma(*z),
            _ => f64::NAN,
        },
        ulps: 8.0,
        ..PLAIN
    },
    Row {
        name: "hyp2f1",
        arity: (4, 4),
        latex: Latex::Custom(|a| match a {
            [a, b, c, z] => format!("{{}}_2F_1\\left({a},{b};{c};{z}\\right)"),
            _ => String::new(),
        }),
        value: |a| match a {
            [a, b, c, z] => special::hyp2f1(*a, *b, *c, *z),
            _ => f64::NAN,
        },
        ulps: 300.0,
        ..PLAIN
    },
    // Arguments: p, q, the p upper parameters, the q lower ones, z; read and printed as hyper([a…],[b…],z).
    Row {
        name: "hyper",
        arity: (3, 64),
        latex: Latex::Custom(|a| {
            let [p, q, rest @ ..] = a else { return String::new() };
            let (upper, rest) = rest.split_at(p.parse().unwrap_or(0).min(rest.len()));
            let (lower, argument) = rest.split_at(q.parse().unwrap_or(0).min(rest.len()));
            format!("{{}}_{{{p}}}F_{{{q}}}\\left({};{};{}\\right)", upper.join(","), lower.join(","), argument.join(","))
        }),
        value: |a| {
            let [p, q, rest @ ..] = a else { return f64::NAN };
            // The counts must be whole and leave exactly one argument.
            let (Some(p), Some(q)) = (count(*p, rest), count(*q, rest)) else { return f64::NAN };
            let (upper, rest) = rest.split_at(p);
            match rest.split_at_checked(q) {
                Some((lower, [z])) => special::hyper(upper, lower, *z),
                _ => f64::NAN,
            }
        },
        ulps: 320.0,
        ..PLAIN
    },
    Row {
        name: "elliprf",
        arity: (3, 3),
        latex: Latex::Custom(|a| format!("R_{{F}}({})", a.join(",\\,"))),
        value: |a| ternary(a, special::rf),
        ulps: 8.0,
        sign: Some(|_| Sign::Positive),
        ..PLAIN
    },
    Row {
        name: "elliprd",
        arity: (3, 3),
        latex: Latex::Custom(|a| format!("R_{{D}}({})", a.join(",\\,"))),
        value: |a| ternary(a, special::rd),
        ulps: 11.0,
        sign: Some(|_| Sign::Positive),
        ..PLAIN
    },
    Row {
        name: "elliprc",
        arity: (2, 2),
        latex: Latex::Custom(|a| format!("R_{{C}}({})", a.join(",\\,"))),
        value: |a| binary(a, special::rc),
        ulps: 6.0,
        sign: Some(|_| Sign::Positive),
        ..PLAIN
    },
    Row {
        name: "ellipk",
        latex: Latex::Operator("K"),
        value: |a| unary(a, special::ellipk),
        ulps: 6.0,
        sign: Some(|_| Sign::Positive),
        ..PLAIN
    },
    Row {
        name: "ellipf",
        arity: (2, 2),
        latex: Latex::Custom(|a| format!("F({})", a.join("\\,|\\,"))),
        value: |a| binary(a, special::ellipf),
        ulps: 7.0,
        ..PLAIN
    },
    Row {
        name: "ellipe",
        arity: (1, 2),
        latex: Latex::Custom(|a| format!("E({})", a.join("\\,|\\,"))),
        value: |a| match a {
            [m] => special::ellipe(*m),
            [phi, m] => special::ellipe_inc(*phi, *m),
            _ => f64::NAN,
        },
        ulps: 8.0,
        ..PLAIN
    },
];

/// A whole number of at most as many as there are.
fn count(value: f64, of: &[f64]) -> Option<usize> {
    (value.fract() == 0.0 && value >= 0.0 && value <= of.len() as f64).then_some(value as usize)
}

fn ternary(a: &[f64], f: fn(f64, f64, f64) -> f64) -> f64 {
    match a {
        [u, v, w] => f(*u, *v, *w),
        _ => f64::NAN,
    }
}

/// Γ at small whole and half numbers: Γ(z + 1) = z Γ(z) from Γ(1) = 1 or Γ(1/2) = √π.
fn known_gamma(z: &Expr) -> Option<Expr> {
    let number = z.as_number().filter(|n| n.is_positive() && **n <= Number::integer(12))?;
    let (mut below, mut value) = if number.is_integer() {
        (Number::integer(1), Expr::one())
    } else if (number - &Number::ratio(1, 2)).is_integer() {
        (Number::ratio(1, 2), Expr::pi().sqrt())
    } else {
        return None;
    };
    while below < *number {
        value = value * Expr::number(below.clone());
        below = &below + &Number::integer(1);
    }
    Some(value)
}

/// z·3F2(1/2, 1/2, 1; 3/2, 3/2; ±z²), which is χ₂(z) or Ti₂(z).
fn dilogarithm(a: &[Expr], sign: i64) -> Expr {
    let z = first(a);
    let (half, one) = (Expr::ratio(1, 2), Expr::one());
    let parameters = [Expr::integer(3), Expr::integer(2), half.clone(), half, one, Expr::ratio(3, 2), Expr::ratio(3, 2)];
    let argument = Expr::integer(sign) * z.power(2);
    z * Expr::call("hyper", parameters.into_iter().chain([argument]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gamma_of_whole_and_half_numbers_is_folded() {
        let gamma = |p, q| Expr::call("gamma", [Expr::ratio(p, q)]);
        assert_eq!(gamma(5, 1), Expr::integer(24));
        assert_eq!(gamma(1, 1), Expr::one());
        assert_eq!(gamma(1, 2), Expr::pi().sqrt());
        assert_eq!(gamma(7, 2), Expr::ratio(15, 8) * Expr::pi().sqrt());
        assert!(matches!(gamma(1, 3).node(), crate::expr::Node::Function(..)));
    }
}
