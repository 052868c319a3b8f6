//! The list of quantities in every command: each one answers, or refuses by name and with a reason.
#![cfg(all(feature = "cli", unix))]
#![allow(clippy::unwrap_used, clippy::panic)]

use sneddon::contact::{Kind, Quantity};
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sneddon")).args(arguments).output().unwrap()
}

/// Text has the symbol and its argument; CSV, which programs read, keeps the key.
#[test]
fn functions_of_a_load_are_shown_as_functions() {
    for (key, title, header) in [("F_of_d", "F(d) of f(r) = r^2/4", "d,F_of_d,"), ("a_of_F", "a(F) of f(r) = r^2/4", "F,a_of_F,")] {
        let given = ["eval", "r^2/4", "--quantity", key, "--at", "0.2"];
        let [text, csv] = [&given[..], &[&given[..], &["--csv"]].concat()].map(|given| String::from_utf8(run(given).stdout).unwrap());
        assert!(text.starts_with(&format!("{title}\n")) && csv.starts_with(header), "{text}{csv}");
    }
}

#[test]
fn every_command_answers_or_refuses_every_quantity() {
    let commands: [(&[&str], usize); 5] = [
        (&["eval", "r^2/4", "--at", "0.2", "--radius", "0.5", "--json"], Quantity::ALL.len()),
        (&["derive", "r^2/4", "--json"], Quantity::ALL.iter().filter(|own| own.has_formula()).count()),
        (&["plot", "r^2/4", "--radius", "0.5"], Quantity::ALL.iter().filter(|own| own.kind() != Kind::Inverse).count()),
        (&["code", "r^2/4", "--lang", "c"], 6),
        (&["tradeoff", "r^2/4", "--budget", "0.05"], 3),
    ];
    for (command, count) in commands {
        let help = String::from_utf8(run(&[command[0], "--help"]).stdout).unwrap();
        let mut answered = 0;
        for quantity in Quantity::ALL {
            let key = quantity.key();
            let done = run(&[command, &["--quantity", key]].concat());
            let (out, said) = (String::from_utf8(done.stdout).unwrap(), String::from_utf8(done.stderr).unwrap());
            // A measurement that the clock cut short exits with 1.
            if done.status.success() || (command[0] == "tradeoff" && out.contains("Incomplete: ")) {
                answered += 1;
                assert!(help.contains(&format!("- {key}:")), "{command:?} {key}: {help}");
                // A document has the quantity that was asked for, under its key.
                let named = [quantity.key(), quantity.relation()].map(|own| format!("\"{own}\""));
                assert!(command.last() != Some(&"--json") || named.iter().any(|own| out.contains(own)), "{command:?} {key}: {out}");
            } else {
                assert_eq!(done.status.code(), Some(2), "{command:?} {key}: {said}");
                assert!(said.starts_with(&format!("error: --quantity {key}: ")) && out.is_empty(), "{command:?} {key}: {said}");
            }
        }
        assert_eq!(answered, count, "{command:?}");
    }
}

/// The help of `eval` says which quantities need the contact radius.
#[test]
fn the_help_of_eval_names_every_field() {
    let help = String::from_utf8(run(&["eval", "--help"]).stdout).unwrap();
    let keys: Vec<&str> = Quantity::ALL.iter().filter(|own| own.needs_radius()).map(|own| own.key()).collect();
    let line = help.lines().skip_while(|own| !own.contains("--radius <A>")).nth(1).unwrap();
    let words: Vec<&str> = line.split([',', ' ']).collect();
    assert!(line.trim().starts_with("Contact radius, for ") && keys.iter().all(|key| words.contains(key)), "{line}: {keys:?}");
}

