//! Numbers from a solution: closed forms if they exist, quadrature for the remaining terms, and the error of both.

use crate::derive::closed_form::{ClosedForm, DOUBLES, THIRTY_DIGITS, for_second_pass, good_enough, precise_total, refined, total};
use crate::derive::domain::barrier::Barrier;
use crate::derive::engine::Solution;
use crate::derive::solved::SolvedInterval;
use crate::derive::superposed::Superposed;
use crate::eval::{constant_value, first_double_from, last_double_up_to};
use crate::evaluate::curve::PressureCurve;
use crate::evaluate::local_polynomials::PolynomialCache;
use crate::evaluate::ways::Way;
use crate::evaluate::ways::best::{Best, by_quadrature};
use crate::expr::{Bindings, Condition, Expr, Relation, Symbol, has_30_digits};
use crate::integrate::admit::{beyond_the_edge, finite_and_not_negative, tolerance_in_range};
use crate::integrate::ask::Ask;
use crate::integrate::error::TransformError;
use crate::integrate::integral::NumericProfile;
use crate::integrate::segment::Segment;
use crate::num::{Bounded, Estimate, Precise, work};
use crate::print::text_condition;
use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

/// Ends of the profile with a smaller relative distance are identified.
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
    /// One of [`WAYS`](crate::evaluate::ways::WAYS) alone.
    Only(&'static Way),
}

/// A number with its error and its method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Value, error bound and evaluations of f′.
    pub estimate: Estimate,
    /// `exact`, `quadrature`, `mixed` for a sum of closed terms and integrals, `series`, `curve`, or `root` for a solution of g(a) = d.
    pub method: &'static str,
}

impl Reading {
    /// The key of the way, or the method if no way was needed; a number without error that needed none is `exact`.
    pub fn way(&self) -> &'static str {
        match self.estimate.way {
            "" if self.estimate.error == 0.0 => "exact",
            "" => self.method,
            way => way,
        }
    }
}

/// A solution with numbers for its parameters, compiled for many points; it may be shared between threads.
pub struct Evaluator<'a> {
    pub(crate) solution: Cow<'a, Solution>,
    pub(crate) bindings: Bindings,
    pub(crate) chains: Vec<NumericChain>,
    pub(crate) limits: Vec<f64>,
    barriers: Vec<Barrier>,
    /// The smallest limit and the first end of a barrier.
    end: OnceLock<f64>,
    typed: OnceLock<Arc<NumericProfile>>,
    recognised: OnceLock<NumericProfile>,
    heights: OnceLock<Heights>,
    pub(crate) steep: OnceLock<bool>,
    /// The wave numbers of f.
    pub(crate) waves: OnceLock<Vec<Expr>>,
    pub(crate) polynomials: PolynomialCache,
    pub(crate) tolerance: f64,
    pub(crate) method: Method,
}

/// The typed f minus its value at the axis: the breakpoints and pieces of each chain.
pub(crate) struct Heights {
    pub(crate) chains: Vec<(Vec<f64>, Vec<ClosedForm>)>,
}

pub(crate) struct NumericChain {
    pub(crate) breakpoints: Vec<Bounded>,
    /// For each breakpoint, the largest double that is not beyond it.
    last_before: OnceLock<Vec<f64>>,
    equivalent: OnceLock<ClosedAndOpen>,
    force: OnceLock<ClosedAndOpen>,
    pressure: OnceLock<ClosedAndOpen>,
    outside: OnceLock<ClosedAndOpen>,
    axial: OnceLock<ClosedAndOpen>,
}

/// The closed expressions of one quantity, one per interval of the contact and `None` where it is 0, each compiled where a contact
/// first ends in its interval; and the part that remains to be integrated.
pub(crate) struct ClosedAndOpen {
    closed: Vec<OnceLock<Option<ClosedForm>>>,
    pub(crate) open: NumericProfile,
}

