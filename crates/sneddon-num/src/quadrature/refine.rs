//! The work list of the adaptive quadrature: what to refine next, how, and when to stop.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::super::bounded::Bounded;
use super::super::error::NumError;
use super::super::estimate::Estimate;
use super::super::work;
use super::sample::{Order, Part, Sample, sample};
use super::transform::Map;
use super::{Integrand, Options, Rule};

/// Deepest bisection: positions stay exact integers.
const DEEPEST: u32 = 50;
/// First level at which zeros at all points imply a zero panel.
const BLANK_LEVEL: u32 = 3;
/// Bisections without effect after which a piece is left alone.
const MOST_STALLS: u8 = 12;
/// The same if the error is so small relative to |f| that noise is the likely reason.
const MOST_STALLS_IN_NOISE: u8 = 4;

/// A part of a panel with the estimate of its integral.
pub(super) struct Piece {
    map: Map,
    place: Part,
    order: Order,
    /// How many bisections above it had no effect.
    stalls: u8,
    found: Sample,
}

impl Piece {
    fn hopeless(&self) -> bool {
        let patience = if self.found.quadrature <= 1e-8 * self.found.size { MOST_STALLS_IN_NOISE } else { MOST_STALLS };
        self.place.level >= DEEPEST || self.stalls >= patience || self.found.quadrature <= 0.1 * self.found.noise
    }
}

impl PartialEq for Piece {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}
impl Eq for Piece {}
impl PartialOrd for Piece {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Piece {
    fn cmp(&self, other: &Self) -> Ordering {
        self.found.quadrature.total_cmp(&other.found.quadrature)
    }
}

/// Running sums that steer the refinement; the answer itself is summed afresh.
#[derive(Clone, Copy, Default)]
struct Totals {
    value: f64,
    quadrature: f64,
    noise: f64,
}

impl Totals {
    fn add(&mut self, found: &Sample) {
        self.value += found.value;
        self.quadrature += found.quadrature;
        self.noise += found.noise;
    }
}

/// The state of one integration.
#[derive(Default)]
pub(super) struct Work {
    open: BinaryHeap<Piece>,
    /// Pieces that refinement does not improve.
    closed: Vec<Piece>,
    /// Bound on the cut tails of singular panels.
    cut: f64,
    evaluations: u64,
    totals: Totals,
}

impl Work {
    /// Notes the cut tails of a panel and the calls that they cost.
    pub(super) fn count(&mut self, cut: f64, evaluations: u64) {
        self.cut += cut;
        self.evaluations += evaluations;
    }

    /// Refuses to begin another panel when the calls are used up.
    pub(super) fn may_start(&self, options: &Options) -> Result<(), NumError> {
        if self.evaluations < options.max_evaluations {
            return Ok(());
        }
        let (value, evaluations) = (self.totals.value, self.evaluations);
        Err(NumError::EvaluationLimit { value, error: f64::INFINITY, evaluations })
    }

    /// The answer if this piece is all there is.
    pub(super) fn alone(&self, piece: &Piece, options: &Options) -> Estimate {
        let noise = piece.found.noise + self.cut;
        let found = Estimate::estimated(piece.found.value, piece.found.quadrature + noise, self.evaluations);
        modest(found, piece.found.quadrature > noise, options)
    }

    pub(super) fn push(&mut self, piece: Piece) {
        self.totals.add(&piece.found);
        self.open.push(piece);
    }

    /// Applies a rule to a place.
    pub(super) fn measure(
        &mut self,
        order: Order,
        map: Map,
        place: Part,
        stalls: u8,
        options: &Options,
        integrand: &mut Integrand<'_>,
    ) -> Result<Piece, NumError> {
        let mut found = sample(order, &map, place, options.charge_x, integrand)?;
        self.evaluations += order.points();
        if found.size == 0.0 && place.level < BLANK_LEVEL {
            found.quadrature = f64::INFINITY;
        }
        Ok(Piece { map, place, order, stalls, found })
    }

