//! The list of exact solutions, with one line and one file per family.

pub(crate) mod abel;
mod axial;
mod bessel;
mod combination;
mod difference_of_squares;
mod error_function;
mod gaussian;
mod gaussian_bessel;
mod hypergeometric;
pub(crate) mod laurent;
mod linear;
mod log_linear;
mod moments;
mod outside;
mod pole;
mod polynomial_segment;
mod power;
mod power_log;
mod quadratic;
mod quadratic_wave;
pub(crate) mod reading;
mod root;
mod segment_power;
mod series;
mod shifted_power;
mod struve;
mod wave;

pub use axial::axial;
pub use outside::outside;
pub use power::kappa;

use crate::derive::angles;
use crate::derive::rule::{Answer, Rule};
use crate::derive::term::Term;
use crate::expr::normal::NormalTerm;
use crate::expr::{Condition, Expr};
use crate::integrate::segment::Segment;
use crate::num::work;

/// Every rule; the order is irrelevant, because rules are disjoint or name the rule that they specialise.
pub static RULES: &[&Rule] = &[
    &power::RULE,
    &polynomial_segment::RULE,
    &root::SPHERE,
    &root::WORN_SPHERE,
    &root::HYPERBOLOID,
    &root::WORN_HYPERBOLOID,
    &quadratic::pole::ODD,
    &quadratic::pole::ODD_BELOW,
    &quadratic::pole::EVEN,
    &quadratic::pole::EVEN_BELOW,
    &quadratic::pole::WORN_ODD,
    &quadratic::pole::WORN_ODD_BELOW,
    &quadratic::pole::WORN_EVEN,
    &quadratic::pole::WORN_EVEN_BELOW,
    &quadratic::logarithm::ABOVE,
    &quadratic::logarithm::BELOW,
    &quadratic::logarithm::WORN_ABOVE,
    &quadratic::logarithm::WORN_BELOW,
    &power_log::RULE,
    &power_log::ON_SEGMENT,
    &linear::RATIONAL,
    &linear::ROOT,
    &log_linear::RULE,
    &bessel::FIRST_KIND,
    &bessel::MODIFIED,
    &wave::CIRCULAR,
    &wave::HYPERBOLIC,
    &wave::EXPONENTIAL,
    &quadratic_wave::WHOLE,
    &quadratic_wave::SEGMENT,
    &gaussian::DECAY,
    &gaussian::GROWTH,
    &gaussian::SEGMENT,
    &gaussian_bessel::RULE,
    &error_function::ERROR_FUNCTION,
    &error_function::DAWSON,
    &struve::STRUVE,
    &struve::MODIFIED_STRUVE,
    &struve::BESSEL_SQUARE,
    &struve::MODIFIED_BESSEL_SQUARE,
    &quadratic::arcs::ATAN_EVEN,
    &quadratic::arcs::ATAN_ODD,
    &quadratic::arcs::ATANH_EVEN,
    &quadratic::arcs::ATANH_ODD,
    &quadratic::arcs::WORN_ATAN,
    &quadratic::arcs::WORN_ATANH,
    &quadratic::arcs::ASINH_EVEN,
    &quadratic::arcs::ASINH_ODD,
    &quadratic::arcs::ASIN_EVEN,
    &quadratic::arcs::ASIN_ODD,
    &quadratic::arcs::WORN_ASINH,
    &quadratic::arcs::WORN_ASIN,
    &quadratic::roots::ODD,
    &quadratic::roots::ODD_BELOW,
    &quadratic::roots::WORN_ODD,
    &quadratic::roots::WORN_ODD_BELOW,
    &quadratic::roots::EVEN,
    &quadratic::roots::EVEN_BELOW,
    &quadratic::roots::WORN_EVEN,
    &quadratic::roots::WORN_EVEN_BELOW,
    &quadratic::binomial::WHOLE,
    &quadratic::binomial::WHOLE_BELOW,
    &quadratic::binomial::WORN,
    &quadratic::binomial::WORN_BELOW,
    &segment_power::NEGATIVE,
    &segment_power::REAL,
    &shifted_power::RULE,
    &difference_of_squares::RULE,
    GENERAL,
];

/// The fallback rule, used if no other rule applies; it agrees with every other rule that applies to the same term.
pub static GENERAL: &Rule = &hypergeometric::RULE;

/// Steps of work after which a rule is abandoned.
const LONGEST: u64 = 50_000_000;
/// Largest formula of g, in nodes, for a term and for all terms of an interval together; larger ones remain integrals.
///
/// With the 8340 nodes of `(1+r/b)^(61/2)`, g has 29 000 characters.
pub(super) const LARGEST: usize = 6_000;

/// The rule for a term, with its result; rules that exceed the work limit or the size limit are skipped.
///
/// Where no rule but the general one applies, sines, cosines and tangents of constant angles in the kernel count as positive, which
/// becomes a condition: sqrt(h² + r² tan²θ) is a hyperboloid.
pub fn answer(term: &Term) -> Option<(&'static Rule, Answer)> {
    let direct = nicest(term);
    let is_special = direct.as_ref().is_some_and(|own| own.0.id != GENERAL.id);
    if is_special || !term.parts.iter().any(|part| angles::has_angle(&part.kernel)) {
        return direct;
    }
    let kernels = Expr::sum(term.parts.iter().map(|part| part.kernel.clone()));
    let positive = angles::Positive::of(&kernels);
    let part = |own: &NormalTerm| NormalTerm {
        coefficient: positive.replaced(&own.coefficient),
        exponent: own.exponent.clone(),
        kernel: positive.replaced(&own.kernel),
    };
    let segment =
        Segment { lower: positive.replaced(&term.segment.lower), upper: term.segment.upper.as_ref().map(|own| positive.replaced(own)) };
    let replaced = Term { parts: term.parts.iter().map(part).collect(), segment };
    let found = nicest(&replaced).filter(|own| own.0.id != GENERAL.id);
    let restored = |own: Answer| {
        let stated = own.conditions.iter().map(|own| Condition {
            left: positive.restored(&own.left),
            relation: own.relation,
            right: positive.restored(&own.right),
        });
        let conditions = stated.chain(angles::conditions(std::iter::once(&kernels))).collect();
        Answer { conditions, ..own.map(&|expr| positive.restored(expr)) }
    };
    found.map(|(rule, own)| (rule, restored(own))).or(direct)
}

fn nicest(term: &Term) -> Option<(&'static Rule, Answer)> {
    let is_short = |own: &Answer| own.equivalent.within.shown.size_up_to(LARGEST) < LARGEST;
    let apply = |rule: &'static Rule| {
        let found = if work::is_exhausted() { None } else { work::share(LONGEST, || (rule.apply)(term)).flatten() };
        Some((rule, found.filter(is_short)?))
    };
    let answers: Vec<(&'static Rule, Answer)> = RULES.iter().filter(|rule| rule.id != GENERAL.id).filter_map(|rule| apply(rule)).collect();
    let general: Vec<&str> = answers.iter().filter_map(|(rule, _)| rule.specializes).collect();
    let found = answers.into_iter().find(|(rule, _)| !general.contains(&rule.id)).or_else(|| apply(GENERAL));
    if !angles::has_angle(&term.segment.lower) && !term.segment.upper.as_ref().is_some_and(angles::has_angle) {
        return found;
    }
    found.map(|(rule, own)| (rule, own.map(&angles::without_roots)))
}
