//! Names and units of columns, such as `r_um`, `r [um]`, `r (um)`, `r/um` or `r`.

use crate::scene::{Dimension, SceneError, Unit};
use std::ops::Range;

/// A field without surrounding quotes and blanks, and its bytes.
pub(super) type Field<'t> = (&'t str, Range<usize>);

/// A column to read.
#[derive(Clone, Debug)]
pub(super) struct Column {
    /// The name as written in the header.
    pub(super) name: String,
    pub(super) index: usize,
    pub(super) unit: Option<Unit>,
    pub(super) place: Range<usize>,
}

/// Names of radii and heights.
const RADII: [&str; 6] = ["r", "x", "radius", "position", "distance", "lateral"];
const HEIGHTS: [&str; 6] = ["z", "f", "h", "height", "profile", "topography"];

/// Names of heights if no other column matches, as in a line scan y(x).
const ORDINATES: [&str; 2] = ["y", "y1"];

const HELP: &str = "expected a column r (or x, for a line scan) and a column z, with units as in r_um,z_nm";

/// Finds the columns of radius and height; `is_table` is true if there are numbers below the names.
///
/// # Errors
/// [`SceneError`] if a column is missing or duplicated, or its unit is not a length.
pub(super) fn chosen(fields: &[Field<'_>], is_table: bool, line_scan: bool) -> Result<(Column, Column), SceneError> {
    let all: Vec<(String, usize)> = fields.iter().enumerate().map(|(index, (text, _))| (parts(text).0.to_lowercase(), index)).collect();
    let place = |index: usize| fields.get(index).map_or(0..0, |(_, place)| place.clone());
    let find = |names: &[&str], what: &str| -> Result<Column, SceneError> {
        let found: Vec<usize> = all.iter().filter(|(name, _)| names.contains(&name.as_str())).map(|(_, index)| *index).collect();
        match found.as_slice() {
            [index] => {
                let (text, place) = fields.get(*index).cloned().unwrap_or(("", 0..0));
                Ok(Column { name: text.to_owned(), index: *index, unit: unit(text, &place)?, place })
            }
            // Do not echo the contents of a file that is not a table; it may be confidential.
            [] if !is_table => {
                Err(SceneError::missing(format!("the first line of the points does not contain a column of {what}")).help(HELP))
            }
            [] => {
                let seen: Vec<&str> = fields.iter().map(|(text, _)| *text).take(8).collect();
                let whole = place(0).start..place(fields.len().saturating_sub(1)).end;
                Err(SceneError::missing(format!("no column of {what} among {}", seen.join(", "))).help(HELP).at(whole))
            }
            [first, second, ..] => {
                let text = |index: &usize| fields.get(*index).map_or("", |(text, _)| *text);
                let message = format!("{} and {} are both columns of {what}", text(first), text(second));
                Err(SceneError::value(message).help("expected only one of them").at(place(*second)))
            }
        }
    };
    let wanted: &[&str] = if line_scan && all.iter().any(|(name, _)| name == "x") { &["x"] } else { &RADII };
    let radius = find(wanted, "radii")?;
    let any = all.iter().any(|(name, _)| HEIGHTS.contains(&name.as_str()));
    let ordinates = !any && all.iter().any(|(name, _)| ORDINATES.contains(&name.as_str()));
    let height = find(if ordinates { &ORDINATES } else { &HEIGHTS }, "heights")?;
    if !ordinates
        && parts(&radius.name).0.eq_ignore_ascii_case("x")
        && let Some((_, index)) = all.iter().find(|(name, _)| name == "y")
    {
        let message = "a map of a surface with columns x, y and z is not supported";
        return Err(SceneError::value(message).help("expected a profile r, z or a line scan x, z").at(place(*index)));
    }
    Ok((radius, height))
}

/// Splits a column name into name and unit.
pub fn parts(text: &str) -> (&str, Option<&str>) {
    let text = text.trim();
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some((name, rest)) = text.split_once(open)
            && let Some(unit) = rest.trim_end().strip_suffix(close)
        {
            return (name.trim(), Some(unit.trim()));
        }
    }
    let split = text.split_once(['_', '/', ' ']);
    split.map_or((text, None), |(name, unit)| (name.trim(), Some(unit.trim_start_matches('/').trim())))
}

fn unit(text: &str, place: &Range<usize>) -> Result<Option<Unit>, SceneError> {
    let Some(own) = parts(text).1 else { return Ok(None) };
    let unit = Unit::parse(own).map_err(|error| error.at(place.clone()))?;
    if unit.dimension() == Dimension::LENGTH {
        return Ok(Some(unit));
    }
    let message = format!("{own} is {}, not a length", unit.dimension());
    Err(SceneError::unit(message).help("expected a column of lengths such as z_nm").at(place.clone()))
}
