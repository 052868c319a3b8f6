//! Dimensions of parameters: which power of a length each must be for f(r) to be a length.

use crate::expr::{Bindings, Condition, Expr, Node, Number, Symbol};

/// What a parameter measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::code) enum ParameterDimension {
    /// An angle in radians, as the argument of a trigonometric function.
    Angle,
    /// A power of a length, with its exponent; 0 for a plain number.
    Length(f64),
    /// What depends on the values of others, as C in C r^n.
    Open,
}

/// Coefficients below this are rounding errors of the elimination; exponents are its multiples.
const NONE: f64 = 1.0 / 1_073_741_824.0;

/// The dimensions of parameters for which every one of these expressions is a length.
pub(in crate::code) fn dimensions(lengths: &[&Expr], parameters: &[Symbol]) -> Vec<ParameterDimension> {
    let mut system = System { parameters, unknowns: parameters.len(), equations: Vec::new() };
    for own in lengths {
        let found = system.of(own);
        system.equal(&found, &Exponent::of(1.0));
    }
    let solved = system.solved();
    let is_angle = |symbol: &Symbol| lengths.iter().any(|own| is_angle(own, symbol));
    parameters
        .iter()
        .zip(solved)
        .map(|(symbol, own)| match own {
            Some(exponent) if exponent.abs() < NONE && is_angle(symbol) => ParameterDimension::Angle,
            Some(exponent) => ParameterDimension::Length((exponent / NONE).round() * NONE),
            None => ParameterDimension::Open,
        })
        .collect()
}

/// The size of tips: a micrometre.
const MICROMETRE: f64 = 1e-6;
/// Parameters whose factors are tried together.
const MOST_PARAMETERS: usize = 6;
/// Factors of lengths by turns, for conditions such as b < R.
const FACTORS: [f64; 3] = [1.0, 4.0, 0.25];

/// Values of the parameters for which no condition on them alone is known to fail: lengths of about a micrometre.
pub(in crate::code) fn starting_values(dimensions: &[ParameterDimension], parameters: &[Symbol], conditions: &[Condition]) -> Vec<f64> {
    let values = |pattern: usize| -> Vec<f64> {
        let mut rest = pattern;
        let one = |dimension: &ParameterDimension| match dimension {
            ParameterDimension::Angle => 0.35,
            ParameterDimension::Open => 1.0,
            ParameterDimension::Length(exponent) => {
                let factor = FACTORS[rest % FACTORS.len()];
                rest /= FACTORS.len();
                (factor * MICROMETRE).powf(*exponent)
            }
        };
        dimensions.iter().map(one).collect()
    };
    let holds = |values: &Vec<f64>| {
        let pairs = parameters.iter().zip(values).filter_map(|(own, value)| Some((own.name(), Expr::number(Number::from_f64(*value)?))));
        let bindings: Bindings = pairs.collect();
        conditions.iter().all(|own| own.substitute(&bindings).decided() != Some(false))
    };
    let patterns = FACTORS.len().pow(dimensions.len().min(MOST_PARAMETERS) as u32);
    (0..patterns).map(values).find(holds).unwrap_or_else(|| values(0))
}

/// Whether a parameter is the argument of a sine, cosine or tangent.
fn is_angle(expr: &Expr, symbol: &Symbol) -> bool {
    match expr.node() {
        Node::Function(function, arguments) if matches!(function.name(), "sin" | "cos" | "tan") => {
            matches!(arguments.as_slice(), [only] if only.as_symbol() == Some(symbol))
        }
        _ => expr.children().into_iter().any(|own| is_angle(own, symbol)),
    }
}

/// An exponent of length: a number plus a sum over the unknown exponents.
#[derive(Clone, Debug)]
struct Exponent {
    number: f64,
    /// Pairs of an unknown and its factor.
    unknown: Vec<(usize, f64)>,
}

