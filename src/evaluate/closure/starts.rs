//! A function next to the axis: Chebyshev fits that begin at r = 0, where those between powers of two see the rounding of its
//! values only.

use super::cells::{Cell, LAST, exponent_of, hidden_f_prime, kept, place_of, places};
use crate::num::{Bounded, work};
use std::sync::OnceLock;

/// Exponents of two beyond that of r that are tried before one serves, and after one has served without a better one.
const TRIED: [i32; 2] = [18, 3];
/// Halved with the fit, the last coefficients fall by this factor at least unless they are noise.
const FALLING: f64 = 0.6;
/// Noise above this share of what f changes by hides f.
const LOUD: f64 = 1e-6;
/// As many powers of two below its end a fit is compared with narrow ones.
const DEPTH: i32 = 50;
/// Minimum radius of narrow fits; below it φ may be subnormal.
const FAINTEST: f64 = 1e-285;
/// A narrow fit whose last coefficients are larger than this share of what φ changes by does not see φ, …
const BLIND: f64 = 1e-3;
/// … of which rounding may hide this share.
const HIDDEN: f64 = 5e-8;
/// Maximum ratio of what rounding hides to the rounding error of the narrow fits next to it, once one of these resolves φ.
const TRACES: f64 = 1e4;
/// Maximum ratio of rounding errors to the coefficients that show them.
const AMPLITUDE: f64 = 16.0;
/// Number of narrow fits that count as next to another.
const RECENT: usize = 4;
/// Maximum ratio of rounding errors between one narrow fit and those next to it; a larger one is a kink.
const GROWTH: f64 = 1e4;
/// Widths of the narrower fits that distinguish rounding from waves, as fractions of an octave.
const CLOSE_UPS: [f64; 3] = [1e-1, 1e-2, 1e-3];
/// Minimum ratio of the change of φ within a narrower fit to the supposed rounding error, so that the fit shows the true one.
const SEVERAL: f64 = 10.0;
/// Beyond this share of its fit a radius is left to the fits between powers of two.
const REACH: f64 = 0.75;

/// The results of narrow fits to φ.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Seen {
    Slopes,
    /// The rounding errors of φ, which are larger than its variation.
    Rounding,
    /// The terms of φ that remain where another term rounds to a constant; see [`Starts::continues`].
    Remains,
}

type Choice = Option<(i32, Seen)>;

/// The fits of one function to 0 ≤ r ≤ 2^k, computed when needed.
pub(super) struct Starts {
    upper: f64,
    fits: Box<[OnceLock<Box<Fit>>]>,
    /// Fits between one power of two and the next, with which the others must agree.
    octaves: Box<[OnceLock<Box<Octave>>]>,
    /// Which fit serves radii between one power of two and the next, and what narrower fits see there.
    chosen: Box<[OnceLock<Choice>]>,
    /// The values of [`Starts::mismatch`] by powers of two.
    mismatches: Box<[OnceLock<f64>]>,
    /// The fit that serves radii at which nothing is seen of φ.
    first: OnceLock<i32>,
}

/// A fit between one power of two and the next.
struct Octave {
    cell: Cell,
    /// The apparent rounding error of φ.
    rounding: f64,
    /// True if φ has waves, poles or kinks here that the fit does not resolve.
    has_features: bool,
}

struct Fit {
    cell: Cell,
    /// The size of the last coefficients, and the error of φ beyond the stated one that they show.
    level: f64,
    noise: f64,
    /// The change of f.
    spread: f64,
    /// True if it agrees with narrow fits below.
    stands: OnceLock<bool>,
    /// True if f′(0) is 0 within its error, and taken to be 0.
    flat: bool,
}

impl Starts {
    /// For a segment that begins at the axis; nothing is fitted yet.
    pub(super) fn new(upper: f64) -> Self {
        Self { upper, fits: places(), octaves: places(), chosen: places(), mismatches: places(), first: OnceLock::new() }
    }

    /// Returns the derivative of φ of order 1 or 2 at r with a bound on its error, and what narrower fits see there; `None` if φ
    /// is not smooth from the axis to beyond r.
    pub(super) fn derivative(&self, order: usize, r: f64, phi: &impl Fn(f64) -> Bounded) -> Option<(Bounded, Seen)> {
        let (fit, seen) = self.at(r, phi)?;
        Some((fit.derivative(order, r), seen))
    }

    /// Returns a bound on the slope at r of steps of φ that were taken for noise.
    pub(super) fn hidden_f_prime(&self, r: f64, phi: &impl Fn(f64) -> Bounded) -> f64 {
        let octave = exponent_of(r).and_then(|exponent| self.octave(exponent, phi));
        octave.map_or(0.0, |own| hidden_f_prime(own.cell.noise(), r))
    }

