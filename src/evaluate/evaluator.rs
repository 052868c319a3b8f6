//! Numbers from a solution: closed forms where they exist, quadrature for the rest, and the error of both.

use crate::derive::closed_form::{ClosedForm, for_second_pass, good_enough, precise_total, refined, total};
use crate::derive::domain::barrier::Barrier;
use crate::derive::engine::Solution;
use crate::derive::kinks::is_below;
use crate::derive::solved::SolvedInterval;
use crate::derive::superposed::Superposed;
use crate::eval::{constant_value, first_double_from};
use crate::evaluate::local_polynomials::PolynomialCache;
use crate::evaluate::series::SeriesEvaluator;
use crate::evaluate::ways::combine::ORDER;
use crate::expr::{Bindings, Expr, Symbol, has_30_digits};
use crate::integrate::admit::{beyond_the_edge, finite_and_not_negative, tolerance_in_range};
use crate::integrate::error::TransformError;
use crate::integrate::integral::NumericProfile;
use crate::integrate::segment::Segment;
use crate::num::{Bounded, Estimate, Precise, work};
use std::sync::OnceLock;

/// Ends of the profile that are as close as this, relatively, are one.
const SAME: f64 = 64.0 * f64::EPSILON;

/// How a number may be computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The cheapest way that meets the tolerance.
    Auto,
    /// Closed forms only.
    Exact,
    /// Quadrature of the profile as typed.
    Quadrature,
}

/// A number with its error and the way it was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Value, error bound and evaluations of f′.
    pub estimate: Estimate,
    /// `exact`, `quadrature`, or `mixed` where closed terms stand beside integrals.
    pub method: &'static str,
}

/// A solution with numbers for its parameters, compiled for many points; it may be shared between threads.
pub struct Evaluator<'a> {
    pub(crate) solution: &'a Solution,
    pub(crate) bindings: Bindings,
    pub(crate) chains: Vec<NumericChain>,
    pub(crate) limits: Vec<f64>,
    barriers: Vec<Barrier>,
    /// The smallest limit and the first end of a barrier.
    end: OnceLock<f64>,
    typed: OnceLock<NumericProfile>,
    recognised: OnceLock<NumericProfile>,
    heights: OnceLock<Heights>,
    pub(crate) steep: OnceLock<bool>,
    pub(crate) polynomials: PolynomialCache,
    pub(crate) tolerance: f64,
    pub(crate) method: Method,
}

/// f as it was typed, less its value at the axis: per chain its breakpoints and pieces.
pub(crate) struct Heights {
    pub(crate) chains: Vec<(Vec<f64>, Vec<ClosedForm>)>,
}

pub(crate) struct NumericChain {
    pub(crate) breakpoints: Vec<Bounded>,
    slope: OnceLock<Part>,
    force: OnceLock<Part>,
    pressure: OnceLock<Part>,
    outside: OnceLock<Part>,
}

/// The closed expressions of one quantity, one per interval of the contact, and what is left to integrate.
pub(crate) struct Part {
    pub(crate) closed: Vec<Option<ClosedForm>>,
    pub(crate) open: NumericProfile,
}

impl<'a> Evaluator<'a> {
    /// Binds the parameters to numbers; nothing else is computed before it is asked for.
    ///
    /// ```
    /// use sneddon::{expr::{Bindings, Expr}, parse, transform::{Evaluator, Method, Profile, derive}};
    /// let profile = Profile::new(&parse::profile("r^2/(2*R)").unwrap()).unwrap();
    /// let solution = derive(&profile).unwrap();
    /// let set = Bindings::one("R", Expr::integer(2));
    /// let evaluator = Evaluator::new(&solution, &set, Method::Auto, 1e-13).unwrap();
    /// assert_eq!(evaluator.slope(3.0).unwrap().estimate.value, 4.5);
    /// ```
    ///
    /// # Errors
    /// [`TransformError::Evaluation`] where a parameter has no value; [`TransformError::Statement`] for a tolerance outside (0, 1).
    pub fn new(solution: &'a Solution, bindings: &Bindings, method: Method, tolerance: f64) -> Result<Self, TransformError> {
        tolerance_in_range(tolerance)?;
        let number = |expr: &Expr| constant_value(expr, bindings).map(|b| b.value);
        let mut chains = Vec::new();
        for chain in &solution.chains {
            let breakpoints = chain.breakpoints.iter().map(|b| constant_value(b, bindings)).collect::<Result<_, _>>()?;
            chains.push(NumericChain {
                breakpoints,
                slope: OnceLock::new(),
                force: OnceLock::new(),
                pressure: OnceLock::new(),
                outside: OnceLock::new(),
            });
        }
        let limits = solution.profile.limits().map(number).collect::<Result<_, _>>()?;
        Ok(Self {
            solution,
            bindings: bindings.clone(),
            chains,
            limits,
            barriers: solution.profile.demands.iter().map(|own| Barrier::new(own, bindings)).collect::<Result<_, _>>()?,
            end: OnceLock::new(),
            typed: OnceLock::new(),
            recognised: OnceLock::new(),
            heights: OnceLock::new(),
            steep: OnceLock::new(),
            polynomials: PolynomialCache::default(),
            tolerance,
            method,
        })
    }