impl Exponent {
    fn of(number: f64) -> Self {
        Self { number, unknown: Vec::new() }
    }

    fn plus(mut self, other: &Self, factor: f64) -> Self {
        self.number += factor * other.number;
        self.unknown.extend(other.unknown.iter().map(|(index, own)| (*index, factor * own)));
        self
    }
}

/// Linear equations, each of which says that an exponent is 0.
struct System<'a> {
    parameters: &'a [Symbol],
    unknowns: usize,
    equations: Vec<Exponent>,
}

impl System<'_> {
    fn equal(&mut self, one: &Exponent, other: &Exponent) {
        self.equations.push(one.clone().plus(other, -1.0));
    }

    /// The exponent of an expression; what must hold inside it becomes equations.
    fn of(&mut self, expr: &Expr) -> Exponent {
        let zero = Exponent::of(0.0);
        match expr.node() {
            Node::Number(_) | Node::Constant(_) => zero,
            Node::Symbol(symbol) => match self.parameters.iter().position(|own| own == symbol) {
                Some(index) => Exponent { number: 0.0, unknown: vec![(index, 1.0)] },
                None => Exponent::of(1.0),
            },
            Node::Product(factors) => factors.iter().fold(zero, |total, own| total.plus(&self.of(own), 1.0)),
            Node::Sum(terms) => {
                // 0 has every dimension.
                let mut all: Vec<Exponent> = terms.iter().filter(|own| !own.is_zero()).map(|own| self.of(own)).collect();
                let Some(first) = all.pop() else { return zero };
                all.iter().for_each(|own| self.equal(own, &first));
                first
            }
            Node::Power(base, exponent) => {
                let base = self.of(base);
                let raised = self.of(exponent);
                self.equal(&raised, &zero);
                match exponent.as_number() {
                    Some(number) => zero.plus(&base, number.to_f64()),
                    // Of a power with an open exponent only that of a plain number is known.
                    None if base.number == 0.0 && base.unknown.is_empty() => zero,
                    None => {
                        self.unknowns += 1;
                        Exponent { number: 0.0, unknown: vec![(self.unknowns - 1, 1.0)] }
                    }
                }
            }
            Node::Function(_, arguments) => {
                for own in arguments {
                    let own = self.of(own);
                    self.equal(&own, &zero);
                }
                zero
            }
        }
    }

    /// The exponents that the equations decide, by Gauss–Jordan elimination.
    fn solved(&self) -> Vec<Option<f64>> {
        let width = self.unknowns;
        let row = |own: &Exponent| {
            let mut row = vec![0.0; width + 1];
            let number = (width, own.number);
            own.unknown.iter().copied().chain([number]).for_each(|(index, factor)| row[index] += factor);
            row
        };
        let mut rows: Vec<Vec<f64>> = self.equations.iter().map(row).collect();
        let mut pivots = vec![None; width];
        let mut done = 0;
        for column in 0..width {
            let Some(best) = (done..rows.len()).max_by(|i, j| rows[*i][column].abs().total_cmp(&rows[*j][column].abs())) else { break };
            if rows[best][column].abs() < NONE {
                continue;
            }
            rows.swap(done, best);
            let pivot = rows[done][column];
            rows[done].iter_mut().for_each(|own| *own /= pivot);
            let top = rows[done].clone();
            for (index, other) in rows.iter_mut().enumerate() {
                let factor = other[column];
                if index != done && factor != 0.0 {
                    other.iter_mut().zip(&top).for_each(|(own, top)| *own -= factor * top);
                }
            }
            pivots[column] = Some(done);
            done += 1;
        }
        let is_free = |column: usize| pivots[column].is_none();
        (0..self.parameters.len())
            .map(|column| {
                let own = &rows[pivots[column]?];
                let is_open = (0..width).any(|other| is_free(other) && own[other].abs() > NONE);
                (!is_open).then_some(-own[width])
            })
            .collect()
    }
}
