//! Parses a file of points: comments, delimiter, header and numbers, each with its position.

use super::header::{Column, Field, chosen};
use crate::scene::SceneError;
use std::ops::Range;

/// Decodes a file as UTF-8, with or without byte order mark, or else as Latin-1.
///
/// The second value is true if the file is not UTF-8.
pub fn decoded(bytes: Vec<u8>) -> (String, bool) {
    match String::from_utf8(bytes) {
        Ok(text) => (text, false),
        Err(error) => (error.into_bytes().into_iter().map(char::from).collect(), true),
    }
}

/// The delimiter between two columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Delimiter {
    One(char),
    Blanks,
}

/// One row of numbers with the position of its radius.
#[derive(Clone, Debug)]
pub struct Row {
    /// The radius as written in the file.
    pub r: f64,
    /// The height.
    pub z: f64,
    pub(super) place: Range<usize>,
}

/// The rows of a file and the two columns that were read.
#[derive(Debug)]
pub struct Sheet {
    pub(super) radius: Column,
    pub(super) height: Column,
    /// One entry per line of numbers.
    pub rows: Vec<Row>,
    /// True if any number has a decimal comma.
    pub(super) decimal_comma: bool,
}

const HEADER: &str = "expected a header such as r_um,z_nm or r [um];z [um]; comments begin with #";

/// Reads the radius and the height of every row.
///
/// # Errors
/// [`SceneError`] with a position in the text of the file.
pub fn sheet(text: &str, line_scan: bool) -> Result<Sheet, SceneError> {
    let begin = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
    if text.contains('\0') {
        return Err(SceneError::value("the file is not text: it contains a zero byte").help("expected a text file in UTF-8"));
    }
    let mut lines = lines(text, begin).filter(|line| !text.get(line.clone()).unwrap_or_default().trim().is_empty()).peekable();
    let mut comment = None;
    let first = loop {
        let Some(line) = lines.peek().cloned() else {
            // Do not quote comments; they may be confidential.
            return Err(match comment {
                Some(_) => SceneError::missing("the file contains only comments").help(HEADER),
                None => SceneError::missing("the file is empty").help(HEADER).at(0..0),
            });
        };
        match body(text, &line) {
            Some(_) => break line,
            None => comment = lines.next(),
        }
    };
    let slice = |line: &Range<usize>| text.get(line.clone()).unwrap_or_default();
    let mut fields = Vec::new();
    let mut delimiter = sniffed(slice(&first));
    split(slice(&first), first.start, delimiter, &mut fields);
    let numbers = fields.iter().all(|(field, _)| number(field, delimiter).is_some());
    let columns = if numbers {
        // A header in a comment, as written by NumPy.
        let behind = comment.map(|line| {
            let skipped = slice(&line).find('#').map_or(0, |at| at + 1);
            line.start + skipped..line.end
        });
        let own = delimiter;
        let count = fields.len();
        let named = behind.filter(|line| {
            delimiter = sniffed(slice(line));
            split(slice(line), line.start, delimiter, &mut fields);
            fields.iter().any(|(field, _)| number(field, delimiter).is_none())
        });
        // The names may be separated by commas although the numbers are separated by blanks.
        if fields.len() == count {
            delimiter = own;
        }
        if named.is_none() {
            return Err(SceneError::missing("the first row contains numbers instead of column names").help(HEADER).at(first));
        }
        chosen(&fields, true, line_scan)?
    } else {
        lines.next();
        let mut below = Vec::new();
        if let Some(line) = lines.peek() {
            split(slice(line), line.start, delimiter, &mut below);
        }
        let is_table = below.len() == fields.len() && below.iter().all(|(field, _)| number(field, delimiter).is_some());
        chosen(&fields, is_table, line_scan)?
    };
    let count = fields.len();
    let (radius, height) = columns;
    let mut own = Sheet { radius, height, rows: Vec::new(), decimal_comma: false };
    for line in lines {
        if body(text, &line).is_none() {
            continue;
        }
        split(slice(&line), line.start, delimiter, &mut fields);
        if fields.len() == count + 1 && fields.last().is_some_and(|(field, _)| field.is_empty()) {
            fields.pop();
        }
        if fields.len() != count {
            let message = format!("this row has {}, but the header has {count}", counted(fields.len()));
            let help = if delimiter == Delimiter::One(',') {
                "expected as many fields as in the header; with decimal commas, separate the columns by ;"
            } else {
                "expected as many fields as in the header"
            };
            return Err(SceneError::value(message).help(help).at(line));
        }
        let mut read = |column: &Column| -> Result<(f64, Range<usize>), SceneError> {
            let (field, place) = fields.get(column.index).cloned().unwrap_or(("", line.clone()));
            let fault = |message: String| {
                Err(SceneError::value(message).help("expected a finite decimal number such as 0.25 or 1e-3").at(place.clone()))
            };
            let shown: String = field.chars().take(40).collect();
            match number(field, delimiter) {
                Some((value, comma)) if value.is_finite() => {
                    own.decimal_comma |= comma;
                    Ok((value, place))
                }
                Some(_) => fault(format!("{} = {shown} is not finite", column.name)),
                None if field.is_empty() => fault(format!("{} is empty", column.name)),
                None => fault(format!("{} = {shown:?} is not a number", column.name)),
            }
        };
        let ((r, place), (z, _)) = (read(&own.radius)?, read(&own.height)?);
        own.rows.push(Row { r, z, place });
    }
    if own.rows.is_empty() {
        return Err(SceneError::missing("the file contains a header but no rows").help("expected at least 4 rows").at(first));
    }
    Ok(own)
}