    /// The profile as typed, as numbers.
    ///
    /// # Errors
    /// As [`Evaluator::new`].
    pub fn typed(&self) -> Result<&NumericProfile, TransformError> {
        if let Some(ready) = self.typed.get() {
            return Ok(ready);
        }
        let built = self.typed_profile()?;
        work::check()?;
        Ok(self.typed.get_or_init(|| built))
    }

    /// The profile by the recognition form of f′.
    pub(crate) fn recognised(&self) -> Result<&NumericProfile, TransformError> {
        if let Some(ready) = self.recognised.get() {
            return Ok(ready);
        }
        let intervals = self.solution.chains.iter().flat_map(|chain| &chain.intervals);
        let slope = |interval: &SolvedInterval| Expr::sum(interval.terms.iter().map(|solved| solved.term.slope()));
        let pieces: Vec<(Segment, Expr)> = intervals.map(|interval| (interval.segment.clone(), slope(interval))).collect();
        let built = NumericProfile::new(&pieces, &self.bindings)?;
        work::check()?;
        Ok(self.recognised.get_or_init(|| built))
    }

    /// The smallest upper limit of r that the profile has.
    pub fn limit(&self) -> f64 {
        *self.end.get_or_init(|| work::finished(|| self.with_ends(Barrier::first_end)))
    }

    /// The same, and where the profile is found to end at a place up to `at`, that place.
    pub(crate) fn limit_up_to(&self, at: f64) -> f64 {
        if self.barriers.is_empty() { self.limit() } else { self.with_ends(|own| own.end_up_to(at)).min(self.limit()) }
    }

    /// The smallest limit or end; an end that rounding alone puts below a limit is that limit.
    fn with_ends(&self, end: impl Fn(&Barrier) -> Option<f64>) -> f64 {
        let limit = self.limits.iter().copied().fold(f64::INFINITY, f64::min);
        let found = self.barriers.iter().filter_map(end).fold(limit, f64::min);
        if found > limit * (1.0 - SAME) { limit } else { found }
    }

    /// Every breakpoint below `end`, rising.
    pub fn breakpoints_below(&self, end: f64) -> Vec<f64> {
        let mut list: Vec<f64> =
            self.chains.iter().flat_map(|c| c.breakpoints.iter().map(|b| b.value)).filter(|b| *b > 0.0 && *b < end).collect();
        list.sort_by(f64::total_cmp);
        list.dedup();
        list
    }

    /// g(x).
    ///
    /// # Errors
    /// [`TransformError`]: outside the domain, no closed form where one is demanded, or no digits.
    pub fn slope(&self, x: f64) -> Result<Reading, TransformError> {
        self.check_domain("x", x)?;
        let integrate = |open: &NumericProfile| open.slope(x, self.tolerance);
        if self.method == Method::Quadrature {
            return self.integral_of(Superposed::Equivalent, x, integrate);
        }
        self.combine(Superposed::Equivalent, x, &[x], |open| integrate(open).map(Some)).and_then(|r| finite(r, "x", x))
    }

