//! How accurate a program is: its routines run with an error bound that grows with every operation.

mod first_order;
mod operations;
mod resolved;

use super::tree::{Comparison, LENGTH, Routine};
use crate::num::{Bounded, work};
use first_order::{Operation, Record};
pub(super) use operations::{ASSUMED, ELEMENTARY};
use operations::{Known, binary};
use resolved::{Accumulation, Code, Condition, Resolved, Step};

/// Steps of work for an operation, and for one that is recorded.
const PLAIN_OPERATION: u64 = 4;
const RECORDED: u64 = 6;
/// The most operations of one run.
const MOST_STEPS: usize = 400_000;

/// Runs routines.
pub(super) struct Machine<'a> {
    names: Vec<&'a str>,
    routines: Vec<Resolved<'a>>,
    record: Option<Record>,
}

/// A result with its running bound, and its place in the record.
#[derive(Clone, Copy, Debug)]
pub(super) struct Traced {
    pub(super) bounded: Bounded,
    place: usize,
}

impl<'a> Machine<'a> {
    /// A machine for routines; `library` gives the assumed accuracy of functions of the language's library.
    pub(super) fn new(routines: &'a [Routine], library: &dyn Fn(&str) -> Option<f64>) -> Self {
        let names = routines.iter().map(|own| own.name.as_str()).collect();
        Self { names, routines: resolved::resolved(routines, library), record: None }
    }

    /// The value of a routine at exact arguments, with its running bound; `None` if it does not end or calls what is unknown.
    pub(super) fn traced(&mut self, name: &str, arguments: &[f64]) -> Option<Traced> {
        let routine = self.routines.get(self.names.iter().position(|own| *own == name)?)?;
        let mut run = Run { routines: &self.routines, steps: 0, record: &mut self.record };
        let arguments: Vec<Traced> = arguments.iter().map(|own| run.leaf(Bounded::exact(*own))).collect();
        run.routine(routine, &arguments)
    }

    /// Starts a new record: the operations of all runs from here on belong to it.
    pub(super) fn start_record(&mut self) {
        self.record.get_or_insert_default().clear();
    }

    /// A bound on the error of the sum of results times factors: the sum of running bounds, or that to first order if there is a
    /// record and it is smaller.
    pub(super) fn error(&self, sum: &[(Traced, f64)]) -> f64 {
        let running = sum.iter().map(|(own, factor)| own.bounded.error * factor.abs()).sum();
        let places: Vec<(usize, f64)> = sum.iter().map(|(own, factor)| (own.place, *factor)).collect();
        self.record.as_ref().and_then(|record| record.error(&places)).map_or(running, |own| own.min(running))
    }
}

/// One run of a routine and of those that it calls.
struct Run<'m, 'a> {
    routines: &'m [Resolved<'a>],
    steps: usize,
    record: &'m mut Option<Record>,
}

/// The variables and arrays of a running routine.
struct Variables {
    numbers: Vec<Traced>,
    arrays: Vec<Vec<Traced>>,
}

impl Variables {
    fn element(&mut self, array: usize, index: Traced) -> Option<&mut Traced> {
        self.arrays.get_mut(array)?.get_mut(index.bounded.value as usize)
    }

    fn set(&mut self, place: usize, value: Traced) -> Option<()> {
        *self.numbers.get_mut(place)? = value;
        Some(())
    }
}

impl<'m, 'a> Run<'m, 'a> {
    #[inline]
    fn leaf(&mut self, bounded: Bounded) -> Traced {
        let place = self.record.as_mut().map_or(0, |record| record.leaf(bounded));
        Traced { bounded, place }
    }

    #[inline]
    fn operation(
        &mut self,
        operation: Operation<'_>,
        operands: &[Traced],
        bounded: Bounded,
        own: impl Fn(&[Bounded]) -> Bounded,
    ) -> Traced {
        work::spend(if self.record.is_some() { RECORDED } else { PLAIN_OPERATION });
        let Some(record) = &mut *self.record else { return Traced { bounded, place: 0 } };
        let pair = |operand: &Traced| (operand.place, operand.bounded);
        let place = match operands {
            [a] => record.operation(operation, &[pair(a)], bounded, own),
            [a, b] => record.operation(operation, &[pair(a), pair(b)], bounded, own),
            more => record.operation(operation, &more.iter().map(pair).collect::<Vec<_>>(), bounded, own),
        };
        Traced { bounded, place }
    }

    fn routine(&mut self, routine: &'m Resolved<'a>, arguments: &[Traced]) -> Option<Traced> {
        // A table is read at one place instead of copied.
        if let (Some(table), [index]) = (routine.table, arguments) {
            let value = *table.get(index.bounded.value as usize)?;
            return Some(self.leaf(Bounded::rounded(value)));
        }
        let mut numbers = vec![Traced { bounded: Bounded::exact(f64::NAN), place: 0 }; routine.numbers];
        numbers.iter_mut().zip(arguments).for_each(|(own, argument)| *own = *argument);
        let mut variables = Variables { numbers, arrays: vec![Vec::new(); routine.arrays] };
        self.block(&routine.body, &mut variables)?
    }

