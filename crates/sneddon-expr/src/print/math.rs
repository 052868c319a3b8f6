//! A formula as mathematics is laid out, before any notation writes it.

use crate::expr::function::Setting;
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
    ///
    /// Of 333 formulas in LaTeX at 10 pt, 90 % had 3.2 to 4.7 pt per letter, and none more than 4.9 pt.
    pub(super) fn breadth(&self) -> usize {
        (self.points() / LETTER).ceil() as usize
    }

    /// The width in points at a font size of 10 pt.
    fn points(&self) -> f64 {
        let tall = |inner: &Self| inner.any(&|part| matches!(part, Self::Fraction(..) | Self::Integral { .. } | Self::Cases { .. }));
        match self {
            Self::Number { mantissa, exponent } => {
                let power = exponent.map_or(0.0, |own| 17.2 + SCRIPT * digits(&own.to_string()));
                digits(mantissa) + power
            }
            Self::Name(name) if name.contains('(') => {
                // The value of a function.
                name.split(['(', ')', ',']).map(|own| Self::Name(own.trim().to_owned()).points()).sum::<f64>() + 8.0
            }
            Self::Name(name) => {
                // An index is small.
                let words = name.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
                let word = |own: &str| match greek::letter(own) {
                    Some(_) => 5.5,
                    // E stands for the effective modulus and has a star.
                    None if name == "E" => 12.4,
                    None => own.chars().map(letter_points).sum(),
                };
                words.enumerate().map(|(place, own)| if place == 0 { word(own) } else { SCRIPT * word(own) + 0.5 }).sum()
            }
            Self::Constant(_) => 5.7,
            Self::Sum(terms) => {
                let first = if terms.first().is_some_and(|own| own.0) { 7.8 } else { 0.0 };
                first + 12.2 * terms.len().saturating_sub(1) as f64 + terms.iter().map(|own| own.1.points()).sum::<f64>()
            }
            Self::Negative(inner) => 7.8 + inner.points(),
            Self::Product(factors) => factors.iter().map(|own| own.points() + 1.2).sum(),
            Self::Fraction(upper, lower) => upper.points().max(lower.points()) + 2.4,
            Self::Slash(upper, lower) => upper.points() + lower.points() + 5.0,
            Self::Root(_, inner) => inner.points() + if tall(inner) { 10.0 } else { 8.3 },
            Self::Power(base, exponent) => base.points() + SCRIPT * exponent.points() + 0.5,
            Self::Parentheses(inner) => inner.points() + if tall(inner) { 14.7 } else { 8.0 },
            Self::Cases { pieces, last, .. } => {
                let end = pieces.iter().map(|(_, end)| 2.0 * end.points()).fold(0.0, f64::max);
                pieces.iter().map(|own| &own.0).chain([last.as_ref()]).map(|value| value.points() + end + 42.0).fold(0.0, f64::max)
            }
            Self::Integral { integrand, lower, upper, .. } => {
                let limits = SCRIPT * lower.points().max(upper.points());
                integrand.as_ref().map_or(0.0, |own| own.points()) + limits + 22.0
            }
            Self::Relation(left, _, right) => left.points() + right.points() + 13.3,
            Self::Call(call) => call.points(call.groups.iter().flatten().any(tall)),
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

/// The width of a letter in points, so small that formulas of 72 letters fit in a column of 345 pt.
const LETTER: f64 = 4.4;
/// The size of exponents and indices.
const SCRIPT: f64 = 0.78;

fn letter_points(letter: char) -> f64 {
    match letter {
        'M' | 'W' => 10.0,
        other if other.is_uppercase() => 7.5,
        _ => 5.2,
    }
}

fn digits(text: &str) -> f64 {
    text.chars().map(|own| if own == '.' { 2.8 } else { 5.0 }).sum()
}

impl Call {
    fn points(&self, is_tall: bool) -> f64 {
        let name = 5.0 * self.function.row().typeset.letters.text.chars().count() as f64;
        let scripts: f64 = self.index.iter().chain(&self.power).map(|own| SCRIPT * own.points() + 0.5).sum();
        let arguments: f64 = self.groups.iter().flatten().map(|own| own.points() + 4.5).sum();
        let fence = if self.bare { 1.7 } else { (if is_tall { 14.7 } else { 8.0 }) - 4.5 };
        match self.function.row().typeset.setting {
            Setting::Exponential => 5.0 + SCRIPT * arguments,
            Setting::Absolute => arguments + 5.0,
            _ => name + scripts + arguments + fence,
        }
    }

    /// The numbers of upper and lower parameters of a hypergeometric function.
    pub(super) fn prescript(&self) -> Option<(usize, usize)> {
        match self.groups.as_slice() {
            [upper, lower, _] => Some((upper.len(), lower.len())),
            _ => None,
        }
    }
}