    /// F(a)/(2E*) under a smooth edge.
    ///
    /// # Errors
    /// As [`Self::slope`].
    pub fn force(&self, a: f64) -> Result<Reading, TransformError> {
        self.check_domain("a", a)?;
        let integrate = |open: &NumericProfile| open.force(a, self.tolerance);
        if self.method == Method::Quadrature {
            return self.integral_of(Superposed::Force, a, integrate);
        }
        self.combine(Superposed::Force, a, &[a], |open| integrate(open).map(Some)).and_then(|r| finite(r, "a", a))
    }

    /// g or F/(2E*) by quadrature alone: at once where f′ as typed has the digits, which is nearly always.
    #[inline]
    fn integral_of(
        &self,
        quantity: Superposed,
        at: f64,
        integrate: impl Fn(&NumericProfile) -> Result<Estimate, TransformError>,
    ) -> Result<Reading, TransformError> {
        let typed = self.typed().and_then(&integrate);
        match typed {
            Ok(own) if own.value.is_normal() && own.error <= self.tolerance * own.value.abs() => {
                Ok(Reading { estimate: own, method: "quadrature" })
            }
            typed => {
                let found = self.by_quadrature(quantity, at, &[at], typed.map(Some), |open| integrate(open).map(Some));
                found.and_then(|reading| finite(reading, quantity.coordinate(), at))
            }
        }
    }

    pub(crate) fn height_forms(&self) -> Result<&Heights, TransformError> {
        if let Some(ready) = self.heights.get() {
            return Ok(ready);
        }
        let radius = [Symbol::new("r")];
        let mut chains = Vec::new();
        // f(0) is taken away in the expression, where it may cancel before any rounding.
        let mut shift = -self.bindings.apply(&self.solution.profile.shift);
        for chain in &self.solution.profile.chains {
            let number = |b: &Expr| first_double_from(b, &self.bindings);
            let breakpoints = chain.breakpoints.iter().map(number).collect::<Result<Vec<_>, _>>()?;
            let compile = |piece: &Expr| ClosedForm::new(&(self.bindings.apply(piece) + &shift), &radius);
            chains.push((breakpoints, chain.pieces.iter().map(compile).collect::<Result<Vec<_>, _>>()?));
            shift = Expr::zero();
        }
        work::check()?;
        Ok(self.heights.get_or_init(|| Heights { chains }))
    }

    /// f(r) − f(0): the typed expression where it keeps its digits, else ∫₀^r f′ dr.
    ///
    /// # Errors
    /// As [`Self::slope`].
    pub fn height(&self, r: f64) -> Result<Reading, TransformError> {
        self.check_domain("r", r)?;
        let heights = self.height_forms()?;
        let mut forms = Vec::new();
        for (breakpoints, pieces) in &heights.chains {
            let Some(piece) = pieces.get(breakpoints.iter().filter(|b| **b <= r).count()) else {
                return Err(TransformError::OutOfDomain { symbol: "r", at: r, limit: String::new() });
            };
            forms.push(piece);
        }
        let estimate = Estimate::from_bounded(total(&forms, &[r], good_enough(self.tolerance)), 0);
        let plain = Reading { estimate, method: "exact" };
        if self.method != Method::Quadrature && (self.method == Method::Exact || estimate.relative_error() <= self.tolerance) {
            return finite(Some(plain), "r", r);
        }
        let other = Reading { estimate: self.typed()?.height(r, self.tolerance)?, method: "quadrature" };
        let better = if other.estimate.is_better_than(estimate) { other } else { plain };
        finite(Some(better), "r", r)
    }

