//! What was meant where an operator is missing: edits of the text that make it an expression.

use super::error::Repair;
use super::{ParseError, Reason};
use std::ops::Range;

/// Most edits of one text.
const MOST_EDITS: usize = 40;
/// The longest text that is written out as a whole, in bytes.
const LONGEST: usize = 160;

impl Repair {
    /// The text with this edit.
    fn applied(self, text: &str) -> String {
        let part = |range: Range<usize>| text.get(range).unwrap_or_default();
        let joined = |left: &str, right: &str| format!("{}*{right}", left.trim_end());
        match self {
            Self::Insert { at } => joined(part(0..at), part(at..text.len())),
            Self::Enclose { from, to, at } => {
                let inside = match at {
                    Some(at) => joined(part(from..at), part(at..to)),
                    None => part(from..to).to_owned(),
                };
                // tan θ is tan(θ), without the blank between.
                let before = if at.is_none() { part(0..from).trim_end() } else { part(0..from) };
                format!("{before}({inside}){}", part(to..text.len()))
            }
        }
    }

    /// The advice about the place alone.
    pub(super) fn local(self, text: &str, first: &Range<usize>, second: &Range<usize>) -> String {
        let part = |range: Range<usize>| text.get(range).unwrap_or_default();
        let (one, two) = (part(first.clone()), part(second.clone()));
        if one.len() + two.len() > 40 {
            return "write every product with *, as in 2*r".to_owned();
        }
        match self {
            Self::Enclose { at: None, .. } => format!("write {one}({two})"),
            Self::Enclose { .. } => format!("write the divisor in parentheses, as in /({one}*{two})"),
            Self::Insert { .. } if two == "(" || two == "[" => format!("write every product with *, as in {one}*(…)"),
            Self::Insert { .. } => format!("write {one}*{two}"),
        }
    }
}

/// Adds the whole text as it was meant to an error about a missing operator, if that can be read.
pub(super) fn advised<T>(text: &str, read: impl Fn(&str) -> Result<T, ParseError>) -> Result<T, ParseError> {
    let error = match read(text) {
        Ok(value) => return Ok(value),
        Err(error) if edit(&error).is_none() || text.len() > LONGEST => return Err(error),
        Err(error) => error,
    };
    let (mut meant, mut next) = (text.to_owned(), edit(&error));
    for _ in 0..MOST_EDITS {
        let Some(repair) = next else { return Err(error) };
        meant = repair.applied(&meant);
        next = match read(&meant) {
            Ok(_) => return Err(error.advising(format!("write {}", meant.trim()))),
            Err(another) => edit(&another),
        };
    }
    Err(error)
}

/// The edit that an error calls for.
fn edit(error: &ParseError) -> Option<Repair> {
    match error.reason() {
        // R(1 - r) is a product: no function has so short a name.
        Reason::UnknownFunction { name } if name.chars().count() <= 2 => Some(Repair::Insert { at: error.span().end }),
        _ => error.repair(),
    }
}
