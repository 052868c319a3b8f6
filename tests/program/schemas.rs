//! The published JSON Schemas and the real output of every command: each document is valid, and has no key that its schema lacks.
#![cfg(all(feature = "cli", unix))]
#![allow(clippy::unwrap_used, clippy::panic)]

use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

/// What is wrong with a value under a schema, place by place; covers the keywords that the schemas use, and refuses others.
pub(super) fn faults(schema: &Value, value: &Value, root: &Value, place: &str, found: &mut Vec<String>) {
    const KNOWN: [&str; 14] = [
        "$schema",
        "$id",
        "$defs",
        "$ref",
        "title",
        "description",
        "type",
        "properties",
        "required",
        "additionalProperties",
        "items",
        "enum",
        "const",
        "anyOf",
    ];
    let Some(keywords) = schema.as_object() else { return found.push(format!("{place}: {schema} is no schema")) };
    for keyword in keywords.keys() {
        assert!(KNOWN.contains(&keyword.as_str()) || keyword == "minimum", "{place}: the keyword {keyword} is not known to this test");
    }
    if let Some(name) = schema.get("$ref").and_then(Value::as_str) {
        let target = root.pointer(name.strip_prefix('#').unwrap()).unwrap_or_else(|| panic!("{place}: {name} leads nowhere"));
        faults(target, value, root, place, found);
    }
    if let Some(types) = schema.get("type") {
        let types: Vec<&str> =
            types.as_array().map_or_else(|| vec![types.as_str().unwrap()], |list| list.iter().filter_map(Value::as_str).collect());
        let is = |name: &&str| match *name {
            "null" => value.is_null(),
            "boolean" => value.is_boolean(),
            "string" => value.is_string(),
            "number" => value.is_number(),
            "integer" => value.is_i64() || value.is_u64(),
            "array" => value.is_array(),
            "object" => value.is_object(),
            other => panic!("{place}: the type {other}"),
        };
        if !types.iter().any(is) {
            found.push(format!("{place}: {value:.80} is not {types:?}"));
        }
    }
    if let (Some(least), Some(number)) = (schema.get("minimum").and_then(Value::as_f64), value.as_f64())
        && number < least
    {
        found.push(format!("{place}: {number} is below {least}"));
    }
    if let Some(list) = schema.get("enum").and_then(Value::as_array)
        && !list.contains(value)
    {
        found.push(format!("{place}: {value} is none of {list:?}"));
    }
    if let Some(constant) = schema.get("const")
        && constant != value
    {
        found.push(format!("{place}: {value} is not {constant}"));
    }
    if let Some(choices) = schema.get("anyOf").and_then(Value::as_array) {
        let tried = choices.iter().map(|choice| {
            let mut own = Vec::new();
            faults(choice, value, root, place, &mut own);
            own
        });
        let tried: Vec<Vec<String>> = tried.collect();
        if tried.iter().all(|own| !own.is_empty()) {
            found.push(format!("{place}: no choice fits: {tried:?}"));
        }
    }
    if let (Some(items), Some(list)) = (schema.get("items"), value.as_array()) {
        list.iter().enumerate().for_each(|(index, own)| faults(items, own, root, &format!("{place}/{index}"), found));
    }
    let Some(object) = value.as_object() else { return };
    for key in schema.get("required").and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_str) {
        if !object.contains_key(key) {
            found.push(format!("{place}: the key {key} is missing"));
        }
    }
    let (properties, more) = (schema.get("properties"), schema.get("additionalProperties"));
    for (key, own) in object {
        match (properties.and_then(|list| list.get(key)), more) {
            (Some(known), _) => faults(known, own, root, &format!("{place}/{key}"), found),
            (None, Some(more)) => faults(more, own, root, &format!("{place}/{key}"), found),
            // The schema allows more keys, so that later versions may add some; the program writes none that is not described.
            (None, None) if properties.is_some() => found.push(format!("{place}: the key {key} is not described")),
            (None, None) => {}
        }
    }
}

