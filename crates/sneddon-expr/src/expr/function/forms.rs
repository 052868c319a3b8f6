//! Rows of functions that exist for stable evaluation; each states the expression that is shown in its place.

use super::elementary::{binary, ternary, unary};
use super::precise::order;
use super::typeset::{self, Setting};
use super::{Accuracy, PLAIN, Row, precise, slices};
use crate::expr::normal::{expanded, over_whole_denominator};
use crate::expr::{Expr, Sign, Symbol};
use crate::num::double_double::two_sum;
use crate::num::{Precise, Region, forms, kappa, precise as thirty};
use num_complex::Complex64;

/// aⁿ arcsin(a/r) − ∫₀^a xⁿ/√(r²−x²) dx, where the integral is aⁿ⁺¹/((n+1) r) 2F1(1/2, (n+1)/2; (n+3)/2; a²/r²), and elementary for whole n.
fn outside_power(n: &Expr, a: &Expr, r: &Expr) -> Expr {
    if let Some(n) = n.as_integer().filter(|n| (1..=HIGHEST_OUTSIDE).contains(n)) {
        return outside_whole_power(n, a, r);
    }
    let (half, next) = (Expr::ratio(1, 2), n + Expr::one());
    let lower = (n + Expr::integer(3)) * &half;
    let hyper = Expr::call("hyp2f1", [half.clone(), &next * &half, lower, a.power(2) / r.power(2)]);
    a.pow(n) * Expr::call("asin", [a / r]) - a.pow(&next) / (next * r) * hyper
}

/// Displacements of powers up to this order are written out.
const HIGHEST_OUTSIDE: i64 = 8;

/// The same with ∫₀^a xⁿ/√(r²−x²) dx = ((n − 1) r² ∫₀^a xⁿ⁻²/√(r²−x²) dx − aⁿ⁻¹ √(r²−a²))/n from arcsin(a/r) or r − √(r²−a²) on.
fn outside_whole_power(n: i64, a: &Expr, r: &Expr) -> Expr {
    let leg = (r.power(2) - a.power(2)).sqrt();
    let angle = Expr::call("asin", [a / r]);
    let even = n % 2 == 0;
    // The factor of the first integral, and those of the root.
    let (mut first, mut roots) = (Expr::one(), if even { Vec::new() } else { vec![Expr::integer(-1)] });
    for m in (if even { 2 } else { 3 }..=n).step_by(2) {
        let share = Expr::ratio(m - 1, m) * r.power(2);
        first = first * &share;
        roots.iter_mut().for_each(|own| *own = &*own * &share);
        roots.push(-a.power(m - 1) / Expr::integer(m));
    }
    let begin = first * if even { angle.clone() } else { r.clone() };
    a.power(n) * angle - begin - Expr::sum(roots) * leg
}

/// The angle whose cosine is b/x, 0 ≤ b ≤ x.
#[inline]
fn angle_from(b: f64, x: f64) -> f64 {
    forms::angle_above(b, x)
}

/// Up to here ln(1 + u) is taken from u.
const NEAR_ONE: f64 = 0.5;

/// Defaults of these rows: positive values, and no LaTeX form, because the shown expression is typeset.
const FORM: Row = Row { typeset: typeset::upright("form"), sign: Some(|_| Sign::Positive), ..PLAIN };

