//! Constants without a finite real value, such as 1/0, ln 0 and tan(π/2), which the parser refuses and a substitution may produce.

use crate::expr::{Expr, Formula, Function, Node, Number, Sign, known_sign};

/// True if the function is known to be infinite for these arguments, such as tan(π/2), Γ(0) and artanh 1.
pub fn has_pole(function: Function, arguments: &[Expr]) -> bool {
    match function.name() {
        "tan" => Function::named("cos").is_some_and(|cosine| Expr::function(cosine, arguments.to_vec()).is_zero()),
        "gamma" | "digamma" | "polygamma" => arguments.last().and_then(Expr::as_integer).is_some_and(|n| n <= 0),
        // Infinite by overflow, as exp(1000), is a value.
        _ => {
            numbers(arguments).is_some_and(|own| own.iter().all(|number| number.abs() <= 1.0) && (function.row().value)(&own).is_infinite())
        }
    }
}

fn numbers(arguments: &[Expr]) -> Option<Vec<f64>> {
    arguments.iter().map(|argument| argument.as_number().map(Number::to_f64)).collect()
}

/// False if the function is known to have no finite real value for these arguments.
pub(crate) fn has_value(function: Function, arguments: &[Expr]) -> bool {
    let row = function.row();
    let value = numbers(arguments).map(|own| (row.value)(&own));
    if value.is_some_and(f64::is_nan) || has_pole(function, arguments) {
        return false;
    }
    row.domain.is_none_or(|domain| {
        domain(arguments).iter().all(|bound| match known_sign(bound) {
            Sign::Negative => false,
            Sign::Zero => value.is_some_and(f64::is_finite),
            Sign::Positive | Sign::Unknown => true,
        })
    })
}

/// The first part of a formula that is a constant without a finite real value, such as tan θ after θ = π/2 is set; `None` if there
/// is none, or none is known.
///
/// ```
/// use sneddon_expr::{expr::{Bindings, Expr, undefined_constant}, parse, print};
/// let formula = parse::profile("r*tan(theta) + r^2/(2*R)").unwrap();
/// let set = |value: Expr| undefined_constant(&formula.substitute(&Bindings::one("theta", value)));
/// assert_eq!(print::text_expr(&set(Expr::pi() / Expr::integer(2)).unwrap()), "tan(pi/2)");
/// assert!(set(Expr::ratio(1, 3)).is_none());
/// ```
pub fn undefined_constant(formula: &Formula) -> Option<Expr> {
    formula.expressions().into_iter().find_map(|expr| examine(expr).err())
}

/// Whether the expression is a constant; the error is a constant within it that has no value.
fn examine(expr: &Expr) -> Result<bool, Expr> {
    let mut is_constant = !matches!(expr.node(), Node::Symbol(_));
    for child in expr.children() {
        is_constant &= examine(child)?;
    }
    let is_undefined = match expr.node() {
        Node::Power(base, exponent) if base.is_zero() => known_sign(exponent) == Sign::Negative,
        Node::Power(base, exponent) => {
            is_constant && exponent.as_number().is_some_and(|own| !own.is_integer()) && known_sign(base) == Sign::Negative
        }
        Node::Function(function, arguments) => is_constant && !has_value(*function, arguments),
        _ => false,
    };
    if is_undefined { Err(expr.clone()) } else { Ok(is_constant) }
}
