//! `sneddon scene`: creates scene files.

use crate::cli::{Failure, Outcome, input, output};
use crate::scene::SHAPES;
use crate::scene::template;
use clap::Subcommand;

/// Creates scene files to edit and solve.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Prints a commented scene file for a named shape.
    #[command(after_help = EXAMPLES)]
    New {
        /// Name of the shape, such as sphere; without it all shapes are listed.
        #[arg(value_name = "SHAPE")]
        shape: Option<String>,
    },
}

const EXAMPLES: &str = "Examples:
  sneddon scene new
  sneddon scene new cone > cone.toml";

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let Command::New { shape: name } = &arguments.command;
    let Some(name) = name else {
        output::print(|out| {
            SHAPES.iter().try_for_each(|shape| {
                let f = shape.ways.first().map_or("", |way| way.f);
                writeln!(out, "{:<30} {}\n{:<30} f(r) = {f}\n{:<30} {}", shape.name, shape.title, "", "", shape.source)
            })
        })?;
        return Ok(Outcome::Done);
    };
    let shape = input::shape(name)?;
    output::print(|out| out.write_all(template(shape).as_bytes()))?;
    Ok(Outcome::Done)
}
