//! `sneddon reference`: means over cells against 16 digits and against the force, symmetry, formats, and what is refused.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::panic)]

use serde_json::Value;
use sneddon::num::work::apart;
use sneddon::scene::{Grid, Loads, Quantity, Run, Scene, scene};
use sneddon::{parse, transform::Profile};
use sneddon_checks::seeds::cases;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn scene_of(profile: &str, rim: Option<f64>, load: f64, by_radius: bool) -> Scene {
    let control = if by_radius { sneddon::scene::Control::ContactRadius } else { sneddon::scene::Control::Depth };
    let profile = Profile::new(&parse::profile(profile).unwrap()).unwrap();
    Scene { rim, control, loads: Loads::List(vec![load]), ..Scene::of(profile) }
}

#[test]
fn means_have_their_reference_values() {
    let mut count = 0;
    let mut worst = 0.0f64;
    for line in include_str!("../oracle/cells.csv").lines().skip(1) {
        let [profile, depth, side, points, row, column, mean] = line.split(';').collect::<Vec<_>>().try_into().unwrap();
        let number = |text: &str| text.parse::<f64>().unwrap();
        let own = if depth.is_empty() { scene_of(profile, None, 1.0, true) } else { scene_of(profile, Some(1.0), number(depth), false) };
        let solution = own.solution().unwrap();
        let run = Run::new(&own, &solution).unwrap();
        let grid = Grid::Square { side: number(side), count: points.parse().unwrap(), between: false };
        let field = run.field(&grid, Quantity::Pressure, run.state(0, true).as_ref(), true);
        let (value, error) = field.at(&[row.parse().unwrap(), column.parse().unwrap()]).unwrap();
        let off = (value - number(mean)).abs();
        assert!(off <= error + 1e-15 * number(mean), "{line}: {value:?} ± {error:e} is off by {off:e}");
        assert!(error <= 1e-10 * number(mean).max(0.01), "{line}: {error:e}");
        worst = worst.max(off / number(mean).max(0.01));
        count += 1;
    }
    assert_eq!(count, 21);
    println!("largest relative error: {worst:e}");
}

/// Σ p̄ h² = F: nothing of a singularity is lost, whether the axis is a point or lies between points.
#[test]
fn means_add_up_to_the_force() {
    for (profile, rim, load, by_radius) in [
        ("r^2/2", None, 1.0, true),
        ("r/5", None, 1.0, true),
        ("r^(1/2)", None, 1.0, true),
        ("piecewise(0, r<1/2, (r-1/2)/3)", None, 1.0, true),
        ("2-sqrt(4-r^2)", None, 1.0, true),
        ("0", Some(1.0), 0.3, false),
        ("r^2/8", Some(1.0), 1.0, false),
        ("-r^2/10", Some(1.0), 0.4, false),
    ] {
        let own = scene_of(profile, rim, load, by_radius);
        let solution = own.solution().unwrap();
        let run = Run::new(&own, &solution).unwrap();
        let state = run.state(0, true).unwrap();
        let grids: &[_] = if cases(true, false) {
            &[(2.1, 7, false), (2.5, 8, true)]
        } else {
            &[(2.5, 16, false), (2.5, 16, true), (2.1, 15, false), (2.0 + 1.0 / 8.0, 17, false)]
        };
        for &(side, count, between) in grids {
            let field = run.field(&Grid::Square { side, count, between }, Quantity::Pressure, Some(&state), true);
            let area = (side / count as f64).powi(2);
            let (mut total, mut doubt) = (0.0, 0.0);
            for place in (0..count).flat_map(|i| (0..count).map(move |j| [i, j])) {
                let (mean, error) = field.at(&place).unwrap();
                total += mean * area;
                doubt += error * area;
            }
            let off = (total - state.force).abs();
            assert!(off <= doubt + 1e-14 * state.force, "{profile} {count} {between}: {total:?} is not {:?}, {doubt:e}", state.force);
            assert!(doubt < 1e-9 * state.force, "{profile}: {doubt:e}");
        }
        let rings = Grid::Radial(Loads::List((0..20).map(|i| f64::from(i) / 16.0).collect()));
        let field = run.field(&rings, Quantity::Pressure, Some(&state), true);
        let force: f64 = (0..20)
            .map(|i| {
                let (inner, outer) = ((f64::from(i) - 0.5).max(0.0) / 16.0, (f64::from(i) + 0.5) / 16.0);
                std::f64::consts::PI * (outer * outer - inner * inner) * field.at(&[i as usize]).unwrap().0
            })
            .sum();
        assert!((force / state.force - 1.0).abs() < 1e-10, "{profile}: {force:?}");
    }
}

