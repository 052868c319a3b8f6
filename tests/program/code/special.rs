//! Profiles whose formulas have special functions that the languages lack: they are written with the functions.

use super::{Near, assert_in_c, cases, entry, judge_c, program_of};
use serde_json::Value;
use sneddon::code::{Language, write};
use sneddon::contact::Quantity;
use sneddon_checks::seeds::takes;

/// A name, a profile, its parameters, quantities and a claim.
type Special = (&'static str, &'static str, &'static [(&'static str, &'static str)], &'static [Quantity], f64);

/// Profiles with elliptic, Fresnel and hypergeometric functions and with slope angles, which the catalogue lacks, the quantities that are
/// compared, and their largest claim.
const SPECIAL: [Special; 33] = [
    ("arsinh", "h*asinh(r/b)", &[("b", "0.8"), ("h", "0.4")], G_AND_F, 16.0),
    ("arcsine", "h*asin(r/R)", &[("R", "1.7"), ("h", "0.4")], G_AND_F, 16.0),
    ("worn arsinh", "piecewise(0, r<c, h*(asinh(r/b)-asinh(c/b)))", &[("b", "1.3"), ("c", "0.4"), ("h", "0.4")], G_AND_F, 16.0),
    ("arctangent", "h*atan(r/w)", &[("h", "0.4"), ("w", "1.3")], &[Quantity::Pressure], 16.0),
    ("quadratic wave", "A*sin(k*r^2)+B*(1-cos(k*r^2))", &[("A", "0.4"), ("B", "0.3"), ("k", "1.1")], G_AND_F, 16.0),
    ("even arsinh", "h*(r*asinh(r/w)-sqrt(w^2+r^2)+w)", &[("h", "0.4"), ("w", "1.3")], G_AND_F, 16.0),
    ("binomial", "h*((1+r^2/b^2)^p-1)", &[("b", "0.8"), ("h", "0.4"), ("p", "1.35")], G_AND_F, 16.0),
    // Refused where one part has artanh(x/R) from the quotient and another from R - x.
    ("root of a whole power", "h*(1-(1-(r/R)^2)^(3/2))", &[("R", "1.7"), ("h", "0.4")], ALL_OF_RADIUS, 16.0),
    ("binomial below", "h*(1-(1-r^2/R^2)^p)", &[("R", "1.7"), ("h", "0.4"), ("p", "1.35")], G_AND_F, 16.0),
    ("worn power", "piecewise(0, r<b, C*(r^n-b^n))", &[("C", "0.9"), ("b", "0.3"), ("n", "1.7")], G_AND_F, 16.0),
    ("power to an end", "piecewise(C*r^n, r<b, C*b^n)", &[("C", "0.9"), ("b", "0.3"), ("n", "1.7")], G_AND_F, 16.0),
    ("shifted power", "piecewise(0, r<b, C*(r-b)^n)", &[("C", "0.9"), ("b", "0.3"), ("n", "1.7")], G_AND_F, 16.0),
    // 6328 where the difference of x² and (R sin θ)² is not factored.
    (
        "spherical cap",
        "piecewise(R-sqrt(R^2-r^2), r<R*sin(theta), (r-R*sin(theta))*tan(theta)+R-R*cos(theta))",
        &[("R", "1.7"), ("theta", "0.3")],
        &[Quantity::Equivalent, Quantity::Force, Quantity::ForceOfDepth],
        16.0,
    ),
    ("fractional cusp", "abs(r^1.2-b)", &[("b", "0.3")], G_AND_F, 16.0),
    ("worn arctangent", "piecewise(0, r<b, h*(atan(r/w)-atan(b/w)))", &[("b", "0.3"), ("h", "0.4"), ("w", "1.3")], FORCES, 16.0),
    ("grown polynomial", "r^2*h+(exp(r)-1)*r^5", &[("h", "0.4")], FORCES, 16.0),
    // Refused where the intervals of the piece beyond the kink ended before they came near to it.
    ("kink far inside", "abs(h*(1-1/(1+(r/w)^2))-c)", &[("c", "0.26"), ("h", "0.827"), ("w", "1.3")], G_AND_F, 16.0),
    // 51 for F of the fraction with the power series and the closed form alone.
    ("fraction", "r/(w+r)", &[("w", "1.3")], FORCES, 16.0),
    ("power of a fraction", "(h*r^2/(w^2+r^2))^3", &[("h", "0.4"), ("w", "1.3")], &[Quantity::ForceOfDepth], 16.0),
    ("difference of waves", "h*(k*r-sin(k*r))", &[("h", "0.4"), ("k", "2.2")], G_AND_F, 19.0),
    // 248 where a condition number comes from steps longer than a wave, and where 1 - cos(k r) cancels in f'.
    ("difference of waves of numbers", "0.4*(2.2*r-sin(2.2*r))", &[], G_AND_F, 16.0),
    ("square of a wave", "h*sin(k*r)^2", &[("h", "0.4"), ("k", "2.2")], G_AND_F, 16.0),
    ("power", "h*r^0.7", &[("h", "0.4")], &[Quantity::Pressure], 16.0),
    // Refused without the power series of p.
    ("power times a sphere", "r^4*(R-sqrt(R^2-r^2))", &[("R", "1.7")], &[Quantity::Pressure], 16.0),
    ("square times a sphere", "r^2*(R-sqrt(R^2-r^2))", &[("R", "1.7")], &[Quantity::Pressure], 16.0),
    // 30 where 1 - 1/(1 + u) cancels in f'.
    ("cube of a fraction", "(h*(1-1/(1+(r/w)^2)))^3", &[("h", "0.4"), ("w", "1.3")], G_AND_F, 16.0),
    // 260 where 1 - sqrt(1 - u) cancels in f'.
    ("square of a sphere", "0.875*r^2.5+(1-sqrt(1-r^2/4))^2", &[], G_AND_F, 16.0),
    // 20 without intervals that shrink toward the axis.
    ("cusp far inside", "sqrt(1+abs(r-b)/w)-1", &[("b", "0.3"), ("w", "1.3")], G_AND_F, 16.0),
    // 26 where the piece beyond a near kink gave up, because the small differences r - b are noise there.
    ("kink in a fraction", "r^2/(1+r^2)+piecewise(0, r<b, h*(r-b)^2)", &[("b", "0.3"), ("h", "0.4")], FORCES, 16.0),
    // 854 where the power series ends before the power of r, whose term it then misses.
    ("wave and a high power", "1-besselj(0,k*r)+h*r^10", &[("h", "0.4"), ("k", "2.2")], G_AND_F, 16.0),
    // 475 where the fractions of f' cancel.
    ("difference of fractions", "r^2/(2.59+r)-(r-ln(1+r))", &[], G_AND_F, 16.0),
    ("saturating of numbers", "1-exp(-r)", &[], G_AND_F, 16.0),
    ("truncated cone of numbers", "piecewise(0, r<0.9, r-0.9)", &[], &[Quantity::Radius], 7.0),
];
const FORCES: &[Quantity] = &[Quantity::Force, Quantity::ForceOfDepth];
const ALL_OF_RADIUS: &[Quantity] = &[Quantity::Equivalent, Quantity::Force, Quantity::Pressure];
const G_AND_F: &[Quantity] = &[Quantity::Equivalent, Quantity::Force];

