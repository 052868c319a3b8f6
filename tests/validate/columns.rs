//! Columns of energy and stiffness, fields of every shape, grids in another order, and the places of a file as a grid.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used)]

use crate::validate::{room, validated};
use serde_json::Value;
use std::f64::consts::PI;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// f = r²/20, E* = 1.
const SCENE: &str = "[profile]\nf = \"r^2/(2*R)\"\nparameters = { R = 10 }\n[material]\nE = 1\nnu = 0\n";

fn pressure(a: f64, r: f64) -> f64 {
    2.0 / (PI * 10.0) * (a * a - r * r).max(0.0).sqrt()
}

/// An NPY file of doubles.
fn npy(shape: &[usize], values: &[f64]) -> Vec<u8> {
    let shape: Vec<String> = shape.iter().map(usize::to_string).collect();
    let mut head = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({},), }}", shape.join(", "));
    while !(head.len() + 11).is_multiple_of(64) {
        head.push(' ');
    }
    head.push('\n');
    let length = u16::try_from(head.len()).unwrap().to_le_bytes();
    [b"\x93NUMPY\x01\x00", &length[..], head.as_bytes(), &values.iter().flat_map(|own| own.to_le_bytes()).collect::<Vec<_>>()].concat()
}

/// The field of contacts of these radii with h = 0.05, rows along y, the axis on a pixel.
fn field(radii: &[f64], rows: usize, across: usize) -> Vec<f64> {
    let step = |index: usize, count: usize| 0.05 * (index as f64 - (count / 2) as f64);
    let one = |a: f64| (0..rows).flat_map(move |i| (0..across).map(move |j| pressure(a, step(i, rows).hypot(step(j, across)))));
    radii.iter().flat_map(|a| one(*a)).collect()
}

/// F = 4/3 √R d^{3/2}, U = 2/5 F d, k = 2a for E* = 1.
#[test]
fn energy_and_stiffness_are_read() {
    let place = room("energy");
    let rows = |energy: f64, stiffness: f64| {
        let row = |index: i32| {
            let d = 1e-3 * f64::from(index);
            let force = 4.0 / 3.0 * 10f64.sqrt() * d.powf(1.5);
            format!("{d:?},{force:?},{:?},{:?}\n", energy * 0.4 * force * d, stiffness * 2.0 * (10.0 * d).sqrt())
        };
        format!("d_um,F_mN,U_nJ,k_mN/um\n{}", (3..12).map(row).collect::<String>())
    };
    for (energy, stiffness, code) in [(1.0, 1.0, 0), (2.0, 1.0, 1), (1.0, 2.0, 1), (1e-9, 1.0, 1)] {
        fs::write(place.join("data.csv"), rows(energy, stiffness)).unwrap();
        let (found, document) = validated(&place, SCENE, &["data.csv".to_owned()], &[]);
        assert_eq!(found, code, "{document:#}");
        let name = if code == 0 { Value::Null } else { Value::from("scale") };
        assert_eq!(document["suspicion_details"].get("id").cloned().unwrap_or_default(), name, "{document:#}");
    }
}

/// The unit of a mapped column is that of the symbol, or else that of its name.
#[test]
fn mapped_columns_keep_their_units() {
    let place = room("mapped");
    let scene = "[profile]\nf = \"r^2/(2*R)\"\nparameters = { R = \"10 um\" }\n[material]\neffective_modulus = \"1 GPa\"\n";
    // With lengths in um and E* = 1 GPa, forces are in mN.
    let row = |index: i32| {
        let d = 1e-3 * f64::from(index);
        format!("{index},{d:?},{:?}\n", 4.0 / 3.0 * 10f64.sqrt() * d.powf(1.5))
    };
    let rows: String = (3..12).map(row).collect();
    for (header, map, expected) in [
        ("step,h_um,L_mN", ["d=h_um", "F=L_mN"], 0),
        ("step,h [um],L / mN", ["d=h [um]", "F=L / mN"], 0),
        ("step,h_mm,L_N", ["d_um=h_mm", "F_mN=L_N"], 0),
        ("step,h_um,L_N", ["d=h_um", "F=L_N"], 1),
    ] {
        fs::write(place.join("data.csv"), format!("{header}\n{rows}")).unwrap();
        let options = map.iter().flat_map(|own| ["--map", *own]).collect::<Vec<_>>();
        let (code, document) = validated(&place, scene, &["data.csv".to_owned()], &options);
        assert_eq!(code, expected, "{header}: {document:#}");
    }
}

