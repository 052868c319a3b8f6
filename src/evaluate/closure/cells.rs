//! Derivatives of a function given by its values: Chebyshev interpolation on cells that double outward, halved where needed.

use crate::num::{Bounded, chebyshev, work};
use std::sync::OnceLock;

/// Nodes of a cell.
const NODES: usize = 20;
/// Halvings of a cell before it is abandoned, sufficient near an end with a root.
const DEEPEST: i32 = 50;
/// Halvings that a function without a kink may take inside its segment.
const SMOOTH: i32 = 34;
/// Number of the last coefficients used to distinguish noise from φ.
pub(super) const LAST: usize = 6;
/// Number of halvings over which the last coefficients of a cell are compared.
const WIDER: usize = 5;
/// Number of halvings above which slowly decreasing coefficients indicate a kink rather than noise.
const FOLLOWED: i32 = 14;
/// Minimum number of halvings of a cell whose ends are cuts of the quadrature.
const NARROW: i32 = 10;
/// Maximum number of cuts in one doubling.
const MOST_CUTS: usize = 1024;
/// Number of cells on each side of the smallest whose ends are cuts as well.
const BESIDE: usize = 3;
/// Number of doublings below a radius that are searched for cuts.
const OCTAVES: i32 = 40;
/// Steps within this multiple of a radius count at it.
const AHEAD: f64 = 1.1;
/// Cells that one doubling may be cut into; a kink takes about fifty.
const MOST_CELLS: usize = 4000;
/// Binary exponents of doubles: from the smallest to the largest.
const EXPONENTS: usize = 2100;

/// The interpolant of one function φ on part of a segment.
///
/// The interval of the fit exceeds the interval of use, because derivatives are least accurate at the ends of a fit.
pub(super) struct Cell {
    /// The upper end of the interval of use.
    to: f64,
    middle: f64,
    half: f64,
    /// Chebyshev coefficients of φ, φ′ and φ″ over the fit; the derivatives are in units of the half width.
    orders: [[f64; NODES]; 3],
    /// The truncation error of the interpolant, and the error of its values.
    doubt: f64,
    resolved: bool,
    /// The largest |φ|.
    size: f64,
    /// The largest |φ′| at the nodes.
    steepest: f64,
    /// Size of the noise accepted as rounding, or 0.
    accepted: f64,
}

/// The interpolants of one function on one segment, computed when needed.
pub struct Cells {
    lower: f64,
    upper: f64,
    doublings: Box<[OnceLock<Doubling>]>,
}

/// The cells between one power of two and the next.
struct Doubling {
    cells: Vec<Cell>,
    /// The first place inside the segment where no cell is small enough: a kink, a jump or the end of the function's domain.
    seam: Option<f64>,
    /// Places at which quadrature splits its panels; see [`cuts`].
    cuts: Vec<f64>,
    /// The beginnings of runs of adjacent cells with noise, and the size of the noise; isolated noise may be a step of φ.
    steps: Vec<(f64, f64)>,
    /// True if the fit that begins at the axis agrees with the slopes of the cells.
    agrees: OnceLock<bool>,
}

/// Returns a bound on the slope at r that noise of this size can hide.
pub(super) fn hidden_f_prime(noise: f64, r: f64) -> f64 {
    30.0 * noise / r
}

impl Doubling {
    fn cell(&self, r: f64) -> Option<&Cell> {
        self.cells.get(self.cells.partition_point(|cell| cell.to <= r)).or_else(|| self.cells.last())
    }
}

/// Returns an empty place for every power of two.
pub(super) fn places<T>() -> Box<[OnceLock<T>]> {
    (0..EXPONENTS).map(|_| OnceLock::new()).collect()
}

/// Returns the cached value, computing it first if necessary; `None` if the work budget ends, in which case nothing is cached.
pub(super) fn kept<T>(place: &OnceLock<T>, build: impl FnOnce() -> T) -> Option<&T> {
    if place.get().is_none() {
        let built = build();
        if work::is_exhausted() {
            return None;
        }
        let _ = place.set(built);
    }
    place.get()
}