#[test]
fn special_functions_are_as_accurate_in_c_as_they_claim() {
    let (mut sources, mut all) = (Vec::new(), Vec::new());
    for (number, (id, text, values, quantities, largest)) in SPECIAL.into_iter().enumerate() {
        let params: serde_json::Map<String, Value> = values.iter().map(|(name, value)| ((*name).to_owned(), (*value).into())).collect();
        let entry = entry(&serde_json::json!({"id": id, "f": text, "params": params}));
        let near = Near::new(&entry);
        for (index, own) in quantities.iter().enumerate() {
            if !takes(number + index, 2) {
                continue;
            }
            let made = program_of(&entry, *own, Language::C).unwrap_or_else(|| panic!("{id} {} is not written", own.key()));
            let claim = made.claims()[0].1.unwrap().ulps;
            assert!(claim <= largest, "{id} {}: a claim of {claim} ulp", own.key());
            let module = format!("m{}", sources.len());
            let cases = cases(&entry, &near, &module, *own, &made);
            assert!(cases.len() > 2, "{id} {}: {} values", own.key(), cases.len());
            all.extend(cases);
            sources.push((module, write(&made)));
        }
    }
    judge_c("special", &sources, &all);
}

/// f rises up to r = √2.946 and falls to 0: far out, nearly nothing remains of the integral of f′. The magnitudes of f′ integrate to twice
/// the value for the profile that stays at its maximum, less the value itself.
#[test]
fn the_condition_number_counts_the_cancellation_in_the_integral() {
    let text = "3*r/((1+r)*(2.946+r))";
    let own = entry(&serde_json::json!({"id": "pit", "f": text, "params": {}}));
    let held = text.replace('r', "sqrt(2.946)");
    let held = format!("piecewise({text}, r<sqrt(2.946), {held})");
    let held = entry(&serde_json::json!({"id": "held", "f": held, "params": {}}));
    let made = program_of(&own, Quantity::Equivalent, Language::C).unwrap();
    let claim = made.claims()[0].1.unwrap();
    assert!(claim.ulps <= 16.0 && claim.conditional.is_some(), "{claim:?}");
    let value = |entry: &super::Entry, x: f64| Near::new(entry).evaluator.equivalent(x).unwrap().estimate.value;
    let conditions: Vec<String> = [20.0, 1e3, 1e5, 1e7]
        .into_iter()
        .map(|x: f64| {
            let exact = value(&own, x);
            let slope = (value(&own, x * (1.0 + 1e-6)) - value(&own, x * (1.0 - 1e-6))) / 2e-6;
            let condition = (2.0 * value(&held, x) - exact) / exact + (slope / exact).abs();
            // One ulp is at most this part of a value.
            format!("fabs(sneddon_g({x:?})/{exact:?} - 1.0) < {:?}", (claim.ulps * condition + 1.0) * f64::EPSILON)
        })
        .collect();
    assert_in_c("pit", text, &[Quantity::Equivalent], &conditions);
}

