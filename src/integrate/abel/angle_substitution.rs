//! The integral over the angle on the segment below x by nested rules, with f′ in blocks and half of the points by symmetry.

use crate::integrate::error::TransformError;
use crate::integrate::integral::{NumericSegment, Weight, intricate, modest, stricter};
use crate::integrate::source::f_prime::{Numbers, Scratch};
use crate::num::Estimate;
use crate::num::bounded::UNIT;
use crate::num::quadrature::{CHUNK, EvenIntegrand, Extent, Form, Mean, Nodes, Radii, Wish, from_the_axis, mean};

/// Most evaluations before the range is bisected instead.
const MOST_EVALUATIONS: u64 = 400;
/// Beyond this fraction of the limit, f′ is computed from the distance to the limit.
pub(crate) const NEAR_THE_LIMIT: f64 = 0.7;

impl NumericSegment {
    /// The integral, if this segment reaches up to x and the rules meet the tolerance.
    ///
    /// # Errors
    /// [`TransformError::NotComputable`] if f′ is not finite.
    pub(crate) fn by_nested_rules(&self, x: f64, weight: Weight, tolerance: f64) -> Result<Option<Estimate>, TransformError> {
        let own = if self.is_intricate(x, weight) { intricate(tolerance) } else { stricter(tolerance) };
        self.nested(&self.f_prime, x, weight, (tolerance, own), 0.0)
    }

    /// The same for f′ or (r f′)′. The rules use the second of the tolerances, and errors are relative to the larger of `scale`
    /// and the value.
    pub(crate) fn nested(
        &self,
        numbers: &Numbers,
        x: f64,
        weight: Weight,
        (tolerance, own): (f64, f64),
        scale: f64,
    ) -> Result<Option<Estimate>, TransformError> {
        let lower = self.lower.value;
        let largest = move |value: f64| if value.abs() > scale { value.abs() } else { scale };
        if self.upper.is_some_and(|upper| upper.value < x) || (self.singular && lower > 0.0) {
            return Ok(None);
        }
        let limit = self.limit.as_ref().map(|limit| limit.value.value).filter(|limit| *limit > x);
        let mut source =
            Source { numbers, doubt: self.lower.error, weight, x, from_limit: None, bounds: Bounds::Running, scratch: Scratch::take() };
        let refused = |_| TransformError::NotComputable { at: x };
        if self.singular {
            let extent = Extent::new(lower, x, None);
            let mut ask = |at: Radii<'_>, values: &mut [f64], errors: &mut [f64]| source.ask(at, None, values, errors);
            let wish = Wish { accepted: |value: f64| own * largest(value), charge_r: false };
            let (found, _) = from_the_axis(&mut ask, &extent, &wish).map_err(refused)?;
            return Ok(found.map(|found| with_rounding(modest(found, own * largest(found.value), tolerance * largest(found.value)))));
        }
        // Weights are functions of x − r, except for g and F, which may use the distance to the limit instead.
        let by_limit = matches!(weight, Weight::Equivalent | Weight::Force);
        if !by_limit && limit.is_some_and(|limit| x > NEAR_THE_LIMIT * limit) {
            // Features within limit − x of the end are too narrow for the nodes.
            return Ok(None);
        }
        if let (Some(end), Some(limit)) = (&self.limit, limit)
            && by_limit
            && std::ptr::eq(numbers, &self.f_prime)
            && x > NEAR_THE_LIMIT * limit
        {
            source.from_limit = Some((&end.f_prime, end.value.error));
        }
        let extent = Extent::new(lower, x, limit.filter(|_| by_limit));
        let form = Form::choose(&extent, self.odd, limit.filter(|_| by_limit));
        let scale_of = form.scale(&extent);
        let mut integrand = Even { source, form, extent };
        let Mean { value, left_out, noise, evaluations, reached, .. } =
            mean(&mut integrand, MOST_EVALUATIONS, |mean| 0.98 * own * largest(scale_of * mean) / scale_of).map_err(refused)?;
        if !reached {
            return Ok(None);
        }
        let value = scale_of * value;
        let (left_out, noise) = (scale_of * left_out, scale_of * noise);
        // If the truncation error exceeds the rounding noise, report at least the requested tolerance as the error.
        let least = if left_out > noise { 0.97 * tolerance * largest(value) } else { 0.0 };
        Ok(Some(with_rounding(Estimate::estimated(value, least.max(left_out + noise), evaluations))))
    }
}

impl NumericSegment {
    /// f′ or (r f′)′ as an even integrand from its lower end on, with the given kind of error bounds.
    #[inline]
    pub(crate) fn integrand<'a>(
        &self,
        numbers: &'a Numbers,
        x: f64,
        weight: Weight,
        form: Form,
        extent: Extent,
        bounds: Bounds,
    ) -> Even<'a> {
        let doubt = self.lower.error;
        let source = Source { numbers, doubt, weight, x, from_limit: None, bounds, scratch: Scratch::take() };
        Even { source, form, extent }
    }
}

/// Adds the rounding error of the leading factor.
fn with_rounding(found: Estimate) -> Estimate {
    Estimate { error: found.error + 8.0 * UNIT * found.value.abs(), ..found }
}

