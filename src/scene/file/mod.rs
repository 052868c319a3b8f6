//! Parses scene files: keys and positions, numbers with units, formulas, and checks of their dimensions.
//!
//! `document` handles keys and positions, `read` and `reading` build a scene, and `check` verifies dimensions.
//! No contact problem is solved here.

pub(crate) mod argument;
pub(crate) mod change;
pub(crate) mod check;
pub(crate) mod counting;
pub(crate) mod declared;
pub(crate) mod dimensioned;
pub(crate) mod document;
pub(crate) mod read;
pub(crate) mod reading;
pub(crate) mod template;
pub(crate) mod unit;
