//! The first radius beyond a lower end where an expression vanishes, as a formula.

use crate::derive::angles;
use crate::derive::domain::located::approximate;
use crate::derive::domain::{certain_sign_at, sample_bindings, value_at};
use crate::eval::constant_value;
use crate::expr::{Bindings, Expr, Node, Sign, Symbol, normal, sign};

/// How an expression behaves at its first zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Zero {
    /// Every zero counts, as for a divisor or the argument of a logarithm.
    Any,
    /// Only a change of sign counts, as for the argument of a square root.
    Crossing,
}

/// Random admissible parameters at which a formula is tested.
const SAMPLES: usize = 12;
/// Fewer samples prove too little.
const FEWEST: usize = 4;
/// Places between the lower end and the zero at which the expression must be positive.
const PLACES: u32 = 24;
/// The relative distance from a positive lower end at which the sign is read.
const NEAR: f64 = 1e-9;
/// The radii at which the sign next to the axis is read, in any unit of length: the first with a certain sign decides.
const NEXT_TO_THE_AXIS: [f64; 8] = [1e-290, 1e-200, 1e-120, 1e-80, 1e-40, 1e-25, 1e-15, NEAR];
/// The relative distance beyond a zero at which a double zero differs from rounding errors.
const BEYOND: f64 = 1e-4;

/// The sign next to the lower end at random parameters: `None` if it depends on them, or is known nowhere.
pub(crate) fn starting_sign(expr: &Expr, lower: &Expr) -> Option<Sign> {
    let signs: Vec<bool> = starts(expr, lower).into_iter().map(|(_, _, positive)| positive).collect();
    match signs.first() {
        Some(first) if signs.iter().all(|own| own == first) => Some(if *first { Sign::Positive } else { Sign::Negative }),
        _ => None,
    }
}

/// Random parameters, the lower end there, and whether the expression is positive next to it.
fn starts(expr: &Expr, lower: &Expr) -> Vec<(Bindings, f64, bool)> {
    // Every other set has its numbers cubed, so that they cover four decades.
    let whole = expr + lower;
    let power = |name: &Symbol| if angles::largest(&whole, name).is_some() { 1 } else { 3 };
    let cubed = |set: Bindings| set.iter().map(|(name, value)| (name.name(), value.power(power(name)))).collect();
    let sets = sample_bindings(&whole, 2 * SAMPLES).into_iter().enumerate();
    let sets = sets.map(|(index, set)| if index % 2 == 1 { cubed(set) } else { set });
    let start = |set: Bindings| {
        let low = number(lower, &set)?;
        let sign = if low > 0.0 {
            certain_sign_at(expr, &set, low + NEAR * low)
        } else {
            NEXT_TO_THE_AXIS.iter().find_map(|r| certain_sign_at(expr, &set, *r))
        }?;
        Some((set, low, sign > 0.0))
    };
    sets.into_iter().filter_map(start).collect()
}

/// The first zero of an expression that is positive next to `lower`; `None` if it has none, or none that this finds.
///
/// The candidates solve the equation exactly.
/// Which of them comes first is found at random parameters, between which and `lower` the expression must be positive.
pub(crate) fn first_zero(expr: &Expr, lower: &Expr, zero: Zero) -> Option<Expr> {
    let mut places = Vec::new();
    reached(expr, &Expr::zero(), &mut places);
    places.dedup();
    first_of(&places, expr, lower, zero).or_else(|| first_of(&places.iter().map(absolute).collect::<Vec<_>>(), expr, lower, zero))
}

