//! The stress on the axis below a contact, term by term: ∫₀^a g′(x) x(x²+3z²)/(x²+z²)² dx in closed form.
//!
//! These solutions apply to terms, like rules, but are separate from them: many terms with a closed g have none, because the logarithm and
//! the inverse functions of g′ lead to dilogarithms.

use crate::derive::domain::located::is_approximate;
use crate::derive::rule::{Branches, Pair};
use crate::derive::term::Term;
use crate::expr::{Expr, Sign, sign};

/// The contribution of a term to −σ_zz(z)·π/E* on the axis under a smooth edge, over the symbols z and a; `None` if no closed form is known.
///
/// Powers, and pieces whose f′ is c r: worn and capped paraboloids.
pub fn axial(term: &Term) -> Option<Branches> {
    if term.segment.is_whole() {
        return power(term).map(Branches::endless);
    }
    if is_approximate(&term.segment.lower) || term.segment.upper.as_ref().is_some_and(is_approximate) {
        return None;
    }
    let coefficients = term.polynomial()?;
    let [flat, rising] = coefficients.as_slice() else { return None };
    flat.is_zero().then(|| Branches::from_ends(&term.segment, |end| Pair::same(rising * worn(end))))
}

/// f′ = c r^(n−1): c κ_n ∫ x^n (x²+3z²)/(x²+z²)² dx = c κ_n [aⁿ⁺¹/(a²+z²) + (2 − n) ∫ xⁿ/(x²+z²) dx].
fn power(term: &Term) -> Option<Pair> {
    let part = term.single().filter(|part| part.kernel.is_one())?;
    let n = &part.exponent + Expr::one();
    if sign(&n) != Sign::Positive {
        return None;
    }
    let (a, z) = (Expr::symbol("a"), Expr::symbol("z"));
    let next = &n + Expr::one();
    let (first, factor) = (a.pow(&next) / (a.power(2) + z.power(2)), Expr::integer(2) - &n);
    let scale = &part.coefficient * super::kappa(&n);
    let (shown, evaluated) = match n.as_integer() {
        Some(1) => (written_out(1, &a, &z), written_out(1, &a, &z)),
        Some(2) => (Expr::zero(), Expr::zero()),
        whole => {
            let upper = &next / Expr::integer(2);
            let list = [Expr::one(), upper.clone(), upper + Expr::one(), -(a.power(2) / z.power(2))];
            let own = a.pow(&next) / (&next * z.power(2)) * Expr::call("hyp2f1", list);
            (whole.filter(|n| *n <= HIGHEST).map_or_else(|| own.clone(), |n| written_out(n, &a, &z)), own.clone())
        }
    };
    Some(Pair { shown: &scale * (&first + &factor * shown), evaluated: scale * (first + factor * evaluated) })
}

/// Integrals of powers up to this order are written out.
const HIGHEST: i64 = 8;

/// ∫₀^a xⁿ/(x²+z²) dx = aⁿ⁻¹/(n − 1) − z² ∫₀^a xⁿ⁻²/(x²+z²) dx, down to n = 0 or 1.
fn written_out(n: i64, a: &Expr, z: &Expr) -> Expr {
    let mut terms = Vec::new();
    let mut factor = Expr::one();
    for m in (2..=n).rev().step_by(2) {
        terms.push(&factor * a.power(m - 1) / Expr::integer(m - 1));
        factor = -(factor * z.power(2));
    }
    let last = match n % 2 {
        0 => Expr::call("atan", [a / z]) / z,
        _ => Expr::call("ln", [Expr::one() + a.power(2) / z.power(2)]) / Expr::integer(2),
    };
    Expr::sum(terms) + factor * last
}

/// f′ = r from b on, with w² = a² − b² and Z² = b² + z²: w (2a²Z² + b²z²)/(Z² (a²+z²)) − (b⁴/Z³) arctan(w/Z).
fn worn(b: &Expr) -> Expr {
    let (a, z) = (Expr::symbol("a").power(2), Expr::symbol("z").power(2));
    let square = b.power(2);
    let (inner, far) = ((&a - &square).sqrt(), &square + &z);
    let first = &inner * (Expr::integer(2) * &a * &far + &square * &z) / (&far * (a + z));
    let root = far.sqrt();
    first - square.power(2) * Expr::call("atan", [inner / &root]) / root.power(3)
}
