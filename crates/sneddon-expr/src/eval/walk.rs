//! The walk over the tree: the operations for every node, and their order.

use super::{Algebra, BoundedAlgebra, EvalError, PreciseAlgebra, WideAlgebra};
use crate::expr::function::Accuracy;
use crate::expr::{Bindings, Constant, Expr, Function, Node, Number, Symbol, shown_to_30_digits};
use crate::num::{Bounded, DoubleDouble, Precise, precise};

/// Computes `expr` in the given algebra; `value_of` gives the value of a symbol.
///
/// Differences of squares are factored, (u − v)(u + v), fractions divide by their denominator, half powers are
/// roots, and products alternate between factors and divisors so that intermediate results stay in range.
///
/// # Errors
/// [`EvalError::Unbound`] for a symbol without value.
///
/// ```
/// use sneddon_expr::{eval::{walk, FloatAlgebra}, expr::Expr};
/// let f = Expr::symbol("r").power(2) / Expr::integer(4);
/// let value = walk(&f, &mut FloatAlgebra, &mut |_| Some(3.0)).unwrap();
/// assert_eq!(value, 2.25);
/// ```
pub fn walk<A: Algebra>(
    expr: &Expr,
    algebra: &mut A,
    value_of: &mut impl FnMut(&Symbol) -> Option<A::Value>,
) -> Result<A::Value, EvalError> {
    walk_with(expr, algebra, &mut |expr, _| match expr.node() {
        Node::Symbol(symbol) => value_of(symbol).map(Some).ok_or_else(|| EvalError::Unbound { name: symbol.name().to_owned() }),
        _ => Ok(None),
    })
}

/// The value of an expression without symbols, or with the given ones bound, and a bound of its error.
///
/// # Errors
/// As [`walk`].
pub fn constant_value(expr: &Expr, bindings: &Bindings) -> Result<Bounded, EvalError> {
    let bound = bindings.apply(expr);
    let own = walk(&bound, &mut BoundedAlgebra, &mut |_| None)?;
    if own.is_finite() && own.error <= own.value.abs() {
        return Ok(own);
    }
    // Intermediate results may overflow although the value is finite, as in e^1000/(1 + e^1000).
    let wide = walk(&bound, &mut WideAlgebra, &mut |_| None)?.precise().bounded();
    Ok(if wide.is_finite() && (wide.error < own.error || own.error.is_nan()) { wide } else { own })
}

/// As [`constant_value`], with 30 digits.
///
/// # Errors
/// As [`walk`].
pub fn precise_value(expr: &Expr, bindings: &Bindings) -> Result<Precise, EvalError> {
    let bound = shown_to_30_digits(&bindings.apply(expr));
    let own = walk(&bound, &mut PreciseAlgebra, &mut |_| None)?;
    if own.is_finite() && own.error <= own.value.hi.abs() {
        return Ok(own);
    }
    let wide = walk(&bound, &mut WideAlgebra, &mut |_| None)?.precise();
    Ok(if wide.is_finite() && (wide.error < own.error || own.error.is_nan()) { wide } else { own })
}

/// The smallest double that is not below the value of a constant, to within 30 digits: r ≥ b is equivalent to r ≥ this double.
///
/// # Errors
/// As [`precise_value`].
///
/// ```
/// use sneddon_expr::{eval::first_double_from, expr::{Bindings, Expr}};
/// // The double nearest to 1/3 is below it, the double nearest to 1/10 is above.
/// assert_eq!(first_double_from(&Expr::ratio(1, 3), &Bindings::default()).unwrap(), (1.0 / 3.0_f64).next_up());
/// assert_eq!(first_double_from(&Expr::ratio(1, 10), &Bindings::default()).unwrap(), 0.1);
/// ```
pub fn first_double_from(expr: &Expr, bindings: &Bindings) -> Result<f64, EvalError> {
    let Precise { value, error } = precise_value(expr, bindings)?;
    if !value.hi.is_finite() {
        return constant_value(expr, bindings).map(|own| own.value);
    }
    Ok(if value.lo > error { value.hi.next_up() } else { value.hi })
}

