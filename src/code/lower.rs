//! From an expression to statements: the walk of the evaluation, written down; equal parts become one variable.

mod beta;
mod elliptic;
mod equal;
mod limits;

use super::tree::{Operator, Statement, Value};
use crate::eval::{Algebra, EvalError, PreciseAlgebra, walk};
use crate::expr::{Expr, Function};
use crate::num::{DoubleDouble, Precise};
use std::collections::{BTreeMap, HashMap};

/// The identifiers of the symbols.
pub(super) type Names = BTreeMap<String, String>;

/// Functions of the table and the routines that compute them for the orders 0 and 1.
const OF_ORDERS_0_AND_1: [(&str, &str); 5] = [
    ("besselj", "bessel_j"),
    ("struveh", "struve_h"),
    ("besseli_scaled", "bessel_i_scaled"),
    ("struvel", "struve_l"),
    ("bessel_struve", "bessel_i_less_struve"),
];

/// A value with more operations than this becomes a variable.
const LONG: usize = 12;

/// The statements that compute an expression, and its value; `counter` numbers the variables.
pub(super) fn lowered(expr: &Expr, names: &Names, counter: &mut usize) -> Result<(Vec<Statement>, Value), EvalError> {
    let mut recorder = Recorder::default();
    let mut inputs: Vec<String> = Vec::new();
    let root = {
        // The walk borrows the recorder and the names of inputs by turns.
        let mut known: HashMap<String, u32> = HashMap::new();
        for symbol in expr.symbols() {
            let Some(name) = names.get(symbol.name()) else { continue };
            let slot = recorder.push(Step::Input(inputs.len()));
            inputs.push(name.clone());
            known.insert(symbol.name().to_owned(), slot);
        }
        walk(expr, &mut recorder, &mut |symbol| known.get(symbol.name()).copied())?
    };
    Ok(recorder.statements(root, &inputs, counter))
}

/// A recorded operation; equal ones are recorded once.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Step {
    /// The bits of the nearest double, of the rest, and of the error.
    Constant(u64, u64, u64),
    Input(usize),
    Binary(Operator, u32, u32),
    Call(&'static str, Vec<u32>),
}

#[derive(Default)]
struct Recorder {
    steps: Vec<Step>,
    places: HashMap<Step, u32>,
}

impl Recorder {
    fn push(&mut self, step: Step) -> u32 {
        if let Some(place) = self.places.get(&step) {
            return *place;
        }
        let place = u32::try_from(self.steps.len()).unwrap_or(u32::MAX);
        self.steps.push(step.clone());
        self.places.insert(step, place);
        place
    }

    fn known(&self, place: u32) -> Option<Precise> {
        match self.steps.get(place as usize)? {
            Step::Constant(hi, lo, error) => {
                Some(Precise { value: DoubleDouble { hi: f64::from_bits(*hi), lo: f64::from_bits(*lo) }, error: f64::from_bits(*error) })
            }
            _ => None,
        }
    }

    /// Whether a value is a constant that is exactly this number.
    fn is(&self, place: u32, value: f64) -> bool {
        self.known(place).is_some_and(|known| known.value.hi == value && known.value.lo == 0.0)
    }

    /// The constant that an operation on constants gives, where its 30 digits are good ones.
    fn folded(&mut self, operands: &[u32], compute: impl Fn(&[Precise]) -> Precise) -> Option<u32> {
        let known = operands.iter().map(|own| self.known(*own)).collect::<Option<Vec<_>>>()?;
        let value = compute(&known);
        (value.is_finite() && value.error <= 1e-20 * value.value.hi.abs()).then(|| self.constant(value))
    }

    fn binary(&mut self, operator: Operator, a: u32, b: u32) -> u32 {
        let compute = |own: &[Precise]| match (own, &mut PreciseAlgebra) {
            ([a, b], algebra) => match operator {
                Operator::Add => algebra.add(*a, *b),
                Operator::Subtract => algebra.subtract(*a, *b),
                Operator::Multiply => algebra.multiply(*a, *b),
                Operator::Divide => algebra.divide(*a, *b),
            },
            _ => Precise::nan(),
        };
        self.folded(&[a, b], compute).unwrap_or_else(|| self.push(Step::Binary(operator, a, b)))
    }

    fn number(&mut self, value: f64) -> u32 {
        self.constant(Precise::exact(value))
    }

    fn named(&mut self, name: &'static str, arguments: &[u32]) -> u32 {
        self.push(Step::Call(name, arguments.to_vec()))
    }