/// Points are those of the curves, the same in all eight octants.
#[test]
fn points_are_symmetric() {
    let own = scene_of("r^2/2", None, 1.0, true);
    let solution = own.solution().unwrap();
    let run = Run::new(&own, &solution).unwrap();
    let state = run.state(0, true).unwrap();
    for curve in [Quantity::Pressure, Quantity::Displacement, Quantity::Profile] {
        let grid = Grid::Square { side: 3.0, count: 12, between: false };
        let field = run.field(&grid, curve, Some(&state), false);
        for (i, j) in (0..12).flat_map(|i| (0..12).map(move |j| (i, j))) {
            let r = grid.coordinate(i).hypot(grid.coordinate(j));
            assert_eq!(field.at(&[i, j]), field.at(&[j, i]));
            assert_eq!(field.at(&[i, j]).unwrap(), run.points(curve, Some(&state), &[r])[0].value.unwrap());
        }
    }
}

const SCENE: &str = "[profile]\nshape = 'cone'\nparameters = { theta = '12 deg' }\n[material]\neffective_modulus = '3 GPa'\n[load]\ndepth = ['10 nm', '20 nm']\n[outputs]\nquantities = ['F', 'p', 'u']\nunits = { length = 'um', force = 'mN', pressure = 'GPa' }\n";

fn room(name: &str) -> PathBuf {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("reference").join(name);
    let _ = fs::remove_dir_all(&place);
    fs::create_dir_all(&place).unwrap();
    fs::write(place.join("scene.toml"), SCENE).unwrap();
    place
}

fn reference(place: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sneddon")).current_dir(place).arg("reference").arg("scene.toml").args(arguments).output().unwrap()
}

#[test]
fn every_format_says_the_same() {
    let place = room("formats");
    let grid = ["--grid", "8", "--box", "0.4 um", "--cells"];
    for name in ["out.csv", "out.json", "out.npy"] {
        let mut arguments = grid.to_vec();
        arguments.extend(["-o", name]);
        let done = reference(&place, &arguments);
        assert!(done.status.success() && done.stdout.is_empty(), "{}", String::from_utf8_lossy(&done.stderr));
    }
    let json: Value = serde_json::from_slice(&fs::read(place.join("out.json")).unwrap()).unwrap();
    assert_eq!((&json["grid"]["kind"], &json["grid"]["cells"]), (&Value::from("square"), &Value::from(true)));
    let csv = fs::read_to_string(place.join("out.csv")).unwrap();
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("d_um,x_um,y_um,r_um,p_GPa,p_error_GPa,p_bound,u_um,u_error_um,u_bound,cell_um"));
    let npy = fs::read(place.join("out.npy")).unwrap();
    assert_eq!(&npy[..8], b"\x93NUMPY\x01\x00");
    let length = usize::from(u16::from_le_bytes([npy[8], npy[9]]));
    let header = std::str::from_utf8(&npy[10..10 + length]).unwrap();
    assert!(header.contains("'shape': (2, 2, 2, 8, 8, )") && header.ends_with('\n') && (10 + length) % 64 == 0, "{header}");
    let numbers: Vec<f64> = npy[10 + length..].chunks(8).map(|own| f64::from_le_bytes(own.try_into().unwrap())).collect();
    assert_eq!(numbers.len(), 2 * 2 * 2 * 64);
    for load in 0..2 {
        for row in 0..8 {
            for column in 0..8 {
                let fields: Vec<&str> = lines.next().unwrap().split(',').collect();
                for (quantity, name) in ["p", "u"].into_iter().enumerate() {
                    let entry = &json["loads"][load]["fields"][quantity];
                    assert_eq!((&entry["quantity"], &entry["bound"]), (&name.into(), &fields[6 + 3 * quantity].into()));
                    for (part, key) in ["values", "error_estimates"].into_iter().enumerate() {
                        let own: f64 = fields[4 + 3 * quantity + part].parse().unwrap();
                        // The reader of JSON may be off by a last place.
                        let read = entry[key][row][column].as_f64().unwrap();
                        assert!((read - own).abs() <= f64::EPSILON * own.abs(), "{read:?} {own:?}");
                        assert_eq!(own, numbers[(((load * 2 + quantity) * 2 + part) * 8 + row) * 8 + column]);
                    }
                }
            }
        }
    }
}

