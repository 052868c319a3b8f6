//! A recorded walk: operations over numbered slots, with shared subterms computed once.

use super::blocks::Program;
use super::cost::Cost;
use super::walk::walk_with;
use super::{Algebra, EvalError, Kept};
use crate::expr::function::Accuracy;
use crate::expr::{Expr, Function, Node, Symbol};
use crate::num::{DoubleDouble, Precise, work};
use std::collections::HashMap;
use std::sync::OnceLock;

/// Expressions compiled for many evaluations.
///
/// ```
/// use sneddon_expr::{eval::{FloatAlgebra, Tape}, expr::{Expr, Symbol}};
/// let f = Expr::symbol("r").power(2) + Expr::symbol("r");
/// let tape = Tape::compile(&[f], &[Symbol::new("r")]).unwrap();
/// let mut slots = Vec::new();
/// assert_eq!(tape.run(&mut FloatAlgebra, &[3.0], &mut slots), Some(12.0));
/// ```
#[derive(Clone, Debug)]
pub struct Tape {
    pub(super) operations: Vec<Operation>,
    pub(super) constants: Vec<Precise>,
    pub(super) arguments: Vec<u32>,
    pub(super) outputs: Vec<u32>,
    pub(super) inputs: usize,
    program: OnceLock<Option<Program>>,
    kept: Box<Kept>,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Operation {
    Constant(u32),
    Input(u32),
    Add(u32, u32),
    Subtract(u32, u32),
    Multiply(u32, u32),
    Divide(u32, u32),
    SquareRoot(u32),
    Power(u32, u32),
    /// Base, and the places of the exponent's double and of its rest among the constants.
    RealPower(u32, u32, u32),
    Call(Function, u32, u32),
}

impl Tape {
    /// Records the expressions over the given inputs.
    ///
    /// # Errors
    /// [`EvalError::Unbound`] for a symbol that is not an input.
    pub fn compile(expressions: &[Expr], inputs: &[Symbol]) -> Result<Self, EvalError> {
        Self::compile_with(expressions, inputs, false)
    }

    /// Records the expressions for enclosures: a power is one operation, and no difference of squares is factored, because an
    /// argument that occurs once is enclosed without loss.
    ///
    /// # Errors
    /// [`EvalError::Unbound`] for a symbol that is not an input.
    pub fn for_enclosures(expressions: &[Expr], inputs: &[Symbol]) -> Result<Self, EvalError> {
        Self::compile_with(expressions, inputs, true)
    }

    fn compile_with(expressions: &[Expr], inputs: &[Symbol], keeps_powers: bool) -> Result<Self, EvalError> {
        let mut recorder = Recorder {
            keeps_powers,
            tape: Self {
                operations: Vec::new(),
                constants: Vec::new(),
                arguments: Vec::new(),
                outputs: Vec::new(),
                inputs: inputs.len(),
                program: OnceLock::new(),
                kept: Box::default(),
            },
        };
        for index in 0..inputs.len() {
            recorder.push(Operation::Input(u32::try_from(index).unwrap_or(u32::MAX)));
        }
        let mut outputs = Vec::new();
        let mut seen: HashMap<Expr, u32> = HashMap::new();
        for expr in expressions {
            let slot = record(expr, &mut recorder, inputs, &mut seen);
            // An expression that was built after the budget was exhausted is meaningless.
            work::check()?;
            outputs.push(slot?);
        }
        recorder.tape.outputs = outputs;
        for operation in &recorder.tape.operations {
            let counts = &mut recorder.tape.kept.counts;
            let kind = match operation {
                Operation::Power(..) | Operation::RealPower(..) => &mut counts.elementary,
                Operation::Call(function, ..) if function.row().slice.is_some() => &mut counts.elementary,
                Operation::Call(..) => &mut counts.special,
                _ => &mut counts.arithmetic,
            };
            *kind += 1;
        }
        Ok(recorder.tape)
    }

    /// Returns the first output, or `None` if the number of inputs is wrong or the work was stopped, as in [`work::stoppable`].
    pub fn run<A: Algebra>(&self, algebra: &mut A, inputs: &[A::Value], slots: &mut Vec<A::Value>) -> Option<A::Value> {
        self.fill(algebra, inputs, slots)?;
        slots.get(*self.outputs.first()? as usize).copied()
    }

