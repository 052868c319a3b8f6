//! What a validation found: plain numbers and sentences, for every format of report.

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
    /// The largest error: relative to its own row in files of loads, to the largest exact value in files of places.
    pub max: f64,
    /// Where it stands: the load, or r, in the unit of the data.
    pub worst_at: f64,
    /// The mean error with its sign, relative to the mean exact value.
    pub bias: f64,
    /// Rows that were compared.
    pub rows: u64,
    /// The error at the largest load.
    pub at_largest_load: f64,
    /// The error that is accepted; `None` where the column decides nothing.
    pub tolerance: Option<f64>,
    /// Whether it is accepted; `None` where the column decides nothing.
    pub passed: Option<bool>,
    /// The largest distance in pixels, for contact radii on a known grid.
    pub pixels: Option<f64>,
    /// The row whose error exceeds its own limit by the largest factor.
    pub beyond: Option<Beyond>,
    /// Rows next to apex, kink and rim.
    pub excluded: Option<Excluded>,
}

/// The row whose error exceeds its own limit by the largest factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beyond {
    /// Where it is: the load, or r.
    pub at: f64,
    /// Its relative error.
    pub error: f64,
    /// The largest relative error that is acceptable there.
    pub limit: f64,
}

/// Rows next to a singular place, where a pixel cannot follow the exact pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Excluded {
    /// How many.
    pub rows: u64,
    /// Rows among them where the exact pressure is infinite.
    pub infinite: u64,
    /// ‖e‖₂/‖exact‖₂ over the others.
    pub l2: f64,
    /// Their largest error, relative to the largest exact value among them.
    pub max: f64,
}

/// One file.
#[derive(Clone, Debug, PartialEq)]
pub struct FileReport {
    /// Its name.
    pub name: String,
    /// Pixels along a side of the box.
    pub grid: Option<f64>,
    /// The pixel as a part of the largest contact radius.
    pub pixel: Option<f64>,
    /// Rows read.
    pub rows: u64,
    /// Its columns.
    pub columns: Vec<Column>,
    /// How it was read, in sentences.
    pub notes: Vec<String>,
    /// Points to draw.
    pub plots: Vec<Plot>,
}

/// Data and exact values of one column over one coordinate.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// What is drawn over what, with units.
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
    /// What it is, in one sentence.
    pub text: String,
    /// ‖e‖₂/‖exact‖₂ as the data stand; [`f64::MAX`] where no place can be compared.
    pub before: f64,
    /// The same if the suspicion is true.
    pub after: f64,
}

impl Suspicion {
    /// How the error changes if the suspicion is true, in words; data without any comparable place have no error before.
    pub fn fall(&self) -> String {
        if self.before < f64::MAX {
            format!("the error falls from {:.2e} to {:.2e}", self.before, self.after)
        } else {
            format!("the error then is {:.2e}", self.after)
        }
    }
}

/// The whole.
#[derive(Clone, Debug, PartialEq)]
pub struct Validation {
    /// The verdict.
    pub passed: bool,
    /// Why, in one sentence.
    pub reason: String,
    /// The fault that explains the data, where exactly one does.
    pub suspicion: Option<Suspicion>,
    /// The columns of the finest file of each kind.
    pub columns: Vec<Column>,
    /// Orders of convergence by column; `None` for a single file.
    pub orders: Option<Vec<(&'static str, Order)>>,
    /// Every file, coarsest first.
    pub files: Vec<FileReport>,
    /// How the whole was read, in sentences.
    pub notes: Vec<String>,
    /// What a reader must know of the exact solution.
    pub warnings: Vec<String>,
}
