//! Expressions in LaTeX.

use super::latex_symbol::symbol;
use super::layout::{Factor, Layout, layout};
use super::number::digits;
use super::order;
use crate::expr::function::Latex;
use crate::expr::{Constant, Expr, Function, Node, Number};

/// Where an expression stands.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Style {
    /// On the line, with built-up fractions.
    Display,
    /// In an exponent, with fractions on one line.
    Exponent,
}

/// Functions whose name stands before a single symbol without parentheses.
const BARE: [&str; 13] = ["ln", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh"];

pub(super) fn expr(expr: &Expr) -> String {
    styled(expr, Style::Display)
}

fn styled(expr: &Expr, style: Style) -> String {
    if let Node::Sum(_) = expr.node() {
        let mut sum = String::new();
        for term in order::terms(expr) {
            append(&mut sum, product(&term, style));
        }
        return sum;
    }
    let (negative, body) = product(expr, style);
    if negative { format!("-{body}") } else { body }
}

/// Adds a term with its sign to a sum.
pub(super) fn append(sum: &mut String, (negative, body): (bool, String)) {
    sum.push_str(match (sum.is_empty(), negative) {
        (true, true) => "-",
        (true, false) => "",
        (false, true) => " - ",
        (false, false) => " + ",
    });
    sum.push_str(&body);
}

/// The expression in parentheses that are as tall as it is.
pub(super) fn parenthesised(inner: &str) -> String {
    let tall = ["\\frac", "\\sqrt", "\\left", "\\int", "\\begin"].iter().any(|part| inner.contains(part));
    if tall { format!("\\left({inner}\\right)") } else { format!("({inner})") }
}

/// The sign of a product and the rest of it.
pub(super) fn product(expr: &Expr, style: Style) -> (bool, String) {
    let layout = layout(expr);
    let body = if layout.lower.is_empty() {
        alone(&layout.upper, style)
    } else if style == Style::Exponent {
        slashed(&layout)
    } else {
        let upper = if layout.upper.is_empty() { "1".to_owned() } else { alone(&layout.upper, style) };
        let fraction = format!("\\frac{{{upper}}}{{{}}}", alone(&layout.lower, style));
        std::iter::once(fraction).chain(layout.behind.iter().map(|f| factor(f, style, true))).reduce(beside).unwrap_or_default()
    };
    (layout.negative, body)
}

/// A product where nothing stands beside it; a single sum needs no parentheses then.
fn alone(factors: &[Factor], style: Style) -> String {
    match factors {
        [] => "1".to_owned(),
        [Factor { base, exponent }] if exponent.is_one() && matches!(base.node(), Node::Sum(_)) => styled(base, style),
        _ => joined(factors, style, true),
    }
}

fn joined(factors: &[Factor], style: Style, bare: bool) -> String {
    factors.iter().map(|f| factor(f, style, bare)).reduce(beside).unwrap_or_default()
}

/// A fraction on one line.
fn slashed(layout: &Layout) -> String {
    let upper: Vec<Factor> = layout.upper.iter().chain(&layout.behind).cloned().collect();
    let upper = if upper.is_empty() { "1".to_owned() } else { joined(&upper, Style::Exponent, false) };
    let lower = joined(&layout.lower, Style::Exponent, false);
    if layout.lower.len() == 1 { format!("{upper}/{lower}") } else { format!("{upper}/{}", parenthesised(&lower)) }
}

/// Two factors beside each other.
fn beside(left: String, right: String) -> String {
    if right.starts_with(|c: char| c.is_ascii_digit()) {
        format!("{left} \\cdot {right}")
    } else if ends_with_root(&left) || right.starts_with("\\int") || right.starts_with("{}_") {
        // An index in front, as of ₂F₁, would cling to what stands before it.
        format!("{left}\\, {right}")
    } else {
        format!("{left} {right}")
    }
}

/// True where the last thing set is a root, after which a letter needs a little space.
fn ends_with_root(left: &str) -> bool {
    let mut depth = 0usize;
    for (at, c) in left.char_indices().rev() {
        match c {
            '}' => depth += 1,
            '{' => depth = depth.saturating_sub(1),
            _ => continue,
        }
        if depth == 0 {
            let before = left.get(..at).unwrap_or("");
            return left.ends_with('}') && (before.ends_with("\\sqrt") || before.ends_with(']'));
        }
    }
    false
}

fn factor(factor: &Factor, style: Style, bare: bool) -> String {
    let Factor { base, exponent } = factor;
    match factor.root() {
        Some(2) => return format!("\\sqrt{{{}}}", styled(base, style)),
        Some(k @ 3..=9) => return format!("\\sqrt[{k}]{{{}}}", styled(base, style)),
        _ => {}
    }
    if exponent.is_one() {
        return unit(base, style, bare, None);
    }
    let power = styled(exponent, Style::Exponent);
    match base.node() {
        Node::Function(function, _) if factor.whole().is_some() && matches!(function.row().latex, Latex::Operator(_)) => {
            unit(base, style, bare, Some(&power))
        }
        Node::Symbol(symbol) if symbol.name() == "E" => format!("{{E^{{*}}}}^{{{power}}}"),
        Node::Number(number) if is_plain(number) => format!("{}^{{{power}}}", unit(base, style, bare, None)),
        Node::Symbol(_) | Node::Constant(_) | Node::Sum(_) => format!("{}^{{{power}}}", unit(base, style, bare, None)),
        Node::Function(function, _)
            if matches!(function.row().latex, Latex::Custom(_)) && closes_itself(&unit(base, style, bare, None)) =>
        {
            format!("{}^{{{power}}}", unit(base, style, bare, None))
        }
        _ => format!("{}^{{{power}}}", parenthesised(&styled(base, style))),
    }
}

/// True where an exponent behind the last sign can only belong to the whole.
fn closes_itself(set: &str) -> bool {
    set.ends_with(')') || set.ends_with('|')
}

fn is_plain(number: &Number) -> bool {
    !number.is_negative() && (number.is_integer() || number.is_decimal()) && digits(number).exponent.is_none()
}

/// A base without its exponent; `power` belongs to the name of an operator.
fn unit(base: &Expr, style: Style, bare: bool, power: Option<&str>) -> String {
    match base.node() {
        Node::Number(number) => {
            let digits = digits(number);
            match (digits.mantissa.as_str(), digits.exponent) {
                (_, None) => digits.mantissa,
                ("1", Some(exponent)) => format!("10^{{{exponent}}}"),
                (mantissa, Some(exponent)) => format!("{mantissa} \\cdot 10^{{{exponent}}}"),
            }
        }
        Node::Constant(Constant::Pi) => "\\pi".to_owned(),
        Node::Constant(Constant::Euler) => "e".to_owned(),
        Node::Symbol(name) => symbol(name.name()),
        Node::Function(function, arguments) => call(*function, arguments, style, bare, power),
        Node::Power(..) | Node::Product(_) | Node::Sum(_) => parenthesised(&styled(base, style)),
    }
}

fn call(function: Function, arguments: &[Expr], style: Style, bare: bool, power: Option<&str>) -> String {
    if let ("exp", [argument]) = (function.name(), arguments) {
        return format!("e^{{{}}}", styled(argument, Style::Exponent));
    }
    let arguments = order::arguments(function, arguments);
    let set: Vec<String> = arguments.iter().map(|argument| styled(argument, style)).collect();
    let operator = match function.row().latex {
        Latex::Custom(set_by_row) => return set_by_row(&set),
        Latex::Operator(operator) => operator,
    };
    let operator = power.map_or_else(|| operator.to_owned(), |power| format!("{operator}^{{{power}}}"));
    match (arguments.as_slice(), set.as_slice()) {
        ([argument], [set]) if bare && BARE.contains(&function.name()) && is_single(argument, function) => {
            if set.starts_with('\\') {
                format!("{operator}{set}")
            } else {
                format!("{operator} {set}")
            }
        }
        _ => format!("{operator}{}", parenthesised(&set.join(", "))),
    }
}

/// True for what a function takes without parentheses.
fn is_single(argument: &Expr, function: Function) -> bool {
    match argument.node() {
        Node::Symbol(_) | Node::Constant(_) => true,
        Node::Number(number) => function.name() == "ln" && is_plain(number),
        _ => false,
    }
}