    /// Every output for the given input values.
    pub fn run_all<A: Algebra>(&self, algebra: &mut A, inputs: &[A::Value], slots: &mut Vec<A::Value>) -> Option<Vec<A::Value>> {
        self.fill(algebra, inputs, slots)?;
        self.outputs.iter().map(|slot| slots.get(*slot as usize).copied()).collect()
    }

    /// The number of operations.
    pub fn len(&self) -> usize {
        self.operations.len()
    }

    /// True for a tape without operations.
    pub fn is_empty(&self) -> bool {
        self.operations.is_empty()
    }

    fn fill<A: Algebra>(&self, algebra: &mut A, inputs: &[A::Value], slots: &mut Vec<A::Value>) -> Option<()> {
        if inputs.len() != self.inputs {
            return None;
        }
        work::spend(self.kept.counts.steps(&A::COST));
        slots.clear();
        slots.reserve(self.operations.len());
        let mut gathered = Vec::new();
        let kept = A::kept(&self.kept).map(|own| own.get_or_init(|| work::unbroken(|| self.constant_values(algebra))));
        let stops = A::STOPS || (A::STOPS_SPECIAL && self.is_special());
        for (index, operation) in self.operations.iter().enumerate() {
            if stops && work::is_stopped() {
                return None;
            }
            let value = match kept.and_then(|list| list.get(index).copied().flatten()) {
                Some(known) => known,
                None => self.step(operation, algebra, inputs, &|slot| slots.get(*slot as usize).copied(), &mut gathered)?,
            };
            slots.push(value);
        }
        Some(())
    }

    /// The values of all operations that do not depend on the inputs.
    fn constant_values<A: Algebra>(&self, algebra: &mut A) -> Vec<Option<A::Value>> {
        let mut values: Vec<Option<A::Value>> = Vec::with_capacity(self.operations.len());
        let mut gathered = Vec::new();
        for operation in &self.operations {
            let value = match operation {
                Operation::Input(_) => None,
                // An operation that reads an input has an operand without a value.
                _ => self.step(operation, algebra, &[], &|slot| values.get(*slot as usize).copied().flatten(), &mut gathered),
            };
            values.push(value);
        }
        values
    }

    /// One operation on values that are known.
    #[inline]
    pub(super) fn step<A: Algebra>(
        &self,
        operation: &Operation,
        algebra: &mut A,
        inputs: &[A::Value],
        get: &impl Fn(&u32) -> Option<A::Value>,
        gathered: &mut Vec<A::Value>,
    ) -> Option<A::Value> {
        Some(match operation {
            Operation::Constant(index) => algebra.constant(*self.constants.get(*index as usize)?),
            Operation::Input(index) => *inputs.get(*index as usize)?,
            Operation::Add(a, b) => algebra.add(get(a)?, get(b)?),
            Operation::Subtract(a, b) => algebra.subtract(get(a)?, get(b)?),
            Operation::Multiply(a, b) => algebra.multiply(get(a)?, get(b)?),
            Operation::Divide(a, b) => algebra.divide(get(a)?, get(b)?),
            Operation::SquareRoot(a) => algebra.square_root(get(a)?),
            Operation::Power(a, b) => algebra.power(get(a)?, get(b)?),
            Operation::RealPower(a, nearest, rest) => {
                let constant = |index: &u32| self.constants.get(*index as usize).copied();
                algebra.real_power(get(a)?, constant(nearest)?.value.hi, constant(rest)?)
            }
            Operation::Call(function, from, to) => {
                gathered.clear();
                for slot in self.arguments.get(*from as usize..*to as usize)? {
                    gathered.push(get(slot)?);
                }
                match function.row().accuracy {
                    Accuracy::Bounded(_) if A::READS_NUMBERS && gathered.len() > 1 => {
                        let numbers: Vec<_> =
                            self.arguments.get(*from as usize..*to as usize)?.iter().map(|own| self.number(*own)).collect();
                        algebra.call_with_numbers(*function, gathered, &numbers)
                    }
                    _ => algebra.call(*function, gathered),
                }
            }
        })
    }

    /// The number in a slot; `None` for anything that is computed.
    fn number(&self, slot: u32) -> Option<DoubleDouble> {
        match self.operations.get(slot as usize)? {
            Operation::Constant(index) => self.constants.get(*index as usize).map(|own| own.value),
            _ => None,
        }
    }

