//! How a formula was found: a line for a terminal, a sentence for a document.

use crate::transform::{Derived, Status};

/// The book whose equations most rules cite.
pub(super) const BOOK: &str = "Popov & Heß";

/// The status of a formula, its rules and its references; nothing for a formula that was given.
#[derive(Clone, Default)]
pub(super) struct Sources {
    status: Option<Status>,
    /// False for a formula that is not an integral and was not compared with quadrature.
    compared: bool,
    rules: Vec<&'static str>,
    references: Vec<&'static str>,
}

impl Sources {
    pub(super) fn of(derived: &Derived) -> Self {
        // An integral is quadrature itself.
        let compared = derived.compared != Some(false) || derived.status == Status::Numeric;
        Self { status: Some(derived.status), compared, rules: derived.rules.clone(), references: derived.reference.clone() }
    }

    /// The words of the command line, as in `exact | rule sphere | Popov & Heß (3.27)`; `None` for a formula that was given.
    pub(super) fn line(&self) -> Option<String> {
        let rules = match self.rules.as_slice() {
            [] => String::new(),
            [rule] => format!(" | rule {rule}"),
            rules => format!(" | rules {}", rules.join(", ")),
        };
        let references = joined(&self.references, "", str::to_owned);
        let references = if references.is_empty() { references } else { format!(" | {references}") };
        let compared = if self.compared { "" } else { ", not compared with quadrature" };
        Some(format!("{}{compared}{rules}{references}", self.status?.name()))
    }

    /// A sentence, as in `In closed form: Popov & Heß (3.27), (3.30).`, with its words written by `escape`; `None` for a formula that
    /// was given, such as the depth under a rim.
    ///
    /// The equations of the book are one reference, with `citation` behind its authors.
    pub(super) fn sentence(&self, citation: &str, escape: impl Fn(&str) -> String) -> Option<String> {
        let status = match self.status? {
            Status::Exact if self.references.is_empty() => return None,
            Status::Exact => "In closed form",
            Status::Partial => "Partly in closed form",
            Status::Numeric => "Left as an integral",
        };
        let compared = if self.compared { "" } else { ", not compared with quadrature" };
        let references = joined(&self.references, citation, escape);
        let references = if references.is_empty() { references } else { format!(": {references}") };
        Some(format!("{status}{compared}{references}."))
    }
}

/// References with the equations of the book as one, with `citation` behind its authors.
pub(super) fn joined(references: &[&'static str], citation: &str, escape: impl Fn(&str) -> String) -> String {
    // The general formula is equation (3.27) of the book.
    let equation = |own: &&'static str| own.strip_prefix("general formula, ").unwrap_or(own).strip_prefix(BOOK).map(str::trim);
    let mut equations: Vec<&str> = Vec::new();
    for own in references.iter().filter_map(equation).flat_map(|own| own.split(", ")) {
        if !equations.contains(&own) {
            equations.push(own);
        }
    }
    let book = (!equations.is_empty()).then(|| format!("{}{citation} {}", escape(BOOK), escape(&equations.join(", "))));
    let others = references.iter().filter(|own| equation(own).is_none()).map(|own| escape(own));
    book.into_iter().chain(others).collect::<Vec<_>>().join("; ")
}