    /// Returns an estimate of the change of g(r) = r ∫ φ′/√(r² − b²) db due to the differences between φ and its fits: rounding
    /// errors, and steps that the fits smooth.
    ///
    /// `serves` returns true for the radii at which the fits from the axis on are used; it must be the same function in every
    /// call.
    pub(super) fn mismatch(&self, r: f64, phi: &impl Fn(f64) -> Bounded, serves: &impl Fn(f64) -> bool) -> f64 {
        let own = exponent_of(r).and_then(|last| kept(self.mismatches.get(place_of(last)?)?, || self.computed_mismatch(last, phi, serves)));
        own.copied().unwrap_or(0.0)
    }

    /// Integration by parts: a difference δ(b) changes g by δ at the axis, by about 4δ next to r, and by about 4δ(b/r)² in
    /// between.
    fn computed_mismatch(&self, last: i32, phi: &impl Fn(f64) -> Bounded, serves: &impl Fn(f64) -> bool) -> f64 {
        let mut most = 0.0_f64;
        let mut before = f64::NAN;
        for exponent in (last - DEPTH..=last).rev() {
            let from = libm::scalbn(1.0, exponent);
            let Some((fit, _)) = self.at(from, phi).filter(|_| serves(from)) else { continue };
            // The same fit serves many octaves.
            if std::mem::replace(&mut before, fit.cell.end()) == fit.cell.end() {
                continue;
            }
            let difference = |below: i32| {
                let from = libm::scalbn(1.0, below);
                let octave = self.octave(below, phi).filter(|_| from >= FAINTEST)?;
                let at = |share: f64| {
                    let r = (1.0 + share) * from;
                    (octave.cell.derivative_within(0, r, 0.0).value - fit.cell.derivative_within(0, r, 0.0).value).abs()
                };
                let within = |share: &f64| (1.0 + share) * from <= fit.cell.end();
                let places = [0.1, 0.35, 0.6, 0.85].into_iter().filter(within);
                Some(places.map(at).fold(0.0, |most, own| if own > most { own } else { most }))
            };
            let lowest = last - DEPTH;
            let weighed = |below: i32| Some(4.0 * libm::scalbn(1.0, 2 * (below - last)) * difference(below)?);
            let total = difference(lowest).unwrap_or(0.0) + (lowest..=exponent).filter_map(weighed).sum::<f64>();
            most = most.max(total);
        }
        most
    }

    fn octave(&self, exponent: i32, phi: &impl Fn(f64) -> Bounded) -> Option<&Octave> {
        let from = libm::scalbn(1.0, exponent);
        let own = kept(self.octaves.get(place_of(exponent)?)?, || Octave::boxed(from, (2.0 * from).min(self.upper), phi));
        own.map(AsRef::as_ref)
    }

    /// Returns true if φ is smooth from the axis to beyond r; the fit that shows it then serves smaller radii at which no other
    /// fit does.
    pub(super) fn begin(&self, r: f64, phi: &impl Fn(f64) -> Bounded) -> bool {
        let found = exponent_of(r).and_then(|exponent| self.choose(exponent, phi));
        found.is_some_and(|(k, _)| *self.first.get_or_init(|| k) == k)
    }

    fn at(&self, r: f64, phi: &impl Fn(f64) -> Bounded) -> Option<(&Fit, Seen)> {
        let exponent = exponent_of(r)?;
        let own = kept(self.chosen.get(place_of(exponent)?)?, || self.choose(exponent, phi))?;
        let (k, seen) = own.or_else(|| Some((*self.first.get()?, Seen::Slopes)))?;
        let fit = self.served(k, phi).filter(|fit| r < REACH * fit.cell.end())?;
        // Rounding errors in proportion to φ, as of r^8 times what cancels, are below what the fit resolves.
        let is_hidden = |own: &Octave| own.shows_rounding() && own.rounding > r * fit.derivative(1, r).error;
        let seen = if seen == Seen::Slopes && self.octave(exponent, phi).is_some_and(is_hidden) { Seen::Rounding } else { seen };
        Some((fit, seen))
    }

    /// Returns the exponent of the fit with the smallest error for radii from 2^exponent on.
    fn choose(&self, exponent: i32, phi: &impl Fn(f64) -> Bounded) -> Choice {
        let r = libm::scalbn(1.0, exponent);
        let (mut best, mut idle) = (None, 0);
        for k in exponent + 2..=1023 {
            if libm::scalbn(0.5, k) >= self.upper || work::is_exhausted() {
                break;
            }
            match self.served(k, phi).map(|fit| fit.derivative(1, r).error) {
                Some(error) if best.is_none_or(|(_, least)| error < least) => (best, idle) = (Some((k, error)), 0),
                // As long as nothing is seen of f, larger fits may see it.
                None if best.is_none() && self.hides(k, phi) => {}
                _ => idle += 1,
            }
            if idle >= TRIED[usize::from(best.is_some())] {
                break;
            }
        }
        let (best, _) = best?;
        match self.first.get() {
            Some(first) if *first >= best && self.continues(*first, exponent, phi) => Some((*first, Seen::Remains)),
            _ => Some((best, Seen::Slopes)),
        }
    }

