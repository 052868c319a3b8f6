//! `sneddon rules`: the catalogue of exact solutions.

use crate::cli::output::OutputArguments;
use crate::cli::typesetting::{Format, PageArguments};
use crate::cli::{Failure, Outcome};
use crate::parse;
use crate::report::page::{self, Page};
use crate::report::{self, Statement};
use crate::transform::Rule;
use crate::transform::rules::RULES;
use std::io;

/// Lists the exact solutions in the catalogue, with their sources.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    #[command(flatten)]
    output: OutputArguments<Format>,
    #[command(flatten)]
    page: PageArguments,
}

const EXAMPLES: &str = "Examples:
  sneddon rules
  sneddon rules --json
  sneddon rules --format latex --standalone";

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let answer = arguments.output.destination()?;
    let format = answer.format().page();
    let style = arguments.page.style(format)?;
    answer.write(|_, out| match format {
        None => report::json::rules(RULES, out),
        // The formulas as the rules state them, which can be parsed.
        Some(page::Format::Text) => report::text::rules(RULES, out),
        Some(format) => {
            let statements: Vec<_> = RULES.iter().map(|rule| statement(rule)).collect::<Result<_, _>>().map_err(io::Error::other)?;
            Page::of_rules(&statements).write(format, style, out)
        }
    })?;
    Ok(Outcome::Done)
}

/// Parses the formulas of a rule.
fn statement(rule: &'static Rule) -> Result<Statement, String> {
    let read = |text: &str| parse::formula(text).map_err(|error| format!("rule {} is invalid: {error}", rule.id));
    Ok(Statement {
        rule,
        pattern: read(rule.pattern)?,
        equivalent: read(rule.equivalent)?,
        force: read(rule.force)?,
        pressure: rule.pressure.map(read).transpose()?,
    })
}
