//! Profiles given as tables: values against 50 digits, closed forms, laws, convergence, and what is refused.
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used, clippy::indexing_slicing)]

use sneddon::contact::Contact;
use sneddon::num::Estimate;
use sneddon::num::quadrature::{Options, Panel, Point, integrate};
use sneddon::transform::inner::smoothed;
use sneddon::transform::{Cubic, Interpolation, Penalty, Profile, Quantities, TableError, TableProfile, TransformError};
use sneddon_checks::quantities::quantity;
use sneddon_checks::rows::rows;
use sneddon_checks::seeds::cases;

/// The generator of `oracle/tables.py`.
fn made(count: usize, fine: i32, kink: Option<usize>) -> TableProfile {
    let (mut state, mut lower, mut slope, mut pieces) = (12345_u64, 0.0, 0.0, Vec::new());
    for index in 0..count {
        state = (1_103_515_245 * state + 12345) % (1 << 31);
        let width = 2f64.powi(-fine - ((state >> 16) % 3) as i32);
        let rise = (((state >> 10) % 64) as f64 - 12.0) / 256.0 * width * 8.0;
        let bump = (((state >> 20) % 16) as f64 - 8.0) / 64.0;
        if Some(index) == kink {
            slope += 0.25;
        }
        let coefficients = [0.0, slope, rise / (2.0 * width) + 1.5 * bump * width, -bump];
        pieces.push(Cubic { lower, upper: lower + width, coefficients });
        lower += width;
        slope += rise;
    }
    TableProfile::from_cubics(pieces).unwrap()
}

#[test]
fn values_are_right_to_rounding_and_their_errors_honest() {
    let text = include_str!("../oracle/tables.csv");
    let tables =
        [("few", made(24, 2, None)), ("kinked", made(24, 2, Some(11))), ("hundred", made(100, 4, None)), ("many", made(10_000, 10, None))];
    for (name, own) in tables {
        for (quantities, most, promise) in [("gFG", 6e-16, 2.5e-14), ("u", 3e-16, 8e-15), ("p", 4e-16, 6e-14)] {
            let (mut worst, mut widest, mut share) = (0.0f64, 0.0f64, 0.0f64);
            for row in rows(text).iter().filter(|row| row[0] == name && quantities.contains(row[1])) {
                let (r, a, truth): (f64, f64, f64) = (row[2].parse().unwrap(), row[3].parse().unwrap(), row[4].parse().unwrap());
                let found = quantity(&own, row[1], r, a);
                let error = (found.value - truth).abs();
                // The reference itself is rounded to a double here.
                let at = format!("{name} {} at {r:?}, {a:?}: {found:?}, truth {truth:?}, off by {error:e}", row[1]);
                assert!(error <= found.error + 0.5 * f64::EPSILON * truth.abs(), "dishonest: {at}");
                worst = worst.max(error / truth.abs());
                widest = widest.max(found.error / truth.abs());
                share = share.max((error - 0.5 * f64::EPSILON * truth.abs()) / found.error);
            }
            if std::env::var_os("SHOW").is_some() {
                println!("{name} {quantities}: off by {worst:.1e}, promised {widest:.1e}, at most {share:.2} of the promise");
            }
            assert!(worst <= most && widest <= promise, "{name} {quantities}: off by {worst:e}, promised {widest:e}");
        }
    }
}

fn close(found: Estimate, truth: f64, tolerance: f64, what: &str) {
    assert!((found.value - truth).abs() <= tolerance * truth.abs(), "{what}: {found:?}, {truth:?}");
}

fn sampled(count: u32, last: f64, mut f: impl FnMut(f64) -> f64) -> (Vec<f64>, Vec<f64>) {
    // Spacings that differ by up to a third.
    let place = |i: u32| last * (f64::from(i) + if i % 2 == 1 { 0.15 } else { 0.0 }) / f64::from(count);
    let r: Vec<f64> = (0..=count - count % 2).map(place).collect();
    let z = r.iter().map(|r| f(*r)).collect();
    (r, z)
}

