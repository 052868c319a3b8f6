//! `sneddon invert`: finds the profile with a given equivalent profile or pressure.

use crate::cli::output::OutputArguments;
use crate::cli::typesetting::{Format, Steps, TypesettingArguments};
use crate::cli::units::CallUnits;
use crate::cli::{Failure, Outcome, budget, input, points};
use crate::contact::{ContactError, each_point, inverse_steps, short_inverse_steps, with_reasons};
use crate::expr::{Bindings, Expr, Formula};
use crate::parse;
use crate::report::page::Page;
use crate::report::{Inversion, Wanted, inversion};
use crate::scene::Dimension;
use crate::transform::{self, Inverse, InverseNumbers, Method, TransformError};

/// Finds the shape f(r) from an equivalent profile g(x) or from a pressure p(r).
///
/// g is an expression in x with the same grammar as profiles. If f has no closed form, it is printed as an integral; --at computes values.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    /// Equivalent profile g(x), such as x^2/R; - reads it from stdin.
    #[arg(value_name = "G", allow_hyphen_values = true, required_unless_present = "pressure")]
    equivalent: Option<String>,
    /// Pressure p(r) in a contact of radius a, instead of G; E is the effective modulus.
    #[arg(long, value_name = "P", conflicts_with = "equivalent", allow_hyphen_values = true)]
    pressure: Option<String>,
    /// Sets the value of a parameter; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Radii at which f is computed: 0.1,0.5 or start:stop:count or log:start:stop:count.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    at: Option<String>,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArguments<Format>,
    #[command(flatten)]
    typesetting: TypesettingArguments,
    /// Shows the derivation of f from g, step by step; --steps=full adds all intermediate steps.
    #[arg(long, value_name = "FORM", value_enum, num_args = 0..=1, require_equals = true, default_missing_value = "short")]
    steps: Option<Steps>,
    #[command(flatten)]
    pub(in crate::cli) budget: budget::BudgetArguments,
}

const EXAMPLES: &str = "Examples:
  sneddon invert 'x*atanh(x/R)'
  sneddon invert 'C*x^n' --format latex
  sneddon invert 'ln(1+x^4/w^4)' --set w=2 --at 0.5,1,2
  sneddon invert --pressure 'p_0*sqrt(1-r^2/a^2)'";

/// Relative tolerance of the values.
const TOLERANCE: f64 = 1e-13;

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let answer = arguments.output.destination()?;
    let units = CallUnits::of(&arguments.set, &[arguments.at.as_deref()], None);
    units.tell();
    let at = arguments.at.as_deref().map(|list| points::read(list, &units, Dimension::LENGTH)).transpose()?.unwrap_or_default();
    let style = arguments.typesetting.style(answer.format().page())?;
    let asked = Asked::read(arguments)?;
    let settings = input::Settings::read(&arguments.set, &asked.typed, &units)?;
    if !at.is_empty() {
        settings.demand_all(&asked.typed)?;
    }
    let (equivalent, found) = asked.solved(&settings.exact())?;
    let mut readings = Vec::new();
    if !at.is_empty() {
        let (_, bound) = asked.solved(&settings.rounded()).or_else(|_| asked.solved(&settings.exact()))?;
        let numbers = InverseNumbers::new(&bound, &Bindings::default(), Method::Auto, TOLERANCE).map_err(|error| asked.failure(&error))?;
        let of_block = |block: &[f64]| block.iter().map(|r| numbers.value(*r).map(Ok).map_err(ContactError::from)).collect();
        readings = with_reasons(each_point(&at, usize::MAX, of_block)).map_err(|error| match error {
            ContactError::Transform(error) => asked.failure(&error),
            other => Failure::new(other.to_string()),
        })?;
    }
    let pressure = asked.pressure.as_ref().map(|own| {
        let set = settings.exact();
        [&own.0, &own.1.depth, &own.1.force].map(|expr| set.apply(expr))
    });
    let presentation = arguments.typesetting.presentation(&equivalent, None)?;
    let check = budget::part(|| transform::check_inverse(&found));
    let record = Inversion {
        pressure: pressure.as_ref().map(|[pressure, depth, force]| Wanted { pressure, depth, force }),
        equivalent: &equivalent,
        profile: found.profile(),
        at_axis: found.at_axis(),
        conditions: found.conditions.clone(),
        check,
        at,
        readings,
    };
    let steps = arguments.steps.map(|own| match own {
        Steps::Short => short_inverse_steps(&equivalent, &record.profile, record.at_axis),
        Steps::Full => inverse_steps(&equivalent, &record.profile, record.at_axis),
    });
    answer.write(|format, out| {
        let Some(page) = format.page() else {
            return inversion::json(&record, steps.as_deref(), &presentation, out);
        };
        let whole = match &steps {
            None => Page::of_inversion(&record, &presentation),
            Some(steps) => Page::of_inverse_steps(&record, steps, &presentation),
        };
        whole.write(page, style, out)?;
        if matches!(format, Format::Text | Format::Unicode) { inversion::readings(&record, out) } else { Ok(()) }
    })?;
    points::warn_of_missing_values(&record.readings);
    let outcome = budget::judged(&record.check);
    Ok(if record.why().is_some() { Outcome::Failed } else { outcome })
}

/// The requested inversion: of g as typed, or of the g that belongs to a pressure.
struct Asked {
    place: &'static str,
    typed: input::Typed,
    equivalent: Formula,
    pressure: Option<(Expr, transform::FromPressure)>,
}

impl Asked {
    fn read(arguments: &Arguments) -> Result<Self, Failure> {
        if let Some(argument) = &arguments.pressure {
            let pressure = parse::pressure(argument).map_err(|error| Failure::parse("--pressure", argument, &error))?;
            let typed = input::Typed { text: argument.clone(), formula: Formula::Closed(pressure.clone()) };
            let found = transform::equivalent_of_pressure(&pressure)
                .map_err(|error| Failure::new(error.to_string()).at("--pressure", argument, 0..argument.len()))?;
            let equivalent = Formula::Closed(found.equivalent.clone());
            return Ok(Self { place: "--pressure", typed, equivalent, pressure: Some((pressure, found)) });
        }
        let text = input::text(arguments.equivalent.as_deref().unwrap_or_default())?;
        let formula = parse::equivalent(&text).map_err(|error| Failure::parse("G", &text, &error))?;
        Ok(Self { place: "G", equivalent: formula.clone(), typed: input::Typed { text, formula }, pressure: None })
    }

    /// Returns g with the given parameter values, and f.
    fn solved(&self, values: &Bindings) -> Result<(Formula, Inverse), Failure> {
        let equivalent = self.equivalent.substitute(values);
        let found = transform::invert(&equivalent, |text| parse::formula(text).ok()).map_err(|error| self.failure(&error))?;
        Ok((equivalent, found))
    }

    /// Converts an error about f(r) to a failure about g(x).
    fn failure(&self, error: &TransformError) -> Failure {
        match inversion::refusal(error, |text| parse::formula(text).ok()) {
            Some(message) => Failure::new(message).at(self.place, &self.typed.text, 0..self.typed.text.len()),
            None => Failure::new(error.to_string()),
        }
    }
}
