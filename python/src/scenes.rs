//! Scenes: what `sneddon solve`, `sneddon reference` and `sneddon validate` answer.

use crate::error::Fault;
use crate::interrupt::{interruptible, written};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use sneddon::num::Bound as Ground;
use sneddon::num::work::{self, Budget};
use sneddon::report::{solved::json as solved_json, validation};
use sneddon::scene::{self, Change, Declared, Dimension, Grid, LONGEST_TIP, Quantity, Run, Scene, SceneError, infinite_value};
use sneddon::validate::{Layout, Origin, Request, Source, ValidationError};
use std::fs::File;
use std::io::{Cursor, Read};
use std::path::Path;
use std::sync::Arc;

/// Steps of work that each row of a scene and each place of a field may take.
const STEPS: u64 = 1_000_000;

/// The scene with the points of its measured tip, whose file counts from `directory`.
fn with_points(scene: Scene, directory: &str) -> Result<Scene, Fault> {
    let Some(measured) = &scene.measured else { return Ok(scene) };
    let path = Path::new(directory).join(measured.file());
    let refused =
        |message: String| Fault::new(message).help("a file of points is accepted; its name counts from the directory of the scene");
    if std::fs::metadata(&path).is_ok_and(|own| !own.is_file()) {
        return Err(refused(format!("{} is not a regular file", path.display())));
    }
    let mut bytes = Vec::new();
    let done = File::open(&path).and_then(|file| file.take(LONGEST_TIP as u64 + 1).read_to_end(&mut bytes));
    done.map_err(|error| refused(format!("cannot read {}: {error}", path.display())))?;
    if bytes.len() > LONGEST_TIP {
        return Err(refused(format!("{} has more than {LONGEST_TIP} bytes", path.display())));
    }
    let points = scene::decoded(bytes);
    scene.with_points(&points).map_err(|error| Fault::points(&path.display().to_string(), &points.0, &error))
}

/// The document that `sneddon solve --json` prints.
#[pyfunction]
pub(crate) fn solve(py: Python<'_>, text: &str, directory: &str, force: bool) -> PyResult<String> {
    let answer = interruptible(py, || -> Result<String, Fault> {
        let failed = |error: SceneError| Fault::scene(text, &error);
        let scene = with_points(scene::scene(text).map_err(failed)?, directory)?;
        within(|| {
            let solution = scene.solution().map_err(failed)?;
            let run = Run::new(&scene, &solution).map_err(failed)?;
            work::allow(run.steps().saturating_mul(STEPS));
            written(|out| solved_json::solved(&run, force, out))
        })
    });
    Ok(answer??)
}

/// A budget for a whole call; what is allowed within counts on top of it.
fn within<T>(call: impl FnOnce() -> Result<T, Fault>) -> Result<T, Fault> {
    work::within(Budget::DEFAULT, call)
}

impl From<work::Exhausted> for Fault {
    fn from(error: work::Exhausted) -> Self {
        Self::new(error.to_string())
    }
}

/// Values and bounds of one curve.
type Curves<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, &'static str);

/// A field in the units of the scene's answers: p, its bounds, what they rest on, and the same of u, one entry per place.
///
/// With `cells` the places are those of a square of `cells` points along each side, in rows, and pressures are means over its cells.
#[pyfunction]
#[pyo3(signature = (text, directory, load, x, y, cells=None))]
pub(crate) fn reference<'py>(
    py: Python<'py>,
    text: &str,
    directory: &str,
    load: usize,
    x: PyReadonlyArray1<'py, f64>,
    y: PyReadonlyArray1<'py, f64>,
    cells: Option<(f64, usize, bool)>,
) -> PyResult<(Curves<'py>, Curves<'py>)> {
    let (x, y) = (x.as_slice()?.to_vec(), y.as_slice()?.to_vec());
    let fields = interruptible(py, || fields(text, directory, load, (&x, &y), cells))??;
    let [p, u] = fields.map(|own| (own.values.into_pyarray(py), own.errors.into_pyarray(py), own.ground.name()));
    Ok((p, u))
}

/// One quantity at every place.
#[derive(Default)]
struct Values {
    values: Vec<f64>,
    errors: Vec<f64>,
    /// What the error bounds rest on, all of them together.
    ground: Ground,
}

impl Values {
    /// Adds the point with this index, or says why it has no value.
    fn take(&mut self, index: usize, curve: Quantity, found: Result<(f64, f64), &'static str>, ground: Ground) -> Result<(), Fault> {
        let (value, error, ground) = match found {
            Ok((value, error)) => (value, error, ground),
            // Infinite by theory at an apex, a kink or a rim.
            Err(why) => match infinite_value(curve, why) {
                Some(infinite) => (infinite, 0.0, Ground::Proven),
                None => return Err(Fault::new(why).place(format!("flat index {index}"))),
            },
        };
        self.values.push(value);
        self.errors.push(error);
        self.ground = self.ground.and(ground);
        Ok(())
    }
}

