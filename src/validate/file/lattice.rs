//! The pixel of a lattice from the distances of its points to the axis, or from contact areas counted in pixels.

use std::collections::BTreeMap;

/// The position of the axis in the lattice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Offset {
    /// On the centre of a pixel: r² = (i² + j²) h².
    Centre,
    /// On a corner: r² = ((i + ½)² + (j + ½)²) h².
    Corner,
    /// Evenly spaced radii of an unknown lattice.
    Line,
}

impl Offset {
    pub(in crate::validate) fn text(self) -> &'static str {
        match self {
            Self::Centre => "a square lattice with the axis on the centre of a pixel",
            Self::Corner => "a square lattice with the axis on the corner of a pixel",
            Self::Line => "evenly spaced radii",
        }
    }

    /// 4 r²/h² of a pixel.
    fn quarters(self, i: u64, j: u64) -> u64 {
        let (x, y) = match self {
            Self::Centre | Self::Line => (2 * i, 2 * j),
            Self::Corner => (2 * i + 1, 2 * j + 1),
        };
        x * x + y * y
    }
}

/// A lattice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice {
    /// The distance between neighbours.
    pub pixel: f64,
    /// The position of the axis.
    pub offset: Offset,
}

/// Returns the values of 4 r²/h² with their numbers of pixels, up to a limit.
pub(in crate::validate) fn shells(offset: Offset, most: u64) -> BTreeMap<u64, u64> {
    let mut shells = BTreeMap::new();
    let reach = most.isqrt() / 2 + 1;
    for i in 0..=reach {
        for j in 0..=reach {
            let own = offset.quarters(i, j);
            if own <= most {
                let mirrored = |n: u64, half: bool| if half || n > 0 { 2 } else { 1 };
                let half = offset == Offset::Corner;
                *shells.entry(own).or_insert(0) += mirrored(i, half) * mirrored(j, half);
            }
        }
    }
    shells
}

/// Returns 4 r²/h² of a distance if it is nearly a whole number.
pub(in crate::validate) fn quarters(r: f64, pixel: f64) -> Option<u64> {
    let q = 4.0 * (r / pixel).powi(2);
    let whole = q.round();
    ((q - whole).abs() <= 0.05_f64.min(1e-3 + 4e-6 * q) && whole < 1e15).then_some(whole as u64)
}

/// Returns the largest pixel whose lattice contains all of these distances, the smallest ones of a file in increasing order.
pub fn of_distances(r: &[f64]) -> Option<Lattice> {
    let first = r.iter().copied().find(|r| *r > 0.0)?;
    let last = *r.last()?;
    if r.len() < 4 {
        return None;
    }
    // Evenly spaced radii are also part of a lattice, whose pixel is their spacing.
    let spacing = r.windows(2).map(|pair| pair[1] - pair[0]);
    let (least, most) = spacing.fold((f64::INFINITY, 0.0_f64), |(low, high), own| (low.min(own), high.max(own)));
    if most - least <= 1e-4 * most {
        return Some(Lattice { pixel: most, offset: Offset::Line });
    }
    let mut best: Option<Lattice> = None;
    for offset in [Offset::Centre, Offset::Corner] {
        if offset != Offset::Centre && r.first() == Some(&0.0) {
            continue;
        }
        for nearest in shells(offset, 200).into_keys().filter(|own| *own > 0) {
            let pixel = first / (nearest as f64).sqrt() * 2.0;
            if best.is_some_and(|own| own.pixel >= pixel) {
                break;
            }
            let reach = 4.0 * (last / pixel).powi(2);
            if reach > 4e6 {
                break;
            }
            let known = shells(offset, reach as u64 + 8);
            if r.iter().all(|r| quarters(*r, pixel).is_some_and(|own| known.contains_key(&own))) {
                best = Some(Lattice { pixel, offset });
                break;
            }
        }
    }
    best
}

/// Returns the pixel from distinct contact radii a = √(N h²/π) with their loads: the largest h for which every N is whole, beyond chance.
///
/// Radii that follow a power law of the load to less than one pixel of area were computed, not counted.
pub fn of_areas(radii: &[(f64, f64)]) -> Option<f64> {
    let pixel = largest_unit(radii)?;
    let logs: Vec<(f64, f64)> = radii.iter().filter(|own| own.0 > 0.0 && own.1 > 0.0).map(|(a, load)| (load.ln(), a.ln())).collect();
    let n = logs.len() as f64;
    let mean = logs.iter().fold((0.0, 0.0), |sum, own| (sum.0 + own.0 / n, sum.1 + own.1 / n));
    let (sxx, sxy) = logs.iter().fold((0.0, 0.0), |sum, (x, y)| (sum.0 + (x - mean.0).powi(2), sum.1 + (x - mean.0) * (y - mean.1)));
    let slope = if sxx > 0.0 { sxy / sxx } else { 0.0 };
    let off = |(x, y): &(f64, f64)| {
        let fitted = (mean.1 + slope * (x - mean.0)).exp();
        std::f64::consts::PI * (y.exp().powi(2) - fitted * fitted).abs() / (pixel * pixel)
    };
    logs.iter().any(|own| off(own) > 0.5).then_some(pixel)
}

fn largest_unit(radii: &[(f64, f64)]) -> Option<f64> {
    const MOST_INTERVALS: u32 = 200_000;
    let areas: Vec<f64> = radii.iter().map(|(a, _)| std::f64::consts::PI * a * a).collect();
    let least = areas.iter().copied().fold(f64::INFINITY, f64::min);
    if areas.len() < 4 || least <= 0.0 {
        return None;
    }
    // One wrong area of several does not hide the unit of the others.
    let may_miss = usize::from(areas.len() >= 6);
    for count in 1..=MOST_INTERVALS {
        let unit = least / f64::from(count);
        // Expected number of trials that would succeed by chance.
        let (mut chance, mut missed) = (f64::from(count), 0);
        for area in &areas {
            let n = area / unit;
            let slack = (1e-6 + 1.5e-7 * n).min(0.5);
            if (n - n.round()).abs() > slack {
                missed += 1;
                chance *= areas.len() as f64;
            } else if *area != least {
                chance *= 2.0 * slack;
            }
            if missed > may_miss {
                break;
            }
        }
        if missed == 0 || (missed <= may_miss && chance < 1e-6) {
            return (chance < 1e-4).then(|| unit.sqrt());
        }
    }
    None
}