/// p is infinite at the apex: empty in CSV, null with its reason in JSON, infinite in NPY.
#[test]
fn radii_have_points_and_an_apex() {
    let place = room("radii");
    let done = reference(&place, &["--grid", "0:0.1um:3", "--json"]);
    let json: Value = serde_json::from_slice(&done.stdout).unwrap();
    assert_eq!(json["grid"]["r"], serde_json::json!([0.0, 0.05, 0.1]));
    let first = &json["loads"][0]["fields"][0];
    assert!(first["values"][0].is_null() && first["values"][1].is_number() && first["why"].as_str().unwrap().contains("apex"));
    let done = reference(&place, &["--grid", "0:0.1um:3"]);
    assert!(String::from_utf8(done.stdout).unwrap().lines().nth(1).unwrap().starts_with("0.01,0.0,,,,0.009"));
    assert!(reference(&place, &["--grid", "0:0.1um:3", "-o", "a.npy"]).status.success());
    let bytes = fs::read(place.join("a.npy")).unwrap();
    assert_eq!(f64::from_le_bytes(bytes[128..136].try_into().unwrap()), f64::INFINITY);
}

/// `[data]` says the grid of the solver.
#[test]
fn the_data_of_the_scene_declare_a_grid() {
    let place = room("declared");
    fs::write(place.join("scene.toml"), format!("{SCENE}[data]\nbox = '0.4 um'\ngrid = [4, 8]\npressure = 'cell'\n")).unwrap();
    let declared = reference(&place, &[]);
    let typed = reference(&place, &["--grid", "8", "--box", "0.4 um", "--cells"]);
    assert!(declared.status.success() && declared.stdout == typed.stdout);
    assert!(String::from_utf8(declared.stdout).unwrap().lines().count() == 1 + 2 * 64);
}

#[test]
fn bad_grids_are_refused() {
    let place = room("bad");
    for (arguments, said) in [
        (vec!["--grid", "64"], "no box"),
        (vec!["--grid", "64", "--box", "3 N"], "not a length"),
        (vec!["--grid", "64", "--box", "3"], "no unit"),
        (vec!["--grid", "64", "--box=-3 um"], "not positive"),
        (vec!["--grid", "0", "--box", "3 um"], "expected 1 to 8192 points"),
        (vec!["--grid", "99999", "--box", "3 um"], "expected 1 to 8192 points"),
        (vec!["--grid", "7", "--box", "3 um", "--between"], "even number"),
        (vec!["--grid", "1:2"], "cannot parse the grid"),
        (vec!["--grid", "2um:1um:5"], "are not increasing"),
        (vec!["--grid=-1um:1um:5"], "negative or infinite radius"),
        (vec![], "no grid"),
        (vec!["--grid", "8", "--box", "1 um", "-o", "a.txt"], ".npy"),
    ] {
        let done = reference(&place, &arguments);
        let text = String::from_utf8(done.stderr).unwrap();
        assert_eq!(done.status.code(), Some(2), "{arguments:?}: {text}");
        assert!(done.stdout.is_empty() && text.contains(said), "{arguments:?}: {text}");
    }
    assert!(scene(SCENE).is_err() && fs::read_dir(&place).unwrap().count() == 1);
}

