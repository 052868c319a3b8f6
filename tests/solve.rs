//! `sneddon solve` and `sneddon scene` as their users meet them: answers, exit codes, files, and what is said about bad scenes.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::panic)]

use serde_json::Value;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

const PROGRAM: &str = env!("CARGO_BIN_EXE_sneddon");

/// Runs the program in a directory, with a scene on stdin.
fn run_in(place: &Path, stdin: &str, arguments: &[&str]) -> Output {
    let mut command = Command::new(PROGRAM);
    command.current_dir(place).args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    // The program may refuse before it reads.
    let _ = child.stdin.take().unwrap().write_all(stdin.as_bytes());
    child.wait_with_output().unwrap()
}

fn room(name: &str) -> PathBuf {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("solve").join(name);
    let _ = fs::remove_dir_all(&place);
    fs::create_dir_all(&place).unwrap();
    place
}

fn json(scene: &str, code: i32, more: &[&str]) -> Value {
    let mut arguments = vec!["solve", "-", "--json"];
    arguments.extend(more);
    let done = run_in(Path::new("."), scene, &arguments);
    assert_eq!(done.status.code(), Some(code), "{}", String::from_utf8_lossy(&done.stderr));
    serde_json::from_slice(&done.stdout).unwrap()
}

const EXAMPLE: &str = r#"
[profile]
f = "r^2/(2*R)"
parameters = { R = "10 um" }
radius = "2 um"
[material]
E = "72 GPa"
nu = 0.17
[load]
depth = { start = "0.05 um", stop = "0.5 um", count = 10 }
[outputs]
quantities = ["F", "a", "k", "p_mean", "U", "p", "u", "g", "f"]
at = { start = "0 um", stop = "2 um", count = 5 }
units = { length = "um", force = "mN", pressure = "GPa" }
"#;

fn close(value: &Value, expected: f64) {
    let value = value.as_f64().unwrap();
    assert!((value - expected).abs() <= 4e-15 * expected.abs(), "{value:?} is not {expected:?}");
}

#[test]
fn json_has_its_keys() {
    let found = json(EXAMPLE, 0, &[]);
    assert_eq!(found["units"]["force"], "mN");
    let modulus = 72.0 / (1.0 - 0.17f64 * 0.17);
    close(&found["effective_modulus"], modulus);
    assert_eq!(found["validity"]["valid"], true);
    assert!(found["validity"]["assumptions"].as_str().unwrap().contains("frictionless"));
    let rows = found["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 10);
    // Hertz below g(c) = 0.4 um.
    let second = &rows[1];
    assert_eq!((second["d"].as_f64(), second["a"].as_f64(), &second["edge"]), (Some(0.1), Some(1.0), &Value::from("smooth")));
    close(&second["F"], 4.0 / 3.0 * modulus * 0.1);
    close(&second["U"], 2.0 / 5.0 * 4.0 / 3.0 * modulus * 0.01);
    // The rim above it: F = 2E*(c d − c³/(3R)).
    let last = &rows[9];
    assert_eq!((&last["edge"], last["a"].as_f64()), (&Value::from("rim"), Some(2.0)));
    close(&last["F"], 2.0 * modulus * (2.0 * 0.5 - 8.0 / 30.0));
    let curves = found["curves"].as_array().unwrap();
    assert_eq!(curves.len(), 2 + 2 * 10);
    let of_last: Vec<&Value> = curves.iter().filter(|own| own["d"] == 0.5).collect();
    let pressure = of_last.iter().find(|own| own["quantity"] == "p").unwrap();
    let at_rim = pressure["points"].as_array().unwrap().last().unwrap();
    assert!(at_rim["value"].is_null() && at_rim["why"].as_str().unwrap().contains("rim"));
}

/// Invalid rows are null and the exit code is 1; `--force` shows their numbers.
#[test]
fn invalid_rows_are_null() {
    let scene = "[profile]\nf = '1-exp(-r^2)'\n[material]\neffective_modulus = 1\n[load]\ndepth = [0.5, 1.1]\n";
    let found = json(scene, 1, &[]);
    let rows = &found["rows"];
    assert_eq!((&rows[0]["valid"], &rows[1]["valid"]), (&Value::from(true), &Value::from(false)));
    assert!(rows[1]["F"].is_null() && rows[1]["a"].is_null() && rows[0]["F"].is_number());
    assert_eq!(rows[1]["d"], 1.1);
    let finding = &rows[1]["findings"][0];
    assert_eq!((&finding["rule"], &finding["severity"]), (&Value::from("outside_gap"), &Value::from("error")));
    assert!(finding["at"].as_f64().unwrap() > 1.0 && rows[1]["why"].is_string());
    let shown = json(scene, 1, &["--force"]);
    assert!(shown["rows"][1]["F"].is_number() && shown["rows"][1]["valid"] == false);
}

#[test]
fn steep_slopes_and_kinks_are_warnings() {
    let scene = "[profile]\nshape = 'truncated-cone'\nparameters = { b = 1, theta = 0.5 }\n[material]\neffective_modulus = 1\n[load]\ndepth = 0.5\n";
    let found = json(scene, 0, &[]);
    let rules: Vec<&str> = found["validity"]["findings"].as_array().unwrap().iter().map(|own| own["rule"].as_str().unwrap()).collect();
    assert_eq!(rules, ["steep_slope", "kink"]);
    assert_eq!(found["validity"]["valid"], true);
}

#[test]
fn csv_names_units() {
    let place = room("csv");
    let scene = EXAMPLE.replace(", \"p\", \"u\", \"g\", \"f\"", "");
    let done = run_in(&place, &scene, &["solve", "-", "--csv", "-o", "rows.csv"]);
    assert!(done.status.success() && done.stdout.is_empty());
    let text = fs::read_to_string(place.join("rows.csv")).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("d_um,F_mN,a_um,k_mN/um,p_mean_GPa,U_mN*um,edge,valid,rule"));
    assert!(lines.next().unwrap().starts_with("0.05,") && text.lines().count() == 11);
}

