//! What roots, divisors and functions demand of r: that an expression be positive, up to where it is, and under which conditions.

use crate::derive::angles;
use crate::derive::chain::Chain;
use crate::derive::domain::above_zero::above_zero;
use crate::derive::domain::barrier::Barrier;
use crate::derive::domain::decided::is_proven_not_below;
use crate::derive::domain::demand::Demand;
use crate::derive::domain::first_zero::{Zero, fails_somewhere, first_zero, starting_sign};
use crate::derive::domain::located::approximate;
use crate::derive::domain::numeric_sign::numeric_sign;
use crate::derive::domain::{is_regular, sample_bindings, value_at, vanishes_at_random_points};
use crate::eval::constant_value;
use crate::expr::{Bindings, Condition, Expr, Node, Relation, Sign, Symbol, leading_term, normal, sign};
use crate::integrate::error::TransformError;
use crate::print;

/// Random parameters at which a limit of f is looked for.
const SAMPLES: usize = 4;

/// Adds what the functions and roots of a chain demand of r, solved for r where that is possible.
///
/// `unused` has, for each piece, the arguments of min and max that must have a value although the piece does not contain them.
///
/// # Errors
/// [`TransformError::NotReal`] if a demand can never be met near the axis.
pub(crate) fn collect(
    chain: &Chain,
    unused: &[Vec<Expr>],
    conditions: &mut Vec<Condition>,
    open: &mut Vec<Demand>,
) -> Result<(), TransformError> {
    for (index, (lower, upper, piece)) in chain.intervals().enumerate() {
        let (mut demands, before) = (Vec::new(), conditions.len());
        for own in unused.get(index).into_iter().flatten().chain([piece]) {
            gather(own, &lower, upper, &mut demands);
        }
        let is_unbounded = !demands.is_empty() && upper.is_some_and(|upper| !has_limit_at(piece, upper));
        for demand in demands.into_iter().map(|own| Demand { is_unbounded, ..own }) {
            match solve(&demand)? {
                Outcome::Holds => {}
                Outcome::Holding(condition) => conditions.push(condition),
                Outcome::Open if open.contains(&demand) => {}
                Outcome::Open => {
                    conditions.extend(stated(&demand)?);
                    open.push(demand);
                }
            }
        }
        let is_end = |own: &Condition| own.left == Expr::symbol("r") && upper.is_some_and(|upper| is_proven_not_below(upper, &own.right));
        if conditions.get(before..).is_some_and(|own| own.iter().any(is_end)) {
            // The pieces beyond are not reached.
            break;
        }
    }
    Ok(())
}

/// True if some function, root or divisor of the expression may demand something of r.
pub(crate) fn are_made(expr: &Expr) -> bool {
    let mut demands = Vec::new();
    gather(expr, &Expr::zero(), None, &mut demands);
    !demands.is_empty()
}

/// Expressions under fractional powers, in divisors and in restricted functions.
fn gather(expr: &Expr, lower: &Expr, upper: Option<&Expr>, demands: &mut Vec<Demand>) {
    let mut add = |expr: &Expr, zero, either_sign| {
        if sign(expr) != Sign::Positive {
            let negative = either_sign && starts_negative(expr, lower);
            let expr = if negative { -expr } else { expr.clone() };
            demands.push(Demand { expr, zero, either_sign, lower: lower.clone(), upper: upper.cloned(), is_unbounded: false });
        }
    };
    match expr.node() {
        Node::Power(base, exponent) => match (exponent.as_integer(), base.node()) {
            // The reciprocal of a tangent has no pole where the tangent has one.
            (Some(n), Node::Function(function, arguments)) if n < 0 && function.name() == "tan" => {
                add(&Expr::call("sin", arguments.iter().cloned()), Zero::Any, true);
                return arguments.iter().for_each(|argument| gather(argument, lower, upper, demands));
            }
            (Some(n), _) if n < 0 => add(base, Zero::Any, true),
            (Some(_), _) => {}
            (None, _) if sign(exponent) == Sign::Positive => add(base, Zero::Crossing, false),
            (None, _) => add(base, Zero::Any, false),
        },
        Node::Function(function, arguments) => {
            let zero = if matches!(function.name(), "asin" | "acos" | "acosh") { Zero::Crossing } else { Zero::Any };
            let own = function.row().domain.map_or_else(Vec::new, |domain| domain(arguments));
            own.iter().for_each(|expr| add(expr, zero, false));
            match (function.name(), arguments.last()) {
                ("tan", Some(u)) => add(&Expr::call("cos", [u.clone()]), Zero::Any, true),
                // Between the poles at 0, −1, −2, … nothing is demanded.
                ("gamma" | "digamma" | "polygamma", Some(u)) if !starts_negative(u, lower) => add(u, Zero::Any, false),
                _ => {}
            }
        }
        _ => {}
    }
    expr.children().into_iter().for_each(|child| gather(child, lower, upper, demands));
}

