//! The normal stress on the axis, at the surface and below it.

use super::{Contact, ContactError, Measured};
use crate::num::{Bounded, Estimate};
use crate::transform::{Quantities, Reading};

impl<P: Quantities + ?Sized> Contact<'_, P> {
    /// σ_zz at the depth z ≥ 0 on the axis of an isotropic half-space under a contact of radius a, negative in compression.
    ///
    /// σ_zz(z) = −(E*/π)[∫₀^a g′(x) W(x) dx + (d − g(a)) W(a)], W(x) = x(x²+3z²)/(x²+z²)²: every spring is a rigid punch, and
    /// the punches superpose. z counts from the undeformed surface into the body; at z = 0 it is −p(0).
    /// Poisson's ratio plays no part beyond E*. The integral is taken of f′ times a positive weight, so that it keeps
    /// its digits for z ≪ a and z ≫ a alike; its error is estimated.
    ///
    /// ```
    /// use sneddon::contact::Contact;
    /// use sneddon::{expr::Bindings, parse, transform::{Evaluator, Method, Profile, derive}};
    /// let solution = derive(&Profile::new(&parse::profile("r^2/4").unwrap()).unwrap()).unwrap();
    /// let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-13).unwrap();
    /// let contact = Contact::new(evaluator, 3.0, None, 1e-13);
    /// // Hertz: σ_zz = −p₀/(1 + z²/a²), p₀ = (2/π) E* a/R with R = 2
    /// let found = contact.axial_stress(0.5, 1.0).unwrap().unwrap().estimate;
    /// let expected = -3.0 / std::f64::consts::PI / 1.25;
    /// assert!((found.value - expected).abs() <= found.error && found.error < 1e-12);
    /// ```
    ///
    /// # Errors
    /// As the evaluator; [`ContactError::Missing`] for a depth that is negative or no number.
    pub fn axial_stress(&self, z: f64, a: f64) -> Result<Measured, ContactError> {
        if z.is_nan() || z < 0.0 || z.is_infinite() {
            return Err(ContactError::Missing { quantity: "the stress below the surface", needs: "a depth z from 0 on" });
        }
        if z == 0.0 {
            let negative = |own: Reading| Reading { estimate: Estimate { value: -own.estimate.value, ..own.estimate }, ..own };
            return Ok(self.pressure(0.0, a)?.map(negative));
        }
        let smooth = self.evaluator().axial(z, a)?;
        let mut total = smooth.estimate;
        if let Some(depth) = self.depth_of_rim() {
            let excess = Estimate::exact(depth) + self.evaluator().equivalent(a)?.estimate.scaled(-1.0);
            total = total + excess.times(edge(z, a));
        }
        let factor = Bounded::exact(self.effective_modulus()) / Bounded::rounded(std::f64::consts::PI);
        let estimate = total.times(factor).scaled(-1.0);
        Ok(Ok(Reading { estimate, method: smooth.method }))
    }
}

/// W(a) = a(a²+3z²)/(a²+z²)², from the ratio of the two that does not exceed 1.
fn edge(z: f64, a: f64) -> Bounded {
    let exact = Bounded::exact;
    let (z, a) = (exact(z), exact(a));
    let ratio = if z.value < a.value { z / a } else { a / z };
    let (square, below) = (ratio * ratio, |own: Bounded| (exact(1.0) + own) * (exact(1.0) + own));
    if z.value < a.value {
        (exact(1.0) + exact(3.0) * square) / below(square) / a
    } else {
        (exact(3.0) + square) / below(square) * ratio / z
    }
}
