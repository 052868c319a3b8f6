//! Where a profile is real and finite: its value at the axis, and tests at random admissible points.

pub(crate) mod above_zero;
pub(crate) mod acute_sign;
pub(crate) mod barrier;
pub(crate) mod decided;
pub(crate) mod demand;
pub(crate) mod demands;
pub(crate) mod first_zero;
pub(crate) mod identity;
pub(crate) mod located;
pub(crate) mod numeric_sign;

use crate::derive::angles;
use crate::derive::domain::numeric_sign::certain_sign;
use crate::derive::stream::Stream;
use crate::eval::{BoundedAlgebra, WideAlgebra, constant_value, walk};
use crate::expr::function::has_pole;
use crate::expr::{Bindings, Condition, Expr, Node, Number, Relation, Sign, Symbol, leading_term, normal, sign};
use crate::integrate::error::TransformError;
use crate::num::{Bounded, Precise, Wide};
use crate::print;

/// f(0) of the innermost piece.
///
/// # Errors
/// [`TransformError::SingularAtAxis`] where f is infinite there, [`TransformError::NotReal`] where it is not real.
pub(crate) fn value_at_axis(piece: &Expr, conditions: &mut Vec<Condition>) -> Result<Expr, TransformError> {
    let radius = Symbol::new("r");
    if let Some(value) = finite_limit_of_terms(piece, &radius, conditions) {
        return value;
    }
    if is_regular(piece) {
        let here = Bindings::one("r", Expr::zero()).apply(piece);
        return match probe(&here, 0.0) {
            Probe::Finite => Ok(here),
            Probe::NotReal => Err(TransformError::NotReal { detail: print::text_expr(piece) }),
            Probe::Infinite => Err(TransformError::SingularAtAxis { detail: print::text_expr(piece) }),
        };
    }
    if let Some(value) = limit_of_regular_terms(piece, &radius) {
        return Ok(value);
    }
    // sin(k r)/(k r) and the like: the leading term of their power series.
    let terms = normal::normal_terms(piece, &radius).ok();
    let recognised = terms.map_or_else(|| piece.clone(), |terms| Expr::sum(terms.iter().map(|term| term.to_expr(&radius))));
    if let Some(term) = leading_term(piece).or_else(|| leading_term(&recognised)) {
        return match term.exponent {
            own if own.is_positive() => Ok(Expr::zero()),
            own if own.is_zero() => Ok(term.coefficient),
            _ => Err(TransformError::SingularAtAxis { detail: print::text_expr(piece) }),
        };
    }
    // Where poles cancel, as those of digamma(r) + 1/r, the difference of two large numbers says nothing.
    let has_pole = piece.parts().any(has_pole_at_axis);
    // r^n ln(1 + 1/r) and the like: look at the sequence r → 0.
    let settled = sample_bindings(piece, 3).iter().all(|set| {
        let near = |r: f64| value_at(piece, set, r);
        let (u, v, w) = (near(1e-80), near(1e-120), near(1e-160));
        let size = near(1e-3).abs().max(f64::MIN_POSITIVE);
        u.is_finite()
            && v.is_finite()
            && w.is_finite()
            && (v - w).abs() <= 1e-9 * size.max(w.abs())
            && (u - v).abs() <= 1e-6 * size.max(w.abs())
            && converges(piece, set)
            && (!has_pole || has_digits(piece, set, 1e-80))
    });
    let unknown = || TransformError::UnknownAtAxis { detail: print::text_expr(piece) };
    if !settled {
        return Err(if grows(&recognised) { TransformError::SingularAtAxis { detail: print::text_expr(piece) } } else { unknown() });
    }
    let limits: Vec<f64> = sample_bindings(piece, 3).iter().map(|set| value_at(piece, set, 1e-160)).collect();
    if limits.iter().all(|limit| limit.abs() < 1e-30) {
        return Ok(Expr::zero());
    }
    match (limits.first().copied().and_then(Number::from_f64), piece.symbols().len()) {
        // A limit that was looked at is known to a double's digits only.
        (Some(limit), 0 | 1) => Ok(Expr::call("approximate", [Expr::number(limit)])),
        _ => Err(unknown()),
    }
}

/// True where the values toward the axis exceed any limit that equal or growing steps between them exceed, as those of ln(r) do.
fn grows(piece: &Expr) -> bool {
    sample_bindings(piece, 3).iter().all(|set| {
        let [far, near, nearest] = [1e-40, 1e-80, 1e-160].map(|r| value_at(piece, set, r));
        let (step, before) = ((nearest - near).abs(), (near - far).abs());
        nearest.is_infinite() || (step > 0.0 && step >= 0.9 * before && has_digits(piece, set, 1e-80))
    })
}

