//! The table `[data]`: properties of the solver whose data are validated.

use crate::scene::file::dimensioned::to_f64;
use crate::scene::file::document::{Entry, Table};
use crate::scene::system::System;
use crate::scene::{Control, Dimension, DimensionedNumber, SceneError};
use std::ops::Range;

/// The edges of the solver's domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Walls {
    /// A half-space, without periodic images.
    Free,
    /// A periodic domain.
    Periodic,
    /// Unknown.
    Unknown,
}

/// Properties of a solver's data in computing units; whatever is `None` is inferred from the data.
#[derive(Clone, Debug, PartialEq)]
pub struct Declared {
    /// The side of the square domain.
    pub side: Option<f64>,
    /// Numbers of pixels along a side, one per file.
    pub grid: Vec<f64>,
    /// The edges of the domain.
    pub walls: Walls,
    /// The quantity that the solver controlled.
    pub control: Option<Control>,
    /// True if pressures are means over pixels, false if they are values at pixel centres.
    pub cells: Option<bool>,
    /// True if pressures and forces are positive in tension.
    pub tension: bool,
    /// The relative tolerance at which the solver stopped.
    pub tolerance: f64,
}

impl Declared {
    /// Returns an empty declaration.
    pub fn nothing() -> Self {
        Self { side: None, grid: Vec::new(), walls: Walls::Unknown, control: None, cells: None, tension: false, tolerance: 0.0 }
    }
}

/// The table as typed.
pub(in crate::scene) struct Typed {
    side: Option<(DimensionedNumber, Range<usize>)>,
    rest: Declared,
}

/// Maximum number of pixels along a side.
const MOST_PIXELS: usize = 1 << 24;

impl Typed {
    /// Reads the table.
    pub(in crate::scene) fn read(table: &Table<'_>) -> Result<Self, SceneError> {
        table.allow(&["box", "grid", "boundary", "control", "pressure", "sign", "tolerance"])?;
        let word = |key: &str, known: &[&'static str]| table.get(key).map(|entry| entry.word(known)).transpose();
        let walls = match word("boundary", &["free", "periodic", "unknown"])? {
            Some("free") => Walls::Free,
            Some("periodic") => Walls::Periodic,
            _ => Walls::Unknown,
        };
        let control = word("control", &["depth", "force"])?.map(|own| if own == "force" { Control::Force } else { Control::Depth });
        let cells = word("pressure", &["cell", "point"])?.map(|own| own == "cell");
        let tension = word("sign", &["compression+", "tension+"])? == Some("tension+");
        let grid = table.get("grid").map_or(Ok(Vec::new()), |entry| counts(&entry))?;
        let tolerance = table.get("tolerance").map_or(Ok(0.0), |entry| fraction(&entry))?;
        let side = table.get("box").map(|entry| Ok::<_, SceneError>((entry.quantity()?, entry.span()))).transpose()?;
        Ok(Self { side, rest: Declared { side: None, grid, walls, control, cells, tension, tolerance } })
    }

    /// Returns the side of the box, which may define a unit.
    pub(in crate::scene) fn side(&self) -> Option<&DimensionedNumber> {
        self.side.as_ref().map(|own| &own.0)
    }

    /// Converts the numbers to the units of the scene.
    pub(in crate::scene) fn declared(self, system: &System) -> Result<Declared, SceneError> {
        let side = match &self.side {
            None => None,
            Some((quantity, span)) => match system.number(quantity, Dimension::LENGTH, "box").map_err(|error| error.at(span.clone()))? {
                side if side > 0.0 => Some(side),
                _ => {
                    let message = format!("box = {} is not positive", quantity.text());
                    return Err(SceneError::value(message).help("expected a positive length").at(span.clone()));
                }
            },
        };
        Ok(Declared { side, ..self.rest })
    }
}

/// Reads a whole number, or a list of them.
fn counts(entry: &Entry<'_>) -> Result<Vec<f64>, SceneError> {
    let one = |entry: &Entry<'_>| Ok(entry.count(MOST_PIXELS)? as f64);
    match entry.list() {
        Some(list) => list.map(|own| one(&own)).collect(),
        None => Ok(vec![one(entry)?]),
    }
}

fn fraction(entry: &Entry<'_>) -> Result<f64, SceneError> {
    let value = to_f64(&entry.quantity()?.in_base()).map_err(|error| error.at(entry.span()))?;
    if (0.0..1.0).contains(&value) {
        return Ok(value);
    }
    Err(SceneError::value(format!("tolerance = {value:?} is not between 0 and 1"))
        .help("expected the relative tolerance of the solver, such as 1e-9")
        .at(entry.span()))
}
