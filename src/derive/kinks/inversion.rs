//! The sign change of a difference in which r occurs once, by inverting the functions around it from the outside inward.

use crate::derive::angles;
use crate::derive::domain::first_zero::{inverses, root_of_square};
use crate::expr::normal;
use crate::expr::{Bindings, Condition, Expr, Node, Sign, Symbol, multiplied_out, over_one_denominator};
use std::collections::BTreeMap;

/// The sign of a difference on r > 0, if it changes at most once.
pub(super) enum Crossing {
    /// It changes at this place, from negative to positive if it rises.
    At { place: Expr, is_rising: bool },
    /// It has one sign.
    Never { is_positive: bool },
}

/// The sign change of a difference, and the conditions on parameters under which the change exists; `None` if it does not solve.
pub(super) fn crossing(difference: &Expr, radius: &Symbol) -> Option<(Crossing, Vec<Condition>)> {
    let mut conditions = Vec::new();
    let (power, is_rising) = match solved(difference, radius, &mut conditions)? {
        Solved::Root { power, is_rising } => (power, is_rising),
        Solved::Never { is_positive } => return Some((Crossing::Never { is_positive }, conditions)),
    };
    // The root is positive if the sign at the axis differs from that beyond the root.
    let at_axis = tidy(&Bindings::one(radius.name(), Expr::zero()).apply(difference), radius);
    let exists = match sign(&at_axis) {
        Some(own) => (own == Sign::Negative) == is_rising,
        None => is_above(&power.0, &Expr::zero(), &mut conditions)?,
    };
    let value = over_one_denominator(&power.0).unwrap_or(power.0);
    let (content, rest) = symbols_in_front(&value);
    let place = (content * rest).pow(&power.1.recip());
    Some((if exists { Crossing::At { place, is_rising } } else { Crossing::Never { is_positive: is_rising } }, conditions))
}

/// The sign change of s √(q₀ + q₂ r²) + l r + c, which is 0 at the axis, as the difference of a sphere or a hyperboloid and a cone with
/// the same apex, and its conditions; `None` for other differences.
///
/// With S = |s| √|q₂|, it is at 2|c l|/(S² ∓ l²), with the sign of q₂, under |l| < S.
pub(super) fn from_one_apex(difference: &Expr, radius: &Symbol) -> Option<(Crossing, Vec<Condition>)> {
    let (c, parts) = separated(&multiplied_out(difference), radius);
    let [one, two] = parts.as_slice() else { return None };
    let (line, root) = if one.0.as_symbol() == Some(radius) { (one, two) } else { (two, one) };
    let (base, exponent) = root.0.split_power();
    if line.0.as_symbol() != Some(radius) || exponent != Expr::ratio(1, 2) {
        return None;
    }
    let coefficients = normal::polynomial_coefficients(&base, radius)?;
    let [q0, q1, q2] = coefficients.as_slice() else { return None };
    let (s, l) = (&root.1, &line.1);
    if !q1.is_zero() || !angles::is_proven_zero(&(&c + s * root_of_square(q0)), radius) {
        return None;
    }
    let (is_round, of_c, of_l) = (sign(q2)? == Sign::Negative, sign(&c)?, sign(l)?);
    let is_positive = of_l == Sign::Positive;
    if is_round == (of_c == of_l) {
        return Some((Crossing::Never { is_positive }, Vec::new()));
    }
    let size = |own: &Expr, sign: Sign| if sign == Sign::Positive { own.clone() } else { -own };
    let (height, slope) = (size(&c, of_c), size(l, of_l));
    let square = s.power(2) * size(q2, if is_round { Sign::Negative } else { Sign::Positive });
    // A slope angle has a positive tangent.
    let steepest = match normal::square_root(&square).and_then(|root| Some((sign(&root)?, root))) {
        Some((of_root, root)) => size(&root, of_root),
        None => root_of_square(&square),
    };
    let mut conditions = Vec::new();
    let ratio = &slope / &steepest;
    let twice = angle_of_tangent(&ratio).map(|angle| Expr::integer(2) * angle);
    // A slope angle 2u is acute as well.
    let place = if let Some(twice) = twice.filter(|own| sign(&Expr::call("cos", [own.clone()])) == Some(Sign::Positive)) {
        height / steepest * Expr::call(if is_round { "sin" } else { "tan" }, [twice])
    } else {
        match angle_of_tangent(&ratio.recip()).and_then(beyond_half_of_right) {
            Some(condition) => conditions.push(condition),
            None if is_above(&steepest, &slope, &mut conditions)? => {}
            None => return Some((Crossing::Never { is_positive }, Vec::new())),
        }
        let is_below = |own: &Expr| sign(&own.split_power().1) == Some(Sign::Negative);
        let (below, above): (Vec<Expr>, Vec<Expr>) = ratio.factors().into_iter().partition(is_below);
        let (above, below) = (Expr::product(above), Expr::product(below).recip());
        let divisor = below.power(2) + if is_round { above.power(2) } else { -above.power(2) };
        Expr::integer(2) * height / steepest * above * below / divisor
    };
    Some((Crossing::At { place, is_rising: !is_positive }, conditions))
}

