//! The displayed form: functions that exist only for stable evaluation are replaced by equivalent standard expressions.

use super::{Expr, Node, Row, rewritten};

/// The expression that is printed for `expr`; parts without such functions are unchanged.
///
/// ```
/// use sneddon_expr::expr::{Expr, shown};
/// let stable = Expr::call("artanh_ratio", [Expr::symbol("x"), Expr::symbol("R")]);
/// assert_eq!(shown(&stable), Expr::call("atanh", [Expr::symbol("x") / Expr::symbol("R")]));
/// ```
pub fn shown(expr: &Expr) -> Expr {
    replaced(expr, &|row, a| row.shown.map(|rule| rule(a)))
}

/// The expression for mathematical notation, where functions with a symbol are kept.
pub fn shown_as_mathematics(expr: &Expr) -> Expr {
    replaced(expr, &|row, a| row.shown.filter(|_| !row.has_sign).map(|rule| rule(a)))
}

/// The same with inverse hyperbolic functions as logarithms.
///
/// arsinh z = ln(z + √(z²+1)), arcosh z = ln(z + √(z²−1)), artanh z = ln((1+z)/(1−z))/2.
///
/// ```
/// use sneddon_expr::expr::{Expr, shown_with_logarithms};
/// let z = Expr::symbol("z");
/// let logarithm = Expr::call("ln", [&z + (z.power(2) + Expr::one()).sqrt()]);
/// assert_eq!(shown_with_logarithms(&Expr::call("asinh", [z])), logarithm);
/// ```
pub fn shown_with_logarithms(expr: &Expr) -> Expr {
    let ln = |argument: Expr| Some(Expr::call("ln", [argument]));
    let form = |row: &Row, a: &[Expr]| match (row.name, a) {
        ("asinh", [z]) => ln(z + (z.power(2) + Expr::one()).sqrt()),
        ("acosh", [z]) => ln(z + (z.power(2) - Expr::one()).sqrt()),
        // ln((R + x)/(R − x))/2 for x/R.
        ("atanh", [z]) => {
            let (above, below) =
                z.factors().into_iter().partition::<Vec<_>, _>(|own| !own.split_power().1.split_coefficient().0.is_negative());
            let (above, below) = (Expr::product(above), Expr::product(below).recip());
            ln((&below + &above) / (below - above)).map(|own| own / Expr::integer(2))
        }
        _ => row.shown.filter(|_| !row.has_sign).map(|rule| rule(a)),
    };
    replaced(expr, &form)
}

/// The expression that is evaluated with 30 digits: functions without a 30-digit value are replaced by equivalent expressions,
/// if these have 30-digit values.
pub fn shown_to_30_digits(expr: &Expr) -> Expr {
    let form = |row: &Row, a: &[Expr]| {
        let rule = row.shown.filter(|_| row.precise.is_none())?;
        Some(shown_to_30_digits(&rule(a))).filter(has_30_digits)
    };
    replaced(expr, &form)
}

/// Whether every function in the expression has a value with 30 digits.
pub fn has_30_digits(expr: &Expr) -> bool {
    match expr.node() {
        Node::Number(_) | Node::Constant(_) | Node::Symbol(_) => true,
        Node::Power(base, exponent) => has_30_digits(base) && has_30_digits(exponent),
        Node::Function(function, arguments) => function.row().precise.is_some() && arguments.iter().all(has_30_digits),
        Node::Product(parts) | Node::Sum(parts) => parts.iter().all(has_30_digits),
    }
}

/// The replacement of a function at the given arguments, if any.
type Form<'a> = &'a dyn Fn(&Row, &[Expr]) -> Option<Expr>;

fn replaced(expr: &Expr, form: Form<'_>) -> Expr {
    rewritten(expr, &|own, again| {
        let Node::Function(function, arguments) = own.node() else { return None };
        let inner: Vec<Expr> = arguments.iter().map(again).collect();
        let here = form(function.row(), &inner)?;
        Some(again(&here))
    })
}
