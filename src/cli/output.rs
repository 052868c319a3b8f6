//! Destination and format of the output: stdout, or a file whose extension selects the format.

use super::Failure;
use super::file::{self, Target};
use crate::num::work;
use clap::builder::{EnumValueParser, PossibleValue, TypedValueParser};
use clap::error::{ContextKind, ContextValue};
use clap::{Arg, ArgAction, ArgMatches, Command, ValueEnum, value_parser};
use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes the output to stdout; a closed pipe is not an error.
pub(super) fn print(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    let failed = |error: io::Error| Failure::new(format!("cannot write the output: {error}"));
    let whole = file::spooled(write);
    work::check()?;
    let (mut whole, mut out) = (whole.map_err(failed)?, io::stdout().lock());
    match io::copy(&mut whole, &mut out).and_then(|_| out.flush()) {
        Ok(()) => Ok(()),
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        Err(error) => Err(failed(error)),
    }
}

/// The file extensions that a command supports, each with its format.
pub(super) type Endings<F> = [(&'static str, F)];

/// The formats of a command.
pub(super) trait OutputFormat: ValueEnum + Copy + PartialEq + Send + Sync + 'static {
    /// The file extensions, each with its format; the first one of a format is shown in the help.
    const ENDINGS: &'static Endings<Self>;
    /// The format where none is requested.
    const USUAL: Self;
    /// The extension of a format that is more than the results, and what it is.
    const PAGE: Option<(&'static str, &'static str)> = None;
    /// True if a file in the format of [`Self::PAGE`] is written in addition to the results on stdout.
    const IS_BESIDE: bool = false;

    /// The format with this name.
    fn named(name: &str) -> Option<Self> {
        Self::value_variants().iter().copied().find(|own| own.to_possible_value().is_some_and(|own| own.get_name() == name))
    }

    /// The name of this format.
    fn name(self) -> String {
        self.to_possible_value().map_or_else(String::new, |own| own.get_name().to_owned())
    }
}

/// The formats of a table.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum Tabular {
    Text,
    Csv,
    Json,
}

impl OutputFormat for Tabular {
    const ENDINGS: &'static Endings<Self> = &[("txt", Self::Text), ("csv", Self::Csv), ("json", Self::Json)];
    const USUAL: Self = Self::Text;
}

/// The options `--format`, `--json`, `--csv` and `-o`, with those formats that the command has.
#[derive(Clone)]
pub(super) struct OutputArguments<F> {
    format: Option<F>,
    file: Option<PathBuf>,
}

/// Formats with an option of the same name.
const SHORTCUTS: [&str; 2] = ["json", "csv"];

impl<F: OutputFormat> OutputArguments<F> {
    /// Returns the format on stdout next to a file in the format of [`OutputFormat::PAGE`].
    pub(super) fn beside(&self) -> F {
        let page = F::PAGE.and_then(|own| known(own.0, F::ENDINGS));
        self.format.filter(|own| Some(*own) != page).unwrap_or(F::USUAL)
    }

    /// Returns true if a JSON document is written to stdout.
    pub(super) fn is_document(&self) -> bool {
        self.format.is_some_and(|own| own.name() == "json") && self.file.as_ref().is_none_or(|path| path.as_os_str() == "-")
    }

    /// Returns the destination, see [`Destination::choose`].
    ///
    /// # Errors
    /// See [`Destination::choose`].
    pub(super) fn destination(&self) -> Result<Destination<F>, Failure> {
        let file = self.file.as_deref();
        let page = F::PAGE.filter(|_| F::IS_BESIDE).and_then(|own| known(own.0, F::ENDINGS));
        let is_page = page.is_some() && file.and_then(|path| ending(path, F::ENDINGS)) == page;
        Destination::choose(file, self.format.filter(|_| !is_page), F::USUAL, F::ENDINGS)
    }

    fn shortcuts() -> impl Iterator<Item = &'static str> {
        SHORTCUTS.into_iter().filter(|name| F::named(name).is_some())
    }

    /// The help of `-o`.
    fn help() -> String {
        let page = F::PAGE.map(|own| own.0);
        let usual: Vec<&str> = distinct(F::ENDINGS).into_iter().filter(|own| Some(*own) != page).collect();
        let instead = if F::IS_BESIDE { "" } else { " instead of stdout" };
        let page = F::PAGE.map_or_else(String::new, |(own, what)| {
            let beside = if F::IS_BESIDE { " in addition to the results on stdout" } else { "" };
            format!(", or .{own} for {what}{beside}")
        });
        let extensions =
            if page.is_empty() { listed(&usual) } else { usual.iter().map(|own| format!(".{own}")).collect::<Vec<_>>().join(", ") };
        format!("Writes to this file{instead}; the extension selects the format: {extensions}{page}")
    }
}

impl<F: OutputFormat> clap::FromArgMatches for OutputArguments<F> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let shortcut = Self::shortcuts().find(|name| matches.get_flag(name)).and_then(F::named);
        Ok(Self { format: matches.get_one("format").copied().or(shortcut), file: matches.get_one("output").cloned() })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

