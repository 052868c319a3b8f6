//! The diagnosis: each known fault is corrected and the exact solution recomputed; a fault is reported if the error then decreases to the discretization error.

pub(crate) mod displacement;
mod field;
pub(crate) mod hypothesis;
mod images;
mod loads;
pub(crate) mod placing;
pub(crate) mod score;

use super::exact::Exact;
use super::field::Spot;
use super::record::Suspicion;
use crate::contact::{Load, State};
use crate::num::work;
use crate::parse;
use crate::scene::{Change, Control, Dimension, Scene, scene_for_data};
use crate::transform::Profile;
use crate::validate::file::row::Row;
use hypothesis::{Columns, Fault, SolvedProblem};
use placing::Placing;
use score::{GridProperties, Score};
use std::cell::Cell;

/// The data that failed.
pub(super) enum Evidence {
    Loads {
        rows: Vec<Row>,
        /// Factors that convert the columns to computing units.
        factors: Row,
        columns: Columns,
    },
    Field {
        spots: Vec<Spot>,
        /// The state under the load of the scene.
        state: State,
        /// Inputs that do not change with the scene.
        held: Vec<Control>,
        /// The side of the domain, if it is known.
        side: Option<f64>,
        /// Possible mistakes about the position of the axis that fit the coordinates.
        placings: Vec<Placing>,
        /// Factors that convert the columns r (or x) and p to computing units.
        factors: (f64, f64),
        columns: Columns,
    },
}

/// The error must decrease by this factor, and to this multiple of the discretization error.
const FALL: f64 = 6.0;
const SHARE: f64 = 2.0;
/// A factor that reduces the error so much is not the error of a grid, which changes with the contact radius.
const CONSTANT: f64 = 30.0;
/// The residual error of an approximate hypothesis; for periodic images it is 4.3e-3 at a side of 2.05 a.
const ROUGH: f64 = 5e-3;
/// Number of rows or points on which a hypothesis is tested.
const TRIED: usize = 40;

/// Maximum work for a hypothesis that requires a new exact solution, in steps (about 0.2 s).
const ONE: u64 = 20_000_000;
/// Maximum work for all such hypotheses together, in steps (about 1 s).
const ALL: u64 = 100_000_000;

/// A tested hypothesis.
#[derive(Clone)]
struct Tried {
    id: &'static str,
    text: String,
    score: Score,
    /// True if a number was fitted.
    free: bool,
    /// True if the effect of the fault is known only approximately.
    rough: bool,
}

/// Finds the fault that explains the data; an error if the budget does not suffice for the search.
pub(super) fn diagnose(text: &str, scene: &Scene, evidence: &Evidence, gauge: &GridProperties) -> Result<Option<Suspicion>, Unfinished> {
    let trial = Trial { text, scene, gauge, left: Cell::new(ALL) };
    let search = || {
        let (before, tried) = match evidence {
            Evidence::Loads { rows, factors, columns } => trial.loads(rows, factors, columns)?,
            Evidence::Field { .. } => trial.field(evidence)?,
        };
        chosen(before, tried)
    };
    // The rest is for writing the verdict.
    let most = work::left() - work::left() / 8;
    work::until_deadline(|| work::share(most, search)).ok_or(Unfinished)
}

/// The search for a fault was cut short.
pub(super) struct Unfinished;

fn chosen(before: Option<Score>, tried: Vec<Tried>) -> Option<Suspicion> {
    let old = |column: usize| before.and_then(|own| own.errors.get(column).copied()).unwrap_or(f64::MAX);
    let column = before.map_or(0, |own| own.worst());
    let error = |own: &Tried| own.score.errors.get(column).copied().unwrap_or(f64::MAX);
    let explains = |own: &Tried| {
        let fell = error(own) * FALL <= old(column);
        // The small errors of a coarse grid can always be reproduced by a fitted number, but not by one factor for all loads.
        let is_one_factor = own.id == "modulus" && error(own) * CONSTANT <= old(column);
        let clear = before.is_none_or(|before| before.share() >= if own.free && !is_one_factor { 3.0 } else { 1.0 });
        clear && fell && (own.score.share() <= SHARE || (own.rough && error(own) <= ROUGH))
    };
    let best = |free: bool| {
        let all = tried.iter().filter(|own| own.free == free && explains(own));
        // Among faults that cannot be distinguished, the first is reported.
        all.fold(None::<&Tried>, |best, own| match best {
            Some(best) if 1.3 * own.score.share() >= best.score.share() => Some(best),
            _ => Some(own),
        })
    };
    let found = match (best(false), best(true)) {
        (Some(fixed), Some(free)) if 3.0 * error(free) < error(fixed) && fixed.score.share() > 0.7 => free,
        // Without a known grid the tolerance is wide: a fitted number with a much smaller error is more likely than a fault within the tolerance.
        (Some(fixed), Some(free)) if 30.0 * error(free) < error(fixed) => free,
        (Some(fixed), _) => fixed,
        (None, free) => free?,
    };
    Some(Suspicion { id: found.id, text: found.text.clone(), before: old(column), after: error(found) })
}

