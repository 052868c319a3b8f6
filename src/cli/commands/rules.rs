//! `sneddon rules`: the catalogue of exact solutions.

use crate::cli::output::{Destination, Endings, Formats};
use crate::cli::{Failure, Outcome};
use crate::parse;
use crate::report::{self, Statement};
use crate::transform::Rule;
use crate::transform::rules::RULES;
use clap::ValueEnum;
use std::path::PathBuf;

/// Lists the exact solutions in the catalogue, with their sources.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    /// Output format [default: text].
    #[arg(long, value_parser = Formats(ENDINGS))]
    format: Option<Format>,
    /// Same as --format json.
    #[arg(long, conflicts_with = "format")]
    json: bool,
    /// Writes to this file instead of stdout; the extension selects the format: .txt, .md or .json.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Format {
    Text,
    Json,
    Markdown,
}

const ENDINGS: &Endings<Format> = &[("txt", Format::Text), ("md", Format::Markdown), ("json", Format::Json)];

const EXAMPLES: &str = "Examples:
  sneddon rules
  sneddon rules --json
  sneddon rules --format markdown";

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let flag = arguments.format.or(arguments.json.then_some(Format::Json));
    let answer = Destination::choose(arguments.output.as_deref(), flag, Format::Text, ENDINGS)?;
    let statements = match answer.format() {
        Format::Markdown => RULES.iter().map(|rule| statement(rule)).collect::<Result<Vec<_>, _>>()?,
        Format::Text | Format::Json => Vec::new(),
    };
    answer.write(|format, out| match format {
        Format::Json => report::json::rules(RULES, out),
        Format::Text => report::text::rules(RULES, out),
        Format::Markdown => report::markdown::rules(&statements, out),
    })?;
    Ok(Outcome::Done)
}

/// Parses the formulas of a rule.
fn statement(rule: &'static Rule) -> Result<Statement, Failure> {
    let read = |text: &str| parse::formula(text).map_err(|error| Failure::new(format!("rule {} is invalid: {error}", rule.id)));
    Ok(Statement {
        rule,
        pattern: read(rule.pattern)?,
        equivalent: read(rule.equivalent)?,
        force: read(rule.force)?,
        pressure: rule.pressure.map(read).transpose()?,
    })
}