    /// G(a) = ∫₀^a g dx: from the closed forms where that keeps its digits, else as one integral of its own.
    ///
    /// # Errors
    /// As [`Self::slope`].
    pub fn integral(&self, a: f64) -> Result<Reading, TransformError> {
        self.check_domain("a", a)?;
        if self.method != Method::Quadrature {
            let (slope, force) = (self.slope(a)?, self.force(a)?);
            let closed = Bounded::exact(a) * slope.estimate.bounded() - force.estimate.bounded();
            let (evaluations, bound) =
                (slope.estimate.evaluations + force.estimate.evaluations, slope.estimate.bound.and(force.estimate.bound));
            let closed = refined(closed, closed.value, good_enough(self.tolerance), || self.precise_integral(a).unwrap_or(Precise::nan()));
            let estimate = Estimate::from_bounded(closed, evaluations).resting_on(bound);
            let own = Reading { estimate, method: slope.method };
            if self.method == Method::Exact || estimate.relative_error() <= self.tolerance {
                return Ok(own);
            }
            let mut whole = self.typed()?.integral(a, self.tolerance);
            let is_poor = |own: &Result<Estimate, TransformError>| !own.as_ref().is_ok_and(|own| own.relative_error() <= self.tolerance);
            let beats = |other: &Estimate, own: &Result<Estimate, _>| own.as_ref().map_or(true, |own| other.is_better_than(*own));
            // What the typed f′ takes away from itself the recognised one has not.
            if is_poor(&whole)
                && let Ok(other) = self.recognised().and_then(|own| own.integral(a, self.tolerance))
                && beats(&other, &whole)
            {
                // Next to the end of a root the rounding of the nodes shows between them, which no difference of values tells in full.
                whole = Ok(Estimate { error: 2.0 * other.error, ..other });
            }
            if is_poor(&whole)
                && let Ok(series) = SeriesEvaluator::with(&self.solution.profile, &self.bindings, ORDER)
                && let Ok(Reading { estimate: series, .. }) = series.integral(a)
                && (series.value != 0.0 || series.error > 0.0)
                && beats(&series, &whole)
            {
                whole = Ok(series);
            }
            return match whole {
                Ok(whole) if whole.is_better_than(estimate) => Ok(Reading { estimate: whole, method: "quadrature" }),
                Err(error) if !estimate.error.is_finite() => Err(error),
                _ => Ok(own),
            };
        }
        Ok(Reading { estimate: self.typed()?.integral(a, self.tolerance)?, method: "quadrature" })
    }

    /// a g(a) − F/(2E*) with 30 digits, where nothing is left to integrate.
    fn precise_integral(&self, a: f64) -> Result<Precise, TransformError> {
        let (Some(slope), Some(force)) =
            (self.with_30_digits(Superposed::Equivalent, &[a])?, self.with_30_digits(Superposed::Force, &[a])?)
        else {
            return Ok(Precise::nan());
        };
        Ok(Precise::exact(a).mul(slope).sub(force))
    }

    /// The closed form with 30 digits: g(x) at `[x]`, F/(2E*) at `[a]`, p π/E* at `[r, a]`, r < a; `None` where something is left to integrate.
    ///
    /// # Errors
    /// [`TransformError`] where an answer cannot be compiled.
    pub fn with_30_digits(&self, quantity: Superposed, inputs: &[f64]) -> Result<Option<Precise>, TransformError> {
        let contact = inputs.last().copied().unwrap_or(0.0);
        let mut forms = Vec::new();
        for index in 0..self.chains.len() {
            let part = self.part(index, quantity)?;
            if !part.open.is_empty() {
                return Ok(None);
            }
            forms.extend(part.closed.get(self.interval(index, contact)).and_then(Option::as_ref));
        }
        Ok(Some(precise_total(&forms, inputs)))
    }

    /// u_z(r) outside a contact of radius a < r with a smooth edge.
    ///
    /// # Errors
    /// As [`Self::slope`].
    pub fn displacement(&self, r: f64, a: f64) -> Result<Reading, TransformError> {
        self.check_domain("a", a)?;
        beyond_the_edge("r", r, a)?;
        let found = self.combine(Superposed::Outside, a, &[r, a], |open| open.displacement(r, a, self.tolerance).map(Some));
        found.and_then(|reading| finite(reading, "r", r))
    }

    /// ∫₀^a g′(x) x(x²+3z²)/(x²+z²)² dx, which is −σ_zz(z)·π/E* on the axis under a smooth edge; always by quadrature.
    ///
    /// # Errors
    /// As [`Self::slope`]; [`TransformError::NoClosedForm`] where a closed form is demanded.
    pub fn axial(&self, z: f64, a: f64) -> Result<Reading, TransformError> {
        work::bounded(|| self.stress_on_axis(z, a))
    }

