//! Files that `sneddon reference` writes, read by `sneddon validate`.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::panic)]

use serde_json::Value;
use sneddon_checks::seeds::{cases, sample, takes};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn run_in(place: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sneddon")).current_dir(place).args(arguments).output().unwrap()
}

fn room(name: &str) -> PathBuf {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("references").join(name);
    let _ = fs::remove_dir_all(&place);
    fs::create_dir_all(&place).unwrap();
    place
}

/// An NPY file of doubles.
fn npy(shape: &[usize], numbers: &[f64]) -> Vec<u8> {
    let shape: String = shape.iter().map(|own| format!("{own}, ")).collect();
    let head = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({shape}), }}\n");
    let size = u16::try_from(head.len()).unwrap().to_le_bytes();
    [b"\x93NUMPY\x01\x00", &size[..], head.as_bytes()]
        .concat()
        .into_iter()
        .chain(numbers.iter().flat_map(|own| own.to_le_bytes()))
        .collect()
}

/// The verdict on a file.
fn judged(place: &Path, file: &str, options: &[&str]) -> Value {
    let done = run_in(place, &[&["validate", "scene.toml", file, "--json"], options].concat());
    assert!(matches!(done.status.code(), Some(0 | 1)), "{file}: {}", String::from_utf8_lossy(&done.stderr));
    let document: Value = serde_json::from_slice(&done.stdout).unwrap();
    assert_eq!(document["passed"] == true, done.status.success());
    document
}

/// Class "a file that `reference` wrote is refused": tables with bounds and with infinite pressures, bare and with units, are read and pass.
#[test]
fn tables_of_references_are_validated() {
    let place = room("reference");
    let bare = "[material]\neffective_modulus = 1.0\n[load]\ndepth = 0.1\n[outputs]\nquantities = [\"p\", \"u\"]\n";
    let units = "[material]\neffective_modulus = \"70 GPa\"\n[load]\ndepth = \"0.1 um\"\n[outputs]\nquantities = [\"p\", \"u\"]\n";
    let cases = [
        ("[profile]\nf = \"0.3*r\"\n", bare, "1"),
        ("[profile]\nf = \"r^2\"\n", bare, "1"),
        ("[profile]\nf = \"max(0,r-b)/2\"\nparameters = { b = 0.125 }\n", bare, "1"),
        ("[profile]\nf = \"r^2/(2*R)\"\nparameters = { R = \"2 um\" }\n", units, "2 um"),
        ("[profile]\nf = \"r/4\"\n", units, "2 um"),
        // p(0) = 0, of which rounding leaves 1e-15.
        ("[profile]\nf = \"-h*r^2/c^2\"\nparameters = { h = 0.05, c = 1.5 }\nradius = 1.5\n", bare, "3.2"),
    ];
    for (profile, rest, side) in cases {
        let scene = format!("{profile}{rest}");
        fs::write(place.join("scene.toml"), &scene).unwrap();
        for grid in [&["--grid", "16", "--box", side][..], &["--grid", "17", "--box", side]] {
            let made = run_in(&place, &[&["reference", "scene.toml"], grid, &["-o", "field.csv"]].concat());
            assert!(made.status.success(), "{scene}: {}", String::from_utf8_lossy(&made.stderr));
            let judged = run_in(&place, &["validate", "scene.toml", "field.csv", "--json"]);
            assert_eq!(judged.status.code(), Some(0), "{scene}: {}", String::from_utf8_lossy(&judged.stderr));
            let document: Value = serde_json::from_slice(&judged.stdout).unwrap();
            assert!(document["passed"] == true && document["suspicion"].is_null(), "{scene}: {document}");
        }
    }
    // One row of that punch that is wrong is still found.
    let made = run_in(&place, &["reference", "scene.toml", "--grid", "0:1.4:15"]);
    let rows: Vec<String> = String::from_utf8(made.stdout).unwrap().lines().map(str::to_owned).collect();
    let [head, first, rest @ ..] = rows.as_slice() else { panic!("{rows:?}") };
    let off = |row: &String| {
        let [r, p, tail @ ..] = &row.split(',').collect::<Vec<_>>()[..] else { panic!("{row}") };
        [&[*r, &format!("{:?}", 2.0 * p.parse::<f64>().unwrap())], tail].concat().join(",")
    };
    for (index, passes) in [(usize::MAX, true), (2, false), (6, false)] {
        let changed = rest.iter().enumerate().map(|(i, row)| if i == index { off(row) } else { row.clone() });
        let text: Vec<String> = [head.clone(), first.clone()].into_iter().chain(changed).collect();
        fs::write(place.join("row.csv"), text.join("\n")).unwrap();
        assert_eq!(judged(&place, "row.csv", &[])["passed"] == true, passes, "{index}");
    }
    // Elsewhere an empty pressure is a fault.
    fs::write(place.join("scene.toml"), format!("[profile]\nf = \"r^2\"\n{bare}")).unwrap();
    fs::write(place.join("gap.csv"), "r,p\n0.1,0.1\n0.2,\n0.3,0.0\n").unwrap();
    let refused = run_in(&place, &["validate", "scene.toml", "gap.csv"]);
    assert!(refused.status.code() == Some(2) && String::from_utf8_lossy(&refused.stderr).contains("column p is empty"));
}

