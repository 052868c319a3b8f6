//! The radii at which f′ jumps, on the axis or at a kink, where the pressure is infinite.

use crate::derive::profile::Profile;
use crate::eval::constant_value;
use crate::expr::{Bindings, Expr, Number};

impl Profile {
    /// The radii at which f′ jumps for some values of the parameters, the axis first; the pressure is infinite there.
    ///
    /// f′ is odd, so it jumps on the axis unless it vanishes there. Radii at which f′ has no finite value are left out.
    ///
    /// ```
    /// use sneddon::{expr::Expr, parse, transform::Profile};
    /// let jumps = |text| Profile::new(&parse::profile(text).unwrap()).unwrap().jumps();
    /// assert_eq!(jumps("abs(r-b)"), [Expr::zero(), Expr::symbol("b")]);
    /// assert!(jumps("max(0, r-b)^2").is_empty());
    /// ```
    pub fn jumps(&self) -> Vec<Expr> {
        steps(self).unwrap_or_default().into_iter().filter(Step::is_jump).map(|own| own.radius).collect()
    }
}

/// f′ on both sides of a radius, as expressions in r.
struct Step {
    radius: Expr,
    before: Expr,
    after: Expr,
}

/// The radii at which f′ may jump; on the axis it does unless it vanishes, because it is odd.
fn steps(profile: &Profile) -> Option<Vec<Step>> {
    let mut found: Vec<Step> = Vec::new();
    for chain in &profile.chains {
        let slopes = chain.f_primes().ok()?;
        let first = slopes.first()?;
        let apex = Step { radius: Expr::zero(), before: -first, after: first.clone() };
        let inner = chain.breakpoints.iter().zip(slopes.iter().zip(slopes.iter().skip(1)));
        let inner = inner.map(|(b, (before, after))| Step { radius: b.clone(), before: before.clone(), after: after.clone() });
        for step in std::iter::once(apex).chain(inner) {
            match found.iter_mut().find(|own| own.radius == step.radius) {
                Some(own) => (own.before, own.after) = (&own.before + &step.before, &own.after + &step.after),
                None => found.push(step),
            }
        }
    }
    Some(found)
}

impl Step {
    /// True if f′ differs on both sides for some values of the parameters, by more than the rounding of a radius that was typed.
    fn is_jump(&self) -> bool {
        /// The values of the parameters are multiples of these.
        const DRAWS: [f64; 2] = [0.293, 0.717];
        /// The smallest jump relative to f′.
        const LEAST: f64 = 1e-9;
        let place = Bindings::one("r", self.radius.clone());
        let (before, after) = (place.apply(&self.before), place.apply(&self.after));
        let jump = &after - &before;
        DRAWS.iter().any(|draw| {
            let value = |i: usize| Number::from_f64(draw * (1.0 + 0.37 * i as f64)).map(Expr::number);
            let names = jump.symbols();
            let bindings: Bindings = names.iter().enumerate().filter_map(|(i, own)| Some((own.name(), value(i)?))).collect();
            let number = |own: &Expr| constant_value(own, &bindings).ok().filter(|own| own.value.is_finite());
            let size = [&before, &after].into_iter().filter_map(number).map(|own| own.value.abs()).sum::<f64>();
            number(&jump).is_some_and(|own| own.value.abs() > own.error + LEAST * size)
        })
    }
}
