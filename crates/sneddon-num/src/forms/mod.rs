//! Stable forms that closed contact solutions need; one family per file, every factor positive.

pub mod capped_root;
mod elliptic_pole;
pub mod outside_power;
pub mod pressure_power;
pub mod root_family;
pub mod root_pressure;
pub mod segment;
pub mod worn_pressure;
pub mod worn_root;

pub use capped_root::capped_sphere_force;
pub use elliptic_pole::elliptic_pole;
pub use outside_power::outside_power;
pub use pressure_power::pressure_power;
pub use root_family::{artanh_ratio, hyperboloid_force, hyperboloid_integral, sphere_force, sphere_integral};
pub use root_pressure::{hyperboloid_pressure, sphere_pressure};
pub use segment::angle_above;
pub use segment::{angle_between, shifted_power, shifted_power_force};
pub use worn_pressure::elliptic_moment;
pub use worn_root::{worn_hyperboloid_force, worn_hyperboloid_slope, worn_sphere_force, worn_sphere_slope};