/// Returns the exponent of the largest power of two that is at most r.
pub(super) fn exponent_of(r: f64) -> Option<i32> {
    (r > 0.0 && r.is_finite()).then(|| libm::ilogb(r))
}

/// Returns the index of the place for a power of two.
pub(super) fn place_of(exponent: i32) -> Option<usize> {
    usize::try_from(exponent + 1075).ok()
}

impl Cells {
    /// Creates the interpolants of a segment without computing any.
    pub fn new(lower: f64, upper: f64) -> Self {
        Self { lower, upper, doublings: places() }
    }

    /// The derivative of φ of order 1 or 2 at r with a bound of its error; NaN if φ is not smooth enough.
    pub fn derivative(&self, order: usize, r: f64, phi: &impl Fn(f64) -> Bounded) -> Bounded {
        self.doubling(r, phi).and_then(|own| own.cell(r)).map_or(NOTHING, |cell| cell.derivative(order, r))
    }

    /// Returns a bound on the slope at r of steps of φ that were taken for noise.
    pub(super) fn hidden_f_prime(&self, r: f64, phi: &impl Fn(f64) -> Bounded) -> f64 {
        let below = |own: &Doubling| own.steps.iter().filter(|(from, _)| *from <= AHEAD * r).map(|(_, noise)| noise).sum();
        self.doubling(r, phi).map_or(0.0, |own| hidden_f_prime(below(own), r))
    }

    /// Returns true if `other` agrees with the slopes of all cells between the powers of two around r, within both bounds; false
    /// if the budget of work ends. The first answer is kept, so `other` must be the same function in every call.
    pub(super) fn agree(&self, r: f64, phi: &impl Fn(f64) -> Bounded, other: &impl Fn(f64) -> Option<Bounded>) -> bool {
        let same = |cell: &Cell| {
            let (own, other) = (cell.derivative(1, cell.middle), other(cell.middle));
            other.is_none_or(|other| (own.value - other.value).abs() <= own.error + other.error || own.value.is_nan())
        };
        self.doubling(r, phi).and_then(|own| kept(&own.agrees, || own.cells.iter().all(same))).copied().unwrap_or(false)
    }

    /// A radius slightly below r at which φ is not smooth, if any; the derivatives do not resolve such a point.
    pub fn seam(&self, r: f64, phi: &impl Fn(f64) -> Bounded) -> Option<f64> {
        // Points beyond r, such as the undeclared end of a sphere, do not affect it.
        let own = self.doubling(r, phi)?.seam.filter(|seam| *seam <= r);
        own.or_else(|| if libm::scalbn(1.0, exponent_of(r)?) > self.lower { self.doubling(0.5 * r, phi)?.seam } else { None })
    }

    /// An estimate of the largest |φ′| around r; 0 if unknown.
    pub(super) fn steepness(&self, r: f64, phi: &impl Fn(f64) -> Bounded) -> f64 {
        self.doubling(r, phi).and_then(|own| own.cell(r)).map_or(0.0, |cell| cell.steepest)
    }

    fn doubling(&self, r: f64, phi: &impl Fn(f64) -> Bounded) -> Option<&Doubling> {
        let exponent = exponent_of(r)?;
        kept(self.doublings.get(place_of(exponent)?)?, || self.build(exponent, phi))
    }

