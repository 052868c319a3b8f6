//! Named shapes at extreme sizes, depths and exponents against 25 digits, what overflows on the way, and shapes that blend into simpler ones.
#![cfg(feature = "scene")]
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon::scene::{Quantity, Row, Run, scene};
use sneddon_checks::seeds::cases;

fn rows(profile: &str, modulus: &str, load: &str) -> Vec<Row> {
    let text = format!(
        "[profile]\n{profile}\n[material]\neffective_modulus = {modulus}\n[load]\n{load}\n[outputs]\nquantities = ['d', 'F', 'a', 'k']\n"
    );
    let own = scene(&text).unwrap_or_else(|error| panic!("{error} in\n{text}"));
    let solution = own.solution().unwrap();
    let run = Run::new(&own, &solution).unwrap();
    (0..own.loads.len()).map(|index| run.row(index).unwrap()).collect()
}

fn row(profile: &str, modulus: &str, load: &str) -> Row {
    rows(profile, modulus, load).remove(0)
}

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

/// Lengths from 1e-9 to 1e6, d/R from 1e-14 on, exponents from 1e-3 to 1e4, moduli from 1 to 1e12: 4 ulp times the condition number.
#[test]
fn every_shape_at_its_extremes() {
    let (mut worst, mut count) = (0.0f64, 0);
    let mut faults = Vec::new();
    for line in include_str!("../oracle/scene_extremes.csv").lines().skip(1).step_by(cases(7, 1)) {
        let [shape, parameters, d, a, force, condition] = line.split(';').collect::<Vec<_>>().try_into().unwrap();
        let condition = number(condition).max(1.0);
        let profile = format!("shape = '{shape}'\nparameters = {{ {parameters} }}");
        for modulus in [1.0, 1e12] {
            let by_depth = row(&profile, &format!("{modulus:?}"), &format!("depth = {d}"));
            if number(a) < f64::MIN_POSITIVE {
                // No double is as small as this radius: that is said, and not answered.
                assert!(by_depth.value(Quantity::Radius).is_none() && by_depth.value(Quantity::Force).is_none(), "{line}: {by_depth:?}");
                continue;
            }
            if number(force) * modulus < f64::MIN_POSITIVE {
                assert!(by_depth.value(Quantity::Force).is_none(), "{line}: {by_depth:?}");
                continue;
            }
            let by_force = row(&profile, &format!("{modulus:?}"), &format!("force = {:?}", number(force) * modulus));
            for (what, found, expected) in [
                ("F", by_depth.value(Quantity::Force), number(force) * modulus),
                ("a", by_depth.value(Quantity::Radius), number(a)),
                ("k", by_depth.value(Quantity::Stiffness), 2.0 * number(a) * modulus),
                ("d of F", by_force.value(Quantity::Depth), number(d)),
            ] {
                let Some(found) = found else {
                    faults.push(format!("{line}: no {what}: {:?}", by_depth.indented.findings));
                    continue;
                };
                // From the force to the depth the errors of the force count with the inverse of its exponent, at most 1.
                let ulps = (found - expected).abs() / (f64::EPSILON * expected);
                if ulps > 4.0 * condition {
                    faults.push(format!("{line}: {what} = {found:?} is off by {ulps:.1} ulp"));
                }
                worst = worst.max(ulps / condition);
                count += 1;
            }
        }
    }
    println!("{count} values, largest error {worst:.2} ulp times the condition number");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(count > 700 / cases(7, 1), "{count}");
}

/// R² or a³ leave the range of doubles, and the force does not: F = (4/3) E* √R d^(3/2); what has no number says so.
#[test]
fn what_overflows_on_the_way_is_answered() {
    for (radius, modulus, depth) in
        [("1e200", "1e-100", "1e-180"), ("1e-200", "1e150", "1e-220"), ("1e250", "1", "1e-280"), ("1e-280", "1e300", "1e-290")]
    {
        let (r, e, d) = (number(radius), number(modulus), number(depth));
        let log = (4.0f64 / 3.0).ln() + e.ln() + 0.5 * r.ln() + 1.5 * d.ln();
        let found = row(&format!("shape = 'paraboloid'\nparameters = {{ R = {radius} }}"), modulus, &format!("depth = {depth}"));
        let force = found.value(Quantity::Force).unwrap_or_else(|| panic!("{radius} {modulus} {depth}: {found:?}"));
        assert!((force.ln() - log).abs() < 1e-11, "{radius} {modulus} {depth}: {force:?}");
        let root = found.value(Quantity::Radius).unwrap();
        assert!((root.ln() - 0.5 * (r.ln() + d.ln())).abs() < 1e-11, "{root:?}");
    }
    let lost = row("shape = 'paraboloid'\nparameters = { R = 1e-300 }", "1e-300", "depth = 1e-300");
    let force = lost.values.iter().find(|(datum, _)| *datum == Quantity::Force).unwrap().1;
    assert!(force.unwrap_err().contains("too small"), "{lost:?}");
    let lost = row("shape = 'paraboloid'\nparameters = { R = 1e200 }", "1e200", "depth = 1e100");
    let force = lost.values.iter().find(|(datum, _)| *datum == Quantity::Force).unwrap().1;
    assert!(force.unwrap_err().contains("too large"), "{lost:?}");
}

