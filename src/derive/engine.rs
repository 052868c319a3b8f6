//! The derivation: split a profile into terms, match each with the rules, collect the answers.

use crate::derive::angles;
use crate::derive::chain::Chain;
use crate::derive::domain::above_zero::above_zero;
use crate::derive::domain::decided::{decided_for_all, drop_implied};
use crate::derive::domain::demands;
use crate::derive::domain::located::is_approximate;
use crate::derive::profile::Profile;
use crate::derive::rules;
use crate::derive::solved::{Agreement, SolvedChain, SolvedInterval, SolvedTerm};
use crate::derive::term;
use crate::derive::term::Term;
use crate::derive::verification::{Demotion, Gate, Verification};
use crate::expr::normal::NormalTerm;
use crate::expr::{Condition, Expr, Relation, Symbol, derivative, normal};
use crate::integrate::error::TransformError;
use crate::integrate::segment::Segment;
use crate::num::work;
use std::borrow::Cow;

/// A profile with the solution of every term: exact if a rule applies, otherwise an integral.
#[derive(Clone)]
pub struct Solution {
    /// The profile.
    pub profile: Profile,
    /// Its chains, solved term by term.
    pub chains: Vec<SolvedChain>,
    /// The conditions of the profile and of the rules.
    pub conditions: Vec<Condition>,
    /// The results of comparing every term with quadrature.
    pub verification: Verification,
}

/// Derives the solution of a profile: superposition (3.25)–(3.26) of the solutions of its terms.
///
/// # Errors
/// [`TransformError`] if a function has no derivative.
///
/// ```
/// use sneddon::{parse, transform};
/// let profile = transform::Profile::new(&parse::profile("r^2/(2*R)").unwrap()).unwrap();
/// let solution = transform::derive(&profile).unwrap();
/// assert!(solution.is_closed());
/// ```
pub fn derive(profile: &Profile) -> Result<Solution, TransformError> {
    work::bounded(|| solve(profile))
}

fn solve(profile: &Profile) -> Result<Solution, TransformError> {
    let mut conditions = profile.conditions.clone();
    let (mut chains, mut verification) = (Vec::new(), Verification::default());
    let gate = Gate::new(profile, &profile.conditions);
    for chain in &profile.chains {
        let slopes = chain.f_primes()?;
        let parts = |index: usize| {
            let (f_prime, piece) = (slopes.get(index)?, chain.pieces.get(index)?);
            normal_parts(f_prime).or_else(|| normal_parts(&slope_of_polynomial(piece)?))
        };
        let mut solved = solve_chain(chain, &slopes, parts);
        if !gate.recognition_holds(chain, &slopes, &solved) {
            verification.demoted.push(Demotion { rule: "recognition", quantity: "f'" });
            solved = solve_chain(chain, &slopes, |_| None);
        }
        chains.extend(solved);
    }
    for term in chains.iter_mut().flat_map(|chain| &mut chain.intervals).flat_map(|interval| &mut interval.terms) {
        gate.judge(term, &mut verification);
    }
    for term in chains.iter().flat_map(|chain| &chain.intervals).flat_map(|interval| &interval.terms) {
        if let Some((_, answer)) = &term.answer {
            // State signs as the profile does: b < R instead of 0 < R − b.
            let is_sign = |own: &Condition| own.relation == Relation::Less && own.left.is_zero();
            let stated = |own: &Condition| if is_sign(own) { above_zero(&own.right).unwrap_or_else(|| own.clone()) } else { own.clone() };
            conditions.extend(answer.conditions.iter().map(stated));
        }
    }
    // The pressure of an open term is an integral over (r f′)′, without which the result would be incomplete.
    for (_, f_prime) in chains.iter().flat_map(|chain| chain.remainder(SolvedTerm::has_open_pressure)) {
        derivative(&(Expr::symbol("r") * f_prime), &Symbol::new("r"))?;
    }
    conditions.extend(demands::of_either_sign(&profile.demands, &conditions));
    conditions.sort();
    conditions.dedup();
    conditions.retain(|own| decided_for_all(own) != Some(true));
    drop_implied(&mut conditions);
    Ok(Solution { profile: profile.clone(), chains, conditions, verification })
}

/// The terms of f′; an expression that cannot be expanded is a single term without a rule.
///
/// Coefficients that vanish by trigonometric identities, such as tan θ − sin θ/cos θ, are dropped.
fn normal_parts(f_prime: &Expr) -> Option<Vec<NormalTerm>> {
    let radius = Symbol::new("r");
    let mut terms = normal::normal_terms(f_prime, &radius).ok()?;
    terms.retain(|term| !angles::cancels(&term.coefficient));
    Some(terms)
}

/// The derivative of a polynomial, expanded first: that of a long product or of nested factors is far longer.
fn slope_of_polynomial(piece: &Expr) -> Option<Expr> {
    let radius = Symbol::new("r");
    let list = normal::polynomial_coefficients(piece, &radius)?;
    derivative(&Expr::sum(list.into_iter().zip(0_i64..).map(|(c, k)| c * Expr::from(radius.clone()).power(k))), &radius).ok()
}

