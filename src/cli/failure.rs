//! Bad input: what is said about it, with the place marked under the text.

use crate::contact::ContactError;
use crate::num::{Budget, Exhausted};
use crate::parse::{self, ParseError};
use crate::transform::TransformError;
use std::io::{self, IsTerminal, Write};
use std::ops::Range;

/// Why a command did not do its work; the exit code is 2, or 1 where its budget did not suffice.
#[derive(Debug)]
pub struct Failure {
    message: String,
    help: Option<String>,
    place: Option<Place>,
    incomplete: bool,
}

/// A piece of text with the part of it that is meant.
#[derive(Debug)]
struct Place {
    name: String,
    text: String,
    span: Range<usize>,
}

/// Characters of a line that are shown; longer ones are cut.
const SHOWN: usize = 120;
/// Characters before the place in a line that is cut.
const BEFORE: usize = 50;

impl Failure {
    /// A message that needs no place.
    pub(super) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), help: None, place: None, incomplete: false }
    }

    /// True where the input may be good, but the budget did not suffice; the exit code is 1.
    pub(super) fn is_incomplete(&self) -> bool {
        self.incomplete
    }

    /// What went wrong, without advice and place.
    pub(super) fn message(&self) -> String {
        line(&self.message)
    }

    /// Adds what would be accepted.
    pub(super) fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// A text that could not be read.
    pub(super) fn parse(name: &str, text: &str, error: &ParseError) -> Self {
        Self::new(error.reason().to_string()).help(error.accepted()).at(name, text, error.span())
    }

    /// A profile that could be read but has no answer.
    pub(super) fn profile(text: &str, error: &ContactError) -> Self {
        let about_profile = match error {
            ContactError::Transform(
                TransformError::OutOfDomain { .. }
                | TransformError::Overflow { .. }
                | TransformError::NotComputable { .. }
                | TransformError::NoDigits { .. }
                | TransformError::NoClosedForm { .. }
                | TransformError::Exhausted(_)
                | TransformError::Number(_)
                | TransformError::Evaluation(_),
            ) => false,
            ContactError::Transform(_) => true,
            _ => false,
        };
        let failure = Self::new(error.to_string());
        if about_profile { failure.at("PROFILE", text, 0..text.len()) } else { failure }
    }

    /// Marks a place.
    pub(super) fn at(mut self, name: &str, text: &str, span: Range<usize>) -> Self {
        self.place = Some(Place { name: name.to_owned(), text: text.to_owned(), span });
        self
    }

    /// Says it on stderr.
    pub(super) fn report(&self) {
        let mut stderr = io::stderr().lock();
        let colour = stderr.is_terminal();
        // Nothing can be said where even the message cannot be written.
        let _ = self.write(colour, &mut stderr);
    }

    fn write(&self, colour: bool, out: &mut dyn Write) -> io::Result<()> {
        let (bold, plain) = if colour { ("\x1b[1;31m", "\x1b[0m") } else { ("", "") };
        match &self.place {
            None => writeln!(out, "{bold}error{plain}: {}", line(&self.message))?,
            Some(place) => {
                writeln!(out, "{bold}error{plain}: {}: {}", line(&place.position()), line(&self.message))?;
                let (shown, offset, marks) = place.excerpt();
                writeln!(out, "  | {shown}")?;
                writeln!(out, "  | {}{bold}{}{plain}", " ".repeat(offset), "^".repeat(marks))?;
            }
        }
        self.help.iter().try_for_each(|help| writeln!(out, "help: {}", shown(help)))
    }
}

impl Place {
    /// The name of the text with line and column.
    fn position(&self) -> String {
        let (line, column) = parse::position(&self.text, self.span.clone());
        match self.text.trim_end().contains('\n') {
            false => format!("{}, column {column}", self.name),
            true => format!("{}, line {line}, column {column}", self.name),
        }
    }

    /// The line of the place as it can be shown, the characters before the mark, and the length of the mark.
    ///
    /// Control characters are replaced, and a long line is cut around the place.
    fn excerpt(&self) -> (String, usize, usize) {
        let before = self.text.get(..self.span.start).unwrap_or(&self.text);
        let begin = before.rfind('\n').map_or(0, |at| at + 1);
        let line: Vec<char> = self.text.get(begin..).unwrap_or_default().chars().take_while(|c| *c != '\n').map(visible).collect();
        let offset = before.get(begin..).unwrap_or_default().chars().count();
        let marked = self.text.get(self.span.clone()).unwrap_or_default().chars().count();
        let skipped = if line.len() > SHOWN { offset.saturating_sub(BEFORE) } else { 0 };
        let shown: String = line.iter().skip(skipped).take(SHOWN).collect();
        let (left, right) = (if skipped > 0 { "... " } else { "" }, if line.len() > skipped + SHOWN { " ..." } else { "" });
        let room = line.len().min(skipped + SHOWN).saturating_sub(offset);
        (format!("{left}{shown}{right}"), left.len() + offset - skipped, marked.min(room).max(1))
    }
}

impl From<Exhausted> for Failure {
    fn from(error: Exhausted) -> Self {
        let seconds = error.steps as f64 / Budget::seconds(1.0).count() as f64;
        let failure = Self::new(format!("the work was stopped: the budget of {} steps is used up", error.steps))
            .help(format!("a larger --budget SECONDS would be accepted (this one stands for {seconds:.1} s), or a simpler profile"));
        Self { incomplete: true, ..failure }
    }
}

/// A character that takes one place and moves no cursor.
fn visible(c: char) -> char {
    match c {
        '\t' => ' ',
        // Besides controls, marks that turn the direction of what is written.
        c if c.is_control() || matches!(c, '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}') => '\u{fffd}',
        c => c,
    }
}

/// The most characters of a message.
const MESSAGE: usize = 280;

/// A message as one line of moderate length: what names, keys and paths bring along moves no cursor and hides nothing.
fn line(message: &str) -> String {
    let mut characters = message.chars();
    let mut text: String = characters.by_ref().take(MESSAGE).map(visible).collect();
    if characters.next().is_some() {
        text.push_str(" ...");
    }
    text
}

/// The same without a limit, for advice that lists what is known.
fn shown(message: &str) -> String {
    message.chars().map(visible).collect()
}

/// Something that is worth knowing, on stderr.
pub(super) fn warn(message: &str) {
    // A warning that cannot be written is no reason to stop.
    let _ = writeln!(io::stderr(), "warning: {}", line(message));
}
