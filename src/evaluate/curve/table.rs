//! The second stage: g, F or G as low-degree polynomials between breakpoints, for large numbers of values.

use super::piece::{Integral, Piece, Share, SquaredRadius};
use super::source::power;
use crate::derive::stream::Stream;
use crate::integrate::error::TransformError;
use crate::num::spectral::{LOCAL, Local, local_nodes};
use crate::num::{Estimate, work};

/// One quantity over [0, reach].
pub(super) struct Table {
    spans: Vec<Span>,
}

/// From one breakpoint to the next: the quantity is x^m w^q times a function of w or √w, w = x² − k².
struct Span {
    anchor: f64,
    to: f64,
    /// 1/w at the end.
    scale: f64,
    /// True if the function is analytic in w, false if only in √w.
    square: bool,
    front: Front,
    /// The index of leaves by position; empty if the quantity vanishes.
    cells: Vec<u32>,
    leaves: Vec<Leaf>,
}

/// The factor before the polynomial.
#[derive(Clone, Copy, Debug)]
struct Front {
    /// True for a factor x.
    x: bool,
    /// The power of w.
    w: f64,
}

struct Leaf {
    /// The end of the leaf, as a fraction of the span.
    to: f64,
    middle: f64,
    scale: f64,
    local: Local,
    error: f64,
}

/// Maximum number of halvings of a leaf.
const DEEPEST: u32 = 44;
/// Cells of the position index, as a power of 2.
const CELLS: u32 = 9;
/// Maximum number of leaves of a curve.
const MOST_LEAVES: usize = 20_000;
/// Number of polynomials compared with another computation.
const MOST_COMPARED: usize = 256;
/// Number of points processed together.
const CHUNK: usize = 128;

impl Table {
    /// # Errors
    /// [`TransformError::NotComputable`] if the quantity is too irregular for polynomials.
    pub(super) fn new(pieces: &[Piece], kind: Integral, breakpoints: &[f64], reach: f64) -> Result<Self, TransformError> {
        let mut spans = Vec::new();
        let mut ends: Vec<f64> = breakpoints.to_vec();
        ends.push(reach);
        let mut from = 0.0;
        for to in ends {
            spans.push(Span::new(pieces, kind, from, to)?);
            from = to;
        }
        Ok(Self { spans })
    }

    /// Value and error at one place of [0, reach].
    pub(super) fn at(&self, x: f64) -> (f64, f64) {
        let Some(span) = self.spans.iter().find(|span| x <= span.to) else { return (f64::NAN, f64::NAN) };
        let w = (x - span.anchor) * (x + span.anchor);
        let Some((leaf, u)) = span.locate(w) else { return (0.0, 0.0) };
        let front = span.front.at(x, w);
        let value = leaf.local.at(u) * front;
        (value, leaf.error * front + 6.0 * f64::EPSILON * value.abs())
    }

    /// The derivative by x at one place.
    pub(super) fn derivative(&self, x: f64) -> f64 {
        let Some(span) = self.spans.iter().find(|span| x <= span.to) else { return f64::NAN };
        let w = (x - span.anchor) * (x + span.anchor);
        let Some((leaf, u)) = span.locate(w) else { return 0.0 };
        let (front, value) = (span.front.at(x, w), leaf.local.at(u));
        let inner = leaf.local.slope(u) * leaf.scale * if span.square { span.scale * 2.0 * x } else { span.scale.sqrt() * x / w.sqrt() };
        let own = if span.front.x { 1.0 / x } else { 0.0 } + span.front.w * 2.0 * x / w;
        front * (inner + own * value)
    }

    /// Values at many places of [0, reach].
    pub(super) fn fill(&self, places: &[f64], out: &mut [f64]) {
        for (places, out) in places.chunks(CHUNK).zip(out.chunks_mut(CHUNK)) {
            let mut from = 0;
            // Runs of points in one span are processed in tight loops; sorted points form long runs.
            while let Some(first) = places.get(from) {
                let Some(span) = self.spans.iter().find(|span| *first <= span.to) else { break };
                let inside = |x: &f64| *x <= span.to && (*x > span.anchor || span.anchor == 0.0 || x == first);
                let count = places.iter().skip(from).take_while(|x| inside(x)).count().max(1);
                if let (Some(places), Some(out)) = (places.get(from..from + count), out.get_mut(from..from + count)) {
                    span.fill(places, out);
                }
                from += count;
            }
        }
    }

