//! Numbers with error bounds: branch-free bounds where nothing under- or overflows, the scalar operation elsewhere.
//!
//! A point whose bound is not comfortable (a zero or tiny product, an edge, an infinity) is computed again by [`Bounded`].

use super::program::{Action, Known, Operand, Program};
use super::{BLOCK, BlockInput, BlockScratch, RegisterSlot};
use crate::expr::Function;
use crate::num::{Bounded, DoubleDouble, real_power, real_power_part};

/// Most arguments of a function.
const MOST_ARGUMENTS: usize = 8;
/// Half the spacing of the numbers just above 1.
const UNIT: f64 = f64::EPSILON / 2.0;
/// More than the roundings made in computing one bound.
const WIDEN: f64 = 1.0 + 16.0 * UNIT;
/// Above this half an ulp is far from underflow, and so is what the products of a bound may lose: 2^-500.
const COMFORTABLE: f64 = f64::from_bits((1023 - 500) << 52);
/// An exponent whose own error is below this counts with the largest logarithm of a comfortable base.
const NEARLY_EXACT: f64 = 1e-25;
/// The logarithm of the largest double, and a little more.
const LARGEST_LN: f64 = 710.0;

/// Values and bounds of one operand over a block.
#[derive(Clone, Copy)]
struct Each<'a> {
    values: &'a [f64],
    errors: &'a [f64],
}

#[derive(Clone, Copy)]
enum Values<'a> {
    One(Bounded),
    Each(Each<'a>),
}

/// Where the results go.
struct To<'a> {
    values: &'a mut [f64],
    errors: &'a mut [f64],
}

/// Where a block's inputs are.
#[derive(Clone, Copy)]
struct Block<'a, 'b> {
    inputs: &'b [BlockInput<'a>],
    zeros: &'a [f64],
    from: usize,
    count: usize,
}

impl Program {
    /// The output and its error bounds at the points from `from` on, as many as `out` has and at most [`BLOCK`].
    pub(super) fn run_bounded(
        &self,
        inputs: &[BlockInput<'_>],
        from: usize,
        out: &mut [f64],
        errors: &mut [f64],
        scratch: &mut BlockScratch,
    ) -> Option<()> {
        let BlockScratch { registers, zeros } = scratch;
        let block = Block { inputs, zeros, from, count: out.len().min(BLOCK) };
        let Some((last, steps)) = self.steps.split_last() else {
            match block.values(self.output, registers)? {
                Values::One(known) => {
                    out.fill(known.value);
                    errors.fill(known.error);
                }
                Values::Each(each) => {
                    out.copy_from_slice(each.values);
                    errors.copy_from_slice(each.errors);
                }
            }
            return Some(());
        };
        for step in steps {
            // The register is taken out, so that the operands can be read while it is written.
            let mut own = registers.get_mut(step.to)?.take()?;
            let to = To { values: own.values.get_mut(..block.count)?, errors: own.errors.get_mut(..block.count)? };
            let done = self.act_bounded(&step.action, &block, to, registers);
            *registers.get_mut(step.to)? = Some(own);
            done?;
        }
        self.act_bounded(&last.action, &block, To { values: out, errors }, registers)
    }

    fn act_bounded(&self, action: &Action, block: &Block<'_, '_>, to: To<'_>, registers: &[RegisterSlot]) -> Option<()> {
        let values = |operand: &Operand| block.values(*operand, registers);
        match action {
            Action::Add(a, b) => two(values(a)?, values(b)?, to, add, |a, b| a + b),
            Action::Subtract(a, b) => two(values(a)?, values(b)?, to, |a, b| add(a, -b), |a, b| a - b),
            Action::Multiply(a, b) => two(values(a)?, values(b)?, to, multiply, |a, b| a * b),
            Action::Scale(a, by) => one(values(a)?, to, |a| scale(a, *by), |a| a * Bounded::exact(*by)),
            Action::Divide(a, b) => two(values(a)?, values(b)?, to, divide, |a, b| a / b),
            Action::SquareRoot(a) => one(values(a)?, to, square_root, Bounded::sqrt),
            Action::Power(a, Operand::Constant(Known { bounded: exponent, .. })) => {
                one(values(a)?, to, |a| power(a, *exponent), |a| a.powf(*exponent));
            }
            Action::Power(a, b) => two(values(a)?, values(b)?, to, |_, _| UNKNOWN, Bounded::powf),
            Action::RealPower(a, nearest, rest) => {
                let rest = rest.bounded;
                one(values(a)?, to, |a| split_power(a, *nearest, rest), |a| a.real_power(*nearest, rest));
            }
            Action::Slice(law, function, a) => {
                let row = function.row();
                let slow = |a: Bounded| a.apply(|z| (row.value)(&[z]), row.ulps());
                match values(a)? {
                    Values::One(a) => one(Values::One(a), to, |_| UNKNOWN, slow),
                    Values::Each(a) => {
                        (law.values)(a.values, to.values);
                        (law.growth)(a.values, a.errors, to.values, to.errors);
                        charge(a, to, row.ulps(), slow);
                    }
                }
            }
            Action::Call(function, start, end) => {
                let mut list = [Values::One(Bounded::exact(0.0)); MOST_ARGUMENTS];
                let arguments = self.arguments.get(*start..*end)?;
                let list = list.get_mut(..arguments.len())?;
                for (own, argument) in list.iter_mut().zip(arguments) {
                    *own = values(argument)?;
                }
                many(*function, list, to);
            }
        }
        Some(())
    }
}

impl<'a> Block<'a, '_> {
    fn values<'r>(&self, operand: Operand, registers: &'r [RegisterSlot]) -> Option<Values<'r>>
    where
        'a: 'r,
    {
        let range = self.from..self.from + self.count;
        Some(match operand {
            Operand::Constant(known) => Values::One(known.bounded),
            Operand::Input(index) => {
                let input = self.inputs.get(index)?;
                let errors = if input.errors.is_empty() { self.zeros.get(..self.count)? } else { input.errors.get(range.clone())? };
                Values::Each(Each { values: input.values.get(range)?, errors })
            }
            Operand::Register(index) => {
                let own = registers.get(index)?.as_ref()?;
                Values::Each(Each { values: own.values.get(..self.count)?, errors: own.errors.get(..self.count)? })
            }
        })
    }
}

