//! The pressure as the integral of the derivative of a closed g, for contacts whose kinks all lie below the radius.

use crate::derive::closed_form::{ClosedForm, good_enough, total};
use crate::derive::superposed::Superposed;
use crate::evaluate::evaluator::Evaluator;
use crate::evaluate::ways::CLOSED_SLOPE;
use crate::evaluate::ways::pressure::MORE_DIGITS;
use crate::expr::{Symbol, derivative};
use crate::integrate::integral::reached;
use crate::num::quadrature::{EndBehaviour, Options, Panel, Point, integrate};
use crate::num::stable::leg;
use crate::num::{Bounded, Estimate, work};

/// Number of values of g′ in the smallest rule.
const FEWEST: u64 = 21;

impl Evaluator<'_> {
    /// p(r) π/E* = ∫_r^a g′(x)/√(x²−r²) dx = ∫₀^U g′(r cosh u) du, cosh U = a/r, with the derivative of the closed g.
    ///
    /// Near a kink at b ≪ r, quadrature of f′ may cancel, whereas the effect of its jump is smaller by b/r in g′.
    /// `None` if a breakpoint lies beyond r, g is not closed, the integral does not converge, or `most` steps of work do not
    /// suffice for a first rule.
    pub(crate) fn pressure_by_closed_slope(&self, r: f64, a: f64, most: u64) -> Option<Estimate> {
        let kinks = self.chains.iter().flat_map(|chain| &chain.breakpoints).filter(|b| b.value - b.error < a);
        let last = kinks.map(|b| b.value + b.error).fold(0.0, f64::max);
        if r <= last || r >= a {
            return None;
        }
        let forms = self.rising(a)?;
        let forms: Vec<&ClosedForm> = forms.iter().collect();
        // Values of special functions are too expensive for a search.
        let most = if forms.iter().any(|form| form.tape().is_special()) { most.min(MORE_DIGITS) } else { most };
        let mut g_prime = |point: Point| {
            let x = r * point.x.cosh();
            // x is accurate to a few rounding errors, and g′ varies on the scale of the distance to the last kink.
            let moved = 4.0 * f64::EPSILON * (1.0 + point.x) * (r / (r - last));
            let own = total(&forms, &[x], good_enough(self.tolerance)).bounded();
            Bounded { error: own.error + moved * own.value.abs(), ..own }
        };
        let reach = (leg(a, r) / r).asinh();
        // Give up if the budget does not cover the first rule.
        let (_, each, _) = work::apart(most, || g_prime(Point { x: 0.5 * reach, from_lower: 0.5 * reach, from_upper: 0.5 * reach }));
        work::spend(each);
        if each.saturating_mul(FEWEST) > most {
            return None;
        }
        let panel = Panel { lower: 0.0, upper: reach, kind: EndBehaviour::Smooth };
        let options = Options { rel_tol: self.tolerance, charge_x: false, max_evaluations: 20_000, ..Options::default() };
        let found = reached(integrate(&mut g_prime, &[panel], &options), a).ok()?;
        // U is accurate to a few rounding errors.
        let end = g_prime(Point { x: reach, from_lower: reach, from_upper: f64::MIN_POSITIVE });
        let error = found.error + 8.0 * f64::EPSILON * reach * end.value.abs();
        Some(Estimate { error, ..found.by(CLOSED_SLOPE) })
    }

    /// g′ of every chain for a contact that ends at a; `None` if an integral remains.
    fn rising(&self, a: f64) -> Option<Vec<ClosedForm>> {
        let x = Symbol::new("x");
        let chains = self.solution.chains.iter().enumerate();
        let forms = chains.map(|(index, chain)| {
            if !self.part(index, Superposed::Equivalent).ok()?.open.is_empty() {
                return None;
            }
            let equivalent = self.bindings.apply(&chain.closed(self.interval(index, a), Superposed::Equivalent, |pair| &pair.shown));
            ClosedForm::new(&derivative(&equivalent, &x).ok()?, std::slice::from_ref(&x)).ok()
        });
        forms.collect()
    }
}
