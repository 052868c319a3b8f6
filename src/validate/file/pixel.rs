//! The pixel of every file: declared, or else inferred from the data; if neither is possible, only the order of the files is known.

use crate::scene::Declared;
use crate::validate::file::column::Kind;
use crate::validate::file::survey::{Content, Survey};
use crate::validate::{Suspicion, ValidationError};

/// The known properties of a file's grid, with the pixel in computing units.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::validate) struct Pixel {
    /// Number of pixels along a side of the box.
    pub(in crate::validate) grid: Option<f64>,
    /// h.
    pub(in crate::validate) pixel: Option<f64>,
    /// h, or a number proportional to it.
    pub(in crate::validate) relative: f64,
    /// The side of the box.
    pub(in crate::validate) side: Option<f64>,
    /// The pixel inferred from the coordinates or the contact radii of the data.
    seen: Option<f64>,
    /// Ratio of the pixel of the coordinates to the pixel of box and grid; for contact radii, the ratio of the pixel areas.
    mismatch: Option<f64>,
    /// The side of the square that the points fill, if a different box or a smaller grid is declared.
    filled: Option<f64>,
    /// True if the pixel is inferred from contact radii instead of coordinates.
    by_radii: bool,
}

impl Pixel {
    /// Returns true if the points cannot belong to the declared box and grid: points may be missing, but there cannot be additional points.
    fn contradicts(&self) -> bool {
        const SLACK: f64 = 0.01;
        self.filled.is_some() || self.mismatch.is_some_and(|ratio| (ratio / ratio.round().max(1.0) - 1.0).abs() > SLACK)
    }
}

/// Returns the fault in the box or the order of the files if the data contradict the declaration.
pub(in crate::validate) fn contradiction(pixels: &[Pixel], length: &dyn Fn(f64) -> String) -> Option<Suspicion> {
    let worst = pixels.iter().find(|own| own.contradicts());
    if let Some(before) = in_another_order(pixels) {
        let text = "files in the wrong order: the numbers of pixels fit the data only in another order".to_owned();
        return Some(Suspicion { id: "file-order", text, before, after: 0.0 });
    }
    let worst = worst?;
    let text = match (worst.filled, worst.grid, worst.seen) {
        (Some(side), Some(count), Some(h)) => {
            format!("another grid: the points of the data fill a square of {:.0} pixels along a side, not {count}", side / h)
        }
        (Some(side), ..) => {
            format!(
                "another box: the points of the data fill a square with a side of {}, which differs from the declared box",
                length(side)
            )
        }
        (None, Some(count), Some(h)) if worst.by_radii => format!(
            "another box: the contact radii are counted in pixels of {}; with the declared grid, they fit a box of {} or a whole fraction of it, not the declared box",
            length(h),
            length(h * count)
        ),
        (None, count, h) => format!(
            "another box: with the declared grid, the points of the data fit a box of {}, not the declared box",
            length(count.zip(h).map_or(f64::NAN, |(count, h)| count * h))
        ),
    };
    let ratio = worst.filled.zip(worst.side).map(|(filled, side)| filled / side).or(worst.mismatch);
    Some(Suspicion { id: "box", text, before: ratio.map_or(0.0, |own| (own - 1.0).abs()), after: 0.0 })
}

/// Returns the relative difference of the boxes computed file by file, if sorting both the numbers of pixels and the pixels gives a single box.
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

/// Returns the pixels of the files of one kind, in the given order.
pub(in crate::validate) fn pixels(
    surveys: &mut [&mut Survey<'_>],
    content: Content,
    declared: Option<&Declared>,
    grid: &[f64],
    length: &dyn Fn(f64) -> String,
) -> Result<Vec<Pixel>, ValidationError> {
    let given = if grid.is_empty() { declared.map_or(&[][..], |own| &own.grid) } else { grid };
    let side = declared.and_then(|own| own.side);
    if !grid.is_empty() && grid.len() != surveys.len() {
        let what = if content == Content::Loads { "loads" } else { "fields" };
        let files = if surveys.len() == 1 { "there is 1 file".to_owned() } else { format!("there are {} files", surveys.len()) };
        let numbers = if grid.len() == 1 { "1 number".to_owned() } else { format!("{} numbers", grid.len()) };
        return Err(ValidationError::request(
            format!("the grid has {numbers}, but {files} of {what}"),
            "expected one number for each file, in the order of the files, such as 64,128,256",
        ));
    }
    let mut list = Vec::new();
    for (index, survey) in surveys.iter_mut().enumerate() {
        let count = if given.len() == surveys_len(given, grid, index) { given.get(index).copied() } else { None };
        let betrayed = survey.lattice.map(|own| own.pixel).or(survey.counted);
        let stated = side.zip(count).map(|(side, count)| side / count);
        let of_places = survey.lattice.map(|own| own.pixel).zip(stated).map(|(own, stated)| own / stated);
        // All areas are multiples of this pixel, which may consist of several true pixels, such as four for a symmetric contact.
        let of_radii = survey.counted.filter(|_| survey.lattice.is_none()).zip(stated).map(|(own, stated)| (own / stated).powi(2));
        let mismatch = of_places.or(of_radii);
        // The pixels of an array without coordinates are those of the grid.
        let placed = survey.data.arrays.as_ref().is_some_and(|own| own.placed);
        let whole = side.zip(count).zip(betrayed).filter(|((side, count), h)| placed && (side / h - count).abs() > 0.5);
        let filled = whole.map(|((side, _), _)| side).or_else(|| {
            survey.filled_square().filter(|own| match (side, count, betrayed) {
                // Coordinates may begin and end on the sides of the box, or half a pixel inside.
                (Some(side), None, Some(h)) => [0.0, 1.0].iter().all(|pixels| (own - side - pixels * h).abs() > 0.25 * h),
                (None, Some(count), Some(h)) => *own > (count + 0.5) * h,
                _ => false,
            })
        });
        // The data take precedence over the declaration, except for contact radii, which are less reliable.
        let disagrees = Pixel { mismatch, ..Pixel::default() }.contradicts();
        let pixel = if disagrees && survey.lattice.is_some() { betrayed.or(stated) } else { stated.or(betrayed) };
        match (stated, betrayed, survey.lattice) {
            (Some(stated), Some(betrayed), _) if disagrees || (survey.lattice.is_some() && (stated / betrayed - 1.0).abs() > 0.01) => {
                survey.notes.push(format!(
                    "box and grid give a pixel of {}, but the data have a pixel of {}",
                    length(stated),
                    length(betrayed)
                ));
            }
            (None, Some(betrayed), Some(lattice)) => {
                survey.notes.push(format!("inferred from the points: {}, pixel {}", lattice.offset.text(), length(betrayed)));
            }
            (None, Some(betrayed), None) => {
                survey.notes.push(format!("inferred from the contact radii, which are counted in pixels: pixel {}", length(betrayed)));
            }
            (None, None, _) => survey.notes.push(unknown_pixel(survey.index(Kind::ContactRadius).is_some())),
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

/// `[data]` may contain more or fewer grids than there are files; then only the grids of the first files are known.
fn surveys_len(given: &[f64], grid: &[f64], index: usize) -> usize {
    if grid.is_empty() && index >= given.len() { usize::MAX } else { given.len() }
}

/// Returns the note that the pixel is not known, on which the tolerance of contact radii depends.
fn unknown_pixel(has_radii: bool) -> String {
    let effect = if has_radii { ", so that contact radii fail only if they are off by more than 15 %" } else { "" };
    format!("the pixel is not known{effect}; for a solver on a regular grid, set box and grid in [data]")
}
