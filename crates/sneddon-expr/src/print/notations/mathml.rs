//! Formulas in MathML Core, which browsers draw without a library.

use crate::expr::function::{Font, Letters, Setting};
use crate::expr::{Constant, Relation};
use crate::print::math::{Call, Math};
use crate::print::named;
use crate::print::notations::greek;
use crate::print::notations::latex_symbol;

/// Between a function and its argument, for readers and screen readers.
const APPLY: &str = "<mo>&#x2061;</mo>";
/// A narrow space before the differential of an integral.
const THIN: &str = "<mspace width=\"0.1667em\"/>";

/// Writes an equation as a displayed `math` element, with the range in which it applies; its left side is a name, or a name with an
/// argument, as in `g(x)`.
pub(in crate::print) fn equation(left: &str, right: &Math, range: Option<(&str, Math)>) -> String {
    let comma = "<mo separator=\"true\">,</mo><mspace width=\"1em\"/>";
    let range =
        range.map_or_else(String::new, |(variable, from)| format!("{comma}{}", row(&[symbol(variable), operator("≥"), write(&from)])));
    document(&row(&[symbol(left), operator("="), write(right), range]))
}

/// Writes a formula as a displayed `math` element.
pub(in crate::print) fn formula(math: &Math) -> String {
    document(&write(math))
}

fn document(inner: &str) -> String {
    format!("<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"block\">{inner}</math>")
}

pub(in crate::print) fn write(math: &Math) -> String {
    match math {
        Math::Number { mantissa, exponent: None } => number(mantissa),
        Math::Number { mantissa, exponent: Some(exponent) } => {
            let power = format!("<msup>{}{}</msup>", number("10"), signed(*exponent));
            if mantissa == "1" { power } else { row(&[number(mantissa), operator("·"), power]) }
        }
        Math::Name(name) => symbol(name),
        Math::Constant(Constant::Pi) => "<mi>π</mi>".to_owned(),
        Math::Constant(Constant::Euler) => "<mi mathvariant=\"normal\">e</mi>".to_owned(),
        Math::Constant(Constant::Cut) => "<mi>?</mi>".to_owned(),
        Math::Sum(terms) => {
            let mut parts = Vec::with_capacity(2 * terms.len());
            for (place, (negative, term)) in terms.iter().enumerate() {
                match (place, negative) {
                    (0, false) => {}
                    (0, true) => parts.push(prefix("−")),
                    (_, true) => parts.push(operator("−")),
                    (_, false) => parts.push(operator("+")),
                }
                parts.push(write(term));
            }
            row(&parts)
        }
        Math::Negative(inner) => row(&[prefix("−"), write(inner)]),
        Math::Product(factors) => {
            let mut parts = Vec::with_capacity(2 * factors.len());
            for (place, factor) in factors.iter().enumerate() {
                if place > 0 {
                    parts.push(operator(if matches!(factor.first(), Math::Number { .. }) { "·" } else { "&#x2062;" }));
                }
                parts.push(write(factor));
            }
            row(&parts)
        }
        Math::Fraction(upper, lower) => format!("<mfrac>{}{}</mfrac>", write(upper), write(lower)),
        Math::Slash(upper, lower) => row(&[write(upper), operator("/"), write(lower)]),
        Math::Root(2, inner) => format!("<msqrt>{}</msqrt>", write(inner)),
        Math::Root(degree, inner) => format!("<mroot>{}{}</mroot>", write(inner), number(&degree.to_string())),
        Math::Power(base, exponent) => format!("<msup>{}{}</msup>", write(base), write(exponent)),
        Math::Parentheses(inner) => fenced("(", &write(inner), ")"),
        Math::Call(call) => write_call(call),
        Math::Cases { variable, pieces, last } => cases(variable, pieces, last),
        Math::Integral { integrand, variable, lower, upper } => {
            let sign = format!("<msubsup><mo>∫</mo>{}{}</msubsup>", write(lower), write(upper));
            let integrand = integrand.as_ref().map_or(String::new(), |integrand| write(integrand));
            row(&[sign, integrand, THIN.to_owned(), "<mi mathvariant=\"normal\">d</mi>".to_owned(), symbol(variable)])
        }
        Math::Relation(left, relation, right) => {
            let sign = match relation {
                Relation::Less => "&lt;",
                Relation::LessOrEqual => "≤",
                Relation::Equal => "=",
            };
            row(&[write(left), operator(sign), write(right)])
        }
    }
}

fn row(parts: &[String]) -> String {
    format!("<mrow>{}</mrow>", parts.concat())
}

fn number(digits: &str) -> String {
    format!("<mn>{digits}</mn>")
}

fn signed(number: i64) -> String {
    let digits = self::number(&number.unsigned_abs().to_string());
    if number < 0 { row(&[prefix("−"), digits]) } else { digits }
}

fn operator(sign: &str) -> String {
    format!("<mo>{sign}</mo>")
}

fn prefix(sign: &str) -> String {
    format!("<mo form=\"prefix\">{sign}</mo>")
}