/// A value, and its bound where it is comfortable: finite, and not near underflow.
struct Quick {
    value: f64,
    error: f64,
    comfortable: bool,
}

const UNKNOWN: Quick = Quick { value: f64::NAN, error: f64::NAN, comfortable: false };

/// Half a unit in the last place: the power of two below |value|, whose exponent bits alone are kept.
#[inline(always)]
fn half_ulp(value: f64) -> f64 {
    f64::from_bits(value.to_bits() & 0x7ff0_0000_0000_0000) * UNIT
}

/// 1/size or up to 0.6 % more, for sizes between 2^-500 and 2^500: a bound needs no division.
///
/// The bits of a number are nearly its logarithm, so that their difference to a constant is the inverse to 5.1 %, always of the
/// same sign after one step of Newton's: 1 − 0.051² ≤ size·inverse ≤ 1.
#[inline(always)]
pub fn above_inverse(size: f64) -> f64 {
    const ONE: u64 = 0x7fde_6238_22fc_16e6;
    let rough = f64::from_bits(ONE.wrapping_sub(size.to_bits()));
    rough * (2.0 - size * rough) * 1.003
}

#[inline(always)]
fn add(a: Bounded, b: Bounded) -> Quick {
    let value = a.value + b.value;
    let from_b = value - a.value;
    let from_a = value - from_b;
    let rest = (a.value - from_a) + (b.value - from_b);
    let error = (a.error + b.error + rest.abs()) * WIDEN;
    Quick { value, error, comfortable: error <= f64::MAX }
}

#[inline(always)]
fn multiply(a: Bounded, b: Bounded) -> Quick {
    let value = a.value * b.value;
    let rounding = half_ulp(value);
    let error = (a.value.abs() * b.error + (b.value.abs() + b.error) * a.error + rounding) * WIDEN;
    Quick { value, error, comfortable: (rounding >= COMFORTABLE) & (error <= f64::MAX) }
}

#[inline(always)]
fn scale(a: Bounded, by: f64) -> Quick {
    let (value, error) = (a.value * by, a.error * by.abs());
    let kept = (half_ulp(value) >= COMFORTABLE) & ((error >= COMFORTABLE) | (a.error == 0.0));
    Quick { value, error, comfortable: kept & (error <= f64::MAX) & (value.abs() <= f64::MAX) }
}

