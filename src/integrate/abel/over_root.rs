//! A range that begins at the axis, over t = v^(1/N), in which the fractional powers of r are whole.

use crate::integrate::abel::pieces::{MOST_NODES, Piece, PieceNode, Range, proven_sum};
use crate::integrate::error::TransformError;
use crate::integrate::source::f_prime::Scratch;
use crate::integrate::source::leading_power::LeadingPower;
use crate::num::bounded::UNIT;
use crate::num::{Bounded, Estimate, Region};

/// The leading power from which on pieces of the variable itself take no more values than pieces of its root.
const FAST: f64 = 1.0;
/// Relative rounding error of t^N and of its derivative for each of the N factors, in units of the rounding of one operation: 3 for t,
/// the sum of a number and a product, and 1 for the multiplication.
const PER_FACTOR: f64 = 4.0;

/// The distances to both ends of a range, as regions of the complex plane.
#[derive(Clone, Copy)]
pub(crate) struct EndDistances {
    pub(crate) from_lower: Region,
    pub(crate) from_upper: Region,
    /// True if the piece is measured from the upper end.
    pub(crate) from_above: bool,
    /// True for a piece of the real axis.
    pub(crate) is_real: bool,
}

impl EndDistances {
    /// The distances of a piece with the ellipse of σ around it.
    pub(crate) fn of(piece: Piece, sigma: f64, width: f64) -> Self {
        let hair = 4.0 * UNIT * width;
        let (low, high, short) = piece.around(sigma);
        let near = Region::new((low, high), (-short, short));
        let far = Region::new((width - hair, width + hair), (0.0, 0.0)) - near;
        let (from_lower, from_upper) = if piece.from_above { (far, near) } else { (near, far) };
        Self { from_lower, from_upper, from_above: piece.from_above, is_real: sigma == 0.0 }
    }
}

/// A range whose integrand is a weight times a function of r with a leading power.
pub(crate) trait Weighted: Range {
    /// A bound on the integrand.
    fn largest_over(&mut self, distances: EndDistances) -> f64;

    /// A bound on the weight.
    fn weight_over(&mut self, distances: EndDistances) -> f64;

    /// r/v for a distance v from the axis; `None` if v is too large for a bound.
    fn ratio(&self, v: Region) -> Option<Region>;

    /// Takes into account that a distance has a further relative error, in units of the rounding of one operation.
    fn add_rounding(&mut self, units: f64);
}

/// As [`proven_sum`], over the root of the variable for each range that comes with a leading power, if the power is fractional and N is
/// at most `most_root`; over the variables themselves where that has no proof.
///
/// # Errors
/// As [`proven_sum`].
pub(crate) fn proven_sum_over_roots<R: Weighted + Clone>(
    ranges: &[(R, Option<&LeadingPower>)],
    most_root: i32,
    more: Bounded,
    tolerance: f64,
    at: f64,
) -> Result<Option<Estimate>, TransformError> {
    let mut over_roots: Vec<_> = ranges.iter().map(|(range, power)| OverRoot::of(range.clone(), *power, most_root)).collect();
    if over_roots.iter().any(|own| own.root.is_some())
        && let Some(found) = proven_sum(&mut over_roots, more, tolerance, at)?
    {
        return Ok(Some(found));
    }
    let mut plain: Vec<_> = ranges.iter().map(|(range, _)| range.clone()).collect();
    proven_sum(&mut plain, more, tolerance, at)
}

/// The range with v = t^N: the function r^s h(r^(1/N)) times N t^(N−1) is analytic at t = 0.
///
/// Over v itself, pieces next to the axis are halved some 50 to 100 times until the singularity of r^s no longer matters.
struct OverRoot<'a, R> {
    range: R,
    root: Option<Root<'a>>,
    slots: Vec<Region>,
}

struct Root<'a> {
    power: &'a LeadingPower,
    degree: i32,
    /// N s.
    whole: i32,
    /// The length of the range over v, and over t.
    before: f64,
    width: f64,
}

impl<'a, R: Weighted> OverRoot<'a, R> {
    /// The range over t, which begins at the axis; unchanged unless the power is fractional and below 1, has no logarithm, and N is
    /// at most `most`.
    ///
    /// The larger N is, the closer the singularities of f′ come to the real axis of t.
    fn of(mut range: R, power: Option<&'a LeadingPower>, most: i32) -> Self {
        let root = power.and_then(|power| {
            let (degree, whole) = power.whole_root().filter(|(degree, _)| power.exponent < FAST && (2..=most).contains(degree))?;
            let before = range.width();
            Some(Root { power, degree, whole, before, width: before.powf(1.0 / f64::from(degree)) })
        });
        if let Some(own) = &root {
            range.add_rounding(PER_FACTOR * f64::from(own.degree));
        }
        Self { range, root, slots: Vec::new() }
    }
}