    /// Returns true if the narrow fit at 2^exponent resolves only a remainder of φ.
    ///
    /// Where a term of φ rounds to a constant, the other terms remain: exp(r) - 1 - r evaluates to -r for r < 1e-16. The slope of
    /// the narrow fit then differs from that of fit k, while fit k agrees with the narrow fits at all larger radii.
    fn continues(&self, k: i32, exponent: i32, phi: &impl Fn(f64) -> Bounded) -> bool {
        let (Some(wide), Some(narrow)) = (self.fit(k, phi), self.octave(exponent, phi)) else { return false };
        let r = narrow.cell.middle();
        let (f_prime, other) = (wide.derivative(1, r), narrow.cell.derivative_within(1, r, 0.0));
        let differ = (f_prime.value - other.value).abs() > f_prime.error + other.error;
        narrow.cell.is_resolved() && differ && self.agrees(wide, k, k - exponent, phi)
    }

    fn fit(&self, k: i32, phi: &impl Fn(f64) -> Bounded) -> Option<&Fit> {
        Some(kept(self.fits.get(place_of(k)?)?, || Fit::boxed(libm::scalbn(1.0, k).min(self.upper), phi))?.as_ref())
    }

    /// Returns true if φ is rounding noise according to this fit and to the narrow fits below it.
    fn hides(&self, k: i32, phi: &impl Fn(f64) -> Bounded) -> bool {
        self.fit(k, phi).is_some_and(|own| is_blind(&own.cell) && self.stands(own, k, phi))
    }

    /// Returns the fit if it has resolved φ, to rounding or to noise.
    fn served(&self, k: i32, phi: &impl Fn(f64) -> Bounded) -> Option<&Fit> {
        let own = self.fit(k, phi).filter(|own| !is_blind(&own.cell))?;
        let loud = !own.level.is_finite() || own.level > LOUD * own.spread;
        let still = || self.fit(k - 1, phi).is_some_and(|half| half.level > FALLING * own.level);
        let serves = own.cell.is_resolved() || (!loud && still());
        (serves && self.stands(own, k, phi)).then_some(own)
    }

    /// Returns true if a fit agrees with narrow ones at radii far below its end: what it does not see there is noise, and no
    /// feature.
    fn stands(&self, own: &Fit, k: i32, phi: &impl Fn(f64) -> Bounded) -> bool {
        kept(&own.stands, || self.agrees(own, k, DEPTH, phi)).copied().unwrap_or(false)
    }

    /// Returns true if a fit agrees with narrow ones down to 2^(k - depth).
    fn agrees(&self, own: &Fit, k: i32, depth: i32, phi: &impl Fn(f64) -> Bounded) -> bool {
        // Rounding errors of the last narrow fits that resolve φ, and the largest of these and of the fits below.
        let (mut recent, mut traces, mut was_blind) = ([f64::INFINITY; RECENT], f64::INFINITY, false);
        (1..=depth).all(|below| {
            let Some(place) = place_of(k - below).and_then(|place| self.octaves.get(place)) else { return true };
            let (from, to) = (libm::scalbn(1.0, k - below), libm::scalbn(2.0, k - below));
            if to > own.cell.end() || from < FAINTEST {
                return true;
            }
            let Some(found) = kept(place, || Octave::boxed(from, to, phi)) else { return false };
            let Octave { cell: octave, rounding, has_features } = found.as_ref();
            if *has_features {
                return false;
            }
            let level = octave.last(LAST);
            let places = [0.1, 0.35, 0.6, 0.85].map(|share| from + share * (to - from));
            // Below its rounding further out φ may look smooth again, as 1 - sin(r)/r does where sin(r)/r rounds to 1, or exp(r)
            // - 1 - r, which is -r where exp(r) rounds to 1.
            let blind = is_blind(octave) || (was_blind && octave.spread() <= AMPLITUDE * traces);
            was_blind = blind;
            // Rounding errors do not grow this much from one octave to the next.
            if octave.rounding(LAST) > GROWTH * traces {
                return false;
            }
            if blind {
                traces = traces.max(*rounding);
            } else {
                recent.rotate_right(1);
                recent[0] = *rounding;
                traces = recent.into_iter().filter(|own| own.is_finite()).fold(0.0, f64::max);
            }
            // A narrow fit that finds only noise is inconclusive; other narrow fits measure slopes.
            let (order, hidden) = if blind { (0, (HIDDEN * own.spread).min(TRACES * traces)) } else { (1, 0.0) };
            places.into_iter().all(|r| {
                let (narrow, wide) = (octave.derivative_within(order, r, 10.0 * level), own.derivative(order, r));
                (narrow.value - wide.value).abs() <= hidden + narrow.error + wide.error
            })
        })
    }
}

