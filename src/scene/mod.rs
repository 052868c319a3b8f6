//! Contact scenes: a tip, two materials, loads and requested quantities, with units; read from TOML and solved row by row.

mod body;
mod doubt;
mod error;
pub(crate) mod file;
mod load;
mod measured;
mod model;
mod model_error;
mod punch;
mod reference;
mod regime;
mod row;
mod run;
mod shape;
mod sweep;
mod system;

pub use crate::contact::{Dimension, Quantity};
pub use error::{Reason, SceneError};
pub use file::change::Change;
pub use file::counting::Counting;
pub use file::declared::{Declared, Walls};
pub use file::dimensioned::DimensionedNumber;
#[cfg(feature = "cli")]
pub(crate) use file::dimensioned::to_double_double;
pub use file::document::LONGEST;
pub use file::read::{scene, scene_for_data, scene_for_grid};
pub use file::template::template;
pub use file::unit::Unit;
pub use load::{Control, Loads, Steps};
pub use measured::{Apex, Fit, FitParameter, Join, LONGEST_TIP, Measured, MeasuredTip, Note, Scan, Smoothing, decoded};
pub use model::{DepthFrom, Outputs, Scene, Shown};
pub use reference::{Field, Grid, LARGEST_GRID};
pub use regime::{Regime, Simple};
pub use row::{Row, Work};
pub use run::{Point, Run, infinite_value};
pub use shape::{Parameter, SHAPES, Shape, Way, known_shape, shape};
pub use system::{Names, System};

/// Private items used by tests in `tests/`; not part of the public interface.
#[doc(hidden)]
pub mod inner {
    pub use super::measured::columns::sheet;
    pub use super::measured::header::parts;
}
