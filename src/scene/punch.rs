//! Flat punches with non-circular cross-sections, whose stiffness equals the stiffness of a circular punch with an effective diameter.

use super::system::System;
use super::{Dimension, DimensionedNumber, Quantity, Scene, SceneError};
use crate::scene::file::dimensioned::to_f64;
use crate::scene::file::document::Table;
use std::f64::consts::PI;
use std::ops::Range;

/// Cross-sections with the approximate β of Popov & Heß (3.41); more accurate computations give about 1.02 for the square and 1.06 for the triangle.
const SECTIONS: [(&str, f64); 3] = [("circle", 1.0), ("square", 1.012), ("triangle", 1.034)];

/// A flat punch with a convex cross-section: D = 2β√(A/π), k = D E* (3.40), (3.42).
pub(super) struct Punch {
    beta: f64,
    pub(super) area: DimensionedNumber,
    span: Range<usize>,
}

impl Punch {
    /// Reads `cross_section` or `beta`, with `area`; `None` if neither is given.
    pub(super) fn read(table: &Table<'_>) -> Result<Option<Self>, SceneError> {
        let help = "expected cross_section = \"square\" and area = \"4 um^2\", or beta and area";
        let (section, beta) = (table.get("cross_section"), table.get("beta"));
        let beta = match (section, beta) {
            (None, None) => return Ok(None),
            (Some(entry), None) => {
                let word = entry.word(&SECTIONS.map(|own| own.0))?;
                SECTIONS.iter().find(|own| own.0 == word).map_or(1.0, |own| own.1)
            }
            (None, Some(entry)) => {
                let beta = to_f64(&entry.quantity()?.in_base()).map_err(|error| error.at(entry.span()))?;
                // Of all cross-sections with the same area, the circle has the smallest stiffness.
                if !(1.0..=10.0).contains(&beta) {
                    return Err(SceneError::value(format!("beta = {beta:?} is out of range"))
                        .help("expected a number of at least 1, the value for a circle")
                        .at(entry.span()));
                }
                beta
            }
            (Some(_), Some(entry)) => {
                return Err(SceneError::value("the punch has both cross_section and beta").help(help).at(entry.span()));
            }
        };
        if let Some(other) = ["f", "shape", "points", "radius", "parameters"].into_iter().find(|key| table.get(key).is_some()) {
            let message = format!("{other} cannot be combined with a flat punch with a cross-section");
            return Err(SceneError::value(message).help(help).at(table.key_span(other)));
        }
        let entry = table.demand("area", help)?;
        Ok(Some(Self { beta, area: entry.quantity()?, span: entry.span() }))
    }

    /// Returns half the effective diameter, β√(A/π).
    pub(super) fn radius(&self, system: &System) -> Result<f64, SceneError> {
        let square = Dimension::LENGTH.times(Dimension::LENGTH).unwrap_or(Dimension::NONE);
        let area = system.number(&self.area, square, "area").map_err(|error| error.at(self.span.clone()))?;
        if area > 0.0 {
            return Ok(self.beta * (area / PI).sqrt());
        }
        Err(SceneError::value(format!("area = {} is not positive", self.area.text())).at(self.span.clone()))
    }

    /// Returns an error for quantities that are unknown for non-circular punches: all but d, F and k.
    pub(super) fn refuse(scene: &Scene, outputs: Option<&Table<'_>>) -> Result<(), SceneError> {
        let known = [Quantity::Depth, Quantity::Force, Quantity::Stiffness];
        let data = scene.outputs.data.iter().find(|own| !known.contains(own)).map(|own| own.key());
        let Some(name) = data.or(scene.outputs.curves.first().map(|own| own.key())) else { return Ok(()) };
        let error =
            SceneError::value(format!("{name} is not available for a punch with a non-circular cross-section")).help("expected d, F and k");
        Err(match outputs.and_then(|table| table.get("quantities")) {
            Some(entry) => error.at(entry.span()),
            None => error,
        })
    }
}
