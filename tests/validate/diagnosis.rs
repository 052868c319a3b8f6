//! The search for the cause of a failure: what it may cost, and that the verdict survives it.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used)]

use crate::validate::{room, validated};
use serde_json::Value;
use sneddon_checks::seeds::cases;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Profiles whose pressure is open, whose g is slow, or whose depth has a largest value: units of 0.1 mm.
const SHAPES: [(&str, &str); 5] = [
    ("h*(1-exp(-r^2/w^2))", "h = 0.03, w = 2"),
    ("piecewise(r^2/(2*R), r<b, b^2/(2*R)+(r-b)*b/R)", "b = 0.3, R = 50"),
    ("h*tanh(r/w)^2", "h = 0.03, w = 2"),
    ("r^2/(2*R)+h*sin(k*r)^2", "h = 5e-4, R = 50, k = 6"),
    ("piecewise(0, r<b, (r-b)*tan(theta))", "b = 0.2, theta = \"10 deg\""),
];

fn scene((f, parameters): (&str, &str), load: &str) -> String {
    format!("[profile]\nf = \"{f}\"\nparameters = {{ {parameters} }}\n[material]\nE = 210e9\nnu = 0.3\n[load]\n{load}\n")
}

/// What the program answers as JSON.
fn answer(place: &Path, arguments: &[&str]) -> Value {
    let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).current_dir(place).args(arguments).arg("--json").output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    serde_json::from_slice(&done.stdout).unwrap()
}

/// A budget of steps of work suffices for the verdict and the name of the fault, for fields and for loads.
#[test]
fn a_fault_of_any_profile_is_named_within_a_small_budget() {
    let place = room("diagnosis");
    for shape in SHAPES.into_iter().step_by(cases(6, 1)) {
        let text = scene(shape, "contact_radius = 1.0");
        fs::write(place.join("scene.toml"), &text).unwrap();
        let exact = answer(&place, &["reference", "scene.toml", "--grid", "0:1.2:121"]);
        let numbers = |own: &Value| own.as_array().unwrap().iter().map(Value::as_f64).collect::<Vec<_>>();
        let (r, p) = (numbers(&exact["grid"]["r"]), numbers(&exact["loads"][0]["fields"][0]["values"]));
        let rows = r.iter().zip(&p).filter_map(|(r, p)| Some(format!("{:?},{:?}\n", (*r)?, 1.05 * (*p)?)));
        fs::write(place.join("field.csv"), format!("r,p\n{}", rows.collect::<String>())).unwrap();
        let (code, found) = validated(&place, &text, &["field.csv".to_owned()], &["--budget", "2"]);
        assert_eq!((code, &found["suspicion_details"]["id"]), (1, &Value::from("modulus")), "{shape:?}: {found:#}");
        let text = scene(shape, "contact_radius = { start = 0.5, stop = 1.0, count = 17 }");
        fs::write(place.join("scene.toml"), &text).unwrap();
        let rows = answer(&place, &["solve", "scene.toml"])["rows"].as_array().unwrap().clone();
        let row = |row: &Value| format!("{},{:?},{}\n", row["d"], -row["F"].as_f64().unwrap(), row["a"]);
        fs::write(place.join("loads.csv"), format!("d,F,a\n{}", rows.iter().map(row).collect::<String>())).unwrap();
        let (code, found) = validated(&place, &text, &["loads.csv".to_owned()], &["--budget", "2"]);
        assert_eq!((code, &found["suspicion_details"]["id"]), (1, &Value::from("sign")), "{shape:?}: {found:#}");
    }
}
