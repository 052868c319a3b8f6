//! Destination and format of the output: stdout, or a file whose extension selects the format.

use super::Failure;
use super::file::{self, Target};
use crate::num::work;
use clap::builder::{EnumValueParser, PossibleValue, TypedValueParser};
use clap::error::{ContextKind, ContextValue};
use clap::{Arg, ValueEnum};
use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::Path;

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

/// The formats of a table.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Tabular {
    Text,
    Csv,
    Json,
}

impl Tabular {
    pub(super) const ENDINGS: &Endings<Self> = &[("txt", Self::Text), ("csv", Self::Csv), ("json", Self::Json)];

    /// Returns the format that an option demands, if any.
    pub(super) fn demanded(json: bool, csv: bool) -> Option<Self> {
        json.then_some(Self::Json).or(csv.then_some(Self::Csv))
    }
}

/// Parses the name of a format; for a file extension such as `tex`, the error suggests the name.
#[derive(Clone)]
pub(super) struct Formats<F: 'static>(pub(super) &'static Endings<F>);

impl<F: ValueEnum + Send + Sync + 'static> TypedValueParser for Formats<F> {
    type Value = F;

    fn parse_ref(&self, command: &clap::Command, argument: Option<&Arg>, value: &OsStr) -> Result<F, clap::Error> {
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
    pub(super) fn choose(file: Option<&Path>, flag: Option<F>, usual: F, endings: &Endings<F>) -> Result<Self, Failure> {
        let Some(path) = file.filter(|path| path.as_os_str() != "-") else {
            return Ok(Self { format: flag.unwrap_or(usual), target: None });
        };
        let shown = path.display();
        let special = path.metadata().is_ok_and(|own| !own.is_file() && !own.is_dir());
        let format = match (ending(path, endings), flag) {
            (Some(format), Some(flag)) if format != flag => {
                return Err(Failure::new(format!("-o {shown}: the extension contradicts the requested format"))
                    .help(format!("omit the format option, or use a matching extension: {}", listed(endings))));
            }
            (Some(format), _) => format,
            (None, flag) if special => flag.unwrap_or(usual),
            (None, _) => return Err(unknown(path, endings)),
        };
        Ok(Self { format, target: Some(Target::new(path)?) })
    }

    /// Like [`Self::choose`], but a file in the format `picture` is written in addition to the results on stdout, whose format the flag selects.
    ///
    /// # Errors
    /// See [`Self::choose`].
    pub(super) fn beside(file: Option<&Path>, flag: Option<F>, usual: F, endings: &Endings<F>, picture: F) -> Result<Self, Failure> {
        let is_picture = file.and_then(|path| ending(path, endings)).is_some_and(|own| own == picture);
        Self::choose(file, flag.filter(|_| !is_picture), usual, endings)
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
    let own = path.extension()?.to_str()?;
    endings.iter().find(|(known, _)| known.eq_ignore_ascii_case(own)).map(|(_, format)| *format)
}

fn unknown<F>(path: &Path, endings: &Endings<F>) -> Failure {
    let shown = path.display();
    let message = match path.extension() {
        Some(own) => format!("-o {shown}: this command does not write .{} files", own.to_string_lossy()),
        None => format!("-o {shown}: the file name has no extension"),
    };
    Failure::new(message).help(format!("expected a name ending in {}, or - for stdout", listed(endings)))
}

fn listed<F>(endings: &Endings<F>) -> String {
    let names: Vec<String> = endings.iter().map(|(name, _)| format!(".{name}")).collect();
    match names.as_slice() {
        [first @ .., last] if !first.is_empty() => format!("{} or {last}", first.join(", ")),
        _ => names.concat(),
    }
}
