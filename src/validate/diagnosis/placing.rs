//! Mistakes about the position of the axis: in a corner of the domain, or in the order of a discrete Fourier transform.

/// The range of the coordinates in a file, relative to the axis, in computing units.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// The smallest coordinates along x and y.
    pub low: [f64; 2],
    /// The largest coordinates along x and y.
    pub high: [f64; 2],
}

impl Extent {
    /// Returns an empty range.
    pub const NONE: Self = Self { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };

    /// Adds one coordinate along x or y.
    pub fn take(&mut self, axis: usize, coordinate: f64) {
        if let (Some(low), Some(high)) = (self.low.get_mut(axis), self.high.get_mut(axis)) {
            (*low, *high) = (low.min(coordinate), high.max(coordinate));
        }
    }
}

/// A mistake about the position of the axis.
#[derive(Clone, Debug)]
pub struct Placing {
    /// A short name.
    pub id: &'static str,
    pub(in crate::validate) text: &'static str,
    /// The position of the axis along x and y, with the period of the coordinate for data that wrap around.
    along: [(f64, f64); 2],
    /// The factor by which coordinates are too large.
    scale: f64,
}

impl Placing {
    /// Returns the coordinates of a point relative to the axis.
    pub fn at(&self, x: f64, y: f64) -> (f64, f64) {
        let one = |(centre, period): (f64, f64), own: f64| {
            let own = own - centre;
            (if period.is_finite() { own - period * (own / period).round() } else { own }) / self.scale
        };
        let [first, second] = self.along;
        (one(first, x), if y.is_nan() { y } else { one(second, y) })
    }
}

/// Coordinates begin in a corner if they begin this close to 0, relative to their range.
const BEGIN: f64 = 0.05;

/// Returns every known mistake that fits the coordinates; `side` is the declared side of the domain.
///
/// Coordinates of n pixels run from 0 to (n − 1)h or from h/2 to (n − ½)h, so the middle of the box is known to half a pixel;
/// coordinates from 0 to nh include both ends of the box, and are too large by n/(n − 1).
pub fn placings(extent: &Extent, pixel: Option<f64>, side: Option<f64>) -> Vec<Placing> {
    const CORNER: &str = "the origin is in a corner of the domain: the axis of the data is in the middle of the coordinates; state this origin together with the side of the box";
    const SHIFTED: &str =
        "the field is in the order of a discrete Fourier transform: the axis is in the corners of the domain; apply fftshift";
    const UNSHIFTED: &str = "the field is in the order of a discrete Fourier transform: the second half of the coordinates belongs to the other side; apply fftshift";
    let pixel = pixel.unwrap_or(0.0);
    let [x, y] = [0, 1].map(|axis: usize| (extent.low.get(axis).copied(), extent.high.get(axis).copied()));
    let range = |own: (Option<f64>, Option<f64>)| own.0.zip(own.1).filter(|own| own.1 > own.0);
    let Some(x) = range(x) else { return Vec::new() };
    let y = range(y);
    let from_corner = |own: (f64, f64)| own.0 >= -BEGIN * (own.1 - own.0);
    if !from_corner(x) && y.is_some_and(from_corner) {
        return Vec::new();
    }
    // The middle and the period in one direction, for every possible position of the pixels.
    let along = |own: (f64, f64), shift: f64, declared: bool| {
        let period = side.filter(|_| declared).unwrap_or(own.1 - own.0 + pixel);
        let middle = if declared && from_corner(own) { 0.5 * period } else { 0.5 * (own.0 + own.1) + shift };
        (middle, period)
    };
    let mut list: Vec<Placing> = Vec::new();
    // Both ends of the box are included.
    let both_ends = side.is_some_and(|side| (x.1 - x.0 - side).abs() < 0.25 * pixel);
    let scales = [Some(1.0), both_ends.then(|| (x.1 - x.0) / (x.1 - x.0 - pixel).max(pixel))];
    for (shift, declared) in [(0.5 * pixel, false), (0.0, false), (0.0, true)] {
        if declared && side.is_none() {
            continue;
        }
        let both = [Some(x), y].map(|own| own.map_or((0.0, f64::INFINITY), |own| along(own, shift, declared)));
        for scale in scales.into_iter().flatten() {
            let mut add = |id, text, along| list.push(Placing { id, text, along, scale });
            let first_pixel = both.map(|own| (own.0 - 0.5 * own.1, own.1));
            if from_corner(x) {
                add("origin-corner", CORNER, both.map(|own| (own.0, f64::INFINITY)));
                add("fftshift", UNSHIFTED, both.map(|own| (0.0, own.1)));
                add("fftshift", UNSHIFTED, first_pixel);
            } else {
                add("fftshift", SHIFTED, first_pixel);
            }
        }
    }
    list
}
