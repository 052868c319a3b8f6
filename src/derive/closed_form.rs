//! Evaluation of closed expressions: in double precision if that is accurate, else with 30 digits, rounded once.

use crate::derive::rule::Pair;
use crate::eval::{BoundedAlgebra, EvalError, IntervalAlgebra, PreciseAlgebra, Tape, WideAlgebra};
use crate::expr::{Expr, Symbol, has_30_digits, shown_to_30_digits};
use crate::num::{Bounded, Estimate, Precise, Region, Wide, work};
use std::sync::OnceLock;

/// A relative bound of this size counts as full accuracy: four units in the last place of a double.
const GOOD: f64 = 4.0 * f64::EPSILON;
/// The key of values in double precision.
pub(crate) const DOUBLES: &str = "doubles";
/// The key of values with 30 digits.
pub(crate) const THIRTY_DIGITS: &str = "thirty-digits";
/// The key of values with 30 digits and an exponent that neither overflows nor underflows.
pub(crate) const WIDE_EXPONENT: &str = "wide-exponent";
/// Smaller tolerances request the full accuracy of the form.
const EVERY_DIGIT: f64 = 1e-13;

/// The relative bound at which a double-precision result is used: the tolerance, or four ulps for tolerances of 1e-13 or less.
pub(crate) fn good_enough(tolerance: f64) -> f64 {
    if tolerance > EVERY_DIGIT { tolerance } else { GOOD }
}

/// An expression over a few inputs, compiled for many points.
///
/// Measured where the bound is at most 8 ulp, over the random expressions of `tests/oracle/second.csv`: mean error 0.26 ulp,
/// largest 2.8 ulp; over the cancelling profiles of `tests/oracle/cancelling.csv`: mean 0.32 ulp, largest 7.6 ulp.
///
/// ```
/// use sneddon::{expr::{Expr, Symbol}, transform::ClosedForm};
/// let x = Expr::symbol("x");
/// let f = (Expr::one() + &x).sqrt() - Expr::one() - x / Expr::integer(2);
/// let form = ClosedForm::new(&f, &[Symbol::new("x")]).unwrap();
/// // −x²/8 + x³/16 − …, of which double precision alone keeps six digits.
/// let value = form.value(&[1e-5]);
/// assert!(value.error < 1e-15 * value.value.abs() && (value.value / -1.249_993_750_039_062_5e-11 - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Debug)]
pub struct ClosedForm {
    tape: Tape,
    /// The expression of the second pass, before functions are replaced by equivalent expressions.
    second: Expr,
    inputs: Vec<Symbol>,
    precise: OnceLock<Option<Tape>>,
}

impl ClosedForm {
    /// Compiles an expression whose only symbols are the inputs.
    ///
    /// # Errors
    /// [`EvalError::Unbound`] for any other symbol.
    pub fn new(expr: &Expr, inputs: &[Symbol]) -> Result<Self, EvalError> {
        Self::with_second(expr, expr.clone(), inputs)
    }

    /// Compiles an expression with a separate, mathematically equal expression for the second pass.
    pub(crate) fn with_second(expr: &Expr, second: Expr, inputs: &[Symbol]) -> Result<Self, EvalError> {
        let tape = Tape::compile(std::slice::from_ref(expr), inputs)?;
        Ok(Self { tape, second, inputs: inputs.to_vec(), precise: OnceLock::new() })
    }

    /// The value at exact inputs, with a bound of its error; NaN if the number of inputs is wrong.
    pub fn value(&self, inputs: &[f64]) -> Bounded {
        total(&[self], inputs, GOOD).bounded()
    }

    /// An enclosure of the values while the only input runs between two numbers; `None` if unknown.
    ///
    /// ```
    /// use sneddon::{expr::{Expr, Symbol}, transform::ClosedForm};
    /// let r = Symbol::new("r");
    /// let form = ClosedForm::new(&(Expr::symbol("r").power(2) - Expr::one()), &[r]).unwrap();
    /// let (low, high) = form.over(0.5, 2.0).unwrap();
    /// // The values lie in [−0.75, 3]; the enclosure of (r − 1)(r + 1), by which r² − 1 is evaluated, is wider below.
    /// assert!((-1.6..=-0.75).contains(&low) && (3.0..3.1).contains(&high));
    /// ```
    pub fn over(&self, lower: f64, upper: f64) -> Option<(f64, f64)> {
        self.tape.run(&mut IntervalAlgebra, &[Region::interval(lower, upper)], &mut Vec::new())?.real_range()
    }

    /// In double precision.
    pub(crate) fn in_doubles(&self, inputs: &[Bounded], slots: &mut Vec<Bounded>) -> Bounded {
        self.tape.run(&mut BoundedAlgebra, inputs, slots).unwrap_or(Bounded::exact(f64::NAN))
    }

