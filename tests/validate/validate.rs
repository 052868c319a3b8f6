//! `sneddon validate` on real runs of two boundary-element solvers, on data with planted faults, and on files that are none.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)]

use serde_json::Value;
use sneddon_checks::seeds::sample;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const PROGRAM: &str = env!("CARGO_BIN_EXE_sneddon");
const GRIDS: [u32; 3] = [64, 128, 256];

fn runs() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/solver_runs")
}

pub(crate) fn room(name: &str) -> PathBuf {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("validate").join(name);
    let _ = fs::remove_dir_all(&place);
    fs::create_dir_all(&place).unwrap();
    place
}

fn run(place: &Path, arguments: &[String]) -> Output {
    Command::new(PROGRAM).current_dir(place).arg("validate").args(arguments).output().unwrap()
}

/// Validates files with a scene; the exit code and the JSON document.
pub(crate) fn validated(place: &Path, scene: &str, files: &[String], more: &[&str]) -> (i32, Value) {
    fs::write(place.join("scene.toml"), scene).unwrap();
    let mut arguments = vec!["scene.toml".to_owned()];
    arguments.extend(files.iter().cloned());
    arguments.push("--json".to_owned());
    arguments.extend(more.iter().map(|own| (*own).to_owned()));
    let done = run(place, &arguments);
    let code = done.status.code().unwrap();
    assert!(code < 2, "{}", String::from_utf8_lossy(&done.stderr));
    let document: Value = serde_json::from_slice(&done.stdout).unwrap();
    assert_eq!(document["passed"], code == 0);
    (code, document)
}

/// The scene of a run: lengths in um or m, with its load and what is said of the data.
fn scene(set: &str, load: Option<&str>, data: &str) -> String {
    let micro = set.contains("_cm");
    let length = if micro { "um" } else { "m" };
    let profile = match set.split('_').next().unwrap() {
        "paraboloid" if micro => "f = \"r^2/(2*R)\"\nparameters = { R = \"10 um\" }".to_owned(),
        "paraboloid" => "f = \"r^2/(2*R)\"\nparameters = { R = \"5 mm\" }".to_owned(),
        "sphere" => "shape = \"sphere\"\nparameters = { R = \"10 um\" }".to_owned(),
        "cone" => "f = \"r*tan(theta)\"\nparameters = { theta = 0.2 }".to_owned(),
        _ => "f = \"0\"\nradius = \"1 um\"".to_owned(),
    };
    let material = if micro { "E = \"72 GPa\"\nnu = 0.17" } else { "E = \"210 GPa\"\nnu = 0.3" };
    let load = load.map_or(String::new(), |own| format!("[load]\n{own}\n"));
    format!("[profile]\n{profile}\n[material]\n{material}\n{load}[outputs]\nunits = {{ length = \"{length}\" }}\n{data}")
}

fn files(set: &str, kind: &str) -> Vec<String> {
    let path = |n: u32| runs().join(format!("{set}_n{n}_{kind}.csv"));
    GRIDS.iter().map(|n| path(*n)).filter(|own| own.exists()).map(|own| own.display().to_string()).collect()
}

#[test]
fn force_files_of_real_runs_converge_with_their_order() {
    let place = room("forces");
    let errors = fs::read_to_string(runs().join("errors.csv")).unwrap();
    let reported = |run: &str| -> f64 {
        errors.lines().find(|line| line.starts_with(&format!("{run},"))).unwrap().split(',').nth(1).unwrap().parse().unwrap()
    };
    for (set, side, low, high) in [
        ("paraboloid_cm", "8 um", 1.5, 2.3),
        ("sphere_cm", "20 um", 1.5, 2.3),
        ("flat_punch_cm", "4 um", 0.9, 1.3),
        ("paraboloid_tamaas_dcfft", "0.4 mm", 1.5, 2.3),
        ("cone_tamaas_dcfft", "0.4 mm", 1.5, 2.3),
    ] {
        let declared = format!("[data]\nbox = \"{side}\"\ngrid = [64, 128, 256]\nboundary = \"free\"\n");
        for (data, more) in [("", vec![]), ("", vec!["--grid", "64,128,256"]), (declared.as_str(), vec![])] {
            let (code, found) = validated(&place, &scene(set, None, data), &files(set, "Fd"), &more);
            assert_eq!(code, 0, "{set}: {found:#}");
            assert_eq!(found["suspicion"], Value::Null);
            let order = &found["order"]["F"];
            let number = |key: &str| order[key].as_f64().unwrap();
            assert!(number("value") > low && number("value") < high && number("low") > 0.0, "{set}: {order}");
            for (n, file) in GRIDS.iter().zip(found["files"].as_array().unwrap()) {
                let own = file["columns"]["F"]["at_largest_load"].as_f64().unwrap();
                let expected = reported(&format!("{set}_n{n}"));
                assert!((own - expected).abs() <= 0.01 * expected, "{set} {n}: {own} {expected}");
            }
        }
    }
}

#[test]
fn every_single_force_file_passes_on_its_own_grid() {
    let place = room("each");
    for (set, side) in [
        ("paraboloid_cm", "8 um"),
        ("sphere_cm", "20 um"),
        ("flat_punch_cm", "4 um"),
        ("paraboloid_tamaas_dcfft", "0.4 mm"),
        ("cone_tamaas_dcfft", "0.4 mm"),
    ] {
        for (n, file) in GRIDS.iter().zip(files(set, "Fd")) {
            let control = if set.contains("_cm") { "depth" } else { "force" };
            let data = format!("[data]\nbox = \"{side}\"\ngrid = {n}\ncontrol = \"{control}\"\n");
            let (code, found) = validated(&place, &scene(set, None, &data), &[file], &[]);
            assert_eq!(code, 0, "{set} {n}: {found:#}");
            assert_eq!(found["order"], Value::Null);
            let decides = if control == "depth" { "F" } else { "d" };
            assert_eq!(found["columns"][decides]["passed"], true, "the controlled quantity carries no error");
            assert_eq!(found["columns"]["a"]["passed"], true);
        }
    }
}

#[test]
fn pressure_files_of_free_runs_pass_and_those_of_periodic_boxes_fail_with_the_reason() {
    let place = room("pressures");
    for (set, loads) in [
        ("paraboloid_cm", &["contact_radius = \"2 um\"", "depth = \"0.4 um\""][..]),
        ("flat_punch_cm", &["depth = \"0.05 um\""]),
        ("paraboloid_tamaas_dcfft", &["contact_radius = \"0.1 mm\"", "force = \"61.538461538 N\""]),
        ("cone_tamaas_dcfft", &["contact_radius = \"0.1 mm\"", "force = \"734.8065673 N\""]),
        ("paraboloid_tamaas_periodic", &["contact_radius = \"0.1 mm\"", "force = \"61.538461538 N\"", "depth = \"2 um\""]),
        ("cone_tamaas_periodic", &["contact_radius = \"0.1 mm\"", "force = \"734.8065673 N\""]),
    ] {
        let side = match set {
            "paraboloid_cm" => "8 um",
            "flat_punch_cm" => "4 um",
            _ => "0.4 mm",
        };
        let periodic = set.contains("periodic");
        let files = files(set, "p");
        let grids = if files.len() == 3 { "64,128,256" } else { "64,256" };
        for load in loads {
            let declared = format!("[data]\nbox = \"{side}\"\ngrid = [{grids}]\npressure = \"point\"\n");
            for data in ["", declared.as_str()] {
                let (code, found) = validated(&place, &scene(set, Some(load), data), &files, &["--grid", grids]);
                assert_eq!(code, i32::from(periodic), "{set} {load}: {found:#}");
                let suspicion = found["suspicion"].as_str().unwrap_or("");
                assert_eq!(suspicion.contains("periodic"), periodic, "{set} {load}: {suspicion}");
                let order = &found["order"]["p"];
                if periodic {
                    assert!(order["low"].as_f64().unwrap() <= 0.0 || order["value"].as_f64().unwrap() < 0.05, "{order}");
                    assert!(found["reason"].as_str().unwrap().contains("do not decrease"), "{found:#}");
                } else {
                    assert!(order["value"].as_f64().unwrap() > 0.9, "{set}: {order}");
                    assert!(found["columns"]["p"]["excluded"]["rows"].as_u64().unwrap() > 0);
                }
            }
        }
    }
}