    /// The slots that an operation reads.
    pub(super) fn operands(&self, operation: &Operation) -> Option<Vec<usize>> {
        let slots: &[u32] = match operation {
            Operation::Constant(_) | Operation::Input(_) => &[],
            Operation::Add(a, b)
            | Operation::Subtract(a, b)
            | Operation::Multiply(a, b)
            | Operation::Divide(a, b)
            | Operation::Power(a, b) => &[*a, *b],
            Operation::SquareRoot(a) | Operation::RealPower(a, ..) => &[*a],
            Operation::Call(_, from, to) => self.arguments.get(*from as usize..*to as usize)?,
        };
        Some(slots.iter().map(|slot| *slot as usize).collect())
    }

    /// The program for runs over blocks, prepared at the first call.
    pub(super) fn program(&self) -> Option<&Program> {
        self.program.get_or_init(|| Program::new(self)).as_ref()
    }

    /// Whether a run may take long for some arguments: it calls functions other than the elementary ones.
    pub fn is_special(&self) -> bool {
        self.kept.counts.special > 0
    }

    /// How many operations of each kind it has.
    pub(super) fn counts(&self) -> Cost {
        self.kept.counts
    }

    /// About how many nanoseconds a point of a block takes, in doubles and with 30 digits.
    pub fn cost(&self) -> (f64, f64) {
        self.program().map_or((0.0, 0.0), Program::cost)
    }
}

/// Walks `expr` into the recorder; equal subtrees get one slot.
fn record(expr: &Expr, recorder: &mut Recorder, inputs: &[Symbol], seen: &mut HashMap<Expr, u32>) -> Result<u32, EvalError> {
    if let Some(slot) = seen.get(expr) {
        return Ok(*slot);
    }
    let slot = match expr.node() {
        Node::Symbol(symbol) => inputs
            .iter()
            .position(|input| input == symbol)
            .and_then(|index| u32::try_from(index).ok())
            .ok_or_else(|| EvalError::Unbound { name: symbol.name().to_owned() })?,
        _ => walk_with(expr, recorder, &mut |inner, recorder| {
            if inner == expr { Ok(None) } else { record(inner, recorder, inputs, seen).map(Some) }
        })?,
    };
    seen.insert(expr.clone(), slot);
    Ok(slot)
}

/// The algebra whose values are slots: it writes operations down instead of doing them.
struct Recorder {
    tape: Tape,
    keeps_powers: bool,
}

impl Recorder {
    fn keep(&mut self, number: Precise) -> u32 {
        self.tape.constants.push(number);
        u32::try_from(self.tape.constants.len() - 1).unwrap_or(u32::MAX)
    }

    fn push(&mut self, operation: Operation) -> u32 {
        self.tape.operations.push(operation);
        u32::try_from(self.tape.operations.len() - 1).unwrap_or(u32::MAX)
    }
}

impl Algebra for Recorder {
    type Value = u32;
    fn constant(&mut self, number: Precise) -> u32 {
        let index = self.keep(number);
        self.push(Operation::Constant(index))
    }
    fn add(&mut self, a: u32, b: u32) -> u32 {
        self.push(Operation::Add(a, b))
    }
    fn subtract(&mut self, a: u32, b: u32) -> u32 {
        self.push(Operation::Subtract(a, b))
    }
    fn multiply(&mut self, a: u32, b: u32) -> u32 {
        self.push(Operation::Multiply(a, b))
    }
    fn divide(&mut self, a: u32, b: u32) -> u32 {
        self.push(Operation::Divide(a, b))
    }
    fn square_root(&mut self, a: u32) -> u32 {
        self.push(Operation::SquareRoot(a))
    }
    fn power(&mut self, a: u32, b: u32) -> u32 {
        self.push(Operation::Power(a, b))
    }
    fn real_power(&mut self, a: u32, nearest: f64, rest: Precise) -> u32 {
        let (nearest, rest) = (self.keep(Precise::exact(nearest)), self.keep(rest));
        self.push(Operation::RealPower(a, nearest, rest))
    }
    fn keeps_powers(&self) -> bool {
        self.keeps_powers
    }
    fn call(&mut self, function: Function, arguments: &[u32]) -> u32 {
        let from = u32::try_from(self.tape.arguments.len()).unwrap_or(u32::MAX);
        self.tape.arguments.extend_from_slice(arguments);
        let to = u32::try_from(self.tape.arguments.len()).unwrap_or(u32::MAX);
        self.push(Operation::Call(function, from, to))
    }
}