pub(super) static ROWS: &[Row] = &[
    Row {
        name: "kappa",
        accuracy: Accuracy::ROUNDED,
        typeset: typeset::italic("κ").set(Setting::Index),
        value: |a| unary(a, kappa::kappa),
        precise: Some(|a| match a {
            [n] => kappa::kappa_precise(*n),
            _ => Precise::nan(),
        }),
        shown: Some(|a| {
            let half = |n: &Expr, more: Expr| {
                let sum = n / Expr::integer(2) + more;
                gamma(expanded(&sum, &Symbol::new("r")).unwrap_or(sum))
            };
            with(a, |[n]| Expr::pi().sqrt() * half(n, Expr::one()) / half(n, Expr::ratio(1, 2)))
        }),
        ..FORM
    },
    // ln v with v = 1 + u, from whichever of the two has more digits; the evaluation writes it, no tree contains it.
    Row {
        name: "ln_near_one",
        accuracy: Accuracy::Measured(2.0),
        is_pair: true,
        arity: (2, 2),
        value: |a| {
            binary(a, |u, v| {
                if u.is_nan() || v.is_nan() {
                    f64::NAN
                } else if u.abs() < NEAR_ONE {
                    u.ln_1p()
                } else {
                    v.ln()
                }
            })
        },
        precise: Some(|a| match a {
            [u, _] if u.hi.abs() < NEAR_ONE => precise::unary(&[*u], thirty::ln1p),
            [_, v] => precise::unary(&[*v], thirty::ln),
            _ => Precise::nan(),
        }),
        spread: Some(|a, by| match (a, by) {
            ([u, _], [distance, _]) if u.hi.abs() < NEAR_ONE => {
                precise::one(&[*u], &[*distance], |u, by| precise::to_pole(by, 1.0 + u.hi - 2.0 * by))
            }
            ([_, v], [_, distance]) => precise::one(&[*v], &[*distance], |v, by| precise::to_pole(by, v.hi - 2.0 * by)),
            _ => f64::INFINITY,
        }),
        complex: Some(|a| match a {
            // The rounding of 1 + u is divided out again (Kahan).
            [u, v] if u.norm() < NEAR_ONE => {
                if *v == Complex64::ONE {
                    *u
                } else {
                    v.ln() * u / (v - 1.0)
                }
            }
            [_, v] => v.ln(),
            _ => Complex64::new(f64::NAN, f64::NAN),
        }),
        sign: None,
        shown: Some(|a| with(a, |[_, v]| Expr::call("ln", [v.clone()]))),
        region: Some(|a| match a {
            [u, v] => u.ln_1p().and(v.ln()),
            _ => Region::unknown(),
        }),
        ..FORM
    },
    // (1 + u)^p for large p, which would multiply the rounding of 1 + u; the evaluation writes it, no tree contains it.
    Row {
        name: "power_near_one",
        accuracy: Accuracy::ROUNDED,
        arity: (2, 2),
        value: |a| binary(a, |u, p| thirty::pow(two_sum(1.0, u), p.into()).value.value()),
        precise: Some(|a| match a {
            [u, p] => Precise::exact(1.0).add(Precise { value: *u, error: 0.0 }).pow(Precise { value: *p, error: 0.0 }),
            _ => Precise::nan(),
        }),
        complex: Some(|a| match a {
            [u, p] => (Complex64::ONE + u).powc(*p),
            _ => Complex64::new(f64::NAN, f64::NAN),
        }),
        sign: None,
        shown: Some(|a| with(a, |[u, p]| (Expr::one() + u).pow(p))),
        region: Some(|a| match a {
            [u, p] => (Region::real(1.0) + *u).power(*p),
            _ => Region::unknown(),
        }),
        ..FORM
    },
    // A number that is known to 32 ulps only: a kink that was located numerically.
    Row {
        name: "approximate",
        value: |a| unary(a, |z| z),
        accuracy: Accuracy::Defined(64.0),
        precise: Some(|a| match a {
            [z] => Precise { value: *z, error: 64.0 * f64::EPSILON * z.hi.abs() },
            _ => Precise::nan(),
        }),
        spread: Some(|_, by| by.iter().sum()),
        shown: Some(|a| with(a, |[z]| z.clone())),
        region: Some(|a| match a {
            [z] => *z * Region::new((1.0 - 64.0 * f64::EPSILON, 1.0 + 64.0 * f64::EPSILON), (0.0, 0.0)),
            _ => Region::unknown(),
        }),
        ..FORM
    },
    // ∫_b^x (r−b)^k/√(x²−r²) dr
    Row {
        name: "shifted_power",
        accuracy: Accuracy::Measured(8.0),
        arity: (3, 3),
        value: |a| segment(a, forms::shifted_power),
        precise: Some(|a| precise::segment(a, thirty::shifted_power)),
        spread: Some(|a, by| precise::segment_spread(a, by, false)),
        ..FORM
    },
    // ∫_b^c (r−b)^k/√(x²−r²) dr
    Row {
        name: "shifted_power_between",
        accuracy: Accuracy::Measured(8.0),
        arity: (4, 4),
        value: |a| segment(a, forms::shifted_power),
        precise: Some(|a| precise::segment(a, thirty::shifted_power)),
        spread: Some(|a, by| precise::segment_spread(a, by, false)),
        ..FORM
    },
    // ∫_b^a (r−b)^k r²/√(a²−r²) dr
    Row {
        name: "shifted_power_force",
        accuracy: Accuracy::Measured(8.0),
        arity: (3, 3),
        value: |a| segment(a, forms::shifted_power_force),
        precise: Some(|a| precise::segment(a, thirty::shifted_power_force)),
        spread: Some(|a, by| precise::segment_spread(a, by, true)),
        ..FORM
    },
    // ∫_b^c (r−b)^k r²/√(a²−r²) dr
    Row {
        name: "shifted_power_force_between",
        accuracy: Accuracy::Measured(8.0),
        arity: (4, 4),
        value: |a| segment(a, forms::shifted_power_force),
        precise: Some(|a| precise::segment(a, thirty::shifted_power_force)),
        spread: Some(|a, by| precise::segment_spread(a, by, true)),
        ..FORM
    },
    // ∫_b^x dr/√(x²−r²)
    Row {
        name: "angle_from",
        accuracy: Accuracy::Measured(3.0),
        arity: (2, 2),
        value: |a| binary(a, angle_from),
        sweep: Some(|a, place, z, out| match (&*a, place) {
            // The usual case: b stays.
            ([b, _], 1) => out.iter_mut().zip(z).for_each(|(out, x)| *out = angle_from(*b, *x)),
            _ => slices::sweep(a, place, z, out, |a| binary(a, angle_from)),
        }),
        precise: Some(|a| match a {
            [b, x] => precise::segment(&[0.0.into(), *b, *x], thirty::shifted_power),
            _ => Precise::nan(),
        }),
        spread: Some(|a, by| match (a, by) {
            ([b, x], [by_b, by_x]) => precise::segment_spread(&[0.0.into(), *b, *x], &[0.0, *by_b, *by_x], false),
            _ => f64::INFINITY,
        }),
        shown: Some(|a| with(a, |[b, x]| Expr::call("acos", [b / x]))),
        ..FORM
    },
    Row {
        name: "artanh_ratio",
        accuracy: Accuracy::Measured(2.0),
        arity: (2, 2),
        value: |a| binary(a, forms::artanh_ratio),
        sweep: Some(|a, place, z, out| slices::sweep(a, place, z, out, |a| binary(a, forms::artanh_ratio))),
        shown: Some(|a| with(a, |[x, big]| Expr::call("atanh", [x / big]))),
        ..FORM
    },
    Row {
        name: "sphere_force",
        accuracy: Accuracy::Measured(9.0),
        arity: (2, 2),
        value: |a| binary(a, forms::sphere_force),
        sweep: Some(|a, place, z, out| slices::sweep(a, place, z, out, |a| binary(a, forms::sphere_force))),
        shown: Some(|a| with(a, |[a, big]| ((big.power(2) + a.power(2)) * Expr::call("atanh", [a / big]) - a * big) / Expr::integer(2))),
        ..FORM
    },
    Row {
        name: "hyperboloid_force",
        accuracy: Accuracy::Measured(6.0),
        arity: (2, 2),
        value: |a| binary(a, forms::hyperboloid_force),
        shown: Some(|a| with(a, |[a, b]| ((a.power(2) - b.power(2)) * Expr::call("atan", [a / b]) + a * b) / Expr::integer(2))),
        ..FORM
    },
    Row {
        name: "worn_sphere_slope",
        accuracy: Accuracy::Measured(5.0),
        arity: (3, 3),
        value: |a| ternary(a, forms::worn_sphere_slope),
        shown: Some(|a| with(a, |[b, x, big]| Expr::call("atanh", [leg(x, b) / leg(big, b)]))),
        ..FORM
    },
    Row {
        name: "worn_sphere_force",
        accuracy: Accuracy::Measured(12.0),
        arity: (3, 3),
        value: |a| ternary(a, forms::worn_sphere_force),
        shown: Some(|a| {
            with(a, |[b, a, big]| {
                let (w, c) = (leg(a, b), leg(big, b));
                ((big.power(2) + a.power(2)) * Expr::call("atanh", [&w / &c]) - w * c) / Expr::integer(2)
            })
        }),
        ..FORM
    },
    Row {
        name: "capped_sphere_force",
        accuracy: Accuracy::Measured(16.0),
        arity: (3, 3),
        value: |a| ternary(a, forms::capped_sphere_force),
        shown: Some(|a| {
            with(a, |[b, a, big]| {
                let (w, c) = (leg(a, b), leg(big, b));
                let logarithm = Expr::call("ln", [(big + a) / (&c + &w)]);
                ((big.power(2) + a.power(2)) * logarithm - big * a + w * c) / Expr::integer(2)
            })
        }),
        ..FORM
    },
    Row {
        name: "worn_hyperboloid_slope",
        accuracy: Accuracy::Measured(4.0),
        arity: (3, 3),
        value: |a| ternary(a, forms::worn_hyperboloid_slope),
        shown: Some(|a| with(a, |[b, x, scale]| Expr::call("atan", [leg(x, b) / hypotenuse(scale, b)]))),
        ..FORM
    },
    Row {
        name: "worn_hyperboloid_force",
        accuracy: Accuracy::Measured(9.0),
        arity: (3, 3),
        value: |a| ternary(a, forms::worn_hyperboloid_force),
        shown: Some(|a| {
            with(a, |[b, a, scale]| {
                let (w, c) = (leg(a, b), hypotenuse(scale, b));
                ((a.power(2) - scale.power(2)) * Expr::call("atan", [&w / &c]) + w * c) / Expr::integer(2)
            })
        }),
        ..FORM
    },
    // ∫₀^a n x^(n−1) asin(x/r) dx
    Row {
        name: "outside_power",
        accuracy: Accuracy::Measured(40.0),
        arity: (3, 3),
        value: |a| ternary(a, forms::outside_power),
        shown: Some(|a| with(a, |[n, a, r]| outside_power(n, a, r))),
        ..FORM
    },
    Row {
        name: "pressure_power",
        accuracy: Accuracy::Measured(7.0),
        arity: (3, 3),
        value: |a| ternary(a, forms::pressure_power),
        shown: Some(|a| with(a, |[n, s, a]| pressure_power(n, s, a))),
        ..FORM
    },
    Row {
        name: "sphere_pressure",
        accuracy: Accuracy::Measured(8.0),
        arity: (3, 3),
        value: |a| ternary(a, forms::sphere_pressure),
        shown: Some(|a| {
            with(a, |[s, a, big]| {
                let (w, c) = (leg(a, s), leg(big, s));
                let outer = big + &c;
                chi((a + &w) / &outer) - chi((a - &w) / &outer) + big / &c * Expr::call("atanh", [&w / &c])
            })
        }),
        ..FORM
    },
    Row {
        name: "hyperboloid_pressure",
        accuracy: Accuracy::Measured(6.0),
        arity: (3, 3),
        value: |a| ternary(a, forms::hyperboloid_pressure),
        shown: Some(|a| {
            with(a, |[s, a, b]| {
                let (w, c) = (leg(a, s), hypotenuse(b, s));
                let outer = b + &c;
                ti((a + &w) / &outer) - ti((a - &w) / &outer) + b / &c * Expr::call("atan", [&w / &c])
            })
        }),
        ..FORM
    },
    // ∫_M^a x^(2k)/√((x²−M²)(x²−m²)) dx with M = max(b, r), m = min(b, r)
    Row {
        name: "elliptic_moment",
        accuracy: Accuracy::Measured(14.0),
        arity: (4, 4),
        value: |a| match a {
            [k, b, s, a] => whole_order(*k).map_or(f64::NAN, |k| forms::elliptic_moment(k, *b, *s, *a)),
            _ => f64::NAN,
        },
        shown: Some(|a| match a {
            [k, b, s, a] => k.as_integer().map_or_else(Expr::zero, |k| elliptic_moment(k, b, s, a)),
            _ => Expr::zero(),
        }),
        ..FORM
    },
    // ∫_M^a dx/((x² ± w²)√((x²−M²)(x²−m²))) with M = max(b, r), m = min(b, r)
    Row {
        name: "elliptic_pole",
        accuracy: Accuracy::Measured(10.0),
        arity: (5, 5),
        value: |a| match a {
            [sign, w, b, s, a] => forms::elliptic_pole(*sign, *w, *b, *s, *a),
            _ => f64::NAN,
        },
        shown: Some(|own| with(own, |[sign, w, b, s, a]| elliptic_pole(sign, w, b, s, a))),
        ..FORM
    },
];