/// The largest double that is not above the value of a constant, to within 30 digits: x > b is equivalent to x > this double.
///
/// # Errors
/// As [`precise_value`].
///
/// ```
/// use sneddon_expr::{eval::last_double_up_to, expr::{Bindings, Expr}};
/// assert_eq!(last_double_up_to(&Expr::ratio(1, 3), &Bindings::default()).unwrap(), 1.0 / 3.0);
/// assert_eq!(last_double_up_to(&Expr::ratio(1, 10), &Bindings::default()).unwrap(), 0.1_f64.next_down());
/// ```
pub fn last_double_up_to(expr: &Expr, bindings: &Bindings) -> Result<f64, EvalError> {
    let Precise { value, error } = precise_value(expr, bindings)?;
    if !value.hi.is_finite() {
        return constant_value(expr, bindings).map(|own| own.value);
    }
    // A constant that is not known to 30 digits may be anywhere within its error.
    let is_known = error < 0.125 * f64::EPSILON * value.hi.abs() || error == 0.0;
    Ok(match is_known {
        false => (value.hi - error).next_down(),
        true if value.lo < -error => value.hi.next_down(),
        true => value.hi,
    })
}

/// The walk with a hook that may supply the value of a subtree.
pub(super) fn walk_with<A: Algebra>(
    expr: &Expr,
    algebra: &mut A,
    known: &mut impl FnMut(&Expr, &mut A) -> Result<Option<A::Value>, EvalError>,
) -> Result<A::Value, EvalError> {
    if let Some(value) = known(expr, algebra)? {
        return Ok(value);
    }
    match expr.node() {
        Node::Number(number) => Ok(constant(number, algebra)),
        Node::Constant(Constant::Pi) => Ok(algebra.constant(PI)),
        Node::Constant(Constant::Euler) => Ok(algebra.constant(E)),
        Node::Constant(Constant::Cut) => Err(EvalError::Cut),
        Node::Symbol(symbol) => Err(EvalError::Unbound { name: symbol.name().to_owned() }),
        Node::Function(function, arguments) => {
            if let Some((near_one, beside)) = logarithm_near_one(*function, arguments) {
                let beside = walk_with(&beside, algebra, known)?;
                let whole = arguments.iter().map(|a| walk_with(a, algebra, known)).collect::<Result<Vec<_>, _>>()?;
                let pair: Vec<A::Value> = std::iter::once(beside).chain(whole).collect();
                return Ok(algebra.call(near_one, &pair));
            }
            let values = arguments.iter().map(|a| walk_with(a, algebra, known)).collect::<Result<Vec<_>, _>>()?;
            if A::READS_NUMBERS && values.len() > 1 && matches!(function.row().accuracy, Accuracy::Bounded(_)) {
                let numbers: Vec<Option<DoubleDouble>> = arguments.iter().map(number).collect();
                return Ok(algebra.call_with_numbers(*function, &values, &numbers));
            }
            Ok(algebra.call(*function, &values))
        }
        Node::Sum(terms) => {
            if !algebra.keeps_powers()
                && let Some((u, v)) = difference_of_squares(terms)
            {
                let (u, v) = (walk_with(&u, algebra, known)?, walk_with(&v, algebra, known)?);
                let (difference, sum) = (algebra.subtract(u, v), algebra.add(u, v));
                return Ok(algebra.multiply(difference, sum));
            }
            let mut total = None;
            // Add the positive terms first and subtract afterwards.
            let (positive, negative): (Vec<&Expr>, Vec<&Expr>) = terms.iter().partition(|t| !t.split_coefficient().0.is_negative());
            for term in positive {
                let value = walk_with(term, algebra, known)?;
                total = Some(match total {
                    None => value,
                    Some(sum) => algebra.add(sum, value),
                });
            }
            for term in negative {
                let value = walk_with(&-term, algebra, known)?;
                let from = match total {
                    None => algebra.constant(Precise::exact(0.0)),
                    Some(sum) => sum,
                };
                total = Some(algebra.subtract(from, value));
            }
            Ok(total.unwrap_or_else(|| algebra.constant(Precise::exact(0.0))))
        }
        Node::Product(_) | Node::Power(..) => quotient(expr, algebra, known),
    }
}

