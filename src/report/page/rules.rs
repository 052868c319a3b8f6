//! The page of the catalogue of exact solutions: a list of all rules, then each with its formulas, domain and sources.

use super::sources::Sources;
use super::{Block, Page};
use crate::print::{Presentation, Prose};
use crate::report::Statement;

impl Page {
    /// Creates the page of the catalogue.
    pub fn of_rules(statements: &[Statement]) -> Self {
        let mut page = Self::new("Exact solutions", true, &Presentation::default());
        page.has_separate_sections = true;
        page.sentence(Prose::read(
            "Each rule solves one family of terms of $f'(r)$; the solution of a profile is the sum of the solutions of its terms",
        ));
        page.sentence(Prose::read("Parameters are positive, $E$ is the effective modulus, and $F$ and $p$ belong to a smooth edge"));
        page.sentence(Prose::words("If no pressure is stated, it remains an integral over the closed form of the equivalent profile"));
        page.sentence(Prose::read(
            "The formula of a family is an example: the rule also solves terms with other parameters, with additional powers of $r$ and, if stated, on segments",
        ));
        page.list("Contents", "rule", statements.iter().map(|own| Prose::words(&format!("{}: {}", own.rule.id, own.rule.title))).collect());
        statements.iter().for_each(|own| page.rule(own));
        page
    }

    fn rule(&mut self, statement: &Statement) {
        let rule = statement.rule;
        self.heading(1, rule.id);
        self.sentence(Prose::words(rule.title));
        let mut formulas = vec![("f(r)", &statement.pattern), ("g(x)", &statement.equivalent), ("F(a)", &statement.force)];
        formulas.extend(statement.pressure.as_ref().map(|own| ("p(r)", own)));
        for (left, right) in formulas {
            self.equation("", left, right, Sources::default());
        }
        let mut item = |own: Prose| self.blocks.push(Block::Item("rule", own));
        item(Prose::words(&format!("As typed: {}", rule.pattern)));
        item(Prose::words(&format!("Where: {}", rule.guard)));
        if let Some(general) = rule.specializes {
            item(Prose::words(&format!("A special form of {general}")));
        }
        item(Prose::words(&format!("Source: {}", rule.reference.join("; "))));
    }
}
