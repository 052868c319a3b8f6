//! Pictures and pages: what is drawn is the contact that `eval` knows, every file stands alone, and nothing hostile comes out.
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)]

use sneddon::contact::{Kind, Quantity};
use sneddon::report::inner::Axis;
use sneddon_checks::seeds::cases;
use std::fs;
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sneddon")).args(arguments).output().unwrap()
}

fn picture(arguments: &[&str], ending: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(format!("picture.{ending}"));
    let done = run(&[arguments, &["-o", file.to_str().unwrap()]].concat());
    assert!(done.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    assert!(done.stdout.is_empty());
    fs::read(file).unwrap()
}

/// The points of the lines in the first colour, in the order of the panels.
fn lines(svg: &str) -> Vec<Vec<(f64, f64)>> {
    let own = svg.split("<polyline ").filter(|part| part.contains("stroke=\"#0072B2\""));
    let points = |part: &str| part.split("points=\"").nth(1)?.split('"').next().map(str::to_owned);
    let pair = |text: &str| text.split_once(',').map(|(x, y)| (x.parse::<f64>().unwrap(), y.parse::<f64>().unwrap()));
    let all: Vec<Vec<(f64, f64)>> = own.filter_map(points).map(|list| list.split_whitespace().filter_map(pair).collect()).collect();
    // The short ones are in the legend.
    all.into_iter().filter(|line: &Vec<_>| line.len() > 10).collect()
}

#[test]
fn a_radius_beyond_the_end_is_refused() {
    let done =
        Command::new(env!("CARGO_BIN_EXE_sneddon")).args(["plot", "R-sqrt(R^2-r^2)", "--set", "R=1", "--radius", "2"]).output().unwrap();
    let said = String::from_utf8(done.stderr).unwrap();
    assert!(done.status.code() == Some(2) && done.stdout.is_empty() && said.contains("which ends at r = 1"), "{said}");
}

/// The picture of `README.md` is what its command in `docs/pictures.md` draws.
#[test]
fn the_picture_of_the_readme_is_fresh() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(root.join("docs/pictures.md")).unwrap();
    let command = page.lines().find(|line| line.ends_with("-o contact.svg")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let typed = command.replace("$ sneddon", env!("CARGO_BIN_EXE_sneddon"));
    let done = Command::new("sh").args(["-c", &typed]).current_dir(folder.path()).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let drawn = fs::read_to_string(folder.path().join("contact.svg")).unwrap();
    assert!(drawn == fs::read_to_string(root.join("docs/figures/contact.svg")).unwrap(), "docs/figures/contact.svg is stale: {command}");
}

#[test]
fn curves_have_the_shape_of_the_theory() {
    // F is c d² for a cone and c d^(3/2) for a paraboloid, and the pressure of a paraboloid an ellipse.
    for (f, power) in [("r", 2.0), ("r^2", 1.5), ("r^4", 1.25)] {
        let svg = String::from_utf8(picture(&["plot", f, "--quantity", "F", "--radius", "1"], "svg")).unwrap();
        let line = &lines(&svg)[0];
        let ((left, bottom), (right, top)) = (line[0], line[line.len() - 1]);
        for (x, y) in line {
            let (x, y) = ((x - left) / (right - left), (y - bottom) / (top - bottom));
            assert!((y - x.powf(power)).abs() < 0.012, "{f}: {y} instead of {} at {x}", x.powf(power));
        }
    }
    let svg = String::from_utf8(picture(&["plot", "r^2", "--quantity", "p", "--radius", "1"], "svg")).unwrap();
    let line = &lines(&svg)[0];
    let ((left, top), (right, bottom)) = (line[0], line[line.len() - 1]);
    for (x, y) in line {
        let (x, y) = ((x - left) / (right - left), (y - bottom) / (top - bottom));
        assert!((x * x + y * y - 1.0).abs() < 0.02, "{x}, {y}");
    }
}

/// Class "an infinite pressure is drawn as a finite peak": the line leaves the picture at a kink, an apex and a rim, and the picture says where.
#[test]
fn infinite_pressures_leave_the_picture() {
    // Profile, quantity, place, and whether the line goes down.
    let all: [(&[&str], &str, &str, bool); 5] = [
        (&["max(0,r-0.5)*0.3"], "p", "radius r = 0.5", false),
        (&["0.3*r"], "p", "radius r = 0", false),
        (&["0.3*r"], "sigma_zz", "depth below the surface z = 0", true),
        (&["r^2", "max(0,r-0.6)"], "p", "radius r = 0.6", false),
        (&["piecewise(r/5,r<0.25,3*r/5-0.1)"], "p", "radius r = 0, 0.25", false),
    ];
    for (profiles, quantity, place, falls) in all.into_iter().take(cases(3, 5)) {
        let arguments = [&["plot"], profiles, &["--quantity", quantity, "--radius", "1"]].concat();
        let svg = String::from_utf8(picture(&arguments, "svg")).unwrap();
        let infinite = if falls { "minus infinity" } else { "infinite" };
        assert!(svg.contains(&format!("; {infinite} at {place}</title>")), "{profiles:?}: {}", svg.lines().nth(1).unwrap());
        // The frame: the ends of the longest vertical line in black.
        let axis = svg.split("<polyline ").filter(|part| part.contains("stroke=\"#000000\"")).filter_map(|part| {
            let points = part.split("points=\"").nth(1)?.split('"').next()?;
            let ends: Vec<f64> = points.split_whitespace().filter_map(|own| own.split_once(',')?.1.parse().ok()).collect();
            Some((ends.iter().copied().fold(f64::INFINITY, f64::min), ends.iter().copied().fold(0.0, f64::max)))
        });
        let (top, bottom) = axis.max_by(|one, other| (one.1 - one.0).total_cmp(&(other.1 - other.0))).unwrap();
        let all = || {
            svg.split("<polyline ").filter(|part| part.contains("stroke-width=\"2\"")).flat_map(|part| {
                let points = part.split("points=\"").nth(1).and_then(|own| own.split('"').next()).unwrap_or_default().to_owned();
                points.split_whitespace().filter_map(|own| own.split_once(',')?.1.parse::<f64>().ok()).collect::<Vec<_>>()
            })
        };
        let reached = if falls { all().any(|y| y >= bottom - 1.0) } else { all().any(|y| y <= top + 1.0) };
        assert!(reached, "{profiles:?}: the line stays between {top} and {bottom}");
        let shown = run(&[&arguments[..], &["--effective-modulus", "2"]].concat());
        assert!(String::from_utf8(shown.stdout).unwrap().contains(&format!("{infinite} at {place}")));
    }
    let smooth = String::from_utf8(picture(&["plot", "r^2", "--quantity", "p", "--radius", "1"], "svg")).unwrap();
    assert!(!smooth.contains("infinite"));
}

#[test]
fn every_quantity_is_drawn_in_every_format() {
    let known = Quantity::ALL.iter().filter(|own| own.kind() != Kind::Inverse).map(|own| own.key());
    let all = &known.chain(["section"]).collect::<Vec<_>>().join(",");
    let profile = ["plot", "R-sqrt(R^2-r^2)", "min(r^2/(2*R),h)", "--set", "R=1", "--set", "h=0.1", "--radius", "0.4", "--quantity", all];
    let svg = String::from_utf8(picture(&profile, "svg")).unwrap();
    assert_eq!(svg.matches("role=\"img\"").count(), 1);
    assert!(svg.contains("<title>") && svg.contains("min(r^2/(2*R),h)"));
    assert!(lines(&svg).len() >= 14);
    assert!(picture(&["plot", "r^2", "r"], "png").starts_with(b"\x89PNG\r\n\x1a\n"));
    let text = String::from_utf8(run(&profile).stdout).unwrap();
    assert!(text.contains("Normal force") && text.contains("Tip and surface") && text.contains('⠤'), "{text}");
}

#[test]
fn names_are_text() {
    let profile = "piecewise(0,r<b,(r-b)^2)";
    let svg = String::from_utf8(picture(&["plot", profile, "r^2", "--set", "b=0.3", "--radius", "1"], "svg")).unwrap();
    assert!(svg.contains("r&lt;b") && !svg.contains("r<b"));
}

#[test]
fn bad_input_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("picture.svg");
    let file = file.to_str().unwrap();
    let cases: [&[&str]; 7] = [
        &["plot", "r^2/(2*R)", "-o", file],
        &["plot", "r^2", "--set", "R=2", "-o", file],
        &["plot", "0", "-o", file],
        &["plot", "-o", file],
        &["plot", "no-such-file.toml", "-o", file],
        &["plot", "r^2", "--quantity", "x", "-o", file],
        &["plot", "r^2", "--radius", "-1", "-o", file],
    ];
    for case in cases {
        assert_eq!(run(case).status.code(), Some(2), "{case:?}");
        assert!(fs::metadata(file).is_err(), "{case:?}");
    }
    assert_eq!(run(&["plot", "r^2", "-o", "picture.pdf"]).status.code(), Some(2));
}