#[test]
fn points_of_a_cubic_give_its_exact_transform() {
    let (r, z) = sampled(200, 2.0, |r| 1.0 + r * r * (2.0 + r) / 8.0);
    let own = Profile::from_points(&r, &z, Interpolation::MonotoneCubic).unwrap();
    assert_eq!(own.extrapolated(), None);
    let kappa = 0.75 * std::f64::consts::PI;
    for x in [1e-3, 0.1, 0.73, 1.999, 2.0] {
        close(own.equivalent(x).unwrap().estimate, (4.0 + kappa * x) * x * x / 8.0, 1e-11, "g");
        let force = (2.0 * 4.0 / 3.0 + kappa * 0.75 * x) * x * x * x / 8.0;
        close(own.force(x).unwrap().estimate, force, 1e-11, "F");
        close(own.height(x).unwrap().estimate, x * x * (2.0 + x) / 8.0, 1e-9, "f");
    }
    let (r, z) = sampled(40, 2.0, |r| r * r / 4.0);
    let contact = Contact::new(Profile::from_points(&r, &z, Interpolation::MonotoneCubic).unwrap(), 3.0, None, 1e-12);
    // Hertz with R = 2: F = 4/3 E* a³/R, p = 2E*√(a²−r²)/(πR), U = 2E* a⁵/15 · 1.
    let a: f64 = 1.3;
    close(contact.force(a).unwrap().estimate, 2.0 * a.powi(3), 1e-13, "F");
    let pressure = contact.pressure(0.5, a).unwrap().unwrap().estimate;
    close(pressure, 3.0 / std::f64::consts::PI * (a * a - 0.25).sqrt(), 1e-12, "p");
    close(contact.pressure(0.0, a).unwrap().unwrap().estimate, 3.0 / std::f64::consts::PI * a, 1e-12, "p at the axis");
    close(contact.energy(a).unwrap().estimate, 3.0 * 2.0 * a.powi(5) / 15.0, 1e-12, "U");
    close(contact.contact_radius(0.5 * a * a).unwrap().estimate, a, 1e-12, "a");
}

#[test]
fn force_pressure_depth_and_energy_obey_their_laws() {
    let own = made(cases(12, 100), 4, None);
    let last = own.limit();
    for a in [0.77 * last, 0.3 * last].into_iter().take(cases(1, 2)) {
        let (g, force, whole) = (own.equivalent(a).unwrap().estimate, own.force(a).unwrap().estimate, own.integral(a).unwrap().estimate);
        close(whole, a * g.value - force.value, 1e-13, "G = a g − F");
        // F/(2E*) = ∫ p π/E* r dr with r = a sin t, piece by piece.
        let mut places: Vec<f64> = own.breakpoints_below(a).into_iter().step_by(5).map(|b| (b / a).asin()).collect();
        places.insert(0, 0.0);
        places.push(std::f64::consts::FRAC_PI_2);
        let panels: Vec<Panel> = places.windows(2).map(|p| Panel::smooth(p[0], p[1])).collect();
        let mut integrand = |point: Point| {
            let r = a * point.x.sin();
            own.pressure(r, a).unwrap().unwrap().estimate.bounded() * sneddon::num::Bounded::exact(r * a * point.x.cos())
        };
        let options = Options { rel_tol: 1e-7, ..Options::default() };
        let summed = integrate(&mut integrand, &panels, &options).unwrap();
        close(summed, force.value, 1e-7, "∫ p r dr");
        // dF/dd = 2E* a, by differences.
        let h = 1e-5 * a;
        let rise = |name| quantity(&own, name, 0.0, a + h).value - quantity(&own, name, 0.0, a - h).value;
        close(Estimate::exact(rise("F") / rise("g")), a, 1e-8, "dF/dd");
        // dU/dd = F: U = ∫ (d − g)², F/(2E*) = ∫ (d − g).
        let energy = |d: f64| own.squared_gap(a, sneddon::num::Bounded::exact(d)).unwrap().unwrap().estimate;
        let slope = (energy(g.value + 1e-3).value - energy(g.value - 1e-3).value) / 4e-3;
        close(Estimate::exact(slope), force.value, 1e-9, "dU/dd");
    }
}

#[test]
fn clusters_and_quadrature_of_single_pieces_agree() {
    let own = made(300, 5, Some(150));
    let numeric = own.numeric();
    let last = own.limit();
    for (share, part) in [(0.31, 0.9), (0.999, 0.4), (0.52, 0.01)] {
        let a = share * last;
        let r = part * a;
        let (found, other) = (quantity(&own, "p", r, a), numeric.pressure(r, a, 1e-12).unwrap().unwrap());
        assert!((found.value - other.value).abs() <= found.error + other.error, "{found:?} {other:?}");
        assert!(found.error <= 1e-11 * found.value.abs());
        let (found, other) = (own.displacement(1.5 * a, a).unwrap().estimate, numeric.displacement(1.5 * a, a, 1e-12).unwrap());
        assert!((found.value - other.value).abs() <= found.error + other.error, "{found:?} {other:?}");
    }
    let kink = own.pieces()[150].lower;
    assert_eq!(own.pressure(kink, 0.9 * last).unwrap(), None);
}

