//! Lays out expressions and formulas as mathematics.

use super::layout::{Factor, Layout, layout_for};
use super::math::{Call, Math};
use super::number::digits;
use super::order;
use crate::expr::function::Setting;
use crate::expr::{Condition, Expr, Formula, Function, Node, Number};
use crate::num::work;

/// Functions whose name precedes a single symbol without parentheses.
const BARE: [&str; 13] = ["ln", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh"];

/// The purpose of a layout.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Style {
    /// The program's grammar: the sign of an integrand stays with it, so that the formula reads back as it is.
    Grammar,
    /// Mathematics on the line, with built-up fractions.
    Display,
    /// Mathematics in an exponent, with fractions on one line.
    Exponent,
}

impl Style {
    /// The style of an exponent.
    fn raised(self) -> Self {
        if self == Self::Grammar { self } else { Self::Exponent }
    }
}

/// Lays out a formula.
pub(super) fn formula(formula: &Formula, style: Style) -> Math {
    with_sign(signed(formula, style))
}

/// Lays out a condition.
pub(super) fn condition(condition: &Condition, style: Style) -> Math {
    Math::Relation(Box::new(expr(&condition.left, style)), condition.relation, Box::new(expr(&condition.right, style)))
}

fn with_sign((negative, body): (bool, Math)) -> Math {
    if negative { Math::Negative(Box::new(body)) } else { body }
}

/// Lays out an expression.
pub(super) fn expr(expr: &Expr, style: Style) -> Math {
    if let Node::Sum(_) = expr.node() {
        return Math::Sum(order::terms(expr).iter().map(|term| product(term, style)).collect());
    }
    with_sign(turned(expr, style))
}

fn parenthesised(inner: Math) -> Math {
    Math::Parentheses(Box::new(inner))
}

/// The sign of a formula and the rest of it.
fn signed(formula: &Formula, style: Style) -> (bool, Math) {
    // The output is discarded after a stop.
    if work::is_stopped() {
        return (false, one());
    }
    match formula {
        Formula::Closed(closed) if matches!(closed.node(), Node::Sum(_)) => (false, expr(closed, style)),
        Formula::Closed(closed) => turned(closed, style),
        Formula::Sum(parts) => {
            let mut terms = Vec::new();
            for part in parts {
                match part {
                    // A sum includes the sign of its first term.
                    Formula::Closed(closed) if matches!(closed.node(), Node::Sum(_)) => {
                        terms.extend(order::terms(closed).iter().map(|term| product(term, style)));
                    }
                    other => terms.push(signed(other, style)),
                }
            }
            (false, Math::Sum(terms))
        }
        Formula::Scaled(scale, inner) => {
            let (negative, scale) = match scale.node() {
                Node::Sum(_) => (false, Some(parenthesised(expr(scale, style)))),
                _ if scale.is_one() => (false, None),
                _ if (-scale).is_one() => (true, None),
                _ => {
                    let (negative, scale) = product(scale, style);
                    (negative, Some(scale))
                }
            };
            let (inner_negative, inner) = match **inner {
                Formula::Sum(_) => (false, parenthesised(self::formula(inner, style))),
                _ => signed(inner, style),
            };
            (negative != inner_negative, scale.map_or(inner.clone(), |scale| beside(scale, inner)))
        }
        Formula::Piecewise { variable, pieces, last } => {
            let pieces = pieces.iter().map(|(value, end)| (self::formula(value, style), expr(end, style))).collect();
            (false, Math::Cases { variable: variable.name().to_owned(), pieces, last: Box::new(self::formula(last, style)) })
        }
        Formula::Integral { integrand, variable, lower, upper } => {
            let (negative, integrand) = match &**integrand {
                Formula::Closed(closed) if closed.is_one() => (false, None),
                Formula::Sum(_) => (false, Some(parenthesised(self::formula(integrand, style)))),
                Formula::Closed(closed) if matches!(closed.node(), Node::Sum(_)) => (false, Some(parenthesised(expr(closed, style)))),
                other if style == Style::Grammar => (false, Some(self::formula(other, style))),
                other => {
                    let (negative, body) = signed(other, style);
                    (negative, Some(body))
                }
            };
            let (lower, upper) = (Box::new(expr(lower, style)), Box::new(expr(upper, style)));
            (negative, Math::Integral { integrand: integrand.map(Box::new), variable: variable.name().to_owned(), lower, upper })
        }
    }
}

