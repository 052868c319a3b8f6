//! The numbers of a contact: depth, force, stiffness, pressure, displacement, energy and the inverse a(d).

use super::radius::features::Features;
use super::radius::{self, DepthSamples};
use super::{ContactError, Explicit};
use crate::num::quadrature::{Options, Panel, Point, integrate};
use crate::num::{Bounded, Estimate, NumError, work};
use crate::transform::{Evaluator, Quantities, Reading, TransformError, finite_and_not_negative};
use std::f64::consts::PI;
use std::marker::PhantomData;
use std::sync::Arc;

/// A contact with numbers for everything: the evaluator of its profile, E*, and the depth of a rim if there is one.
///
/// The profile may be a formula, a closure, a table, or any other type that implements [`Quantities`].
pub struct Contact<'a, P: Quantities + ?Sized = Evaluator<'a>> {
    evaluator: Arc<P>,
    formula: PhantomData<&'a ()>,
    effective_modulus: f64,
    depth: Option<f64>,
    tolerance: f64,
    /// Samples of g, shared by the contact radii of all depths.
    radii: Arc<DepthSamples>,
    /// The curvature of f, shared by all searches.
    pub(super) features: Arc<Features>,
    inverse: Inverse,
}

/// How a(d) is computed.
#[derive(Clone)]
enum Inverse {
    /// The root of g(a) = d.
    Root,
    /// The closed form; with `only`, also where its error exceeds the tolerance.
    Explicit { explicit: Arc<Explicit>, only: bool },
    /// A closed form is required but not available.
    Missing,
}

/// The largest number of values of g for one energy, and for each interval between kinks if these are many.
const MOST_NESTED: u64 = 5_000;
const MOST_BETWEEN_KINKS: u64 = 500;

/// Smallest radius at which g is evaluated for the energy, relative to the contact radius.
const NEAREST: f64 = 1e-30;

/// Largest radius, relative to that of the contact, below which g without a digit is bounded by g further out.
const NEAR_AXIS: f64 = 0.1;

/// Relative error above which an energy has no reliable digit.
const LARGEST_ERROR: f64 = 0.1;

/// A value, or the reason why it is infinite or undefined in theory.
pub type Measured = Result<Reading, Reason>;

/// Returns the reading, or an error if its value or its bound is not a finite double.
pub(super) fn representable(own: Reading, symbol: &'static str, at: f64) -> Result<Reading, ContactError> {
    let Estimate { value, error, .. } = own.estimate;
    if value.is_finite() && error.is_finite() {
        Ok(own)
    } else if value.is_infinite() {
        Err(TransformError::Overflow { symbol, at, is_negative: value < 0.0 }.into())
    } else if value.is_nan() {
        Err(TransformError::NotComputable { at }.into())
    } else {
        Err(TransformError::NoDigits { at, value, error }.into())
    }
}

/// Distances from a singularity, relative to the contact radius, at which the sign of its logarithm is determined.
const NEAR: [f64; 2] = [1e-8, 1e-12];

/// Why a quantity has no finite value at a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// The pressure diverges at the axis under a pointed tip.
    Apex,
    /// The pressure diverges where f′ jumps.
    Kink,
    /// The pressure is minus infinity at a concave apex.
    ConcaveApex,
    /// The pressure is minus infinity at a negative jump of f′.
    ConcaveKink,
    /// The pressure diverges at the rim of a punch.
    Rim,
    /// A mean over a contact without area.
    NoArea,
    /// The work budget was exhausted before the point was reached.
    Unfinished,
    /// An error at this point alone, such as a point outside the domain or an overflow.
    Refused(String),
}

impl Reason {
    /// The sentence for reports.
    pub fn text(&self) -> &str {
        match self {
            Self::Refused(why) => why,
            other => other.fixed_text().unwrap_or("the work limit was reached at this point"),
        }
    }

