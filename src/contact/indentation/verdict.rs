//! Checks whether a state is the unique solution of Signorini's problem: p ≥ 0 inside, no overlap outside, and d ≥ g(a).

use super::landscape::{STEEP, affordable, rounded};
use super::proof::Sign;
use super::{Boundary, Indentation, Indented, Naming, State};
use crate::num::stable::leg;
use crate::num::{Estimate, work};
use crate::transform::{Quantities, Reading};
use std::cell::{Cell, OnceCell};

/// The severity of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// A warning; the state is valid.
    Warning,
    /// The state is not the solution of the contact problem.
    Error,
}

impl Severity {
    /// The word for reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

/// An error or a warning about a state.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// A short name: `outside_gap`, `tension_inside`, `edge_gap`, `unreachable`, `steep_slope`, `kink`, `not_computable`.
    pub rule: &'static str,
    /// The severity.
    pub severity: Severity,
    /// The message.
    pub message: String,
    /// The first offending radius.
    pub at: Option<f64>,
}

/// Results of earlier states.
pub(super) struct Known {
    /// Contacts with a smooth edge up to these radii have no overlap outside: proven, and checked, with the number of radii.
    proven_to: Cell<f64>,
    valid_to: Cell<(f64, u64)>,
    /// From this contact radius on, there is an overlap outside.
    invalid_from: Cell<Option<f64>>,
    /// Contact radii with their forces, for profiles whose g decreases somewhere.
    pub(super) forces: OnceCell<Vec<(f64, f64)>>,
    /// The smallest depth of a complete contact, the radius where its pressure vanishes first, and the number of radii checked.
    complete: OnceCell<(f64, f64, u32)>,
    /// From this depth on, the pressure of a complete contact is proven to be nowhere negative.
    complete_from: Cell<f64>,
}

impl Default for Known {
    fn default() -> Self {
        Self {
            proven_to: Cell::new(0.0),
            valid_to: Cell::new((0.0, 0)),
            invalid_from: Cell::new(None),
            forces: OnceCell::new(),
            complete: OnceCell::new(),
            complete_from: Cell::new(f64::INFINITY),
        }
    }
}

impl Known {
    /// Whether a larger contact is known to have no overlap outside: `Some(None)` if proven, else with the number of radii.
    fn vouched_for(&self, a: f64) -> Option<Option<u64>> {
        if a <= self.proven_to.get() {
            return Some(None);
        }
        let (to, radii) = self.valid_to.get();
        (a <= to).then_some(Some(radii))
    }

    fn vouch(&self, a: f64, radii: Option<u64>) {
        match radii {
            None => self.proven_to.set(a.max(self.proven_to.get())),
            Some(radii) if a > self.valid_to.get().0 => self.valid_to.set((a, radii)),
            Some(_) => {}
        }
    }
}

/// The findings about one state so far.
#[derive(Default)]
struct Inspection {
    findings: Vec<Finding>,
    radii: Option<u64>,
}

impl Inspection {
    /// Records that the verdict is based on values at this many radii.
    fn looked_at(&mut self, radii: u64) {
        self.counts(Some(radii));
    }

    fn counts(&mut self, radii: Option<u64>) {
        self.radii = match (self.radii, radii) {
            (Some(known), Some(more)) => Some(known.saturating_add(more)),
            (known, more) => known.or(more),
        };
    }

    fn finds_overlap(&mut self, message: String, at: Option<f64>) {
        self.findings.push(Finding { rule: "outside_gap", severity: Severity::Error, message, at });
    }

    fn finds_tension(&mut self, at: f64, naming: &Naming) {
        let message = format!("the pressure is negative at r = {}: the contact would open there", naming.length(at));
        self.findings.push(Finding { rule: "tension_inside", severity: Severity::Error, message, at: Some(at) });
    }
}

/// Maximum number of radii at which a pressure or a gap is evaluated before its minima are refined.
const LOOKS: u32 = 96;
/// Radii at which the pressure must be missing to be called unknown.
const FEW: usize = 4;
/// Fraction of the radius at which the cost of a value is measured.
const TYPICAL: f64 = 0.37;
/// Relative accuracy of the radius of a change of sign; closer values are more expensive.
const PLACED: f64 = 1e-9;
/// Steps of the golden section.
const REFINEMENTS: u32 = 48;
/// Tolerance for a negative pressure or gap, relative to the mean pressure or the depth.
const NOISE: f64 = 1e-11;

