//! A tape prepared for blocks: constants are computed once, dead operations dropped, and registers shared.

use super::super::tape::Operation;
use super::super::{Algebra, BoundedAlgebra, FloatAlgebra, Tape};
use crate::expr::{Function, SliceLaw};
use crate::num::{Bounded, Precise};

/// The remaining operations, in order; the last one writes the output.
#[derive(Clone, Debug)]
pub(crate) struct Program {
    pub(super) steps: Vec<Step>,
    pub(super) arguments: Vec<Operand>,
    pub(super) output: Operand,
    registers: usize,
    inputs: usize,
}

/// Where an operand is.
#[derive(Clone, Copy, Debug)]
pub(super) enum Operand {
    Constant(Known),
    Input(usize),
    Register(usize),
}

/// A number that does not depend on the point, in plain and in bounded algebra.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    pub(super) plain: f64,
    pub(super) bounded: Bounded,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub(super) action: Action,
    /// The register of the result.
    pub(super) to: usize,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Action {
    Add(Operand, Operand),
    Subtract(Operand, Operand),
    Multiply(Operand, Operand),
    /// By an exact power of two, of either sign.
    Scale(Operand, f64),
    Divide(Operand, Operand),
    SquareRoot(Operand),
    Power(Operand, Operand),
    /// With the exponent's double and its rest.
    RealPower(Operand, f64, Known),
    /// A function of one number with a law for slices.
    Slice(&'static SliceLaw, Function, Operand),
    /// Any other function, with its arguments' places in `arguments`.
    Call(Function, usize, usize),
}

impl Program {
    /// The number of inputs.
    pub(super) fn inputs(&self) -> usize {
        self.inputs
    }

    /// The number of registers.
    pub(super) fn registers(&self) -> usize {
        self.registers
    }

    /// About how many nanoseconds a point takes, in doubles and with 30 digits.
    ///
    /// A function without a slice implementation takes about 1000 ns. With 30 digits it takes the same time if its double is the
    /// rounded 30-digit value; otherwise up to 170 000 ns were measured.
    pub(in super::super) fn cost(&self) -> (f64, f64) {
        let of = |step: &Step| match &step.action {
            Action::Add(..) | Action::Subtract(..) | Action::Multiply(..) | Action::Scale(..) => (0.25, 20.0),
            Action::Divide(..) | Action::SquareRoot(..) => (1.0, 50.0),
            Action::Slice(..) => (7.0, 300.0),
            Action::Power(..) | Action::RealPower(..) => (12.0, 500.0),
            Action::Call(function, ..) if function.row().sweep.is_some() => (20.0, 500.0),
            Action::Call(function, ..) if function.row().is_rounded() => (1000.0, 1200.0),
            Action::Call(..) => (1000.0, 170_000.0),
        };
        self.steps.iter().map(of).fold((0.0, 0.0), |(a, b), (c, d)| (a + c, b + d))
    }

    /// The program of the tape's first output.
    pub(in super::super) fn new(tape: &Tape) -> Option<Self> {
        let output = *tape.outputs.first()? as usize;
        let last_use = last_uses(tape, output)?;
        let mut program = Self { steps: Vec::new(), arguments: Vec::new(), output: Operand::Input(0), registers: 0, inputs: tape.inputs };
        let mut places: Vec<Operand> = Vec::with_capacity(tape.operations.len());
        let mut free: Vec<usize> = Vec::new();
        for (index, operation) in tape.operations.iter().enumerate() {
            if last_use.get(index).is_none_or(Option::is_none) {
                places.push(Operand::Input(0));
                continue;
            }
            let place = program.place(tape, operation, &places, &mut free)?;
            places.push(place);
            // Operands used here for the last time release their registers after the result has been assigned another one.
            for slot in tape.operands(operation)? {
                if let (Some(Some(last)), Some(Operand::Register(register))) = (last_use.get(slot), places.get(slot))
                    && *last == index
                    && !free.contains(register)
                {
                    free.push(*register);
                }
            }
        }
        program.output = *places.get(output)?;
        Some(program)
    }

    fn place(&mut self, tape: &Tape, operation: &Operation, places: &[Operand], free: &mut Vec<usize>) -> Option<Operand> {
        if let Some(known) = folded(tape, operation, places) {
            return Some(Operand::Constant(known));
        }
        let at = |slot: &u32| places.get(*slot as usize).copied();
        let action = match operation {
            Operation::Constant(_) => return None,
            Operation::Input(index) => return Some(Operand::Input(*index as usize)),
            Operation::Add(a, b) => Action::Add(at(a)?, at(b)?),
            Operation::Subtract(a, b) => Action::Subtract(at(a)?, at(b)?),
            Operation::Multiply(a, b) => match (at(a)?, at(b)?) {
                (Operand::Constant(c), b) if c.is_scale() => Action::Scale(b, c.plain),
                (a, Operand::Constant(c)) if c.is_scale() => Action::Scale(a, c.plain),
                (a, b) => Action::Multiply(a, b),
            },
            Operation::Divide(a, b) => match (at(a)?, at(b)?) {
                (a, Operand::Constant(c)) if c.is_scale() => Action::Scale(a, c.plain.recip()),
                (a, b) => Action::Divide(a, b),
            },
            Operation::SquareRoot(a) => Action::SquareRoot(at(a)?),
            Operation::Power(a, b) => Action::Power(at(a)?, at(b)?),
            Operation::RealPower(a, nearest, rest) => {
                let constant = |index: &u32| tape.constants.get(*index as usize).copied();
                Action::RealPower(at(a)?, constant(nearest)?.value.hi, Known::of(constant(rest)?))
            }
            Operation::Call(function, from, to) => {
                let slots = tape.arguments.get(*from as usize..*to as usize)?;
                match (slots, &function.row().slice) {
                    ([one], Some(law)) => Action::Slice(law, *function, at(one)?),
                    _ => {
                        let start = self.arguments.len();
                        for slot in slots {
                            self.arguments.push(at(slot)?);
                        }
                        Action::Call(*function, start, self.arguments.len())
                    }
                }
            }
        };
        let to = free.pop().unwrap_or_else(|| {
            self.registers += 1;
            self.registers - 1
        });
        self.steps.push(Step { action, to });
        Some(Operand::Register(to))
    }
}

impl Known {
    fn of(number: Precise) -> Self {
        Self { plain: FloatAlgebra.constant(number), bounded: BoundedAlgebra.constant(number) }
    }

    /// True if multiplying by it only shifts the exponent, and so does multiplying by its inverse.
    fn is_scale(self) -> bool {
        let power_of_two = self.plain.to_bits() & 0x000f_ffff_ffff_ffff == 0 && self.plain.is_normal() && self.plain.recip().is_normal();
        power_of_two && self.bounded.error == 0.0
    }
}

/// The result of an operation on constants only, by the same operations as at a point.
fn folded(tape: &Tape, operation: &Operation, places: &[Operand]) -> Option<Known> {
    if matches!(operation, Operation::Input(_)) {
        return None;
    }
    let known = |slot: &u32| match places.get(*slot as usize) {
        Some(Operand::Constant(known)) => Some(*known),
        _ => None,
    };
    let plain = tape.step(operation, &mut FloatAlgebra, &[], &|slot| known(slot).map(|k| k.plain), &mut Vec::new())?;
    let bounded = tape.step(operation, &mut BoundedAlgebra, &[], &|slot| known(slot).map(|k| k.bounded), &mut Vec::new())?;
    Some(Known { plain, bounded })
}

/// For every operation that the output needs, the last one that uses it.
fn last_uses(tape: &Tape, output: usize) -> Option<Vec<Option<usize>>> {
    let mut last = vec![None; tape.operations.len()];
    *last.get_mut(output)? = Some(usize::MAX);
    for (index, operation) in tape.operations.iter().enumerate().rev() {
        if last.get(index).is_some_and(Option::is_some) {
            for slot in tape.operands(operation)? {
                let use_of = last.get_mut(slot)?;
                *use_of = use_of.or(Some(index));
            }
        }
    }
    Some(last)
}
