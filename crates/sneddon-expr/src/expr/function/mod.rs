//! The function table: one row per function with all of its properties.

mod elementary;
mod elliptic;
mod exact_angles;
mod forms;
mod hypergeometric;
mod precise;
mod slices;
mod special;
mod typeset;
mod undefined;
mod waves;

pub use forms::{elliptic_moment_parts, pressure_power_in_one_term};
pub use slices::{Growth, SliceLaw};
pub use typeset::{Font, Letters, Setting, Typeset};
pub(crate) use undefined::has_value;
pub use undefined::{has_pole, undefined_constant};

use super::{Expr, Sign};
use crate::num::{DoubleDouble, Precise, Region};
use num_complex::Complex64;
use std::cmp::Ordering;
use std::hash::{Hash, Hasher};

/// One function: its names, its values and its laws.
pub struct Row {
    /// The name that is printed and read.
    pub name: &'static str,
    /// Other spellings that are read.
    pub spellings: &'static [&'static str],
    /// Smallest and largest number of arguments.
    pub arity: (usize, usize),
    /// How it is typeset.
    pub typeset: Typeset,
    /// The value; NaN outside the domain.
    pub value: fn(&[f64]) -> f64,
    /// Error bound of the value, and its justification.
    pub accuracy: Accuracy,
    /// The value with about 30 digits, at exact arguments; `None` if only double precision is available.
    pub precise: Option<fn(&[DoubleDouble]) -> Precise>,
    /// Bound on the change of the value while every argument moves by at most its distance; differences are used if `None`.
    pub spread: Option<Spread>,
    /// Values and errors over slices, for elementary functions of one number.
    pub slice: Option<SliceLaw>,
    /// True if both arguments encode the same number, so that varying one of them alone gives no error bound.
    pub is_pair: bool,
    /// The values while one argument runs over a slice and the others stay, for functions of several numbers.
    pub sweep: Option<Sweep>,
    /// The value at complex arguments, for elementary functions.
    pub complex: Option<fn(&[Complex64]) -> Complex64>,
    /// Where the values lie for complex arguments in rectangles, unknown where the function is not analytic.
    pub region: Option<fn(&[Region]) -> Region>,
    /// The derivative with respect to the argument at the given position.
    pub derivative: Option<DerivativeLaw>,
    /// A shorter canonical form for these arguments, where there is one.
    pub fold: Option<FoldLaw>,
    /// The sign for these arguments.
    pub sign: Option<fn(&[Expr]) -> Sign>,
    /// Expressions that must be positive for the function to be real and finite.
    pub domain: Option<DomainLaw>,
    /// The expression shown to the reader instead of a function that exists only for stable evaluation.
    pub shown: Option<fn(&[Expr]) -> Expr>,
    /// True if the function has a mathematical symbol, so that it is replaced by its definition only in plain text.
    pub has_sign: bool,
}

impl Row {
    /// Error bound of the value in units in the last place.
    pub fn ulps(&self) -> f64 {
        match self.accuracy {
            Accuracy::Exact => 0.0,
            Accuracy::Bounded(ulps) | Accuracy::Measured(ulps) | Accuracy::Defined(ulps) => ulps,
        }
    }

    /// Returns `true` if the value is always the rounded 30-digit value, so that both take about the same time.
    pub(crate) fn is_rounded(&self) -> bool {
        self.accuracy == Accuracy::ROUNDED
    }
}

/// Error bound of a function value in units in the last place, and its justification.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Accuracy {
    /// The value is an argument or its size; nothing is rounded.
    Exact,
    /// The value is computed to 30 digits with a bound that includes all cancellation, and rounded.
    ///
    /// Values with a larger bound are refused, so that the number of units is rigorous.
    Bounded(f64),
    /// Twice the largest error that was measured against 30 digits; the record is the table of functions in `docs/accuracy.md`.
    Measured(f64),
    /// The bound is part of the definition: the argument has the same uncertainty.
    Defined(f64),
}

impl Accuracy {
    /// A rounded 30-digit value: twice a little more than half a unit.
    pub(super) const ROUNDED: Self = Self::Bounded(1.1);
    /// A value that is refused if its computed bound exceeds two units; rounding adds half a unit, and another half is headroom.
    pub(super) const OWN_BOUND: Self = Self::Bounded(3.0);
}

/// Values of f while the argument at one position runs over a slice; the list contains the other arguments.
pub type Sweep = fn(&mut [f64], usize, &[f64], &mut [f64]);
/// Bounds the change of f(arguments) while every argument moves by at most its distance.
pub type Spread = fn(&[DoubleDouble], &[f64]) -> f64;
/// The derivative of f(arguments) with respect to the argument at a position.
pub type DerivativeLaw = fn(&[Expr], usize) -> Option<Expr>;
/// A shorter form of f(arguments).
pub type FoldLaw = fn(&[Expr]) -> Option<Expr>;
/// Expressions that must be positive for f(arguments) to be real.
pub type DomainLaw = fn(&[Expr]) -> Vec<Expr>;

/// Default values of a row; rows override some of them.
pub(super) const PLAIN: Row = Row {
    name: "",
    spellings: &[],
    arity: (1, 1),
    typeset: typeset::upright(""),
    value: |_| f64::NAN,
    accuracy: Accuracy::Measured(1.0),
    precise: None,
    spread: None,
    slice: None,
    sweep: None,
    complex: None,
    region: None,
    derivative: None,
    fold: None,
    sign: None,
    domain: None,
    shown: None,
    has_sign: false,
    is_pair: false,
};

/// A function of the table; compared by name.
#[derive(Clone, Copy)]
pub struct Function(&'static Row);

impl Function {
    /// The function of this name or spelling.
    pub fn named(name: &str) -> Option<Self> {
        rows().find(|row| row.name == name || row.spellings.contains(&name)).map(Self)
    }

    /// Every function of the table.
    pub fn all() -> impl Iterator<Item = Self> {
        rows().map(Self)
    }

    /// Its row.
    pub fn row(self) -> &'static Row {
        self.0
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        self.0.name
    }
}

fn rows() -> impl Iterator<Item = &'static Row> {
    elementary::ROWS.iter().chain(special::ROWS).chain(hypergeometric::ROWS).chain(elliptic::ROWS).chain(waves::ROWS).chain(forms::ROWS)
}

impl std::fmt::Debug for Function {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl PartialEq for Function {
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name()
    }
}

impl Eq for Function {}

impl PartialOrd for Function {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Function {
    fn cmp(&self, other: &Self) -> Ordering {
        self.name().cmp(other.name())
    }
}

impl Hash for Function {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.name().hash(state);
    }
}