pub(super) fn schema(command: &str) -> Value {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/schemas").join(format!("{command}.json"));
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

const SCENE: &str = "
[profile]
shape = 'cone-with-spherical-cap'
parameters = { R = '0.2 um', theta = '12 deg' }
[material]
effective_modulus = '70 GPa'
[load]
depth = ['10 nm', '80 nm']
[outputs]
quantities = ['d', 'F', 'a', 'k', 'p_mean', 'U', 'p', 'u', 'g', 'f', 'sigma_zz']
at = { start = '0 um', stop = '0.1 um', count = 2 }
depths = { start = '0 um', stop = '0.1 um', count = 2 }
units = { length = 'um', force = 'mN', pressure = 'GPa' }
";
const CONCAVE: &str = "
[profile]
shape = 'concave-paraboloid'
parameters = { h = '0.05 um', c = '5 um' }
[material]
effective_modulus = '70 GPa'
[load]
depth = ['1 nm', '0.4 um']
depth_from = 'first_touch'
[outputs]
quantities = ['F', 'p']
at = ['0 um', '5 um']
";
const MEASURED: &str = "
[profile]
points = 'tip.csv'
[material]
effective_modulus = '70 GPa'
[load]
depth = ['10 nm', '80 nm', '80 um']
[outputs]
quantities = ['F', 'a', 'p']
at = ['0 um', '0.5 um']
units = { length = 'um', force = 'mN', pressure = 'GPa' }
";
const TIP: &str = "r_um,z_um\n0,0\n0.25,0.003125\n0.5,0.0125\n1,0.05\n1.5,0.1125\n2,0.2\n3,0.45\n4,0.8\n";

/// Every command with what its documents may look like.
const CALLS: &[(&str, &[&str])] = &[
    ("derive", &["r^2/(2*R)"]),
    ("derive", &["1+ln(1+r^2/w^2)*exp(-r/b)"]),
    ("derive", &["0", "--depth", "d"]),
    ("derive", &["12.73*r^2", "--digits", "3", "--inverse-hyperbolic", "log"]),
    ("derive", &["ln(cosh(r))", "--steps"]),
    ("derive", &["max(r^2/(2*R)-h,0)", "--steps=full", "--quantity", "f,g,G,d,F,a,k,p,u,U,p_mean,sigma_zz,q,u_1d"]),
    ("eval", &["r^2/(2*R)", "--set", "R=20 nm", "--quantity", "F", "--at", "5 nm"]),
    ("eval", &["1+r", "--quantity", "p", "--at", "0,0.5", "--radius", "1"]),
    ("eval", &["r^2", "--quantity", "F", "--at", "0.5", "--depth", "2", "--effective-modulus", "3"]),
    ("compare", &["r^2/(2*R)"]),
    ("compare", &["ln(cosh(r))"]),
    ("invert", &["x^2/R"]),
    ("invert", &["x^2/R", "--steps"]),
    ("invert", &["x^2/R", "--steps=full"]),
    ("invert", &["x^2/12.73", "--digits", "3"]),
    ("invert", &["ln(1+x^4/w^4)", "--set", "w=2", "--at", "0.5,1"]),
    ("invert", &["x^2/(1-x)", "--at", "0.5,2"]),
    ("invert", &["--pressure", "p_0*sqrt(1-r^2/a^2)"]),
    ("kappa", &["--at", "0,0.5,2"]),
    ("rules", &[]),
    ("solve", &["scene.toml"]),
    ("solve", &["concave.toml"]),
    ("solve", &["concave.toml", "--force"]),
    ("solve", &["measured.toml"]),
    ("solve", &["scene.toml", "--dimensionless"]),
    ("reference", &["scene.toml", "--grid", "0:0.1um:3"]),
    ("reference", &["concave.toml", "--grid", "4", "--box", "12 um", "--cells"]),
    ("validate", &["scene.toml", "rows.csv"]),
    ("validate", &["scene.toml", "wrong.csv", "wrong.csv"]),
    ("tradeoff", &["R-sqrt(R^2-r^2)", "--set", "R=2", "--at", "0.1,0.5", "--budget", "0.2"]),
];

#[test]
fn every_document_fits_its_schema() {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("schemas");
    fs::create_dir_all(&place).unwrap();
    for (name, text) in [("scene.toml", SCENE), ("concave.toml", CONCAVE), ("measured.toml", MEASURED), ("tip.csv", TIP)] {
        fs::write(place.join(name), text).unwrap();
    }
    fs::write(place.join("rows.csv"), "d_um,F_mN\n0.01,0.0415\n0.08,1.495\n").unwrap();
    fs::write(place.join("wrong.csv"), "d_um,F_mN,a_um\n0.01,0.083,0.0447\n0.08,2.99,0.253\n").unwrap();
    let mut problems = Vec::new();
    let mut called = BTreeSet::new();
    for (command, arguments) in CALLS {
        called.insert((*command).to_owned());
        let mut program = Command::new(env!("CARGO_BIN_EXE_sneddon"));
        let done = program.current_dir(&place).arg(command).args(*arguments).arg("--json").output().unwrap();
        let shown = format!("{command} {arguments:?}");
        assert!(done.status.code() != Some(2), "{shown}: {}", String::from_utf8_lossy(&done.stderr));
        let text = String::from_utf8(done.stdout).unwrap();
        assert_eq!(text.matches('\n').count(), 1, "{shown}: one line");
        let document: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(document["schema"], json!(format!("sneddon/{command}/1")), "{shown}");
        assert!(text.starts_with("{\"schema\":"), "{shown}");
        let schema = schema(command);
        let mut found = Vec::new();
        faults(&schema, &document, &schema, "", &mut found);
        problems.extend(found.into_iter().map(|fault| format!("{shown}: {fault}")));
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    let published: BTreeSet<String> = fs::read_dir(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/schemas"))
        .unwrap()
        .map(|file| file.unwrap().path().file_stem().unwrap().to_string_lossy().into_owned())
        .collect();
    assert_eq!(called, published, "every schema has a call, and every call a schema");
}

/// A test that cannot fail would prove nothing: the documents below break their schemas.
#[test]
fn what_breaks_a_schema_is_found() {
    let schema = schema("eval");
    let good = json!({ "schema": "sneddon/eval/1", "quantity": "F", "method": "exact", "coordinate": "a", "profile": { "text": "r", "latex": "r" },
        "parameters": {}, "effective_modulus": 1.0, "radius": null, "depth": null, "shift": null,
        "points": [{ "at": 1.0, "value": null, "error_estimate": null, "method": null, "way": null, "evaluations": 0, "why": "it is infinite" }] });
    let count = |document: &Value| {
        let mut found = Vec::new();
        faults(&schema, document, &schema, "", &mut found);
        found.len()
    };
    assert_eq!(count(&good), 0);
    for (pointer, wrong) in [
        ("/schema", json!("sneddon/eval/2")),
        ("/effective_modulus", json!("1")),
        ("/points/0/evaluations", json!(-1)),
        ("/points/0", json!({ "at": 1.0 })),
        ("/shift", json!({ "text": "1" })),
        ("/parameters", json!({ "R": null })),
    ] {
        let mut bad = good.clone();
        *bad.pointer_mut(pointer).unwrap() = wrong;
        assert!(count(&bad) > 0, "{pointer}");
    }
    let mut more = good;
    more["surprise"] = json!(1);
    assert_eq!(count(&more), 1);
}
