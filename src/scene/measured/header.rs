//! Names and units of columns: `r_um`, `r [um]`, `r (um)`, `r/um` or plain `r`.

use crate::scene::{Dimension, SceneError, Unit};
use std::ops::Range;

/// A field without quotes and blanks around it, and its bytes.
pub(super) type Field<'t> = (&'t str, Range<usize>);

/// A column that is read.
#[derive(Clone, Debug)]
pub(super) struct Column {
    /// As it stands in the header.
    pub(super) name: String,
    pub(super) index: usize,
    pub(super) unit: Option<Unit>,
    pub(super) place: Range<usize>,
}

/// What radii and heights may be called.
const RADII: [&str; 6] = ["r", "x", "radius", "position", "distance", "lateral"];
const HEIGHTS: [&str; 6] = ["z", "f", "h", "height", "profile", "topography"];

/// What a height is called where nothing else is one: a line scan y(x).
const ORDINATES: [&str; 2] = ["y", "y1"];

const HELP: &str = "a column r (or x, for a line scan) and a column z would be accepted, with units as in r_um,z_nm";

/// The columns of radius and height; `is_table` says whether numbers stand below the names.
///
/// # Errors
/// [`SceneError`] where one of them is missing or stands twice, or has a unit that is no length.
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
            [] if !is_table => Err(SceneError::missing(format!("the first line of the points names no column of {what}")).help(HELP)),
            [] => {
                let seen: Vec<&str> = fields.iter().map(|(text, _)| *text).take(8).collect();
                let whole = place(0).start..place(fields.len().saturating_sub(1)).end;
                Err(SceneError::missing(format!("there is no column of {what} among {}", seen.join(", "))).help(HELP).at(whole))
            }
            [first, second, ..] => {
                let text = |index: &usize| fields.get(*index).map_or("", |(text, _)| *text);
                let message = format!("{} and {} are both columns of {what}", text(first), text(second));
                Err(SceneError::value(message).help("one of them would be accepted").at(place(*second)))
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
        let message = "x, y and z make a map of a surface, which is not read";
        return Err(SceneError::value(message).help("a profile r, z or a line scan x, z would be accepted").at(place(*index)));
    }
    Ok((radius, height))
}

/// Name and unit as they stand.
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
    Err(SceneError::unit(message).help("a column of lengths such as z_nm would be accepted").at(place.clone()))
}