/// True if the expression is known to be negative next to the lower end.
fn starts_negative(expr: &Expr, lower: &Expr) -> bool {
    // r/tanh(r) − 1 is 0/0 − 1 at the axis.
    if lower.is_zero() && !is_regular(expr) {
        return starting_sign(expr, lower) == Some(Sign::Negative);
    }
    let here = Bindings::one("r", lower.clone()).apply(expr);
    sign(&here) == Sign::Negative || numeric_sign(&here) == Some(-1.0)
}

enum Outcome {
    /// It is met throughout the piece.
    Holds,
    /// It is met throughout the piece under this condition.
    Holding(Condition),
    /// Nothing is proven.
    Open,
}

/// The proof status of a demand.
fn solve(demand: &Demand) -> Result<Outcome, TransformError> {
    let Demand { expr, lower, .. } = demand;
    let radius = Symbol::new("r");
    let never = || TransformError::NotReal { detail: print::text_expr(expr) };
    if !expr.contains(&radius) {
        return match sign(expr) {
            Sign::Negative => Err(never()),
            Sign::Positive => Ok(Outcome::Holds),
            _ => match numeric_sign(expr) {
                Some(s) if s > 0.0 => Ok(Outcome::Holds),
                Some(_) => Err(never()),
                // A divisor of unknown sign must only not be zero.
                None if demand.either_sign => Ok(Outcome::Holds),
                None => above_zero(expr).map(Outcome::Holding).ok_or_else(never),
            },
        };
    }
    if lower.is_zero() && starts_negative(expr, lower) {
        return Err(never());
    }
    let Ok(terms) = normal::normal_terms(expr, &radius) else { return Ok(Outcome::Open) };
    let (mut constant, mut power) = (Expr::zero(), None);
    for term in terms {
        if term.kernel.is_one() && term.exponent.is_zero() {
            constant = term.coefficient;
        } else if term.kernel.is_one() && power.is_none() && sign(&term.exponent) == Sign::Positive {
            power = Some(term);
        } else {
            return Ok(Outcome::Open);
        }
    }
    let Some(power) = power else { return Ok(Outcome::Holds) };
    let limit = || (-&constant / &power.coefficient).pow(&power.exponent.recip());
    match (sign(&constant), sign(&power.coefficient)) {
        (Sign::Positive | Sign::Zero, Sign::Positive) => Ok(Outcome::Holds),
        // c r^k keeps its sign.
        (Sign::Zero, Sign::Unknown) if demand.either_sign => Ok(Outcome::Holds),
        (Sign::Zero | Sign::Negative, Sign::Negative) => Err(never()),
        (Sign::Positive, Sign::Negative) => Ok(end_at(limit(), demand).map_or(Outcome::Holds, Outcome::Holding)),
        (Sign::Negative, Sign::Positive) => match sign(&(lower - limit())) {
            Sign::Positive | Sign::Zero => Ok(Outcome::Holds),
            _ => Ok(Outcome::Holding(Condition::less(limit(), lower.clone()))),
        },
        _ => Ok(Outcome::Open),
    }
}

/// r < limit where a demand is met up to a limit; `None` if its piece ends before the limit, or at it with a finite f.
fn end_at(limit: Expr, demand: &Demand) -> Option<Condition> {
    let radius = Symbol::new("r");
    let r = Expr::from(radius.clone());
    let Some(end) = &demand.upper else { return Some(Condition::less(r, limit)) };
    let room = &limit - end;
    let is_at_end =
        || angles::is_proven_zero(&room, &radius) || room.symbols().is_empty() || vanishes_at_random_points(&room) == Some(true);
    match (sign(&room), numeric_sign(&room)) {
        (Sign::Positive, _) | (_, Some(1.0)) => None,
        (Sign::Negative, _) | (_, Some(_)) => Some(Condition::less(r, limit)),
        (own, _) if own == Sign::Zero || is_at_end() => {
            (demand.zero == Zero::Any && demand.is_unbounded).then(|| Condition::less(r, limit))
        }
        _ if angles::is_proven_below(end, &limit) || is_square(&(limit.power(2) - end.power(2))) => None,
        _ => Some(Condition { left: end.clone(), relation: Relation::LessOrEqual, right: limit }),
    }
}