/// Pseudo-random numbers in [−1, 1].
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// A tip with its exact relations, written down here once more: E* = 2, lengths of order 1.
#[derive(Clone, Copy)]
enum Tip {
    /// R = 10: a² = R d, F = (4/3) E* a³/R, p = (2E*/πR) √(a² − r²).
    Paraboloid,
    /// tan θ = 0.25: a = 2d/(π tan θ), F = (π/2) E* a² tan θ, p = (E*/2) tan θ arcosh(a/r).
    Cone,
}

const MODULUS: f64 = 2.0;
const RADIUS: f64 = 10.0;
const SLOPE: f64 = 0.25;
const NU: f64 = 0.3;
const SIDE: f64 = 8.0;

impl Tip {
    fn scene(self, load: &str, n: u32) -> String {
        let young = MODULUS * (1.0 - NU * NU);
        let profile = match self {
            Self::Paraboloid => format!("f = \"r^2/(2*R)\"\nparameters = {{ R = {RADIUS} }}"),
            Self::Cone => format!("f = \"r*tan(theta)\"\nparameters = {{ theta = {:?} }}", SLOPE.atan()),
        };
        format!(
            "[profile]\n{profile}\n[material]\nE = {young:?}\nnu = {NU}\n[load]\n{load}\n[data]\nbox = {SIDE}\ngrid = {n}\nboundary = \"free\"\n"
        )
    }

    fn depth(self, a: f64) -> f64 {
        match self {
            Self::Paraboloid => a * a / RADIUS,
            Self::Cone => std::f64::consts::FRAC_PI_2 * a * SLOPE,
        }
    }

    fn force(self, a: f64) -> f64 {
        match self {
            Self::Paraboloid => 4.0 / 3.0 * MODULUS * a.powi(3) / RADIUS,
            Self::Cone => std::f64::consts::FRAC_PI_2 * MODULUS * a * a * SLOPE,
        }
    }

    fn pressure(self, r: f64, a: f64) -> f64 {
        match self {
            _ if r >= a => 0.0,
            Self::Paraboloid => 2.0 * MODULUS / (std::f64::consts::PI * RADIUS) * (a * a - r * r).sqrt(),
            // The solver's value at the apex is finite.
            Self::Cone => 0.5 * MODULUS * SLOPE * (a / r.max(0.01)).acosh(),
        }
    }
}

/// d, F and a with errors as a grid makes them: up to 0.1 (h/a)² in F, a quarter of a pixel in a.
fn loads(tip: Tip, n: u32, change: &dyn Fn(usize, [f64; 3]) -> [f64; 3]) -> String {
    let (h, mut noise) = (SIDE / f64::from(n), Noise(7));
    let mut text = "d,F,a\n".to_owned();
    for index in 0..12 {
        let a = 0.8 + 0.1 * index as f64;
        let error = 0.1 * (h / a).powi(2) * (0.6 + 0.4 * noise.next());
        let row = change(index, [tip.depth(a), tip.force(a) * (1.0 + error), a + 0.25 * h * noise.next()]);
        writeln!(text, "{:?},{:?},{:?}", row[0], row[1], row[2]).unwrap();
    }
    text
}

/// Pressures at the centres of pixels, with errors up to 0.1 (h/a)².
fn pressures(tip: Tip, n: u32, a: f64, change: &dyn Fn([f64; 2]) -> [f64; 2]) -> String {
    let (h, mut noise) = (SIDE / f64::from(n), Noise(11));
    let mut text = "r,p\n".to_owned();
    for i in 0..n / 4 {
        for j in 0..=i {
            let r = h * f64::from(i).hypot(f64::from(j));
            let p = tip.pressure(r, a) * (1.0 + 0.1 * (h / a).powi(2) * noise.next());
            let row = change([r, p]);
            writeln!(text, "{:?},{:?}", row[0], row[1]).unwrap();
        }
    }
    text
}

#[test]
fn exact_data_with_the_errors_of_a_grid_pass() {
    let place = room("sound");
    for tip in [Tip::Paraboloid, Tip::Cone] {
        let scene = tip.scene("contact_radius = 1.9", 128);
        fs::write(place.join("loads.csv"), loads(tip, 128, &|_, row| row)).unwrap();
        fs::write(place.join("p.csv"), pressures(tip, 128, 1.9, &|row| row)).unwrap();
        for file in ["loads.csv", "p.csv"] {
            let (code, found) = validated(&place, &scene, &[file.to_owned()], &[]);
            assert_eq!(code, 0, "{found:#}");
        }
    }
}

/// Noise far below the tolerance needs no order; a constant error has none, and no finer grid would cure it.
#[test]
fn errors_that_do_not_shrink_are_noise_or_a_fault() {
    let place = room("floor");
    let scene = Tip::Paraboloid.scene("contact_radius = 1.9", 64).replace("grid = 64", "grid = [32, 64, 128]");
    let files = |part: f64| -> Vec<String> {
        let write = |n: u32| {
            let (h, mut noise) = (SIDE / f64::from(n), Noise(n.into()));
            let mut text = "r,p\n".to_owned();
            for i in 0..n / 4 {
                for j in 0..=i {
                    let r = h * f64::from(i).hypot(f64::from(j));
                    writeln!(text, "{r:?},{:?}", Tip::Paraboloid.pressure(r, 1.9) * (1.0 + part + 5e-6 * noise.next())).unwrap();
                }
            }
            fs::write(place.join(format!("p{n}.csv")), text).unwrap();
            format!("p{n}.csv")
        };
        vec![write(32), write(64), write(128)]
    };
    let (code, found) = validated(&place, &scene, &files(0.0), &[]);
    assert_eq!(code, 0, "{found:#}");
    let (code, found) = validated(&place, &scene, &files(0.03), &[]);
    let reason = found["reason"].as_str().unwrap_or_default().to_owned();
    assert!(code == 1 && reason.contains("refinement does not help"), "{found:#}");
}

