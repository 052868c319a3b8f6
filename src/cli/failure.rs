//! Error messages of the program, with the relevant part of the input marked.

use crate::contact::ContactError;
use crate::eval::EvalError;
use crate::expr::ExprError;
use crate::num::{Budget, Exhausted};
use crate::parse::{self, ParseError};
use crate::scene::SceneError;
use crate::transform::TransformError;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use std::error::Error;
use std::io::{self, IsTerminal, Write};
use std::ops::Range;

/// The reason why a command failed; the exit code is 2, or 1 if its budget was exhausted.
#[derive(Debug)]
pub struct Failure {
    message: String,
    help: Option<String>,
    place: Option<Excerpt>,
    incomplete: bool,
}

/// A text with the part of it that caused the error.
#[derive(Debug)]
struct Excerpt {
    name: String,
    text: String,
    span: Range<usize>,
}

/// Maximum number of characters of an error message, and of its first line.
const MOST_CHARACTERS: usize = 300;
const FIRST: usize = 120;
/// Maximum and minimum width of an excerpt, including its dots.
const SHOWN: usize = 120;
const NARROWEST: usize = 40;
/// Maximum number of characters of a word in a message, such as a path.
const LONGEST_WORD: usize = 48;
/// Number of characters of `error: ` or `help: `, and of the bar before an excerpt, each with the end of the line.
const PREFIX: usize = 8;
/// Number of characters of `warning: `, with the end of the line.
const WARNING: usize = 10;
const BAR: usize = 5;
/// Replaces omitted text.
const DOTS: &str = " ...";

/// Returns advice in terms of command-line options.
fn advice(error: &ContactError) -> Option<String> {
    let ContactError::Transform(error) = error else { return None };
    match error {
        TransformError::Flat => Some("derive and eval take the depth of a punch with --depth, as a number or the symbol d".to_owned()),
        TransformError::Kinks { .. } => Some("set the parameters with --set, or write the pieces with piecewise(…)".to_owned()),
        TransformError::Expression(ExprError::UnknownOrder { .. }) => Some("set the values of the parameters with --set".to_owned()),
        TransformError::CurveTooRough { .. } => Some("use that tolerance, a smaller range, or --method quadrature".to_owned()),
        TransformError::NoClosedForm { .. } => Some("compute its value with --method auto or --method quadrature".to_owned()),
        TransformError::Evaluation(EvalError::Unbound { name }) => Some(format!("set its value with --set {name}=VALUE")),
        _ => None,
    }
}

