//! Evaluation of a list of points, in which a failure at one point does not affect the others.

use super::{Contact, ContactError, Measured, Quantity, Reason};
use crate::num::{Bounded, work};
use crate::transform::{PressureCurve, Quantities, Reading, TransformError};
use std::sync::Arc;

/// Divisor of the remaining budget: a single point may use one part of this many.
const FOR_ONE: u64 = 2;
/// Factor between the budget of a block and its expected cost.
const HEADROOM: u64 = 4;
/// Steps above which a list of pressures under one contact is answered by one expansion.
const EXPENSIVE: u64 = 100_000_000;
/// Fewest pressures for which an expansion is considered.
const MANY: usize = 20;
/// The most kinks for which an expansion is considered: its work grows with their square.
const MOST_KINKS: usize = 32;
/// Parts of the contact radius at which the cost of a pressure is measured.
const TYPICAL: [f64; 2] = [0.37, 0.61];
/// Relative error above which a pressure of the expansion is computed anew.
const FINE: f64 = 1e-10;

impl<'a, P: Quantities + ?Sized> Contact<'a, P> {
    /// Returns this contact for `count` pressures under the radius `a`, with one expansion for all of them where they cost too much one by
    /// one.
    ///
    /// The errors of the expansion are estimated; where one exceeds 1e-10 of the value, without an expansion, and for every other
    /// quantity, the profile is asked as before.
    pub fn for_pressures(&self, a: f64, count: usize) -> Contact<'a, Expanded<P>> {
        let is_chosen = self.are_expensive(a, count);
        self.with_pressures(if is_chosen { self.evaluator().pressure_curve(a).map(Arc::new) } else { None })
    }

    /// Returns whether `count` pressures under the radius `a` cost too much one by one, and have an expansion.
    ///
    /// The decision depends on counted steps and not on the budget, so that a budget changes no answer.
    pub(crate) fn are_expensive(&self, a: f64, count: usize) -> bool {
        if count < MANY || a.is_nan() || a <= 0.0 || !self.evaluator().has_pressure_curve() {
            return false;
        }
        if self.evaluator().breakpoints_below(a).len() > MOST_KINKS {
            return false;
        }
        // Beyond that cost, any list that is long enough is expensive.
        let most = EXPENSIVE / MANY as u64;
        let cost = |part: f64| {
            let (_, spent, _) = work::apart(most, || self.evaluator().pressure(part * a, a).is_ok());
            work::spend(spent);
            spent
        };
        // What the first call prepares for all others is not part of the cost of one.
        TYPICAL.into_iter().map(cost).min().unwrap_or(0).saturating_mul(count as u64) >= EXPENSIVE
    }

    /// Returns this contact with an expansion of the pressures under its radius, see [`Quantities::pressure_curve`].
    pub(crate) fn with_pressures(&self, curve: Option<Arc<PressureCurve<'static>>>) -> Contact<'a, Expanded<P>> {
        let evaluator = Expanded { profile: self.shared_evaluator(), curve };
        Contact::new(evaluator, self.effective_modulus(), self.depth_of_rim(), self.tolerance())
    }
}

impl Contact<'_> {
    /// The numbers of a quantity at every point, and for a field under a contact of this radius; as [`Quantity::number`] one by one.
    ///
    /// A point without a value has a [`Reason`], which is [`Reason::Unfinished`] if the budget was exhausted. Many expensive pressures come
    /// from one expansion.
    ///
    /// # Errors
    /// If no point has a value: the first error, or the exhausted budget.
    ///
    /// ```
    /// use sneddon::contact::{Contact, Quantity};
    /// use sneddon::{expr::Bindings, parse, transform::{Evaluator, Method, Profile, derive}};
    /// let solution = derive(&Profile::new(&parse::profile("2-sqrt(4-r^2)").unwrap()).unwrap()).unwrap();
    /// let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
    /// let contact = Contact::new(evaluator, 1.0, None, 1e-13);
    /// // The sphere ends at r = 2.
    /// let forces = contact.numbers(Quantity::Force, &[0.5, 1.5, 2.5], None).unwrap();
    /// assert!(forces[0].is_ok() && forces[1].is_ok() && forces[2].is_err());
    /// ```
    pub fn numbers(&self, quantity: Quantity, at: &[f64], radius: Option<f64>) -> Result<Vec<Measured>, ContactError> {
        let under = radius.filter(|_| quantity == Quantity::Pressure).map(|a| (a, self.for_pressures(a, at.len())));
        let expanded = under.filter(|(_, own)| own.evaluator().curve.is_some());
        let read = |block: &[f64]| match &expanded {
            Some((a, own)) => block.iter().map(|r| own.pressure(*r, *a)).collect(),
            None => self.block(quantity, block, radius),
        };
        if at.len() == 1 {
            // The whole budget is for this point, and its error is that of the list.
            return read(at);
        }
        with_reasons(each_point(at, usize::MAX, read))
    }
}

