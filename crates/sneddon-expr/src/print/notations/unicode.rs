//! Formulas on one line of Unicode text, for a terminal or a message.

use crate::expr::function::Setting;
use crate::expr::{Constant, Relation};
use crate::print::math::{Call, Math};
use crate::print::named;
use crate::print::notations::greek;
use crate::print::notations::latex_symbol;
use crate::print::signed_terms;

/// How tightly a part binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Unit,
}

/// Writes a formula on one line.
pub(in crate::print) fn write(math: &Math) -> String {
    match math {
        Math::Number { mantissa, exponent: None } => mantissa.clone(),
        Math::Number { mantissa, exponent: Some(exponent) } if mantissa == "1" => format!("10{}", superscript(&exponent.to_string())),
        Math::Number { mantissa, exponent: Some(exponent) } => format!("{mantissa}·10{}", superscript(&exponent.to_string())),
        Math::Name(name) => symbol(name),
        Math::Constant(Constant::Pi) => "π".to_owned(),
        Math::Constant(Constant::Euler) => "e".to_owned(),
        Math::Constant(Constant::Cut) => "?".to_owned(),
        Math::Sum(terms) => signed_terms(terms, "−", |term| at_least(term, Binding::Product)),
        Math::Negative(inner) => format!("−{}", at_least(inner, Binding::Product)),
        Math::Product(factors) => factors.iter().map(|factor| at_least(factor, Binding::Product)).collect::<Vec<_>>().join("·"),
        Math::Fraction(upper, lower) | Math::Slash(upper, lower) => {
            format!("{}/{}", at_least(upper, Binding::Product), at_least(lower, Binding::Unit))
        }
        Math::Root(degree, inner) => {
            let degree = if *degree == 2 { String::new() } else { superscript(&degree.to_string()) };
            format!("{degree}√{}", at_least_a_letter(inner))
        }
        Math::Power(base, exponent) => format!("{}{}", at_least(base, Binding::Unit), raised(exponent)),
        Math::Parentheses(inner) => format!("({})", write(inner)),
        Math::Call(call) => write_call(call),
        Math::Cases { variable, pieces, last } => {
            let name = symbol(variable);
            let pieces: String = pieces.iter().map(|(value, end)| format!("{} for {name} < {}; ", write(value), write(end))).collect();
            format!("{{ {pieces}{} beyond }}", write(last))
        }
        Math::Integral { integrand, variable, lower, upper } => {
            let integrand = integrand.as_ref().map_or(String::new(), |integrand| at_least(integrand, Binding::Product) + " ");
            format!("∫[{}, {}] {integrand}d{}", write(lower), write(upper), symbol(variable))
        }
        Math::Relation(left, relation, right) => {
            let sign = match relation {
                Relation::Less => "<",
                Relation::LessOrEqual => "≤",
                Relation::Equal => "=",
            };
            format!("{} {sign} {}", write(left), write(right))
        }
    }
}

/// The text, in parentheses where it binds less tightly.
fn at_least(math: &Math, least: Binding) -> String {
    let text = write(math);
    if binding(math) < least { format!("({text})") } else { text }
}

fn binding(math: &Math) -> Binding {
    match math {
        Math::Sum(_) | Math::Negative(_) | Math::Relation(..) => Binding::Sum,
        Math::Product(_) | Math::Fraction(..) | Math::Slash(..) | Math::Integral { .. } => Binding::Product,
        _ => Binding::Unit,
    }
}

/// True for a radicand that needs no parentheses: a number or a name.
fn at_least_a_letter(math: &Math) -> String {
    match math {
        Math::Number { exponent: None, .. } | Math::Name(_) | Math::Constant(_) | Math::Parentheses(_) => write(math),
        _ => format!("({})", write(math)),
    }
}

/// An exponent: raised digits and letters where Unicode has them, else behind a caret.
fn raised(exponent: &Math) -> String {
    let text = write(exponent);
    if text.chars().all(|c| raised_sign(c).is_some()) {
        return superscript(&text);
    }
    match exponent {
        Math::Name(_) | Math::Constant(_) | Math::Parentheses(_) | Math::Number { .. } => format!("^{text}"),
        _ => format!("^({text})"),
    }
}

fn raised_sign(c: char) -> Option<char> {
    const PLAIN: &str = "0123456789-−+n";
    const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁻⁺ⁿ";
    let place = PLAIN.chars().position(|plain| plain == c)?;
    RAISED.chars().nth(place)
}

fn lowered_sign(c: char) -> Option<char> {
    const LOWERED: &str = "₀₁₂₃₄₅₆₇₈₉";
    LOWERED.chars().nth(c.to_digit(10)? as usize)
}

fn superscript(text: &str) -> String {
    text.chars().map(|c| raised_sign(c).unwrap_or(c)).collect()
}

/// An index: lowered digits where there is nothing else, else behind an underscore.
fn index(text: &str) -> String {
    let lowered: Option<String> = text.chars().map(lowered_sign).collect();
    lowered.unwrap_or_else(|| format!("_{text}"))
}

pub(in crate::print) fn symbol(name: &str) -> String {
    if name == "E" {
        return "E*".to_owned();
    }
    if let Some((function, primes, argument)) = named::parts(name) {
        return format!("{}{}({})", symbol(function), "′".repeat(primes), named::arguments(argument, ", ", str::to_owned, symbol));
    }
    let (letter, indices) = latex_symbol::parts(name);
    let indices: Vec<&str> = indices.into_iter().map(|part| greek::letter(part).unwrap_or(part)).collect();
    let letter = greek::letter(letter).unwrap_or(letter);
    if indices.is_empty() { letter.to_owned() } else { format!("{letter}{}", index(&indices.join(","))) }
}

fn write_call(call: &Call) -> String {
    let typeset = call.function.row().typeset;
    let list = |group: &Vec<Math>| group.iter().map(write).collect::<Vec<_>>().join(", ");
    let groups: Vec<String> = call.groups.iter().map(list).collect();
    match typeset.setting {
        Setting::Absolute => return format!("|{}|", groups.join(", ")),
        Setting::Exponential => {
            return match call.groups.as_slice() {
                [group] if group.len() == 1 => format!("e{}", group.iter().map(raised).collect::<String>()),
                _ => format!("exp({})", groups.join(", ")),
            };
        }
        _ => {}
    }
    let mut name =
        format!("{}{}", typeset.letters.text, if typeset.letters.index.is_empty() { String::new() } else { index(typeset.letters.index) });
    if let Some((upper, lower)) = call.prescript() {
        name = format!("{}{name}{}", index(&upper.to_string()), index(&lower.to_string()));
    }
    if let Some(order) = &call.index {
        let order = write(order);
        name = if typeset.setting == Setting::Ordered {
            format!("{name}⁽{}⁾", superscript(&order))
        } else {
            format!("{name}{}", index(&order))
        };
    }
    if let Some(power) = &call.power {
        name += &raised(power);
    }
    if groups.is_empty() {
        return name;
    }
    let between = if typeset.setting == Setting::Parameter { " | " } else { "; " };
    let inside = groups.join(between);
    if call.bare { format!("{name} {inside}") } else { format!("{name}({inside})") }
}
