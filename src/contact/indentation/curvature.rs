//! Slope and bend of the profile as numbers: f′ and (r f′)′ per piece, with the kinks between the pieces.

use crate::eval::constant_value;
use crate::expr::{Bindings, Expr, Symbol, balanced, derivative};
use crate::num::Bounded;
use crate::transform::{ClosedForm, Over, Profile, Slopes, TransformError, sum_of_ranges};
use std::sync::{Arc, OnceLock};

/// f′ and (r f′)′ of a profile with numbers for all parameters, and of additional profiles that are not formulas.
///
/// If the bend is nowhere negative, g increases, since g′(x) = ∫₀^{π/2} (r f′)′|_{r = x sin t} dt, and the pressure is positive.
pub(in crate::contact) struct Curvature<'a> {
    chains: Vec<Pieces>,
    others: Vec<Arc<dyn Slopes + 'a>>,
}

struct Pieces {
    breakpoints: Vec<f64>,
    heights: Vec<ClosedForm>,
    f_primes: Vec<ClosedForm>,
    bends: Vec<ClosedForm>,
    /// (r f′)″, compiled when needed for the sign of (r f′)′.
    turns: Vec<Turn>,
}

/// An expression that is compiled when needed.
struct Turn {
    bend: Expr,
    compiled: OnceLock<Option<ClosedForm>>,
}

/// A jump of f′.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::contact) struct Kink {
    pub(in crate::contact) at: f64,
    /// f′ beyond minus f′ before.
    pub(in crate::contact) jump: f64,
}

impl<'a> Curvature<'a> {
    /// Creates the curvature of profiles that are not formulas.
    pub(in crate::contact) fn of(others: Vec<Arc<dyn Slopes + 'a>>) -> Self {
        Self { chains: Vec::new(), others }
    }

    /// Compiles both derivatives of every piece of a formula, and adds it.
    ///
    /// # Errors
    /// [`TransformError`] if a piece has no derivative or a parameter has no value.
    pub(in crate::contact) fn with(mut self, profile: &Profile) -> Result<Self, TransformError> {
        let radius = Symbol::new("r");
        let compile = |expr: &Expr| ClosedForm::new(expr, std::slice::from_ref(&radius));
        let mut shift = -&profile.shift;
        for chain in &profile.chains {
            let number = |b: &Expr| constant_value(b, &Bindings::default()).map(|b| b.value);
            let breakpoints = chain.breakpoints.iter().map(number).collect::<Result<_, _>>()?;
            let heights = chain.pieces.iter().map(|piece| compile(&(piece + &shift))).collect::<Result<_, _>>()?;
            shift = Expr::zero();
            let (mut f_primes, mut bends) = (Vec::new(), Vec::new());
            let mut turns = Vec::new();
            for f_prime in chain.f_primes()? {
                let f_prime = balanced(&f_prime);
                let bend = balanced(&derivative(&(Expr::symbol("r") * &f_prime), &radius)?);
                bends.push(compile(&bend)?);
                f_primes.push(compile(&f_prime)?);
                turns.push(Turn { bend, compiled: OnceLock::new() });
            }
            self.chains.push(Pieces { breakpoints, heights, f_primes, bends, turns });
        }
        Ok(self)
    }

    /// f′(r); the right-hand limit at a breakpoint.
    pub(super) fn f_prime(&self, r: f64) -> Bounded {
        self.total(r, |pieces| &pieces.f_primes, |other| other.first(r))
    }

    /// (r f′)′ at r.
    pub(super) fn bend(&self, r: f64) -> Bounded {
        self.total(r, |pieces| &pieces.bends, |other| other.bend(r))
    }

    /// The radii where the pieces of a formula meet, in increasing order.
    pub(super) fn breakpoints(&self) -> Vec<f64> {
        let mut list: Vec<f64> = self.chains.iter().flat_map(|pieces| pieces.breakpoints.iter().copied()).collect();
        list.sort_by(f64::total_cmp);
        list.dedup();
        list
    }

    /// Bounds on f − f(0) between two radii without a breakpoint between them; `None` if unknown.
    pub(super) fn height_over(&self, lower: f64, upper: f64) -> Option<(f64, f64)> {
        if self.others.is_empty() { self.total_over(lower, upper, |pieces| &pieces.heights, |_| None) } else { None }
    }

