//! Rows of a file with loads whose error is much larger than the errors of the neighbouring rows.

use super::norms::Outlier;
use std::collections::VecDeque;

/// Number of neighbours on either side.
const REACH: usize = 4;
/// Minimum number of neighbours for an estimate of the error.
const FEWEST: usize = 4;
/// Discretization errors scatter: a row may exceed the largest error of its neighbours by this factor.
const HEADROOM: f64 = 4.0;

/// Compares the error of every row with the errors of its neighbours; only a few rows are stored.
pub(super) struct Neighbours {
    rows: VecDeque<Seen>,
    /// The power of h/a with which errors increase for small contacts.
    power: i32,
    /// Relative errors below this value are never outliers.
    floor: f64,
    judged: usize,
    worst: Option<(Outlier, f64)>,
}

struct Seen {
    own: Outlier,
    error: f64,
    radius: f64,
}

impl Neighbours {
    pub(super) fn new(power: i32, floor: f64) -> Self {
        Self { rows: VecDeque::new(), power, floor, judged: 0, worst: None }
    }

    /// Adds the next row, whose exact contact radius is `radius`.
    pub(super) fn push(&mut self, own: Outlier, radius: f64) {
        if own.exact == 0.0 || radius <= 0.0 {
            return;
        }
        self.rows.push_back(Seen { own, error: (own.data / own.exact - 1.0).abs(), radius });
        if self.rows.len() == 2 * REACH + 1 {
            (self.judged..=REACH).for_each(|index| self.judge(index));
            self.rows.pop_front();
            self.judged = REACH;
        }
    }

    /// Returns the row that exceeds its neighbours by the largest factor, with the expected error.
    pub(super) fn worst(mut self) -> Option<(Outlier, f64)> {
        (self.judged..self.rows.len()).for_each(|index| self.judge(index));
        self.worst
    }

    fn judge(&mut self, index: usize) {
        let Some(row) = self.rows.get(index) else { return };
        let near = index.saturating_sub(REACH)..=index + REACH;
        let others = self.rows.iter().enumerate().filter(|(at, _)| *at != index && near.contains(at)).map(|own| own.1);
        // The discretization error decreases as the contact grows; other errors do not.
        let excused = others.clone().map(|other| other.error * (other.radius / row.radius).max(1.0).powi(self.power)).fold(0.0, f64::max);
        let limit = (HEADROOM * excused).max(self.floor);
        let exceeds = |(own, limit): &(Outlier, f64)| (own.data / own.exact - 1.0).abs() / limit;
        if others.count() >= FEWEST && row.error > limit && self.worst.as_ref().is_none_or(|worst| exceeds(worst) < row.error / limit) {
            self.worst = Some((row.own, limit));
        }
    }
}