/// Every fault is found; each is named by the word that belongs to it.
#[test]
fn planted_faults_are_found_and_named() {
    use std::f64::consts::PI;
    let place = room("faults");
    let factor = 1.0 - NU * NU;
    let load = "contact_radius = 1.9";
    type Rows = Box<dyn Fn(Tip) -> String>;
    let of_loads = |change: &'static dyn Fn(usize, [f64; 3]) -> [f64; 3]| -> Rows { Box::new(move |tip| loads(tip, 128, change)) };
    let of_places = |change: &'static dyn Fn([f64; 2]) -> [f64; 2]| -> Rows { Box::new(move |tip| pressures(tip, 128, 1.9, change)) };
    let next = |tip: Tip| {
        let text = loads(tip, 128, &|_, row| row);
        let rows: Vec<Vec<&str>> = text.lines().skip(1).map(|line| line.split(',').collect()).collect();
        let shifted = rows.windows(2).map(|pair| format!("{},{},{}\n", pair[0][0], pair[1][1], pair[1][2]));
        format!("d,F,a\n{}", shifted.collect::<String>())
    };
    let faults: Vec<(&str, Rows)> = vec![
        ("E used as E*", of_loads(&|_, [d, f, a]| [d, f * (1.0 - NU * NU), a])),
        ("E* used as E", of_loads(&|_, [d, f, a]| [d, f / (1.0 - NU * NU), a])),
        ("a missing pi", of_loads(&|_, [d, f, a]| [d, f / PI, a])),
        ("a missing pi", of_loads(&|_, [d, f, a]| [d, f, a * 1.772_453_850_905_516])),
        ("unit slip: F", of_loads(&|_, [d, f, a]| [d, 1e3 * f, a])),
        ("unit slip: d", of_loads(&|_, [d, f, a]| [1e3 * d, f, a])),
        ("tension and compression confused", of_loads(&|_, [d, f, a]| [d, -f, a])),
        ("quarter model", of_loads(&|_, [d, f, a]| [d, 0.25 * f, a])),
        ("diameter and radius confused", of_loads(&|_, [d, f, a]| [d, f, 2.0 * a])),
        ("another reference for depth", of_loads(&|_, [d, f, a]| [d + 0.01, f, a])),
        ("compliant frame", of_loads(&|_, [d, f, a]| [d + 0.02 * f, f, a])),
        ("another modulus", of_loads(&|_, [d, f, a]| [d, 1.2345 * f, a])),
        ("another load level", Box::new(next)),
        ("E used as E*", of_places(&|[r, p]| [r, p * (1.0 - NU * NU)])),
        ("a missing pi", of_places(&|[r, p]| [r, PI * p])),
        ("unit slip: p", of_places(&|[r, p]| [r, 1e-6 * p])),
        ("unit slip: r", of_places(&|[r, p]| [1e3 * r, p])),
        ("tension and compression confused", of_places(&|[r, p]| [r, -p])),
        ("diameter and radius confused", of_places(&|[r, p]| [2.0 * r, p])),
        ("shifted origin", of_places(&|[r, p]| [r + 0.1, p])),
        ("another load level", Box::new(|tip| pressures(tip, 128, 1.8, &|row| row))),
    ];
    assert!(factor < 1.0);
    for (number, tip) in [Tip::Paraboloid, Tip::Cone].into_iter().enumerate() {
        for (name, data) in sample(&faults, number, 2) {
            fs::write(place.join("data.csv"), data(tip)).unwrap();
            let (code, found) = validated(&place, &tip.scene(load, 128), &["data.csv".to_owned()], &[]);
            assert_eq!(code, 1, "{name} passes: {found:#}");
            let suspicion = found["suspicion"].as_str().unwrap_or("");
            assert!(suspicion.contains(name), "{name}: {suspicion:?}, {}", found["reason"]);
        }
    }
    // Faults of the scene itself.
    let turned = Tip::Cone.scene(load, 128).replace(&format!("{:?}", SLOPE.atan()), &format!("{:?}", PI / 2.0 - SLOPE.atan()));
    let doubled = Tip::Paraboloid.scene(load, 128).replace("R = 10", "R = 20");
    for (tip, scene, name) in
        [(Tip::Cone, turned, "half-opening angle and surface angle confused"), (Tip::Paraboloid, doubled, "diameter and radius confused")]
    {
        fs::write(place.join("data.csv"), loads(tip, 128, &|_, row| row)).unwrap();
        let (code, found) = validated(&place, &scene, &["data.csv".to_owned()], &[]);
        assert_eq!(code, 1, "{found:#}");
        assert!(found["suspicion"].as_str().unwrap_or("").contains(name), "{found:#}");
    }
}

#[test]
fn a_fault_without_a_name_is_given_none() {
    let place = room("nameless");
    let wild = loads(Tip::Paraboloid, 128, &|index, [d, f, a]| [d, f * (1.0 + 0.1 * (index as f64 * 2.3).sin()), a]);
    fs::write(place.join("data.csv"), wild).unwrap();
    let (code, found) = validated(&place, &Tip::Paraboloid.scene("depth = 0.3", 128), &["data.csv".to_owned()], &[]);
    assert_eq!((code, &found["suspicion"]), (1, &Value::Null), "{found:#}");
}

/// Without a comparison there is no pass, and the first line says which columns were not read.
#[test]
fn what_was_not_compared_does_not_pass() {
    let place = room("nothing");
    let reason = |found: &Value| found["reason"].as_str().unwrap().to_owned();
    // A contact of six pixels: all its places are next to the edge or the apex; those beyond have no pressure to be wrong.
    // A quadrant with a gap makes no force either.
    for (tip, factor) in [(Tip::Cone, 1e3), (Tip::Cone, 1.0), (Tip::Paraboloid, 0.0)] {
        let (a, h) = (1.5, 0.25);
        let mut text = "r,p\n".to_owned();
        for i in 0..16 {
            let r = h * f64::from(i);
            if r < 0.7 && matches!(tip, Tip::Paraboloid) {
                continue;
            }
            writeln!(text, "{r:?},{:?}", factor * tip.pressure(r, a)).unwrap();
        }
        fs::write(place.join("p.csv"), text).unwrap();
        let (code, found) = validated(&place, &tip.scene("contact_radius = 1.5", 32), &["p.csv".to_owned()], &[]);
        assert_eq!(code, 1, "{found:#}");
        assert!(reason(&found).contains("nothing was judged"), "{found:#}");
        assert_eq!(found["suspicion"], Value::Null);
    }
    // Contact radii without a pixel, beside a force under a name that nothing knows.
    let rows = loads(Tip::Paraboloid, 128, &|_, [d, f, a]| [d, 10.0 * f, a]).replace("d,F,a", "d,strength,a");
    fs::write(place.join("data.csv"), rows).unwrap();
    let scene = Tip::Paraboloid.scene("depth = 0.3", 128);
    let blind = scene.split("[data]").next().unwrap();
    let (code, found) = validated(&place, blind, &["data.csv".to_owned()], &[]);
    assert!(reason(&found).contains("ignored columns: strength"), "{found:#}");
    assert!(code == 1 || found["columns"]["a"]["passed"] == true, "{found:#}");
    let (_, found) = validated(&place, &scene, &["data.csv".to_owned()], &[]);
    assert!(reason(&found).contains("ignored columns: strength"), "{found:#}");
    // Under a name that is known the force is read, and fails.
    for name in ["P", "Fn", "normal_force"] {
        let rows = loads(Tip::Paraboloid, 128, &|_, [d, f, a]| [d, 10.0 * f, a]).replace("d,F,a", &format!("penetration,{name},a"));
        fs::write(place.join("data.csv"), rows).unwrap();
        let (code, found) = validated(&place, blind, &["data.csv".to_owned()], &[]);
        assert!(code == 1 && found["columns"]["F"]["passed"] == false, "{name}: {found:#}");
    }
}

/// Wrong rows at small loads weigh next to nothing in a norm, but each is far beyond what its grid excuses.
/// Class "contact radii alone": without a pixel they are judged by the tolerance of the request, and by nothing else.
#[test]
fn contact_radii_alone_are_judged_by_the_tolerance_that_is_asked_for() {
    let place = room("radii_alone");
    // d = a²/R and F = 4 a³/(3 R) with R = 1.
    let scene = "[profile]\nf = \"r^2/2\"\n[material]\neffective_modulus = 1\n";
    for control in ["d", "F"] {
        for (factor, tolerance, passed) in [(1.0, Some("1e-9"), true), (1.001, Some("1e-9"), false), (1.001, Some("1e-2"), true)] {
            let row = |a: f64| format!("{:?},{:?}\n", if control == "d" { a * a } else { 4.0 * a * a * a / 3.0 }, factor * a);
            let rows: String = [0.2, 0.3, 0.5].into_iter().map(row).collect();
            fs::write(place.join("radii.csv"), format!("{control},a\n{rows}")).unwrap();
            let more = tolerance.map_or(vec![], |own| vec!["--tol", own]);
            let (code, found) = validated(&place, scene, &["radii.csv".to_owned()], &more);
            assert_eq!(code == 0, passed, "{control} {factor} {tolerance:?}: {found:#}");
        }
        let (code, found) = validated(&place, scene, &["radii.csv".to_owned()], &[]);
        assert!(code == 1 && found["reason"].as_str().unwrap().contains("or a tolerance"), "{control}: {found:#}");
    }
}

