//! Closed forms over slices: blocks of points on every core, with scalar evaluation for the points that need another method.

use crate::derive::closed_form::{ClosedForm, DOUBLES, good_enough};
use crate::derive::superposed::Superposed;
use crate::eval::{BlockInput, BlockScratch};
use crate::evaluate::evaluator::{Evaluator, Method, Reading};
use crate::evaluate::local_polynomials;
use crate::integrate::error::TransformError;
use crate::num::spectral::Plan;
use crate::num::work;
use crate::num::{Bound, Bounded, Estimate};

/// The caller's buffers for the numbers of a slice, each as long as the slice.
///
/// Values alone are fastest: every point is evaluated once and without error bounds. If a closed form takes more than a few
/// nanoseconds and enough points of the slice lie within a sixteenth of an octave, it is expanded there in low-degree polynomials
/// from 30-digit values, which are cached. They are accurate to 0.75 units in the last place, the largest error measured,
/// regardless of cancellation in the form. Near kinks, ends and changes of sign, the form in doubles is used.
#[derive(Debug)]
pub struct Slice<'a> {
    /// The values.
    pub values: &'a mut [f64],
    /// Bounds of their errors, if requested.
    pub errors: Option<&'a mut [f64]>,
    /// The origin of each value, if requested.
    pub origins: Option<&'a mut [Origin]>,
}

/// The origin of a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Origin {
    /// As in [`Reading`].
    pub method: &'static str,
    /// The key of the way, as in [`Estimate`].
    pub way: &'static str,
    /// Evaluations of f′ for the value; 0 for a closed form.
    pub evaluations: u64,
    /// The kind of error bound.
    pub bound: Bound,
}

impl Origin {
    /// A closed form in double precision.
    pub const CLOSED: Self = Self { method: "exact", way: DOUBLES, evaluations: 0, bound: Bound::Proven };
}

impl<'a> Slice<'a> {
    /// Values alone.
    pub fn values(values: &'a mut [f64]) -> Self {
        Self { values, errors: None, origins: None }
    }

    /// Whether only values are requested.
    fn is_plain(&self) -> bool {
        self.errors.is_none() && self.origins.is_none()
    }

    /// Values and bounds of their errors.
    pub fn bounded(values: &'a mut [f64], errors: &'a mut [f64]) -> Self {
        Self { values, errors: Some(errors), origins: None }
    }
}

/// Points checked together for lying in one interval and inside the domain.
const CHUNK: usize = 1024;
/// Points of one task; with this size, a task of the cheapest closed form takes ten times as long as starting it on a thread.
#[cfg(feature = "parallel")]
const TASK: usize = 16 * CHUNK;

/// One of the quantities whose closed forms are known per interval.
#[derive(Clone, Copy)]
enum Wanted {
    Height,
    Superposed(Superposed, Option<f64>),
}

/// The forms of one chain, one per interval, and the breakpoints between them.
struct Forms<'e> {
    breakpoints: Vec<f64>,
    /// True if a breakpoint belongs to the interval beyond it.
    closed_below: bool,
    forms: Vec<Option<&'e ClosedForm>>,
}

/// The scratch memory of one thread.
#[derive(Default)]
struct Scratch {
    block: BlockScratch,
    radius: Vec<f64>,
    places: Vec<usize>,
    gathered: Vec<f64>,
    part: Vec<f64>,
    part_errors: Vec<f64>,
}

