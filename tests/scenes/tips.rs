//! Measured tips: samples of known shapes against the shapes, repaired files against clean ones, and the laws of every contact.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon::contact::State;
use sneddon::scene::{Fit, MeasuredTip, Quantity, Run, Scene, SceneError, scene};
use sneddon_checks::seeds::sample;
use std::fmt::Write;

/// Nodes and weights of Gauss–Legendre quadrature on (0, 1).
const NODES: [(f64, f64); 5] = [
    (0.046_910_077_030_668_0, 0.118_463_442_528_094_5),
    (0.230_765_344_947_158_5, 0.239_314_335_249_683_2),
    (0.5, 0.284_444_444_444_444_4),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_2),
    (0.953_089_922_969_332, 0.118_463_442_528_094_5),
];

/// The integral over (from, to).
fn integral(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    (to - from) * NODES.iter().map(|(node, weight)| weight * f(from + (to - from) * node)).sum::<f64>()
}

/// A scene in which lengths are micrometres, pressures gigapascals and forces millinewtons.
fn text(profile: &str, load: &str) -> String {
    format!(
        "[profile]\n{profile}\n[material]\neffective_modulus = '74 GPa'\n[load]\n{load}\n[outputs]\nquantities = ['d', 'F', 'a', 'U']\n\
         units = {{ length = 'um', force = 'mN', pressure = 'GPa' }}\n"
    )
}

fn measured(csv: &str, keys: &str, load: &str) -> Result<Scene, SceneError> {
    scene(&text(&format!("points = 'tip.csv'\n{keys}"), load)).unwrap().with_points(&(csv.to_owned(), false))
}

/// d, F, a and U of the first load, its state, and what `look` finds.
fn solved<T>(scene: &Scene, look: impl Fn(&Run<'_>, &State) -> T) -> ([f64; 4], T) {
    let solution = scene.solution().unwrap();
    let run = Run::new(scene, &solution).unwrap();
    let row = run.row(0).unwrap();
    assert!(row.is_valid(), "{row:?}");
    let values = [Quantity::Depth, Quantity::Force, Quantity::Radius, Quantity::Energy].map(|datum| row.value(datum).unwrap());
    (values, look(&run, &row.indented.state.unwrap()))
}

fn numbers(scene: &Scene) -> [f64; 4] {
    solved(scene, |_, _| ()).0
}

fn tip(csv: &str, keys: &str) -> MeasuredTip {
    measured(csv, keys, "depth = '1 nm'").unwrap().tip.unwrap()
}

fn rules(csv: &str, keys: &str) -> Vec<&'static str> {
    tip(csv, keys).notes().iter().map(|note| note.rule).collect()
}

fn csv(rows: impl IntoIterator<Item = (f64, f64)>) -> String {
    let mut text = "r_um,z_um\n".to_owned();
    rows.into_iter().for_each(|(r, z)| writeln!(text, "{r:?},{z:?}").unwrap());
    text
}

/// Samples from the axis to `end`, a little uneven.
fn samples(f: &dyn Fn(f64) -> f64, end: f64, count: u32) -> Vec<(f64, f64)> {
    let place = |i: u32| {
        let t = f64::from(i) / f64::from(count);
        end * (t + 0.02 * (6.0 * t).sin() * (1.0 - t))
    };
    (0..=count).map(|i| if i == count { end } else { place(i) }).map(|r| (r, f(r))).collect()
}

/// Name, keys in a scene, and f in micrometres.
type Known = (&'static str, &'static str, fn(f64) -> f64);

const SHAPES: [Known; 5] = [
    ("paraboloid", "f = 'r^2/(2*R)'\nparameters = { R = '10 um' }", |r| r * r / 20.0),
    ("sphere", "f = 'R-sqrt(R^2-r^2)'\nparameters = { R = '5 um' }", |r| r * r / (5.0 + (25.0 - r * r).sqrt())),
    ("cone", "f = 'r*t'\nparameters = { t = 0.2 }", |r| 0.2 * r),
    ("hyperboloid", "f = 'h*(sqrt(1+r^2/b^2)-1)'\nparameters = { h = '0.2 um', b = '0.8 um' }", |r| 0.2 * ((r / 0.8).hypot(1.0) - 1.0)),
    ("quartic", "f = 'r^4/k^3'\nparameters = { k = '3 um' }", |r| r.powi(4) / 27.0),
];

