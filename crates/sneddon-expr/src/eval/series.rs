//! Expressions as power series at r = 0, every coefficient with its error, and bounds of what lies beyond the last one.
//!
//! A series is r^s (A₀ + A₁ r + …). Beside the coefficients travels, for several radii ρ, a bound of Σ |A_n| ρ^n over n ≥ 1. A
//! finite bound proves that the expression is analytic for |r| ≤ ρ, and gives |A_n| ≤ bound/ρ^n for every n (Cauchy's estimate).

mod functions;

use super::{EvalError, constant_value};
use crate::expr::{Bindings, Expr, Node, Symbol, leading_term};
use crate::num::Bounded;
use thiserror::Error;

/// Why an expression has no power series at r = 0.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum SeriesError {
    /// It is not r^s times an analytic function.
    #[error("{what} is not analytic")]
    NotAnalytic {
        /// The part that is not.
        what: &'static str,
    },
    /// Taylor arithmetic does not know the function, or not at this place.
    #[error("no series of {function} is known here")]
    Unknown {
        /// The function.
        function: &'static str,
    },
    /// A coefficient whose sign or zero decides is known to its error only.
    #[error("a coefficient that must not vanish cannot be told from 0")]
    Undecided,
    /// A number could not be computed.
    #[error(transparent)]
    Evaluation(#[from] EvalError),
}

/// How far a series goes, and the radii at which its rest is bounded.
pub(super) struct Frame {
    pub(super) length: usize,
    pub(super) radii: Vec<f64>,
}

/// r^shift (A₀ + A₁ r + …): as many coefficients as are known, and a bound of Σ_{n≥1} |A_n| ρ^n for every radius.
#[derive(Clone, Debug)]
pub struct Series {
    /// The power in front.
    pub shift: f64,
    /// A₀, A₁, …
    pub coefficients: Vec<Bounded>,
    /// The bounds, one per radius; infinite if none is known.
    pub rest: Vec<f64>,
}

/// Bounds are widened by this share after every step: more than their own rounding.
const MARGIN: f64 = 1e-12;

/// The series of an expression in r without other symbols, to at least `length` coefficients.
///
/// Terms of a sum whose powers of r do not differ by whole numbers form separate series.
///
/// ```
/// use sneddon_expr::{eval::power_series, expr::Expr};
/// // r − r³/6 + …, analytic everywhere
/// let sine = power_series(&Expr::call("sin", [Expr::symbol("r")]), 6, &[1.0]).unwrap();
/// let own = &sine[0];
/// assert_eq!(own.shift + 0.0, 0.0);
/// assert!((own.coefficients[3].value + 1.0 / 6.0).abs() <= own.coefficients[3].error + 1e-17);
/// assert!(own.rest[0] >= 1.0_f64.sinh() && own.rest[0] < 1.1753);
/// ```
///
/// # Errors
/// [`SeriesError`], which says what is not analytic.
pub fn power_series(expr: &Expr, length: usize, radii: &[f64]) -> Result<Vec<Series>, SeriesError> {
    let mut working = length;
    // Divisions by powers of r cost coefficients at the end; a few more rounds make up for them.
    for _ in 0..8 {
        let frame = Frame { length: working, radii: radii.to_vec() };
        let mut groups: Vec<Series> = Vec::new();
        for term in expr.terms() {
            let own = frame.series(&term)?;
            match groups.iter_mut().find(|group| (group.shift - own.shift).fract() == 0.0) {
                Some(group) => *group = frame.sum(group, &own)?,
                None => groups.push(own),
            }
        }
        let shortest = groups.iter().map(|group| group.coefficients.len()).min().unwrap_or(length);
        if shortest >= length {
            return Ok(groups);
        }
        working += length - shortest;
    }
    Err(SeriesError::Undecided)
}

