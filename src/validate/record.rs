//! The result of a validation: numbers and sentences for all report formats.

use super::Order;

/// Errors of one column of one file.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// The symbol: d, F, a, p, u, or F_from_p.
    pub name: &'static str,
    /// Σ|e|/Σ|exact|.
    pub l1: f64,
    /// ‖e‖₂/‖exact‖₂.
    pub l2: f64,
    /// The largest error: relative to its own row in files with loads, to the largest exact value in files with fields.
    pub max: f64,
    /// The position of the largest error: the load, or r, in the unit of the data.
    pub worst_at: f64,
    /// The mean error with its sign, relative to the mean exact value.
    pub bias: f64,
    /// Number of compared rows.
    pub rows: u64,
    /// The error at the largest load.
    pub at_largest_load: f64,
    /// The tolerance; `None` if the column is not judged.
    pub tolerance: Option<f64>,
    /// True if the error is within the tolerance; `None` if the column is not judged.
    pub passed: Option<bool>,
    /// The largest difference in pixels, for contact radii on a known grid.
    pub pixels: Option<f64>,
    /// The row whose error exceeds its own limit by the largest factor.
    pub beyond: Option<Beyond>,
    /// Rows near the apex, kinks and the rim.
    pub excluded: Option<Excluded>,
}

/// The row whose error exceeds its own limit by the largest factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beyond {
    /// The position: the load, or r.
    pub at: f64,
    /// The relative error.
    pub error: f64,
    /// The tolerance at this row.
    pub limit: f64,
}

/// Rows near a singular point, where a pixel cannot resolve the exact pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Excluded {
    /// The number of rows.
    pub rows: u64,
    /// The number of rows with an infinite exact pressure.
    pub infinite: u64,
    /// ‖e‖₂/‖exact‖₂ of the other rows.
    pub l2: f64,
    /// The largest error of the other rows, relative to their largest exact value.
    pub max: f64,
}

/// One file.
#[derive(Clone, Debug, PartialEq)]
pub struct FileReport {
    /// The name of the file.
    pub name: String,
    /// Number of pixels along a side of the box.
    pub grid: Option<f64>,
    /// The pixel relative to the largest contact radius.
    pub pixel: Option<f64>,
    /// Number of rows read.
    pub rows: u64,
    /// The columns.
    pub columns: Vec<Column>,
    /// Notes about how the file was read.
    pub notes: Vec<String>,
    /// Points to plot.
    pub plots: Vec<Plot>,
}

/// Data and exact values of one column as a function of one coordinate.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// The title with units.
    pub title: String,
    /// The name of the coordinate with its unit.
    pub across: String,
    /// Coordinate, data, exact value.
    pub points: Vec<(f64, f64, f64)>,
}

/// A fault that explains the data.
#[derive(Clone, Debug, PartialEq)]
pub struct Suspicion {
    /// A short name.
    pub id: &'static str,
    /// A description in one sentence.
    pub text: String,
    /// ‖e‖₂/‖exact‖₂ of the data; [`f64::MAX`] if no point can be compared.
    pub before: f64,
    /// The same error after the fault is corrected.
    pub after: f64,
}

impl Suspicion {
    /// Describes the change of the error when the fault is corrected; data without comparable points have no error before.
    pub fn fall(&self) -> String {
        if self.before < f64::MAX {
            format!("correcting it reduces the error from {:.2e} to {:.2e}", self.before, self.after)
        } else {
            format!("correcting it gives an error of {:.2e}", self.after)
        }
    }
}

/// The complete result.
#[derive(Clone, Debug, PartialEq)]
pub struct Validation {
    /// The verdict.
    pub passed: bool,
    /// The reason in one sentence.
    pub reason: String,
    /// The fault that explains the data, if there is exactly one.
    pub suspicion: Option<Suspicion>,
    /// What the budget did not suffice for: the search for a fault.
    pub cut_short: Option<&'static str>,
    /// The columns of the finest file of each kind.
    pub columns: Vec<Column>,
    /// Orders of convergence by column; `None` for a single file.
    pub orders: Option<Vec<(&'static str, Order)>>,
    /// All files, coarsest first.
    pub files: Vec<FileReport>,
    /// Notes about how the files were read.
    pub notes: Vec<String>,
    /// Warnings about the exact solution.
    pub warnings: Vec<String>,
}

/// Seven digits of a value, with its unit.
pub(super) fn significant(value: f64, unit: &str) -> String {
    let rounded: f64 = format!("{value:.6e}").parse().unwrap_or(value);
    let is_plain = rounded == 0.0 || (1e-4..1e7).contains(&rounded.abs());
    let number = if is_plain { rounded.to_string() } else { format!("{rounded:e}") };
    format!("{number} {unit}").trim_end().to_owned()
}