    fn stress_on_axis(&self, z: f64, a: f64) -> Result<Reading, TransformError> {
        self.check_domain("a", a)?;
        finite_and_not_negative("z", z)?;
        if z == 0.0 {
            let infinite = || TransformError::Statement { what: "z", got: z, accepted: "a depth z > 0 below the apex of a pointed tip" };
            return self.pressure(0.0, a)?.ok_or_else(infinite);
        }
        if self.method == Method::Exact {
            return Err(TransformError::NoClosedForm { quantity: "the stress below the surface" });
        }
        let estimate = self.typed()?.axial(z, a, self.tolerance);
        let poor = |own: &Estimate| own.relative_error() > self.tolerance;
        if estimate.as_ref().map_or(true, poor)
            && let Ok(other) = self.recognised().and_then(|own| own.axial(z, a, self.tolerance))
            && estimate.as_ref().map_or(true, |own| other.is_better_than(*own))
        {
            return Ok(Reading { estimate: other, method: "quadrature" });
        }
        Ok(Reading { estimate: estimate?, method: "quadrature" })
    }

    /// Refuses a place that is no length, or that the profile does not reach.
    ///
    /// # Errors
    /// [`TransformError::Statement`] for a place that is negative, infinite or NaN, [`TransformError::OutOfDomain`] at the limit of r and
    /// beyond it.
    pub fn check_domain(&self, symbol: &'static str, at: f64) -> Result<(), TransformError> {
        finite_and_not_negative(symbol, at)?;
        let limit = self.limit_up_to(at);
        if at >= limit {
            return Err(TransformError::OutOfDomain { symbol, at, limit: format!(", which ends at r = {limit}") });
        }
        Ok(())
    }

    /// The number of breakpoints of the chain below the contact's end; one that may be below it counts, because the
    /// formula beyond it carries the doubt in its error.
    pub(crate) fn interval(&self, chain: usize, contact: f64) -> usize {
        self.chains.get(chain).map_or(0, |c| c.breakpoints.iter().filter(|b| is_below(**b, contact)).count())
    }

    pub(crate) fn part(&self, index: usize, quantity: Superposed) -> Result<&Part, TransformError> {
        let (Some(numeric), Some(chain)) = (self.chains.get(index), self.solution.chains.get(index)) else {
            return Err(TransformError::NoClosedForm { quantity: quantity.name() });
        };
        let cell = match quantity {
            Superposed::Equivalent => &numeric.slope,
            Superposed::Force => &numeric.force,
            Superposed::Pressure => &numeric.pressure,
            Superposed::Outside => &numeric.outside,
        };
        if let Some(ready) = cell.get() {
            return Ok(ready);
        }
        let inputs: &[&str] = match quantity {
            Superposed::Equivalent => &["x"],
            Superposed::Force => &["a"],
            Superposed::Pressure | Superposed::Outside => &["r", "a"],
        };
        let symbols: Vec<Symbol> = inputs.iter().map(|name| Symbol::new(name)).collect();
        let mut closed = Vec::new();
        for interval in 0..chain.intervals.len() {
            let expr = self.bindings.apply(&chain.closed(interval, quantity, |pair| &pair.evaluated));
            let second =
                if has_30_digits(&expr) { expr.clone() } else { self.bindings.apply(&chain.closed(interval, quantity, for_second_pass)) };
            closed.push(if expr.is_zero() { None } else { Some(ClosedForm::with_second(&expr, second, &symbols)?) });
        }
        let open = chain.remainder(|term| quantity.is_open(term));
        let part = Part { closed, open: NumericProfile::new(&open, &self.bindings)? };
        // What was compiled after the budget was used up means nothing.
        work::check()?;
        Ok(cell.get_or_init(|| part))
    }
}

/// A value that theory makes infinite, or that left the domain, is an error where a number is needed.
fn finite(reading: Option<Reading>, symbol: &'static str, at: f64) -> Result<Reading, TransformError> {
    match reading {
        Some(reading) if reading.estimate.value.is_finite() && reading.estimate.error.is_finite() => Ok(reading),
        // A number without any bound is no answer.
        Some(reading) if reading.estimate.value.is_finite() => Err(TransformError::NotComputable { at }),
        Some(reading) if reading.estimate.value.is_infinite() => Err(TransformError::Overflow { symbol, at }),
        _ => Err(TransformError::OutOfDomain { symbol, at, limit: String::new() }),
    }
}