impl Frame {
    fn series(&self, expr: &Expr) -> Result<Series, SeriesError> {
        let radius = Symbol::new("r");
        if !expr.contains(&radius) {
            return Ok(self.constant(constant_value(expr, &Bindings::default())?));
        }
        match expr.node() {
            Node::Symbol(_) => Ok(Series { shift: 1.0, ..self.constant(Bounded::exact(1.0)) }),
            Node::Sum(terms) => {
                let mut total = self.constant(Bounded::exact(0.0));
                for term in terms {
                    total = self.sum(&total, &self.series(term)?)?;
                }
                // What vanishes at the axis exactly, though its parts are rounded, as in √(1.21 + r²) − 1.1.
                let rounded = total.coefficients.iter().find(|own| own.value != 0.0 || own.error > 0.0);
                if rounded.is_some_and(|own| own.value.abs() <= own.error)
                    && let Some(order) = leading_term(expr).map(|term| term.exponent.to_f64())
                {
                    let below = total.coefficients.iter_mut().enumerate().filter(|(n, _)| total.shift + (*n as f64) < order - 0.5);
                    below.for_each(|(_, own)| *own = Bounded::exact(0.0));
                }
                Ok(self.tightened(total))
            }
            Node::Product(factors) => {
                let mut total = self.constant(Bounded::exact(1.0));
                for factor in factors {
                    total = self.product(&total, &self.series(factor)?);
                }
                Ok(total)
            }
            Node::Power(base, exponent) => {
                let own = self.series(base)?;
                match exponent.as_number() {
                    Some(number) => self.power(&own, number.to_f64(), number.is_exact_f64()),
                    None if !exponent.contains(&radius) => {
                        let power = constant_value(exponent, &Bindings::default())?;
                        // An inexact exponent of r itself could not be compared with others.
                        if power.error == 0.0 { self.power(&own, power.value, true) } else { self.general_power(&own, power) }
                    }
                    None => {
                        let logarithm = self.ln(&own)?;
                        self.exp(&self.product(&self.series(exponent)?, &logarithm))
                    }
                }
            }
            Node::Function(function, arguments) => self.call(*function, arguments),
            Node::Number(_) | Node::Constant(_) => Ok(self.constant(constant_value(expr, &Bindings::default())?)),
        }
    }

    pub(super) fn constant(&self, value: Bounded) -> Series {
        let mut coefficients = vec![Bounded::exact(0.0); self.length];
        if let Some(first) = coefficients.first_mut() {
            *first = value;
        }
        Series { shift: 0.0, coefficients, rest: vec![0.0; self.radii.len()] }
    }

    pub(super) fn sum(&self, u: &Series, v: &Series) -> Result<Series, SeriesError> {
        if u.vanishes() {
            return Ok(v.clone());
        }
        if v.vanishes() {
            return Ok(u.clone());
        }
        let (low, high) = if u.shift <= v.shift { (u, v) } else { (v, u) };
        let gap = high.shift - low.shift;
        if gap.fract() != 0.0 {
            return Err(SeriesError::NotAnalytic { what: "a sum of different fractional powers inside an expression" });
        }
        let high = self.raised(high, gap);
        let length = low.coefficients.len().min(high.coefficients.len());
        Ok(Series {
            shift: low.shift,
            coefficients: low.coefficients.iter().zip(&high.coefficients).take(length).map(|(a, b)| *a + *b).collect(),
            rest: low.rest.iter().zip(&high.rest).map(|(a, b)| widened(a + b)).collect(),
        })
    }

    /// Returns the series with tighter bounds, to which coefficients that cancel in a sum contribute only what remains of them.
    ///
    /// A bound is the sum over the N known coefficients plus the tail Σ_{n≥N} |A_n| ρ^n, which is at most (ρ/ρ′)^N times the bound at a
    /// larger radius ρ′.
    fn tightened(&self, mut own: Series) -> Series {
        let power = i32::try_from(own.coefficients.len()).unwrap_or(i32::MAX);
        let tail = |rho: f64| {
            let larger = self.radii.iter().zip(&own.rest).filter(|(other, _)| **other > rho);
            larger.map(|(other, rest)| (rho / other).powi(power) * rest).filter(|tail| !tail.is_nan()).fold(f64::INFINITY, f64::min)
        };
        let known = |rho: f64| rho * own.coefficients.iter().skip(1).rev().fold(0.0, |sum, c| sum * rho + (c.value.abs() + c.error));
        own.rest = self.radii.iter().zip(&own.rest).map(|(rho, rest)| rest.min(widened(known(*rho) + tail(*rho)))).collect();
        own
    }

