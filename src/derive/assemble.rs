//! The derived formulas: each term's closed answer or its integral, put together per interval.

use crate::derive::engine::Solution;
use crate::derive::engine::expanded_or_same;
use crate::derive::rules::{self, abel};
use crate::derive::solved::{SolvedChain, SolvedInterval, SolvedTerm};
use crate::derive::superposed::Superposed;
use crate::derive::term::Term;
use crate::derive::verification::{Field, Gate};
use crate::expr::function::pressure_power_in_one_term;
use crate::expr::{
    Bindings, Expr, Formula, Node, Number, Relation, Symbol, collected, derivative, in_lowest_terms, rewritten, shown, shown_as_mathematics,
};
use crate::integrate::error::TransformError;
use crate::integrate::segment::Segment;
use crate::integrate::source::ends::{Growth, growth};
use crate::num::work;
use std::borrow::Cow;

/// Sizes of expressions are compared up to this number of nodes.
const SIZE: usize = 10_000;

/// Steps of work that each node takes when the formula is printed. They are counted when the formula is put together, because
/// nothing is cut while it is printed.
const PRINTING: u64 = 35;

/// How much of a formula is closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// The whole formula.
    Exact,
    /// Some terms stay as integrals.
    Partial,
    /// No term is closed.
    Numeric,
}

impl Status {
    /// The status of a formula that leaves an integral over one of this status.
    pub fn integrated(self) -> Self {
        if self == Self::Numeric { self } else { Self::Partial }
    }

    /// The word that reports use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Partial => "partial",
            Self::Numeric => "numeric",
        }
    }
}

/// A derived formula with the rules and the equations that it rests on.
#[derive(Clone, Debug)]
pub struct Derived {
    /// The formula as it is shown.
    pub formula: Formula,
    /// How much of it is closed.
    pub status: Status,
    /// True if every closed form that a rule gave agreed with quadrature when it was derived; `None` if only a later check
    /// compares it.
    pub compared: Option<bool>,
    /// True if parts of an open pressure are shown in closed form. They are not compared with quadrature when the profile is
    /// derived.
    pub split: bool,
    /// The rules that answered, in the order of the terms.
    pub rules: Vec<&'static str>,
    /// The equations of the source.
    pub reference: Vec<&'static str>,
}

impl Derived {
    /// A formula that was given and rests on nothing.
    pub fn given(formula: Formula) -> Self {
        Self { formula, status: Status::Exact, compared: Some(true), split: false, rules: Vec::new(), reference: Vec::new() }
    }
}

impl Solution {
    /// g(x), the equivalent profile (3.27).
    pub fn equivalent_profile(&self) -> Derived {
        self.derived(Superposed::Equivalent, "x", &Expr::one(), "Popov & Heß (3.27)")
    }

    /// F(a) under a smooth edge, E for the effective modulus.
    pub fn force(&self) -> Derived {
        self.derived(Superposed::Force, "a", &(Expr::integer(2) * Expr::symbol("E")), "Popov & Heß (3.22), (3.25)")
    }

    /// p(r) under a smooth edge, positive in compression; `None` if f′ is so large at a breakpoint that g may jump there,
    /// because then neither ∫ g′/√(x²−r²) dx nor the integral over (r f′)′ is the pressure.
    pub fn pressure(&self) -> Option<Derived> {
        self.chains
            .iter()
            .all(SolvedChain::has_pressure_formula)
            .then(|| self.derived(Superposed::Pressure, "a", &(Expr::symbol("E") / Expr::pi()), "Popov & Heß (3.37)"))
    }