/// The keys in the first column of the table of `docs/quantities.md`.
#[test]
fn the_page_lists_every_quantity() {
    let page = fs::read_to_string(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/quantities.md")).unwrap();
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `")?.split(" |").next());
    let mut listed: Vec<&str> = rows.flat_map(|keys| keys.split(", ")).map(|key| key.trim_matches('`')).collect();
    let mut known: Vec<&str> = Quantity::ALL.iter().map(|own| own.key()).collect();
    listed.sort_unstable();
    known.sort_unstable();
    assert_eq!(listed, known);
}

#[test]
fn scenes_have_every_quantity_of_a_load_and_references_write_no_other_one() {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("quantities");
    fs::create_dir_all(&place).unwrap();
    let scene = |name: &str, quantities: &str| {
        let path = place.join(name);
        let outputs = format!("quantities = [{quantities}]\nat = [0.0, 0.2, 0.9]\ndepths = [0.1, 0.4]");
        let text = format!(
            "[profile]\nf = \"r^2/(2*R)\"\nparameters = {{ R = 2 }}\n[material]\neffective_modulus = 3\n[load]\ndepth = [0.1, 0.2]\n[outputs]\n{outputs}\n"
        );
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let known: Vec<&Quantity> = Quantity::ALL.iter().filter(|own| own.kind() != Kind::Inverse).collect();
    let list = |own: &[&Quantity]| own.iter().map(|own| format!("\"{}\"", own.key())).collect::<Vec<_>>().join(", ");
    let done = run(&["solve", &scene("all.toml", &list(&known)), "--json"]);
    let found: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    for quantity in &known {
        let key = quantity.key();
        if quantity.kind() == Kind::Number {
            let row = &found["rows"][1];
            assert!(row[key].is_f64() && row["error_estimates"][key].is_f64() && row["bounds"][key].is_string(), "{key}: {row}");
            // Over the contact radius of the row, as `eval` has it.
            let a = row["a"].as_f64().unwrap().to_string();
            let at = if *quantity == &Quantity::Radius { row["d"].as_f64().unwrap().to_string() } else { a };
            let own = run(&["eval", "r^2/4", "--quantity", key, "--at", &at, "--effective-modulus", "3", "--json"]);
            let own: serde_json::Value = serde_json::from_slice(&own.stdout).unwrap();
            let (value, known) = (row[key].as_f64().unwrap(), own["points"][0]["value"].as_f64().unwrap());
            assert!((value - known).abs() <= 5e-16 * known.abs(), "{key}: {value} {known}");
        } else {
            let curves = found["curves"].as_array().unwrap();
            let own: Vec<_> = curves.iter().filter(|own| own["quantity"] == key).collect();
            assert_eq!(own.len(), if quantity.kind() == Kind::Shape { 1 } else { 2 }, "{key}");
            assert!(own.iter().flat_map(|own| own["points"].as_array().unwrap()).all(|own| own["value"].is_f64()), "{key}: {own:?}");
        }
    }
    for (quantities, fields) in
        [("\"sigma_zz\"", None), ("\"q\", \"sigma_zz\"", None), ("\"p\", \"sigma_zz\"", Some("p")), ("\"d\"", Some("p"))]
    {
        let done = run(&["reference", &scene("one.toml", quantities), "--json"]);
        let said = String::from_utf8(done.stderr).unwrap();
        match fields {
            None => assert!(done.status.code() == Some(2) && done.stdout.is_empty() && said.contains("is not a field"), "{said}"),
            Some(own) => {
                let found: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
                for load in found["loads"].as_array().unwrap() {
                    for key in ["d", "F", "a"] {
                        let (value, error) = (load[key].as_f64().unwrap(), load["error_estimates"][key].as_f64().unwrap());
                        assert!(error <= 2e-15 * value && load["bounds"][key] == "proven", "{key}: {load}");
                    }
                }
                let fields = found["loads"][0]["fields"].as_array().unwrap();
                assert!(fields.len() == 1 && fields[0]["quantity"] == own, "{found}");
                assert_eq!(said.contains("sigma_zz is not a field"), quantities.contains("sigma_zz"), "{said}");
            }
        }
    }
}

/// The note of `derive` and the numbers of `eval` come from different code.
#[test]
fn the_note_names_the_radii_at_which_the_pressure_is_infinite() {
    let answer = |arguments: &[&str]| -> serde_json::Value { serde_json::from_slice(&run(arguments).stdout).unwrap() };
    for profile in [
        "r/4",
        "r^2/4",
        "abs(r-1/2)",
        "min(r,1/2)",
        "max(0,r-1/2)*0.3",
        "max(0,r-1/2)^2",
        "r^2/2+max(0,r-1/2)*0.3-max(0,r-1/4)*0.2",
        "r^2/2+max(0,r-1/2)*0.3-max(0,r-1/2)*3/10",
        "piecewise(r^2/2, r<1/2, r/2-1/8)",
        "piecewise(r^2/2, r<1/2, r/4)",
        "2-sqrt(4-r^2)+abs(r-1/4)",
    ] {
        let notes = answer(&["derive", profile, "--json"])["notes"].to_string();
        let note = notes.split('"').find(|own| own.contains("is infinite there")).unwrap_or_default();
        let named: Vec<&str> = note.split("r = ").skip(1).filter_map(|own| own.split([' ', ',', ';']).next()).collect();
        let points = answer(&["eval", profile, "--quantity", "p", "--at", "0,0.25,0.5", "--radius", "1", "--json"])["points"].clone();
        let places = ["0", "1/4", "1/2"].into_iter().zip(points.as_array().unwrap());
        let infinite: Vec<&str> = places.filter(|(_, own)| own["why"].to_string().contains("infini")).map(|own| own.0).collect();
        assert_eq!(named, infinite, "{profile}: {note}");
    }
}
