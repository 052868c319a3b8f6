//! Sources of f′ for a whole curve: one segment, or one class of its powers, with its behaviour at the lower end.

use crate::eval::{BoundedAlgebra, Tape};
use crate::expr::{Expr, Number, Symbol, derivative, normal};
use crate::integrate::integral::{NumericSegment, with_ulps};
use crate::integrate::source::f_prime::Numbers;
use crate::num::Bounded;

/// f′ or (r f′)′ on one segment as u^B ψ with u = r² − b²: the exponent of the factor before ψ, and the source of its values.
pub(super) struct Source<'a> {
    pub(super) lower: f64,
    pub(super) upper: Option<f64>,
    /// B: f′/(2r) = (r² − b²)^B ψ, with ψ analytic at the lower end.
    pub(super) exponent: f64,
    values: Values<'a>,
    /// ψ(−r), if the expression defines it; only on segments that begin at the axis.
    mirrored: Option<Tape>,
}

enum Values<'a> {
    FPrime(&'a NumericSegment),
    Bend(&'a Numbers),
    Tape(Box<Tape>),
}

/// The two halves of a function by their parity in r.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Parity {
    /// The function itself.
    Whole,
    /// (ψ(r) + ψ(−r))/2.
    Even,
    /// (ψ(r) − ψ(−r))/(2r).
    Odd,
}

impl<'a> Source<'a> {
    /// The sources of f′ on a segment: a single source, or one for each class of fractional powers at the axis.
    pub(super) fn of_slope(segment: &'a NumericSegment) -> Vec<Self> {
        Self::of(segment, Values::FPrime(segment), || segment.source.as_ref().map(|(f_prime, _)| f_prime.clone()))
    }

    /// The sources of (r f′)′ instead of f′; empty if it is not known.
    pub(super) fn of_bend(segment: &'a NumericSegment) -> Vec<Self> {
        let Ok(bend) = segment.bend() else { return Vec::new() };
        let derived = || {
            let (f_prime, _) = segment.source.as_ref()?;
            derivative(&(Expr::symbol("r") * f_prime), &Symbol::new("r")).ok()
        };
        Self::of(segment, Values::Bend(bend), derived)
    }

    fn of(segment: &'a NumericSegment, values: Values<'a>, expr: impl Fn() -> Option<Expr>) -> Vec<Self> {
        let (lower, upper) = (segment.lower.value, segment.upper.map(|u| u.value));
        let found = order_at(|delta| values.at(Bounded::exact(delta)).value, scale(lower, upper));
        if lower > 0.0 {
            return vec![Self { lower, upper, exponent: halves(found).unwrap_or(0.0), values, mirrored: None }];
        }
        let classes = if segment.singular { expr().and_then(|own| classes(&own)).unwrap_or_default() } else { Vec::new() };
        if classes.len() > 1 {
            let own: Option<Vec<Self>> = classes.iter().map(|class| Self::of_class(class, upper)).collect();
            if let Some(list) = own {
                return list;
            }
        }
        let (power, mirrored) = match (classes.first(), near_integer(found)) {
            (Some(class), _) => (class.power, class.mirrored()),
            (None, Some(power)) => (power, expr().and_then(|own| mirrored(&own, power))),
            (None, None) => (found, None),
        };
        vec![Self { lower, upper, exponent: (power - 1.0) / 2.0, values, mirrored }]
    }

    fn of_class(class: &Class, upper: Option<f64>) -> Option<Self> {
        let r = Symbol::new("r");
        let values = Tape::compile(std::slice::from_ref(&class.whole), &[r]).ok()?;
        let exponent = (class.power - 1.0) / 2.0;
        Some(Self { lower: 0.0, upper, exponent, values: Values::Tape(Box::new(values)), mirrored: class.mirrored() })
    }

    /// True if the two halves by parity are available.
    pub(super) fn has_mirror(&self) -> bool {
        self.mirrored.is_some()
    }

    /// ψ at u = r² − b² above the lower end, for the given exponent B.
    pub(super) fn psi(&self, u: f64, exponent: f64, parity: Parity) -> Bounded {
        let r = (self.lower * self.lower + u).sqrt();
        let delta = with_ulps(u / (self.lower + r), 4.0);
        let f_prime = self.values.at(delta);
        let half = Bounded::exact(0.5);
        // Both halves use the same ψ.
        let exponent = if parity == Parity::Whole { exponent } else { self.exponent };
        let whole = if self.lower == 0.0 {
            // f′/(2r) over r^(2B) is f′/2 over r^(2B+1).
            half * f_prime / with_ulps(power(r, 2.0 * exponent + 1.0), 4.0)
        } else {
            half * f_prime / with_ulps(r * power(u, exponent), 6.0)
        };
        let other = match (&self.mirrored, parity) {
            (_, Parity::Whole) | (None, _) => return whole,
            (Some(tape), _) => half * run(tape, delta),
        };
        match parity {
            Parity::Odd => half * (whole - other) / with_ulps(r, 4.0),
            _ => half * (whole + other),
        }
    }
}

