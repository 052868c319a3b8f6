//! Sentences with embedded formulas, written in any of the notations.

use super::{Notation, Presentation};
use crate::expr::{Bindings, Condition, Formula};
use crate::print::notations::{greek, mathml};

/// A piece of a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Span {
    Words(String),
    /// A symbol, the value of a function such as g(x), or a quotient of differentials such as `dd F/dd a`.
    Name(String),
    Formula(Formula),
    Condition(Condition),
}

/// A sentence with formulas in it.
///
/// ```
/// use sneddon_expr::print::{Notation, Prose};
/// let edge = Prose::read("the edge is at $x$ = $R_1$");
/// assert_eq!(edge.written(Notation::Text), "the edge is at x = R_1");
/// assert_eq!(edge.written(Notation::Latex), "the edge is at $x = R_{1}$");
/// let stiffness = Prose::read("by definition $k$ = $dd F/dd d$");
/// assert_eq!(stiffness.written(Notation::Latex), r"by definition $k = \mathrm{d}F/\mathrm{d}d$");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Prose(Vec<Span>);

impl Prose {
    /// A sentence in which names are enclosed in dollar signs; `dd F` is the differential of F.
    pub fn read(sentence: &str) -> Self {
        Self::default().then(sentence)
    }

    /// Literal text without formulas.
    pub fn words(words: &str) -> Self {
        Self(vec![Span::Words(words.to_owned())])
    }

    /// Appends text in which names are enclosed in dollar signs.
    #[must_use]
    pub fn then(mut self, sentence: &str) -> Self {
        for (place, part) in sentence.split('$').enumerate().filter(|(_, part)| !part.is_empty()) {
            self.0.push(if place % 2 == 1 { Span::Name(part.to_owned()) } else { Span::Words(part.to_owned()) });
        }
        self
    }

    /// Appends a formula.
    #[must_use]
    pub fn formula(mut self, formula: impl Into<Formula>) -> Self {
        self.0.push(Span::Formula(formula.into()));
        self
    }

    /// Appends a condition.
    #[must_use]
    pub fn condition(mut self, condition: Condition) -> Self {
        self.0.push(Span::Condition(condition));
        self
    }

    /// Appends another sentence.
    #[must_use]
    pub fn followed_by(mut self, other: &Self) -> Self {
        self.0.extend(other.0.iter().cloned());
        self
    }

    /// True for an empty sentence.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The conditions in the sentence.
    pub fn conditions(&self) -> impl Iterator<Item = &Condition> {
        self.0.iter().filter_map(|span| if let Span::Condition(own) = span { Some(own) } else { None })
    }

    /// Replaces formulas and names by their presentation.
    #[must_use]
    pub fn presented(&self, presentation: &Presentation) -> Self {
        let presented = |span: &Span| match span {
            Span::Words(words) => Span::Words(words.clone()),
            Span::Name(name) => Span::Name(presentation.name(name)),
            Span::Formula(formula) => Span::Formula(presentation.formula(formula)),
            Span::Condition(condition) => Span::Condition(presentation.condition(condition)),
        };
        Self(self.0.iter().map(presented).collect())
    }

    /// Replaces symbols in formulas and conditions; names stay.
    #[must_use]
    pub fn substitute(&self, bindings: &Bindings) -> Self {
        let replaced = |span: &Span| match span {
            Span::Words(_) | Span::Name(_) => span.clone(),
            Span::Formula(formula) => Span::Formula(formula.substitute(bindings)),
            Span::Condition(condition) => Span::Condition(condition.substitute(bindings)),
        };
        Self(self.0.iter().map(replaced).collect())
    }

    /// The sentence in a notation, with words escaped.
    ///
    /// Formulas are enclosed in dollar signs in LaTeX and Typst, and in `math` elements in MathML.
    pub fn written(&self, notation: Notation) -> String {
        self.written_with(notation, |words| escaped(words, notation))
    }

