//! The profile as chains of smooth pieces, read from a formula and examined for jumps, kinks and poles.

use crate::derive::chain::Chain;
use crate::derive::domain::decided::{decided_for_all, drop_implied, is_proven_not_below};
use crate::derive::domain::demand::Demand;
use crate::derive::domain::demands;
use crate::derive::domain::numeric_sign::numeric_sign;
use crate::derive::kinks::{Resolved, groups, resolve};
use crate::derive::{angles, domain};
use crate::expr::{Bindings, Condition, Expr, Formula, Node, Relation, Sign, Symbol, undefined_constant};
use crate::integrate::error::TransformError;
use crate::num::work;
use crate::print;

/// The largest number of pieces of one chain.
const MOST_PIECES: usize = 10_000;

/// A profile f(r) as a sum of chains, with its conditions of validity.
#[derive(Clone, Debug)]
pub struct Profile {
    /// The formula as it was typed, with set parameters in place.
    pub typed: Formula,
    /// The chains whose sum is f.
    pub chains: Vec<Chain>,
    /// f(0), which is subtracted so that f starts at 0.
    pub shift: Expr,
    /// Conditions on the parameters and on r.
    pub conditions: Vec<Condition>,
    /// Expressions that must be positive for the profile to be real, and are not proven positive for all parameters.
    pub(crate) demands: Vec<Demand>,
}

impl Profile {
    /// Reads a formula: finds the pieces, locates kinks, refuses jumps and poles at the axis.
    ///
    /// ```
    /// use sneddon::{parse, transform::{Profile, TransformError}};
    /// let read = |text| Profile::new(&parse::profile(text).unwrap());
    /// assert_eq!(read("abs(r-b)").unwrap().chains[0].breakpoints.len(), 1);
    /// assert!(matches!(read("piecewise(0, r<b, 1)"), Err(TransformError::Jump { .. })));
    /// assert!(matches!(read("ln(r)"), Err(TransformError::SingularAtAxis { .. })));
    /// ```
    ///
    /// # Errors
    /// [`TransformError`] with the place and the reason.
    pub fn new(formula: &Formula) -> Result<Self, TransformError> {
        work::bounded(|| Self::read(formula))
    }

    fn read(formula: &Formula) -> Result<Self, TransformError> {
        if let Some(constant) = undefined_constant(formula) {
            return Err(TransformError::UndefinedConstant { constant: print::text_expr(&constant) });
        }
        let radius = Symbol::new("r");
        let mut conditions = Vec::new();
        let mut chains = Vec::new();
        let mut closed = Vec::new();
        let parts = match formula {
            Formula::Sum(parts) => parts.clone(),
            other => vec![other.clone()],
        };
        for part in parts {
            match Chain::from_formula(&part)? {
                chain if chain.breakpoints.is_empty() => closed.extend(chain.pieces),
                chain => chains.push(chain),
            }
        }
        let whole = |expr| Chain { breakpoints: Vec::new(), pieces: vec![expr] };
        // Summands with separate kinks are separate chains, so that unrelated kinks need not be ordered.
        let (together, mut apart) = (Expr::sum(closed), Vec::new());
        if !together.is_zero() || chains.is_empty() {
            apart = groups(&together).into_iter().map(whole).collect();
        }
        let split = apart.into_iter().map(|chain| examined(chain, &radius, &mut conditions)).collect::<Result<Vec<_>, _>>();
        let mut resolved = match split {
            // Jumps of different summands may cancel.
            Err(TransformError::Jump { .. }) => vec![examined(whole(together), &radius, &mut conditions)?],
            other => other?,
        };
        for chain in chains {
            resolved.push(examined(chain, &radius, &mut conditions)?);
        }
        let (mut resolved, unused): (Vec<Chain>, Vec<_>) = resolved.into_iter().map(|own| (own.chain, own.unused)).unzip();
        for piece in resolved.iter_mut().flat_map(|chain| &mut chain.pieces) {
            if angles::cancels(piece) {
                *piece = Expr::zero();
            }
        }
        let mut shift = Vec::new();
        for chain in &resolved {
            if let Some(first) = chain.pieces.first() {
                shift.push(domain::value_at_axis(first, &mut conditions)?);
            }
        }
        let mut open = Vec::new();
        for (chain, unused) in resolved.iter().zip(&unused) {
            demands::collect(chain, unused, &mut conditions, &mut open)?;
        }
        // The order and continuity of the pieces are proven only for acute slope angles.
        if resolved.iter().any(|chain| !chain.breakpoints.is_empty()) {
            conditions.extend(angles::conditions(resolved.iter().flat_map(|chain| chain.breakpoints.iter().chain(&chain.pieces))));
        }
        conditions.sort();
        conditions.dedup();
        if let Some(failing) = conditions.iter().find(|own| decided_for_all(own) == Some(false)) {
            return Err(TransformError::ConditionFails { condition: print::text_condition(failing) });
        }
        conditions.retain(|own| decided_for_all(own).is_none());
        drop_implied(&mut conditions);
        let mut profile = Self { typed: formula.clone(), chains: resolved, shift: Expr::sum(shift), conditions, demands: open };
        profile.end_at_limits();
        Ok(profile)
    }

    /// Drops the pieces that begin beyond the end of the profile.
    fn end_at_limits(&mut self) {
        let limits: Vec<Expr> = self.limits().cloned().collect();
        let unreached = |breakpoint: &Expr| limits.iter().any(|limit| is_proven_not_below(breakpoint, limit));
        for chain in &mut self.chains {
            while chain.breakpoints.last().is_some_and(unreached) {
                chain.breakpoints.pop();
                chain.pieces.pop();
            }
        }
    }

