//! Tests of `validate`: a solver's data beside the exact solution.

mod array;
mod columns;
mod diagnosis;
mod displacement;
mod images;
mod kinks;
mod lattice;
mod mirrored;
mod order;
mod placing;
mod tables;
mod validate;
