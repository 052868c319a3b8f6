//! Contact scenes: a tip, two materials, loads and the quantities wanted, with units; read from TOML and solved row by row.

mod argument;
mod body;
mod change;
mod check;
mod counting;
mod declared;
mod dimensioned;
mod document;
mod error;
mod load;
mod measured;
mod model;
mod model_error;
mod punch;
mod read;
mod reading;
mod reference;
mod regime;
mod row;
mod run;
mod shape;
mod sweep;
mod system;
mod template;
mod unit;

pub use crate::contact::{Dimension, Quantity};
pub use change::Change;
pub use counting::Counting;
pub use declared::{Declared, Walls};
pub use dimensioned::DimensionedNumber;
pub use document::LONGEST;
pub use error::{Reason, SceneError};
pub use load::{Control, Loads, Steps};
pub use measured::{Apex, Fit, FitParameter, Join, LONGEST_TIP, Measured, MeasuredTip, Note, Scan, Smoothing, decoded};
pub use model::{DepthFrom, Outputs, Scene, Shown};
pub use read::{scene, scene_for_data, scene_for_grid};
pub use reference::{Field, Grid, LARGEST_GRID};
pub use regime::{Regime, Simple};
pub use row::{Row, Work};
pub use run::{Point, Run};
pub use shape::{Parameter, SHAPES, Shape, Way, known_shape, shape};
pub use system::{Names, System};
pub use template::template;
pub use unit::Unit;

/// Private parts that tests in `tests/` look at; not part of the interface.
#[doc(hidden)]
pub mod inner {
    pub use super::measured::columns::sheet;
    pub use super::measured::header::parts;
}
