//! Slope and bend of the profile as numbers: f′ and (r f′)′ per piece, with the kinks between the pieces.

use crate::eval::constant_value;
use crate::expr::{Bindings, Expr, Symbol, derivative};
use crate::num::Bounded;
use crate::transform::{ClosedForm, Profile, Slopes, TransformError};
use std::sync::Arc;

/// f′ and (r f′)′ of a profile whose parameters are all numbers, and of what is no formula beside it.
///
/// A bend that is nowhere negative makes g rise, since g′(x) = ∫₀^{π/2} (r f′)′|_{r = x sin t} dt; and a rising g presses everywhere.
pub(super) struct Curvature<'a> {
    chains: Vec<Pieces>,
    others: Vec<Arc<dyn Slopes + 'a>>,
}

struct Pieces {
    breakpoints: Vec<f64>,
    slopes: Vec<ClosedForm>,
    bends: Vec<ClosedForm>,
}

/// A place where f′ jumps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Kink {
    pub(super) at: f64,
    /// f′ beyond minus f′ before.
    pub(super) jump: f64,
}

impl<'a> Curvature<'a> {
    /// That of profiles that are no formulas.
    pub(super) fn of(others: Vec<Arc<dyn Slopes + 'a>>) -> Self {
        Self { chains: Vec::new(), others }
    }

    /// Compiles both derivatives of every piece of a formula, and adds it.
    ///
    /// # Errors
    /// [`TransformError`] where a piece has no derivative or a parameter is left.
    pub(super) fn with(mut self, profile: &Profile) -> Result<Self, TransformError> {
        let radius = Symbol::new("r");
        let compile = |expr: &Expr| ClosedForm::new(expr, std::slice::from_ref(&radius));
        for chain in &profile.chains {
            let number = |b: &Expr| constant_value(b, &Bindings::default()).map(|b| b.value);
            let breakpoints = chain.breakpoints.iter().map(number).collect::<Result<_, _>>()?;
            let (mut slopes, mut bends) = (Vec::new(), Vec::new());
            for slope in chain.slopes()? {
                bends.push(compile(&derivative(&(Expr::symbol("r") * &slope), &radius)?)?);
                slopes.push(compile(&slope)?);
            }
            self.chains.push(Pieces { breakpoints, slopes, bends });
        }
        Ok(self)
    }

    /// f′(r), beyond a breakpoint where r is one.
    pub(super) fn slope(&self, r: f64) -> Bounded {
        self.total(r, |pieces| &pieces.slopes, |other| other.first(r))
    }

    /// (r f′)′ at r.
    pub(super) fn bend(&self, r: f64) -> Bounded {
        self.total(r, |pieces| &pieces.bends, |other| other.bend(r))
    }

    fn total(&self, r: f64, pick: impl Fn(&Pieces) -> &Vec<ClosedForm>, ask: impl Fn(&dyn Slopes) -> Bounded) -> Bounded {
        let formulas = self.chains.iter().filter_map(|pieces| {
            let index = pieces.breakpoints.iter().filter(|b| **b <= r).count();
            pick(pieces).get(index).map(|form| form.value(&[r]))
        });
        Bounded::sum(formulas.chain(self.others.iter().map(|other| ask(other.as_ref()))))
    }

    /// Every place where f′ jumps beyond doubt, rising.
    pub(super) fn kinks(&self) -> Vec<Kink> {
        let mut found: Vec<Kink> = Vec::new();
        for pieces in &self.chains {
            for (at, pair) in pieces.breakpoints.iter().zip(pieces.slopes.windows(2)) {
                let [before, beyond] = pair else { continue };
                let (before, beyond) = (before.value(&[*at]), beyond.value(&[*at]));
                let jump = beyond - before;
                // The breakpoint itself is rounded: a slope that is merely continuous may seem to jump by as much as it changes there.
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
