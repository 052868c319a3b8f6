//! The third pass: 30 digits and exponents without end, for values whose intermediate results leave the range of doubles.

use super::cost::Cost;
use super::{Algebra, PreciseAlgebra};
use crate::expr::Function;
use crate::num::{DoubleDouble, Precise, Wide, precise};

/// Values of two doubles with a separate exponent and a running bound of the error.
///
/// Functions are those of the second pass. An argument below their range counts as 0 within 1e-270 or, where the function is its
/// argument to first order, is the value; of one above the range only logarithms and angles have a value.
///
/// ```
/// use sneddon_expr::{eval::{Tape, WideAlgebra}, expr::{Expr, Symbol}};
/// use sneddon_num::{Precise, Wide};
/// let x = Expr::symbol("x");
/// let f = (Expr::one() + x.power(2)).sqrt() / x;
/// let tape = Tape::compile(&[f], &[Symbol::new("x")]).unwrap();
/// let value = tape.run(&mut WideAlgebra, &[Wide::new(Precise::exact(1e200))], &mut Vec::new()).unwrap().precise();
/// assert_eq!(value.value.hi, 1.0);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct WideAlgebra;

/// Functions of doubles keep their 30 digits within 2^±RANGE.
const RANGE: i32 = 880;
/// Where the argument is below 2^-RANGE, f(z) = z to every digit.
const LIKE_THEIR_ARGUMENT: [&str; 8] = ["sin", "tan", "asin", "atan", "sinh", "tanh", "asinh", "atanh"];
/// Integrals over a segment of (r−b)^k, homogeneous in the radii that follow k: degree k, and k + 2 with the weight r².
const SEGMENTS: [(&str, f64); 4] =
    [("shifted_power", 0.0), ("shifted_power_between", 0.0), ("shifted_power_force", 2.0), ("shifted_power_force_between", 2.0)];

impl Algebra for WideAlgebra {
    type Value = Wide;
    const COST: Cost = Cost::new(84, 420, 320);
    const STOPS: bool = true;
    fn constant(&mut self, number: Precise) -> Wide {
        Wide::new(number)
    }
    fn add(&mut self, a: Wide, b: Wide) -> Wide {
        a.add(b)
    }
    fn subtract(&mut self, a: Wide, b: Wide) -> Wide {
        a.add(b.neg())
    }
    fn multiply(&mut self, a: Wide, b: Wide) -> Wide {
        a.mul(b)
    }
    fn divide(&mut self, a: Wide, b: Wide) -> Wide {
        a.div(b)
    }
    fn square_root(&mut self, a: Wide) -> Wide {
        a.sqrt()
    }
    fn power(&mut self, a: Wide, b: Wide) -> Wide {
        a.pow(b)
    }
    fn call(&mut self, function: Function, arguments: &[Wide]) -> Wide {
        let name = function.name();
        match (name, arguments) {
            ("exp", [z]) => return z.exp(),
            ("ln", [z]) => return z.ln(),
            ("ln_near_one", [_, v]) if v.exponent() > 8 => return v.ln(),
            ("ln_near_one", [u, _]) if u.exponent() < -RANGE => return u.within(f64::EPSILON * f64::EPSILON),
            ("asinh" | "acosh", [z]) if z.exponent() > RANGE && !z.is_negative() => return z.shifted(1).ln(),
            ("angle_from", [b, x]) if b.exponent() < x.exponent() - 1 => return quarter_turn(b.div(*x)),
            ("angle_from", [b, x]) => return in_other_units(function, &[b.shifted(-x.exponent()), x.shifted(-x.exponent())], 0),
            ("elliprf" | "elliprc", [.., z]) => {
                // Homogeneous of degree −1/2.
                let half = z.exponent().div_euclid(2);
                let own: Vec<Wide> = arguments.iter().map(|z| z.shifted(-2 * half)).collect();
                return in_other_units(function, &own, -half);
            }
            (_, [z]) if z.exponent() < -RANGE && LIKE_THEIR_ARGUMENT.contains(&name) => {
                return if z.is_zero() { *z } else { z.within(f64::EPSILON * f64::EPSILON) };
            }
            ("atan", [z]) if z.exponent() > RANGE => {
                let own = Precise { value: precise::PI.scale(0.5), error: 3e-33 };
                return if z.is_negative() { Wide::new(own).neg() } else { Wide::new(own) };
            }
            _ => {}
        }
        if let Some((_, more)) = SEGMENTS.iter().find(|(own, _)| *own == name)
            && let [k, radii @ ..] = arguments
        {
            return segment(function, *k, radii, *more);
        }
        in_other_units(function, arguments, 0)
    }
}

/// The second pass's function at these arguments, times 2^shift.
fn in_other_units(function: Function, arguments: &[Wide], shift: i32) -> Wide {
    let values: Option<Vec<Precise>> = arguments.iter().map(|z| within_range(*z)).collect();
    values.map_or_else(Wide::nan, |values| Wide::new(PreciseAlgebra.call(function, &values)).shifted(shift))
}

/// The argument as two doubles: 0 with an error if it is too small, `None` if it is too large.
fn within_range(z: Wide) -> Option<Precise> {
    if z.exponent() > RANGE {
        return None;
    }
    if z.exponent() < -RANGE && !(z.is_zero() && z.precise().error == 0.0) {
        return Some(Precise::checked(DoubleDouble::from(0.0), 1e-264));
    }
    Some(z.precise())
}

/// acos z of a small z: π/2 − asin z.
fn quarter_turn(z: Wide) -> Wide {
    let half = Wide::new(Precise { value: precise::PI.scale(0.5), error: 3e-33 });
    let Some(asin) = Function::named("asin") else { return Wide::nan() };
    half.add(WideAlgebra.call(asin, &[z]).neg())
}

/// A homogeneous integral, with radii brought to the size of the outermost one.
fn segment(function: Function, k: Wide, radii: &[Wide], more: f64) -> Wide {
    let Some(outer) = radii.last().map(|x| x.exponent()) else { return Wide::nan() };
    let order = k.precise().value.hi;
    let degree = (order + more) * f64::from(outer);
    if degree.is_nan() || degree.abs() > 1e8 {
        return Wide::nan();
    }
    let own: Vec<Wide> = std::iter::once(k).chain(radii.iter().map(|radius| radius.shifted(-outer))).collect();
    in_other_units(function, &own, degree as i32)
}