/// Splits a chain into terms; terms common to all intervals act on the whole axis and form a separate chain.
fn solve_chain(chain: &Chain, slopes: &[Expr], parts: impl Fn(usize) -> Option<Vec<NormalTerm>>) -> Vec<SolvedChain> {
    let radius = Symbol::new("r");
    let mut parts: Vec<Option<Vec<NormalTerm>>> = (0..slopes.len()).map(parts).collect();
    let mut common: Vec<NormalTerm> = Vec::new();
    if let [Some(first), others @ ..] = parts.as_slice()
        && !others.is_empty()
    {
        let everywhere = |part: &&NormalTerm| others.iter().all(|list| list.as_ref().is_some_and(|list| list.contains(*part)));
        common = first.iter().filter(everywhere).cloned().collect();
    }
    for list in parts.iter_mut().flatten() {
        list.retain(|part| !common.contains(part));
    }
    let mut chains = Vec::new();
    if !common.is_empty() {
        let f_prime = Expr::sum(common.iter().map(|part| part.to_expr(&radius)));
        let intervals = vec![solve_interval(Segment::whole(), f_prime, Some(common.clone()))];
        chains.push(SolvedChain { breakpoints: Vec::new(), intervals });
    }
    let mut intervals = Vec::new();
    for (index, (f_prime, list)) in slopes.iter().cloned().zip(parts).enumerate() {
        let lower = index.checked_sub(1).and_then(|i| chain.breakpoints.get(i)).cloned().unwrap_or_else(Expr::zero);
        let segment = Segment { lower, upper: chain.breakpoints.get(index).cloned() };
        let f_prime = match (&list, common.is_empty()) {
            (Some(list), false) => Expr::sum(list.iter().map(|part| part.to_expr(&radius))),
            _ => f_prime,
        };
        intervals.push(solve_interval(segment, f_prime, list));
    }
    chains.push(SolvedChain { breakpoints: chain.breakpoints.clone(), intervals });
    chains
}

fn solve_interval(segment: Segment, f_prime: Expr, parts: Option<Vec<NormalTerm>>) -> SolvedInterval {
    let terms = match parts {
        Some(parts) => term::split(parts, &segment),
        None => vec![whole(&f_prime, &segment)],
    };
    // No formula is exact if a breakpoint was located numerically.
    let rough = is_approximate(&segment.lower) || segment.upper.as_ref().is_some_and(is_approximate);
    let mut length = 0;
    let mut answer = |term: &Term| {
        let found = if rough || length >= rules::LARGEST { None } else { rules::answer(term) };
        length += found.as_ref().map_or(0, |(_, own)| own.equivalent.within.shown.size_up_to(rules::LARGEST));
        found
    };
    let mut solved = |term: Term| SolvedTerm { answer: answer(&term), term, agreement: Agreement::default() };
    let mut terms: Vec<SolvedTerm> = rules::reading::remembered(|| terms.into_iter().map(&mut solved).collect());
    if length >= rules::LARGEST {
        terms = vec![SolvedTerm { answer: None, term: whole(&f_prime, &segment), agreement: Agreement::default() }];
    }
    SolvedInterval { segment, f_prime, terms }
}

fn whole(f_prime: &Expr, segment: &Segment) -> Term {
    let part = NormalTerm { coefficient: Expr::one(), exponent: Expr::zero(), kernel: f_prime.clone() };
    Term { parts: vec![part], segment: segment.clone() }
}

impl Solution {
    /// Returns the solution without the answers whose conditions are broken; their terms are integrated instead.
    pub(crate) fn without_answers(&self, is_broken: impl Fn(&Condition) -> bool) -> Cow<'_, Self> {
        let fails = |term: &SolvedTerm| term.answer.as_ref().is_some_and(|(_, own)| own.conditions.iter().any(&is_broken));
        if !self.terms().any(fails) {
            return Cow::Borrowed(self);
        }
        let mut own = self.clone();
        let terms = own.chains.iter_mut().flat_map(|chain| &mut chain.intervals).flat_map(|interval| &mut interval.terms);
        terms.filter(|term| fails(term)).for_each(|term| term.answer = None);
        Cow::Owned(own)
    }

    /// Warnings about closed forms that were rejected.
    pub fn warnings(&self) -> Vec<String> {
        self.verification.demoted.iter().map(Demotion::text).collect()
    }

    /// True if every term has an exact solution for g and F.
    pub fn is_closed(&self) -> bool {
        self.terms().all(|term| term.answer.is_some())
    }

    /// Every term of every interval.
    pub fn terms(&self) -> impl Iterator<Item = &SolvedTerm> {
        self.chains.iter().flat_map(|chain| &chain.intervals).flat_map(|interval| &interval.terms)
    }
}

impl SolvedChain {
    /// f′ of the terms selected by `left_out`, per interval; zero if it selects none.
    ///
    /// If it selects every term of an interval, the derivative is returned as typed.
    pub(crate) fn remainder(&self, left_out: impl Fn(&SolvedTerm) -> bool) -> Vec<(Segment, Expr)> {
        self.intervals
            .iter()
            .map(|interval| {
                let picked: Vec<Expr> = interval.terms.iter().filter(|t| left_out(t)).map(|t| t.term.f_prime()).collect();
                let f_prime = if picked.is_empty() {
                    Expr::zero()
                } else if picked.len() == interval.terms.len() {
                    interval.f_prime.clone()
                } else {
                    Expr::sum(picked)
                };
                (interval.segment.clone(), f_prime)
            })
            .collect()
    }
}

impl SolvedTerm {
    /// True if g and F of the term remain integrals.
    pub fn is_open(&self) -> bool {
        self.answer.is_none()
    }

    /// True if the pressure of the term remains an integral.
    pub fn has_open_pressure(&self) -> bool {
        self.answer.as_ref().is_none_or(|(_, answer)| answer.pressure.is_none())
    }
}

/// The expression expanded with respect to a variable, or unchanged if the expansion is too large.
pub(crate) fn expanded_or_same(expr: &Expr, variable: &str) -> Expr {
    normal::expanded(expr, &Symbol::new(variable)).unwrap_or_else(|_| expr.clone())
}