/// Two factors as one product.
fn beside(left: Math, right: Math) -> Math {
    let list = |math| match math {
        Math::Product(factors) => factors,
        other => vec![other],
    };
    Math::Product(list(left).into_iter().chain(list(right)).collect())
}

/// The sign of a product and the rest of it, without a leading minus if the terms of a factor can be exchanged: x²/(R₂ − R₁) for
/// −x²/(R₁ − R₂). The program's grammar keeps the product, so that it reads back.
fn turned(expr: &Expr, style: Style) -> (bool, Math) {
    let mut layout = layout_for(expr, style == Style::Grammar);
    let is_difference = |factor: &&mut Factor| {
        let Node::Sum(terms) = factor.base.node() else { return false };
        let negative = terms.iter().filter(|term| term.split_coefficient().0.is_negative()).count();
        negative > 0 && 2 * negative >= terms.len() && factor.whole().is_some_and(|power| power % 2 != 0)
    };
    if layout.negative && style != Style::Grammar {
        let mut factors = layout.upper.iter_mut().chain(&mut layout.lower).chain(&mut layout.behind);
        if let Some(own) = factors.find(is_difference) {
            own.base = -&own.base;
            layout.negative = false;
        }
    }
    laid(&layout, style)
}

/// The sign of a product and the rest of it.
fn product(expr: &Expr, style: Style) -> (bool, Math) {
    laid(&layout_for(expr, style == Style::Grammar), style)
}

fn laid(layout: &Layout, style: Style) -> (bool, Math) {
    let body = if layout.lower.is_empty() {
        alone(&layout.upper, style)
    } else if style == Style::Exponent {
        slashed(layout, style)
    } else {
        let fraction = Math::Fraction(Box::new(alone(&layout.upper, style)), Box::new(alone(&layout.lower, style)));
        if layout.behind.is_empty() { fraction } else { beside(fraction, joined(&layout.behind, style, true)) }
    };
    (layout.negative, body)
}

/// A product without adjacent factors, so that a single sum needs no parentheses.
fn alone(factors: &[Factor], style: Style) -> Math {
    match factors {
        [] => one(),
        [Factor { base, exponent }] if exponent.is_one() && matches!(base.node(), Node::Sum(_)) => expr(base, style),
        _ => joined(factors, style, true),
    }
}

fn one() -> Math {
    Math::Number { mantissa: "1".to_owned(), exponent: None }
}

fn joined(factors: &[Factor], style: Style, bare: bool) -> Math {
    match factors {
        [only] => factor(only, style, bare),
        _ => Math::Product(factors.iter().map(|f| factor(f, style, bare)).collect()),
    }
}

/// A fraction on one line.
fn slashed(layout: &Layout, style: Style) -> Math {
    let upper: Vec<Factor> = layout.upper.iter().chain(&layout.behind).cloned().collect();
    let upper = if upper.is_empty() { one() } else { joined(&upper, style, false) };
    let lower = joined(&layout.lower, style, false);
    let lower = if layout.lower.len() == 1 { lower } else { parenthesised(lower) };
    Math::Slash(Box::new(upper), Box::new(lower))
}

