//! The model error of measured tips: the change of a result with a second interpolation of the points.

use super::run::of_state;
use super::{Dimension, Quantity, Run};
use crate::contact::{Indentation, State};

impl Run<'_> {
    /// Returns the state of a load with the second interpolation; `None` without a measured tip or without a contact.
    pub fn second_state(&self, index: usize) -> Option<State> {
        let (_, load) = self.load(index)?;
        self.second.as_ref()?.solve(load).ok()?.state
    }

    /// Returns the changes of a row's values with the second interpolation, in output order; `None` without a measured tip.
    ///
    /// The controlled quantity does not change.
    pub fn row_model_errors(&self, index: usize, state: Option<&State>) -> Option<Vec<(Quantity, Option<f64>)>> {
        let second = self.second.as_ref()?;
        let other = state.and_then(|_| self.second_state(index));
        let system = &self.scene().system;
        let change = |datum: Quantity| -> Option<f64> {
            let (own, other) = (state?, other.as_ref()?);
            let change = (self.number(&self.indentation, datum, own)? - self.number(second, datum, other)?).abs();
            Some(change * system.out(datum.dimension())).filter(|own| own.is_finite())
        };
        Some(self.scene().outputs.data.iter().map(|datum| (*datum, change(*datum))).collect())
    }

    fn number(&self, indentation: &Indentation<'_>, datum: Quantity, state: &State) -> Option<f64> {
        if let Some(known) = of_state(datum, state, self.scene().effective_modulus) {
            return known.ok();
        }
        Some(datum.number(&indentation.contact(state), state.radius, state.radius).ok()?.ok()?.estimate.value)
    }

    /// Returns the change of a curve's value with the second interpolation, in output units; each interpolation uses its own state under the same load.
    pub fn point_model_error(&self, curve: Quantity, states: Option<(&State, &State)>, at: f64) -> Option<f64> {
        let second = self.second.as_ref()?;
        let read = |indentation: &Indentation<'_>, state: Option<&State>| -> Option<f64> {
            let found = match state {
                None => curve.number(indentation.shape(), at, at),
                Some(state) if state.radius == 0.0 => return Some(0.0),
                Some(state) => curve.number(&indentation.contact(state), at, state.radius),
            };
            Some(found.ok()?.ok()?.estimate.value)
        };
        if at == 0.0 && !curve.needs_radius() {
            return Some(0.0);
        }
        if curve.needs_radius() && states.is_none() || self.indentation.rim().is_some_and(|c| !curve.needs_radius() && at > c) {
            return None;
        }
        let change = (read(&self.indentation, states.map(|own| own.0))? - read(second, states.map(|own| own.1))?).abs();
        Some(change * self.scene().system.out(curve.dimension())).filter(|own| own.is_finite())
    }

    /// Returns the last radius of the measured tip in output units.
    pub fn tip_ends_at(&self) -> Option<f64> {
        self.scene().tip.as_ref().map(|tip| tip.last_radius() * self.scene().system.out(Dimension::LENGTH))
    }
}
