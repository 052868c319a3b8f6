//! The pixel of every file: what is declared first, then what the file betrays, else only the order of the files.

use super::ValidationError;
use super::survey::{Content, Survey};
use crate::scene::Declared;

/// What is known of a file's grid; the pixel in computed units.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pixel {
    /// Pixels along a side of the box.
    pub(super) grid: Option<f64>,
    /// h.
    pub(super) pixel: Option<f64>,
    /// h, or a number in proportion to it.
    pub(super) relative: f64,
    /// The side of the box.
    pub(super) side: Option<f64>,
}

/// The pixels of the files of one kind, in the order in which they were given.
pub(super) fn pixels(
    surveys: &mut [&mut Survey<'_>],
    content: Content,
    declared: Option<&Declared>,
    grid: &[f64],
) -> Result<Vec<Pixel>, ValidationError> {
    let given = if grid.is_empty() { declared.map_or(&[][..], |own| &own.grid) } else { grid };
    let side = declared.and_then(|own| own.side);
    if !grid.is_empty() && grid.len() != surveys.len() {
        let what = if content == Content::Loads { "files of loads" } else { "files of pressures" };
        let message = format!("--grid has {} numbers for {} {what}", grid.len(), surveys.len());
        return Err(ValidationError::request(
            message,
            "one number per file, in the same order, such as --grid 64,128,256, would be accepted",
        ));
    }
    let mut list = Vec::new();
    for (index, survey) in surveys.iter_mut().enumerate() {
        let count = if given.len() == surveys_len(given, grid, index) { given.get(index).copied() } else { None };
        let betrayed = survey.lattice.map(|own| own.pixel).or(survey.counted);
        let stated = side.zip(count).map(|(side, count)| side / count);
        let pixel = stated.or(betrayed);
        match (stated, betrayed, survey.lattice) {
            (Some(stated), Some(betrayed), _) if (stated / betrayed - 1.0).abs() > 0.01 => {
                survey.notes.push(format!(
                    "box and grid make a pixel of {stated:.6e}, the data look like one of {betrayed:.6e} (in the scene's unit of length)"
                ));
            }
            (None, Some(betrayed), Some(lattice)) => {
                survey.notes.push(format!(
                    "inferred from the places: {}, pixel {betrayed:.6e} in the scene's unit of length",
                    lattice.offset.text()
                ));
            }
            (None, Some(betrayed), None) => {
                survey.notes.push(format!(
                    "inferred from the contact radii, which are counted in pixels: pixel {betrayed:.6e} in the scene's unit of length"
                ));
            }
            (None, None, _) => survey.notes.push("the pixel is not known: [data] box and grid would tell it".to_owned()),
            _ => {}
        }
        let side = side.or_else(|| pixel.zip(count).map(|(pixel, count)| pixel * count));
        list.push(Pixel { grid: count, pixel, relative: 0.0, side });
    }
    let all_known = list.iter().all(|own| own.pixel.is_some());
    let all_counted = list.iter().all(|own| own.grid.is_some());
    let mut halved = 1.0;
    for own in &mut list {
        own.relative = match (own.pixel, own.grid) {
            (Some(pixel), _) if all_known => pixel,
            (_, Some(count)) if all_counted => 1.0 / count,
            _ => halved,
        };
        halved *= 0.5;
    }
    Ok(list)
}

/// `[data]` may name more grids than there are files, or fewer: then only those of the first files are known.
fn surveys_len(given: &[f64], grid: &[f64], index: usize) -> usize {
    if grid.is_empty() && index >= given.len() { usize::MAX } else { given.len() }
}
