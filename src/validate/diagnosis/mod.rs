//! The diagnosis: every known fault is put right, the exact solution computed again, and the fault named if the error then falls to that of the grid.

pub(crate) mod displacement;
pub(crate) mod hypothesis;
pub(crate) mod placing;
pub(crate) mod score;

use super::exact::{Exact, Formula, Pressures};
use super::field::{Region, Spot};
use super::record::Suspicion;
use crate::contact::{Load, State};
use crate::num::work;
use crate::parse;
use crate::scene::{Change, Control, Scene, scene_for_data};
use crate::transform::Profile;
use crate::validate::file::row::Row;
use hypothesis::{Exchange, Fault, Slip, Taken};
use placing::Placing;
use score::{Gauge, Score};
use std::cell::Cell;

/// Data that failed.
pub(super) enum Evidence {
    Loads {
        rows: Vec<Row>,
        /// Computed units per number of the columns.
        factors: Row,
    },
    Field {
        spots: Vec<Spot>,
        /// The state of the scene's load.
        state: State,
        /// What stays when the scene changes.
        held: Vec<Control>,
        /// The side of the solver's box, where it is known.
        side: Option<f64>,
        /// True where the box is said not to repeat.
        free: bool,
        /// Mistakes about the place of the axis that fit the coordinates.
        placings: Vec<Placing>,
        /// Computed units per number of the columns r (or x) and p.
        factors: (f64, f64),
    },
}

/// The error must fall by this much, and to this many times what the grid excuses.
const FALL: f64 = 6.0;
const SHARE: f64 = 2.0;
/// Rows and places that a hypothesis is tried on.
const TRIED: usize = 40;

/// Steps of work for one hypothesis that needs an exact solution of its own, and for all of them together: about 0.2 and 1.5 seconds.
const ONE: u64 = 20_000_000;
const ALL: u64 = 150_000_000;

/// A hypothesis that was tried.
struct Tried {
    id: &'static str,
    text: String,
    score: Score,
    /// Free numbers that were fitted.
    free: bool,
    /// True where the effect itself is known to an order only.
    rough: bool,
}

/// Names the one fault that explains the data.
pub(super) fn diagnose(text: &str, scene: &Scene, evidence: &Evidence, gauge: &Gauge) -> Option<Suspicion> {
    // The verdict stands already: what is left of the budget must not be used up by the search for its cause.
    let trial = Trial { text, scene, gauge, left: Cell::new(ALL.min(work::left() / 2)) };
    let (before, tried) = match evidence {
        Evidence::Loads { rows, factors } => trial.loads(rows, factors)?,
        Evidence::Field { .. } => trial.field(evidence)?,
    };
    chosen(before, tried)
}

fn chosen(before: Option<Score>, tried: Vec<Tried>) -> Option<Suspicion> {
    let old = |column: usize| before.and_then(|own| own.errors.get(column).copied()).unwrap_or(f64::MAX);
    let column = before.map_or(0, |own| own.worst());
    let error = |own: &Tried| own.score.errors.get(column).copied().unwrap_or(f64::MAX);
    let explains = |own: &Tried| {
        let fell = error(own) * FALL <= old(column);
        // A coarse grid makes small errors that a free number can always follow.
        let clear = before.is_none_or(|before| before.share() >= if own.free { 3.0 } else { 1.5 });
        clear && fell && (own.score.share() <= SHARE || (own.rough && error(own) <= 3e-3))
    };
    let best = |free: bool| {
        let all = tried.iter().filter(|own| own.free == free && explains(own));
        // The first of the list wins among those that no grid can tell apart.
        all.fold(None::<&Tried>, |best, own| match best {
            Some(best) if 1.3 * own.score.share() >= best.score.share() => Some(best),
            _ => Some(own),
        })
    };
    let found = match (best(false), best(true)) {
        (Some(fixed), Some(free)) if 3.0 * error(free) < error(fixed) && fixed.score.share() > 0.7 => free,
        (Some(fixed), _) => fixed,
        (None, free) => free?,
    };
    Some(Suspicion { id: found.id, text: found.text.clone(), before: old(column), after: error(found) })
}