/// Class "a tolerance hides a wrong row": a row that is inconsistent with its neighbours fails under `--tol` too, if it is beyond it.
#[test]
fn a_tolerance_hides_no_wrong_row() {
    let place = room("hidden");
    let scene = "[profile]\nf = \"r^2/2\"\n[material]\neffective_modulus = 1\n";
    for (factor, tolerance, code) in [(1.03, "1e-2", 1), (1.4, "0.2", 1), (1.03, "5e-2", 0), (1.0, "1e-3", 0)] {
        for wrong in [0, 4, 9] {
            let row = |index: u32| {
                let a = 0.1 * f64::from(index + 1);
                format!("{:?},{:?}\n", a * a, 4.0 * a * a * a / 3.0 * if index == wrong { factor } else { 1.0 })
            };
            fs::write(place.join("rows.csv"), format!("d,F\n{}", (0..10).map(row).collect::<String>())).unwrap();
            let found = validated(&place, scene, &["rows.csv".to_owned()], &["--tol", tolerance]);
            assert_eq!(found.0, code, "{factor} {tolerance} {wrong}: {:#}", found.1);
        }
    }
}

/// Class "a factor is called a wrong order of the files": it cancels the error of the coarsest grid, so that errors grow towards a limit.
#[test]
fn a_factor_is_no_wrong_order() {
    let place = room("order");
    let scene = "[profile]\nf = \"0\"\nradius = 1.0\n[material]\neffective_modulus = 1\n[data]\nbox = 2.5\n";
    let named = |factor: f64, files: [u32; 3]| {
        let names = files.map(|n| format!("{n}.csv"));
        for (name, n) in names.iter().zip(files) {
            // F of a solver on n pixels is too small by about a quarter of h/a.
            let row = |d: f64| format!("{d:?},{:?}\n", factor * 2.0 * d * (1.0 - 0.1 * 2.5 / f64::from(n)));
            fs::write(place.join(name), format!("d,F\n{}", [0.025, 0.05, 0.075, 0.1].map(row).concat())).unwrap();
        }
        let (code, found) = validated(&place, scene, &names, &["--grid", "64,128,256"]);
        (code, found["suspicion_details"]["id"].as_str().unwrap_or("").to_owned())
    };
    assert_eq!(named(1.0, [64, 128, 256]).0, 0);
    assert_eq!(named(1.0, [256, 128, 64]), (1, "file-order".to_owned()));
    for factor in [1.005, 1.004] {
        let (code, id) = named(factor, [64, 128, 256]);
        assert!(code == 1 && id != "file-order", "{factor}: {id}");
    }
}

/// Class "a load where the exact value is 0": the reason names it, and no infinite norm is shown.
#[test]
fn a_force_without_a_contact_is_named() {
    let place = room("no_contact");
    fs::write(place.join("scene.toml"), "[profile]\nf = \"r^2/2\"\n[material]\neffective_modulus = 1\n").unwrap();
    for depth in ["0", "-0.1"] {
        fs::write(place.join("data.csv"), format!("d,F\n{depth},0.3\n0.25,0.16666666666666666\n")).unwrap();
        let done = run(&place, &["scene.toml".to_owned(), "data.csv".to_owned()]);
        let text = String::from_utf8_lossy(&done.stdout);
        assert_eq!(done.status.code(), Some(1), "{text}");
        assert!(text.starts_with(&format!("failed: F is not 0 at d = {depth}, where its exact value is 0")), "{text}");
        assert!(!text.contains("e308") && !text.contains("inf"), "{text}");
    }
}

/// What is not judged is not called within its tolerance, and a load of the command line that nothing needs is told.
#[test]
fn the_first_line_names_what_was_judged() {
    let place = room("judged");
    fs::write(place.join("scene.toml"), "[profile]\nf = \"r^2/2\"\n[material]\neffective_modulus = 1\n").unwrap();
    fs::write(place.join("data.csv"), "d,F,a\n0.25,0.16666666666666666,0.5\n0.04,0.010666666666666666,0.2\n").unwrap();
    let done = run(&place, &["scene.toml", "data.csv", "--load", "d=0.1"].map(str::to_owned));
    let (text, told) = (String::from_utf8_lossy(&done.stdout), String::from_utf8_lossy(&done.stderr));
    assert!(text.starts_with("passed: within the tolerance: F (L2 error of F: ") && text.contains("; not judged: a\n"), "{text}");
    assert!(told.contains("--load is not used"), "{told}");
    for (name, kind) in [("data.npy", "NPY"), ("data.npz", "NPZ")] {
        fs::write(place.join(name), "no array").unwrap();
        let done = run(&place, &["scene.toml", name].map(str::to_owned));
        let told = String::from_utf8_lossy(&done.stderr);
        assert!(done.status.code() == Some(2) && told.contains(&format!("this is not an {kind} file")), "{told}");
    }
}

#[test]
fn no_norm_hides_rows_that_are_wrong() {
    let place = room("rows");
    let sweep = |wrong: &dyn Fn(usize) -> f64| -> String {
        let row = |i: usize| {
            let a = 0.2 * 10f64.powf(i as f64 / 16.0);
            format!("{:?},{:?}\n", Tip::Paraboloid.depth(a), wrong(i) * Tip::Paraboloid.force(a))
        };
        format!("d,F\n{}", (0..17).map(row).collect::<String>())
    };
    let scene = Tip::Paraboloid.scene("depth = 0.3", 512);
    let blind = scene.split("[data]").next().unwrap().to_owned();
    let eight = |factor: f64| move |i: usize| if i < 8 { factor } else { 1.0 };
    for (scene, factor, expected) in [(&blind, 1.0, 0), (&scene, 1.0, 0), (&blind, 10.0, 1), (&scene, 10.0, 1), (&scene, 0.5, 1)] {
        fs::write(place.join("data.csv"), sweep(&eight(factor))).unwrap();
        let (code, found) = validated(&place, scene, &["data.csv".to_owned()], &[]);
        assert_eq!(code, expected, "{factor}: {found:#}");
    }
    for wrong in [0, 5, 16] {
        fs::write(place.join("data.csv"), sweep(&|i| if i == wrong { 2.0 } else { 1.0 })).unwrap();
        let (code, found) = validated(&place, &blind, &["data.csv".to_owned()], &[]);
        assert_eq!(code, 1, "row {wrong}: {found:#}");
    }
}

/// The force of a punch on three grids of a real solver, made 1 or 2 % wrong: on the way down to the wrong limit errors change their sign, or grow.
#[test]
fn what_no_finer_grid_cures_fails_whatever_its_errors_look_like() {
    let place = room("limit");
    let scene = scene("flat_punch_cm", None, "[data]\nbox = \"4 um\"\ngrid = [64, 128, 256]\n");
    for (factor, expected) in [(1.0, 0), (1.01, 1), (1.02, 1), (0.99, 1), (0.98, 1)] {
        let scaled = |(index, file): (usize, &String)| {
            let text = fs::read_to_string(file).unwrap();
            let mut lines = text.lines();
            let mut out = format!("{}\n", lines.next().unwrap());
            for line in lines {
                let mut fields: Vec<String> = line.split(',').map(str::to_owned).collect();
                fields[1] = format!("{:?}", factor * fields[1].parse::<f64>().unwrap());
                out += &format!("{}\n", fields.join(","));
            }
            fs::write(place.join(format!("{index}.csv")), out).unwrap();
            format!("{index}.csv")
        };
        let files: Vec<String> = files("flat_punch_cm", "Fd").iter().enumerate().map(scaled).collect();
        let (code, found) = validated(&place, &scene, &files, &[]);
        assert_eq!(code, expected, "{factor}: {found:#}");
    }
}