impl Evaluator<'_> {
    /// g at every x, as by [`Evaluator::equivalent`].
    ///
    /// With bounds, values equal the scalar results, and bounds may differ in their last digits. Values alone are computed by the
    /// form in doubles or, in dense parts of the slice, by polynomials (see [`Slice`]); they do not depend on earlier slices.
    /// Long slices run on every core with the feature `parallel`; no result depends on the number of threads.
    ///
    /// ```
    /// use sneddon::{expr::Bindings, parse, transform::{Evaluator, Method, Profile, Slice, derive}};
    /// let solution = derive(&Profile::new(&parse::profile("r^2/4").unwrap()).unwrap()).unwrap();
    /// let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
    /// let (mut g, mut errors) = ([0.0; 3], [0.0; 3]);
    /// evaluator.equivalents(&[1.0, 2.0, 3.0], Slice::bounded(&mut g, &mut errors)).unwrap();
    /// assert_eq!(g, [0.5, 2.0, 4.5]);
    /// ```
    ///
    /// # Errors
    /// [`TransformError::Buffer`] for a buffer of another length, else the error of the first failing point.
    pub fn equivalents(&self, x: &[f64], out: Slice<'_>) -> Result<(), TransformError> {
        self.fill(Wanted::Superposed(Superposed::Equivalent, None), x, out, &|x| self.equivalent(x).map(Some))
    }

    /// F/(2E*) at every contact radius a, as by [`Evaluator::force`]; see [`Evaluator::equivalents`].
    ///
    /// # Errors
    /// As [`Evaluator::equivalents`].
    pub fn forces(&self, a: &[f64], out: Slice<'_>) -> Result<(), TransformError> {
        self.fill(Wanted::Superposed(Superposed::Force, None), a, out, &|a| self.force(a).map(Some))
    }

    /// p·π/E* at every r under a contact of radius a, as by [`Evaluator::pressure`]; see [`Evaluator::equivalents`].
    ///
    /// If the pressure is theoretically infinite, the value and its error are infinite, and the method is `infinite`.
    ///
    /// # Errors
    /// As [`Evaluator::equivalents`].
    pub fn pressures(&self, r: &[f64], a: f64, out: Slice<'_>) -> Result<(), TransformError> {
        self.fill(Wanted::Superposed(Superposed::Pressure, Some(a)), r, out, &|r| self.pressure(r, a))
    }

    /// f(r) − f(0) at every r, as by [`Evaluator::height`]; see [`Evaluator::equivalents`].
    ///
    /// # Errors
    /// As [`Evaluator::equivalents`].
    pub fn heights(&self, r: &[f64], out: Slice<'_>) -> Result<(), TransformError> {
        self.fill(Wanted::Height, r, out, &|r| self.height(r).map(Some))
    }

    fn fill(
        &self,
        wanted: Wanted,
        points: &[f64],
        out: Slice<'_>,
        scalar: &(impl Fn(f64) -> Result<Option<Reading>, TransformError> + Sync),
    ) -> Result<(), TransformError> {
        let wanted_too = [out.errors.as_ref().map(|e| e.len()), out.origins.as_ref().map(|o| o.len())];
        if let Some(buffer) = wanted_too.into_iter().flatten().chain([out.values.len()]).find(|length| *length != points.len()) {
            return Err(TransformError::Buffer { points: points.len(), buffer });
        }
        let forms = self.forms(wanted, points)?;
        let plan = match (&forms, wanted) {
            (Some(forms), Wanted::Superposed(quantity, radius)) if out.is_plain() => {
                let tapes = forms.iter().flat_map(|own| own.forms.iter().flatten()).map(|form| form.tape());
                local_polynomials::plan(self, quantity, radius, tapes, points)
            }
            _ => None,
        };
        let run = |points: &[f64], out: Slice<'_>| match &plan {
            Some(plan) => self.planned(plan, &forms, wanted, points, out.values, scalar),
            None => self.task(&forms, wanted, points, out, scalar),
        };
        in_tasks(points, out, &run)
    }

    /// Polynomials where the slice is dense, and the forms for the other points.
    fn planned(
        &self,
        plan: &Plan,
        forms: &Option<Vec<Forms<'_>>>,
        wanted: Wanted,
        points: &[f64],
        values: &mut [f64],
        scalar: &impl Fn(f64) -> Result<Option<Reading>, TransformError>,
    ) -> Result<(), TransformError> {
        let (mut places, mut gathered, mut found) = (Vec::new(), Vec::new(), Vec::new());
        // Gather the remaining points by chunks of the slice, which do not depend on the number of threads.
        for (points, values) in points.chunks(CHUNK).zip(values.chunks_mut(CHUNK)) {
            places.clear();
            plan.fill(points, values, &mut places);
            if places.is_empty() {
                continue;
            }
            gathered.clear();
            gathered.extend(places.iter().filter_map(|place| points.get(*place).copied()));
            found.clear();
            found.resize(gathered.len(), 0.0);
            self.task(forms, wanted, &gathered, Slice::values(&mut found), scalar)?;
            for (place, found) in places.iter().zip(&found) {
                if let Some(value) = values.get_mut(*place) {
                    *value = *found;
                }
            }
        }
        Ok(())
    }

    /// The closed forms of the intervals in which the points lie, if they alone give the result; `None` if every point needs scalar
    /// evaluation.
    fn forms(&self, wanted: Wanted, points: &[f64]) -> Result<Option<Vec<Forms<'_>>>, TransformError> {
        if matches!(self.method, Method::Quadrature | Method::Only(_)) {
            return Ok(None);
        }
        let Wanted::Superposed(quantity, radius) = wanted else {
            let chains = self.height_forms()?.chains.iter();
            let list = chains.map(|(breakpoints, pieces)| Forms {
                breakpoints: breakpoints.clone(),
                closed_below: true,
                forms: pieces.iter().map(Some).collect(),
            });
            return Ok(Some(list.collect()));
        };
        let (lowest, highest) = match radius {
            Some(a) => (a, a),
            None if self.chains.iter().all(|own| own.breakpoints.is_empty()) => (0.0, 0.0),
            None => ends(points),
        };
        let mut list = Vec::new();
        for index in 0..self.chains.len() {
            if !self.part(index, quantity)?.open.is_empty() {
                return Ok(None);
            }
            let (first, last) = (self.interval(index, lowest), self.interval(index, highest));
            let form = |interval: usize| if interval < first { Ok(None) } else { self.closed_form(index, interval, quantity) };
            let forms = (0..=last).map(form).collect::<Result<Vec<_>, _>>()?;
            list.push(Forms { breakpoints: self.last_before(index).to_vec(), closed_below: false, forms });
        }
        Ok(Some(list))
    }

    fn task(
        &self,
        forms: &Option<Vec<Forms<'_>>>,
        wanted: Wanted,
        points: &[f64],
        mut out: Slice<'_>,
        scalar: &impl Fn(f64) -> Result<Option<Reading>, TransformError>,
    ) -> Result<(), TransformError> {
        let mut scratch = Scratch::default();
        // Use scalar evaluation for tolerances below the guaranteed accuracy of a good closed form.
        let good = if self.method == Method::Exact { good_enough(self.tolerance) } else { good_enough(self.tolerance).min(self.tolerance) };
        for (index, points) in points.chunks(CHUNK).enumerate() {
            work::check()?;
            let range = index * CHUNK..index * CHUNK + points.len();
            let Some(values) = out.values.get_mut(range.clone()) else { continue };
            let mut errors = out.errors.as_deref_mut().and_then(|errors| errors.get_mut(range.clone()));
            let mut origins = out.origins.as_deref_mut().and_then(|origins| origins.get_mut(range));
            let done = forms
                .as_ref()
                .is_some_and(|forms| self.closed(forms, wanted, points, values, errors.as_deref_mut(), &mut scratch).is_some());
            if let Some(origins) = &mut origins {
                origins.fill(Origin::CLOSED);
            }
            if done && all_enough(values, errors.as_deref(), good) {
                continue;
            }
            for (place, (point, value)) in points.iter().zip(values).enumerate() {
                let error = errors.as_deref_mut().and_then(|errors| errors.get_mut(place));
                let enough = match &error {
                    Some(error) => **error <= good * value.abs() && error.is_finite(),
                    None => value.is_finite(),
                };
                if done && enough {
                    continue;
                }
                let (found, method) = match scalar(*point)? {
                    Some(reading) => (reading.estimate, reading.method),
                    None => (Estimate { error: f64::INFINITY, ..Estimate::exact(f64::INFINITY) }, "infinite"),
                };
                *value = found.value;
                if let Some(error) = error {
                    *error = found.error;
                }
                if let Some(origin) = origins.as_deref_mut().and_then(|origins| origins.get_mut(place)) {
                    *origin = Origin { method, way: found.way, evaluations: found.evaluations, bound: found.bound };
                }
            }
        }
        Ok(())
    }

    /// The sum of the closed forms at every point of a chunk; `None` if a point is outside the domain.
    fn closed(
        &self,
        forms: &[Forms<'_>],
        wanted: Wanted,
        points: &[f64],
        values: &mut [f64],
        mut errors: Option<&mut [f64]>,
        scratch: &mut Scratch,
    ) -> Option<()> {
        // The lowest point is needed only if there are breakpoints.
        let (lowest, highest) =
            if forms.iter().all(|form| form.breakpoints.is_empty()) { (f64::NAN, highest(points)) } else { ends(points) };
        let radius = match wanted {
            Wanted::Superposed(_, radius) => radius,
            Wanted::Height => None,
        };
        if radius.unwrap_or(highest) >= self.limit_up_to(radius.unwrap_or(highest))
            || radius.is_some_and(|a| highest >= a)
            || highest.is_nan()
        {
            return None;
        }
        if let Some(a) = radius {
            scratch.radius.resize(CHUNK, a);
            scratch.radius.fill(a);
        }
        if let [form] = forms
            && let (first, last) = (form.interval(radius.unwrap_or(lowest)), form.interval(radius.unwrap_or(highest)))
            && first == last
        {
            return run(form.forms.get(first).copied()?, points, radius.is_some(), values, errors, scratch);
        }
        values.fill(0.0);
        if let Some(errors) = &mut errors {
            errors.fill(0.0);
        }
        for form in forms {
            let (first, last) = (form.interval(radius.unwrap_or(lowest)), form.interval(radius.unwrap_or(highest)));
            for interval in first..=last {
                self.gathered(form, interval, points, radius, values, errors.as_deref_mut(), scratch)?;
            }
        }
        Some(())
    }

    /// Adds one chain's form at the points of one interval.
    #[allow(clippy::too_many_arguments)]
    fn gathered(
        &self,
        form: &Forms<'_>,
        interval: usize,
        points: &[f64],
        radius: Option<f64>,
        values: &mut [f64],
        errors: Option<&mut [f64]>,
        scratch: &mut Scratch,
    ) -> Option<()> {
        let own = form.forms.get(interval).copied()?;
        let Some(_) = own else { return Some(()) };
        let inside = |x: &f64| form.interval(radius.unwrap_or(*x)) == interval;
        let (mut places, mut gathered) = (std::mem::take(&mut scratch.places), std::mem::take(&mut scratch.gathered));
        let (mut part, mut part_errors) = (std::mem::take(&mut scratch.part), std::mem::take(&mut scratch.part_errors));
        places.clear();
        places.extend(points.iter().enumerate().filter(|(_, x)| inside(x)).map(|(place, _)| place));
        gathered.clear();
        gathered.extend(places.iter().filter_map(|place| points.get(*place)));
        part.resize(gathered.len(), 0.0);
        part_errors.resize(gathered.len(), 0.0);
        let with_errors = errors.is_some();
        let done = run(own, &gathered, radius.is_some(), &mut part, with_errors.then_some(&mut part_errors), scratch);
        match errors {
            Some(errors) => {
                for ((place, value), error) in places.iter().zip(&part).zip(&part_errors) {
                    if let (Some(sum), Some(bound)) = (values.get_mut(*place), errors.get_mut(*place)) {
                        let total = Bounded { value: *sum, error: *bound } + Bounded { value: *value, error: *error };
                        (*sum, *bound) = (total.value, total.error);
                    }
                }
            }
            None => {
                for (place, value) in places.iter().zip(&part) {
                    if let Some(sum) = values.get_mut(*place) {
                        *sum += value;
                    }
                }
            }
        }
        (scratch.places, scratch.gathered, scratch.part, scratch.part_errors) = (places, gathered, part, part_errors);
        done
    }
}

