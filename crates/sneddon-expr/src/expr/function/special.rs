//! Rows of the special functions that users type or answers show, spelled as in mpmath.

use super::elementary::{binary, first, region, unary};
use super::typeset::{self, Setting};
use super::waves::of_order;
use super::{Accuracy, PLAIN, Row};
use crate::expr::{Expr, Number, Sign, sign};
use crate::num::{Precise, Region, special};

pub(super) static ROWS: &[Row] = &[
    Row {
        name: "gamma",
        typeset: typeset::upright("Γ"),
        value: |a| unary(a, libm::tgamma),
        accuracy: Accuracy::Measured(10.0),
        precise: Some(|a| match a {
            [z] => special::gamma_precise(*z),
            _ => Precise::nan(),
        }),
        derivative: Some(|a, _| Some(Expr::call("gamma", a.to_vec()) * Expr::call("digamma", a.to_vec()))),
        fold: Some(|a| known_gamma(&first(a))),
        sign: Some(|a| match sign(&first(a)) {
            Sign::Positive => Sign::Positive,
            _ => Sign::Unknown,
        }),
        region: Some(|a| region(a, Region::gamma)),
        ..PLAIN
    },
    Row {
        name: "digamma",
        typeset: typeset::italic("ψ"),
        value: |a| unary(a, special::digamma),
        accuracy: Accuracy::Measured(6.0),
        precise: Some(|a| match a {
            [z] if z.hi > 0.0 => special::digamma_precise(*z),
            _ => Precise::nan(),
        }),
        derivative: Some(|a, _| Some(Expr::call("polygamma", [Expr::one(), first(a)]))),
        region: Some(|a| region(a, Region::digamma)),
        ..PLAIN
    },
    // ψ^(m)(z), m = 0, 1, 2, …
    Row {
        name: "polygamma",
        arity: (2, 2),
        typeset: typeset::italic("ψ").set(Setting::Ordered),
        value: |a| binary(a, special::polygamma),
        accuracy: Accuracy::Measured(6.0),
        precise: Some(|a| match a {
            [m, z] => special::polygamma_precise(*m, *z),
            _ => Precise::nan(),
        }),
        derivative: Some(|a, i| match (a, i) {
            ([m, z], 1) => Some(Expr::call("polygamma", [m + Expr::one(), z.clone()])),
            _ => None,
        }),
        fold: Some(|a| match a {
            [m, z] if m.is_zero() => Some(Expr::call("digamma", [z.clone()])),
            _ => None,
        }),
        sign: Some(|a| match a {
            [m, z] if sign(z) == Sign::Positive => match m.as_integer() {
                Some(m) if m >= 1 => {
                    if m % 2 == 1 {
                        Sign::Positive
                    } else {
                        Sign::Negative
                    }
                }
                _ => Sign::Unknown,
            },
            _ => Sign::Unknown,
        }),
        region: Some(|a| of_order(a, Region::polygamma)),
        ..PLAIN
    },
];

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
