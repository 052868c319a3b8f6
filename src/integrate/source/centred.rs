//! Polynomials inside functions, written around the place where they are shortest: (r − b)² again, where it was multiplied out.

use crate::expr::{Expr, Node, Number, Rewriting, Symbol, normal, rewritten};
use crate::integrate::integral::typed_degree;

/// The same function of r, with every polynomial in an exponent, a base or an argument written in powers of r − s, where that has fewer
/// terms than it has in powers of r.
///
/// A polynomial c_n rⁿ + c_(n−1) rⁿ⁻¹ + … has no term of degree n − 1 in powers of r − s for s = −c_(n−1)/(n c_n).
/// −10¹² r² + 2·10¹² r − 10¹², as it follows from the Gaussian of a narrow ridge, has neither digits nor an enclosure near r = 1;
/// −10¹² (r − 1)² has both.
pub fn centred(expr: &Expr) -> Expr {
    let radius = Symbol::new("r");
    let shorter = |own: &Expr, _: &dyn Fn(&Expr) -> Expr| match own.node() {
        _ if !own.contains(&radius) => Some(own.clone()),
        Node::Sum(terms) => around_its_centre(own, terms.len(), &radius),
        _ => None,
    };
    let inside = Rewriting::new(&shorter);
    rewritten(expr, &|own, _| match own.node() {
        Node::Power(base, exponent) => Some(inside.of(base).pow(&inside.of(exponent))),
        Node::Function(function, arguments) => Some(Expr::function(*function, arguments.iter().map(|own| inside.of(own)).collect())),
        _ => None,
    })
}

/// The highest degree that is looked at.
const HIGHEST: usize = 12;

/// The polynomial in powers of r − s, where these are fewer than `terms`.
fn around_its_centre(sum: &Expr, terms: usize, radius: &Symbol) -> Option<Expr> {
    // Expanding other expressions would be expensive.
    typed_degree(sum, radius).filter(|degree| *degree <= HIGHEST)?;
    let coefficients = normal::polynomial_coefficients(sum, radius).filter(|list| list.len() >= 3)?;
    let numbers = coefficients.iter().map(Expr::as_number).collect::<Option<Vec<&Number>>>()?;
    let [.., before, highest] = numbers.as_slice() else { return None };
    if before.is_zero() || highest.is_zero() {
        return None;
    }
    let degree = i64::try_from(coefficients.len() - 1).ok()?;
    let centre = Expr::number(-*before) / (Expr::number((*highest).clone()) * Expr::integer(degree));
    let list = normal::shifted_coefficients(&coefficients, &centre, radius).filter(|list| list.len() < terms)?;
    let distance = Expr::from(radius.clone()) - centre;
    Some(Expr::sum(list.iter().map(|(k, c)| c * distance.power(*k))))
}
