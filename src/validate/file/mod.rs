//! The files of a solver: tables and arrays, the meaning of columns, units, and the pixel of a lattice.
//!
//! `survey` reads a file once from beginning to end.
//! No values are compared here.

pub(crate) mod array;
pub(crate) mod column;
pub(crate) mod data;
pub(crate) mod lattice;
pub(crate) mod layout;
pub(crate) mod pixel;
pub(crate) mod points;
pub(crate) mod row;
pub(crate) mod stacked;
pub(crate) mod survey;
pub(crate) mod table;
pub(crate) mod units;
