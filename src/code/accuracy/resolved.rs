//! Routines whose names are resolved to places, so that running them again and again compares no names.

use super::first_order::Operation;
use super::operations::Known;
use crate::code::tree::{Comparison, Operator, Routine, Statement, Test, Value};
use crate::num::Bounded;

/// A routine with its variables in numbered places, the parameters first.
pub(super) struct Resolved<'a> {
    pub(super) numbers: usize,
    pub(super) arrays: usize,
    pub(super) body: Vec<Step<'a>>,
    /// The numbers of a routine that returns an element of a table.
    pub(super) table: Option<&'a [f64]>,
}

/// A statement.
pub(super) enum Step<'a> {
    Set(usize, Code<'a>),
    /// A new array of zeros.
    Array(usize),
    Table(usize, &'a [f64]),
    SetElement(usize, Code<'a>, Code<'a>),
    If(Condition<'a>, Vec<Step<'a>>, Vec<Step<'a>>),
    While(Condition<'a>, Vec<Step<'a>>),
    Return(Code<'a>),
    /// The three statements of a compensated sum.
    Accumulate(Accumulation<'a>, [Box<Step<'a>>; 3]),
}

/// A number that is computed.
pub(super) enum Code<'a> {
    Number(Bounded),
    Variable(usize),
    Element(usize, Box<Code<'a>>),
    Binary(Operator, Box<[Code<'a>; 2]>),
    Larger(Box<[Code<'a>; 2]>),
    Smaller(Box<[Code<'a>; 2]>),
    /// A routine by its index.
    Routine(usize, Vec<Code<'a>>),
    Known(Operation<'a>, Known, Vec<Code<'a>>),
    /// A name that is not defined.
    Unknown,
}

/// A condition.
pub(super) enum Condition<'a> {
    Compare(Comparison, Code<'a>, Code<'a>),
    All(Vec<Condition<'a>>),
    Any(Vec<Condition<'a>>),
    Not(Box<Condition<'a>>),
}

/// `total = sum + term; rest = rest + ((sum - total) + term); sum = total`.
pub(super) struct Accumulation<'a> {
    pub(super) total: usize,
    pub(super) rest: usize,
    pub(super) sum: usize,
    pub(super) term: Code<'a>,
}

/// Resolves the names of all routines; `library` gives the assumed accuracy of functions of the language's library.
pub(super) fn resolved<'a>(routines: &'a [Routine], library: &dyn Fn(&str) -> Option<f64>) -> Vec<Resolved<'a>> {
    let one = |routine: &'a Routine| {
        let numbers = routine.parameters.iter().map(String::as_str).collect();
        let mut names = Names { routines, library, numbers, arrays: Vec::new() };
        let body = names.block(&routine.body);
        let table = match routine.body.as_slice() {
            [Statement::Table(_, values), Statement::Return(Value::Element(..))] if routine.parameters.len() == 1 => {
                Some(values.as_slice())
            }
            _ => None,
        };
        Resolved { numbers: names.numbers.len(), arrays: names.arrays.len(), body, table }
    };
    routines.iter().map(one).collect()
}

/// The names of a routine by their places.
struct Names<'a, 'l> {
    routines: &'a [Routine],
    library: &'l dyn Fn(&str) -> Option<f64>,
    numbers: Vec<&'a str>,
    arrays: Vec<&'a str>,
}

/// The place of a name, which is added if it is new.
fn place<'a>(names: &mut Vec<&'a str>, name: &'a str) -> usize {
    names.iter().position(|own| *own == name).unwrap_or_else(|| {
        names.push(name);
        names.len() - 1
    })
}

impl<'a> Names<'a, '_> {
    fn block(&mut self, mut list: &'a [Statement]) -> Vec<Step<'a>> {
        let mut steps = Vec::new();
        while let [own, rest @ ..] = list {
            if let [first, second, third, more @ ..] = list
                && let Some(sum) = self.accumulation([first, second, third])
            {
                steps.push(Step::Accumulate(sum, [first, second, third].map(|own| Box::new(self.step(own)))));
                list = more;
            } else {
                steps.push(self.step(own));
                list = rest;
            }
        }
        steps
    }

    fn step(&mut self, own: &'a Statement) -> Step<'a> {
        match own {
            Statement::Let(name, value) | Statement::Set(name, value) => {
                let value = self.value(value);
                Step::Set(place(&mut self.numbers, name), value)
            }
            Statement::Array(name) => Step::Array(place(&mut self.arrays, name)),
            Statement::Table(name, values) => Step::Table(place(&mut self.arrays, name), values),
            Statement::SetElement(name, index, value) => {
                let (index, value) = (self.value(index), self.value(value));
                Step::SetElement(place(&mut self.arrays, name), index, value)
            }
            Statement::If(test, yes, no) => Step::If(self.test(test), self.block(yes), self.block(no)),
            Statement::While(test, body) => Step::While(self.test(test), self.block(body)),
            Statement::Return(value) => Step::Return(self.value(value)),
        }
    }

    fn test(&mut self, test: &'a Test) -> Condition<'a> {
        match test {
            Test::Compare(comparison, left, right) => Condition::Compare(*comparison, self.value(left), self.value(right)),
            Test::All(list) => Condition::All(list.iter().map(|own| self.test(own)).collect()),
            Test::Any(list) => Condition::Any(list.iter().map(|own| self.test(own)).collect()),
            Test::Not(own) => Condition::Not(Box::new(self.test(own))),
        }
    }

    fn value(&mut self, value: &'a Value) -> Code<'a> {
        match value {
            Value::Number(number, true) => Code::Number(Bounded::exact(*number)),
            Value::Number(number, false) => Code::Number(Bounded::rounded(*number)),
            Value::Name(name) => self.numbers.iter().position(|own| own == name).map_or(Code::Unknown, Code::Variable),
            Value::Element(name, index) => {
                let array = self.arrays.iter().position(|own| own == name);
                array.map_or(Code::Unknown, |array| Code::Element(array, Box::new(self.value(index))))
            }
            Value::Binary(operator, left, right) => Code::Binary(*operator, Box::new([self.value(left), self.value(right)])),
            Value::Call(name, arguments) => {
                if let Some(index) = self.routines.iter().position(|own| own.name == *name) {
                    return Code::Routine(index, arguments.iter().map(|own| self.value(own)).collect());
                }
                match (name.as_str(), arguments.as_slice()) {
                    ("max", [a, b]) => Code::Larger(Box::new([self.value(a), self.value(b)])),
                    ("min", [a, b]) => Code::Smaller(Box::new([self.value(a), self.value(b)])),
                    _ => match Known::named(name, self.library) {
                        Some(known) => Code::Known(Operation::call(name), known, arguments.iter().map(|own| self.value(own)).collect()),
                        None => Code::Unknown,
                    },
                }
            }
        }
    }

    fn accumulation(&mut self, statements: [&'a Statement; 3]) -> Option<Accumulation<'a>> {
        let [
            Statement::Let(total, Value::Binary(Operator::Add, sum, term)) | Statement::Set(total, Value::Binary(Operator::Add, sum, term)),
            Statement::Set(rest, Value::Binary(Operator::Add, old_rest, lost)),
            Statement::Set(sum_name, Value::Name(last)),
        ] = statements
        else {
            return None;
        };
        let Value::Binary(Operator::Add, less, again) = &**lost else { return None };
        let Value::Binary(Operator::Subtract, before, after) = &**less else { return None };
        let is = |value: &Value, name: &str| matches!(value, Value::Name(own) if own == name);
        let fits = is(sum, sum_name) && is(old_rest, rest) && is(before, sum_name) && is(after, total) && last == total;
        if !(fits && again == term && matches!(**term, Value::Name(_))) {
            return None;
        }
        let mut at = |name: &'a str| place(&mut self.numbers, name);
        let (total, rest, sum) = (at(total), at(rest), at(sum_name));
        Some(Accumulation { total, rest, sum, term: self.value(term) })
    }
}
