//! The recognition form: an expression as a sum of coefficient · r^m · kernel(r), independent of how it was typed.
//!
//! It is used for recognition and proofs of equality only; results are shown in the form stated by their rule.

mod calls;
mod content;
mod division;
mod factor;
mod gather;
mod logarithm;
mod polynomial;
mod power;
mod rational;
mod shift;
mod sparse;
mod univariate;
mod waves;

use super::{Expr, ExprError, Node, Symbol};
pub use content::common_content;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::One;
pub use polynomial::Polynomial;
pub use shift::shifted_coefficients;
use std::collections::BTreeMap;

/// One term of the recognition form: coefficient · variable^exponent · kernel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NormalTerm {
    /// Free of the variable.
    pub coefficient: Expr,
    /// The exponent of the variable itself, free of the variable.
    pub exponent: Expr,
    /// The product of all other factors that depend on the variable; 1 if there are none.
    pub kernel: Expr,
}

impl NormalTerm {
    /// The term as an expression.
    pub fn to_expr(&self, variable: &Symbol) -> Expr {
        Expr::product([self.coefficient.clone(), Expr::from(variable.clone()).pow(&self.exponent), self.kernel.clone()])
    }

    /// The exponent as a non-negative whole number, where the term is a plain power.
    pub fn whole_power(&self) -> Option<u32> {
        if self.kernel.is_one() { self.exponent.as_integer().and_then(|m| u32::try_from(m).ok()) } else { None }
    }
}

/// The recognition form of `expr` with respect to `variable`: products expanded, contents taken out of
/// powers, roots moved out of denominators, like terms collected.
///
/// # Errors
/// [`ExprError::TooLarge`] if expanding would need more terms than [`Polynomial::LIMIT`].
///
/// ```
/// use sneddon_expr::expr::{Expr, Symbol, normal::normal_terms};
/// let (r, big) = (Expr::symbol("r"), Expr::symbol("R"));
/// // r/√(4R² − 4r²) = (1/2)·r·(R² − r²)^(−1/2)
/// let four = Expr::integer(4);
/// let slope = &r / (&four * big.power(2) - &four * r.power(2)).sqrt();
/// let terms = normal_terms(&slope, &Symbol::new("r")).unwrap();
/// assert_eq!(terms.len(), 1);
/// assert_eq!(terms[0].coefficient, Expr::ratio(1, 2));
/// ```
pub fn normal_terms(expr: &Expr, variable: &Symbol) -> Result<Vec<NormalTerm>, ExprError> {
    let polynomial = Polynomial::canonical(expr, variable)?;
    let base = Expr::from(variable.clone());
    let mut collected: BTreeMap<(Expr, Expr), Vec<Expr>> = BTreeMap::new();
    for (monomial, coefficient) in polynomial.terms() {
        let (mut free, mut exponent, mut kernel) = (vec![Expr::number(coefficient.clone())], Expr::zero(), Vec::new());
        for (atom, power) in monomial {
            if *atom == base && !power.contains(variable) {
                exponent = power.clone();
            } else if *atom == Expr::euler() {
                let (dependent, constant): (Vec<Expr>, Vec<Expr>) = power.terms().into_iter().partition(|term| term.contains(variable));
                kernel.push(atom.pow(&Expr::sum(dependent)));
                free.push(atom.pow(&Expr::sum(constant)));
            } else if atom.contains(variable) || power.contains(variable) {
                kernel.push(atom.pow(power));
            } else {
                free.push(atom.pow(power));
            }
        }
        collected.entry((exponent, Expr::product(kernel))).or_default().push(Expr::product(free));
    }
    Ok(collected
        .into_iter()
        .map(|((exponent, kernel), list)| NormalTerm { coefficient: content::factored(&Expr::sum(list)), exponent, kernel })
        .filter(|term| !term.coefficient.is_zero())
        .collect())
}

/// The expression expanded and collected, as short as the recognition form makes it.
///
/// # Errors
/// As [`normal_terms`].
pub fn expanded(expr: &Expr, variable: &Symbol) -> Result<Expr, ExprError> {
    Ok(Polynomial::from_expr(expr, variable)?.to_expr())
}

/// True if the expression is proven to be zero; false proves nothing.
pub fn is_proven_zero(expr: &Expr, variable: &Symbol) -> bool {
    expr.is_zero()
        || Polynomial::from_expr(expr, variable).is_ok_and(|p| p.is_zero())
        || Polynomial::canonical(expr, variable).is_ok_and(|p| p.is_zero())
}

/// The exact square root of a polynomial in its symbols, up to its sign; `None` if it is no square.
///
/// ```
/// use sneddon_expr::expr::{Expr, normal::square_root};
/// let (a, b) = (Expr::symbol("a"), Expr::symbol("b"));
/// let square = a.power(2) - Expr::integer(2) * &a * &b + b.power(2);
/// assert_eq!(square_root(&square).unwrap().power(2), (&a - &b).power(2));
/// assert_eq!(square_root(&-square), None);
/// ```
pub fn square_root(expr: &Expr) -> Option<Expr> {
    let polynomial = Polynomial::from_expr(expr, &Symbol::new("r")).ok()?;
    Some(sparse::square_root(&polynomial)?.to_expr())
}

/// The coefficients c_k of a polynomial in the variable, by increasing k; `None` if the expression is not a polynomial.
pub fn polynomial_coefficients(expr: &Expr, variable: &Symbol) -> Option<Vec<Expr>> {
    coefficients(&normal_terms(expr, variable).ok()?)
}

/// The coefficients of a recognition form by increasing power; `None` if it is not a polynomial.
pub fn coefficients(terms: &[NormalTerm]) -> Option<Vec<Expr>> {
    const HIGHEST: u32 = 400;
    let mut coefficients: Vec<Expr> = Vec::new();
    for term in terms {
        let k = term.whole_power().filter(|k| *k <= HIGHEST)? as usize;
        while coefficients.len() <= k {
            coefficients.push(Expr::zero());
        }
        if let Some(own) = coefficients.get_mut(k) {
            *own = &*own + &term.coefficient;
        }
    }
    Some(coefficients)
}

/// A sum with fractions written over one whole denominator: a³/4 + 3ab²/8 becomes (2a³ + 3ab²)/8.
pub fn over_whole_denominator(expr: &Expr) -> Expr {
    let terms = expr.terms();
    let denominator = terms.iter().fold(BigInt::one(), |common, term| {
        let (number, _) = term.split_coefficient();
        if number.is_decimal() { common } else { common.lcm(number.value().denom()) }
    });
    if terms.len() < 2 || denominator.is_one() {
        return expr.clone();
    }
    let whole = Expr::number(BigRational::from_integer(denominator).into());
    Expr::sum(terms.iter().map(|term| term * &whole)) / whole
}

/// True for sums and other composite bases that the expansion must look into.
fn is_sum(expr: &Expr) -> bool {
    matches!(expr.node(), Node::Sum(_))
}