impl Indentation<'_> {
    /// The state with all findings about it.
    pub(super) fn judged(&self, state: State) -> Indented {
        let mut verdict = Inspection::default();
        match state.boundary {
            Boundary::Apart => {}
            // Nothing beyond the reach has been examined.
            _ if state.radius.next_down() > self.landscape.reach => verdict.looked_at(0),
            _ if self.landscape.risen >= self.landscape.reach => {}
            _ if self.landscape.rising => verdict.looked_at(self.landscape.looked),
            Boundary::Rim => self.tension_of_complete_contact(&state, &mut verdict),
            // One finding suffices for the verdict, and overlaps are found sooner.
            Boundary::Smooth if !self.is_detailed => {
                self.overlap_outside(&state, &mut verdict);
                if verdict.findings.is_empty() {
                    self.tension_inside(&state, &mut verdict);
                }
            }
            Boundary::Smooth => {
                self.tension_inside(&state, &mut verdict);
                self.overlap_outside(&state, &mut verdict);
            }
        }
        let mut findings = verdict.findings;
        findings.extend(self.steep_slope(&state));
        Indented { state: Some(state), findings, radii: verdict.radii }
    }

    /// p ≥ 0 for all r < c, which is a lower limit of the depth: p increases with d in proportion to 1/√(c² − r²).
    fn tension_of_complete_contact(&self, state: &State, verdict: &mut Inspection) {
        let Some(rim) = self.at_rim else { return };
        let (least, at, places) = *self.known.complete.get_or_init(|| work::unbroken(|| self.least_depth(rim.radius, rim.equivalent)));
        if state.depth >= least * (1.0 - NOISE * least.signum()) {
            if state.depth >= self.known.complete_from.get() {
                return;
            }
            let sign = |cells| self.pressure_sign(cells, rim.radius, state.depth - rim.equivalent, NOISE * state.depth.abs());
            match self.landscape.cells.as_ref().map_or(Sign::Open(0), sign) {
                Sign::Proven => self.known.complete_from.set(state.depth),
                Sign::Open(looks) => verdict.looked_at(looks + u64::from(places)),
                Sign::Negative(at) | Sign::NegativeAt(at) => verdict.finds_tension(rounded(at, 8), &self.naming),
            }
            return;
        }
        let message = if least.is_infinite() {
            "a complete contact is impossible: the pressure at the axis is negative at every depth".to_owned()
        } else {
            let (least, at) = (self.naming.length(least), self.naming.length(at));
            format!("a complete contact needs d >= {least} (the pressure vanishes first at r = {at}); below it is in tension there")
        };
        verdict.findings.push(Finding { rule: "tension_inside", severity: Severity::Error, message, at: Some(at) });
    }

    /// The maximum over r < c of g(c) − √(c² − r²) π p_smooth/E*, its radius, and the number of radii checked.
    fn least_depth(&self, c: f64, at_rim: f64) -> (f64, f64, u32) {
        let shape = self.contact.evaluator();
        if self.pull_on_axis(c) == Some(true) {
            return (f64::INFINITY, 0.0, 0);
        }
        let needed = |r: f64| match shape.pressure(r, c) {
            Ok(Some(p)) => p.estimate.value * leg(c, r) - at_rim,
            // The pressure is −∞ at a concave kink and +∞ at a convex one.
            Ok(None) => f64::INFINITY,
            Err(_) => f64::NAN,
        };
        if let Some(kink) = self.landscape.kinks.iter().find(|kink| kink.jump < 0.0 && kink.at < c) {
            return (f64::INFINITY, kink.at, 0);
        }
        let count = affordable(LOOKS, || needed(TYPICAL * c));
        let (at, value) = lowest(&needed, &looks_between(0.0, c, count));
        if -value > at_rim { (-value, at, count) } else { (at_rim, c, count) }
    }

    /// Returns `None` if the pressure of a smooth contact of this radius is not negative on the axis, else whether it is −∞.
    fn pull_on_axis(&self, a: f64) -> Option<bool> {
        let pulls = |r: f64| {
            let p = self.contact.evaluator().pressure(r, a).ok()?;
            Some(p.map(|p| p.estimate.value + p.estimate.error < 0.0))
        };
        if self.landscape.flat > 0.0 || pulls(1e-9 * a) != Some(Some(true)) {
            return None;
        }
        match pulls(0.0)? {
            None => Some(true),
            Some(negative) => negative.then_some(false),
        }
    }

    /// p ≥ 0 inside a contact with a smooth edge.
    fn tension_inside(&self, state: &State, verdict: &mut Inspection) {
        let a = state.radius;
        if let Some(kink) = self.landscape.kinks.iter().find(|kink| kink.jump < 0.0 && kink.at < a) {
            let message = format!("the profile bends away at r = {}: the pressure there is minus infinity", self.naming.length(kink.at));
            verdict.findings.push(Finding { rule: "tension_inside", severity: Severity::Error, message, at: Some(kink.at) });
            return;
        }
        if a <= self.landscape.risen {
            return;
        }
        if let Some(infinite) = self.pull_on_axis(a) {
            if infinite {
                let message = "the profile has a concave apex: the pressure at r = 0 is minus infinity".to_owned();
                verdict.findings.push(Finding { rule: "tension_inside", severity: Severity::Error, message, at: Some(0.0) });
            } else {
                verdict.finds_tension(0.0, &self.naming);
            }
            return;
        }
        let mean = (state.force / (a * a * self.contact.effective_modulus())).abs();
        let sign = match &self.landscape.cells {
            Some(cells) => self.pressure_sign(cells, a, 0.0, NOISE * mean),
            None => Sign::Open(0),
        };
        let shape = self.contact.evaluator();
        let pressure = |r: f64| match shape.pressure(r, a) {
            Ok(Some(p)) => surely(p.estimate, NOISE * mean),
            _ => f64::NAN,
        };
        match sign {
            Sign::Proven => {}
            Sign::Negative(at) => verdict.finds_tension(at, &self.naming),
            Sign::NegativeAt(at) if !self.is_detailed => verdict.finds_tension(rounded(at, 8), &self.naming),
            Sign::NegativeAt(at) => {
                let count = affordable(LOOKS, || pressure(TYPICAL * a));
                let first = first_negative(&pressure, &looks_between(0.0, at, count), 1e-3 * mean);
                verdict.finds_tension(first.unwrap_or(rounded(at, 8)), &self.naming);
            }
            Sign::Open(looks) => {
                let mut places = looks_between(0.0, a, affordable(LOOKS, || pressure(TYPICAL * a)));
                // The pressure is smallest where g begins to decrease.
                places.extend(self.landscape.falls().filter(|r| *r < a).take(LOOKS as usize));
                places.sort_by(f64::total_cmp);
                places.dedup();
                verdict.looked_at(looks + places.len() as u64);
                if a <= self.landscape.first_fall {
                    return;
                }
                // A pressure that is missing everywhere is slow to ask for, so a few radii decide.
                let mut few = places.iter().step_by(places.len().div_ceil(FEW).max(1)).copied();
                if few.all(|r| pressure(r).is_nan()) && pressure(TYPICAL * a).is_nan() {
                    let message = "the pressure has no reliable digit inside the contact, so tension there is not excluded".to_owned();
                    verdict.findings.push(Finding { rule: "pressure_unknown", severity: Severity::Error, message, at: None });
                } else if let Some(at) = first_negative(&pressure, &places, 1e-3 * mean) {
                    verdict.finds_tension(at, &self.naming);
                }
            }
        }
    }

    /// f − d + u ≥ 0 for every r > a within the profile.
    ///
    /// The gap is (2/π)∫_a^r (g − d)/√(r² − x²) dx. If g increases up to a, a contact without overlap implies the same for all
    /// smaller contacts.
    fn overlap_outside(&self, state: &State, verdict: &mut Inspection) {
        let a = state.radius;
        let ordered = a < self.landscape.first_fall;
        let known = &self.known;
        if ordered && let Some(radii) = known.vouched_for(a) {
            verdict.counts(radii);
            return;
        }
        if ordered
            && !self.is_detailed
            && let Some(from) = known.invalid_from.get().filter(|from| *from <= a)
        {
            verdict.finds_overlap(format!("every contact from a = {} on overlaps outside", self.naming.length(from)), None);
            return;
        }
        if ordered && known.invalid_from.get().is_none_or(|from| a < from) {
            // Check a larger contact first, whose result applies to later loads.
            let end = known.invalid_from.get().unwrap_or(self.landscape.first_fall).min(self.landscape.reach);
            let ahead = a + 0.5 * (end - a);
            if ahead > a && ahead < self.landscape.first_fall {
                let found = self.first_overlap(ahead);
                // Do not store an incomplete result.
                if work::is_exhausted() {
                    return;
                }
                match found {
                    // There may be a proof for this load even without a proof for the larger contact.
                    (None, radii) if radii.is_none() || !self.is_detailed => {
                        known.vouch(ahead, radii);
                        verdict.counts(radii);
                        return;
                    }
                    (None, _) => {}
                    (Some(_), _) => known.invalid_from.set(Some(ahead)),
                }
            }
        }
        let (overlap, radii) = self.first_overlap(a);
        if ordered && !work::is_exhausted() {
            match overlap {
                None => known.vouch(a, radii),
                Some(_) => known.invalid_from.set(Some(known.invalid_from.get().map_or(a, |from| from.min(a)))),
            }
        }
        verdict.counts(radii);
        let Some(at) = overlap else { return };
        let place = self.naming.length(at);
        verdict
            .finds_overlap(format!("the deformed surface reaches the indenter again at r = {place}: the contact is not a disc"), Some(at));
    }

    /// The first radius beyond a at which the bodies overlap, and the number of radii checked without a proof.
    fn first_overlap(&self, a: f64) -> (Option<f64>, Option<u64>) {
        let (contact, reach) = (&self.contact, self.landscape.reach);
        let Ok(Reading { estimate: Estimate { value: depth, .. }, .. }) = contact.evaluator().equivalent(a) else { return (None, Some(0)) };
        if a >= self.landscape.first_fall
            && let Ok(beyond) = contact.evaluator().equivalent((a * (1.0 + 1e-6)).min(reach))
            && beyond.estimate.value + beyond.estimate.error < depth
        {
            return (Some(a), None);
        }
        let gap = |r: f64| match (contact.evaluator().height(r), contact.evaluator().displacement(r, a)) {
            (Ok(f), Ok(u)) => {
                let value = f.estimate.value - depth + u.estimate.value;
                surely(
                    Estimate {
                        error: f.estimate.error + u.estimate.error,
                        bound: f.estimate.bound.and(u.estimate.bound),
                        ..Estimate::exact(value)
                    },
                    NOISE * depth.abs(),
                )
            }
            _ => f64::NAN,
        };
        let looks = match self.landscape.cells.as_ref().map(|cells| self.gap_sign(cells, a, depth, NOISE * depth.abs())) {
            Some(Sign::Proven) => return (None, None),
            Some(Sign::Negative(at)) => return (Some(at), None),
            Some(Sign::NegativeAt(at)) if !self.is_detailed => return (Some(rounded(at, 8)), None),
            Some(Sign::NegativeAt(at)) => {
                let count = affordable(LOOKS, || gap(at));
                let first = first_negative(&gap, &looks_between(a, at, count), f64::INFINITY);
                return (Some(first.unwrap_or(rounded(at, 8))), None);
            }
            Some(Sign::Open(looks)) => looks,
            None => 0,
        };
        let near = (8.0 * a).min(reach);
        let count = affordable(LOOKS, || gap(0.5 * (a + near)));
        let mut places: Vec<f64> = looks_between(a, near, count);
        let mut far = 8.0 * a;
        while far < reach {
            places.push(far);
            far *= 1.2f64.powf(f64::from(LOOKS) / f64::from(count));
        }
        places.push(reach);
        places.extend(self.landscape.troughs.iter().copied().filter(|r| *r > a && *r < reach));
        places.sort_by(f64::total_cmp);
        places.dedup();
        (first_negative(&gap, &places, f64::INFINITY), Some(looks + places.len() as u64))
    }

    /// A warning if the slope of the profile inside the contact is too large for a half-space.
    fn steep_slope(&self, state: &State) -> Option<Finding> {
        let (what, at) = self.steep.filter(|(_, at)| *at < state.radius)?;
        let message = format!(
            "{what}'s slope exceeds {STEEP} from r = {} on: a half-space is a poor model of the surface there",
            self.naming.length(at)
        );
        Some(Finding { rule: "steep_slope", severity: Severity::Warning, message, at: Some(at) })
    }
}

