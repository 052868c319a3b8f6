//! Formulas in the program's own grammar; what is written here reads back as an equal expression.

use super::layout::{Factor, layout};
use super::number::digits;
use super::order;
use crate::expr::{Constant, Expr, Formula, Function, Node, Relation};

pub(super) fn formula(formula: &Formula) -> String {
    let (negative, body) = signed(formula);
    if negative { format!("-{body}") } else { body }
}

pub(super) fn relation(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => "<",
        Relation::LessOrEqual => "<=",
        Relation::Equal => "=",
    }
}

pub(super) fn expr(expr: &Expr) -> String {
    if let Node::Sum(_) = expr.node() {
        let mut sum = String::new();
        for term in order::terms(expr) {
            append(&mut sum, product(&term));
        }
        return sum;
    }
    let (negative, body) = product(expr);
    if negative { format!("-{body}") } else { body }
}

/// Adds a term with its sign to a sum.
fn append(sum: &mut String, (negative, body): (bool, String)) {
    sum.push_str(match (sum.is_empty(), negative) {
        (true, true) => "-",
        (true, false) => "",
        (false, true) => " - ",
        (false, false) => " + ",
    });
    sum.push_str(&body);
}

/// The sign of a formula and the rest of it.
fn signed(formula: &Formula) -> (bool, String) {
    match formula {
        Formula::Closed(closed) if matches!(closed.node(), Node::Sum(_)) => (false, expr(closed)),
        Formula::Closed(closed) => product(closed),
        Formula::Sum(parts) => {
            let mut sum = String::new();
            for part in parts {
                match part {
                    // A sum begins with its own sign.
                    Formula::Closed(closed) if matches!(closed.node(), Node::Sum(_)) => {
                        for term in order::terms(closed) {
                            append(&mut sum, product(&term));
                        }
                    }
                    other => append(&mut sum, signed(other)),
                }
            }
            (false, sum)
        }
        Formula::Scaled(scale, inner) => {
            let (negative, scale) = match scale.node() {
                Node::Sum(_) => (false, format!("({})", expr(scale))),
                _ => product(scale),
            };
            let (inner_negative, inner) = match **inner {
                Formula::Sum(_) => (false, format!("({})", self::formula(inner))),
                _ => signed(inner),
            };
            (negative != inner_negative, if scale == "1" { inner } else { format!("{scale}*{inner}") })
        }
        Formula::Piecewise { variable, pieces, last } => {
            let mut arguments: Vec<String> = Vec::with_capacity(2 * pieces.len() + 1);
            for (value, end) in pieces {
                arguments.push(self::formula(value));
                arguments.push(format!("{variable} < {}", expr(end)));
            }
            arguments.push(self::formula(last));
            (false, format!("piecewise({})", arguments.join(", ")))
        }
        Formula::Integral { integrand, variable, lower, upper } => {
            (false, format!("integral({}, {variable}, {}, {})", self::formula(integrand), expr(lower), expr(upper)))
        }
    }
}

/// The sign of a product and the rest of it.
fn product(product: &Expr) -> (bool, String) {
    let layout = layout(product);
    let mut text = if layout.upper.is_empty() { "1".to_owned() } else { joined(&layout.upper) };
    match layout.lower.as_slice() {
        [] => {}
        [only] => text = format!("{text}/{}", factor(only)),
        lower => text = format!("{text}/({})", joined(lower)),
    }
    if !layout.behind.is_empty() {
        text = format!("{text}*{}", joined(&layout.behind));
    }
    (layout.negative, text)
}

fn joined(factors: &[Factor]) -> String {
    factors.iter().map(factor).collect::<Vec<_>>().join("*")
}

fn factor(factor: &Factor) -> String {
    if factor.root() == Some(2) {
        return format!("sqrt({})", expr(&factor.base));
    }
    let base = match factor.base.node() {
        Node::Sum(_) | Node::Product(_) | Node::Power(..) => format!("({})", expr(&factor.base)),
        _ => operand(&factor.base),
    };
    if factor.exponent.is_one() { base } else { format!("{base}^{}", operand(&factor.exponent)) }
}

/// An expression where an operator binds it: in parentheses unless it is a single unit.
fn operand(operand: &Expr) -> String {
    match operand.node() {
        Node::Number(number) if number.is_negative() || !(number.is_integer() || number.is_decimal()) => format!("({})", expr(operand)),
        Node::Number(number) => {
            let digits = digits(number);
            digits.exponent.map_or(digits.mantissa.clone(), |exponent| format!("{}e{exponent}", digits.mantissa))
        }
        Node::Constant(Constant::Pi) => "pi".to_owned(),
        Node::Constant(Constant::Euler) => "e".to_owned(),
        Node::Symbol(symbol) => symbol.name().to_owned(),
        Node::Function(function, arguments) => call(*function, arguments),
        Node::Power(..) | Node::Product(_) | Node::Sum(_) => format!("({})", expr(operand)),
    }
}

fn call(function: Function, arguments: &[Expr]) -> String {
    let list = |arguments: &[Expr]| arguments.iter().map(expr).collect::<Vec<_>>().join(", ");
    // The row's arguments are the lengths of both lists, their entries, and the variable.
    if let ("hyper", [upper, lower, rest @ ..]) = (function.name(), arguments)
        && let (Some(p), Some(q)) = (length(upper), length(lower))
        && let Some((upper, rest)) = rest.split_at_checked(p)
        && let Some((lower, rest)) = rest.split_at_checked(q)
    {
        return format!("hyper([{}], [{}], {})", list(upper), list(lower), list(rest));
    }
    format!("{}({})", function.name(), list(&order::arguments(function, arguments)))
}

fn length(expr: &Expr) -> Option<usize> {
    expr.as_integer().and_then(|n| usize::try_from(n).ok())
}
