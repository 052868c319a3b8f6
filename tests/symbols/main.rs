//! Tests of expressions, of the language and of the function table: parsing, printing, recognition, values of special functions.

mod balanced;
mod cross_checks;
mod folding;
mod functions;
mod grammar;
mod hypergeometric;
mod language;
mod normal;
mod numbers;
mod precise;
mod printing;
mod recognition;
mod special;
mod waves;
mod wide;