/// One row of a dozen that is off is named, and nothing else is suspected.
#[test]
fn one_bad_row_or_pixel_is_named() {
    let place = room("single");
    let scene = Tip::Paraboloid.scene("contact_radius = 1.9", 128);
    fs::write(place.join("loads.csv"), loads(Tip::Paraboloid, 128, &|i, [d, f, a]| [d, if i == 7 { 1.1 * f } else { f }, a])).unwrap();
    let spoiled: String = pressures(Tip::Paraboloid, 128, 1.9, &|row| row)
        .lines()
        .enumerate()
        .map(|(i, line)| match line.split_once(',') {
            Some((r, p)) if i == 100 => format!("{r},{:?}\n", 1.3 * p.parse::<f64>().unwrap()),
            _ => format!("{line}\n"),
        })
        .collect();
    fs::write(place.join("p.csv"), spoiled).unwrap();
    for file in ["loads.csv", "p.csv"] {
        let (code, found) = validated(&place, &scene, &[file.to_owned()], &[]);
        assert_eq!(code, 1, "{found:#}");
        assert_eq!(found["suspicion_details"]["id"], "single-row", "{found:#}");
    }
}

/// Class "a fault that passes": a pressure just outside of a smooth edge, where the norms compare nothing. Any of them passed.
#[test]
fn a_pressure_outside_the_contact_is_seen() {
    let place = room("outside");
    let scene = Tip::Paraboloid.scene("contact_radius = 1.9", 128);
    let rows = pressures(Tip::Paraboloid, 128, 1.9, &|row| row);
    let mean = Tip::Paraboloid.force(1.9) / (std::f64::consts::PI * 1.9 * 1.9);
    for (at, share, code) in [(1.92, 1.5, 1), (1.98, 0.5, 1), (2.05, 0.05, 1), (2.05, 0.01, 0), (1.92, 0.2, 0)] {
        let mut is_done = false;
        let spoiled: String = rows
            .lines()
            .map(|line| match line.split_once(',').and_then(|(r, _)| r.parse::<f64>().ok()) {
                Some(r) if r > at && !std::mem::replace(&mut is_done, true) => format!("{r:?},{:?}\n", share * mean),
                _ => format!("{line}\n"),
            })
            .collect();
        fs::write(place.join("p.csv"), spoiled).unwrap();
        let (found, report) = validated(&place, &scene, &["p.csv".to_owned()], &[]);
        assert!(is_done && found == code, "{share} at {at}: {report:#}");
    }
}

/// The errors of good data fall by themselves; a further file that is finer turns no pass into a failure.
#[test]
fn errors_far_inside_their_tolerance_pass_without_an_order() {
    let place = room("inside");
    let scene = Tip::Paraboloid.scene("depth = 0.3", 64).replace("grid = 64", "grid = [32, 64, 128]");
    let write = |name: &str, error: [f64; 3]| {
        let rows = [0.9, 1.3, 1.7].into_iter().zip(error);
        let text: String =
            rows.map(|(a, e)| format!("{:?},{:?}\n", Tip::Paraboloid.depth(a), Tip::Paraboloid.force(a) * (1.0 + e))).collect();
        fs::write(place.join(name), format!("d,F\n{text}")).unwrap();
        name.to_owned()
    };
    // L2 of 3.8e-4, 1.3e-4 and 3.5e-5, with signs as grids make them; tolerances from 1e-2 to 1e-3.
    let files = [write("0.csv", [9e-4, 4e-4, -3.7e-4]), write("1.csv", [-3e-4, 1e-4, 1.2e-4]), write("2.csv", [4e-5, -7e-5, 3e-5])];
    for count in 1..=3 {
        let scene = if count == 3 { scene.clone() } else { scene.replace("[32, 64, 128]", if count == 1 { "[32]" } else { "[32, 64]" }) };
        let (code, found) = validated(&place, &scene, &files[..count], &[]);
        assert_eq!(code, 0, "{count}: {found:#}");
    }
}

#[test]
fn the_force_of_a_complete_lattice_is_the_sum_of_its_pressures() {
    let place = room("lattice");
    fs::write(place.join("p.csv"), pressures(Tip::Paraboloid, 128, 1.9, &|[r, p]| [r, 1.01 * p])).unwrap();
    let scene = Tip::Paraboloid.scene("contact_radius = 1.9", 128);
    let (_, found) = validated(&place, &scene, &["p.csv".to_owned()], &["--tol", "0.02"]);
    // The same rule on both sides: the lattice's own error drops out.
    let bias = found["columns"]["F_from_p"]["bias"].as_f64().unwrap();
    assert!((bias - 0.01).abs() < 5e-4, "{bias}");
    // A thinned file makes no sum.
    let thinned: String = pressures(Tip::Paraboloid, 128, 1.9, &|row| row)
        .lines()
        .enumerate()
        .filter(|(i, _)| i % 3 != 2)
        .map(|(_, l)| format!("{l}\n"))
        .collect();
    fs::write(place.join("p.csv"), thinned).unwrap();
    let (_, found) = validated(&place, &scene, &["p.csv".to_owned()], &[]);
    assert_eq!(found["columns"]["F_from_p"], Value::Null);
}

#[test]
fn odd_but_readable_files_are_read() {
    let place = room("readable");
    let plain = loads(Tip::Cone, 128, &|_, row| row);
    let names = plain.lines().next().unwrap();
    for (name, text) in [
        ("byte order mark", format!("\u{feff}{plain}")),
        ("CRLF", plain.replace('\n', "\r\n")),
        ("decimal commas", plain.replace(',', ";").replace('.', ",")),
        ("tabs", plain.replace(',', "\t")),
        ("comments", format!("# made by a solver\n{plain}# end\n")),
        ("names in a comment", plain.replace("d,F,a", "# d,F,a")),
        ("names twice", format!("{plain}{names}\n{}", plain.split_once('\n').unwrap().1)),
        ("another column", plain.lines().enumerate().map(|(i, line)| format!("{line},{}\n", if i == 0 { "steps" } else { "3" })).collect()),
        ("words", plain.replace("d,F,a", "depth,force,contact_radius")),
    ] {
        fs::write(place.join("data.csv"), text).unwrap();
        let (code, found) = validated(&place, &Tip::Cone.scene("depth = 0.3", 128), &["data.csv".to_owned()], &[]);
        assert_eq!(code, 0, "{name}: {found:#}");
    }
}

