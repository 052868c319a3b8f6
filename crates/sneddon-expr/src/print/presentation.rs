//! How formulas are presented: names of symbols, decimals, rounded numbers, and logarithms for inverse hyperbolic functions.

use super::Renaming;
use super::rounding::{MOST_DIGITS, Rounding, with_decimals};
use crate::expr::{Condition, Expr, Formula, Number, shown_as_mathematics, shown_with_logarithms};

/// Changes applied to formulas before they are printed; empty by default.
///
/// ```
/// use sneddon_expr::{expr::Expr, print::{self, Presentation}};
/// let third = Expr::ratio(1000, 2999) * Expr::call("acosh", [Expr::symbol("z")]);
/// let presentation = Presentation { digits: Some(3), logarithms: true, ..Presentation::default() };
/// assert_eq!(print::text(&presentation.formula(&third.into())), "0.333*ln(z + sqrt(z^2 - 1))");
/// ```
#[derive(Clone, Debug, Default)]
pub struct Presentation {
    /// Names that are shown in place of the program's own.
    pub names: Renaming,
    /// Whether long fractions are written with decimals, and long whole numbers rounded.
    pub decimals: bool,
    /// The largest number of significant digits of decimals; `None` for exact numbers.
    pub digits: Option<u32>,
    /// Whether inverse hyperbolic functions are written as logarithms.
    pub logarithms: bool,
}

impl Presentation {
    /// The default presentation of results for a typed formula: with decimals if it was typed with decimals and without long fractions.
    pub fn of(typed: &Formula) -> Self {
        let any = |property: &dyn Fn(&Number) -> bool| {
            typed.expressions().into_iter().flat_map(Expr::parts).filter_map(Expr::as_number).any(property)
        };
        let decimals = any(&Number::has_decimals) && !any(&|own| !own.has_decimals() && !own.is_short());
        Self { decimals, ..Self::default() }
    }

    /// The name under which this one is shown; see [`Renaming::name`].
    pub fn name(&self, name: &str) -> String {
        self.names.name(name)
    }

    /// The formula as it is presented.
    pub fn formula(&self, formula: &Formula) -> Formula {
        if self.is_plain() {
            return self.names.formula(formula);
        }
        let shown = formula.map(&|expr| self.expr(expr));
        match self.digits {
            Some(digits) if digits < MOST_DIGITS && has_empty_piece(&shown) => {
                Self { digits: Some(digits + 1), ..self.clone() }.formula(formula)
            }
            _ => self.names.formula(&shown),
        }
    }

    /// The condition as it is presented.
    pub fn condition(&self, condition: &Condition) -> Condition {
        let Condition { left, relation, right } = condition;
        self.names.condition(&Condition { left: self.expr(left), relation: *relation, right: self.expr(right) })
    }

    fn is_plain(&self) -> bool {
        self.digits.is_none() && !self.logarithms && !self.decimals
    }

    fn expr(&self, expr: &Expr) -> Expr {
        if self.is_plain() {
            return expr.clone();
        }
        let shown = if self.logarithms { shown_with_logarithms(expr) } else { shown_as_mathematics(expr) };
        let shown = if self.decimals { with_decimals(&shown) } else { shown };
        match self.digits {
            Some(digits) => Rounding { digits }.expr(&shown),
            None => shown,
        }
    }
}

/// Returns whether two pieces end at the same place.
fn has_empty_piece(formula: &Formula) -> bool {
    match formula {
        Formula::Closed(_) => false,
        Formula::Sum(parts) => parts.iter().any(has_empty_piece),
        Formula::Scaled(_, inner) => has_empty_piece(inner),
        Formula::Integral { integrand, .. } => has_empty_piece(integrand),
        Formula::Piecewise { pieces, last, .. } => {
            let ends = || pieces.iter().map(|(_, end)| end);
            ends().zip(ends().skip(1)).any(|(one, next)| one == next)
                || pieces.iter().any(|(value, _)| has_empty_piece(value))
                || has_empty_piece(last)
        }
    }
}
