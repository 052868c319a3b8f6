//! `sneddon rules`: the catalogue of exact solutions.

use super::{Failure, Outcome, output};
use crate::parse;
use crate::report::{self, Statement};
use crate::transform::Rule;
use crate::transform::rules::RULES;
use clap::ValueEnum;

/// Lists the exact solutions that the program knows, with their sources.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// How the catalogue is written.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// The same as --format json.
    #[arg(long, conflicts_with = "format")]
    json: bool,
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    Text,
    Json,
    Markdown,
}

const EXAMPLES: &str = "Examples:
  sneddon rules
  sneddon rules --json
  sneddon rules --format markdown";

pub(super) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let statements = match arguments.format {
        Format::Markdown => RULES.iter().map(|rule| statement(rule)).collect::<Result<Vec<_>, _>>()?,
        Format::Text | Format::Json => Vec::new(),
    };
    output::print(|out| match arguments.format {
        _ if arguments.json => report::json::rules(RULES, out),
        Format::Json => report::json::rules(RULES, out),
        Format::Text => report::text::rules(RULES, out),
        Format::Markdown => report::markdown::rules(&statements, out),
    })?;
    Ok(Outcome::Done)
}

/// Reads the texts of a rule.
fn statement(rule: &'static Rule) -> Result<Statement, Failure> {
    let read = |text: &str| parse::formula(text).map_err(|error| Failure::new(format!("the rule {} is misstated: {error}", rule.id)));
    Ok(Statement {
        rule,
        pattern: read(rule.pattern)?,
        slope: read(rule.slope)?,
        force: read(rule.force)?,
        pressure: rule.pressure.map(read).transpose()?,
    })
}