impl<F: OutputFormat> clap::Args for OutputArguments<F> {
    fn augment_args(command: Command) -> Command {
        let format = Arg::new("format").long("format").value_name("FORMAT").value_parser(Formats(F::ENDINGS));
        let format = format.help(format!("Output format [default: {}]", F::USUAL.name()));
        let shortcut = |name: &'static str| {
            let others = ["format"].into_iter().chain(Self::shortcuts().filter(move |own| *own != name));
            Arg::new(name).long(name).action(ArgAction::SetTrue).help(format!("Same as --format {name}")).conflicts_with_all(others)
        };
        let output =
            Arg::new("output").short('o').long("output").value_name("FILE").value_parser(value_parser!(PathBuf)).help(Self::help());
        Self::shortcuts().map(shortcut).fold(command.arg(format), Command::arg).arg(output)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

/// Parses the name of a format; for a file extension such as `tex`, the error suggests the name.
#[derive(Clone)]
struct Formats<F: 'static>(&'static Endings<F>);

impl<F: ValueEnum + Send + Sync + 'static> TypedValueParser for Formats<F> {
    type Value = F;

    fn parse_ref(&self, command: &Command, argument: Option<&Arg>, value: &OsStr) -> Result<F, clap::Error> {
        EnumValueParser::<F>::new().parse_ref(command, argument, value).map_err(|mut error| {
            let meant = self.0.iter().find(|own| value.to_str() == Some(own.0)).and_then(|own| own.1.to_possible_value());
            if let Some(meant) = meant {
                error.insert(ContextKind::SuggestedValue, ContextValue::String(meant.get_name().to_owned()));
            }
            error
        })
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(F::value_variants().iter().filter_map(F::to_possible_value)))
    }
}

/// The destination and the format of the output.
pub(super) struct Destination<F> {
    format: F,
    target: Option<Target>,
}

impl<F: Copy + PartialEq> Destination<F> {
    /// Chooses the format from the extension of `file`, else from the flag, else the default.
    ///
    /// `-` is stdout. A pipe or a device without an extension uses the format of the flag.
    ///
    /// # Errors
    /// [`Failure`] for an extension that the command does not support or that contradicts the flag, and for a file that
    /// cannot be written.
    fn choose(file: Option<&Path>, flag: Option<F>, usual: F, endings: &Endings<F>) -> Result<Self, Failure> {
        let Some(path) = file.filter(|path| path.as_os_str() != "-") else {
            return Ok(Self { format: flag.unwrap_or(usual), target: None });
        };
        let shown = path.display();
        let special = path.metadata().is_ok_and(|own| !own.is_file() && !own.is_dir());
        let format = match (ending(path, endings), flag) {
            (Some(format), Some(flag)) if format != flag => {
                return Err(Failure::new(format!("-o {shown}: the extension contradicts the requested format"))
                    .help(format!("omit the format option, or use a matching extension: {}", listed(&distinct(endings)))));
            }
            (Some(format), _) => format,
            (None, flag) if special => flag.unwrap_or(usual),
            (None, _) => return Err(unknown(path, endings)),
        };
        Ok(Self { format, target: Some(Target::new(path)?) })
    }

    /// Returns the format.
    pub(super) fn format(&self) -> F {
        self.format
    }

    /// Returns true if the output goes to stdout.
    pub(super) fn is_stdout(&self) -> bool {
        self.target.is_none()
    }

    /// Writes the output; a file appears only when it is complete.
    pub(super) fn write(&self, write: impl FnOnce(F, &mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
        let formatted = |out: &mut dyn Write| write(self.format, out);
        match &self.target {
            Some(target) => target.fill(formatted),
            None => print(formatted),
        }
    }
}

/// Returns the format that belongs to the extension of a file name.
fn ending<F: Copy>(path: &Path, endings: &Endings<F>) -> Option<F> {
    known(path.extension()?.to_str()?, endings)
}

fn known<F: Copy>(extension: &str, endings: &Endings<F>) -> Option<F> {
    endings.iter().find(|(known, _)| known.eq_ignore_ascii_case(extension)).map(|(_, format)| *format)
}

/// The first extension of every format.
fn distinct<F: PartialEq>(endings: &Endings<F>) -> Vec<&'static str> {
    let is_first = |place: usize| endings.iter().take(place).all(|earlier| endings.get(place).is_none_or(|own| own.1 != earlier.1));
    endings.iter().enumerate().filter(|(place, _)| is_first(*place)).map(|(_, own)| own.0).collect()
}

fn unknown<F: PartialEq>(path: &Path, endings: &Endings<F>) -> Failure {
    let shown = path.display();
    let message = match path.extension() {
        Some(own) => format!("-o {shown}: this command does not write .{} files", own.to_string_lossy()),
        None => format!("-o {shown}: the file name has no extension"),
    };
    Failure::new(message).help(format!("expected a name ending in {}, or - for stdout", listed(&distinct(endings))))
}

fn listed(extensions: &[&str]) -> String {
    let names: Vec<String> = extensions.iter().map(|own| format!(".{own}")).collect();
    match names.as_slice() {
        [first @ .., last] if !first.is_empty() => format!("{} or {last}", first.join(", ")),
        _ => names.concat(),
    }
}
