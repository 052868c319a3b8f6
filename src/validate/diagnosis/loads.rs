//! The diagnosis of files with loads.

use super::hypothesis::{self, ColumnMistake, Exchange, Fault, SolvedProblem};
use super::{Ranked, TRIED, Trial, Tried, minimum, score, thinned};
use crate::contact::{Load, State};
use crate::validate::exact::{Exact, States};
use crate::validate::file::row::Row;
use std::cell::RefCell;

impl Trial<'_> {
    pub(super) fn loads(&self, all: &[Row], factors: &Row, columns: &hypothesis::Columns) -> Option<Ranked> {
        let rows = &thinned(all);
        // A sample of the rows would not contain the row with the next load.
        let neighbours = all.get(all.len().saturating_sub(TRIED)..)?;
        let solution = self.scene.solution().ok()?;
        let largest = score::largest(rows, self.gauge.by_force);
        let exact = Exact::new(self.scene, &solution, largest).ok()?;
        let states = score::states(&exact, rows, self.gauge.by_force);
        let known = RefCell::new(States::new(&exact, None));
        let before = score::under(&exact, rows, &states, self.gauge);
        let faults = self.faults(&hypothesis::of_loads(columns));
        // The budget may be exhausted: faults that keep the loads require no new contacts and are tried first, faults with the largest loads last.
        let mut order: Vec<(usize, &Fault)> = faults.iter().enumerate().collect();
        let far = |fault: &Fault| if fault.slip.columns == Exchange::Nothing { fault.slip.depth.abs().ln().abs() } else { f64::MAX };
        order.sort_by(|one, other| far(one.1).total_cmp(&far(other.1)));
        // Fitted numbers need no other solution.
        let mut others = Vec::new();
        self.references(&exact, rows, &mut others);
        self.fitted(&exact, &known, rows, &mut others);
        let mut found: Vec<(usize, Tried)> = Vec::new();
        // The states of the most recent loads.
        let mut far_states: Option<(Load, Vec<Option<State>>)> = None;
        for (index, fault) in order {
            let level = fault.slip.ahead != 0 || fault.slip.force_ahead != 0;
            // Forces are proportional to the modulus.
            let force = if let SolvedProblem::Modulus(factor) = fault.taken { factor } else { 1.0 };
            let slip = ColumnMistake { force: force * fault.slip.force, ..fault.slip };
            let rows = corrected(if level { neighbours } else { rows }, &slip, factors);
            let own = score::largest(&rows, self.gauge.by_force);
            let load = if self.gauge.by_force { slip.force } else { slip.depth };
            let stays = load == 1.0 && slip.ahead == 0 && slip.force_ahead == 0 && slip.columns == Exchange::Nothing;
            let score = match fault.taken {
                SolvedProblem::AsIs | SolvedProblem::Modulus(_) if stays => score::under(&exact, &rows, &states, self.gauge),
                SolvedProblem::AsIs | SolvedProblem::Modulus(_) if is_near(own, largest) => {
                    self.limited(|| score::again(&exact, &known, &rows, self.gauge))
                }
                SolvedProblem::AsIs | SolvedProblem::Modulus(_) => {
                    if far_states.as_ref().is_none_or(|known| known.0 != own) {
                        let states = |exact: Exact<'_>| score::states(&exact, &rows, self.gauge.by_force);
                        far_states = self.limited(|| Exact::new(self.scene, &solution, own).ok().map(states)).map(|found| (own, found));
                    }
                    far_states.as_ref().and_then(|(_, states)| score::under(&exact, &rows, states, self.gauge))
                }
                SolvedProblem::Changed(_) | SolvedProblem::Parabola => {
                    self.with(&fault.taken, &exact, own, |exact| score::loads(exact, &rows, self.gauge))
                }
            };
            found.extend(score.map(|score| (index, Tried { id: fault.id, text: fault.text.clone(), score, free: false, rough: false })));
        }
        found.sort_by_key(|own| own.0);
        Some((before, found.into_iter().map(|own| own.1).chain(others).collect()))
    }

    /// Checks for depths with another reference, such as the edge of the contact.
    fn references(&self, exact: &Exact<'_>, rows: &[Row], tried: &mut Vec<Tried>) {
        let moved = |change: &dyn Fn(&State, f64) -> f64| -> Vec<Row> {
            let one = |row: &Row| {
                let state = exact.state(Load::Force(row.force))?;
                let height = exact.shape().profile(state.radius).ok()?.estimate.value;
                Some(Row { depth: row.depth + change(&state, height), ..*row })
            };
            rows.iter().filter_map(one).collect()
        };
        if rows.iter().any(|row| row.depth.is_nan() || row.force.is_nan()) {
            return;
        }
        let edge = moved(&|_, height| height);
        let contact = moved(&|state, height| state.depth - height);
        for (rows, text) in [
            (edge, "another reference for depth: d is the displacement at the edge of the contact, d - f(a), instead of at the axis"),
            (contact, "another reference for depth: d is only the height f(a) of the contact, without the sink-in outside"),
        ] {
            let score = self.limited(|| score::loads(exact, &rows, self.gauge));
            tried.extend(score.map(|score| Tried { id: "reference", text: text.to_owned(), score, free: false, rough: false }));
        }
    }

    /// Checks for faults with a fitted number.
    fn fitted(&self, exact: &Exact<'_>, known: &RefCell<States<'_>>, rows: &[Row], tried: &mut Vec<Tried>) {
        let deepest = rows.iter().map(|row| row.depth.abs()).fold(0.0, f64::max);
        let strongest = rows.iter().map(|row| row.force.abs()).fold(0.0, f64::max);
        if rows.len() < 3 || deepest == 0.0 || strongest == 0.0 {
            return;
        }
        let score = |factor: f64| {
            let rows: Vec<Row> = rows.iter().map(|row| Row { force: row.force / factor, ..*row }).collect();
            self.limited(|| score::again(exact, known, &rows, self.gauge))
        };
        if let Some(x) = minimum(-1.0, 1.0, 81, &|x| score(10f64.powf(x)).map_or(f64::MAX, |own| own.share())) {
            let factor = 10f64.powf(x);
            let text = format!(
                "another modulus: all forces are {factor:.4} times the exact values at their depth, as for {factor:.4} times the E* of the scene"
            );
            tried.extend(score(factor).map(|score| Tried { id: "modulus", text, score, free: true, rough: false }));
        }
        let mut fit = |id: &'static str, name: &dyn Fn(f64) -> String, change: &dyn Fn(&Row, f64) -> Row| {
            let changed = |x: f64| rows.iter().map(|row| change(row, x)).collect::<Vec<_>>();
            let score = |x: f64| self.limited(|| score::again(exact, known, &changed(x), self.gauge));
            let Some(x) = minimum(-0.5, 0.5, 41, &|x| score(x).map_or(f64::MAX, |own| own.share())) else { return };
            tried.extend(score(x).map(|score| Tried { id, text: name(x), score, free: true, rough: false }));
        };
        fit("reference", &|x| format!("another reference for depth: every d is too large by {}", self.length(x * deepest)), &|row, x| {
            Row { depth: row.depth - x * deepest, ..*row }
        });
        fit(
            "compliance",
            &|x| {
                format!(
                    "another reference for depth: d contains a part proportional to the force, {} at the largest, as for a compliant frame or periodic images",
                    self.length(x * deepest)
                )
            },
            &|row, x| Row { depth: row.depth - x * deepest * row.force / strongest, ..*row },
        );
        fit("tare", &|x| format!("every F is too large by {x:.4} times the largest force: the force sensor has an offset"), &|row, x| {
            Row { force: row.force - x * strongest, ..*row }
        });
    }
}

/// Returns true for a load that a solution for another largest load resolves.
fn is_near(load: Load, largest: Load) -> bool {
    match (load, largest) {
        (Load::Depth(own), Load::Depth(other)) | (Load::Force(own), Load::Force(other)) => (0.05..=1.0 + 1e-9).contains(&(own / other)),
        _ => false,
    }
}

/// Returns the rows with the mistake undone.
fn corrected(rows: &[Row], slip: &ColumnMistake, factors: &Row) -> Vec<Row> {
    let rows: Vec<Row> = rows.iter().filter_map(|row| slip.columns.exchanged(row, factors)).collect();
    let at = |index: usize, ahead: i32| index.checked_add_signed(-ahead as isize).and_then(|own| rows.get(own));
    let one = |(index, row): (usize, &Row)| {
        let (force, radius) = (at(index, slip.ahead + slip.force_ahead)?.force, at(index, slip.ahead)?.radius);
        Some(Row { depth: row.depth / slip.depth, force: force / slip.force, radius: radius / slip.radius })
    };
    rows.iter().enumerate().filter_map(one).collect()
}
