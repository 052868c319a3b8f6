//! Single pixels that differ from the mirrored ones: the tolerance next to the edge and to kinks is wide, the symmetry of a field is not.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::indexing_slicing)]

use crate::validate::{room, validated};
use sneddon_checks::seeds::cases;
use std::fs;
use std::process::Command;

/// Lengths in units of the contact radius.
const SHAPES: [(&str, &str); 4] = [
    ("r^2/(2*R)", "R = 50"),
    ("piecewise(0, r<b, (r-b)*tan(theta))", "b = 0.4, theta = \"10 deg\""),
    ("piecewise(0, r<b, (r-b)^2/(2*R))", "b = 0.5, R = 50"),
    ("h*(1-exp(-r^2/w^2))", "h = 0.03, w = 2"),
];

/// A field of pixels of a box with side 3, as exact values at points or as means over pixels.
fn field(name: &str, (f, parameters): (&str, &str), pixels: usize, means: bool) -> (std::path::PathBuf, String, Vec<[f64; 3]>) {
    let place = room(name);
    let scene = format!(
        "[profile]\nf = \"{f}\"\nparameters = {{ {parameters} }}\n[material]\neffective_modulus = 1e5\n[load]\ncontact_radius = 1.0\n"
    );
    fs::write(place.join("scene.toml"), &scene).unwrap();
    let count = pixels.to_string();
    let mut arguments = vec!["reference", "scene.toml", "--grid", &count, "--box", "3"];
    arguments.extend(means.then_some("--cells"));
    let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).current_dir(&place).args(arguments).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let text = String::from_utf8(done.stdout).unwrap();
    let row = |line: &str| {
        let numbers: Vec<f64> = line.split(',').map(|own| own.parse().unwrap_or(f64::NAN)).collect();
        [0, 1, 3].map(|at| numbers[at])
    };
    let rows: Vec<[f64; 3]> = text.lines().skip(1).map(row).filter(|own| own.iter().all(|own| own.is_finite())).collect();
    (place, scene, rows)
}

fn written(rows: &[[f64; 3]]) -> String {
    rows.iter().fold("x,y,p\n".to_owned(), |text, [x, y, p]| text + &format!("{x:?},{y:?},{p:?}\n"))
}

/// Class "one pixel among mirrored ones": beside the edge, beside a kink, on a kink, and in the middle.
#[test]
fn a_single_pixel_fails_wherever_it_is() {
    for shape in SHAPES.into_iter().step_by(cases(2, 1)) {
        for (pixels, means) in [(64, false), (64, true), (32, true)] {
            let (place, scene, rows) = field("single_pixel", shape, pixels, means);
            let file = |rows: &[[f64; 3]]| {
                fs::write(place.join("field.csv"), written(rows)).unwrap();
                let more: &[&str] = if means { &["--cells"] } else { &[] };
                validated(&place, &scene, &["field.csv".to_owned()], more)
            };
            assert_eq!(file(&rows).0, 0, "{shape:?} {pixels} {means}");
            for radius in [0.3, 0.39, 0.47, 0.6, 0.86, 0.89, 0.93] {
                let distance = |own: &[f64; 3]| (own[0].hypot(own[1]) - radius).abs();
                // Points on an axis or a diagonal have three mirrored points, and others seven.
                let at = (0..rows.len()).min_by(|one, other| distance(&rows[*one]).total_cmp(&distance(&rows[*other]))).unwrap();
                for factor in [0.8, 1.1, 1.3] {
                    let mut wrong = rows.clone();
                    wrong[at][2] *= factor;
                    let (code, found) = file(&wrong);
                    assert_eq!(code, 1, "{shape:?} {pixels} {means}: {factor} at {radius}");
                    assert_eq!(
                        found["suspicion_details"]["id"], "single-row",
                        "{shape:?} {pixels} {means}: {factor} at {radius}: {found:#}"
                    );
                }
            }
        }
    }
}

/// Validation accepts the noise of a solver and rejects a ring of pixels that contradict each other.
#[test]
fn noise_passes_and_contradicting_rings_fail() {
    let mut seed = 1_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
    };
    for shape in SHAPES {
        let (place, scene, rows) = field("contradicting", shape, 64, true);
        let noisy: Vec<[f64; 3]> = rows.iter().map(|[x, y, p]| [*x, *y, p * (1.0 + 5e-4 * random())]).collect();
        let ring: Vec<[f64; 3]> = rows
            .iter()
            .map(|[x, y, p]| [*x, *y, if (x.hypot(*y) - 0.85).abs() < 0.07 { p * (1.0 + 0.15 * random()) } else { *p }])
            .collect();
        let double: Vec<[f64; 3]> = rows.iter().chain(&rows[2048..2112]).copied().collect();
        for (rows, expected) in [(&noisy, 0), (&ring, 1), (&double, 0)] {
            fs::write(place.join("field.csv"), written(rows)).unwrap();
            let (code, found) = validated(&place, &scene, &["field.csv".to_owned()], &["--cells"]);
            assert_eq!(code, expected, "{shape:?}: {found:#}");
        }
        let (_, found) = validated(&place, &scene, &["field.csv".to_owned()], &["--cells"]);
        let notes = found["files"][0]["notes"].to_string();
        assert!(
            notes.contains(" points are in the data more than once") && notes.contains("all points of a lattice, each once"),
            "{shape:?}: {notes}"
        );
    }
}
