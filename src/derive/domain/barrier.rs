//! The radius at which a demand on r fails for given parameters, located or excluded by enclosures.

use crate::derive::closed_form::ClosedForm;
use crate::derive::domain::demand::Demand;
use crate::derive::domain::first_zero::Zero;
use crate::derive::domain::numeric_sign::certain_sign;
use crate::eval::constant_value;
use crate::expr::{Bindings, Expr, Symbol};
use crate::integrate::error::TransformError;
use crate::num::work;
use std::sync::{Mutex, PoisonError};

/// A demand with numbers for its parameters.
pub(crate) struct Barrier {
    form: ClosedForm,
    /// The sign that the expression must keep.
    sign: f64,
    zero: Zero,
    lower: f64,
    upper: f64,
    known: Mutex<Known>,
}

#[derive(Clone, Copy)]
struct Known {
    /// The demand is met from the lower end up to here.
    met: f64,
    /// Where it fails.
    end: Option<f64>,
}

/// Enclosures for one question, beyond which the demand is looked at from place to place only.
const MOST_ENCLOSURES: u32 = 2_000;
/// Places of that look.
const PLACES: u32 = 512;
/// An interval as short as this, relative to its place, is a place.
const SHORTEST: f64 = 4.0 * f64::EPSILON;
/// An interval from the axis on is a place where it is this small a part of the range.
const NEAREST: f64 = 1e-18;
/// Steps of a search within an interval, which subnormal places would not end.
const MOST_HALVINGS: u32 = 1_100;
/// Powers of two at which a sign is looked for.
const OCTAVES: std::ops::Range<i32> = -200..200;

impl Barrier {
    /// # Errors
    /// [`TransformError::Evaluation`] if a parameter has no value.
    pub(crate) fn new(demand: &Demand, bindings: &Bindings) -> Result<Self, TransformError> {
        let number = |expr: &Expr| constant_value(expr, bindings).map(|own| own.value);
        let form = ClosedForm::new(&bindings.apply(&demand.expr), &[Symbol::new("r")])?;
        let lower = number(&demand.lower)?;
        let upper = demand.upper.as_ref().map_or(Ok(f64::INFINITY), number)?;
        let next = if lower > 0.0 { lower * (1.0 + NEAREST.sqrt()) } else { f64::from(OCTAVES.start).exp2() };
        let starts_negative = || [lower, next].into_iter().map(|r| form.value(&[r])).find_map(certain_sign) == Some(-1.0);
        let sign = if demand.either_sign && starts_negative() { -1.0 } else { 1.0 };
        Ok(Self { form, sign, zero: demand.zero, lower, upper, known: Mutex::new(Known { met: lower, end: None }) })
    }

    /// The lower end of its piece.
    pub(crate) fn lower(&self) -> f64 {
        self.lower
    }

    /// Where the demand fails, if it does at some power of two, or before.
    pub(crate) fn first_end(&self) -> Option<f64> {
        let places = OCTAVES.map(|power| f64::from(power).exp2()).filter(|r| self.lower < *r && *r < self.upper);
        let mut failing = None;
        for r in places {
            let value = self.form.value(&[r]);
            if value.value.is_nan() {
                break;
            }
            if certain_sign(value) == Some(-self.sign) {
                failing = Some(r);
                break;
            }
        }
        self.end_up_to(failing?)
    }

    /// Where the demand fails, if that is not beyond `at`.
    pub(crate) fn end_up_to(&self, at: f64) -> Option<f64> {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let to = at.min(self.upper);
        if known.end.is_none() && to > known.met {
            known.end = work::finished(|| self.search(known.met, to));
            known.met = to;
        }
        known.end.filter(|end| *end <= at)
    }

    /// The first place of a range at which the demand fails, from left to right by bisection.
    fn search(&self, from: f64, to: f64) -> Option<f64> {
        let mut open = vec![(from, to)];
        // A divisor that is zero at the lower end, as in sin(r)/r, has no certain sign next to it.
        let mut has_sign = from > self.lower;
        for _ in 0..MOST_ENCLOSURES {
            let (low, high) = open.pop()?;
            match self.form.over(low, high).map(|(one, other)| (self.sign * one, self.sign * other)) {
                Some((one, other)) if one.min(other) > 0.0 || (one.min(other) >= 0.0 && self.zero == Zero::Crossing) => {
                    has_sign = true;
                    continue;
                }
                Some((one, other)) if one.max(other) < 0.0 => return Some(low),
                _ => {}
            }
            let sign = certain_sign(self.form.value(&[high]));
            if sign.is_none() && !has_sign {
                continue;
            }
            let is_place = high <= low * (1.0 + SHORTEST) || (low == 0.0 && high <= NEAREST * to);
            if is_place {
                match sign {
                    Some(sign) if sign != self.sign => return Some(low),
                    None if self.zero == Zero::Any => return Some(low),
                    _ => {
                        has_sign = true;
                        continue;
                    }
                }
            }
            let middle = match low {
                0.0 => high / 1024.0,
                low if high > 4.0 * low => low.sqrt() * high.sqrt(),
                low => low + 0.5 * (high - low),
            };
            open.extend([(middle, high), (low, middle)]);
        }
        self.look(from, to)
    }

    /// The same without proof.
    fn look(&self, from: f64, to: f64) -> Option<f64> {
        let fails = |r: f64| certain_sign(self.form.value(&[r])) == Some(-self.sign);
        let place = |step: u32| from + (to - from) * f64::from(step) / f64::from(PLACES);
        // The sizes at the last two places.
        let (mut before, mut last) = (0.0, 0.0);
        for step in 1..=PLACES {
            let (at, value) = (place(step), self.form.value(&[place(step)]));
            if certain_sign(value) == Some(-self.sign) {
                return Some(last_before(place(step - 1), at, fails));
            }
            let size = value.value.abs();
            let is_lowest = self.zero == Zero::Any && step >= 3 && last <= f64::min(before, size);
            if is_lowest && let Some(end) = self.double_zero(place(step - 2), at) {
                return Some(end);
            }
            (before, last) = (last, size);
        }
        None
    }

    /// Where the expression touches zero between two places, or falls below it, by a golden-section search for its smallest size.
    fn double_zero(&self, from: f64, to: f64) -> Option<f64> {
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        let has_lost_sign = |r: f64| certain_sign(self.form.value(&[r])) != Some(self.sign);
        let size = |r: f64| self.form.value(&[r]).value.abs();
        let (mut low, mut high) = (from, to);
        for _ in 0..MOST_HALVINGS {
            if high <= low * (1.0 + SHORTEST) {
                break;
            }
            let (one, two) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
            match [one, two].into_iter().find(|r| has_lost_sign(*r)) {
                Some(zero) => return Some(last_before(from, zero, has_lost_sign)),
                None if size(one) <= size(two) => high = two,
                None => low = one,
            }
        }
        None
    }
}

/// The last place found by bisection before something is the case that is at `to` and not at `from`.
fn last_before(from: f64, to: f64, is_so: impl Fn(f64) -> bool) -> f64 {
    let (mut before, mut beyond) = (from, to);
    for _ in 0..MOST_HALVINGS {
        let middle = before + 0.5 * (beyond - before);
        if beyond <= before * (1.0 + SHORTEST) || middle <= before || middle >= beyond {
            break;
        }
        *(if is_so(middle) { &mut beyond } else { &mut before }) = middle;
    }
    before
}
