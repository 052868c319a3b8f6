//! `sneddon compare`: compares closed forms with quadrature.

use crate::cli::failure::warn;
use crate::cli::output::{Endings, OutputArguments, OutputFormat};
use crate::cli::{Failure, Outcome, budget, input};
use crate::contact::{self, ContactError, Setting};
use crate::report::{self, Compared};
use crate::transform::{self, TransformError, Verdict};
use clap::ValueEnum;

/// Compares the closed forms with numerical quadrature of the profile, at up to 64 points per quantity.
///
/// Parameters without a value are assigned admissible random values from a fixed seed. The exit code is 1 if a comparison fails or nothing could be compared.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    #[command(flatten)]
    profile: input::ProfileArguments,
    /// Contact radius [default: points spread over the range of the profile].
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    radius: Option<String>,
    /// Depth of a punch whose rim is at the contact radius.
    #[arg(long, value_name = "D", allow_hyphen_values = true)]
    depth: Option<String>,
    /// Largest relative difference to accept [default: the error bounds].
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    tol: Option<String>,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArguments<Format>,
    #[command(flatten)]
    pub(in crate::cli) budget: budget::BudgetArguments,
}

const EXAMPLES: &str = "Examples:
  sneddon compare 'R-sqrt(R^2-r^2)'
  sneddon compare 'piecewise(0, r<b, (r^2-b^2)/(2*R))' --set R=2 --set b=0.6 --tol 1e-9 --json";

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(in crate::cli) enum Format {
    Text,
    Json,
}

impl OutputFormat for Format {
    const ENDINGS: &'static Endings<Self> = &[("txt", Self::Text), ("json", Self::Json)];
    const USUAL: Self = Self::Text;
}

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let answer = arguments.output.destination()?;
    let units = arguments.profile.units(&[arguments.radius.as_deref(), arguments.depth.as_deref()], None);
    units.tell();
    let setting = Setting {
        radius: arguments.radius.as_deref().map(|text| units.positive_length("--radius", text)).transpose()?,
        depth: arguments.depth.as_deref().map(|text| units.length("--depth", text)).transpose()?,
        tolerance: arguments.tol.as_deref().map(input::tolerance).transpose()?,
    };
    let (typed, settings) = arguments.profile.read(&units)?;
    let failed = |error: ContactError| Failure::profile(&typed.text, &error);
    let profile = settings.bound_profile(&typed)?;
    if profile.is_flat() && setting.depth.is_none() {
        return Err(failed(TransformError::Flat.into()));
    }
    let solution = transform::derive(&profile).map_err(|error| failed(error.into()))?;
    solution.warnings().iter().for_each(|text| warn(text));
    let comparisons = contact::compare(&solution, &setting).map_err(failed)?;
    let record = Compared { profile: &typed.formula, comparisons: &comparisons };
    answer.write(|format, out| match format {
        Format::Json => report::json::comparison(&record, out),
        Format::Text => report::text::comparison(&record, out),
    })?;
    record.why().into_iter().for_each(warn);
    let has = |verdict| comparisons.quantities.iter().any(|own| own.verdict == verdict);
    let passed = comparisons.is_complete && has(Verdict::Passed) && !has(Verdict::Failed);
    Ok(if passed { Outcome::Done } else { Outcome::Failed })
}
