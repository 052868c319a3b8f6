//! The pixel of every file: what is declared first, then what the file betrays, else only the order of the files.

use crate::scene::Declared;
use crate::validate::file::survey::{Content, Survey};
use crate::validate::{Suspicion, ValidationError};

/// What is known of a file's grid; the pixel in computed units.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::validate) struct Pixel {
    /// Pixels along a side of the box.
    pub(in crate::validate) grid: Option<f64>,
    /// h.
    pub(in crate::validate) pixel: Option<f64>,
    /// h, or a number in proportion to it.
    pub(in crate::validate) relative: f64,
    /// The side of the box.
    pub(in crate::validate) side: Option<f64>,
    /// The pixel that the places or the contact radii of the data show.
    seen: Option<f64>,
    /// Ratio of the pixel of the places to that of box and grid; for contact radii, the ratio of the areas of the pixels.
    mismatch: Option<f64>,
    /// The side of the square that the places fill, where another box or a smaller grid is declared.
    filled: Option<f64>,
    /// True where contact radii show the pixel, not places.
    by_radii: bool,
}

impl Pixel {
    /// True where the places of the data cannot belong to the box and the grid that are declared: places may be left out, but not added.
    fn contradicts(&self) -> bool {
        const SLACK: f64 = 0.01;
        self.filled.is_some() || self.mismatch.is_some_and(|ratio| (ratio / ratio.round().max(1.0) - 1.0).abs() > SLACK)
    }
}

/// What is wrong with the box or the order of the files, where the data contradict what is declared.
pub(in crate::validate) fn contradiction(pixels: &[Pixel]) -> Option<Suspicion> {
    let worst = pixels.iter().find(|own| own.contradicts());
    if let Some(before) = in_another_order(pixels) {
        let text = "files in the wrong order: the numbers of pixels fit the data only in another order of the files".to_owned();
        return Some(Suspicion { id: "file-order", text, before, after: 0.0 });
    }
    let worst = worst?;
    let text = match (worst.filled, worst.grid, worst.seen) {
        (Some(side), Some(count), Some(h)) => {
            format!("another grid: the places of the data fill a square of {:.0} pixels along a side, not of {count}", side / h)
        }
        (Some(side), ..) => {
            format!("another box: the places of the data fill a square of {side:.6} in the scene's unit of length, not the declared box")
        }
        (None, Some(count), Some(h)) if worst.by_radii => format!(
            "another box: the contact radii are counted in pixels of {h:.6}, and with that grid fit a box of {:.6} in the scene's unit of length or a whole fraction of it, not the declared one",
            h * count
        ),
        (None, count, h) => format!(
            "another box: with that grid the places of the data fit a box of {:.6} in the scene's unit of length, not the declared one",
            count.zip(h).map_or(f64::NAN, |(count, h)| count * h)
        ),
    };
    let ratio = worst.filled.zip(worst.side).map(|(filled, side)| filled / side).or(worst.mismatch);
    Some(Suspicion { id: "box", text, before: ratio.map_or(0.0, |own| (own - 1.0).abs()), after: 0.0 })
}

/// Returns the relative difference of the boxes that numbers of pixels and pixels make file by file, if sorting both makes one box.
fn in_another_order(pixels: &[Pixel]) -> Option<f64> {
    const SAME: f64 = 0.02;
    let mut counts: Vec<f64> = pixels.iter().map(|own| own.grid).collect::<Option<_>>()?;
    let mut sizes: Vec<f64> = pixels.iter().map(|own| own.seen).collect::<Option<_>>()?;
    let difference = |counts: &[f64], sizes: &[f64]| {
        let sides = || counts.iter().zip(sizes).map(|(count, size)| count * size);
        sides().fold(0.0, f64::max) / sides().fold(f64::INFINITY, f64::min) - 1.0
    };
    let as_given = difference(&counts, &sizes);
    counts.sort_by(f64::total_cmp);
    sizes.sort_by(|one, other| other.total_cmp(one));
    (as_given > SAME && difference(&counts, &sizes) <= SAME).then_some(as_given)
}

/// The pixels of the files of one kind, in the order in which they were given.
pub(in crate::validate) fn pixels(
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
        let of_places = survey.lattice.map(|own| own.pixel).zip(stated).map(|(own, stated)| own / stated);
        // All areas are multiples of this pixel, which may consist of several true ones: of four if the contact is symmetrical.
        let of_radii = survey.counted.filter(|_| survey.lattice.is_none()).zip(stated).map(|(own, stated)| (own / stated).powi(2));
        let mismatch = of_places.or(of_radii);
        let filled = survey.filled_square().filter(|own| match (side, count, betrayed) {
            // Coordinates may begin and end on the sides of the box, or half a pixel inside.
            (Some(side), None, Some(h)) => [0.0, 1.0].iter().all(|pixels| (own - side - pixels * h).abs() > 0.25 * h),
            (None, Some(count), Some(h)) => *own > (count + 0.5) * h,
            _ => false,
        });
        // What the data show is true of them, whatever is declared; contact radii tell less surely.
        let disagrees = Pixel { mismatch, ..Pixel::default() }.contradicts();
        let pixel = if disagrees && survey.lattice.is_some() { betrayed.or(stated) } else { stated.or(betrayed) };
        match (stated, betrayed, survey.lattice) {
            (Some(stated), Some(betrayed), _) if disagrees || (survey.lattice.is_some() && (stated / betrayed - 1.0).abs() > 0.01) => {
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
        list.push(Pixel { grid: count, pixel, relative: 0.0, side, seen: betrayed, mismatch, filled, by_radii: survey.lattice.is_none() });
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
