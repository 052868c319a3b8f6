//! An indentation: from the depth, the force or the contact radius to the other two, with a verdict on the validity of the
//! solution.

mod body;
pub(super) mod cells;
pub(super) mod curvature;
mod errors;
mod landscape;
mod naming;
mod proof;
mod root;
mod verdict;

pub use body::Body;
pub use errors::Estimates;
pub use naming::{Naming, in_unit};
pub use verdict::{Finding, Severity};

use super::radius::NoRadius;
use super::radius::unreachable::stays_below;
use super::{Contact, ContactError, Explicit, explicit};
use crate::expr::{Bindings, Symbol};
use crate::num::work;
use crate::transform::{ClosedForm, Evaluator, Method, Quantities, Reading, Slopes, Solution, Superposition};
use curvature::Curvature;
use landscape::Landscape;
use root::{Follower, Horizon};
use std::sync::Arc;
use verdict::Known;

/// One load of an indentation; lengths, forces and moduli are numbers of one consistent system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Load {
    /// The displacement of the indenter at r = 0.
    Depth(f64),
    /// The normal force.
    Force(f64),
    /// The contact radius.
    Radius(f64),
}

/// The edge of the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Boundary {
    /// The bodies do not touch.
    Apart,
    /// The profile leaves the surface smoothly: d = g(a).
    Smooth,
    /// The contact reaches the vertical side of the indenter: a = c, and d is free.
    Rim,
}

/// A solved load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// The displacement at r = 0.
    pub depth: f64,
    /// The normal force.
    pub force: f64,
    /// The contact radius.
    pub radius: f64,
    /// The edge of the contact.
    pub boundary: Boundary,
}

/// A state with all findings about it, or the reason why a state does not exist.
#[derive(Clone, Debug, PartialEq)]
pub struct Indented {
    /// The state; `None` if the load has no contact.
    pub state: Option<State>,
    /// Errors and warnings.
    pub findings: Vec<Finding>,
    /// The number of radii at which pressure and gap, or quantities that determine their signs, were evaluated without a proof
    /// that they are nowhere negative. `None` if the verdict is proven.
    pub radii: Option<u64>,
}

impl Indented {
    /// True if the state is the solution, that is, if no finding is an error.
    pub fn is_valid(&self) -> bool {
        self.state.is_some() && self.findings.iter().all(|finding| finding.severity != Severity::Error)
    }
}

/// The setup of an indentation: the effective modulus, the radius of the rim of a cylinder, and the numerical method.
#[derive(Clone, Copy, Debug)]
pub struct Setup {
    /// E* in units of pressure.
    pub effective_modulus: f64,
    /// The radius of a vertical side; `None` for a profile without a rim.
    pub rim: Option<f64>,
    /// The relative tolerance of quadratures.
    pub tolerance: f64,
    /// The numerical method.
    pub method: Method,
}

/// A frictionless indentation of an elastic half-space, ready for many loads.
///
/// ```
/// use sneddon::contact::{Indentation, Load, Setup};
/// use sneddon::{parse, transform::{Method, Profile, derive}};
/// let solution = derive(&Profile::new(&parse::profile("r^2/(2*10)").unwrap()).unwrap()).unwrap();
/// let setup = Setup { effective_modulus: 3.0, rim: None, tolerance: 1e-12, method: Method::Auto };
/// let indentation = Indentation::new(&solution, setup, Load::Depth(0.1)).unwrap();
/// let state = indentation.solve(Load::Depth(0.1)).unwrap().state.unwrap();
/// // a = √(R d), F = (4/3) E* √R d^(3/2)
/// assert_eq!(state.radius, 1.0);
/// assert!((state.force - 4.0 * 10f64.sqrt() * 0.1f64.powf(1.5)).abs() < 1e-15);
/// ```
pub struct Indentation<'a> {
    contact: Contact<'a, Superposition<'a>>,
    setup: Setup,
    landscape: Landscape<'a>,
    explicit: Option<(ClosedForm, ClosedForm)>,
    follower: Follower,
    known: Known,
    at_rim: Option<AtRim>,
    naming: Naming,
    /// Whether findings state the radius at which they begin, and every verdict is proven if possible.
    is_detailed: bool,
    /// The body that is too steep for a half-space, and the first such radius.
    steep: Option<(&'static str, f64)>,
}