/// At most so many items, evenly chosen.
fn thinned<T: Copy>(items: &[T]) -> Vec<T> {
    let every = items.len().div_ceil(TRIED).max(1);
    items.iter().copied().step_by(every).collect()
}

struct Trial<'t> {
    text: &'t str,
    scene: &'t Scene,
    gauge: &'t Gauge,
    /// Steps of work left for exact solutions of hypotheses.
    left: Cell<u64>,
}

/// What was found before, and every hypothesis that could be tried.
type Found = (Option<Score>, Vec<Tried>);

impl Trial<'_> {
    fn loads(&self, all: &[Row], factors: &Row) -> Option<Found> {
        let rows = &thinned(all);
        // Neighbours are neighbours only where none is left out.
        let neighbours = all.get(all.len().saturating_sub(TRIED)..)?;
        let solution = self.scene.solution().ok()?;
        let largest = score::largest(rows, self.gauge.by_force);
        let exact = Exact::new(self.scene, &solution, largest).ok()?;
        let states = score::states(&exact, rows, self.gauge.by_force);
        let before = score::under(&exact, rows, &states, self.gauge);
        let faults = self.faults(&hypothesis::of_loads());
        // The work may end: loads that stay as they are have their contacts already, and far ones cost most.
        let mut order: Vec<(usize, &Fault)> = faults.iter().enumerate().collect();
        let far = |fault: &Fault| if fault.slip.columns == Exchange::Nothing { fault.slip.depth.abs().ln().abs() } else { f64::MAX };
        order.sort_by(|one, other| far(one.1).total_cmp(&far(other.1)));
        let mut found: Vec<(usize, Tried)> = Vec::new();
        // The states of the last loads that are far from those of the data.
        let mut far_states: Option<(Load, Vec<Option<State>>)> = None;
        for (index, fault) in order {
            let level = fault.slip.ahead != 0 || fault.slip.force_ahead != 0;
            // Forces are in proportion to the modulus.
            let force = if let Taken::Modulus(factor) = fault.taken { factor } else { 1.0 };
            let slip = Slip { force: force * fault.slip.force, ..fault.slip };
            let rows = corrected(if level { neighbours } else { rows }, &slip, factors);
            let own = score::largest(&rows, self.gauge.by_force);
            let load = if self.gauge.by_force { slip.force } else { slip.depth };
            let stays = load == 1.0 && slip.ahead == 0 && slip.force_ahead == 0 && slip.columns == Exchange::Nothing;
            let score = match fault.taken {
                Taken::AsIs | Taken::Modulus(_) if stays => score::under(&exact, &rows, &states, self.gauge),
                Taken::AsIs | Taken::Modulus(_) if is_near(own, largest) => self.limited(|| score::loads(&exact, &rows, self.gauge)),
                Taken::AsIs | Taken::Modulus(_) => {
                    if far_states.as_ref().is_none_or(|known| known.0 != own) {
                        let states = |exact: Exact<'_>| score::states(&exact, &rows, self.gauge.by_force);
                        far_states = self.limited(|| Exact::new(self.scene, &solution, own).ok().map(states)).map(|found| (own, found));
                    }
                    far_states.as_ref().and_then(|(_, states)| score::under(&exact, &rows, states, self.gauge))
                }
                Taken::Changed(_) | Taken::Parabola => self.with(&fault.taken, &exact, own, |exact| score::loads(exact, &rows, self.gauge)),
            };
            found.extend(score.map(|score| (index, Tried { id: fault.id, text: fault.text.clone(), score, free: false, rough: false })));
        }
        found.sort_by_key(|own| own.0);
        let mut tried: Vec<Tried> = found.into_iter().map(|own| own.1).collect();
        self.references(&exact, rows, &mut tried);
        self.fitted(&exact, rows, &mut tried);
        Some((before, tried))
    }

    /// Depths that are measured elsewhere: at the edge of the contact.
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
            (edge, "depth from another reference: d is the displacement at the edge of the contact, d - f(a), not at the axis"),
            (contact, "depth from another reference: d is the height f(a) of the contact alone, without the sink-in outside"),
        ] {
            let score = score::loads(exact, &rows, self.gauge);
            tried.extend(score.map(|score| Tried { id: "reference", text: text.to_owned(), score, free: false, rough: false }));
        }
    }

    /// Faults with a free number.
    fn fitted(&self, exact: &Exact<'_>, rows: &[Row], tried: &mut Vec<Tried>) {
        let deepest = rows.iter().map(|row| row.depth.abs()).fold(0.0, f64::max);
        let strongest = rows.iter().map(|row| row.force.abs()).fold(0.0, f64::max);
        if rows.len() < 3 || deepest == 0.0 || strongest == 0.0 {
            return;
        }
        let score = |factor: f64| {
            let rows: Vec<Row> = rows.iter().map(|row| Row { force: row.force / factor, ..*row }).collect();
            score::loads(exact, &rows, self.gauge)
        };
        if let Some(x) = minimum(-1.0, 1.0, 81, &|x| score(10f64.powf(x)).map_or(f64::MAX, |own| own.share())) {
            let factor = 10f64.powf(x);
            let text = format!(
                "another modulus: all forces are {factor:.4} times the exact ones at their depth, as for an E* {factor:.4} times that of the scene"
            );
            tried.extend(score(factor).map(|score| Tried { id: "modulus", text, score, free: true, rough: false }));
        }
        let mut fit = |id: &'static str, name: &dyn Fn(f64) -> String, change: &dyn Fn(&Row, f64) -> Row| {
            let score = |x: f64| score::loads(exact, &rows.iter().map(|row| change(row, x)).collect::<Vec<_>>(), self.gauge);
            let Some(x) = minimum(-0.5, 0.5, 41, &|x| score(x).map_or(f64::MAX, |own| own.share())) else { return };
            tried.extend(score(x).map(|score| Tried { id, text: name(x), score, free: true, rough: false }));
        };
        let length = |x: f64| {
            let unit = self.scene.system.unit_name(crate::scene::Dimension::LENGTH);
            format!("{:.4e} {unit}", x * deepest * self.scene.system.out(crate::scene::Dimension::LENGTH)).trim_end().to_owned()
        };
        fit("reference", &|x| format!("depth from another reference: every d is too large by {}", length(x)), &|row, x| Row {
            depth: row.depth - x * deepest,
            ..*row
        });
        fit(
            "compliance",
            &|x| {
                format!(
                    "depth from another reference: d holds a part in proportion to the force, {} at the largest, as of a compliant frame or of periodic images",
                    length(x)
                )
            },
            &|row, x| Row { depth: row.depth - x * deepest * row.force / strongest, ..*row },
        );
        fit("tare", &|x| format!("every F is too large by {x:.4} times the largest one: its zero is another one"), &|row, x| Row {
            force: row.force - x * strongest,
            ..*row
        });
    }

    fn field(&self, evidence: &Evidence) -> Option<Found> {
        let Evidence::Field { spots: all, state, held, side, free, placings, factors } = evidence else { return None };
        // Places far outside say nothing; where the unit of r has slipped the pressures tell what lies inside.
        let inside: Vec<Spot> = all.iter().copied().filter(|spot| spot.p != 0.0).collect();
        let solution = self.scene.solution().ok()?;
        let exact = Exact::new(self.scene, &solution, Load::Depth(state.depth)).ok()?;
        let formula = exact.formula();
        let known = exact.pressures(formula.as_ref(), state);
        // Places next to edges say nothing either, if they are where the file says.
        let region = Region::new(state.radius, self.gauge.margin, &known.sharp);
        let clear: Vec<Spot> = inside.iter().copied().filter(|spot| region.holds(spot.r)).collect();
        let chosen = [&clear, &inside].into_iter().find(|own| own.len() >= 8).map_or(all.as_slice(), Vec::as_slice);
        let spots = thinned(chosen);
        let before = score::field(&known, &spots, self.gauge);
        if before.is_some_and(|own| own.share() <= 1.0) {
            return self.lost(&known, all);
        }
        let mut tried = Vec::new();
        tried.extend(self.cut_off(&known, &clear, factors.1));
        for fault in self.faults(&hypothesis::of_field(self.gauge.pixel, *factors)) {
            let spots = placed(&spots, &fault.slip, *factors);
            if fault.taken == Taken::AsIs {
                // A pixel that was read off the places has slipped with them, one that was declared has not.
                let factor = fault.slip.distance;
                let slipped = Gauge { margin: self.gauge.margin / factor, pixel: self.gauge.pixel.map(|h| h / factor), ..*self.gauge };
                for gauge in [slipped, *self.gauge] {
                    let found = score::field(&known, &spots, &gauge);
                    tried.extend(found.map(|score| Tried { id: fault.id, text: fault.text.clone(), score, free: false, rough: false }));
                }
                continue;
            }
            for control in held {
                let load = held_load(*control, state);
                let found = self.with(&fault.taken, &exact, load, |exact| {
                    score::field(&exact.pressures(exact.formula().as_ref(), &exact.state(load)?), &spots, self.gauge)
                });
                tried.extend(found.map(|score| Tried { id: fault.id, text: fault.text.clone(), score, free: false, rough: false }));
            }
        }
        for placing in placings {
            let spots: Vec<Spot> = spots.iter().map(|spot| spot.at(placing.at(spot.x, spot.y))).collect();
            let found = score::field(&known, &spots, self.gauge);
            tried.extend(found.map(|score| Tried { id: placing.id, text: placing.text.to_owned(), score, free: false, rough: false }));
        }
        if !free {
            self.images(state, &spots, *side, &mut tried);
        }
        self.fitted_field((&exact, formula.as_ref()), &known, &spots, &mut tried);
        Some((before, tried))
    }

    /// Pressures that are right up to some pixels within the edge, and 0 beyond.
    fn lost(&self, known: &Pressures<'_>, all: &[Spot]) -> Option<Found> {
        let (a, pixel) = (known.state.radius, self.gauge.pixel?);
        let gauge = Gauge { margin: pixel, ..*self.gauge };
        let (kept, gone): (Vec<Spot>, Vec<Spot>) = all.iter().filter(|spot| spot.r < a).partition(|spot| spot.p != 0.0);
        let end = kept.iter().map(|spot| spot.r).fold(0.0, f64::max);
        if end > a - 1.5 * pixel || gone.iter().any(|spot| spot.r < end) {
            return None;
        }
        let both: Vec<Spot> = kept.iter().chain(&gone).copied().collect();
        let text = format!("pressures are lost at the edge of the contact: they end {:.1} pixels inside of it", (a - end) / pixel);
        let score = score::field(known, &kept, &gauge)?;
        Some((score::field(known, &both, &gauge), vec![Tried { id: "lost-edge", text, score, free: false, rough: true }]))
    }

    /// Pressures that are cut off: several places have the largest one, and the others are right.
    fn cut_off(&self, known: &Pressures<'_>, clear: &[Spot], factor: f64) -> Option<Tried> {
        const FEWEST: usize = 3;
        let top = clear.iter().map(|spot| spot.p).fold(0.0, f64::max);
        let (flat, kept): (Vec<Spot>, Vec<Spot>) = clear.iter().partition(|spot| spot.p >= top * (1.0 - 1e-9));
        if flat.len() < FEWEST {
            return None;
        }
        let text = format!("pressures are cut off: none is larger than {:.6e}", top / factor);
        Some(Tried { id: "cut-off", text, score: score::field(known, &thinned(&kept), self.gauge)?, free: false, rough: false })
    }

    /// A box that repeats: its images press at the same force on a surface that they bend by c r² + e r⁴.
    ///
    /// A force F at the distance ρ lowers the surface by F/(πE*ρ); over a square lattice of side L the mean over the angle has
    /// r² Σρ⁻³/4 and 9 r⁴ Σρ⁻⁵/64, where L³Σρ⁻³ = 9.0336 and L⁵Σρ⁻⁵ = 5.0903; a constant moves the depth only.
    fn images(&self, state: &State, spots: &[Spot], side: Option<f64>, tried: &mut Vec<Tried>) {
        let score = |side: f64| {
            let force = state.force / (std::f64::consts::PI * self.scene.effective_modulus);
            let (second, fourth) = (force * 9.033_6 / 4.0 / side.powi(3), force * 9.0 * 5.090_3 / 64.0 / side.powi(5));
            let added = parse::profile(&format!("{second:e}*r^2+{fourth:e}*r^4")).ok()?;
            let profile = Profile::new(&crate::expr::Formula::sum([self.scene.profile.typed.clone(), added])).ok()?;
            let scene = Scene { profile, ..self.scene.clone() };
            self.solved(&scene, Load::Force(state.force), |exact| {
                let own = exact.state(Load::Force(state.force))?;
                score::field(&exact.pressures(exact.formula().as_ref(), &own), spots, self.gauge)
            })
        };
        let a = state.radius;
        let text = |side: f64| {
            format!(
                "periodic images: the data fit a box that repeats with a side of {:.3} a, with pressures too high inside, too low at the edge and the force conserved; refinement cannot cure that, a free half-space operator would",
                side / a
            )
        };
        if let Some(own) = side {
            tried.extend(score(own).map(|score| Tried { id: "periodic", text: text(own), score, free: false, rough: true }));
            return;
        }
        let fitted = minimum(2.0f64.ln(), 12.0f64.ln(), 9, &|x| score(a * x.exp()).map_or(f64::MAX, |own| own.share()));
        if let Some(own) = fitted.map(|x| a * x.exp()) {
            tried.extend(score(own).map(|score| Tried { id: "periodic", text: text(own), score, free: true, rough: true }));
        }
    }

    fn fitted_field(
        &self,
        (exact, formula): (&Exact<'_>, Option<&Formula<'_>>),
        known: &Pressures<'_>,
        spots: &[Spot],
        tried: &mut Vec<Tried>,
    ) {
        let State { radius: a, force, .. } = known.state;
        let share = |own: Option<Score>| own.map_or(f64::MAX, |own| own.share());
        let length = |x: f64| {
            let unit = self.scene.system.unit_name(crate::scene::Dimension::LENGTH);
            format!("{:.4e} {unit}", x * self.scene.system.out(crate::scene::Dimension::LENGTH)).trim_end().to_owned()
        };
        let moved = |x: f64, y: f64| -> Vec<Spot> {
            let one = |spot: &Spot| {
                let r = if spot.y.is_nan() || spot.x.is_nan() { (spot.r - x).abs() } else { (spot.x - x).hypot(spot.y - y) };
                Spot { r, ..*spot }
            };
            spots.iter().map(one).collect()
        };
        let score = |x: f64, y: f64| score::field(known, &moved(x, y), self.gauge);
        let planar = spots.iter().all(|spot| !spot.x.is_nan() && !spot.y.is_nan());
        let (mut x, mut y) = (0.0, 0.0);
        for _ in 0..if planar { 4 } else { 1 } {
            x = minimum(-0.5 * a, 0.5 * a, 41, &|own| share(score(own, y))).unwrap_or(x);
            if planar {
                y = minimum(-0.5 * a, 0.5 * a, 41, &|own| share(score(x, own))).unwrap_or(y);
            }
        }
        let place = if planar { format!("({}, {})", length(x), length(y)) } else { format!("r = {}", length(x)) };
        let text = format!("a shifted origin: the axis of the data lies at {place}");
        tried.extend(score(x, y).map(|score| Tried { id: "origin", text, score, free: true, rough: false }));

        let scaled = |factor: f64| {
            let spots: Vec<Spot> = spots.iter().map(|spot| Spot { p: spot.p / factor, ..*spot }).collect();
            score::field(known, &spots, self.gauge)
        };
        if let Some(x) = minimum(-1.0, 1.0, 81, &|x| share(scaled(10f64.powf(x)))) {
            let factor = 10f64.powf(x);
            let text = format!(
                "another modulus: all pressures are {factor:.4} times the exact ones, as for an E* {factor:.4} times that of the scene at the same depth"
            );
            tried.extend(scaled(factor).map(|score| Tried { id: "modulus", text, score, free: true, rough: false }));
        }
        let another = |x: f64| {
            self.limited(|| {
                let own = exact.state(Load::Force(force * x.exp()))?;
                score::field(&exact.pressures(formula, &own), spots, self.gauge)
            })
        };
        if let Some(x) = minimum(-1.6, 1.6, 41, &|x| share(another(x))) {
            let text = format!("a load level off: the pressures belong to a force {:.4} times that of the scene's load", x.exp());
            tried.extend(another(x).map(|score| Tried { id: "level", text, score, free: true, rough: false }));
        }
    }

    fn faults(&self, of_data: &[Fault]) -> Vec<Fault> {
        let without_poisson = scene_for_data(self.text, &Change::NoPoisson).ok().map(|own| own.effective_modulus);
        let mut all = hypothesis::of_the_model(self.scene, without_poisson);
        all.extend_from_slice(of_data);
        all
    }

    /// Asks the exact solution of what the solver may have taken the scene for.
    fn with<T>(&self, taken: &Taken, exact: &Exact<'_>, largest: Load, ask: impl FnOnce(&Exact<'_>) -> Option<T>) -> Option<T> {
        let scene = match taken {
            Taken::AsIs => self.scene.clone(),
            Taken::Changed(change) => {
                let changed = scene_for_data(self.text, change).ok()?;
                Scene { tip: self.scene.tip.clone(), ..changed }
            }
            Taken::Modulus(factor) => Scene { effective_modulus: self.scene.effective_modulus * factor, ..self.scene.clone() },
            Taken::Parabola => {
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

    /// The answer, where it takes no more than one hypothesis may; what it costs is taken from what is left for all.
    fn limited<T>(&self, ask: impl FnOnce() -> Option<T>) -> Option<T> {
        let (found, spent, whole) = work::apart(ONE.min(self.left.get()), ask);
        self.left.set(self.left.get().saturating_sub(spent));
        work::spend(spent);
        found.filter(|_| whole)
    }
}

/// True for a load that a solution for another largest load has looked at closely.
fn is_near(load: Load, largest: Load) -> bool {
    match (load, largest) {
        (Load::Depth(own), Load::Depth(other)) | (Load::Force(own), Load::Force(other)) => (0.05..=1.0 + 1e-9).contains(&(own / other)),
        _ => false,
    }
}

fn held_load(control: Control, state: &State) -> Load {
    match control {
        Control::Depth => Load::Depth(state.depth),
        Control::Force => Load::Force(state.force),
        Control::ContactRadius => Load::Radius(state.radius),
    }
}

/// Rows without the slip.
fn corrected(rows: &[Row], slip: &Slip, factors: &Row) -> Vec<Row> {
    let rows: Vec<Row> = rows.iter().filter_map(|row| slip.columns.exchanged(row, factors)).collect();
    let at = |index: usize, ahead: i32| index.checked_add_signed(-ahead as isize).and_then(|own| rows.get(own));
    let one = |(index, row): (usize, &Row)| {
        let (force, radius) = (at(index, slip.ahead + slip.force_ahead)?.force, at(index, slip.ahead)?.radius);
        Some(Row { depth: row.depth / slip.depth, force: force / slip.force, radius: radius / slip.radius })
    };
    rows.iter().enumerate().filter_map(one).collect()
}

/// Places without the slip.
fn placed(spots: &[Spot], slip: &Slip, (length, pressure): (f64, f64)) -> Vec<Spot> {
    let one = |spot: &Spot| match slip.columns {
        Exchange::DistanceAndPressure => Spot { r: (spot.p / pressure * length).abs(), p: spot.r / length * pressure, ..*spot },
        _ => Spot { r: spot.r / slip.distance, p: spot.p / slip.pressure, ..*spot },
    };
    spots.iter().map(one).collect()
}

/// The smallest value of a function over an interval: the best of evenly spaced trials, made sharp by golden sections.
fn minimum(low: f64, high: f64, trials: u32, f: &dyn Fn(f64) -> f64) -> Option<f64> {
    let at = |index: u32| low + (high - low) * f64::from(index) / f64::from(trials - 1);
    let best = (0..trials).map(|index| (index, f(at(index)))).min_by(|one, other| one.1.total_cmp(&other.1))?;
    if best.1 == f64::MAX {
        return None;
    }
    let (mut left, mut right) = (at(best.0.saturating_sub(1)), at((best.0 + 1).min(trials - 1)));
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let (mut inner, mut outer) = (right - golden * (right - left), left + golden * (right - left));
    let (mut f_inner, mut f_outer) = (f(inner), f(outer));
    for _ in 0..28 {
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