/// A hyperboloid is a paraboloid at its tip and a cone far away; capped shapes are the cap below its end and the flank far beyond.
#[test]
fn shapes_blend_into_simpler_ones() {
    let force = |profile: &str, depth: f64| row(profile, "1", &format!("depth = {depth:?}")).value(Quantity::Force).unwrap();
    let paraboloid = |r: f64, d: f64| 4.0 / 3.0 * r.sqrt() * d.powf(1.5);
    let cone = |slope: f64, d: f64| 2.0 * d * d / (std::f64::consts::PI * slope);
    let close = |what: &str, value: f64, expected: f64, tolerance: f64| {
        assert!((value / expected - 1.0).abs() < tolerance, "{what}: {value:?} is not {expected:?}");
    };
    let theta = 0.2f64;
    for d in [1e-16, 1e-12, 1e-9] {
        // R = b²/h = 9/2.
        close("hyperboloid", force("shape = 'hyperboloid'\nparameters = { h = 0.5, b = 1.5 }", d), paraboloid(4.5, d), 1e-15 + d);
        close("ellipsoid", force("shape = 'ellipsoid'\nparameters = { b = 2, c = 2 }", d), paraboloid(2.0, d), 1e-15 + d);
    }
    for d in [1e9, 1e12] {
        let far = force("shape = 'hyperboloid'\nparameters = { h = 0.5, b = 1.5 }", d);
        close("hyperboloid", far, cone(1.0 / 3.0, d), 2.0 / d);
        let own = cone(theta.tan(), d);
        for capped in [
            "shape = 'cone-with-spherical-cap'\nparameters = { R = 0.5, theta = 0.2 }",
            "shape = 'cone-with-parabolic-cap'\nparameters = { b = 0.5, theta = 0.2 }",
            "shape = 'truncated-cone'\nparameters = { b = 0.5, theta = 0.2 }",
        ] {
            close(capped, force(capped, d), own, 2.0 / d);
        }
    }
    // A cap that is not left yet is the whole indenter, to the last digits.
    for d in [1e-9, 1e-4, 1e-3] {
        let sphere = force("shape = 'sphere'\nparameters = { R = 0.5 }", d);
        close("spherical cap", force("shape = 'cone-with-spherical-cap'\nparameters = { R = 0.5, theta = 0.2 }", d), sphere, 2e-15);
        let cap = force("shape = 'paraboloid-with-parabolic-cap'\nparameters = { P = 3, b = 0.5, R = 1 }", d);
        close("parabolic cap", cap, paraboloid(3.0, d), 2e-15);
    }
    // The ellipsoid with equal axes is the sphere.
    for a in [1e-6, 0.1, 1.9] {
        let at = |profile: &str| row(profile, "1", &format!("contact_radius = {a:?}")).value(Quantity::Force).unwrap();
        close("ellipsoid", at("shape = 'ellipsoid'\nparameters = { b = 2, c = 2 }"), at("shape = 'sphere'\nparameters = { R = 2 }"), 2e-15);
    }
    // A tiny flat end, a tiny cap.
    let tiny = force("shape = 'truncated-paraboloid'\nparameters = { b = 1e-12, R = 2 }", 0.1);
    close("truncated paraboloid", tiny, paraboloid(2.0, 0.1), 1e-15);
}

/// The error of the depth under a given force is an error of the line load and of its displacement. Under 1e-7 the tip is worn to a radius of 1,
/// which the contact exceeds by 6e-18; the references solve F(a) = 1e-7 by mpmath with 60 digits.
#[test]
fn line_loads_have_the_error_of_their_depth() {
    let text = "[profile]\nf = 'piecewise(0, r<b, (r^2-b^2)/(2*R))'\nparameters = { R = 5, b = 1 }\n[material]\neffective_modulus = 70\n\
                [load]\nforce = 1e-7\n[outputs]\nquantities = ['q', 'u_1d']\nat = [0.1, 0.99999]\n";
    let scene = scene(text).unwrap();
    let solution = scene.solution().unwrap();
    let run = Run::new(&scene, &solution).unwrap();
    let state = run.state(0, false).unwrap();
    // Each reference is the sum of a double and a remainder.
    for (curve, value, remainder) in
        [(Quantity::LineDisplacement, 7.142857142857143e-10, -1.6463e-26), (Quantity::LineLoad, 5e-8, 2.1563e-24)]
    {
        for (_, point) in run.curve(curve, Some(state)) {
            let (found, error) = point.value.unwrap();
            let off = ((found - value) - remainder).abs();
            assert!(off <= error && error < 1e-12 * value, "{curve:?}: {found:e} is off by {off:e}, and claims {error:e}");
        }
    }
}