impl Values<'_> {
    fn at(&self, delta: Bounded) -> Bounded {
        match self {
            Self::FPrime(segment) => segment.f_prime.at(delta, &mut Vec::new()),
            Self::Bend(bend) => bend.at(delta, &mut Vec::new()),
            Self::Tape(tape) => run(tape, delta),
        }
    }
}

fn run(tape: &Tape, delta: Bounded) -> Bounded {
    let mut slots = Vec::new();
    tape.run(&mut BoundedAlgebra, &[delta], &mut slots).unwrap_or(Bounded { value: f64::NAN, error: f64::NAN })
}

/// z^q; the usual exponents without a call of pow.
pub(super) fn power(z: f64, q: f64) -> f64 {
    if q == 0.0 {
        1.0
    } else if q == 0.5 {
        z.sqrt()
    } else if q == 1.0 {
        z
    } else if q == 1.5 {
        z * z.sqrt()
    } else if q == 2.0 {
        z * z
    } else {
        z.powf(q)
    }
}

fn scale(lower: f64, upper: Option<f64>) -> f64 {
    match upper {
        Some(upper) => upper - lower,
        None if lower > 0.0 => lower,
        None => 1.0,
    }
}

/// The leading power of δ of a function.
fn order_at(f: impl Fn(f64) -> f64, scale: f64) -> f64 {
    let (near, nearer) = (f(1e-9 * scale), f(1e-12 * scale));
    let order = (near / nearer).abs().log10() / 3.0;
    if order.is_finite() && order > -0.99 { order } else { 0.0 }
}

fn near_integer(order: f64) -> Option<f64> {
    let whole = order.round();
    ((order - whole).abs() < 0.004 && whole >= 0.0).then_some(whole)
}

/// Near a breakpoint, integer and half-integer orders are considered.
fn halves(order: f64) -> Option<f64> {
    let twice = near_integer(2.0 * order)?;
    Some(0.5 * twice)
}

/// Terms of f′ whose powers of r differ by whole numbers.
struct Class {
    power: f64,
    whole: Expr,
    /// (power − smallest power, coefficient·kernel).
    parts: Vec<(i32, Expr)>,
}

impl Class {
    /// ψ(−r) = Σ (−r)^k kernel(−r), compiled over r.
    fn mirrored(&self) -> Option<Tape> {
        let r = Symbol::new("r");
        let minus = -Expr::from(r.clone());
        let sum = Expr::sum(self.parts.iter().map(|(k, part)| minus.power(i64::from(*k)) * replaced(part, &r, &minus)));
        Tape::compile(&[sum], &[r]).ok()
    }
}

/// A term of f′: its power of r, the other factor, and the whole term.
type Member = (f64, Expr, Expr);

/// Groups the terms of f′ by the fractional part of their powers; `None` if a power is not a number.
fn classes(f_prime: &Expr) -> Option<Vec<Class>> {
    let r = Symbol::new("r");
    let mut found: Vec<(f64, Vec<Member>)> = Vec::new();
    for term in normal::normal_terms(f_prime, &r).ok()? {
        let exponent = term.exponent.as_number().map(Number::to_f64)?;
        let part = &term.coefficient * &term.kernel;
        let whole = term.to_expr(&r);
        match found.iter_mut().find(|(own, _)| near_integer((own - exponent).abs()).is_some()) {
            Some((_, list)) => list.push((exponent, part, whole)),
            None => found.push((exponent, vec![(exponent, part, whole)])),
        }
    }
    let class = |(_, list): (f64, Vec<Member>)| {
        let power = list.iter().map(|(own, _, _)| *own).fold(f64::INFINITY, f64::min);
        let whole = Expr::sum(list.iter().map(|(_, _, whole)| whole.clone()));
        let parts = list.into_iter().map(|(own, part, _)| ((own - power).round() as i32, part)).collect();
        Class { power, whole, parts }
    };
    Some(found.into_iter().map(class).collect())
}

/// ψ(−r) for f′ = r^m ψ with whole m: f′(−r)/(−r)^m.
fn mirrored(f_prime: &Expr, whole: f64) -> Option<Tape> {
    let r = Symbol::new("r");
    let minus = -Expr::from(r.clone());
    let m = whole as i64;
    let expr = replaced(f_prime, &r, &minus) * minus.power(-m);
    Tape::compile(&[expr], &[r]).ok()
}

fn replaced(expr: &Expr, symbol: &Symbol, by: &Expr) -> Expr {
    crate::expr::Bindings::one(symbol.name(), by.clone()).apply(expr)
}