/// a/b changes by (δa − (a/b)·δb)/(b + δb).
#[inline(always)]
fn divide(a: Bounded, b: Bounded) -> Quick {
    let value = a.value / b.value;
    let rounding = half_ulp(value);
    let size = b.value.abs();
    let error = ((a.error + (value.abs() + rounding) * b.error) * above_inverse(size - b.error) + rounding) * WIDEN;
    let apart = (b.error <= 0.5 * size) & (size >= 2.0 * COMFORTABLE);
    let inside = (rounding >= COMFORTABLE) & (size <= 1.0 / COMFORTABLE);
    Quick { value, error, comfortable: apart & inside & (error <= f64::MAX) }
}

/// √a − √(a−δ) = δ/(√a (1 + √(1−δ/a))) ≤ δ √a/(2a − δ).
#[inline(always)]
fn square_root(a: Bounded) -> Quick {
    let value = a.value.sqrt();
    let error = (a.error * value * above_inverse(2.0 * a.value - a.error) + half_ulp(value)) * WIDEN;
    let inside = (a.value >= COMFORTABLE) & (a.value <= 0.5 / COMFORTABLE);
    Quick { value, error, comfortable: inside & (a.error <= 0.5 * a.value) & (error <= f64::MAX) }
}

/// ln of the power moves by at most s = |p| δ/(a − δ) and what the exponent's own error brings; expm1 s ≤ s + s² up to 1.
#[inline(always)]
fn power(a: Bounded, exponent: Bounded) -> Quick {
    let value = a.value.powf(exponent.value);
    let own = value * f64::EPSILON;
    let stretch = a.error / (a.value - a.error);
    let shift = exponent.value.abs() * stretch + exponent.error * (LARGEST_LN + stretch);
    let error = ((value + own) * shift * (1.0 + shift) + own) * WIDEN;
    let inside = (a.value >= COMFORTABLE) & (a.error <= 0.5 * a.value) & (shift <= 1.0) & (exponent.error <= NEARLY_EXACT);
    Quick { value, error, comfortable: inside & (half_ulp(value) >= COMFORTABLE) & (error <= f64::MAX) }
}

/// The same with the remainder of the exponent beyond its double.
#[inline(always)]
fn split_power(a: Bounded, nearest: f64, rest: Bounded) -> Quick {
    let value = real_power(a.value, nearest, rest.value);
    let own = value * (f64::EPSILON + real_power_part(rest.value, rest.error));
    let shift = (nearest.abs() + rest.value.abs()) * (a.error / (a.value - a.error));
    let error = ((value + own) * shift * (1.0 + shift) + own) * (1.0 + 1e-9);
    let inside = (a.value >= COMFORTABLE) & (a.error <= 0.5 * a.value) & (shift <= 1.0);
    Quick { value, error, comfortable: inside & (half_ulp(value) >= COMFORTABLE) & (error <= f64::MAX) }
}

/// Raises the error of a value that underflowed to zero to at least [`Bounded::VANISHED`].
#[inline(always)]
fn lifted(own: Bounded) -> Bounded {
    let vanished = own.value == 0.0 && own.error > 0.0;
    Bounded { value: own.value, error: if vanished { own.error.max(Bounded::VANISHED) } else { own.error } }
}

/// One operand: `quick` everywhere, `slow` where that is not comfortable.
#[inline(always)]
fn one(a: Values<'_>, to: To<'_>, quick: impl Fn(Bounded) -> Quick, slow: impl Fn(Bounded) -> Bounded) {
    let a = match a {
        Values::One(a) => {
            let result = slow(a);
            to.values.fill(result.value);
            to.errors.fill(result.error);
            return;
        }
        Values::Each(a) => a,
    };
    let mut odd = false;
    for (((value, error), to_value), to_error) in a.values.iter().zip(a.errors).zip(to.values.iter_mut()).zip(to.errors.iter_mut()) {
        let found = quick(Bounded { value: *value, error: *error });
        (*to_value, *to_error) = (found.value, found.error);
        odd |= !found.comfortable;
    }
    if odd {
        for (((value, error), to_value), to_error) in a.values.iter().zip(a.errors).zip(to.values).zip(to.errors) {
            let a = Bounded { value: *value, error: *error };
            if !quick(a).comfortable {
                let found = lifted(slow(a));
                (*to_value, *to_error) = (found.value, found.error);
            }
        }
    }
}