/// Runs `shape` on exactly N arguments; a wrong number cannot be built and shows as 0.
fn with<const N: usize>(arguments: &[Expr], shape: impl Fn(&[Expr; N]) -> Expr) -> Expr {
    <&[Expr; N]>::try_from(arguments).map_or_else(|_| Expr::zero(), shape)
}

/// Calls a segment form; without an upper end the segment reaches to x.
fn segment(a: &[f64], f: fn(u32, f64, f64, f64) -> f64) -> f64 {
    match a {
        [k, b, x] => order(*k).map_or(f64::NAN, |k| f(k, *b, f64::INFINITY, *x)),
        [k, b, c, x] => order(*k).map_or(f64::NAN, |k| f(k, *b, *c, *x)),
        _ => f64::NAN,
    }
}

/// Legendre's χ₂.
fn chi(z: Expr) -> Expr {
    Expr::call("legendre_chi2", [z])
}

/// The inverse tangent integral Ti₂.
fn ti(z: Expr) -> Expr {
    Expr::call("inverse_tangent_integral", [z])
}

fn gamma(u: Expr) -> Expr {
    Expr::call("gamma", [u])
}

/// √(u² − v²).
fn leg(u: &Expr, v: &Expr) -> Expr {
    (u.power(2) - v.power(2)).sqrt()
}

