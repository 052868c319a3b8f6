//! Tests of hostile input and of the budget of work.

mod budget;
mod fuzz;
