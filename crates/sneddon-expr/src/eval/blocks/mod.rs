//! Tapes over blocks of points: one dispatch per operation and block, plain or with a running bound of the error.

pub(super) mod bounded;
mod plain;
mod program;

pub(crate) use program::Program;

use super::Tape;
use crate::num::work;

/// Points that run through the whole tape together, few enough for their registers to fit into the first-level cache.
const BLOCK: usize = 256;

/// Scratch memory shared by all blocks of a thread; nothing is allocated after the first call of the largest tape.
#[derive(Clone, Debug, Default)]
pub struct BlockScratch {
    registers: Vec<RegisterSlot>,
    /// Errors of exact inputs.
    zeros: Vec<f64>,
}

/// A register; empty while it is being written.
type RegisterSlot = Option<Box<Register>>;

/// Intermediate values of one block and their errors.
#[derive(Clone, Debug)]
struct Register {
    values: [f64; BLOCK],
    errors: [f64; BLOCK],
}

/// One input of a bounded run over a block.
#[derive(Clone, Copy, Debug)]
pub struct BlockInput<'a> {
    /// The values.
    pub values: &'a [f64],
    /// Bounds of their errors; empty for exact values.
    pub errors: &'a [f64],
}

impl<'a> BlockInput<'a> {
    /// Exact values.
    pub fn exact(values: &'a [f64]) -> Self {
        Self { values, errors: &[] }
    }
}

impl BlockScratch {
    fn prepare(&mut self, registers: usize) {
        if self.registers.len() < registers {
            self.registers.resize_with(registers, || Some(Box::new(Register { values: [0.0; BLOCK], errors: [0.0; BLOCK] })));
        }
        if self.zeros.is_empty() {
            self.zeros = vec![0.0; BLOCK];
        }
    }
}

impl Tape {
    /// The first output at every point of a block, bit for bit the values of [`Tape::run`] with plain numbers.
    ///
    /// `None` if the number of inputs, or the length of an input, is wrong.
    /// The accuracy is the same as for [`Tape::run`]; values outside a domain are NaN.
    ///
    /// ```
    /// use sneddon_expr::{eval::{BlockScratch, Tape}, expr::{Expr, Symbol}};
    /// let f = Expr::symbol("r").power(2) + Expr::symbol("r");
    /// let tape = Tape::compile(&[f], &[Symbol::new("r")]).unwrap();
    /// let (mut out, mut scratch) = ([0.0; 3], BlockScratch::default());
    /// tape.run_block(&[&[1.0, 2.0, 3.0]], &mut out, &mut scratch).unwrap();
    /// assert_eq!(out, [2.0, 6.0, 12.0]);
    /// ```
    pub fn run_block(&self, inputs: &[&[f64]], out: &mut [f64], scratch: &mut BlockScratch) -> Option<()> {
        let program = self.program()?;
        if inputs.len() != program.inputs() || inputs.iter().any(|input| input.len() != out.len()) {
            return None;
        }
        work::spend(self.counts().block_steps(out.len()));
        scratch.prepare(program.registers());
        let mut from = 0;
        for out in out.chunks_mut(BLOCK) {
            program.run(inputs, from, out, &mut scratch.registers)?;
            from += out.len();
        }
        Some(())
    }

    /// The first output at every point of a block with a bound of its error, as [`Tape::run`] gives it with bounded numbers.
    ///
    /// Sums, products, quotients and roots are bounded rigorously, elementary functions by their derivative; where such a cheap bound
    /// does not hold (an edge of a domain, underflow), and for other functions, the point goes through [`Bounded`](crate::num::Bounded).
    /// The values are those of the bounded scalar tape; one that underflows to zero has an error of at least
    /// [`Bounded::VANISHED`](crate::num::Bounded::VANISHED).
    /// `None` as for [`Tape::run_block`].
    ///
    /// ```
    /// use sneddon_expr::{eval::{BlockInput, BlockScratch, Tape}, expr::{Expr, Symbol}};
    /// let f = Expr::call("sin", [Expr::symbol("r")]);
    /// let tape = Tape::compile(&[f], &[Symbol::new("r")]).unwrap();
    /// let (mut out, mut errors, mut scratch) = ([0.0; 2], [0.0; 2], BlockScratch::default());
    /// let r = BlockInput { values: &[0.5, 1.5], errors: &[1e-10, 0.0] };
    /// tape.run_block_bounded(&[r], &mut out, &mut errors, &mut scratch).unwrap();
    /// assert!(out[0] == 0.5_f64.sin() && errors[0] >= 8.7e-11 && errors[0] < 1.1e-10 && errors[1] < 1e-15);
    /// ```
    pub fn run_block_bounded(
        &self,
        inputs: &[BlockInput<'_>],
        out: &mut [f64],
        errors: &mut [f64],
        scratch: &mut BlockScratch,
    ) -> Option<()> {
        let program = self.program()?;
        let fits = |input: &BlockInput<'_>| input.values.len() == out.len() && (input.errors.is_empty() || input.errors.len() == out.len());
        if inputs.len() != program.inputs() || errors.len() != out.len() || !inputs.iter().all(fits) {
            return None;
        }
        work::spend(self.counts().bounded_block_steps(out.len()));
        scratch.prepare(program.registers());
        let mut from = 0;
        for (out, errors) in out.chunks_mut(BLOCK).zip(errors.chunks_mut(BLOCK)) {
            program.run_bounded(inputs, from, out, errors, scratch)?;
            from += out.len();
        }
        Some(())
    }
}
