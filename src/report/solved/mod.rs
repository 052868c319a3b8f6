//! Common parts of all formats of a solved scene: the findings of all rows, grouped by rule.

#[cfg(feature = "scene")]
pub(crate) mod bounds;
#[cfg(feature = "cli")]
pub mod html;
#[cfg(feature = "data")]
pub mod json;
#[cfg(feature = "data")]
pub mod npz;
#[cfg(feature = "scene")]
pub mod text;
#[cfg(feature = "scene")]
pub(crate) mod tip;
#[cfg(feature = "data")]
pub(crate) mod tip_json;

use crate::contact::{Boundary, Finding, Severity, in_unit};
use crate::scene::{Dimension, Regime, Row, Run, Scene};

/// The verdict on all rows so far.
#[derive(Default)]
pub struct Verdict {
    findings: Vec<(Finding, u64)>,
    rows: u64,
    invalid: u64,
    unfinished: u64,
    largest: f64,
    /// Minimum number of radii at which an unproven row was checked.
    radii: Option<u64>,
    regime: Option<Regime>,
}

/// Returns a verdict in words; an unproven verdict includes the number of radii that were checked.
pub(super) fn words(valid: bool, radii: Option<u64>) -> String {
    match (valid, radii) {
        (false, _) => "not valid".to_owned(),
        (true, None) => "valid".to_owned(),
        (true, Some(radii)) => format!("valid at {radii} radii"),
    }
}

/// The assumptions for an axisymmetric indenter.
pub const ASSUMPTIONS: &str = "frictionless contact of an axisymmetric indenter with an elastic half-space, without adhesion";
/// The assumptions for a flat punch with a non-circular cross-section.
const ASSUMPTIONS_OF_PUNCH: &str =
    "frictionless contact of a flat punch of the given cross-section with an elastic half-space, without adhesion";

/// Returns the assumptions of a scene.
pub(super) fn assumptions(scene: &Scene) -> &'static str {
    if scene.round { ASSUMPTIONS } else { ASSUMPTIONS_OF_PUNCH }
}

/// Returns the name of the edge of a contact.
pub(super) fn edge(boundary: Boundary) -> &'static str {
    match boundary {
        Boundary::Rim => "rim",
        Boundary::Smooth => "smooth",
        Boundary::Apart => "apart",
    }
}

impl Verdict {
    /// Adds a row.
    pub fn take(&mut self, row: &Row) {
        self.rows += 1;
        self.invalid += u64::from(row.validity() == Some(false));
        self.unfinished += u64::from(row.validity().is_none());
        if let Some(radii) = row.indented.radii.filter(|_| row.is_valid()) {
            self.radii = Some(self.radii.map_or(radii, |known| known.min(radii)));
        }
        if let Some(state) = row.indented.state {
            self.largest = self.largest.max(state.radius);
        }
        if let Some(own) = row.regime
            && self.regime.is_none_or(|known| own.force_error.abs() > known.force_error.abs())
        {
            self.regime = Some(own);
        }
        for finding in &row.indented.findings {
            match self.findings.iter_mut().find(|(known, _)| known.rule == finding.rule) {
                Some((_, count)) => *count += 1,
                None => self.findings.push((finding.clone(), 1)),
            }
        }
    }

    /// Adds the findings about the profile within the largest contact.
    pub fn close(&mut self, run: &Run<'_>) {
        self.findings.extend(tip::findings(run).into_iter().map(|own| (own, 0)));
        let length = run.scene().system.out(Dimension::LENGTH);
        for (at, jump) in run.kinks().into_iter().filter(|(at, jump)| *at < self.largest * length && *jump > 0.0) {
            let unit = run.scene().system.unit_name(Dimension::LENGTH);
            let place = in_unit(at, &(1.0, unit));
            let message = format!("the slope of the profile jumps by {jump:.3} at r = {place}, where the pressure is infinite");
            self.findings.push((Finding { rule: "kink", severity: Severity::Warning, message, at: Some(at) }, 0));
        }
    }

    /// Returns whether every row is valid; `None` if the budget was exhausted before that was known.
    pub fn validity(&self) -> Option<bool> {
        match (self.invalid, self.unfinished) {
            (0, 0) => Some(true),
            (0, _) => None,
            _ => Some(false),
        }
    }

    /// Returns the verdict on all rows in words, with the number of rows to which it applies if it is not that all are valid.
    pub fn words(&self) -> String {
        match self.validity() {
            Some(true) => words(true, self.radii),
            Some(false) => format!("not valid in {} of {} rows", self.invalid, self.rows),
            None => format!("not known in {} of {} rows", self.unfinished, self.rows),
        }
    }

    /// Returns the minimum number of radii at which an unproven row was checked; `None` if every row is proven, or one is unfinished.
    pub fn radii(&self) -> Option<u64> {
        self.radii.filter(|_| self.unfinished == 0)
    }

    /// Returns the first finding of every rule and the number of affected rows, which is zero for findings about the whole profile.
    pub fn findings(&self) -> &[(Finding, u64)] {
        &self.findings
    }

    /// Returns the row with the largest difference from its simple shape.
    pub fn regime(&self) -> Option<&Regime> {
        self.regime.as_ref()
    }

    /// Returns the number of invalid rows and the number of all rows.
    pub fn counts(&self) -> (u64, u64) {
        (self.invalid, self.rows)
    }
}
