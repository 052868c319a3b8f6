//! `sneddon completions`: tab completion for a shell.

use crate::cli::{Failure, Outcome, output};
use clap::CommandFactory;

/// Prints a tab-completion script for a shell.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    /// Name of the shell.
    #[arg(value_enum)]
    shell: clap_complete::Shell,
}

const EXAMPLES: &str = "Examples:
  sneddon completions bash";

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut crate::cli::Arguments::command(), "sneddon", &mut script);
    output::print(|out| out.write_all(&script))?;
    Ok(Outcome::Done)
}
