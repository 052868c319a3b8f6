//! Forces on parts of a contact, and so means of the pressure over cells: its singularities are integrated, not sampled.

use super::{Contact, ContactError};
use crate::num::quadrature::{Options, Panel, Point, integrate_blocks};
use crate::num::stable::leg;
use crate::num::{Bounded, Estimate, NumError};
use crate::transform::{Quantities, TransformError};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The pressure of one contact, ready for the forces on many parts of it.
///
/// ```
/// use sneddon::contact::{Contact, PartialForce};
/// use sneddon::{expr::Bindings, parse, transform::{Evaluator, Method, Profile, derive}};
/// let solution = derive(&Profile::new(&parse::profile("r^2/4").unwrap()).unwrap()).unwrap();
/// let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
/// let contact = Contact::new(evaluator, 3.0, None, 1e-13);
/// let force = PartialForce::new(&contact, 1.0, []).unwrap();
/// // A quarter of F = 2 on a square that covers a quarter of the contact
/// let quarter = force.on_rectangle([0.0, 1.0], [0.0, 1.0]).unwrap();
/// assert!((quarter.value - 0.5).abs() <= quarter.error && quarter.error < 1e-10);
/// ```
pub struct PartialForce<'c, P: Quantities> {
    smooth: Contact<'c, P>,
    a: f64,
    /// E*(d − g(a))/π.
    excess: Bounded,
    /// Radii at which the pressure is not smooth, rising; the last one is a.
    rough: Vec<f64>,
}

/// The relative tolerance of every piece of a cell.
const TOLERANCE: f64 = 1e-11;
/// Relative error of a cell's force due to rounding of its edges, for a cell as wide as its distance from the axis.
const EDGES: f64 = 16.0 * f64::EPSILON;

impl<'c, P: Quantities> PartialForce<'c, P> {
    /// A contact of radius a whose profile has kinks at these radii.
    ///
    /// # Errors
    /// As the evaluator.
    pub fn new(contact: &Contact<'c, P>, a: f64, kinks: impl IntoIterator<Item = f64>) -> Result<Self, ContactError> {
        let excess = match contact.depth_of_rim() {
            Some(depth) => Bounded::exact(depth) - contact.evaluator().equivalent(a)?.estimate.bounded(),
            None => Bounded::exact(0.0),
        };
        let factor = Bounded::exact(contact.effective_modulus()) / Bounded::rounded(PI);
        // The axis, where the pressure of a pointed tip is infinite, and every place where f or its slopes change.
        let mut rough = vec![0.0];
        rough.extend(kinks.into_iter().chain(contact.evaluator().breakpoints_below(a)).filter(|b| *b > 0.0 && *b < a));
        rough.push(a);
        rough.sort_by(f64::total_cmp);
        rough.dedup();
        Ok(Self { smooth: contact.with_depth(None), a, excess: excess * factor, rough })
    }

    /// ∫∫ p dx dy over a rectangle that does not cross the axes: x and y from 0 on.
    ///
    /// # Errors
    /// As the evaluator; [`ContactError::Missing`] for a rectangle that is empty or crosses an axis.
    pub fn on_rectangle(&self, x: [f64; 2], y: [f64; 2]) -> Result<Estimate, ContactError> {
        let ([x0, x1], [y0, y1]) = (x, y);
        if !(x0 >= 0.0 && y0 >= 0.0 && x1 > x0 && y1 > y0 && x1.is_finite() && y1.is_finite()) {
            return Err(ContactError::Missing { quantity: "the force on a rectangle", needs: "0 <= x0 < x1 and 0 <= y0 < y1" });
        }
        let corners = [x0.hypot(y0), x1.hypot(y0), x0.hypot(y1), x1.hypot(y1)];
        // The circle of radius r lies in the rectangle from the larger of two angles to the smaller of two others.
        let arc = |r: f64| {
            let acos = |x: f64| if r > x { leg(r, x).atan2(x) } else { 0.0 };
            let asin = |y: f64| if r > y { y.atan2(leg(r, y)) } else { FRAC_PI_2 };
            let (upper, lower) = (acos(x0).min(asin(y1)), acos(x1).max(if y0 > 0.0 { asin(y0) } else { 0.0 }));
            Bounded { value: (upper - lower).max(0.0), error: 6.0 * f64::EPSILON * (upper + lower) }
        };
        let found = self.radial(&corners, arc)?;
        let moved = EDGES * (x1 / (x1 - x0)).max(y1 / (y1 - y0)) * found.value.abs();
        Ok(Estimate { error: found.error + moved, ..found })
    }