/// An error of an option is at the option, and not in the scene.
#[test]
fn errors_of_options_are_not_placed_in_the_scene() {
    let place = room("options");
    let scene = "[profile]\nf = \"r^2/(2*R)\"\nparameters = { R = \"10 um\" }\n[material]\neffective_modulus = \"1 GPa\"\n[load]\ndepth = \"1 nm\"\n";
    fs::write(place.join("scene.toml"), scene).unwrap();
    fs::write(place.join("data.csv"), "r_um,p_MPa\n0,1\n").unwrap();
    let cases: [(&[&str], &str); 6] = [
        (&["validate", "scene.toml", "data.csv", "--box", "8"], "--box, column 1: the box has no unit"),
        (&["validate", "scene.toml", "data.csv", "--load", "d=1 GPa"], "--load, column 1: "),
        (&["validate", "scene.toml", "data.csv", "--load", "z=1"], "--load, column 1: \"z=1\" is not a load"),
        (&["reference", "scene.toml", "--grid", "1:2"], "--grid, column 1: "),
        (&["reference", "scene.toml", "--grid", "0:2:11"], "--grid, column 1: 2 has no unit"),
        (&["reference", "scene.toml", "--grid", "8", "--box", "8"], "--box, column 1: the box has no unit"),
    ];
    for (arguments, message) in cases {
        let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).current_dir(&place).args(arguments).output().unwrap();
        let error = String::from_utf8(done.stderr).unwrap();
        assert!(done.status.code() == Some(2) && error.contains(message), "{arguments:?}: {error}");
    }
}

/// A rectangle, a stack of one field per load, and an array that `--map` names by its number.
#[test]
fn fields_of_every_shape_are_read() {
    let place = room("shapes");
    let one = format!("{SCENE}[load]\ncontact_radius = 1\n");
    let two = format!("{SCENE}[load]\ncontact_radius = [0.8, 1]\n");
    let cases: [(&str, Vec<u8>, &str, &[&str]); 5] = [
        (&one, npy(&[64, 64], &field(&[1.0], 64, 64)), "3.2", &["--map", "p=1"]),
        (&one, npy(&[48, 64], &field(&[1.0], 48, 64)), "3.2", &[]),
        (&one, npy(&[80, 48], &field(&[1.0], 80, 48)), "4", &[]),
        (&two, npy(&[2, 64, 64], &field(&[0.8, 1.0], 64, 64)), "3.2", &[]),
        (&two, npy(&[2, 64, 64], &field(&[0.8, 1.0], 64, 64)), "3.2", &["--map", "p=2", "--load", "a=1"]),
    ];
    for (scene, bytes, side, more) in cases {
        fs::write(place.join("data.npy"), bytes).unwrap();
        let (code, found) = validated(&place, scene, &["data.npy".to_owned()], &[&["--box", side], more].concat());
        assert_eq!(code, 0, "{more:?}: {found:#}");
    }
    // The loads in the other order.
    fs::write(place.join("data.npy"), npy(&[2, 64, 64], &field(&[1.0, 0.8], 64, 64))).unwrap();
    let (code, found) = validated(&place, &two, &["data.npy".to_owned()], &["--box", "3.2"]);
    assert_eq!(code, 1, "{found:#}");
}

/// The numbers of pixels in another order than the files contradict the places, and contact radii that are counted.
#[test]
fn grids_in_another_order_are_named() {
    let place = room("order");
    let runs = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/solver_runs");
    let tip = "[profile]\nf = \"r^2/(2*R)\"\nparameters = { R = \"5 mm\" }\n[material]\nE = \"210 GPa\"\nnu = 0.3\n";
    for (kind, load) in [("p", "[load]\ncontact_radius = \"0.1 mm\"\n"), ("Fd", "")] {
        let files = [64, 128].map(|n| runs.join(format!("paraboloid_tamaas_dcfft_n{n}_{kind}.csv")).display().to_string());
        for (grid, code) in [("64,128", 0), ("128,64", 1)] {
            let (found, document) = validated(&place, &format!("{tip}{load}"), &files, &["--grid", grid, "--box", "0.4 mm"]);
            assert_eq!(found, code, "{document:#}");
            let id = document["suspicion_details"].get("id").cloned().unwrap_or_default();
            assert_eq!(id, if code == 0 { Value::Null } else { Value::from("file-order") }, "{document:#}");
        }
    }
}

