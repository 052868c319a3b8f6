//! Formulas in LaTeX, for math mode.

use crate::expr::function::Setting;
use crate::expr::{Constant, Relation};
use crate::print::math::{Call, Math};
use crate::print::notations::latex_symbol::{letters, symbol};
use crate::print::signed_terms;

/// Writes a formula in LaTeX.
pub(in crate::print) fn write(math: &Math) -> String {
    match math {
        Math::Number { mantissa, exponent: None } => mantissa.clone(),
        Math::Number { mantissa, exponent: Some(exponent) } if mantissa == "1" => format!("10^{{{exponent}}}"),
        Math::Number { mantissa, exponent: Some(exponent) } => format!("{mantissa} \\cdot 10^{{{exponent}}}"),
        Math::Name(name) => symbol(name),
        Math::Constant(Constant::Pi) => "\\pi".to_owned(),
        Math::Constant(Constant::Euler) => "e".to_owned(),
        Math::Constant(Constant::Cut) => "?".to_owned(),
        Math::Sum(terms) => signed_terms(terms, "-", write),
        Math::Negative(inner) => format!("-{}", write(inner)),
        Math::Product(factors) => product(factors),
        Math::Fraction(upper, lower) => format!("\\frac{{{}}}{{{}}}", write(upper), write(lower)),
        Math::Slash(upper, lower) => format!("{}/{}", write(upper), write(lower)),
        Math::Root(2, inner) => format!("\\sqrt{{{}}}", write(inner)),
        Math::Root(degree, inner) => format!("\\sqrt[{degree}]{{{}}}", write(inner)),
        Math::Power(base, exponent) => match base.as_ref() {
            // A second superscript needs braces.
            Math::Name(name) if symbol(name).contains('^') => format!("{{{}}}^{{{}}}", symbol(name), write(exponent)),
            _ => format!("{}^{{{}}}", write(base), write(exponent)),
        },
        Math::Parentheses(inner) => parenthesised(&write(inner), is_tall(inner)),
        Math::Call(call) => write_call(call),
        Math::Cases { variable, pieces, last } => {
            let name = symbol(variable);
            let mut start: Option<String> = None;
            let mut rows = Vec::with_capacity(pieces.len() + 1);
            for (value, end) in pieces {
                let end = write(end);
                let range = start.map_or_else(|| format!("{name} < {end}"), |start| format!("{start} \\le {name} < {end}"));
                rows.push(format!("{}, & {range}", write(value)));
                start = Some(end);
            }
            rows.push(format!("{}, & {name} \\ge {}", write(last), start.unwrap_or_default()));
            format!("\\begin{{cases}} {} \\end{{cases}}", rows.join(" \\\\ "))
        }
        Math::Integral { integrand, variable, lower, upper } => {
            let integrand = integrand.as_ref().map_or(String::new(), |integrand| write(integrand) + " ");
            format!("\\int_{{{}}}^{{{}}} {integrand}\\,\\mathrm{{d}}{}", write(lower), write(upper), symbol(variable))
        }
        Math::Relation(left, relation, right) => format!("{} {} {}", write(left), sign(*relation), write(right)),
    }
}

fn sign(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => "<",
        Relation::LessOrEqual => "\\le",
        Relation::Equal => "=",
    }
}

/// Adjacent factors, with the space required between each pair.
fn product(factors: &[Math]) -> String {
    let mut text = String::new();
    for (place, factor) in factors.iter().enumerate() {
        let before = place.checked_sub(1).and_then(|before| factors.get(before));
        text.push_str(match before {
            None => "",
            Some(_) if matches!(factor.first(), Math::Number { .. }) => " \\cdot ",
            // After a root a letter needs a little space; an index in front would cling to what precedes it.
            Some(before) if matches!(before.last(), Math::Root(..)) || factor.first().has_prescript() => "\\, ",
            Some(_) => " ",
        });
        text.push_str(&write(factor));
    }
    text
}

/// True if parentheses around a part must grow with it.
fn is_tall(math: &Math) -> bool {
    math.any(&|part| match part {
        Math::Fraction(..) | Math::Root(..) | Math::Cases { .. } | Math::Integral { .. } => true,
        Math::Call(call) => call.function.row().typeset.setting == Setting::Absolute,
        _ => false,
    })
}

fn parenthesised(inner: &str, tall: bool) -> String {
    if tall { format!("\\left({inner}\\right)") } else { format!("({inner})") }
}

fn write_call(call: &Call) -> String {
    let typeset = call.function.row().typeset;
    let list = |group: &Vec<Math>| group.iter().map(write).collect::<Vec<_>>().join(", ");
    let arguments = || call.groups.iter().map(list).collect::<Vec<_>>();
    match typeset.setting {
        Setting::Exponential => return format!("e^{{{}}}", arguments().join(", ")),
        Setting::Absolute => return format!("\\left|{}\\right|", arguments().join(", ")),
        _ => {}
    }
    let mut name = letters(typeset.letters);
    if let Some((upper, lower)) = call.prescript() {
        name = format!("{{}}_{{{upper}}}{name}_{{{lower}}}");
    }
    if let Some(index) = &call.index {
        let index = write(index);
        name = if typeset.setting == Setting::Ordered { format!("{name}^{{({index})}}") } else { format!("{name}_{{{index}}}") };
    }
    if let Some(power) = &call.power {
        name = format!("{name}^{{{}}}", write(power));
    }
    if call.groups.is_empty() {
        return name;
    }
    let between = if typeset.setting == Setting::Parameter { " \\mid " } else { "; " };
    let inside = arguments().join(between);
    if call.bare {
        let space = if inside.starts_with('\\') { "" } else { " " };
        return format!("{name}{space}{inside}");
    }
    format!("{name}{}", parenthesised(&inside, call.groups.iter().flatten().any(is_tall)))
}