    /// Bounds on f′ between two radii.
    pub(super) fn f_prime_over(&self, lower: f64, upper: f64) -> Option<(f64, f64)> {
        self.total_over(lower, upper, |pieces| &pieces.f_primes, |own| Some(own.f_prime))
    }

    /// Bounds on (r f′)′ between two radii.
    pub(super) fn bend_over(&self, lower: f64, upper: f64) -> Option<(f64, f64)> {
        let (low, high) = self.total_over(lower, upper, |pieces| &pieces.bends, |own| Some(own.bend))?;
        // If the sign is undecided, use the value at the middle, in which terms cancel exactly, and enclose only its change.
        let narrow = lower > 0.0 && upper < 2.0 * lower && low < 0.0 && high > 0.0;
        let near = if narrow { self.bend_around(lower, upper) } else { None };
        Some(near.map_or((low, high), |near| (low.max(near.0), high.min(near.1))))
    }

    /// Bounds on (r f′)′ by the value at the middle and an enclosure of the change from there.
    fn bend_around(&self, lower: f64, upper: f64) -> Option<(f64, f64)> {
        if !self.others.is_empty() {
            return None;
        }
        let middle = 0.5 * (lower + upper);
        let radius = Symbol::new("r");
        let mut change = (0.0, 0.0);
        for pieces in &self.chains {
            let turn = pieces.turns.get(pieces.breakpoints.iter().filter(|b| **b <= middle).count())?;
            let compiled = turn.compiled.get_or_init(|| {
                let own = balanced(&derivative(&turn.bend, &radius).ok()?);
                ClosedForm::new(&own, std::slice::from_ref(&radius)).ok()
            });
            let own = compiled.as_ref()?.over(lower, upper)?;
            change = (change.0 + own.0, change.1 + own.1);
        }
        let bend = self.bend(middle);
        let half = 0.5 * (upper - lower) * (1.0 + 4.0 * f64::EPSILON);
        let most = half * change.0.abs().max(change.1.abs()) * (1.0 + 8.0 * f64::EPSILON) + bend.error;
        (most < f64::INFINITY).then_some((bend.value - most, bend.value + most))
    }

    fn total_over(
        &self,
        lower: f64,
        upper: f64,
        pick: impl Fn(&Pieces) -> &Vec<ClosedForm>,
        ask: impl Fn(Over) -> Option<(f64, f64)>,
    ) -> Option<(f64, f64)> {
        let middle = 0.5 * (lower + upper);
        let formulas = self.chains.iter().map(|pieces| {
            let index = pieces.breakpoints.iter().filter(|b| **b <= middle).count();
            pick(pieces).get(index)?.over(lower, upper)
        });
        let others = self.others.iter().map(|other| other.over(lower, upper).and_then(&ask));
        sum_of_ranges(formulas.chain(others))
    }

    fn total(&self, r: f64, pick: impl Fn(&Pieces) -> &Vec<ClosedForm>, ask: impl Fn(&dyn Slopes) -> Bounded) -> Bounded {
        let formulas = self.chains.iter().filter_map(|pieces| {
            let index = pieces.breakpoints.iter().filter(|b| **b <= r).count();
            pick(pieces).get(index).map(|form| form.value(&[r]))
        });
        Bounded::sum(formulas.chain(self.others.iter().map(|other| ask(other.as_ref()))))
    }

    /// Every certain jump of f′, in increasing order.
    pub(in crate::contact) fn kinks(&self) -> Vec<Kink> {
        let mut found: Vec<Kink> = Vec::new();
        for pieces in &self.chains {
            for (at, pair) in pieces.breakpoints.iter().zip(pieces.f_primes.windows(2)) {
                let [before, beyond] = pair else { continue };
                let (before, beyond) = (before.value(&[*at]), beyond.value(&[*at]));
                let jump = beyond - before;
                // Because the breakpoint is rounded, a continuous slope may appear to jump by its change over the rounding error.
                let doubt = jump.error + 16.0 * f64::EPSILON * (before.value.abs() + beyond.value.abs());
                if jump.value.abs() > doubt {
                    found.push(Kink { at: *at, jump: jump.value });
                }
            }
        }
        found.extend(self.others.iter().flat_map(|other| other.kinks()).map(|(at, jump)| Kink { at, jump }));
        found.sort_by(|one, other| one.at.total_cmp(&other.at));
        found
    }
}