    /// As [`Self::written`], with words written by `escape`.
    pub fn written_with(&self, notation: Notation, escape: impl Fn(&str) -> String) -> String {
        let mut text = String::new();
        let mut open = String::new();
        for (place, span) in self.0.iter().enumerate() {
            let Span::Words(words) = span else {
                open += &span.mathematics(notation);
                continue;
            };
            let is_followed = self.0.get(place + 1).is_some_and(|next| !matches!(next, Span::Words(_)));
            let (before, rest) = words.split_at(if open.is_empty() { 0 } else { signs_after(words, is_followed) });
            let (rest, after) = rest.split_at(rest.len() - if is_followed { sign_before(rest) } else { 0 });
            open += &signs(before, notation);
            if !rest.is_empty() {
                text += &closed(&std::mem::take(&mut open), notation);
                text += &escape(rest);
            }
            open += &signs(after, notation);
        }
        text + &closed(&open, notation)
    }
}

impl Span {
    fn mathematics(&self, notation: Notation) -> String {
        match self {
            Self::Words(words) => signs(words, notation),
            Self::Name(name) => {
                let parts = name.split('/').map(|part| match part.strip_prefix("dd ") {
                    Some(own) => format!("{}{}", upright_d(notation), notation.name(own)),
                    None => notation.name(part),
                });
                parts.collect::<Vec<_>>().join(if notation == Notation::Mathml { "<mo>/</mo>" } else { "/" })
            }
            Self::Formula(formula) => notation.formula(formula),
            Self::Condition(condition) => notation.condition(condition),
        }
    }
}

/// The d of a differential.
fn upright_d(notation: Notation) -> &'static str {
    match notation {
        Notation::Text | Notation::Unicode => "d",
        Notation::Latex => "\\mathrm{d}",
        Notation::Typst => "upright(d) ",
        Notation::Mathml => "<mi mathvariant=\"normal\">d</mi>",
    }
}

/// Mathematics between its delimiters.
fn closed(math: &str, notation: Notation) -> String {
    match notation {
        _ if math.is_empty() => String::new(),
        Notation::Text | Notation::Unicode => math.to_owned(),
        Notation::Latex | Notation::Typst => format!("${math}$"),
        Notation::Mathml => format!("<math xmlns=\"http://www.w3.org/1998/Math/MathML\">{math}</math>"),
    }
}

/// How many bytes at the beginning of words are mathematics, as in ` = 0, because`: all, if they only join two formulas, else a relation
/// with a number.
fn signs_after(words: &str, is_followed: bool) -> usize {
    let is_sign = |letter: char| letter.is_ascii_digit() || matches!(letter, ' ' | '=' | '<' | '>' | '+' | '-' | '−' | '·');
    if is_followed && words.chars().all(is_sign) {
        return words.len();
    }
    let number = words.trim_start_matches([' ', '=', '<', '>']);
    let digits = number.len() - number.trim_start_matches(|letter: char| letter.is_ascii_digit()).len();
    let relation = words.get(..words.len() - number.len()).unwrap_or_default();
    let rest = number.get(digits..).unwrap_or_default();
    let has_decimals = rest.strip_prefix('.').is_some_and(|rest| rest.starts_with(|letter: char| letter.is_ascii_digit()));
    let ends = !has_decimals && !rest.starts_with(|letter: char| letter.is_alphanumeric() || matches!(letter, '_' | '^' | '*' | '/'));
    if relation.trim().is_empty() || digits == 0 || !ends { 0 } else { relation.len() + digits }
}

/// How many bytes at the end of words are the sign of the formula behind, as in `between −`.
fn sign_before(words: &str) -> usize {
    let sign = words.chars().last().filter(|own| matches!(own, '−' | '-')).map_or(0, char::len_utf8);
    let is_joined = words.get(..words.len() - sign).is_some_and(|own| own.ends_with(char::is_alphanumeric));
    if is_joined { 0 } else { sign }
}

