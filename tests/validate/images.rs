//! Pressures in small periodic boxes by tamaas: the images are named, with the side of the box.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used)]

use serde_json::Value;
use sneddon_checks::seeds::cases;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

const COUNT: usize = 64;

/// The pressures of each tip in each box, of one eighth of the pixels, by tests/oracle/periodic_boxes.py.
fn boxes() -> BTreeMap<(String, String), BTreeMap<(usize, usize), String>> {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/periodic_boxes.csv");
    let mut found = BTreeMap::<_, BTreeMap<_, _>>::new();
    for line in fs::read_to_string(path).unwrap().lines().skip(1) {
        let [tip, side, i, j, p] = line.split(',').collect::<Vec<_>>().try_into().unwrap();
        let place = (i.parse().unwrap(), j.parse().unwrap());
        found.entry((tip.to_owned(), side.to_owned())).or_default().insert(place, p.to_owned());
    }
    found
}

#[test]
fn images_are_named_down_to_touching_contacts() {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("images");
    fs::create_dir_all(&place).unwrap();
    let boxes = boxes();
    assert_eq!(boxes.len(), 6);
    for ((tip, side), pressures) in boxes.into_iter().step_by(cases(2, 1)) {
        let formula = match tip.as_str() {
            "cone" => "r/5",
            "paraboloid" => "r^2/20",
            _ => "r^4/20",
        };
        let scene = format!("[profile]\nf = \"{formula}\"\n[material]\neffective_modulus = 1\n[load]\ncontact_radius = 1\n");
        fs::write(place.join("scene.toml"), scene).unwrap();
        let side_of_box: f64 = side.parse().unwrap();
        let mut data = "x,y,p\n".to_owned();
        // The axis lies between the four middle pixels.
        let distance = |index: usize| if index < COUNT / 2 { COUNT / 2 - 1 - index } else { index - COUNT / 2 };
        let at = |index: usize| (index as f64 - (COUNT as f64 - 1.0) / 2.0) * side_of_box / COUNT as f64;
        for row in 0..COUNT {
            for column in 0..COUNT {
                let (i, j) = (distance(row), distance(column));
                writeln!(data, "{},{},{}", at(column), at(row), pressures[&(i.max(j), i.min(j))]).unwrap();
            }
        }
        fs::write(place.join("data.csv"), &data).unwrap();
        // Without a part of the box, nothing but the pressures tells its side; where contacts almost touch, that is not found.
        let part: Vec<&str> = data.lines().enumerate().filter(|(index, _)| *index == 0 || index % COUNT > 3).map(|own| own.1).collect();
        fs::write(place.join("part.csv"), part.join("\n")).unwrap();
        let calls = [&["data.csv", "--grid", "64", "--box", &side][..], &["data.csv"], &["part.csv"]];
        for known in &calls[..if side_of_box > 2.5 { 3 } else { 2 }] {
            let arguments = [["validate", "scene.toml", "--json"].as_slice(), known].concat();
            let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).current_dir(&place).args(arguments).output().unwrap();
            let answer: Value = serde_json::from_slice(&done.stdout).unwrap();
            assert_eq!((done.status.code(), &answer["suspicion_details"]["id"]), (Some(1), &"periodic".into()), "{tip} {side}: {answer}");
            let text = answer["suspicion"].as_str().unwrap();
            let named: f64 = text.split("a side of ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
            // Where the side is declared, there is nothing to find.
            assert!(known.contains(&"--box") || (named / side_of_box - 1.0).abs() < 2e-3, "{tip} {side}: {text}");
        }
    }
}
