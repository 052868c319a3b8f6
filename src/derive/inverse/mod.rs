//! The inverse transform f(r) = (2/π) ∫₀^r g(x)/√(r²−x²) dx: a profile from its equivalent profile, exact if a rule applies.
//!
//! Three methods are tried in this order: a statement read from g to f, powers by 1/κ_n, and the forward rules.
//! The last method reuses the forward rules because the integral has the same form, with g instead of f′.

mod pressure;
mod statement;
mod table;
mod unify;

pub use pressure::{FromPressure, equivalent_of_pressure};
pub use statement::Reader;
pub use table::{InverseRule, TABLE};

use crate::derive::assemble::{Derived, Status};
use crate::derive::chain::Chain;
use crate::derive::domain::located::is_approximate;
use crate::derive::profile::Profile;
use crate::derive::rule::{Branches, Pair};
use crate::derive::rules;
use crate::derive::rules::kappa;
use crate::derive::term;
use crate::derive::term::Term;
use crate::expr::normal::{self, NormalTerm};
use crate::expr::{Bindings, Condition, Expr, Formula, Sign, Symbol, sign};
use crate::integrate::error::TransformError;
use crate::integrate::segment::Segment;
use crate::num::work;
use statement::InvertedTerms;

/// A profile f(r) that was found from an equivalent profile g(x).
pub struct Inverse {
    /// g over r, examined like every profile: its pieces, its kinks and the range where it is real.
    pub equivalent: Profile,
    /// The conditions under which f is valid.
    pub conditions: Vec<Condition>,
    pub(crate) chains: Vec<InverseChain>,
}

/// The pieces of g between breakpoints, with their contributions to f.
pub(crate) struct InverseChain {
    pub(crate) breakpoints: Vec<Expr>,
    pub(crate) intervals: Vec<InverseInterval>,
}

pub(crate) struct InverseInterval {
    pub(crate) segment: Segment,
    closed: Vec<Share>,
    /// The part of g on this interval that no rule inverts.
    pub(crate) open: Expr,
}

/// The contribution of some terms of g to f.
struct Share {
    id: &'static str,
    reference: Vec<&'static str>,
    /// Over r.
    f: Branches,
}

impl Share {
    fn from_statement(found: InvertedTerms, conditions: &mut Vec<Condition>) -> Self {
        conditions.extend(found.conditions);
        Self { id: found.id, reference: found.reference.to_vec(), f: Branches::endless(Pair::same(found.f)) }
    }
}

/// Finds f(r) from g(x), given over x; `read` turns the statements of rules into formulas.
///
/// ```
/// use sneddon::{parse, print, transform};
/// let read = |text: &str| parse::formula(text).ok();
/// let sphere = transform::invert(&parse::equivalent("x*atanh(x/R)").unwrap(), read).unwrap();
/// assert_eq!(print::text(&sphere.profile().formula), "R - sqrt(R^2 - r^2)");
/// ```
///
/// # Errors
/// [`TransformError`] if g jumps, has no finite value at the axis, or its pieces cannot be separated.
pub fn invert(g: &Formula, read: Reader) -> Result<Inverse, TransformError> {
    work::bounded(|| solve(g, read))
}

fn solve(g: &Formula, read: Reader) -> Result<Inverse, TransformError> {
    let equivalent = Profile::new(&over_radius(g))?;
    let mut conditions = equivalent.conditions.clone();
    let mut chains = Vec::new();
    for chain in &equivalent.chains {
        chains.extend(solve_chain(chain, read, &mut conditions));
    }
    conditions.sort();
    conditions.dedup();
    conditions.retain(|c| c.decided() != Some(true));
    Ok(Inverse { equivalent, conditions, chains })
}

/// g over r in place of x, breakpoints included.
fn over_radius(g: &Formula) -> Formula {
    let radius = Bindings::one("x", Expr::symbol("r"));
    match g.substitute(&radius) {
        Formula::Piecewise { pieces, last, .. } => Formula::Piecewise { variable: Symbol::new("r"), pieces, last },
        Formula::Sum(parts) => Formula::Sum(parts.iter().map(over_radius).collect()),
        Formula::Scaled(factor, inner) => Formula::Scaled(factor, Box::new(over_radius(&inner))),
        other => other,
    }
}

