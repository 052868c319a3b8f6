//! A profile from a prescribed pressure: q(x) = 2 ∫_x^a r p/√(r²−x²) dr, and g = d − q/E*.

use crate::derive::rules::reading;
use crate::expr::normal;
use crate::expr::{Expr, Sign, Symbol, sign};
use crate::integrate::error::TransformError;
use crate::print;
use std::collections::BTreeMap;

/// The equivalent profile, depth and force of a prescribed pressure p(r) in a contact of radius a.
#[derive(Clone, Debug)]
pub struct FromPressure {
    /// g(x), with g(0) = 0.
    pub equivalent: Expr,
    /// The depth d = q(0)/E*.
    pub depth: Expr,
    /// The force F = 2π ∫₀^a p r dr.
    pub force: Expr,
}

/// The largest power of r² that is expanded.
const HIGHEST: i64 = 60;

/// g(x), d and F of a pressure Σ c (a²−r²)^s r^(2j), s > −1, in a contact of radius `a` with the effective modulus `E`.
///
/// With r² = a² − t every term is a sum of powers t^s, and t^s gives q = B(s+1, 1/2) (a²−x²)^(s+1/2) and F = π a^(2s+2)/(s+1):
/// s = −1/2 is the flat punch, s = 1/2 the parabola of Hertz, s = 0 a constant pressure.
///
/// ```
/// use sneddon::{parse, print, transform::equivalent_of_pressure};
/// let hertz = equivalent_of_pressure(&parse::pressure("p_0*sqrt(1-r^2/a^2)").unwrap()).unwrap();
/// assert_eq!(print::text_expr(&hertz.equivalent), "pi*p_0*x^2/(2*E*a)");
/// assert_eq!(print::text_expr(&hertz.depth), "pi*p_0*a/(2*E)");
/// ```
///
/// # Errors
/// [`TransformError::NoProfileForPressure`] for any other pressure.
pub fn equivalent_of_pressure(pressure: &Expr) -> Result<FromPressure, TransformError> {
    let radius = Symbol::new("r");
    let refuse = |expr: &Expr| TransformError::NoProfileForPressure { term: print::text_expr(expr) };
    let terms = normal::normal_terms(pressure, &radius).map_err(|_| refuse(pressure))?;
    let (a, x) = (Expr::symbol("a"), Expr::symbol("x"));
    let square = a.power(2);
    let inside = &square - x.power(2);
    let (mut line_load, mut force): (BTreeMap<Expr, Vec<Expr>>, Vec<Expr>) = (BTreeMap::new(), Vec::new());
    for term in terms {
        let refused = || refuse(&term.to_expr(&radius));
        let half = term.exponent.as_integer().filter(|m| m % 2 == 0 && (0..=2 * HIGHEST).contains(m)).ok_or_else(refused)? / 2;
        let (scale, power) = power_of_gap(&term.kernel, &radius).ok_or_else(refused)?;
        if sign(&(&power + Expr::one())) != Sign::Positive {
            return Err(refused());
        }
        let mut binomial = Expr::one();
        for i in 0..=half {
            // r^(2j) = (a² − t)^j
            let parity = if i % 2 == 0 { Expr::one() } else { Expr::integer(-1) };
            let factor = Expr::product([term.coefficient.clone(), scale.clone(), parity, binomial.clone(), square.power(half - i)]);
            let s = &power + Expr::integer(i);
            let next = &s + Expr::one();
            line_load.entry(&s + Expr::ratio(1, 2)).or_default().push(&factor * beta_with_half(&next));
            force.push(factor * Expr::pi() * square.pow(&next) / next);
            binomial = binomial * Expr::integer(half - i) / Expr::integer(i + 1);
        }
    }
    let coordinate = Symbol::new("x");
    let tidy = |expr: &Expr| normal::expanded(expr, &coordinate).unwrap_or_else(|_| expr.clone());
    let (mut depth, mut load) = (Vec::new(), Vec::new());
    for (s, list) in line_load {
        let coefficient = tidy(&Expr::sum(list)) / Expr::symbol("E");
        depth.push(tidy(&(&coefficient * square.pow(&s))));
        let own = coefficient * inside.pow(&s);
        // Expand whole powers, so that their constant terms cancel with the depth; leave roots unchanged.
        load.push(if s.as_integer().is_some() { tidy(&own) } else { own });
    }
    let depth = Expr::sum(depth);
    Ok(FromPressure { equivalent: &depth - Expr::sum(load), depth, force: tidy(&Expr::sum(force)) })
}

/// λ and s where the kernel is λ (a² − r²)^s; a kernel of 1 has s = 0.
fn power_of_gap(kernel: &Expr, radius: &Symbol) -> Option<(Expr, Expr)> {
    if kernel.is_one() {
        return Some((Expr::one(), Expr::zero()));
    }
    let (base, power) = reading::power(kernel);
    let (constant, last) = reading::quadratic(&base)?;
    let scale = -last;
    let same = normal::is_proven_zero(&(constant - &scale * Expr::symbol("a").power(2)), radius);
    (same && sign(&scale) == Sign::Positive).then(|| (scale.pow(&power), power))
}

/// B(z, 1/2) = √π Γ(z)/Γ(z + 1/2).
fn beta_with_half(z: &Expr) -> Expr {
    Expr::pi().sqrt() * Expr::call("gamma", [z.clone()]) / Expr::call("gamma", [z + Expr::ratio(1, 2)])
}
