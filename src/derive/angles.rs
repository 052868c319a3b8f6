//! Slope angles: constants such as tan θ, whose angles lie between 0 and π/2.
//!
//! The flank of a cone has an acute slope angle, so that its sine, cosine and tangent are positive.
//! Results proven under that assumption carry the condition that the angle is acute.

use crate::derive::domain::acute_sign::same_sign;
use crate::derive::domain::identity::vanishes_identically;
use crate::derive::domain::numeric_sign::numeric_sign;
use crate::eval::constant_value;
use crate::expr::{Bindings, Condition, Expr, Node, Number, Sign, Symbol, normal, rewritten};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

/// The largest multiple of an angle that is expanded.
const LARGEST_MULTIPLE: i64 = 12;

/// Expressions in which every sine, cosine and tangent of a constant angle is a positive symbol.
pub(crate) struct Positive {
    values: Vec<(Expr, Symbol)>,
}

impl Positive {
    /// Collects the constants of the expression.
    pub(crate) fn of(expr: &Expr) -> Self {
        let mut calls = Vec::new();
        collect(expr, &mut calls);
        let values = calls.into_iter().enumerate().map(|(place, call)| (call, Symbol::new(&format!("angle·{place}")))).collect();
        Self { values }
    }

    /// The expression with symbols for these constants.
    pub(crate) fn replaced(&self, expr: &Expr) -> Expr {
        map_calls(expr, &|call| self.values.iter().find(|(known, _)| known == call).map(|(_, symbol)| Expr::from(symbol.clone())))
    }

    /// The expression with the constants for their symbols.
    pub(crate) fn restored(&self, expr: &Expr) -> Expr {
        self.values.iter().map(|(call, symbol)| (symbol.name(), call.clone())).collect::<Bindings>().apply(expr)
    }
}

/// The sign of an expression, assuming acute slope angles.
pub(crate) fn sign(expr: &Expr) -> Sign {
    let known = crate::expr::sign(expr);
    if known != Sign::Unknown || !has_angle(expr) {
        return known;
    }
    crate::expr::sign(&Positive::of(expr).replaced(expr))
}

/// True if the expression is proven to be zero for acute slope angles; false proves nothing.
pub(crate) fn is_proven_zero(expr: &Expr, variable: &Symbol) -> bool {
    normal::is_proven_zero(expr, variable)
        || (has_angle(expr) && algebraic(expr).is_some_and(|algebraic| normal::is_proven_zero(&algebraic, variable)))
}

/// True if the expression vanishes by identities, for all angles, as tan θ − sin θ/cos θ; false proves nothing.
///
/// sin θ − √(1 − cos² θ) is zero only for acute angles, and does not vanish here.
pub(crate) fn cancels(expr: &Expr) -> bool {
    vanishes_identically(&over_units(expr, &half_angle).unwrap_or_else(|| expr.clone()))
}

/// True if the quotient of the two is a product of sines and cosines of acute angles, so that the first is smaller.
pub(crate) fn is_proven_below(lower: &Expr, upper: &Expr) -> bool {
    let quotient = lower / upper;
    let below_one = |factor: &Expr| {
        let (base, exponent) = factor.split_power();
        match base.node() {
            Node::Number(number) => exponent.is_one() && number.is_positive() && number.value() <= &BigRational::from_integer(1.into()),
            Node::Function(function, _) => {
                matches!(function.name(), "sin" | "cos") && is_angle(&base) && crate::expr::sign(&exponent) == Sign::Positive
            }
            _ => false,
        }
    };
    has_angle(&quotient) && quotient.factors().iter().all(below_one)
}

/// The conditions 0 < u < π/2 for every symbolic slope angle u of the expressions, of which the largest multiple implies the others.
pub(crate) fn conditions<'a>(exprs: impl Iterator<Item = &'a Expr>) -> Vec<Condition> {
    let mut calls = Vec::new();
    exprs.for_each(|expr| collect(expr, &mut calls));
    let mut largest: Vec<(Expr, Number)> = Vec::new();
    for angle in calls.iter().filter_map(argument).filter(|angle| !angle.symbols().is_empty()) {
        let (number, rest) = angle.split_coefficient();
        let (number, rest) = if number.is_positive() { (number, rest) } else { (Number::integer(1), angle) };
        match largest.iter_mut().find(|(known, _)| *known == rest) {
            Some((_, known)) => *known = number.max(known.clone()),
            None => largest.push((rest, number)),
        }
    }
    let acute = |(angle, number): (Expr, Number)| {
        // Degrees are multiples of π.
        let per_unit = if angle.factors().contains(&Expr::pi()) { Expr::pi() } else { Expr::one() };
        let angle = angle / &per_unit;
        let end = Expr::pi() / (Expr::integer(2) * Expr::number(number) * per_unit);
        [Condition::less(Expr::zero(), angle.clone()), Condition::less(angle, end)]
    };
    largest.into_iter().flat_map(acute).collect()
}

