//! `sneddon completions`: tab completion for a shell.

use super::{Failure, Outcome, output};
use clap::CommandFactory;

/// Writes the completion script of a shell.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// The shell.
    #[arg(value_enum)]
    shell: clap_complete::Shell,
}

const EXAMPLES: &str = "Examples:
  sneddon completions bash";

pub(super) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut super::Arguments::command(), "sneddon", &mut script);
    output::print(|out| out.write_all(&script))?;
    Ok(Outcome::Done)
}
