//! `sneddon solve`: computes the quantities that a scene file requests.

use crate::cli::failure::warn;
use crate::cli::output::{Endings, OutputArguments, OutputFormat};
use crate::cli::precision::PrecisionArguments;
use crate::cli::progress::Progress;
use crate::cli::typesetting::PageArguments;
use crate::cli::{Failure, Outcome, budget, tip};
use crate::contact::{Edge, Quantity, Relations, Step, relations, steps};
use crate::expr::{Expr, Formula};
use crate::print::Presentation;
use crate::report::page::{self, Page};
use crate::report::picture::Pictured;
use crate::report::solved::html;
use crate::report::solved::html::Sheet;
use crate::report::solved::{json as solved_json, npz as solved_npz, text as solved_text};
use crate::report::{Derivation, Digits, Unchecked, Verdict};
use crate::scene::{self, Run, Scene, SceneError};
use crate::transform::{self, Check, Profile, Solution};
use clap::ValueEnum;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Solves a contact scene: computes depth, force, contact radius and fields for given loads.
///
/// The scene file defines the shape, the materials, the loads and the requested quantities; `sneddon scene new SHAPE` creates one.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    /// Scene file; - reads it from stdin.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArguments<Format>,
    #[command(flatten)]
    precision: PrecisionArguments,
    #[command(flatten)]
    pub(in crate::cli) budget: budget::BudgetArguments,
    #[command(flatten)]
    page: PageArguments,
    /// Shows the values of invalid rows as well, next to the reason.
    #[arg(long)]
    force: bool,
    /// Writes dimensionless results d/R, F/(E* R^2) and p/E*, where R is the radius of the profile or of its vertical side.
    #[arg(long)]
    dimensionless: bool,
}

const EXAMPLES: &str = "Examples:
  sneddon scene new sphere > sphere.toml
  sneddon solve sphere.toml
  sneddon solve sphere.toml -o sphere.json
  sneddon solve sphere.toml -o report.html

Exit codes: 0 done, 1 a row is not valid, 2 bad input (the reason is on stderr).";

/// Work allowed for each row and each point of a curve.
const STEPS_PER_ROW: u64 = 1_000_000;

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(in crate::cli) enum Format {
    Text,
    Unicode,
    Latex,
    Markdown,
    Typst,
    Mathml,
    Html,
    Csv,
    Json,
    Npz,
}

impl OutputFormat for Format {
    const ENDINGS: &'static Endings<Self> = &[
        ("txt", Self::Text),
        ("csv", Self::Csv),
        ("json", Self::Json),
        ("npz", Self::Npz),
        ("tex", Self::Latex),
        ("md", Self::Markdown),
        ("typ", Self::Typst),
        ("html", Self::Html),
    ];
    const USUAL: Self = Self::Text;
    const PAGE: Option<(&'static str, &'static str)> = Some(("html", "a page with plots and formulas"));
}

impl Format {
    /// Returns the format of a page of formulas and tables; `None` for data and for the page with plots.
    fn page(self) -> Option<page::Format> {
        Some(match self {
            Self::Unicode => page::Format::Unicode,
            Self::Latex => page::Format::Latex,
            Self::Markdown => page::Format::Markdown,
            Self::Typst => page::Format::Typst,
            Self::Mathml => page::Format::Mathml,
            Self::Text | Self::Html | Self::Csv | Self::Json | Self::Npz => return None,
        })
    }
}

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let answer = arguments.output.destination()?;
    let format = answer.format();
    let digits = arguments.precision.digits(format.page().is_some() || matches!(format, Format::Text | Format::Csv))?;
    let style = arguments.page.style(format.page())?;
    let text = read(&arguments.scene)?;
    let name = arguments.scene.display().to_string();
    let failed = |error: SceneError| Failure::scene(&name, &text, &error);
    let mut scene = scene::scene(&text).map_err(failed)?;
    if arguments.dimensionless {
        scene = scene.dimensionless().map_err(failed)?;
    }
    let scene = tip::with_points(scene, &arguments.scene, failed)?;
    let solution = scene.solution().map_err(failed)?;
    solution.warnings().iter().for_each(|text| warn(text));
    let run = Run::new(&scene, &solution).map_err(failed)?;
    let progress = Progress::new(run.steps(), answer.is_stdout());
    budget::allow(run.steps(), STEPS_PER_ROW);
    let run = run.watched(|| progress.step());
    let (mut verdict, mut unchecked) = (Verdict::default(), None);
    answer.write(|format, out| {
        verdict = match format {
            Format::Json => solved_json::solved(&run, arguments.force, out)?,
            Format::Csv => solved_text::csv(&run, arguments.force, digits, out)?,
            Format::Npz => solved_npz::npz(&run, arguments.force, out)?,
            Format::Text => solved_text::table(&run, arguments.force, digits, out)?,
            Format::Html => {
                let (own, why) = with_plots(&file_name(&arguments.scene), &text, &run, arguments.force, out)?;
                unchecked = why;
                own
            }
            Format::Unicode | Format::Latex | Format::Markdown | Format::Typst | Format::Mathml => {
                let formulas = Formulas::of(&solution, &scene);
                let asked: Vec<Quantity> =
                    scene.outputs.data.iter().chain(&scene.outputs.curves).copied().filter(|own| own.has_formula()).collect();
                let record = formulas.as_ref().map(|own| own.record(&asked));
                let digits = if arguments.precision.is_given() { digits } else { Digits::significant(SHOWN).unwrap_or_default() };
                let (page, verdict) = Page::of_scene(&run, record.as_ref(), arguments.force, digits);
                format.page().map_or(Ok(()), |format| page.write(format, style, out))?;
                unchecked = formulas.as_ref().and_then(|own| Unchecked::why(&own.check));
                verdict
            }
        };
        Ok(())
    })?;
    let cut = run.cut_short();
    drop(run);
    drop(progress);
    if let Some(why) = cut {
        warn(&format!("some numbers are missing: {why}"));
        return Ok(Outcome::Failed);
    }
    if let Some(why) = unchecked {
        warn(why);
        return Ok(Outcome::Failed);
    }
    if verdict.validity() == Some(true) {
        return Ok(Outcome::Done);
    }
    let (invalid, rows) = verdict.counts();
    let first = verdict.findings().iter().find(|(own, _)| own.severity == crate::contact::Severity::Error);
    let verb = if rows == 1 { "row is" } else { "rows are" };
    warn(&format!("{invalid} of {rows} {verb} not valid{}", first.map_or_else(String::new, |(own, _)| format!(": {}", own.message))));
    Ok(Outcome::Failed)
}

