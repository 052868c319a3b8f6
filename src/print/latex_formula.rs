//! Pieces, integrals and sums of them in LaTeX.

use super::latex::{Style, append, expr, parenthesised, product};
use super::latex_symbol::symbol;
use super::order;
use crate::expr::{Expr, Formula, Node, Relation, Symbol};

pub(super) fn formula(formula: &Formula) -> String {
    let (negative, body) = signed(formula);
    if negative { format!("-{body}") } else { body }
}

pub(super) fn relation(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => "<",
        Relation::LessOrEqual => "\\le",
        Relation::Equal => "=",
    }
}

/// The sign of a formula and the rest of it.
fn signed(formula: &Formula) -> (bool, String) {
    match formula {
        Formula::Closed(closed) if matches!(closed.node(), Node::Sum(_)) => (false, expr(closed)),
        Formula::Closed(closed) => product(closed, Style::Display),
        Formula::Sum(parts) => {
            let mut sum = String::new();
            for part in parts {
                match part {
                    // A sum begins with its own sign.
                    Formula::Closed(closed) if matches!(closed.node(), Node::Sum(_)) => {
                        for term in order::terms(closed) {
                            append(&mut sum, product(&term, Style::Display));
                        }
                    }
                    other => append(&mut sum, signed(other)),
                }
            }
            (false, sum)
        }
        Formula::Scaled(scale, inner) => scaled(scale, inner),
        Formula::Piecewise { variable, pieces, last } => (false, cases(variable, pieces, last)),
        Formula::Integral { integrand, variable, lower, upper } => {
            let (negative, body) = match &**integrand {
                Formula::Closed(closed) if closed.is_one() => (false, String::new()),
                Formula::Sum(_) => (false, parenthesised(&self::formula(integrand)) + " "),
                Formula::Closed(closed) if matches!(closed.node(), Node::Sum(_)) => (false, parenthesised(&expr(closed)) + " "),
                other => {
                    let (negative, body) = signed(other);
                    (negative, body + " ")
                }
            };
            let variable = symbol(variable.name());
            (negative, format!("\\int_{{{}}}^{{{}}} {body}\\,\\mathrm{{d}}{variable}", expr(lower), expr(upper)))
        }
    }
}

fn scaled(scale: &Expr, inner: &Formula) -> (bool, String) {
    let (negative, scale) = match scale.node() {
        Node::Sum(_) => (false, parenthesised(&expr(scale))),
        _ => product(scale, Style::Display),
    };
    let (inner_negative, inner) = match inner {
        Formula::Sum(_) => (false, parenthesised(&formula(inner))),
        _ => signed(inner),
    };
    (negative != inner_negative, if scale == "1" { inner } else { format!("{scale} {inner}") })
}

fn cases(variable: &Symbol, pieces: &[(Formula, Expr)], last: &Formula) -> String {
    let name = symbol(variable.name());
    let mut rows = Vec::with_capacity(pieces.len() + 1);
    let mut start: Option<String> = None;
    for (value, end) in pieces {
        let end = expr(end);
        let range = start.map_or_else(|| format!("{name} < {end}"), |start| format!("{start} \\le {name} < {end}"));
        rows.push(format!("{}, & {range}", formula(value)));
        start = Some(end);
    }
    let range = start.map_or_else(String::new, |start| format!("{name} \\ge {start}"));
    rows.push(format!("{}, & {range}", formula(last)));
    format!("\\begin{{cases}} {} \\end{{cases}}", rows.join(" \\\\ "))
}
