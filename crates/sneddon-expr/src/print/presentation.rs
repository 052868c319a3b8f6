//! How formulas are presented: names of symbols, decimals, rounded numbers, and logarithms for inverse hyperbolic functions.

use super::Renaming;
use super::rounding::{Rounding, with_decimals};
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
        fn has(expr: &Expr, property: &dyn Fn(&Number) -> bool) -> bool {
            expr.as_number().is_some_and(property) || expr.children().into_iter().any(|child| has(child, property))
        }
        let any = |property: &dyn Fn(&Number) -> bool| typed.expressions().into_iter().any(|expr| has(expr, property));
        let decimals = any(&Number::has_decimals) && !any(&|own| !own.has_decimals() && !own.is_short());
        Self { decimals, ..Self::default() }
    }

    /// The name under which this one is shown; see [`Renaming::name`].
    pub fn name(&self, name: &str) -> String {
        self.names.name(name)
    }

    /// The formula as it is presented.
    pub fn formula(&self, formula: &Formula) -> Formula {
        self.names.formula(&if self.is_plain() { formula.clone() } else { formula.map(&|expr| self.expr(expr)) })
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
        self.digits.map_or_else(|| shown.clone(), |digits| Rounding { digits, whole: self.decimals }.expr(&shown))
    }
}
