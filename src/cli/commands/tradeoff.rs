//! `sneddon tradeoff`: the cost of accuracy, method by method.

use crate::cli::failure::warn;
use crate::cli::output;
use crate::cli::output::{Endings, OutputArguments, OutputFormat};
use crate::cli::quantities::{Quantities, demand};
use crate::cli::{Failure, Outcome, budget, input, points};
use crate::contact::{ContactError, Quantity};
use crate::expr::Bindings;
use crate::report::{self, Tradeoff};
use crate::scene::Dimension;
use crate::tradeoff::{self, Options, Problem, TradeoffError};
use crate::transform::{self, Evaluator, Method, TransformError};
use clap::ValueEnum;
use std::io::Write;
use std::time::Duration;

/// Benchmarks each method over a range of accuracies: true error, time per point and number of evaluations.
///
/// Errors are relative to a reference that is a thousand times more accurate; if the error is too small to resolve, a bound is shown.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    #[command(flatten)]
    profile: input::ProfileArguments,
    /// Quantity to compute; the spring foundation computes only forces.
    #[arg(long, value_parser = Quantities(compared), default_value = "F")]
    quantity: Quantity,
    /// Points: 0.1,0.5 or start:stop:count or log:start:stop:count [default: 32 random points from a fixed seed, within the range of the profile].
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    at: Option<String>,
    /// Contact radius, for p.
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    radius: Option<String>,
    /// Relative error for which a method is recommended [default: 1e-3, 1e-6, 1e-9, 1e-12 and 1e-15].
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    tol: Option<String>,
    /// Time for the benchmark, in seconds.
    #[arg(long, value_name = "SECONDS", default_value = "10", allow_hyphen_values = true)]
    budget: String,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArguments<Format>,
}

const EXAMPLES: &str = "Examples:
  sneddon tradeoff 'r^2/(2*R)' --set R=2
  sneddon tradeoff 'R-sqrt(R^2-r^2)' --set R=2 --quantity p --radius 1 --at 0.5 --tol 1e-9 -o sphere.svg

Exit codes: 0 done, 1 the time did not suffice for every method, 2 bad input (the reason is on stderr).";

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(in crate::cli) enum Format {
    Text,
    Csv,
    Json,
    Svg,
}

impl OutputFormat for Format {
    const ENDINGS: &'static Endings<Self> = &[("svg", Self::Svg), ("txt", Self::Text), ("csv", Self::Csv), ("json", Self::Json)];
    const USUAL: Self = Self::Text;
    const PAGE: Option<(&'static str, &'static str)> = Some(("svg", "a plot"));
    const IS_BESIDE: bool = true;
}

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let quantity = arguments.quantity;
    demand(&[quantity], compared)?;
    let units = arguments.profile.units(&[arguments.at.as_deref(), arguments.radius.as_deref()], None);
    units.tell();
    let at = arguments.at.as_deref().map(|list| points::read(list, &units, Dimension::LENGTH)).transpose()?;
    let radius = arguments.radius.as_deref().map(|text| units.positive_length("--radius", text)).transpose()?;
    if radius.is_some() && quantity != Quantity::Pressure {
        return Err(Failure::new("--radius requires --quantity p").help("omit --radius, or add --quantity p"));
    }
    let wanted = arguments.tol.as_deref().map(input::tolerance).transpose()?;
    let budget = Duration::from_secs_f64(budget::seconds(&arguments.budget)?);
    let answer = arguments.output.destination()?;
    let (typed, settings) = arguments.profile.read(&units)?;
    settings.demand_all(&typed)?;
    let failed = |error: ContactError| Failure::profile(&typed.text, &error);
    let refused = |error: TransformError| failed(error.into());
    let profile = settings.bound_profile(&typed)?;
    if profile.is_flat() {
        return Err(refused(TransformError::Flat));
    }
    let solution = transform::derive(&profile).map_err(refused)?;
    let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).map_err(refused)?;
    let study = Problem::new(&solution, &evaluator, quantity, radius, at).and_then(|problem| {
        let usual = Options::default();
        let options = Options { budget, wanted: wanted.map_or(usual.wanted, |own| vec![own]), ..usual };
        tradeoff::run(problem, &options)
    });
    let study = study.map_err(|error| match error {
        TradeoffError::Transform(error) => refused(error),
        other => Failure::new(other.to_string()),
    })?;
    let record = Tradeoff { profile: &typed.formula, parameters: settings.values(), study: &study };
    let has_plot = answer.format() == Format::Svg;
    if let Some(why) = record.cut().filter(|_| has_plot && record.rows().next().is_none()) {
        warn(&why);
        return Ok(Outcome::Failed);
    }
    let plot = if has_plot { report::tradeoff::plot::svg(&record).map_err(Failure::new)? } else { String::new() };
    let write = |format, out: &mut dyn Write| match format {
        Format::Svg => out.write_all(plot.as_bytes()),
        Format::Json => report::tradeoff::json::tradeoff(&record, out),
        Format::Csv => report::tradeoff::csv::tradeoff(&record, out),
        Format::Text => report::tradeoff::text::tradeoff(&record, out),
    };
    answer.write(write)?;
    if has_plot && !answer.is_stdout() {
        output::print(|out| write(arguments.output.beside(), out))?;
    }
    Ok(if record.cut().is_some() { Outcome::Failed } else { Outcome::Done })
}

/// Checks whether `tradeoff` supports a quantity.
fn compared(quantity: Quantity) -> Result<(), &'static str> {
    if Problem::QUANTITIES.contains(&quantity) {
        Ok(())
    } else {
        Err("tradeoff measures only g, F and p; all other quantities follow from them")
    }
}
