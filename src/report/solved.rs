//! What every format of a solved scene shares: the findings of all rows together, one per rule.

use crate::contact::{Finding, Severity, in_unit};
use crate::scene::{Dimension, Regime, Row, Run};

/// The verdict on all rows that were seen.
#[derive(Default)]
pub struct Verdict {
    findings: Vec<(Finding, u64)>,
    rows: u64,
    invalid: u64,
    largest: f64,
    regime: Option<Regime>,
}

/// What every answer takes for granted.
pub const ASSUMPTIONS: &str = "frictionless contact of an axially symmetric indenter with an elastic half-space, without adhesion";

impl Verdict {
    /// Takes a row into account.
    pub fn take(&mut self, row: &Row) {
        self.rows += 1;
        self.invalid += u64::from(!row.is_valid());
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
        self.findings.extend(super::solved_tip::findings(run).into_iter().map(|own| (own, 0)));
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