    /// The same profile with parameters replaced.
    ///
    /// # Errors
    /// As [`Profile::new`].
    pub fn substitute(&self, bindings: &Bindings) -> Result<Self, TransformError> {
        if bindings.is_empty() { Ok(self.clone()) } else { Self::new(&self.typed.substitute(bindings)) }
    }

    /// The parameters that have no value yet, by name.
    pub fn parameters(&self) -> Vec<Symbol> {
        self.typed.symbols().into_iter().filter(|s| s.name() != "r").collect()
    }

    /// The conditions 0 < u < π/2 for the slope angles u, which generated code checks.
    pub(crate) fn angle_conditions(&self) -> Vec<Condition> {
        angles::conditions(self.chains.iter().flat_map(|chain| chain.breakpoints.iter().chain(&chain.pieces)))
    }

    /// True if abs, min or max decide about pieces, for which the sign of what has a slope angle may have been used.
    pub(crate) fn has_kinks(&self) -> bool {
        let is_kink = |part: &Expr| matches!(part.node(), Node::Function(function, _) if matches!(function.name(), "abs" | "min" | "max"));
        self.typed.expressions().iter().any(|own| own.parts().any(is_kink))
    }

    /// True if f does not depend on r.
    pub fn is_flat(&self) -> bool {
        let radius = Symbol::new("r");
        self.chains.iter().all(|chain| chain.pieces.iter().all(|piece| !piece.contains(&radius)))
    }

    /// Upper limits of r from the conditions: the right-hand sides of r < limit.
    pub fn limits(&self) -> impl Iterator<Item = &Expr> {
        let radius = Expr::symbol("r");
        self.conditions.iter().filter(move |c| c.left == radius && c.relation != Relation::Equal).map(|c| &c.right)
    }
}

impl Chain {
    fn from_formula(formula: &Formula) -> Result<Self, TransformError> {
        match formula {
            Formula::Closed(expr) => Ok(Self { breakpoints: Vec::new(), pieces: vec![expr.clone()] }),
            Formula::Piecewise { pieces, last, .. } => {
                let (mut breakpoints, mut values) = (Vec::new(), Vec::new());
                for (value, end) in pieces {
                    values.push(closed(value)?);
                    breakpoints.push(end.clone());
                }
                values.push(closed(last)?);
                Ok(Self { breakpoints, pieces: values })
            }
            Formula::Scaled(..) | Formula::Sum(_) | Formula::Integral { .. } => {
                Err(TransformError::Kinks { function: "piecewise", reason: "pieces inside this expression cannot be separated".to_owned() })
            }
        }
    }

    /// Breakpoints must increase: proven, or added as a condition.
    fn refuse_disorder(&self, conditions: &mut Vec<Condition>) -> Result<(), TransformError> {
        for pair in self.breakpoints.windows(2) {
            let [lower, upper] = pair else { continue };
            match angles::sign(&(upper - lower)) {
                Sign::Positive => {}
                Sign::Unknown if angles::is_proven_below(lower, upper) => {}
                Sign::Unknown => match numeric_sign(&(upper - lower)) {
                    Some(s) if s > 0.0 => {}
                    Some(_) => return Err(disorder(lower, upper)),
                    None => conditions.push(Condition::less(lower.clone(), upper.clone())),
                },
                Sign::Zero | Sign::Negative => return Err(disorder(lower, upper)),
            }
        }
        Ok(())
    }

    /// Neighbouring pieces must meet, as those at kinks do: a difference at an admissible point is a jump unless it is proven to be zero.
    fn refuse_jumps(&self, radius: &Symbol, kinks: &[Expr], conditions: &mut Vec<Condition>) -> Result<(), TransformError> {
        for ((before, beyond), at) in self.pieces.iter().zip(self.pieces.iter().skip(1)).zip(&self.breakpoints) {
            if kinks.contains(at) {
                // Divided by what vanishes there, the function of a kink jumps.
                if domain::seems_to_jump(before, beyond, at, conditions) {
                    return Err(TransformError::Jump { at: print::text_expr(at), jump: print::text_expr(&(beyond - before)) });
                }
                continue;
            }
            let place = Bindings::one(radius.name(), at.clone());
            let jump = place.apply(beyond) - place.apply(before);
            if angles::is_proven_zero(&jump, radius) {
                continue;
            }
            match domain::vanishes_at_random_points(&jump) {
                Some(true) => conditions.push(Condition::equal(place.apply(before), place.apply(beyond))),
                Some(false) => return Err(TransformError::Jump { at: print::text_expr(at), jump: print::text_expr(&jump) }),
                None => return Err(TransformError::NotReal { detail: print::text_expr(&jump) }),
            }
        }
        Ok(())
    }
}

/// Resolves the kinks of a chain and checks that its breakpoints increase and its pieces meet.
fn examined(chain: Chain, radius: &Symbol, conditions: &mut Vec<Condition>) -> Result<Resolved, TransformError> {
    let resolved = resolve(chain, conditions)?;
    let Resolved { chain, kinks, .. } = &resolved;
    if chain.pieces.len() > MOST_PIECES {
        return Err(TransformError::TooManyPieces { limit: MOST_PIECES });
    }
    chain.refuse_disorder(conditions)?;
    chain.refuse_jumps(radius, kinks, conditions)?;
    Ok(resolved)
}

fn closed(formula: &Formula) -> Result<Expr, TransformError> {
    formula
        .as_closed()
        .cloned()
        .ok_or_else(|| TransformError::Kinks { function: "piecewise", reason: "a piece contains pieces itself".to_owned() })
}

fn disorder(lower: &Expr, upper: &Expr) -> TransformError {
    TransformError::ConditionFails { condition: format!("{} < {}", print::text_expr(lower), print::text_expr(upper)) }
}