/// Class "a file that `reference` wrote is refused": every format, loads by depth, force and radius, one and several of them, squares
/// and radii, a rim with its infinite pressure, means over cells, bare numbers and units, displacements and shapes without pressures,
/// ramps that begin where nothing can be compared; and a wrong field is found in each.
#[test]
fn every_format_of_references_is_validated() {
    let place = room("formats");
    let bare = "[material]\neffective_modulus = 1.0\n[load]\ndepth = 0.1\n[outputs]\nquantities = [\"p\", \"u\"]\n";
    let several = "[material]\nE = \"70 GPa\"\nnu = 0.3\n[load]\nforce = [\"10 mN\", \"20 mN\"]\n[outputs]\nquantities = [\"p\"]\n";
    let radii = "[material]\neffective_modulus = \"2 MPa\"\n[load]\ncontact_radius = [\"0.5 um\", \"0.8 um\", \"1 um\"]\n";
    let at = "[outputs]\nquantities = [\"p\", \"u\", \"f\"]\nat = { start = \"0 um\", stop = \"2 um\", count = 161 }\n";
    let cells = "[data]\nbox = 1.0\ngrid = 32\npressure = \"cell\"\n";
    let only = |fields: &str| {
        let paraboloid = "[profile]\nf = \"r^2/(2*R)\"\nparameters = { R = \"10 um\" }\n[material]\neffective_modulus = \"1 GPa\"\n";
        format!("{paraboloid}[load]\ndepth = \"0.1 um\"\n[outputs]\nquantities = [{fields}]\n")
    };
    let ramp = "[material]\neffective_modulus = 1.0\n[load]\ndepth = [0.0, 0.05, 0.1]\n[outputs]\nquantities = [\"p\", \"u\"]\n";
    let cases: [(String, &[&str], &[&str]); 12] = [
        (only("\"u\""), &["--grid", "32", "--box", "4 um"], &["--box", "4 um"]),
        (only("\"u\""), &["--grid", "32", "--box", "4 um", "--between"], &["--box", "4 um"]),
        (only("\"p\""), &["--grid", "0 um:2 um:81"], &["--grid", "0 um:2 um:81"]),
        (only("\"f\", \"g\""), &["--grid", "0:2 um:81"], &["--grid", "0:2 um:81"]),
        (format!("[profile]\nf = \"r^2\"\n{ramp}"), &["--grid", "32", "--box", "1"], &["--box", "1"]),
        (format!("[profile]\nf = \"max(0,r^2-0.01)\"\n{ramp}"), &["--grid", "32", "--box", "1"], &["--box", "1"]),
        (format!("[profile]\nf = \"r^2\"\n{bare}"), &["--grid", "32", "--box", "1"], &["--box", "1"]),
        (format!("[profile]\nf = \"r^2\"\n{bare}{cells}"), &[], &[]),
        (format!("[profile]\nf = \"r^2\"\n{bare}"), &["--grid", "32", "--box", "1", "--between"], &["--box", "1"]),
        (format!("[profile]\nf = \"0\"\nradius = 0.25\n{bare}"), &["--grid", "32", "--box", "1"], &["--box", "1"]),
        (
            format!("[profile]\nf = \"r^2/(2*R)\"\nparameters = {{ R = \"20 um\" }}\n{several}"),
            &["--grid", "32", "--box", "6 um"],
            &["--box", "6 um"],
        ),
        (format!("[profile]\nf = \"r^2/(2*R)\"\nparameters = {{ R = \"20 um\" }}\n{radii}{at}"), &[], &[]),
    ];
    for (number, (scene, grid, options)) in cases.into_iter().enumerate().filter(|own| takes(own.0, 2)) {
        fs::write(place.join("scene.toml"), &scene).unwrap();
        for file in sample(["field.csv", "field.json", "field.npy"], number, 3) {
            let made = run_in(&place, &[&["reference", "scene.toml", "-o", file], grid].concat());
            assert!(made.status.success(), "{scene}: {}", String::from_utf8_lossy(&made.stderr));
            let document = judged(&place, file, options);
            assert!(document["passed"] == true && document["suspicion"].is_null(), "{file}, {scene}: {document}");
            // Every number half as large again.
            let text = fs::read(place.join(file)).unwrap();
            fs::write(place.join(file), enlarged(file, &text)).unwrap();
            assert_eq!(judged(&place, file, options)["passed"], false, "{file}, {scene}");
        }
    }
}

