//! `sneddon plot`: plots of profiles and scenes.

use crate::cli::commands::solve::read;
use crate::cli::failure::warn;
use crate::cli::output::{Endings, OutputArguments, OutputFormat};
use crate::cli::quantities::{Quantities, demand};
use crate::cli::units::CallUnits;
use crate::cli::{Failure, Outcome, budget, input, tip};
use crate::contact::{ContactError, Kind, Quantity};
use crate::expr::Bindings;
use crate::report::picture::{Picture, Pictured};
use crate::scene::{self, Control, Dimension, Loads, Run, Scene, SceneError};
use crate::transform::{Evaluator, Method, Solution, TransformError, derive, reach};
use clap::builder::{PossibleValue, TypedValueParser};
use clap::{Arg, Command, ValueEnum};
use std::ffi::OsStr;
use std::path::Path;

/// Plots quantities against depth, and fields against radius at the largest load.
///
/// All parameters of a profile need a value; its contact radius runs from 0 to --radius.
/// The load of a scene runs from 0 to its largest value. Several profiles or scenes share the same axes.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    /// Shapes f(r), or scene files with the extension .toml; put -- before a shape that begins with a minus sign.
    #[arg(value_name = "PROFILE|SCENE", required = true)]
    subjects: Vec<String>,
    /// Quantities to draw, separated by commas [default: F,a,p].
    #[arg(long, value_parser = Drawings, value_delimiter = ',', value_name = "LIST")]
    quantity: Vec<Pictured>,
    /// Sets the value of a parameter, with or without a unit; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Largest contact radius of a profile [default: close to the end of the profile, else beyond its last kink, else 3, or less where the
    /// profile is steep].
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    radius: Option<String>,
    /// Effective modulus E* of a profile.
    #[arg(long, value_name = "VALUE", default_value = "1", allow_hyphen_values = true)]
    effective_modulus: String,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArguments<Format>,
    #[command(flatten)]
    pub(in crate::cli) budget: budget::BudgetArguments,
}

const EXAMPLES: &str = "Examples:
  sneddon plot 'r^2/(2*R)' --set R=2 --radius 0.5
  sneddon plot 'R-sqrt(R^2-r^2)' 'r^2/(2*R)' --set R=1 --quantity F,p --radius 0.8";

/// Number of loads in a plot.
const LOADS: usize = 61;
/// Work allowed for each value in a plot.
const STEPS_PER_VALUE: u64 = 100_000;

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(in crate::cli) enum Format {
    Svg,
    Png,
    Text,
}

impl OutputFormat for Format {
    const ENDINGS: &'static Endings<Self> = &[("svg", Self::Svg), ("png", Self::Png), ("txt", Self::Text)];
    const USUAL: Self = Self::Text;
}

/// Parses the key of a quantity, or `section`.
#[derive(Clone)]
struct Drawings;

const SECTION: &str = "section";

impl TypedValueParser for Drawings {
    type Value = Pictured;

    fn parse_ref(&self, command: &Command, argument: Option<&Arg>, value: &OsStr) -> Result<Pictured, clap::Error> {
        if value == SECTION {
            return Ok(Pictured::Section);
        }
        Quantities(drawn).parse_ref(command, argument, value).map(Pictured::Quantity)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let section = PossibleValue::new(SECTION).help("the tip in the deformed surface");
        let known: Vec<PossibleValue> = Quantities(drawn).possible_values().into_iter().flatten().collect();
        Some(Box::new(known.into_iter().chain([section])))
    }
}

fn is_scene(subject: &str) -> bool {
    subject.ends_with(".toml")
}

