//! Independent libraries agree with ours, as far as their own measured accuracy reaches.
#![allow(clippy::unwrap_used)]

use approx::assert_relative_eq;
use sneddon::num::forms::pressure_power;
use sneddon::num::kappa::kappa;
use sneddon::num::special as own;

/// κ_n = (n/2) B(n/2, 1/2) by the beta function of `statrs`, which errs by up to 4e-13 between 0.1 and 20.
#[test]
fn kappa_is_a_beta_function() {
    for n in [0.2, 0.5, 1.0, 2.7, 9.0, 30.0] {
        assert_relative_eq!(kappa(n), n / 2.0 * statrs::function::beta::beta(n / 2.0, 0.5), max_relative = 4e-13);
    }
}

/// The same by the logarithm of the beta function of `special`, good to 2e-13 for small n.
#[test]
fn kappa_is_a_beta_function_by_logarithms_too() {
    use special::Beta;
    for n in [0.2f64, 0.5, 1.0, 2.7, 9.0] {
        assert_relative_eq!(kappa(n), n / 2.0 * (n / 2.0).ln_beta(0.5).exp(), max_relative = 2e-13);
    }
}

/// S_n(s, a) = (aⁿ/2) ∫ over t = (s/a)² …: with n < 0 it is an incomplete beta function,
/// S_n = (sⁿ/2) B_y(1/2, −n/2) at y = 1 − s²/a²; here by `special`, good to 1.5e-14.
#[test]
fn pressure_power_is_an_incomplete_beta_function() {
    use special::Beta;
    for (n, s) in [(-0.5f64, 0.3f64), (-0.25, 0.9), (-0.75, 0.05)] {
        let log_beta = 0.5f64.ln_beta(-n / 2.0);
        let incomplete = (1.0 - s * s).inc_beta(0.5, -n / 2.0, log_beta) * log_beta.exp();
        assert_relative_eq!(pressure_power(n, s, 1.0), s.powf(n) / 2.0 * incomplete, max_relative = 1.5e-14);
    }
}

/// Γ, ψ and erf of the two libraries; `statrs` is off by 1.4e-13 in Γ and by 1e-10 in erf, `special` by a few ulps.
#[test]
fn gamma_digamma_and_error_function_agree() {
    for z in [0.3f64, 1.7, 4.25, 11.5] {
        assert_relative_eq!(libm::tgamma(z), statrs::function::gamma::gamma(z), max_relative = 2e-13);
        assert_relative_eq!(libm::erf(z), statrs::function::erf::erf(z), max_relative = 1e-9);
        assert_relative_eq!(own::digamma(z), special::Gamma::digamma(z), max_relative = 1e-13);
    }
}
