//! What a rule is: one family of exact solutions, as data plus one function.

use crate::derive::term::Term;
use crate::expr::{Condition, Expr, shown_as_mathematics};
use crate::integrate::segment::Segment;

/// One family of exact solutions.
///
/// `pattern`, `equivalent`, `force` and `pressure` are the rule's statement in the program's own grammar; tests hold them
/// against the code and against quadrature, the documentation prints them, and the inverse reads them from g to f.
pub struct Rule {
    /// Short name, as reports cite it.
    pub id: &'static str,
    /// A description of the profiles.
    pub title: &'static str,
    /// f(r).
    pub pattern: &'static str,
    /// g(x).
    pub equivalent: &'static str,
    /// F(a), with E for the effective modulus.
    pub force: &'static str,
    /// p(r) under a smooth edge, where it closes.
    pub pressure: Option<&'static str>,
    /// The pattern's parameters with the intervals that tests sample.
    pub parameters: &'static [Parameter],
    /// Under which conditions it holds, as the documentation says it.
    pub guard: &'static str,
    /// Where it comes from.
    pub reference: &'static [&'static str],
    /// The more general rule that this one is a nicer form of.
    pub specializes: Option<&'static str>,
    /// Matches a term and answers it, or declines.
    pub apply: fn(&Term) -> Option<Answer>,
}

/// A parameter of a rule's pattern.
pub struct Parameter {
    /// Its name in the pattern.
    pub name: &'static str,
    /// The smallest sampled value.
    pub lowest: f64,
    /// The largest sampled value.
    pub highest: f64,
}

/// The exact contribution of one term; every part is in closed form.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The contribution to g(x), over the symbol x.
    pub equivalent: Branches,
    /// The contribution to F(a)/(2E*), over the symbol a.
    pub force: Branches,
    /// ∫_r^a g′(x)/√(x²−r²) dx, which is p(r)·π/E*, over the symbols r and a.
    pub pressure: Option<Branches>,
    /// The conditions of validity.
    pub conditions: Vec<Condition>,
}

/// The contribution of a segment [b, c): within it, and beyond its upper end.
#[derive(Clone, Debug)]
pub struct Branches {
    /// For b < x ≤ c.
    pub within: Pair,
    /// For x > c; the same as `within` where the segment has no upper end.
    pub beyond: Pair,
}

/// A formula as it is shown and as it is evaluated; tests hold the two equal.
#[derive(Clone, Debug)]
pub struct Pair {
    /// As a careful author prints it.
    pub shown: Expr,
    /// Free of cancellation.
    pub evaluated: Expr,
}

impl Answer {
    /// Every formula replaced by the result of `form`; printed ones have no stable functions, inside which `form` finds nothing.
    #[must_use]
    pub(crate) fn map(&self, form: &dyn Fn(&Expr) -> Expr) -> Self {
        let pair = |own: &Pair| Pair { shown: form(&shown_as_mathematics(&own.shown)), evaluated: form(&own.evaluated) };
        let branches = |own: &Branches| Branches { within: pair(&own.within), beyond: pair(&own.beyond) };
        Self {
            equivalent: branches(&self.equivalent),
            force: branches(&self.force),
            pressure: self.pressure.as_ref().map(branches),
            conditions: self.conditions.clone(),
        }
    }
}

impl Pair {
    /// One expression for both; its stable functions print as what they equal.
    pub fn same(expr: Expr) -> Self {
        Self { shown: expr.clone(), evaluated: expr }
    }

    /// Both multiplied by a factor.
    pub fn scaled(&self, factor: &Expr) -> Self {
        Self { shown: factor * &self.shown, evaluated: factor * &self.evaluated }
    }

    /// The difference of two.
    pub(crate) fn minus(&self, other: &Self) -> Self {
        Self { shown: &self.shown - &other.shown, evaluated: &self.evaluated - &other.evaluated }
    }
}

impl Branches {
    /// Both multiplied by a factor.
    pub fn scaled(&self, factor: &Expr) -> Self {
        Self { within: self.within.scaled(factor), beyond: self.beyond.scaled(factor) }
    }

    /// The answer of a segment by its parts from either end outward: the lower end's, less the upper end's beyond that.
    pub(crate) fn from_ends(segment: &Segment, from: impl Fn(&Expr) -> Pair) -> Self {
        let within = from(&segment.lower);
        let beyond = segment.upper.as_ref().map_or_else(|| within.clone(), |upper| within.minus(&from(upper)));
        Self { within, beyond }
    }

    /// The answer of a segment without upper end.
    pub fn endless(pair: Pair) -> Self {
        Self { beyond: pair.clone(), within: pair }
    }
}