/// Checks whether `plot` supports a quantity.
fn drawn(quantity: Quantity) -> Result<(), &'static str> {
    if quantity.kind() == Kind::Inverse { Err("plot draws quantities against depth; expected F, a or d") } else { Ok(()) }
}

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let answer = arguments.output.destination()?;
    let usual = [Quantity::Force, Quantity::Radius, Quantity::Pressure].map(Pictured::Quantity);
    let quantities: &[Pictured] = if arguments.quantity.is_empty() { &usual } else { &arguments.quantity };
    for own in quantities {
        if let Pictured::Quantity(own) = own {
            demand(&[*own], drawn)?;
        }
    }
    for item in &arguments.set {
        if !arguments.subjects.iter().any(|own| input::is_about(item, own)) {
            let name = item.split_once('=').map_or(item.as_str(), |(name, _)| name);
            return Err(Failure::new(format!("none of the profiles has a parameter {}", name.trim()))
                .help("set a parameter of one of the profiles with --set NAME=VALUE, such as --set R=2"));
        }
    }
    if arguments.subjects.iter().all(|own| is_scene(own)) && (arguments.radius.is_some() || arguments.effective_modulus != "1") {
        warn("--radius and --effective-modulus are not used: scenes have their own loads and materials");
    }
    let data = Pictured::data(quantities);
    let subjects = arguments.subjects.iter().map(|own| Subject::read(arguments, own, &data)).collect::<Result<Vec<_>, _>>()?;
    if subjects.iter().any(|own| !own.has_same_units(subjects.first())) {
        return Err(Failure::new("the results have different units and cannot share axes")
            .help("give every profile the same units, and request them in [outputs] of each scene"));
    }
    budget::allow((subjects.len() * quantities.len() * LOADS) as u64, STEPS_PER_VALUE);
    let runs = subjects.iter().map(Subject::run).collect::<Result<Vec<_>, _>>()?;
    let is_alone = subjects.len() == 1;
    let named: Vec<(&str, &Run<'_>)> =
        subjects.iter().zip(&runs).map(|(own, run)| (if is_alone { "" } else { own.name.as_str() }, run)).collect();
    let picture = Picture::of_contacts(&named, quantities);
    if let Some(why) = runs.iter().find_map(Run::cut_short).filter(|_| picture.is_empty()) {
        warn(why);
        return Ok(Outcome::Failed);
    }
    if picture.is_empty() {
        return Err(Failure::new("nothing to draw: no load has a valid contact").help("run sneddon solve for the reasons"));
    }
    let drawn = match answer.format() {
        Format::Svg => picture.svg().map(String::into_bytes),
        Format::Png => picture.png(),
        Format::Text => Ok(picture.text().into_bytes()),
    };
    let drawn = drawn.map_err(Failure::new)?;
    answer.write(|_, out| out.write_all(&drawn))?;
    if let Some(why) = runs.iter().find_map(Run::cut_short) {
        warn(why);
        return Ok(Outcome::Failed);
    }
    Ok(Outcome::Done)
}

/// A profile or a scene, with its transform.
struct Subject {
    name: String,
    scene: Scene,
    solution: Solution,
    /// The text of the scene file, for error messages.
    text: Option<String>,
}

impl Subject {
    fn read(arguments: &Arguments, subject: &str, data: &[Quantity]) -> Result<Self, Failure> {
        if is_scene(subject) { Self::of_scene(Path::new(subject), data) } else { Self::of_profile(arguments, subject, data) }
    }

    fn of_scene(path: &Path, data: &[Quantity]) -> Result<Self, Failure> {
        let text = read(path)?;
        let name = path.display().to_string();
        let failed = |error: SceneError| Failure::scene(&name, &text, &error);
        let scene = scene::scene(&text).map_err(failed)?;
        let scene = tip::with_points(scene, path, failed)?.swept(LOADS, data);
        let solution = scene.solution().map_err(failed)?;
        let name = path.file_stem().map_or(name.clone(), |stem| stem.to_string_lossy().into_owned());
        Ok(Self { name, scene, solution, text: Some(text) })
    }

    fn of_profile(arguments: &Arguments, text: &str, data: &[Quantity]) -> Result<Self, Failure> {
        let units = CallUnits::of(&arguments.set, &[arguments.radius.as_deref()], Some(&arguments.effective_modulus));
        let effective_modulus = units.modulus("--effective-modulus", &arguments.effective_modulus)?;
        let radius = arguments.radius.as_deref().map(|own| units.positive_length("--radius", own)).transpose()?;
        let (typed, settings) = input::one_profile(text, &arguments.set, &units)?;
        settings.demand_all(&typed)?;
        let failed = |error: ContactError| Failure::profile(&typed.text, &error);
        let profile = settings.bound_profile(&typed)?;
        if profile.is_flat() {
            return Err(Failure::profile(&typed.text, &TransformError::Flat.into())
                .help("plot a punch from a scene: create one with `sneddon scene new flat`"));
        }
        let solution = derive(&profile).map_err(|error| failed(error.into()))?;
        solution.warnings().iter().for_each(|own| warn(own));
        let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).map_err(|error| failed(error.into()))?;
        if let Some(radius) = radius {
            evaluator.check_domain("a", radius).map_err(|error| failed(error.into()))?;
        }
        let largest = radius.unwrap_or_else(|| reach(&evaluator));
        let scene = Scene { control: Control::ContactRadius, loads: Loads::List(vec![largest]), effective_modulus, ..Scene::of(profile) };
        let named = [Dimension::LENGTH, Dimension::FORCE, Dimension::PRESSURE].map(|own| units.name(own));
        let scene = Scene { system: scene::System::counted(named), ..scene }.swept(LOADS, data);
        Ok(Self { name: typed.text, scene, solution, text: None })
    }

    fn run(&self) -> Result<Run<'_>, Failure> {
        Run::new(&self.scene, &self.solution).map(Run::without_details).map_err(|error| match &self.text {
            Some(text) => Failure::scene(&self.name, text, &error),
            None => {
                let own = Failure::new(error.to_string());
                match error.accepted() {
                    Some(help) => own.help(help),
                    None => own,
                }
            }
        })
    }

    fn has_same_units(&self, other: Option<&Self>) -> bool {
        let names =
            |own: &Self| [Dimension::LENGTH, Dimension::FORCE, Dimension::PRESSURE].map(|dimension| own.scene.system.unit_name(dimension));
        other.is_none_or(|other| names(self) == names(other))
    }
}
