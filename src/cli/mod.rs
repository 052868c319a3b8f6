//! The command line, with one file per subcommand; no other module reads or writes files or streams.

mod budget;
mod commands;
mod curve;
mod failure;
mod file;
mod input;
mod output;
mod points;
mod precision;
mod progress;
mod quantities;
mod series;
mod tip;
mod typesetting;
mod units;

use crate::report;
use clap::{Parser, Subcommand};
use commands::{code, compare, completions, derive, eval, invert, kappa, plot, reference, rules, scene, solve, tradeoff, validate};
use failure::Failure;
use std::process::ExitCode;

/// Private items used by tests in `tests/`; not part of the public interface.
#[doc(hidden)]
pub mod inner {
    pub use super::points::read;
    pub use super::units::CallUnits;
}

/// Solves contact problems from the shape of an indenter, with formulas and numbers.
///
/// A profile is an expression for the shape f(r), such as r^2/(2*R); any name other than r is a positive parameter.
#[derive(Parser)]
// Examples are commands to copy: they must not wrap, even in a build where another crate enables `wrap_help` of clap.
#[command(name = "sneddon", version, propagate_version = false, after_help = EXAMPLES, term_width = 0)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

const EXAMPLES: &str = "Examples:
  sneddon derive 'r^2/(2*R)'
  sneddon eval 'R-sqrt(R^2-r^2)' --quantity F --at 0.1,0.5 --set R=2

Exit codes: 0 done, 1 a comparison or validation failed or the work is incomplete, 2 bad input (the reason is on stderr).";

#[derive(Subcommand)]
enum Command {
    Derive(derive::Arguments),
    Eval(eval::Arguments),
    Compare(compare::Arguments),
    Invert(invert::Arguments),
    Code(code::Arguments),
    Plot(plot::Arguments),
    Tradeoff(tradeoff::Arguments),
    Kappa(kappa::Arguments),
    Rules(rules::Arguments),
    Solve(solve::Arguments),
    Reference(reference::Arguments),
    Validate(validate::Arguments),
    Scene(scene::Arguments),
    Completions(completions::Arguments),
}

impl Command {
    /// The name of the JSON document that the command writes to stdout, if any.
    fn document(&self) -> Option<&'static str> {
        let (name, is_document) = match self {
            Self::Derive(own) => ("derive", own.output.is_document()),
            Self::Invert(own) => ("invert", own.output.is_document()),
            Self::Eval(own) => ("eval", own.output.is_document()),
            Self::Compare(own) => ("compare", own.output.is_document()),
            Self::Solve(own) => ("solve", own.output.is_document()),
            Self::Reference(own) => ("reference", own.output.is_document()),
            Self::Validate(own) => ("validate", own.output.is_document()),
            _ => return None,
        };
        is_document.then_some(name)
    }
}

/// The outcome of a command that ran to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Outcome {
    Done,
    /// A comparison exceeded its tolerance.
    Failed,
}

/// Runs the program on the arguments of the process.
pub fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            if error.use_stderr() && error.kind() != clap::error::ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
                failure::report_usage(&error);
            } else {
                // An error while writing the help cannot be reported.
                let _ = error.print();
            }
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    file::answer_interrupts();
    let document = arguments.command.document();
    let outcome = match arguments.command {
        Command::Derive(own) => own.budget.run(|| derive::run(&own)),
        Command::Eval(own) => own.budget.run(|| eval::run(&own)),
        Command::Compare(own) => own.budget.run(|| compare::run(&own)),
        Command::Invert(own) => own.budget.run(|| invert::run(&own)),
        Command::Code(own) => own.budget.run(|| code::run(&own)),
        Command::Plot(own) => own.budget.run(|| plot::run(&own)),
        Command::Tradeoff(own) => tradeoff::run(&own),
        Command::Kappa(own) => kappa::run(&own),
        Command::Rules(own) => rules::run(&own),
        Command::Solve(own) => own.budget.run(|| solve::run(&own)),
        Command::Reference(own) => own.budget.run(|| reference::run(&own)),
        Command::Validate(own) => own.budget.run(|| validate::run(&own)),
        Command::Scene(own) => scene::run(&own),
        Command::Completions(own) => completions::run(&own),
    };
    match outcome {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::Failed) => ExitCode::from(1),
        Err(failure) => {
            failure.report();
            let Some(schema) = document.filter(|_| failure.is_incomplete()) else {
                return ExitCode::from(if failure.is_incomplete() { 1 } else { 2 });
            };
            // If stdout is closed, nothing more can be reported.
            let _ = output::print(|out| report::json::unfinished(schema, &failure.message(), out));
            ExitCode::from(1)
        }
    }
}