/// Returns true if φ is only noise.
fn is_blind(cell: &Cell) -> bool {
    cell.last(LAST) >= BLIND * cell.spread()
}

/// Returns true if narrow fits resolve φ and find slopes that go up and down, as at waves and poles.
///
/// Rounding errors are either noise, which no fit resolves, or steps between which the slope varies monotonically.
fn has_features(from: f64, to: f64, phi: &impl Fn(f64) -> Bounded) -> bool {
    /// Where the narrow fits begin, and their width, as shares of the octave.
    const BEGINS: [f64; 6] = [0.07, 0.23, 0.41, 0.58, 0.77, 0.93];
    const WIDTH: f64 = 1e-3;
    /// Ratio of slopes below which their order is inconclusive.
    const ALIKE: f64 = 2.0;
    let f_prime = |begin: f64| {
        let low = from + begin * (to - from);
        let cell = Cell::fit((low, low + WIDTH * (to - from)), to, phi);
        (!is_blind(&cell)).then(|| cell.derivative_within(1, cell.end(), 0.0).value)
    };
    let slopes: Vec<f64> = BEGINS.into_iter().filter_map(f_prime).collect();
    let turns = slopes.iter().any(|own| own * slopes.first().unwrap_or(own) < 0.0);
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    let (mut rises, mut falls) = (false, false);
    for own in slopes.iter().map(|own| own.abs()) {
        rises |= own > ALIKE * least;
        falls |= ALIKE * own < most;
        (least, most) = (least.min(own), most.max(own));
    }
    turns || (rises && falls)
}

impl Octave {
    /// Returns true if what the fit does not resolve are rounding errors, and no kink or wave.
    fn shows_rounding(&self) -> bool {
        is_blind(&self.cell) && !self.has_features && self.rounding > 0.1 * self.cell.rounding(LAST)
    }

    fn boxed(from: f64, to: f64, phi: &impl Fn(f64) -> Bounded) -> Box<Self> {
        let cell = Cell::fit((from, to), to, phi);
        let rounding = cell.rounding(LAST);
        // The last coefficients of a fit that has not resolved φ may be those of a wave or a kink. A much narrower fit has those
        // of noise if φ changes by several times as much within it.
        let near = || {
            let fits = CLOSE_UPS.into_iter().map(|share| Cell::fit((from, from + share * (to - from)), to, phi));
            fits.filter(|own| own.spread() > SEVERAL * rounding).fold(rounding, |least, own| least.min(own.rounding(LAST)))
        };
        let rounding = if cell.is_resolved() { rounding } else { near() };
        let has_features = is_blind(&cell) && has_features(from, to, phi);
        Box::new(Self { cell, rounding, has_features })
    }
}

impl Fit {
    fn boxed(end: f64, phi: &impl Fn(f64) -> Bounded) -> Box<Self> {
        let cell = Cell::fit((0.0, end), end, phi);
        let (level, spread) = (cell.last(LAST), cell.spread());
        let noise = if cell.is_resolved() { 0.0 } else { 4.0 * level };
        let start = cell.derivative_within(1, 0.0, noise);
        let flat = start.value.abs() <= start.error;
        Box::new(Self { cell, level, noise, spread, stands: OnceLock::new(), flat })
    }

    fn derivative(&self, order: usize, r: f64) -> Bounded {
        let own = self.cell.derivative_within(order, r, self.noise);
        let second = |r: f64| self.cell.derivative_within(2, r, self.noise);
        // f′ is at most as wrong as r times the largest error of f″, which is that at the axis.
        let error = r * second(0.0).error;
        if order != 1 || !self.flat || own.error < error {
            return own;
        }
        // By three nodes of Gauss, so that f′ keeps its relative accuracy as it vanishes.
        let nodes = [(0.112_701_665_379_258_31, 5.0), (0.5, 8.0), (0.887_298_334_620_741_7, 5.0)];
        let mean = nodes.iter().map(|(share, weight)| weight / 18.0 * second(share * r).value).sum::<f64>();
        Bounded { value: r * mean, error: error + 1e-12 * (r * mean).abs() }
    }
}
