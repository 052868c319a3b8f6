//! What a scene file says: its keys with their places, numbers with units, formulas, and the checks of what was typed.
//!
//! `document` knows keys and places, `read` and `reading` make a scene of them, `check` sees that dimensions agree.
//! Nothing is solved here.

pub(crate) mod argument;
pub(crate) mod change;
pub(crate) mod check;
pub(crate) mod counting;
pub(crate) mod declared;
pub(crate) mod dimensioned;
pub(crate) mod document;
pub(crate) mod read;
pub(crate) mod reading;
pub(crate) mod template;
pub(crate) mod unit;