    /// The tape in double precision.
    pub(crate) fn tape(&self) -> &Tape {
        &self.tape
    }

    /// The tape of the second and third pass, compiled when it is first needed.
    fn precise_tape(&self) -> Option<&Tape> {
        let compile = || Tape::compile(&[shown_to_30_digits(&self.second)], &self.inputs).ok();
        self.precise.get_or_init(|| work::unbroken(compile)).as_ref()
    }

    /// With 30 digits.
    fn in_30_digits(&self, inputs: &[Precise], slots: &mut Vec<Precise>) -> Precise {
        self.precise_tape().and_then(|tape| tape.run(&mut PreciseAlgebra, inputs, slots)).unwrap_or(Precise::nan())
    }

    /// With 30 digits and without intermediate overflow or underflow.
    fn in_wide(&self, inputs: &[Wide], slots: &mut Vec<Wide>) -> Wide {
        self.precise_tape().and_then(|tape| tape.run(&mut WideAlgebra, inputs, slots)).unwrap_or(Wide::nan())
    }
}

/// The sum of closed forms at exact inputs; see [`refined`].
pub(crate) fn total(forms: &[&ClosedForm], inputs: &[f64], good: f64) -> Estimate {
    let sum = in_doubles(forms, inputs);
    refined(sum, sum.value, good, || precise_total(forms, inputs))
}

/// The sum in double precision.
pub(crate) fn in_doubles(forms: &[&ClosedForm], inputs: &[f64]) -> Bounded {
    let exact: Vec<Bounded> = inputs.iter().copied().map(Bounded::exact).collect();
    let mut slots = Vec::new();
    forms.iter().fold(Bounded::exact(0.0), |sum, form| sum + form.in_doubles(&exact, &mut slots))
}

/// The sum with 30 digits, which remains accurate under cancellation between the forms.
pub(crate) fn in_30_digits(forms: &[&ClosedForm], inputs: &[f64]) -> Precise {
    let exact: Vec<Precise> = inputs.iter().copied().map(Precise::exact).collect();
    let mut slots = Vec::new();
    forms.iter().fold(Precise::exact(0.0), |sum, form| sum.add(form.in_30_digits(&exact, &mut slots)))
}

/// The sum with 30 digits and without intermediate overflow or underflow; infinite if it exceeds the range of doubles.
pub(crate) fn in_wide(forms: &[&ClosedForm], inputs: &[f64]) -> Precise {
    let exact: Vec<Wide> = inputs.iter().copied().map(|own| Wide::new(Precise::exact(own))).collect();
    let mut slots = Vec::new();
    forms.iter().fold(Wide::new(Precise::exact(0.0)), |sum, form| sum.add(form.in_wide(&exact, &mut slots))).precise()
}

/// The more accurate of two values, and its key.
pub(crate) fn precise_total(forms: &[&ClosedForm], inputs: &[f64]) -> (Precise, &'static str) {
    let second = in_30_digits(forms, inputs);
    if second.is_finite() && second.error <= GOOD * second.value.hi.abs() {
        return (second, THIRTY_DIGITS);
    }
    let third = in_wide(forms, inputs);
    let better = third.value.hi.is_infinite() || second.error.is_nan() || third.error < second.error;
    if better && !third.value.hi.is_nan() { (third, WIDE_EXPONENT) } else { (second, THIRTY_DIGITS) }
}

/// The first value if its bound is small relative to the whole of which it is a part, else the more accurate of both.
pub(crate) fn refined(first: Bounded, whole: f64, good: f64, second: impl FnOnce() -> (Precise, &'static str)) -> Estimate {
    let in_doubles = Estimate::from_bounded(first, 0).by(DOUBLES);
    if first.value.is_finite() && first.error <= good * whole.abs() {
        return in_doubles;
    }
    let (second, way) = second();
    let second = rounded(second);
    let better = first.error.is_nan() || second.error < first.error;
    if second.is_finite() && better { Estimate::from_bounded(second, 0).by(way) } else { in_doubles }
}

/// Rounds to a double; the bound includes the rounding error.
pub(crate) fn rounded(exact: Precise) -> Bounded {
    let mut own = exact.bounded();
    if exact.value.lo != 0.0 {
        // The bound covers at least the rounding error.
        own.error = own.error.max(Bounded::rounded(own.value).error);
    }
    own
}

/// The expression of an answer for the second pass: the shown form if the evaluated form has functions without 30-digit values.
pub(crate) fn for_second_pass(pair: &Pair) -> &Expr {
    if has_30_digits(&shown_to_30_digits(&pair.evaluated)) { &pair.evaluated } else { &pair.shown }
}