    /// The cells of radii from 2^exponent to twice that, within the segment.
    fn build(&self, exponent: i32, phi: &impl Fn(f64) -> Bounded) -> Doubling {
        let scale = libm::scalbn(1.0, exponent);
        let (mut cells, mut sizes): (Vec<Cell>, Vec<(f64, f64, i32)>) = (Vec::new(), Vec::new());
        let mut seam = None;
        let mut waiting = vec![(scale.max(self.lower), (2.0 * scale).min(self.upper), 0, [f64::INFINITY; WIDER])];
        while let Some((from, to, depth, wider)) = waiting.pop() {
            if work::is_exhausted() {
                break;
            }
            let margin = 0.25 * libm::scalbn(scale, -depth);
            let ends = ((from - margin).max(self.lower), (to + margin).min(self.upper));
            let mut cell = Cell::fit(ends, to, phi);
            // The coefficients of a root at an end of the segment also decrease slowly.
            if from > self.lower && to < self.upper {
                cell.accept_noise(&wider, phi);
            }
            let middle = from + 0.5 * (to - from);
            let is_full = cells.len() + waiting.len() >= MOST_CELLS;
            let can_halve = depth < DEEPEST && !is_full && middle > from && middle < to;
            if cell.resolved || !can_halve {
                // Cells near a root at an end of the segment are as wide as their distance to the end. A kink inside the segment
                // appears resolved only when it is below the rounding of r or φ.
                let apart = (from - self.lower).min(self.upper - to) > 1e3 * (to - from);
                let is_seam = !cell.resolved || depth > SMOOTH || (depth > FOLLOWED && cell.is_kinked(&wider));
                if (apart && is_seam) || (is_full && !cell.resolved) {
                    seam.get_or_insert(to);
                }
                cells.push(cell);
                sizes.push((from, to, depth));
            } else {
                let mut wider = wider;
                wider.rotate_right(1);
                wider[0] = cell.last(LAST);
                waiting.push((middle, to, depth + 1, wider));
                waiting.push((from, middle, depth + 1, wider));
            }
        }
        let runs = cells.chunk_by(|one, other| (one.accepted > 0.0) == (other.accepted > 0.0));
        let noise = |run: &[Cell]| run.iter().fold(0.0, |most: f64, cell| most.max(cell.accepted));
        let steps = runs.filter_map(|run| Some((run.first()?.begin(), noise(run)))).filter(|(_, noise)| *noise > 0.0).collect();
        let cuts = cuts(&cells, &sizes);
        Doubling { cells, seam, cuts, steps, agrees: OnceLock::new() }
    }

    /// Returns the places below r next to which φ is least smooth, in ascending order.
    pub(super) fn cuts(&self, r: f64, phi: &impl Fn(f64) -> Bounded) -> Vec<f64> {
        let Some(last) = exponent_of(r) else { return Vec::new() };
        let radii = (last - OCTAVES..=last).map(|exponent| libm::scalbn(1.0, exponent));
        let doublings = radii.filter(|from| 2.0 * from > self.lower).filter_map(|from| self.doubling(from.max(self.lower.next_up()), phi));
        doublings.flat_map(|own| own.cuts.iter().copied()).filter(|cut| *cut < r).collect()
    }
}

/// Returns the ends of short runs of cells with noise. Such a run may contain a step of φ, which lies between the nodes of a wide
/// panel.
fn ends_of_noise(cells: &[Cell], sizes: &[(f64, f64, i32)]) -> Vec<f64> {
    /// Maximum number of cells in a run.
    const FEW: usize = 4;
    let mut found = Vec::new();
    let mut begin = 0;
    for run in cells.chunk_by(|one, other| (one.accepted > 0.0) == (other.accepted > 0.0)) {
        let end = begin + run.len();
        if run.len() <= FEW && run.iter().all(|cell| cell.accepted > 0.0) {
            let ends = sizes.get(begin..end).unwrap_or_default();
            found.extend(ends.first().map(|own| own.0));
            found.extend(ends.last().map(|own| own.1));
        }
        begin = end;
    }
    found
}

/// Returns the ends of the cells that were halved more often than their neighbours and of the adjacent cells, one of which may
/// contain the kink and have treated it as noise. The smallest cells come first, up to [`MOST_CUTS`], because noise also halves
/// cells. The ends of isolated noise are added.
fn cuts(cells: &[Cell], sizes: &[(f64, f64, i32)]) -> Vec<f64> {
    let mut runs = Vec::new();
    let mut begin = 0;
    for run in sizes.chunk_by(|one, other| one.2 == other.2) {
        let end = begin + run.len();
        let depth = run.first().map_or(0, |own| own.2);
        let is_shallower = |index: Option<usize>| index.and_then(|index| sizes.get(index)).is_none_or(|own| own.2 < depth);
        if depth >= NARROW && is_shallower(begin.checked_sub(1)) && is_shallower(Some(end)) {
            runs.push((depth, begin.saturating_sub(BESIDE)..(end + BESIDE).min(sizes.len())));
        }
        begin = end;
    }
    runs.sort_by_key(|(depth, _)| -depth);
    let mut found = Vec::new();
    for (_, around) in runs {
        let around = sizes.get(around).unwrap_or_default();
        if found.len() + around.len() >= MOST_CUTS {
            break;
        }
        found.extend(around.first().map(|own| own.0));
        found.extend(around.iter().map(|own| own.1));
    }
    found.extend(ends_of_noise(cells, sizes));
    found.sort_by(f64::total_cmp);
    found.dedup();
    found
}

