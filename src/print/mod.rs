//! Formulas to text and LaTeX, in the order in which they are read.
//!
//! Both print the *shown* form: functions that exist only for stable evaluation are replaced by what they equal.
//! Text reads back as an equal expression; LaTeX is set as a careful author would set it.

mod latex;
mod latex_formula;
mod latex_symbol;
mod layout;
mod number;
mod order;
mod roots;
mod text;

use crate::expr::{Condition, Expr, Formula, shown, shown_in_latex};

/// The formula in the program's own grammar.
///
/// ```
/// use sneddon::{expr::Expr, print};
/// let (r, radius) = (Expr::symbol("r"), Expr::symbol("R"));
/// let sphere = &radius - (radius.power(2) - r.power(2)).sqrt();
/// assert_eq!(print::text(&sphere.into()), "R - sqrt(R^2 - r^2)");
/// ```
pub fn text(formula: &Formula) -> String {
    text::formula(&formula.map(&shown))
}

/// The expression in the program's own grammar.
///
/// ```
/// use sneddon::{expr::Expr, print};
/// assert_eq!(print::text_expr(&(Expr::pi() * Expr::symbol("x") / Expr::integer(2))), "pi/2*x");
/// ```
pub fn text_expr(expr: &Expr) -> String {
    text::expr(&shown(expr))
}

/// The condition in the program's own grammar.
///
/// ```
/// use sneddon::{expr::{Condition, Expr}, print};
/// let inside = Condition::less(Expr::symbol("r"), Expr::symbol("R"));
/// assert_eq!(print::text_condition(&inside), "r < R");
/// ```
pub fn text_condition(condition: &Condition) -> String {
    let (left, right) = (shown(&condition.left), shown(&condition.right));
    format!("{} {} {}", text::expr(&left), text::relation(condition.relation), text::expr(&right))
}

/// The formula in LaTeX, for math mode.
///
/// ```
/// use sneddon::{expr::Expr, print};
/// let (r, radius) = (Expr::symbol("r"), Expr::symbol("R"));
/// let sphere = &radius - (radius.power(2) - r.power(2)).sqrt();
/// assert_eq!(print::latex(&sphere.into()), r"R - \sqrt{R^{2} - r^{2}}");
/// ```
pub fn latex(formula: &Formula) -> String {
    latex_formula::formula(&formula.map(&shown_in_latex))
}

/// The expression in LaTeX, for math mode.
///
/// ```
/// use sneddon::{expr::Expr, print};
/// let cone = Expr::pi() / Expr::integer(2) * Expr::symbol("x") * Expr::call("tan", [Expr::symbol("theta")]);
/// assert_eq!(print::latex_expr(&cone), r"\frac{\pi}{2} x \tan\theta");
/// ```
pub fn latex_expr(expr: &Expr) -> String {
    latex::expr(&shown_in_latex(expr))
}

/// The condition in LaTeX, for math mode.
///
/// ```
/// use sneddon::{expr::{Condition, Expr}, print};
/// let inside = Condition::less(Expr::symbol("r"), Expr::symbol("R_tip"));
/// assert_eq!(print::latex_condition(&inside), r"r < R_{\mathrm{tip}}");
/// ```
pub fn latex_condition(condition: &Condition) -> String {
    let (left, right) = (shown_in_latex(&condition.left), shown_in_latex(&condition.right));
    format!("{} {} {}", latex::expr(&left), latex_formula::relation(condition.relation), latex::expr(&right))
}
