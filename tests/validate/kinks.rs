//! Faults of pressures within four pixels of a kink or of a rim, which the norms leave out.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used)]

use crate::validate::{room, validated};
use sneddon_checks::seeds::sample;
use std::fs;
use std::process::Command;

/// Tips with a kink or a rim, with the radius of the contact and that of the kink.
const TIPS: [(&str, &str, f64); 4] = [
    ("f = \"max(0, r-b)*s\"\nparameters = { b = 0.5, s = 0.2 }\n", "contact_radius = 1", 0.5),
    ("f = \"max(0, r^2-b^2)/20\"\nparameters = { b = 0.4 }\n", "contact_radius = 1", 0.4),
    ("f = \"r*s\"\nparameters = { s = 0.2 }\n", "contact_radius = 1", 0.0),
    ("f = \"0\"\nradius = 1\n", "depth = 0.05", 1.0),
];

/// Rows x, y, r, p of exact pressures at the middles of pixels, 64 along a side of 3.
fn exact(scene: &str, place: &std::path::Path) -> Vec<[f64; 4]> {
    fs::write(place.join("exact.toml"), scene).unwrap();
    let arguments = ["reference", "exact.toml", "--grid", "64", "--box", "3", "--between"];
    let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).current_dir(place).args(arguments).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let row = |line: &str| {
        let numbers: Vec<f64> = line.split(',').take(4).map(|own| own.parse().unwrap()).collect();
        numbers.try_into().unwrap()
    };
    String::from_utf8(done.stdout).unwrap().lines().skip(1).map(row).collect()
}

#[test]
fn faults_next_to_kinks_and_rims_fail() {
    let place = room("kinks");
    let pixel = 3.0 / 64.0;
    for (tip, load, kink) in sample(TIPS, 0, 2) {
        let scene = format!("[profile]\n{tip}[material]\neffective_modulus = 1\n[load]\n{load}\n[data]\npressure = \"point\"\n");
        let rows = exact(&scene, &place);
        let judged = |change: &dyn Fn(f64, f64, f64, f64) -> f64, digits: usize| {
            let row = |own: &[f64; 4]| {
                let [x, y, r, p] = *own;
                format!("{x},{y},{:.*e}\n", digits - 1, change(x, y, r, p))
            };
            fs::write(place.join("data.csv"), format!("x,y,p\n{}", rows.iter().map(row).collect::<String>())).unwrap();
            validated(&place, &scene, &["data.csv".to_owned()], &["--grid", "64", "--box", "3"])
        };
        // Few digits make equal numbers, but nothing that is cut off.
        for digits in [3, 12] {
            let (code, found) = judged(&|_, _, _, p| p, digits);
            assert_eq!(code, 0, "{tip} {digits}: {found:#}");
        }
        let mut by_size: Vec<f64> = rows.iter().map(|own| own[3]).filter(|p| *p > 0.0).collect();
        by_size.sort_by(f64::total_cmp);
        let top = by_size[by_size.len() - 1 - by_size.len() / 12];
        let (code, found) = judged(&|_, _, _, p| p.min(top), 12);
        assert_eq!(code, 1, "{tip}: {found:#}");
        assert_eq!(found["suspicion_details"]["id"], "cut-off", "{tip}: {found:#}");
        if kink < 1.0 {
            // One pixel between one and four pixels from the kink.
            let [u, v, ..] = *rows.iter().find(|own| own[2] > kink + 1.6 * pixel && own[2] < kink + 2.6 * pixel).unwrap();
            for factor in [1.15, 0.85] {
                let (code, found) = judged(&|x, y, _, p| if (x, y) == (u, v) { factor * p } else { p }, 12);
                assert_eq!((code, &found["suspicion_details"]["id"]), (1, &"single-row".into()), "{tip} {factor}: {found:#}");
            }
        }
    }
}

/// Under a rim the force of whole pixels is that of a radius a' − 0.116 h, where a' is counted: so it was in every solver that was measured.
#[test]
fn one_per_cent_more_force_under_a_rim_fails() {
    let place = room("rim");
    let (side, radius, depth) = (3.0, 1.0, 0.05);
    for count in [64, 96, 128] {
        let pixel = side / f64::from(count);
        let at = |index: i32| (f64::from(index - count / 2) + 0.5) * pixel;
        let lattice = || (0..count).flat_map(|i| (0..count).map(move |j| (i, j)));
        let inside = |(i, j): (i32, i32)| at(i).hypot(at(j)) < radius;
        let counted = (lattice().filter(|own| inside(*own)).count() as f64 / std::f64::consts::PI).sqrt() * pixel;
        let effective = counted - 0.116 * pixel;
        let scene = "[profile]\nf = \"0\"\nradius = 1\n[material]\neffective_modulus = 1\n";
        let loads = |factor: f64| {
            let row = |k: i32| {
                let d = depth * f64::from(k) / 8.0;
                format!("{d},{:?},{counted:?}\n", factor * 2.0 * effective * d)
            };
            format!("d,F,a\n{}", (1..=8).map(row).collect::<String>())
        };
        // Pressures of that force: those of the exact contact, but for what the pixels next to the rim take.
        let field = |factor: f64| {
            let exact = |(i, j): (i32, i32)| {
                let r = at(i).hypot(at(j));
                depth / std::f64::consts::PI / (radius * radius - r * r).sqrt()
            };
            let is_next = |own: (i32, i32)| at(own.0).hypot(at(own.1)) > radius - 2.0 * pixel;
            let sum = |next: bool| lattice().filter(|own| inside(*own) && is_next(*own) == next).map(exact).sum::<f64>() * pixel * pixel;
            let rest = (2.0 * effective * depth - sum(false)) / sum(true);
            let row = |own: (i32, i32)| {
                let p = if !inside(own) { 0.0 } else { factor * exact(own) * if is_next(own) { rest } else { 1.0 } };
                format!("{},{},{p:?}\n", at(own.0), at(own.1))
            };
            format!("x,y,p\n{}", lattice().map(row).collect::<String>())
        };
        for factor in [1.0, 1.01, 0.985] {
            let code = i32::from(factor != 1.0);
            fs::write(place.join("loads.csv"), loads(factor)).unwrap();
            let grid = count.to_string();
            let (found, document) = validated(&place, scene, &["loads.csv".to_owned()], &["--grid", &grid, "--box", "3"]);
            assert_eq!(found, code, "{count} {factor}: {document:#}");
            fs::write(place.join("field.csv"), field(factor)).unwrap();
            let scene = format!("{scene}[load]\ndepth = {depth}\n");
            let (found, document) = validated(&place, &scene, &["field.csv".to_owned()], &["--grid", &grid, "--box", "3"]);
            assert_eq!(found, code, "field {count} {factor}: {document:#}");
        }
    }
}
