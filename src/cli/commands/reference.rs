//! `sneddon reference`: exact data on the grid of a solver.

use crate::cli::commands::solve::read;
use crate::cli::commands::validate;
use crate::cli::failure::warn;
use crate::cli::output::{Endings, OutputArguments, OutputFormat};
use crate::cli::precision::PrecisionArguments;
use crate::cli::progress::Progress;
use crate::cli::{Failure, Outcome, budget, tip};
use crate::report::Reference;
use crate::scene::{self, Grid, Run, SceneError};
use crate::validate::points;
use clap::ValueEnum;
use std::collections::BTreeSet;
use std::path::PathBuf;

/// Computes exact pressure, displacement and shape on the grid of a solver, with an error bound for each value.
///
/// The scene file defines the contact and the loads. Writes those of p, u, f, g requested in [outputs]; p by default.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(in crate::cli) struct Arguments {
    /// Scene file; - reads it from stdin.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Grid: N points along both sides of a square box, or start:stop:count for radii [default: the grid of [data], or the radii of [outputs]].
    #[arg(long, value_name = "GRID")]
    grid: Option<String>,
    /// Reads the points from the columns x and y, or r, of this file, and keeps their order.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["grid", "side", "cells", "between"])]
    points: Option<PathBuf>,
    /// Side of the box, such as "8 um" [default: the box of [data]].
    #[arg(long = "box", value_name = "LENGTH", allow_hyphen_values = true)]
    side: Option<String>,
    /// Computes pressures as means over the cells around the points, as in boundary element methods.
    #[arg(long)]
    cells: bool,
    /// Centres the axis between grid points instead of on one.
    #[arg(long)]
    between: bool,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArguments<Format>,
    #[command(flatten)]
    precision: PrecisionArguments,
    #[command(flatten)]
    pub(in crate::cli) budget: budget::BudgetArguments,
}

const EXAMPLES: &str = "Examples:
  sneddon scene new sphere > sphere.toml
  sneddon reference sphere.toml --grid '0:2 um:11'
  sneddon reference sphere.toml --grid 64 --box '4 um' --cells -o sphere.npy

Exit codes: 0 done, 1 a load has no valid contact, 2 bad input (the reason is on stderr).";

/// Work allowed for each point of a grid, including the mean over its cell.
const STEPS_PER_PLACE: u64 = 2_000_000;

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(in crate::cli) enum Format {
    Csv,
    Json,
    Npy,
}

impl OutputFormat for Format {
    const ENDINGS: &'static Endings<Self> = &[("csv", Self::Csv), ("json", Self::Json), ("npy", Self::Npy)];
    const USUAL: Self = Self::Csv;
    const PAGE: Option<(&'static str, &'static str)> = Some(("npy", "a NumPy array"));
}

pub(in crate::cli) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let answer = arguments.output.destination()?;
    let digits = arguments.precision.digits(answer.format() == Format::Csv)?;
    let text = read(&arguments.scene)?;
    let name = arguments.scene.display().to_string();
    let failed = |error: SceneError| Failure::scene(&name, &text, &error);
    let scene = scene::scene_for_grid(&text).map_err(failed)?;
    let declared = Grid::declared(&scene, arguments.between);
    let grid = match (&arguments.points, &arguments.grid, declared) {
        (Some(path), ..) => {
            let source = validate::source(path)?;
            points(&source, &scene).map_err(|error| validate::failure(&name, &text, &error))?
        }
        (None, Some(own), _) => {
            let length = |text: &String| scene.length("the box", text).map_err(|error| Failure::argument("--box", text, &error));
            let side = arguments.side.as_ref().map(length).transpose()?;
            Grid::parse(own, side, arguments.between, &scene).map_err(|error| Failure::argument("--grid", own, &error))?
        }
        (None, None, Some(own)) => own.checked().map_err(failed)?,
        (None, None, None) if !scene.outputs.at.is_empty() => Grid::Radial(scene.outputs.at.clone()).checked().map_err(failed)?,
        (None, None, None) => {
            return Err(Failure::new("no grid is given")
                .help("use --grid \"0:2 um:101\", --grid 64 --box \"8 um\" or --points FILE, or set `at` in [outputs]"));
        }
    };
    if matches!(grid, Grid::Radial(_)) && (arguments.side.is_some() || arguments.between) {
        warn("--box and --between are not used: the grid is a list of radii");
    }
    // Points from a file have no cells.
    let cells = arguments.points.is_none() && (arguments.cells || scene.data.as_ref().is_some_and(|own| own.cells == Some(true)));
    let (curves, others) = scene.outputs.fields().map_err(failed)?;
    for other in others {
        warn(&format!("{} is not a field on a grid; use `sneddon solve` for it", other.key()));
    }
    if !scene.round {
        return Err(Failure::new("the fields of a punch with a non-circular cross-section are not known")
            .help("use sneddon solve for d, F and k, or a round indenter"));
    }
    let scene = tip::with_points(scene, &arguments.scene, failed)?;
    let solution = scene.solution().map_err(failed)?;
    solution.warnings().iter().for_each(|text| warn(text));
    let run = Run::new(&scene, &solution).map_err(failed)?;
    let steps = scene.loads.len() as u64 * (1 + curves.len() as u64 * grid.distinct() as u64);
    budget::allow(steps, STEPS_PER_PLACE);
    let progress = Progress::new(steps, answer.is_stdout());
    let run = run.watched(|| progress.step());
    let reference = Reference { run: &run, grid: &grid, curves: &curves, cells, digits };
    let (mut missing, mut estimated) = (0, BTreeSet::new());
    answer.write(|format, out| {
        match format {
            Format::Csv => missing = reference.csv(out)?,
            Format::Json => missing = reference.json(out)?,
            Format::Npy => estimated = reference.npy(out)?,
        }
        Ok(())
    })?;
    for key in estimated {
        warn(&format!("error bounds of {key} are estimated, not proven; CSV and JSON record this, NPY cannot"));
    }
    let cut = run.cut_short();
    drop(run);
    drop(progress);
    if let Some(why) = cut {
        warn(&format!("some numbers are missing: {why}"));
        return Ok(Outcome::Failed);
    }
    if missing == 0 {
        return Ok(Outcome::Done);
    }
    warn(&format!("{missing} of {} loads have no valid contact; run `sneddon solve` for the reasons", scene.loads.len()));
    Ok(Outcome::Failed)
}