/// The candidate that is the first zero at all random parameters.
fn first_of(places: &[Expr], expr: &Expr, lower: &Expr, zero: Zero) -> Option<Expr> {
    let samples: Vec<(Bindings, f64)> =
        starts(expr, lower).into_iter().filter(|(_, _, positive)| *positive).map(|(set, low, _)| (set, low)).collect();
    if places.is_empty() || samples.len() < FEWEST {
        return None;
    }
    let mut chosen = None;
    for (set, low) in &samples {
        let mut found: Option<(usize, f64)> = None;
        for (index, place) in places.iter().enumerate() {
            let Some(at) = number(place, set).filter(|at| *at > low * (1.0 + NEAR)) else { continue };
            let beyond = value_at(expr, set, at * (1.0 + BEYOND));
            // The absolute value of a candidate is a zero of even functions only.
            let vanishes = || value_at(expr, set, at).abs() <= SMALL * value_at(expr, set, at * (1.0 - BEYOND)).abs();
            let counts = beyond.is_nan() || beyond <= 0.0 || (zero == Zero::Any && vanishes());
            if counts && found.is_none_or(|(_, first)| at < first) {
                found = Some((index, at));
            }
        }
        let (index, at) = found?;
        let inside = |step: u32| low + (at - low) * f64::from(step) / f64::from(PLACES);
        let positive = (1..PLACES).all(|step| value_at(expr, set, inside(step)) > 0.0);
        if !positive || chosen.is_some_and(|own| own != index) {
            return None;
        }
        chosen = Some(index);
    }
    places.get(chosen?).cloned()
}

/// A value next to a zero, as a part of that at a distance of [`BEYOND`].
const SMALL: f64 = 1e-6;

/// True if the expression is not positive at some radius beyond `lower`, for some of the random parameters.
pub(crate) fn fails_somewhere(expr: &Expr, lower: &Expr) -> bool {
    starts(expr, lower).iter().any(|(set, low, positive)| {
        (-24..24).any(|power| {
            let value = value_at(expr, set, low + f64::from(power).exp2());
            value.is_finite() && value != 0.0 && (value > 0.0) != *positive
        })
    })
}

fn number(expr: &Expr, set: &Bindings) -> Option<f64> {
    constant_value(expr, set).ok().map(|own| own.value).filter(|own| own.is_finite())
}

/// Adds the radii at which `part` has the given value, as far as inverse functions give them.
fn reached(part: &Expr, value: &Expr, places: &mut Vec<Expr>) {
    let radius = Symbol::new("r");
    let depends = |expr: &Expr| expr.contains(&radius);
    match part.node() {
        Node::Symbol(_) if depends(part) => places.push(value.clone()),
        Node::Sum(terms) => {
            let (own, free): (Vec<Expr>, Vec<Expr>) = terms.iter().cloned().partition(|term| depends(term));
            let value = value - Expr::sum(free);
            match own.as_slice() {
                [only] => reached(only, &value, places),
                _ => of_powers(&(Expr::sum(own) - value), &radius, places),
            }
        }
        Node::Product(factors) => {
            let (own, free): (Vec<Expr>, Vec<Expr>) = factors.iter().cloned().partition(|factor| depends(factor));
            match own.as_slice() {
                [only] => reached(only, &(value / Expr::product(free)), places),
                _ if value.is_zero() => own.iter().for_each(|factor| reached(factor, value, places)),
                _ => {}
            }
        }
        Node::Power(base, exponent) if !depends(exponent) => {
            if !value.is_zero() {
                let root = root_of(value, exponent);
                reached(base, &root, places);
                if exponent.as_integer().is_some_and(|n| n % 2 == 0) {
                    reached(base, &-root, places);
                }
            } else if sign(exponent) == Sign::Positive {
                reached(base, value, places);
            }
        }
        Node::Power(base, exponent) if !depends(base) && !value.is_zero() => {
            let logarithm = |of: &Expr| Expr::call("ln", [of.clone()]);
            reached(exponent, &(logarithm(value) / logarithm(base)), places);
        }
        Node::Function(function, arguments) => {
            let arguments: Vec<&Expr> = arguments.iter().collect();
            for (argument, value) in inverses(function.name(), &arguments, value) {
                reached(argument, &value, places);
            }
        }
        _ => {}
    }
}

/// value^(1/n); |u| for the square root of u², whose sign is not known.
fn root_of(value: &Expr, exponent: &Expr) -> Expr {
    let is_even = exponent.as_integer().is_some_and(|n| n % 2 == 0);
    match last_root(value) {
        Some((root, power)) if is_even && sign(&root) == Sign::Unknown => absolute(&root).pow(&(power / exponent)),
        _ => value.pow(&exponent.recip()),
    }
}

/// u and 2^k of u^(2^k), for the largest k above 0, where u has parameters. The sign of u is arbitrary.
pub(crate) fn last_root(value: &Expr) -> Option<(Expr, Expr)> {
    let next = |own: &Expr| normal::square_root(own).filter(|root| !root.symbols().is_empty());
    let (mut root, mut power) = (next(value)?, Expr::integer(2));
    while let Some(next) = next(&root).or_else(|| next(&-&root)) {
        (root, power) = (next, power * Expr::integer(2));
    }
    Some((root, power))
}

