//! The kinds of value that an expression can be walked with.

use super::cost::Cost;
use crate::expr::function::Accuracy;
use crate::expr::{Function, Row};
use crate::num::{Bounded, DoubleDouble, Precise, Region, real_power};
use num_complex::Complex64;
use std::cell::RefCell;
use std::sync::OnceLock;

/// Arithmetic over one kind of value; values outside a domain become NaN, which callers turn into errors.
pub trait Algebra {
    /// The values.
    type Value: Copy;
    /// What one operation costs.
    const COST: Cost = Cost::new(4, 4, 4);
    /// Whether a tape checks for a stop, as in [`work::stoppable`](crate::num::work::stoppable), before every operation.
    /// A stopped run returns `None`.
    const STOPS: bool = false;
    /// Whether only a tape with special functions does.
    const STOPS_SPECIAL: bool = false;
    /// A number of the tree to 30 digits.
    fn constant(&mut self, number: Precise) -> Self::Value;
    /// a + b.
    fn add(&mut self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// a − b.
    fn subtract(&mut self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// a·b.
    fn multiply(&mut self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// a/b.
    fn divide(&mut self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// √a.
    fn square_root(&mut self, a: Self::Value) -> Self::Value;
    /// a^b.
    fn power(&mut self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// a^(nearest + rest), where the rest is what a double leaves of the exponent.
    fn real_power(&mut self, a: Self::Value, nearest: f64, rest: Precise) -> Self::Value {
        let (nearest, rest) = (self.constant(Precise::exact(nearest)), self.constant(rest));
        let (power, correction) = (self.power(a, nearest), self.power(a, rest));
        self.multiply(power, correction)
    }
    /// Whether a power is one operation, even a square: an enclosure of z·z is wider than one of z².
    fn keeps_powers(&self) -> bool {
        false
    }
    /// A function of the table.
    fn call(&mut self, function: Function, arguments: &[Self::Value]) -> Self::Value;
    /// Whether [`Self::call_with_numbers`] makes a difference.
    const READS_NUMBERS: bool = false;
    /// The same where the numbers among the arguments are known to 30 digits; the others are `None`.
    fn call_with_numbers(&mut self, function: Function, arguments: &[Self::Value], _numbers: &[Option<DoubleDouble>]) -> Self::Value {
        self.call(function, arguments)
    }
    /// Where a tape keeps the values of this algebra that do not depend on its inputs.
    fn kept(_tape: &Kept) -> Option<&KeptValues<Self::Value>> {
        None
    }
}

/// Per operation the value, where it does not depend on the inputs.
pub type KeptValues<V> = OnceLock<Vec<Option<V>>>;

/// The constants of a tape, which are computed once: a constant such as κ(3/2) takes as long as the rest of a run.
#[derive(Clone, Debug, Default)]
pub struct Kept {
    pub(super) bounded: KeptValues<Bounded>,
    pub(super) precise: KeptValues<Precise>,
    /// How many operations of each kind the tape has.
    pub(super) counts: Cost,
}

/// Plain `f64` values.
#[derive(Clone, Copy, Debug, Default)]
pub struct FloatAlgebra;

impl Algebra for FloatAlgebra {
    type Value = f64;
    const COST: Cost = Cost::new(3, 28, 100);
    fn constant(&mut self, number: Precise) -> f64 {
        number.value.hi
    }
    fn add(&mut self, a: f64, b: f64) -> f64 {
        a + b
    }
    fn subtract(&mut self, a: f64, b: f64) -> f64 {
        a - b
    }
    fn multiply(&mut self, a: f64, b: f64) -> f64 {
        a * b
    }
    fn divide(&mut self, a: f64, b: f64) -> f64 {
        a / b
    }
    fn square_root(&mut self, a: f64) -> f64 {
        a.sqrt()
    }
    fn power(&mut self, a: f64, b: f64) -> f64 {
        a.powf(b)
    }
    fn real_power(&mut self, a: f64, nearest: f64, rest: Precise) -> f64 {
        real_power(a, nearest, rest.value.hi)
    }
    fn call(&mut self, function: Function, arguments: &[f64]) -> f64 {
        (function.row().value)(arguments)
    }
}

/// Values with a running bound of their error.
#[derive(Clone, Copy, Debug, Default)]
pub struct BoundedAlgebra;

impl Algebra for BoundedAlgebra {
    type Value = Bounded;
    const COST: Cost = Cost::new(6, 26, 180);
    const STOPS_SPECIAL: bool = true;
    const READS_NUMBERS: bool = true;
    fn kept(tape: &Kept) -> Option<&KeptValues<Bounded>> {
        Some(&tape.bounded)
    }
    fn constant(&mut self, number: Precise) -> Bounded {
        let exact = number.error == 0.0 && number.value.lo == 0.0;
        if exact { Bounded::exact(number.value.hi) } else { Bounded::rounded(number.value.hi) }
    }
    fn add(&mut self, a: Bounded, b: Bounded) -> Bounded {
        a + b
    }
    fn subtract(&mut self, a: Bounded, b: Bounded) -> Bounded {
        a - b
    }
    fn multiply(&mut self, a: Bounded, b: Bounded) -> Bounded {
        a * b
    }
    fn divide(&mut self, a: Bounded, b: Bounded) -> Bounded {
        a / b
    }
    fn square_root(&mut self, a: Bounded) -> Bounded {
        a.sqrt()
    }
    fn power(&mut self, a: Bounded, b: Bounded) -> Bounded {
        a.powf(b)
    }
    fn real_power(&mut self, a: Bounded, nearest: f64, rest: Precise) -> Bounded {
        let rest = self.constant(rest);
        a.real_power(nearest, rest)
    }
    fn call(&mut self, function: Function, arguments: &[Bounded]) -> Bounded {
        let row = function.row();
        match arguments {
            [argument] => argument.apply(|z| (row.value)(&[z]), row.ulps()),
            _ => by_spread(row, arguments).unwrap_or_else(|| Bounded::apply_many(row.value, arguments, row.ulps())),
        }
    }
    fn call_with_numbers(&mut self, function: Function, arguments: &[Bounded], numbers: &[Option<DoubleDouble>]) -> Bounded {
        of_one(function.row(), arguments, numbers).unwrap_or_else(|| self.call(function, arguments))
    }
}

/// The value where all arguments but one are numbers and some of these were rounded: one evaluation with their 30 digits tells
/// what that rounding does, and each of them need not be moved by itself. `None` if the value is not one of 30 digits itself.
fn of_one(row: &Row, arguments: &[Bounded], numbers: &[Option<DoubleDouble>]) -> Option<Bounded> {
    let Accuracy::Bounded(ulps) = row.accuracy else { return None };
    let precise = row.precise?;
    let open = numbers.iter().position(Option::is_none)?;
    let is_rounded = arguments.iter().zip(numbers).any(|(own, number)| number.is_some() && own.error != 0.0);
    if !is_rounded || numbers.iter().skip(open + 1).any(Option::is_none) {
        return None;
    }
    let value = (row.value)(&arguments.iter().map(|own| own.value).collect::<Vec<_>>());
    if !value.is_finite() {
        return Some(Bounded::checked(f64::NAN, f64::NAN));
    }
    let point = RefCell::new(numbers.iter().map(|number| number.unwrap_or(0.0.into())).collect::<Vec<_>>());
    let exact = |z: f64| {
        let mut point = point.borrow_mut();
        if let Some(place) = point.get_mut(open) {
            *place = z.into();
        }
        let found = precise(&point);
        let nearest = found.value.value();
        // Half a unit is for rounding; the margin covers the errors of the 30-digit numbers.
        if found.error <= 0.9 * (ulps - 0.5) * f64::EPSILON * nearest.abs() { nearest } else { f64::NAN }
    };
    let found = arguments.get(open)?.apply(exact, ulps);
    // Next to a zero the row may have a better way than 30 digits.
    let error = (found.error + (found.value - value).abs()) * (1.0 + 4.0 * f64::EPSILON);
    found.is_finite().then(|| Bounded::checked(value, error))
}

/// Bounds as those of [`BoundedAlgebra`] in which every operation is charged half a unit, whether it rounds at this point or not:
/// near by they hold as well.
#[derive(Clone, Copy, Debug, Default)]
pub struct RoundingAlgebra;

impl RoundingAlgebra {
    fn charged(own: Bounded) -> Bounded {
        Bounded { error: own.error + 0.5 * f64::EPSILON * own.value.abs(), ..own }
    }
}

impl Algebra for RoundingAlgebra {
    type Value = Bounded;
    const COST: Cost = Cost::new(2, 16, 30);
    fn constant(&mut self, number: Precise) -> Bounded {
        BoundedAlgebra.constant(number)
    }
    fn add(&mut self, a: Bounded, b: Bounded) -> Bounded {
        Self::charged(a + b)
    }
    fn subtract(&mut self, a: Bounded, b: Bounded) -> Bounded {
        Self::charged(a - b)
    }
    fn multiply(&mut self, a: Bounded, b: Bounded) -> Bounded {
        Self::charged(a * b)
    }
    fn divide(&mut self, a: Bounded, b: Bounded) -> Bounded {
        Self::charged(a / b)
    }
    fn square_root(&mut self, a: Bounded) -> Bounded {
        Self::charged(a.sqrt())
    }
    fn power(&mut self, a: Bounded, b: Bounded) -> Bounded {
        Self::charged(a.powf(b))
    }
    fn real_power(&mut self, a: Bounded, nearest: f64, rest: Precise) -> Bounded {
        Self::charged(BoundedAlgebra.real_power(a, nearest, rest))
    }
    fn call(&mut self, function: Function, arguments: &[Bounded]) -> Bounded {
        Self::charged(BoundedAlgebra.call(function, arguments))
    }
}

/// The value with the bound of its row, by a single call of the function; `None` if the row has no bound, or has too many
/// arguments.
fn by_spread(row: &Row, arguments: &[Bounded]) -> Option<Bounded> {
    const FEW: usize = 4;
    let spread = row.spread?;
    let (mut point, mut exact, mut by) = ([0.0; FEW], [DoubleDouble::from(0.0); FEW], [0.0; FEW]);
    let count = arguments.len();
    let (point, exact, by) = (point.get_mut(..count)?, exact.get_mut(..count)?, by.get_mut(..count)?);
    for (((value, known), distance), argument) in point.iter_mut().zip(&mut *exact).zip(&mut *by).zip(arguments) {
        (*value, *known, *distance) = (argument.value, argument.value.into(), argument.error);
    }
    let value = (row.value)(point);
    let carried = if by.iter().all(|by| *by == 0.0) { 0.0 } else { spread(exact, by) };
    let error = (carried + row.ulps() * f64::EPSILON * value.abs()) * (1.0 + 8.0 * f64::EPSILON);
    if row.is_pair {
        return Some(Bounded::checked(value, error + f64::from_bits(1)));
    }
    // Near underflow the bound itself would be inaccurate.
    (value.abs() >= 1e-150 && error <= f64::MAX).then_some(Bounded { value, error })
}

/// Complex values of the elementary functions; a step into the imaginary direction gives derivatives without cancellation.
#[derive(Clone, Copy, Debug, Default)]
pub struct ComplexAlgebra;

impl Algebra for ComplexAlgebra {
    type Value = Complex64;
    const COST: Cost = Cost::new(4, 20, 200);
    fn constant(&mut self, number: Precise) -> Complex64 {
        Complex64::new(number.value.hi, 0.0)
    }
    fn add(&mut self, a: Complex64, b: Complex64) -> Complex64 {
        a + b
    }
    fn subtract(&mut self, a: Complex64, b: Complex64) -> Complex64 {
        a - b
    }
    fn multiply(&mut self, a: Complex64, b: Complex64) -> Complex64 {
        a * b
    }
    fn divide(&mut self, a: Complex64, b: Complex64) -> Complex64 {
        a / b
    }
    fn square_root(&mut self, a: Complex64) -> Complex64 {
        a.sqrt()
    }
    fn power(&mut self, a: Complex64, b: Complex64) -> Complex64 {
        if b.im == 0.0 { a.powf(b.re) } else { a.powc(b) }
    }
    fn call(&mut self, function: Function, arguments: &[Complex64]) -> Complex64 {
        function.row().complex.map_or(Complex64::new(f64::NAN, f64::NAN), |f| f(arguments))
    }
}

/// Most arguments of a function of numbers.
const FEW: usize = 8;

/// Rectangles that hold every value for arguments in rectangles; unknown where the expression is, or may be, not analytic.
#[derive(Clone, Copy, Debug, Default)]
pub struct RegionAlgebra;

impl Algebra for RegionAlgebra {
    type Value = Region;
    const COST: Cost = Cost::new(24, 80, 70);
    fn constant(&mut self, number: Precise) -> Region {
        let (value, error) = (number.value.hi, number.value.lo.abs() + number.error);
        if error == 0.0 { Region::real(value) } else { Region::new(((value - error).next_down(), (value + error).next_up()), (0.0, 0.0)) }
    }
    fn add(&mut self, a: Region, b: Region) -> Region {
        a + b
    }
    fn subtract(&mut self, a: Region, b: Region) -> Region {
        a - b
    }
    fn multiply(&mut self, a: Region, b: Region) -> Region {
        a * b
    }
    fn divide(&mut self, a: Region, b: Region) -> Region {
        a / b
    }
    fn square_root(&mut self, a: Region) -> Region {
        a.sqrt()
    }
    fn power(&mut self, a: Region, b: Region) -> Region {
        a.power(b)
    }
    fn real_power(&mut self, a: Region, nearest: f64, rest: Precise) -> Region {
        let by = rest.value.hi.abs() + rest.value.lo.abs() + rest.error;
        a.power(Region::new(((nearest - by).next_down(), (nearest + by).next_up()), (0.0, 0.0)))
    }
    fn call(&mut self, function: Function, arguments: &[Region]) -> Region {
        let row = function.row();
        // Of numbers every function has a value.
        let mut numbers = [0.0; FEW];
        if let Some(numbers) = numbers.get_mut(..arguments.len())
            && numbers.iter_mut().zip(arguments).all(|(slot, argument)| argument.as_real().map(|value| *slot = value).is_some())
        {
            let value = (row.value)(numbers);
            let error = (row.ulps() + 1.0) * f64::EPSILON * value.abs();
            return if value.is_finite() { Region::new((value - error, value + error), (0.0, 0.0)) } else { Region::unknown() };
        }
        row.region.map_or_else(Region::unknown, |region| region(arguments))
    }
}

/// Intervals of real numbers that hold every value for arguments in intervals; unknown where the expression is, or may be, not
/// analytic.
#[derive(Clone, Copy, Debug, Default)]
pub struct IntervalAlgebra;

impl Algebra for IntervalAlgebra {
    type Value = Region;
    const COST: Cost = Cost::new(16, 28, 280);
    fn constant(&mut self, number: Precise) -> Region {
        RegionAlgebra.constant(number)
    }
    fn add(&mut self, a: Region, b: Region) -> Region {
        a + b
    }
    fn subtract(&mut self, a: Region, b: Region) -> Region {
        a - b
    }
    fn multiply(&mut self, a: Region, b: Region) -> Region {
        (a * b).on_the_axis()
    }
    fn divide(&mut self, a: Region, b: Region) -> Region {
        (a / b).on_the_axis()
    }
    fn square_root(&mut self, a: Region) -> Region {
        a.sqrt().on_the_axis()
    }
    fn power(&mut self, a: Region, b: Region) -> Region {
        a.power(b).on_the_axis()
    }
    fn call(&mut self, function: Function, arguments: &[Region]) -> Region {
        RegionAlgebra.call(function, arguments).on_the_axis()
    }
}
