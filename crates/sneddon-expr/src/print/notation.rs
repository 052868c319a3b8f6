//! The notations as values, for writers that are the same in all of them.

use super::math::Math;
use super::{compose, laid_out, mapped};
use crate::expr::{Condition, Formula, shown, shown_as_mathematics};
use crate::print::notations::{latex, latex_symbol, mathml, text, typst, unicode};
use compose::Style;

/// A way of writing formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// The program's own grammar.
    Text,
    /// One line of Unicode.
    Unicode,
    /// LaTeX, for math mode.
    Latex,
    /// Typst, for math mode.
    Typst,
    /// The content of a `math` element of MathML Core.
    Mathml,
}

impl Notation {
    /// The formula, without delimiters.
    pub fn formula(self, formula: &Formula) -> String {
        self.written(&self.math(formula))
    }

    /// The condition, without delimiters.
    pub fn condition(self, condition: &Condition) -> String {
        let math = match self {
            Self::Text => compose::condition(&mapped(condition, shown), Style::Grammar),
            _ => compose::condition(&mapped(condition, shown_as_mathematics), Style::Display),
        };
        self.written(&math)
    }

    /// A parameter or a variable, or the value of a function such as g(x) or f'(r).
    ///
    /// ```
    /// use sneddon_expr::print::Notation;
    /// assert_eq!(Notation::Latex.name("g_1(x)"), "g_{1}(x)");
    /// assert_eq!(Notation::Unicode.name("delta(a)"), "δ(a)");
    /// ```
    pub fn name(self, name: &str) -> String {
        match self {
            Self::Text => name.to_owned(),
            Self::Unicode => unicode::symbol(name),
            Self::Latex => latex_symbol::symbol(name),
            Self::Typst => typst::symbol(name),
            Self::Mathml => mathml::symbol(name),
        }
    }

    /// The formula in lines of about `width` visible characters; a line ends before a sign.
    ///
    /// Text and Unicode break at any sign, the outermost first; the other notations between the terms of a sum.
    ///
    /// ```
    /// use sneddon_expr::{expr::Expr, print::Notation};
    /// let sum = Expr::symbol("alpha") + Expr::symbol("beta") + Expr::symbol("gamma");
    /// assert_eq!(Notation::Latex.lines(&sum.into(), 8), [r"\alpha + \beta", r"+ \gamma"]);
    /// ```
    pub fn lines(self, formula: &Formula, width: usize) -> Vec<String> {
        let math = self.math(formula);
        match (self, &math) {
            (Self::Text | Self::Unicode, _) => wrapped(&self.written(&math), width),
            (_, Math::Sum(terms)) => self.terms_in_lines(terms, width),
            _ => vec![self.written(&math)],
        }
    }

    /// About how many letters wide the formula is set on one line.
    pub fn breadth(self, formula: &Formula) -> usize {
        self.math(formula).breadth()
    }

    /// The breadth of the widest of the [lines](Self::lines) of a formula in mathematical notation.
    pub fn widest(self, formula: &Formula, width: usize) -> usize {
        match self.math(formula) {
            Math::Sum(terms) => {
                let widths = || terms.iter().map(|(_, term)| term.breadth() + 3);
                if widths().sum::<usize>() <= width + 3 { widths().sum() } else { widths().max().unwrap_or(0).saturating_sub(3) }
            }
            other => other.breadth(),
        }
    }

    fn math(self, formula: &Formula) -> Math {
        match self {
            Self::Text => compose::formula(&formula.map(&shown), Style::Grammar),
            _ => laid_out(formula),
        }
    }

    fn written(self, math: &Math) -> String {
        match self {
            Self::Text => text::write(math),
            Self::Unicode => unicode::write(math),
            Self::Latex => latex::write(math),
            Self::Typst => typst::write(math),
            Self::Mathml => mathml::write(math),
        }
    }

    fn terms_in_lines(self, terms: &[(bool, Math)], width: usize) -> Vec<String> {
        let mut lines: Vec<String> = Vec::new();
        let mut used = 0;
        for (place, (negative, term)) in terms.iter().enumerate() {
            let own = term.breadth() + 3;
            let sign = match (place, negative) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => "+ ",
                (_, true) => "- ",
            };
            let piece = format!("{sign}{}", self.written(term));
            match lines.last_mut().filter(|_| used + own <= width + 3) {
                Some(line) => {
                    line.push(' ');
                    line.push_str(&piece);
                    used += own;
                }
                None => {
                    lines.push(piece);
                    used = own;
                }
            }
        }
        lines
    }
}

/// The text in lines of at most `width` characters where it has spaces before signs or after commas, the outermost first.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut rest: Vec<char> = text.chars().collect();
    while rest.len() > width.max(1) {
        let mut depth = 0_usize;
        let mut best: Option<(usize, usize)> = None;
        for (place, letter) in rest.iter().enumerate() {
            match letter {
                '(' | '[' => depth += 1,
                ')' | ']' => depth = depth.saturating_sub(1),
                ' ' if place > 0 => {
                    let before_sign = rest.get(place + 1).is_some_and(|next| matches!(next, '+' | '-' | '−'))
                        && rest.get(place + 2).is_some_and(|next| *next == ' ');
                    let after_comma = rest.get(place - 1).is_some_and(|own| matches!(own, ',' | ';'));
                    if !before_sign && !after_comma {
                        continue;
                    }
                    if place <= width {
                        // An outer place is better, unless it leaves most of the line empty.
                        let is_better = best.is_none_or(|(known, at)| depth <= known || at < width / 3);
                        if is_better {
                            best = Some((depth, place));
                        }
                    } else if best.is_none() {
                        best = Some((depth, place));
                        break;
                    }
                }
                _ => {}
            }
            if place > width && best.is_some() {
                break;
            }
        }
        let Some((_, place)) = best else { break };
        let tail = rest.split_off(place + 1);
        lines.push(rest.iter().collect::<String>().trim_end().to_owned());
        rest = tail;
    }
    lines.push(rest.iter().collect());
    lines
}
