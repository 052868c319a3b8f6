//! Generated code compiles, runs, and is as accurate as its comment claims, against values with 30 digits.
//!
//! C is compiled with cc and Rust with rustc, which every Rust toolchain brings along or needs; Python, Fortran and Octave run where they
//! are installed, and a line on stderr says which of them were not.
#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)]

mod search;
mod special;

use serde_json::Value;
use sneddon::code::inner::identifiers;
use sneddon::code::{CodeError, Language, Program, QUANTITIES, program, write};
use sneddon::contact::Quantity;
use sneddon::expr::{Expr, Number, Symbol};
use sneddon::num::{DoubleDouble, Precise, precise};
use sneddon::transform::{Evaluator, Method, Profile, Solution, Superposed, derive, reach};
use sneddon::{parse, print};
use sneddon_checks::seeds::{cases as cases_of, takes};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// A profile of the catalogue at the doubles next to its parameters.
struct Entry {
    id: String,
    text: String,
    solution: Solution,
    parameters: Vec<f64>,
}

fn entries() -> &'static [Entry] {
    static ENTRIES: OnceLock<Vec<Entry>> = OnceLock::new();
    ENTRIES.get_or_init(read_entries)
}

fn entry(own: &Value) -> Entry {
    let formula = parse::profile(own["f"].as_str().unwrap()).unwrap();
    let solution = derive(&Profile::new(&formula).unwrap()).unwrap();
    let number = |name: &str| parse::constant(own["params"][name].as_str().unwrap()).unwrap().as_number().unwrap().to_f64();
    let parameters: Vec<f64> = solution.profile.parameters().iter().map(|own| number(own.name())).collect();
    Entry { id: own["id"].as_str().unwrap().to_owned(), text: print::text(&formula), solution, parameters }
}

fn read_entries() -> Vec<Entry> {
    let list: Value = serde_json::from_str(include_str!("../data/profiles.json")).unwrap();
    // Bessel functions J, differences I - L, and profiles with special functions that the catalogue lacks.
    let more = serde_json::json!([
        {"id": "sine", "f": "h*sin(k*r)", "params": {"h": "0.4", "k": "2.2"}},
        {"id": "saturating", "f": "h*(1-exp(-r/w))", "params": {"h": "0.4", "w": "1.3"}},
        {"id": "bessel", "f": "h*(1-besselj(0,k*r))", "params": {"h": "0.4", "k": "2.2"}},
        {"id": "modified", "f": "A*(besseli(0,k*r)-1)+C*besseli(1,k*r)", "params": {"A": "0.4", "C": "0.3", "k": "1.1"}},
        {"id": "struve", "f": "h*(2/pi*k*r-struveh(0,k*r))", "params": {"h": "0.4", "k": "1.1"}},
        {"id": "dawson", "f": "h*(r/w-dawson(r/w))", "params": {"h": "0.4", "w": "1.3"}},
        // Quadrature between the power series and the closed form, with one rule and with the other.
        {"id": "fraction", "f": "h*r/(w+r)", "params": {"h": "0.4", "w": "1.3"}},
        {"id": "two fractions", "f": "r^2/(w+r)-r*h/(h+r)", "params": {"h": "1.7", "w": "2.5"}},
    ]);
    list.as_array().unwrap().iter().chain(more.as_array().unwrap()).map(entry).collect()
}

/// The largest claim of a catalogue profile, times the condition number where it is conditional.
const LARGEST_CLAIM: f64 = 16.0;

/// The program of a quantity, if the language has it.
fn program_of(entry: &Entry, own: Quantity, language: Language) -> Option<Program> {
    match program(&entry.solution, &[own], language, &entry.text) {
        Ok(made) => Some(made),
        Err(CodeError::NotClosed { .. } | CodeError::Function { .. } | CodeError::Contact(_) | CodeError::Inaccurate { .. }) => None,
        Err(CodeError::NoDepth { .. }) if entry.id == "concave_paraboloid" => None,
        Err(other) => panic!("{} {}: {other}", entry.id, own.key()),
    }
}

