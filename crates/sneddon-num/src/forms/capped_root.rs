//! Force of a sphere that ends at a radius inside the contact: a spherical cap.

use super::root_family::in_sphere;
use crate::stable::{exponent, ldexp, leg};

/// Force of a sphere's cap of radius `b` inside a contact of radius `a`: `∫_0^b r^3 / (sqrt(R^2-r^2) sqrt(a^2-r^2)) dr`
/// `= ((R^2 + a^2) L - R a + sqrt(R^2-b^2) sqrt(a^2-b^2)) / 2`, `L = ln((R + a) / (sqrt(R^2-b^2) + sqrt(a^2-b^2)))`.
///
/// Domain: `0 <= b <= R`, `b <= a`, on both sides of `a = R`; NaN elsewhere.
///
/// Up to `L = 1` by `(2 R a sinh^2 L - (R^2 + a^2)(sinh 2L - 2L)/2) / 2`, in which two thirds cancel at most;
/// `L` itself from a sum of positive terms.
///
/// Accuracy: measured at most 11 ulp. Source: MDR chapter (3.27), with `P/2 - r^2 = D cosh φ`, `P = R^2 + a^2`, `2D = R^2 - a^2`.
///
/// ```
/// use sneddon_num::forms::{capped_sphere_force, sphere_force};
/// assert!((capped_sphere_force(1.0, 1.0, 3.0) / sphere_force(1.0, 3.0) - 1.0).abs() < 1e-15);
/// ```
pub fn capped_sphere_force(b: f64, a: f64, r: f64) -> f64 {
    if !(b >= 0.0 && b <= a && a.is_finite() && in_sphere(b, r)) {
        return f64::NAN;
    }
    if b == 0.0 {
        return 0.0;
    }
    // The force is a square of lengths; in units of b none of its parts leaves the range unless it does itself.
    let e = i64::from(exponent(b));
    let (b, a, r) = (ldexp(b, -e), ldexp(a, -e), ldexp(r, -e));
    let (w, c) = (leg(a, b), leg(r, b));
    let logarithm = (b / (c + w) * (b / (r + c) + b / (a + w))).ln_1p();
    if logarithm > 1.0 {
        let sum = r * r + a * a;
        return ldexp(0.5 * (sum * logarithm - b * b * (sum - b * b) / (r * a + w * c)), 2 * e);
    }
    // sinh z − z = z³/6 tail; with L ~ b²/(2Ra) for a small cap, every factor below stays in range.
    let (sine, z) = (logarithm.sinh(), 2.0 * logarithm);
    // 1/((2k)(2k+1)), k = 11 … 2: the last term is below 2^-60 of the sum.
    let tail = (2..=11).rev().fold(1.0, |sum, k| 1.0 + sum * z * z / f64::from(2 * k * (2 * k + 1)));
    let excess = ((r * z) * (r * z) + (a * z) * (a * z)) * (z / 6.0 * tail);
    ldexp((r * sine) * (a * sine) - 0.25 * excess, 2 * e)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// b, a, R and the printed formula at 2500 digits (mpmath).
    const VALUES: [(f64, f64, f64, f64); 12] = [
        (1.0, 1.0, 3.0, 0.232_867_951_399_863_27),
        (1.0, 1.5, 1.25, 0.218_937_026_508_753_5),
        (1.0, 1.0, 1.007_812_5, 2.292_392_543_085_703),
        (0.5, 40.0, 60.0, 6.510_906_499_481_653e-06),
        (0.000_976_562_5, 1.0, 2.0, 1.136_868_828_967_304e-13),
        (1.0, 71161.5, 950.75, 3.695_121_651_121_424e-09),
        (1e-09, 3e-09, 1.0, 8.662_820_994_079_607e-29),
        (1e-09, 1.0, 1000000000.0, 2.500_000_000_000_000_7e-46),
        (0.75, 2.0, 0.75, 0.149_334_176_665_495_67),
        (1.0, 1.000_000_000_000_000_2, 1.000_000_000_000_000_2, 17.175_253_104_278_614),
        (3.0, 3.25, 100000000.0, 1.033_333_333_333_333_7e-07),
        (100000.0, 150000.0, 1e200, 2.002_710_206_251_928e-186),
    ];

    #[test]
    fn edges_of_the_domain() {
        assert_eq!(capped_sphere_force(0.0, 1.0, 2.0), 0.0);
        for (b, a, r) in [(-1.0, 1.0, 2.0), (2.0, 1.0, 3.0), (2.0, 3.0, 1.0), (f64::NAN, 1.0, 1.0), (1.0, f64::INFINITY, 2.0)] {
            assert!(capped_sphere_force(b, a, r).is_nan());
        }
    }

    #[test]
    fn has_its_digits() {
        for (b, a, r, truth) in VALUES {
            let value = capped_sphere_force(b, a, r);
            assert!((value / truth - 1.0).abs() < 11.0 * f64::EPSILON, "{b} {a} {r}: {value:e} {truth:e}");
        }
    }
}