    /// 2π ∫ p r dr over a ring.
    ///
    /// # Errors
    /// As the evaluator; [`ContactError::Missing`] for an empty ring.
    pub fn on_ring(&self, inner: f64, outer: f64) -> Result<Estimate, ContactError> {
        if !(inner >= 0.0 && outer > inner && outer.is_finite()) {
            return Err(ContactError::Missing { quantity: "the force on a ring", needs: "0 <= inner < outer" });
        }
        let found = self.radial(&[inner, outer], |_| Bounded::rounded(TAU))?;
        let moved = EDGES * outer / (outer - inner) * found.value.abs();
        Ok(Estimate { error: found.error + moved, ..found })
    }

    /// ∫ p(r) arc(r) r dr between the outermost of these radii; the arc is smooth between them except for square-root singularities just above each radius.
    fn radial(&self, radii: &[f64], arc: impl Fn(f64) -> Bounded) -> Result<Estimate, ContactError> {
        let lowest = radii.iter().copied().fold(f64::INFINITY, f64::min);
        let highest = radii.iter().copied().fold(0.0, f64::max).min(self.a);
        let mut ends: Vec<f64> = radii.iter().chain(&self.rough).copied().filter(|r| *r >= lowest && *r <= highest).collect();
        ends.extend([lowest, highest]);
        // An end that differs from a rough place by its rounding only is that place: between them there would be no number.
        for end in &mut ends {
            if let Some(own) = self.rough.iter().find(|own| (**own - *end).abs() <= 8.0 * f64::EPSILON * **own) {
                *end = *own;
            }
        }
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let mut total = Estimate::exact(0.0);
        for pair in ends.windows(2) {
            let [from, to] = *pair else { continue };
            if from >= self.a {
                break;
            }
            total = total + self.between(from, to, &arc)?;
        }
        Ok(total)
    }

    fn between(&self, from: f64, to: f64, arc: &impl Fn(f64) -> Bounded) -> Result<Estimate, ContactError> {
        let length = to - from;
        let rough = self.rough.iter().any(|at| *at > from - 0.5 * length && *at < to + 0.5 * length);
        let mut failure: Option<ContactError> = None;
        let mut height = |up: f64, down: f64| {
            let r = if up < down { from + up } else { to - down };
            // Where the sum rounds to an end the pressure may be infinite; the contribution beyond is negligible.
            let inside = r.max(from.next_up()).min(to.next_down());
            let smooth = match self.smooth.pressure(inside, self.a) {
                Ok(Ok(own)) => own.estimate.bounded(),
                Ok(Err(_)) => Bounded { value: f64::NAN, error: 0.0 },
                Err(error) => {
                    failure.get_or_insert(error);
                    Bounded { value: f64::NAN, error: 0.0 }
                }
            };
            let below = (self.a - to) + down;
            let edge = if self.excess.value == 0.0 && self.excess.error == 0.0 {
                Bounded::exact(0.0)
            } else {
                let product = below * (self.a + r);
                self.excess / Bounded { value: product, error: 4.0 * f64::EPSILON * product }.sqrt()
            };
            (smooth + edge) * arc(r) * Bounded { value: r, error: f64::EPSILON * r }
        };
        let options = Options { rel_tol: TOLERANCE, charge_x: false, ..Options::default() };
        let found = if rough {
            let mut integrand = |points: &[Point], heights: &mut [Bounded]| {
                for (point, own) in points.iter().zip(heights) {
                    *own = height(point.from_lower, point.from_upper);
                }
            };
            integrate_blocks(&mut integrand, &[Panel::singular(0.0, length)], &options)
        } else {
            // r = from + length·t² removes the square-root singularity of the arc at the lower end.
            let mut integrand = |points: &[Point], heights: &mut [Bounded]| {
                for (point, own) in points.iter().zip(heights) {
                    let (t, rest) = (point.from_lower, point.from_upper);
                    *own = height(length * t * t, length * rest * (1.0 + t)) * Bounded { value: 2.0 * t, error: 8.0 * f64::EPSILON * t };
                }
            };
            integrate_blocks(&mut integrand, &[Panel::smooth(0.0, 1.0)], &options).map(|found| found.scaled(length))
        };
        match found {
            Ok(found) => Ok(found),
            Err(
                NumError::ToleranceNotReached { value, error, evaluations, .. } | NumError::EvaluationLimit { value, error, evaluations },
            ) if error.is_finite() => {
                let factor = if rough { 1.0 } else { length };
                Ok(Estimate::estimated(value * factor, error * factor, evaluations))
            }
            Err(other) => Err(failure.unwrap_or_else(|| ContactError::Transform(TransformError::from(other)))),
        }
    }
}