/// A profile that is not a formula, with its transforms and its derivatives.
#[derive(Clone)]
pub struct Part<'a> {
    quantities: Arc<dyn Quantities + 'a>,
    slopes: Arc<dyn Slopes + 'a>,
}

impl<'a> Part<'a> {
    /// A profile that may be shared between several indentations.
    pub fn new(shape: Arc<impl Quantities + Slopes + 'a>) -> Self {
        Self { quantities: shape.clone(), slopes: shape }
    }
}

/// Quantities at the rim that do not depend on the load.
#[derive(Clone, Copy, Debug)]
struct AtRim {
    radius: f64,
    /// g(c).
    equivalent: f64,
    /// F of a smooth contact of radius c.
    force: f64,
}

impl<'a> Indentation<'a> {
    /// Examines the profile; `largest` is the largest expected load.
    ///
    /// # Errors
    /// [`ContactError`] if the profile cannot be evaluated, or requires a rim.
    pub fn new(solution: &'a Solution, setup: Setup, largest: Load) -> Result<Self, ContactError> {
        Self::beside(Some(solution), Vec::new(), setup, largest)
    }

    /// A profile that is not a formula: a table of points, a closure, or any type that implements both traits.
    ///
    /// ```
    /// use sneddon::contact::{Indentation, Load, Setup};
    /// use sneddon::transform::{Interpolation, Method, Profile};
    /// let r: Vec<f64> = (0..=40).map(|i| 0.05 * f64::from(i)).collect();
    /// let z: Vec<f64> = r.iter().map(|r| r * r / 4.0).collect();
    /// let tip = Profile::from_points(&r, &z, Interpolation::MonotoneCubic).unwrap();
    /// let setup = Setup { effective_modulus: 3.0, rim: None, tolerance: 1e-12, method: Method::Auto };
    /// let indentation = Indentation::of(tip, setup, Load::Depth(0.5)).unwrap();
    /// // a = √(R d) with R = 2
    /// let found = indentation.solve(Load::Depth(0.5)).unwrap();
    /// assert!(found.is_valid() && (found.state.unwrap().radius - 1.0).abs() < 1e-14);
    /// ```
    ///
    /// # Errors
    /// As [`Indentation::new`].
    pub fn of(shape: impl Quantities + Slopes + 'a, setup: Setup, largest: Load) -> Result<Self, ContactError> {
        Self::beside(None, vec![Part::new(Arc::new(shape))], setup, largest)
    }

    /// An optional formula, and the profiles added to it.
    ///
    /// # Errors
    /// As [`Indentation::new`].
    pub fn beside(solution: Option<&'a Solution>, others: Vec<Part<'a>>, setup: Setup, largest: Load) -> Result<Self, ContactError> {
        Self::between(&[], solution, others, setup, largest)
    }