/// Rows are not lost where curves are asked for; curves alone stand alone.
#[test]
fn csv_has_rows_and_points() {
    let done = run_in(Path::new("."), EXAMPLE, &["solve", "-", "--csv"]);
    let text = String::from_utf8(done.stdout).unwrap();
    let (rows, points) = text.split_once("\n\n").unwrap();
    assert_eq!(rows.lines().count(), 11);
    assert_eq!(points.lines().next(), Some("quantity,d_um,at_um,value,error,unit,bound"));
    assert_eq!(points.lines().count(), 1 + 2 * 5 + 2 * 10 * 5);
    let alone = EXAMPLE.replace("\"F\", \"a\", \"k\", \"p_mean\", \"U\", ", "");
    let done = run_in(Path::new("."), &alone, &["solve", "-", "--csv"]);
    assert_eq!(String::from_utf8(done.stdout).unwrap().trim_end(), points.trim_end());
}

/// 0.15 is 0.15, in whatever unit it is computed.
#[test]
fn ranges_are_rounded_once() {
    let load = |load: &str, units: &str| {
        let scene = format!(
            "[profile]\nf = 'r^2/(2*R)'\nparameters = {{ R = '10 um' }}\n[material]\neffective_modulus = '3 GPa'\n[load]\n{load}\n[outputs]\nquantities = ['F', 'd', 'p']\nat = {{ start = '0 nm', stop = '0.7 nm', count = 8 }}\nunits = {{ {units} }}\n"
        );
        json(&scene, 0, &[])
    };
    let listed =
        |found: &Value, key: &str| -> Vec<f64> { found["rows"].as_array().unwrap().iter().map(|row| row[key].as_f64().unwrap()).collect() };
    let depths = load("depth = { start = '0.05 um', stop = '0.4 um', count = 8 }", "length = 'um'");
    assert_eq!(listed(&depths, "d"), [0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4]);
    let radii: Vec<f64> = depths["curves"][0]["points"].as_array().unwrap().iter().map(|own| own["at"].as_f64().unwrap()).collect();
    assert_eq!(radii, [0.0, 0.0001, 0.0002, 0.0003, 0.0004, 0.0005, 0.0006, 0.0007]);
    assert_eq!(depths["curves"][2]["d"], 0.15);
    // Forces are computed in other units than they are shown in.
    let forces = load("force = { start = '0.1 mN', stop = '0.7 mN', count = 7 }", "length = 'um', force = 'mN', pressure = 'MPa'");
    assert_eq!(listed(&forces, "F"), [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]);
    let decades = load("depth = { start = '1e-5 um', stop = '1 um', count = 6, spacing = 'log' }", "length = 'um'");
    assert_eq!(listed(&decades, "d"), [1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0]);
}

