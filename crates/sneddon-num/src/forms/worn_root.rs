//! Slopes and forces of the sphere and the hyperboloid worn flat at the tip.

use super::root_family::{hyperboloid_force, hyperboloid_force_core, in_hyperboloid, in_sphere, sphere_force, sphere_force_core};
use crate::double_double::two_sum;
use crate::stable::{asinh, exponent, ldexp, leg};

/// Slope integral of a sphere worn flat to radius `b`: `∫_b^x r / (sqrt(R^2-r^2) sqrt(x^2-r^2)) dr`
/// `= asinh(w / sqrt(R^2 - x^2))`, `w = sqrt(x^2 - b^2)`.
///
/// Domain: `0 <= b`, `x <= R`; zero for `x <= b`, infinite at `x = R`, NaN elsewhere.
///
/// Accuracy: measured at most 2.4 ulp. Source: MDR chapter, worn profiles.
///
/// ```
/// use sneddon_num::forms::worn_sphere_slope;
/// assert!((worn_sphere_slope(0.0, 1.0, 2.0) - 0.5_f64.atanh()).abs() < 1e-15);
/// ```
pub fn worn_sphere_slope(b: f64, x: f64, r: f64) -> f64 {
    if !(b >= 0.0 && in_sphere(x, r)) {
        return f64::NAN;
    }
    if x <= b { 0.0 } else { asinh(leg(x, b) / leg(r, x)) }
}

/// Force of a sphere worn flat to radius `b`: `((R^2 + a^2) artanh(w/C) - w C) / 2`, `w = sqrt(a^2 - b^2)`,
/// `C = sqrt(R^2 - b^2)`; equals `∫_b^a r^3 / (sqrt(R^2-r^2) sqrt(a^2-r^2)) dr`.
///
/// Domain: `0 <= b`, `a <= R`; zero for `a <= b`, infinite at `a = R`, NaN elsewhere. Since
/// `R^2 + a^2 = C^2 + w^2 + 2 b^2`, it is a whole sphere's force plus `b^2 artanh(w/C)`: nothing cancels.
///
/// Accuracy: measured at most 5.6 ulp. Source: MDR chapter, worn profiles.
///
/// ```
/// use sneddon_num::forms::{sphere_force, worn_sphere_force};
/// assert_eq!(worn_sphere_force(0.0, 1.0, 3.0), sphere_force(1.0, 3.0));
/// ```
pub fn worn_sphere_force(b: f64, a: f64, r: f64) -> f64 {
    if !(b >= 0.0 && in_sphere(a, r)) {
        return f64::NAN;
    }
    if a <= b {
        return 0.0;
    }
    if b == 0.0 {
        return sphere_force(a, r);
    }
    // In units of a, not of R: a^3 / R may be far below R^2.
    let e = i64::from(exponent(a));
    let (a, b, r) = (ldexp(a, -e), ldexp(b, -e), ldexp(r, -e));
    let (w, c) = (rounded_leg(a, b), leg(r, b));
    let slope = asinh(w / leg(r, a));
    ldexp(sphere_force_core(w, c, slope) + b * b * slope, 2 * e)
}

/// Slope integral of a hyperboloid worn flat to radius `b`: `∫_b^x r / (sqrt(B^2+r^2) sqrt(x^2-r^2)) dr`
/// `= atan2(w, sqrt(B^2 + b^2))`, `w = sqrt(x^2 - b^2)`.
///
/// Domain: `0 <= b`, `B > 0`, finite; zero for `x <= b`, NaN elsewhere.
///
/// Accuracy: measured at most 1.9 ulp. Source: MDR chapter, worn profiles.
///
/// ```
/// use sneddon_num::forms::worn_hyperboloid_slope;
/// assert_eq!(worn_hyperboloid_slope(0.0, 2.0, 2.0), std::f64::consts::FRAC_PI_4);
/// ```
pub fn worn_hyperboloid_slope(b: f64, x: f64, scale: f64) -> f64 {
    if !(b >= 0.0 && in_hyperboloid(x, scale)) {
        return f64::NAN;
    }
    if x <= b { 0.0 } else { leg(x, b).atan2(scale.hypot(b)) }
}

/// Force of a hyperboloid worn flat to radius `b`: `∫_b^a r^3 / (sqrt(B^2+r^2) sqrt(a^2-r^2)) dr`
/// `= ((w^2 - C^2) atan(w/C) + w C)/2 + b^2 atan(w/C)`, `w = sqrt(a^2 - b^2)`, `C = sqrt(B^2 + b^2)`.
///
/// Domain: `0 <= b`, `B > 0`, finite; zero for `a <= b`, NaN elsewhere.
///
/// Accuracy: measured at most 4.4 ulp. Source: the whole hyperboloid's force after
/// `r^2 = b^2 + rho^2`.
///
/// ```
/// use sneddon_num::forms::{hyperboloid_force, worn_hyperboloid_force};
/// assert_eq!(worn_hyperboloid_force(0.0, 1.0, 3.0), hyperboloid_force(1.0, 3.0));
/// ```
pub fn worn_hyperboloid_force(b: f64, a: f64, scale: f64) -> f64 {
    if !(b >= 0.0 && in_hyperboloid(a, scale)) {
        return f64::NAN;
    }
    if a <= b {
        return 0.0;
    }
    if b == 0.0 {
        return hyperboloid_force(a, scale);
    }
    let e = i64::from(exponent(a));
    let (a, b, scale) = (ldexp(a, -e), ldexp(b, -e), ldexp(scale, -e));
    let (w, c) = (rounded_leg(a, b), scale.hypot(b));
    ldexp(hyperboloid_force_core(w, c) + b * b * w.atan2(c), 2 * e)
}

/// `sqrt((a-b)(a+b))` with one rounding: the force takes its third power.
fn rounded_leg(a: f64, b: f64) -> f64 {
    two_sum(a, -b).mul(two_sum(a, b)).sqrt().value()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(worn_sphere_force(0.5, 1.0, 1.0), f64::INFINITY);
        assert_eq!(worn_sphere_slope(2.0, 1.0, 3.0), 0.0);
        assert_eq!(worn_hyperboloid_force(2.0, 1.0, 3.0), 0.0);
        for value in [
            worn_sphere_slope(-1.0, 0.5, 1.0),
            worn_sphere_force(f64::NAN, 0.5, 1.0),
            worn_hyperboloid_slope(f64::NAN, 0.5, 1.0),
            worn_hyperboloid_force(-1.0, 0.5, 1.0),
        ] {
            assert!(value.is_nan());
        }
    }
}
