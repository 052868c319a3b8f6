//! Where a solver's coordinates put the axis: in a corner of the box, or in the order of a discrete Fourier transform.

/// How far the coordinates of a file reach, counted from the axis; computed units.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// The least coordinates along x and y.
    pub low: [f64; 2],
    /// The largest ones.
    pub high: [f64; 2],
}

impl Extent {
    /// Of no coordinates.
    pub const NONE: Self = Self { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };

    /// Takes one coordinate along x or y.
    pub fn take(&mut self, axis: usize, coordinate: f64) {
        if let (Some(low), Some(high)) = (self.low.get_mut(axis), self.high.get_mut(axis)) {
            (*low, *high) = (low.min(coordinate), high.max(coordinate));
        }
    }
}

/// One mistake about the place of the axis.
#[derive(Clone, Debug)]
pub struct Placing {
    /// Its short name.
    pub id: &'static str,
    pub(in crate::validate) text: &'static str,
    /// Where the axis lies along x and y, with the period of the coordinate where the data wrap around.
    along: [(f64, f64); 2],
    /// By how much coordinates are too large.
    scale: f64,
}

impl Placing {
    /// The coordinates of a place, counted from the axis.
    pub fn at(&self, x: f64, y: f64) -> (f64, f64) {
        let one = |(centre, period): (f64, f64), own: f64| {
            let own = own - centre;
            (if period.is_finite() { own - period * (own / period).round() } else { own }) / self.scale
        };
        let [first, second] = self.along;
        (one(first, x), if y.is_nan() { y } else { one(second, y) })
    }
}

/// Coordinates that begin this close to 0, as a share of their range, begin in a corner.
const BEGIN: f64 = 0.05;

/// Every known mistake that fits the coordinates; `side` is the side of the box where it is declared.
///
/// Coordinates of n pixels run from 0 to (n − 1)h or from h/2 to (n − ½)h, so the middle of the box is known to half a pixel;
/// those that run from 0 to nh have both ends of the box, and are too large by n/(n − 1).
pub fn placings(extent: &Extent, pixel: Option<f64>, side: Option<f64>) -> Vec<Placing> {
    const CORNER: &str =
        "the origin is in a corner of the domain: the axis of the data lies in the middle of their coordinates, which --origin corner says";
    const SHIFTED: &str =
        "the field is in the order of a discrete Fourier transform: its axis lies in the corners of the domain, as without fftshift";
    const UNSHIFTED: &str = "the field is in the order of a discrete Fourier transform: coordinates beyond half of the box count from its other side, as without fftshift";
    let pixel = pixel.unwrap_or(0.0);
    let [x, y] = [0, 1].map(|axis: usize| (extent.low.get(axis).copied(), extent.high.get(axis).copied()));
    let range = |own: (Option<f64>, Option<f64>)| own.0.zip(own.1).filter(|own| own.1 > own.0);
    let Some(x) = range(x) else { return Vec::new() };
    let y = range(y);
    let from_corner = |own: (f64, f64)| own.0 >= -BEGIN * (own.1 - own.0);
    if !from_corner(x) && y.is_some_and(from_corner) {
        return Vec::new();
    }
    // The middle and the period of one direction, for every way in which pixels may lie.
    let along = |own: (f64, f64), shift: f64, declared: bool| {
        let period = side.filter(|_| declared).unwrap_or(own.1 - own.0 + pixel);
        let middle = if declared && from_corner(own) { 0.5 * period } else { 0.5 * (own.0 + own.1) + shift };
        (middle, period)
    };
    let mut list: Vec<Placing> = Vec::new();
    // Both ends of the box are among the coordinates.
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