    /// The largest absolute value and the largest absolute error over the table's nodes.
    pub(super) fn extremes(&self) -> (f64, f64) {
        let (mut value, mut error) = (0.0_f64, 0.0_f64);
        for span in &self.spans {
            let mut from = 0.0;
            for leaf in &span.leaves {
                for share in [from, leaf.middle, leaf.to] {
                    let w = if span.square { share } else { share * share } / span.scale;
                    let x = SquaredRadius::new(span.anchor, w).x.min(span.to);
                    let (own, own_error) = self.at(x);
                    value = value.max(own.abs());
                    error = error.max(own_error);
                }
                from = leaf.to;
            }
        }
        (value, error)
    }

    /// Compares every polynomial with another computation at a random point, and the first polynomial after a breakpoint also
    /// close to the breakpoint. If they disagree, the errors of this and adjacent polynomials grow to three times the difference.
    ///
    /// Of very many polynomials an evenly spaced selection is compared, and the largest growth applies to all.
    pub(super) fn examine(&mut self, stream: &mut Stream, exact: impl Fn(f64) -> Result<Estimate, TransformError>) {
        let stride = self.len().div_ceil(MOST_COMPARED).max(1);
        for span in &mut self.spans {
            let growths = span.growths(stride, stream, &exact);
            let largest = growths.iter().copied().fold(1.0, f64::max);
            for (index, leaf) in span.leaves.iter_mut().enumerate() {
                let near = growths.iter().skip(index.saturating_sub(1)).take(if index == 0 { 2 } else { 3 });
                leaf.error *= if stride > 1 { largest } else { near.copied().fold(1.0, f64::max) };
            }
        }
    }

    /// The number of polynomials.
    pub(super) fn len(&self) -> usize {
        self.spans.iter().map(|span| span.leaves.len()).sum()
    }
}

impl Front {
    fn at(self, x: f64, w: f64) -> f64 {
        let own = if w == 0.0 && self.w <= 0.0 { 1.0 } else { power(w, self.w) };
        if self.x { x * own } else { own }
    }
}

impl Span {
    fn new(pieces: &[Piece], kind: Integral, anchor: f64, to: f64) -> Result<Self, TransformError> {
        let here: Vec<&Piece> = pieces.iter().filter(|piece| piece.lower < to).collect();
        let before = here.iter().any(|piece| piece.lower < anchor);
        let fronts: Vec<f64> = here.iter().filter(|piece| piece.lower == anchor).map(|piece| piece.front(kind)).collect();
        let lowest = fronts.iter().copied().fold(f64::INFINITY, f64::min);
        let same = fronts.iter().all(|own| *own == lowest);
        let front = if before || !lowest.is_finite() { 0.0 } else { lowest };
        let (square, x) = (!before && same, kind == Integral::Root);
        let scale = 1.0 / ((to - anchor) * (to + anchor));
        let mut span = Self { anchor, to, scale, square, front: Front { x, w: front }, cells: Vec::new(), leaves: Vec::new() };
        if !here.is_empty() {
            let sum = |place: SquaredRadius| here.iter().fold(Share::default(), |sum, piece| sum + piece.share(kind, place, front));
            span.cover(&sum, 0.0, 1.0, 0)?;
            span.index();
        }
        Ok(span)
    }

    fn cover(&mut self, sum: &impl Fn(SquaredRadius) -> Share, from: f64, to: f64, depth: u32) -> Result<(), TransformError> {
        work::check()?;
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let (mut values, mut noise) = ([0.0; LOCAL], 0.0_f64);
        for (value, node) in values.iter_mut().zip(local_nodes()) {
            let share = middle + half * node;
            let w = if self.square { share } else { share * share } / self.scale;
            let found = sum(SquaredRadius::new(self.anchor, w));
            noise = noise.max(found.noise + ROUNDING * f64::EPSILON * found.size);
            *value = found.value;
        }
        if !values.iter().all(|value| value.is_finite()) {
            return Err(TransformError::NotComputable { at: self.to });
        }
        let (local, tail, largest) = Local::fit(&values);
        if tail <= (FINE * f64::EPSILON * largest).max(0.2 * noise) || depth >= DEEPEST {
            if self.leaves.len() >= MOST_LEAVES {
                return Err(TransformError::NotComputable { at: self.to });
            }
            let error = tail + noise + 2.0 * f64::EPSILON * largest;
            self.leaves.push(Leaf { to, middle, scale: 1.0 / half, local, error });
            return Ok(());
        }
        self.cover(sum, from, middle, depth + 1)?;
        self.cover(sum, middle, to, depth + 1)
    }