/// Returns at most this many items, evenly sampled.
fn thinned<T: Copy>(items: &[T]) -> Vec<T> {
    let every = items.len().div_ceil(TRIED).max(1);
    items.iter().copied().step_by(every).collect()
}

struct Trial<'t> {
    text: &'t str,
    scene: &'t Scene,
    gauge: &'t GridProperties,
    /// Number of steps left for exact solutions of hypotheses.
    left: Cell<u64>,
}

/// The score of the data as they are, and every hypothesis that was tested.
type Ranked = (Option<Score>, Vec<Tried>);

impl Trial<'_> {
    fn faults(&self, of_data: &[Fault]) -> Vec<Fault> {
        let without_poisson = scene_for_data(self.text, &Change::NoPoisson).ok().map(|own| own.effective_modulus);
        let mut all = hypothesis::of_the_model(self.scene, without_poisson);
        all.extend_from_slice(of_data);
        all
    }

    /// Formats a length in the output unit of the scene.
    fn length(&self, x: f64) -> String {
        let system = &self.scene.system;
        format!("{:.4e} {}", x * system.out(Dimension::LENGTH), system.unit_name(Dimension::LENGTH)).trim_end().to_owned()
    }

    /// Tests the exact solutions of the problems that the solver may have solved instead of the scene.
    fn with<T>(&self, taken: &SolvedProblem, exact: &Exact<'_>, largest: Load, ask: impl FnOnce(&Exact<'_>) -> Option<T>) -> Option<T> {
        let scene = match taken {
            SolvedProblem::AsIs => self.scene.clone(),
            SolvedProblem::Changed(change) => {
                let changed = scene_for_data(self.text, change).ok()?;
                Scene { tip: self.scene.tip.clone(), ..changed }
            }
            SolvedProblem::Modulus(factor) => Scene { effective_modulus: self.scene.effective_modulus * factor, ..self.scene.clone() },
            SolvedProblem::Parabola => {
                let scale = self.scene.rim.unwrap_or(self.gauge.margin.max(f64::MIN_POSITIVE) * 4.0);
                let bend = exact.bend(scale)?;
                let profile = Profile::new(&parse::profile(&format!("{bend:e}*r^2")).ok()?).ok()?;
                Scene { profile, ..self.scene.clone() }
            }
        };
        self.solved(&scene, largest, ask)
    }

    fn solved<T>(&self, scene: &Scene, largest: Load, ask: impl FnOnce(&Exact<'_>) -> Option<T>) -> Option<T> {
        self.limited(|| {
            let solution = scene.solution().ok()?;
            ask(&Exact::new(scene, &solution, largest).ok()?)
        })
    }

    /// Runs a computation if its work stays within the limits for one hypothesis and for all of them.
    fn limited<T>(&self, ask: impl FnOnce() -> Option<T>) -> Option<T> {
        let most = ONE.min(self.left.get());
        if most == 0 || work::is_exhausted() {
            return None;
        }
        let (found, spent, whole) = work::apart(most, ask);
        self.left.set(self.left.get().saturating_sub(spent));
        work::spend(spent);
        found.filter(|_| whole)
    }
}

/// Number of golden-section steps for cheap functions.
const SECTIONS: u32 = 28;

/// Minimizes a function over an interval: the best of evenly spaced trials, refined by golden-section search.
fn minimum(low: f64, high: f64, trials: u32, f: &dyn Fn(f64) -> f64) -> Option<f64> {
    minimum_by(SECTIONS, low, high, trials, f)
}

/// Minimizes a function with a given number of golden-section steps.
fn minimum_by(sections: u32, low: f64, high: f64, trials: u32, f: &dyn Fn(f64) -> f64) -> Option<f64> {
    let at = |index: u32| low + (high - low) * f64::from(index) / f64::from(trials - 1);
    let best = (0..trials).map(|index| (index, f(at(index)))).min_by(|one, other| one.1.total_cmp(&other.1))?;
    if best.1 == f64::MAX {
        return None;
    }
    let (mut left, mut right) = (at(best.0.saturating_sub(1)), at((best.0 + 1).min(trials - 1)));
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let (mut inner, mut outer) = (right - golden * (right - left), left + golden * (right - left));
    let (mut f_inner, mut f_outer) = (f(inner), f(outer));
    for _ in 0..sections {
        if f_inner <= f_outer {
            (right, outer, f_outer) = (outer, inner, f_inner);
            inner = right - golden * (right - left);
            f_inner = f(inner);
        } else {
            (left, inner, f_inner) = (inner, outer, f_outer);
            outer = left + golden * (right - left);
            f_outer = f(outer);
        }
    }
    Some(0.5 * (left + right))
}
