//! The derived formulas: each term's closed answer or its integral, put together per interval.

use super::ends::{Growth, growth};
use super::engine::{SolvedChain, SolvedTerm, expanded_or_same};
use super::quantity::Quantity;
use super::{Solution, TransformError};
use crate::expr::{Bindings, Expr, Formula, Symbol, collected, derivative, shown};

/// Sizes of expressions are compared up to this number of nodes.
const SIZE: usize = 10_000;

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
    /// The rules that answered, in the order of the terms.
    pub rules: Vec<&'static str>,
    /// The equations of the source.
    pub reference: Vec<&'static str>,
}

impl Solution {
    /// g(x), the equivalent profile (3.27).
    pub fn equivalent_profile(&self) -> Derived {
        self.derived(Quantity::Slope, "x", &Expr::one(), "Popov & Heß (3.27)")
    }

    /// F(a) under a smooth edge, E for the effective modulus.
    pub fn force(&self) -> Derived {
        self.derived(Quantity::Force, "a", &(Expr::integer(2) * Expr::symbol("E")), "Popov & Heß (3.22), (3.25)")
    }

    /// p(r) under a smooth edge, positive in compression; `None` where f′ is so large at a breakpoint that g may jump there,
    /// because then neither ∫ g′/√(x²−r²) dx nor the integral over (r f′)′ is the pressure.
    pub fn pressure(&self) -> Option<Derived> {
        self.chains
            .iter()
            .all(SolvedChain::has_pressure_formula)
            .then(|| self.derived(Quantity::Pressure, "a", &(Expr::symbol("E") / Expr::pi()), "Popov & Heß (3.37)"))
    }

