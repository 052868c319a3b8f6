//! Contact scenes: a tip, two materials, loads and the quantities wanted, with units; read from TOML and solved row by row.

mod body;
mod check;
mod dimension;
mod document;
mod error;
mod load;
mod measured;
mod model;
mod model_error;
mod punch;
mod quantity;
mod read;
mod reading;
mod row;
mod run;
mod shape;
mod system;
mod template;
mod unit;

pub use dimension::Dimension;
pub use document::LONGEST;
pub use error::{Reason, SceneError};
pub use load::{Control, Loads, Steps};
pub use measured::{Apex, Fit, FitParameter, Join, LONGEST_TIP, Measured, MeasuredTip, Note, Scan, Smoothing, decoded};
pub use model::{Curve, Datum, DepthFrom, Outputs, Scene, Shown};
pub use quantity::Quantity;
pub use read::scene;
pub use row::{Row, Work};
pub use run::{Point, Run};
pub use shape::{Parameter, SHAPES, Shape, Way, shape};
pub use system::{Names, System};
pub use template::template;
pub use unit::Unit;