fn fenced(open: &str, inner: &str, close: &str) -> String {
    format!("<mrow><mo form=\"prefix\">{open}</mo>{inner}<mo form=\"postfix\">{close}</mo></mrow>")
}

/// The text with the special characters of XML escaped.
pub(in crate::print) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// A part of a name. Letters are italic, words upright.
fn word(word: &str) -> String {
    if !word.is_empty() && word.chars().all(|c| c.is_ascii_digit()) {
        number(word)
    } else {
        format!("<mi>{}</mi>", escaped(greek::letter(word).unwrap_or(word)))
    }
}

pub(in crate::print) fn symbol(name: &str) -> String {
    if name == "E" {
        return "<msup><mi>E</mi><mo>*</mo></msup>".to_owned();
    }
    if let Some((function, primes, argument)) = named::parts(name) {
        let primes = if primes == 0 { String::new() } else { format!("<mo>{}</mo>", "′".repeat(primes)) };
        let function = if primes.is_empty() { symbol(function) } else { format!("<msup>{}{primes}</msup>", symbol(function)) };
        return row(&[
            function,
            APPLY.to_owned(),
            fenced("(", &named::arguments(argument, "<mo separator=\"true\">,</mo>", number, symbol), ")"),
        ]);
    }
    let (letter, indices) = latex_symbol::parts(name);
    let indices: Vec<String> = indices.into_iter().map(word).collect();
    match indices.as_slice() {
        [] => word(letter),
        [only] => format!("<msub>{}{only}</msub>", word(letter)),
        list => format!("<msub>{}<mrow>{}</mrow></msub>", word(letter), list.join("<mo separator=\"true\">,</mo>")),
    }
}

fn cases(variable: &str, pieces: &[(Math, Math)], last: &Math) -> String {
    let name = symbol(variable);
    let line = |value: &Math, range: Vec<String>| {
        format!("<mtr><mtd style=\"text-align: left\">{}</mtd><mtd style=\"text-align: left\">{}</mtd></mtr>", write(value), row(&range))
    };
    let mut rows = String::new();
    let mut start: Option<String> = None;
    for (value, end) in pieces {
        let end = write(end);
        let mut range: Vec<String> = start.iter().flat_map(|start| [start.clone(), operator("≤")]).collect();
        range.extend([name.clone(), operator("&lt;"), end.clone()]);
        rows += &line(value, range);
        start = Some(end);
    }
    rows += &line(last, vec![name, operator("≥"), start.unwrap_or_default()]);
    format!("<mrow><mo form=\"prefix\">{{</mo><mtable>{rows}</mtable></mrow>")
}

fn letters(letters: Letters) -> String {
    let name = match (letters.text, letters.font) {
        // MathML Core has no attribute for bold letters; use the bold letters of Unicode.
        ("H", Font::Bold) => "<mi>𝐇</mi>".to_owned(),
        ("L", Font::Bold) => "<mi>𝐋</mi>".to_owned(),
        (text, Font::Italic) => format!("<mi>{text}</mi>"),
        (text, _) => format!("<mi mathvariant=\"normal\">{text}</mi>"),
    };
    if letters.index.is_empty() { name } else { format!("<msub>{name}{}</msub>", word(letters.index)) }
}

fn write_call(call: &Call) -> String {
    let typeset = call.function.row().typeset;
    let comma = "<mo separator=\"true\">,</mo>";
    let list = |group: &Vec<Math>| group.iter().map(write).collect::<Vec<_>>().join(comma);
    let groups: Vec<String> = call.groups.iter().map(list).collect();
    match typeset.setting {
        Setting::Exponential => {
            return format!("<msup><mi mathvariant=\"normal\">e</mi>{}</msup>", row(&[groups.join(comma)]));
        }
        Setting::Absolute => return fenced("|", &groups.join(comma), "|"),
        _ => {}
    }
    let mut name = letters(typeset.letters);
    if let Some((upper, lower)) = call.prescript() {
        let (upper, lower) = (number(&upper.to_string()), number(&lower.to_string()));
        name = format!("<mmultiscripts>{name}{lower}<mrow></mrow><mprescripts/>{upper}<mrow></mrow></mmultiscripts>");
    }
    if let Some(order) = &call.index {
        let order = write(order);
        name = if typeset.setting == Setting::Ordered {
            format!("<msup>{name}{}</msup>", fenced("(", &order, ")"))
        } else {
            format!("<msub>{name}{order}</msub>")
        };
    }
    if let Some(power) = &call.power {
        name = format!("<msup>{name}{}</msup>", write(power));
    }
    if groups.is_empty() {
        return name;
    }
    let between = if typeset.setting == Setting::Parameter { "<mo separator=\"true\">|</mo>" } else { "<mo separator=\"true\">;</mo>" };
    let inside = groups.join(between);
    let arguments = if call.bare { inside } else { fenced("(", &inside, ")") };
    row(&[name, APPLY.to_owned(), arguments])
}