    fn derived(&self, quantity: Quantity, variable: &str, factor: &Expr, reference: &'static str) -> Derived {
        let open = |term: &SolvedTerm| quantity.is_open(term);
        let (mut rules, mut references) = (Vec::new(), vec![reference]);
        let (mut closed, mut left) = (0, 0);
        for term in self.terms() {
            match &term.answer {
                Some((rule, _)) if !open(term) => {
                    closed += 1;
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
        let formula = Formula::sum(self.chains.iter().map(|chain| chain.formula(quantity, variable, self)));
        Derived { formula: formula.scaled(factor), status, rules, reference: references }
    }
}

impl SolvedChain {
    fn formula(&self, quantity: Quantity, variable: &str, solution: &Solution) -> Formula {
        let mut values = (0..self.intervals.len()).map(|interval| {
            let closed = collected(&self.closed(interval, quantity, |pair| &pair.shown));
            let open = match quantity {
                Quantity::Slope => self.open_integral(interval, "x"),
                Quantity::Force => self.open_integral(interval, "a"),
                Quantity::Pressure => self.open_pressure(interval, solution),
                // No formula of it is shown.
                Quantity::Outside => Formula::zero(),
            };
            Formula::sum([Formula::Closed(closed), open])
        });
        let pieces: Vec<(Formula, Expr)> = values.by_ref().take(self.breakpoints.len()).zip(self.breakpoints.iter().cloned()).collect();
        let last = values.next().unwrap_or_else(Formula::zero);
        if pieces.is_empty() { last } else { Formula::Piecewise { variable: Symbol::new(variable), pieces, last: Box::new(last) } }
    }

    /// g or F/(2E*) of the terms without a rule, as integrals over f′.
    fn open_integral(&self, interval: usize, variable: &str) -> Formula {
        let (end, radius) = (Expr::symbol(variable), Expr::symbol("r"));
        let root = (end.power(2) - radius.power(2)).sqrt();
        let parts = self.remainder(SolvedTerm::is_open).into_iter().take(interval + 1).filter(|(_, slope)| !slope.is_zero());
        Formula::sum(parts.map(|(segment, slope)| {
            let upper = segment.upper.clone().filter(|upper| self.ends_before(upper, interval)).unwrap_or_else(|| end.clone());
            let (factor, weight) = if variable == "x" { (end.clone(), Expr::one()) } else { (Expr::one(), radius.power(2)) };
            integral(slope * weight / &root, "r", segment.lower, upper).scaled(&factor)
        }))
    }

    /// True where the breakpoint lies below the given interval.
    fn ends_before(&self, upper: &Expr, interval: usize) -> bool {
        self.breakpoints.iter().take(interval).any(|b| b == upper)
    }

    /// Over g′ the integral needs a g without jumps; straight from f′ it needs a bounded f′. A symbolic exponent of a closed g
    /// is taken to be one without jumps.
    fn has_pressure_formula(&self) -> bool {
        let worst = self.remainder(SolvedTerm::has_open_pressure).iter().map(|(segment, slope)| growth(slope, segment)).max();
        let closed = self.intervals.iter().flat_map(|i| &i.terms).filter(|t| t.has_open_pressure()).all(|t| t.answer.is_some());
        match worst {
            None | Some(Growth::Bounded) => true,
            Some(Growth::Gentle | Growth::Unproven) => closed,
            Some(Growth::Steep) => false,
        }
    }

    /// p π/E* of the terms without a pressure rule: over g′ where g is closed, else straight from f′.
    fn open_pressure(&self, interval: usize, solution: &Solution) -> Formula {
        if !self.intervals.iter().flat_map(|i| &i.terms).any(SolvedTerm::has_open_pressure) {
            return Formula::zero();
        }
        match self.open_pressure_from_slope(interval) {
            Ok(Some(formula)) => formula,
            // `derive` has made sure that (r f′)′ exists.
            _ => self.open_pressure_from_profile(interval, solution).unwrap_or_else(|_| Formula::zero()),
        }
    }

    /// ∫ g′(x)/√(x²−r²) dx interval by interval; `None` where g is not closed.
    fn open_pressure_from_slope(&self, interval: usize) -> Result<Option<Formula>, TransformError> {
        let (x, r, a) = (Expr::symbol("x"), Expr::symbol("r"), Expr::symbol("a"));
        let root = (x.power(2) - r.power(2)).sqrt();
        let mut parts = Vec::new();
        for index in 0..=interval {
            let mut terms = Vec::new();
            for (own, solved) in self.intervals.iter().enumerate().take(index + 1) {
                for term in solved.terms.iter().filter(|t| t.has_open_pressure()) {
                    let Some((_, answer)) = &term.answer else { return Ok(None) };
                    let pair = if own < index { &answer.slope.beyond } else { &answer.slope.within };
                    terms.push(shown(&pair.shown));
                }
            }
            let slope = derivative(&Expr::sum(terms), &Symbol::new("x"))?;
            let expanded = expanded_or_same(&slope, "x");
            // Whichever reads shorter.
            let slope = if expanded.size_up_to(SIZE) <= slope.size_up_to(SIZE) { expanded } else { slope };
            if slope.is_zero() {
                continue;
            }
            let begin = index.checked_sub(1).and_then(|i| self.breakpoints.get(i));
            let end = if index < interval { self.breakpoints.get(index) } else { None };
            let from = match begin {
                Some(begin) => Expr::call("max", [begin.clone(), r.clone()]),
                None => r.clone(),
            };
            let lower = match end {
                Some(end) => Expr::call("min", [from, end.clone()]),
                None => from,
            };
            parts.push(integral(slope / &root, "x", lower, end.cloned().unwrap_or_else(|| a.clone())));
        }
        Ok(Some(Formula::sum(parts)))
    }

    /// ∫ (s f′(s))′ K(s, r) ds + Σ b δ K(b, r).
    fn open_pressure_from_profile(&self, interval: usize, solution: &Solution) -> Result<Formula, TransformError> {
        let name = bound_name(solution);
        let (s, a) = (Expr::symbol(name), Expr::symbol("a"));
        let radius = Symbol::new("r");
        let rename = Bindings::one("r", s.clone());
        let mut parts = Vec::new();
        let mut previous = Expr::zero();
        for (index, (segment, slope)) in self.remainder(SolvedTerm::has_open_pressure).into_iter().enumerate().take(interval + 1) {
            if !segment.lower.is_zero() {
                let place = Bindings::one("r", segment.lower.clone());
                let jump = expanded_or_same(&(place.apply(&slope) - place.apply(&previous)), "r");
                parts.push(Formula::Closed(jump * &segment.lower * kernel(&segment.lower)));
            }
            let bend = derivative(&(Expr::symbol("r") * &slope), &radius)?;
            let upper = if index < interval { segment.upper.clone().unwrap_or_else(|| a.clone()) } else { a.clone() };
            if !bend.is_zero() {
                parts.push(integral(rename.apply(&bend) * kernel(&s), name, segment.lower, upper));
            }
            previous = slope;
        }
        Ok(Formula::sum(parts))
    }
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