impl Failure {
    /// Creates an error without a position.
    pub(super) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), help: None, place: None, incomplete: false }
    }

    /// Returns true if the budget was exhausted, although the input may be valid; the exit code is then 1.
    pub(super) fn is_incomplete(&self) -> bool {
        self.incomplete
    }

    /// Returns the message without help and position.
    pub(super) fn message(&self) -> String {
        line(&self.message)
    }

    /// Adds a help line: what was expected, or what to do.
    pub(super) fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Creates an error for a text that could not be parsed.
    pub(super) fn parse(name: &str, text: &str, error: &ParseError) -> Self {
        Self::new(error.reason().to_string()).help(error.accepted()).at(name, text, error.span())
    }

    /// Creates an error for a scene that cannot be read or solved, with the position in its text.
    pub(super) fn scene(name: &str, text: &str, error: &SceneError) -> Self {
        let failure = Self::unplaced(error);
        match error.span() {
            Some(span) => failure.at(name, text, span),
            None => Self { message: format!("{name}: {}", failure.message), ..failure },
        }
    }

    /// Creates an error for the value of an option, which was read in the units of a scene.
    pub(super) fn argument(option: &str, value: &str, error: &SceneError) -> Self {
        Self::unplaced(error).at(option, value, 0..value.len())
    }

    /// Creates an error with the message and the help of a scene error.
    fn unplaced(error: &SceneError) -> Self {
        let failure = Self::new(error.to_string());
        match error.accepted() {
            Some(help) => failure.help(help),
            None => failure,
        }
    }

    /// Creates an error for a profile that was parsed, but whose result cannot be computed.
    pub(super) fn profile(text: &str, error: &ContactError) -> Self {
        let about_profile = match error {
            ContactError::Transform(
                TransformError::OutOfDomain { .. }
                | TransformError::Overflow { .. }
                | TransformError::Underflow { .. }
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
        let failure = match error {
            ContactError::Transform(TransformError::Exhausted(own)) => Self::from(*own),
            other => Self::new(other.to_string()),
        };
        let failure = match advice(error) {
            // The advice replaces the end of the library's message.
            Some(advice) => Self { message: failure.message.split("; ").next().unwrap_or_default().to_owned(), ..failure }.help(advice),
            None => failure,
        };
        if about_profile { failure.at("PROFILE", text, 0..text.len()) } else { failure }
    }

    /// Adds the position of the error.
    pub(super) fn at(mut self, name: &str, text: &str, span: Range<usize>) -> Self {
        self.place = Some(Excerpt { name: name.to_owned(), text: text.to_owned(), span });
        self
    }

    /// Prints the error on stderr.
    pub(super) fn report(&self) {
        let mut stderr = io::stderr().lock();
        let colour = stderr.is_terminal();
        // An error while writing to stderr cannot be reported.
        let _ = self.write(colour, &mut stderr);
    }

    fn write(&self, colour: bool, out: &mut dyn Write) -> io::Result<()> {
        let (bold, plain) = if colour { ("\x1b[1;31m", "\x1b[0m") } else { ("", "") };
        let position = self.place.as_ref().map(Excerpt::position);
        let is_long = |text: &str| text.chars().count() + PREFIX > FIRST + 1;
        let whole = position.as_ref().map_or_else(|| self.message.clone(), |position| format!("{position}: {}", self.message));
        // If the position and the message do not fit on one line, print the position on the next.
        let apart = position.as_ref().filter(|_| is_long(&whole));
        let whole = if apart.is_some() { &self.message } else { &whole };
        // Print the advice at the end of a long message as a help line.
        let parts = if is_long(whole) && self.help.is_none() { whole.rsplit_once("; ") } else { None };
        let (message, help) = parts.map_or((whole.as_str(), self.help.as_deref()), |(message, help)| (message, Some(help)));
        let message = line(message);
        writeln!(out, "{bold}error{plain}: {message}")?;
        let mut room = MOST_CHARACTERS - PREFIX - message.chars().count();
        if let Some(position) = apart {
            let position = cut(position, FIRST / 2);
            writeln!(out, "  at {position}")?;
            room = room.saturating_sub(PREFIX + position.chars().count());
        }
        if let Some(place) = &self.place {
            // Shorten the excerpt before the help.
            let needed = help.map_or(0, |help| PREFIX + help.chars().count());
            let (shown, offset, marks) = place.excerpt((room.saturating_sub(needed) / 2).clamp(NARROWEST, SHOWN));
            writeln!(out, "  | {shown}")?;
            writeln!(out, "  | {}{bold}{}{plain}", " ".repeat(offset), "^".repeat(marks))?;
            room = room.saturating_sub(2 * BAR + shown.chars().count() + offset + marks);
        }
        help.iter().try_for_each(|help| writeln!(out, "help: {}", cut(help, room.saturating_sub(PREFIX))))
    }
}

impl Excerpt {
    /// Returns the name of the text with line and column.
    fn position(&self) -> String {
        let (line, column) = parse::position(&self.text, self.span.clone());
        let name = if self.name.chars().count() > FIRST / 2 { with_short_words(&self.name) } else { self.name.clone() };
        match self.text.contains('\n') {
            false => format!("{name}, column {column}"),
            true => format!("{name}, line {line}, column {column}"),
        }
    }

    /// Returns the line to show, the number of characters before the mark, and the length of the mark.
    ///
    /// Control characters are replaced, and a long line is shortened around the mark.
    fn excerpt(&self, width: usize) -> (String, usize, usize) {
        let before = self.text.get(..self.span.start).unwrap_or(&self.text);
        let begin = before.rfind('\n').map_or(0, |at| at + 1);
        let line: Vec<char> = self.text.get(begin..).unwrap_or_default().chars().take_while(|c| *c != '\n').map(visible).collect();
        let offset = before.get(begin..).unwrap_or_default().chars().count();
        let marked = self.text.get(self.span.clone()).unwrap_or_default().chars().count();
        // Reserve space for the dots at both ends.
        let width = if line.len() + BAR <= width { line.len() } else { width - 2 * DOTS.len() - BAR };
        let before_mark = width / 3;
        let skipped = if line.len() > width { offset.saturating_sub(before_mark) } else { 0 };
        let shown: String = line.iter().skip(skipped).take(width).collect();
        let (left, right) = (if skipped > 0 { "... " } else { "" }, if line.len() > skipped + width { DOTS } else { "" });
        let room = line.len().min(skipped + width).saturating_sub(offset);
        (format!("{left}{shown}{right}"), left.len() + offset - skipped, marked.min(room).max(1))
    }
}

impl From<Exhausted> for Failure {
    fn from(error: Exhausted) -> Self {
        let seconds = error.steps as f64 / Budget::seconds(1.0).count() as f64;
        // Round to two significant digits, like a budget that a user would type.
        let seconds = format!("{seconds:.1e}").parse().unwrap_or(seconds);
        let failure = Self::new(format!("stopped at the work limit of {} steps", error.steps))
            .help(format!("raise the limit with --budget SECONDS (now {seconds} s), or simplify the profile"));
        Self { incomplete: true, ..failure }
    }
}

/// Replaces a character that has no fixed width or moves the cursor.
fn visible(c: char) -> char {
    match c {
        '\t' => ' ',
        // Besides control characters, these are the marks that change the writing direction.
        c if c.is_control() || matches!(c, '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}') => '\u{fffd}',
        c => c,
    }
}

/// Returns a message as one line of limited length, without control characters from names, keys or paths.
///
/// The middle is omitted if necessary, since a message starts with what is wrong and ends with the reason.
fn line(message: &str) -> String {
    shortened(message, FIRST + 1 - PREFIX)
}

/// Shortens a text to at most `most` characters: long words first, then the middle of the text.
fn shortened(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        return text.chars().map(visible).collect();
    }
    without_middle(&with_short_words(text), most)
}

