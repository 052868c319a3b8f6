//! Slope and bend of the profile as numbers: f′ and (r f′)′ per piece, with the kinks between the pieces.

use crate::eval::constant_value;
use crate::expr::{Bindings, Expr, Symbol, derivative};
use crate::num::Bounded;
use crate::transform::{ClosedForm, Profile, TransformError};

/// f′ and (r f′)′ of a profile whose parameters are all numbers.
///
/// A bend that is nowhere negative makes g rise, since g′(x) = ∫₀^{π/2} (r f′)′|_{r = x sin t} dt; and a rising g presses everywhere.
pub(super) struct Curvature {
    chains: Vec<Pieces>,
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

impl Curvature {
    /// Compiles both derivatives of every piece.
    ///
    /// # Errors
    /// [`TransformError`] where a piece has no derivative or a parameter is left.
    pub(super) fn new(profile: &Profile) -> Result<Self, TransformError> {
        let radius = Symbol::new("r");
        let compile = |expr: &Expr| ClosedForm::new(expr, std::slice::from_ref(&radius));
        let mut chains = Vec::new();
        for chain in &profile.chains {
            let number = |b: &Expr| constant_value(b, &Bindings::default()).map(|b| b.value);
            let breakpoints = chain.breakpoints.iter().map(number).collect::<Result<_, _>>()?;
            let (mut slopes, mut bends) = (Vec::new(), Vec::new());
            for slope in chain.slopes()? {
                bends.push(compile(&derivative(&(Expr::symbol("r") * &slope), &radius)?)?);
                slopes.push(compile(&slope)?);
            }
            chains.push(Pieces { breakpoints, slopes, bends });
        }
        Ok(Self { chains })
    }

    /// f′(r), beyond a breakpoint where r is one.
    pub(super) fn slope(&self, r: f64) -> Bounded {
        self.total(r, |pieces| &pieces.slopes)
    }

    /// (r f′)′ at r.
    pub(super) fn bend(&self, r: f64) -> Bounded {
        self.total(r, |pieces| &pieces.bends)
    }

    fn total(&self, r: f64, pick: impl Fn(&Pieces) -> &Vec<ClosedForm>) -> Bounded {
        Bounded::sum(self.chains.iter().filter_map(|pieces| {
            let index = pieces.breakpoints.iter().filter(|b| **b <= r).count();
            pick(pieces).get(index).map(|form| form.value(&[r]))
        }))
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
        found.sort_by(|one, other| one.at.total_cmp(&other.at));
        found
    }
}