/// The value if its sign is certain, else 0.
fn surely(estimate: Estimate, noise: f64) -> f64 {
    if estimate.value.abs() <= estimate.error.max(noise) { 0.0 } else { estimate.value }
}

/// Radii between two ends, denser towards both.
fn looks_between(lower: f64, upper: f64, count: u32) -> Vec<f64> {
    (1..count)
        .map(|step| {
            let angle = std::f64::consts::PI * f64::from(step) / f64::from(count);
            lower + (upper - lower) * 0.5 * (1.0 - angle.cos())
        })
        .collect()
}

/// The first change of sign to negative values, or the minimum of a dip below 0.
fn first_negative(function: &impl Fn(f64) -> f64, places: &[f64], shallow: f64) -> Option<f64> {
    let mut seen: Vec<(f64, f64)> = Vec::new();
    for place in places {
        let value = function(*place);
        if value.is_nan() {
            continue;
        }
        let (mut at, mut low) = (*place, value);
        // A dip between samples: three values of which the middle one is the smallest.
        if value >= 0.0
            && let [.., (first, before), (middle, bottom)] = seen.as_slice()
            && *bottom <= *before
            && *bottom <= value
            && *bottom > 0.0
            && *bottom < shallow
        {
            let (dip, under) = golden(function, *first, *middle, *place);
            if under < 0.0 {
                (at, low) = (dip, under);
            }
        }
        if low < 0.0 {
            let before = seen.iter().rev().find(|(r, value)| *value > 0.0 && *r < at).map(|(r, _)| *r);
            return Some(before.map_or(at, |from| sign_change(function, from, at)));
        }
        seen.push((*place, value));
    }
    None
}