/// Returns the text with the middle of every long word, such as a path, replaced by dots.
fn with_short_words(text: &str) -> String {
    let end = LONGEST_WORD / 3;
    let short = |word: &str| match word.chars().count() {
        count if count <= LONGEST_WORD => word.to_owned(),
        count => word.chars().take(end).chain("...".chars()).chain(word.chars().skip(count - end)).collect(),
    };
    text.split(' ').map(short).collect::<Vec<_>>().join(" ")
}

/// Shortens a text to at most `most` characters by omitting its middle.
fn without_middle(text: &str, most: usize) -> String {
    let count = text.chars().count();
    if count <= most {
        return text.chars().map(visible).collect();
    }
    let end = most / 3;
    let begin = most - end - DOTS.len() - 1;
    let (begin, end) = (text.chars().take(begin), text.chars().skip(count - end));
    let (begin, end) = (begin.map(visible).collect::<String>(), end.map(visible).collect::<String>());
    // Cut at word boundaries if possible.
    let is_part = |rest: &str| rest.chars().count() < LONGEST_WORD / 3;
    let begin = begin.rsplit_once(' ').filter(|(_, rest)| is_part(rest)).map_or(begin.as_str(), |(kept, _)| kept);
    let end = end.split_once(' ').filter(|(rest, _)| is_part(rest)).map_or(end.as_str(), |(_, kept)| kept);
    format!("{begin} ... {end}")
}

