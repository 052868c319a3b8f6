//! `sneddon solve`: computes the quantities that a scene file requests.

use crate::cli::failure::warn;
use crate::cli::output::{Destination, Endings};
use crate::cli::precision::PrecisionArguments;
use crate::cli::progress::Progress;
use crate::cli::{Failure, Outcome, budget, tip};
use crate::contact::{Edge, relations, steps};
use crate::expr::Expr;
use crate::print::Presentation;
use crate::report::picture::Pictured;
use crate::report::solved::html;
use crate::report::solved::html::Sheet;
use crate::report::solved::{json as solved_json, npz as solved_npz, text as solved_text};
use crate::report::{Derivation, Unchecked, Verdict};
use crate::scene::{self, Run, SceneError};
use crate::transform;
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
    /// Writes JSON.
    #[arg(long)]
    pub(in crate::cli) json: bool,
    /// Writes CSV: the rows, an empty line, and the points of the curves; only the points if no other quantity is requested.
    #[arg(long, conflicts_with = "json")]
    csv: bool,
    /// Writes to this file instead of stdout; the extension selects the format: .txt, .csv, .json, .npz, or .html for a page with plots and formulas.
    #[arg(short, long, value_name = "FILE")]
    pub(in crate::cli) output: Option<PathBuf>,
    #[command(flatten)]
    precision: PrecisionArguments,
    #[command(flatten)]
    pub(in crate::cli) budget: budget::BudgetArguments,
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

#[derive(Clone, Copy, PartialEq)]
enum Format {
    Text,
    Csv,
    Json,
    Npz,
    Html,
}

const ENDINGS: &Endings<Format> =
    &[("txt", Format::Text), ("csv", Format::Csv), ("json", Format::Json), ("npz", Format::Npz), ("html", Format::Html)];

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let flag = arguments.json.then_some(Format::Json).or(arguments.csv.then_some(Format::Csv));
    let answer = Destination::choose(arguments.output.as_deref(), flag, Format::Text, ENDINGS)?;
    let digits = arguments.precision.digits(matches!(answer.format(), Format::Text | Format::Csv))?;
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
                let (own, why) = page(&file_name(&arguments.scene), &text, &run, arguments.force, out)?;
                unchecked = why;
                own
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
    warn(&format!("{invalid} of {rows} rows are not valid{}", first.map_or_else(String::new, |(own, _)| format!(": {}", own.message))));
    Ok(Outcome::Failed)
}

/// Returns the name of a file without its directories.
fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

/// Number of loads in the plots of a page.
const PICTURED: usize = 41;

/// Writes the HTML page of a solved scene, with the formulas of the profile if it has any.
///
/// Returns the verdict on the rows, and the reason why the check of the formulas or a picture is incomplete.
fn page(name: &str, text: &str, run: &Run<'_>, formally: bool, out: &mut dyn io::Write) -> io::Result<(Verdict, Option<&'static str>)> {
    let scene = run.scene();
    let swept = scene.swept(PICTURED, &Pictured::data(html::pictured(scene)));
    let solution = swept.solution().map_err(io::Error::other)?;
    let pictured = Run::new(&swept, &solution).map_err(io::Error::other)?.without_details();
    let edge = if scene.rim.is_some() { Edge::Rim(Expr::symbol("d")) } else { Edge::Smooth };
    let typed = scene.profile.typed.clone();
    // Measured tips and punches with a non-circular cross-section have no formulas.
    let mut found = relations(&solution, &edge).ok().filter(|_| scene.round && scene.measured.is_none());
    let check = found.as_mut().map(|relations| {
        let check = budget::part(|| transform::check(&solution));
        check.iter().for_each(|check| relations.confirm(check));
        check
    });
    let steps = found.as_ref().and_then(|found| steps(&typed, &solution, &edge, found).ok());
    let presentation = Presentation::of(&typed);
    let record = found.as_ref().zip(check).map(|(relations, check)| Derivation {
        profile: &scene.profile,
        typed: &typed,
        edge: &edge,
        relations,
        asked: &[],
        presentation: &presentation,
        check,
    });
    let formulas = record.as_ref().zip(steps.as_deref());
    let verdict = html::html(&Sheet { text, name, run, swept: &pictured, formulas }, formally, out)?;
    let unchecked = formulas.and_then(|(own, _)| Unchecked::why(&own.check));
    Ok((verdict, unchecked.or_else(|| pictured.cut_short())))
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