/// √(u² + v²).
fn hypotenuse(u: &Expr, v: &Expr) -> Expr {
    (u.power(2) + v.power(2)).sqrt()
}

/// S_n = ∫_s^a xⁿ/√(x²−s²) dx: elementary for small whole n by n S_n = a^(n−1) w + (n−1) s² S_(n−2), else by ₂F₁.
fn pressure_power(n: &Expr, s: &Expr, a: &Expr) -> Expr {
    const HIGHEST: i64 = 40;
    let w = leg(a, s);
    let Some(whole) = n.as_integer().filter(|n| (0..=HIGHEST).contains(n)) else { return pressure_power_in_one_term(n, s, a) };
    // S_n = w·P(a, s) + c·s^n·arcosh(a/s), the last only for even n.
    let (mut start, mut factor, mut polynomial) = (whole % 2, Expr::one(), Vec::new());
    if start == 1 {
        polynomial.push(Expr::one());
    }
    while start < whole {
        start += 2;
        let step = Expr::ratio(start - 1, start) * s.power(2);
        polynomial = polynomial.iter().map(|term| term * &step).collect();
        factor = factor * step;
        polynomial.push(a.power(start - 1) / Expr::integer(start));
    }
    let with_root = if whole == 0 { Expr::zero() } else { w * over_whole_denominator(&Expr::sum(polynomial)) };
    if whole % 2 == 1 { with_root } else { with_root + factor * Expr::call("acosh", [a / s]) }
}

