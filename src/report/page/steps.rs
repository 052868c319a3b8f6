//! The page of a step-by-step derivation.

use super::sources::Sources;
use super::{Block, Page, sources};
use crate::contact::Step;
use crate::print::{Presentation, Prose};
use crate::report::Derivation;

impl Page {
    /// Creates a page with the numbered steps of a derivation, then notes and the check.
    pub fn of_steps(record: &Derivation<'_>, steps: &[Step]) -> Self {
        let mut page = Self::of_numbered("Derivation", steps, record.presentation);
        page.parametrize(record.formula(), record.presentation);
        let entries = record.entries();
        let shown: Vec<_> = entries.iter().filter_map(|entry| Some(entry.derived.as_ref()?.formula.clone())).collect();
        page.close_steps(record, &entries, &shown);
        page
    }

    /// Creates a page of numbered steps.
    pub fn of_numbered(title: &str, steps: &[Step], presentation: &Presentation) -> Self {
        let mut page = Self::new(title, true, presentation);
        page.steps(steps, "", 1, presentation);
        page
    }

    fn steps(&mut self, steps: &[Step], number: &str, level: usize, presentation: &Presentation) {
        for (at, step) in steps.iter().enumerate() {
            let number = if number.is_empty() { (at + 1).to_string() } else { format!("{number}.{}", at + 1) };
            self.heading(level, &format!("{number} {}", step.title));
            if let (Some(left), Some(right)) = (&step.left, &step.right) {
                self.equation(
                    &format!("step-{}", number.replace('.', "-")),
                    &presentation.name(left),
                    &presentation.formula(right),
                    Sources::default(),
                );
            }
            let mut reason = step.reason.presented(presentation);
            if !step.reference.is_empty() {
                let sources = format!(" [{}]", sources::joined(&step.reference, "", str::to_owned));
                reason = reason.followed_by(&Prose::words(&sources));
            }
            if !reason.is_empty() {
                self.blocks.push(Block::Sentence(reason));
            }
            self.steps(&step.steps, &number, level + 1, presentation);
        }
    }
}
