//! The page of an inversion: the input, f(r), conditions, notes and the check; also step by step.

use super::Page;
use super::sources::Sources;
use crate::contact::Step;
use crate::expr::Formula;
use crate::print::{Presentation, Prose};
use crate::report::{Inversion, text};

impl Page {
    /// Creates the page of the result of `invert`.
    pub fn of_inversion(record: &Inversion<'_>, presentation: &Presentation) -> Self {
        let mut page = Self::new("Profile of an equivalent profile", false, presentation);
        page.parametrize(record.equivalent, presentation);
        let mut state = |key: &str, left: &str, right: &Formula, sources| {
            page.equation(key, &presentation.name(left), &presentation.formula(right), sources)
        };
        if let Some(wanted) = &record.pressure {
            for (key, left, expr) in [("p", "p(r)", wanted.pressure), ("d", "d", wanted.depth), ("F", "F", wanted.force)] {
                state(key, left, &expr.clone().into(), Sources::default());
            }
        }
        state("g", "g(x)", record.equivalent, Sources::default());
        state("f", "f(r)", &record.profile.formula, Sources::of(&record.profile));
        page.close_inversion(record, presentation);
        page
    }

    /// Creates a page with the numbered steps of an inversion, followed by the result.
    pub fn of_inverse_steps(record: &Inversion<'_>, steps: &[Step], presentation: &Presentation) -> Self {
        let mut page = Self::of_numbered("From the equivalent profile to the profile", steps, presentation);
        page.parametrize(record.equivalent, presentation);
        page.close_inversion(record, presentation);
        page
    }

    fn close_inversion(&mut self, record: &Inversion<'_>, presentation: &Presentation) {
        self.list(
            "Conditions",
            "condition",
            record.conditions.iter().map(|own| Prose::default().condition(presentation.condition(own))).collect(),
        );
        self.list("Notes", "note", record.notes(presentation));
        self.list("Check against quadrature of g as typed", "check", vec![Prose::words(&text::outcome(&record.check))]);
    }
}