/// p and u.
fn fields(
    text: &str,
    directory: &str,
    load: usize,
    (x, y): (&[f64], &[f64]),
    cells: Option<(f64, usize, bool)>,
) -> Result<[Values; 2], Fault> {
    let failed = |error: SceneError| Fault::scene(text, &error);
    let scene = with_points(scene::scene_for_grid(text).map_err(failed)?, directory)?;
    if !scene.round {
        return Err(Fault::new("no field is known of a punch with a cross-section").help("a round indenter is accepted"));
    }
    let loads = scene.loads.len();
    if load >= loads {
        return Err(Fault::new(format!("load index {load} is out of range"))
            .help(format!("expected an index from 0 to {}", loads.saturating_sub(1))));
    }
    let length = scene.system.out(Dimension::LENGTH);
    let solution = scene.solution().map_err(failed)?;
    let run = Run::new(&scene, &solution).map_err(failed)?;
    let state = within(|| Ok(run.state(load, false)))?;
    let Some(state) = state else {
        return Err(Fault::new("no valid contact exists for this load").help("run sneddon.solve for the reasons"));
    };
    let mut means = None;
    if let Some((side, count, between)) = cells {
        let grid = Grid::Square { side: side / length, count, between }.checked().map_err(failed)?;
        means = Some(within(|| {
            work::allow((grid.distinct() as u64).saturating_mul(STEPS));
            Ok((run.field(&grid, Quantity::Pressure, Some(&state), true), count))
        })?);
    }
    let radii: Vec<f64> = x.iter().zip(y).map(|(x, y)| x.hypot(*y) / length).collect();
    let values = |curve: Quantity| -> Result<Values, Fault> {
        let points = within(|| {
            work::allow((radii.len() as u64).saturating_mul(STEPS));
            Ok(run.points(curve, Some(&state), &radii))
        })?;
        let mut out = Values::default();
        for (index, own) in points.into_iter().enumerate() {
            out.take(index, curve, own.value, own.bound)?;
        }
        Ok(out)
    };
    let pressures = match means {
        None => values(Quantity::Pressure)?,
        Some((field, count)) => {
            let mut out = Values::default();
            for index in 0..radii.len() {
                out.take(index, Quantity::Pressure, field.at(&[index / count, index % count]), field.bound())?;
            }
            out
        }
    };
    Ok([pressures, values(Quantity::Displacement)?])
}

/// The document that `sneddon validate --json` prints, of files in memory.
#[pyfunction]
#[pyo3(signature = (text, directory, files, tolerance, grid, map, side, origin, load, cells))]
#[allow(clippy::too_many_arguments)]
pub(crate) fn validate(
    py: Python<'_>,
    text: &str,
    directory: &str,
    files: Vec<(String, Bound<'_, PyBytes>)>,
    tolerance: Option<f64>,
    grid: Vec<f64>,
    map: Vec<(String, String)>,
    side: Option<&str>,
    origin: Option<&str>,
    load: Option<&str>,
    cells: Option<bool>,
) -> PyResult<String> {
    let files: Vec<(String, Vec<u8>)> = files.into_iter().map(|(name, bytes)| (name, bytes.as_bytes().to_vec())).collect();
    let answer = interruptible(py, || -> Result<String, Fault> {
        let failed = |error: SceneError| Fault::scene(text, &error);
        let refused = |error: ValidationError| Fault::validation(text, &error);
        let mut scene = with_points(scene::scene_for_data(text, &Change::None).map_err(failed)?, directory)?;
        if let Some(own) = load {
            scene = scene.under(own).map_err(failed)?;
        }
        if let Some(own) = side {
            let side = scene.length("box", own).map_err(failed)?;
            let data = scene.data.take().unwrap_or_else(Declared::nothing);
            scene.data = Some(Declared { side: Some(side), ..data });
        }
        let side = scene.data.as_ref().and_then(|own| own.side);
        let origin = match origin {
            None => None,
            Some("corner") => Some(Origin::Corner),
            Some("centre") => Some(Origin::Centre),
            Some("pixel") => Some(Origin::Pixel),
            Some(other) => {
                return Err(Fault::new(format!("origin {other:?} is not known")).help("corner, centre and pixel are accepted"));
            }
        };
        let shown_side = side.map(|own| own * scene.system.out(Dimension::LENGTH));
        let layout = Layout { map, side, shown_side, origin, radii: false, cells }.checked().map_err(refused)?;
        let bytes: u64 = files.iter().map(|(_, own)| own.len() as u64).sum();
        let source = |(name, bytes): (String, Vec<u8>)| {
            let bytes: Arc<[u8]> = bytes.into();
            Source { name, open: Box::new(move || Ok(Box::new(Cursor::new(Arc::clone(&bytes))) as Box<dyn Read>)) }
        };
        let sources: Vec<Source<'_>> = files.into_iter().map(source).collect();
        within(|| {
            work::allow(bytes.saturating_mul(10_000));
            let request = Request { text, scene: &scene, sources: &sources, tolerance, grid: &grid, layout: &layout };
            let found = sneddon::validate::validate(&request).map_err(refused)?;
            written(|out| validation::json::validation(&found, out))
        })
    });
    Ok(answer??)
}
