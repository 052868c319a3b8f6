//! A formula as mathematics is laid out, before any notation writes it.

use crate::expr::{Constant, Function, Relation};
use crate::print::notations::greek;

/// One part of a formula.
#[derive(Clone)]
pub(super) enum Math {
    /// Digits, and the power of ten that they are multiplied with.
    Number { mantissa: String, exponent: Option<i64> },
    /// A parameter or a variable.
    Name(String),
    /// π or e.
    Constant(Constant),
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Math)>),
    /// −m.
    Negative(Box<Math>),
    /// Adjacent factors.
    Product(Vec<Math>),
    /// A built-up fraction.
    Fraction(Box<Math>, Box<Math>),
    /// A fraction on one line, as in exponents.
    Slash(Box<Math>, Box<Math>),
    /// The root of this degree.
    Root(i64, Box<Math>),
    /// A base and its exponent.
    Power(Box<Math>, Box<Math>),
    /// Parentheses as tall as what they hold.
    Parentheses(Box<Math>),
    /// A function.
    Call(Call),
    /// Pieces over a variable: each value with the end of its range, then the last value.
    Cases { variable: String, pieces: Vec<(Math, Math)>, last: Box<Math> },
    /// ∫ from `lower` to `upper`; an integrand of 1 is left out.
    Integral { integrand: Option<Box<Math>>, variable: String, lower: Box<Math>, upper: Box<Math> },
    /// A relation between two sides.
    Relation(Box<Math>, Relation, Box<Math>),
}

/// A function with its arguments.
#[derive(Clone)]
pub(super) struct Call {
    pub(super) function: Function,
    /// The argument that is set as an index of the name, or as its order.
    pub(super) index: Option<Box<Math>>,
    /// An exponent at the name, as in sin²θ.
    pub(super) power: Option<Box<Math>>,
    /// The arguments, in groups.
    pub(super) groups: Vec<Vec<Math>>,
    /// Whether the argument follows the name without parentheses.
    pub(super) bare: bool,
}

impl Math {
    /// True if this part, or one within it, has a property.
    pub(super) fn any(&self, has: &dyn Fn(&Self) -> bool) -> bool {
        has(self) || self.children().into_iter().any(|child| child.any(has))
    }

    fn children(&self) -> Vec<&Self> {
        match self {
            Self::Number { .. } | Self::Name(_) | Self::Constant(_) => Vec::new(),
            Self::Sum(terms) => terms.iter().map(|(_, term)| term).collect(),
            Self::Product(factors) => factors.iter().collect(),
            Self::Negative(inner) | Self::Root(_, inner) | Self::Parentheses(inner) => vec![inner],
            Self::Fraction(one, other) | Self::Slash(one, other) | Self::Power(one, other) | Self::Relation(one, _, other) => {
                vec![one, other]
            }
            Self::Call(call) => call.index.iter().chain(&call.power).map(Box::as_ref).chain(call.groups.iter().flatten()).collect(),
            Self::Cases { pieces, last, .. } => pieces.iter().flat_map(|(value, end)| [value, end]).chain([last.as_ref()]).collect(),
            Self::Integral { integrand, lower, upper, .. } => {
                integrand.iter().map(Box::as_ref).chain([lower.as_ref(), upper.as_ref()]).collect()
            }
        }
    }

    /// About how many letters wide it is set.
    pub(super) fn breadth(&self) -> usize {
        let script = |inner: &Self| (2 * inner.breadth()).div_ceil(3);
        match self {
            Self::Number { mantissa, exponent } => mantissa.chars().count() + exponent.map_or(0, |own| 3 + own.to_string().len()),
            Self::Name(name) => {
                // A Greek letter is one letter, and an index is small.
                let words = name.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
                words.map(|word| if greek::letter(word).is_some() { 1 } else { word.chars().count() }).sum::<usize>().max(1)
            }
            Self::Constant(_) => 1,
            Self::Sum(terms) => terms.iter().map(|(_, term)| term.breadth() + 3).sum(),
            Self::Fraction(upper, lower) => upper.breadth().max(lower.breadth()) + 1,
            Self::Power(base, exponent) => base.breadth() + script(exponent),
            Self::Cases { pieces, last, .. } => {
                let row = |value: &Self, end: usize| value.breadth() + end + 8;
                let end = pieces.iter().map(|(_, end)| 2 * end.breadth()).max().unwrap_or(0);
                pieces.iter().map(|(value, _)| row(value, end)).chain([row(last, end)]).max().unwrap_or(0)
            }
            Self::Integral { integrand, lower, upper, .. } => {
                integrand.as_ref().map_or(0, |own| own.breadth()) + script(lower).max(script(upper)) + 4
            }
            Self::Call(call) => {
                let name = call.function.row().typeset.letters.text.chars().count();
                let scripts: usize = call.index.iter().chain(&call.power).map(|own| script(own)).sum();
                name + scripts + 2 + call.groups.iter().flatten().map(|own| own.breadth() + 2).sum::<usize>()
            }
            other => other.children().iter().map(|child| child.breadth()).sum::<usize>() + 2,
        }
    }

    /// The first thing on the line.
    pub(super) fn first(&self) -> &Self {
        match self {
            Self::Product(factors) => factors.first().map_or(self, Self::first),
            Self::Slash(upper, _) => upper.first(),
            Self::Power(base, _) => base.first(),
            Self::Sum(terms) => terms.first().filter(|(negative, _)| !negative).map_or(self, |(_, term)| term.first()),
            _ => self,
        }
    }

    /// The last thing on the line.
    pub(super) fn last(&self) -> &Self {
        match self {
            Self::Product(factors) => factors.last().map_or(self, Self::last),
            Self::Slash(_, lower) => lower.last(),
            Self::Sum(terms) => terms.last().map_or(self, |(_, term)| term.last()),
            _ => self,
        }
    }

    /// True for a function with an index in front of its name, such as ₂F₁.
    pub(super) fn has_prescript(&self) -> bool {
        matches!(self, Self::Call(call) if call.prescript().is_some())
    }
}

impl Call {
    /// The numbers of upper and lower parameters of a hypergeometric function.
    pub(super) fn prescript(&self) -> Option<(usize, usize)> {
        match self.groups.as_slice() {
            [upper, lower, _] => Some((upper.len(), lower.len())),
            _ => None,
        }
    }
}