/// Truncates a text to at most `most` characters, including the trailing dots.
fn cut(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        return text.chars().map(visible).collect();
    }
    let kept: String = text.chars().take(most.saturating_sub(DOTS.len())).map(visible).collect();
    kept + DOTS
}

/// Prints an error of the argument parser in the same form as other errors.
pub(super) fn report_usage(error: &clap::Error) {
    usage(error).report();
}

/// Converts an error of the argument parser.
fn usage(error: &clap::Error) -> Failure {
    let context = |kind| match error.get(kind) {
        // Every short word is similar to `help`.
        Some(ContextValue::Strings(list)) => list.iter().map(String::as_str).filter(|own| *own != "help").collect::<Vec<_>>().join(", "),
        Some(other) => other.to_string(),
        None => String::new(),
    };
    let argument = context(ContextKind::InvalidArg);
    let suggestion = |kind| match context(kind) {
        meant if meant.is_empty() => String::new(),
        meant => format!("did you mean {meant}? "),
    };
    let options = "run with --help for the list of options";
    match error.kind() {
        ErrorKind::UnknownArgument => {
            Failure::new(format!("unexpected argument {argument}")).help(format!("{}{options}", suggestion(ContextKind::SuggestedArg)))
        }
        ErrorKind::InvalidSubcommand => Failure::new(format!("unknown command {}", context(ContextKind::InvalidSubcommand)))
            .help(format!("{}run with --help for the list of commands", suggestion(ContextKind::SuggestedSubcommand))),
        ErrorKind::MissingRequiredArgument => {
            let plural = if argument.contains(", ") { "s" } else { "" };
            Failure::new(format!("missing required argument{plural} {argument}")).help(options)
        }
        ErrorKind::TooManyValues => Failure::new(format!("{argument} does not take a value")).help(options),
        ErrorKind::ArgumentConflict if argument == context(ContextKind::PriorArg) => {
            Failure::new(format!("{argument} is given more than once")).help(options)
        }
        ErrorKind::ArgumentConflict => {
            Failure::new(format!("{argument} cannot be used with {}", context(ContextKind::PriorArg))).help(options)
        }
        ErrorKind::InvalidValue | ErrorKind::ValueValidation => {
            let value = context(ContextKind::InvalidValue);
            let message =
                if value.is_empty() { format!("{argument} requires a value") } else { format!("invalid value {value:?} for {argument}") };
            let known = context(ContextKind::ValidValue);
            match error.source().map(|own| expected(&own.to_string())) {
                Some(help) => Failure::new(message).help(help),
                None if known.is_empty() => Failure::new(message),
                None => Failure::new(message).help(format!("{}expected one of {known}", suggestion(ContextKind::SuggestedValue))),
            }
        }
        _ => {
            let text = error.to_string();
            let first = text.lines().next().unwrap_or_default();
            Failure::new(first.strip_prefix("error: ").unwrap_or(first)).help(options)
        }
    }
}

/// Returns the help for a value that the argument parser rejects for this reason.
fn expected(reason: &str) -> String {
    match reason {
        "invalid digit found in string" => "expected a whole number".to_owned(),
        "invalid float literal" => "expected a number".to_owned(),
        other => match other.split_once(" is not in ").and_then(|(_, range)| range.split_once("..=")) {
            Some((low, high)) => format!("expected a whole number from {low} to {high}"),
            None => other.to_owned(),
        },
    }
}

/// Prints a warning on stderr.
pub(super) fn warn(message: &str) {
    // A warning that cannot be written is not an error.
    let _ = writeln!(io::stderr(), "warning: {}", shortened(message, MOST_CHARACTERS - WARNING));
}
