//! `-o FILE`: the ending of the name decides the format, in every command alike.
#![cfg(all(feature = "cli", unix))]
#![allow(clippy::unwrap_used, clippy::panic)]

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

fn room(name: &str) -> PathBuf {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("endings").join(name);
    let _ = fs::remove_dir_all(&place);
    fs::create_dir_all(&place).unwrap();
    fs::write(place.join("scene.toml"), SCENE).unwrap();
    fs::write(place.join("rows.csv"), "d_um,F_mN\n0.1,13.333333333333334\n").unwrap();
    place
}

fn run(place: &PathBuf, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sneddon")).current_dir(place).args(arguments).output().unwrap()
}

/// E* = 100 GPa, R = 10 um, d = 0.1 um: a = 1 um, F = (4/3) E* a^3/R = 13.333… mN.
const SCENE: &str = "
[profile]
shape = 'paraboloid'
parameters = { R = '10 um' }
[material]
effective_modulus = '100 GPa'
[load]
depth = '0.1 um'
[outputs]
quantities = ['F', 'a', 'p']
at = ['0 um', '0.5 um']
units = { length = 'um', force = 'mN', pressure = 'GPa' }
";

/// An ending, and how the file begins.
type Ending = (&'static str, &'static str);

/// Every command that writes, its endings, and how a file of each begins.
const COMMANDS: &[(&[&str], &[Ending])] = &[
    (
        &["derive", "r^2/(2*R)"],
        &[
            ("txt", "f(r) = "),
            ("tex", "%"),
            ("md", "```math"),
            ("typ", "$ f"),
            ("html", "<article>"),
            ("json", "{\"schema\":\"sneddon/derive/1\""),
        ],
    ),
    (&["plot", "r^2"], &[("svg", "<svg role=\"img\""), ("txt", "Normal force")]),
    (
        &["eval", "r^2", "--quantity", "g", "--at", "1,2"],
        &[("txt", "g of f(r) = "), ("csv", "x,g,error,method,bound\n1.0,2.0,"), ("json", "{\"schema\":\"sneddon/eval/1\"")],
    ),
    (&["compare", "r^2"], &[("txt", "closed forms"), ("json", "{\"schema\":\"sneddon/compare/1\"")]),
    (&["invert", "x^2"], &[("txt", "g(x) = "), ("tex", "%"), ("json", "{\"schema\":\"sneddon/invert/1\"")]),
    (
        &["rules"],
        &[
            ("txt", "heß-power"),
            ("tex", "\n\\noindent Each rule"),
            ("md", "Each rule"),
            ("typ", "Each rule"),
            ("html", "<article>"),
            ("json", "{\"schema\":\"sneddon/rules/1\""),
        ],
    ),
    (&["kappa", "--at", "1,2"], &[("txt", "kappa_n = "), ("csv", "n,kappa_n,"), ("json", "{\"schema\":\"sneddon/kappa/1\"")]),
    (
        &["solve", "scene.toml"],
        &[
            ("txt", "E* = "),
            ("csv", "d_um,F_mN,a_um,"),
            ("json", "{\"schema\":\"sneddon/solve/1\""),
            ("npz", "PK\u{3}\u{4}"),
            ("tex", "\\begin{equation}"),
            ("md", "```math"),
            ("typ", "$ f"),
            ("html", "<!DOCTYPE html>"),
        ],
    ),
    (
        &["reference", "scene.toml", "--grid", "0:2 um:3"],
        &[("csv", "r_um,p_GPa"), ("json", "{\"schema\":\"sneddon/reference/1\""), ("npy", "\u{93}NUMPY")],
    ),
    (&["validate", "scene.toml", "rows.csv"], &[("txt", ""), ("json", "{\"schema\":\"sneddon/validate/1\""), ("html", "<!DOCTYPE html>")]),
];

#[test]
fn the_ending_decides_everywhere() {
    let place = room("decides");
    for (command, endings) in COMMANDS {
        for (ending, start) in *endings {
            for name in [format!("out.{ending}"), format!("OUT.{}", ending.to_uppercase())] {
                let done = run(&place, &[command, &["-o", name.as_str()][..]].concat());
                let shown = format!("{command:?} -o {name}");
                assert!(done.status.success(), "{shown}: {}", String::from_utf8_lossy(&done.stderr));
                let bytes = fs::read(place.join(&name)).unwrap();
                let text: String = bytes.iter().map(|byte| char::from(*byte)).collect();
                let wanted: String = start.bytes().map(char::from).collect();
                let wanted = if start.is_ascii() || *start == "heß-power" { wanted } else { (*start).to_owned() };
                assert!(!text.is_empty() && text.starts_with(&wanted), "{shown}: {text:.60}");
                // The page of a validation stands beside the answer, everything else is the answer.
                assert_eq!(done.stdout.is_empty(), (command[0], *ending) != ("validate", "html"), "{shown}");
            }
        }
        for name in ["out.xyz", "out", "out.", ".json", "out.json.bak"] {
            let done = run(&place, &[command, &["-o", name][..]].concat());
            let message = String::from_utf8_lossy(&done.stderr).into_owned();
            assert_eq!(done.status.code(), Some(2), "{command:?} -o {name}: {message}");
            assert!(done.stdout.is_empty() && message.contains(&format!(".{}", endings[0].0)), "{command:?} -o {name}: {message}");
            assert!(!place.join(name).exists(), "{command:?} -o {name}");
        }
    }
}