/// The condition π/4 < u on the parameter of which the angle u is a multiple.
fn beyond_half_of_right(angle: &Expr) -> Option<Condition> {
    let [parameter] = angle.symbols().into_iter().collect::<Vec<_>>().try_into().ok()?;
    let parameter = Expr::symbol(parameter.name());
    let factor = angle / &parameter;
    factor.symbols().is_empty().then(|| Condition::less(Expr::pi() / (Expr::integer(4) * factor), parameter))
}

/// u, of tan u.
fn angle_of_tangent(expr: &Expr) -> Option<&Expr> {
    match expr.node() {
        Node::Function(function, arguments) if function.name() == "tan" => arguments.first(),
        _ => None,
    }
}

/// The terms without r, and the functions of r with the sums of their factors.
fn separated(difference: &Expr, radius: &Symbol) -> (Expr, Vec<(Expr, Expr)>) {
    let mut parts: BTreeMap<Expr, Vec<Expr>> = BTreeMap::new();
    for term in difference.terms() {
        let (own, free): (Vec<Expr>, Vec<Expr>) = term.factors().into_iter().partition(|factor| factor.contains(radius));
        parts.entry(Expr::product(own)).or_default().push(Expr::product(free));
    }
    let constant = parts.remove(&Expr::one()).map_or_else(Expr::zero, Expr::sum);
    (constant, parts.into_iter().map(|(own, list)| (own, Expr::sum(list))).collect())
}

/// Where an increasing or a decreasing function changes its sign.
enum Solved {
    /// At the radius whose power has this value, if that is positive: r^m = value.
    Root {
        power: (Expr, Expr),
        is_rising: bool,
    },
    Never {
        is_positive: bool,
    },
}

impl Solved {
    /// That of the opposite difference.
    fn negated(self) -> Self {
        match self {
            Self::Root { power, is_rising } => Self::Root { power, is_rising: !is_rising },
            Self::Never { is_positive } => Self::Never { is_positive: !is_positive },
        }
    }
}

fn solved(difference: &Expr, radius: &Symbol, conditions: &mut Vec<Condition>) -> Option<Solved> {
    // Partial fractions separate r²/(r² + w²), but also make two terms of a root.
    [multiplied_out(difference), tidy(difference, radius)].iter().find_map(|own| {
        let mut needed = Vec::new();
        let found = solved_as_it_is(own, radius, &mut needed)?;
        conditions.append(&mut needed);
        Some(found)
    })
}

fn solved_as_it_is(difference: &Expr, radius: &Symbol, conditions: &mut Vec<Condition>) -> Option<Solved> {
    let (constant, parts) = separated(difference, radius);
    match parts.as_slice() {
        [(function, factor)] => {
            let target = tidy(&(-constant / factor), radius);
            let is_positive = sign(factor)? == Sign::Positive;
            let found = inverted(function, target, radius, conditions)?;
            Some(if is_positive { found } else { found.negated() })
        }
        [one, two] => quadratic(one, two, &constant, radius),
        _ => None,
    }
}

/// Of K(r) − `target`, for a power or a function K.
fn inverted(function: &Expr, target: Expr, radius: &Symbol, conditions: &mut Vec<Condition>) -> Option<Solved> {
    let (base, exponent) = function.split_power();
    if base.as_symbol() == Some(radius) {
        let is_rising = sign(&exponent)? == Sign::Positive;
        return is_rising.then_some(Solved::Root { power: (target, exponent), is_rising });
    }
    let (zero, one, quarter) = (Expr::zero(), Expr::one(), Expr::pi() / Expr::integer(2));
    // The argument, its value at the change, and the ends of the range of K.
    let (argument, value, [least, most]) = match base.node() {
        _ if base == Expr::euler() => (exponent.clone(), Expr::call("ln", [target.clone()]), [Some(zero), None]),
        _ if exponent.contains(radius) => return None,
        Node::Sum(_) => {
            // Whole powers of what may be negative are not monotone.
            if exponent.as_integer().is_some() && sign(&base)? == Sign::Negative {
                return None;
            }
            (base.clone(), target.pow(&exponent.recip()), [Some(zero), None])
        }
        Node::Function(outer, arguments) if exponent.is_one() => {
            let [argument] = arguments.as_slice() else { return None };
            let range = match outer.name() {
                "ln" | "asinh" | "sinh" | "atanh" => [None, None],
                "atan" | "asin" => [Some(-&quarter), Some(quarter)],
                "tanh" => [Some(-&one), Some(one)],
                "acosh" => [Some(zero), None],
                "cosh" if sign(argument)? == Sign::Positive => [Some(one), None],
                _ => return None,
            };
            let (_, value) = inverses(outer.name(), &[argument], &target).into_iter().next()?;
            (argument.clone(), value, range)
        }
        _ => return None,
    };
    for (end, is_positive) in [(least.map(|least| &target - least), true), (most.map(|most| most - &target), false)] {
        if let Some(within) = end
            && !is_above(&within, &Expr::zero(), conditions)?
        {
            return Some(Solved::Never { is_positive });
        }
    }
    let falls = matches!(base.node(), Node::Sum(_)) && sign(&exponent)? == Sign::Negative;
    let found = solved(&(argument - value), radius, conditions)?;
    Some(if falls { found.negated() } else { found })
}

