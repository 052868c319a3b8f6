//! Scores how well data fit an exact solution: the L2 error, absolute and relative to the discretization error.

use crate::contact::{Boundary, Load, State};
use crate::validate::exact::{Exact, Pressures, States};
use crate::validate::field::{Spot, places};
use crate::validate::file::row::Row;
use crate::validate::file::survey::Cell;
use crate::validate::loads::{BLIND_RADIUS, Tolerances};
use crate::validate::norms::Norms;
use crate::validate::norms::ratio;
use crate::validate::region::{Region, excused};
use std::cell::RefCell;

/// Properties of the grid of the scored data.
#[derive(Clone, Copy, Debug)]
pub(in crate::validate) struct GridProperties {
    pub(in crate::validate) pixel: Option<f64>,
    /// The distance between compared pressures and singular points.
    pub(in crate::validate) margin: f64,
    /// The cell over which pressures are means.
    pub(in crate::validate) cell: Option<Cell>,
    pub(in crate::validate) solver: f64,
    /// The tolerance of loads, which replaces the discretization error.
    pub(in crate::validate) demanded: Option<f64>,
    /// True if the solver controlled the force.
    pub(in crate::validate) by_force: bool,
}

/// Errors of the decisive columns: force (or depth, or pressure), and contact radius.
#[derive(Clone, Copy, Debug)]
pub(in crate::validate) struct Score {
    /// L2 errors.
    pub(in crate::validate) errors: [f64; 2],
    /// The same errors relative to the discretization error.
    pub(in crate::validate) shares: [f64; 2],
}

impl Score {
    /// Returns the index of the column whose error is largest relative to its discretization error.
    pub(in crate::validate) fn worst(&self) -> usize {
        usize::from(self.shares[1] > self.shares[0])
    }

    pub(in crate::validate) fn share(&self) -> f64 {
        self.shares[0].max(self.shares[1])
    }
}

/// Returns the load of a row, as controlled by the solver.
fn load(row: &Row, by_force: bool) -> Load {
    if row.depth.is_nan() || (by_force && !row.force.is_nan()) { Load::Force(row.force) } else { Load::Depth(row.depth) }
}

/// Returns the largest load of the rows.
pub(in crate::validate) fn largest(rows: &[Row], by_force: bool) -> Load {
    let size = |row: &Row| match load(row, by_force) {
        Load::Depth(own) | Load::Force(own) | Load::Radius(own) => own,
    };
    rows.iter().max_by(|one, other| size(one).total_cmp(&size(other))).map_or(Load::Depth(0.0), |row| load(row, by_force))
}

/// Returns the score of rows with loads; `None` if most loads have no contact.
pub(in crate::validate) fn loads(exact: &Exact<'_>, rows: &[Row], gauge: &GridProperties) -> Option<Score> {
    under(exact, rows, &states(exact, rows, gauge.by_force), gauge)
}

/// Returns the same score with states that are shared by many trials.
pub(in crate::validate) fn again(exact: &Exact<'_>, known: &RefCell<States<'_>>, rows: &[Row], gauge: &GridProperties) -> Option<Score> {
    let states: Vec<Option<State>> = rows.iter().map(|row| known.borrow_mut().at(load(row, gauge.by_force))).collect();
    under(exact, rows, &states, gauge)
}

/// Returns the states under the loads of the rows, if they exist.
pub(in crate::validate) fn states(exact: &Exact<'_>, rows: &[Row], by_force: bool) -> Vec<Option<State>> {
    rows.iter().map(|row| exact.state(load(row, by_force))).collect()
}

/// Returns the score of rows with known states.
pub(in crate::validate) fn under(exact: &Exact<'_>, rows: &[Row], states: &[Option<State>], gauge: &GridProperties) -> Option<Score> {
    let judge = Tolerances { demanded: gauge.demanded, solver: gauge.solver };
    let (mut main, mut radius, mut lost) = (Norms::new(true), Norms::new(true), 0);
    for (row, state) in rows.iter().zip(states) {
        let load = load(row, gauge.by_force);
        let Some(state) = *state else {
            lost += 1;
            continue;
        };
        let allowed = judge.allowed(gauge.pixel, &state, exact.room(&state));
        match load {
            Load::Depth(_) if !row.force.is_nan() => main.add(0.0, 0.0, row.force, state.force, allowed),
            Load::Force(_) if !row.depth.is_nan() => main.add(0.0, 0.0, row.depth, exact.depth(&state), allowed),
            _ => {}
        }
        if !row.radius.is_nan() {
            let half = gauge.pixel.map_or(BLIND_RADIUS, |h| if state.radius > h { 0.5 * h / state.radius } else { 0.5 });
            radius.add(0.0, 0.0, row.radius, state.radius, half);
        }
    }
    if 4 * lost > rows.len() || (main.rows == 0 && radius.rows == 0) {
        return None;
    }
    let share = |own: &Norms| if own.rows == 0 { 0.0 } else { ratio(own.l2(), own.allowed()) };
    Some(Score { errors: [main.l2(), radius.l2()], shares: [share(&main), share(&radius)] })
}

/// Returns the score of pressures under a state; `None` if too few points can be compared.
pub(in crate::validate) fn field(pressures: &Pressures<'_>, spots: &[Spot], gauge: &GridProperties) -> Option<Score> {
    let state = &pressures.state;
    let a = state.radius;
    let region = Region::new(a, gauge.margin, &pressures.sharp);
    let inside: Vec<&Spot> = spots.iter().filter(|spot| region.holds(spot.r)).collect();
    if 3 * inside.len() < spots.len() || inside.len() < 3 || a <= 0.0 {
        return None;
    }
    let (mut wanted, mut found) = (Vec::new(), Vec::new());
    inside.iter().for_each(|spot| places(spot.r, gauge.cell, &mut wanted));
    pressures.at(&wanted, &mut found);
    let each = if gauge.cell.is_some() { 2 } else { 1 };
    let mut norms = Norms::new(false);
    for (spot, exact) in inside.iter().zip(found.chunks(each)) {
        let exact = exact.iter().sum::<f64>() / each as f64;
        if exact.is_finite() {
            let allowed = excused(spot.r, &region, gauge.pixel, state.boundary == Boundary::Rim);
            norms.add(0.0, 0.0, spot.p, exact, allowed + gauge.solver);
        }
    }
    // A contact that is smaller than the distance of all points explains nothing.
    if norms.rows < 3 || norms.allowed() == 0.0 {
        return None;
    }
    Some(Score { errors: [norms.l2(), 0.0], shares: [ratio(norms.l2(), norms.allowed()), 0.0] })
}