/// A call with what it must give.
struct Case {
    what: String,
    module: String,
    function: String,
    arguments: Vec<f64>,
    truth: DoubleDouble,
    /// The claim, times the condition number where it is conditional.
    ulps: f64,
}

/// E* of every call.
const MODULUS: f64 = 1.5;
/// The step of condition numbers.
const STEP: f64 = 1e-6;

fn cases(entry: &Entry, near: &Near<'_>, module: &str, own: Quantity, made: &Program) -> Vec<Case> {
    let evaluator = &near.evaluator;
    let (_, claim) = made.claims()[0];
    let Some(claim) = claim else { return Vec::new() };
    let end = reach(evaluator);
    // The condition number itself is known to some digits.
    let claimed = |coordinates: &[f64], place: f64, more: f64| {
        (claim.ulps + more) * claim.conditional.map_or(1.0, |_| 1.01 * near.condition(own, coordinates, place))
    };
    let mut list = Vec::new();
    // Integrals of mpmath over 24 decades of the radius.
    for line in include_str!("../oracle/decades.csv").lines().skip(1) {
        let [id, quantity, radius, value] = line.split(',').collect::<Vec<_>>().try_into().unwrap();
        let (key, factor): (_, &[f64]) = if own == Quantity::Force { ("F", &[MODULUS]) } else { ("g", &[]) };
        if id != entry.id || quantity != key || !matches!(own, Quantity::Force | Quantity::Equivalent | Quantity::Depth) {
            continue;
        }
        let truth = parse::constant(value).unwrap().as_number().unwrap().to_f64() * factor.first().map_or(1.0, |own| 2.0 * own);
        // Two roundings of the truth, of half a unit each.
        let radius: f64 = radius.parse().unwrap();
        let ulps = claimed(&[radius], radius, 1.0);
        let arguments = [&[radius], factor, &entry.parameters].concat();
        let (what, function) = (format!("{id} {}", own.key()), format!("sneddon_{}", own.key()));
        list.push(Case { what, module: module.to_owned(), function, arguments, truth: truth.into(), ulps });
    }
    for part in [1e-5, 3e-4, 0.01, 0.11, 0.3, 0.52, 0.77, 0.93, 0.999] {
        let place = end * part;
        let exact = |quantity, inputs: &[f64]| evaluator.with_30_digits(quantity, inputs).unwrap().filter(|own| own.value.hi != 0.0);
        let mut push = |coordinates: &[f64], truth: Option<Precise>| {
            let Some(truth) = truth.filter(|own| own.is_finite() && own.error <= 1e-22 * own.value.hi.abs()) else { return };
            let mut arguments = coordinates.to_vec();
            if matches!(own, Quantity::Force | Quantity::Pressure | Quantity::ForceOfDepth) {
                arguments.push(MODULUS);
            }
            arguments.extend(&entry.parameters);
            let (what, function) = (format!("{} {}", entry.id, own.key()), format!("sneddon_{}", own.key()));
            let ulps = claimed(coordinates, place, 0.0);
            list.push(Case { what, module: module.to_owned(), function, arguments, truth: truth.value, ulps });
        };
        match own {
            Quantity::Equivalent | Quantity::Depth => push(&[place], exact(Superposed::Equivalent, &[place])),
            Quantity::Force => {
                push(&[place], exact(Superposed::Force, &[place]).map(|own| own.mul(Precise::exact(2.0 * MODULUS))));
            }
            Quantity::Pressure => {
                let pi = Precise { value: precise::PI, error: 3e-33 };
                for inner in [0.003, 0.35, 0.8] {
                    let r = inner * place;
                    push(&[r, place], exact(Superposed::Pressure, &[r, place]).map(|own| own.mul(Precise::exact(MODULUS)).div(pi)));
                }
            }
            Quantity::Radius | Quantity::ForceOfDepth => {
                // The depth that belongs to `place`, rounded: a moves by the rest over g′, and F by 2E*a times the rest.
                let Some(depth) = exact(Superposed::Equivalent, &[place]) else { continue };
                let at = |x: f64| exact(Superposed::Equivalent, &[x]).map_or(f64::NAN, |own| own.value.hi);
                let slope = (at(place * (1.0 + 1e-5)) - at(place * (1.0 - 1e-5))) / (2e-5 * place);
                let rest = -depth.value.lo / slope;
                // Where g has fallen before, an inner radius has the same depth.
                let inside = |i: i32| evaluator.equivalent(place * f64::from(i) / 100.0);
                let first = !(1..100).any(|i| inside(i).is_ok_and(|own| own.estimate.value > depth.value.hi));
                if slope > 0.0 && depth.value.hi > 0.0 && first && (depth.value.hi / (slope * place)).is_finite() {
                    let truth = if own == Quantity::Radius {
                        Some(Precise::exact(place).add(Precise::exact(rest)))
                    } else {
                        let less = Precise::exact(-2.0 * MODULUS * place).mul(Precise::exact(depth.value.lo));
                        exact(Superposed::Force, &[place]).map(|own| own.mul(Precise::exact(2.0 * MODULUS)).add(less))
                    };
                    push(&[depth.value.hi], truth);
                }
            }
            other => panic!("{other:?} is not written"),
        }
    }
    list
}