/// Class "a bound that forgets the error of the contact radius": pressures next to the edge under a given depth or force, and u(0), which is
/// the depth. With a² = R d, p = 2 E* √(R d − r²)/(π R) has no error that counts in twice the digits.
#[test]
fn fields_inherit_the_error_of_the_contact_radius() {
    use sneddon::num::{DoubleDouble, Precise, precise};
    use sneddon::scene::Control;
    let tip = Profile::new(&parse::profile("r^2/(2*2)").unwrap()).unwrap();
    let depths = [0.1, 0.3, 0.07, 1.0 / 3.0, 2e-7, 41.0];
    let forces: Vec<f64> = depths.iter().map(|d: &f64| 4.0 / 3.0 * 2.0_f64.sqrt() * d.powf(1.5)).collect();
    for (control, loads) in [(Control::Depth, depths.to_vec()), (Control::Force, forces)] {
        let scene = Scene { loads: Loads::List(loads.clone()), control, ..Scene::of(tip.clone()) };
        let solution = scene.solution().unwrap();
        let run = Run::new(&scene, &solution).unwrap();
        for (index, load) in loads.iter().enumerate() {
            let state = run.state(index, false).unwrap();
            let exact = |own: f64| Precise::exact(own);
            // F = (4/3) E* √R d^(3/2).
            let depth = match control {
                Control::Depth => exact(*load),
                _ => {
                    let square = exact(0.75).mul(exact(*load));
                    let cube = square.mul(square).div(exact(2.0));
                    let root = cube.value.hi.cbrt();
                    // A step of Newton's method.
                    let rest = cube.sub(exact(root).mul(exact(root)).mul(exact(root)));
                    exact(root).add(rest.div(exact(3.0 * root * root)))
                }
            };
            let check = |quantity: Quantity, at: f64, truth: DoubleDouble| {
                let (value, error) = run.points(quantity, Some(&state), &[at])[0].value.unwrap();
                let off = ((truth.hi - value) + truth.lo).abs();
                assert!(off <= error, "{control:?} {load}, {} at {at:?}: {value:?} ± {error:e} is off by {off:e}", quantity.key());
                error / truth.hi.abs()
            };
            check(Quantity::Displacement, 0.0, depth.value);
            for gap in [0.5, 1e-2, 1e-5, 1e-8, 1e-11, 1e-14] {
                let r = state.radius * (1.0 - gap);
                let square = exact(2.0).mul(depth).sub(exact(r).mul(exact(r)));
                let truth = square.sqrt().div(Precise { value: precise::PI, error: 0.0 });
                let error = check(Quantity::Pressure, r, truth.value);
                assert!(error < 3e-15 + 1.1e-15 / gap, "{gap}: {error}");
            }
        }
    }
}

/// Class "finished work is thrown away": cells that the budget does not reach have no mean, and the others keep theirs. The pressures of the
/// profiles have no short formula and come from one expansion.
#[test]
fn cells_keep_their_means_where_the_budget_does_not_suffice_for_others() {
    for tip in ["piecewise(0, r<1, 0.2*(r-1))", "r^2*(1+0.2*besselj(0,9*r)^2*exp(-r))", "piecewise(0, r<1, sqrt(24)-sqrt(25-r^2))"]
        .into_iter()
        .take(cases(2, 3))
    {
        let profile = Profile::new(&parse::profile(tip).unwrap()).unwrap();
        let scene = Scene { effective_modulus: 3.0, loads: Loads::List(vec![0.1]), ..Scene::of(profile) };
        let solution = scene.solution().unwrap();
        let grid = Grid::Square { side: 4.0, count: 32, between: true };
        let means = |steps: u64| {
            let run = Run::new(&scene, &solution).unwrap();
            let state = run.state(0, false);
            let (field, spent, _) = apart(steps, || run.field(&grid, Quantity::Pressure, state.as_ref(), true));
            let all: Vec<_> = (0..32).flat_map(|row| (0..=row).map(move |column| [row, column])).map(|place| field.at(&place)).collect();
            (all, run.cut_short().is_some(), spent)
        };
        let (whole, is_cut, spent) = means(1 << 40);
        assert!(!is_cut && whole.iter().all(Result::is_ok), "{tip}");
        let mut partial = 0;
        for steps in (1..10).map(|share| spent * share / 5) {
            let (part, is_cut, _) = means(steps);
            let missing = part.iter().filter(|own| own.is_err()).count();
            assert!(is_cut == (missing > 0) && part.iter().zip(&whole).all(|(own, all)| own.is_err() || own == all), "{tip} {steps}");
            partial += u32::from(is_cut && part.iter().any(|own| own.is_ok_and(|mean| mean.0 > 0.0)));
        }
        assert!(partial > 0, "{tip}");
    }
}