    /// u(r) outside a contact with a smooth edge, (2/π) ∫₀^a g′(x) arcsin(x/r) dx, or −σ_zz(z)·π/E* on the axis,
    /// ∫₀^a g′(x) x(x²+3z²)/(x²+z²)² dx. `None` if a term that stays open has no closed g, or if quadrature contradicts a closed form.
    pub fn field(&self, field: Superposed) -> Option<Derived> {
        let is_open = |term: &SolvedTerm| field.is_open(term);
        let known = |chain: &SolvedChain| {
            let has_open = chain.intervals.iter().flat_map(|own| &own.terms).any(is_open);
            !has_open || (chain.has_pressure_formula() && matches!(chain.g_primes(is_open, |_| false), Ok(Some(_))))
        };
        if !self.chains.iter().all(known) {
            return None;
        }
        let tested = if field == Superposed::Outside { Field::OUTSIDE } else { Field::AXIAL };
        let gate = Gate::new(&self.profile, &self.conditions);
        let mut agreement = true;
        for solved in self.terms() {
            let Some(forms) = field.branches(solved) else { continue };
            agreement &= gate.field_agrees(&tested, &solved.term, &forms)?;
        }
        let derived = self.derived(field, "a", &Expr::one(), "Popov & Heß (3.27)");
        Some(Derived { compared: Some(agreement && derived.status != Status::Numeric), ..derived })
    }

    fn derived(&self, quantity: Superposed, variable: &str, factor: &Expr, reference: &'static str) -> Derived {
        let open = |term: &SolvedTerm| quantity.is_open(term);
        let (mut rules, mut references) = (Vec::new(), vec![reference]);
        let (mut closed, mut left, mut compared) = (0, 0, true);
        for term in self.terms() {
            match &term.answer {
                Some((rule, _)) if !open(term) => {
                    closed += 1;
                    compared &= quantity.agrees(term);
                    if !rules.contains(&rule.id) {
                        rules.push(rule.id);
                        references.extend(rule.reference.iter().filter(|r| !references.contains(r)).copied().collect::<Vec<_>>());
                    }
                }
                _ => left += 1,
            }
        }
        let status = match (closed, left) {
            (_, 0) => Status::Exact,
            (0, _) => Status::Numeric,
            _ => Status::Partial,
        };
        let (mut formulas, mut split) = (Vec::new(), false);
        for chain in self.chains.iter().flat_map(SolvedChain::parts) {
            let open = match quantity {
                Superposed::Pressure => chain.open_pressures(self),
                Superposed::Outside | Superposed::Axial => chain.open_fields(quantity),
                Superposed::Equivalent | Superposed::Force => Vec::new(),
            };
            split |= quantity == Superposed::Pressure && open.iter().any(has_closed_part);
            formulas.push(chain.formula(quantity, variable, open));
        }
        let formula = Formula::sum(formulas);
        let compared = Some(compared && status != Status::Numeric && !split);
        let status = match status {
            _ if split && !formula.has_integral() => Status::Exact,
            Status::Numeric if split => Status::Partial,
            other => other,
        };
        let positive = self.positive_differences();
        let formula = formula.scaled(factor).map(&|own| in_lowest_terms(&without_squares(own, &positive))).with_constants_in_front();
        work::spend(PRINTING * formula.expressions().iter().map(|own| own.size_up_to(SIZE) as u64).sum::<u64>());
        Derived { formula, status, compared, split, rules, reference: references }
    }
}

impl Solution {
    /// The differences that are positive by a condition on the parameters, each preceded by its square.
    fn positive_differences(&self) -> Vec<(Expr, Expr)> {
        let differences = self.conditions.iter().filter(|own| own.relation == Relation::Less).map(|own| &own.right - &own.left);
        differences.filter(|own| own.terms().len() == 2).map(|own| (expanded_or_same(&own.power(2), "r"), own)).collect()
    }
}

/// The expression with √(R² − 2hR + h²) replaced by R − h where h < R.
fn without_squares(expr: &Expr, positive: &[(Expr, Expr)]) -> Expr {
    if positive.is_empty() {
        return expr.clone();
    }
    rewritten(expr, &|own, _| {
        let Node::Power(base, exponent) = own.node() else { return None };
        let first = |own: &Expr| own.terms().first().map_or_else(|| Number::integer(1), |term| term.split_coefficient().0);
        positive.iter().filter(|(own, _)| own.symbols() == base.symbols()).find_map(|(own, root)| {
            let square = expanded_or_same(base, "r");
            let factor = Expr::number(first(&square)) / Expr::number(first(own));
            let is_square = expanded_or_same(&(own * &factor), "r") == square;
            is_square.then(|| root.pow(&(Expr::integer(2) * exponent)) * factor.pow(exponent))
        })
    })
}

