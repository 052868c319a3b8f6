//! Tests of contact quantities and of indentation: laws, explicit relations, verdicts.

mod explicit;
mod indentation;
mod laws;
mod radii;
