//! How much of an answer is owed to the way in which measured points are joined: its change with a second way.

use super::run::of_state;
use super::{Dimension, Quantity, Run};
use crate::contact::{Indentation, State};

impl Run<'_> {
    /// The state of a load with the points of the tip joined in the second way; `None` without a tip, or where it has none.
    pub fn second_state(&self, index: usize) -> Option<State> {
        let (_, load) = self.load(index)?;
        self.second.as_ref()?.solve(load).ok()?.state
    }

    /// What the numbers of a row change by with the second way, in the order of the outputs; `None` where there is no measured tip.
    ///
    /// The number that is controlled does not change.
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

    /// What a value of a curve changes by with the second way, in the units of the answers; each way has its own state of the same load.
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

    /// The last radius of the measured tip in the units of the answers.
    pub fn tip_ends_at(&self) -> Option<f64> {
        self.scene().tip.as_ref().map(|tip| tip.last_radius() * self.scene().system.out(Dimension::LENGTH))
    }
}
