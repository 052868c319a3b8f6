//! The contact problem: materials, depth, force, pressure and displacement, explicit relations and the spring foundation.

mod comparison;
mod error;
mod explained;
mod explicit;
mod force_radius;
mod foundation;
mod indentation;
mod material;
mod mean;
mod points;
mod problem;
mod quantity;
mod radius;
mod report;
mod slices;
mod steps;
mod stress;

pub use comparison::{Comparison, Comparisons, Setting, compare};
pub use error::ContactError;
pub use explained::{Explained, WayResult};
pub use explicit::{Explicit, explicit};
pub use foundation::{FoundationState, SpringFoundation};
pub use indentation::{Body, Boundary, Estimates, Finding, Indentation, Indented, Load, Naming, Part, Setup, Severity, State, in_unit};
pub use material::{ElasticBody, TransverselyIsotropic, effective_modulus};
pub use mean::PartialForce;
pub use points::{Absence, Expanded, each_point, with_reasons};
#[cfg(feature = "scene")]
pub(crate) use problem::step_of;
pub use problem::{Contact, Measured, Reason};
pub use quantity::{Dimension, Formulas, Kind, Loaded, Quantity};
pub use report::{Edge, Relations, relations, rim_radius};
pub use steps::{Step, inverse_steps, short_inverse_steps, short_steps, steps};
