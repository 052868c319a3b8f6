//! `sneddon validate`: a solver's data beside the exact solution.

use crate::cli::commands::solve;
use crate::cli::failure::warn;
use crate::cli::output;
use crate::cli::output::{Destination, Endings};
use crate::cli::tip;
use crate::cli::{Failure, Outcome, budget};
use crate::report::validation::{html, json, text as screen};
use crate::scene::{Change, Declared, Dimension, Grid, SceneError, scene_for_data};
use crate::validate::{Layout, Origin, Request, Source, ValidationError, validate};
use std::fs::File;
use std::io::{self, Cursor, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Compares a contact solver's results with the exact solution of a scene, and says what is wrong with them.
///
/// Files with columns d, F, a hold a load per row; files with r (or x, y) and p, u, f or g hold places under the scene's load.
/// A column d beside the places separates several loads.
/// Columns are named with their units: d_um,F_mN,a_um or r_m,p_Pa. Several files are several resolutions.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    /// The scene file; [load] is needed for pressures only.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// The solver's data: CSV, NPY, NPZ, or what sneddon reference writes; coarsest first unless --grid or the data tell otherwise.
    #[arg(value_name = "DATA", required = true)]
    data: Vec<PathBuf>,
    /// The relative error in L2 that is accepted, in the place of that of the grid.
    #[arg(long, value_name = "T")]
    tol: Option<f64>,
    /// Pixels along a side of the solver's domain, per file; or the radii of an array of `sneddon reference`, as "0:2 um:101".
    #[arg(long, value_name = "N,N,…|START:STOP:COUNT", value_delimiter = ',', allow_hyphen_values = true)]
    grid: Vec<String>,
    /// The column or array of a quantity, as in p=press or p_GPa=press; columns and rows without names are counted from 1.
    #[arg(long, value_name = "NAME=COLUMN", value_parser = mapped)]
    map: Vec<(String, String)>,
    /// The side of the solver's domain, as "8 um", in the place of that of [data].
    #[arg(long = "box", value_name = "LENGTH")]
    side: Option<String>,
    /// The load of files of places, as d=0.4, F="2 mN" or a=1, in the place of that of [load].
    #[arg(long, value_name = "SYMBOL=VALUE")]
    load: Option<String>,
    /// Where the axis lies: in the middle of a box whose coordinates begin in a corner, or, in fields without coordinates, in the
    /// middle between pixels (centre) or on a pixel.
    #[arg(long, value_name = "PLACE")]
    origin: Option<Place>,
    /// Pressures are means over the pixels, or over rings between radii, as `sneddon reference --cells` writes them.
    #[arg(long)]
    cells: bool,
    /// Writes JSON.
    #[arg(long)]
    pub(in crate::cli) json: bool,
    /// Writes into this file; its ending decides the format: .html, a page with plots beside the answer on stdout, or .txt or .json.
    #[arg(short, long, value_name = "REPORT.html")]
    pub(in crate::cli) output: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) budget: budget::BudgetArguments,
}

/// [`Origin`] as an argument.
#[derive(Clone, Copy, clap::ValueEnum)]
enum Place {
    Corner,
    Centre,
    Pixel,
}

fn mapped(text: &str) -> Result<(String, String), String> {
    let found = text.split_once('=').filter(|own| !own.0.trim().is_empty() && !own.1.is_empty());
    found.map(|(name, column)| (name.trim().to_owned(), column.to_owned())).ok_or_else(|| "p=press would be accepted".to_owned())
}

const EXAMPLES: &str = "Examples:
  sneddon scene new paraboloid > tip.toml
  sneddon solve tip.toml --csv > rows.csv
  sneddon validate tip.toml rows.csv --json

Exit codes: 0 passed, 1 failed, 2 bad input (the reason is on stderr).";

/// Most bytes of data that can be read only once.
const LONGEST: u64 = 100_000_000;
/// Work that each byte of a file may be, all suspicions included.
const STEPS_PER_BYTE: u64 = 10_000;

#[derive(Clone, Copy, PartialEq)]
enum Format {
    Text,
    Json,
    Html,
}

const ENDINGS: &Endings<Format> = &[("html", Format::Html), ("htm", Format::Html), ("txt", Format::Text), ("json", Format::Json)];