/// Hertz: σ_zz = −p₀/(1 + z²/a²); and the cone's apex has no stress.
#[test]
fn stress_below_the_surface() {
    let scene = |profile: &str| {
        format!(
            "[profile]\n{profile}\n[material]\neffective_modulus = 1\n[load]\ncontact_radius = 1\n[outputs]\nquantities = ['sigma_zz']\ndepths = [0, 0.5, 3]\n"
        )
    };
    let hertz = json(&scene("f = 'r^2/2'"), 0, &[]);
    assert_eq!(hertz["curves"][0]["quantity"], "sigma_zz");
    for point in hertz["curves"][0]["points"].as_array().unwrap() {
        let z = point["at"].as_f64().unwrap();
        close(&point["value"], -2.0 / std::f64::consts::PI / (1.0 + z * z));
        assert!(point["error_estimate"].as_f64().unwrap() < 1e-12);
    }
    let cone = json(&scene("f = 'r/5'"), 0, &[]);
    let first = &cone["curves"][0]["points"][0];
    assert!(first["value"].is_null() && first["why"].as_str().unwrap().contains("apex"));
    assert!(cone["curves"][0]["points"][1]["value"].as_f64().unwrap() < 0.0);
}

/// A sphere taken for a paraboloid: F = (4/3)E*√R d^(3/2) against the sphere's own force at the same depth.
#[test]
fn rows_tell_their_regime() {
    let scene = |shape: &str, load: &str| {
        format!("[profile]\n{shape}\n[material]\neffective_modulus = 1\n[load]\n{load}\n[outputs]\nquantities = ['F', 'd']\n")
    };
    let regime = |found: &Value| (found["rows"][0]["regime"]["shape"].clone(), found["rows"][0]["regime"]["force_error"].as_f64().unwrap());
    for sphere in ["shape = 'sphere'\nparameters = { R = 2 }", "f = '2-sqrt(4-r^2)'"] {
        let found = json(&scene(sphere, "contact_radius = 0.5"), 0, &[]);
        let (a, r) = (0.5f64, 2.0f64);
        let (d, force) = (a * (a / r).atanh(), (a * a + r * r) * (a / r).atanh() - a * r);
        let expected = 4.0 / 3.0 * r.sqrt() * d.powf(1.5) / force - 1.0;
        let (shape, error) = regime(&found);
        assert_eq!(shape, "paraboloid");
        assert!((error - expected).abs() < 1e-8 && expected > 0.001, "{error} {expected}");
        let said = found["validity"]["regime"]["message"].as_str().unwrap();
        assert!(said.contains("a paraboloid of R = 2") && said.contains("too large"), "{said}");
    }
    // A worn cone is a punch at first and a cone in the end.
    let worn = "shape = 'truncated-cone'\nparameters = { b = 1, theta = 0.1 }";
    assert_eq!(regime(&json(&scene(worn, "depth = 1e-6"), 0, &[])).0, "flat");
    let (shape, error) = regime(&json(&scene(worn, "depth = 10"), 0, &[]));
    assert!(shape == "cone" && error.abs() < 0.02, "{error}");
    // What is simple itself has none.
    for own in ["shape = 'paraboloid'\nparameters = { R = 2 }", "f = 'r^2/4'", "f = 'r/5'", "f = 'r^3'"] {
        assert!(json(&scene(own, "depth = 0.1"), 0, &[])["rows"][0].get("regime").is_none(), "{own}");
    }
}

/// What is found out late names lengths in the units of the answers.
#[test]
fn late_findings_have_units() {
    let scene = |radius: &str, load: &str| {
        format!(
            "[profile]\nshape = 'sphere'\nparameters = {{ R = '10 um' }}\n{radius}\n[material]\neffective_modulus = '3 GPa'\n[load]\n{load}\n[outputs]\nquantities = ['F']\nunits = {{ length = 'nm' }}\n"
        )
    };
    let why = json(&scene("", "contact_radius = '12 um'"), 1, &[])["rows"][0]["why"].clone();
    assert_eq!(why, "the profile ends at r = 10000.0 nm");
    let done = run_in(Path::new("."), &scene("radius = '0.012 mm'", "depth = '1 nm'"), &["solve", "-"]);
    let said = String::from_utf8(done.stderr).unwrap();
    assert!(done.status.code() == Some(2) && said.contains("12000.0 nm") && said.contains("10000.0 nm"), "{said}");
}