fn factor(factor: &Factor, style: Style, bare: bool) -> Math {
    let Factor { base, exponent } = factor;
    if let Some(k @ 2..=9) = factor.root() {
        return Math::Root(k, Box::new(expr(base, style)));
    }
    if exponent.is_one() {
        return unit(base, style, bare, None);
    }
    let power = expr(exponent, style.raised());
    let base = match base.node() {
        Node::Function(function, _) if factor.whole().is_some() && function.row().typeset.setting == Setting::Operator => {
            return unit(base, style, bare, Some(power));
        }
        Node::Number(number) if !is_plain(number) => parenthesised(expr(base, style)),
        Node::Number(_) | Node::Symbol(_) | Node::Constant(_) | Node::Sum(_) => unit(base, style, bare, None),
        Node::Function(function, _) if closes_itself(function.row().typeset.setting) => unit(base, style, bare, None),
        _ => parenthesised(expr(base, style)),
    };
    Math::Power(Box::new(base), Box::new(power))
}

/// True if an exponent after the call applies to the whole call.
fn closes_itself(setting: Setting) -> bool {
    !matches!(setting, Setting::Operator | Setting::Exponential | Setting::Index)
}

fn is_plain(number: &Number) -> bool {
    !number.is_negative() && (number.is_integer() || number.is_decimal()) && digits(number).exponent.is_none()
}

/// A base without its exponent; `power` belongs to the name of a function.
fn unit(base: &Expr, style: Style, bare: bool, power: Option<Math>) -> Math {
    match base.node() {
        Node::Number(number) => {
            let digits = digits(number);
            Math::Number { mantissa: digits.mantissa, exponent: digits.exponent }
        }
        Node::Constant(constant) => Math::Constant(*constant),
        Node::Symbol(name) => Math::Name(name.shown().to_owned()),
        Node::Function(function, arguments) => Math::Call(call(*function, arguments, style, bare, power)),
        Node::Power(..) | Node::Product(_) | Node::Sum(_) => parenthesised(expr(base, style)),
    }
}

fn call(function: Function, arguments: &[Expr], style: Style, bare: bool, power: Option<Math>) -> Call {
    let setting = function.row().typeset.setting;
    let inner = if setting == Setting::Exponential { style.raised() } else { style };
    let arguments = order::arguments(function, arguments);
    let bare = bare && matches!(arguments.as_slice(), [argument] if BARE.contains(&function.name()) && is_single(argument, function));
    let set = |list: &[Expr]| list.iter().map(|argument| expr(argument, inner)).collect::<Vec<_>>();
    let (index, groups) = match (setting, arguments.as_slice()) {
        (Setting::Indexed | Setting::Ordered | Setting::Index, [index, rest @ ..]) => {
            (Some(expr(index, inner)), if rest.is_empty() { Vec::new() } else { vec![set(rest)] })
        }
        (Setting::Parameter, list) => (None, list.iter().map(|argument| vec![expr(argument, inner)]).collect()),
        (Setting::Groups(sizes), list) => (None, grouped(set(list), sizes)),
        (Setting::CountedGroups, [upper, lower, rest @ ..]) => {
            let count = |expr: &Expr| expr.as_integer().and_then(|n| usize::try_from(n).ok()).unwrap_or(0);
            (None, grouped(set(rest), &[count(upper), count(lower)]))
        }
        (_, list) => (None, vec![set(list)]),
    };
    Call { function, index: index.map(Box::new), power: power.map(Box::new), groups, bare }
}

/// The list in groups of these sizes, with the remaining items as the last group.
fn grouped(mut list: Vec<Math>, sizes: &[usize]) -> Vec<Vec<Math>> {
    let mut groups = Vec::new();
    for size in sizes {
        let rest = list.split_off((*size).min(list.len()));
        groups.push(std::mem::replace(&mut list, rest));
    }
    if !list.is_empty() {
        groups.push(list);
    }
    groups
}

/// True if the argument needs no parentheses.
fn is_single(argument: &Expr, function: Function) -> bool {
    match argument.node() {
        Node::Symbol(_) | Node::Constant(_) => true,
        Node::Number(number) => function.name() == "ln" && is_plain(number),
        _ => false,
    }
}
