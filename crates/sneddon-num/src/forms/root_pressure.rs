//! Pressures of the sphere and the hyperboloid.

use crate::legendre;
use crate::special::{inverse_tangent_integral, legendre_chi2};
use crate::stable::{asinh, exponent, ldexp, leg};

/// Pressure of a sphere without its factor `E/pi`:
/// `∫_s^a g'(x) / sqrt(x^2 - s^2) dx`, `g = x artanh(x/R)`, `= chi2(u+) - chi2(u-) + (R/c) artanh(w/c)`,
/// `c = sqrt(R^2 - s^2)`, `w = sqrt(a^2 - s^2)`, `u+ = (a+w)/(R+c)`, `u- = s^2/((a+w)(R+c))`.
///
/// Domain: `0 <= s`, `0 <= a <= R`; zero for `s >= a`, infinite at `a = R`, NaN elsewhere.
///
/// Accuracy: measured at most 3.6 ulp, also for `s -> a` and `a -> R`.
///
/// Source: MDR chapter, pressure from g; Legendre's chi function.
///
/// ```
/// use sneddon_num::forms::sphere_pressure;
/// let shallow = sphere_pressure(3e-4, 5e-4, 1.0); // Hertz: 2 sqrt(a^2 - s^2) / R
/// assert!((shallow / 8e-4 - 1.0).abs() < 1e-6);
/// ```
pub fn sphere_pressure(s: f64, a: f64, r: f64) -> f64 {
    if !(s >= 0.0 && a >= 0.0 && r > 0.0 && a <= r && r.is_finite()) {
        return f64::NAN;
    }
    if s >= a {
        return 0.0;
    }
    if a == r {
        return f64::INFINITY;
    }
    let shallow = 2.0 * (leg(a, s) / r);
    let (s, a, r) = normalised(s, a, r);
    if r == f64::INFINITY {
        return shallow;
    }
    let (w, c) = (leg(a, s), leg(r, s));
    // artanh(w/c), with c^2 - w^2 = R^2 - a^2 taken from the exact difference R - a.
    let edge = r / c * asinh(w / leg(r, a));
    if w < 0.9 * c {
        // chi2(u+) - chi2(u-) = ∫_0^w artanh(y/R)/y dv, y^2 = s^2 + v^2: no difference, smooth until w -> c.
        let integral = legendre::integrate(|t, _| {
            // In units of a the square cannot overflow, and where it underflows y does not matter.
            let y = (s * s + (w * t) * (w * t)).sqrt();
            if y < 1e-9 * r { 1.0 / r } else { 0.5 * (2.0 * y / (r - y)).ln_1p() / y }
        });
        return w * integral + edge;
    }
    let sum = (a + w) * (r + c);
    (legendre_chi2((a + w) / (r + c)) - legendre_chi2(s * (s / sum))) + edge
}

/// Pressure of a hyperboloid without its factor `E h/(pi b)`:
/// `∫_s^a g'(x) / sqrt(x^2 - s^2) dx`, `g = x atan(x/b)`, `= Ti2(v+) - Ti2(v-) + (b/c) atan2(w, c)`,
/// `c = sqrt(b^2 + s^2)`, `w = sqrt(a^2 - s^2)`, `v+ = (a+w)/(b+c)`, `v- = s^2/((a+w)(b+c))`.
///
/// Domain: `s, a >= 0`, `b > 0`, finite; zero for `s >= a`, NaN elsewhere.
///
/// Accuracy: measured at most 2.7 ulp, also for `s -> a`.
///
/// Source: MDR chapter, pressure from g; inverse tangent integral.
///
/// ```
/// use sneddon_num::forms::hyperboloid_pressure;
/// let shallow = hyperboloid_pressure(3e-4, 5e-4, 1.0); // 2 sqrt(a^2 - s^2) / b
/// assert!((shallow / 8e-4 - 1.0).abs() < 1e-6);
/// ```
pub fn hyperboloid_pressure(s: f64, a: f64, b: f64) -> f64 {
    if !(s >= 0.0 && a >= 0.0 && b > 0.0 && a.is_finite() && b.is_finite()) {
        return f64::NAN;
    }
    if s >= a {
        return 0.0;
    }
    let shallow = 2.0 * (leg(a, s) / b);
    let blunt = b.hypot(s);
    let sharp = std::f64::consts::FRAC_PI_2 * (a.ln() + std::f64::consts::LN_2 - (b + blunt).ln() + b / blunt);
    let (s, a, b) = normalised(s, a, b);
    if b == f64::INFINITY {
        return shallow;
    }
    let (w, c) = (leg(a, s), b.hypot(s));
    if c < 1e-290 {
        return sharp; // a cone's logarithm; the arguments below would leave the range
    }
    let edge = b / c * w.atan2(c);
    if w < 4.0 * c {
        let integral = legendre::integrate(|t, _| {
            let y = (s * s + (w * t) * (w * t)).sqrt();
            if y < 1e-9 * b { 1.0 / b } else { y.atan2(b) / y }
        });
        return w * integral + edge;
    }
    // Here (a+w)/s > 8, so the difference keeps its digits.
    let high = (a + w) / (b + c);
    let low = s / (a + w) * (s / (b + c));
    (inverse_tangent_integral(high) - inverse_tangent_integral(low)) + edge
}

/// The three lengths divided by the power of two of `a`: the pressures depend on ratios only.
fn normalised(s: f64, a: f64, scale: f64) -> (f64, f64, f64) {
    let e = -i64::from(exponent(a));
    (ldexp(s, e), ldexp(a, e), ldexp(scale, e))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(sphere_pressure(1.0, 1.0, 2.0), 0.0);
        assert_eq!(sphere_pressure(0.5, 1.0, 1.0), f64::INFINITY);
        assert_eq!(hyperboloid_pressure(2.0, 1.0, 1.0), 0.0);
        assert!(sphere_pressure(0.5, 2.0, 1.0).is_nan());
        assert!(hyperboloid_pressure(0.5, 2.0, 0.0).is_nan());
        assert!(hyperboloid_pressure(f64::NAN, 2.0, 1.0).is_nan());
    }
}
