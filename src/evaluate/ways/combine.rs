//! One number from a solution: closed terms and integrals together, or whichever other way has more digits.

use crate::derive::closed_form::{DOUBLES, good_enough, precise_total, refined, rounded};
use crate::derive::superposed::Superposed;
use crate::evaluate::evaluator::{Evaluator, Method, Reading};
use crate::evaluate::series::SeriesEvaluator;
use crate::evaluate::ways::RECOGNISED;
use crate::evaluate::ways::best::{Answer, Best, by_quadrature, is_lost};
use crate::integrate::ask::Ask;
use crate::integrate::error::TransformError;
use crate::integrate::integral::NumericProfile;
use crate::num::{Bound, Bounded, Estimate, Precise, work};
use std::cell::Cell;

/// Relative error of a quadrature above which costly ways, and the series, are tried too.
const SCANT: f64 = 1e-10;

impl Evaluator<'_> {
    /// Closed terms plus the integrals of the others; or the whole by quadrature where that is demanded or has more digits.
    ///
    /// Where double precision leaves the sum of the closed terms too few digits, all of them are evaluated with 30.
    ///
    /// Special functions may need many thousand terms at some arguments, and the terms that stay open may cancel where the formula
    /// that was typed does not: with method `auto` each may take one or two milliseconds before the integral of the formula as typed is
    /// tried instead. Where that misses the tolerance, closed forms may take half a second. Open terms may take a tenth of a second,
    /// and only where the integral is also less accurate than [`SCANT`].
    pub(crate) fn combine(&self, quantity: Superposed, ask: Ask) -> Answer {
        let abandoned = Cell::new(None);
        let found = self.combined(quantity, ask, Some(&abandoned));
        let (enough, steps) = match abandoned.get() {
            None => return found,
            Some(Abandoned::ClosedForm) => (self.tolerance, STEPS_AFTER_QUADRATURE),
            Some(Abandoned::OpenTerms) => (self.tolerance.max(SCANT), OPEN_STEPS_AFTER_QUADRATURE),
        };
        let typed = self.typed().and_then(|typed| unless_underflown(typed, ask, self.integrate(typed, ask)));
        if matches!(&typed, Ok(Some(own)) if own.meets(enough)) {
            return by_quadrature(typed);
        }
        work::share(steps, || self.combined(quantity, ask, None)).unwrap_or_else(|| self.by_quadrature(ask, typed))
    }

    fn integrate(&self, profile: &NumericProfile, ask: Ask) -> Result<Option<Estimate>, TransformError> {
        work::bounded(|| profile.answer(ask, self.tolerance))
    }

    /// As [`Self::combine`]; if `abandoned` is given, what takes long is abandoned and named there.
    fn combined(&self, quantity: Superposed, ask: Ask, abandoned: Option<&Cell<Option<Abandoned>>>) -> Answer {
        work::spend(OVERHEAD);
        let abandoned = abandoned.filter(|_| self.method == Method::Auto);
        let coordinates = ask.coordinates();
        let [place, contact] = coordinates;
        let inputs = quantity.inputs(&coordinates);
        let typed = || self.typed().and_then(|typed| self.integrate(typed, ask));
        if self.method == Method::Quadrature {
            return self.by_quadrature(ask, typed());
        }
        let whole = || self.by_quadrature(ask, typed());
        let exact: Vec<Bounded> = inputs.iter().copied().map(Bounded::exact).collect();
        let (mut closed, mut open, mut any_open) = (Bounded::exact(0.0), Estimate::exact(0.0), false);
        let mut overflow = false;
        let mut forms = Vec::new();
        let mut slots = Vec::new();
        for index in 0..self.chains.len() {
            let part = self.part(index, quantity)?;
            if let Some(form) = self.closed_form(index, self.interval(index, contact), quantity)? {
                let abandoned = abandoned.filter(|_| form.tape().is_special());
                let found = in_time(Abandoned::ClosedForm, abandoned, CLOSED_FORM_STEPS, || form.in_doubles(&exact, &mut slots));
                let Some(value) = found else { return Ok(None) };
                if value.value.is_infinite() {
                    // Individually infinite terms, at the apex or at a kink; elsewhere the value is too large for a float.
                    if quantity == Superposed::Pressure && self.may_be_infinite(place) {
                        return Ok(None);
                    }
                    overflow = true;
                }
                closed = closed + value;
                forms.push(form);
            }
            if !part.open.is_empty() {
                if self.method == Method::Exact {
                    return Err(TransformError::NoClosedForm { quantity: quantity.name() });
                }
                // Terms that are 0/0 at the axis, one by one and together: only the whole profile has a series there.
                if part.open.is_ragged()
                    && self.typed()?.is_mended()
                    && let Ok(own) = whole()
                {
                    return Ok(own);
                }
                let most = if self.chains.len() > MOST_CHAINS { 0 } else { OPEN_STEPS };
                let found = in_time(Abandoned::OpenTerms, abandoned, most, || self.integrate(&part.open, ask));
                let Some(found) = found else { return Ok(None) };
                let found = match found {
                    Ok(Some(found)) => found,
                    Ok(None) => return Ok(None),
                    // A term underflows, or is 0/0 next to the axis; the integral over the whole profile may still be accurate.
                    // An estimate would hide what could not be resolved alone.
                    Err(error) if is_lost(&error) => {
                        return whole()?.filter(|whole| whole.estimate.bound == Bound::Proven).map(Some).ok_or(error);
                    }
                    Err(error) => return Err(error),
                };
                open = open + found;
                any_open = true;
            }
        }
        let abandoned = abandoned.filter(|_| forms.iter().any(|form| form.tape().is_special()));
        let precise = || {
            let found = in_time(Abandoned::ClosedForm, abandoned, CLOSED_FORM_STEPS_30_DIGITS, || precise_total(&forms, inputs));
            found.unwrap_or((Precise::nan(), DOUBLES))
        };
        let closed = if forms.is_empty() {
            Estimate::exact(0.0)
        } else if closed.value.is_finite() {
            refined(closed, (closed + open.bounded()).value, good_enough(self.tolerance), precise)
        } else {
            // An intermediate overflow does not imply that the result overflows.
            let (exact, way) = precise_total(&forms, inputs);
            if exact.value.hi.is_infinite() || (overflow && !exact.is_finite()) {
                let signed = if exact.value.hi.is_infinite() { exact.value.hi } else { closed.value };
                return Err(TransformError::Overflow { symbol: quantity.coordinate(), at: contact, is_negative: signed < 0.0 });
            }
            Estimate::from_bounded(rounded(exact), 0).by(way)
        };
        let estimate = if any_open { closed + open } else { closed };
        let method = match (!forms.is_empty(), any_open) {
            (true, true) => "mixed",
            (false, true) => "quadrature",
            _ => "exact",
        };
        let own = Reading { estimate, method };
        if estimate.value.is_nan() && self.method == Method::Exact {
            // Infinite parts of both signs: theory says whether the whole is infinite too.
            return match whole()? {
                None => Ok(None),
                Some(_) => Err(TransformError::NotComputable { at: place }),
            };
        }
        if self.method == Method::Exact || estimate.meets(self.tolerance) {
            return Ok(Some(own));
        }
        if method == "quadrature" {
            let own = Best::of(self.tolerance, Ok(Some(own)));
            return if estimate.meets(SCANT) { own } else { own.or(|| self.by_series(ask)) }.answer();
        }
        self.or_the_whole(own, ask)
    }

    /// The better of a number whose closed form lost digits, or left its domain, and of the whole by quadrature or, next to the
    /// axis, by the series.
    pub(crate) fn or_the_whole(&self, own: Reading, ask: Ask) -> Answer {
        let typed = || self.quadrature(self.typed()?, ask);
        Best::of(self.tolerance, Ok(Some(own))).or(typed).or(|| self.by_recognition(ask)).or(|| self.by_series(ask)).answer()
    }

    /// Quadrature of f′ as typed (`typed` is its result), or of its recognition form if the typed one cancels or leaves the range
    /// of doubles.
    #[cold]
    pub(crate) fn by_quadrature(&self, ask: Ask, typed: Result<Option<Estimate>, TransformError>) -> Answer {
        let typed = self.typed().and_then(|profile| by_quadrature(unless_underflown(profile, ask, typed)));
        match Best::of(self.tolerance, typed).or(|| self.by_recognition(ask)).answer() {
            // An integrand that is 0/0 in doubles next to the axis may have a series.
            Err(error) if is_lost(&error) => self.by_series(ask).map_err(|_| error),
            other => other,
        }
    }

    pub(crate) fn by_recognition(&self, ask: Ask) -> Answer {
        let found = work::share(STEPS_AFTER_QUADRATURE, || self.quadrature(self.recognised()?, ask));
        let found = found.unwrap_or(Err(TransformError::NotComputable { at: ask.reach() }))?;
        Ok(found.map(|own| Reading { estimate: own.estimate.by(RECOGNISED), ..own }))
    }

    fn quadrature(&self, profile: &NumericProfile, ask: Ask) -> Answer {
        by_quadrature(unless_underflown(profile, ask, self.integrate(profile, ask)))
    }

    /// By the power series at the axis, with a proven remainder.
    ///
    /// # Errors
    /// [`TransformError::NotComputable`] if the series is not known, or if the truncated series has no accurate digit.
    pub(crate) fn by_series(&self, ask: Ask) -> Answer {
        let order = if matches!(ask, Ask::Pressure { .. }) { SeriesEvaluator::PRESSURE_ORDER } else { SeriesEvaluator::ORDER };
        let none = TransformError::NotComputable { at: ask.reach() };
        let Ok(series) = SeriesEvaluator::with(&self.solution.profile, &self.bindings, order) else { return Err(none) };
        let found = match ask {
            Ask::Equivalent(x) => series.equivalent(x),
            Ask::Force(a) => series.force(a),
            Ask::Integral(a) => series.integral(a),
            Ask::Height(r) => series.height(r),
            Ask::Pressure { r, a } if r > 0.0 => series.pressure(r, a),
            Ask::Pressure { .. } | Ask::Outside { .. } | Ask::Axial { .. } => return Err(none),
        };
        found.ok().filter(|own| own.estimate.error < own.estimate.value.abs()).map(Some).ok_or(none)
    }
}

