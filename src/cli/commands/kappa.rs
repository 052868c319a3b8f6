//! `sneddon kappa`: the constants of power-law profiles.

use crate::cli::output::{OutputArguments, Tabular};
use crate::cli::precision::PrecisionArguments;
use crate::cli::units::CallUnits;
use crate::cli::{Failure, Outcome, points};
use crate::eval::constant_value;
use crate::expr::{Bindings, Expr, Node, Number};
use crate::num::Estimate;
use crate::report::power_constants::{self, PowerConstant};
use crate::scene::Dimension;
use crate::transform::rules::kappa;

/// Tabulates the constants of power-law profiles: f(r) = C*r^n has g(x) = kappa_n*C*x^n.
///
/// kappa_n = sqrt(pi)*gamma(n/2 + 1)/gamma(n/2 + 1/2), with kappa_1 = pi/2 and kappa_2 = 2.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    /// Exponents n, at least 0: 1,1.5,2 or start:stop:count or log:start:stop:count.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    at: String,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArguments<Tabular>,
    #[command(flatten)]
    precision: PrecisionArguments,
}

const EXAMPLES: &str = "Examples:
  sneddon kappa --at 0.5:4:8
  sneddon kappa --at 1,1.5,2,3 --json";

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let answer = arguments.output.destination()?;
    let digits = arguments.precision.digits(answer.format() != Tabular::Json)?;
    let exponents = points::read(&arguments.at, &CallUnits::of(&[], &[], None), Dimension::NONE)?;
    let constant = |n: f64| {
        let unknown = || Failure::new(format!("kappa_n has no value at n = {n:?}"));
        let form = kappa(&Expr::number(Number::from_f64(n).ok_or_else(unknown)?));
        let value = constant_value(&form, &Bindings::default()).map_err(|_| unknown())?;
        let exact = Some(form).filter(|form| !matches!(form.node(), Node::Function(..)));
        Ok(PowerConstant { exponent: n, value: digits.of(Estimate::from_bounded(value, 0)), exact })
    };
    let list = exponents.into_iter().map(constant).collect::<Result<Vec<_>, Failure>>()?;
    answer.write(|format, out| match format {
        Tabular::Json => power_constants::as_json(&list, out),
        Tabular::Csv => power_constants::as_csv(&list, out),
        Tabular::Text => power_constants::as_text(&list, out),
    })?;
    Ok(Outcome::Done)
}
