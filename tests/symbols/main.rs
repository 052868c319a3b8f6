//! Tests of expressions, of the language and of the function table: parsing, printing, recognition, values of special functions.

mod cross_checks;
mod functions;
mod grammar;
mod hypergeometric;
mod language;
mod precise;
mod recognition;
mod special;
mod waves;
mod wide;