/// f rises to 1 within a few units of length, which no interval of the quadrature shows at the largest radii.
#[test]
fn a_feature_far_below_the_contact_radius_is_not_missed() {
    let text = "(1-1/(1+r^2))^3";
    let own = entry(&serde_json::json!({"id": "far", "f": text, "params": {}}));
    let near = Near::new(&own);
    let conditions: Vec<String> = [1e9, 1e20, 1e40]
        .into_iter()
        .map(|x: f64| format!("fabs(sneddon_g({x:?})/{:?} - 1.0) < 5e-16", near.evaluator.equivalent(x).unwrap().estimate.value))
        .collect();
    assert_in_c("far", text, &[Quantity::Equivalent], &conditions);
}

/// Pressures of high powers by Euler's integral, whose factors overflow one by one. The references are integrals over u, x = r cosh u, by mpmath
/// with 40 digits.
#[test]
fn pressures_of_high_powers_are_written() {
    let values = [
        ("40.0", "3.0348047634246072788"),
        ("45.0", "3.203913272818424403"),
        ("60.5", "3.6799931110419112366"),
        ("100.0", "4.6809689862634763018"),
        ("1000.0", "14.590421616285109037"),
    ];
    let conditions = values.map(|(n, value)| format!("fabs(sneddon_p(0.5, 1.0, 1.0, 1.0, {n})/{value} - 1.0) < 4e-15"));
    assert_in_c("high powers", "C*r^n", &[Quantity::Pressure], &conditions);
}

/// Where the phase is between 38 and 47, the terms of the asymptotic series of Fresnel's integrals never become smaller than 1e-18 of their sum.
/// The reference is g(6.5) by mpmath.
#[test]
fn fresnel_integrals_have_values_where_their_series_begins() {
    let conditions: Vec<String> = (60..75).map(|i| format!("isfinite(sneddon_g({:?}, 1.0, 1.0, 1.0))", 0.1 * f64::from(i))).collect();
    let value = "fabs(sneddon_g(6.5, 1.0, 1.0, 1.0)/36.519011754768321 - 1.0) < 2e-16".to_owned();
    assert_in_c("fresnel", "r^2/(2*R)+h*(1-cos(q*r^2))", &[Quantity::Equivalent], &[conditions, vec![value]].concat());
}