/// Formulas of chains with at most this number of intervals are added up for each interval.
const MANY: usize = 8;

impl SolvedChain {
    /// The chains that are added up for each interval: the chain itself or, where it has many intervals, one chain for each of
    /// them, because sums for each interval grow with the square of their number.
    fn parts(&self) -> Vec<Cow<'_, Self>> {
        if self.intervals.len() <= MANY {
            return vec![Cow::Borrowed(self)];
        }
        let alone = |own: &SolvedInterval| {
            let Segment { lower, upper } = own.segment.clone();
            let begin = Some(lower).filter(|lower| !lower.is_zero());
            let without = |segment| SolvedInterval { segment, f_prime: Expr::zero(), terms: Vec::new() };
            let before = begin.clone().map(|end| without(Segment { lower: Expr::zero(), upper: Some(end) }));
            let after = upper.clone().map(|lower| without(Segment { lower, upper: None }));
            let intervals = before.into_iter().chain([own.clone()]).chain(after).collect();
            Self { breakpoints: begin.into_iter().chain(upper).collect(), intervals }
        };
        self.intervals.iter().filter(|own| !own.terms.is_empty()).map(|own| Cow::Owned(alone(own))).collect()
    }

    /// The formula, interval by interval, with the parts of a pressure or of a field that stay open.
    fn formula(&self, quantity: Superposed, variable: &str, open: Vec<Formula>) -> Formula {
        let mut open = open.into_iter();
        let mut values = (0..self.intervals.len()).map(|interval| {
            let closed = self.closed(interval, quantity, |pair| &pair.shown);
            let open = match quantity {
                Superposed::Equivalent => self.open_integral(interval, "x"),
                Superposed::Force => self.open_integral(interval, "a"),
                _ => open.next().unwrap_or_else(Formula::zero),
            };
            with_collected(Formula::sum([Formula::Closed(closed), open]))
        });
        let pieces: Vec<(Formula, Expr)> = values.by_ref().take(self.breakpoints.len()).zip(self.breakpoints.iter().cloned()).collect();
        let last = values.next().unwrap_or_else(Formula::zero);
        if pieces.is_empty() { last } else { Formula::Piecewise { variable: Symbol::new(variable), pieces, last: Box::new(last) } }
    }

    /// g or F/(2E*) of the terms without a rule, as integrals over f′.
    fn open_integral(&self, interval: usize, variable: &str) -> Formula {
        let (end, radius) = (Expr::symbol(variable), Expr::symbol("r"));
        let root = (end.power(2) - radius.power(2)).sqrt();
        let parts = self.remainder(SolvedTerm::is_open).into_iter().take(interval + 1).filter(|(_, f_prime)| !f_prime.is_zero());
        Formula::sum(parts.map(|(segment, f_prime)| {
            let upper = segment.upper.clone().filter(|upper| self.ends_before(upper, interval)).unwrap_or_else(|| end.clone());
            let (factor, weight) = if variable == "x" { (end.clone(), Expr::one()) } else { (Expr::one(), radius.power(2)) };
            integral(f_prime * weight / &root, "r", segment.lower, upper).scaled(&factor)
        }))
    }

    /// True if the breakpoint lies below the given interval.
    fn ends_before(&self, upper: &Expr, interval: usize) -> bool {
        self.breakpoints.iter().take(interval).any(|b| b == upper)
    }

    /// Over g′ the integral needs a g without jumps; straight from f′ it needs a bounded f′. A symbolic exponent of a closed g
    /// is taken to be one without jumps.
    fn has_pressure_formula(&self) -> bool {
        let worst = self.remainder(SolvedTerm::has_open_pressure).iter().map(|(segment, f_prime)| growth(f_prime, segment)).max();
        let closed = self.intervals.iter().flat_map(|i| &i.terms).filter(|t| t.has_open_pressure()).all(|t| t.answer.is_some());
        match worst {
            None | Some(Growth::Bounded) => true,
            Some(Growth::Gentle | Growth::Unproven) => closed,
            Some(Growth::Steep) => false,
        }
    }

    /// p π/E* of the terms without a pressure rule, per interval: over g′ where g is closed, else straight from f′.
    fn open_pressures(&self, solution: &Solution) -> Vec<Formula> {
        if !self.intervals.iter().flat_map(|i| &i.terms).any(SolvedTerm::has_open_pressure) {
            return vec![Formula::zero(); self.intervals.len()];
        }
        let begun = self.begun_pressures();
        match self.g_primes(SolvedTerm::has_open_pressure, |term| begun.iter().any(|(own, _)| std::ptr::eq(*own, term))) {
            Ok(Some(list)) => self.open_pressures_from_g_primes(&list, &Expr::sum(begun.into_iter().map(|(_, own)| own))),
            // `derive` has made sure that (r f′)′ exists.
            _ => self.open_pressures_from_profile(solution).unwrap_or_else(|_| vec![Formula::zero(); self.intervals.len()]),
        }
    }

    /// The terms of a piece that begins at the axis and ends, whose pressure would be closed if they did not end, with this pressure.
    fn begun_pressures(&self) -> Vec<(&SolvedTerm, Expr)> {
        let pressure = |solved: &SolvedTerm| {
            let endless = Term { segment: Segment::whole(), parts: solved.term.parts.clone() };
            let (_, answer) = rules::answer(&endless)?;
            answer.pressure.filter(|_| answer.conditions.is_empty()).map(|own| own.within.shown)
        };
        let first = self.intervals.first().filter(|own| own.segment.upper.is_some() && own.segment.lower.is_zero());
        let terms = first.into_iter().flat_map(|own| &own.terms).filter(|term| term.has_open_pressure());
        terms.filter_map(|term| Some((term, pressure(term)?))).collect()
    }

    /// What the selected terms of every interval add to g′, within the interval, unless that is left out, and beyond it; `None` if their g is
    /// not closed.
    fn g_primes(
        &self,
        is_selected: impl Fn(&SolvedTerm) -> bool,
        is_left_out: impl Fn(&SolvedTerm) -> bool,
    ) -> Result<Option<Vec<[Expr; 2]>>, TransformError> {
        let x = Symbol::new("x");
        let mut g_primes = Vec::with_capacity(self.intervals.len());
        for solved in &self.intervals {
            let (mut within, mut beyond) = (Vec::new(), Vec::new());
            for term in solved.terms.iter().filter(|term| is_selected(term)) {
                let Some((_, answer)) = &term.answer else { return Ok(None) };
                if !is_left_out(term) {
                    within.push(derivative(&shown(&answer.equivalent.within.shown), &x)?);
                }
                beyond.push(derivative(&shown(&answer.equivalent.beyond.shown), &x)?);
            }
            g_primes.push([Expr::sum(within), Expr::sum(beyond)]);
        }
        Ok(Some(g_primes))
    }

    /// ∫ g′(x)/√(x²−r²) dx for the contacts that end on each interval: over the intervals below the end with all that g′ is
    /// there, and the closed pressure `begun` of the first interval.
    fn open_pressures_from_g_primes(&self, g_primes: &[[Expr; 2]], begun: &Expr) -> Vec<Formula> {
        let (x, r, a) = (Expr::symbol("x"), Expr::symbol("r"), Expr::symbol("a"));
        let root = (x.power(2) - r.power(2)).sqrt();
        let from = |begin: Option<&Expr>| begin.map_or_else(|| r.clone(), |begin| Expr::call("max", [begin.clone(), r.clone()]));
        let part = |g_prime: &Expr, begin: Option<&Expr>, end: Option<&Expr>| {
            let split = abel::split(g_prime, &self.breakpoints, begin, end.unwrap_or(&a));
            let (closed, g_prime) = split.map_or_else(|| (Expr::zero(), g_prime.clone()), |own| (own.closed, own.rest));
            let lower = match end {
                Some(end) => Expr::call("min", [from(begin), end.clone()]),
                None => from(begin),
            };
            let open = (!g_prime.is_zero()).then(|| integral(g_prime / &root, "x", lower, end.cloned().unwrap_or_else(|| a.clone())));
            Formula::sum([Formula::Closed(closed)].into_iter().chain(open))
        };
        let begin = |index: usize| index.checked_sub(1).and_then(|i| self.breakpoints.get(i));
        let shorter = |g_prime: Expr| {
            let expanded = expanded_or_same(&g_prime, "x");
            if expanded.size_up_to(SIZE) <= g_prime.size_up_to(SIZE) { expanded } else { g_prime }
        };
        let (mut ended, mut before) = (Vec::new(), Vec::new());
        let mut all = Vec::with_capacity(g_primes.len());
        for (index, [within, beyond]) in g_primes.iter().enumerate() {
            let g_prime = shorter(Expr::sum(before.iter().chain([within]).cloned()));
            let end = self.breakpoints.get(index);
            if index == 0 && !begun.is_zero() {
                // Under a contact that ends at max(b, r), the piece alone presses below b, and nothing beyond.
                let up_to_end = end.map_or_else(|| a.clone(), |end| Expr::call("max", [end.clone(), r.clone()]));
                all.push(Formula::sum([Formula::Closed(begun.clone()), part(&g_prime, None, None)]));
                ended.push(Formula::Closed(Bindings::one("a", up_to_end).apply(begun)));
                ended.push(part(&g_prime, None, end));
                before.push(beyond.clone());
                continue;
            }
            all.push(Formula::sum(ended.iter().cloned().chain([part(&g_prime, begin(index), None)])));
            ended.push(part(&g_prime, begin(index), end));
            before.push(beyond.clone());
        }
        all
    }

    /// The integrals over g′ of the terms without a closed field, for the contacts that end on each interval.
    fn open_fields(&self, field: Superposed) -> Vec<Formula> {
        let (x, a) = (Expr::symbol("x"), Expr::symbol("a"));
        let weight = match field {
            Superposed::Outside => Expr::integer(2) / Expr::pi() * Expr::call("asin", [&x / Expr::symbol("r")]),
            _ => axial_weight(&x),
        };
        let Ok(Some(g_primes)) = self.g_primes(|term| field.is_open(term), |_| false) else {
            return vec![Formula::zero(); self.intervals.len()];
        };
        let (mut ended, mut before, mut all) = (Vec::new(), Vec::new(), Vec::with_capacity(g_primes.len()));
        for (index, [within, beyond]) in g_primes.into_iter().enumerate() {
            let g_prime = Expr::sum(before.iter().chain([&within]).cloned());
            let begin = index.checked_sub(1).and_then(|index| self.breakpoints.get(index)).cloned().unwrap_or_else(Expr::zero);
            let part = |end: Expr| (!g_prime.is_zero()).then(|| integral(&g_prime * &weight, "x", begin.clone(), end));
            all.push(Formula::sum(ended.iter().cloned().chain(part(a.clone()))));
            ended.extend(self.breakpoints.get(index).and_then(|end| part(end.clone())));
            before.push(beyond);
        }
        all
    }

    /// ∫ (s f′(s))′ K(s, r) ds + Σ b δ K(b, r), per interval.
    fn open_pressures_from_profile(&self, solution: &Solution) -> Result<Vec<Formula>, TransformError> {
        let name = bound_name(solution);
        let (s, a) = (Expr::symbol(name), Expr::symbol("a"));
        let radius = Symbol::new("r");
        let rename = Bindings::one("r", s.clone());
        let mut ended: Vec<Formula> = Vec::new();
        let mut all = Vec::with_capacity(self.intervals.len());
        let mut previous = Expr::zero();
        for (segment, f_prime) in self.remainder(SolvedTerm::has_open_pressure) {
            if !segment.lower.is_zero() {
                let place = Bindings::one("r", segment.lower.clone());
                let jump = expanded_or_same(&(place.apply(&f_prime) - place.apply(&previous)), "r");
                ended.push(Formula::Closed(jump * &segment.lower * kernel(&segment.lower)));
            }
            let bend = derivative(&(Expr::symbol("r") * &f_prime), &radius)?;
            let up_to = |upper: Expr| integral(rename.apply(&bend) * kernel(&s), name, segment.lower.clone(), upper);
            let own = (!bend.is_zero()).then(|| up_to(a.clone()));
            all.push(Formula::sum(ended.iter().cloned().chain(own)));
            if !bend.is_zero() {
                ended.push(up_to(segment.upper.clone().unwrap_or_else(|| a.clone())));
            }
            previous = f_prime;
        }
        Ok(all)
    }
}