/// ∫_s^a xⁿ/√(x²−s²) dx = a^(n−1) √(a²−s²) ₂F₁(1, (1−n)/2; 3/2; 1−s²/a²) for any real n > −1 and 0 < s < a, one term where the
/// elementary form has n/2 of them.
pub fn pressure_power_in_one_term(n: &Expr, s: &Expr, a: &Expr) -> Expr {
    let (two, one) = (Expr::integer(2), Expr::one());
    let arguments = [one.clone(), (&one - n) / &two, Expr::ratio(3, 2), &one - (s / a).power(2)];
    a.pow(&(n - one)) * leg(a, s) * Expr::call("hyp2f1", arguments)
}

/// Returns `k` as the order of an elliptic moment: −1 or a whole number from 0 to 400.
fn whole_order(k: f64) -> Option<i32> {
    if k == -1.0 { Some(-1) } else { order(k).and_then(|k| k.try_into().ok()) }
}

/// E_k for k = −1, 0 and 1 by elliptic integrals, for larger k by those of 0 and 1.
fn elliptic_moment(k: i64, b: &Expr, s: &Expr, a: &Expr) -> Expr {
    let moment = |k: i64| Expr::call("elliptic_moment", [Expr::integer(k), b.clone(), s.clone(), a.clone()]);
    if k > 1 {
        let Some([first, second, root]) = elliptic_moment_parts(k, b, s, a).pop() else { return moment(k) };
        return first * moment(0) + second * moment(1) + root * leg(a, b) * leg(a, s);
    }
    let (big, small) = (Expr::call("max", [b.clone(), s.clone()]), Expr::call("min", [b.clone(), s.clone()]));
    let ratio = leg(a, &big) / leg(a, &small);
    if k == -1 {
        // ∫ sin²/Δ dθ = ⅓ sin³φ R_D(cos²φ, Δ²(φ), 1), which keeps its digits at r = 0, unlike (F − E)/m.
        let (cosine, one) = ((leg(&big, &small) / leg(a, &small)).power(2), Expr::one());
        let delta = &cosine * (a / &big).power(2);
        let part = ratio.power(3) / Expr::integer(3) * Expr::call("elliprd", [cosine, delta, one]);
        return part / big.power(3) + ratio / (a * big.power(2));
    }
    let (angle, parameter) = (Expr::call("asin", [ratio.clone()]), (&small / &big).power(2));
    let first = Expr::call("ellipf", [angle.clone(), parameter.clone()]);
    let second = Expr::call("ellipe", [angle, parameter]);
    match k {
        0 => first / big,
        1 => big * (first - second) + a * ratio,
        _ => moment(k),
    }
}