/// Reads the number of pixels of one file.
fn pixels_along_a_side(text: &str) -> Result<f64, Failure> {
    let number = text.trim().parse().ok().filter(|own: &f64| *own >= 1.0 && own.is_finite());
    number.ok_or_else(|| Failure::new(format!("--grid has {text:?}")).help("expected numbers of pixels, such as 64,128,256"))
}

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    if let Some(tolerance) = arguments.tol
        && !(tolerance > 0.0 && tolerance.is_finite())
    {
        return Err(Failure::new(format!("--tol {tolerance} is not positive")).help("a relative error such as 1e-3 would be accepted"));
    }
    let flag = arguments.json.then_some(Format::Json);
    let report = Destination::beside(arguments.output.as_deref(), flag, Format::Text, ENDINGS, Format::Html)?;
    let text = solve::read(&arguments.scene)?;
    let name = arguments.scene.display().to_string();
    let sources: Vec<Source<'_>> = arguments.data.iter().map(|path| source(path)).collect::<Result<_, _>>()?;
    let failed = |error: SceneError| Failure::scene(&name, &text, &error);
    let scene = scene_for_data(&text, &Change::None).map_err(failed)?;
    let scene = tip::with_points(scene, &arguments.scene, failed)?;
    let mut scene = match &arguments.load {
        Some(text) => scene.under(text).map_err(failed)?,
        None => scene,
    };
    let (radii, pixels): (Vec<&String>, Vec<&String>) = arguments.grid.iter().partition(|own| own.contains(':'));
    for text in &radii {
        if let Grid::Radial(own) = Grid::parse(text, None, false, &scene).map_err(failed)? {
            scene.outputs.at = own;
        }
    }
    let grid = pixels.into_iter().map(|own| pixels_along_a_side(own)).collect::<Result<Vec<f64>, Failure>>()?;
    if let Some(text) = &arguments.side {
        let side = scene.length("box", text).map_err(failed)?;
        let data = scene.data.take().unwrap_or_else(Declared::nothing);
        scene.data = Some(Declared { side: Some(side), ..data });
    }
    let side = scene.data.as_ref().and_then(|own| own.side);
    let layout = Layout {
        map: arguments.map.clone(),
        side,
        shown_side: side.map(|own| own * scene.system.out(Dimension::LENGTH)),
        origin: arguments.origin.map(|own| match own {
            Place::Corner => Origin::Corner,
            Place::Centre => Origin::Centre,
            Place::Pixel => Origin::Pixel,
        }),
        radii: !radii.is_empty(),
        cells: arguments.cells.then_some(true),
    };
    let layout = layout.checked().map_err(|error| failure(&name, &text, &error))?;
    let request = Request { layout: &layout, text: &text, scene: &scene, sources: &sources, tolerance: arguments.tol, grid: &grid };
    let found = validate(&request).map_err(|error| failure(&name, &text, &error))?;
    found.warnings.iter().for_each(|text| warn(text));
    let page = if report.format() == Format::Html { html::html(&found).map_err(Failure::new)? } else { String::new() };
    let write = |format, out: &mut dyn io::Write| match format {
        Format::Html => out.write_all(page.as_bytes()),
        Format::Json => json::validation(&found, out),
        Format::Text => screen::text(&found, out),
    };
    report.write(write)?;
    if report.format() == Format::Html {
        output::print(|out| write(flag.unwrap_or(Format::Text), out))?;
    }
    Ok(if found.passed { Outcome::Done } else { Outcome::Failed })
}

/// A file, read anew for every pass; what cannot be read twice is kept.
pub(super) fn source(path: &Path) -> Result<Source<'_>, Failure> {
    let name = path.display().to_string();
    let failed = |error: io::Error| {
        Failure::new(format!("the data {} cannot be read: {error}", path.display()))
            .help("a CSV file with names of columns in its first line would be accepted")
    };
    let stdin = path.as_os_str() == "-";
    let known = if stdin { None } else { Some(std::fs::metadata(path).map_err(failed)?) };
    if let Some(own) = known.filter(std::fs::Metadata::is_file) {
        budget::allow(own.len(), STEPS_PER_BYTE);
        File::open(path).map_err(failed)?;
        return Ok(Source { name, open: Box::new(move || Ok(Box::new(File::open(path)?) as Box<dyn Read>)) });
    }
    // What cannot be read twice is kept, and what has no end is not read to its end.
    let mut bytes = Vec::new();
    let read = if stdin {
        io::stdin().lock().take(LONGEST + 1).read_to_end(&mut bytes)
    } else {
        File::open(path).and_then(|own| own.take(LONGEST + 1).read_to_end(&mut bytes))
    };
    read.map_err(failed)?;
    if bytes.len() as u64 > LONGEST {
        let message = format!("the data {name} are more than {LONGEST} bytes from a pipe or a device");
        return Err(Failure::new(message).help("a regular file of any length would be accepted"));
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