/// The upper limit of a parameter that is a slope angle or occurs in a slope angle.
pub(crate) fn largest(expr: &Expr, parameter: &Symbol) -> Option<f64> {
    let mut calls = Vec::new();
    collect(expr, &mut calls);
    let multiples = calls.iter().filter_map(argument).filter_map(|angle| {
        let (number, rest) = angle.split_coefficient();
        // Degrees are multiples of π.
        let factor = if rest.factors().iter().any(|factor| *factor == Expr::pi()) { std::f64::consts::PI } else { 1.0 };
        (rest.contains(parameter) && number.is_positive()).then(|| number.to_f64() * factor)
    });
    multiples.reduce(f64::max).map(|multiple| std::f64::consts::FRAC_PI_2 / multiple)
}

/// True if the expression has the sine, cosine or tangent of a slope angle.
pub(crate) fn has_angle(expr: &Expr) -> bool {
    expr.parts().any(is_angle)
}

/// True for the sine, cosine or tangent of an angle that is constant and may be acute.
fn is_angle(expr: &Expr) -> bool {
    let Some(angle) = argument(expr) else { return false };
    if angle.contains(&Symbol::new("r")) {
        return false;
    }
    if !angle.symbols().is_empty() {
        return true;
    }
    let value = constant_value(&angle, &Bindings::default());
    value.is_ok_and(|value| value.value - value.error > 0.0 && value.value + value.error < std::f64::consts::FRAC_PI_2)
}

/// The argument of a sine, cosine or tangent.
fn argument(expr: &Expr) -> Option<Expr> {
    match expr.node() {
        Node::Function(function, arguments) if matches!(function.name(), "sin" | "cos" | "tan") => arguments.first().cloned(),
        _ => None,
    }
}

fn collect(expr: &Expr, calls: &mut Vec<Expr>) {
    if is_angle(expr) {
        if !calls.contains(expr) {
            calls.push(expr.clone());
        }
    } else {
        expr.children().into_iter().for_each(|child| collect(child, calls));
    }
}

/// Replaces such constants by the result of `form`.
fn map_calls(expr: &Expr, form: &dyn Fn(&Expr) -> Option<Expr>) -> Expr {
    rewritten(expr, &|own, _| is_angle(own).then(|| form(own).unwrap_or_else(|| own.clone())))
}

/// The expression over the cosines of the smallest angles in it: sin θ = √(1 − c²), cos 2θ = 2c² − 1.
fn algebraic(expr: &Expr) -> Option<Expr> {
    // Sums under roots are collected, so that R² − R²(1 − c²) is (Rc)².
    Some(expanded_under_roots(&over_units(expr, &acute)?))
}

/// Cosine and sine of an acute angle, over the cosine.
fn acute(place: usize) -> (Expr, Expr) {
    let cosine = Expr::from(Symbol::new(&format!("cosine·{place}")));
    let sine = (Expr::one() - cosine.power(2)).sqrt();
    (cosine, sine)
}

/// Cosine and sine of any angle, over the tangent of its half.
fn half_angle(place: usize) -> (Expr, Expr) {
    let tangent = Expr::from(Symbol::new(&format!("tangent·{place}")));
    let square = tangent.power(2);
    ((Expr::one() - &square) / (Expr::one() + &square), Expr::integer(2) * tangent / (Expr::one() + &square))
}

/// The expression with its sines, cosines and tangents over the cosine and the sine of each smallest angle in it.
fn over_units(expr: &Expr, unit: &dyn Fn(usize) -> (Expr, Expr)) -> Option<Expr> {
    let mut calls = Vec::new();
    collect(expr, &mut calls);
    let units = AngleUnits::of(&calls.iter().filter_map(argument).collect::<Vec<_>>());
    let mut values = Vec::with_capacity(calls.len());
    for call in &calls {
        let Node::Function(function, arguments) = call.node() else { return None };
        let (cosine, sine) = units.rotation(arguments.first()?, unit)?;
        let value = match function.name() {
            "sin" => sine,
            "cos" => cosine,
            _ => sine / cosine,
        };
        values.push((call, value));
    }
    Some(map_calls(expr, &|call| values.iter().find(|(known, _)| *known == call).map(|(_, value)| value.clone())))
}