/// Of b r^m + a r^(2m) + c with a and c of opposite signs.
fn quadratic(one: &(Expr, Expr), two: &(Expr, Expr), c: &Expr, radius: &Symbol) -> Option<Solved> {
    let order = |own: &(Expr, Expr)| {
        let (base, exponent) = own.0.split_power();
        (base.as_symbol() == Some(radius)).then_some(exponent)
    };
    let twice = |own: &Expr| Expr::integer(2) * own;
    let (m, n) = (order(one)?, order(two)?);
    let (m, b, a) = if twice(&m) == n {
        (m, &one.1, &two.1)
    } else if twice(&n) == m {
        (n, &two.1, &one.1)
    } else {
        return None;
    };
    let (is_rising, of_c) = (sign(a)? == Sign::Positive, sign(c)?);
    if (of_c == Sign::Negative) != is_rising || sign(&m)? != Sign::Positive {
        return None;
    }
    let [a, b, c] = if is_rising { [a.clone(), b.clone(), c.clone()] } else { [-a, -b, -c] };
    let root = root_of_square(&tidy(&(b.power(2) - Expr::integer(4) * &a * &c), radius));
    // For positive b, this form does not subtract.
    let value = if sign(&b) == Some(Sign::Positive) { -twice(&c) / (&b + root) } else { (root - &b) / twice(&a) };
    Some(Solved::Root { power: (value, m), is_rising })
}

/// Whether one value lies above another one, which becomes a condition if it depends on the parameters; `None` if it is unknown.
fn is_above(value: &Expr, bound: &Expr, conditions: &mut Vec<Condition>) -> Option<bool> {
    let difference = value - bound;
    match angles::known_sign(&difference) {
        Sign::Unknown if difference.symbols().is_empty() => None,
        // A root is positive where it is real, and the domain of the profile states where that is.
        Sign::Unknown if matches!(difference.node(), Node::Power(_, exponent) if exponent.as_integer().is_none()) => Some(true),
        Sign::Unknown => {
            let (below, above): (Vec<Expr>, Vec<Expr>) =
                cleared(&difference).into_iter().partition(|own| own.split_coefficient().0.is_negative());
            conditions.push(Condition::less(-Expr::sum(below), Expr::sum(above)));
            Some(true)
        }
        known => Some(known == Sign::Positive),
    }
}

/// The terms without positive factors that all of them have, and without denominators.
fn cleared(sum: &Expr) -> Vec<Expr> {
    let (content, rest) = symbols_in_front(sum);
    let rest = if sign(&content) == Some(Sign::Positive) { rest } else { sum.clone() };
    let divisor = |own: &Expr| own.factors().into_iter().find(|factor| sign(&factor.split_power().1) == Some(Sign::Negative));
    match rest.terms().iter().find_map(divisor).filter(|own| sign(own) == Some(Sign::Positive)) {
        Some(own) => cleared(&Expr::sum(rest.terms().iter().map(|term| term / &own))),
        None => rest.terms(),
    }
}

/// The symbols and functions that all terms of a sum have as factors, and the sum without them.
fn symbols_in_front(sum: &Expr) -> (Expr, Expr) {
    let (content, rest) = normal::common_content(&sum.terms());
    let (number, content) = content.split_coefficient();
    (content, Expr::sum(rest.iter().map(|term| term * Expr::number(number.clone()))))
}

/// The sign if it is known and not 0.
fn sign(expr: &Expr) -> Option<Sign> {
    Some(angles::known_sign(expr)).filter(|own| matches!(own, Sign::Positive | Sign::Negative))
}

fn tidy(expr: &Expr, radius: &Symbol) -> Expr {
    normal::expanded(expr, radius).unwrap_or_else(|_| expr.clone())
}
