//! A page of formulas and sentences, independent of its notation; there is one file per notation and one per record.

mod definitions;
mod derivation;
#[cfg(feature = "cli")]
mod inversion;
mod latex;
mod markdown;
mod mathml;
mod steps;
mod text;
mod typst;

use crate::expr::Formula;
use crate::print::{Notation, Prose};
use std::io::{self, Write};

/// A page.
pub struct Page {
    title: String,
    /// True if sentences are part of the text instead of comments, as for steps and complete documents.
    is_text: bool,
    blocks: Vec<Block>,
}

enum Block {
    /// An equation with the key of its quantity and its sources.
    Equation { key: String, left: String, right: Formula, sources: Prose },
    /// Text between the equations and below the last one.
    Sentence(Prose),
    /// A note about the first equation.
    Remark(Prose),
    /// A heading with its level; 1 is the highest.
    Heading(usize, String),
    /// A list item, with the kind of list.
    Item(&'static str, Prose),
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

/// The line width of a document with one column.
const COLUMN: usize = 72;

impl Page {
    /// Writes the page.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write(&self, format: Format, style: Style, out: &mut dyn Write) -> io::Result<()> {
        match format {
            Format::Text => text::write(self, Notation::Text, style, out),
            Format::Unicode => text::write(self, Notation::Unicode, style, out),
            Format::Latex => latex::write(self, style, out),
            Format::Markdown => markdown::write(self, style, out),
            Format::Typst => typst::write(self, style, out),
            Format::Mathml => mathml::write(self, style, out),
        }
    }

    fn equation(&mut self, key: &str, left: &str, right: &Formula, sources: Prose) {
        self.blocks.push(Block::Equation { key: key.to_owned(), left: left.to_owned(), right: right.clone(), sources });
    }

    fn list(&mut self, title: &str, kind: &'static str, items: Vec<Prose>) {
        if !items.is_empty() {
            self.heading(1, title);
            self.blocks.extend(items.into_iter().map(|own| Block::Item(kind, own)));
        }
    }

    fn heading(&mut self, level: usize, text: &str) {
        self.blocks.push(Block::Heading(level, text.to_owned()));
    }
}

/// Returns the lines of a formula: a single line without a width, else as many as necessary.
fn lines(right: &Formula, notation: Notation, width: Option<usize>) -> Vec<String> {
    width.map_or_else(|| vec![notation.formula(right)], |width| notation.lines(right, width))
}