const NOTHING: Bounded = Bounded { value: f64::NAN, error: f64::NAN };

/// The cosines of the nodes.
fn cosines() -> &'static [f64] {
    static TABLE: OnceLock<Vec<f64>> = OnceLock::new();
    TABLE.get_or_init(|| chebyshev::cosines(NODES))
}

/// The nodes, in decreasing order.
fn nodes() -> [f64; NODES] {
    let table = cosines();
    std::array::from_fn(|j| table.get(2 * j + 1).copied().unwrap_or(f64::NAN))
}

impl Cell {
    /// Fits φ on an interval; the cell answers below `to`.
    pub(super) fn fit((from, end): (f64, f64), to: f64, phi: &impl Fn(f64) -> Bounded) -> Self {
        let (middle, half) = (from + 0.5 * (end - from), 0.5 * (end - from));
        let samples: [Bounded; NODES] = nodes().map(|x| phi(middle + half * x));
        let size = samples.iter().fold(0.0, |size: f64, s| size.max(s.value.abs()));
        // The rounding of r displaces a node by half an ulp of the largest radius, which changes φ by its slope times this.
        let noise = samples.iter().fold(0.0, |noise: f64, s| noise.max(s.error)) + f64::EPSILON * size;
        let mut values = [0.0; NODES];
        chebyshev::coefficients(&samples.map(|s| s.value), cosines(), &mut values);
        let slopes = differentiated(&values, half);
        let bends = differentiated(&slopes, half);
        let tail = values[NODES - 3..].iter().fold(0.0, |tail: f64, c| tail.max(c.abs()));
        let steepest = nodes().iter().map(|x| chebyshev::sum(&slopes, *x).abs()).fold(0.0, f64::max);
        let moved = 0.5 * f64::EPSILON * end * steepest;
        let finite = samples.iter().all(|s| s.value.is_finite());
        // Sums of many random rounding errors remain well below their number.
        let resolved = finite && tail <= (noise + moved).max(4.0 * f64::EPSILON * size);
        Self { to, middle, half, orders: [values, slopes, bends], doubt: tail + noise + moved, resolved, size, steepest, accepted: 0.0 }
    }

    /// Coefficients that neither decrease nor grow over several halvings of a cell are noise beyond the declared error, as for
    /// ln(cosh(r)) near the axis.
    fn accept_noise(&mut self, wider: &[f64; WIDER], phi: &impl Fn(f64) -> Bounded) {
        // In three halvings they decrease by 8 at a kink and grow by 8 near a pole; near rounding level one halving suffices.
        const STILL: f64 = 0.5;
        const GROWING: f64 = 4.0;
        let (last, low) = (self.last(LAST), self.noise() == 0.0);
        let before = if low { wider[0] } else { wider[2] };
        if !self.resolved && last > STILL * before && last < GROWING * before && self.is_noisy_within(phi) {
            self.resolved = true;
            self.accepted = self.noise();
            self.doubt += 4.0 * last;
        }
    }

    /// Returns false if a narrow part of the cell is free of noise although φ changes there by more than the noise. The cell then
    /// contains many kinks or waves, which look like noise as well.
    fn is_noisy_within(&self, phi: &impl Fn(f64) -> Bounded) -> bool {
        /// Smaller noise, relative to φ, is taken for rounding without a comparison.
        const LOUD: f64 = 1e-6;
        /// The beginnings and widths of narrow parts, as fractions of the cell.
        const BEGIN: f64 = 0.37;
        const WIDTHS: [f64; 3] = [1e-1, 1e-2, 1e-3];
        /// Maximum noise of a part that counts as free of noise, relative to the noise of the cell.
        const CLEAN: f64 = 1e-2;
        let (noise, from) = (self.last(LAST), self.begin() + 2.0 * BEGIN * self.half);
        let is_clean = |own: &Self| own.spread() > noise && own.last(LAST) < CLEAN * noise;
        let part = |width: f64| Self::fit((from, from + 2.0 * width * self.half), self.to, phi);
        noise <= LOUD * self.size || !WIDTHS.into_iter().any(|width| is_clean(&part(width)))
    }

