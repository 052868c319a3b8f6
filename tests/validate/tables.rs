//! Tables of loads as people write them: many rows, small factors, headers with words, and one wrong contact radius.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::indexing_slicing)]

use crate::validate::{room, validated};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Smooth, with a kink below the largest radius, with a largest depth, and with a closed a(d).
const SHAPES: [(&str, &str); 5] = [
    ("h*(1-exp(-r^2/w^2))", "h = 0.03, w = 2"),
    ("piecewise(r^2/(2*R), r<b, b^2/(2*R)+(r-b)*tan(theta))", "b = 0.7, R = 50, theta = \"10 deg\""),
    ("piecewise(0, r<b, (r-b)*tan(theta))", "b = 0.2, theta = \"10 deg\""),
    ("h*tanh(r/w)^2", "h = 0.03, w = 2"),
    ("r^2/(2*R)", "R = 50"),
];

fn scene((f, parameters): (&str, &str), load: &str) -> String {
    format!("[profile]\nf = \"{f}\"\nparameters = {{ {parameters} }}\n[material]\nE = 210e9\nnu = 0.3\n{load}")
}

/// d, F and a of a scene; evenly spaced radii would look like areas that are counted in pixels.
fn solved(place: &Path, text: &str) -> Vec<[f64; 3]> {
    fs::write(place.join("solved.toml"), text).unwrap();
    let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).current_dir(place).args(["solve", "solved.toml", "--json"]).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let document: Value = serde_json::from_slice(&done.stdout).unwrap();
    document["rows"].as_array().unwrap().iter().map(|row| ["d", "F", "a"].map(|key| row[key].as_f64().unwrap())).collect()
}

fn table(place: &Path, header: &str, rows: &[[f64; 3]], columns: usize) -> Vec<String> {
    let line = |row: &[f64; 3]| row[..columns].iter().map(|own| format!("{own:?}")).collect::<Vec<_>>().join(",") + "\n";
    fs::write(place.join("rows.csv"), format!("{header}\n{}", rows.iter().map(line).collect::<String>())).unwrap();
    vec!["rows.csv".to_owned()]
}

fn exact(name: &str, shape: (&str, &str), count: usize) -> (PathBuf, Vec<[f64; 3]>) {
    let place = room(name);
    let rows = solved(
        &place,
        &scene(shape, &format!("[load]\ncontact_radius = {{ start = 0.5, stop = 1.0, count = {count}, spacing = \"log\" }}\n")),
    );
    (place, rows)
}

/// Interpolated states differ from exact rows by rounding only.
#[test]
fn long_tables_are_compared_with_the_exact_states() {
    for shape in SHAPES {
        let (place, rows) = exact("long", shape, 700);
        for data in ["", "[data]\ncontrol = \"force\"\n"] {
            let (code, found) = validated(&place, &scene(shape, data), &table(&place, "d,F,a", &rows, 3), &[]);
            assert_eq!(code, 0, "{shape:?}: {found:#}");
            for (name, column) in found["columns"].as_object().unwrap() {
                let max = column["max"].as_f64().unwrap();
                assert!(max < 6e-15, "{shape:?} {data}: {name} {max:e}");
            }
        }
    }
}

/// The diagnosis names a constant factor of all forces, even if the error is as small as the error of a coarse grid.
#[test]
fn a_small_factor_of_all_forces_is_named() {
    for shape in SHAPES {
        let (place, rows) = exact("factor", shape, 17);
        let text = scene(shape, "");
        for (factor, columns) in [(1.005, 3), (0.995, 3), (1.02, 3), (1.015, 2), (0.98, 2), (1.0, 3), (1.0, 2)] {
            let rows: Vec<[f64; 3]> = rows.iter().map(|[d, force, a]| [*d, factor * force, *a]).collect();
            let header = if columns == 3 { "d,F,a" } else { "d,F" };
            let (code, found) = validated(&place, &text, &table(&place, header, &rows, columns), &["--budget", "2"]);
            let expected = if factor == 1.0 { Value::Null } else { Value::from("modulus") };
            assert_eq!((code, &found["suspicion_details"]["id"]), (i32::from(factor != 1.0), &expected), "{shape:?} {factor}: {found:#}");
        }
    }
}

/// Class "the same names with spaces, brackets and capitals": a column that is ignored widens the tolerance.
#[test]
fn headers_are_read_as_people_write_them() {
    let shape = SHAPES[4];
    let (place, rows) = exact("headers", shape, 17);
    let text = scene(shape, "");
    for header in [
        "d,F,contact_radius",
        "Depth,Normal force,Contact radius",
        "depth [m],force [N],contact radius [m]",
        "Indentation depth (m),Load (N),contact_radius (m)",
        "indentation-depth_m,normal-force_N,contact-radius_m",
        "d / m,F / N,Contact Radius / m",
    ] {
        for factor in [1.0, 1.005] {
            let rows: Vec<[f64; 3]> = rows.iter().map(|[d, force, a]| [*d, factor * force, *a]).collect();
            let (code, found) = validated(&place, &text, &table(&place, header, &rows, 3), &[]);
            assert_eq!(code, i32::from(factor != 1.0), "{header}: {found:#}");
            assert!(!found["reason"].to_string().contains("ignored"), "{header}: {found:#}");
        }
    }
}