impl<'a> Evaluator<'a> {
    /// Binds the parameters to numbers; everything else is computed when needed.
    ///
    /// ```
    /// use sneddon::{expr::{Bindings, Expr}, parse, transform::{Evaluator, Method, Profile, derive}};
    /// let profile = Profile::new(&parse::profile("r^2/(2*R)").unwrap()).unwrap();
    /// let solution = derive(&profile).unwrap();
    /// let set = Bindings::one("R", Expr::integer(2));
    /// let evaluator = Evaluator::new(&solution, &set, Method::Auto, 1e-13).unwrap();
    /// assert_eq!(evaluator.equivalent(3.0).unwrap().estimate.value, 4.5);
    /// ```
    ///
    /// # Errors
    /// [`TransformError::Evaluation`] if a parameter has no value; [`TransformError::ConditionFails`] if the values break a condition of
    /// the profile on its parameters; [`TransformError::Statement`] for a tolerance outside (0, 1). Closed forms whose own conditions
    /// the values break are not used: their terms are integrated.
    pub fn new(solution: &'a Solution, bindings: &Bindings, method: Method, tolerance: f64) -> Result<Self, TransformError> {
        tolerance_in_range(tolerance)?;
        // The conditions on slope angles keep signs in formulas, which numbers do not need unless kinks depend on them.
        let is_needed = |own: &Condition| solution.profile.has_kinks() || !solution.profile.angle_conditions().contains(own);
        if let Some(broken) = solution.profile.conditions.iter().find(|own| is_broken(own, bindings) && is_needed(own)) {
            return Err(TransformError::ConditionFails { condition: text_condition(broken) });
        }
        let solution = solution.without_answers(|own| is_broken(own, bindings));
        let number = |expr: &Expr| constant_value(expr, bindings).map(|b| b.value);
        let mut chains = Vec::new();
        for chain in &solution.chains {
            let breakpoints = chain.breakpoints.iter().map(|b| constant_value(b, bindings)).collect::<Result<_, _>>()?;
            chains.push(NumericChain {
                breakpoints,
                last_before: OnceLock::new(),
                equivalent: OnceLock::new(),
                force: OnceLock::new(),
                pressure: OnceLock::new(),
                outside: OnceLock::new(),
                axial: OnceLock::new(),
            });
        }
        let limits = solution.profile.limits().map(number).collect::<Result<_, _>>()?;
        let barriers: Result<Vec<Barrier>, _> = solution.profile.demands.iter().map(|own| Barrier::new(own, bindings)).collect();
        let mut barriers = barriers?;
        barriers.sort_by(|one, other| one.lower().total_cmp(&other.lower()));
        Ok(Self {
            solution,
            bindings: bindings.clone(),
            chains,
            limits,
            barriers,
            end: OnceLock::new(),
            typed: OnceLock::new(),
            recognised: OnceLock::new(),
            heights: OnceLock::new(),
            steep: OnceLock::new(),
            waves: OnceLock::new(),
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
        self.shared().map(Arc::as_ref)
    }

    /// The pressure curve of the profile as typed under a contact of radius a.
    ///
    /// # Errors
    /// As [`PressureCurve::new`].
    pub(crate) fn pressure_curve(&self, a: f64) -> Result<PressureCurve<'static>, TransformError> {
        PressureCurve::shared(Arc::clone(self.shared()?), a)
    }

    fn shared(&self) -> Result<&Arc<NumericProfile>, TransformError> {
        if let Some(ready) = self.typed.get() {
            return Ok(ready);
        }
        let built = self.typed_profile()?;
        work::check()?;
        Ok(self.typed.get_or_init(|| Arc::new(built)))
    }

    /// The profile by the recognition form of f′.
    pub(crate) fn recognised(&self) -> Result<&NumericProfile, TransformError> {
        if let Some(ready) = self.recognised.get() {
            return Ok(ready);
        }
        let intervals = self.solution.chains.iter().flat_map(|chain| &chain.intervals);
        let f_prime = |interval: &SolvedInterval| Expr::sum(interval.terms.iter().map(|solved| solved.term.f_prime()));
        let pieces: Vec<(Segment, Expr)> = intervals.map(|interval| (interval.segment.clone(), f_prime(interval))).collect();
        let built = NumericProfile::new(&pieces, &self.bindings)?;
        work::check()?;
        Ok(self.recognised.get_or_init(|| built))
    }

    /// The smallest upper limit of r that the profile has.
    pub fn limit(&self) -> f64 {
        *self.end.get_or_init(|| work::finished(|| self.with_ends(|own, _| own.first_end())))
    }

    /// The smallest upper limit, or an end of the profile found numerically below `at`, if that is smaller.
    pub(crate) fn limit_up_to(&self, at: f64) -> f64 {
        if self.barriers.is_empty() { self.limit() } else { self.with_ends(|own, before| own.end_up_to(at.min(before))).min(self.limit()) }
    }

    /// The smallest limit or end; an end that lies below a limit only by rounding is replaced by the limit.
    ///
    /// `end` is called with the smallest one so far, beyond which no other counts.
    fn with_ends(&self, end: impl Fn(&Barrier, f64) -> Option<f64>) -> f64 {
        let limit = self.limits.iter().copied().fold(f64::INFINITY, f64::min);
        let narrowed =
            |found: f64, own: &Barrier| if own.lower() < found { end(own, found).map_or(found, |end| end.min(found)) } else { found };
        let found = self.barriers.iter().fold(limit, narrowed);
        if found > limit * (1.0 - SAME) { limit } else { found }
    }

    /// Every breakpoint below `end`, in increasing order.
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
    /// [`TransformError`]: outside the domain, without a required closed form, or without a reliable digit.
    pub fn equivalent(&self, x: f64) -> Result<Reading, TransformError> {
        self.number("x", Superposed::Equivalent, Ask::Equivalent(x))
    }

    /// F(a)/(2E*) under a smooth edge.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub fn force(&self, a: f64) -> Result<Reading, TransformError> {
        self.number("a", Superposed::Force, Ask::Force(a))
    }