/// The limit from the recognition form, where every term is a plain power.
fn finite_limit_of_terms(piece: &Expr, radius: &Symbol, conditions: &mut Vec<Condition>) -> Option<Result<Expr, TransformError>> {
    let terms = normal::normal_terms(piece, radius).ok()?;
    let (mut limit, mut demands) = (Expr::zero(), Vec::new());
    // Poles of several terms may cancel, as in (1 − cos r)/r; those of plain powers cannot.
    let plain = terms.iter().all(|term| term.kernel.is_one());
    for term in terms {
        let positive = sign(&term.exponent) == Sign::Positive;
        if positive && is_logarithmic(&term.kernel, radius) {
            continue;
        }
        if !term.kernel.is_one() {
            return None;
        }
        match sign(&term.exponent) {
            Sign::Positive => {}
            Sign::Zero => limit = limit + term.coefficient,
            Sign::Negative if !plain => return None,
            Sign::Negative => {
                let detail = print::text_expr(&term.to_expr(radius));
                return Some(Err(TransformError::SingularAtAxis { detail }));
            }
            // An exponent of unknown sign must be positive: that is for the reader to judge.
            Sign::Unknown => demands.push(Condition::less(Expr::zero(), term.exponent)),
        }
    }
    conditions.extend(demands);
    Some(Ok(limit))
}

/// The limit from the recognition form, where every kernel is finite at the axis or a logarithm under a positive power.
fn limit_of_regular_terms(piece: &Expr, radius: &Symbol) -> Option<Expr> {
    let at_axis = Bindings::one("r", Expr::zero());
    let mut limit = Expr::zero();
    for term in normal::normal_terms(piece, radius).ok()? {
        let positive = sign(&term.exponent) == Sign::Positive;
        if positive && is_logarithmic(&term.kernel, radius) {
            continue;
        }
        let here =
            is_regular(&term.kernel).then(|| at_axis.apply(&term.kernel)).filter(|value| matches!(probe(value, 0.0), Probe::Finite))?;
        match sign(&term.exponent) {
            Sign::Positive => {}
            Sign::Zero => limit = limit + term.coefficient * here,
            Sign::Negative | Sign::Unknown => return None,
        }
    }
    Some(limit)
}

/// True for 1 and for powers of logarithms of r, which any positive power of r outweighs at the axis.
fn is_logarithmic(kernel: &Expr, radius: &Symbol) -> bool {
    kernel.factors().iter().all(|factor| match factor.split_power().0.node() {
        Node::Number(_) => true,
        Node::Function(function, arguments) => {
            function.name() == "ln"
                && arguments
                    .iter()
                    .all(|a| a.factors().iter().all(|f| f.split_power().0.as_symbol() == Some(radius) || !f.contains(radius)))
        }
        _ => false,
    })
}

enum Probe {
    Finite,
    NotReal,
    Infinite,
}

fn probe(expr: &Expr, r: f64) -> Probe {
    let mut real = false;
    for set in sample_bindings(expr, 4) {
        let value = value_at(expr, &set, r);
        if value.is_infinite() {
            return Probe::Infinite;
        }
        real |= value.is_finite();
    }
    if real { Probe::Finite } else { Probe::NotReal }
}

/// False if something vanishes at the axis under a power that may be negative, or in a logarithm, or a function has no value there,
/// such as tan(π/2).
pub(crate) fn is_regular(expr: &Expr) -> bool {
    let at_axis = Bindings::one("r", Expr::zero());
    let vanishes = |inner: &Expr| at_axis.apply(inner).is_zero();
    expr.parts().all(|own| match own.node() {
        Node::Power(base, exponent) => sign(exponent) == Sign::Positive || !vanishes(base),
        Node::Function(function, arguments) if function.name() == "ln" && arguments.iter().any(vanishes) => false,
        _ => !has_pole_at_axis(own),
    })
}

/// True for a function with a pole at the axis, such as tan(π/2 − r). Those of ln, artanh and K are logarithmic: every power outweighs
/// them.
fn has_pole_at_axis(expr: &Expr) -> bool {
    match Bindings::one("r", Expr::zero()).apply(expr).node() {
        Node::Function(function, arguments) => {
            matches!(function.name(), "tan" | "gamma" | "digamma" | "polygamma") && has_pole(*function, arguments)
        }
        _ => false,
    }
}

/// True where the expression vanishes within its error bound at 32 random admissible points; `None` where it is real at none.
pub(crate) fn vanishes_at_random_points(expr: &Expr) -> Option<bool> {
    let mut seen = false;
    for set in sample_bindings(expr, 32) {
        let Ok(value) = constant_value(expr, &set) else { return Some(false) };
        if value.value.is_nan() {
            continue;
        }
        seen = true;
        if value.value.abs() > 4.0 * value.error {
            return Some(false);
        }
    }
    seen.then_some(true)
}