#[test]
fn files_that_are_no_data_are_refused_with_their_line() {
    let place = room("refused");
    let scene = Tip::Cone.scene("depth = 0.3", 128);
    fs::write(place.join("scene.toml"), &scene).unwrap();
    for (text, said) in [
        ("", "neither a header nor rows"),
        ("d,F,a\n", "a header but no rows"),
        ("0.1,0.2,0.3\n0.2,0.3,0.4\n", "numbers instead of column names"),
        ("d,F,a\n0.1,x,0.3\n", "line 2: column F: \"x\" is not a number"),
        ("d,F,a\n0.1,NaN,0.3\n", "NaN is not finite"),
        ("d,F,a\n0.1,,0.3\n", "column F is empty"),
        ("d,F,a\n0.1,0.2\n", "2 fields, but the first line has 3 column names"),
        ("d,F\n0,1,0,2\n", "decimal commas"),
        ("d,d,F\n0.1,0.1,0.2\n", "contain the same quantity"),
        ("d_um,F_um\n0.1,0.2\n", "um is a length, not a force"),
        ("t,s\n0.1,0.2\n", "nothing to compare"),
        ("p,F\n0.1,0.2\n", "at least two of d, F and a"),
        ("p\n0.1\n", "missing column r"),
        ("r\n0.1\n", "missing column p or u"),
    ] {
        fs::write(place.join("data.csv"), text).unwrap();
        let page = place.join("page.html");
        fs::write(&page, "old").unwrap();
        let arguments = ["scene.toml", "data.csv", "-o", "page.html"].map(str::to_owned);
        let done = run(&place, &arguments);
        let error = String::from_utf8_lossy(&done.stderr).into_owned();
        assert_eq!(done.status.code(), Some(2), "{text:?}: {error}");
        assert!(error.contains(said), "{text:?}: {error}");
        assert!(error.contains("help: expected") || error.contains("semicolon"), "{error}");
        assert!(done.stdout.is_empty());
        assert_eq!(fs::read_to_string(&page).unwrap(), "old");
    }
}

#[test]
fn the_page_needs_nothing_else() {
    let place = room("page");
    fs::write(place.join("scene.toml"), scene("paraboloid_cm", Some("contact_radius = \"2 um\""), "")).unwrap();
    let mut arguments = vec!["scene.toml".to_owned()];
    arguments.extend(files("paraboloid_cm", "p"));
    arguments.extend(["-o", "page.html"].map(str::to_owned));
    assert_eq!(run(&place, &arguments).status.code(), Some(0));
    let page = fs::read_to_string(place.join("page.html")).unwrap();
    assert!(page.contains("<svg") && page.contains("exact") && page.ends_with("</html>\n"));
    for outside in ["src=", "href=", "<script", "url("] {
        assert!(!page.contains(outside), "{outside}");
    }
}

/// Known columns that a file of loads does not use, and options that apply to fields only, are named.
#[test]
fn what_is_not_used_is_named() {
    let place = room("unused");
    let rows = loads(Tip::Cone, 128, &|_, row| row);
    let rows: Vec<String> =
        rows.lines().enumerate().map(|(i, line)| format!("{line},{}\n", if i == 0 { "radius" } else { "0.05" })).collect();
    fs::write(place.join("data.csv"), rows.concat()).unwrap();
    fs::write(place.join("scene.toml"), Tip::Cone.scene("depth = 0.3", 128)).unwrap();
    let done = run(&place, &["scene.toml", "data.csv", "--cells"].map(str::to_owned));
    let [said, warned] = [done.stdout, done.stderr].map(|own| String::from_utf8(own).unwrap());
    assert!(said.lines().next().unwrap().ends_with("ignored columns: radius"), "{said}");
    assert!(warned.contains("--cells and --origin are not used"), "{warned}");
}

#[test]
fn grid_and_data_that_do_not_fit_are_refused() {
    let place = room("grid");
    fs::write(place.join("data.csv"), loads(Tip::Cone, 128, &|_, row| row)).unwrap();
    let scene = Tip::Cone.scene("depth = 0.3", 128);
    for (scene, more, said) in [
        (scene.clone(), vec!["--grid", "64,128"], "the grid has 2 numbers, but there is 1 file of loads"),
        (scene.replace("grid = 128", "gird = 128"), vec![], "did you mean grid?"),
        (scene.replace("\"free\"", "\"fre\""), vec![], "did you mean free?"),
        (scene.replace("box = 8", "box = 0"), vec![], "box = 0"),
        (scene, vec!["--tol", "0"], "--tol, column 1: 0 is not positive"),
    ] {
        fs::write(place.join("scene.toml"), scene).unwrap();
        let arguments: Vec<String> = ["scene.toml", "data.csv"].into_iter().chain(more).map(str::to_owned).collect();
        let done = run(&place, &arguments);
        assert_eq!(done.status.code(), Some(2));
        assert!(String::from_utf8_lossy(&done.stderr).contains(said), "{}", String::from_utf8_lossy(&done.stderr));
    }
}

