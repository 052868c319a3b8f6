//! `sneddon derive`: the formulas of a profile.

use super::failure::warn;
use super::output::{Destination, Endings};
use super::{Failure, Outcome, input};
use crate::contact::{ContactError, Edge, RIM, relations};
use crate::expr::{Bindings, Expr};
use crate::report::{self, Derivation};
use crate::transform;
use clap::ValueEnum;
use std::path::PathBuf;

/// Derives g, d, F, p, k and, where they are explicit, a(d) and F(d) as formulas.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    #[command(flatten)]
    profile: input::ProfileArguments,
    /// A punch with a rim at the contact radius, at this depth: a number, or the symbol d.
    #[arg(long, value_name = "D", allow_hyphen_values = true)]
    depth: Option<String>,
    /// How the answer is written [default: text].
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// The same as --format json.
    #[arg(long, conflicts_with = "format")]
    json: bool,
    /// Writes into this file instead of stdout; its ending decides the format: .txt, .tex or .json.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

const EXAMPLES: &str = "Examples:
  sneddon derive 'r^2/(2*R)'
  sneddon derive '-h*r^2/c^2' --depth d --format latex
  echo 'R-sqrt(R^2-r^2)' | sneddon derive - --set R=2 --json";

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Format {
    Text,
    Unicode,
    Latex,
    Markdown,
    Typst,
    Mathml,
    Json,
}

const ENDINGS: &Endings<Format> = &[("txt", Format::Text), ("tex", Format::Latex), ("json", Format::Json)];

pub(super) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let flag = arguments.format.or(arguments.json.then_some(Format::Json));
    let answer = Destination::choose(arguments.output.as_deref(), flag, Format::Text, ENDINGS)?;
    let edge = arguments.depth.as_deref().map(input::depth).transpose()?.map_or(Edge::Smooth, Edge::Rim);
    let (typed, settings) = if edge == Edge::Smooth { arguments.profile.read()? } else { arguments.profile.read_punch()? };
    let shown = typed.formula.substitute(&settings.exact()).substitute(&Bindings::one(RIM, Expr::symbol("a")));
    let failed = |error: ContactError| Failure::profile(&typed.text, &error);
    let profile = settings.exact_profile(&typed).map_err(|error| failed(error.into()))?;
    let solution = transform::derive(&profile).map_err(|error| failed(error.into()))?;
    solution.warnings().iter().for_each(|text| warn(text));
    let relations = relations(&solution, &edge).map_err(failed)?;
    let check = transform::check(&solution).map_err(|error| error.to_string());
    let record = Derivation { profile: &profile, typed: &shown, edge: &edge, relations: &relations, check };
    answer.write(|format, out| match format {
        Format::Json => report::json::derivation(&record, out),
        Format::Latex => report::latex::derivation(&record, out),
        Format::Markdown => report::markdown::derivation(&record, out),
        Format::Typst => report::typst::derivation(&record, out),
        Format::Mathml => report::mathml::derivation(&record, out),
        Format::Unicode => report::text::derivation_in_unicode(&record, out),
        Format::Text => report::text::derivation(&record, out),
    })?;
    if !record.failed() {
        return Ok(Outcome::Done);
    }
    warn("the check against quadrature failed");
    Ok(Outcome::Failed)
}
