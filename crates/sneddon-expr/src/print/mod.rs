//! Formulas in every notation: text, Unicode, LaTeX, Typst and MathML.
//!
//! An expression is laid out once as mathematics (`math.rs`), in the order in which it is read, and each notation writes that.
//! Functions that exist only for stable evaluation are replaced by what they equal.
//! Text reads back as an equal expression; the others look as a careful author would set them.

mod compose;
mod decimal_roots;
mod layout;
mod math;
mod named;
mod notation;
pub(crate) mod notations;
mod number;
mod order;
mod parts;
mod presentation;
mod prose;
mod renaming;
mod roots;
mod rounding;

use crate::expr::{Condition, Expr, Formula, shown, shown_as_mathematics};
use compose::Style;
use math::Math;
use notations::{latex, mathml, text, typst, unicode};

pub use notation::Notation;
pub use parts::Names;
pub use presentation::Presentation;
pub use prose::Prose;
pub use renaming::Renaming;

/// The formula in the program's own grammar.
///
/// ```
/// use sneddon_expr::{expr::Expr, print};
/// let (r, radius) = (Expr::symbol("r"), Expr::symbol("R"));
/// let sphere = &radius - (radius.power(2) - r.power(2)).sqrt();
/// assert_eq!(print::text(&sphere.into()), "R - sqrt(R^2 - r^2)");
/// ```
pub fn text(formula: &Formula) -> String {
    text::write(&compose::formula(&formula.map(&shown), Style::Grammar))
}

/// The expression in the program's own grammar.
///
/// ```
/// use sneddon_expr::{expr::Expr, print};
/// assert_eq!(print::text_expr(&(Expr::pi() * Expr::symbol("x") / Expr::integer(2))), "pi/2*x");
/// ```
pub fn text_expr(expr: &Expr) -> String {
    text::write(&compose::expr(&shown(expr), Style::Grammar))
}

/// The condition in the program's own grammar.
///
/// ```
/// use sneddon_expr::{expr::{Condition, Expr}, print};
/// let inside = Condition::less(Expr::symbol("r"), Expr::symbol("R"));
/// assert_eq!(print::text_condition(&inside), "r < R");
/// ```
pub fn text_condition(condition: &Condition) -> String {
    text::write(&compose::condition(&mapped(condition, shown), Style::Grammar))
}

/// The formula in LaTeX, for math mode.
///
/// ```
/// use sneddon_expr::{expr::Expr, print};
/// let (r, radius) = (Expr::symbol("r"), Expr::symbol("R"));
/// let sphere = &radius - (radius.power(2) - r.power(2)).sqrt();
/// assert_eq!(print::latex(&sphere.into()), r"R - \sqrt{R^{2} - r^{2}}");
/// ```
pub fn latex(formula: &Formula) -> String {
    latex::write(&laid_out(formula))
}

/// The expression in LaTeX, for math mode.
///
/// ```
/// use sneddon_expr::{expr::Expr, print};
/// let cone = Expr::pi() / Expr::integer(2) * Expr::symbol("x") * Expr::call("tan", [Expr::symbol("theta")]);
/// assert_eq!(print::latex_expr(&cone), r"\frac{\pi}{2} x \tan\theta");
/// ```
pub fn latex_expr(expr: &Expr) -> String {
    latex::write(&compose::expr(&shown_as_mathematics(expr), Style::Display))
}

/// The condition in LaTeX, for math mode.
///
/// ```
/// use sneddon_expr::{expr::{Condition, Expr}, print};
/// let inside = Condition::less(Expr::symbol("r"), Expr::symbol("R_tip"));
/// assert_eq!(print::latex_condition(&inside), r"r < R_{\mathrm{tip}}");
/// ```
pub fn latex_condition(condition: &Condition) -> String {
    latex::write(&compose::condition(&mapped(condition, shown_as_mathematics), Style::Display))
}

/// The formula on one line of Unicode text.
///
/// ```
/// use sneddon_expr::{expr::Expr, print};
/// let cone = Expr::pi() / Expr::integer(2) * Expr::symbol("x").power(2) * Expr::call("tan", [Expr::symbol("theta")]);
/// assert_eq!(print::unicode(&cone.into()), "π/2·x²·tan θ");
/// ```
pub fn unicode(formula: &Formula) -> String {
    unicode::write(&laid_out(formula))
}

/// The formula in Typst, for math mode.
///
/// ```
/// use sneddon_expr::{expr::Expr, print};
/// let (r, radius) = (Expr::symbol("r"), Expr::symbol("R"));
/// let sphere = &radius - (radius.power(2) - r.power(2)).sqrt();
/// assert_eq!(print::typst(&sphere.into()), "R - sqrt(R^(2) - r^(2))");
/// ```
pub fn typst(formula: &Formula) -> String {
    typst::write(&laid_out(formula))
}

/// The formula as a displayed `math` element of MathML Core.
///
/// ```
/// use sneddon_expr::{expr::Expr, print};
/// let root = Expr::symbol("a").sqrt();
/// assert!(print::mathml(&root.into()).contains("<msqrt><mi>a</mi></msqrt>"));
/// ```
pub fn mathml(formula: &Formula) -> String {
    mathml::formula(&laid_out(formula))
}

/// An equation as a `math` element of MathML Core; `left` is a name, or a name with an argument. It may apply from a
/// value of a variable on, which `range` names.
///
/// ```
/// use sneddon_expr::{expr::Expr, print};
/// assert!(print::mathml_equation("d(a)", &Expr::symbol("a").into(), None).contains("<mo>=</mo><mi>a</mi>"));
/// ```
pub fn mathml_equation(left: &str, formula: &Formula, range: Option<(&str, &Expr)>) -> String {
    let range = range.map(|(variable, from)| (variable, compose::expr(&shown_as_mathematics(from), Style::Display)));
    mathml::equation(left, &laid_out(formula), range)
}

/// The text with those characters escaped that mean something in HTML and XML.
///
/// ```
/// assert_eq!(sneddon_expr::print::escaped("r < R & <b>"), "r &lt; R &amp; &lt;b&gt;");
/// ```
pub fn escaped(text: &str) -> String {
    mathml::escaped(text)
}

/// The words as LaTeX sets them in a text, every character that means something to it escaped.
///
/// ```
/// assert_eq!(sneddon_expr::print::latex_words("R_1 & 5 %"), r"R\_1 \& 5 \%");
/// ```
pub fn latex_words(words: &str) -> String {
    prose::latex_words(words)
}

fn laid_out(formula: &Formula) -> Math {
    compose::formula(&formula.map(&shown_as_mathematics), Style::Display)
}

fn mapped(condition: &Condition, form: fn(&Expr) -> Expr) -> Condition {
    Condition { left: form(&condition.left), right: form(&condition.right), ..condition.clone() }
}

/// The terms of a sum with their signs, and no sign before a first term that is added.
fn signed_terms(terms: &[(bool, Math)], minus: &str, write: impl Fn(&Math) -> String) -> String {
    let mut sum = String::new();
    for (place, (negative, term)) in terms.iter().enumerate() {
        match (place, negative) {
            (0, true) => sum.push_str(minus),
            (0, false) => {}
            (_, true) => sum.push_str(&format!(" {minus} ")),
            (_, false) => sum.push_str(" + "),
        }
        sum.push_str(&write(term));
    }
    sum
}