/// x (x²+3z²)/(x²+z²)².
pub(crate) fn axial_weight(x: &Expr) -> Expr {
    let (square, depth) = (x.power(2), Expr::symbol("z").power(2));
    x * (&square + Expr::integer(3) * &depth) / (square + depth).power(2)
}

/// Returns true if the formula has a closed part that is not 0.
fn has_closed_part(formula: &Formula) -> bool {
    match formula {
        Formula::Closed(expr) => !expr.is_zero(),
        Formula::Sum(parts) => parts.iter().any(has_closed_part),
        Formula::Scaled(_, inner) => has_closed_part(inner),
        Formula::Piecewise { pieces, last, .. } => has_closed_part(last) || pieces.iter().any(|(value, _)| has_closed_part(value)),
        Formula::Integral { .. } => false,
    }
}

/// Collects like terms in the closed parts of a formula, where functions for stable evaluation are the standard ones.
fn with_collected(formula: Formula) -> Formula {
    match formula {
        Formula::Closed(expr) => Formula::Closed(collected(&shown_as_mathematics(&with_few_terms(&expr)))),
        Formula::Sum(parts) => Formula::Sum(parts.into_iter().map(with_collected).collect()),
        other => other,
    }
}

/// The pressures of the powers in one formula are written out up to this number of terms.
const MOST_TERMS: i64 = 40;
/// Pressures of powers up to this order are always written out.
const SHORT_ORDER: i64 = 4;