/// A shift by one pixel of 256: places that are drawn by a step would all lie in a few columns.
#[test]
fn the_axis_of_a_fine_lattice_is_found() {
    let place = room("axis");
    let scene = format!("{SCENE}[load]\ncontact_radius = 4\n");
    let whole = field(&[4.0], 256, 256);
    for (rows, across) in [(1, 0), (0, 1), (-1, 1)] {
        let at = |i: i32, j: i32| whole[usize::try_from(256 * (i - rows).rem_euclid(256) + (j - across).rem_euclid(256)).unwrap()];
        let moved: Vec<f64> = (0..256).flat_map(|i| (0..256).map(move |j| at(i, j))).collect();
        fs::write(place.join("data.npy"), npy(&[256, 256], &moved)).unwrap();
        let (code, found) = validated(&place, &scene, &["data.npy".to_owned()], &["--box", "12.8", "--origin", "pixel"]);
        assert_eq!((code, &found["suspicion_details"]["id"]), (1, &"origin".into()), "{found:#}");
        let text = found["suspicion"].as_str().unwrap();
        let named: Vec<f64> = text.split(['(', ',', ')']).filter_map(|own| own.trim().parse().ok()).collect();
        let [x, y] = named[..] else { panic!("{text}") };
        assert!((x - 0.05 * f64::from(across)).abs() < 1e-3 && (y - 0.05 * f64::from(rows)).abs() < 1e-3, "{rows} {across}: {text}");
    }
}

/// Compares pressures at radii far below a pixel. Near the axis, p(r) − p(0) is a multiple of r² ln r for the first tip, and p(r) grows
/// like −ln r for the second.
#[test]
fn pressures_next_to_the_axis_are_compared() {
    let place = room("next");
    let radii: Vec<f64> = [1e-15, 1e-12, 1e-9, 1e-8, 1e-6].into_iter().chain((1..40).map(|i| 0.02 * f64::from(i))).collect();
    for tip in ["r^2*exp(r)", "r+r^2*exp(r)/100"] {
        let scene = format!("[profile]\nf = \"{tip}\"\n[material]\neffective_modulus = 1\n[load]\ncontact_radius = 1\n");
        let places: Vec<String> = radii.iter().map(f64::to_string).collect();
        let words = ["eval", tip, "--quantity", "p", "--radius", "1", "--at", &places.join(","), "--method", "quadrature", "--csv"];
        let made = Command::new(env!("CARGO_BIN_EXE_sneddon")).args(words).output().unwrap();
        let table = String::from_utf8(made.stdout).unwrap();
        let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').take(2).collect()).collect();
        fs::write(place.join("data.csv"), rows.iter().map(|own| own.join(",") + "\n").collect::<String>()).unwrap();
        let (code, found) = validated(&place, &scene, &["data.csv".to_owned()], &["--tol", "1e-6"]);
        let largest = found["columns"]["p"]["max"].as_f64().unwrap();
        assert!(code == 0 && largest < 1e-7, "{tip}: {found:#}");
    }
}

/// Fewer pixels than places along a side, and boxes that the counted contact radii do not fit.
#[test]
fn grids_and_boxes_that_cannot_be_fail() {
    let place = room("impossible");
    let scene = format!("{SCENE}[load]\ncontact_radius = 1\n");
    let step = |index: usize| 0.05 * (index as f64 - 32.0);
    let row =
        |index: usize| format!("{},{},{:?}\n", step(index % 64), step(index / 64), pressure(1.0, step(index % 64).hypot(step(index / 64))));
    fs::write(place.join("data.csv"), format!("x,y,p\n{}", (0..64 * 64).map(row).collect::<String>())).unwrap();
    let counted = |a: f64| {
        let pixels = (0..64 * 64).filter(|index| step(index % 64).hypot(step(index / 64)) < a).count();
        (pixels as f64 / PI).sqrt() * 0.05
    };
    let load = |index: i32| {
        let a = 0.3 + 0.1 * f64::from(index);
        format!("{:?},{:?},{:?}\n", a * a / 10.0, 4.0 * a.powi(3) / 30.0, counted(a))
    };
    fs::write(place.join("loads.csv"), format!("d,F,a\n{}", (0..9).map(load).collect::<String>())).unwrap();
    for (file, more, code) in [
        ("data.csv", &["--grid", "64"][..], 0),
        ("data.csv", &["--grid", "32"], 1),
        ("data.csv", &["--grid", "63"], 1),
        ("data.csv", &["--box", "3.2"], 0),
        ("data.csv", &["--box", "3.12"], 1),
        ("loads.csv", &["--grid", "64", "--box", "3.2"], 0),
        ("loads.csv", &["--grid", "32", "--box", "3.2"], 1),
        ("loads.csv", &["--grid", "64", "--box", "6.4"], 1),
    ] {
        let (found, document) = validated(&place, &scene, &[file.to_owned()], more);
        assert_eq!(found, code, "{file} {more:?}: {document:#}");
        let name = if code == 0 { Value::Null } else { Value::from("box") };
        assert_eq!(document["suspicion_details"].get("id").cloned().unwrap_or_default(), name, "{more:?}: {document:#}");
    }
}

