//! The Pareto front, and the recommended method for a required accuracy.

use super::Row;

/// The default accuracies for which advice is given.
pub const WANTED: [f64; 5] = [1e-3, 1e-6, 1e-9, 1e-12, 1e-15];

/// Ratio of the costs of a single value above which the set-up is a reason to use another method.
const WORTH_TELLING: f64 = 1.5;

/// Errors below half a unit in the last place are one and the same to a double.
const FLOOR: f64 = 0.5 * f64::EPSILON;

/// The recommended method for an accuracy.
#[derive(Clone, Debug)]
pub struct Advice {
    /// The wanted relative error.
    pub wanted: f64,
    /// The row that is fastest per point, by its index; `None` if nothing is as accurate.
    pub pick: Option<usize>,
    /// The row that is fastest for a single point with its set-up, where it is another one, and the number of points from which
    /// on `pick` is faster.
    pub few: Option<(usize, f64)>,
}

/// Marks the rows that nothing else beats in both time and error.
pub(super) fn mark(rows: &mut [Row]) {
    let all: Vec<(f64, f64)> = rows.iter().map(|row| (row.time.median, row.error.max(FLOOR))).collect();
    for (index, row) in rows.iter_mut().enumerate() {
        let own = (row.time.median, row.error.max(FLOOR));
        let beaten = |(other, (time, error)): (usize, &(f64, f64))| {
            other != index && *time <= own.0 && *error <= own.1 && ((*time, *error) != own || other < index)
        };
        row.front = !all.iter().enumerate().any(beaten);
    }
}

/// The fastest row that is at least so accurate.
pub(super) fn advise(rows: &[Row], wanted: f64) -> Advice {
    let enough = || rows.iter().enumerate().filter(|(_, row)| row.error.max(FLOOR) <= wanted);
    let pick = enough().min_by(|one, other| one.1.time.median.total_cmp(&other.1.time.median));
    let alone = |row: &Row| row.set_up + row.time.median;
    let single = enough().min_by(|one, other| alone(one.1).total_cmp(&alone(other.1)));
    let few = match (pick, single) {
        (Some((index, fast)), Some((other, quick)))
            if index != other && quick.time.median > fast.time.median && alone(fast) > WORTH_TELLING * alone(quick) =>
        {
            Some((other, ((fast.set_up - quick.set_up) / (quick.time.median - fast.time.median)).ceil().max(2.0)))
        }
        _ => None,
    };
    Advice { wanted, pick: pick.map(|(index, _)| index), few }
}
