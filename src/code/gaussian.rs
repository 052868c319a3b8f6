//! Profiles r^(2j) exp(−κ²r²): g and F as series whose terms have one sign, where the closed form with Dawson's integral cancels.
//!
//! With y = κx, g = d/dx ∫₀^x r f/√(x²−r²) dr and F/(2E*) = (x d/dx − 1) of the same integral, up to f(0), which has no part in
//! either. The integral is π/(2κ_m) y^m ₁F₁(j + 1; m/2 + 1; −y²) with m = 2j + 1, and Kummer's transformation makes its terms
//! positive.

use crate::expr::normal::{NormalTerm, normal_terms};
use crate::expr::{Expr, Node, Sign, Symbol, sign};

/// c r^(2j) exp(−κ²r²).
pub(super) struct Gaussian {
    pub(super) factor: Expr,
    pub(super) j: u32,
    pub(super) kappa: Expr,
}

/// The largest j.
const LARGEST: i64 = 20;

/// The terms of a profile, constants apart; `None` if there is another one.
pub(super) fn gaussians(profile: &Expr) -> Option<Vec<Gaussian>> {
    let radius = Symbol::new("r");
    let terms = normal_terms(profile, &radius).ok()?;
    let changing = terms.iter().filter(|own| !(own.kernel.is_one() && own.exponent.is_zero()));
    let found: Option<Vec<Gaussian>> = changing.map(|own| gaussian(own, &radius)).collect();
    found.filter(|own| !own.is_empty())
}

fn gaussian(term: &NormalTerm, radius: &Symbol) -> Option<Gaussian> {
    let exponent = term.exponent.as_integer()?;
    let j = Some(exponent / 2).filter(|j| exponent % 2 == 0 && (0..=LARGEST).contains(j))?;
    let Node::Function(function, arguments) = term.kernel.node() else { return None };
    let ([argument], "exp") = (arguments.as_slice(), function.name()) else { return None };
    let square = -(argument / Expr::from(radius.clone()).power(2));
    let is_scale = !square.contains(radius) && sign(&square) == Sign::Positive;
    is_scale.then(|| Some(Gaussian { factor: term.coefficient.clone(), j: u32::try_from(j).ok()?, kappa: square.sqrt() }))?
}