/// The point between `from` and `to` at which a function that is nonnegative at `from` becomes negative, to within [`PLACED`].
fn sign_change(function: &impl Fn(f64) -> f64, mut from: f64, mut to: f64) -> f64 {
    let near = PLACED * to;
    while to - from > near {
        let middle = 0.5 * (from + to);
        if middle <= from || middle >= to {
            break;
        }
        if function(middle) < 0.0 { to = middle } else { from = middle }
    }
    rounded(to, 8)
}

/// The refined position of the smallest value.
fn lowest(function: &impl Fn(f64) -> f64, places: &[f64]) -> (f64, f64) {
    let mut all: Vec<(f64, f64)> = vec![(0.0, function(0.0))];
    all.extend(places.iter().map(|r| (*r, function(*r))));
    all.retain(|(_, value)| !value.is_nan());
    let mut best = all.iter().copied().min_by(|one, other| one.1.total_cmp(&other.1)).unwrap_or((0.0, 0.0));
    for three in all.windows(3) {
        if let [(first, before), (middle, bottom), (last, beyond)] = three
            && bottom <= before
            && bottom <= beyond
        {
            let dip = golden(function, *first, *middle, *last);
            if dip.1 < best.1 {
                best = dip;
            }
        }
    }
    best
}

/// Golden-section search for a minimum between two points, given a lower point between them.
fn golden(function: &impl Fn(f64) -> f64, mut lower: f64, mut middle: f64, mut upper: f64) -> (f64, f64) {
    const SHARE: f64 = 0.381_966_011_250_105_1;
    let mut bottom = function(middle);
    for _ in 0..REFINEMENTS {
        let wide = upper - middle > middle - lower;
        let next = if wide { middle + SHARE * (upper - middle) } else { middle - SHARE * (middle - lower) };
        let value = function(next);
        if value < bottom {
            if wide {
                lower = middle
            } else {
                upper = middle
            }
            (middle, bottom) = (next, value);
        } else if wide {
            upper = next;
        } else {
            lower = next;
        }
        if upper - lower <= 1e-9 * middle {
            break;
        }
    }
    (middle, bottom)
}