/// The numbers of a list, each missing one with its [`Reason`].
///
/// # Errors
/// If no point has a value: the first error, or the exhausted budget.
pub fn with_reasons(found: Vec<Result<Measured, Absence<ContactError>>>) -> Result<Vec<Measured>, ContactError> {
    let mut first = None;
    let mut reason = |absence| match absence {
        Absence::Unfinished | Absence::Failed(ContactError::Transform(TransformError::Exhausted(_))) => Reason::Unfinished,
        Absence::Failed(error) => {
            let why = Reason::Refused(error.to_string());
            first.get_or_insert(error);
            why
        }
    };
    let readings: Vec<Measured> = found.into_iter().map(|own| own.unwrap_or_else(|absence| Err(reason(absence)))).collect();
    if readings.iter().all(|own| matches!(own, Err(Reason::Refused(_) | Reason::Unfinished))) {
        return Err(first.unwrap_or_else(|| work::exhausted().into()));
    }
    Ok(readings)
}

/// A profile whose pressures under one contact radius come from one expansion; see [`Contact::for_pressures`].
pub struct Expanded<P: ?Sized> {
    profile: Arc<P>,
    curve: Option<Arc<PressureCurve<'static>>>,
}

impl<P: Quantities + ?Sized> Quantities for Expanded<P> {
    fn equivalent(&self, x: f64) -> Result<Reading, TransformError> {
        self.profile.equivalent(x)
    }

    fn force(&self, a: f64) -> Result<Reading, TransformError> {
        self.profile.force(a)
    }

    fn integral(&self, a: f64) -> Result<Reading, TransformError> {
        self.profile.integral(a)
    }

    fn pressure(&self, r: f64, a: f64) -> Result<Option<Reading>, TransformError> {
        let Some(curve) = self.curve.as_ref().filter(|own| own.radius() == a) else { return self.profile.pressure(r, a) };
        match curve.at(r)? {
            Some(own) if own.error <= FINE * own.value.abs() => Ok(Some(Reading { estimate: own, method: "curve" })),
            Some(_) => self.profile.pressure(r, a),
            None => Ok(None),
        }
    }

    fn axial(&self, z: f64, a: f64) -> Result<Reading, TransformError> {
        self.profile.axial(z, a)
    }

    fn displacement(&self, r: f64, a: f64) -> Result<Reading, TransformError> {
        self.profile.displacement(r, a)
    }

    fn height(&self, r: f64) -> Result<Reading, TransformError> {
        self.profile.height(r)
    }

    fn shortest_wave(&self, r: f64) -> f64 {
        self.profile.shortest_wave(r)
    }

    fn limit(&self) -> f64 {
        self.profile.limit()
    }

    fn breakpoints_below(&self, end: f64) -> Vec<f64> {
        self.profile.breakpoints_below(end)
    }

    fn check_domain(&self, symbol: &'static str, at: f64) -> Result<(), TransformError> {
        self.profile.check_domain(symbol, at)
    }

    fn flat_radius(&self) -> Result<f64, TransformError> {
        self.profile.flat_radius()
    }

    fn f_prime_over(&self, lower: f64, upper: f64) -> Option<(f64, f64)> {
        self.profile.f_prime_over(lower, upper)
    }

    fn power_at_axis(&self, radius: f64) -> Option<(f64, f64)> {
        self.profile.power_at_axis(radius)
    }

    fn squared_gap(&self, a: f64, depth: Bounded) -> Option<Result<Reading, TransformError>> {
        self.profile.squared_gap(a, depth)
    }
}

/// Why a point of [`each_point`] has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Absence<E> {
    /// The error at this point, which says nothing about the others.
    Failed(E),
    /// The budget was exhausted.
    Unfinished,
}

/// Evaluates a list of points with `read`, in blocks of at most `largest_block` points, within the open budget.
///
/// The block size doubles after each success. A block that fails or exceeds its budget is evaluated point by point, each of which may
/// use half of the remaining budget.
///
/// ```
/// use sneddon::contact::{Absence, each_point};
/// let roots = each_point(&[1.0, -1.0, 4.0], usize::MAX, |block: &[f64]| {
///     block.iter().map(|x| if *x < 0.0 { Err("negative") } else { Ok(x.sqrt()) }).collect()
/// });
/// assert_eq!(roots, [Ok(1.0), Err(Absence::Failed("negative")), Ok(2.0)]);
/// ```
pub fn each_point<P, T, E>(
    points: &[P],
    largest_block: usize,
    mut read: impl FnMut(&[P]) -> Result<Vec<T>, E>,
) -> Vec<Result<T, Absence<E>>> {
    let reserve = work::Reserve::default();
    let mut list = Vec::with_capacity(points.len());
    let (mut size, mut dearest) = (1, 0);
    while let Some(rest) = points.get(list.len()..).filter(|rest| !rest.is_empty()) {
        let left = reserve.beyond();
        let affordable = usize::try_from(left / (2 * HEADROOM * dearest).max(1)).unwrap_or(usize::MAX);
        let block = rest.get(..size.min(affordable).max(1)).unwrap_or(rest);
        let count = block.len() as u64;
        let most = if count == 1 { left / FOR_ONE } else { HEADROOM * dearest.max(1) * count };
        let before = work::left();
        match (work::until_deadline(|| work::share(most, || read(block))), block) {
            (Some(Ok(found)), _) => {
                dearest = dearest.max((before - work::left()) / count);
                list.extend(found.into_iter().map(Ok));
                size = (2 * block.len()).min(largest_block);
            }
            (Some(Err(error)), [_]) => list.push(Err(Absence::Failed(error))),
            (None, [_]) => list.push(Err(Absence::Unfinished)),
            _ => size = 1,
        }
    }
    list
}