/// Places of the pressure as parts of the contact radius.
const PARTS: [f64; 4] = [0.13, 0.4, 0.66, 0.85];

fn pressures(run: &Run<'_>, state: &State) -> Vec<f64> {
    PARTS.iter().map(|part| run.points(Quantity::Pressure, Some(state), &[part * state.radius])[0].value.unwrap().0).collect()
}

/// Depths that reach contact radii anywhere between two points.
const DEPTHS: [f64; 7] = [0.05, 0.063, 0.074, 0.081, 0.09, 0.1, 0.117];

fn at_depth(depth: f64) -> String {
    format!("depth = '{depth} um'")
}

/// Sampled shapes tend to the shapes: F as the fourth power of the spacing, a nearly so, p as the third, until rounding.
#[test]
fn samples_converge_to_their_shape() {
    for (name, profile, f) in SHAPES {
        let exact = DEPTHS.map(|depth| solved(&scene(&text(profile, &at_depth(depth))).unwrap(), pressures));
        let worst = |count: u32| {
            let rows = csv(samples(&f, 2.0, count));
            let mut errors = [0.0f64; 3];
            for (depth, (exact, exact_pressure)) in DEPTHS.iter().zip(&exact) {
                let (own, pressure) = solved(&measured(&rows, "", &at_depth(*depth)).unwrap(), pressures);
                errors[0] = errors[0].max((own[1] / exact[1] - 1.0).abs());
                errors[1] = errors[1].max((own[2] / exact[2] - 1.0).abs());
                errors[2] = pressure.iter().zip(exact_pressure).map(|(p, e)| (p / e - 1.0).abs()).fold(errors[2], f64::max);
            }
            errors
        };
        let (coarse, fine) = (worst(20), worst(160));
        for (index, least) in [3.8, 3.4, 3.0].into_iter().enumerate() {
            let order = (coarse[index] / fine[index]).log(8.0);
            println!("{name}: {:.1e} to {:.1e}, order {order:.2}", coarse[index], fine[index]);
            assert!(fine[index] < 1e-13 || order > least, "{name}: {coarse:?} to {fine:?}");
        }
    }
}

/// What a second way of joining says is no less than the true error.
#[test]
fn model_errors_cover_the_true_errors() {
    for (number, (name, profile, f)) in SHAPES.into_iter().enumerate() {
        let exact = DEPTHS.map(|depth| solved(&scene(&text(profile, &at_depth(depth))).unwrap(), pressures));
        for count in sample([12, 25, 50, 100], number, 2) {
            let rows = csv(samples(&f, 2.0, count));
            let (mut errors, mut stated) = ([0.0f64; 3], [0.0f64; 3]);
            for (depth, (exact, exact_pressure)) in DEPTHS.iter().zip(&exact) {
                let scene = measured(&rows, "", &at_depth(*depth)).unwrap();
                let (own, (pressure, said)) = solved(&scene, |run, state| {
                    let row = run.row_model_errors(0, Some(state)).unwrap();
                    let second = run.second_state(0).unwrap();
                    let point =
                        |part: &f64| run.point_model_error(Quantity::Pressure, Some((state, &second)), part * state.radius).unwrap();
                    let most = PARTS.iter().map(point).fold(0.0, f64::max);
                    let of = |datum: Quantity| row.iter().find(|own| own.0 == datum).unwrap().1.unwrap();
                    (pressures(run, state), [of(Quantity::Force), of(Quantity::Radius), most])
                });
                let worst = pressure.iter().zip(exact_pressure).map(|(p, e)| (p - e).abs()).fold(0.0, f64::max);
                for (index, error) in [(own[1] - exact[1]).abs(), (own[2] - exact[2]).abs(), worst].into_iter().enumerate() {
                    errors[index] = errors[index].max(error);
                    stated[index] = stated[index].max(said[index]);
                }
            }
            println!("{name} {count}: off by {errors:?}, model errors {stated:?}");
            assert!(errors.iter().zip(stated).all(|(error, stated)| *error <= stated + 1e-11), "{name} {count}: {errors:?} {stated:?}");
        }
    }
}