/// The closed form of a pressure with one term over ₂F₁ for each power where elementary ones would have n²/4 terms together, as
/// for a polynomial of degree 20.
fn with_few_terms(expr: &Expr) -> Expr {
    let order = |own: &Expr| match own.node() {
        Node::Function(function, arguments) if function.name() == "pressure_power" => arguments.first().and_then(Expr::as_integer),
        _ => None,
    };
    let terms: i64 = expr.parts().filter_map(order).map(|n| n / 2 + 1).sum();
    if terms <= MOST_TERMS {
        return expr.clone();
    }
    rewritten(expr, &|own, _| {
        let Node::Function(_, arguments) = own.node() else { return None };
        let [n, r, a] = arguments.as_slice() else { return None };
        order(own).is_some_and(|n| n > SHORT_ORDER).then(|| pressure_power_in_one_term(n, r, a))
    })
}

/// K(s, r) = √(a²−M²) R_F(M²(M²−m²), a²(M²−m²), M²(a²−m²)) with M = max(r, s), m = min(r, s).
fn kernel(s: &Expr) -> Expr {
    let (r, a) = (Expr::symbol("r"), Expr::symbol("a"));
    let big = Expr::call("max", [r.clone(), s.clone()]).power(2);
    let small = Expr::call("min", [r, s.clone()]).power(2);
    let (square, spread) = (a.power(2), &big - &small);
    (&square - &big).sqrt() * Expr::call("elliprf", [&big * &spread, &square * &spread, &big * (&square - &small)])
}

/// A name for the bound radius that no parameter has.
fn bound_name(solution: &Solution) -> &'static str {
    let taken = solution.profile.parameters();
    ["s", "t", "rho", "sigma", "tau", "r_0", "r_1", "r_2"]
        .into_iter()
        .find(|name| !taken.iter().any(|p| p.name() == *name))
        .unwrap_or("r_bound")
}

fn integral(integrand: Expr, variable: &str, lower: Expr, upper: Expr) -> Formula {
    Formula::Integral { integrand: Box::new(Formula::Closed(integrand)), variable: Symbol::new(variable), lower, upper }
}