/// Counted contact areas, one of which is wrong: the pixel is that of the others, and F is not accused.
#[test]
fn one_wrong_radius_does_not_change_the_pixel() {
    let shape = SHAPES[4];
    let (place, mut rows) = exact("radius", shape, 17);
    let pixel: f64 = 3.0 / 128.0;
    for row in &mut rows {
        let reach = (row[2] / pixel) as i64;
        let points = (-reach..=reach).flat_map(|i| (-reach..=reach).map(move |j| (i, j)));
        let count = points.filter(|(i, j)| ((i * i + j * j) as f64).sqrt() * pixel < row[2]).count();
        row[2] = (count as f64 / std::f64::consts::PI).sqrt() * pixel;
    }
    let text = scene(shape, "");
    assert_eq!(validated(&place, &text, &table(&place, "d,F,a", &rows, 3), &[]).0, 0);
    for at in [0, 8, 16] {
        let mut wrong = rows.clone();
        wrong[at][2] *= 1.1;
        let (code, found) = validated(&place, &text, &table(&place, "d,F,a", &wrong, 3), &[]);
        assert_eq!(code, 1, "{at}");
        let passed = ["F", "a"].map(|name| found["columns"][name]["passed"].as_bool());
        assert_eq!(passed, [Some(true), Some(false)], "{at}: {found:#}");
    }
}

/// Units are named as the columns have them, and a factor of 1000 is a unit rather than a factor of 100 of another column.
#[test]
fn unit_slips_name_the_units_of_the_columns() {
    let shape = ("r^2/(2*R)", "R = \"50 um\"");
    let place = room("units");
    let units = "[outputs]\nunits = { length = \"um\", force = \"mN\" }\n";
    let load = "[load]\ncontact_radius = { start = \"0.5 um\", stop = \"1 um\", count = 9 }\n";
    let with_units = |more: &str| scene(shape, more).replace("210e9", "\"210 GPa\"");
    let text = with_units(units);
    let rows = solved(&place, &with_units(&format!("{load}{units}")));
    let slips: [(&str, [f64; 3], usize, &str); 4] = [
        ("d_um,F_mN", [1.0, 1e3, 1.0], 2, "F is 10^3 times too large: the numbers are in uN, but were read as mN"),
        ("d_mm,F_mN,a_um", [1.0, 1.0, 1.0], 3, "d is 10^3 times too large: the numbers are in um, but were read as mm"),
        ("d_um,F_mN,a_um", [1e-3, 1.0, 1.0], 3, "d is 10^3 times too small: the numbers are in mm, but were read as um"),
        ("d_um,F_uN,a_um", [1.0, 1e-3, 1.0], 3, "F is 10^6 times too small: the numbers are in N, but were read as uN"),
    ];
    for (header, factors, columns, expected) in slips {
        let rows: Vec<[f64; 3]> = rows.iter().map(|row| [0, 1, 2].map(|at| row[at] * factors[at])).collect();
        let (code, found) = validated(&place, &text, &table(&place, header, &rows, columns), &[]);
        let suspicion = found["suspicion"].as_str().unwrap_or_default();
        assert!(code == 1 && suspicion.contains(expected), "{header}: {suspicion}");
    }
}

/// A lone array is the pressure, whatever the name of its file, and its pixels are those of the grid.
#[test]
fn a_lone_array_is_the_pressure() {
    let place = room("lone");
    let text = scene(("r^2/(2*R)", "R = 50"), "[load]\ncontact_radius = 1.0\n");
    let (modulus, h) = (210e9 / 0.91, 3.0 / 64.0);
    let pressure = |i: usize, j: usize| {
        let (x, y) = ((i as f64 - 31.5) * h, (j as f64 - 31.5) * h);
        2.0 / std::f64::consts::PI * modulus / 50.0 * (1.0 - x * x - y * y).max(0.0).sqrt()
    };
    let head = "{'descr': '<f8', 'fortran_order': False, 'shape': (64, 64), }\n";
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((head.len() as u16).to_le_bytes());
    bytes.extend(head.as_bytes());
    bytes.extend((0..4096).flat_map(|at| pressure(at / 64, at % 64).to_le_bytes()));
    for name in ["q", "p", "r", "a", "d", "x", "U", "k", "F", "force", "contact_radius"] {
        let file = format!("{name}.npy");
        fs::write(place.join(&file), &bytes).unwrap();
        let (code, found) = validated(&place, &text, &[file], &["--box", "3"]);
        assert_eq!(code, 0, "{name}: {found:#}");
        assert!(found["columns"]["p"].is_object(), "{name}: {found:#}");
    }
    for grid in ["64", "32", "65", "128"] {
        let (code, found) = validated(&place, &text, &["q.npy".to_owned()], &["--box", "3", "--grid", grid]);
        assert_eq!(code, i32::from(grid != "64"), "{grid}: {found:#}");
        assert!(grid == "64" || found["suspicion_details"]["id"] == "box", "{grid}: {found:#}");
    }
}
