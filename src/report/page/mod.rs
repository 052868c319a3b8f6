//! A page of formulas and sentences, independent of its notation; there is one file per notation and one per record.

mod apart;
mod arranged;
mod definitions;
mod derivation;
#[cfg(feature = "cli")]
mod inversion;
mod latex;
mod markdown;
mod mathml;
mod rules;
#[cfg(feature = "scene")]
mod scene;
mod sources;
mod steps;
mod text;
mod typst;

use crate::expr::{Expr, Formula};
use crate::print::{self, Notation, Presentation, Prose};
use sources::Sources;
use std::io::{self, Write};

/// A page.
#[derive(Clone)]
pub struct Page {
    title: String,
    /// True if sentences are part of the text instead of comments, as for steps and complete documents.
    is_text: bool,
    /// The parameters of the shape.
    parameters: Vec<String>,
    /// True if the names of parts apply to one section only.
    has_separate_sections: bool,
    /// The symbol of the contact radius.
    radius: String,
    /// The beginning of the labels, from the first formula, so that two derivations have no label in common.
    mark: String,
    blocks: Vec<Block>,
}

#[derive(Clone)]
enum Block {
    /// An equation with the key of its quantity, the range in which it applies if that is not everywhere, and its sources.
    Equation { key: String, left: String, right: Formula, range: Option<Range>, sources: Sources },
    /// The definitions of names in the equations before.
    Where(Vec<(String, Formula)>),
    /// Text between the equations and below the last one.
    Sentence(Prose),
    /// A note about the first equation.
    Remark(Prose),
    /// A heading with its level; 1 is the highest.
    Heading(usize, String),
    /// A list item, with the kind of list.
    Item(&'static str, Prose),
    /// The heads of columns, and rows of cells.
    #[cfg_attr(not(feature = "scene"), expect(dead_code, reason = "only pages of scenes have tables"))]
    Table(Vec<Prose>, Vec<Vec<Prose>>),
}

/// The values of a variable, from this one on, for which an equation holds.
#[derive(Clone)]
struct Range {
    variable: String,
    from: Expr,
}

/// The formats of a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Plain text; formulas can be parsed again.
    Text,
    /// Plain text with Unicode formulas.
    Unicode,
    /// LaTeX with the package amsmath.
    Latex,
    /// Markdown with LaTeX formulas.
    Markdown,
    /// Typst.
    Typst,
    /// HTML with MathML.
    Mathml,
}

/// The style of a page.
#[derive(Clone, Copy, Debug, Default)]
pub struct Style {
    /// True for a complete document, false for a fragment.
    pub standalone: bool,
    /// The number of characters after which formulas are broken into lines.
    pub width: Option<usize>,
}

/// The line width of a document with one column, in letters.
const COLUMN: usize = 72;
/// The line width of a terminal, in letters.
const TERMINAL: usize = 100;

impl Page {
    /// Writes the page.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write(&self, format: Format, style: Style, out: &mut dyn Write) -> io::Result<()> {
        let width = style.width.unwrap_or(if format == Format::Unicode { TERMINAL } else { COLUMN });
        let arranged = |notation| self.apart().arranged(notation, width);
        match format {
            Format::Text => text::write(self, Notation::Text, style, out),
            Format::Unicode => text::write(&arranged(Notation::Unicode), Notation::Unicode, style, out),
            Format::Latex => latex::write(&arranged(Notation::Latex), Style { width: Some(width), ..style }, out),
            Format::Markdown => markdown::write(&arranged(Notation::Latex), Style { width: Some(width), ..style }, out),
            Format::Typst => typst::write(&arranged(Notation::Typst), Style { width: Some(width), ..style }, out),
            Format::Mathml => mathml::write(&arranged(Notation::Mathml), style, out),
        }
    }

    fn new(title: &str, is_text: bool, presentation: &Presentation) -> Self {
        Self {
            title: title.to_owned(),
            is_text,
            parameters: Vec::new(),
            has_separate_sections: false,
            radius: presentation.name("a"),
            mark: String::new(),
            blocks: Vec::new(),
        }
    }

    fn equation(&mut self, key: &str, left: &str, right: &Formula, sources: Sources) {
        if self.mark.is_empty() {
            self.mark = format!("{}:", marked(right));
        }
        self.blocks.push(Block::Equation { key: key.to_owned(), left: left.to_owned(), right: right.clone(), range: None, sources });
    }

    /// States the parameters: the symbols of the shape besides its coordinate.
    fn parametrize(&mut self, shape: &Formula, presentation: &Presentation) {
        let names =
            shape.symbols().into_iter().map(|own| own.name().to_owned()).filter(|own| !matches!(own.as_str(), "r" | "x" | "a" | "d"));
        self.parameters = names.map(|own| presentation.name(&own)).collect();
    }

    fn list(&mut self, title: &str, kind: &'static str, items: Vec<Prose>) {
        if !items.is_empty() {
            self.heading(1, title);
            self.blocks.extend(items.into_iter().map(|own| Block::Item(kind, own)));
        }
    }

    fn sentence(&mut self, own: Prose) {
        self.blocks.push(Block::Sentence(own));
    }

    fn heading(&mut self, level: usize, text: &str) {
        self.blocks.push(Block::Heading(level, text.to_owned()));
    }
}

/// The letters and digits of a formula, joined by hyphens; a long formula is shortened and its length added.
fn marked(formula: &Formula) -> String {
    const LONGEST: usize = 40;
    let text = print::text(formula);
    let words: Vec<&str> = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|own| !own.is_empty()).collect();
    let whole = words.join("-");
    match whole.get(..LONGEST) {
        Some(start) => format!("{start}-{}", text.len()),
        None => whole,
    }
}

/// The letters that are left for the right side of an equation.
fn room(left: &str, range: Option<&Range>, notation: Notation, width: usize) -> usize {
    let behind = range.map_or(0, |own| notation.breadth(&own.from.clone().into()) + own.variable.chars().count() + 6);
    width.saturating_sub(left.chars().count() + 3 + behind).max(20)
}

/// Returns the lines of the right side of an equation, a single one without a width, else as many as necessary; the last one ends with
/// the range.
fn lines(left: &str, right: &Formula, range: Option<&Range>, notation: Notation, width: Option<usize>) -> Vec<String> {
    let room = width.map(|width| room(left, range, notation, width));
    let mut lines = room.map_or_else(|| vec![notation.formula(right)], |room| notation.lines(right, room));
    if let (Some(last), Some(range)) = (lines.last_mut(), range) {
        let (space, sign) = match notation {
            Notation::Latex => (" \\quad ", "\\ge"),
            Notation::Typst => (" quad ", ">="),
            _ => ("  ", "≥"),
        };
        last.push_str(&format!(",{space}{} {sign} {}", notation.name(&range.variable), notation.formula(&range.from.clone().into())));
    }
    lines
}