/// The kind of error bounds of the values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bounds {
    /// Bounds of 0.
    None,
    /// Bounds at each point.
    Running,
    /// The same bounds for all nearby points.
    NearBy,
}

/// f′ times the weight of a quantity.
struct Source<'a> {
    numbers: &'a Numbers,
    /// The uncertainty of the lower end.
    doubt: f64,
    weight: Weight,
    x: f64,
    /// f′ over the distance to the limit, and the uncertainty of the limit.
    from_limit: Option<(&'a Numbers, f64)>,
    bounds: Bounds,
    scratch: Scratch,
}

impl Source<'_> {
    /// Values and bounds at a few points, times the factor of the variable.
    fn ask(&mut self, at: Radii<'_>, factor: Option<&[f64]>, values: &mut [f64], errors: &mut [f64]) {
        if self.bounds == Bounds::None {
            return self.ask_plainly(at, factor, values, errors);
        }
        let own = self.doubt;
        let (mut distances, mut doubts) = ([0.0; CHUNK], [0.0; CHUNK]);
        let (distances, doubts) = (&mut distances[..values.len()], &mut doubts[..values.len()]);
        let (numbers, end, from) = match self.from_limit {
            Some((numbers, error)) => (numbers, error, at.below_limit),
            None => (self.numbers, own, at.past_start),
        };
        for ((distance, doubt), given) in distances.iter_mut().zip(&mut *doubts).zip(from) {
            // Below the smallest normal number f′ is not accurate; the omitted part is bounded from the last values.
            *distance = given.max(f64::MIN_POSITIVE);
            // The distance is measured from an inexact end; near that end the caller accounts for its error.
            *doubt = 12.0 * UNIT * *distance + if *distance > 2.0 * end { end } else { 0.0 };
        }
        if self.bounds == Bounds::NearBy {
            numbers.block_near_by(distances, doubts, values, errors);
        } else {
            numbers.block(distances, doubts, values, errors, &mut self.scratch);
        }
        if let Some(factor) = factor {
            for ((value, error), by) in values.iter_mut().zip(&mut *errors).zip(factor) {
                *value *= by;
                *error *= by;
            }
        }
        if matches!(self.weight, Weight::Equivalent) {
            errors.iter_mut().zip(values).for_each(|(error, value)| *error += 8.0 * UNIT * value.abs());
        } else {
            self.weigh(at, values, errors);
        }
    }

    /// Values alone.
    fn ask_plainly(&mut self, at: Radii<'_>, factor: Option<&[f64]>, values: &mut [f64], errors: &mut [f64]) {
        self.numbers.plain_block(at.past_start, values, &mut self.scratch);
        if let Some(factor) = factor {
            values.iter_mut().zip(factor).for_each(|(value, by)| *value *= by);
        }
        if !matches!(self.weight, Weight::Equivalent) {
            self.weigh(at, values, errors);
            errors.fill(0.0);
        }
    }

    /// Multiplies by the weight.
    #[inline(never)]
    fn weigh(&self, at: Radii<'_>, values: &mut [f64], errors: &mut [f64]) {
        let x = self.x;
        for (((value, error), &r), &below) in values.iter_mut().zip(errors).zip(at.r).zip(at.below_limit) {
            let (by, roundings) = match self.weight {
                Weight::Equivalent => (1.0, 0.0),
                Weight::Force => {
                    let share = r / x;
                    (share * share, 28.0 * UNIT + 4.0 * self.doubt / r)
                }
                // Here below_limit is x − r: sin²τ = (x − r)(x + r)/x².
                Weight::Integral => {
                    let share = below / x;
                    (share * (2.0 - share), 16.0 * UNIT)
                }
                Weight::Outside(outer) => {
                    // Multiply the roots separately: the product under one root may leave the range of doubles.
                    let ratio = x / (outer - x).sqrt() / (outer + x).sqrt();
                    let share = below / x;
                    let (q, s) = ((share * (2.0 - share)).sqrt(), r / x);
                    let short = s * s / (1.0 + q);
                    let angle = (q * ratio).atan();
                    ((short * ratio).atan2(1.0 + q * ratio * ratio) + short * angle, 32.0 * UNIT)
                }
            };
            *value *= by;
            *error = *error * by.abs() + (8.0 * UNIT + roundings) * value.abs();
        }
    }
}

/// f′ times the weight and the factor of the variable.
pub(crate) struct Even<'a> {
    source: Source<'a>,
    form: Form,
    extent: Extent,
}

impl EvenIntegrand for Even<'_> {
    const BOUNDED: bool = true;
    const BLOCK: usize = CHUNK;
    const TOGETHER: bool = true;

    fn fill(&mut self, nodes: Nodes<'_>, values: &mut [f64], errors: &mut [f64]) {
        let exact = matches!(self.source.weight, Weight::Integral | Weight::Outside(_));
        let source = &mut self.source;
        self.form.visit::<CHUNK>(&self.extent, nodes, exact, |at, factor| source.ask(at, factor, values, errors));
    }

    fn radii<'n>(&self, nodes: Nodes<'n>) -> Option<&'n [f64]> {
        self.form.radii(nodes)
    }
}
