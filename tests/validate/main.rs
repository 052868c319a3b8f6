//! Tests of `validate`: a solver's data beside the exact solution.

mod array;
mod diagnosis;
mod displacement;
mod lattice;
mod order;
mod placing;
mod validate;