    /// The routines and functions that a function of the table is written with.
    fn written(&mut self, name: &'static str, arguments: &[u32]) -> u32 {
        let is = |own: u32, value: f64| self.is(own, value);
        let whole = |own: u32| self.known(own).is_some_and(|n| n.value.lo == 0.0 && n.value.hi.fract() == 0.0 && n.value.hi >= 0.0);
        match (name, arguments) {
            ("ln", _) => self.named("log", arguments),
            ("shifted_power_between", [k, b, c, x]) if is(*k, 0.0) => self.named("angle_between", &[*b, *c, *x]),
            ("shifted_power_between", [k, b, c, x]) if is(*k, 1.0) && is(*b, 0.0) => self.named("linear_to", &[*c, *x]),
            ("shifted_power_force_between", [k, b, c, x]) if is(*k, 0.0) => self.named("angle_between_force", &[*b, *c, *x]),
            ("shifted_power_force_between", [k, b, c, x]) if is(*k, 1.0) && is(*b, 0.0) => self.named("cubic_to", &[*c, *x]),
            ("pressure_power", [n, ..]) if !whole(*n) => self.named("pressure_power_real", arguments),
            ("hyp2f1", [a, b, c, z]) if is(*a, 1.0) || is(*a, 2.0) => self.named("hyp2f1_of_whole", &[*b, *a, *c, *z]),
            ("hyp2f1", [_, b, ..]) if is(*b, 1.0) || is(*b, 2.0) => self.named("hyp2f1_of_whole", arguments),
            ("betainc", [a, b, start, end]) if is(*start, 0.0) => beta::from_zero(self, *a, *b, *end),
            ("ellipe", [_, _]) => self.named("ellipe_incomplete", arguments),
            ("fresnelc", [z]) => {
                let kind = self.number(0.0);
                self.named("fresnel", &[kind, *z])
            }
            ("fresnels", [z]) => {
                let kind = self.number(1.0);
                self.named("fresnel", &[kind, *z])
            }
            ("besseli", [n, x]) if whole(*n) => self.named("bessel_i", &[*n, *x]),
            (_, [n, x]) if is(*n, 0.0) || is(*n, 1.0) => {
                let form = OF_ORDERS_0_AND_1.iter().find(|own| own.0 == name).map_or(name, |own| own.1);
                self.named(form, &[*n, *x])
            }
            _ => self.named(name, arguments),
        }
    }

    /// Replaces differences that cancel for large arguments by routines: e⁻ᶻ(I₀ − I₁), and x M₀ − M₁ with Mₙ = Iₙ − Lₙ.
    fn difference(&mut self, a: u32, b: u32) -> Option<u32> {
        let call = |own: u32, name: &str, order: f64| match self.steps.get(own as usize)? {
            Step::Call(called, arguments) if *called == name => match arguments.as_slice() {
                [n, x] if self.known(*n).is_some_and(|n| n.value.hi == order) => Some(*x),
                _ => None,
            },
            _ => None,
        };
        if let (Some(x), Some(other)) = (call(a, "bessel_i_scaled", 0.0), call(b, "bessel_i_scaled", 1.0))
            && x == other
        {
            return Some(self.named("bessel_i_drop", &[x]));
        }
        let x = call(b, "bessel_i_less_struve", 1.0)?;
        let Step::Binary(Operator::Multiply, one, other) = *self.steps.get(a as usize)? else { return None };
        let is_product = |x_place: u32, called: u32| x_place == x && call(called, "bessel_i_less_struve", 0.0) == Some(x);
        if !is_product(one, other) && !is_product(other, one) {
            return None;
        }
        let two = self.number(2.0);
        let mean = self.named("decay_mean", &[two, x]);
        Some(self.multiply(x, mean))
    }

    fn negative(&mut self, a: u32) -> u32 {
        let factor = self.number(-1.0);
        self.multiply(factor, a)
    }