/// A profile at its parameters, and with each of them moved up and down by a small step.
struct Near<'a> {
    evaluator: Evaluator<'a>,
    moved: Vec<[Evaluator<'a>; 2]>,
}

impl<'a> Near<'a> {
    fn new(entry: &'a Entry) -> Self {
        let at = |parameters: &[f64]| {
            let names = entry.solution.profile.parameters();
            let pairs = names.iter().zip(parameters).map(|(own, value)| (own.name(), Expr::number(Number::from_f64(*value).unwrap())));
            Evaluator::new(&entry.solution, &pairs.collect(), Method::Auto, 1e-13).unwrap()
        };
        let one = |index: usize, factor: f64| {
            let mut parameters = entry.parameters.clone();
            parameters[index] *= factor;
            at(&parameters)
        };
        let moved = (0..entry.parameters.len()).map(|index| [one(index, 1.0 + STEP), one(index, 1.0 - STEP)]).collect();
        Self { evaluator: at(&entry.parameters), moved }
    }

    /// 1 + Σ |v ∂f/∂v|/|f| over the arguments v, for coordinates that belong to the contact radius `place`.
    fn condition(&self, own: Quantity, coordinates: &[f64], place: f64) -> f64 {
        let number = |evaluator: &Evaluator<'_>, own: Superposed, inputs: &[f64]| {
            let reading = match own {
                Superposed::Force => evaluator.force(inputs[0]).ok(),
                Superposed::Pressure => evaluator.pressure(inputs[0], inputs[1]).ok().flatten(),
                _ => evaluator.equivalent(inputs[0]).ok(),
            };
            reading.map_or(f64::NAN, |own| own.estimate.value)
        };
        let here = |own, inputs: &[f64]| number(&self.evaluator, own, inputs);
        // v ∂f/∂v by a coordinate, and by each parameter.
        let by_coordinate = |own, inputs: &[f64], index: usize| {
            let at = |factor: f64| {
                here(own, &inputs.iter().enumerate().map(|(i, v)| if i == index { v * factor } else { *v }).collect::<Vec<_>>())
            };
            (at(1.0 + STEP) - at(1.0 - STEP)) / (2.0 * STEP)
        };
        let by_parameters = |own, inputs: &[f64]| -> Vec<f64> {
            let change = |pair: &[Evaluator<'_>; 2]| (number(&pair[0], own, inputs) - number(&pair[1], own, inputs)) / (2.0 * STEP);
            self.moved.iter().map(change).collect()
        };
        let (depth, at) = (here(Superposed::Equivalent, &[place]), [place]);
        let changes: Vec<f64> = match own {
            // g(a, v) = d, so that ∂a/∂d = 1/g′ and ∂a/∂v = -(∂g/∂v)/g′.
            Quantity::Radius => {
                let rise = by_coordinate(Superposed::Equivalent, &at, 0) / place;
                let all = [vec![depth], by_parameters(Superposed::Equivalent, &at)].concat();
                all.into_iter().map(|own| own / (rise * place)).collect()
            }
            // ∂F/∂d = 2E*a and ∂F/∂v = ∂F(a)/∂v - 2E*a ∂g/∂v, in units of 2E*.
            Quantity::ForceOfDepth => {
                let force = here(Superposed::Force, &at);
                let pairs = by_parameters(Superposed::Force, &at).into_iter().zip(by_parameters(Superposed::Equivalent, &at));
                let all = pairs.map(|(force, depth)| force - place * depth).chain([place * depth, force]);
                all.map(|own| own / force).collect()
            }
            _ => {
                let own = match own {
                    Quantity::Force => Superposed::Force,
                    Quantity::Pressure => Superposed::Pressure,
                    _ => Superposed::Equivalent,
                };
                let (value, modulus) = (here(own, coordinates), if own == Superposed::Equivalent { 0.0 } else { 1.0 });
                let coordinates_moved = (0..coordinates.len()).map(|index| by_coordinate(own, coordinates, index));
                coordinates_moved.chain(by_parameters(own, coordinates)).map(|own| own / value).chain([modulus]).collect()
            }
        };
        1.0 + changes.into_iter().map(f64::abs).filter(|own| own.is_finite()).sum::<f64>()
    }
}