/// Errors of g of 1 − cos r at x = 2.4, for spacings halved again and again.
#[test]
fn refinement_converges() {
    let truth = Profile::new(&sneddon::parse::profile("1-cos(r)").unwrap()).unwrap();
    let solution = sneddon::transform::derive(&truth).unwrap();
    let bindings = sneddon::expr::Bindings::default();
    let method = sneddon::transform::Method::Auto;
    let truth = sneddon::transform::Evaluator::new(&solution, &bindings, method, 1e-13).unwrap().equivalent(2.4).unwrap().estimate.value;
    for how in [Interpolation::MonotoneCubic, Interpolation::EvenSmoothingSpline(Penalty::Weight(0.0))] {
        let error = |count| {
            let (r, z) = sampled(count, 3.0, |r| 1.0 - r.cos());
            (Profile::from_points(&r, &z, how).unwrap().equivalent(2.4).unwrap().estimate.value - truth).abs()
        };
        let errors: Vec<f64> = [20, 40, 80, 160, 320].map(error).to_vec();
        if std::env::var_os("SHOW").is_some() {
            println!("{how:?}: {errors:?}");
        }
        // f is right to the fourth power; the kernel's root at r = x costs half a power, and g is there where the piece ends.
        let order = (errors[2] / errors[4]).log2() / 2.0;
        assert!(order > 3.2, "{how:?}: {errors:?}, order {order}");
    }
}

#[test]
fn smoothing_takes_the_noise_away() {
    let mut state = 7_u64;
    let mut noise = || {
        let mut sum = -6.0;
        for _ in 0..12 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            sum += (state >> 11) as f64 / (1_u64 << 53) as f64;
        }
        1e-3 * sum
    };
    let (r, z) = sampled(1000, 2.0, |r| r * r / 4.0 + noise());
    let g = |how| Profile::from_points(&r, &z, how).unwrap().equivalent(1.5).unwrap().estimate.value;
    let truth = 1.5 * 1.5 / 2.0;
    let off = |how| (g(how) - truth).abs();
    let kinds = [
        Interpolation::SmoothingSpline(Penalty::CrossValidation),
        Interpolation::SmoothingSpline(Penalty::Noise(1e-3)),
        Interpolation::EvenSmoothingSpline(Penalty::CrossValidation),
        Interpolation::EvenSmoothingSpline(Penalty::Noise(1e-3)),
    ];
    for how in kinds {
        if std::env::var_os("SHOW").is_some() {
            println!("{how:?}: off by {:e}", off(how));
        }
        assert!(off(how) < 3e-3, "{how:?}: {:e}", off(how));
    }
    // The residual of the spline is the noise that was stated.
    let own = Profile::from_points(&r, &z, Interpolation::SmoothingSpline(Penalty::Noise(1e-3))).unwrap();
    let residual: f64 = own.pieces().iter().zip(&z).map(|(piece, z)| (piece.coefficients[0] - z).powi(2)).sum();
    assert!((residual / 1000.0).sqrt() > 0.99e-3 && (residual / 1001.0).sqrt() < 1.01e-3, "{residual:e}");
    // An even spline has a finite pressure at the axis.
    let own = Profile::from_points(&r, &z, Interpolation::EvenSmoothingSpline(Penalty::CrossValidation)).unwrap();
    assert!(own.pressure(0.0, 1.0).unwrap().is_some());
}