/// Where a pixel lies next to a kink, the mean that a solver has there is far below the exact value; the force of all pixels is right.
#[test]
fn a_pixel_at_a_kink_leaves_the_force_alone() {
    let place = room("kink");
    let scene =
        "[profile]\nf = \"max(0,s*(r-b))\"\nparameters = { b = 0.6, s = 0.2 }\n[material]\nE = 1\nnu = 0\n[load]\ncontact_radius = 1\n";
    fs::write(place.join("scene.toml"), scene).unwrap();
    // The places (12.5, 2.5) h, at the distance 12.75 h from the axis.
    let h = 0.6 / 12.5_f64.hypot(2.5) * (1.0 + 1e-9);
    let side = format!("{:?}", 64.0 * h);
    let done = reference(&place, &["--grid", "64", "--box", &side, "--between"]);
    let text = String::from_utf8(done.stdout).unwrap();
    let row = |line: &str| line.split(',').map(|own| own.parse::<f64>().unwrap_or(f64::NAN)).collect::<Vec<_>>();
    let rows: Vec<Vec<f64>> = text.lines().skip(1).map(row).collect();
    let near = |row: &&Vec<f64>| (0.3..0.7).contains(&((row[2] - 0.6).abs() / h));
    let most = rows.iter().filter(near).map(|row| row[3]).fold(0.0, f64::max);
    assert!(rows.iter().any(|row| row[3] > 2.0 * most));
    // Not `most` itself: several places with one largest pressure would be cut off.
    let data = rows.iter().map(|row| format!("{:?},{:?},{:?}\n", row[0], row[1], if row[3] > most { 0.999 * most } else { row[3] }));
    fs::write(place.join("data.csv"), format!("x,y,p\n{}", data.collect::<String>())).unwrap();
    let (code, found) = validated(&place, scene, &["data.csv".to_owned()], &[]);
    assert_eq!(code, 0, "{found:#}");
}

fn reference(place: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sneddon")).current_dir(place).args(["reference", "scene.toml"]).args(arguments).output().unwrap()
}

#[test]
fn the_places_of_a_file_are_a_grid() {
    let place = room("points");
    fs::write(place.join("scene.toml"), format!("{SCENE}[load]\ncontact_radius = 1\n")).unwrap();
    fs::write(place.join("plane.csv"), "n,x,y\n1,0.3,0.4\n2,-0.6,0\n3,2,0\n").unwrap();
    fs::write(place.join("radii.csv"), "# in any order\nr\n0.6\n0\n0.5\n").unwrap();
    for (file, count, radii) in [("plane.csv", 3, [0.5, 0.6, 2.0]), ("radii.csv", 1, [0.6, 0.0, 0.5])] {
        let done = reference(&place, &["--points", file]);
        let text = String::from_utf8(done.stdout).unwrap();
        let rows: Vec<Vec<&str>> = text.lines().skip(1).map(|line| line.split(',').collect()).collect();
        assert_eq!(rows.len(), 3, "{text}");
        for (row, r) in rows.iter().zip(radii) {
            let [own, p, error] = [count - 1, count, count + 1].map(|index| row[index].parse::<f64>().unwrap());
            assert!((own - r).abs() <= 1e-16 * r && (p - pressure(1.0, r)).abs() <= error + 1e-16, "{text}");
        }
    }
    for (file, text, message) in
        [("none.csv", "p\n1\n", "no columns x and y"), ("bad.csv", "r\n-1\n", "negative radius"), ("words.csv", "x,y\n1,one\n", "line 2")]
    {
        fs::write(place.join(file), text).unwrap();
        let done = reference(&place, &["--points", file, "-o", "out.csv"]);
        let error = String::from_utf8(done.stderr).unwrap();
        assert!(done.status.code() == Some(2) && error.contains(message), "{error}");
        assert!(!place.join("out.csv").exists());
    }
}