/// Relations, signs and whole numbers in mathematics.
fn signs(words: &str, notation: Notation) -> String {
    if matches!(notation, Notation::Text | Notation::Unicode) {
        return words.to_owned();
    }
    let plain = words.replace('−', "-").replace(">=", "≥").replace("<=", "≤");
    match notation {
        Notation::Latex => plain.replace('≥', "\\ge").replace('≤', "\\le").replace('·', "\\cdot"),
        Notation::Typst => plain.replace('≥', ">=").replace('≤', "<=").replace('·', "dot"),
        _ => {
            let token = |own: &str| {
                let is_number = own.starts_with(|letter: char| letter.is_ascii_digit());
                if is_number { format!("<mn>{own}</mn>") } else { format!("<mo>{}</mo>", mathml::escaped(&own.replace('-', "−"))) }
            };
            plain.split_whitespace().map(token).collect()
        }
    }
}

/// Words with the special characters of the notation escaped.
fn escaped(words: &str, notation: Notation) -> String {
    match notation {
        Notation::Text | Notation::Unicode => words.to_owned(),
        Notation::Mathml => mathml::escaped(words),
        Notation::Latex => latex_words(words),
        Notation::Typst => {
            let mut text = String::with_capacity(words.len());
            for letter in words.chars() {
                if matches!(
                    letter,
                    '\\' | '#' | '$' | '*' | '_' | '`' | '<' | '>' | '@' | '[' | ']' | '=' | '~' | '/' | '"' | '\'' | '+' | '-'
                ) {
                    text.push('\\');
                }
                text.push(letter);
            }
            text
        }
    }
}

/// Words escaped for LaTeX text mode.
pub(super) fn latex_words(words: &str) -> String {
    let words = words.replace(">=", "≥").replace("<=", "≤");
    let mut text = String::with_capacity(words.len());
    for letter in words.chars() {
        match letter {
            '\\' => text.push_str("\\textbackslash{}"),
            '{' | '}' | '%' | '#' | '&' | '_' | '$' => {
                text.push('\\');
                text.push(letter);
            }
            '^' => text.push_str("\\textasciicircum{}"),
            '~' => text.push_str("\\textasciitilde{}"),
            '<' => text.push_str("$<$"),
            '>' => text.push_str("$>$"),
            '–' => text.push_str("--"),
            own if own.is_ascii() || ('\u{c0}'..='\u{17f}').contains(&own) || own == '…' => text.push(own),
            own => match latex_sign(own) {
                Some(sign) => text += &format!("${sign}$"),
                // Fall back to the code point for characters without a LaTeX command.
                None => text += &format!("[U+{:04X}]", u32::from(own)),
            },
        }
    }
    text
}

/// A letter or sign beyond ASCII in math mode.
fn latex_sign(sign: char) -> Option<String> {
    const SIGNS: [(char, &str); 34] = [
        ('′', "'"),
        ('″', "''"),
        ('¹', "^1"),
        ('²', "^2"),
        ('³', "^3"),
        ('⁴', "^4"),
        ('ⁿ', "^n"),
        ('ˣ', "^x"),
        ('⁻', "^-"),
        ('₀', "_0"),
        ('₁', "_1"),
        ('₂', "_2"),
        ('ₙ', "_n"),
        ('−', "-"),
        ('±', "\\pm"),
        ('∓', "\\mp"),
        ('×', "\\times"),
        ('·', "\\cdot"),
        ('√', "\\surd"),
        ('∫', "\\int"),
        ('∂', "\\partial"),
        ('∞', "\\infty"),
        ('≤', "\\le"),
        ('≥', "\\ge"),
        ('≠', "\\ne"),
        ('≈', "\\approx"),
        ('∼', "\\sim"),
        ('∈', "\\in"),
        ('→', "\\to"),
        ('↦', "\\mapsto"),
        ('°', "^\\circ"),
        ('µ', "\\mu"),
        ('⌊', "\\lfloor"),
        ('⌋', "\\rfloor"),
    ];
    let known = SIGNS.iter().find(|(own, _)| *own == sign).map(|(_, text)| (*text).to_owned());
    known.or_else(|| greek::name(sign).map(crate::print::notations::latex_symbol::symbol))
}