/// For ln(1 + u): the function of u and 1 + u that keeps the digits of u.
fn logarithm_near_one(function: Function, arguments: &[Expr]) -> Option<(Function, Expr)> {
    let ("ln", [argument]) = (function.name(), arguments) else { return None };
    Some((Function::named("ln_near_one")?, beside_one(argument)?))
}

/// u of 1 + u.
fn beside_one(sum: &Expr) -> Option<Expr> {
    let Node::Sum(terms) = sum.node() else { return None };
    let (one, others): (Vec<&Expr>, Vec<&Expr>) = terms.iter().partition(|term| term.is_one());
    (!one.is_empty()).then(|| Expr::sum(others.into_iter().cloned()))
}

/// A number of the tree; one beyond the range of doubles is written as an operation, for algebras that reach further.
fn constant<A: Algebra>(number: &Number, algebra: &mut A) -> A::Value {
    const STEP: i64 = 900;
    if is_literal(number) {
        return algebra.constant(literal(number));
    }
    let size = number.to_f64().abs();
    let Some(step) = Number::integer(2).power(STEP) else { return algebra.constant(literal(number)) };
    let factor = algebra.constant(literal(&step));
    let small = size < 1.0;
    let Some(back) = (if small { Some(step) } else { step.reciprocal() }) else { return algebra.constant(literal(number)) };
    let inner = constant(&(number * &back), algebra);
    if small { algebra.divide(inner, factor) } else { algebra.multiply(inner, factor) }
}

const PI: Precise = Precise { value: precise::PI, error: 3.0e-33 };
const E: Precise = Precise { value: precise::E, error: 2.2e-33 };

/// A number that fits into one constant of the tape, to 30 digits.
fn number(expr: &Expr) -> Option<DoubleDouble> {
    match expr.node() {
        Node::Number(number) if is_literal(number) => Some(literal(number).value),
        Node::Constant(Constant::Pi) => Some(PI.value),
        Node::Constant(Constant::Euler) => Some(E.value),
        _ => None,
    }
}

/// Whether a number is within the range of two doubles.
fn is_literal(number: &Number) -> bool {
    number.is_zero() || (1e-270..f64::INFINITY).contains(&number.to_f64().abs())
}

/// A number of the tree as two doubles; the error is 0 where they hold it exactly.
fn literal(number: &Number) -> Precise {
    let hi = number.to_f64();
    let Some(head) = Number::from_f64(hi) else {
        return Precise { value: hi.into(), error: f64::INFINITY };
    };
    let rest = number - &head;
    if rest.is_zero() {
        return Precise::exact(hi);
    }
    let lo = rest.to_f64();
    let error = if rest.is_exact_f64() { 0.0 } else { lo.abs() * f64::EPSILON + f64::from_bits(1) };
    Precise { value: DoubleDouble { hi, lo }, error }
}

/// Products and powers: factors and divisors by turns.
fn quotient<A: Algebra>(
    expr: &Expr,
    algebra: &mut A,
    known: &mut impl FnMut(&Expr, &mut A) -> Result<Option<A::Value>, EvalError>,
) -> Result<A::Value, EvalError> {
    let (mut factors, mut divisors) = (Vec::new(), Vec::new());
    for factor in expr.factors() {
        match factor.node() {
            Node::Number(number) => split_number(number, algebra, &mut factors, &mut divisors),
            Node::Power(base, exponent) => match exponent.as_number() {
                Some(power) if power.is_negative() => raise(base, &-power, algebra, known, &mut divisors)?,
                Some(power) => raise(base, power, algebra, known, &mut factors)?,
                None => {
                    let (base, exponent) = (walk_with(base, algebra, known)?, walk_with(exponent, algebra, known)?);
                    factors.push(algebra.power(base, exponent));
                }
            },
            _ => factors.push(walk_with(&factor, algebra, known)?),
        }
    }
    let mut factors = factors.into_iter();
    let mut result = match factors.next() {
        Some(first) => first,
        None => algebra.constant(Precise::exact(1.0)),
    };
    let mut divisors = divisors.into_iter();
    loop {
        let (divisor, factor) = (divisors.next(), factors.next());
        if divisor.is_none() && factor.is_none() {
            return Ok(result);
        }
        if let Some(divisor) = divisor {
            result = algebra.divide(result, divisor);
        }
        if let Some(factor) = factor {
            result = algebra.multiply(result, factor);
        }
    }
}