impl Forms<'_> {
    /// The interval that contains the end of the contact, or the point.
    fn interval(&self, at: f64) -> usize {
        let below = |b: &&f64| if self.closed_below { **b <= at } else { **b < at };
        self.breakpoints.iter().filter(below).count()
    }
}

/// The smallest and the largest point; NaN if the first point is. Eight lanes, for vectorization.
fn ends(points: &[f64]) -> (f64, f64) {
    const LANES: usize = 8;
    let first = points.first().copied().unwrap_or(f64::NAN);
    let (mut low, mut high) = ([first; LANES], [first; LANES]);
    let (whole, rest) = points.as_chunks::<LANES>();
    let mut meet = |part: &[f64; LANES]| {
        for i in 0..LANES {
            low[i] = if part[i] < low[i] { part[i] } else { low[i] };
            high[i] = if part[i] > high[i] { part[i] } else { high[i] };
        }
    };
    whole.iter().for_each(&mut meet);
    let mut last = [first; LANES];
    last.iter_mut().zip(rest).for_each(|(own, x)| *own = *x);
    meet(&last);
    (low.into_iter().fold(first, f64::min), high.into_iter().fold(first, f64::max))
}

/// The largest point; NaN if the first point is.
fn highest(points: &[f64]) -> f64 {
    const LANES: usize = 8;
    let first = points.first().copied().unwrap_or(f64::NAN);
    let mut high = [first; LANES];
    let (whole, rest) = points.as_chunks::<LANES>();
    whole.iter().for_each(|part| (0..LANES).for_each(|i| high[i] = if part[i] > high[i] { part[i] } else { high[i] }));
    high.into_iter().chain(rest.iter().copied()).fold(first, f64::max)
}