    /// The sentence of a value that is infinite or undefined in theory; `None` for the other reasons.
    pub(crate) fn fixed_text(&self) -> Option<&'static str> {
        Some(match self {
            Self::Apex => "the pressure is infinite at the apex of a pointed tip",
            Self::Kink => "the pressure is infinite at a kink of the profile",
            Self::ConcaveApex => "the pressure is minus infinity at a concave apex",
            Self::ConcaveKink => "the pressure is minus infinity at a concave kink of the profile",
            Self::NoArea => "the contact has no area",
            Self::Refused(_) | Self::Unfinished => return None,
            Self::Rim => "the pressure is infinite at the rim of a punch (as an inverse square root)",
        })
    }

    /// The infinite value of the pressure in theory; `None` for the other reasons.
    pub fn infinite_pressure(&self) -> Option<f64> {
        match self {
            Self::Apex | Self::Kink | Self::Rim => Some(f64::INFINITY),
            Self::ConcaveApex | Self::ConcaveKink => Some(f64::NEG_INFINITY),
            Self::NoArea | Self::Unfinished | Self::Refused(_) => None,
        }
    }

    /// The reason at radius r of a contact of radius a, from nearby pressures, which increase or decrease towards r.
    pub(crate) fn at_singularity(r: f64, a: f64, pressure: impl Fn(f64) -> Option<f64>) -> Self {
        let near = |gap: f64| if r + gap * a < a { pressure(r + gap * a) } else { pressure(r - gap * a) };
        let [far, near_by] = NEAR.map(near);
        Self::of_singularity(r, far.zip(near_by).is_some_and(|(far, near_by)| near_by < far))
    }

    /// The reason at radius r, where the pressure falls to minus infinity or rises.
    fn of_singularity(r: f64, falls: bool) -> Self {
        match (r == 0.0, falls) {
            (true, false) => Self::Apex,
            (false, false) => Self::Kink,
            (true, true) => Self::ConcaveApex,
            (false, true) => Self::ConcaveKink,
        }
    }
}

impl<P: Quantities> Contact<'_, P> {
    /// A contact of the evaluated profile with the effective modulus E* and, for a punch with a rim, its depth.
    ///
    /// ```
    /// use sneddon::contact::Contact;
    /// use sneddon::{expr::Bindings, parse, transform::{Evaluator, Method, Profile, derive}};
    /// let solution = derive(&Profile::new(&parse::profile("r^2/4").unwrap()).unwrap()).unwrap();
    /// let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
    /// let contact = Contact::new(evaluator, 3.0, None, 1e-13);
    /// // F = (4/3) E* a³/R with R = 2
    /// assert_eq!(contact.force(1.0).unwrap().estimate.value, 2.0);
    /// ```
    pub fn new(evaluator: P, effective_modulus: f64, depth: Option<f64>, tolerance: f64) -> Self {
        let (evaluator, radii, features) = (Arc::new(evaluator), Arc::default(), Arc::default());
        Self { evaluator, formula: PhantomData, effective_modulus, depth, tolerance, radii, features, inverse: Inverse::Root }
    }

    /// Returns the same contact with the type of its profile erased.
    pub(super) fn erased(&self) -> Contact<'_, dyn Quantities + '_> {
        Contact {
            evaluator: Arc::clone(&self.evaluator) as Arc<dyn Quantities + '_>,
            formula: PhantomData,
            effective_modulus: self.effective_modulus,
            depth: self.depth,
            tolerance: self.tolerance,
            radii: Arc::clone(&self.radii),
            features: Arc::clone(&self.features),
            inverse: self.inverse.clone(),
        }
    }
}