    #[inline]
    fn number(&self, symbol: &'static str, quantity: Superposed, ask: Ask) -> Result<Reading, TransformError> {
        let at = ask.reach();
        self.check_domain(symbol, at)?;
        let found = match self.method {
            Method::Quadrature => return self.integral_of(symbol, ask),
            Method::Only(way) => way.answer(self, ask),
            Method::Auto | Method::Exact => self.combine(quantity, ask),
        };
        found.and_then(|reading| finite(reading, symbol, at))
    }

    /// g or F/(2E*) by quadrature alone, directly if the typed f′ is accurate, which is almost always the case.
    #[inline]
    fn integral_of(&self, symbol: &'static str, ask: Ask) -> Result<Reading, TransformError> {
        let typed = self.typed().and_then(|own| own.answer(ask, self.tolerance));
        match typed {
            Ok(Some(own)) if own.value.is_normal() && own.error <= self.tolerance * own.value.abs() => {
                Ok(Reading { estimate: own, method: "quadrature" })
            }
            typed => self.by_quadrature(ask, typed).and_then(|reading| finite(reading, symbol, ask.reach())),
        }
    }

    pub(crate) fn height_forms(&self) -> Result<&Heights, TransformError> {
        if let Some(ready) = self.heights.get() {
            return Ok(ready);
        }
        let radius = [Symbol::new("r")];
        let mut chains = Vec::new();
        // Subtract f(0) symbolically, so that it may cancel before any rounding.
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

    /// f(r) − f(0): the typed expression if it is accurate, else ∫₀^r f′ dr.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub fn height(&self, r: f64) -> Result<Reading, TransformError> {
        self.check_domain("r", r)?;
        if let Method::Only(way) = self.method {
            return way.answer(self, Ask::Height(r)).and_then(|found| finite(found, "r", r));
        }
        let estimate = total(&self.forms_of_height(r)?, &[r], good_enough(self.tolerance));
        let own = Ok(Some(Reading { estimate, method: "exact" }));
        let typed = || by_quadrature(self.typed()?.height(r, self.tolerance).map(Some));
        let found = match self.method {
            Method::Exact => own,
            // f′ is checked even if its values are not needed for the result.
            Method::Quadrature => Best::of(0.0, own).or(typed).answer(),
            _ => Best::of(self.tolerance, own).or(typed).or(|| self.by_series(Ask::Height(r))).answer(),
        };
        finite(found?, "r", r)
    }

    /// The pieces of f at r, one per chain.
    pub(crate) fn forms_of_height(&self, r: f64) -> Result<Vec<&ClosedForm>, TransformError> {
        let piece =
            |(breakpoints, pieces): &'_ (Vec<f64>, Vec<ClosedForm>)| breakpoints.iter().filter(|b| **b <= r).count().min(pieces.len());
        let chains = self.height_forms()?.chains.iter();
        let forms = chains.map(|own| own.1.get(piece(own)).ok_or(TransformError::OutOfDomain { symbol: "r", at: r, limit: String::new() }));
        forms.collect()
    }

