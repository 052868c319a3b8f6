//! Rows of a file of loads whose error is far above the errors of the rows around them.

use super::norms::Outlier;
use std::collections::VecDeque;

/// Rows that are looked at on either side.
const REACH: usize = 4;
/// Fewest neighbours that say how large errors are.
const FEWEST: usize = 4;
/// Errors of a grid scatter: a row may exceed the largest of its neighbours by this factor.
const HEADROOM: f64 = 4.0;

/// Compares the error of every row with those of its neighbours; rows are forgotten when they are far behind.
pub(super) struct Neighbours {
    rows: VecDeque<Seen>,
    /// The power of h/a with which errors grow towards small contacts.
    power: i32,
    /// Relative errors below this are never out of proportion.
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

    /// Takes the next row, whose exact contact radius is `radius`.
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

    /// The row that exceeds its neighbours by the largest factor, with the error that they would excuse.
    pub(super) fn worst(mut self) -> Option<(Outlier, f64)> {
        (self.judged..self.rows.len()).for_each(|index| self.judge(index));
        self.worst
    }

    fn judge(&mut self, index: usize) {
        let Some(row) = self.rows.get(index) else { return };
        let near = index.saturating_sub(REACH)..=index + REACH;
        let others = self.rows.iter().enumerate().filter(|(at, _)| *at != index && near.contains(at)).map(|own| own.1);
        // The error of a grid falls as the contact grows; other errors do not.
        let excused = others.clone().map(|other| other.error * (other.radius / row.radius).max(1.0).powi(self.power)).fold(0.0, f64::max);
        let limit = (HEADROOM * excused).max(self.floor);
        let exceeds = |(own, limit): &(Outlier, f64)| (own.data / own.exact - 1.0).abs() / limit;
        if others.count() >= FEWEST && row.error > limit && self.worst.as_ref().is_none_or(|worst| exceeds(worst) < row.error / limit) {
            self.worst = Some((row.own, limit));
        }
    }
}
