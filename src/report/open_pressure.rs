//! Notes that explain why a pressure remains an integral, by the functions in the integrand.

use crate::expr::{Expr, Formula, Node, Symbol};
use crate::print::Prose;
use std::collections::BTreeSet;

/// The kind of an integral of g′(x)/√(x²−r²), by the functions in g′.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    /// g itself is an integral.
    OpenProfile,
    /// Exponentials, waves, Bessel and Struve functions, and integrals of them.
    Bessel,
    /// Elliptic integrals.
    Elliptic,
    /// Inverse functions, which are integrals of roots.
    Inverse,
    /// Hypergeometric and incomplete beta functions.
    Hypergeometric,
    /// Logarithms multiplied by powers.
    Logarithm,
    /// Powers and roots.
    Algebraic,
}

impl Kind {
    /// Returns the kind of a function by its name, or `None` if the function does not determine one.
    fn of(name: &str) -> Option<Self> {
        Some(match name {
            "sin" | "cos" | "tan" | "exp" | "sinh" | "cosh" | "tanh" | "besselj" | "besseli" | "struveh" | "struvel" | "dawson" | "erf"
            | "erfc" | "erfi" | "fresnelc" | "fresnels" => Self::Bessel,
            "ellipk" | "ellipe" | "ellipf" | "elliprf" | "elliprd" | "elliprj" => Self::Elliptic,
            "asin" | "acos" | "atan" | "atan2" | "asinh" | "acosh" | "atanh" | "elliprc" => Self::Inverse,
            "hyp2f1" | "hyp1f1" | "hyper" | "betainc" | "polylog" => Self::Hypergeometric,
            "ln" => Self::Logarithm,
            _ => return None,
        })
    }

    fn sentence(self) -> &'static str {
        match self {
            Self::OpenProfile => "the integral in $p(r)$ is over $f'(r)$, because a part of $g(x)$ has no closed form in the catalogue",
            Self::Bessel => "the integral in $p(r)$ is an incomplete integral of Bessel functions, for which no closed form is known",
            Self::Elliptic => {
                "the integral in $p(r)$ is an integral of elliptic integrals over their modulus, for which no closed form is known"
            }
            Self::Inverse => {
                "the integral in $p(r)$ contains an inverse function and two square roots, so it is an integral of elliptic integrals \
                 over a parameter, for which no closed form is known"
            }
            Self::Hypergeometric => "the integral in $p(r)$ contains a hypergeometric function and a square root; no closed form is known",
            Self::Logarithm => "the integral in $p(r)$ contains a logarithm times a power of x, for which the catalogue has no closed form",
            Self::Algebraic => "the integral in $p(r)$ contains only roots; the catalogue has no closed form for it",
        }
    }
}

/// Returns the notes for a pressure with integrals; none for a closed form.
pub(super) fn reasons(pressure: &Formula) -> Vec<Prose> {
    let mut found = BTreeSet::new();
    for (integrand, variable) in pressure.integrals() {
        // Integrals over g′ have the variable x; integrals over f′ have another variable.
        if variable.name() != "x" {
            found.insert(Kind::OpenProfile);
            continue;
        }
        let mut own = BTreeSet::new();
        if let Formula::Closed(expr) = integrand {
            in_expression(expr, variable, &mut own);
        }
        found.extend(if own.is_empty() { BTreeSet::from([Kind::Algebraic]) } else { own });
    }
    found.into_iter().map(|kind| Prose::read(kind.sentence())).collect()
}

/// Adds the kinds of the outermost functions of the variable.
fn in_expression(expr: &Expr, variable: &Symbol, found: &mut BTreeSet<Kind>) {
    if !expr.contains(variable) {
        return;
    }
    let kind = match expr.node() {
        // sin(atan x) is algebraic, and ln(x + √(x²+1)) is an inverse function.
        Node::Function(function, arguments) => match (function.name(), arguments.as_slice()) {
            ("sin" | "cos" | "tan", [argument]) if is_inverse(argument) => None,
            ("ln", [argument]) if !is_monomial(argument, variable) => Some(Kind::Inverse),
            (name, _) => Kind::of(name),
        },
        Node::Power(base, exponent) if *base == Expr::euler() && exponent.contains(variable) => Some(Kind::Bessel),
        _ => None,
    };
    match kind {
        Some(kind) => {
            found.insert(kind);
        }
        None => expr.children().into_iter().for_each(|child| in_expression(child, variable, found)),
    }
}

/// True for a power of the variable times a constant.
fn is_monomial(expr: &Expr, variable: &Symbol) -> bool {
    expr.factors().iter().filter(|own| own.contains(variable)).all(|own| own.split_power().0.as_symbol() == Some(variable))
}

fn is_inverse(expr: &Expr) -> bool {
    matches!(expr.node(), Node::Function(function, _) if Kind::of(function.name()) == Some(Kind::Inverse))
}