    /// Runs statements; `Some(None)` where none of them returned.
    fn block(&mut self, list: &'m [Step<'a>], variables: &mut Variables) -> Option<Option<Traced>> {
        for own in list {
            if let Some(done) = self.step(own, variables)? {
                return Some(Some(done));
            }
        }
        Some(None)
    }

    fn step(&mut self, step: &'m Step<'a>, variables: &mut Variables) -> Option<Option<Traced>> {
        self.steps += 1;
        if self.steps > MOST_STEPS {
            return None;
        }
        match step {
            Step::Set(place, value) => {
                let value = self.value(value, variables)?;
                variables.set(*place, value)?;
            }
            Step::Array(place) => {
                let zero = self.leaf(Bounded::exact(0.0));
                *variables.arrays.get_mut(*place)? = vec![zero; LENGTH];
            }
            Step::Table(place, values) => {
                *variables.arrays.get_mut(*place)? = values.iter().map(|own| self.leaf(Bounded::rounded(*own))).collect();
            }
            Step::SetElement(array, index, value) => {
                let (index, value) = (self.value(index, variables)?, self.value(value, variables)?);
                *variables.element(*array, index)? = value;
            }
            Step::Return(value) => return Some(Some(self.value(value, variables)?)),
            Step::If(test, yes, no) => {
                let taken = if self.test(test, variables)? { yes } else { no };
                return self.block(taken, variables);
            }
            Step::While(test, body) => {
                while self.test(test, variables)? {
                    self.steps += 1;
                    if let Some(done) = self.block(body, variables)? {
                        return Some(Some(done));
                    }
                }
            }
            Step::Accumulate(own, _) if self.record.is_none() => self.accumulated(own, variables)?,
            Step::Accumulate(_, steps) => {
                for own in steps {
                    self.step(own, variables)?;
                }
            }
        }
        Some(None)
    }

    /// Adds a term to a compensated sum: the error of the sum counts with the rest, which contains its roundings.
    fn accumulated(&mut self, own: &'m Accumulation<'a>, variables: &mut Variables) -> Option<()> {
        let (sum, rest) = (variables.numbers.get(own.sum)?.bounded, variables.numbers.get(own.rest)?.bounded);
        let term = self.value(&own.term, variables)?.bounded;
        let next = Bounded::exact(sum.value) + Bounded::exact(term.value);
        let lost = (sum.value - next.value) + term.value;
        // The rounding error of the sum, up to the sign, which the rest contains as far as it is computed exactly.
        let missed = (next.error - lost.abs()).abs();
        let total = rest + Bounded::exact(lost);
        let total = Bounded::checked(total.value, total.error + sum.error + term.error + missed);
        let next = Bounded::exact(next.value);
        for (place, value) in [(own.total, next), (own.rest, total), (own.sum, next)] {
            let value = self.leaf(value);
            variables.set(place, value)?;
        }
        Some(())
    }

    fn test(&mut self, test: &'m Condition<'a>, variables: &mut Variables) -> Option<bool> {
        Some(match test {
            Condition::Compare(comparison, left, right) => {
                let (left, right) = (self.value(left, variables)?.bounded.value, self.value(right, variables)?.bounded.value);
                match comparison {
                    Comparison::Less => left < right,
                    Comparison::LessOrEqual => left <= right,
                    Comparison::Greater => left > right,
                    Comparison::GreaterOrEqual => left >= right,
                    Comparison::Equal => left == right,
                }
            }
            Condition::All(list) => {
                for own in list {
                    if !self.test(own, variables)? {
                        return Some(false);
                    }
                }
                true
            }
            Condition::Any(list) => {
                for own in list {
                    if self.test(own, variables)? {
                        return Some(true);
                    }
                }
                false
            }
            Condition::Not(own) => !self.test(own, variables)?,
        })
    }

    fn value(&mut self, value: &'m Code<'a>, variables: &mut Variables) -> Option<Traced> {
        Some(match value {
            Code::Number(number) => self.leaf(*number),
            Code::Variable(place) => *variables.numbers.get(*place)?,
            Code::Element(array, index) => {
                let index = self.value(index, variables)?;
                *variables.element(*array, index)?
            }
            Code::Binary(operator, operands) => {
                let [left, right] = self.pair(operands, variables)?;
                let bounded = binary(*operator, left.bounded, right.bounded);
                self.operation(Operation::Binary(*operator), &[left, right], bounded, |own| match own {
                    [left, right] => binary(*operator, *left, *right),
                    _ => bounded,
                })
            }
            Code::Larger(operands) => {
                let [a, b] = self.pair(operands, variables)?;
                if a.bounded.value >= b.bounded.value { a } else { b }
            }
            Code::Smaller(operands) => {
                let [a, b] = self.pair(operands, variables)?;
                if a.bounded.value <= b.bounded.value { a } else { b }
            }
            Code::Routine(index, arguments) => {
                let routine = self.routines.get(*index)?;
                return match arguments.as_slice() {
                    [only] => {
                        let only = self.value(only, variables)?;
                        self.routine(routine, &[only])
                    }
                    more => {
                        let arguments = self.list(more, variables)?;
                        self.routine(routine, &arguments)
                    }
                };
            }
            Code::Known(operation, known, arguments) => match arguments.as_slice() {
                [only] => {
                    let only = self.value(only, variables)?;
                    self.known(*operation, *known, &[only], &[only.bounded])?
                }
                more => {
                    let arguments = self.list(more, variables)?;
                    let numbers: Vec<Bounded> = arguments.iter().map(|own| own.bounded).collect();
                    self.known(*operation, *known, &arguments, &numbers)?
                }
            },
            Code::Unknown => return None,
        })
    }

    fn known(&mut self, operation: Operation<'_>, known: Known, arguments: &[Traced], numbers: &[Bounded]) -> Option<Traced> {
        let bounded = known.at(numbers)?;
        Some(self.operation(operation, arguments, bounded, |own| known.at(own).unwrap_or(bounded)))
    }

    #[inline]
    fn pair(&mut self, [left, right]: &'m [Code<'a>; 2], variables: &mut Variables) -> Option<[Traced; 2]> {
        Some([self.value(left, variables)?, self.value(right, variables)?])
    }

    fn list(&mut self, values: &'m [Code<'a>], variables: &mut Variables) -> Option<Vec<Traced>> {
        values.iter().map(|own| self.value(own, variables)).collect()
    }
}