impl<P: Quantities + ?Sized> Contact<'_, P> {
    /// Returns the same contact with a closed form of a(d).
    ///
    /// [`Self::contact_radius`] evaluates the closed form, and searches for the root of g(a) = d where the error of the closed form exceeds the
    /// tolerance or its value is not finite. With `only`, the tolerance is ignored, and a missing closed form is an error.
    #[must_use]
    pub fn with_explicit(self, explicit: Option<Explicit>, only: bool) -> Self {
        let explicit = explicit.map(Arc::new);
        let inverse = match (explicit, only) {
            (Some(explicit), only) => Inverse::Explicit { explicit, only },
            (None, true) => Inverse::Missing,
            (None, false) => Inverse::Root,
        };
        Self { inverse, ..self }
    }

    /// The same contact at another depth of its rim, or with a smooth edge; the evaluator is shared.
    #[must_use]
    pub fn with_depth(&self, depth: Option<f64>) -> Self {
        Self {
            evaluator: Arc::clone(&self.evaluator),
            formula: PhantomData,
            effective_modulus: self.effective_modulus,
            depth,
            tolerance: self.tolerance,
            radii: Arc::clone(&self.radii),
            features: Arc::clone(&self.features),
            inverse: self.inverse.clone(),
        }
    }

    /// E*.
    pub fn effective_modulus(&self) -> f64 {
        self.effective_modulus
    }

    /// The profile's evaluator.
    pub fn evaluator(&self) -> &P {
        &self.evaluator
    }

    /// Returns the profile's evaluator as a shared pointer.
    pub fn shared_evaluator(&self) -> Arc<P> {
        Arc::clone(&self.evaluator)
    }

    /// The tolerance of roots and integrals.
    pub(super) fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// True for a punch with a rim at the contact radius.
    pub(super) fn has_rim(&self) -> bool {
        self.depth.is_some()
    }

    /// The given depth of a punch with a rim.
    pub(super) fn depth_of_rim(&self) -> Option<f64> {
        self.depth
    }

    /// f(r), shifted so that f(0) = 0.
    ///
    /// # Errors
    /// [`ContactError`] outside the domain.
    pub fn profile(&self, r: f64) -> Result<Reading, ContactError> {
        Ok(self.evaluator.height(r)?)
    }

    /// d: g(a) under a smooth edge (3.26), the given depth under a rim.
    ///
    /// # Errors
    /// Returns the errors of the evaluator.
    pub fn depth(&self, a: f64) -> Result<Reading, ContactError> {
        match self.depth {
            Some(depth) => Ok(exact(depth)),
            None => representable(self.evaluator.equivalent(a).map_err(TransformError::of_radius)?, "a", a),
        }
    }

    /// F = F_smooth(a) + 2E* a (d − g(a)) (3.22), (3.61).
    ///
    /// # Errors
    /// Returns the errors of the evaluator.
    pub fn force(&self, a: f64) -> Result<Reading, ContactError> {
        representable(self.any_force(a)?, "a", a)
    }

    /// Like [`Self::force`], but infinite if the force is too large for a double.
    pub(super) fn any_force(&self, a: f64) -> Result<Reading, ContactError> {
        let smooth = self.evaluator.force(a)?;
        let twice = Bounded::exact(2.0) * Bounded::exact(self.effective_modulus);
        let mut total = smooth.estimate.times(twice);
        if let Some(depth) = self.depth {
            let excess = Estimate::exact(depth) + self.evaluator.equivalent(a)?.estimate.scaled(-1.0);
            total = total + excess.scaled(a).times(twice);
        }
        Ok(Reading { estimate: total, method: smooth.method })
    }

    /// k = 2E*a (3.1), (3.22).
    ///
    /// # Errors
    /// [`ContactError`] for a radius outside the domain, or if k is too large for a number.
    pub fn stiffness(&self, a: f64) -> Result<Reading, ContactError> {
        self.evaluator.check_domain("a", a)?;
        let value = Bounded::exact(2.0) * Bounded::exact(self.effective_modulus) * Bounded::exact(a);
        if !value.is_finite() {
            return Err(TransformError::Overflow { symbol: "a", at: a, is_negative: false }.into());
        }
        Ok(Reading { estimate: Estimate::from_bounded(value, 0), method: "exact" })
    }

    /// F/(π a²); undefined for a contact without area.
    ///
    /// # Errors
    /// Returns the errors of the evaluator.
    pub fn mean_pressure(&self, a: f64) -> Result<Measured, ContactError> {
        if a == 0.0 {
            return Ok(Err(Reason::NoArea));
        }
        let force = self.force(a)?;
        let mean = over_area(force.estimate, Bounded::exact(a));
        if force.estimate.value.abs() < f64::MIN_POSITIVE && mean.error > mean.value.abs() {
            return Err(TransformError::Underflow { quantity: "the force", symbol: "a", at: a }.into());
        }
        representable(Reading { estimate: mean, ..force }, "a", a).map(Ok)
    }

    /// The displacement of the one-dimensional model, d − g(x) within the contact and 0 outside (3.7).
    ///
    /// # Errors
    /// Returns the errors of the evaluator.
    pub fn line_displacement(&self, x: f64, a: f64) -> Result<Reading, ContactError> {
        finite_and_not_negative("x", x)?;
        finite_and_not_negative("a", a)?;
        if x > a || (x == a && self.depth.is_none()) {
            return Ok(exact(0.0));
        }
        let (d, g) = (self.depth(a)?, self.evaluator.equivalent(x)?);
        Ok(Reading { estimate: d.estimate + g.estimate.scaled(-1.0), method: g.method })
    }

    /// The line load of the one-dimensional model, q(x) = E* (d − g(x)); F is its integral from −a to a.
    ///
    /// # Errors
    /// Returns the errors of the evaluator.
    pub fn line_load(&self, x: f64, a: f64) -> Result<Reading, ContactError> {
        let Reading { estimate, method } = self.line_displacement(x, a)?;
        representable(Reading { estimate: estimate.scaled(self.effective_modulus), method }, "x", x)
    }

    /// p(r), positive in compression: (E*/π)(∫_r^a g′/√(x²−r²) dx + (d − g(a))/√(a²−r²)) (3.37) with its edge term.
    ///
    /// # Errors
    /// Returns the errors of the evaluator.
    pub fn pressure(&self, r: f64, a: f64) -> Result<Measured, ContactError> {
        finite_and_not_negative("r", r)?;
        finite_and_not_negative("a", a)?;
        if r > a {
            return Ok(Ok(exact(0.0)));
        }
        let excess = match self.depth {
            Some(depth) => Estimate::exact(depth) + self.evaluator.equivalent(a)?.estimate.scaled(-1.0),
            None => Estimate::exact(0.0),
        };
        if r == a {
            return Ok(if excess.value == 0.0 { Ok(exact(0.0)) } else { Err(Reason::Rim) });
        }
        let Some(smooth) = self.evaluator.pressure(r, a)? else {
            return Ok(Err(self.singularity(r, a)));
        };
        let factor = Bounded::exact(self.effective_modulus) / Bounded::rounded(std::f64::consts::PI);
        let mut total = smooth.estimate;
        if self.depth.is_some() {
            // Multiply two roots, because the product of both lengths may leave the range of doubles.
            let (gap, sum) = (Bounded::exact(a) - Bounded::exact(r), Bounded::exact(a) + Bounded::exact(r));
            total = total + excess.times(Bounded::exact(1.0) / gap.sqrt() / sum.sqrt());
        }
        representable(Reading { estimate: total.times(factor), method: smooth.method }, "r", r).map(Ok)
    }

    /// Why the pressure at r is infinite.
    pub(super) fn singularity(&self, r: f64, a: f64) -> Reason {
        match self.f_prime_falls_at(r, a) {
            Some(falls) => Reason::of_singularity(r, falls),
            None => Reason::at_singularity(r, a, |r| Some(self.evaluator.pressure(r, a).ok()??.estimate.value)),
        }
    }

    /// Whether f′ falls at r, from 0 at the axis; `None` if bounds on f′ on both sides do not decide.
    fn f_prime_falls_at(&self, r: f64, a: f64) -> Option<bool> {
        let [_, gap] = NEAR.map(|gap| gap * a);
        let beyond = self.evaluator.f_prime_over(r + gap, r + 2.0 * gap)?;
        let before = if r == 0.0 { (0.0, 0.0) } else { self.evaluator.f_prime_over(r - 2.0 * gap, r - gap)? };
        let (falls, rises) = (beyond.1 < before.0, beyond.0 > before.1);
        (falls != rises).then_some(falls)
    }

    /// u_z(r): d − f(r) inside the contact, (2/π)∫₀^a (d − g)/√(r²−x²) dx outside.
    ///
    /// # Errors
    /// Returns the errors of the evaluator.
    pub fn displacement(&self, r: f64, a: f64) -> Result<Reading, ContactError> {
        let d = self.depth(a)?;
        if r <= a {
            let f = self.profile(r)?;
            return Ok(Reading { estimate: d.estimate + f.estimate.scaled(-1.0), method: d.method });
        }
        let smooth = self.evaluator.displacement(r, a)?;
        let mut total = smooth.estimate;
        if let Some(depth) = self.depth {
            let excess = Estimate::exact(depth) + self.evaluator.equivalent(a)?.estimate.scaled(-1.0);
            let angle = (Bounded::exact(a) / Bounded::exact(r)).apply(f64::asin, 2.0);
            total = total + excess.times(angle * Bounded::exact(2.0) / Bounded::rounded(std::f64::consts::PI));
        }
        representable(Reading { estimate: total, method: smooth.method }, "r", r)
    }

    /// G(a) = ∫₀^a g dx.
    ///
    /// # Errors
    /// Returns the errors of the evaluator.
    pub fn integral(&self, a: f64) -> Result<Reading, ContactError> {
        representable(self.evaluator.integral(a)?, "x", a)
    }

    /// The strain energy U = E* ∫₀^a (d − g)² dx of the whole profile; it does not superpose.
    ///
    /// # Errors
    /// Returns the errors of the evaluator.
    pub fn energy(&self, a: f64) -> Result<Reading, ContactError> {
        let found = representable(work::bounded(|| self.nested_energy(a))?, "a", a)?;
        let Estimate { value, error, .. } = found.estimate;
        // Nothing cancels in the integral of a square; below the normal numbers the error is that of the range of doubles.
        let lost = value >= f64::MIN_POSITIVE && error > LARGEST_ERROR * value;
        if lost { Err(TransformError::NoDigits { at: a, value, error }.into()) } else { Ok(found) }
    }

    fn nested_energy(&self, a: f64) -> Result<Reading, ContactError> {
        let depth = self.depth(a)?.estimate;
        let d = depth.bounded();
        if !(d.value * (d.value * a)).is_finite() {
            return Err(TransformError::Overflow { symbol: "a", at: a, is_negative: false }.into());
        }
        if let Some(own) = self.evaluator.squared_gap(a, d) {
            let Reading { estimate, method } = own?;
            return Ok(Reading { estimate: charge_underflow(estimate, d, a).scaled(self.effective_modulus), method });
        }
        let mut failure = None;
        let mut inner = 0;
        let mut integrand = |point: Point| match self.near_axis(point.x.max(NEAREST * a), a) {
            Ok(g) => {
                inner += g.evaluations;
                let gap = d - g.bounded();
                gap * gap
            }
            Err(error) => {
                failure.get_or_insert(error);
                Bounded::exact(f64::NAN)
            }
        };
        let mut places = vec![0.0];
        places.extend(self.evaluator.breakpoints_below(a));
        places.push(a);
        let panels: Vec<Panel> = places.windows(2).filter_map(|p| Some(Panel::singular(*p.first()?, *p.last()?))).collect();
        // Limit the evaluations, because each may be a quadrature.
        let most = MOST_NESTED.max(MOST_BETWEEN_KINKS * panels.len() as u64);
        let options = Options { rel_tol: self.tolerance, max_evaluations: most, ..Options::default() };
        let found = match integrate(&mut integrand, &panels, &options) {
            Ok(found) => found,
            Err(
                NumError::ToleranceNotReached { value, error, evaluations, .. } | NumError::EvaluationLimit { value, error, evaluations },
            ) if error.is_finite() => Estimate::estimated(value, error, evaluations),
            Err(other) => return Err(failure.map_or_else(|| other.into(), Into::into)),
        };
        let total = charge_underflow(found, d, a).scaled(self.effective_modulus).by(depth.way);
        Ok(Reading { estimate: Estimate { evaluations: found.evaluations + inner, ..total }, method: "quadrature" })
    }

    /// Returns g(x), or 0 with the size of g at a larger radius as its error if rounding leaves g(x) no accurate digit.
    fn near_axis(&self, x: f64, a: f64) -> Result<Estimate, TransformError> {
        let mut found = self.evaluator.equivalent(x).map(|own| own.estimate);
        let mut place = x;
        while matches!(found, Err(TransformError::NoDigits { .. })) && place < NEAR_AXIS * a {
            place *= 10.0;
            let size = |own: Reading| Estimate::estimated(0.0, own.estimate.value.abs() + own.estimate.error, own.estimate.evaluations);
            found = self.evaluator.equivalent(place).map(size);
        }
        found
    }

    /// a(d): the first root of g(a) = d beyond the flat part of the tip.
    ///
    /// The search samples g on a logarithmic grid that is refined where g is not a power law, and at the local maxima of g.
    /// The result does not depend on the unit of length.
    ///
    /// # Errors
    /// [`ContactError::Unreachable`] if no contact radius exists, which enclosures of f′ prove; [`ContactError::NotFound`] if the search
    /// finds none but cannot exclude one.
    pub fn contact_radius(&self, depth: f64) -> Result<Reading, ContactError> {
        match &self.inverse {
            Inverse::Explicit { explicit, only } => match explicit.contact_radius_at(depth) {
                Err(error) if *only => return Err(TransformError::from(error).into()),
                Ok(found) if found.estimate.value.is_finite() && (*only || found.estimate.relative_error() <= self.tolerance) => {
                    return Ok(found);
                }
                _ => {}
            },
            Inverse::Missing => return Err(TransformError::NoClosedForm { quantity: "a" }.into()),
            Inverse::Root => {}
        }
        work::bounded(|| radius::of_depth(self, &self.radii, depth))
    }

    /// A = πa².
    ///
    /// # Errors
    /// [`ContactError`] for a radius outside the domain, or if A is too large for a number.
    pub fn area(&self, a: f64) -> Result<Reading, ContactError> {
        self.evaluator.check_domain("a", a)?;
        let area = Bounded::rounded(PI) * Bounded::exact(a) * Bounded::exact(a);
        representable(Reading { estimate: Estimate::from_bounded(area, 0), method: "exact" }, "a", a)
    }

    /// F(d), the force at the contact radius a(d).
    ///
    /// # Errors
    /// As [`Self::contact_radius`] and [`Self::force`].
    pub fn force_of_depth(&self, depth: f64) -> Result<Reading, ContactError> {
        let radius = self.contact_radius(depth)?;
        let gap = |a: f64| Ok(Estimate::exact(depth) + self.evaluator.equivalent(a)?.estimate.scaled(-1.0));
        let force = self.with_depth(Some(depth));
        let corrected = |a: f64| force.force(a);
        to_second_order(&radius, corrected, gap, 2.0 * self.effective_modulus).unwrap_or_else(|| through(radius, |a| self.force(a)))
    }

    /// d(F), the depth at the contact radius a(F).
    ///
    /// # Errors
    /// As [`Self::radius_under_force`] and [`Self::depth`].
    pub fn depth_of_force(&self, force: f64) -> Result<Reading, ContactError> {
        let radius = self.radius_under_force(force)?;
        let lack = |a: f64| Ok(Estimate::exact(force) + self.force(a)?.estimate.scaled(-1.0));
        let a = radius.estimate.value;
        let stiffness = Bounded::exact(2.0) * Bounded::exact(self.effective_modulus) * Bounded::exact(a);
        let corrected = |a: f64| {
            let own = self.depth(a)?;
            Ok(Reading { estimate: own.estimate + lack(a)?.times(Bounded::exact(1.0) / stiffness), ..own })
        };
        to_second_order(&radius, corrected, lack, 1.0 / (stiffness.value * a)).unwrap_or_else(|| through(radius, |a| self.depth(a)))
    }
}

