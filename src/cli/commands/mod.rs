//! The subcommands: one file for each, with its arguments, its help and what it does.
//!
//! What several of them share lies beside this folder.
//! Every command writes its answer to stdout or to a file, once it is complete.

pub(super) mod code;
pub(super) mod compare;
pub(super) mod completions;
pub(super) mod derive;
pub(super) mod eval;
pub(super) mod invert;
pub(super) mod plot;
pub(super) mod reference;
pub(super) mod rules;
pub(super) mod scene;
pub(super) mod solve;
pub(super) mod tradeoff;
pub(super) mod validate;