    /// G(a) = ∫₀^a g dx: from the closed forms if that is accurate, else as a single integral.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub fn integral(&self, a: f64) -> Result<Reading, TransformError> {
        self.check_domain("a", a)?;
        let ask = Ask::Integral(a);
        let found = match self.method {
            Method::Only(way) => way.answer(self, ask),
            Method::Quadrature => return Ok(Reading { estimate: self.typed()?.integral(a, self.tolerance)?, method: "quadrature" }),
            Method::Exact => return self.integral_of_parts(a),
            Method::Auto => self.or_the_whole(self.integral_of_parts(a)?, ask),
        };
        finite(found?, "a", a)
    }

    /// a g(a) − F/(2E*), with 30 digits if the difference cancels and both terms are closed.
    pub(crate) fn integral_of_parts(&self, a: f64) -> Result<Reading, TransformError> {
        let (equivalent, force) = (self.equivalent(a)?, self.force(a)?);
        let closed = Bounded::exact(a) * equivalent.estimate.bounded() - force.estimate.bounded();
        // The methods of both terms.
        let both = equivalent.estimate + force.estimate;
        let precise = || self.precise_integral(a).unwrap_or((Precise::nan(), THIRTY_DIGITS));
        let closed = refined(closed, closed.value, good_enough(self.tolerance), precise);
        let way = if closed.way == DOUBLES { both.way } else { closed.way };
        let estimate = Estimate { evaluations: both.evaluations, bound: both.bound, way, ..closed };
        Ok(Reading { estimate, method: equivalent.method })
    }

    /// a g(a) − F/(2E*) with 30 digits, if both terms are closed.
    fn precise_integral(&self, a: f64) -> Result<(Precise, &'static str), TransformError> {
        let forms = |quantity| self.closed_forms(quantity, a);
        let (Some(equivalent), Some(force)) = (forms(Superposed::Equivalent)?, forms(Superposed::Force)?) else {
            return Ok((Precise::nan(), THIRTY_DIGITS));
        };
        let ((equivalent, way), (force, _)) = (precise_total(&equivalent, &[a]), precise_total(&force, &[a]));
        Ok((Precise::exact(a).mul(equivalent).sub(force), way))
    }

    /// The closed form with 30 digits: g(x) at `[x]`, F/(2E*) at `[a]`, p π/E* at `[r, a]`, r < a; `None` if an integral remains.
    ///
    /// # Errors
    /// [`TransformError`] if a closed form cannot be compiled.
    pub fn with_30_digits(&self, quantity: Superposed, inputs: &[f64]) -> Result<Option<Precise>, TransformError> {
        let forms = self.closed_forms(quantity, inputs.last().copied().unwrap_or(0.0))?;
        Ok(forms.map(|forms| precise_total(&forms, inputs).0))
    }

    /// The closed forms of every chain for a contact that ends at a radius; `None` if an integral remains.
    pub(crate) fn closed_forms(&self, quantity: Superposed, contact: f64) -> Result<Option<Vec<&ClosedForm>>, TransformError> {
        let mut forms = Vec::new();
        for index in 0..self.chains.len() {
            if !self.part(index, quantity)?.open.is_empty() {
                return Ok(None);
            }
            forms.extend(self.closed_form(index, self.interval(index, contact), quantity)?);
        }
        Ok(Some(forms))
    }

    /// u_z(r) outside a contact of radius a < r with a smooth edge.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
    pub fn displacement(&self, r: f64, a: f64) -> Result<Reading, TransformError> {
        self.check_domain("a", a)?;
        beyond_the_edge("r", r, a)?;
        let ask = Ask::Outside { r, a };
        let found = match self.method {
            Method::Only(way) => way.answer(self, ask),
            _ => self.combine(Superposed::Outside, ask),
        };
        found.and_then(|reading| finite(reading, "r", r))
    }

    /// ∫₀^a g′(x) x(x²+3z²)/(x²+z²)² dx, which is −σ_zz(z)·π/E* on the axis under a smooth edge.
    ///
    /// # Errors
    /// As [`Self::equivalent`].
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
        let ask = Ask::Axial { z, a };
        let found = match self.method {
            Method::Only(way) => way.answer(self, ask),
            Method::Auto if self.closed_forms(Superposed::Axial, a)?.is_none() => {
                // Samples may miss everything in an open term that the whole profile shows, and no bound on this integral is proven.
                let typed = by_quadrature(self.typed()?.axial(z, a, self.tolerance).map(Some));
                Best::of(self.tolerance, typed).or(|| self.by_recognition(ask)).answer()
            }
            _ => self.combine(Superposed::Axial, ask),
        };
        finite(found?, "z", z)
    }

    /// Refuses a coordinate that is not a length or lies outside the profile.
    ///
    /// # Errors
    /// [`TransformError::Statement`] for a coordinate that is negative, infinite or NaN, [`TransformError::OutOfDomain`] at and
    /// beyond the limit of r.
    pub fn check_domain(&self, symbol: &'static str, at: f64) -> Result<(), TransformError> {
        finite_and_not_negative(symbol, at)?;
        let limit = self.limit_up_to(at);
        if at >= limit {
            return Err(TransformError::OutOfDomain { symbol, at, limit: format!(", which ends at r = {limit}") });
        }
        Ok(())
    }

    /// The number of breakpoints of the chain below the contact's end.
    pub(crate) fn interval(&self, chain: usize, contact: f64) -> usize {
        self.last_before(chain).iter().filter(|b| **b < contact).count()
    }

    /// For each breakpoint of the chain, the largest double that is not beyond it.
    pub(crate) fn last_before(&self, chain: usize) -> &[f64] {
        let (Some(numeric), Some(solved)) = (self.chains.get(chain), self.solution.chains.get(chain)) else { return &[] };
        let last = |(expr, rounded): (&Expr, &Bounded)| last_double_up_to(expr, &self.bindings).unwrap_or(rounded.value);
        let list = || solved.breakpoints.iter().zip(&numeric.breakpoints).map(last).collect();
        numeric.last_before.get_or_init(|| work::prepared(list))
    }

    pub(crate) fn part(&self, index: usize, quantity: Superposed) -> Result<&ClosedAndOpen, TransformError> {
        let (Some(numeric), Some(chain)) = (self.chains.get(index), self.solution.chains.get(index)) else {
            return Err(TransformError::NoClosedForm { quantity: quantity.name() });
        };
        let cell = match quantity {
            Superposed::Equivalent => &numeric.equivalent,
            Superposed::Force => &numeric.force,
            Superposed::Pressure => &numeric.pressure,
            Superposed::Outside => &numeric.outside,
            Superposed::Axial => &numeric.axial,
        };
        if let Some(ready) = cell.get() {
            return Ok(ready);
        }
        let open = chain.remainder(|term| quantity.is_open(term));
        let closed = chain.intervals.iter().map(|_| OnceLock::new()).collect();
        let part = ClosedAndOpen { closed, open: NumericProfile::new(&open, &self.bindings)? };
        // What was built after the budget was exhausted is meaningless, here and below.
        work::check()?;
        Ok(cell.get_or_init(|| part))
    }

    /// The closed form of a chain for a contact that ends in an interval; `None` if it is 0.
    pub(crate) fn closed_form(&self, index: usize, interval: usize, quantity: Superposed) -> Result<Option<&ClosedForm>, TransformError> {
        let (Some(cell), Some(chain)) = (self.part(index, quantity)?.closed.get(interval), self.solution.chains.get(index)) else {
            return Ok(None);
        };
        if let Some(ready) = cell.get() {
            return Ok(ready.as_ref());
        }
        let inputs: &[&str] = match quantity {
            Superposed::Equivalent => &["x"],
            Superposed::Force => &["a"],
            Superposed::Pressure | Superposed::Outside => &["r", "a"],
            Superposed::Axial => &["z", "a"],
        };
        let symbols: Vec<Symbol> = inputs.iter().map(|name| Symbol::new(name)).collect();
        let expr = self.bindings.apply(&chain.closed(interval, quantity, |pair| &pair.evaluated));
        let second =
            if has_30_digits(&expr) { expr.clone() } else { self.bindings.apply(&chain.closed(interval, quantity, for_second_pass)) };
        let form = if expr.is_zero() { None } else { Some(ClosedForm::with_second(&expr, second, &symbols)?) };
        work::check()?;
        Ok(cell.get_or_init(|| form).as_ref())
    }
}

/// Returns an error for a value that is theoretically infinite or outside the domain.
fn finite(reading: Option<Reading>, symbol: &'static str, at: f64) -> Result<Reading, TransformError> {
    match reading {
        Some(reading) if reading.estimate.value.is_finite() && reading.estimate.error.is_finite() => Ok(reading),
        // A value without a finite error bound is refused.
        Some(reading) if reading.estimate.value.is_finite() => Err(TransformError::NotComputable { at }),
        Some(reading) if reading.estimate.value.is_infinite() => {
            Err(TransformError::Overflow { symbol, at, is_negative: reading.estimate.value < 0.0 })
        }
        _ => Err(TransformError::OutOfDomain { symbol, at, limit: String::new() }),
    }
}

/// Whether the parameters certainly break a condition; conditions that contain r are checked at each radius instead.
fn is_broken(condition: &Condition, bindings: &Bindings) -> bool {
    let (Ok(left), Ok(right)) = (constant_value(&condition.left, bindings), constant_value(&condition.right, bindings)) else {
        return false;
    };
    let difference = left - right;
    condition.relation != Relation::Equal && difference.value > difference.error
}