/// Returns F/(πa²) without the area itself, which may leave the range of doubles.
pub(super) fn over_area(force: Estimate, a: Bounded) -> Estimate {
    let reciprocal = |length: Bounded| Bounded::exact(1.0) / length;
    force.times(reciprocal(a)).times(reciprocal(Bounded::rounded(PI) * a))
}

/// Evaluates F or d at a radius with an error, in a form that is right to second order in that error: F(a) + 2E*a (d − g(a)), or
/// g(a) + (F − F(a))/(2E*a). Both are off by `weight` times ∫ (x − a) of the derivative of the load, hence by at most `weight` times the error
/// of the radius times `residual`, the distance of the load from that at the radius.
///
/// Returns `None` where the radius has no error, or where a value is missing or not finite.
fn to_second_order(
    radius: &Reading,
    corrected: impl Fn(f64) -> Result<Reading, ContactError>,
    residual: impl Fn(f64) -> Result<Estimate, ContactError>,
    weight: f64,
) -> Option<Result<Reading, ContactError>> {
    let Estimate { value: a, error, bound, .. } = radius.estimate;
    if a == 0.0 || error == 0.0 {
        return None;
    }
    let (step, _) = step_of(a, error);
    let own = corrected(a).ok()?;
    let off = |place: f64| residual(place).ok().map(|own| own.value.abs() + own.error);
    // Near the end of the profile, only one side may be available.
    let (here, below) = (off(a)?, off((a - step).max(0.0))?);
    let above = off(a + step).unwrap_or(2.0 * below);
    let spread = here.max(below).max(above);
    let estimate = Estimate { error: (own.estimate.error + weight * error * spread) * (1.0 + 8.0 * f64::EPSILON), ..own.estimate };
    let method = if radius.method == "root" { radius.method } else { own.method };
    let is_finite = estimate.value.is_finite() && estimate.error.is_finite();
    is_finite.then(|| Ok(Reading { estimate: estimate.resting_on(bound), method }))
}