/// True if the difference of two pieces next to the place where they meet does not become smaller on the way there, and stays finite, at
/// random parameters that meet these conditions.
pub(crate) fn seems_to_jump(before: &Expr, beyond: &Expr, at: &Expr, conditions: &[Condition]) -> bool {
    const SETS: usize = 3;
    const DRAWN: usize = 64;
    let whole = before + beyond + at;
    let fails = |own: &Condition, set: &Bindings| match (constant_value(&own.left, set), constant_value(&own.right, set)) {
        (Ok(left), Ok(right)) => own.relation != Relation::Equal && left.value > right.value,
        _ => false,
    };
    let is_admissible = |set: &Bindings| !conditions.iter().any(|own| fails(own, set));
    sample_bindings(&whole, DRAWN).iter().filter(|set| is_admissible(set)).take(SETS).any(|set| {
        let Ok(place) = constant_value(at, set) else { return false };
        let [far, near, nearest] = [1e-3, 1e-6, 1e-9].map(|distance| {
            let sides = [(before, -distance), (beyond, distance)];
            sides.map(|(piece, distance)| bounded_at(piece, set, place.value * (1.0 + distance)))
        });
        let jump = |[low, high]: [Bounded; 2]| high.value - low.value;
        let size: f64 = nearest.iter().map(|own| own.value.abs()).sum();
        // The place is known with an error only, which moves both sides.
        let rise: f64 = far.iter().zip(&near).map(|(far, near)| (far.value - near.value).abs() / 1e-3).sum();
        let doubt = 1e-6 * size + nearest.iter().map(|own| own.error).sum::<f64>() + 2.0 * rise * (place.error / place.value).abs();
        // A difference that grows belongs to a pole, where the profile ends.
        let is_steady = |one: f64, other: f64| (0.9..1.1).contains(&(other / one));
        jump(nearest).abs() > doubt && is_steady(jump(near), jump(nearest)) && is_steady(jump(far), jump(near))
    })
}

/// Seeded random positive values, exact in `f64`, for every symbol of the expression besides r.
pub(crate) fn sample_bindings(expr: &Expr, count: usize) -> Vec<Bindings> {
    let names: Vec<Symbol> = expr.symbols().into_iter().filter(|s| s.name() != "r").collect();
    let mut stream = Stream::new(0x5eed_0d0e);
    let largest: Vec<Option<f64>> = names.iter().map(|name| angles::largest(expr, name)).collect();
    let mut draw = |largest: Option<f64>| {
        let value = stream.dyadic();
        // A slope angle is acute.
        let acute = largest.and_then(|end| Number::from_f64(end * value.to_f64() / (1.0 + value.to_f64())));
        Expr::number(acute.unwrap_or(value))
    };
    (0..count).map(|_| names.iter().zip(&largest).map(|(name, largest)| (name.name(), draw(*largest))).collect()).collect()
}

fn has_digits(piece: &Expr, set: &Bindings, r: f64) -> bool {
    let value = walk(&set.apply(piece), &mut BoundedAlgebra, &mut |_| Some(Bounded::exact(r)));
    value.is_ok_and(|own| own.error < 1e-3 * own.value.abs())
}

/// False if the values move apart toward the axis by more than their errors: where 1 − r is 1 to rounding, 1/cos(asin(1 − r)) is a
/// large constant.
///
/// The last three values that are certain decide, so that exp(−w/r) has its limit in every unit of length.
fn converges(piece: &Expr, set: &Bindings) -> bool {
    /// Largest relative error of a certain value, and what counts as 0.
    const CERTAIN: f64 = 1e-3;
    const NOTHING: f64 = 1e-250;
    let here = set.apply(piece);
    let at = |r: f64| walk(&here, &mut BoundedAlgebra, &mut |_| Some(Bounded::exact(r))).ok();
    let radii = (1..54).map(|step| 10f64.powi(-3 * step));
    let certain: Vec<Bounded> = radii.map_while(at).take_while(|own| own.error <= (CERTAIN * own.value.abs()).max(NOTHING)).collect();
    let [.., far, near, nearest] = certain.as_slice() else { return true };
    let step = (nearest.value - near.value).abs();
    step.is_nan() || step <= 0.9 * (near.value - far.value).abs() + 2.0 * (near.error + nearest.error)
}

/// 1 or −1 if the error bound of the value determines its sign, in double precision or with 30 digits.
pub(crate) fn certain_sign_at(expr: &Expr, set: &Bindings, r: f64) -> Option<f64> {
    let here = set.apply(expr);
    let own = walk(&here, &mut BoundedAlgebra, &mut |_| Some(Bounded::exact(r))).ok();
    own.and_then(certain_sign).or_else(|| {
        let own = walk(&here, &mut WideAlgebra, &mut |_| Some(Wide::new(Precise::exact(r)))).ok()?;
        certain_sign(own.precise().bounded())
    })
}

pub(crate) fn value_at(expr: &Expr, set: &Bindings, r: f64) -> f64 {
    bounded_at(expr, set, r).value
}

fn bounded_at(expr: &Expr, set: &Bindings, r: f64) -> Bounded {
    let (here, unknown) = (set.apply(expr), Bounded::exact(f64::NAN));
    let own = walk(&here, &mut BoundedAlgebra, &mut |_| Some(Bounded::exact(r))).unwrap_or(unknown);
    if !own.value.is_nan() {
        return own;
    }
    // Infinite parts may meet in a number.
    let wide = Wide::new(Precise::exact(r));
    walk(&here, &mut WideAlgebra, &mut |_| Some(wide)).map_or(unknown, |own| own.precise().bounded())
}