fn counted(fields: usize) -> String {
    if fields == 1 { "1 field".to_owned() } else { format!("{fields} fields") }
}

/// Returns the byte range of every line without its end.
fn lines(text: &str, begin: usize) -> impl Iterator<Item = Range<usize>> + '_ {
    // Classic Mac OS ends lines with a carriage return only.
    let end = if text.contains('\n') { '\n' } else { '\r' };
    let mut start = begin;
    text.get(begin..).unwrap_or_default().split(end).map(move |line| {
        let own = start..start + line.trim_end_matches('\r').len();
        start += line.len() + 1;
        own
    })
}

/// Returns the line, unless it is a comment.
fn body<'t>(text: &'t str, line: &Range<usize>) -> Option<&'t str> {
    text.get(line.clone()).filter(|own| !own.trim_start().starts_with('#'))
}

/// Returns the delimiter of a header: `;`, a tab or `,` if there is one, else blanks.
fn sniffed(line: &str) -> Delimiter {
    let mut quoted = false;
    let outside: String = line
        .chars()
        .filter(|c| {
            quoted ^= *c == '"';
            !quoted
        })
        .collect();
    [';', '\t', ','].into_iter().find(|c| outside.trim().contains(*c)).map_or(Delimiter::Blanks, Delimiter::One)
}

/// Splits a line into fields without surrounding quotes and blanks.
fn split<'t>(line: &'t str, start: usize, delimiter: Delimiter, fields: &mut Vec<Field<'t>>) {
    fields.clear();
    let mut push = |from: usize, to: usize| {
        let raw = line.get(from..to).unwrap_or_default();
        let inner = raw.trim();
        let bare = inner.strip_prefix('"').and_then(|own| own.strip_suffix('"')).unwrap_or(inner).trim();
        let offset = start + from + raw.find(bare).unwrap_or(0);
        fields.push((bare, offset..offset + bare.len()));
    };
    let (mut from, mut quoted, mut bracket) = (0, false, false);
    for (at, c) in line.char_indices() {
        match c {
            '"' => quoted = !quoted,
            '[' | '(' => bracket = true,
            ']' | ')' => bracket = false,
            _ => {}
        }
        match delimiter {
            Delimiter::One(own) if c == own && !quoted => {
                push(from, at);
                from = at + c.len_utf8();
            }
            Delimiter::Blanks if c.is_whitespace() && !quoted && !bracket => {
                // A unit in brackets belongs to the preceding name.
                let unit = line.get(at..).unwrap_or_default().trim_start().starts_with(['[', '(']);
                if !unit {
                    if line.get(from..at).is_some_and(|own| !own.trim().is_empty()) {
                        push(from, at);
                    }
                    from = at + c.len_utf8();
                }
            }
            _ => {}
        }
    }
    if delimiter != Delimiter::Blanks || line.get(from..).is_some_and(|own| !own.trim().is_empty()) {
        push(from, line.len());
    }
}

/// Parses the number of a field; the second value is true if it has a decimal comma.
fn number(field: &str, delimiter: Delimiter) -> Option<(f64, bool)> {
    if let Ok(value) = field.parse() {
        return Some((value, false));
    }
    let one_comma = delimiter != Delimiter::One(',') && field.matches(',').count() == 1 && !field.contains('.');
    one_comma.then(|| field.replace(',', ".").parse().ok()).flatten().map(|value| (value, true))
}
