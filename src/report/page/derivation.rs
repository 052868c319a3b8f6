//! The page of a derivation: one equation per quantity, then conditions, notes and the check.

use super::sources::Sources;
use super::{Block, Page, definitions};
use crate::contact::Quantity;
use crate::expr::Formula;
use crate::print::Prose;
use crate::report::{Derivation, Entry, text};

impl Page {
    /// Creates the page of the result of `derive`.
    pub fn of_derivation(record: &Derivation<'_>) -> Self {
        let presentation = record.presentation;
        let mut page = Self::new("Derived relations", false, presentation);
        page.parametrize(record.formula(), presentation);
        // A requested f is listed among the other quantities.
        if !record.asked.contains(&Quantity::Profile) {
            page.equation("f", &presentation.name("f(r)"), &presentation.formula(record.formula()), Sources::default());
        }
        if let Some(shift) = record.shift() {
            let remark = Prose::read("$f(0)$ = ").formula(shift.clone()).then(" is subtracted, so that $f$ starts at 0");
            page.blocks.push(Block::Remark(remark.presented(presentation)));
        }
        let mut shown = vec![record.formula().clone()];
        let entries = record.entries();
        for entry in &entries {
            match &entry.derived {
                Some(derived) => {
                    let sources = Sources::of(derived);
                    page.equation(entry.key, &presentation.name(entry.left), &presentation.formula(&derived.formula), sources);
                    shown.push(derived.formula.clone());
                }
                // For a rim, a(d) does not exist, as a note explains.
                None if record.has_rim() => {}
                None => page
                    .blocks
                    .push(Block::Sentence(Prose::default().then(&format!("${}$: no explicit form", presentation.name(entry.left))))),
            }
        }
        page.close(record, &entries, &shown);
        page
    }

    fn close(&mut self, record: &Derivation<'_>, entries: &[Entry<'_>], shown: &[Formula]) {
        self.list("Conditions", "condition", record.conditions());
        self.close_steps(record, entries, shown);
    }

    /// Adds the notes and the check.
    pub(super) fn close_steps(&mut self, record: &Derivation<'_>, entries: &[Entry<'_>], shown: &[Formula]) {
        self.list("Notes", "note", record.notes(entries).into_iter().chain(definitions::of(shown)).collect());
        self.list("Check against quadrature of f as typed", "check", vec![Prose::words(&text::outcome(&record.check))]);
    }
}
