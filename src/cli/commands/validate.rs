//! `sneddon validate`: checks data of a solver against the exact solution.

use crate::cli::commands::solve;
use crate::cli::failure::warn;
use crate::cli::output;
use crate::cli::output::{Endings, OutputArguments, OutputFormat};
use crate::cli::tip;
use crate::cli::{Failure, Outcome, budget, input};
use crate::report::validation::{html, json, text as screen};
use crate::scene::{Change, Declared, Dimension, Grid, SceneError, scene_for_data};
use crate::validate::{Layout, Origin, Request, Source, ValidationError, validate};
use clap::ValueEnum;
use std::fs::File;
use std::io::{self, Cursor, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Validates data of a contact solver against the exact solution of a scene, and names the most likely cause of an error.
///
/// Files with columns d, F, a contain one load per row; files with r (or x, y) and p, u, f or g contain points under the load of the scene.
/// A column d next to the coordinates separates several loads.
/// Columns are named with their units: d_um,F_mN,a_um or r_m,p_Pa. Several files are treated as several resolutions.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    /// Scene file; [load] is required only for fields.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Data of the solver: CSV, NPY, NPZ, or the output of sneddon reference; coarsest first unless --grid or the data give the resolution.
    #[arg(value_name = "DATA", required = true)]
    data: Vec<PathBuf>,
    /// Relative L2 error to accept, instead of the estimated discretization error.
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    tol: Option<String>,
    /// Number of pixels along a side of the domain, one per file; or the radii of an array of `sneddon reference`, such as "0:2 um:101".
    #[arg(long, value_name = "N,N,…|START:STOP:COUNT", value_delimiter = ',', allow_hyphen_values = true)]
    grid: Vec<String>,
    /// Column or array that contains a quantity, such as p=press or p_GPa=press; unnamed columns and rows are numbered from 1. May be repeated.
    #[arg(long, value_name = "NAME=COLUMN", value_parser = mapped)]
    map: Vec<(String, String)>,
    /// Side of the domain, such as "8 um", instead of the value in [data].
    #[arg(long = "box", value_name = "LENGTH")]
    side: Option<String>,
    /// Load of files with fields, such as d=0.4, F="2 mN" or a=1, instead of the value in [load].
    #[arg(long, value_name = "SYMBOL=VALUE")]
    load: Option<String>,
    /// Position of the axis: in the middle of a box whose coordinates start at a corner (corner) or, for fields without coordinates,
    /// between the middle pixels (centre) or on a pixel (pixel).
    #[arg(long, value_name = "PLACE")]
    origin: Option<OriginChoice>,
    /// Treats pressures as means over pixels, or over rings between radii, as written by `sneddon reference --cells`.
    #[arg(long)]
    cells: bool,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArguments<Format>,
    #[command(flatten)]
    pub(in crate::cli) budget: budget::BudgetArguments,
}

/// [`Origin`] as an argument.
#[derive(Clone, Copy, clap::ValueEnum)]
enum OriginChoice {
    Corner,
    Centre,
    Pixel,
}

fn mapped(text: &str) -> Result<(String, String), String> {
    let found = text.split_once('=').filter(|own| !own.0.trim().is_empty() && !own.1.is_empty());
    found
        .map(|(name, column)| (name.trim().to_owned(), column.to_owned()))
        .ok_or_else(|| "expected NAME=COLUMN, such as p=press".to_owned())
}

const EXAMPLES: &str = "Examples:
  sneddon scene new paraboloid > tip.toml
  sneddon solve tip.toml --csv > rows.csv
  sneddon validate tip.toml rows.csv --json

Exit codes: 0 passed, 1 failed, 2 bad input (the reason is on stderr).";

/// Maximum size of data from a pipe or a device, in bytes.
const LONGEST: u64 = 100_000_000;
/// Work allowed for each byte of a file, including the diagnosis.
const STEPS_PER_BYTE: u64 = 10_000;

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(in crate::cli) enum Format {
    Text,
    Json,
    Html,
}

impl OutputFormat for Format {
    const ENDINGS: &'static Endings<Self> = &[("html", Self::Html), ("htm", Self::Html), ("txt", Self::Text), ("json", Self::Json)];
    const USUAL: Self = Self::Text;
    const PAGE: Option<(&'static str, &'static str)> = Some(("html", "a page with plots"));
    const IS_BESIDE: bool = true;
}