/// A rational factor as numerator and denominator where `f64` holds both, which saves a rounding.
fn split_number<A: Algebra>(number: &Number, algebra: &mut A, factors: &mut Vec<A::Value>, divisors: &mut Vec<A::Value>) {
    let numerator = Number::from(num_rational::BigRational::from_integer(number.value().numer().clone()));
    let denominator = Number::from(num_rational::BigRational::from_integer(number.value().denom().clone()));
    if number.is_exact_f64() || !(numerator.is_exact_f64() && denominator.is_exact_f64()) {
        factors.push(constant(number, algebra));
        return;
    }
    if !numerator.is_one() {
        factors.push(constant(&numerator, algebra));
    }
    divisors.push(constant(&denominator, algebra));
}

/// Larger powers would amplify the rounding error of 1 + u by at least this factor.
const LARGE: i64 = 32;

/// Pushes the factors that make base^power, `power` > 0.
fn raise<A: Algebra>(
    base: &Expr,
    power: &Number,
    algebra: &mut A,
    known: &mut impl FnMut(&Expr, &mut A) -> Result<Option<A::Value>, EvalError>,
    into: &mut Vec<A::Value>,
) -> Result<(), EvalError> {
    if *power > Number::integer(LARGE)
        && let (Some(beside), Some(near_one)) = (beside_one(base), Function::named("power_near_one"))
    {
        let (beside, exponent) = (walk_with(&beside, algebra, known)?, algebra.constant(literal(power)));
        into.push(algebra.call_with_numbers(near_one, &[beside, exponent], &[None, Some(literal(power).value)]));
        return Ok(());
    }
    let value = walk_with(base, algebra, known)?;
    let half = Number::ratio(1, 2);
    match (power.to_i64(), (power - &half).to_i64()) {
        (Some(n @ 1..=3), _) if n == 1 || !algebra.keeps_powers() => into.extend(std::iter::repeat_n(value, n.unsigned_abs() as usize)),
        (None, Some(n @ 0..=3)) => {
            into.extend(std::iter::repeat_n(value, n.unsigned_abs() as usize));
            into.push(algebra.square_root(value));
        }
        _ => {
            // The rounding error of the exponent would be amplified by ln(base).
            let nearest = power.to_f64();
            let rest = Number::from_f64(nearest).map(|nearest| power - &nearest).filter(|rest| !rest.is_zero());
            into.push(match rest {
                Some(rest) => algebra.real_power(value, nearest, literal(&rest)),
                None => {
                    let exponent = algebra.constant(Precise::exact(nearest));
                    algebra.power(value, exponent)
                }
            });
        }
    }
    Ok(())
}

/// u and v where the sum is u² − v² with monomials u and v.
fn difference_of_squares(terms: &[Expr]) -> Option<(Expr, Expr)> {
    let [first, second] = terms else { return None };
    let (plus, minus) = match (first.split_coefficient().0.is_negative(), second.split_coefficient().0.is_negative()) {
        (false, true) => (first.clone(), -second),
        (true, false) => (second.clone(), -first),
        _ => return None,
    };
    Some((monomial_root(&plus)?, monomial_root(&minus)?))
}

/// The exact square root of a number times even powers of symbols and functions.
fn monomial_root(expr: &Expr) -> Option<Expr> {
    let factors = expr.factors();
    let roots = factors.iter().map(|factor| match factor.node() {
        Node::Number(number) => number.root(2).map(Expr::number),
        Node::Power(base, exponent) if matches!(base.node(), Node::Symbol(_) | Node::Function(..)) => {
            let n = exponent.as_integer()?;
            (n % 2 == 0).then(|| base.power(n / 2))
        }
        _ => None,
    });
    Some(Expr::product(roots.collect::<Option<Vec<_>>>()?))
}
