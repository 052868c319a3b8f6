//! Sentences with embedded formulas, written in any of the notations.

use super::{Notation, Presentation};
use crate::expr::{Condition, Formula};
use crate::print::notations::{greek, mathml};

/// A piece of a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Span {
    Words(String),
    /// A symbol, or the value of a function such as g(x).
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
/// assert_eq!(edge.written(Notation::Latex), "the edge is at $x$ = $R_{1}$");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Prose(Vec<Span>);

impl Prose {
    /// A sentence in which names are enclosed in dollar signs.
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

    /// The sentence in a notation, with words escaped.
    ///
    /// Formulas are enclosed in dollar signs in LaTeX and Typst, and in `math` elements in MathML.
    pub fn written(&self, notation: Notation) -> String {
        self.written_with(notation, |words| escaped(words, notation))
    }

    /// As [`Self::written`], with words written by `escape`.
    pub fn written_with(&self, notation: Notation, escape: impl Fn(&str) -> String) -> String {
        let span = |span: &Span| {
            let math = match span {
                Span::Words(words) => return escape(words),
                Span::Name(name) => notation.name(name),
                Span::Formula(formula) => notation.formula(formula),
                Span::Condition(condition) => notation.condition(condition),
            };
            match notation {
                Notation::Text | Notation::Unicode => math,
                Notation::Latex | Notation::Typst => format!("${math}$"),
                Notation::Mathml => format!("<math xmlns=\"http://www.w3.org/1998/Math/MathML\">{math}</math>"),
            }
        };
        self.0.iter().map(span).collect()
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