#[test]
fn the_example_of_the_document_is_true() {
    let place = room("document");
    let document = fs::read_to_string(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/validate.md")).unwrap();
    let example = document.split("## An example").nth(1).unwrap();
    let block = |kind: &str| example.split(&format!("```{kind}\n")).nth(1).unwrap().split("```").next().unwrap().to_owned();
    fs::write(place.join("periodic.toml"), block("toml")).unwrap();
    let text = block("text");
    let (command, shown) = text.split_once('\n').unwrap();
    let arguments: Vec<String> = command.strip_prefix("$ sneddon validate ").unwrap().split(' ').map(str::to_owned).collect();
    for name in arguments.iter().filter(|own| own.ends_with(".csv")) {
        fs::copy(runs().join(name), place.join(name)).unwrap();
    }
    let done = run(&place, &arguments);
    assert_eq!(done.status.code(), Some(1));
    assert_eq!(String::from_utf8(done.stdout).unwrap().trim_end(), shown.trim_end());
}

/// Radii at even steps of depth have areas in whole ratios, without any pixel.
#[test]
fn radii_that_are_computed_betray_no_pixel() {
    let place = room("computed");
    let rows = |factor: f64| -> String {
        let row = |i: i32| {
            let a = (f64::from(i) * 0.04 * RADIUS).sqrt();
            format!("{:?},{:?},{a:?}\n", Tip::Paraboloid.depth(a), factor * Tip::Paraboloid.force(a))
        };
        format!("d,F,a\n{}", (1..=10).map(row).collect::<String>())
    };
    let scene = Tip::Paraboloid.scene("depth = 0.3", 128);
    let scene = scene.split("[data]").next().unwrap();
    for (factor, expected) in [(1.0, 0), (1.0 - NU * NU, 1)] {
        fs::write(place.join("data.csv"), rows(factor)).unwrap();
        let (code, found) = validated(&place, scene, &["data.csv".to_owned()], &[]);
        assert_eq!(code, expected, "{found:#}");
        assert_eq!(found["suspicion"].as_str().is_some_and(|own| own.contains("E used as E*")), expected == 1);
    }
}

#[test]
fn measured_tips_are_compared_too() {
    let place = room("tip");
    let points: String = (0..=120).map(|i| f64::from(i) * 0.03).map(|r| format!("{r:?},{:?}\n", r * r / (2.0 * RADIUS))).collect();
    fs::write(place.join("tip.csv"), format!("r,z\n{points}")).unwrap();
    let scene = Tip::Paraboloid.scene("contact_radius = 1.9", 128);
    let scene = scene.replace(&format!("f = \"r^2/(2*R)\"\nparameters = {{ R = {RADIUS} }}"), "points = \"tip.csv\"");
    fs::write(place.join("loads.csv"), loads(Tip::Paraboloid, 128, &|_, row| row)).unwrap();
    fs::write(place.join("p.csv"), pressures(Tip::Paraboloid, 128, 1.9, &|row| row)).unwrap();
    for file in ["loads.csv", "p.csv"] {
        let (code, found) = validated(&place, &scene, &[file.to_owned()], &[]);
        assert_eq!(code, 0, "{found:#}");
    }
}

/// Files as NumPy writes them, by tests/oracle/arrays.py; the same with a scene of another modulus fail.
#[test]
fn arrays_are_read_as_numpy_writes_them() {
    let place = room("arrays");
    let data = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/arrays");
    let scene = Tip::Paraboloid.scene("contact_radius = 1.9", 40).replace("box = 8\n", "").replace("grid = 40\n", "");
    let young = format!("{:?}", MODULUS * (1.0 - NU * NU));
    let stiff = scene.replace(&young, &format!("{:?}", 1.05 * MODULUS * (1.0 - NU * NU)));
    let cases: [(&str, &[&str]); 10] = [
        ("loads.npz", &[]),
        ("table.npz", &["--map", "d=1", "--map", "F=2", "--map", "a=3"]),
        ("rows.npy", &[]),
        ("blanks.txt", &[]),
        ("nameless.txt", &["--map", "F=1", "--map", "d=2"]),
        ("press.npy", &["--box", "8", "--map", "p=press"]),
        ("press.npy", &["--box", "8", "--origin", "pixel"]),
        ("between.npy", &["--box", "8", "--origin", "centre"]),
        ("between.npy", &["--box", "8"]),
        ("corner.npz", &["--box", "8", "--origin", "corner"]),
    ];
    for (file, more) in cases {
        let path = [data.join(file).display().to_string()];
        let (code, found) = validated(&place, &scene, &path, more);
        assert_eq!(code, 0, "{file} {more:?}: {found:#}");
        let (code, found) = validated(&place, &stiff, &path, more);
        assert_eq!(code, 1, "{file} {more:?}: {found:#}");
    }
    // The axis in the wrong place, or in a corner without a word.
    for (file, more) in [("press.npy", &["--box", "8", "--origin", "centre"][..]), ("corner.npz", &[])] {
        let (code, found) = validated(&place, &scene, &[data.join(file).display().to_string()], more);
        assert_eq!(code, 1, "{file} {more:?}: {found:#}");
    }
    fs::write(place.join("scene.toml"), &scene).unwrap();
    fs::write(place.join("data.h5"), b"\x89HDF\r\n\x1a\n rest").unwrap();
    fs::write(place.join("short.npy"), b"\x93NUMPY\x01\x00\x10\x00{").unwrap();
    // A changed byte in the data of the first member, BZIP2 as its compression method, and half of a file.
    let loads = fs::read(data.join("loads.npz")).unwrap();
    let mut torn = loads.clone();
    torn[60] ^= 0xFF;
    fs::write(place.join("torn.npz"), torn).unwrap();
    let mut foreign = loads.clone();
    let entry = foreign.windows(4).position(|own| own == b"PK\x01\x02").unwrap();
    foreign[entry + 10] = 12;
    fs::write(place.join("foreign.npz"), foreign).unwrap();
    fs::write(place.join("cut.npz"), &loads[..loads.len() / 2]).unwrap();
    let corner = data.join("corner.npz").display().to_string();
    let press = data.join("press.npy").display().to_string();
    for (arguments, said) in [
        (&["data.h5"][..], "h5py"),
        (&["short.npy"], "the header is incomplete"),
        (&["torn.npz"], "array d: "),
        (&["foreign.npz"], "array d: unsupported compression method BZIP2"),
        (&["cut.npz"], "this is not an NPZ file"),
        (&[press.as_str()], "has no coordinates"),
        (&[press.as_str(), "--box", "8", "--map", "p=pres"], "no file contains a column \"pres\""),
        (&[press.as_str(), "--box", "8", "--map", "q=press"], "is not a quantity"),
        (&[press.as_str(), "--box=-8"], "is not positive"),
        (&[corner.as_str(), "--origin", "corner"], "require the box"),
    ] {
        let arguments: Vec<String> = ["scene.toml"].iter().chain(arguments).map(|own| (*own).to_owned()).collect();
        let done = run(&place, &arguments);
        let error = String::from_utf8_lossy(&done.stderr).into_owned();
        assert!(done.status.code() == Some(2) && error.contains(said), "{arguments:?}: {error}");
    }
}

/// Surface displacements of a paraboloid, positive into the surface.
fn displacement(r: f64, a: f64) -> f64 {
    if r <= a {
        return a * a / RADIUS - r * r / (2.0 * RADIUS);
    }
    ((2.0 * a * a - r * r) * (a / r).asin() + a * (r * r - a * a).sqrt()) / (std::f64::consts::PI * RADIUS)
}

/// A square field as a solver writes it: x and y in rows, a value computed at index (i, j) counted from the axis.
fn square(name: &str, n: i32, coordinate: &dyn Fn(i32) -> f64, value: &dyn Fn(i32, i32) -> f64) -> String {
    let mut text = format!("x,y,{name}\n");
    for i in 0..n {
        for j in 0..n {
            writeln!(text, "{:?},{:?},{:?}", coordinate(i), coordinate(j), value(i, j)).unwrap();
        }
    }
    text
}

/// Every way in which coordinates can miss the axis, with the axis on a pixel and between pixels.
#[test]
fn axes_in_the_wrong_place_are_named() {
    let place = room("axes");
    let (n, a, h) = (64, 1.9, SIDE / 64.0);
    let scene = Tip::Paraboloid.scene("contact_radius = 1.9", 64).replace("boundary = \"free\"\n", "");
    for half in [0.0, 0.5] {
        let from_axis = |own: i32| h * (f64::from(own - n / 2) + half);
        // In the order of a discrete Fourier transform, index 0 is where the middle is otherwise.
        let turned = |own: i32| (own + n / 2) % n;
        let value = |i: i32, j: i32| Tip::Paraboloid.pressure(from_axis(i).hypot(from_axis(j)), a);
        let shifted = |i: i32, j: i32| value(turned(i), turned(j));
        let from_corner = |own: i32| h * f64::from(own);
        let from_half = |own: i32| h * (f64::from(own) + 0.5);
        let to_the_end = |own: i32| SIDE / f64::from(n - 1) * f64::from(own);
        let written = |coordinate: &dyn Fn(i32) -> f64, value: &dyn Fn(i32, i32) -> f64| square("p", n, coordinate, value);
        let cases = [
            (written(&from_axis, &value), None),
            (written(&from_corner, &value), Some("origin-corner")),
            (written(&from_half, &value), Some("origin-corner")),
            (written(&to_the_end, &value), Some("origin-corner")),
            (written(&from_axis, &shifted), Some("fftshift")),
            (written(&from_corner, &shifted), Some("fftshift")),
        ];
        for (index, (text, id)) in cases.into_iter().enumerate() {
            fs::write(place.join("p.csv"), text).unwrap();
            let (code, found) = validated(&place, &scene, &["p.csv".to_owned()], &[]);
            assert_eq!(code, i32::from(id.is_some()), "{index} {half}: {}", found["reason"]);
            assert_eq!(found["suspicion_details"]["id"].as_str(), id, "{index} {half}: {}", found["suspicion"]);
        }
    }
}

/// A force per pixel, columns under each other's names, and what becomes of displacements.
#[test]
fn columns_that_hold_something_else_are_named() {
    let place = room("columns");
    let (n, a, h) = (64, 1.9, SIDE / 64.0);
    let scene = Tip::Paraboloid.scene("contact_radius = 1.9", 64);
    let at = |own: i32| h * f64::from(own - n / 2);
    let pressure = |i: i32, j: i32| Tip::Paraboloid.pressure(at(i).hypot(at(j)), a);
    let exact = |i: i32, j: i32| displacement(at(i).hypot(at(j)), a);
    let mean = (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).map(|(i, j)| exact(i, j)).sum::<f64>() / f64::from(n * n);
    let field = |name: &str, value: &dyn Fn(i32, i32) -> f64| square(name, n, &at, value);
    let turned = |order: [usize; 3]| loads(Tip::Paraboloid, 64, &|_, own| order.map(|index| own[index]));
    let cases: Vec<(String, Option<&str>)> = vec![
        (field("p", &|i, j| pressure(i, j) * h * h), Some("force-per-pixel")),
        (field("u", &exact), None),
        (field("u+c", &exact), None),
        (field("u+c", &|i, j| exact(i, j) - mean), None),
        (field("u+c", &|i, j| 1.05 * exact(i, j) - mean), Some("u-scale")),
        (field("u", &|i, j| -exact(i, j)), Some("u-sign")),
        (field("u", &|i, j| exact(i, j) - mean), Some("u-constant")),
        (field("u", &|i, j| exact(i, j) + 0.05), Some("u-constant")),
        (field("u", &|i, j| 0.05 - exact(i, j)), Some("u-sign")),
        (field("u", &|i, j| 1.07 * exact(i, j)), Some("u-scale")),
        (field("u", &|i, j| 1e-3 * exact(i, j)), Some("u-scale")),
        (field("u", &|i, j| (1.0 - NU * NU) * exact(i, j)), Some("modulus")),
        (turned([0, 1, 2]), None),
        (turned([1, 0, 2]), Some("swapped-columns")),
        (turned([2, 1, 0]), Some("swapped-columns")),
        (turned([0, 2, 1]), Some("swapped-columns")),
        (turned([1, 2, 0]), Some("swapped-columns")),
        (turned([2, 0, 1]), Some("swapped-columns")),
        (pressures(Tip::Paraboloid, 64, a, &|[r, p]| [p, r]), Some("swapped-columns")),
    ];
    for (index, (text, id)) in cases.iter().enumerate() {
        fs::write(place.join("data.csv"), text).unwrap();
        let (code, found) = validated(&place, &scene, &["data.csv".to_owned()], &[]);
        assert_eq!(code, i32::from(id.is_some()), "{index}: {}", found["reason"]);
        assert_eq!(found["suspicion_details"]["id"].as_str(), *id, "{index}: {}", found["suspicion"]);
    }
}

/// A load beside the scene takes the place of that of the file, whatever is controlled.
#[test]
fn the_load_of_a_field_can_be_said_beside_the_scene() {
    let place = room("load");
    fs::write(place.join("p.csv"), pressures(Tip::Paraboloid, 64, 1.9, &|row| row)).unwrap();
    let scene = Tip::Paraboloid.scene("depth = 0.1", 64);
    let without = scene.replace("[load]\ndepth = 0.1\n", "");
    let files = ["p.csv".to_owned()];
    assert_eq!(validated(&place, &scene, &files, &[]).0, 1);
    for load in ["a=1.9".to_owned(), format!("d={:?}", Tip::Paraboloid.depth(1.9)), format!("F={:?}", Tip::Paraboloid.force(1.9))] {
        for scene in [&scene, &without] {
            assert_eq!(validated(&place, scene, &files, &["--load", &load]).0, 0, "{load}");
        }
    }
    assert_eq!(validated(&place, &without, &files, &["--load", "a=2"]).0, 1);
    for (load, said) in
        [("q=1", "is not a load"), ("a", "is not a load"), ("a=-1", "not positive"), ("a=1 um", "has a unit"), ("a=1e999", "")]
    {
        let arguments = ["scene.toml", "p.csv", "--load", load].map(str::to_owned);
        let done = run(&place, &arguments);
        assert_eq!(done.status.code(), Some(2), "{load}");
        assert!(String::from_utf8_lossy(&done.stderr).contains(said), "{load}: {}", String::from_utf8_lossy(&done.stderr));
    }
}

/// A row whose error is far above those of its neighbours is no error of a grid, whatever the norm says.
#[test]
fn rows_out_of_proportion_to_their_neighbours_are_named() {
    let place = room("neighbours");
    let scene = |tip: Tip| tip.scene("depth = 0.3", 128).split("[data]").next().unwrap().to_owned();
    for tip in [Tip::Paraboloid, Tip::Cone] {
        let good = loads(tip, 128, &|_, row| row);
        fs::write(place.join("data.csv"), &good).unwrap();
        let (code, found) = validated(&place, &scene(tip), &["data.csv".to_owned()], &[]);
        assert_eq!(code, 0, "{found:#}");
        // The first row, one in the middle, the last one; a radius.
        for (row, factor) in [(0, 1.3), (5, 1.05), (11, 0.97)] {
            let off = loads(tip, 128, &|index, [d, f, a]| [d, if index == row { factor * f } else { f }, a]);
            fs::write(place.join("data.csv"), off).unwrap();
            let (code, found) = validated(&place, &scene(tip), &["data.csv".to_owned()], &[]);
            assert_eq!((code, &found["suspicion_details"]["id"]), (1, &Value::from("single-row")), "row {row}: {found:#}");
        }
        let off = loads(tip, 128, &|index, [d, f, a]| [d, f, if index == 6 { 1.4 * a } else { a }]);
        fs::write(place.join("data.csv"), off).unwrap();
        let (code, found) = validated(&place, &scene(tip), &["data.csv".to_owned()], &[]);
        assert_eq!(code, 1, "{found:#}");
    }
}

/// Forces that are off beside radii that are right to many digits fail without a grid; pressures that end too early fail beside the edge.
#[test]
fn radii_and_the_edge_of_the_contact_are_used() {
    let place = room("edges");
    let paraboloid = |change: f64| {
        let row = |index: i32| f64::from(index + 4).powi(2) * 1e-3;
        let rows = (0..12).map(row).map(|d| format!("{d},{:?},{:?}\n", change * 4.0 / 3.0 * 10f64.sqrt() * d.powf(1.5), (10.0 * d).sqrt()));
        format!("d,F,a\n{}", rows.collect::<String>())
    };
    let scene = "[profile]\nf = \"r^2/(2*R)\"\nparameters = { R = 10 }\n[material]\nE = 1\nnu = 0\n";
    for (change, code) in [(1.0, 0), (1.005, 1)] {
        fs::write(place.join("data.csv"), paraboloid(change)).unwrap();
        let (found, document) = validated(&place, scene, &["data.csv".to_owned()], &[]);
        assert_eq!(found, code, "{document:#}");
    }
    // The radius of a flat punch is given, however the force errs.
    let punch = (1..8).map(|index| 0.01 * f64::from(index)).map(|d| format!("{d:?},{:?},1.0002\n", 2.0 * d * 1.004));
    fs::write(place.join("data.csv"), format!("d,F,a\n{}", punch.collect::<String>())).unwrap();
    let flat = "[profile]\nf = \"0\"\nradius = 1\n[material]\nE = 1\nnu = 0\n";
    let (found, document) = validated(&place, flat, &["data.csv".to_owned()], &[]);
    assert_eq!(found, 0, "{document:#}");
    // p = 2 √(a² − r²)/(π R) on a square lattice of 64 pixels, lost within some pixels of the edge.
    let field = |lost: f64| {
        let (a, h) = (1.0_f64, 1.0 / 20.0);
        let mut text = String::from("x,y,p\n");
        for i in -32..32 {
            for j in -32..32 {
                let (x, y) = (f64::from(i) * h, f64::from(j) * h);
                let p = if x.hypot(y) > a - lost * h {
                    0.0
                } else {
                    2.0 / (std::f64::consts::PI * 10.0) * (a * a - x * x - y * y).max(0.0).sqrt()
                };
                writeln!(text, "{x},{y},{p:?}").unwrap();
            }
        }
        text
    };
    for (lost, code) in [(0.0, 0), (2.5, 1)] {
        fs::write(place.join("data.csv"), field(lost)).unwrap();
        let (found, document) = validated(&place, &format!("{scene}[load]\ndepth = 0.1\n"), &["data.csv".to_owned()], &[]);
        assert_eq!(found, code, "{document:#}");
    }
    // The square is 3.2 wide.
    for (side, code) in [("3.2", 0), ("7", 1)] {
        fs::write(place.join("data.csv"), field(0.0)).unwrap();
        let (found, document) = validated(&place, &format!("{scene}[load]\ndepth = 0.1\n"), &["data.csv".to_owned()], &["--box", side]);
        assert_eq!(found, code, "{document:#}");
    }
}