/// Whether no point of a chunk needs scalar evaluation.
fn all_enough(values: &[f64], errors: Option<&[f64]>, good: f64) -> bool {
    // Branch-free, for vectorization.
    match errors {
        Some(errors) => {
            let mut enough = true;
            values.iter().zip(errors).for_each(|(value, error)| enough &= (*error <= good * value.abs()) & (*error <= f64::MAX));
            enough
        }
        None => {
            // Zero times a finite number is zero; times an infinity or NaN it is NaN, which propagates through the sum.
            let (whole, rest) = values.as_chunks::<8>();
            let mut sums = [0.0; 8];
            whole.iter().for_each(|part| (0..8).for_each(|i| sums[i] += 0.0 * part[i]));
            sums.iter().chain(rest).all(|value| value.is_finite())
        }
    }
}

/// One form over points of one interval.
fn run(
    form: Option<&ClosedForm>,
    points: &[f64],
    with_radius: bool,
    values: &mut [f64],
    errors: Option<&mut [f64]>,
    scratch: &mut Scratch,
) -> Option<()> {
    let radius = scratch.radius.get(..if with_radius { points.len() } else { 0 })?;
    let Some(form) = form else {
        values.fill(0.0);
        if let Some(errors) = errors {
            errors.fill(0.0);
        }
        return Some(());
    };
    let both = [points, radius];
    match errors {
        None => form.tape().run_block(both.get(..if with_radius { 2 } else { 1 })?, values, &mut scratch.block),
        Some(errors) => {
            let both = both.map(BlockInput::exact);
            form.tape().run_block_bounded(both.get(..if with_radius { 2 } else { 1 })?, values, errors, &mut scratch.block)
        }
    }
}

