//! Sums over the rows of one column: L1, L2 and maximum errors, the position of the largest error, and the tolerance.

use super::record::Beyond;

/// Errors of one column; rows are not stored.
#[derive(Clone, Debug)]
pub(super) struct Norms {
    /// True for errors relative to the row's own value, false for errors relative to the largest value.
    by_row: bool,
    pub(super) rows: u64,
    absolute: f64,
    absolute_exact: f64,
    square: f64,
    square_exact: f64,
    /// Σ e · exact.
    along: f64,
    square_allowed: f64,
    /// The factor of the tolerances.
    tightened: f64,
    largest_exact: f64,
    worst: f64,
    pub(super) worst_at: f64,
    largest_load: f64,
    at_largest_load: f64,
    signed: f64,
    /// The largest difference from the exact value.
    pub(super) farthest: f64,
    /// Number of rows whose exact value is not 0; the other rows have no scale for the error.
    inside: u64,
    /// Rows that exceed their own limit; only those with the largest differences are kept.
    suspects: Vec<(Beyond, Outlier)>,
    /// The row with the largest contribution to the L2 error.
    outlier: Option<Outlier>,
}

/// Maximum number of suspects.
const SUSPECTS: usize = 64;
/// Differences below this fraction of the largest exact value of a field are rounding errors.
const ROUNDING: f64 = 1e-13;

/// One row, with its relative discretization error.
#[derive(Clone, Copy, Debug)]
pub(super) struct Outlier {
    pub(super) at: f64,
    pub(super) data: f64,
    pub(super) exact: f64,
    pub(super) allowed: f64,
}

impl Outlier {
    fn difference(&self) -> f64 {
        (self.data - self.exact).abs()
    }
}

impl Norms {
    pub(super) fn new(by_row: bool) -> Self {
        Self {
            by_row,
            rows: 0,
            absolute: 0.0,
            absolute_exact: 0.0,
            square: 0.0,
            square_exact: 0.0,
            along: 0.0,
            square_allowed: 0.0,
            tightened: 1.0,
            largest_exact: 0.0,
            worst: -1.0,
            worst_at: 0.0,
            largest_load: f64::NEG_INFINITY,
            at_largest_load: 0.0,
            signed: 0.0,
            farthest: 0.0,
            inside: 0,
            suspects: Vec::new(),
            outlier: None,
        }
    }

    /// Adds a row: its coordinate, its load, both values, and its relative discretization error.
    pub(super) fn add(&mut self, at: f64, load: f64, data: f64, exact: f64, allowed: f64) {
        let error = data - exact;
        self.rows += 1;
        self.inside += u64::from(exact != 0.0);
        self.absolute += error.abs();
        self.absolute_exact += exact.abs();
        self.square += error * error;
        self.square_exact += exact * exact;
        self.along += error * exact;
        self.square_allowed += (allowed * exact).powi(2);
        self.signed += error;
        self.largest_exact = self.largest_exact.max(exact.abs());
        self.farthest = self.farthest.max(error.abs());
        if self.outlier.is_none_or(|own| own.difference() < error.abs()) {
            self.outlier = Some(Outlier { at, data, exact, allowed });
        }
        let relative = if self.by_row { ratio(error.abs(), exact.abs()) } else { error.abs() };
        if relative > self.worst {
            (self.worst, self.worst_at) = (relative, at);
        }
        if load > self.largest_load {
            (self.largest_load, self.at_largest_load) = (load, ratio(error.abs(), exact.abs()));
        }
    }

    /// Compares one row with its own limit, which an average over many rows cannot hide.
    pub(super) fn limit(&mut self, own: Outlier, limit: f64) {
        if own.exact != 0.0 {
            self.limit_relative_to(own.exact.abs(), own, limit);
        }
    }

    /// The same with the limit relative to `scale`, for rows whose exact value is 0.
    pub(super) fn limit_relative_to(&mut self, scale: f64, own: Outlier, limit: f64) {
        self.suspect(own, ratio(own.difference(), scale), limit);
    }

    /// Notes a row whose error, by whatever measure, exceeds the limit.
    pub(super) fn suspect(&mut self, own: Outlier, error: f64, limit: f64) {
        let known = |other: &Outlier| other.at == own.at && other.data == own.data;
        if error <= limit || self.suspects.iter().any(|other| known(&other.1)) {
            return;
        }
        self.suspects.push((Beyond { at: own.at, error, limit }, own));
        if self.suspects.len() > SUSPECTS {
            self.suspects.sort_by(|one, other| other.1.difference().total_cmp(&one.1.difference()));
            self.suspects.pop();
        }
    }

    /// Multiplies the discretization errors by a factor.
    pub(super) fn tighten(&mut self, factor: f64) {
        self.tightened *= factor;
    }

