//! How accurate a program is: its routines run with an error bound that grows with every operation.

mod first_order;

use super::tree::{Comparison, LENGTH, NAN, Operator, Routine, Statement, Test, Value};
use crate::expr::Function;
use crate::num::{Bounded, work};
use first_order::{Operation, Record};

/// Assumed errors of elementary functions in units in the last place: the largest known errors of the GNU C library in double
/// precision (`sysdeps/x86_64/fpu/libm-test-ulps`).
const ELEMENTARY_ULPS: f64 = 1.0;
/// Assumed errors of hyperbolic functions and their inverses, from the same table.
const HYPERBOLIC_ULPS: f64 = 2.0;
/// The assumptions as stated in generated files.
pub(super) const ASSUMED: &str = "elementary functions accurate to 1 ulp and hyperbolic ones to 2 ulp";

/// Steps of work for an operation, with its names and numbers, and for one that is recorded.
const PLAIN_OPERATION: u64 = 6;
const RECORDED: u64 = 12;
/// The most operations of one run.
const MOST_STEPS: usize = 400_000;

/// The functions that every language has.
pub(super) const ELEMENTARY: [&str; 24] = [
    "sqrt", "exp", "log", "log1p", "expm1", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "asinh", "atanh",
    "abs", "max", "min", "pow", "floor", NAN, "inf",
];

/// Runs routines; `library` gives the assumed accuracy of functions of the language's library.
pub(super) struct Machine<'a> {
    routines: &'a [Routine],
    library: &'a dyn Fn(&str) -> Option<f64>,
    steps: usize,
    record: Option<Record<'a>>,
}

/// A result with its running bound, and its place in the record.
#[derive(Clone, Copy, Debug)]
pub(super) struct Traced {
    pub(super) bounded: Bounded,
    place: usize,
}

