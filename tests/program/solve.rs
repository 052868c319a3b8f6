//! `sneddon solve` and `sneddon scene` as their users meet them: answers, exit codes, files, and what is said about bad scenes.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::panic)]

use serde_json::Value;
use sneddon_checks::seeds::cases;
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
/// Class "a number without a bound": every number of a row has one, with its ground, whatever the load and the edge are.
#[test]
fn every_number_of_a_row_has_a_bound() {
    let flat = EXAMPLE.replace("r^2/(2*R)", "0").replace("parameters = { R = \"10 um\" }\n", "");
    let open = EXAMPLE.replace("r^2/(2*R)", "R*ln(cosh(r/R))").replace("radius = \"2 um\"\n", "");
    let by_force = open.replace("depth = { start = \"0.05 um\", stop = \"0.5 um\"", "force = { start = \"0.05 mN\", stop = \"0.5 mN\"");
    let by_radius = open.replace("depth = { start", "contact_radius = { start");
    for (scene, load) in [(EXAMPLE, "d"), (&flat, "d"), (&open, "d"), (&by_force, "F"), (&by_radius, "a")] {
        let answer = json(scene, 0, &[]);
        for row in answer["rows"].as_array().unwrap() {
            for key in ["d", "F", "a", "k", "p_mean", "U"].into_iter().filter(|key| row.get(key).is_some()) {
                let (value, error) = (row[key].as_f64().unwrap(), row["error_estimates"][key].as_f64().unwrap());
                assert_eq!(row["bounds"][key], "proven", "{scene}: {key} of {row}");
                // Quadrature is asked for 1e-12.
                assert!(error <= 1e-12 * value.abs() && (error > 0.0 || key == load || key == "a"), "{key} of {row}");
            }
        }
    }
}

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
    let bounds = "d_error_um,d_bound,F_error_mN,F_bound,a_error_um,a_bound,k_error_mN/um,k_bound,p_mean_error_GPa,p_mean_bound,U_error_mN*um,U_bound";
    assert_eq!(lines.next(), Some(format!("d_um,F_mN,a_um,k_mN/um,p_mean_GPa,U_mN*um,edge,valid,rule,{bounds}").as_str()));
    let first = lines.next().unwrap();
    assert!(first.starts_with("0.05,") && first.matches("proven").count() == 6 && text.lines().count() == 11, "{first}");
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
    for (signal, code) in [("INT", 130), ("TERM", 143), ("HUP", 129)] {
        let mut child = Command::new(PROGRAM).current_dir(&place).args(["solve", "scene.toml", "--csv", "-o", "rows.csv"]).spawn().unwrap();
        let unfinished = || fs::read_dir(&place).unwrap().any(|own| own.unwrap().file_name().to_str().unwrap().starts_with(".sneddon-"));
        while !unfinished() {
            assert!(child.try_wait().unwrap().is_none());
            std::thread::yield_now();
        }
        let done = Command::new("kill").args([format!("-{signal}"), child.id().to_string()]).status().unwrap();
        assert!(done.success());
        assert_eq!(child.wait().unwrap().code(), Some(code), "{signal}");
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

/// Class "a number without the factor of its unit": every quantity in two systems of units, and A = π a² without dimensions.
#[test]
fn every_quantity_is_in_the_units_of_the_answers() {
    let answer = |units: &str| {
        let quantities = "['F', 'a', 'k', 'A', 'p_mean', 'U', 'q', 'u_1d', 'p', 'u', 'g', 'f', 'G', 'sigma_zz']";
        let head = "[profile]\nf = 'r^2/20'\nlength_unit = 'um'\n[material]\neffective_modulus = '70 GPa'\n[load]\ndepth = '10 nm'\n";
        json(&format!("{head}[outputs]\nquantities = {quantities}\nat = ['50 nm']\ndepths = ['0.1 um']\nunits = {units}\n"), 0, &[])
    };
    let one = answer("{ length = 'um', force = 'mN', pressure = 'GPa' }");
    let other = answer("{ length = 'nm', force = 'N', pressure = 'Pa' }");
    // (key, its number in nm, N and Pa over that in um, mN and GPa).
    let rows = [("d", 1e3), ("F", 1e-3), ("a", 1e3), ("k", 1e-6), ("A", 1e6), ("p_mean", 1e9), ("U", 1.0)];
    for (key, factor) in rows {
        close(&other["rows"][0][key], factor * one["rows"][0][key].as_f64().unwrap());
    }
    let curves = [("g", 1e3), ("f", 1e3), ("G", 1e6), ("q", 1e-6), ("u_1d", 1e3), ("p", 1e9), ("u", 1e3), ("sigma_zz", 1e9)];
    let point = |of: &Value, key: &str| {
        let own = of["curves"].as_array().unwrap().iter().find(|own| own["quantity"] == key).unwrap();
        own["points"][0]["value"].clone()
    };
    for (key, factor) in curves {
        close(&point(&other, key), factor * point(&one, key).as_f64().unwrap());
    }
    let sphere =
        "[profile]\nshape = 'sphere'\nparameters = { R = '10 um' }\n[material]\neffective_modulus = '3 GPa'\n[load]\ndepth = '1 um'\n";
    let bare = json(&format!("{sphere}[outputs]\nquantities = ['a', 'A']\n"), 0, &["--dimensionless"]);
    close(&bare["rows"][0]["A"], std::f64::consts::PI * bare["rows"][0]["a"].as_f64().unwrap().powi(2));
    let table = run_in(Path::new("."), &format!("{sphere}[outputs]\nquantities = ['A']\n"), &["solve", "-", "--csv"]);
    let table = String::from_utf8(table.stdout).unwrap();
    assert!(table.starts_with("d_m,A_m^2,"), "{table}");
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
        // Of a file that has comments only, no line is to blame, and none is quoted.
        assert!(said.contains(", column ") || name == "tip_comments_only.toml", "{name} has no place");
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

/// A scene with two bodies of steel, each with a shape.
fn two_bodies(indenter: &str, counterbody: &str, load: &str) -> String {
    format!(
        "[profile]\nf = \"{indenter}\"\nparameters = {{ R = \"10 mm\" }}\n[material]\nE = \"200 GPa\"\nnu = 0.3\n\
         [counterbody]\nE = \"200 GPa\"\nnu = 0.3\nf = \"{counterbody}\"\nparameters = {{ R = \"10.01 mm\" }}\n\
         [load]\n{load}\n[outputs]\nquantities = [\"d\", \"F\", \"a\"]\nunits = {{ length = \"mm\", force = \"N\", pressure = \"MPa\" }}\n"
    )
}

fn rules(answer: &Value) -> Vec<String> {
    answer["rows"][0]["findings"].as_array().unwrap().iter().map(|own| own["rule"].as_str().unwrap().to_owned()).collect()
}

/// The slope of a ball in a socket is that of the ball, not that of the thin gap between them.
#[test]
fn the_slope_of_each_body_counts() {
    let sphere = "R-sqrt(R^2-r^2)";
    let parabola = "r^2/(2*R)";
    for (ball, load, steep_from) in [
        // r/√(R² − r²) = 0.3 at r = 0.3 R/√1.09
        (sphere, "force = \"10 kN\"", 3.0 / 1.09f64.sqrt()),
        (parabola, "force = \"300 kN\"", 3.0),
    ] {
        let answer = json(&two_bodies(ball, &format!("-({ball})"), load), 0, &[]);
        assert_eq!(rules(&answer), ["steep_slope"], "{ball}");
        let at = answer["rows"][0]["findings"][0]["at"].as_f64().unwrap();
        assert!((at / steep_from - 1.0).abs() < 1e-6, "{at}");
    }
    // Shallow contacts have no warning.
    let answer = json(&two_bodies(sphere, &format!("-({sphere})"), "force = \"1 N\""), 0, &[]);
    assert!(rules(&answer).is_empty() && answer["rows"][0]["a"].as_f64().unwrap() < 2.8);
}

/// A contact cannot be larger than either of the bodies, even where the part that ends cancels in the sum of both shapes.
#[test]
fn the_end_of_each_body_counts() {
    let hidden = "R-sqrt(R^2-r^2)";
    for (indenter, counterbody, radius, code) in [
        (hidden.to_owned(), format!("-({hidden})"), 10.005, 1),
        (format!("r^2/(20*R)+({hidden})"), format!("-({hidden})"), 9.9, 0),
        // asin(r/(2 mm)) ends at 2 mm in both bodies, and only there.
        ("r^2/(20*R)+R*asin(r^2/R^2*25)^2/1000".to_owned(), "-r^2/(20*R)".to_owned(), 1.99, 0),
        ("r^2/(20*R)+R*asin(r^2/R^2*25)^2/1000".to_owned(), "-r^2/(20*R)".to_owned(), 2.01, 1),
    ] {
        let answer = json(&two_bodies(&indenter, &counterbody, &format!("contact_radius = \"{radius} mm\"")), code, &[]);
        assert_eq!(rules(&answer).contains(&"unreachable".to_owned()), code == 1, "{indenter} {radius}");
    }
    let same = "\nparameters = { R = \"10 mm\" }\n";
    let cancelled = two_bodies(&format!("r^2/(20*R)+({hidden})"), &format!("-({hidden})"), "contact_radius = \"11 mm\"");
    let cancelled = cancelled.replace("\nparameters = { R = \"10.01 mm\" }\n", same);
    assert_eq!(rules(&json(&cancelled, 1, &[])), ["unreachable"]);
    assert!(rules(&json(&cancelled.replace("11 mm", "1 mm"), 0, &[])).is_empty());
}

fn bare(profile: &str, load: &str) -> String {
    format!("[profile]\n{profile}\n[material]\neffective_modulus = 1.0\n[load]\n{load}\n[outputs]\nquantities = [\"d\", \"F\", \"a\"]\n")
}

/// What a narrow feature does to a contact shows at no sample; an enclosure misses none.
#[test]
fn no_narrow_feature_escapes_the_verdict() {
    for (feature, radius, rule) in [
        ("4/(1+((r-3)/0.01)^2)", 0.9, "outside_gap"),
        // A groove inside the contact: the pressure would have to pull where its slope turns.
        ("0.05*exp(-((r-0.317)/0.004)^2)", 0.9, "tension_inside"),
    ]
    .into_iter()
    .take(cases(1, 2))
    {
        let answer = json(&bare(&format!("f = \"r^2/2-{feature}\""), &format!("contact_radius = {radius}")), 1, &[]);
        assert!(rules(&answer).contains(&rule.to_owned()), "{feature}: {answer}");
        assert_eq!(answer["validity"]["verdict"], "not valid");
    }
    // Where the ring stays above the deformed surface the contact is valid, and that is proven: u(3) = (2/π)((d − 9/2) asin 0.3 + …) < 0.05.
    let answer = json(&bare("f = \"r^2/2-0.0001/(1+((r-3)/0.001)^2)\"", "contact_radius = 0.9"), 0, &[]);
    assert_eq!(answer["rows"][0]["verdict"], "valid");
}

/// What has an enclosure is proven; what is only looked at says so, and at how many radii.
#[test]
fn verdicts_say_what_they_rest_on() {
    for profile in [
        "f = \"r^2/2\"",
        "f = \"cosh(r)-1\"",
        "f = \"(r+1)*ln(1+r)-r\"",
        "f = \"r*atan(r)\"",
        "f = \"1-exp(-r^2)\"",
        "f = \"atan(r^2)\"",
        "f = \"r^2*gamma(2+r)\"",
        "f = \"1-sqrt(1-r^2)\"",
        "f = \"piecewise(r^2/2, r<1, r-1/2)\"",
        "f = \"-0.05*r^2\"\nradius = 1.0",
        "f = \"0\"\nradius = 1.0",
        "shape = \"ellipsoid\"\nparameters = { b = 1.0, c = 2.0 }",
    ]
    .into_iter()
    .step_by(cases(2, 1))
    {
        let answer = json(&bare(profile, "depth = 0.25"), 0, &[]);
        assert_eq!((&answer["rows"][0]["verdict"], &answer["validity"]["verdict"]), (&"valid".into(), &"valid".into()), "{profile}");
    }
    // hyp1f1 has no enclosure.
    let sampled = bare("f = \"r^2*hyp1f1(1,2,r)\"", "depth = 0.01");
    let answer = json(&sampled, 0, &[]);
    let radii = answer["validity"]["radii"].as_u64().unwrap();
    assert!(radii > 50 && answer["rows"][0]["verdict"] == format!("valid at {radii} radii"));
    let text = run_in(Path::new("."), &sampled, &["solve", "-"]);
    assert!(String::from_utf8_lossy(&text.stdout).contains(&format!("\nvalid at {radii} radii (model: ")));
}

/// The first touch is a root of f′, a kink or the rim, and no sample: heights from the closed minima of each shape.
#[test]
fn the_first_touch_is_exact() {
    let touching = |profile: &str| {
        let scene = bare(profile, "depth = 0.6\ndepth_from = \"first_touch\"");
        let answer = run_in(Path::new("."), &scene, &["solve", "-", "--json", "--force"]);
        let answer: Value = serde_json::from_slice(&answer.stdout).unwrap();
        0.6 - answer["rows"][0]["d"].as_f64().unwrap()
    };
    for (profile, depth) in [
        // −0.1 at r = 1, between the samples
        ("f = \"0.1*(r^4-2*r^2)\"\nradius = 1.2", 0.1),
        // x³ − 2x² has its minimum −32/27 at x = 4/3; here x = r²
        ("f = \"0.01*(r^6-2*r^4)\"\nradius = 1.3", 0.01 * 32.0 / 27.0),
        // the rim, and a kink beside the axis
        ("f = \"-0.05*r^2\"\nradius = 1.3", 0.05 * 1.69),
        ("f = \"0.1*(abs(r-0.7)-0.7)\"\nradius = 1.3", 0.07),
    ] {
        let found = touching(profile);
        assert!((found - depth).abs() <= 4.0 * f64::EPSILON * 0.6, "{profile}: {found:?} for {depth:?}");
    }
    // Two rings, the outer one deeper: 0.02 (1 − cos 5r) − 0.01 r, at the second root of 0.1 sin 5r = 0.01, r = (2π + asin 0.1)/5.
    let r = (std::f64::consts::TAU + 0.1f64.asin()) / 5.0;
    let lowest = 0.02 * (1.0 - (5.0 * r).cos()) - 0.01 * r;
    let found = touching("f = \"0.02*(1-cos(5*r))-0.01*r\"\nradius = 1.7");
    assert!((found + lowest).abs() <= 4.0 * f64::EPSILON * 0.6, "{found:?} for {lowest:?}");
    let answer = json(&bare("f = \"0.1*(r^4-2*r^2)\"\nradius = 1.2", "depth = 0.6\ndepth_from = \"first_touch\""), 0, &[]);
    let row = &answer["rows"][0];
    assert_eq!(row["d"].as_f64(), Some(0.5));
    // F = 2(a d − ∫₀^a g) with g = 0.1(8/3 x⁴ − 4 x²) and a = 1.2
    let integral = 0.1 * (8.0 / 15.0 * 1.2f64.powi(5) - 4.0 / 3.0 * 1.2f64.powi(3));
    assert!((row["F"].as_f64().unwrap() - 2.0 * (0.6 - integral)).abs() < 1e-15);
}

/// A flat punch is not taken for a flat punch, and none but round indenters are axisymmetric.
#[test]
fn a_shape_is_not_compared_with_itself() {
    let flat = json(&bare("f = \"0\"\nradius = 2.0", "depth = 0.1"), 0, &[]);
    assert!(flat["rows"][0].get("regime").is_none());
    for section in ["square", "triangle"] {
        let scene = bare(&format!("cross_section = \"{section}\"\narea = 4.0"), "depth = 0.1").replace("\"F\", \"a\"", "\"F\"");
        let answer = json(&scene, 0, &[]);
        assert!(answer["rows"][0].get("regime").is_none(), "{section}");
        let assumptions = answer["validity"]["assumptions"].as_str().unwrap();
        assert!(!assumptions.contains("axisymmetric") && assumptions.contains("cross-section"), "{assumptions}");
    }
    // F of a concave punch beside the flat one of the same rim, both from the first touch: 2Ec(d + h) to 2Ec(d + 2h/3), h = 0.1.
    let concave = json(&bare("f = \"-0.1*r^2\"\nradius = 1.0", "depth = 0.5"), 0, &[]);
    let regime = &concave["validity"]["regime"];
    assert!((regime["force_error"].as_f64().unwrap() - (0.6 / (0.5 + 0.2 / 3.0) - 1.0)).abs() < 1e-14);
    assert!(regime["message"].as_str().unwrap().ends_with("at the same depth since the first touch"));
}

/// Bodies apart are called apart everywhere, and no number is missing without a reason.
#[test]
fn apart_and_too_small_are_said() {
    let apart = json(&bare("f = \"r^2/2\"", "depth = -0.1"), 0, &[]);
    assert_eq!(apart["rows"][0]["edge"], "apart");
    let tiny = bare("f = \"r^2/2\"", "depth = 1e-300");
    let answer = json(&tiny, 0, &[]);
    assert!(answer["rows"][0]["F"].is_null() && answer["rows"][0]["why"].as_str().unwrap().starts_with("F: it is too small"));
    let text = run_in(Path::new("."), &tiny, &["solve", "-"]);
    assert!(String::from_utf8_lossy(&text.stdout).contains("F: no value in some rows: it is too small"));
}

/// Class "a file that is no table is echoed": neither the message nor the marked line shows what stands in it.
#[test]
fn a_file_that_is_no_table_is_not_shown() {
    let place = room("secret");
    for (name, text) in [
        ("one", "root:x:0:0:root:/root:/bin/bash\n"),
        ("two", "-----BEGIN PRIVATE KEY-----\nMIIE\n"),
        ("three", "127.0.0.1\tlocalhost\n"),
        ("four", "machine\tapi.example\tlogin\tsomebody\tpassword\tsecret\n"),
        ("five", "token secretly other words\n1,2\n"),
        ("six", "ELF\0binary secrets\n"),
    ] {
        fs::write(place.join(name), text).unwrap();
        let scene = format!("[profile]\npoints = \"{name}\"\n[material]\neffective_modulus = 1.0\n[load]\ndepth = 0.1\n");
        let done = run_in(&place, &scene, &["solve", "-"]);
        let said = String::from_utf8_lossy(&done.stderr);
        assert_eq!(done.status.code(), Some(2), "{said}");
        assert!(said.contains("does not contain a column of radii") || said.contains("not text"), "{said}");
        assert!(said.contains(&format!("{name}: ")), "{said}");
        for part in text.split(|own: char| !own.is_alphanumeric()).filter(|own| own.len() > 3) {
            assert!(!said.contains(part), "{name}: {said}");
        }
    }
    // A file that is no scene is not shown either; one with a typo is.
    for (scene, shown) in [("# my profile\npassword = hunter2secret\n", false), ("[profile]\nf = \"r^2\"\nradius = half\n", true)] {
        let done = run_in(&place, scene, &["solve", "-"]);
        let said = String::from_utf8_lossy(&done.stderr);
        let is_shown = said.contains("hunter2") || said.contains("radius = half");
        assert!(done.status.code() == Some(2) && is_shown == shown && said.contains("line "), "{said}");
    }
    // The names of a table help its owner.
    fs::write(place.join("table"), "rad_um,hgt_nm\n0,0\n1,1\n").unwrap();
    let scene = "[profile]\npoints = \"table\"\n[material]\neffective_modulus = 1.0\n[load]\ndepth = 0.1\n";
    assert!(String::from_utf8_lossy(&run_in(&place, scene, &["solve", "-"]).stderr).contains("among rad_um, hgt_nm"));
}