    /// Returns the size of the last coefficients if it is beyond the rounding of φ, else 0.
    pub(super) fn noise(&self) -> f64 {
        const LOW: f64 = 64.0 * f64::EPSILON;
        let last = self.last(LAST);
        if last > LOW * self.size { last } else { 0.0 }
    }

    /// Returns true if the last coefficients fell with the width of the cell until rounding hid them, as they do at a jump of φ′,
    /// or with its square, as at a jump of φ″.
    fn is_kinked(&self, wider: &[f64; WIDER]) -> bool {
        const FALL: f64 = 8.0;
        const SLOW: f64 = 5000.0;
        let first = wider[WIDER - 1];
        FALL * self.last(LAST) < first && first < SLOW * self.doubt
    }

    fn derivative(&self, order: usize, r: f64) -> Bounded {
        if self.resolved { self.derivative_within(order, r, 0.0) } else { NOTHING }
    }

    /// Where the fit begins.
    fn begin(&self) -> f64 {
        self.middle - self.half
    }

    pub(super) fn middle(&self) -> f64 {
        self.middle
    }

    /// Where the fit ends.
    pub(super) fn end(&self) -> f64 {
        self.middle + self.half
    }

    pub(super) fn is_resolved(&self) -> bool {
        self.resolved
    }

    /// Returns the largest magnitude of the last `count` coefficients.
    pub(super) fn last(&self, count: usize) -> f64 {
        self.orders[0].iter().rev().take(count).fold(0.0, |most: f64, c| if c.is_nan() { f64::INFINITY } else { most.max(c.abs()) })
    }

    /// Returns the apparent rounding error of φ: the largest of the last `count` coefficients, but at least half an ulp of the
    /// largest value.
    pub(super) fn rounding(&self, count: usize) -> f64 {
        self.last(count).max(0.5 * f64::EPSILON * self.size)
    }

    /// Returns a bound on the variation of φ, from its coefficients.
    pub(super) fn spread(&self) -> f64 {
        2.0 * self.orders[0].iter().skip(1).map(|c| c.abs()).sum::<f64>()
    }

    /// Returns the derivative of order 0, 1 or 2, where the values of φ have an error of `noise` beyond the stated one.
    pub(super) fn derivative_within(&self, order: usize, r: f64, noise: f64) -> Bounded {
        let Some(list) = self.orders.get(order) else { return NOTHING };
        let x = ((r - self.middle) / self.half).clamp(-1.0, 1.0);
        let value = chebyshev::sum(list, x);
        // Bernstein: a polynomial of degree n below ε has |p′| ≤ nε/√(1−x²), and Markov: |p′| ≤ n²ε.
        let n = NODES as f64;
        let steep = (n / (1.0 - x * x).sqrt()).min(n * n);
        let doubt = 3.0 * (self.doubt + noise);
        // Divided last, because 1/half may overflow where the error is small.
        let error = match order {
            0 => doubt,
            1 => doubt * steep / self.half,
            _ => doubt * steep / self.half * steep.max(n) / self.half,
        };
        Bounded::checked(value, error)
    }
}

/// The coefficients of the derivative: d_(k−1) = d_(k+1) + 2k c_k.
fn differentiated(list: &[f64; NODES], half: f64) -> [f64; NODES] {
    let mut out = [0.0; NODES];
    let (mut last, mut before) = (0.0, 0.0);
    for k in (1..NODES).rev() {
        let own = before + 2.0 * k as f64 * list[k] / half;
        out[k - 1] = own;
        before = last;
        last = own;
    }
    out[0] *= 0.5;
    out
}
