//! Heß's rule: a power of r with any exponent n > 0, whole, real or symbolic.

use super::reading;
use crate::derive::rule::{Answer, Branches, Pair, Parameter, Rule};
use crate::derive::term::Term;
use crate::expr::{Expr, Symbol, normal};
use crate::num::kappa::kappa_exact;

pub(super) static RULE: Rule = Rule {
    id: "heß-power",
    title: "Power of the radius",
    pattern: "C*r^n",
    equivalent: "C*sqrt(pi)*gamma(n/2+1)/gamma(n/2+1/2)*x^n",
    force: "2*E*C*sqrt(pi)*gamma(n/2+1)/gamma(n/2+1/2)*n/(n+1)*a^(n+1)",
    pressure: Some("E/pi*C*n*sqrt(pi)*gamma(n/2+1)/gamma(n/2+1/2)*a^(n-2)*sqrt(a^2-r^2)*hyp2f1(1,1-n/2,3/2,1-r^2/a^2)"),
    parameters: &[Parameter { name: "C", lowest: 0.1, highest: 4.0 }, Parameter { name: "n", lowest: 0.2, highest: 9.0 }],
    guard: "n > 0",
    reference: &["Popov & Heß (3.14)–(3.17)", "Popov & Heß (3.20)–(3.24)"],
    specializes: None,
    apply,
};

/// Whole exponents up to this one get an exact rational (or rational times π) for κ_n.
const HIGHEST_EXACT: i64 = 120;

/// f′ = c·r^(n−1): g = (c/n) κ_n xⁿ, F/(2E*) = c κ_n a^(n+1)/(n+1), p π/E* = c κ_n S_(n−1)(r, a).
fn apply(term: &Term) -> Option<Answer> {
    let part = term.single()?;
    if !term.segment.is_whole() || !part.kernel.is_one() {
        return None;
    }
    let n = &part.exponent + Expr::one();
    let conditions = reading::positive(&n)?;
    let scaled = &part.coefficient * kappa(&n);
    let (x, a, r) = (Expr::symbol("x"), Expr::symbol("a"), Expr::symbol("r"));
    let equivalent = &scaled / &n * x.pow(&n);
    let next = &n + Expr::one();
    let force = &scaled / &next * a.pow(&next);
    let pressure = &scaled * Expr::call("pressure_power", [&n - Expr::one(), r, a]);
    Some(Answer {
        equivalent: Branches::endless(Pair::same(equivalent)),
        force: Branches::endless(Pair::same(force)),
        pressure: Some(Branches::endless(Pair::same(pressure))),
        conditions,
    })
}

/// κ_n of Heß's rule (3.16): exact for small whole n, else √π Γ(n/2+1)/Γ(n/2+1/2).
///
/// ```
/// use sneddon::{expr::Expr, transform::rules::kappa};
/// assert_eq!(kappa(&Expr::integer(2)), Expr::integer(2));
/// assert_eq!(kappa(&Expr::integer(1)), Expr::pi() / Expr::integer(2));
/// ```
pub fn kappa(n: &Expr) -> Expr {
    match n.as_integer().filter(|n| (0..=HIGHEST_EXACT).contains(n)).and_then(|n| u32::try_from(n).ok()) {
        Some(n) => {
            let (rational, times_pi) = kappa_exact(n);
            let rational = Expr::number(rational.into());
            if times_pi { rational * Expr::pi() } else { rational }
        }
        None => Expr::call("kappa", [n.clone()]),
    }
}

/// B(1/2, k+1) = π/κ_(2k+1) = π (2k+3)/(2(k+1) κ_(2k+3)): next to k = −1 the factor n of f′ = C n (r−b)^(n−1) cancels by itself.
pub(super) fn beta_of_half(k: &Expr) -> Expr {
    let order = Expr::integer(2) * k + Expr::integer(3);
    let order = normal::expanded(&order, &Symbol::new("r")).unwrap_or(order);
    Expr::pi() * &order / (Expr::integer(2) * (k + Expr::one()) * kappa(&order))
}