#[test]
fn a_report_needs_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    for shape in ["sphere", "flat", "cone-with-spherical-cap", "truncated-paraboloid"].into_iter().step_by(cases(4, 1)) {
        let template = run(&["scene", "new", shape]);
        assert!(template.status.success(), "{shape}");
        let scene = folder.path().join(format!("{shape}.toml"));
        fs::write(&scene, &template.stdout).unwrap();
        let page = folder.path().join("report.html");
        let done = run(&["solve", scene.to_str().unwrap(), "-o", page.to_str().unwrap()]);
        assert!(done.status.success(), "{shape}: {}", String::from_utf8_lossy(&done.stderr));
        let page = fs::read_to_string(page).unwrap();
        assert!(page.len() < 1_000_000, "{shape}: {} bytes", page.len());
        for part in ["<!DOCTYPE html>", "<h1>", "<svg role=\"img\"", "<title>", "<math ", "<details>", "<th scope=\"col\">", "</html>"] {
            assert!(page.contains(part), "{shape}: {part}");
        }
        let links = page.replace("http://www.w3.org/1998/Math/MathML", "").replace("http://www.w3.org/2000/svg", "");
        assert!(!links.contains("<script") && !links.contains("http"), "{shape}");
        // The numbers are those of the table.
        let csv = String::from_utf8(run(&["solve", scene.to_str().unwrap(), "--csv"]).stdout).unwrap();
        let first = csv.lines().nth(1).unwrap().split(',').next().unwrap();
        assert!(page.contains(&format!("<td>{first}</td>")), "{shape}: {first}");
    }
}