/// Ctrl-C leaves neither the file nor a part of it.
#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_nothing() {
    let place = room("interrupted");
    let scene = EXAMPLE.replace("count = 10", "count = 10000000");
    fs::write(place.join("scene.toml"), scene).unwrap();
    for signal in ["INT", "TERM"] {
        let mut child = Command::new(PROGRAM).current_dir(&place).args(["solve", "scene.toml", "--csv", "-o", "rows.csv"]).spawn().unwrap();
        let unfinished = || fs::read_dir(&place).unwrap().any(|own| own.unwrap().file_name().to_str().unwrap().starts_with(".sneddon-"));
        while !unfinished() {
            assert!(child.try_wait().unwrap().is_none());
            std::thread::yield_now();
        }
        let done = Command::new("kill").args([format!("-{signal}"), child.id().to_string()]).status().unwrap();
        assert!(done.success());
        assert_eq!(child.wait().unwrap().code(), Some(130));
        assert_eq!(fs::read_dir(&place).unwrap().count(), 1);
    }
}

/// A scene names regular files only: a device or a pipe may never end.
#[test]
#[cfg(unix)]
fn a_tip_is_a_regular_file() {
    let place = room("regular");
    let rest = "[material]\neffective_modulus = 1\n[load]\ndepth = [0.1, 0.2]\n[outputs]\nquantities = [\"F\"]\n";
    for device in ["/dev/stdin", "/dev/zero"] {
        fs::write(place.join("scene.toml"), format!("[profile]\npoints = \"{device}\"\n{rest}")).unwrap();
        let done = run_in(&place, "r,z\n0,0\n1,1\n", &["solve", "scene.toml", "--json"]);
        let message = String::from_utf8_lossy(&done.stderr);
        assert!(done.status.code() == Some(2) && done.stdout.is_empty() && message.contains("regular file"), "{message}");
    }
}

/// What a link points at is written, with the rights that it has; a read-only file stays, and a pipe stays a pipe.
#[test]
#[cfg(unix)]
fn files_keep_what_they_are() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let place = room("links");
    let write = |name: &str| run_in(&place, EXAMPLE, &["solve", "-", "--csv", "-o", name]);
    fs::write(place.join("own.csv"), "before").unwrap();
    fs::set_permissions(place.join("own.csv"), fs::Permissions::from_mode(0o640)).unwrap();
    symlink("own.csv", place.join("link.csv")).unwrap();
    assert!(write("link.csv").status.success());
    assert!(fs::symlink_metadata(place.join("link.csv")).unwrap().is_symlink());
    assert!(fs::read_to_string(place.join("own.csv")).unwrap().starts_with("d_um"));
    assert_eq!(fs::metadata(place.join("own.csv")).unwrap().permissions().mode() & 0o777, 0o640);
    let through = write("/dev/stdout");
    assert!(through.status.success() && String::from_utf8_lossy(&through.stdout).starts_with("d_um"));
    fs::write(place.join("kept.csv"), "before").unwrap();
    fs::set_permissions(place.join("kept.csv"), fs::Permissions::from_mode(0o444)).unwrap();
    assert_eq!(write("kept.csv").status.code(), Some(2));
    assert_eq!(fs::read_to_string(place.join("kept.csv")).unwrap(), "before");
}

/// What is there stays when the scene is bad, and nothing is left beside it.
#[test]
fn files_appear_whole_or_not_at_all() {
    let place = room("whole");
    fs::write(place.join("out.json"), "old").unwrap();
    let done = run_in(&place, "[profile]", &["solve", "-", "--json", "-o", "out.json"]);
    assert_eq!(done.status.code(), Some(2));
    assert_eq!(fs::read_to_string(place.join("out.json")).unwrap(), "old");
    let done = run_in(&place, EXAMPLE, &["solve", "-", "--json", "-o", "out.json"]);
    assert!(done.status.success());
    assert!(fs::read_to_string(place.join("out.json")).unwrap().starts_with("{\"schema\":\"sneddon/solve/1\",\"units\""));
    assert_eq!(fs::read_dir(&place).unwrap().count(), 1);
    assert_eq!(run_in(&place, EXAMPLE, &["solve", "-", "-o", "no/such/place"]).status.code(), Some(2));
}

#[test]
fn bare_numbers_are_one_system() {
    let scene = "[profile]\nf = 'r^2/20'\n[material]\neffective_modulus = 3\n[load]\nforce = 0.4\n[outputs]\nquantities = ['d', 'F']\n";
    let found = json(scene, 0, &[]);
    assert!(found["units"].is_null());
    // F = 4/3 E* √(R d³) with R = 10: d³ = (0.4/4)²/10 = 1e-3.
    close(&found["rows"][0]["d"], 0.1);
    let named = json(&format!("{scene}units = {{ length = 'um', force = 'mN', pressure = 'GPa' }}\n"), 0, &[]);
    assert_eq!(named["rows"], found["rows"]);
    assert_eq!(named["units"]["length"], "um");
}

