//! The points of a file with columns x and y, or r, at which fields are requested.

use crate::scene::{Grid, Scene};
use crate::validate::ValidationError;
use crate::validate::file::column::Kind;
use crate::validate::file::data::{Data, Source};
use crate::validate::file::layout::Layout;
use crate::validate::file::table::Table;
use crate::validate::file::units::DataUnits;

/// Reads the points of a file from its columns x and y, or r, in computing units; other columns are ignored.
///
/// If the file repeats its points for several loads, only the points of the first load are read.
///
/// # Errors
/// [`ValidationError`] if the file cannot be read or has no such columns.
pub fn points(source: &Source<'_>, scene: &Scene) -> Result<Grid, ValidationError> {
    let fault = |message: String, help: &str| ValidationError::data(&source.name, None, message, help);
    let (layout, mut units) = (Layout::default(), DataUnits::default());
    let data = Data::of(source, &layout, scene)?;
    let Some(data) = data.first() else { return Err(fault("the file is empty".to_owned(), HELP)) };
    let mut table = Table::open(data)?;
    let mut column = |kind: Kind| -> Result<Option<(usize, f64)>, ValidationError> {
        let Some(index) = table.index(kind) else { return Ok(None) };
        let factor = table.columns.get(index).map(|own| units.factor(scene, &source.name, own)).transpose()?;
        Ok(factor.map(|factor| (index, factor)))
    };
    let (x, y, r) = (column(Kind::X)?, column(Kind::Y)?, column(Kind::Distance)?);
    let wanted = match (x, y, r) {
        (Some(x), Some(y), _) => vec![x, y],
        (_, _, Some(r)) => vec![r],
        _ => return Err(fault("no columns x and y, and no column r".to_owned(), HELP)),
    };
    let mut places = vec![Vec::new(); wanted.len()];
    let mut row = Vec::new();
    while table.next(&mut row)?.is_some() {
        for (list, (index, factor)) in places.iter_mut().zip(&wanted) {
            // A division by a whole number rounds only once, so that 30 um are 3e-5 m.
            let (number, inverse) = (row.get(*index).copied().unwrap_or(f64::NAN), (1.0 / factor).round());
            list.push(if *factor < 1.0 && 1.0 / inverse == *factor { number / inverse } else { number * factor });
        }
    }
    let mut places = places.into_iter();
    let x = places.next().unwrap_or_default();
    Ok(Grid::Points { x, y: places.next() }.checked()?)
}

const HELP: &str = "expected a first line such as x_um,y_um or r_um, followed by rows of numbers";
