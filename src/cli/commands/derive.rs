//! `sneddon derive`: closed forms of a profile.

use crate::cli::failure::warn;
use crate::cli::output::OutputArguments;
use crate::cli::quantities::{Quantities, demand};
use crate::cli::typesetting::{Format, Steps, TypesettingArguments};
use crate::cli::{Failure, Outcome, budget, input};
use crate::contact::{ContactError, Edge, Quantity, relations, rim_radius, short_steps, steps};
use crate::expr::{Bindings, Expr, Sign, sign};
use crate::report::page::Page;
use crate::report::{self, Derivation};
use crate::transform;

/// Derives closed forms of g, d, F, p and k and, where they exist, of a(d) and F(d).
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    #[command(flatten)]
    profile: input::ProfileArguments,
    /// Depth of a punch whose rim is at the contact radius: a number, or the symbol d.
    #[arg(long, value_name = "D", allow_hyphen_values = true)]
    depth: Option<String>,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArguments<Format>,
    #[command(flatten)]
    typesetting: TypesettingArguments,
    /// Shows the derivation of every result from f, step by step; --steps=full adds all intermediate steps.
    #[arg(long, value_name = "FORM", value_enum, num_args = 0..=1, require_equals = true, default_missing_value = "short")]
    steps: Option<Steps>,
    /// Quantities to derive, separated by commas; `a` is a(d).
    #[arg(long, value_parser = Quantities(has_formula), value_delimiter = ',', value_name = "LIST")]
    quantity: Vec<Quantity>,
    #[command(flatten)]
    pub(in crate::cli) budget: budget::BudgetArguments,
}

const EXAMPLES: &str = "Examples:
  sneddon derive 'r^2/(2*R)'
  sneddon derive '-h*r^2/c^2' --depth d --format latex
  sneddon derive 'r^2/(2*R)' --quantity F,p --symbols 'E=E_r,d=\\delta'
  sneddon derive 'r^2/(2*R) + r*tan(theta)' --steps
  sneddon derive --shape cone --format latex --standalone
  echo 'R-sqrt(R^2-r^2)' | sneddon derive - --set R=2 --json";

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let answer = arguments.output.destination()?;
    let style = arguments.typesetting.style(answer.format().page())?;
    demand(&arguments.quantity, has_formula)?;
    let units = arguments.profile.units(&[arguments.depth.as_deref()], None);
    units.tell();
    let edge = arguments.depth.as_deref().map(|text| units.depth(text)).transpose()?.map_or(Edge::Smooth, Edge::Rim);
    let (typed, settings) = if edge == Edge::Smooth { arguments.profile.read(&units)? } else { arguments.profile.read_punch(&units)? };
    let shown = typed.formula.substitute(&settings.exact()).substitute(&Bindings::one(rim_radius().name(), Expr::symbol("a")));
    let quantities = if arguments.quantity.is_empty() { &Quantity::USUAL } else { arguments.quantity.as_slice() };
    let presentation = arguments.typesetting.presentation(&shown, arguments.steps.is_none().then_some(quantities))?;
    let failed = |error: ContactError| Failure::profile(&typed.text, &error);
    let profile = settings.exact_profile(&typed).map_err(|error| failed(error.into()))?;
    let solution = transform::derive(&profile).map_err(|error| failed(error.into()))?;
    solution.warnings().iter().for_each(|text| warn(text));
    let mut relations = relations(&solution, &edge).map_err(failed)?;
    let check = budget::part(|| transform::check(&solution));
    check.iter().for_each(|check| relations.confirm(check));
    // With a rim the depth may keep the pressure positive.
    if edge == Edge::Smooth && relations.g.formula.as_closed().is_some_and(|g| sign(g) == Sign::Negative) {
        warn("g is negative: no valid contact with a smooth edge; the formulas follow");
    }
    let steps = match arguments.steps {
        None => None,
        Some(Steps::Short) => Some(short_steps(&shown, &solution, &edge, &relations)),
        Some(Steps::Full) => Some(steps(&shown, &solution, &edge, &relations)),
    };
    let steps = steps.transpose().map_err(|error| failed(error.into()))?;
    let record = Derivation {
        solution: &solution,
        typed: &shown,
        edge: &edge,
        relations: &relations,
        asked: &arguments.quantity,
        presentation: &presentation,
        check,
    };
    answer.write(|format, out| match (format.page(), &steps) {
        (None, steps) => report::json::derivation(&record, steps.as_deref(), out),
        (Some(format), None) => Page::of_derivation(&record).write(format, style, out),
        (Some(format), Some(steps)) => Page::of_steps(&record, steps).write(format, style, out),
    })?;
    Ok(budget::judged(&record.check))
}

/// Checks whether `derive` supports a quantity.
fn has_formula(quantity: Quantity) -> Result<(), &'static str> {
    match quantity.coordinate() {
        _ if quantity.has_formula() => Ok(()),
        "F" => Err("derive has no formulas in terms of the force; use eval for values"),
        _ => Err("derive has no formula for it; use eval for values"),
    }
}
