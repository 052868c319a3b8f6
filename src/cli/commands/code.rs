//! `sneddon code`: closed forms as source code in another language.

use crate::cli::failure::warn;
use crate::cli::output;
use crate::cli::quantities::{Quantities, demand};
use crate::cli::{Failure, Outcome, budget, file, input};
use crate::code::{CodeError, Language, NamedShape, QUANTITIES, program, write};
use crate::contact::{ContactError, Quantity};
use crate::expr::Formula;
use crate::scene::{Dimension, SHAPES, Way};
use crate::{parse, print, transform};
use clap::ValueEnum;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// Generates source code that evaluates the closed forms g, F, p, d, a(d) and F(d), and states the accuracy of each function.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    #[command(flatten)]
    profile: input::ProfileArguments,
    /// Quantities, separated by commas: g(x), F(a), p(r, a), d(a), the contact radius a(d), and the force F(d) as F_of_d [default: g,F,d,a].
    #[arg(long, value_name = "LIST", value_parser = Quantities(written), value_delimiter = ',')]
    quantity: Vec<Quantity>,
    /// Language of the generated code; octave is an alias of matlab.
    #[arg(long, value_name = "LANGUAGE", value_enum, ignore_case = true)]
    lang: Lang,
    /// Writes to this file instead of stdout.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) budget: budget::BudgetArguments,
}

const EXAMPLES: &str = "Examples:
  sneddon code 'R-sqrt(R^2-r^2)' --quantity g,F --lang c
  sneddon code 'r*tan(theta)' --quantity F_of_d --lang fortran -o cone.f90
  sneddon code 'r^2/(2*R)' --lang nanite -o model_paraboloid.py";

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Lang {
    C,
    Fortran,
    Python,
    #[value(alias = "octave")]
    Matlab,
    Rust,
    Nanite,
}

impl Lang {
    fn language(self) -> Language {
        match self {
            Self::C => Language::C,
            Self::Fortran => Language::Fortran,
            Self::Python => Language::Python,
            Self::Matlab => Language::Matlab,
            Self::Rust => Language::Rust,
            Self::Nanite => Language::Nanite,
        }
    }
}

/// Work allowed for the claim of each function: its operations are run with their errors at some three hundred points.
const STEPS_PER_FUNCTION: u64 = 200_000_000;

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let target = arguments.output.as_deref().filter(|path| path.as_os_str() != "-").map(file::Target::new).transpose()?;
    if let Some(path) = arguments.output.as_deref()
        && let Some(other) = language_of(path).filter(|own| !own.contains(&arguments.lang))
    {
        let lang = |own: Lang| own.to_possible_value().map_or(String::new(), |own| own.get_name().to_owned());
        let name = other.first().copied().map_or(String::new(), lang);
        let message = format!("{} has the extension of {name}, but the language is {}", path.display(), lang(arguments.lang));
        return Err(Failure::new(message).help("expected another extension or another --lang"));
    }
    if arguments.lang == Lang::Nanite && arguments.quantity.iter().any(|own| *own != Quantity::ForceOfDepth) {
        warn("a nanite model contains F(d) only; other quantities are not written");
    }
    let units = arguments.profile.units(&[], None);
    let length = units.name(Dimension::LENGTH);
    if arguments.lang == Lang::Nanite && !["", "m"].contains(&length.as_str()) {
        let message = format!("a model for nanite is in SI units, but the lengths of --set are in {length}");
        return Err(Failure::new(message).help("expected lengths in metres, such as R=5e-6 or R=\"5e-6 m\""));
    }
    units.tell();
    let (typed, settings) = arguments.profile.read(&units)?;
    let formula = typed.formula.substitute(&settings.exact());
    let shown = print::text(&formula);
    let failed = |error: ContactError| Failure::profile(&typed.text, &error);
    let profile = settings.exact_profile(&typed).map_err(|error| failed(error.into()))?;
    let solution = transform::derive(&profile).map_err(|error| failed(error.into()))?;
    solution.warnings().iter().for_each(|text| warn(text));
    demand(&arguments.quantity, written)?;
    let quantities = quantities(arguments);
    budget::allow(quantities.len() as u64, STEPS_PER_FUNCTION);
    let code = program(&solution, &quantities, arguments.lang.language(), &shown).map_err(|error| match error {
        CodeError::Contact(own) => failed(own),
        CodeError::Transform(own) => failed(own.into()),
        other => Failure::new(other.to_string()).help(other.accepted()),
    })?;
    let code = match named(&formula) {
        Some(shape) => code.named(shape),
        None => code,
    };
    let text = write(&if length.is_empty() { code } else { code.with_length_unit(&length) });
    let write = |out: &mut dyn std::io::Write| out.write_all(text.as_bytes());
    match target {
        Some(target) => target.fill(write)?,
        None => output::print(write)?,
    }
    Ok(Outcome::Done)
}

/// Returns the named shape that a profile is, in the symbols of that shape; a second set of symbols is a part of its name and title.
fn named(formula: &Formula) -> Option<NamedShape> {
    let is_own = |way: &&Way| parse::profile(way.f).is_ok_and(|own| own == *formula);
    let shapes = SHAPES.iter().filter(|shape| shape.rim.is_none());
    let (shape, way) = shapes.flat_map(|shape| shape.ways.iter().map(move |way| (shape, way))).find(|(_, way)| is_own(way))?;
    let is_first = shape.ways.first().is_some_and(|own| std::ptr::eq(own, way));
    let symbols: Vec<&str> = way.parameters.iter().filter(|_| !is_first).map(|own| own.name).collect();
    // The title without its explanation.
    let title = shape.title.split([',', ':', '(']).next().unwrap_or(shape.title).trim();
    Some(NamedShape {
        name: std::iter::once(shape.name).chain(symbols.iter().copied()).collect::<Vec<_>>().join("-"),
        title: if symbols.is_empty() { title.to_owned() } else { format!("{title} with {}", symbols.join(", ")) },
        meanings: way.parameters.iter().map(|own| (own.name.to_owned(), own.meaning.to_owned())).collect(),
    })
}

/// Returns the languages whose files have this extension, or `None` for an extension of none.
fn language_of(path: &Path) -> Option<&'static [Lang]> {
    match path.extension()?.to_str()? {
        "c" | "h" => Some(&[Lang::C]),
        "f90" | "f95" | "f03" | "f08" => Some(&[Lang::Fortran]),
        "py" => Some(&[Lang::Python, Lang::Nanite]),
        "m" => Some(&[Lang::Matlab]),
        "rs" => Some(&[Lang::Rust]),
        _ => None,
    }
}

/// Returns the requested quantities without duplicates; a nanite model always contains F(d).
fn quantities(arguments: &Arguments) -> Vec<Quantity> {
    if arguments.lang == Lang::Nanite {
        return vec![Quantity::ForceOfDepth];
    }
    let mut list: Vec<Quantity> = Vec::new();
    for own in arguments.quantity.iter().copied() {
        if !list.contains(&own) {
            list.push(own);
        }
    }
    if list.is_empty() { vec![Quantity::Equivalent, Quantity::Force, Quantity::Depth, Quantity::Radius] } else { list }
}

/// Checks whether `code` supports a quantity.
fn written(quantity: Quantity) -> Result<(), &'static str> {
    static REASON: LazyLock<String> = LazyLock::new(|| format!("code writes only {}", QUANTITIES.map(Quantity::key).join(", ")));
    if QUANTITIES.contains(&quantity) { Ok(()) } else { Err(&REASON) }
}
