//! Operations and functions of a program on numbers with running error bounds.

use crate::code::tree::{NAN, Operator};
use crate::expr::Function;
use crate::num::Bounded;

/// Assumed errors of elementary functions in units in the last place: the largest known errors of the GNU C library in double
/// precision (`sysdeps/x86_64/fpu/libm-test-ulps`).
const ELEMENTARY_ULPS: f64 = 1.0;
/// Assumed errors of hyperbolic functions and their inverses, from the same table.
const HYPERBOLIC_ULPS: f64 = 2.0;
/// The assumptions as stated in generated files.
pub(in crate::code) const ASSUMED: &str = "elementary functions accurate to 1 ulp and hyperbolic ones to 2 ulp";

/// The functions that every language has.
pub(in crate::code) const ELEMENTARY: [&str; 24] = [
    "sqrt", "exp", "log", "log1p", "expm1", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "asinh", "atanh",
    "abs", "max", "min", "pow", "floor", NAN, "inf",
];

#[inline]
pub(super) fn binary(operator: Operator, left: Bounded, right: Bounded) -> Bounded {
    match operator {
        Operator::Add => left + right,
        Operator::Subtract => left - right,
        Operator::Multiply => product(left, right),
        Operator::Divide => quotient(left, right),
    }
}

/// A function of the language or of its library.
#[derive(Clone, Copy)]
pub(super) enum Known {
    Constant(f64),
    Root,
    Power,
    Absolute,
    Floor,
    Arctangent,
    /// A function of one number, accurate to this many units.
    Elementary(fn(f64) -> f64, f64),
    /// A special function, accurate to this many units.
    Special(fn(&[f64]) -> f64, f64),
}

impl Known {
    /// The function of this name; `library` gives the assumed accuracy of functions of the language's library.
    pub(super) fn named(name: &str, library: &dyn Fn(&str) -> Option<f64>) -> Option<Self> {
        let elementary: fn(f64) -> f64 = match name {
            NAN => return Some(Self::Constant(f64::NAN)),
            "inf" => return Some(Self::Constant(f64::INFINITY)),
            "sqrt" => return Some(Self::Root),
            "pow" => return Some(Self::Power),
            "abs" => return Some(Self::Absolute),
            "floor" => return Some(Self::Floor),
            "atan2" => return Some(Self::Arctangent),
            "exp" => f64::exp,
            "log" => f64::ln,
            "log1p" => f64::ln_1p,
            "expm1" => f64::exp_m1,
            "sin" => f64::sin,
            "cos" => f64::cos,
            "tan" => f64::tan,
            "asin" => f64::asin,
            "acos" => f64::acos,
            "atan" => f64::atan,
            "sinh" => f64::sinh,
            "cosh" => f64::cosh,
            "tanh" => f64::tanh,
            "asinh" => f64::asinh,
            "atanh" => f64::atanh,
            _ => {
                let (row, ulps) = (Function::named(name)?.row(), library(name)?);
                return Some(Self::Special(row.value, row.ulps() + ulps));
            }
        };
        let ulps = if matches!(name, "sinh" | "cosh" | "tanh" | "asinh" | "atanh") { HYPERBOLIC_ULPS } else { ELEMENTARY_ULPS };
        Some(Self::Elementary(elementary, ulps))
    }

    /// Its value; `None` for a wrong number of arguments.
    pub(super) fn at(self, arguments: &[Bounded]) -> Option<Bounded> {
        Some(match (self, arguments) {
            (Self::Constant(value), []) => Bounded::exact(value),
            (Self::Root, [a]) => root(*a),
            // One unit is counted by the power itself.
            (Self::Power, [a, b]) => a.powf(*b).apply(|z| z, ELEMENTARY_ULPS - 1.0),
            (Self::Absolute, [a]) => Bounded { value: a.value.abs(), error: a.error },
            (Self::Floor, [a]) => Bounded::exact(a.value.floor()),
            (Self::Arctangent, [a, b]) => arctangent(*a, *b),
            (Self::Elementary(f, ulps), [a]) => a.apply(f, ulps),
            (Self::Special(f, ulps), [only]) => only.apply(|z| f(&[z]), ulps),
            (Self::Special(f, ulps), more) => Bounded::apply_many(f, more, ulps),
            _ => return None,
        })
    }
}

/// Magnitudes of results whose rounding errors are computed exactly by a fused multiply-add.
const PLAIN: std::ops::Range<f64> = 1e-250..1e250;

/// Multiplies with the actual rounding error instead of half a unit; exact products, as of small whole numbers, have none.
#[inline]
fn product(a: Bounded, b: Bounded) -> Bounded {
    let whole = a * b;
    let rest = a.value.mul_add(b.value, -whole.value).abs();
    let carried = a.value.abs() * b.error + b.value.abs() * a.error + a.error * b.error;
    let own = Bounded::checked(whole.value, (carried + rest) * (1.0 + 4.0 * f64::EPSILON));
    if PLAIN.contains(&whole.value.abs()) && own.error < whole.error { own } else { whole }
}

/// Divides with the actual rounding error instead of half a unit.
#[inline]
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
