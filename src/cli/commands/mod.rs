//! The subcommands: one file each, with the arguments, the help and the implementation.
//!
//! Code that several of them share is in the parent folder.
//! Every command writes its output to stdout or to a file once the output is complete.

pub(super) mod code;
pub(super) mod compare;
pub(super) mod completions;
pub(super) mod derive;
pub(super) mod eval;
pub(super) mod invert;
pub(super) mod kappa;
pub(super) mod plot;
pub(super) mod reference;
pub(super) mod rules;
pub(super) mod scene;
pub(super) mod solve;
pub(super) mod tradeoff;
pub(super) mod validate;
