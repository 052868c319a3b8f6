//! Statements that are read from g to f: the inverse table, and the reversed statement of every rule.

use super::table::TABLE;
use super::unify;
use crate::derive::domain;
use crate::derive::rule::Parameter;
use crate::derive::rules::{RULES, reading};
use crate::expr::normal::{self, NormalTerm};
use crate::expr::{Bindings, Condition, Expr, Formula, Node, Sign, Symbol, sign};
use crate::num::work;
use std::collections::BTreeSet;
use std::sync::OnceLock;

/// Parses the text of a statement into a formula; this module does not parse text itself.
pub type Reader = fn(&str) -> Option<Formula>;

/// A statement as expressions over r: g with its terms, and f.
struct Statement {
    id: &'static str,
    reference: &'static [&'static str],
    parameters: Vec<Symbol>,
    /// For a worn shape, the parameter at which both g and f begin.
    breakpoint: Option<Symbol>,
    g: Expr,
    terms: Vec<NormalTerm>,
    f: Expr,
}

/// f of some terms of g, with the rule that was applied.
pub(super) struct InvertedTerms {
    pub(super) id: &'static str,
    pub(super) reference: &'static [&'static str],
    pub(super) f: Expr,
    pub(super) conditions: Vec<Condition>,
}

/// A parsed statement with its non-elementary functions; its terms are computed when first needed.
struct Entry {
    id: &'static str,
    reference: &'static [&'static str],
    g: Formula,
    f: Formula,
    parameters: Vec<Symbol>,
    /// True if f may have a different height at the axis, which does not affect the transform.
    shifted: bool,
    functions: BTreeSet<&'static str>,
    statement: OnceLock<Option<Statement>>,
}

impl Entry {
    fn statement(&self) -> Option<&Statement> {
        self.statement.get_or_init(|| work::uncounted(|| Statement::new(self))).as_ref()
    }
}

/// Every parsed statement, the inverse table first because its results are shorter.
///
/// The statements are parsed once, when a kernel first needs them, so all callers must pass equivalent readers.
fn entries(read: Reader) -> &'static [Entry] {
    static READ: OnceLock<Vec<Entry>> = OnceLock::new();
    let all = || {
        let table = TABLE.iter().map(|rule| (rule.id, rule.reference, rule.pattern, rule.result, rule.parameters, false));
        let rules = RULES.iter().map(|rule| (rule.id, rule.reference, rule.equivalent, rule.pattern, rule.parameters, true));
        table.chain(rules).filter_map(|own| entry(own, read)).collect()
    };
    READ.get_or_init(|| work::uncounted(all))
}