/// One task of a slice.
type Run<'r> = dyn Fn(&[f64], Slice<'_>) -> Result<(), TransformError> + Sync + 'r;

#[cfg(not(feature = "parallel"))]
fn in_tasks(points: &[f64], out: Slice<'_>, run: &Run<'_>) -> Result<(), TransformError> {
    run(points, out)
}

#[cfg(feature = "parallel")]
fn in_tasks(points: &[f64], out: Slice<'_>, run: &Run<'_>) -> Result<(), TransformError> {
    use rayon::iter::{IntoParallelIterator, ParallelIterator};
    // With one thread, run the work on the caller's thread, whose cache contains the points.
    if points.len() <= 2 * TASK || rayon::current_num_threads() == 1 {
        return run(points, out);
    }
    let mut errors = out.errors.map(|errors| errors.chunks_mut(TASK));
    let mut origins = out.origins.map(|origins| origins.chunks_mut(TASK));
    let tasks: Vec<(&[f64], Slice<'_>)> = points
        .chunks(TASK)
        .zip(out.values.chunks_mut(TASK))
        .map(|(points, values)| {
            let (errors, origins) = (errors.as_mut().and_then(Iterator::next), origins.as_mut().and_then(Iterator::next));
            (points, Slice { values, errors, origins })
        })
        .collect();
    // Return the error of the first failing point, independent of thread timing.
    // Threads count their steps separately; together they may use the remaining steps of this thread.
    let (most, stop) = (work::left(), work::stop_flag());
    let counted = |(points, out)| work::stoppable(stop, || work::apart(most, || run(points, out)));
    let ends: Vec<(Result<(), TransformError>, u64, bool)> = tasks.into_par_iter().map(counted).collect();
    ends.iter().for_each(|(_, steps, _)| work::spend(*steps));
    work::check()?;
    ends.into_iter().try_for_each(|(end, ..)| end)
}