/// Class "means are read as values at their places": squares about the axis and beside it, rings, a kink, an infinite pressure at a rim and
/// at an apex; CSV and JSON say so themselves, NPY has `--cells`. Means over squares add up to the force.
#[test]
fn means_are_compared_with_means() {
    let place = room("means");
    let rest = "[material]\neffective_modulus = 1.0\n[load]\ndepth = 0.1\n[outputs]\nquantities = [\"p\"]\n";
    let squares: &[&str] = &["--grid", "64", "--box", "1"];
    let between: &[&str] = &["--grid", "64", "--box", "1", "--between"];
    let rings: &[&str] = &["--grid", "0:0.5:81"];
    let all = [
        ("f = \"r^2\"", squares, &["--box", "1", "--cells"] as &[&str]),
        ("f = \"r/4\"", between, &["--box", "1", "--cells"]),
        ("f = \"max(0,r^2-0.01)\"", squares, &["--box", "1", "--cells"]),
        ("f = \"0\"\nradius = 0.25", squares, &["--box", "1", "--cells"]),
        ("f = \"r^2\"", rings, &["--grid", "0:0.5:81", "--cells"]),
        // A pressure without a formula, which costs a hundred times as much as the others.
        ("f = \"max(0,r-0.1)\"", rings, &["--grid", "0:0.5:81", "--cells"]),
    ];
    for (number, (profile, grid, options)) in all.into_iter().take(cases(5, 6)).enumerate() {
        fs::write(place.join("scene.toml"), format!("[profile]\n{profile}\n{rest}")).unwrap();
        let files = [("field.csv", &[] as &[&str]), ("field.json", &[]), ("field.npy", options)];
        for (file, options) in sample(files, number, 3) {
            let made = run_in(&place, &[&["reference", "scene.toml", "--cells", "-o", file], grid].concat());
            assert!(made.status.success(), "{profile}: {}", String::from_utf8_lossy(&made.stderr));
            let document = judged(&place, file, options);
            assert_eq!(document["passed"], true, "{file}, {profile}: {document}");
            // The rule with two places per cell is good to the third order; a value at the place to the first.
            let column = |name: &str| document["columns"][name]["l2"].as_f64();
            assert!(column("p").unwrap() < 5e-6, "{file}, {profile}: {document}");
            assert!(grid == rings || column("F_from_p").unwrap() < 1e-15, "{file}, {profile}: {document}");
        }
    }
}

/// Class "means are read as values at their places": `[data]` says it of rings in an array.
#[test]
fn declared_means_of_rings_are_rings() {
    let place = room("declared-rings");
    let scene = "[profile]\nf = \"r^2\"\n[material]\neffective_modulus = 1.0\n[load]\ndepth = 0.1\n[data]\npressure = \"cell\"\n";
    fs::write(place.join("scene.toml"), scene).unwrap();
    assert!(run_in(&place, &["reference", "scene.toml", "--grid", "0:0.5:81", "-o", "field.npy"]).status.success());
    let document = judged(&place, "field.npy", &["--grid", "0:0.5:81"]);
    assert!(document["passed"] == true && document["columns"]["p"]["l2"].as_f64().unwrap() < 5e-6, "{document}");
    assert!(document["files"][0]["notes"].to_string().contains("means over rings"), "{document}");
}

/// Class "a file that `reference` wrote is refused": shapes have no value beyond the end of their profile.
#[test]
fn shapes_that_end_are_validated() {
    let place = room("ends");
    let scene = "[profile]\nshape = \"sphere\"\nparameters = { R = \"1 um\" }\n[material]\neffective_modulus = \"1 GPa\"\n\
                 [load]\ndepth = \"0.1 um\"\n[outputs]\nquantities = [\"f\", \"g\"]\n";
    fs::write(place.join("scene.toml"), scene).unwrap();
    for file in ["field.csv", "field.json"] {
        assert!(run_in(&place, &["reference", "scene.toml", "--grid", "0:2 um:21", "-o", file]).status.success());
        let document = judged(&place, file, &[]);
        assert!(document["passed"] == true && document["columns"]["f"]["rows"].as_u64().unwrap() >= 10, "{file}: {document}");
    }
}

