//! Plain numbers: loops that the compiler turns into vector instructions wherever the processor has them.

use super::program::{Action, Operand, Program};
use super::{BLOCK, RegisterSlot};
use crate::expr::Function;
use crate::num::{corrected_power, real_power};

/// Most arguments of a function.
const MOST_ARGUMENTS: usize = 8;

/// One operand over a block.
#[derive(Clone, Copy)]
enum Values<'a> {
    One(f64),
    Each(&'a [f64]),
}

impl Program {
    /// The output at the points from `from` on, as many as `out` has and at most [`BLOCK`].
    pub(super) fn run(&self, inputs: &[&[f64]], from: usize, out: &mut [f64], registers: &mut [RegisterSlot]) -> Option<()> {
        let count = out.len().min(BLOCK);
        let Some((last, steps)) = self.steps.split_last() else {
            match self.values(self.output, inputs, from, count, registers)? {
                Values::One(value) => out.fill(value),
                Values::Each(values) => out.copy_from_slice(values),
            }
            return Some(());
        };
        for step in steps {
            // The register is taken out, so that the operands can be read while it is written.
            let mut own = registers.get_mut(step.to)?.take()?;
            let done = self.act(&step.action, inputs, from, own.values.get_mut(..count)?, registers);
            *registers.get_mut(step.to)? = Some(own);
            done?;
        }
        self.act(&last.action, inputs, from, out, registers)
    }

    fn values<'a>(
        &self,
        operand: Operand,
        inputs: &[&'a [f64]],
        from: usize,
        count: usize,
        registers: &'a [RegisterSlot],
    ) -> Option<Values<'a>> {
        Some(match operand {
            Operand::Constant(known) => Values::One(known.plain),
            Operand::Input(index) => Values::Each(inputs.get(index)?.get(from..from + count)?),
            Operand::Register(index) => Values::Each(registers.get(index)?.as_ref()?.values.get(..count)?),
        })
    }

    fn act(&self, action: &Action, inputs: &[&[f64]], from: usize, to: &mut [f64], registers: &[RegisterSlot]) -> Option<()> {
        let count = to.len();
        let values = |operand: &Operand| self.values(*operand, inputs, from, count, registers);
        match action {
            Action::Add(a, b) => two(values(a)?, values(b)?, to, |a, b| a + b),
            Action::Subtract(a, b) => two(values(a)?, values(b)?, to, |a, b| a - b),
            Action::Multiply(a, b) => two(values(a)?, values(b)?, to, |a, b| a * b),
            Action::Scale(a, by) => one(values(a)?, to, |a| a * by),
            Action::Divide(a, b) => two(values(a)?, values(b)?, to, |a, b| a / b),
            Action::SquareRoot(a) => one(values(a)?, to, f64::sqrt),
            Action::Power(a, b) => two(values(a)?, values(b)?, to, f64::powf),
            Action::RealPower(a, nearest, rest) => match values(a)? {
                Values::One(a) => to.fill(real_power(a, *nearest, rest.plain)),
                Values::Each(a) => {
                    one(Values::Each(a), to, |a| a.powf(*nearest));
                    to.iter_mut().zip(a).for_each(|(to, a)| *to = corrected_power(*to, *a, rest.plain));
                }
            },
            Action::Slice(law, function, a) => match values(a)? {
                Values::Each(a) => (law.values)(a, to),
                Values::One(a) => to.fill((function.row().value)(&[a])),
            },
            Action::Call(function, start, end) => {
                let mut list = [Values::One(0.0); MOST_ARGUMENTS];
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

fn one(a: Values<'_>, to: &mut [f64], f: impl Fn(f64) -> f64) {
    match a {
        Values::One(a) => to.fill(f(a)),
        Values::Each(a) => to.iter_mut().zip(a).for_each(|(to, a)| *to = f(*a)),
    }
}

fn two(a: Values<'_>, b: Values<'_>, to: &mut [f64], f: impl Fn(f64, f64) -> f64) {
    match (a, b) {
        (Values::One(a), Values::One(b)) => to.fill(f(a, b)),
        (Values::Each(a), Values::One(b)) => to.iter_mut().zip(a).for_each(|(to, a)| *to = f(*a, b)),
        (Values::One(a), Values::Each(b)) => to.iter_mut().zip(b).for_each(|(to, b)| *to = f(a, *b)),
        (Values::Each(a), Values::Each(b)) => to.iter_mut().zip(a).zip(b).for_each(|((to, a), b)| *to = f(*a, *b)),
    }
}

fn many(function: Function, arguments: &[Values<'_>], to: &mut [f64]) {
    let row = function.row();
    let value = row.value;
    let mut point = [0.0; MOST_ARGUMENTS];
    let Some(point) = point.get_mut(..arguments.len()) else { return to.fill(f64::NAN) };
    for (slot, argument) in point.iter_mut().zip(arguments) {
        if let Values::One(known) = argument {
            *slot = *known;
        }
    }
    let mut running = arguments.iter().enumerate().filter_map(|(place, argument)| match argument {
        Values::Each(values) => Some((place, *values)),
        Values::One(_) => None,
    });
    if let (Some((place, values)), None, Some(sweep)) = (running.next(), running.next(), row.sweep) {
        return sweep(point, place, values, to);
    }
    for (index, to) in to.iter_mut().enumerate() {
        for (slot, argument) in point.iter_mut().zip(arguments) {
            if let Values::Each(values) = argument {
                *slot = values.get(index).copied().unwrap_or(f64::NAN);
            }
        }
        *to = value(point);
    }
}