    /// Refines until the tolerance is met or nothing helps any more.
    pub(super) fn refine(mut self, order: Order, options: &Options, integrand: &mut Integrand<'_>) -> Result<Estimate, NumError> {
        loop {
            work::check()?;
            if !self.totals.value.is_finite() {
                return Err(NumError::OutOfDomain { what: "sum of the panels' integrals", got: self.totals.value, accepted: "finite" });
            }
            let noise = self.totals.noise + self.cut;
            let requested = options.target(self.totals.value);
            if self.totals.quadrature + noise <= requested {
                let answer = self.answer();
                if answer.error <= options.target(answer.value) {
                    return Ok(modest(answer, self.totals.quadrature > noise, options));
                }
                self.resum();
            }
            let only_noise = self.totals.quadrature <= noise && noise > 0.99 * requested;
            let worst = if only_noise { None } else { self.open.pop() };
            let Some(worst) = worst else {
                let Estimate { value, error, evaluations, .. } = self.answer();
                return Err(NumError::ToleranceNotReached { value, error, requested, evaluations });
            };
            if worst.hopeless() {
                self.closed.push(worst);
                continue;
            }
            if self.evaluations + 2 * order.points().max(Order::Points31.points()) > options.max_evaluations {
                self.open.push(worst);
                let Estimate { value, error, evaluations, .. } = self.answer();
                return Err(NumError::EvaluationLimit { value, error, evaluations });
            }
            self.improve(worst, order, requested, options, integrand)?;
        }
    }

    /// Replaces a piece by a higher rule where that is predicted to suffice, else by its halves.
    fn improve(
        &mut self,
        worst: Piece,
        order: Order,
        requested: f64,
        options: &Options,
        integrand: &mut Integrand<'_>,
    ) -> Result<(), NumError> {
        let Piece { map, place, stalls, found: before, .. } = worst;
        let steps = worst.order.steps_to_the_largest();
        let predicted = before.quadrature * before.rate.powi(steps);
        let mut after = Totals::default();
        if steps > 0 && options.rule == Rule::Cheapest && 4.0 * predicted <= requested {
            // A failed prediction counts as a stall through the order: next time it is bisected.
            let piece = self.measure(Order::Points31, map, place, stalls, options, integrand)?;
            after.add(&piece.found);
            self.open.push(piece);
        } else {
            let mut halves = [None, None];
            for (half, slot) in halves.iter_mut().enumerate() {
                let place = Part { index: 2 * place.index + half as u64, level: place.level + 1 };
                let piece = self.measure(order, map, place, stalls, options, integrand)?;
                after.add(&piece.found);
                *slot = Some(piece);
            }
            // Noise spreads over both halves; an error that gathers in one is being located.
            let smaller = halves.iter().flatten().map(|half| half.found.quadrature).fold(f64::INFINITY, f64::min);
            let spread = smaller > 0.1 * after.quadrature;
            let stalled = u8::from(spread && after.quadrature > 0.8 * before.quadrature);
            for mut piece in halves.into_iter().flatten() {
                piece.stalls = stalls.saturating_add(stalled);
                self.open.push(piece);
            }
        }
        if before.quadrature < 0.5 * self.totals.quadrature {
            self.totals.value += after.value - before.value;
            self.totals.quadrature += after.quadrature - before.quadrature;
            self.totals.noise += after.noise - before.noise;
        } else {
            // Taking a dominant error out of a running sum would leave its rounding behind.
            self.resum();
        }
        Ok(())
    }

    fn resum(&mut self) {
        let mut totals = Totals::default();
        for piece in self.open.iter().chain(&self.closed) {
            totals.add(&piece.found);
        }
        self.totals = totals;
    }

    /// The compensated sum of all pieces.
    fn answer(&self) -> Estimate {
        let pieces = self.open.iter().chain(&self.closed);
        let terms = pieces.map(|piece| Bounded { value: piece.found.value, error: piece.found.quadrature + piece.found.noise });
        let sum = Bounded::sum(terms.chain([Bounded { value: 0.0, error: self.cut }]));
        Estimate::estimated(sum.value, sum.error, self.evaluations)
    }
}

/// Where the rules still leave out more than rounding noise, no more than the tolerance is promised: what a slow part hides
/// under a fast one is looked for down to there only.
fn modest(found: Estimate, left_out: bool, options: &Options) -> Estimate {
    let least = if left_out { 0.9 * options.target(found.value) } else { 0.0 };
    Estimate { error: found.error.max(least), ..found }
}