/// Two operands; a constant one stays in a register of the processor.
#[inline(always)]
fn two(a: Values<'_>, b: Values<'_>, to: To<'_>, quick: impl Fn(Bounded, Bounded) -> Quick, slow: impl Fn(Bounded, Bounded) -> Bounded) {
    let (a, b) = match (a, b) {
        (a, Values::One(b)) => return one(a, to, |a| quick(a, b), |a| slow(a, b)),
        (Values::One(a), b) => return one(b, to, |b| quick(a, b), |b| slow(a, b)),
        (Values::Each(a), Values::Each(b)) => (a, b),
    };
    let mut odd = false;
    let operands = a.values.iter().zip(a.errors).zip(b.values.iter().zip(b.errors));
    for (((a, b), to_value), to_error) in operands.clone().zip(to.values.iter_mut()).zip(to.errors.iter_mut()) {
        let found = quick(Bounded { value: *a.0, error: *a.1 }, Bounded { value: *b.0, error: *b.1 });
        (*to_value, *to_error) = (found.value, found.error);
        odd |= !found.comfortable;
    }
    if odd {
        for (((a, b), to_value), to_error) in operands.zip(to.values).zip(to.errors) {
            let (a, b) = (Bounded { value: *a.0, error: *a.1 }, Bounded { value: *b.0, error: *b.1 });
            if !quick(a, b).comfortable {
                let found = lifted(slow(a, b));
                (*to_value, *to_error) = (found.value, found.error);
            }
        }
    }
}

/// Adds a function's own error to what its arguments' errors make of it.
fn charge(a: Each<'_>, to: To<'_>, ulps: f64, slow: impl Fn(Bounded) -> Bounded) {
    let own = ulps * f64::EPSILON;
    let total = |value: f64, carried: f64| {
        let error = (carried + own * value.abs()) * WIDEN;
        (error, (half_ulp(value) >= COMFORTABLE) & (error <= f64::MAX))
    };
    let mut odd = false;
    for (value, error) in to.values.iter().zip(to.errors.iter_mut()) {
        let (bound, comfortable) = total(*value, *error);
        // What is not comfortable must not become so by being looked at again.
        *error = if comfortable { bound } else { f64::NAN };
        odd |= !comfortable;
    }
    if odd {
        for (((value, error), to_value), to_error) in a.values.iter().zip(a.errors).zip(to.values).zip(to.errors) {
            if to_error.is_nan() {
                let found = lifted(slow(Bounded { value: *value, error: *error }));
                (*to_value, *to_error) = (found.value, found.error);
            }
        }
    }
}

/// A function without a law for slices: the propagated error of its arguments by the bound in its row, else as in the scalar
/// tape.
fn many(function: Function, arguments: &[Values<'_>], to: To<'_>) {
    let row = function.row();
    let count = arguments.len();
    let mut list = [Bounded::exact(0.0); MOST_ARGUMENTS];
    let (mut point, mut exact, mut by) = ([0.0; MOST_ARGUMENTS], [DoubleDouble::from(0.0); MOST_ARGUMENTS], [0.0; MOST_ARGUMENTS]);
    let (Some(list), Some(point), Some(exact), Some(by)) =
        (list.get_mut(..count), point.get_mut(..count), exact.get_mut(..count), by.get_mut(..count))
    else {
        to.values.fill(f64::NAN);
        return to.errors.fill(f64::NAN);
    };
    for (index, (to_value, to_error)) in to.values.iter_mut().zip(to.errors).enumerate() {
        for ((((own, point), exact), by), argument) in
            list.iter_mut().zip(point.iter_mut()).zip(exact.iter_mut()).zip(by.iter_mut()).zip(arguments)
        {
            *own = match argument {
                Values::One(known) => *known,
                Values::Each(each) => match (each.values.get(index), each.errors.get(index)) {
                    (Some(value), Some(error)) => Bounded { value: *value, error: *error },
                    _ => Bounded::exact(f64::NAN),
                },
            };
            (*point, *exact, *by) = (own.value, own.value.into(), own.error);
        }
        if let Some(spread) = row.spread {
            let value = (row.value)(point);
            let carried = if by.iter().all(|by| *by == 0.0) { 0.0 } else { spread(exact, by) };
            let error = (carried + row.ulps() * f64::EPSILON * value.abs()) * WIDEN;
            if half_ulp(value) >= COMFORTABLE && error <= f64::MAX {
                (*to_value, *to_error) = (value, error);
                continue;
            }
        }
        let found = match &*list {
            [argument] => argument.apply(|z| (row.value)(&[z]), row.ulps()),
            list => Bounded::apply_many(row.value, list, row.ulps()),
        };
        (*to_value, *to_error) = (found.value, found.error);
    }
}