#[test]
fn ticks_are_round_and_cover_the_numbers() {
    let texts = |values: &[f64]| {
        let axis = Axis::round(values.iter().copied(), 6);
        axis.ticks.iter().map(|tick| axis.text(*tick)).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(texts(&[0.0, 1.0]), "0 0.2 0.4 0.6 0.8 1.0");
    assert_eq!(texts(&[0.3, 2.9]), "0 0.5 1.0 1.5 2.0 2.5 3.0");
    assert_eq!(texts(&[-3.0, 250.0]), "-50 0 50 100 150 200 250");
    assert_eq!(texts(&[2.1e-9]), "0 0.5e-9 1.0e-9 1.5e-9 2.0e-9 2.5e-9");
    assert_eq!(texts(&[3.3e7]), "0 1e7 2e7 3e7 4e7");
    // What has no extent still gives an axis.
    assert_eq!(texts(&[]), "0 0.5 1.0");
    assert_eq!(texts(&[f64::NAN, f64::INFINITY]), "0 0.5 1.0");
    for size in (-300..300).map(|exponent| 10.0_f64.powi(exponent)) {
        let axis = Axis::round([3.7 * size].into_iter(), 6);
        assert!(axis.low == 0.0 && axis.high >= 3.7 * size && (3..9).contains(&axis.ticks.len()), "{axis:?}");
    }
}
