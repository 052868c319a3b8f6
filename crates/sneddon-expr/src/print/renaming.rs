//! Renaming of the symbols of an answer, as the notation of a journal or a thesis may require.

use crate::expr::{Bindings, Condition, Expr, Formula, Symbol};

/// Symbol names and their displayed replacements.
#[derive(Clone, Debug, Default)]
pub struct Renaming(Vec<(String, String)>);

impl Renaming {
    /// Creates a renaming from pairs of a name and its displayed replacement.
    ///
    /// ```
    /// use sneddon_expr::{expr::Expr, print::{self, Renaming}};
    /// let names = Renaming::new(vec![("d".to_owned(), "delta".to_owned())]);
    /// assert_eq!(print::latex(&names.formula(&Expr::symbol("d").into())), r"\delta");
    /// assert_eq!(names.name("a(d)"), "a(delta)");
    /// ```
    pub fn new(pairs: Vec<(String, String)>) -> Self {
        Self(pairs)
    }

    /// True if every name stays.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The name under which this one is shown; in the value of a function, as g(x), both names may have others.
    pub fn name(&self, name: &str) -> String {
        let mut shown = String::with_capacity(name.len());
        let mut word = String::new();
        for letter in name.chars() {
            if letter.is_alphanumeric() || letter == '_' {
                word.push(letter);
            } else {
                shown.push_str(&self.word(&std::mem::take(&mut word)));
                shown.push(letter);
            }
        }
        shown + &self.word(&word)
    }

    fn word(&self, word: &str) -> String {
        let new = |own: &str| self.0.iter().find(|(old, _)| old == own).map(|(_, new)| new.clone());
        // g_1 is a contribution to g.
        let numbered = || {
            let (letter, index) = word.rsplit_once('_')?;
            let is_number = !index.is_empty() && index.chars().all(|own| own.is_ascii_digit());
            Some(format!("{}_{index}", new(letter).filter(|_| is_number)?))
        };
        new(word).or_else(numbered).unwrap_or_else(|| word.to_owned())
    }

    /// The formula with its symbols renamed, bound variables as well.
    pub fn formula(&self, formula: &Formula) -> Formula {
        if self.is_empty() {
            return formula.clone();
        }
        match formula {
            Formula::Closed(expr) => Formula::Closed(self.expr(expr)),
            Formula::Sum(parts) => Formula::Sum(parts.iter().map(|part| self.formula(part)).collect()),
            Formula::Scaled(factor, inner) => Formula::Scaled(self.expr(factor), Box::new(self.formula(inner))),
            Formula::Piecewise { variable, pieces, last } => Formula::Piecewise {
                variable: self.symbol(variable),
                pieces: pieces.iter().map(|(value, end)| (self.formula(value), self.expr(end))).collect(),
                last: Box::new(self.formula(last)),
            },
            Formula::Integral { integrand, variable, lower, upper } => Formula::Integral {
                integrand: Box::new(self.formula(integrand)),
                variable: self.symbol(variable),
                lower: self.expr(lower),
                upper: self.expr(upper),
            },
        }
    }

    /// The condition with its symbols renamed.
    pub fn condition(&self, condition: &Condition) -> Condition {
        Condition { left: self.expr(&condition.left), relation: condition.relation, right: self.expr(&condition.right) }
    }

    fn symbol(&self, symbol: &Symbol) -> Symbol {
        Symbol::new(&self.name(symbol.name()))
    }

    fn expr(&self, expr: &Expr) -> Expr {
        let mut bindings = Bindings::default();
        for symbol in expr.symbols() {
            let name = self.name(symbol.name());
            if name != symbol.name() {
                bindings.insert(symbol, Expr::symbol(&name));
            }
        }
        bindings.apply(expr)
    }
}