/// The digits of the numbers on a page of formulas, unless a number of digits is requested.
const SHOWN: usize = 6;

/// Returns the name of a file without its directories.
fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

/// Number of loads in the plots of a page.
const PICTURED: usize = 41;

/// Writes the HTML page of a solved scene, with the formulas of the profile if it has any.
///
/// Returns the verdict on the rows, and the reason why the check of the formulas or a picture is incomplete.
fn with_plots(
    name: &str,
    text: &str,
    run: &Run<'_>,
    formally: bool,
    out: &mut dyn io::Write,
) -> io::Result<(Verdict, Option<&'static str>)> {
    let scene = run.scene();
    let swept = scene.swept(PICTURED, &Pictured::data(html::pictured(scene)));
    let solution = swept.solution().map_err(io::Error::other)?;
    let pictured = Run::new(&swept, &solution).map_err(io::Error::other)?.without_details();
    let formulas = Formulas::of(&solution, scene);
    let record = formulas.as_ref().map(|own| own.record(&[]));
    let steps = formulas.as_ref().and_then(Formulas::steps);
    let shown = record.as_ref().zip(steps.as_deref());
    let verdict = html::html(&Sheet { text, name, run, swept: &pictured, formulas: shown }, formally, out)?;
    let unchecked = shown.and_then(|(own, _)| Unchecked::why(&own.check));
    Ok((verdict, unchecked.or_else(|| pictured.cut_short())))
}

/// The formulas of the shape of a scene, with its parameters as symbols if possible, and their check.
struct Formulas<'a> {
    /// With numbers for its parameters.
    numeric: &'a Solution,
    symbolic: Option<Solution>,
    typed: Formula,
    edge: Edge,
    relations: Relations,
    presentation: Presentation,
    check: Result<Check, Unchecked>,
}

impl<'a> Formulas<'a> {
    /// Derives the formulas; `None` for measured tips and punches with a non-circular cross-section, which have none.
    fn of(numeric: &'a Solution, scene: &Scene) -> Option<Self> {
        if !scene.round || scene.measured.is_some() {
            return None;
        }
        let edge = if scene.rim.is_some() { Edge::Rim(Expr::symbol("d")) } else { Edge::Smooth };
        let symbolic = scene.symbolic.as_ref().and_then(|typed| {
            let own = transform::derive(&Profile::new(typed).ok()?).ok()?;
            Some((relations(&own, &edge).ok()?, own, typed.clone()))
        });
        let (mut relations, symbolic, typed) = match symbolic {
            Some((relations, own, typed)) => (relations, Some(own), typed),
            None => (relations(numeric, &edge).ok()?, None, scene.profile.typed.clone()),
        };
        let check = budget::part(|| transform::check(symbolic.as_ref().unwrap_or(numeric)));
        check.iter().for_each(|check| relations.confirm(check));
        let presentation = Presentation::of(&typed);
        Some(Self { numeric, symbolic, typed, edge, relations, presentation, check })
    }

    fn solution(&self) -> &Solution {
        self.symbolic.as_ref().unwrap_or(self.numeric)
    }

    /// The record of these quantities; of the usual ones for an empty list.
    fn record<'b>(&'b self, asked: &'b [Quantity]) -> Derivation<'b> {
        Derivation {
            solution: self.solution(),
            typed: &self.typed,
            edge: &self.edge,
            relations: &self.relations,
            asked,
            presentation: &self.presentation,
            check: self.check.clone(),
        }
    }

    fn steps(&self) -> Option<Vec<Step>> {
        steps(&self.typed, self.solution(), &self.edge, &self.relations).ok()
    }
}

pub(in crate::cli) fn read(path: &Path) -> Result<String, Failure> {
    let name = path.display();
    let limit = scene::LONGEST as u64;
    let mut bytes = Vec::new();
    let done = if path.as_os_str() == "-" {
        io::stdin().lock().take(limit + 1).read_to_end(&mut bytes)
    } else {
        File::open(path).and_then(|file| file.take(limit + 1).read_to_end(&mut bytes))
    };
    done.map_err(|error| {
        Failure::new(format!("cannot read the scene {name}: {error}")).help("create a scene to start from with `sneddon scene new sphere`")
    })?;
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        Failure::new(format!("{name} is not a text file: byte {} is not valid UTF-8", at + 1)).help("expected a scene file in UTF-8")
    })
}
