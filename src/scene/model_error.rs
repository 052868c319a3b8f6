//! How much of an answer is owed to the way in which measured points are joined: its change with a second way.

use super::{Curve, Datum, Dimension, Run};
use crate::contact::{Indentation, State};
use std::f64::consts::PI;

impl Run<'_> {
    /// The state of a load with the points of the tip joined in the second way; `None` without a tip, or where it has none.
    pub fn second_state(&self, index: usize) -> Option<State> {
        let (_, load) = self.load(index)?;
        self.second.as_ref()?.solve(load).ok()?.state
    }

    /// What the numbers of a row change by with the second way, in the order of the outputs; `None` where there is no measured tip.
    ///
    /// The number that is controlled does not change.
    pub fn row_model_errors(&self, index: usize, state: Option<&State>) -> Option<Vec<(Datum, Option<f64>)>> {
        let second = self.second.as_ref()?;
        let other = state.and_then(|_| self.second_state(index));
        let system = &self.scene().system;
        let change = |datum: Datum| -> Option<f64> {
            let (own, other) = (state?, other.as_ref()?);
            let change = (self.number(&self.indentation, datum, own)? - self.number(second, datum, other)?).abs();
            Some(change * system.out(datum.dimension())).filter(|own| own.is_finite())
        };
        Some(self.scene().outputs.data.iter().map(|datum| (*datum, change(*datum))).collect())
    }

    fn number(&self, indentation: &Indentation<'_>, datum: Datum, state: &State) -> Option<f64> {
        let a = state.radius;
        match datum {
            Datum::Depth => Some(state.depth),
            Datum::Force => Some(state.force),
            Datum::Radius => Some(a),
            Datum::Stiffness => Some(2.0 * self.scene().effective_modulus * a),
            Datum::MeanPressure => (a > 0.0).then(|| state.force / a / a / PI),
            Datum::Energy if state.force == 0.0 => Some(0.0),
            Datum::Energy => indentation.energy(state).ok().map(|own| own.estimate.value),
        }
    }

    /// What a value of a curve changes by with the second way, in the units of the answers; each way has its own state of the same load.
    pub fn point_model_error(&self, curve: Curve, states: Option<(&State, &State)>, at: f64) -> Option<f64> {
        let second = self.second.as_ref()?;
        let read = |indentation: &Indentation<'_>, state: Option<&State>| -> Option<f64> {
            let Some(state) = state else {
                let shape = indentation.shape();
                let found = if curve == Curve::Profile { shape.profile(at) } else { shape.depth(at) };
                return Some(found.ok()?.estimate.value);
            };
            if state.radius == 0.0 {
                return Some(0.0);
            }
            let contact = indentation.contact(state);
            match curve {
                Curve::Pressure => contact.pressure(at, state.radius).ok()?.ok().map(|own| own.estimate.value),
                Curve::AxialStress => contact.axial_stress(at, state.radius).ok()?.ok().map(|own| own.estimate.value),
                Curve::Displacement => contact.displacement(at, state.radius).ok().map(|own| own.estimate.value),
                _ => None,
            }
        };
        if at == 0.0 && !curve.needs_load() {
            return Some(0.0);
        }
        if curve.needs_load() && states.is_none() || self.indentation.rim().is_some_and(|c| !curve.needs_load() && at > c) {
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