/// Order, repetition, delimiter, units, comments and line ends change no bit.
#[test]
fn repaired_files_answer_like_clean_ones() {
    let rows = samples(&|r| r * r / 20.0 + 0.01 * r.powi(3), 2.0, 60);
    let clean = csv(rows.clone());
    let load = "force = '3 mN'";
    let expected = numbers(&measured(&clean, "", load).unwrap());
    let mut turned: Vec<_> = rows.clone();
    turned.reverse();
    let mut mixed = rows.clone();
    mixed.sort_by_key(|own| (own.0 * 1e6) as i64 % 17);
    let mut twice = rows.clone();
    twice.extend_from_slice(&rows[3..9]);
    let off = |rows: &[(f64, f64)]| {
        // Pairs of heights about the true one.
        let mut more = rows.to_vec();
        more[7].1 += 0.25;
        more.push((rows[7].0, rows[7].1 - 0.25));
        more
    };
    for (name, text, keys, expected_rules) in [
        ("clean", clean.clone(), "", vec![]),
        ("turned", csv(turned), "", vec!["tip_sorted"]),
        ("mixed", csv(mixed), "", vec!["tip_sorted"]),
        ("twice", csv(twice), "", vec!["tip_sorted", "tip_merged"]),
        ("semicolons", clean.replace(',', ";").replace("r_um;z_um", "r [um];z [um]"), "", vec![]),
        ("decimal commas", clean.replace(',', ";").replace('.', ","), "", vec!["tip_decimal_comma"]),
        ("tabs, comments, line ends", format!("\u{feff}# tip\r\n{}", clean.replace(',', "\t").replace('\n', "\r\n")), "", vec![]),
        ("blanks", format!("# {}", clean.replace(',', "   ")), "", vec![]),
        ("units in the scene", clean.replace("_um", ""), "length_unit = 'um'", vec![]),
        ("one unit for both columns", clean.replace("_um", ""), "units = 'um'", vec![]),
        ("an ordinate", clean.replace("r_um,z_um", "x [um],y1 [um]"), "", vec![]),
        ("a unit per column", clean.replace("_um", ""), "units = { r = 'um', z = 'um' }", vec![]),
        ("inverted", csv(rows.iter().map(|own| (own.0, -own.1))), "invert = true", vec![]),
    ] {
        let scene = measured(&text, keys, load).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(numbers(&scene), expected, "{name}");
        assert_eq!(rules(&text, keys), expected_rules, "{name}");
    }
    let averaged = csv(off(&rows));
    assert_eq!(rules(&averaged, ""), ["tip_sorted", "tip_averaged"]);
    let own = numbers(&measured(&averaged, "", load).unwrap());
    assert!(own.iter().zip(expected).all(|(own, expected)| (own / expected - 1.0).abs() < 1e-12), "{own:?} {expected:?}");
    let nanometres = clean.lines().skip(1).map(|line| line.split(',').map(|own| own.parse::<f64>().unwrap() * 1e3));
    let nanometres: Vec<(f64, f64)> = nanometres.map(|mut own| (own.next().unwrap(), own.next().unwrap())).collect();
    let own = numbers(&measured(&csv(nanometres).replace("_um", "_nm"), "", load).unwrap());
    assert!(own.iter().zip(expected).all(|(own, expected)| (own / expected - 1.0).abs() < 1e-12), "{own:?} {expected:?}");
}

/// Heights that fall or stay are said, and change nothing.
#[test]
fn noise_and_steps_are_said() {
    let rows = samples(&|r| r * r / 20.0, 2.0, 60);
    let stepped = csv(rows.iter().map(|own| (own.0, (own.1 * 200.0).round() / 200.0)));
    assert_eq!(rules(&stepped, ""), ["tip_steps"]);
    assert_eq!(rules(&stepped, "interpolation = 'smoothing-spline'"), [""; 0]);
    let dented = csv(rows.iter().enumerate().map(|(i, own)| (own.0, if i == 30 { own.1 - 0.1 } else { own.1 })));
    assert_eq!(rules(&dented, ""), ["tip_not_monotone"]);
    let worn = csv((0..30).map(f64::from).map(|r| (0.1 * r, (0.1 * r - 1.0).max(0.0).powi(2))));
    assert_eq!(rules(&worn, ""), [""; 0]);
}