/// `--format` on stdout writes what `-o` writes to a file with the ending of that format.
#[test]
fn every_format_has_a_name_and_an_ending() {
    let place = room("formats");
    for (command, endings) in COMMANDS {
        for (ending, _) in *endings {
            let format = match *ending {
                "txt" => "text",
                "tex" => "latex",
                "md" => "markdown",
                "typ" => "typst",
                "html" if ["derive", "invert", "rules"].contains(&command[0]) => "mathml",
                own => own,
            };
            let name = format!("out.{ending}");
            let file = run(&place, &[command, &["-o", name.as_str()][..]].concat());
            let stdout = run(&place, &[command, &["--format", format][..]].concat());
            assert!(file.status.success() && stdout.status.success(), "{command:?} --format {format}: {stdout:?}");
            let (written, printed) = (fs::read(place.join(&name)).unwrap(), stdout.stdout);
            assert!(!printed.is_empty() && written == printed, "{command:?} --format {format}");
            let both = run(&place, &[command, &["--format", format, "-o", name.as_str()][..]].concat());
            assert!(both.status.success(), "{command:?} --format {format} -o {name}");
        }
        let done = run(&place, &[command, &["--format", "pdf"][..]].concat());
        assert_eq!(done.status.code(), Some(2), "{command:?}");
    }
}

#[test]
fn a_dash_is_stdout() {
    let place = room("dash");
    for (command, _) in COMMANDS {
        let plain = run(&place, command);
        let dash = run(&place, &[command, &["-o", "-"][..]].concat());
        assert!(dash.status.success(), "{command:?}: {}", String::from_utf8_lossy(&dash.stderr));
        assert_eq!(plain.stdout, dash.stdout, "{command:?}");
        assert!(!place.join("-").exists());
    }
}

#[test]
fn options_that_contradict_the_ending_are_refused() {
    let place = room("contradict");
    for arguments in [
        &["solve", "scene.toml", "--json", "-o", "x.csv"][..],
        &["solve", "scene.toml", "--csv", "-o", "x.npz"],
        &["derive", "r^2", "--format", "latex", "-o", "x.txt"],
        &["eval", "r^2", "--quantity", "g", "--at", "1", "--csv", "-o", "x.json"],
        &["reference", "scene.toml", "--grid", "0:2 um:3", "--json", "-o", "x.npy"],
        &["solve", "scene.toml", "--format", "latex", "-o", "x.md"],
        &["kappa", "--at", "1", "--format", "csv", "-o", "x.txt"],
    ] {
        let done = run(&place, arguments);
        assert_eq!(done.status.code(), Some(2), "{arguments:?}");
        assert!(String::from_utf8_lossy(&done.stderr).contains("the extension contradicts the requested format"), "{arguments:?}");
    }
    assert!(run(&place, &["solve", "scene.toml", "--json", "-o", "x.json"]).status.success());
    assert!(run(&place, &["validate", "scene.toml", "rows.csv", "--json", "-o", "x.html"]).status.success());
    let done = run(&place, &["solve", "scene.toml", "-o", "x.pdf"]);
    assert!(done.status.code() == Some(2) && String::from_utf8_lossy(&done.stderr).contains(".html"));
}

/// The archive as an independent reader finds it: Python's own ZIP module, and the arrays by the description of the format.
#[test]
fn arrays_are_those_of_numpy() {
    let place = room("arrays");
    assert!(run(&place, &["solve", "scene.toml", "-o", "x.npz"]).status.success());
    let script = r#"
import ast, struct, zipfile
def read(data):
    assert data[:8] == b"\x93NUMPY\x01\x00"
    length, = struct.unpack("<H", data[8:10])
    head = ast.literal_eval(data[10:10 + length].decode("latin1"))
    body = data[10 + length:]
    if head["descr"] == "<f8": values = list(struct.unpack("<%dd" % (len(body) // 8), body))
    elif head["descr"] == "|b1": values = [bool(b) for b in body]
    else: values = body.decode("utf-32-le").rstrip("\0")
    return head["shape"], values
with zipfile.ZipFile("x.npz") as file:
    assert file.testzip() is None
    for name in file.namelist(): print(name, *read(file.read(name)))
"#;
    let done = Command::new("python3").current_dir(&place).args(["-c", script]).output();
    let Ok(done) = done else { return };
    let text = String::from_utf8(done.stdout).unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    for line in [
        "F.npy (1,) [13.333333333333334]",
        "F_unit.npy () mN",
        "F_proven.npy (1,) [True]",
        "p_proven.npy (1, 2) [True, True]",
        "a.npy (1,) [1.0]",
        "valid.npy (1,) [True]",
        "p_at.npy (2,) [0.0, 0.5]",
        "p_unit.npy () GPa",
    ] {
        assert!(text.lines().any(|own| own == line), "{line} is missing in\n{text}");
    }
    let error = text.lines().find_map(|line| line.strip_prefix("F_error.npy (1,) [")?.strip_suffix("]")).unwrap();
    assert!(error.parse::<f64>().unwrap() < 1e-13, "{error}");
    let pressure = text.lines().find_map(|line| line.strip_prefix("p.npy (1, 2) [")).unwrap();
    let numbers: Vec<f64> = pressure.trim_end_matches(']').split(", ").map(|own| own.parse().unwrap()).collect();
    // p = (2 E*/(pi R)) sqrt(a^2 - r^2)
    for (number, root) in numbers.iter().zip([1.0, 0.75f64.sqrt()]) {
        assert!((number / (20.0 / std::f64::consts::PI * root) - 1.0).abs() < 1e-14, "{number}");
    }
}