/// The variables and arrays of a running routine; there are too few for a map to pay off.
struct Variables<'a> {
    numbers: Vec<(&'a str, Traced)>,
    arrays: Vec<(&'a str, Vec<Traced>)>,
}

/// Whether two names are equal; those of variables differ in their last digits, which are compared first.
fn same(one: &str, other: &str) -> bool {
    let (one, other) = (one.as_bytes(), other.as_bytes());
    one.len() == other.len() && one.last() == other.last() && one == other
}

impl<'a> Variables<'a> {
    fn set(&mut self, name: &'a str, value: Traced) {
        match self.numbers.iter_mut().rev().find(|(own, _)| same(own, name)) {
            Some((_, old)) => *old = value,
            None => self.numbers.push((name, value)),
        }
    }

    fn element(&mut self, name: &str, index: Traced) -> Option<&mut Traced> {
        let (_, own) = self.arrays.iter_mut().find(|(own, _)| same(own, name))?;
        own.get_mut(index.bounded.value as usize)
    }
}

impl<'a> Machine<'a> {
    pub(super) fn new(routines: &'a [Routine], library: &'a dyn Fn(&str) -> Option<f64>) -> Self {
        Self { routines, library, steps: 0, record: None }
    }

    /// The value of a routine at exact arguments, with its running bound; `None` if it does not end or calls what is unknown.
    pub(super) fn traced(&mut self, name: &str, arguments: &[f64]) -> Option<Traced> {
        self.steps = 0;
        let arguments = arguments.iter().map(|own| self.leaf(Bounded::exact(*own))).collect();
        self.routine(name, arguments)
    }

    /// Starts a new record: the operations of all runs from here on belong to it.
    pub(super) fn start_record(&mut self) {
        self.record = Some(Record::default());
    }

    /// A bound on the error of the sum of results times factors: the sum of running bounds, or that to first order if there is a
    /// record and it is smaller.
    pub(super) fn error(&self, sum: &[(Traced, f64)]) -> f64 {
        let running = sum.iter().map(|(own, factor)| own.bounded.error * factor.abs()).sum();
        let places: Vec<(usize, f64)> = sum.iter().map(|(own, factor)| (own.place, *factor)).collect();
        self.record.as_ref().and_then(|record| record.error(&places)).map_or(running, |own| own.min(running))
    }

    fn leaf(&mut self, bounded: Bounded) -> Traced {
        let place = self.record.as_mut().map_or(0, |record| record.leaf(bounded));
        Traced { bounded, place }
    }

    fn operation(
        &mut self,
        operation: Operation<'a>,
        operands: &[Traced],
        bounded: Bounded,
        own: impl Fn(&[Bounded]) -> Bounded,
    ) -> Traced {
        work::spend(if self.record.is_some() { RECORDED } else { PLAIN_OPERATION });
        let Some(record) = &mut self.record else { return Traced { bounded, place: 0 } };
        let pair = |operand: &Traced| (operand.place, operand.bounded);
        let place = match operands {
            [a] => record.operation(operation, &[pair(a)], bounded, own),
            [a, b] => record.operation(operation, &[pair(a), pair(b)], bounded, own),
            more => record.operation(operation, &more.iter().map(pair).collect::<Vec<_>>(), bounded, own),
        };
        Traced { bounded, place }
    }

    fn routine(&mut self, name: &str, arguments: Vec<Traced>) -> Option<Traced> {
        let routine = self.routines.iter().find(|own| own.name == name)?;
        // A table is read at one place instead of copied.
        if let ([Statement::Table(_, values), Statement::Return(Value::Element(..))], [index]) =
            (routine.body.as_slice(), arguments.as_slice())
        {
            let value = *values.get(index.bounded.value as usize)?;
            return Some(self.leaf(Bounded::rounded(value)));
        }
        let numbers = routine.parameters.iter().map(String::as_str).zip(arguments).collect();
        let mut variables = Variables { numbers, arrays: Vec::new() };
        self.block(&routine.body, &mut variables)?
    }

    /// Runs statements; `Some(None)` where none of them returned.
    fn block(&mut self, list: &'a [Statement], variables: &mut Variables<'a>) -> Option<Option<Traced>> {
        let mut rest = list;
        while let [own, more @ ..] = rest {
            self.steps += 1;
            if self.steps > MOST_STEPS {
                return None;
            }
            if let ([first, second, third, more @ ..], true) = (rest, self.record.is_none())
                && let Some(accumulation) = Accumulation::of([first, second, third])
            {
                self.accumulated(&accumulation, variables)?;
                rest = more;
                continue;
            }
            rest = more;
            let done = match own {
                Statement::Let(name, value) | Statement::Set(name, value) => {
                    let value = self.value(value, variables)?;
                    variables.set(name, value);
                    None
                }
                Statement::Array(name) => {
                    let zero = self.leaf(Bounded::exact(0.0));
                    variables.arrays.push((name, vec![zero; LENGTH]));
                    None
                }
                Statement::Table(name, values) => {
                    let values = values.iter().map(|own| self.leaf(Bounded::rounded(*own))).collect();
                    variables.arrays.push((name, values));
                    None
                }
                Statement::SetElement(name, index, value) => {
                    let (index, value) = (self.value(index, variables)?, self.value(value, variables)?);
                    *variables.element(name, index)? = value;
                    None
                }
                Statement::Return(value) => Some(self.value(value, variables)?),
                Statement::If(test, yes, no) => {
                    let taken = if self.test(test, variables)? { yes } else { no };
                    self.block(taken, variables)?
                }
                Statement::While(test, body) => {
                    let mut done = None;
                    while done.is_none() && self.test(test, variables)? {
                        self.steps += 1;
                        done = self.block(body, variables)?;
                    }
                    done
                }
            };
            if done.is_some() {
                return Some(done);
            }
        }
        Some(None)
    }

    /// Adds a term to a compensated sum: the error of the sum counts with the rest, which contains its roundings.
    fn accumulated(&mut self, own: &Accumulation<'a>, variables: &mut Variables<'a>) -> Option<()> {
        let (sum, rest) = (self.value(own.sum, variables)?.bounded, self.value(own.rest, variables)?.bounded);
        let term = self.value(own.term, variables)?.bounded;
        let next = Bounded::exact(sum.value) + Bounded::exact(term.value);
        let lost = (sum.value - next.value) + term.value;
        // The rounding error of the sum, up to the sign, which the rest contains as far as it is computed exactly.
        let missed = (next.error - lost.abs()).abs();
        let total = rest + Bounded::exact(lost);
        let total = Bounded::checked(total.value, total.error + sum.error + term.error + missed);
        let set = |name: &'a str, value: Bounded, machine: &mut Self, variables: &mut Variables<'a>| {
            let own = machine.leaf(value);
            variables.set(name, own);
        };
        set(own.total_name, Bounded::exact(next.value), self, variables);
        set(own.rest_name, total, self, variables);
        set(own.sum_name, Bounded::exact(next.value), self, variables);
        Some(())
    }

    fn test(&mut self, test: &'a Test, variables: &mut Variables<'a>) -> Option<bool> {
        Some(match test {
            Test::Compare(comparison, left, right) => {
                let (left, right) = (self.value(left, variables)?.bounded.value, self.value(right, variables)?.bounded.value);
                match comparison {
                    Comparison::Less => left < right,
                    Comparison::LessOrEqual => left <= right,
                    Comparison::Greater => left > right,
                    Comparison::GreaterOrEqual => left >= right,
                    Comparison::Equal => left == right,
                }
            }
            Test::All(list) => {
                for own in list {
                    if !self.test(own, variables)? {
                        return Some(false);
                    }
                }
                true
            }
            Test::Any(list) => {
                for own in list {
                    if self.test(own, variables)? {
                        return Some(true);
                    }
                }
                false
            }
            Test::Not(own) => !self.test(own, variables)?,
        })
    }

    fn value(&mut self, value: &'a Value, variables: &mut Variables<'a>) -> Option<Traced> {
        Some(match value {
            Value::Number(number, true) => self.leaf(Bounded::exact(*number)),
            Value::Number(number, false) => self.leaf(Bounded::rounded(*number)),
            Value::Name(name) => variables.numbers.iter().rev().find(|(own, _)| same(own, name))?.1,
            Value::Element(name, index) => {
                let index = self.value(index, variables)?;
                *variables.element(name, index)?
            }
            Value::Binary(operator, left, right) => {
                let (left, right) = (self.value(left, variables)?, self.value(right, variables)?);
                let bounded = binary(*operator, left.bounded, right.bounded);
                self.operation(Operation::Binary(*operator), &[left, right], bounded, |own| match own {
                    [left, right] => binary(*operator, *left, *right),
                    _ => bounded,
                })
            }
            Value::Call(name, arguments) => {
                let arguments = arguments.iter().map(|own| self.value(own, variables)).collect::<Option<Vec<_>>>()?;
                if self.routines.iter().any(|own| own.name == *name) {
                    return self.routine(name, arguments);
                }
                match (name.as_str(), arguments.as_slice()) {
                    ("max", [a, b]) => return Some(if a.bounded.value >= b.bounded.value { *a } else { *b }),
                    ("min", [a, b]) => return Some(if a.bounded.value <= b.bounded.value { *a } else { *b }),
                    _ => {}
                }
                let numbers: Vec<Bounded> = arguments.iter().map(|own| own.bounded).collect();
                let library = self.library;
                let bounded = function(library, name, &numbers)?;
                self.operation(Operation::Call(name), &arguments, bounded, |own| function(library, name, own).unwrap_or(bounded))
            }
        })
    }
}

/// The three statements of a compensated sum: `total = sum + term; rest = rest + ((sum - total) + term); sum = total`.
struct Accumulation<'a> {
    total_name: &'a str,
    rest_name: &'a str,
    sum_name: &'a str,
    sum: &'a Value,
    rest: &'a Value,
    term: &'a Value,
}