#[test]
fn what_is_no_table_is_refused_with_its_place() {
    let refused = |r: &[f64], z: &[f64], how| match Profile::from_points(r, z, how).err() {
        Some(TransformError::Table(error)) => error,
        other => panic!("{other:?}"),
    };
    let cubic = Interpolation::MonotoneCubic;
    assert_eq!(refused(&[0.0, 1.0], &[0.0], cubic), TableError::Lengths { radii: 2, heights: 1 });
    assert_eq!(refused(&[0.0], &[0.0], cubic), TableError::TooFew { given: 1, needed: 2 });
    let spline = Interpolation::SmoothingSpline(Penalty::CrossValidation);
    assert_eq!(refused(&[0.0, 1.0], &[0.0, 1.0], spline), TableError::TooFew { given: 2, needed: 3 });
    assert!(matches!(refused(&[0.0, 1.0], &[0.0, f64::NAN], cubic), TableError::NotFinite { index: 1, .. }));
    assert!(matches!(refused(&[f64::INFINITY, 1.0], &[0.0, 1.0], cubic), TableError::NotFinite { index: 0, .. }));
    assert_eq!(refused(&[-1.0, 1.0], &[0.0, 1.0], cubic), TableError::Negative { index: 0, radius: -1.0 });
    assert_eq!(refused(&[0.0, 2.0, 1.0], &[0.0; 3], cubic), TableError::Unsorted { index: 2, radius: 1.0, before: 2.0 });
    assert_eq!(refused(&[0.0, 1.0, 1.0], &[0.0; 3], cubic), TableError::Duplicate { index: 2, before: 1, radius: 1.0 });
    let wrong = Interpolation::SmoothingSpline(Penalty::Weight(-1.0));
    assert!(matches!(refused(&[0.0, 1.0, 2.0], &[0.0; 3], wrong), TableError::Penalty { .. }));
    let huge = refused(&[0.0, 1e-300, 2e-300], &[0.0, 1e300, 3e300], cubic);
    assert_eq!(huge, TableError::OutOfRange);
    let gap = vec![Cubic { lower: 0.0, upper: 1.0, coefficients: [0.0; 4] }, Cubic { lower: 1.5, upper: 2.0, coefficients: [0.0; 4] }];
    assert!(matches!(TableProfile::from_cubics(gap).err(), Some(TransformError::Table(TableError::Piece { index: 1 }))));
    let own = Profile::from_points(&[0.5, 1.0, 1.5], &[0.25, 1.0, 2.25], cubic).unwrap();
    assert_eq!(own.extrapolated(), Some(0.5));
    close(own.equivalent(0.25).unwrap().estimate, 0.125, 1e-12, "the parabola that leads to the axis");
    assert!(matches!(own.equivalent(1.5000001), Err(TransformError::OutOfDomain { symbol: "x", .. })));
    assert!(own.equivalent(1.5).is_ok() && own.equivalent(f64::NAN).is_err() && own.equivalent(-1.0).is_err());
}

#[test]
fn cubics_are_reproduced_and_steps_stay_monotone() {
    let r: Vec<f64> = (0..9).map(|i| 0.25 * f64::from(i) + 0.03125 * f64::from(i * i)).collect();
    let z: Vec<f64> = r.iter().map(|r| 1.0 + r * r * (2.0 + r)).collect();
    for piece in Profile::from_points(&r, &z, Interpolation::MonotoneCubic).unwrap().pieces() {
        let truth = |r: f64| r * (4.0 + 3.0 * r);
        for part in [0.0, 0.3, 1.0] {
            let delta = part * (piece.upper - piece.lower);
            assert!((piece.f_prime(delta) - truth(piece.lower + delta)).abs() < 1e-12, "{piece:?}");
        }
    }
    let z = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 3.0, 3.5, 3.5];
    for piece in Profile::from_points(&r, &z, Interpolation::MonotoneCubic).unwrap().pieces() {
        assert!((0..=20).all(|i| piece.f_prime((piece.upper - piece.lower) * f64::from(i) / 20.0) >= -1e-14), "{piece:?}");
    }
}

#[test]
fn no_penalty_interpolates_and_a_large_one_gives_the_line() {
    let r: Vec<f64> = (0..7).map(|i| f64::from(i) * (1.0 + 0.1 * f64::from(i))).collect();
    let z: Vec<f64> = r.iter().map(|r| r.sin()).collect();
    let own = smoothed(&r, &z, 0.0).unwrap();
    assert!(own.residual == 0.0 && own.freedom == 0.0);
    let line = smoothed(&r, &z, 1e9).unwrap();
    assert!((line.freedom - 5.0).abs() < 1e-6, "{}", line.freedom);
    assert!(line.seconds.iter().all(|s| s.abs() < 1e-7));
    // The trace against its definition, column by column.
    let penalty = 0.7;
    let trace: f64 = (0..7)
        .map(|i| {
            let unit: Vec<f64> = (0..7).map(|j| f64::from(u8::from(i == j))).collect();
            1.0 - smoothed(&r, &unit, penalty).unwrap().values[i]
        })
        .sum();
    assert!((smoothed(&r, &z, penalty).unwrap().freedom - trace).abs() < 1e-12);
}