/// Splits a chain into terms; terms common to all pieces act on the whole axis and form a separate chain.
fn solve_chain(chain: &Chain, read: Reader, conditions: &mut Vec<Condition>) -> Vec<InverseChain> {
    let radius = Symbol::new("r");
    let mut parts: Vec<Option<Vec<NormalTerm>>> = chain.pieces.iter().map(|piece| normal::normal_terms(piece, &radius).ok()).collect();
    let mut common: Vec<NormalTerm> = Vec::new();
    if let [Some(first), others @ ..] = parts.as_slice() {
        let everywhere = |part: &&NormalTerm| others.iter().all(|list| list.as_ref().is_some_and(|list| list.contains(*part)));
        common = first.iter().filter(everywhere).cloned().collect();
    }
    for list in parts.iter_mut().flatten() {
        list.retain(|part| !common.contains(part));
    }
    let mut chains = Vec::new();
    if !common.is_empty() {
        let mut own = whole(common.clone(), read, conditions);
        if let ([only], true) = (chain.pieces.as_slice(), own.closed.is_empty()) {
            // Use the typed form, because the recognition form may cancel near its zeros.
            own.open = only.clone();
        }
        chains.push(InverseChain { breakpoints: Vec::new(), intervals: vec![own] });
    }
    if parts.iter().all(|list| list.as_ref().is_some_and(Vec::is_empty)) {
        return chains;
    }
    // A worn shape: zero up to the only breakpoint.
    let worn = match (parts.as_slice(), chain.breakpoints.as_slice()) {
        ([Some(first), Some(_)], [breakpoint]) if first.is_empty() && !is_approximate(breakpoint) => Some(breakpoint),
        _ => None,
    };
    let mut intervals = Vec::new();
    for (index, ((lower, upper, piece), list)) in chain.intervals().zip(parts).enumerate() {
        let segment = Segment { lower, upper: upper.cloned() };
        let rough = is_approximate(&segment.lower) || segment.upper.as_ref().is_some_and(is_approximate);
        let Some(mut list) = list.filter(|_| !rough) else {
            let shared = Expr::sum(common.iter().map(|part| part.to_expr(&radius)));
            intervals.push(InverseInterval { segment, closed: Vec::new(), open: piece - shared });
            continue;
        };
        let mut closed = Vec::new();
        if let (Some(breakpoint), 1) = (worn, index) {
            for found in statement::read_backwards(&mut list, Some(breakpoint), read) {
                closed.push(Share::from_statement(found, conditions));
            }
        }
        let mut own = by_rules(term::split(list, &segment), segment, closed, conditions);
        if own.closed.is_empty() && common.is_empty() {
            own.open = piece.clone();
        }
        intervals.push(own);
    }
    chains.push(InverseChain { breakpoints: chain.breakpoints.clone(), intervals });
    chains
}

/// The terms that act on the whole axis.
fn whole(mut terms: Vec<NormalTerm>, read: Reader, conditions: &mut Vec<Condition>) -> InverseInterval {
    let mut closed = Vec::new();
    for found in statement::read_backwards(&mut terms, None, read) {
        closed.push(Share::from_statement(found, conditions));
    }
    let mut powers: Vec<(Expr, Expr)> = Vec::new();
    terms.retain(|term| {
        let finite = matches!(sign(&term.exponent), Sign::Positive | Sign::Zero);
        if term.kernel.is_one() && finite {
            // Statements may leave a further term with the same power.
            match powers.iter_mut().find(|(n, _)| *n == term.exponent) {
                Some((_, own)) => *own = &*own + &term.coefficient,
                None => powers.push((term.exponent.clone(), term.coefficient.clone())),
            }
            return false;
        }
        true
    });
    for (n, coefficient) in powers.into_iter().filter(|(_, c)| !normal::is_proven_zero(c, &Symbol::new("r"))) {
        let f = coefficient / kappa(&n) * Expr::symbol("r").pow(&n);
        closed.push(Share { id: "inverse-power", reference: vec!["Popov & Heß (3.14)–(3.16)"], f: Branches::endless(Pair::same(f)) });
    }
    let segment = Segment::whole();
    by_rules(term::split(terms, &segment), segment, closed, conditions)
}