/// The integral, unless it is an exact 0 although f′ is not 0: an underflow, or a divisor that is infinite.
pub(crate) fn unless_underflown(
    profile: &NumericProfile,
    ask: Ask,
    found: Result<Option<Estimate>, TransformError>,
) -> Result<Option<Estimate>, TransformError> {
    match found? {
        Some(own) if own.value == 0.0 && own.error == 0.0 && profile.reaches(ask.reach()) => {
            Err(TransformError::NotComputable { at: ask.reach() })
        }
        other => Ok(other),
    }
}

/// Steps of one number in addition to its tapes, measured by `benches/steps.rs`.
const OVERHEAD: u64 = 48;
/// Steps, about a millisecond, after which a closed form with special functions is abandoned in favour of quadrature.
const CLOSED_FORM_STEPS: u64 = 100_000;
/// The same for closed forms with 30 digits.
const CLOSED_FORM_STEPS_30_DIGITS: u64 = 400_000;
/// Steps, about half a second, for a closed form or for the integral of the recognised f′ if quadrature has missed the tolerance.
const STEPS_AFTER_QUADRATURE: u64 = 50_000_000;
/// Steps, about two milliseconds, after which the integral of the open terms of a chain is abandoned in favour of the formula as typed, …
const OPEN_STEPS: u64 = 200_000;
/// … and the most chains of which this is tried, because all of them add up.
const MOST_CHAINS: usize = 64;
/// The steps for the open terms if the formula as typed has missed the tolerance.
const OPEN_STEPS_AFTER_QUADRATURE: u64 = 10_000_000;

/// What was abandoned because it takes long.
#[derive(Clone, Copy)]
enum Abandoned {
    ClosedForm,
    OpenTerms,
}

/// Returns the result of `find`, or `None` if `abandoned` is given and it takes more than `steps`; `abandoned` is then set to `part`.
fn in_time<T>(part: Abandoned, abandoned: Option<&Cell<Option<Abandoned>>>, steps: u64, find: impl FnOnce() -> T) -> Option<T> {
    let Some(abandoned) = abandoned else { return Some(find()) };
    let found = work::share(steps, find);
    if found.is_none() {
        abandoned.set(Some(part));
    }
    found
}