#[test]
fn length_unit_fixes_bare_numbers_of_f() {
    let scene = "[profile]\nf = 'r^2/20'\nlength_unit = 'um'\n[material]\neffective_modulus = '3 GPa'\n[load]\ndepth = '100 nm'\n[outputs]\nquantities = ['F', 'a']\nunits = { length = 'nm', force = 'uN' }\n";
    let found = json(scene, 0, &[]);
    close(&found["rows"][0]["a"], 1000.0);
    close(&found["rows"][0]["F"], 400.0);
}

/// k = D E* with D = 2β√(A/π); nothing is known of the pressure.
#[test]
fn punches_of_other_cross_sections() {
    let scene = |punch: &str| {
        format!(
            "[profile]\n{punch}\narea = '4 um^2'\n[material]\neffective_modulus = '3 GPa'\n[load]\ndepth = '10 nm'\n[outputs]\nquantities = ['F', 'k']\nunits = {{ length = 'um', force = 'mN', pressure = 'GPa' }}\n"
        )
    };
    let round = 2.0 * (4.0 / std::f64::consts::PI).sqrt() * 3.0;
    for (punch, beta) in [
        ("cross_section = 'circle'", 1.0),
        ("cross_section = 'square'", 1.012),
        ("cross_section = 'triangle'", 1.034),
        ("beta = 1.06", 1.06),
    ] {
        let found = json(&scene(punch), 0, &[]);
        close(&found["rows"][0]["k"], beta * round);
        close(&found["rows"][0]["F"], beta * round * 0.01);
    }
}

/// d/R, F/(E* R²): the numbers of another size and material are the same.
#[test]
fn dimensionless_answers() {
    let scene = |radius: &str, modulus: &str, depth: &str| {
        format!(
            "[profile]\nshape = 'sphere'\nparameters = {{ R = '{radius}' }}\n[material]\neffective_modulus = '{modulus}'\n[load]\ndepth = '{depth}'\n"
        )
    };
    let (one, other) =
        (json(&scene("10 um", "3 GPa", "0.1 um"), 0, &["--dimensionless"]), json(&scene("2 m", "7 kPa", "2 cm"), 0, &["--dimensionless"]));
    for key in ["d", "F", "a", "k"] {
        close(&one["rows"][0][key], other["rows"][0][key].as_f64().unwrap());
    }
    close(&one["rows"][0]["d"], 0.01);
    assert_eq!(one["units"]["length"], "R");
}

/// One file per malformed scene, beside the message that is expected.
#[test]
fn bad_scenes_are_refused_with_their_messages() {
    let place = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/bad");
    let mut names: Vec<PathBuf> = fs::read_dir(&place).unwrap().map(|entry| entry.unwrap().path()).collect();
    names.retain(|path| path.extension().is_some_and(|own| own == "toml"));
    names.sort();
    assert!(names.len() >= 40, "{}", names.len());
    for path in names {
        let name = path.file_name().unwrap().to_str().unwrap();
        let done = run_in(&place, "", &["solve", name]);
        let said = String::from_utf8(done.stderr).unwrap();
        assert_eq!(done.status.code(), Some(2), "{name}: {said}");
        assert!(done.stdout.is_empty(), "{name}");
        assert_eq!(said, fs::read_to_string(path.with_extension("txt")).unwrap(), "{name}");
        assert!(said.contains(", column "), "{name} has no place");
    }
}

#[test]
fn missing_files_and_binary_ones() {
    let place = room("missing");
    let done = run_in(&place, "", &["solve", "none.toml"]);
    assert_eq!(done.status.code(), Some(2));
    fs::write(place.join("binary.toml"), [0xffu8, 0x00]).unwrap();
    let done = run_in(&place, "", &["solve", "binary.toml"]);
    assert!(String::from_utf8_lossy(&done.stderr).contains("UTF-8") && done.status.code() == Some(2));
}

/// The complete example of the document is a scene, and answers as the document says.
#[test]
fn the_document_has_a_scene() {
    let text = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/scene.md")).unwrap();
    let scenes: Vec<&str> = text.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert!(scenes.len() >= 2);
    for scene in scenes {
        let found = json(scene, 0, &[]);
        assert_eq!(found["validity"]["valid"], true);
    }
}