/// Without the row at r = 0 the profile is continued evenly, and said to be.
#[test]
fn a_missing_apex_is_continued_and_said() {
    for (name, profile, f) in SHAPES {
        let load = "depth = '0.1 um'";
        let exact = numbers(&scene(&text(profile, load)).unwrap());
        let text = csv(samples(&f, 2.0, 80).into_iter().skip(1));
        assert_eq!(rules(&text, ""), ["tip_extrapolated"], "{name}");
        let own = numbers(&measured(&text, "", load).unwrap());
        println!("{name}: F off by {:.1e}", (own[1] / exact[1] - 1.0).abs());
        assert!((own[1] / exact[1] - 1.0).abs() < 3e-8, "{name}: {own:?} {exact:?}");
        assert_eq!(tip(&text, "").is_rounded(), name != "cone", "{name}");
    }
    let cone = csv(samples(&|r| 0.2 * r, 2.0, 80).into_iter().skip(1));
    assert!(tip(&cone, "apex = 'rounded'").is_rounded() && !tip(&cone, "apex = 'pointed'").is_rounded());
}

/// dF/dd = 2E*a, F = 2π∫p r dr, U = ∫F dd, on a tip that is no named shape.
#[test]
fn laws_hold_on_measured_tips() {
    let bumpy = |r: f64| 0.03 * r * r + 0.004 * (1.0 - (3.0 * r).cos()) + 0.002 * r;
    let text = csv(samples(&bumpy, 3.0, 45));
    for keys in ["", "interpolation = 'smoothing-spline'\nsmoothing = '1e-6 um^3'"] {
        let at = |depth: f64| numbers(&measured(&text, keys, &format!("depth = '{depth:?} um'")).unwrap());
        let (modulus, step) = (74.0, 1e-4);
        let [d, force, a, energy] = at(0.12);
        let rise = (at(d + step)[1] - at(d - step)[1]) / (2.0 * step);
        assert!((rise / (2.0 * modulus * a) - 1.0).abs() < 1e-7, "{keys}: {rise:?} is not {:?}", 2.0 * modulus * a);
        // Over d = D s², in which F is smooth at 0.
        let work: f64 = (0..4).map(|i| 0.25 * f64::from(i)).map(|s| integral(s, s + 0.25, |s| 2.0 * s * d * at(d * s * s)[1])).sum();
        assert!((work / energy - 1.0).abs() < 4e-8, "{keys}: {work:?} is not {energy:?}");
        let scene = measured(&text, keys, "depth = '0.12 um'").unwrap();
        let (_, total) = solved(&scene, |run, state| {
            // r = a sin t on panels between the knots.
            let mut ends: Vec<f64> =
                run.scene().tip.as_ref().unwrap().points().iter().map(|own| own.0).filter(|r| *r < a).map(|r| (r / a).asin()).collect();
            ends.push(std::f64::consts::FRAC_PI_2);
            let value = |t: f64| {
                let r = a * t.sin();
                let p = run.points(Quantity::Pressure, Some(state), &[r])[0].value.unwrap().0;
                2.0 * std::f64::consts::PI * p * r * a * t.cos()
            };
            let panel = |pair: &[f64]| integral(pair[0], pair[1], value);
            ends.windows(2).map(panel).sum::<f64>()
        });
        println!("{:.1e} {:.1e} {:.1e}", rise / (2.0 * modulus * a) - 1.0, work / energy - 1.0, total / force - 1.0);
        assert!((total / force - 1.0).abs() < 2e-8, "{keys}: {total:?} is not {force:?}");
    }
}

/// A scan off centre on a tilted support: place and tilt are found, and the answer is that of the shape.
#[test]
fn line_scans_are_centred_and_levelled() {
    for (name, profile, f) in SHAPES {
        let load = "depth = '0.1 um'";
        let exact = numbers(&scene(&text(profile, load)).unwrap());
        for (offset, tilt) in [(0.0, 0.0), (0.1234, 0.0), (-0.2, 0.03), (0.31, -0.05)] {
            let rows = (-100..=100).map(|i| 0.02 * f64::from(i)).map(|x| (x + 7.0, f((x - offset).abs()) + tilt * (x - offset) + 5.0));
            let text = csv(rows).replace("r_um", "x_um");
            let scene = measured(&text, "line_scan = true", load).unwrap();
            let scan = scene.tip.as_ref().unwrap().scan().unwrap();
            let own = numbers(&scene);
            let error = (own[1] / exact[1] - 1.0).abs();
            println!("{name} {offset} {tilt}: {scan:?}, F off by {error:.1e}");
            // A tilted paraboloid is a paraboloid elsewhere.
            let (offset, tilt) = if name == "paraboloid" { (offset - 10.0 * tilt, 0.0) } else { (offset, tilt) };
            assert!((scan.apex_offset - 7.0 - offset).abs() < 5e-9 && (scan.tilt - tilt).abs() < 1e-9, "{name}: {scan:?}");
            assert!(error < 2e-7, "{name} {offset} {tilt}: {own:?} {exact:?}");
        }
    }
}