    /// The rows beyond their own limit whose errors exceed rounding.
    fn rows_beyond(&self) -> impl Iterator<Item = (Beyond, Outlier)> {
        let rounding = if self.by_row { 0.0 } else { ROUNDING * self.largest_exact };
        self.suspects.iter().copied().filter(move |(_, own)| own.difference() > rounding)
    }

    /// Returns the worst row beyond its own limit.
    pub(super) fn beyond(&self) -> Option<Beyond> {
        self.rows_beyond().map(|own| own.0).reduce(|one, other| if other.error / other.limit > one.error / one.limit { other } else { one })
    }

    /// Returns the single row without which all others are within their tolerance, and their L2 error; `None` if there are more errors.
    pub(super) fn single(&self) -> Option<(Outlier, f64)> {
        const FEWEST: u64 = 5;
        let mut beyond = self.rows_beyond().map(|own| own.1);
        let (first, more) = (beyond.next(), beyond.next().is_some());
        let own = first.or(self.outlier)?;
        let error = own.data - own.exact;
        let rest = (self.square - error * error).max(0.0).sqrt();
        let exact = (self.square_exact - own.exact * own.exact).max(0.0).sqrt();
        let allowed = self.tightened * (self.square_allowed - (own.allowed * own.exact).powi(2)).max(0.0).sqrt();
        (self.rows >= FEWEST && !more && rest <= allowed).then(|| (own, ratio(rest, exact)))
    }

    /// Returns the least-squares factor between data and exact values, and the residual L2 error.
    pub(super) fn scaled(&self) -> (f64, f64) {
        let share = ratio(self.along, self.square_exact);
        let left = (self.square - share * self.along).max(0.0).sqrt();
        (1.0 + share, ratio(left, (1.0 + share).abs() * self.square_exact.sqrt()))
    }

    /// Returns true if the rows allow a verdict: a nonzero exact value was compared, or a zero exact value is not 0 in the data.
    pub(super) fn decisive(&self) -> bool {
        self.inside > 0 || self.absolute > 0.0
    }

    /// Returns Σ|e|/Σ|exact|.
    pub(super) fn l1(&self) -> f64 {
        ratio(self.absolute, self.absolute_exact)
    }

    /// Returns ‖e‖₂/‖exact‖₂.
    pub(super) fn l2(&self) -> f64 {
        ratio(self.square.sqrt(), self.square_exact.sqrt())
    }

    /// Returns the largest error, relative to its own row, or to the largest exact value.
    pub(super) fn max(&self) -> f64 {
        if self.by_row { self.worst.max(0.0) } else { ratio(self.worst.max(0.0), self.largest_exact) }
    }

    /// Returns the relative error at the row of the largest load.
    pub(super) fn at_largest_load(&self) -> f64 {
        self.at_largest_load
    }

    /// Returns Σe/Σ|exact|, with its sign.
    pub(super) fn bias(&self) -> f64 {
        ratio(self.signed, self.absolute_exact)
    }

    /// Returns the L2 norm of the allowed errors, relative to that of the exact values.
    pub(super) fn allowed(&self) -> f64 {
        ratio(self.tightened * self.square_allowed.sqrt(), self.square_exact.sqrt())
    }
}

/// Returns a ratio that is 0 for 0/0, and never infinite.
pub(super) fn ratio(above: f64, below: f64) -> f64 {
    if above == 0.0 {
        return 0.0;
    }
    let ratio = above / below;
    if ratio.is_finite() { ratio } else { f64::MAX }
}

/// An evenly distributed sample of a stream, with fewer than twice `most` items.
///
/// An item is kept if the fractional part of its index times the golden ratio is below 2⁻ⁿ; these parts are spread evenly over [0, 1).
/// Taking every 2ⁿ-th item would take the same columns of every row of a lattice.
#[derive(Clone, Debug)]
pub(super) struct Sample<T> {
    pub(super) items: Vec<T>,
    /// The fractional part of each item in units of 2⁻⁶⁴.
    parts: Vec<u64>,
    most: usize,
    /// n.
    level: u32,
    seen: u64,
}

impl<T> Sample<T> {
    pub(super) fn new(most: usize) -> Self {
        Self { items: Vec::new(), parts: Vec::new(), most, level: 0, seen: 0 }
    }

    pub(super) fn push(&mut self, item: T) {
        let part = self.seen.wrapping_mul(GOLDEN);
        self.seen += 1;
        if part.leading_zeros() < self.level {
            return;
        }
        self.items.push(item);
        self.parts.push(part);
        while self.items.len() >= 2 * self.most {
            self.level += 1;
            let mut chosen = self.parts.iter().map(|own| own.leading_zeros() >= self.level);
            self.items.retain(|_| chosen.next().unwrap_or(false));
            self.parts.retain(|own| own.leading_zeros() >= self.level);
        }
    }
}

/// 2⁶⁴ (φ − 1).
pub(super) const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