/// Class "an option is ignored without a word": radii beside data that have places of their own.
#[test]
fn radii_that_are_not_used_are_named() {
    let place = room("unused-radii");
    let scene = "[profile]\nf = \"r^2\"\n[material]\neffective_modulus = 1.0\n[load]\ndepth = 0.1\n[outputs]\nquantities = [\"p\"]\n";
    fs::write(place.join("scene.toml"), scene).unwrap();
    for (grid, file, used) in
        [("0:1:41", "line.npy", true), ("0:1:41", "line.csv", false), ("0:1:41", "line.json", false), ("64", "square.npy", false)]
    {
        assert!(run_in(&place, &["reference", "scene.toml", "--grid", grid, "--box", "1", "-o", file]).status.success());
        let document = judged(&place, file, &["--grid", "0:1:41", "--box", "1"]);
        assert_eq!(document["passed"], true, "{file}: {document}");
        assert_eq!(document["notes"].to_string().contains("the given radii are not used"), !used, "{file}: {document}");
    }
}

/// Class "what is not judged hides what is wrong": a field that is not 0 although the bodies do not touch fails, and the load that fails is
/// named before those that cannot be judged.
#[test]
fn loads_without_contact_hide_nothing() {
    let place = room("apart");
    let scene = "[profile]\nf = \"r^2\"\n[material]\neffective_modulus = 1.0\n[load]\ndepth = [-0.1, 0.0, 0.05, 0.1]\n\
                 [outputs]\nquantities = [\"p\", \"u\"]\n";
    fs::write(place.join("scene.toml"), scene).unwrap();
    assert!(run_in(&place, &["reference", "scene.toml", "--grid", "0:0.6:61", "-o", "good.csv"]).status.success());
    let good = judged(&place, "good.csv", &[]);
    let said = good["reason"].as_str().unwrap();
    assert!(good["passed"] == true && said.starts_with("d = 0.05") && said.contains("d = 0: nothing was judged"), "{said}");
    let text = fs::read_to_string(place.join("good.csv")).unwrap();
    for (load, column, named) in
        [("0.0,", 2, "d = 0: p is not 0"), ("-0.1,", 5, "d = -0.1: u is not 0"), ("0.1,", 2, "d = 0.1: the L2 error of p")]
    {
        let changed = text.lines().map(|line| {
            let mut fields: Vec<String> = line.split(',').map(str::to_owned).collect();
            if line.starts_with(load) {
                fields[column] = format!("{:?}", 1.5 * fields[column].parse::<f64>().unwrap() + 0.01);
            }
            fields.join(",")
        });
        fs::write(place.join("bad.csv"), changed.collect::<Vec<_>>().join("\n")).unwrap();
        let bad = judged(&place, "bad.csv", &[]);
        assert!(bad["passed"] == false && bad["reason"].as_str().unwrap().starts_with(named), "{bad}");
    }
}

/// The file with its first field half as large again.
fn enlarged(file: &str, bytes: &[u8]) -> Vec<u8> {
    if file.ends_with(".npy") {
        let start = bytes.iter().position(|own| *own == b'\n').unwrap() + 1;
        let numbers = bytes[start..].chunks(8).flat_map(|own| (1.5 * f64::from_le_bytes(own.try_into().unwrap())).to_le_bytes());
        return bytes[..start].iter().copied().chain(numbers).collect();
    }
    let text = std::str::from_utf8(bytes).unwrap();
    if file.ends_with(".json") {
        let mut document: Value = serde_json::from_str(text).unwrap();
        for load in document["loads"].as_array_mut().unwrap() {
            enlarge(&mut load["fields"][0]["values"]);
        }
        return document.to_string().into_bytes();
    }
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let of_field = |own: &&str| ["p", "u", "f"].contains(&own.split('_').next().unwrap());
    let column = header.iter().position(of_field).unwrap();
    let mut out = header.join(",");
    for line in lines {
        let mut fields: Vec<String> = line.split(',').map(str::to_owned).collect();
        if let Ok(p) = fields[column].parse::<f64>() {
            fields[column] = format!("{:?}", 1.5 * p);
        }
        out = format!("{out}\n{}", fields.join(","));
    }
    out.into_bytes()
}

fn enlarge(values: &mut Value) {
    match values {
        Value::Array(list) => list.iter_mut().for_each(enlarge),
        Value::Number(_) => *values = Value::from(1.5 * values.as_f64().unwrap()),
        _ => {}
    }
}