/// Points with noise need a smoothing spline: F is right to the model error that is stated beside it.
#[test]
fn noise_is_smoothed() {
    // Normal deviates from a linear congruence, by the sum of twelve.
    let mut seed = 12345u64;
    let mut noise = || {
        let mut next = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        (0..12).map(|_| next()).sum::<f64>() - 6.0
    };
    let rows: Vec<(f64, f64)> = (0..=200).map(|i| 0.01 * f64::from(i)).map(|r| (r, r * r / 20.0 + 0.001 * noise())).collect();
    let load = "depth = '0.1 um'";
    let exact = 4.0 / 3.0 * 74.0 * 10f64.sqrt() * 0.1f64.powf(1.5);
    for keys in ["", "noise = '1 nm'"] {
        let scene = measured(&csv(rows.clone()), &format!("interpolation = 'smoothing-spline'\n{keys}"), load).unwrap();
        let (own, stated) = solved(&scene, |run, state| run.row_model_errors(0, Some(state)).unwrap()[1].1.unwrap());
        println!("F = {} off by {:.1e}, model error {stated:.1e}", own[1], own[1] - exact);
        assert!((own[1] - exact).abs() < 0.02 * exact && (own[1] - exact).abs() < 5.0 * stated);
    }
}

/// The shape of the other body is added to the measured one.
#[test]
fn a_measured_tip_meets_a_curved_body() {
    let rows = csv(samples(&|r| r * r / 20.0, 2.0, 40));
    let both = |profile: &str| {
        let text = text(profile, "depth = '0.1 um'");
        format!("{text}[counterbody]\nrigid = true\nf = 'r^2/(2*P)+r^4/k^3'\nparameters = {{ P = '30 um', k = '8 um' }}\n")
    };
    let sum = scene(&both("points = 'tip.csv'")).unwrap().with_points(&(rows, false)).unwrap();
    let exact = scene(&both("f = 'r^2/(2*R)'\nparameters = { R = '10 um' }")).unwrap();
    let ((own, p), (expected, q)) = (solved(&sum, pressures), solved(&exact, pressures));
    for (own, expected) in own.iter().chain(&p).zip(expected.iter().chain(&q)) {
        assert!((own / expected - 1.0).abs() < 1e-12, "{own:?} is not {expected:?}");
    }
}

/// Beyond the last point nothing is known, and nothing is answered.
#[test]
fn beyond_the_last_point_there_is_no_answer() {
    let rows = csv(samples(&|r| r * r / 20.0, 2.0, 40));
    for (load, valid) in [
        ("contact_radius = '2 um'", true),
        ("contact_radius = '2.001 um'", false),
        ("depth = '0.4 um'", true),
        ("depth = '0.401 um'", false),
        ("force = '1 N'", false),
    ] {
        let scene = measured(&rows, "", load).unwrap();
        let solution = scene.solution().unwrap();
        let row = Run::new(&scene, &solution).unwrap().row(0).unwrap();
        assert_eq!(row.is_valid(), valid, "{load}");
        assert!(valid || row.indented.findings[0].rule == "unreachable" && row.why().unwrap().contains("r = 2.0 um"), "{row:?}");
    }
}

fn best(f: impl Fn(f64) -> f64) -> Fit {
    let points = (0..=200).map(|i| 0.01 * f64::from(i)).map(|r| (r, 7.0 + f(r)));
    tip(&csv(points), "").fits().remove(0)
}