/// The integral with a pole by Carlson's integrals, as [`forms::elliptic_pole`] computes it.
fn elliptic_pole(sign: &Expr, w: &Expr, b: &Expr, s: &Expr, a: &Expr) -> Expr {
    let (big, small) = (Expr::call("max", [b.clone(), s.clone()]), Expr::call("min", [b.clone(), s.clone()]));
    let cosine = (leg(&big, &small) / leg(a, &small)).power(2);
    let delta = &cosine * (a / &big).power(2);
    // ±(x² ± w²), which is positive.
    let beside = |x: &Expr| w.power(2) + sign * x.power(2);
    let (at_edge, at_large) = (beside(a), beside(&big));
    let first = Expr::call("elliprf", [delta.clone(), Expr::one(), cosine.clone()]);
    let third = Expr::call("elliprj", [delta, Expr::one(), cosine.clone(), &cosine * at_edge / &at_large]);
    let factor = (a.power(2) - big.power(2)) * cosine / (Expr::integer(3) * &at_large);
    sign * leg(a, &big) / (leg(a, &small) * &big * at_large) * (first - sign * factor * third)
}

/// α, β, γ of E_k = α E_0 + β E_1 + γ √((a²−b²)(a²−s²)) for every k up to the highest, polynomials in the squares of a, b and s.
///
/// From (2k−1)E_k = (2k−2)(b²+s²)E_(k−1) − (2k−3)b²s²E_(k−2) + a^(2k−3)√((a²−b²)(a²−s²)).
pub fn elliptic_moment_parts(highest: i64, b: &Expr, s: &Expr, a: &Expr) -> Vec<[Expr; 3]> {
    let (total, product) = (b.power(2) + s.power(2), (b * s).power(2));
    let (zero, one) = (Expr::zero, Expr::one);
    let mut list = vec![[one(), zero(), zero()], [zero(), one(), zero()]];
    let symbol = Symbol::new("a");
    for j in 2..=highest {
        let mut next = [zero(), zero(), a.power(2 * j - 3)];
        let [.., before, own] = list.as_slice() else { break };
        for (sum, (one, two)) in next.iter_mut().zip(own.iter().zip(before)) {
            let step = Expr::integer(2 * j - 2) * &total * one - Expr::integer(2 * j - 3) * &product * two + &*sum;
            *sum = expanded(&(step / Expr::integer(2 * j - 1)), &symbol).unwrap_or_else(|_| zero());
        }
        list.push(next);
    }
    list
}