    /// The factor by which the error of each polynomial must grow, 1 if it agrees or is not compared.
    fn growths(&self, stride: usize, stream: &mut Stream, exact: &impl Fn(f64) -> Result<Estimate, TransformError>) -> Vec<f64> {
        let (mut growths, mut from) = (Vec::with_capacity(self.leaves.len()), 0.0);
        for (index, leaf) in self.leaves.iter().enumerate() {
            let mut growth = 1.0_f64;
            let within = [stream.uniform(), 10f64.powf(-12.0 * stream.uniform())];
            let places = within.iter().take(if index == 0 { 2 } else { 1 });
            for share in places.map(|part| from + (leaf.to - from) * part) {
                let w = if self.square { share } else { share * share } / self.scale;
                let x = SquaredRadius::new(self.anchor, w).x.min(self.to);
                let w = (x - self.anchor) * (x + self.anchor);
                // Skip points where the other computation has no value.
                let (true, Some((own, u)), Ok(other)) = (index % stride == 0, self.locate(w), exact(x)) else { continue };
                let front = self.front.at(x, w);
                let value = own.local.at(u) * front;
                let error = own.error * front.abs();
                let beyond = (value - other.value).abs() - other.error - 6.0 * f64::EPSILON * value.abs();
                if beyond > error && error > 0.0 {
                    growth = growth.max(3.0 * beyond / error);
                }
            }
            growths.push(growth);
            from = leaf.to;
        }
        growths
    }

    fn index(&mut self) {
        let count = 1_usize << CELLS;
        let mut leaf = 0;
        for cell in 0..count {
            let from = cell as f64 / count as f64;
            while self.leaves.get(leaf).is_some_and(|own| own.to <= from) {
                leaf += 1;
            }
            self.cells.push(u32::try_from(leaf).unwrap_or(u32::MAX));
        }
    }

    /// The leaf that contains a point, and the coordinate in the leaf.
    #[inline]
    fn locate(&self, w: f64) -> Option<(&Leaf, f64)> {
        let share = (w * self.scale).clamp(0.0, 1.0);
        let share = if self.square { share } else { share.sqrt() };
        self.leaf(share)
    }

    #[inline]
    fn leaf(&self, share: f64) -> Option<(&Leaf, f64)> {
        let cell = ((share * f64::from(1_u32 << CELLS)) as usize).min((1 << CELLS) - 1);
        let mut index = *self.cells.get(cell)? as usize;
        let mut leaf = self.leaves.get(index)?;
        while share > leaf.to {
            index += 1;
            leaf = self.leaves.get(index)?;
        }
        Some((leaf, (share - leaf.middle) * leaf.scale))
    }

    fn fill(&self, places: &[f64], out: &mut [f64]) {
        let mut squares = [0.0; CHUNK];
        let mut shares = [0.0; CHUNK];
        for ((square, share), x) in squares.iter_mut().zip(&mut shares).zip(places) {
            *square = (x - self.anchor) * (x + self.anchor);
            *share = (*square * self.scale).clamp(0.0, 1.0);
        }
        if !self.square {
            shares.iter_mut().for_each(|share| *share = share.sqrt());
        }
        for (slot, share) in out.iter_mut().zip(&shares) {
            *slot = self.leaf(*share).map_or(0.0, |(leaf, u)| leaf.local.at(u));
        }
        let Front { x, w } = self.front;
        if self.anchor == 0.0 {
            // x^m w^q is one power of x.
            let whole = 2.0 * w + if x { 1.0 } else { 0.0 };
            if whole != 0.0 {
                out.iter_mut().zip(places).for_each(|(slot, x)| *slot *= power(*x, whole));
            }
            return;
        }
        if w != 0.0 {
            out.iter_mut().zip(&squares).for_each(|(slot, square)| *slot *= power(square.max(0.0), w));
        }
        if x {
            out.iter_mut().zip(places).for_each(|(slot, x)| *slot *= x);
        }
    }
}

/// The largest tail of a polynomial, in ulps.
const FINE: f64 = 2.0;
/// Rounding of a sum of a piece's terms, in ulps of their size.
const ROUNDING: f64 = 4.0;

impl std::ops::Add for Share {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, size: self.size + other.size, noise: self.noise + other.noise }
    }
}