type Stated = (&'static str, &'static [&'static str], &'static str, &'static str, &'static [Parameter], bool);

fn entry((id, reference, g, f, parameters, shifted): Stated, read: Reader) -> Option<Entry> {
    let (g, f) = (read(g)?, read(f)?);
    let mut functions = BTreeSet::new();
    match &g {
        Formula::Closed(g) => collect(g, &mut functions),
        Formula::Piecewise { last, .. } => collect(last.as_closed()?, &mut functions),
        _ => return None,
    }
    let parameters = parameters.iter().map(|p| Symbol::new(p.name)).collect();
    Some(Entry { id, reference, g, f, parameters, shifted, functions, statement: OnceLock::new() })
}

/// The non-elementary functions, which the recognition form does not transform into other functions.
fn collect(expr: &Expr, found: &mut BTreeSet<&'static str>) {
    if let Node::Function(function, _) = expr.node()
        && function.row().complex.is_none()
    {
        found.insert(function.name());
    }
    for child in expr.children() {
        collect(child, found);
    }
}

/// Removes terms from g that a statement inverts, until no statement applies.
///
/// With a breakpoint, the terms begin there, and only worn shapes are considered.
pub(super) fn read_backwards(terms: &mut Vec<NormalTerm>, breakpoint: Option<&Expr>, read: Reader) -> Vec<InvertedTerms> {
    let mut found = Vec::new();
    let open = |list: &[NormalTerm]| list.iter().filter(|term| !term.kernel.is_one()).count();
    while open(terms) > 0 {
        let mut present = BTreeSet::new();
        terms.iter().for_each(|term| collect(&term.kernel, &mut present));
        // A statement with a function that g lacks does not apply.
        let possible = entries(read).iter().filter(|entry| entry.functions.is_subset(&present)).filter_map(Entry::statement);
        let possible: Vec<&Statement> = possible.filter(|own| own.breakpoint.is_some() == breakpoint.is_some()).collect();
        let targets = terms.iter().filter(|term| !term.kernel.is_one());
        let candidates = targets.flat_map(|target| {
            let terms: &[NormalTerm] = terms;
            possible.iter().filter_map(move |statement| statement.explains(target, terms, breakpoint))
        });
        // Choose the statement that removes the most terms, or the first of several.
        let best = candidates.reduce(|best, other| if open(&other.1) < open(&best.1) { other } else { best });
        let Some((own, rest)) = best else { break };
        found.push(own);
        *terms = rest;
    }
    found
}

impl Statement {
    fn new(entry: &Entry) -> Option<Self> {
        let radius = Symbol::new("r");
        let over_radius = Bindings::one("x", Expr::symbol("r"));
        let (breakpoint, g, f) = match (&entry.g, &entry.f) {
            (Formula::Closed(g), Formula::Closed(f)) => (None, g, f),
            (Formula::Piecewise { pieces, last: g, .. }, Formula::Piecewise { pieces: others, last: f, .. }) => {
                let ([(before, end)], [(also, same)]) = (pieces.as_slice(), others.as_slice()) else { return None };
                if !before.is_zero() || !also.is_zero() || end != same {
                    return None;
                }
                (Some(end.as_symbol()?.clone()), g.as_closed()?, f.as_closed()?)
            }
            _ => return None,
        };
        let g = over_radius.apply(g);
        let mut terms = normal::normal_terms(&g, &radius).ok()?;
        terms.retain(|term| !term.kernel.is_one());
        // The most specific term comes first.
        terms.sort_by_key(|term| std::cmp::Reverse(term.kernel.size_up_to(1000)));
        let begins = !entry.shifted || breakpoint.is_some();
        let shift = if begins { Expr::zero() } else { domain::value_at_axis(f, &mut Vec::new()).ok()? };
        Some(Self { id: entry.id, reference: entry.reference, parameters: entry.parameters.clone(), breakpoint, g, terms, f: f - shift })
    }

    /// f and the remaining terms, if all terms of this statement match, including the target.
    fn explains(&self, target: &NormalTerm, terms: &[NormalTerm], breakpoint: Option<&Expr>) -> Option<(InvertedTerms, Vec<NormalTerm>)> {
        let known: Bindings = self.breakpoint.iter().zip(breakpoint).map(|(own, place)| (own.name(), place.clone())).collect();
        self.terms.iter().find_map(|pattern| {
            let pair = ((&pattern.exponent, &pattern.kernel), (&target.exponent, &target.kernel));
            self.taken_out(unify::unified(pair.0, pair.1, &self.parameters, &known)?, target, terms)
        })
    }

    /// Matches with all amplitudes set to 1, or one to 1 and the others to 0; the ratio of coefficients replaces their values.
    fn taken_out(&self, values: Bindings, target: &NormalTerm, terms: &[NormalTerm]) -> Option<(InvertedTerms, Vec<NormalTerm>)> {
        let amplitudes: Vec<&Symbol> = self.parameters.iter().filter(|own| values.get(own).is_none()).collect();
        let with = |only: Option<&Symbol>| {
            let mut all = values.clone();
            for own in &amplitudes {
                all.insert((*own).clone(), if only.is_none_or(|only| only == *own) { Expr::one() } else { Expr::zero() });
            }
            self.matched(&values, &all, target, terms)
        };
        let alone = if amplitudes.len() > 1 { amplitudes.as_slice() } else { &[] };
        with(None).or_else(|| alone.iter().find_map(|only| with(Some(only))))
    }

    fn matched(
        &self,
        solved: &Bindings,
        values: &Bindings,
        target: &NormalTerm,
        terms: &[NormalTerm],
    ) -> Option<(InvertedTerms, Vec<NormalTerm>)> {
        let radius = Symbol::new("r");
        let mut conditions = Vec::new();
        for (_, value) in solved.iter() {
            conditions.extend(reading::positive(value)?);
        }
        let own = normal::normal_terms(&values.apply(&self.g), &radius).ok()?;
        let same = |one: &NormalTerm, other: &NormalTerm| one.exponent == other.exponent && one.kernel == other.kernel;
        let ratio = &target.coefficient / &own.iter().find(|term| same(term, target))?.coefficient;
        let mut rest = terms.to_vec();
        for term in own {
            let taken = &ratio * &term.coefficient;
            let place = rest.iter().position(|other| same(other, &term));
            let left = place.and_then(|i| rest.get(i)).map_or_else(Expr::zero, |other| other.coefficient.clone()) - taken;
            if let Some(place) = place {
                rest.remove(place);
            }
            if normal::is_proven_zero(&left, &radius) {
                continue;
            }
            // Remaining powers are solved separately; all other terms must cancel.
            let plain = term.kernel.is_one() && matches!(sign(&term.exponent), Sign::Positive | Sign::Zero);
            if !plain || self.breakpoint.is_some() {
                return None;
            }
            rest.push(NormalTerm { coefficient: left, ..term });
        }
        let f = ratio * values.apply(&self.f);
        Some((InvertedTerms { id: self.id, reference: self.reference, f, conditions }, rest))
    }
}
