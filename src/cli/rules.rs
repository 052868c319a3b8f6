//! `sneddon rules`: the catalogue of exact solutions.

use super::{Failure, Outcome, output};
use crate::report;
use crate::transform::rules::RULES;

/// Lists the exact solutions that the program knows, with their sources.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// Writes JSON.
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "Examples:
  sneddon rules
  sneddon rules --json";

pub(super) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    output::print(|out| match arguments.json {
        true => report::json::rules(RULES, out),
        false => report::text::rules(RULES, out),
    })?;
    Ok(Outcome::Done)
}