    /// r^gap times the analytic part, for a whole gap ≥ 0; the shift is taken down by as much.
    fn raised(&self, own: &Series, gap: f64) -> Series {
        if gap == 0.0 {
            return own.clone();
        }
        let places = (gap as usize).min(self.length);
        let mut coefficients = vec![Bounded::exact(0.0); places];
        coefficients.extend(own.coefficients.iter().copied().take(self.length - places));
        let first = own.first_bound();
        let rest = own.rest.iter().zip(&self.radii).map(|(rest, rho)| widened(rho.powf(gap) * (first + rest))).collect();
        Series { shift: own.shift - gap, coefficients, rest }
    }

    pub(super) fn product(&self, u: &Series, v: &Series) -> Series {
        let length = u.coefficients.len().min(v.coefficients.len());
        let coefficients = (0..length)
            .map(|n| {
                let pairs = u.coefficients.iter().take(n + 1).zip(v.coefficients.iter().take(n + 1).rev());
                Bounded::sum(pairs.map(|(a, b)| *a * *b))
            })
            .collect();
        let (a, b) = (u.first_bound(), v.first_bound());
        // 0·∞ would be NaN: what vanishes contributes nothing.
        let times = |p: f64, q: f64| if p == 0.0 || q == 0.0 { 0.0 } else { p * q };
        let rest = u.rest.iter().zip(&v.rest).map(|(p, q)| widened(times(a, *q) + times(b, *p) + times(*p, *q))).collect();
        Series { shift: u.shift + v.shift, coefficients, rest }
    }

    /// The same with leading zeros taken into the shift, so that A₀ ≠ 0.
    pub(super) fn normalised(&self, own: &Series) -> Result<Series, SeriesError> {
        let zeros = own.coefficients.iter().take_while(|c| c.value == 0.0 && c.error == 0.0).count();
        let coefficients: Vec<Bounded> = own.coefficients.iter().skip(zeros).copied().collect();
        let Some(first) = coefficients.first().filter(|c| c.value.abs() > c.error) else { return Err(SeriesError::Undecided) };
        if zeros == 0 {
            return Ok(own.clone());
        }
        let least = first.value.abs() - first.error;
        let rest = own.rest.iter().zip(&self.radii).map(|(rest, rho)| {
            let whole = widened(rest / rho.powi(i32::try_from(zeros).unwrap_or(i32::MAX)));
            (whole - least).max(0.0) + MARGIN * whole
        });
        Ok(Series { shift: own.shift + zeros as f64, rest: rest.collect(), coefficients })
    }

    /// A series without power in front, as functions need it.
    pub(super) fn plain(&self, own: &Series) -> Result<Series, SeriesError> {
        if own.shift.fract() != 0.0 {
            return Err(SeriesError::NotAnalytic { what: "a fractional power of r inside a function" });
        }
        if own.shift >= 0.0 {
            return Ok(self.raised(own, own.shift));
        }
        let own = self.normalised(own)?;
        if own.shift < 0.0 {
            return Err(SeriesError::NotAnalytic { what: "a negative power of r inside a function" });
        }
        Ok(self.raised(&own, own.shift))
    }
}

impl Series {
    fn vanishes(&self) -> bool {
        self.coefficients.iter().all(|c| c.value == 0.0 && c.error == 0.0) && self.rest.iter().all(|rest| *rest == 0.0)
    }

    /// A₀.
    pub(super) fn first(&self) -> Bounded {
        self.coefficients.first().copied().unwrap_or(Bounded::exact(0.0))
    }

    /// A bound of |A₀|.
    pub(super) fn first_bound(&self) -> f64 {
        let first = self.first();
        first.value.abs() + first.error
    }
}

/// A bound with a margin for its rounding error.
pub(super) fn widened(bound: f64) -> f64 {
    if bound.is_nan() { f64::INFINITY } else { bound * (1.0 + MARGIN) }
}
