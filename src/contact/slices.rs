//! The numbers of a contact over long lists of points, block by block where closed forms answer.

use super::problem::representable;
use super::{Contact, ContactError, Measured, Quantity};
use crate::num::{Bounded, Estimate};
use crate::transform::{Origin, Reading, Slice, TransformError};

/// Number of points computed before their readings are written, which limits the scratch memory.
const PART: usize = 1 << 16;

impl Contact<'_> {
    /// f(r) at every r; as [`Contact::profile`] point by point, and so for the others.
    ///
    /// # Errors
    /// That of the first point that has one.
    pub fn profiles(&self, r: &[f64]) -> Result<Vec<Measured>, ContactError> {
        readings("r", r, |r, out| self.evaluator().heights(r, out), |_, reading| Ok(reading))
    }

    /// g(x) at every x.
    ///
    /// # Errors
    /// As [`Contact::profiles`].
    pub fn equivalents(&self, x: &[f64]) -> Result<Vec<Measured>, ContactError> {
        readings("x", x, |x, out| self.evaluator().equivalents(x, out), |_, reading| Ok(reading))
    }

    /// d(a) at every a.
    ///
    /// # Errors
    /// As [`Contact::profiles`].
    pub fn depths(&self, a: &[f64]) -> Result<Vec<Measured>, ContactError> {
        if self.has_rim() { a.iter().map(|a| Ok(Ok(self.depth(*a)?))).collect() } else { self.equivalents(a) }
    }

    /// F(a) at every a.
    ///
    /// # Errors
    /// As [`Contact::profiles`].
    pub fn forces(&self, a: &[f64]) -> Result<Vec<Measured>, ContactError> {
        if self.has_rim() {
            return a.iter().map(|a| Ok(Ok(self.force(*a)?))).collect();
        }
        let twice = Bounded::exact(2.0) * Bounded::exact(self.effective_modulus());
        readings("a", a, |a, out| self.evaluator().forces(a, out), |_, smooth| Ok(scaled(smooth, twice)))
    }

    /// p(r) at every r under a contact of radius a.
    ///
    /// # Errors
    /// As [`Contact::profiles`].
    pub fn pressures(&self, r: &[f64], a: f64) -> Result<Vec<Measured>, ContactError> {
        if self.has_rim() || r.iter().any(|r| *r >= a) {
            return r.iter().map(|r| self.pressure(*r, a)).collect();
        }
        let factor = Bounded::exact(self.effective_modulus()) / Bounded::rounded(std::f64::consts::PI);
        readings(
            "r",
            r,
            |r, out| self.evaluator().pressures(r, a, out),
            |r, smooth| if smooth.estimate.value.is_infinite() { Err(self.singularity(r, a)) } else { Ok(scaled(smooth, factor)) },
        )
    }

    /// A quantity at every point, and for a field under a contact of this radius.
    ///
    /// # Errors
    /// As [`Contact::profiles`].
    pub(super) fn block(&self, quantity: Quantity, at: &[f64], radius: Option<f64>) -> Result<Vec<Measured>, ContactError> {
        match (quantity, radius) {
            (Quantity::Profile, _) => self.profiles(at),
            (Quantity::Equivalent, _) => self.equivalents(at),
            (Quantity::Depth, _) => self.depths(at),
            (Quantity::Force, _) => self.forces(at),
            (Quantity::Pressure, Some(a)) => self.pressures(at, a),
            _ => at.iter().map(|point| quantity.number(self, *point, radius.unwrap_or(*point))).collect(),
        }
    }
}

fn scaled(reading: Reading, factor: Bounded) -> Reading {
    Reading { estimate: reading.estimate.times(factor), method: reading.method }
}

/// The readings of a list, in parts.
fn readings(
    symbol: &'static str,
    points: &[f64],
    run: impl Fn(&[f64], Slice<'_>) -> Result<(), TransformError>,
    measured: impl Fn(f64, Reading) -> Measured,
) -> Result<Vec<Measured>, ContactError> {
    let part = points.len().min(PART);
    let (mut values, mut errors) = (vec![0.0; part], vec![0.0; part]);
    let mut origins = vec![Origin::CLOSED; part];
    let mut list = Vec::with_capacity(points.len());
    for points in points.chunks(PART) {
        for buffer in [&mut values, &mut errors] {
            buffer.resize(points.len(), 0.0);
        }
        origins.resize(points.len(), Origin::CLOSED);
        run(points, Slice { values: &mut values, errors: Some(&mut errors), origins: Some(&mut origins) })?;
        for (((point, value), error), origin) in points.iter().zip(&values).zip(&errors).zip(&origins) {
            let Origin { method, way, evaluations, bound } = *origin;
            let estimate = Estimate { value: *value, error: *error, evaluations, bound, way };
            let own = measured(*point, Reading { estimate, method });
            list.push(own.map_or_else(|reason| Ok(Err(reason)), |own| representable(own, symbol, *point).map(Ok))?);
        }
    }
    Ok(list)
}
