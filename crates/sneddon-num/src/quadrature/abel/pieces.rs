//! One integral over the angle per piece of f′: nested rules where they suffice, else adaptive bisection.

use super::super::adaptive::{Options, integrate_blocks};
use super::super::even::{self, EvenIntegrand, Known, Mean, Middles, Nodes};
use super::super::{Panel, Point};
use super::forms::{Extent, Form};
use super::start::{Wish, from_the_axis};
use super::{AbelOptions, Radii, Start, Strip, counted, without_spent};
use crate::bounded::UNIT;
use crate::stable::leg;
use crate::{Bounded, Estimate, NumError};

/// ∫ f′ dτ over r = x cos τ, times (r/x)² for the force.
#[inline]
pub(super) fn over_angle<const FORCE: bool>(
    slope: &mut impl FnMut(Radii<'_>, &mut [f64]),
    x: f64,
    options: &AbelOptions<'_>,
) -> Result<Estimate, NumError> {
    let limit = options.limit.unwrap_or(f64::INFINITY);
    if !(x >= 0.0 && x.is_finite() && x < limit) {
        return Err(NumError::OutOfDomain { what: "upper end of an Abel integral", got: x, accepted: "0 <= x, finite, below the limit" });
    }
    let from = options.from.max(0.0);
    if from >= x {
        return Ok(Estimate::exact(0.0));
    }
    let inner = |b: &&f64| **b > from && **b < x;
    if !options.breakpoints.iter().any(|b| inner(&b)) {
        return last::<FORCE>(slope, from, x, options);
    }
    let mut total = Bounded::exact(0.0);
    let (mut evaluations, mut lower) = (0, from);
    for end in options.breakpoints.iter().filter(inner).copied().chain([x]) {
        let part = if end < x { between::<FORCE>(slope, lower, end, x, options) } else { last::<FORCE>(slope, lower, x, options) };
        let part = best(part)?;
        total = total + part.bounded();
        evaluations += part.evaluations;
        lower = end;
    }
    finished(Estimate::estimated(total.value, total.error, evaluations), options)
}

/// The value that an early end still has.
fn best(part: Result<Estimate, NumError>) -> Result<Estimate, NumError> {
    match part {
        Err(NumError::ToleranceNotReached { value, error, evaluations, .. } | NumError::EvaluationLimit { value, error, evaluations }) => {
            Ok(Estimate::estimated(value, error, evaluations))
        }
        other => other,
    }
}

/// The estimate, if it is good enough.
fn finished(found: Estimate, options: &AbelOptions<'_>) -> Result<Estimate, NumError> {
    let Estimate { value, error, evaluations, .. } = found;
    let requested = target(options, value);
    if error <= requested {
        Ok(found)
    } else if evaluations >= options.max_evaluations {
        Err(NumError::EvaluationLimit { value, error, evaluations })
    } else {
        Err(NumError::ToleranceNotReached { value, error, requested, evaluations })
    }
}

pub(super) fn target(options: &AbelOptions<'_>, value: f64) -> f64 {
    options.abs_tol.max(options.rel_tol * value.abs())
}

/// The piece that ends at x.
fn last<const FORCE: bool>(
    slope: &mut impl FnMut(Radii<'_>, &mut [f64]),
    lower: f64,
    x: f64,
    options: &AbelOptions<'_>,
) -> Result<Estimate, NumError> {
    let extent = Extent::new(lower, x, options.limit);
    if options.start == Start::Algebraic {
        if lower > 0.0 {
            return bisected::<FORCE>(slope, lower, &extent, options);
        }
        let mut ask = |at: Radii<'_>, values: &mut [f64], errors: &mut [f64]| {
            slope(at, values);
            for ((v, e), r) in values.iter_mut().zip(errors).zip(at.r) {
                if FORCE {
                    *v *= (*r / x) * (*r / x);
                }
                *e = UNIT * (options.roundings + WEIGHING * f64::from(u8::from(FORCE))) * v.abs();
            }
        };
        let wish = Wish { accepted: |value| target(options, value), charge_r: true };
        let (found, spent) = from_the_axis(&mut ask, &extent, &wish)?;
        return match found {
            Some(found) => Ok(found),
            None => counted(bisected::<FORCE>(slope, lower, &extent, &without_spent(options, spent)), spent),
        };
    }
    let mut spent = 0;
    if let (Some(strip), None) = (&options.strip, options.limit) {
        match in_a_strip::<FORCE>(slope, &extent, strip, options)? {
            (Some(found), _) => return Ok(found),
            (None, evaluations) => spent = evaluations,
        }
    }
    let form = Form::choose(&extent, options.start == Start::Odd, options.limit);
    let scale = form.scale(&extent);
    let mut integrand = Blocks::<_, FORCE> { slope, form, extent, roundings: options.roundings };
    let (least, rel_tol) = (options.abs_tol / scale, options.rel_tol);
    let most = options.max_evaluations.saturating_sub(spent);
    let found = even::mean(&mut integrand, most, |mean: f64| least.max(rel_tol * mean.abs()))?;
    let Mean { value, left_out, noise, reached, .. } = found;
    let evaluations = found.evaluations + spent;
    let (value, noise) = (scale * value, scale * noise);
    let rounding = 8.0 * UNIT * value.abs();
    let mut error = scale * left_out + noise + rounding;
    let requested = target(options, value);
    if reached && error <= requested {
        // If the truncation error exceeds the rounding noise, report at least the requested tolerance as the error.
        if scale * left_out > noise {
            error = error.max(MODEST * requested);
        }
        return Ok(Estimate::estimated(value, error, evaluations));
    }
    if noise + rounding > 0.99 * requested && scale * left_out <= noise {
        return Err(NumError::ToleranceNotReached { value, error, requested, evaluations });
    }
    counted(bisected::<FORCE>(slope, lower, &extent, &without_spent(options, evaluations)), evaluations)
}

/// The mean of f′ is guessed to be this share of the bound, and less where x is less than the height; where it is smaller still
/// another rule is taken.
const GUESS: f64 = 1e-3;

/// The piece that ends at x, by the one rule that suffices for an f′ that is bounded in a strip; `None` if there is none, with
/// the evaluations that were spent.
fn in_a_strip<const FORCE: bool>(
    slope: &mut impl FnMut(Radii<'_>, &mut [f64]),
    extent: &Extent,
    strip: &Strip,
    options: &AbelOptions<'_>,
) -> Result<(Option<Estimate>, u64), NumError> {
    let x = extent.x;
    let odd = options.start == Start::Odd;
    let (wide, high) = (x.hypot(strip.height) / x, strip.height / x);
    // r = x cos τ: |Im τ| up to arsinh(h/x), where |cos τ| ≥ h/x at the upper end.
    let sigma = if odd { high.asinh() } else { (high.asinh() / extent.angle()).asinh() };
    let largest = strip.largest * if odd { 1.0 / high } else { 1.0 } * if FORCE { wide * wide } else { 1.0 };
    let mut spent = 0;
    if !(strip.height > 0.0 && largest <= f64::MAX && sigma <= f64::MAX) {
        return Ok((None, spent));
    }
    let form = Form::choose(extent, odd, None);
    let scale = form.scale(extent);
    let mut wanted = GUESS * options.rel_tol * strip.largest / high.max(1.0);
    for _ in 0..2 {
        let Some(known) = Known::fewest(sigma, largest, wanted.max(0.5 * options.abs_tol / scale)) else { break };
        let found = by_a_known_rule::<FORCE>(slope, known, extent, form, options)?;
        spent += found.evaluations;
        if found.error <= target(options, found.value) {
            return Ok((Some(Estimate { evaluations: spent, ..found }), spent));
        }
        wanted = 0.1 * options.rel_tol * (found.value / scale).abs();
    }
    Ok((None, spent))
}

/// The piece that ends at x by a rule of which is known what it leaves out of the mean.
#[inline]
pub(super) fn by_a_known_rule<const FORCE: bool>(
    slope: &mut impl FnMut(Radii<'_>, &mut [f64]),
    known: Known,
    extent: &Extent,
    form: Form,
    options: &AbelOptions<'_>,
) -> Result<Estimate, NumError> {
    let scale = form.scale(extent);
    let mut integrand = Blocks::<_, FORCE> { slope, form, extent: *extent, roundings: options.roundings };
    let found = known.mean(&mut integrand)?;
    let value = scale * found.value;
    let error = scale * (found.left_out + found.noise) + 8.0 * UNIT * value.abs();
    Ok(Estimate::estimated(value, error, found.evaluations))
}

/// Units that the weight (r/x)² may be off.
const WEIGHING: f64 = 3.0;

/// Number of points at which a closure is evaluated together.
const BLOCK: usize = 8;

/// f′ as an even integrand.
pub(super) struct Blocks<'a, F, const FORCE: bool> {
    pub(super) slope: &'a mut F,
    pub(super) form: Form,
    pub(super) extent: Extent,
    pub(super) roundings: f64,
}

impl<F: FnMut(Radii<'_>, &mut [f64]), const FORCE: bool> EvenIntegrand for Blocks<'_, F, FORCE> {
    const BOUNDED: bool = false;
    const BLOCK: usize = BLOCK;
    const TOGETHER: bool = false;

    #[inline(always)]
    fn fill(&mut self, nodes: Nodes<'_>, values: &mut [f64], _errors: &mut [f64]) {
        let slope = &mut *self.slope;
        self.form.visit::<{ BLOCK }>(&self.extent, nodes, false, |at, factor| {
            slope(at, values);
            if let Some(factor) = factor {
                for (v, factor) in values.iter_mut().zip(factor) {
                    *v *= *factor;
                }
            }
            if FORCE {
                let x = self.extent.x;
                for (v, r) in values.iter_mut().zip(at.r) {
                    *v *= (*r / x) * (*r / x);
                }
            }
        });
    }

    #[inline]
    fn relative(&self) -> f64 {
        UNIT * (self.roundings + 6.0 + WEIGHING * f64::from(u8::from(FORCE)))
    }

    #[inline(always)]
    fn radii<'n>(&self, nodes: Nodes<'n>) -> Option<&'n [f64]> {
        self.form.radii(nodes)
    }

    #[inline(always)]
    fn displacement(&self, middles: Middles<'_>, values: &[f64]) -> f64 {
        2.0 * UNIT * self.form.displacement(&self.extent, middles, values)
    }
}

/// Where the rules leave out more than rounding noise no more than this share of the tolerance is promised.
const MODEST: f64 = 0.999;

/// Where the range is cut before any bisection, as shares of it: a kink just below x, which nobody told, and a
/// narrow feature at the axis show in small panels only.
const GRADES: [f64; 9] = [1e-6, 1e-4, 1e-2, 0.9, 0.99, 0.999, 0.9999, 0.999_99, 0.999_999];

/// The piece that ends at x by bisection of the angle, its lower end perhaps singular.
fn bisected<const FORCE: bool>(
    slope: &mut impl FnMut(Radii<'_>, &mut [f64]),
    lower: f64,
    extent: &Extent,
    options: &AbelOptions<'_>,
) -> Result<Estimate, NumError> {
    let (Extent { x, rest, .. }, angle) = (*extent, extent.angle());
    // τ from 0 at x on; the lower end's own angle from the axis is π/2 − angle.
    let above_axis = if lower == 0.0 { 0.0 } else { lower.atan2(leg(x, lower)) };
    let mut place = |point: &Point| {
        let tau = point.x;
        let from_end = if tau > GRADES[GRADES.len() - 1] * angle { point.from_upper } else { angle - tau };
        let from_axis = above_axis + from_end;
        let past = 2.0 * x * (0.5 * from_end).sin() * (above_axis + 0.5 * from_end).cos();
        let half = (0.5 * tau).sin();
        Spot { r: x * from_axis.sin(), past, below: rest + 2.0 * x * half * half, stretch: tau.cos() / tau.sin() }
    };
    adaptive::<FORCE>(slope, (x, angle), &mut place, &GRADES, options)
}

/// A piece below x, [lower, end].
fn between<const FORCE: bool>(
    slope: &mut impl FnMut(Radii<'_>, &mut [f64]),
    lower: f64,
    end: f64,
    x: f64,
    options: &AbelOptions<'_>,
) -> Result<Estimate, NumError> {
    let width = crate::forms::angle_between(lower, end, x);
    let beyond = leg(x, end).atan2(end);
    let limit = options.limit.unwrap_or(x);
    let mut place = |point: &Point| {
        let (v, tau) = (point.from_lower, beyond + point.from_upper);
        let past = 2.0 * x * (0.5 * v).sin() * (tau + 0.5 * v).sin();
        let r = lower + past;
        Spot { r, past, below: limit - r, stretch: tau.cos() / tau.sin() }
    };
    adaptive::<FORCE>(slope, (x, width), &mut place, &[], options)
}

/// A place of f′, and by how much a relative rounding of r moves the angle.
struct Spot {
    r: f64,
    past: f64,
    below: f64,
    stretch: f64,
}

fn adaptive<const FORCE: bool>(
    slope: &mut impl FnMut(Radii<'_>, &mut [f64]),
    (x, width): (f64, f64),
    place: &mut impl FnMut(&Point) -> Spot,
    grades: &[f64],
    options: &AbelOptions<'_>,
) -> Result<Estimate, NumError> {
    const MOST_NODES: usize = 61;
    let mut integrand = |points: &[Point], heights: &mut [Bounded]| {
        let count = points.len().min(MOST_NODES);
        let (mut r, mut past, mut below, mut stretch, mut out) =
            ([0.0; MOST_NODES], [0.0; MOST_NODES], [0.0; MOST_NODES], [0.0; MOST_NODES], [0.0; MOST_NODES]);
        for (i, point) in points.iter().enumerate().take(MOST_NODES) {
            let spot = place(point);
            (r[i], past[i], below[i], stretch[i]) = (spot.r, spot.past, spot.below, spot.stretch);
        }
        slope(Radii { r: &r[..count], past_start: &past[..count], below_limit: &below[..count] }, &mut out[..count]);
        if FORCE {
            for (v, r) in out.iter_mut().zip(&r) {
                *v *= (r / x) * (r / x);
            }
        }
        // Points come from both ends inwards, the centre last: the next one in the list is the neighbour.
        let half = count / 2;
        for (i, height) in heights.iter_mut().enumerate().take(count) {
            let other = if i + 1 == half { count - 1 } else { (i + 1).min(count - 1) };
            let apart = (points[i].from_lower - points[other].from_lower).abs();
            let rise = if apart > 0.0 { (out[i] - out[other]).abs() / apart } else { 0.0 };
            let error =
                UNIT * ((options.roundings + 2.0 + WEIGHING * f64::from(u8::from(FORCE))) * out[i].abs() + 6.0 * rise * stretch[i].abs());
            *height = Bounded { value: out[i], error };
        }
    };
    let panels = if options.start == Start::Algebraic {
        vec![Panel::singular(0.0, width)]
    } else {
        Panel::chain(grades.iter().map(|share| share * width).chain([width]))
    };
    let own = Options {
        rel_tol: options.rel_tol,
        abs_tol: options.abs_tol,
        max_evaluations: options.max_evaluations,
        charge_x: false,
        ..Options::default()
    };
    let found = integrate_blocks(&mut integrand, &panels, &own)?;
    Ok(Estimate { error: found.error + 8.0 * UNIT * found.value.abs(), ..found })
}
