//! Tests of the program as its users run it: command line, documents, schemas, pictures, formulas and generated code.

mod arrays;
mod budgets;
mod cli;
mod code;
mod definitions;
mod docs;
mod endings;
mod ends;
mod pages;
mod pictures;
mod points;
mod precision;
mod presentation;
mod quantities;
mod references;
mod schemas;
mod solve;
mod spellings;
mod steps;
mod tradeoff;
mod typesetting;
mod units;
mod ways;
mod widths;