/// Parses the number of pixels of one file.
fn pixels_along_a_side(text: &str) -> Result<f64, Failure> {
    let number = text.trim().parse().ok().filter(|own: &f64| *own >= 1.0 && own.is_finite());
    number.ok_or_else(|| Failure::new(format!("--grid contains {text:?}")).help("expected numbers of pixels, such as 64,128,256"))
}

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let tolerance = arguments.tol.as_deref().map(|text| input::positive("--tol", text)).transpose()?;
    let report = arguments.output.destination()?;
    let text = solve::read(&arguments.scene)?;
    let name = arguments.scene.display().to_string();
    let sources: Vec<Source<'_>> = arguments.data.iter().map(|path| source(path)).collect::<Result<_, _>>()?;
    let failed = |error: SceneError| Failure::scene(&name, &text, &error);
    let scene = scene_for_data(&text, &Change::None).map_err(failed)?;
    let scene = tip::with_points(scene, &arguments.scene, failed)?;
    let mut scene = match &arguments.load {
        Some(text) => scene.under(text).map_err(|error| Failure::argument("--load", text, &error))?,
        None => scene,
    };
    let (radii, pixels): (Vec<&String>, Vec<&String>) = arguments.grid.iter().partition(|own| own.contains(':'));
    for text in &radii {
        if let Grid::Radial(own) = Grid::parse(text, None, false, &scene).map_err(|error| Failure::argument("--grid", text, &error))? {
            scene.outputs.at = own;
        }
    }
    let grid = pixels.into_iter().map(|own| pixels_along_a_side(own)).collect::<Result<Vec<f64>, Failure>>()?;
    if let Some(text) = &arguments.side {
        let side = scene.length("the box", text).map_err(|error| Failure::argument("--box", text, &error))?;
        let data = scene.data.take().unwrap_or_else(Declared::nothing);
        scene.data = Some(Declared { side: Some(side), ..data });
    }
    let side = scene.data.as_ref().and_then(|own| own.side);
    let layout = Layout {
        map: arguments.map.clone(),
        side,
        shown_side: side.map(|own| own * scene.system.out(Dimension::LENGTH)),
        origin: arguments.origin.map(|own| match own {
            OriginChoice::Corner => Origin::Corner,
            OriginChoice::Centre => Origin::Centre,
            OriginChoice::Pixel => Origin::Pixel,
        }),
        radii: !radii.is_empty(),
        cells: arguments.cells.then_some(true),
    };
    let layout = layout.checked().map_err(|error| failure(&name, &text, &error))?;
    let request = Request { layout: &layout, text: &text, scene: &scene, sources: &sources, tolerance, grid: &grid };
    let found = validate(&request).map_err(|error| failure(&name, &text, &error))?;
    found.warnings.iter().for_each(|text| warn(text));
    let has_field = found.columns.iter().any(|own| matches!(own.name, "p" | "u" | "f" | "g" | "F_from_p"));
    if arguments.load.is_some() && !has_field {
        warn("--load is not used: the data contain the loads");
    }
    if !has_field && (arguments.cells || arguments.origin.is_some()) {
        warn("--cells and --origin are not used: the data contain no fields");
    }
    let page = if report.format() == Format::Html { html::html(&found).map_err(Failure::new)? } else { String::new() };
    let write = |format, out: &mut dyn io::Write| match format {
        Format::Html => out.write_all(page.as_bytes()),
        Format::Json => json::validation(&found, out),
        Format::Text => screen::text(&found, out),
    };
    report.write(write)?;
    if report.format() == Format::Html && !report.is_stdout() {
        output::print(|out| write(arguments.output.beside(), out))?;
    }
    Ok(if found.passed { Outcome::Done } else { Outcome::Failed })
}

/// Returns a data source that can be read several times; data from a pipe or a device are kept in memory.
pub(super) fn source(path: &Path) -> Result<Source<'_>, Failure> {
    let name = path.display().to_string();
    let failed = |error: io::Error| {
        Failure::new(format!("cannot read the data {}: {error}", path.display()))
            .help("expected a CSV file with column names in its first line")
    };
    let stdin = path.as_os_str() == "-";
    let known = if stdin { None } else { Some(std::fs::metadata(path).map_err(failed)?) };
    if let Some(own) = known.filter(std::fs::Metadata::is_file) {
        budget::allow(own.len(), STEPS_PER_BYTE);
        File::open(path).map_err(failed)?;
        return Ok(Source { name, open: Box::new(move || Ok(Box::new(File::open(path)?) as Box<dyn Read>)) });
    }
    // Pipes and devices can be read only once and may be endless, so read up to a limit and keep the data.
    let mut bytes = Vec::new();
    let read = if stdin {
        io::stdin().lock().take(LONGEST + 1).read_to_end(&mut bytes)
    } else {
        File::open(path).and_then(|own| own.take(LONGEST + 1).read_to_end(&mut bytes))
    };
    read.map_err(failed)?;
    if bytes.len() as u64 > LONGEST {
        let message = format!("{name} contains more than {LONGEST} bytes from a pipe or a device");
        return Err(Failure::new(message).help("expected less data, or a regular file, which may have any size"));
    }
    budget::allow(bytes.len() as u64, STEPS_PER_BYTE);
    let bytes: Arc<[u8]> = bytes.into();
    Ok(Source { name, open: Box::new(move || Ok(Box::new(Cursor::new(Arc::clone(&bytes))) as Box<dyn Read>)) })
}

pub(super) fn failure(name: &str, text: &str, error: &ValidationError) -> Failure {
    match error {
        ValidationError::Scene(error) => Failure::scene(name, text, error),
        other => {
            let own = Failure::new(other.to_string());
            match other.accepted() {
                Some(help) => own.help(help),
                None => own,
            }
        }
    }
}