/// Evaluates a quantity at a radius with an error; the change of the quantity within that error is added to the error.
fn through(radius: Reading, quantity: impl Fn(f64) -> Result<Reading, ContactError>) -> Result<Reading, ContactError> {
    let Estimate { value: a, error, bound, .. } = radius.estimate;
    let own = quantity(a)?;
    let method = if radius.method == "root" { radius.method } else { own.method };
    if a == 0.0 || error == 0.0 {
        return Ok(Reading { estimate: own.estimate.resting_on(bound), method });
    }
    let (step, share) = step_of(a, error);
    let moved = |place: f64| {
        let change = |found: Reading| (found.estimate.value - own.estimate.value).abs() + found.estimate.error + own.estimate.error;
        quantity(place).map(|found| share * change(found))
    };
    // Near the end of the profile, only one side may be available.
    let below = moved((a - step).max(0.0))?;
    let above = moved(a + step).unwrap_or(2.0 * below);
    let estimate = Estimate { error: (own.estimate.error + below.max(above)) * (1.0 + 8.0 * f64::EPSILON), ..own.estimate };
    Ok(Reading { estimate: estimate.resting_on(bound), method })
}

/// Returns a step of at least `error` and at least the spacing of doubles at `a`, and the ratio of `error` to that step.
///
/// Adding a smaller error to `a` would leave `a` unchanged.
pub(crate) fn step_of(a: f64, error: f64) -> (f64, f64) {
    let step = error.max(a.next_up() - a);
    (step, error / step)
}

/// Adds to ∫₀^a (d − g)² dx the error of squares that underflow, if the integral is 0.
fn charge_underflow(squared: Estimate, d: Bounded, a: f64) -> Estimate {
    let underflows = squared.value == 0.0 && (d.value != 0.0 || d.error != 0.0);
    let lost = if underflows { f64::from_bits(1) * a.max(1.0) } else { 0.0 };
    Estimate { error: squared.error.max(lost), ..squared }
}

fn exact(value: f64) -> Reading {
    Reading { estimate: Estimate::exact(value), method: "exact" }
}
