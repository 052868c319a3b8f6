//! What every format of a solved scene shares: the findings of all rows together, one per rule.

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

/// The verdict on all rows that were seen.
#[derive(Default)]
pub struct Verdict {
    findings: Vec<(Finding, u64)>,
    rows: u64,
    invalid: u64,
    largest: f64,
    /// The fewest radii at which a row without a proof was looked at.
    radii: Option<u64>,
    regime: Option<Regime>,
}

/// A verdict in words: what is not proven says at how many radii it was looked at.
pub(super) fn words(valid: bool, radii: Option<u64>) -> String {
    match (valid, radii) {
        (false, _) => "not valid".to_owned(),
        (true, None) => "valid".to_owned(),
        (true, Some(radii)) => format!("valid at {radii} radii"),
    }
}

/// What every answer about an axially symmetric indenter takes for granted.
pub const ASSUMPTIONS: &str = "frictionless contact of an axially symmetric indenter with an elastic half-space, without adhesion";
/// The same for a flat punch that is not round.
const ASSUMPTIONS_OF_PUNCH: &str =
    "frictionless contact of a flat punch of the given cross-section with an elastic half-space, without adhesion";

/// What the answers to a scene take for granted.
pub(super) fn assumptions(scene: &Scene) -> &'static str {
    if scene.round { ASSUMPTIONS } else { ASSUMPTIONS_OF_PUNCH }
}

/// How a contact ends, as reports name it.
pub(super) fn edge(boundary: Boundary) -> &'static str {
    match boundary {
        Boundary::Rim => "rim",
        Boundary::Smooth => "smooth",
        Boundary::Apart => "apart",
    }
}

impl Verdict {
    /// Takes a row into account.
    pub fn take(&mut self, row: &Row) {
        self.rows += 1;
        self.invalid += u64::from(!row.is_valid());
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

    /// Adds what is true of the profile wherever the contact reached.
    pub fn close(&mut self, run: &Run<'_>) {
        self.findings.extend(tip::findings(run).into_iter().map(|own| (own, 0)));
        let length = run.scene().system.out(Dimension::LENGTH);
        for (at, jump) in run.kinks().into_iter().filter(|(at, jump)| *at < self.largest * length && *jump > 0.0) {
            let unit = run.scene().system.unit_name(Dimension::LENGTH);
            let place = in_unit(at, &(1.0, unit));
            let message = format!("the slope of the profile jumps by {jump:.3} at r = {place}: the pressure is infinite there");
            self.findings.push((Finding { rule: "kink", severity: Severity::Warning, message, at: Some(at) }, 0));
        }
    }

    /// True where every row is valid.
    pub fn is_valid(&self) -> bool {
        self.invalid == 0
    }

    /// The verdict on all rows in words.
    pub fn words(&self) -> String {
        words(self.is_valid(), self.radii)
    }

    /// The fewest radii at which a row without a proof was looked at; `None` where every row is proven.
    pub fn radii(&self) -> Option<u64> {
        self.radii
    }

    /// The first finding of every rule, and in how many rows it stands; none for the profile as a whole.
    pub fn findings(&self) -> &[(Finding, u64)] {
        &self.findings
    }

    /// The row that is farthest from its nearest simple shape.
    pub fn regime(&self) -> Option<&Regime> {
        self.regime.as_ref()
    }

    /// How many rows are invalid, and how many there are.
    pub fn counts(&self) -> (u64, u64) {
        (self.invalid, self.rows)
    }
}