impl<'a> Accumulation<'a> {
    fn of(statements: [&'a Statement; 3]) -> Option<Self> {
        let [
            Statement::Let(total_name, Value::Binary(Operator::Add, sum, term))
            | Statement::Set(total_name, Value::Binary(Operator::Add, sum, term)),
            Statement::Set(rest_name, Value::Binary(Operator::Add, rest, lost)),
            Statement::Set(sum_name, Value::Name(last)),
        ] = statements
        else {
            return None;
        };
        let Value::Binary(Operator::Add, less, again) = &**lost else { return None };
        let Value::Binary(Operator::Subtract, before, total) = &**less else { return None };
        let is = |value: &Value, name: &str| matches!(value, Value::Name(own) if own == name);
        let fits = is(sum, sum_name) && is(rest, rest_name) && is(before, sum_name) && is(total, total_name) && last == total_name;
        (fits && again == term && matches!(**term, Value::Name(_))).then_some(Self { total_name, rest_name, sum_name, sum, rest, term })
    }
}

fn binary(operator: Operator, left: Bounded, right: Bounded) -> Bounded {
    match operator {
        Operator::Add => left + right,
        Operator::Subtract => left - right,
        Operator::Multiply => product(left, right),
        Operator::Divide => quotient(left, right),
    }
}

/// The value of a function of the language or of its library.
fn function(library: &dyn Fn(&str) -> Option<f64>, name: &str, arguments: &[Bounded]) -> Option<Bounded> {
    let elementary: Option<fn(f64) -> f64> = match name {
        "exp" => Some(f64::exp),
        "log" => Some(f64::ln),
        "log1p" => Some(f64::ln_1p),
        "expm1" => Some(f64::exp_m1),
        "sin" => Some(f64::sin),
        "cos" => Some(f64::cos),
        "tan" => Some(f64::tan),
        "asin" => Some(f64::asin),
        "acos" => Some(f64::acos),
        "atan" => Some(f64::atan),
        "sinh" => Some(f64::sinh),
        "cosh" => Some(f64::cosh),
        "tanh" => Some(f64::tanh),
        "asinh" => Some(f64::asinh),
        "atanh" => Some(f64::atanh),
        _ => None,
    };
    match (name, arguments) {
        ("sqrt", [a]) => Some(root(*a)),
        // One unit is counted by the power itself.
        ("pow", [a, b]) => Some(a.powf(*b).apply(|z| z, ELEMENTARY_ULPS - 1.0)),
        ("abs", [a]) => Some(Bounded { value: a.value.abs(), error: a.error }),
        ("floor", [a]) => Some(Bounded::exact(a.value.floor())),
        (NAN, []) => Some(Bounded::exact(f64::NAN)),
        ("inf", []) => Some(Bounded::exact(f64::INFINITY)),
        ("atan2", [a, b]) => Some(arctangent(*a, *b)),
        ("sinh" | "cosh" | "tanh" | "asinh" | "atanh", [a]) => elementary.map(|f| a.apply(f, HYPERBOLIC_ULPS)),
        (_, [a]) if elementary.is_some() => elementary.map(|f| a.apply(f, ELEMENTARY_ULPS)),
        _ => {
            let (row, ulps) = (Function::named(name)?.row(), library(name)?);
            Some(match arguments {
                [only] => only.apply(|z| (row.value)(&[z]), row.ulps() + ulps),
                _ => Bounded::apply_many(row.value, arguments, row.ulps() + ulps),
            })
        }
    }
}

/// Magnitudes of results whose rounding errors are computed exactly by a fused multiply-add.
const PLAIN: std::ops::Range<f64> = 1e-250..1e250;

/// Multiplies with the actual rounding error instead of half a unit; exact products, as of small whole numbers, have none.
fn product(a: Bounded, b: Bounded) -> Bounded {
    let whole = a * b;
    let rest = a.value.mul_add(b.value, -whole.value).abs();
    let carried = a.value.abs() * b.error + b.value.abs() * a.error + a.error * b.error;
    let own = Bounded::checked(whole.value, (carried + rest) * (1.0 + 4.0 * f64::EPSILON));
    if PLAIN.contains(&whole.value.abs()) && own.error < whole.error { own } else { whole }
}

/// Divides with the actual rounding error instead of half a unit.
fn quotient(a: Bounded, b: Bounded) -> Bounded {
    let whole = a / b;
    let rest = whole.value.mul_add(-b.value, a.value).abs();
    let carried = (a.error + whole.value.abs() * b.error + rest) / (b.value.abs() - b.error);
    let own = Bounded::checked(whole.value, carried * (1.0 + 4.0 * f64::EPSILON));
    if b.error < b.value.abs() && PLAIN.contains(&whole.value.abs()) && own.error < whole.error { own } else { whole }
}

/// A square root with the actual rounding error instead of half a unit.
fn root(a: Bounded) -> Bounded {
    let whole = a.sqrt();
    let rest = (0.5 * whole.value.mul_add(-whole.value, a.value) / whole.value).abs();
    let carried = 0.5 * a.error / (whole.value * (1.0 - a.error / a.value));
    let own = Bounded::checked(whole.value, (carried + rest) * (1.0 + 4.0 * f64::EPSILON));
    if a.error < 0.5 * a.value && PLAIN.contains(&a.value) && own.error < whole.error { own } else { whole }
}

/// The angle of the point (b, a): it moves by at most the angle of the arguments' errors.
fn arctangent(a: Bounded, b: Bounded) -> Bounded {
    let value = a.value.atan2(b.value);
    let size = a.value.hypot(b.value);
    let carried = (a.error * b.value.abs() + b.error * a.value.abs()) / (size * size) * 1.01;
    let own = Bounded::exact(value).apply(|z| z, ELEMENTARY_ULPS);
    Bounded::checked(value, own.error + if a.error == 0.0 && b.error == 0.0 { 0.0 } else { carried })
}