impl Root<'_> {
    /// The distances over v, and dv/dt.
    fn place(&self, place: PieceNode) -> (PieceNode, f64) {
        let t = place.from_lower;
        let from_lower = t.powi(self.degree);
        let factor = f64::from(self.degree) * t.powi(self.degree - 1);
        let from_upper = if place.from_above { self.above(place.from_upper) } else { self.before - from_lower };
        (PieceNode { from_lower, from_upper, from_above: place.from_above }, factor)
    }

    /// The distance from the upper end over v for one over t.
    fn above(&self, t: f64) -> f64 {
        -self.before * (f64::from(self.degree) * (-t / self.width).ln_1p()).exp_m1()
    }

    /// The same for a region, and a bound on |dv/dt|.
    fn distances(&self, over_t: EndDistances) -> (EndDistances, f64) {
        let about = |length: f64| Region::new((length * (1.0 - 4.0 * UNIT), length * (1.0 + 4.0 * UNIT)), (0.0, 0.0));
        let (before, degree) = (about(self.before), f64::from(self.degree));
        let steepness = over_t.from_lower.powi(self.degree - 1).largest() * degree * (1.0 + 8.0 * UNIT);
        let from_lower = over_t.from_lower.powi(self.degree);
        let from_upper = if over_t.from_above {
            // 1 − (1 − q)^N = q Σ (1 − q)^k, accurate for small q.
            let share = over_t.from_upper * about(self.width).recip();
            let rest = Region::real(1.0) - share;
            before * share * (1..self.degree).fold(Region::real(1.0), |sum, _| Region::real(1.0) + sum * rest)
        } else {
            before - from_lower
        };
        (EndDistances { from_lower, from_upper, ..over_t }, steepness)
    }
}

impl<R: Weighted> Range for OverRoot<'_, R> {
    fn width(&self) -> f64 {
        self.root.as_ref().map_or_else(|| self.range.width(), |own| own.width)
    }

    fn size_at(&self, place: PieceNode) -> f64 {
        let Some(own) = &self.root else { return self.range.size_at(place) };
        let (place, factor) = own.place(place);
        self.range.size_at(place) * factor
    }

    /// Next to the axis |f′ dv/dt| = N |t|^(N−1+Ns) |c|^(Ns) |h| with r^(1/N) = t c and c = (r/v)^(1/N).
    fn largest(&mut self, piece: Piece, sigma: f64) -> f64 {
        let Some(own) = &self.root else { return self.range.largest(piece, sigma) };
        let over_t = EndDistances::of(piece, sigma, own.width);
        let (over_v, steepness) = own.distances(over_t);
        let ratio = if piece.from_above { None } else { self.range.ratio(over_v.from_lower) };
        let Some(ratio) = ratio else { return self.range.largest_over(over_v) * steepness };
        let t = over_t.from_lower;
        // The exponent 1/N is rounded.
        let c = ratio.power(Region::real(1.0 / f64::from(own.degree))) * Region::interval(1.0 - 1e-12, 1.0 + 1e-12);
        let powers = t.powi(own.degree - 1 + own.whole).largest() * c.powi(own.whole).largest() * (1.0 + 8.0 * UNIT);
        let largest = own.power.rest_at(t * c, &mut self.slots) * powers * f64::from(own.degree) * self.range.weight_over(over_v);
        if largest.is_nan() { f64::INFINITY } else { largest }
    }

    fn tail(&mut self, piece: Piece) -> f64 {
        let Some(own) = &self.root else { return self.range.tail(piece) };
        if !piece.from_above || piece.from > 0.0 {
            return f64::INFINITY;
        }
        let to = own.above(piece.to) * (1.0 + 64.0 * UNIT);
        self.range.tail(Piece { to, ..piece })
    }

    fn fill(&self, places: &[PieceNode], values: &mut [f64], errors: &mut [f64], scratch: &mut Scratch) {
        let Some(own) = &self.root else { return self.range.fill(places, values, errors, scratch) };
        let (mut over_v, mut factors) = ([PieceNode::default(); MOST_NODES], [0.0; MOST_NODES]);
        for ((place, moved), factor) in places.iter().zip(&mut over_v).zip(&mut factors) {
            (*moved, *factor) = own.place(*place);
        }
        self.range.fill(&over_v[..places.len()], values, errors, scratch);
        let rounding = PER_FACTOR * f64::from(own.degree) * UNIT;
        for ((value, error), factor) in values.iter_mut().zip(errors).zip(factors) {
            *value *= factor;
            *error = *error * factor + rounding * value.abs();
        }
    }
}
