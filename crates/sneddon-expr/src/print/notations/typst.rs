//! Formulas in Typst, for math mode.

use crate::expr::function::{Font, Letters, Setting};
use crate::expr::{Constant, Relation};
use crate::print::math::{Call, Math};
use crate::print::named;
use crate::print::notations::greek;
use crate::print::notations::latex_symbol;
use crate::print::signed_terms;

/// Writes a formula in Typst.
pub(in crate::print) fn write(math: &Math) -> String {
    match math {
        Math::Number { mantissa, exponent: None } => mantissa.clone(),
        Math::Number { mantissa, exponent: Some(exponent) } if mantissa == "1" => format!("10^({exponent})"),
        Math::Number { mantissa, exponent: Some(exponent) } => format!("{mantissa} dot 10^({exponent})"),
        Math::Name(name) => symbol(name),
        Math::Constant(Constant::Pi) => "pi".to_owned(),
        Math::Constant(Constant::Euler) => "e".to_owned(),
        Math::Constant(Constant::Cut) => "\"?\"".to_owned(),
        Math::Sum(terms) => signed_terms(terms, "-", write),
        Math::Negative(inner) => format!("-{}", write(inner)),
        Math::Product(factors) => product(factors),
        Math::Fraction(upper, lower) => format!("frac({}, {})", write(upper), write(lower)),
        // A slash alone would build the fraction up.
        Math::Slash(upper, lower) => format!("{} slash {}", write(upper), write(lower)),
        Math::Root(2, inner) => format!("sqrt({})", write(inner)),
        Math::Root(degree, inner) => format!("root({degree}, {})", write(inner)),
        Math::Power(base, exponent) => match base.as_ref() {
            Math::Name(name) if name == "E" => format!("(E^*)^({})", write(exponent)),
            _ => format!("{}^({})", write(base), write(exponent)),
        },
        Math::Parentheses(inner) => format!("({})", write(inner)),
        Math::Call(call) => write_call(call),
        Math::Cases { variable, pieces, last } => {
            let name = symbol(variable);
            let mut start: Option<String> = None;
            let mut rows = Vec::with_capacity(pieces.len() + 1);
            for (value, end) in pieces {
                let end = write(end);
                let range = start.map_or_else(|| format!("{name} < {end}"), |start| format!("{start} <= {name} < {end}"));
                rows.push(format!("{} & \"if\" {range}", write(value)));
                start = Some(end);
            }
            rows.push(format!("{} & \"if\" {name} >= {}", write(last), start.unwrap_or_default()));
            format!("cases({})", rows.join(", "))
        }
        Math::Integral { integrand, variable, lower, upper } => {
            let integrand = integrand.as_ref().map_or(String::new(), |integrand| write(integrand) + " ");
            format!("integral_({})^({}) {integrand}dif {}", write(lower), write(upper), symbol(variable))
        }
        Math::Relation(left, relation, right) => {
            let sign = match relation {
                Relation::Less => "<",
                Relation::LessOrEqual => "<=",
                Relation::Equal => "=",
            };
            format!("{} {sign} {}", write(left), write(right))
        }
    }
}

fn product(factors: &[Math]) -> String {
    let mut text = String::new();
    for (place, factor) in factors.iter().enumerate() {
        if place > 0 {
            text.push_str(if matches!(factor.first(), Math::Number { .. }) { " dot " } else { " " });
        }
        text.push_str(&write(factor));
    }
    text
}

/// A part of a name: a Greek letter, a letter, or a word in quotes.
fn word(word: &str) -> String {
    match greek::letter(word) {
        Some(letter) => letter.to_owned(),
        None if word.chars().count() == 1 || word.chars().all(|c| c.is_ascii_digit()) => word.to_owned(),
        None => format!("upright(\"{word}\")"),
    }
}

pub(in crate::print) fn symbol(name: &str) -> String {
    if name == "E" {
        return "E^*".to_owned();
    }
    if let Some((function, primes, argument)) = named::parts(name) {
        // The space keeps the argument out of an index.
        return format!("{}{} ({})", symbol(function), "'".repeat(primes), named::arguments(argument, ", ", str::to_owned, symbol));
    }
    let (letter, indices) = latex_symbol::parts(name);
    let indices: Vec<String> = indices.into_iter().map(word).collect();
    if indices.is_empty() { word(letter) } else { format!("{}_({})", word(letter), indices.join("\\,")) }
}

fn letters(letters: Letters) -> String {
    /// Names of operators in Typst.
    const OPERATORS: [&str; 12] = ["ln", "sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "max", "min"];
    let name = match (letters.text, letters.font) {
        (text, Font::Bold) => format!("upright(bold({text}))"),
        (text, Font::Upright) if OPERATORS.contains(&text) => text.to_owned(),
        (text, Font::Upright) => format!("op(\"{text}\")"),
        (text, Font::Italic) => text.to_owned(),
    };
    if letters.index.is_empty() { name } else { format!("{name}_({})", letters.index) }
}

fn write_call(call: &Call) -> String {
    let typeset = call.function.row().typeset;
    let list = |group: &Vec<Math>| group.iter().map(write).collect::<Vec<_>>().join(", ");
    let groups: Vec<String> = call.groups.iter().map(list).collect();
    match typeset.setting {
        Setting::Exponential => return format!("e^({})", groups.join(", ")),
        Setting::Absolute => return format!("abs({})", groups.join(", ")),
        _ => {}
    }
    let mut name = letters(typeset.letters);
    if let Some((upper, lower)) = call.prescript() {
        name = format!("attach({name}, bl: {upper}, br: {lower})");
    }
    if let Some(order) = &call.index {
        let order = write(order);
        name = if typeset.setting == Setting::Ordered { format!("{name}^((({order})))") } else { format!("{name}_({order})") };
    }
    if let Some(power) = &call.power {
        name = format!("{name}^({})", write(power));
    }
    if groups.is_empty() {
        return name;
    }
    // A semicolon alone would begin a row.
    let between = if typeset.setting == Setting::Parameter { " | " } else { "\\; " };
    let inside = groups.join(between);
    // lr keeps a name that Typst knows from taking the parentheses as its arguments.
    if call.bare { format!("{name} {inside}") } else { format!("{name} lr(({inside}))") }
}