/// Holds the values that a language printed against the truth, one value for each case; returns the largest error as a share of its claim.
fn judge(language: &str, cases: &[Case], output: &str) -> f64 {
    let mut values = output.lines().map(|line| line.trim().parse::<f64>().unwrap_or_else(|_| panic!("{language}: {line}")));
    let (mut faults, mut largest_share) = (Vec::new(), 0.0_f64);
    for case in cases {
        let value = values.next().expect("a value for each call");
        let spacing = case.truth.hi.abs().next_up() - case.truth.hi.abs();
        let off = ((case.truth.hi - value) + case.truth.lo).abs() / spacing;
        largest_share = largest_share.max(off / case.ulps);
        if off.is_nan() || off > case.ulps {
            faults.push(format!(
                "{} {:?} = {value:e}, not {:e}: {off:.2} ulp, claimed {:.2}",
                case.what, case.arguments, case.truth.hi, case.ulps
            ));
        }
    }
    assert!(faults.is_empty(), "{language}: {} of {}\n{}", faults.len(), cases.len(), faults.join("\n"));
    largest_share
}

fn place(name: &str) -> PathBuf {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("code").join(name);
    fs::create_dir_all(&place).unwrap();
    place
}

fn run(program: &str, arguments: &[&str], place: &Path) -> String {
    let done = Command::new(program).args(arguments).current_dir(place).output().unwrap();
    assert!(done.status.success(), "{program} {arguments:?}\n{}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap()
}

fn is_installed(program: &str) -> bool {
    let found = Command::new(program).arg("--version").output().is_ok_and(|done| done.status.success());
    if !found {
        eprintln!("{program} is not installed: its language is not tested here");
    }
    found
}

fn listed(arguments: &[f64]) -> String {
    arguments.iter().map(|own| format!("{own:?}")).collect::<Vec<_>>().join(", ")
}

/// Programs of a language, one in `every` from `first` on and from another one for the next profile, and their calls; `module` numbers
/// the programs.
///
/// Programs and their compilation take long: a part of the catalogue shows one language, and others show other parts.
fn catalogue(language: Language, first: usize, every: usize) -> (Vec<(String, String)>, Vec<Case>) {
    let (mut sources, mut all, every) = (Vec::new(), Vec::new(), cases_of(every, 1));
    for (number, entry) in entries().iter().enumerate() {
        let near = Near::new(entry);
        for (index, own) in QUANTITIES.into_iter().enumerate() {
            if !(first + number + index).is_multiple_of(every) {
                continue;
            }
            let Some(made) = program_of(entry, own, language) else { continue };
            let is_extra = !include_str!("../data/profiles.json").contains(&format!("\"id\": \"{}\"", entry.id));
            let claim = made.claims()[0].1.map_or(0.0, |own| own.ulps);
            assert!(is_extra || claim <= LARGEST_CLAIM, "{} {}: a claim of {claim} ulp", entry.id, own.key());
            let module = format!("m{}", sources.len());
            all.extend(cases(entry, &near, &module, own, &made));
            sources.push((module, write(&made)));
        }
    }
    assert!(all.len() > 600 / cases_of(60, 1), "{language:?}: {} values only", all.len());
    (sources, all)
}

#[test]
fn c_is_as_accurate_as_it_claims() {
    let (sources, cases) = catalogue(Language::C, 0, 16);
    assert_tight(judge_c("c", &sources, &cases));
}

/// Claims that are a quarter of what they are would be broken.
fn assert_tight(largest_share: f64) {
    assert!(largest_share > 0.25, "no error is more than {largest_share:.3} of its claim");
}

/// Compiles C programs and compares what they give.
fn judge_c(name: &str, sources: &[(String, String)], cases: &[Case]) -> f64 {
    let (place, mut text) = (place(name), "#include <stdio.h>\n".to_owned());
    for (module, source) in sources {
        text.push_str(&source.replace("sneddon_", &format!("{module}_sneddon_")));
    }
    text.push_str("int main(void)\n{\n");
    for case in cases {
        writeln!(text, "    printf(\"%.17g\\n\", {}_{}({}));", case.module, case.function, listed(&case.arguments)).unwrap();
    }
    text.push_str("    return 0;\n}\n");
    fs::write(place.join("all.c"), text).unwrap();
    run("cc", &["-std=c99", "-Wall", "-Wextra", "-Werror", cases_of("-O1", "-O2"), "all.c", "-lm", "-o", "all"], &place);
    judge("C", cases, &run("./all", &[], &place))
}

#[test]
fn rust_is_as_accurate_as_it_claims() {
    let (sources, cases) = catalogue(Language::Rust, 1, 14);
    let (place, mut text) = (place("rust"), String::new());
    for (module, source) in &sources {
        writeln!(text, "mod {module} {{\n{source}}}").unwrap();
    }
    text.push_str("fn main() {\n    let show = |own: Result<f64, &str>| println!(\"{:e}\", own.unwrap_or(f64::NAN));\n");
    for case in &cases {
        writeln!(text, "    show({}::{}({}));", case.module, case.function, listed(&case.arguments)).unwrap();
    }
    text.push_str("}\n");
    fs::write(place.join("all.rs"), text).unwrap();
    run("rustc", &["--edition", "2024", "-Dwarnings", "-Adead_code", "all.rs", "-o", "all"], &place);
    assert_tight(judge("Rust", &cases, &run("./all", &[], &place)));
}

#[test]
fn python_is_as_accurate_as_it_claims() {
    if !is_installed("python3") {
        return;
    }
    let (sources, mut cases) = catalogue(Language::Python, 2, 24);
    let place = place("python");
    // SciPy is not everywhere.
    let sources: Vec<_> = sources.into_iter().filter(|(_, text)| !text.contains("scipy")).collect();
    cases.retain(|case| sources.iter().any(|(module, _)| *module == case.module));
    let mut text =
        "def show(call, *arguments):\n    try:\n        print(repr(call(*arguments)))\n    except ValueError:\n        print('nan')\n"
            .to_owned();
    for (module, source) in &sources {
        fs::write(place.join(format!("{module}.py")), source).unwrap();
        writeln!(text, "import {module}").unwrap();
    }
    for case in &cases {
        let name = case.function.trim_start_matches("sneddon_");
        writeln!(text, "show({}.{name}, {})", case.module, listed(&case.arguments)).unwrap();
    }
    fs::write(place.join("all.py"), text).unwrap();
    judge("Python", &cases, &run("python3", &["-B", "all.py"], &place));
}

#[test]
fn fortran_is_as_accurate_as_it_claims() {
    if !is_installed("gfortran") {
        return;
    }
    let (sources, cases) = catalogue(Language::Fortran, 3, 24);
    let (place, mut text, mut uses) = (place("fortran"), String::new(), String::new());
    for (module, source) in &sources {
        text.push_str(&source.replace("module sneddon", &format!("module {module}")));
        for name in QUANTITIES.map(|own| format!("sneddon_{}", own.key())) {
            if source.contains(&format!("public :: {name}\n")) {
                writeln!(uses, "    use {module}, only: {module}_{name} => {name}").unwrap();
            }
        }
    }
    writeln!(text, "program all\n{uses}    implicit none").unwrap();
    let literal = |arguments: &[f64]| arguments.iter().map(|own| format!("{own:e}").replace('e', "d")).collect::<Vec<_>>().join(", ");
    for case in &cases {
        writeln!(text, "    print '(es25.17e3)', {}_{}({})", case.module, case.function, literal(&case.arguments)).unwrap();
    }
    text.push_str("end program all\n");
    fs::write(place.join("all.f90"), text).unwrap();
    run("gfortran", &["-std=f2008", "-Wall", cases_of("-O0", "-O1"), "all.f90", "-o", "all"], &place);
    judge("Fortran", &cases, &run("./all", &[], &place));
}

#[test]
fn octave_is_as_accurate_as_it_claims() {
    if !is_installed("octave") {
        return;
    }
    let (sources, cases) = catalogue(Language::Matlab, 5, 40);
    let (place, mut text) = (place("octave"), "1;\n".to_owned());
    for (module, source) in &sources {
        text.push_str(&source.replace("sneddon_", &format!("{module}_sneddon_")));
    }
    for case in &cases {
        writeln!(text, "printf(\"%.17g\\n\", {}_{}({}));", case.module, case.function, listed(&case.arguments)).unwrap();
    }
    fs::write(place.join("all.m"), text).unwrap();
    judge("Octave", &cases, &run("octave", &["--norc", "--quiet", "all.m"], &place));
}

/// As `docs/code.md` says: a script with several functions, and a function by the name of its file.
#[test]
fn octave_loads_files_as_documented() {
    if !is_installed("octave") {
        return;
    }
    let formula = parse::profile("r^2/(2*R)").unwrap();
    let solution = derive(&Profile::new(&formula).unwrap()).unwrap();
    let place = place("octave_files");
    let text = |quantities: &[Quantity]| write(&program(&solution, quantities, Language::Matlab, "r^2/(2*R)").unwrap());
    fs::write(place.join("sneddon_F_of_d.m"), text(&[Quantity::ForceOfDepth])).unwrap();
    fs::write(place.join("several.m"), text(&[Quantity::Equivalent, Quantity::Depth])).unwrap();
    let calls = "source(\"several.m\"); printf(\"%g %g %g\\n\", sneddon_g(0.5, 0.5), sneddon_d(0.5, 0.5), sneddon_F_of_d(0.25, 3, 1));";
    assert_eq!(run("octave", &["--norc", "--quiet", "--eval", calls], &place), "0.5 0.5 0.5\n");
}

/// Names that are words of a language, differ in case only, or look like what the program writes.
#[test]
fn hostile_names_stay_names() {
    let names = "int lambda linux unix NAN main double t1 T1 g F p y y_ sneddon_g do end fn let self None math nan dp theta H h A X class \
                 double_ log1p value k_ k M_PI inf i j R r_ sum t0 exit_ module real result if_ if EPS e1 E1 sneddon b_ t t_ delta as in";
    let usable: Vec<&str> = names.split_whitespace().filter(|name| parse::profile(&format!("r/{name}")).is_ok()).collect();
    assert!(usable.len() > 40, "{usable:?}");
    for (group, list) in usable.chunks(11).enumerate() {
        // Different powers, so that no two terms are one.
        let terms: Vec<String> = list.iter().enumerate().map(|(index, name)| format!("r^{}/{name}", index + 2)).collect();
        let formula = parse::profile(&terms.join(" + ")).unwrap();
        let solution = derive(&Profile::new(&formula).unwrap()).unwrap();
        let place = place(&format!("hostile_{group}"));
        let all = QUANTITIES.into_iter().filter(|own| *own != Quantity::Pressure).collect::<Vec<_>>();
        let quantities = cases_of(vec![Quantity::Equivalent, Quantity::Radius, Quantity::Depth], all);
        let text = |language| write(&program(&solution, &quantities, language, &print::text(&formula)).unwrap());
        // Half of the groups in each language.
        let is_written = |number: usize| takes(group + number, 2);
        if is_written(0) {
            fs::write(place.join("a.c"), text(Language::C)).unwrap();
            run("cc", &["-Wall", "-Wextra", "-Werror", "-c", "a.c"], &place);
        }
        if is_written(1) {
            fs::write(place.join("a.rs"), text(Language::Rust)).unwrap();
            run("rustc", &["--edition", "2024", "-Dwarnings", "--crate-type", "lib", "--emit", "metadata", "a.rs"], &place);
        }
        if is_written(0) && is_installed("python3") {
            fs::write(place.join("a.py"), text(Language::Python)).unwrap();
            let ones = vec!["1.0"; list.len()].join(", ");
            let check = format!("import a; assert a.g(0.5, {ones}) > 0.5 and abs(a.a(a.d(0.5, {ones}), {ones}) - 0.5) < 1e-15");
            run("python3", &["-B", "-c", &check], &place);
        }
        if is_written(1) && is_installed("gfortran") {
            fs::write(place.join("a.f90"), text(Language::Fortran)).unwrap();
            run("gfortran", &["-std=f2008", "-Wall", "-c", "a.f90"], &place);
        }
    }
}

/// The series of a piece with one power has an `if` with an empty body, which Python rejects.
#[test]
fn a_first_piece_with_one_power_runs_in_python() {
    if !is_installed("python3") {
        return;
    }
    let text = "piecewise(r^2/2, r<b, b*(r-b/2))";
    let solution = derive(&Profile::new(&parse::profile(text).unwrap()).unwrap()).unwrap();
    let place = place("polynomial_piece");
    fs::write(place.join("a.py"), write(&program(&solution, &[Quantity::Equivalent], Language::Python, text).unwrap())).unwrap();
    // g of r²/2 is x².
    run("python3", &["-B", "-c", "import a; assert abs(a.g(0.3, 0.5) - 0.09) < 1e-16"], &place);
}

/// p(0) of slopes A/r and C/r² beyond b is elementary.
#[test]
fn pressures_of_negative_powers_are_written() {
    let law = "1.5/acos(-1.0)*(2.0*acos(0.6)/0.6 + 0.3*0.6*(acos(0.6)/0.432 + 0.8/0.72))";
    let conditions = [format!("fabs(sneddon_p(0.0, 1.0, 1.5, 2.0, 0.3, 0.6)/({law}) - 1.0) < 4e-16")];
    assert_in_c("negative_powers", "piecewise(0, r<b, A*ln(r/b)+C*(1/b-1/r))", &[Quantity::Pressure], &conditions);
}

/// What has no closed form is an error that says so.
#[test]
fn what_cannot_be_written_is_an_error() {
    let code = |text: &str, own: Quantity, language| {
        let formula = parse::profile(text).unwrap();
        program(&derive(&Profile::new(&formula).unwrap()).unwrap(), &[own], language, text).map(|own| write(&own)).unwrap_err().to_string()
    };
    assert!(code("ln(cosh(r))", Quantity::Force, Language::C).contains("the formula of F contains an integral"));
    assert!(code("ln(cosh(r))", Quantity::Radius, Language::C).contains("contains an integral"));
    assert!(code("ln(cosh(r))", Quantity::ForceOfDepth, Language::C).contains("contains an integral"));
    assert!(code("-r^2/R", Quantity::Radius, Language::C).contains("g is positive at none of the radii"));
    assert!(code("h", Quantity::Equivalent, Language::C).contains("the accuracy of g is unknown"));
    assert!(code("r^2*exp(-r^3)", Quantity::Equivalent, Language::C).contains("the function hyper, which cannot be written in C"));
}

/// A number of the program at a point, in every language that needs nothing but this toolchain: outside the domain there is no number.
#[test]
fn outside_the_domain_there_is_no_number() {
    let calls = [
        "g(2.0, 2.0)",
        "g(-1.0, 2.0)",
        "g(1.0, -2.0)",
        "g(NAN, 2.0)",
        "g(1.0, INFINITY)",
        "F(3.0, 1.0, 2.0)",
        "F(1.0, 0.0, 2.0)",
        "a(-1.0, 2.0)",
        "a(1e9, 2.0)",
        "F_of_d(-1.0, 1.0, 2.0)",
        "F_of_d(1e9, 1.0, 2.0)",
        "F_of_d(1.0, -1.0, 2.0)",
    ];
    let at_zero = ["sneddon_g(0.0, 2.0)", "sneddon_a(0.0, 2.0)", "sneddon_F_of_d(0.0, 1.0, 2.0)"].map(|own| format!("{own} == 0.0"));
    let conditions: Vec<String> = calls.iter().map(|own| format!("isnan(sneddon_{own})")).chain(at_zero).collect();
    let quantities = [Quantity::Equivalent, Quantity::Force, Quantity::Radius, Quantity::ForceOfDepth];
    assert_in_c("domain", "R-sqrt(R^2-r^2)", &quantities, &conditions);
}

/// Compiles a C file with a test for each condition, and asserts that all of them hold.
fn assert_in_c(name: &str, profile: &str, quantities: &[Quantity], conditions: &[String]) {
    let solution = derive(&Profile::new(&parse::profile(profile).unwrap()).unwrap()).unwrap();
    let mut text = write(&program(&solution, quantities, Language::C, profile).unwrap());
    text.push_str("#include <stdio.h>\nint main(void)\n{\n");
    for own in conditions {
        writeln!(text, "    printf(\"%d\\n\", (int)({own}));").unwrap();
    }
    text.push_str("    return 0;\n}\n");
    let place = place(name);
    fs::write(place.join("a.c"), text).unwrap();
    run("cc", &["a.c", "-lm", "-o", "a"], &place);
    let output = run("./a", &[], &place);
    let failed: Vec<&String> = conditions.iter().zip(output.lines()).filter(|(_, own)| *own != "1").map(|(own, _)| own).collect();
    assert!(failed.is_empty() && output.lines().count() == conditions.len(), "{failed:#?}");
}

#[test]
fn every_name_is_an_identifier_and_no_two_are_equal() {
    let symbols: Vec<Symbol> = ["R", "r_", "int", "t1", "_x", "é\n*/", "A", "a_0", "A_0"].map(Symbol::new).to_vec();
    let names = identifiers(&symbols, true, &|word| word == "int", &["r".to_owned(), "a".to_owned()]);
    let all: BTreeSet<String> = names.values().map(|own| own.to_lowercase()).collect();
    assert_eq!(all.len(), symbols.len());
    assert_eq!((names["R"].as_str(), names["int"].as_str(), names["t1"].as_str()), ("R_", "int_", "t1_"));
    let is_word =
        |own: &str| own.starts_with(|c: char| c.is_ascii_alphabetic()) && own.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    assert!(names.values().all(|own| is_word(own)), "{names:?}");
}