    /// Variables for what is used more than once or is long, and the value at the end.
    fn statements(&self, root: u32, inputs: &[String], counter: &mut usize) -> (Vec<Statement>, Value) {
        let mut uses = vec![0_usize; self.steps.len()];
        let mut reached = vec![false; self.steps.len()];
        let mut open = vec![root];
        while let Some(place) = open.pop() {
            if let Some(count) = uses.get_mut(place as usize) {
                *count += 1;
            }
            let first = reached.get_mut(place as usize).is_some_and(|own| !std::mem::replace(own, true));
            if first {
                open.extend(self.operands(place));
            }
        }
        let mut values: Vec<Value> = Vec::with_capacity(self.steps.len());
        let mut statements = Vec::new();
        for (place, step) in self.steps.iter().enumerate() {
            let get = |own: &u32| values.get(*own as usize).cloned().unwrap_or(Value::Number(f64::NAN, true));
            let value = match step {
                Step::Constant(hi, lo, error) => {
                    Value::Number(f64::from_bits(*hi), f64::from_bits(*lo) == 0.0 && f64::from_bits(*error) == 0.0)
                }
                Step::Input(index) => inputs.get(*index).map_or(Value::Number(f64::NAN, true), |name| Value::name(name)),
                Step::Binary(operator, a, b) => Value::binary(*operator, get(a), get(b)),
                Step::Call(name, arguments) => Value::call(name, arguments.iter().map(get).collect()),
            };
            let (used, is_reached) = (uses.get(place).copied().unwrap_or(0), reached.get(place).copied().unwrap_or(false));
            let is_root = place == root as usize;
            let value = if is_reached && !is_root && value.size() > 0 && (used > 1 || value.size() > LONG) {
                *counter += 1;
                let name = format!("t{counter}");
                statements.push(Statement::Let(name.clone(), value));
                Value::Name(name)
            } else {
                value
            };
            values.push(value);
        }
        let last = values.get(root as usize).cloned().unwrap_or(Value::Number(f64::NAN, true));
        (statements, last)
    }

    fn operands(&self, place: u32) -> Vec<u32> {
        match self.steps.get(place as usize) {
            Some(Step::Binary(_, a, b)) => vec![*a, *b],
            Some(Step::Call(_, arguments)) => arguments.clone(),
            _ => Vec::new(),
        }
    }
}

impl Algebra for Recorder {
    type Value = u32;

    fn constant(&mut self, number: Precise) -> u32 {
        self.push(Step::Constant(number.value.hi.to_bits(), number.value.lo.to_bits(), number.error.to_bits()))
    }

    fn add(&mut self, a: u32, b: u32) -> u32 {
        limits::sum(self, a, b, false).unwrap_or_else(|| self.binary(Operator::Add, a, b))
    }

    fn subtract(&mut self, a: u32, b: u32) -> u32 {
        self.difference(a, b)
            .or_else(|| elliptic::difference(self, a, b))
            .or_else(|| limits::sum(self, a, b, true))
            .unwrap_or_else(|| self.binary(Operator::Subtract, a, b))
    }

    fn multiply(&mut self, a: u32, b: u32) -> u32 {
        self.binary(Operator::Multiply, a, b)
    }

    fn divide(&mut self, a: u32, b: u32) -> u32 {
        self.binary(Operator::Divide, a, b)
    }

    fn square_root(&mut self, a: u32) -> u32 {
        let compute = |own: &[Precise]| own.first().map_or(Precise::nan(), |a| PreciseAlgebra.square_root(*a));
        self.folded(&[a], compute).unwrap_or_else(|| self.named("sqrt", &[a]))
    }

    fn power(&mut self, a: u32, b: u32) -> u32 {
        let compute = |own: &[Precise]| match own {
            [a, b] => PreciseAlgebra.power(*a, *b),
            _ => Precise::nan(),
        };
        self.folded(&[a, b], compute).unwrap_or_else(|| self.named("pow", &[a, b]))
    }

    fn real_power(&mut self, a: u32, nearest: f64, rest: Precise) -> u32 {
        if let Some(constant) =
            self.folded(&[a], |own| own.first().map_or(Precise::nan(), |a| PreciseAlgebra.real_power(*a, nearest, rest)))
        {
            return constant;
        }
        // a^(n + t) = a^n (1 + t ln a) to all digits: t is below half an ulp of n.
        let (exponent, rest, one) = (self.number(nearest), self.constant(rest), self.number(1.0));
        let power = self.power(a, exponent);
        let logarithm = self.named("log", &[a]);
        let step = self.multiply(rest, logarithm);
        let correction = self.add(one, step);
        self.multiply(power, correction)
    }

    fn call(&mut self, function: Function, arguments: &[u32]) -> u32 {
        let row = function.row();
        let folded = match row.precise {
            Some(_) => self.folded(arguments, |own| PreciseAlgebra.call(function, own)),
            None => None,
        };
        folded.unwrap_or_else(|| self.written(row.name, arguments))
    }
}
