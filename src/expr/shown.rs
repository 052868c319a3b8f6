//! The form that a reader sees: functions that exist for stable evaluation give way to what they equal.

use super::{Expr, Node};

/// The expression that is printed for `expr`; parts without such functions are kept as they are.
///
/// ```
/// use sneddon::expr::{Expr, shown};
/// let stable = Expr::call("artanh_ratio", [Expr::symbol("x"), Expr::symbol("R")]);
/// assert_eq!(shown(&stable), Expr::call("atanh", [Expr::symbol("x") / Expr::symbol("R")]));
/// ```
pub fn shown(expr: &Expr) -> Expr {
    replaced(expr, false).unwrap_or_else(|| expr.clone())
}

/// The expression that LaTeX sets: functions that have a sign of their own there are kept.
pub fn shown_in_latex(expr: &Expr) -> Expr {
    replaced(expr, true).unwrap_or_else(|| expr.clone())
}

/// The replacement, where anything changes.
fn replaced(expr: &Expr, latex: bool) -> Option<Expr> {
    match expr.node() {
        Node::Number(_) | Node::Constant(_) | Node::Symbol(_) => None,
        Node::Power(base, exponent) => {
            let (new_base, new_exponent) = (replaced(base, latex), replaced(exponent, latex));
            if new_base.is_none() && new_exponent.is_none() {
                return None;
            }
            Some(new_base.as_ref().unwrap_or(base).pow(new_exponent.as_ref().unwrap_or(exponent)))
        }
        Node::Function(function, arguments) => {
            let inner = all_replaced(arguments, latex);
            match function.row().shown.filter(|_| !(latex && function.row().in_latex)) {
                Some(rule) => {
                    let form = rule(inner.as_deref().unwrap_or(arguments));
                    Some(replaced(&form, latex).unwrap_or(form))
                }
                None => inner.map(|arguments| Expr::function(*function, arguments)),
            }
        }
        Node::Product(factors) => all_replaced(factors, latex).map(Expr::product),
        Node::Sum(terms) => all_replaced(terms, latex).map(Expr::sum),
    }
}

fn all_replaced(parts: &[Expr], latex: bool) -> Option<Vec<Expr>> {
    let new: Vec<Option<Expr>> = parts.iter().map(|part| replaced(part, latex)).collect();
    if new.iter().all(Option::is_none) {
        return None;
    }
    Some(new.into_iter().zip(parts).map(|(new, old)| new.unwrap_or_else(|| old.clone())).collect())
}