/// True for the square of a polynomial in the parameters, which is not negative.
fn is_square(expr: &Expr) -> bool {
    normal::square_root(expr).is_some()
}

/// True if f seems to have a finite limit at the upper end of its piece: its changes towards there become smaller.
fn has_limit_at(piece: &Expr, upper: &Expr) -> bool {
    sample_bindings(&(piece + upper), SAMPLES).iter().all(|set| {
        let Ok(end) = constant_value(upper, set) else { return false };
        let [one, two, three] = [1e-4, 1e-8, 1e-12].map(|distance| value_at(piece, set, end.value * (1.0 - distance)));
        one.is_nan() || two.is_nan() || (three - two).abs() <= 0.9 * (two - one).abs() + 64.0 * f64::EPSILON * two.abs()
    })
}

/// The conditions of a demand that is not proven: what its lower end demands of the parameters, and where its first zero is.
fn stated(demand: &Demand) -> Result<Vec<Condition>, TransformError> {
    let Demand { expr, zero, either_sign, lower, upper, .. } = demand;
    let mut conditions = Vec::new();
    let starts = starting_sign(expr, lower);
    if starts.is_none() && *either_sign {
        // Which sign it has, and where that ends, depends on the parameters.
        return Ok(conditions);
    }
    if starts != Some(Sign::Positive) && !either_sign {
        let start = Bindings::one("r", lower.clone()).apply(expr);
        if starts == Some(Sign::Negative) && start.is_zero() && lower.is_zero() {
            // It falls from 0 on, as −r/(b + r) does.
            return Err(TransformError::NotReal { detail: print::text_expr(expr) });
        }
        if sign(&start) == Sign::Unknown && !start.symbols().is_empty() {
            conditions.push(above_zero(&start).ok_or_else(|| TransformError::NotReal { detail: print::text_expr(expr) })?);
        }
    }
    let expr = if *either_sign && starts == Some(Sign::Negative) { &-expr } else { expr };
    if let Some(limit) = first_zero(expr, lower, *zero) {
        conditions.extend(end_at(limit, demand));
    } else if expr.symbols().iter().chain(&lower.symbols()).all(|symbol| symbol.name() == "r") {
        let end = Barrier::new(demand, &Bindings::default())?.first_end();
        conditions.extend(end.and_then(approximate).map(|end| Condition::less(Expr::symbol("r"), end)));
    } else if upper.is_none() && fails_somewhere(expr, lower) {
        conditions.push(Condition::less(Expr::zero(), expr.clone()));
    }
    Ok(conditions)
}

/// The conditions under which divisors keep the sign that they have at the lower end of a piece, where it depends on the parameters.
///
/// If `conditions` imply the sign, the condition is r < limit, the first zero; otherwise 0 < D(lower) D(r).
pub(crate) fn of_either_sign(demands: &[Demand], conditions: &[Condition]) -> Vec<Condition> {
    let mut found = Vec::new();
    for demand in demands {
        let Demand { expr, zero, either_sign, lower, .. } = demand;
        if !either_sign || starting_sign(expr, lower).is_some() {
            continue;
        }
        let start = Bindings::one("r", lower.clone()).apply(expr);
        let is_given = |own: &Expr| above_zero(own).is_some_and(|own| conditions.contains(&own));
        let from = [expr.clone(), -expr].into_iter().zip([start.clone(), -&start]).find(|(_, start)| is_given(start));
        match from.map(|(expr, _)| first_zero(&expr, lower, *zero)) {
            Some(Some(limit)) => found.extend(end_at(limit, demand)),
            // No zero was found for this sign.
            Some(None) => {}
            None if !start.is_zero() => found.push(Condition::less(Expr::zero(), start * expr)),
            // A sum that vanishes at the axis begins with the sign of its leading term.
            None => {
                let leading = leading_term(expr).filter(|_| lower.is_zero());
                found.extend(leading.map(|own| Condition::less(Expr::zero(), own.coefficient * expr)));
            }
        }
    }
    found
}