/// Files that hold no fields of the scene, each refused with its reason.
#[test]
fn other_documents_and_other_scenes_are_refused() {
    let place = room("refused");
    let scene = "[profile]\nf = \"r^2\"\n[material]\neffective_modulus = 1.0\n[load]\ndepth = 0.1\n";
    fs::write(place.join("scene.toml"), scene).unwrap();
    let field = |loads: &str| {
        format!("{{\"schema\":\"sneddon/reference/1\",\"units\":null,\"grid\":{{\"r\":[0.0,0.1],\"cells\":false}},\"loads\":[{loads}]}}")
    };
    let one = "{\"d\":0.1,\"fields\":[{\"quantity\":\"p\",\"values\":[[0.1,0.2],[0.3]]}]}";
    for (name, content, said) in [
        ("other.json", "{\"schema\":\"sneddon/solve/1\",\"rows\":[]}".to_owned(), "sneddon/solve/1"),
        ("nameless.json", "{\"a\":1}".to_owned(), "missing field"),
        ("broken.json", "{\"schema\":".to_owned(), "invalid JSON data"),
        ("empty.json", field(""), "nothing to compare"),
        ("ragged.json", field(one), "differ in length"),
    ] {
        fs::write(place.join(name), content).unwrap();
        let done = run_in(&place, &["validate", "scene.toml", name]);
        let error = String::from_utf8_lossy(&done.stderr);
        assert!(done.status.code() == Some(2) && error.contains(said), "{name}: {error}");
    }
    let arrays: [(&[usize], &str); 3] =
        [(&[2, 1, 2, 5], "the array has 2 loads"), (&[1, 1, 2, 5], "the array has 5 radii"), (&[3, 4, 4], "without names")];
    for (shape, said) in arrays {
        fs::write(place.join("field.npy"), npy(shape, &vec![0.5; shape.iter().product()])).unwrap();
        let done = run_in(&place, &["validate", "scene.toml", "field.npy"]);
        let error = String::from_utf8_lossy(&done.stderr);
        assert!(done.status.code() == Some(2) && error.contains(said), "{shape:?}: {error}");
    }
}

/// Class "rows of a stacked array have no names": numbers from 1 on name the fields and the lines of an array.
#[test]
fn rows_of_a_stacked_array_are_mapped() {
    let place = room("stacked");
    fs::write(place.join("scene.toml"), "[profile]\nf = \"r^2\"\n[material]\neffective_modulus = 1.0\n[load]\ndepth = 0.5\n").unwrap();
    // a = 1/2 and p = (4/π)·√(a² − r²) of r², from Hertz's p₀ = 2E*a/(πR).
    let pressure = |r: f64| 4.0 / std::f64::consts::PI * (0.25 - r * r).max(0.0).sqrt();
    let at = |index: usize| (index as f64 - 32.0) / 32.0;
    let places: Vec<(f64, f64)> = (0..64).flat_map(|i| (0..64).map(move |j| (at(j), at(i)))).collect();
    let field = places.iter().map(|(x, y)| pressure(x.hypot(*y)));
    let stack: Vec<f64> = places.iter().map(|own| own.0).chain(places.iter().map(|own| own.1)).chain(field).collect();
    fs::write(place.join("field.npy"), npy(&[3, 64, 64], &stack)).unwrap();
    assert_eq!(judged(&place, "field.npy", &["--map", "x=1", "--map", "y=2", "--map", "p=3"])["passed"], true);
    assert_eq!(judged(&place, "field.npy", &["--map", "p=3", "--box", "2"])["passed"], true);
    assert_eq!(judged(&place, "field.npy", &["--map", "x=1", "--map", "y=2", "--map", "u=3"])["passed"], false);
    let radii: Vec<f64> = (0..200).map(|own| f64::from(own) / 200.0).collect();
    let line: Vec<f64> = radii.iter().copied().chain(radii.iter().map(|own| pressure(*own))).collect();
    fs::write(place.join("line.npy"), npy(&[2, 200], &line)).unwrap();
    assert_eq!(judged(&place, "line.npy", &["--map", "r=1", "--map", "p=2"])["passed"], true);
    // Each row a place, as before.
    let rows: Vec<f64> = radii.iter().flat_map(|own| [*own, pressure(*own)]).collect();
    fs::write(place.join("rows.npy"), npy(&[200, 2], &rows)).unwrap();
    assert_eq!(judged(&place, "rows.npy", &["--map", "r=1", "--map", "p=2"])["passed"], true);
}