/// The expression with cos u for √(1 − sin² u) and sin u for √(1 − cos² u), assuming acute slope angles u.
///
/// Rules take roots of differences of limits: √(R² − b²) with b = R sin θ is R cos θ, which does not cancel.
pub(crate) fn without_roots(expr: &Expr) -> Expr {
    rewritten(expr, &|own, _| {
        let Node::Power(base, exponent) = own.node() else { return None };
        let (factor, function) = squared_complement(base)?;
        Some(factor.pow(exponent) * function.pow(&(Expr::integer(2) * exponent)))
    })
}

/// The factor c and the cosine of c − c sin² u, or the sine of c − c cos² u.
fn squared_complement(sum: &Expr) -> Option<(Expr, Expr)> {
    let Node::Sum(terms) = sum.node() else { return None };
    let [one, other] = terms.as_slice() else { return None };
    let complement = |part: &Expr| {
        let (base, exponent) = part.split_power();
        let Node::Function(function, arguments) = base.node() else { return None };
        let name = match function.name() {
            "sin" => "cos",
            "cos" => "sin",
            _ => return None,
        };
        (exponent == Expr::integer(2) && is_angle(&base)).then(|| Expr::call(name, arguments.clone()))
    };
    [(one, other), (other, one)].into_iter().find_map(|(whole, part)| Some((whole.clone(), complement(&-(part / whole))?)))
}

fn expanded_under_roots(expr: &Expr) -> Expr {
    rewritten(expr, &|own, again| {
        let Node::Power(base, exponent) = own.node() else { return None };
        let base = again(base);
        Some(normal::expanded(&base, &Symbol::new("r")).unwrap_or(base).pow(exponent))
    })
}

/// For every base of an angle, such as θ, the largest number of which all its factors are integer multiples.
struct AngleUnits(Vec<(Expr, BigRational)>);

impl AngleUnits {
    fn of(angles: &[Expr]) -> Self {
        let mut units: Vec<(Expr, BigRational)> = Vec::new();
        for term in angles.iter().flat_map(Expr::terms) {
            let (number, base) = term.split_coefficient();
            let number = number.value().abs();
            match units.iter_mut().find(|(known, _)| *known == base) {
                Some((_, unit)) => *unit = common(unit, &number),
                None => units.push((base, number)),
            }
        }
        Self(units)
    }

    /// Cosine and sine of an angle, over those of the units.
    fn rotation(&self, angle: &Expr, of_unit: &dyn Fn(usize) -> (Expr, Expr)) -> Option<(Expr, Expr)> {
        let mut turned = (Expr::one(), Expr::zero());
        for term in angle.terms() {
            let (number, base) = term.split_coefficient();
            let place = self.0.iter().position(|(known, _)| *known == base)?;
            let (_, unit) = self.0.get(place)?;
            let quarters = number.value() * BigRational::from_integer(2.into());
            let (count, one) = if base == Expr::pi() && quarters.is_integer() {
                (quarters.to_integer(), (Expr::zero(), Expr::one()))
            } else {
                ((number.value() / unit).to_integer(), of_unit(place))
            };
            let count = count.to_i64().filter(|count| count.abs() <= LARGEST_MULTIPLE)?;
            let one = if count < 0 { (one.0, -one.1) } else { one };
            for _ in 0..count.unsigned_abs() {
                turned = product(&turned, &one);
            }
        }
        Some(turned)
    }
}

/// Cosine and sine of the sum of two angles.
fn product((cosine, sine): &(Expr, Expr), (other_cosine, other_sine): &(Expr, Expr)) -> (Expr, Expr) {
    (cosine * other_cosine - sine * other_sine, sine * other_cosine + cosine * other_sine)
}

/// The largest number of which both are integer multiples.
fn common(one: &BigRational, other: &BigRational) -> BigRational {
    if one.is_zero() || other.is_zero() {
        return one + other;
    }
    let denominator: BigInt = one.denom().lcm(other.denom());
    let whole = |number: &BigRational| number.numer() * (&denominator / number.denom());
    BigRational::new(whole(one).gcd(&whole(other)), denominator)
}

/// The sign of a number, or of an expression with acute slope angles.
pub(crate) fn known_sign(expr: &Expr) -> Sign {
    match sign(expr) {
        Sign::Unknown => match numeric_sign(expr).or_else(|| acute_sign(expr)) {
            Some(own) if own > 0.0 => Sign::Positive,
            Some(_) => Sign::Negative,
            None => Sign::Unknown,
        },
        known => known,
    }
}

/// 1 or −1 if an expression in one slope angle has this sign for every acute angle.
fn acute_sign(expr: &Expr) -> Option<f64> {
    if !has_angle(expr) {
        return None;
    }
    let [angle] = expr.symbols().into_iter().collect::<Vec<_>>().try_into().ok()?;
    same_sign(expr, &angle, largest(expr, &angle)?)
}
