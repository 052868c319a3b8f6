//! The gate: every solved term meets quadrature of that term when it is derived, before anything uses it.

mod parameters;

use crate::derive::chain::Chain;
use crate::derive::profile::Profile;
use crate::derive::rule::Branches;
use crate::derive::solved::{Agreement, SolvedChain, SolvedTerm};
use crate::derive::term::Term;
use crate::expr::{Condition, Expr, Symbol};
use crate::num::work;
pub(crate) use parameters::fields::Field;
use parameters::{ParameterDraw, Subject};

/// The results of verifying the terms of a solution.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Verification {
    /// Closed forms that were rejected, because a quadrature with a proven bound contradicts them.
    pub demoted: Vec<Demotion>,
    /// Terms whose closed g and F agree with quadrature.
    pub compared: usize,
    /// Terms for which no comparison could be had.
    pub not_compared: usize,
}

/// A rejected closed form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Demotion {
    /// The rule that gave it, or `recognition` where the terms did not add up to f′.
    pub rule: &'static str,
    /// `g`, `F`, `p`, or `f'` for the terms themselves.
    pub quantity: &'static str,
}

impl Demotion {
    /// The warning for the reader.
    pub fn text(&self) -> String {
        let Self { rule, quantity } = self;
        match *quantity {
            "f'" => "the terms of f' do not add up to it: they were given up, and the profile is integrated as it was typed".to_owned(),
            _ => format!("the closed {quantity} of the rule {rule} disagrees with quadrature: it was given up and is an integral here"),
        }
    }
}

/// Agrees, contradicts, or nothing is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Verdict {
    Agrees,
    Wrong,
    Unknown,
}

impl Verdict {
    /// Of one comparison and another at other values: a contradiction anywhere counts, and so does agreement.
    fn or(self, other: Self) -> Self {
        match (self, other) {
            (Self::Wrong, _) | (_, Self::Wrong) => Self::Wrong,
            (Self::Agrees, _) | (_, Self::Agrees) => Self::Agrees,
            _ => Self::Unknown,
        }
    }

    /// Of two comparisons that must both agree.
    fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Wrong, _) | (_, Self::Wrong) => Self::Wrong,
            (Self::Agrees, Self::Agrees) => Self::Agrees,
            _ => Self::Unknown,
        }
    }
}

/// Draws of the parameters at which every term is compared.
const DRAWS: u64 = 2;
/// Steps of work after which a comparison is abandoned, because special functions at large arguments may take seconds.
const LONGEST: u64 = 2_500_000;

/// The numbers for the parameters at which the terms of a profile are compared.
pub struct Gate {
    names: Vec<Symbol>,
    limits: Vec<Expr>,
    conditions: Vec<Condition>,
    draws: Vec<ParameterDraw>,
}

impl Gate {
    /// Seeded admissible values of the parameters; without parameters, one comparison is enough.
    pub fn new(profile: &Profile, conditions: &[Condition]) -> Self {
        let (names, limits) = (profile.parameters(), profile.limits().cloned().collect());
        let mut gate = Self { names, limits, conditions: conditions.to_vec(), draws: Vec::new() };
        gate.draws = gate.drawn(conditions);
        gate
    }

    fn drawn(&self, conditions: &[Condition]) -> Vec<ParameterDraw> {
        let draws = if self.names.is_empty() { 1 } else { DRAWS };
        (0..draws).filter_map(|draw| ParameterDraw::seeded(self.names.clone(), &self.limits, conditions, draw)).collect()
    }

    /// True unless the terms are proven not to add up to f′ as it was typed.
    pub fn recognition_holds(&self, chain: &Chain, slopes: &[Expr], solved: &[SolvedChain]) -> bool {
        self.draws.iter().all(|draw| draw.recognition_holds(chain, slopes, solved))
    }

    /// Whether the closed field of a term agrees with quadrature; `None` if it is contradicted.
    pub fn field_agrees(&self, field: &Field, term: &Term, forms: &Branches) -> Option<bool> {
        let compare = |draw: &ParameterDraw| work::share(LONGEST, || draw.compare_field(field, term, forms)).flatten();
        let verdicts = self.draws.iter().map(|draw| compare(draw).unwrap_or(Verdict::Unknown));
        match verdicts.fold(Verdict::Unknown, Verdict::or) {
            Verdict::Wrong => None,
            own => Some(own == Verdict::Agrees),
        }
    }

    /// Compares a solved term with quadrature and gives up what is wrong.
    pub fn judge(&self, solved: &mut SolvedTerm, found: &mut Verification) {
        let Some((rule, answer)) = &solved.answer else { return };
        let (mut f_prime, mut force, mut pressure) = (Verdict::Unknown, Verdict::Unknown, Verdict::Unknown);
        // An answer that demands more of the parameters than the profile is compared where that holds.
        let own = if self.draws.iter().all(|draw| draw.admits(&answer.conditions)) {
            None
        } else {
            Some(self.drawn(&[self.conditions.as_slice(), &answer.conditions].concat()))
        };
        if own.as_ref().is_some_and(Vec::is_empty) && !self.draws.is_empty() {
            // The answer holds for parameters only that the profile excludes.
            solved.answer = None;
            return;
        }
        let draws = own.as_ref().unwrap_or(&self.draws);
        let subject = if draws.is_empty() { None } else { Subject::new(&solved.term, answer, &self.names) };
        for (draw, subject) in draws.iter().zip(subject.iter().cycle()) {
            let own = work::share(LONGEST, || draw.compare(subject)).flatten().unwrap_or([Verdict::Unknown; 2]);
            (f_prime, force) = (f_prime.or(own[0]), force.or(own[1]));
            // The closed p is compared with an integral over the closed g.
            if own[0] == Verdict::Agrees {
                let own = work::share(LONGEST, || draw.compare_pressure(subject)).flatten();
                pressure = pressure.or(own.unwrap_or(Verdict::Unknown));
            }
        }
        for (verdict, quantity) in [(f_prime, "g"), (force, "F")] {
            if verdict == Verdict::Wrong {
                found.demoted.push(Demotion { rule: rule.id, quantity });
                solved.answer = None;
                return;
            }
        }
        if pressure == Verdict::Wrong {
            found.demoted.push(Demotion { rule: rule.id, quantity: "p" });
            if let Some((_, answer)) = &mut solved.answer {
                answer.pressure = None;
            }
        }
        // If g cannot be compared, as for r^0.001, whose slope is too steep at the axis for quadrature, F is not compared either.
        let force = if f_prime == Verdict::Unknown { Verdict::Unknown } else { force };
        let agrees = |verdict| verdict == Verdict::Agrees;
        solved.agreement = Agreement { equivalent: agrees(f_prime), force: agrees(force), pressure: agrees(pressure) };
        if agrees(f_prime) && agrees(force) { found.compared += 1 } else { found.not_compared += 1 }
    }
}
