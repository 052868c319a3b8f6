//! The numbers of a solved load with bounds of their errors.

use super::{Boundary, Indentation, Load, State};
use crate::contact::ContactError;
use crate::contact::radius::{CertainSigns, certain};
use crate::num::{Bounded, Estimate};
use crate::transform::Quantities;

/// Depth, force and contact radius of a solved load with their errors; the load has no error.
///
/// The radius is proven if a contact with this load is proven to end within the bound; whether there is a smaller one is a question for
/// the verdict.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimates {
    /// The displacement at r = 0.
    pub depth: Estimate,
    /// The normal force.
    pub force: Estimate,
    /// The contact radius.
    pub radius: Estimate,
    /// A bound of |d − g(a)| for the contact radius of the state, 0 under a rim.
    pub slack: f64,
}

impl Indentation<'_> {
    /// The numbers of a state with their errors, where E* and the load are known to the relative error `doubt`.
    ///
    /// The sign of g(a) − d, or of F(a) − F, is certain on both sides of the radius at the distance of its error.
    /// The other numbers are right to second order in that distance.
    ///
    /// # Errors
    /// [`ContactError`] if g or F has no value next to the contact radius, or no sign there.
    pub fn estimates(&self, state: &State, load: Load, doubt: f64) -> Result<Estimates, ContactError> {
        let (depth, force, radius) = (Estimate::exact(state.depth), Estimate::exact(state.force), Estimate::exact(state.radius));
        let doubted = |own: Estimate| Estimate { error: own.error + 2.0 * doubt * own.value.abs(), ..own };
        let exact = Estimates { depth, force, radius, slack: 0.0 };
        let given = |target: f64| Estimate { error: 2.0 * doubt * target.abs(), ..Estimate::exact(target) };
        let a = state.radius;
        let twice = Bounded::exact(2.0) * Bounded::exact(self.setup.effective_modulus);
        match (state.boundary, load) {
            (Boundary::Apart, _) => Ok(exact),
            // The bodies only touch.
            _ if state.force == 0.0 => Ok(exact),
            (Boundary::Rim, Load::Force(_)) => Ok(Estimates { depth: doubted(self.depth_under(state, a)?), ..exact }),
            (Boundary::Rim, _) => Ok(Estimates { force: doubted(self.force_at(state)?), ..exact }),
            (Boundary::Smooth, Load::Radius(_)) => {
                let (depth, force) = (self.contact.depth(a)?.estimate, self.contact.force(a)?.estimate);
                let (depth, force) = (doubted(from(state.depth, depth)), doubted(from(state.force, force)));
                Ok(Estimates { depth, force, slack: depth.error, ..exact })
            }
            (Boundary::Smooth, Load::Depth(target)) => {
                let gap = |a: f64| Ok(self.contact.depth(a)?.estimate + given(-target));
                let CertainSigns { reach, spread, bound } = self.certain(gap, a)?;
                let radius = Estimate { error: reach, ..radius }.resting_on(bound);
                // F_smooth(a) + 2E* a (d − g(a)) is right to second order in what a is off.
                let own = doubted(self.force_at(state)?);
                let force = Estimate { error: own.error + twice.value * reach * spread, ..own }.resting_on(bound);
                Ok(Estimates { force, radius, slack: spread, ..exact })
            }
            (Boundary::Smooth, Load::Force(target)) => {
                let lack = |a: f64| Ok(self.contact.force(a)?.estimate + given(-target));
                let CertainSigns { reach, spread, bound } = self.certain(lack, a)?;
                let radius = Estimate { error: reach, ..radius }.resting_on(bound);
                // g(a) + (F − F_smooth(a))/(2E* a) is right to second order as well.
                let own = self.depth_under(state, a)?;
                let first = spread / (twice.value * a);
                let depth = Estimate { error: own.error + first * reach / a, ..own }.resting_on(bound);
                Ok(Estimates { depth, radius, slack: first + depth.error, ..exact })
            }
        }
    }

    /// The strain energy of a state with a share from the errors of the state added to its error: dU/dd = F.
    pub fn energy_estimate(&self, energy: Estimate, state: &State, own: &Estimates) -> Estimate {
        let most = state.force + own.force.error + 2.0 * self.setup.effective_modulus * state.radius * own.slack;
        let error = energy.error + most * (own.slack + own.depth.error);
        Estimate { error, ..energy }.resting_on(own.radius.bound.and(own.depth.bound))
    }

    fn certain(&self, mut gap: impl FnMut(f64) -> Result<Estimate, ContactError>, a: f64) -> Result<CertainSigns, ContactError> {
        let evaluator = self.contact.evaluator();
        let found = certain(&mut gap, a, self.landscape.flat, evaluator.limit())?;
        found.ok_or(ContactError::Unreachable { depth: a, reason: "g does not rise through this depth" })
    }

    /// F at the depth and the radius of a state.
    fn force_at(&self, state: &State) -> Result<Estimate, ContactError> {
        let own = self.contact.with_depth(Some(state.depth)).any_force(state.radius)?.estimate;
        Ok(from(state.force, own))
    }

    /// d for a contact of radius a under the force of a state.
    fn depth_under(&self, state: &State, a: f64) -> Result<Estimate, ContactError> {
        let lack = Estimate::exact(state.force) + self.contact.any_force(a)?.estimate.scaled(-1.0);
        let stiffness = Bounded::exact(2.0) * Bounded::exact(self.setup.effective_modulus) * Bounded::exact(a);
        let own = self.contact.with_depth(None).depth(a)?.estimate + lack.times(Bounded::exact(1.0) / stiffness);
        Ok(from(state.depth, own))
    }
}

/// The number of a state with the error of an estimate of the same quantity.
fn from(value: f64, own: Estimate) -> Estimate {
    Estimate { value, error: own.error + (own.value - value).abs(), ..own }
}
