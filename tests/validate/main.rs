//! Tests of `validate`: a solver's data beside the exact solution.

mod validate;
