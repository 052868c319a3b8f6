//! The diagnosis of files with fields.

use super::hypothesis::{self, ColumnMistake, Columns, Exchange, SolvedProblem};
use super::images::{self, Images};
use super::score::{GridProperties, Score};
use super::{Evidence, Ranked, Trial, Tried, minimum, minimum_by, score, thinned};
use crate::contact::{Load, State};
use crate::parse;
use crate::scene::{Control, Scene};
use crate::transform::Profile;
use crate::validate::exact::{Exact, Formula, Pressures};
use crate::validate::field::Spot;
use crate::validate::record::significant;
use crate::validate::region::Region;

/// Golden-section steps in the search for the side of a box; each requires a new exact solution, and together they are accurate to about 1e-4.
const SECTIONS_OF_A_SIDE: u32 = 14;

impl Trial<'_> {
    pub(super) fn field(&self, evidence: &Evidence) -> Option<Ranked> {
        let Evidence::Field { spots: all, state, held, side, placings, factors, columns } = evidence else { return None };
        // Exclude points outside the contact by their zero pressure, since r may be in another unit.
        let inside: Vec<Spot> = all.iter().copied().filter(|spot| spot.p != 0.0).collect();
        let solution = self.scene.solution().ok()?;
        let exact = Exact::new(self.scene, &solution, Load::Depth(state.depth)).ok()?;
        let formula = exact.formula();
        let known = exact.pressures(formula.as_ref(), state);
        // Exclude points near edges as well, unless too few points remain.
        let region = Region::new(state.radius, self.gauge.margin, &known.sharp);
        let clear: Vec<Spot> = inside.iter().copied().filter(|spot| region.holds(spot.r)).collect();
        let chosen = [&clear, &inside].into_iter().find(|own| own.len() >= 8).map_or(all.as_slice(), Vec::as_slice);
        let spots = thinned(chosen);
        // Use all points here: a sample may not contain any clipped pressures.
        if let Some(cut_off) = self.cut_off(&known, &clear, factors.1, columns) {
            let whole = score::field(&known, &clear, self.gauge);
            if super::chosen(whole, vec![cut_off.clone()]).is_some() {
                return Some((whole, vec![cut_off]));
            }
        }
        let before = score::field(&known, &spots, self.gauge);
        if before.is_some_and(|own| own.share() <= 1.0) {
            return self.lost(&known, all);
        }
        let mut tried = Vec::new();
        for fault in self.faults(&hypothesis::of_field(columns, self.gauge.pixel, *factors)) {
            let spots = placed(&spots, &fault.slip, *factors);
            if fault.taken == SolvedProblem::AsIs {
                // An inferred pixel scales with the coordinates, a declared pixel does not.
                let factor = fault.slip.distance;
                let slipped =
                    GridProperties { margin: self.gauge.margin / factor, pixel: self.gauge.pixel.map(|h| h / factor), ..*self.gauge };
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
        // Also where the box is declared as free, because a solver may be periodic by mistake.
        self.images(&exact, state, &spots, *side, &mut tried);
        self.fitted_field((&exact, formula.as_ref()), &known, &spots, &mut tried);
        Some((before, tried))
    }

    /// Checks for pressures that are correct up to some pixels inside the edge, and 0 beyond.
    fn lost(&self, known: &Pressures<'_>, all: &[Spot]) -> Option<Ranked> {
        let (a, pixel) = (known.state.radius, self.gauge.pixel?);
        let gauge = GridProperties { margin: pixel, ..*self.gauge };
        let (kept, gone): (Vec<Spot>, Vec<Spot>) = all.iter().filter(|spot| spot.r < a).partition(|spot| spot.p != 0.0);
        let end = kept.iter().map(|spot| spot.r).fold(0.0, f64::max);
        if end > a - 1.5 * pixel || gone.iter().any(|spot| spot.r < end) {
            return None;
        }
        let both: Vec<Spot> = kept.iter().chain(&gone).copied().collect();
        let text = format!("pressures are lost at the edge of the contact: they end {:.1} pixels inside the edge", (a - end) / pixel);
        let score = score::field(known, &kept, &gauge)?;
        Some((score::field(known, &both, &gauge), vec![Tried { id: "lost-edge", text, score, free: false, rough: true }]))
    }

    /// Checks for clipped pressures: several points have the largest pressure, and the other pressures are correct.
    fn cut_off(&self, known: &Pressures<'_>, clear: &[Spot], factor: f64, columns: &Columns) -> Option<Tried> {
        const FEWEST: usize = 3;
        let top = clear.iter().map(|spot| spot.p).fold(0.0, f64::max);
        let (flat, kept): (Vec<Spot>, Vec<Spot>) = clear.iter().partition(|spot| spot.p >= top * (1.0 - 1e-9));
        if flat.len() < FEWEST {
            return None;
        }
        let unit = columns.iter().find(|own| own.0 == "p").map_or("", |own| own.2.as_str());
        let text = format!("clipped pressures: none is larger than {}", significant(top / factor, unit));
        Some(Tried { id: "cut-off", text, score: score::field(known, &thinned(&kept), self.gauge)?, free: false, rough: false })
    }

    /// Tries a periodic box under the same force.
    fn images(&self, exact: &Exact<'_>, state: &State, spots: &[Spot], side: Option<f64>, tried: &mut Vec<Tried>) {
        let Some(free) = images::moments(exact, state) else { return };
        let load = Load::Force(state.force);
        let under = |images: Images| {
            let added = parse::profile(&images.surface()).ok()?;
            let profile = Profile::new(&crate::expr::Formula::sum([self.scene.profile.typed.clone(), added])).ok()?;
            let scene = Scene { profile, ..self.scene.clone() };
            self.solved(&scene, load, |exact| {
                let own = exact.state(load)?;
                let spots = images.without_fourfold(spots, own.radius, self.scene.effective_modulus);
                let score = score::field(&exact.pressures(exact.formula().as_ref(), &own), &spots, self.gauge)?;
                Some((score, images::moments(exact, &own)?))
            })
        };
        let mut take = |side: f64, is_fitted: bool| {
            let mut found = under(Images { side, moments: free });
            // The images change the contact and therefore its moments; two iterations are sufficient.
            for _ in 0..2 {
                found = found.and_then(|(_, moments)| under(Images { side, moments }));
            }
            let text = format!(
                "periodic images: the data fit a periodic box with a side of {:.3} a; pressures are too high inside and too low at the edge at the same force; use a half-space operator without images, since refinement does not help",
                side / state.radius
            );
            tried.extend(found.map(|(score, _)| Tried { id: "periodic", text, score, free: is_fitted, rough: true }));
        };
        if let Some(side) = side {
            take(side, false);
            return;
        }
        let a = state.radius;
        let share = |side: f64| under(Images { side, moments: free }).map_or(f64::MAX, |(score, _)| score.share());
        if let Some(x) = minimum_by(SECTIONS_OF_A_SIDE, 2.0f64.ln(), 12.0f64.ln(), 9, &|x| share(a * x.exp())) {
            take(a * x.exp(), true);
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
        let place = if planar { format!("({}, {})", self.length(x), self.length(y)) } else { format!("r = {}", self.length(x)) };
        let text = format!("a shifted origin: the axis of the data is at {place}");
        tried.extend(score(x, y).map(|score| Tried { id: "origin", text, score, free: true, rough: false }));

        let scaled = |factor: f64| {
            let spots: Vec<Spot> = spots.iter().map(|spot| Spot { p: spot.p / factor, ..*spot }).collect();
            score::field(known, &spots, self.gauge)
        };
        if let Some(x) = minimum(-1.0, 1.0, 81, &|x| share(scaled(10f64.powf(x)))) {
            let factor = 10f64.powf(x);
            let text = format!(
                "another modulus: all pressures are {factor:.4} times the exact values, as for {factor:.4} times the E* of the scene at the same depth"
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
            let text = format!("another load level: the pressures fit {:.4} times the force of the scene", x.exp());
            tried.extend(another(x).map(|score| Tried { id: "level", text, score, free: true, rough: false }));
        }
    }
}

fn held_load(control: Control, state: &State) -> Load {
    match control {
        Control::Depth => Load::Depth(state.depth),
        Control::Force => Load::Force(state.force),
        Control::ContactRadius => Load::Radius(state.radius),
    }
}

/// Returns the points with the mistake undone.
fn placed(spots: &[Spot], slip: &ColumnMistake, (length, pressure): (f64, f64)) -> Vec<Spot> {
    let one = |spot: &Spot| match slip.columns {
        Exchange::DistanceAndPressure => Spot { r: (spot.p / pressure * length).abs(), p: spot.r / length * pressure, ..*spot },
        _ => Spot { r: spot.r / slip.distance, p: spot.p / slip.pressure, ..*spot },
    };
    spots.iter().map(one).collect()
}
