//! Comparison of the closed displacement outside, or of the closed stress on the axis, of a term with quadrature.

use super::{ENOUGH, ParameterDraw, Part, Radii, TELLING, TOLERANCE, compile};
use crate::derive::rule::{Branches, Pair};
use crate::derive::term::Term;
use crate::derive::verification::Verdict;
use crate::integrate::error::TransformError;
use crate::integrate::integral::NumericProfile;
use crate::num::Estimate;

/// A field of a contact, with the places at which it is compared.
pub struct Field {
    coordinate: &'static str,
    /// Relative to the contact radius.
    places: &'static [f64],
    number: fn(&NumericProfile, f64, f64, f64) -> Result<Estimate, TransformError>,
}

impl Field {
    /// u(r) outside the contact.
    pub const OUTSIDE: Self = Self { coordinate: "r", places: &[1.07, 2.3], number: NumericProfile::displacement };
    /// −σ_zz(z)·π/E* on the axis.
    pub const AXIAL: Self = Self { coordinate: "z", places: &[0.04, 0.7, 3.1], number: NumericProfile::axial };
}

impl ParameterDraw {
    /// Compares the field of a term as evaluated and as shown; `None` if one of them has no value somewhere.
    pub(in crate::derive::verification) fn compare_field(&self, field: &Field, term: &Term, forms: &Branches) -> Option<Verdict> {
        let Radii { all, .. } = self.radii(&term.segment)?;
        let tape = |pair: &Pair| compile(&[pair.evaluated.clone(), pair.shown.clone()], &[field.coordinate, "a"], &self.names);
        let (within, beyond) = (tape(&forms.within)?, tape(&forms.beyond)?);
        let profile = NumericProfile::new(&[(term.segment.clone(), term.f_prime())], &self.bindings).ok()?;
        let mut verdict = Verdict::Agrees;
        for (a, part) in all.into_iter().filter(|(_, part)| *part != Part::Far) {
            let tape = if part == Part::Beyond { &beyond } else { &within };
            for place in field.places.iter().map(|share| share * a) {
                let truth = (field.number)(&profile, place, a, TOLERANCE).ok()?;
                let size = truth.value.abs();
                for own in self.bounded(tape, &[place, a])? {
                    let error = own.error + truth.error;
                    verdict = verdict.and(match error <= TELLING * size {
                        true if (own.value - truth.value).abs() <= ENOUGH * size + error => Verdict::Agrees,
                        true => Verdict::Wrong,
                        false => Verdict::Unknown,
                    });
                }
            }
        }
        Some(verdict)
    }
}
