//! Explicit inversions of profiles with one kernel: g(a) = d solved for a, and F in terms of d without computing a.

use super::{Explicit, positive};
use crate::expr::{Condition, Expr, Node, Sign, Symbol, normal, sign};
use crate::transform::Term;
use crate::transform::rules::reading;

/// References.
/// The method of solving g(a) = d.
const EQUATION: &str = "Monotone in the contact radius, and inverted by an elementary function";
const REFERENCE: [&str; 1] = ["g(a) = d solved for a"];

/// a(d) and F(d) for atan, artanh, 1 − 1/√(1 + r²/b²), 1 − J₀ and I₀ − 1, on the whole axis.
pub(super) fn single_kernel(term: &Term) -> Option<Explicit> {
    let part = term.single().filter(|_| term.segment.is_whole())?;
    match part.kernel.node() {
        Node::Power(base, power) => {
            let (alpha, beta) = reading::quadratic(base)?;
            if sign(&alpha) != Sign::Positive {
                return None;
            }
            if part.exponent.is_zero() && *power == Expr::integer(-1) {
                return match sign(&beta) {
                    Sign::Positive => arctangent(&part.coefficient, &alpha, &beta, 1),
                    Sign::Negative => arctangent(&part.coefficient, &alpha, &-beta, -1),
                    _ => None,
                };
            }
            let inverse_root = part.exponent.is_one() && *power == Expr::ratio(-3, 2) && sign(&beta) == Sign::Positive;
            if inverse_root { saturation(&part.coefficient, &alpha, &beta) } else { None }
        }
        Node::Function(function, arguments) if part.exponent.is_zero() => {
            let [order, argument] = arguments.as_slice() else { return None };
            let list = normal::polynomial_coefficients(argument, &Symbol::new("r"))?;
            let [zero, k] = list.as_slice() else { return None };
            match function.name() {
                "besselj" if order.is_one() && zero.is_zero() => bessel(&part.coefficient, k, 1),
                "besseli" if order.is_one() && zero.is_zero() => bessel(&part.coefficient, k, -1),
                _ => None,
            }
        }
        _ => None,
    }
}

/// f = C arctan(r/w), g = (π/2) C x/√(w² + x²): with s = 2d/(πC), a = w s/√(1 − s²), F = π C E w s²/(1 + √(1 − s²)).
///
/// With `side` = −1 the same for artanh(r/R), with 1 + s² instead of 1 − s².
fn arctangent(coefficient: &Expr, alpha: &Expr, beta: &Expr, side: i64) -> Option<Explicit> {
    let scale = coefficient / (alpha * beta).sqrt();
    let width = (alpha / beta).sqrt();
    let (d, one) = (Expr::symbol("d"), Expr::one());
    let most = Expr::pi() / Expr::integer(2) * &scale;
    let s = &d / &most;
    let root = (&one - Expr::integer(side) * s.power(2)).sqrt();
    let mut conditions = positive(&scale)?;
    if side > 0 {
        conditions.push(Condition::less(d, most));
    }
    Some(Explicit {
        contact_radius: &width * &s / &root,
        force: Expr::pi() * scale * Expr::symbol("E") * width * s.power(2) / (one + root),
        equation: EQUATION,
        reference: REFERENCE.to_vec(),
        conditions,
    })
}

/// f = h (1 − 1/√(1 + r²/b²)), g = h x²/(b² + x²): a = b √(d/(h − d)), F = 2E b [h arctan √(d/(h − d)) − √(d (h − d))].
fn saturation(coefficient: &Expr, alpha: &Expr, beta: &Expr) -> Option<Explicit> {
    let height = coefficient / (alpha.sqrt() * beta);
    let width = (alpha / beta).sqrt();
    let d = Expr::symbol("d");
    let left = &height - &d;
    let ratio = (&d / &left).sqrt();
    let mut conditions = positive(&height)?;
    conditions.push(Condition::less(d.clone(), height.clone()));
    let inner = &height * Expr::call("atan", [ratio.clone()]) - (d * left).sqrt();
    Some(Explicit {
        contact_radius: &width * &ratio,
        force: Expr::integer(2) * Expr::symbol("E") * width * inner,
        equation: EQUATION,
        reference: REFERENCE.to_vec(),
        conditions,
    })
}

/// f = h (1 − J₀(k r)), g = h (1 − cos k x): a = (2/k) arcsin √(d/2h), F = (2E/k) [√(d (2h − d)) − (h − d) k a].
///
/// With `side` = −1 the same for h (I₀(k r) − 1) and h (cosh k x − 1), with arsinh and 2h + d.
fn bessel(coefficient: &Expr, k: &Expr, side: i64) -> Option<Explicit> {
    let height = coefficient / k;
    let (d, two, side_expr) = (Expr::symbol("d"), Expr::integer(2), Expr::integer(side));
    let half = (&d / (&two * &height)).sqrt();
    let angle = &two * Expr::call(if side > 0 { "asin" } else { "asinh" }, [half]);
    let mut conditions = positive(&height)?;
    conditions.extend(positive(k)?);
    if side > 0 {
        conditions.push(Condition::less(d.clone(), &two * &height));
    }
    let leg = (&d * (&two * &height - &side_expr * &d)).sqrt();
    let inner = &side_expr * (leg - (&height - &side_expr * &d) * &angle);
    Some(Explicit {
        contact_radius: &angle / k,
        force: two * Expr::symbol("E") / k * inner,
        equation: EQUATION,
        reference: REFERENCE.to_vec(),
        conditions,
    })
}