#[test]
fn shapes_are_recognised_with_their_parameters() {
    let near = |fit: &Fit, name: &str, expected: f64| {
        let own = fit.parameters.iter().find(|own| own.name == name).unwrap().value;
        assert!((own / expected - 1.0).abs() < 1e-6, "{name} = {own:?} is not {expected:?}: {fit:?}");
    };
    let found = best(|r| r * r / 20.0);
    assert_eq!(found.shape, "paraboloid");
    near(&found, "R", 10.0);
    let found = best(|r| 3.0 - (9.0 - r * r).sqrt());
    assert_eq!(found.shape, "sphere");
    near(&found, "R", 3.0);
    let found = best(|r| 0.2f64.tan() * r);
    assert_eq!(found.shape, "cone");
    near(&found, "theta", 0.2);
    let found = best(|r| 0.3 * ((0.25 + r * r).sqrt() - 0.5));
    assert_eq!(found.shape, "hyperboloid");
    near(&found, "b", 0.5);
    near(&found, "h", 0.15);
    near(&found, "theta", 0.3f64.atan());
    near(&found, "R", 0.5 / 0.3);
    let found = best(|r| 0.1 * r.powf(2.5));
    assert_eq!(found.shape, "power");
    near(&found, "n", 2.5);
    near(&found, "C", 0.1);
}

#[cfg(unix)]
mod program {
    use super::*;
    use std::fs;
    use std::io::Write;
    use std::path::PathBuf;
    use std::process::{Command, Output, Stdio};

    fn solve(name: &str, scene: &str, stdin: &str) -> Output {
        let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("tips");
        fs::create_dir_all(&place).unwrap();
        fs::write(place.join(name), scene).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_sneddon"));
        // From another directory: the name of the file counts from that of the scene.
        command.args(["solve", "--json"]).arg(place.join(name)).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let _ = child.stdin.take().unwrap().write_all(stdin.as_bytes());
        child.wait_with_output().unwrap()
    }

    /// A measured paraboloid is recognised, and rows and curves carry the error of the model.
    #[test]
    fn a_measured_tip_answers_with_its_shape_and_its_model_error() {
        let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("tips");
        fs::create_dir_all(&place).unwrap();
        fs::write(place.join("shape.csv"), csv(samples(&|r| r * r / 20.0, 2.0, 40))).unwrap();
        let scene = text("points = 'shape.csv'", "depth = '0.1 um'").replace("'U']", "'U', 'p']\nat = '0.5 um'");
        let done = solve("shape.toml", &scene, "");
        assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
        let found: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
        assert_eq!(found["tip"]["best_fit"], "paraboloid");
        assert!((found["tip"]["fits"][0]["parameters"]["R"].as_f64().unwrap() - 10.0).abs() < 1e-9);
        assert!(found["rows"][0]["model_error"]["F"].is_number());
        let point = &found["curves"][0]["points"][0];
        assert!(point["model_error"].as_f64().unwrap() < 1e-9 && point["error_estimate"].is_number());
    }

    /// Reference data for a solver come from measured tips, too.
    #[test]
    fn reference_data_of_a_measured_tip() {
        let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("tips");
        fs::create_dir_all(&place).unwrap();
        fs::write(place.join("reference.csv"), csv(samples(&|r| r * r / 20.0, 2.0, 40))).unwrap();
        fs::write(place.join("reference.toml"), text("points = 'reference.csv'", "depth = '0.1 um'")).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_sneddon"));
        let done = command.arg("reference").arg(place.join("reference.toml")).args(["--grid", "0:0.5 um:2", "--json"]).output().unwrap();
        assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
        // p(0) = 2 E* √(d/R)/π
        let expected = 2.0 * 74.0 / std::f64::consts::PI * 0.1;
        let said = String::from_utf8(done.stdout).unwrap();
        let shown = format!("{expected:?}");
        assert!(said.contains(&shown[..12]), "{said} has no {shown}");
    }

    /// A scene that cannot be solved anyway says so before it looks for the file.
    #[test]
    fn bad_scenes_open_no_file() {
        for load in ["force = '-1 mN'", "depth = '1 mN'"] {
            let done = solve("unopened.toml", &text("points = 'there is none.csv'", load), "");
            let said = String::from_utf8_lossy(&done.stderr).into_owned();
            assert_eq!(done.status.code(), Some(2));
            assert!(!said.contains("cannot read"), "{said}");
        }
        let done = solve("missing.toml", &text("points = 'there is none.csv'", "depth = '1 nm'"), "");
        assert!(String::from_utf8_lossy(&done.stderr).contains("cannot read") && done.status.code() == Some(2));
    }
}
