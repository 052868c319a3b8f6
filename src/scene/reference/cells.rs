//! Means of the pressure over cells, as boundary element methods have them.

use super::NO_DIGITS;
use crate::contact::{ContactError, Expanded, PartialForce, State};
use crate::num::{Bound, Estimate, work};
use crate::scene::doubt::Doubt;
use crate::scene::{Dimension, Run};
use crate::transform::Superposition;
use std::cell::Cell;
use std::f64::consts::PI;

/// Pressures that the mean over a cell takes.
const FOR_A_CELL: usize = 50;
/// The same for the cells of a small grid, of which most may lie next to a kink, where each takes more and costlier pressures.
const FOR_FEW_CELLS: usize = 100_000;

type Force<'a> = PartialForce<'a, Expanded<Superposition<'a>>>;

/// The means of one contact pressure over cells.
pub(super) struct Means<'r, 'a> {
    run: &'r Run<'a>,
    radius: f64,
    /// The forces on its parts, and the errors of its state if they are known; `None` if the budget did not suffice.
    prepared: Option<Result<(Force<'a>, Option<Doubt>), ContactError>>,
    bound: &'r Cell<Bound>,
}

impl<'r, 'a> Means<'r, 'a> {
    /// Prepares `count` means under a state; `bound` becomes an estimate when one of them is.
    pub(super) fn new(run: &'r Run<'a>, state: &State, count: usize, bound: &'r Cell<Bound>) -> Self {
        run.expect(count.saturating_mul(FOR_A_CELL).max(FOR_FEW_CELLS));
        let length = run.scene().system.out(Dimension::LENGTH);
        let prepared = work::part(|| {
            let kinks = run.kinks().into_iter().map(|own| own.0 / length);
            Ok((PartialForce::new(&run.for_pressures(state), state.radius, kinks)?, run.doubt(state)))
        });
        Self { run, radius: state.radius, prepared, bound }
    }

    /// The mean over a ring, and its error, in the units of the answer.
    pub(super) fn on_ring(&self, [inner, outer]: [f64; 2]) -> Result<(f64, f64), &'static str> {
        self.mean(PI * (outer - inner) * (outer + inner), [inner, outer], None, |force| force.on_ring(inner, outer))
    }

    /// The mean over a rectangle that does not cross the axes, and its error, in the units of the answer.
    pub(super) fn on_rectangle(&self, x: [f64; 2], y: [f64; 2]) -> Result<(f64, f64), &'static str> {
        let ([x0, x1], [y0, y1]) = (x, y);
        let (ends, diagonal) = ([x0.hypot(y0), x1.hypot(y1)], (x1 - x0).hypot(y1 - y0));
        if ends[0] >= self.radius {
            return Ok((0.0, 0.0));
        }
        self.mean((x1 - x0) * (y1 - y0), ends, Some(diagonal), |force| force.on_rectangle(x, y))
    }

    fn mean(
        &self,
        area: f64,
        ends: [f64; 2],
        diagonal: Option<f64>,
        on_cell: impl FnOnce(&Force<'a>) -> Result<Estimate, ContactError>,
    ) -> Result<(f64, f64), &'static str> {
        let prepared = self.prepared.as_ref().ok_or_else(|| self.run.point_is_cut())?;
        let Ok((force, Some(doubt))) = prepared else { return Err(NO_DIGITS) };
        let found = work::part(|| on_cell(force)).ok_or_else(|| self.run.point_is_cut())?;
        let own = found.ok().filter(|own| own.value.is_finite() && own.error.is_finite()).ok_or(NO_DIGITS)?;
        self.run.told();
        self.bound.set(self.bound.get().and(own.bound).and(doubt.bound));
        let (value, factor) = (own.value / area, self.run.scene().system.out(Dimension::PRESSURE));
        let error = own.error / area + 2.0 * f64::EPSILON * value.abs() + doubt.of_mean(ends, diagonal, area, value);
        Ok((value * factor, error * factor.abs()))
    }
}