    /// The same for a profile that is the sum of several bodies, whose separate slopes and ends are checked because they may cancel
    /// in the sum.
    ///
    /// # Errors
    /// As [`Indentation::new`].
    pub fn between(
        bodies: &[Body<'_>],
        solution: Option<&'a Solution>,
        others: Vec<Part<'a>>,
        setup: Setup,
        largest: Load,
    ) -> Result<Self, ContactError> {
        work::bounded(|| Self::look(bodies, solution, others, setup, largest))
    }

    fn look(
        bodies: &[Body<'_>],
        solution: Option<&'a Solution>,
        others: Vec<Part<'a>>,
        setup: Setup,
        largest: Load,
    ) -> Result<Self, ContactError> {
        // A flat formula does not contribute to a table.
        let formula = solution.filter(|own| others.is_empty() || !own.profile.is_flat());
        let is_flat = formula.is_none_or(|own| own.profile.is_flat()) && others.iter().all(|part| part.slopes.is_flat());
        let (mut parts, slopes): (Vec<_>, Vec<_>) = others.into_iter().map(|part| (part.quantities, part.slopes)).unzip();
        let alone = parts.is_empty();
        let mut curvature = Curvature::of(slopes);
        if let Some(own) = formula {
            parts.insert(0, Arc::new(Evaluator::new(own, &Bindings::default(), setup.method, setup.tolerance)?));
            curvature = curvature.with(&own.profile)?;
        }
        let end = bodies.iter().map(Body::end).fold(f64::INFINITY, f64::min);
        let evaluator = Superposition::new(parts).ending_at(end);
        if let Some(c) = setup.rim {
            if c.is_nan() || c <= 0.0 {
                return Err(ContactError::Missing { quantity: "a cylinder", needs: "a positive radius" });
            }
            evaluator.check_domain("radius", c)?;
        } else if is_flat {
            return Err(ContactError::Missing { quantity: "a flat punch", needs: "a radius: the vertical side of the indenter" });
        }
        let contact = Contact::new(evaluator, setup.effective_modulus, None, setup.tolerance);
        let horizon = Horizon::of(&contact, &curvature, setup.rim, largest);
        let landscape = Landscape::new(contact.evaluator(), curvature, setup.rim, &horizon)?;
        let own = landscape.steep.map(|at| ("the profile", at));
        let steep = if bodies.is_empty() {
            own
        } else {
            let each = bodies.iter().filter_map(|body| body.steep(&landscape.places));
            each.min_by(|one, other| one.1.total_cmp(&other.1))
        };
        if setup.rim.is_none() && !landscape.rising && landscape.samples.iter().all(|(_, g)| *g <= 0.0) {
            return Err(ContactError::Missing { quantity: "a concave profile", needs: "a radius: the vertical side of the indenter" });
        }
        let at_rim = match setup.rim {
            Some(radius) if is_flat => Some(AtRim { radius, equivalent: 0.0, force: 0.0 }),
            Some(radius) => {
                let force = contact.any_force(radius)?.estimate.value;
                Some(AtRim { radius, equivalent: contact.evaluator().equivalent(radius)?.estimate.value, force })
            }
            None => None,
        };
        let compiled = |own: Explicit| {
            let inputs = [Symbol::new("d"), Symbol::new("E")];
            Some((ClosedForm::new(&own.contact_radius, &inputs).ok()?, ClosedForm::new(&own.force, &inputs).ok()?))
        };
        let wanted = landscape.rising && setup.method != Method::Quadrature && matches!(largest, Load::Depth(_));
        let explicit = formula.filter(|_| wanted && alone).and_then(explicit).and_then(compiled);
        Ok(Self {
            contact,
            setup,
            landscape,
            explicit,
            follower: Follower::default(),
            known: Known::default(),
            at_rim,
            naming: Naming::default(),
            is_detailed: true,
            steep,
        })
    }

    /// Sets the units of lengths and forces in findings.
    #[must_use]
    pub fn naming(self, naming: Naming) -> Self {
        Self { naming, ..self }
    }

    /// Omits the searches for the radius at which an overlap or a tension begins, for callers that need only the verdict.
    #[must_use]
    pub fn without_details(self) -> Self {
        Self { is_detailed: false, ..self }
    }

    /// Solves one load.
    ///
    /// # Errors
    /// [`ContactError`] for a negative force or radius, or if a number cannot be computed; an unreachable load is a finding.
    pub fn solve(&self, load: Load) -> Result<Indented, ContactError> {
        work::bounded(|| match load {
            Load::Depth(depth) => self.at_depth(depth),
            Load::Force(force) => self.at_force(force),
            Load::Radius(radius) => self.at_radius(radius),
        })
    }

    /// The contact of a state, for pressure, displacement and energy.
    pub fn contact(&self, state: &State) -> Contact<'a, Superposition<'a>> {
        // Near the flat part of a worn tip, the rounding of a changes g(a) by more than the rounding of d; the edge term compensates
        // this to first order.
        let flat = self.landscape.flat;
        let fixed = state.boundary == Boundary::Rim || (flat > 0.0 && state.radius - flat < 1e-6 * flat);
        self.contact.with_depth(fixed.then_some(state.depth))
    }

    /// The contact with a smooth edge, for quantities of the shape.
    pub fn shape(&self) -> &Contact<'a, Superposition<'a>> {
        &self.contact
    }

    /// The depth at which the bodies first touch, at most 0: the smallest f.
    pub fn first_touch(&self) -> f64 {
        self.landscape.lowest
    }

    /// The radii and heights of the jumps of f′, in increasing order.
    pub fn kinks(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.landscape.kinks.iter().map(|kink| (kink.at, kink.jump))
    }

    /// The radius of the vertical side.
    pub fn rim(&self) -> Option<f64> {
        self.setup.rim
    }

    fn no_contact(depth: f64) -> Indented {
        Indented { state: Some(State { depth, force: 0.0, radius: 0.0, boundary: Boundary::Apart }), findings: Vec::new(), radii: None }
    }

    fn at_depth(&self, depth: f64) -> Result<Indented, ContactError> {
        let touch = self.landscape.lowest;
        // A concave shape at first contact carries no force.
        if depth.is_nan() || depth < touch || (depth == touch && touch < 0.0) {
            return Ok(Self::no_contact(depth));
        }
        if depth == touch && depth == 0.0 {
            let radius = if self.contact.evaluator().breakpoints_below(f64::INFINITY).is_empty() { 0.0 } else { self.landscape.flat };
            let (radius, boundary) = match self.at_rim {
                Some(rim) if rim.equivalent == 0.0 && rim.force == 0.0 => (rim.radius, Boundary::Rim),
                _ => (radius, Boundary::Smooth),
            };
            return Ok(Indented { state: Some(State { depth, force: 0.0, radius, boundary }), findings: Vec::new(), radii: None });
        }
        let mut candidates = Vec::new();
        if let Some(rim) = self.at_rim
            && depth >= rim.equivalent
        {
            let excess = depth - rim.equivalent;
            let force = rim.force + 2.0 * self.setup.effective_modulus * rim.radius * excess;
            // At d = g(c) the edge is still smooth.
            let boundary = if excess == 0.0 && rim.equivalent > 0.0 { Boundary::Smooth } else { Boundary::Rim };
            let state = State { depth, force, radius: rim.radius, boundary };
            if self.landscape.rising {
                return Ok(self.judged(state));
            }
            candidates.push(state);
        }
        if let Some((radius, force)) = &self.explicit {
            let (a, f) = (radius.value(&[depth, 1.0]), force.value(&[depth, self.setup.effective_modulus]));
            let reached = a.value < self.contact.evaluator().limit() && self.setup.rim.is_none_or(|c| a.value <= c);
            if a.value.is_finite() && f.value.is_finite() && reached {
                return Ok(self.judged(State { depth, force: f.value, radius: a.value, boundary: Boundary::Smooth }));
            }
        }
        let found = self.smooth_at_depth(depth)?;
        let nothing = found.is_empty() && candidates.is_empty();
        candidates.splice(0..0, found);
        if nothing {
            let named = self.naming.length(depth);
            return Ok(unreachable(match stays_below(self.contact.evaluator(), depth) {
                Some(NoRadius::Proven(reason)) => format!("no contact radius belongs to d = {named}: {reason}"),
                Some(NoRadius::Unproven(reason)) => format!("no contact radius was found for d = {named}: {reason}"),
                None => format!("no contact radius was found for d = {named}: g does not reach this depth {}", self.how_far()),
            }));
        }
        Ok(self.chosen(&candidates))
    }

    fn at_force(&self, force: f64) -> Result<Indented, ContactError> {
        if force.is_nan() || force < 0.0 {
            return Err(ContactError::Missing { quantity: "a negative force", needs: "adhesion, which is not modelled; expected F >= 0" });
        }
        if force == 0.0 {
            return self.at_depth(self.landscape.lowest);
        }
        let mut candidates = Vec::new();
        if let Some(rim) = self.at_rim
            && force >= rim.force
        {
            let depth = rim.equivalent + (force - rim.force) / (2.0 * self.setup.effective_modulus * rim.radius);
            let state = State { depth, force, radius: rim.radius, boundary: Boundary::Rim };
            if self.landscape.rising {
                return Ok(self.judged(state));
            }
            candidates.push(state);
        }
        let found = self.smooth_at_force(force)?;
        let nothing = found.is_empty() && candidates.is_empty();
        candidates.splice(0..0, found);
        if nothing {
            return Ok(unreachable(format!(
                "no contact radius was found for F = {}: it is not reached {}",
                self.naming.force(force),
                self.how_far()
            )));
        }
        Ok(self.chosen(&candidates))
    }

    /// Where the search for a contact radius ends.
    fn how_far(&self) -> String {
        match self.landscape.followed {
            Some(radius) => format!("as far as the waves of f can be followed, r = {}", self.naming.length(radius)),
            None => "at any radius that was tried".to_owned(),
        }
    }

    fn at_radius(&self, radius: f64) -> Result<Indented, ContactError> {
        if radius.is_nan() || radius < 0.0 {
            return Err(ContactError::Missing { quantity: "the contact radius", needs: "to be nonnegative; expected a >= 0" });
        }
        if let Some(rim) = self.at_rim {
            if radius == rim.radius {
                return Err(ContactError::Missing {
                    quantity: "a contact up to the rim",
                    needs: "a load by depth or force: any depth beyond g(c) has this radius",
                });
            }
            if rim.equivalent == 0.0 && rim.force == 0.0 {
                return Ok(unreachable(format!("the end is flat up to r = {}: a contact is as large", self.naming.length(rim.radius))));
            }
            if radius > rim.radius {
                return Ok(unreachable(format!("the indenter ends at r = {}", self.naming.length(rim.radius))));
            }
        }
        if radius == 0.0 && self.landscape.flat == 0.0 {
            return self.at_depth(0.0);
        }
        if radius < self.landscape.flat {
            return Ok(unreachable(format!(
                "the tip is flat up to r = {}: a contact is at least as large",
                self.naming.length(self.landscape.flat)
            )));
        }
        if radius >= self.contact.evaluator().limit() {
            return Ok(unreachable(format!("the profile ends at r = {}", self.naming.length(self.contact.evaluator().limit()))));
        }
        let depth = self.contact.depth(radius)?.estimate.value;
        let force = self.contact.any_force(radius)?.estimate.value;
        Ok(self.judged(State { depth, force, radius, boundary: Boundary::Smooth }))
    }

    /// The first proven candidate, else the first valid one, else the first one with its findings.
    fn chosen(&self, candidates: &[State]) -> Indented {
        let (mut first, mut looked_at) = (None, None);
        for (index, state) in candidates.iter().enumerate() {
            if index > 0 && self.landscape.exceeds(state.depth, state.radius) {
                continue;
            }
            let judged = self.judged(*state);
            match (judged.is_valid(), judged.radii) {
                (true, None) => return judged,
                (true, Some(_)) => looked_at = looked_at.or(Some(judged)),
                (false, _) => first = first.or(Some(judged)),
            }
        }
        looked_at.or(first).unwrap_or(Indented { state: None, findings: Vec::new(), radii: None })
    }

    /// U = E* ∫₀^a (d − g)² dx of a state.
    ///
    /// # Errors
    /// As [`Contact::energy`].
    pub fn energy(&self, state: &State) -> Result<Reading, ContactError> {
        self.contact(state).energy(state.radius)
    }
}

fn unreachable(message: String) -> Indented {
    let finding = Finding { rule: "unreachable", severity: Severity::Error, message, at: None };
    Indented { state: None, findings: vec![finding], radii: None }
}