/// √u, without a root where u is the square of what has a known sign, as b² + 2bc + c².
pub(crate) fn root_of_square(expr: &Expr) -> Expr {
    match normal::square_root(expr).map(|root| (sign(&root), root)) {
        Some((Sign::Positive, root)) => root,
        Some((Sign::Negative, root)) => -root,
        _ => expr.sqrt(),
    }
}

/// |u|, with the factors of known sign in front.
fn absolute(expr: &Expr) -> Expr {
    let (open, known): (Vec<Expr>, Vec<Expr>) = expr.factors().into_iter().partition(|own| sign(own) == Sign::Unknown);
    let known = known.into_iter().map(|own| if sign(&own) == Sign::Negative { -own } else { own });
    let open = Expr::product(open);
    Expr::product(known) * if open.is_one() { open } else { Expr::call("abs", [open]) }
}

/// Zeros of sums of two powers of r, and of three that are quadratic in a power of r.
fn of_powers(sum: &Expr, radius: &Symbol, places: &mut Vec<Expr>) {
    let Ok(mut terms) = normal::normal_terms(sum, radius) else { return };
    if terms.iter().any(|term| !term.kernel.is_one() || term.exponent.as_number().is_none()) {
        return;
    }
    terms.sort_by(|one, other| one.exponent.as_number().cmp(&other.exponent.as_number()));
    match terms.as_slice() {
        [low, high] => {
            let gap = &high.exponent - &low.exponent;
            places.push((-&low.coefficient / &high.coefficient).pow(&gap.recip()));
        }
        [c, b, a] if &c.exponent + &a.exponent == Expr::integer(2) * &b.exponent => {
            let (half, power) = (&b.coefficient / Expr::integer(2), (&b.exponent - &c.exponent).recip());
            let root = root_of_square(&(half.power(2) - &a.coefficient * &c.coefficient));
            let tidy = |own: Expr| normal::expanded(&own, radius).unwrap_or(own);
            places.push(tidy((&root - &half) / &a.coefficient).pow(&power));
            places.push(tidy((-root - half) / &a.coefficient).pow(&power));
        }
        _ => {}
    }
}

/// The arguments, not below zero where there are several, at which a function has a value; that of the principal inverse is the first.
pub(crate) fn inverses<'a>(name: &str, arguments: &[&'a Expr], value: &Expr) -> Vec<(&'a Expr, Expr)> {
    let call = |name: &'static str| Expr::call(name, [value.clone()]);
    let (argument, values) = match (name, arguments) {
        ("sin", [u]) if value.is_zero() => (*u, vec![Expr::zero(), Expr::pi()]),
        ("sin", [u]) => (*u, vec![call("asin"), Expr::pi() - call("asin")]),
        ("cos", [u]) => (*u, vec![call("acos"), Expr::integer(2) * Expr::pi() - call("acos")]),
        ("tan", [u]) => (*u, vec![call("atan"), call("atan") + Expr::pi()]),
        ("exp", [u]) => (*u, vec![call("ln")]),
        ("ln", [u]) => (*u, vec![call("exp")]),
        ("asin", [u]) => (*u, vec![call("sin")]),
        ("acos", [u]) => (*u, vec![call("cos")]),
        ("atan", [u]) => (*u, vec![call("tan")]),
        ("sinh", [u]) => (*u, vec![call("asinh")]),
        ("cosh", [u]) => (*u, vec![call("acosh")]),
        ("tanh", [u]) => (*u, vec![call("atanh")]),
        ("asinh", [u]) => (*u, vec![call("sinh")]),
        ("acosh", [u]) => (*u, vec![call("cosh")]),
        ("atanh", [u]) => (*u, vec![call("tanh")]),
        ("besselj", [n, u]) if value.is_zero() && n.is_zero() => (*u, approximate(2.404_825_557_695_773).into_iter().collect()),
        ("besselj", [n, u]) if value.is_zero() && n.is_one() => (*u, approximate(3.831_705_970_207_512).into_iter().collect()),
        _ => return Vec::new(),
    };
    values.into_iter().map(|own| (argument, own)).collect()
}
