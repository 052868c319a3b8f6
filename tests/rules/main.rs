//! Tests of the catalogue of rules and of what it derives: statements, reference values, inverses, verification.

mod catalogue;
mod chapter3;
mod chapter3_values;
mod hypergeometric;
mod inverse;
mod laurent;
mod pressures;
mod products;
mod reading;
mod rules;
mod rules_values;
mod statements;
mod verification;
