//! The limit of small contacts: the power with which f begins, and what it gives.

use super::Step;
use crate::contact::{Edge, explicit, relations};
use crate::eval::constant_value;
use crate::expr::{Bindings, Expr, Formula, Node, Sign, Symbol, derivative, normal, sign};
use crate::print::Prose;
use crate::transform::{Profile, Sampler, Solution, derive};

/// The highest power that is looked for in a function that begins late.
const ORDERS: usize = 6;
/// Larger derivatives are not followed.
const SIZE: usize = 2_000;

/// The limits of d and F near the axis, if f is not a power itself.
pub(super) fn step(solution: &Solution, edge: &Edge) -> Option<Step> {
    let [chain] = solution.profile.chains.as_slice() else { return None };
    if *edge != Edge::Smooth || !chain.breakpoints.is_empty() {
        return None;
    }
    let f_prime = chain.f_primes().ok()?.into_iter().next()?;
    let leading = leading(&f_prime)?;
    if leading == f_prime || !is_confirmed(solution, &f_prime, &leading) {
        return None;
    }
    let (coefficient, exponent) = power_of(&leading)?;
    let n = exponent + Expr::one();
    let begin = coefficient / &n * Expr::symbol("r").pow(&n);
    let profile = Profile::new(&Formula::Closed(begin.clone())).ok()?;
    let nearby = derive(&profile).ok()?;
    let found = relations(&nearby, &Edge::Smooth).ok()?;
    let word = match n.as_integer() {
        Some(1) => "the contact of a cone",
        Some(2) => "the contact of a paraboloid, which is Hertz's",
        _ => "the contact of a power",
    };
    let mut steps = vec![
        Step::new("Depth", "d(a)", found.d.formula, Prose::words("Its leading term")),
        Step::new("Force", "F(a)", found.force.formula, Prose::words("Its leading term")),
    ];
    if let Some(solved) = explicit(&nearby) {
        steps.push(Step::new("Force at a depth", "F(d)", Formula::Closed(solved.force), Prose::words("Its leading term")));
    }
    let why = Prose::words(&format!("Next to the axis the shape begins with this power, so that the contact tends to {word}"));
    Some(Step::new("Small contacts", "f(r)", Formula::Closed(begin), why).with(steps))
}

/// The term with which a function of r begins at 0.
fn leading(f_prime: &Expr) -> Option<Expr> {
    let radius = Symbol::new("r");
    let at_axis = Bindings::one("r", Expr::zero());
    let mut found: Vec<(Expr, Expr)> = Vec::new();
    for term in normal::normal_terms(f_prime, &radius).ok()? {
        let mut kernel = term.kernel.clone();
        let (mut order, mut factorial) = (0, 1);
        let value = loop {
            if kernel.size_up_to(SIZE) >= SIZE || is_singular(&kernel, &at_axis) {
                return None;
            }
            let value = at_axis.apply(&kernel);
            if !value.is_zero() {
                break value;
            }
            order += 1;
            if order > ORDERS {
                return None;
            }
            factorial *= order as i64;
            kernel = derivative(&kernel, &radius).ok()?;
        };
        let exponent = &term.exponent + Expr::integer(order as i64);
        found.push((exponent, term.coefficient * value / Expr::integer(factorial)));
    }
    let least = found.iter().map(|(exponent, _)| exponent.as_number().cloned()).collect::<Option<Vec<_>>>()?.into_iter().min()?;
    let coefficient = Expr::sum(found.into_iter().filter(|(exponent, _)| exponent.as_number() == Some(&least)).map(|(_, own)| own));
    (!coefficient.is_zero()).then(|| coefficient * Expr::symbol("r").pow(&Expr::number(least)))
}

/// True if a power with a negative exponent, or a logarithm, has a base that vanishes at the axis.
fn is_singular(expr: &Expr, at_axis: &Bindings) -> bool {
    expr.parts().any(|own| match own.node() {
        Node::Power(base, exponent) => {
            base.contains(&Symbol::new("r"))
                && exponent.as_number().is_none_or(|own| !own.is_integer() || own.is_negative())
                && at_axis.apply(base).is_zero()
        }
        Node::Function(function, arguments) => match function.name() {
            "sqrt" | "exp" | "sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh" | "asin" | "atan" | "asinh" | "atanh" | "erf" => false,
            "ln" => arguments.iter().any(|own| at_axis.apply(own).is_zero()),
            _ => own.contains(&Symbol::new("r")),
        },
        _ => false,
    })
}

/// c and m of c r^m.
fn power_of(leading: &Expr) -> Option<(Expr, Expr)> {
    let terms = normal::normal_terms(leading, &Symbol::new("r")).ok()?;
    let [only] = terms.as_slice() else { return None };
    (only.kernel.is_one() && sign(&only.coefficient) != Sign::Zero).then(|| (only.coefficient.clone(), only.exponent.clone()))
}

/// True if the two agree close to the axis at admissible parameters.
fn is_confirmed(solution: &Solution, f_prime: &Expr, leading: &Expr) -> bool {
    const CLOSE: f64 = 0.05;
    let Some(mut values) = Sampler::new(7).parameters(solution) else { return false };
    values.insert(Symbol::new("r"), Expr::ratio(1, 10_000));
    let value = |expr: &Expr| constant_value(&values.apply(expr), &Bindings::default()).map(|own| own.value).unwrap_or(f64::NAN);
    let (one, other) = (value(f_prime), value(leading));
    ((one - other) / other).abs() < CLOSE
}