/// Applies the forward rules to terms of f′ with the form of these terms of g: x ∫ f′/√(x²−r²) dr is then (π/2) r f(r).
fn by_rules(terms: Vec<Term>, segment: Segment, mut closed: Vec<Share>, conditions: &mut Vec<Condition>) -> InverseInterval {
    let mut open = Vec::new();
    for term in terms {
        let Some((rule, answer)) = rules::answer(&term) else {
            open.push(term.f_prime());
            continue;
        };
        conditions.extend(answer.conditions);
        let f = |pair: &Pair| Pair { shown: from_equivalent(&pair.shown), evaluated: from_equivalent(&pair.evaluated) };
        let reference = rule.reference.iter().copied().chain(["inverse Abel transform"]).collect();
        closed.push(Share {
            id: rule.id,
            reference,
            f: Branches { within: f(&answer.equivalent.within), beyond: f(&answer.equivalent.beyond) },
        });
    }
    InverseInterval { segment, closed, open: Expr::sum(open) }
}

/// 2/(π r) times an expression over x, with x = r.
fn from_equivalent(equivalent: &Expr) -> Expr {
    let (r, two) = (Expr::symbol("r"), Expr::integer(2));
    let over_radius = Bindings::one("x", r.clone()).apply(equivalent);
    let factor = two / (Expr::pi() * r);
    Expr::sum(over_radius.terms().iter().map(|term| &factor * term))
}

impl Inverse {
    /// f(r) with its status, rules and sources.
    pub fn profile(&self) -> Derived {
        let (mut rules, mut reference) = (Vec::new(), vec!["Popov & Heß (3.27), solved for f"]);
        for share in self.chains.iter().flat_map(|chain| &chain.intervals).flat_map(|interval| &interval.closed) {
            if !rules.contains(&share.id) {
                rules.push(share.id);
                reference.extend(share.reference.iter().filter(|r| !reference.contains(r)).copied().collect::<Vec<_>>());
            }
        }
        let open = self.intervals().any(|interval| !interval.open.is_zero());
        let closed = self.intervals().any(|interval| !interval.closed.is_empty());
        let status = match (closed, open) {
            (_, false) => Status::Exact,
            (false, true) => Status::Numeric,
            (true, true) => Status::Partial,
        };
        let formula = Formula::sum(self.chains.iter().map(InverseChain::formula));
        Derived { formula, status, compared: None, split: false, rules, reference }
    }

    /// f(0) = g(0), which does not affect a contact.
    pub fn at_axis(&self) -> &Expr {
        &self.equivalent.shift
    }

    fn intervals(&self) -> impl Iterator<Item = &InverseInterval> {
        self.chains.iter().flat_map(|chain| &chain.intervals)
    }
}

impl InverseChain {
    /// The closed contributions to f for r in the given interval.
    pub(crate) fn closed(&self, interval: usize, pick: impl Fn(&Pair) -> &Expr) -> Expr {
        let shares = self.intervals.iter().enumerate().take(interval + 1);
        Expr::sum(shares.flat_map(|(index, own)| {
            let pick = &pick;
            own.closed.iter().map(move |share| pick(if index < interval { &share.f.beyond } else { &share.f.within }).clone())
        }))
    }

    fn formula(&self) -> Formula {
        let mut values = (0..self.intervals.len()).map(|interval| {
            let closed = self.closed(interval, |pair| &pair.shown);
            let open = self.intervals.iter().take(interval + 1).filter(|own| !own.open.is_zero()).map(|own| self.integral(own, interval));
            Formula::sum(std::iter::once(Formula::Closed(closed)).chain(open))
        });
        let pieces: Vec<(Formula, Expr)> = values.by_ref().take(self.breakpoints.len()).zip(self.breakpoints.iter().cloned()).collect();
        let last = values.next().unwrap_or_else(Formula::zero);
        if pieces.is_empty() { last } else { Formula::Piecewise { variable: Symbol::new("r"), pieces, last: Box::new(last) } }
    }

    /// (2/π) ∫ g/√(r²−x²) dx over one interval, as far as it lies below r.
    fn integral(&self, own: &InverseInterval, interval: usize) -> Formula {
        let (r, x) = (Expr::symbol("r"), Expr::symbol("x"));
        let ended = own.segment.upper.clone().filter(|upper| self.breakpoints.iter().take(interval).any(|b| b == upper));
        let integral = Formula::Integral {
            integrand: Box::new(Formula::Closed(Bindings::one("r", x.clone()).apply(&own.open) / (r.power(2) - x.power(2)).sqrt())),
            variable: Symbol::new("x"),
            lower: own.segment.lower.clone(),
            upper: ended.unwrap_or(r),
        };
        integral.scaled(&(Expr::integer(2) / Expr::pi()))
    }
}
