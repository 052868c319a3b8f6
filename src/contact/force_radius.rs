//! The contact radius under a given force with a smooth edge: the root of F(a) = F.

use super::radius::{CertainSigns, DepthSamples, NoRadius, Span, near_axis, overflow, root};
use super::{Contact, ContactError};
use crate::num::Estimate;
use crate::transform::{Quantities, Reading, TransformError};

impl<P: Quantities + ?Sized> Contact<'_, P> {
    /// The contact radius a with F(a) = F; the tip is flat below it if F is 0.
    ///
    /// The error is proven where the sign of F(a) − F is proven on both sides of a.
    ///
    /// # Errors
    /// [`ContactError::ForceUnreachable`] if no radius on the profile has this force, [`ContactError`] if F cannot be computed on the way.
    ///
    /// ```
    /// use sneddon::contact::Contact;
    /// use sneddon::expr::Bindings;
    /// use sneddon::{parse, transform::{Evaluator, Method, Profile, derive}};
    /// let solution = derive(&Profile::new(&parse::profile("r^2/2").unwrap()).unwrap()).unwrap();
    /// let evaluator = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12).unwrap();
    /// // F = 4E*a³/(3R)
    /// let a = Contact::new(evaluator, 3.0, None, 1e-12).radius_under_force(0.5).unwrap().estimate;
    /// assert!((a.value - 0.5).abs() <= a.error && a.error < 1e-15);
    /// ```
    pub fn radius_under_force(&self, force: f64) -> Result<Reading, ContactError> {
        let start = self.evaluator().flat_radius()?;
        if force == 0.0 {
            return Ok(Reading { estimate: Estimate::exact(start), method: "exact" });
        }
        let unreachable = |reason| ContactError::ForceUnreachable { force, reason };
        if !(force > 0.0 && force.is_finite()) {
            return Err(unreachable("expected a finite force F >= 0"));
        }
        let (mut evaluations, mut way) = (0, "");
        let mut height = |a: f64| match self.force(a) {
            Ok(own) => {
                evaluations += own.estimate.evaluations + 1;
                way = own.estimate.way;
                Ok(own.estimate)
            }
            // F overflows beyond every root.
            Err(ContactError::Transform(TransformError::Overflow { is_negative, .. })) => Ok(Estimate::exact(overflow(is_negative))),
            Err(ContactError::Transform(other)) => Err(other),
            Err(_) => Err(TransformError::NotComputable { at: a }),
        };
        // |F| ≤ 2 E* a max |g|, because r ≤ a.
        let near =
            || near_axis(self.evaluator(), start, |a, g| 2.0 * self.effective_modulus() * a * g * (1.0 + 4.0 * f64::EPSILON) < force);
        let wave = |a: f64| self.evaluator().shortest_wave(a);
        let features = |lower: f64, upper: f64| self.features.between(self.evaluator(), lower, upper);
        let span = Span { near: &near, start, limit: self.evaluator().limit(), wave: &wave, features: &features };
        let found = root(&mut height, &|| None, &DepthSamples::default(), force, span).map_err(|error| match error {
            ContactError::Unreachable { reason, .. } => unreachable(reason),
            other => other,
        })?;
        let (a, CertainSigns { reach, bound, .. }) =
            found.map_err(|(NoRadius::Proven(reason) | NoRadius::Unproven(reason))| unreachable(reason))?;
        Ok(Reading { estimate: Estimate { error: reach, evaluations, bound, way, ..Estimate::exact(a) }, method: "root" })
    }
}
