//! A smaller budget gives the same answer, a part of it that is marked as incomplete, or none.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::schemas::{faults, schema};
use serde_json::{Value, json};
use sneddon::parse;
use sneddon_checks::profiles::{self, Sample};
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Commands of every kind; FILE is a file that exists.
const COMMANDS: &[&str] = &[
    "derive r^2/(2*R) --set R=2",
    "derive r^2/(2*R) --json",
    "derive r^2/(2*R) --steps",
    "derive r^2/(2*R) --steps=full",
    "derive R-sqrt(R^2-r^2) --format latex",
    "derive -h*r^2/c^2 --depth d",
    "derive piecewise(0,r<b,(r-b)*tan(theta)) --json",
    "derive ln(cosh(r)) --json",
    "derive r^2/(2*R) -o FILE.json",
    "invert x^2/R",
    "invert x*atanh(x/R) --json",
    "invert x^2/R --steps -o FILE.tex",
    "code r^2/(2*R) --lang c",
    "code R-sqrt(R^2-r^2) --lang python -o FILE.py",
    "eval R-sqrt(R^2-r^2) --set R=2 --quantity F --at 0.1,0.5 --json",
    "eval exp(sin(r))-1 --quantity g --at 0.1:2:20 --csv",
    "eval max(0,r-0.3)^2+r^2 --quantity p --radius 1 --at 0:0.9:7 --json",
    "eval 1-exp(-r^2) --quantity a --at 0.1,1.2 --json",
    "compare R-sqrt(R^2-r^2) --set R=2 --json",
    "compare ln(cosh(r))",
    "plot r^2 --quantity p -o FILE.svg",
];

/// Commands for any profile; PROFILE is its text and its parameters.
const TEMPLATES: &[&str] = &[
    "derive PROFILE",
    "derive PROFILE --json",
    "derive PROFILE --steps",
    "derive PROFILE --format latex",
    "derive PROFILE -o FILE.json",
    "code PROFILE --lang c --quantity g -o FILE.c",
    "eval PROFILE --quantity g --at 0.1:0.9:5 --json",
    "eval PROFILE --quantity F --at 0.2,0.7",
    "eval PROFILE --quantity p --radius 0.8 --at 0:0.7:5 --csv",
    "eval PROFILE --quantity a --at 0.05,0.4 --json",
    "compare PROFILE --at 0.3,0.7 --json",
    "solve scene.toml --json",
    "solve scene.toml -o FILE.csv",
    "validate scene.toml rows.csv --json",
    "reference scene.toml --grid 0:1:4 -o FILE.csv",
];

#[derive(PartialEq)]
struct Answer {
    code: i32,
    text: String,
    file: String,
}

const BEFORE: &str = "as it was";

fn answer(command: &str, budget: f64, round: usize) -> Answer {
    let words: Vec<&str> = command.split(' ').collect();
    answered(&words, budget, &place(round))
}

fn place(round: usize) -> PathBuf {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("budgets").join(round.to_string());
    fs::create_dir_all(&place).unwrap();
    place
}

/// The answer of a command of [`TEMPLATES`] for a profile.
fn answer_for(profile: &Sample, template: &str, budget: f64, place: &Path) -> Answer {
    let symbols: Vec<_> =
        parse::profile(&profile.text).map_or_else(|_| Vec::new(), |own| own.expressions().iter().flat_map(|own| own.symbols()).collect());
    let values: Vec<_> = profile.values.iter().filter(|(name, _)| symbols.iter().any(|own| own.name() == *name)).collect();
    let sets: Vec<String> = values.iter().map(|(name, value)| format!("{name}={value}")).collect();
    let mut words: Vec<&str> = Vec::new();
    for word in template.split(' ') {
        if word == "PROFILE" {
            words.extend(sets.iter().flat_map(|set| ["--set", set]).chain([profile.text.as_str()]));
        } else {
            words.push(word);
        }
    }
    let parameters: Vec<String> = values.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    let scene = format!(
        "[profile]\nf = \"{}\"\nparameters = {{ {} }}\n[material]\neffective_modulus = 1\n[load]\ndepth = [0.05, 0.4]\n\
         [outputs]\nquantities = [\"p\"]\nat = {{ start = 0, stop = 0.4, count = 4 }}\n",
        profile.text,
        parameters.join(", ")
    );
    fs::write(place.join("scene.toml"), scene).unwrap();
    fs::write(place.join("rows.csv"), "d,F\n0.05,0.01\n0.4,0.2\n").unwrap();
    answered(&words, budget, place)
}

fn answered(words: &[&str], budget: f64, place: &Path) -> Answer {
    let file = words.iter().find(|own| own.starts_with("FILE"));
    if let Some(name) = file {
        fs::write(place.join(name), BEFORE).unwrap();
    }
    let budget = format!("{budget:e}");
    let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).args(words).args(["--budget", &budget]).current_dir(place).output().unwrap();
    Answer {
        code: done.status.code().unwrap(),
        text: String::from_utf8(done.stdout).unwrap(),
        file: file.map_or_else(String::new, |name| fs::read_to_string(place.join(name)).unwrap()),
    }
}

/// The first value of a partial document that differs from the whole one.
fn new(whole: &Value, part: &Value, place: &str) -> Option<String> {
    // A point whose neighbour was cut does not use what was found for it.
    const OF_THE_CUT: [&str; 5] = ["complete", "why", "check", "method", "evaluations"];
    match (whole, part) {
        _ if part.is_null() || whole == part => None,
        // The advice of a verdict follows only once no fault was found.
        (Value::String(whole), Value::String(part)) if place == "/reason" && whole.starts_with(part) => None,
        // A comparison that was cut has fewer points.
        (Value::Object(whole), Value::Object(part)) if part.contains_key("points") && part.contains_key("max_relative_difference") => {
            let number = |own: &serde_json::Map<String, Value>, key: &str| own[key].as_f64().unwrap_or(0.0);
            let least = ["points", "max_relative_difference"].iter().all(|key| number(part, key) <= number(whole, key));
            let same = least && (part["verdict"] == whole["verdict"] || part["verdict"] == "not compared");
            (!same).then(|| format!("{place}: {part:?} and not {whole:?}"))
        }
        (Value::Object(whole), Value::Object(part)) => {
            part.iter().filter(|(key, _)| !OF_THE_CUT.contains(&key.as_str())).find_map(|(key, own)| {
                // A null point has no bound.
                let absent = Value::Null;
                new(whole.get(key).unwrap_or(&absent), own, &format!("{place}/{key}")).filter(|_| part.get("value") != Some(&absent))
            })
        }
        // A row that was cut says so in a finding.
        (Value::Array(whole), Value::Array(part)) if part.iter().any(|own| own["rule"] == "unfinished") => {
            // A summary counts the rows that were finished.
            let counts = |own: &Value, known: &Value| {
                own["rows"].is_u64() && known["rule"] == own["rule"] && known["rows"].as_u64() >= own["rows"].as_u64()
            };
            let is_known = |own: &Value| whole.iter().any(|known| known == own || counts(own, known));
            let other = part.iter().find(|own| own["rule"] != "unfinished" && !is_known(own));
            other.map(|own| format!("{place}: {own}"))
        }
        (Value::Array(whole), Value::Array(part)) if whole.len() == part.len() => {
            whole.iter().zip(part).find_map(|(whole, part)| new(whole, part, &format!("{place}[]")))
        }
        _ => Some(format!("{place}: {part} and not {whole}")),
    }
}

/// Compares an answer with that of a large budget, and returns what is wrong with it.
fn fault(whole: &Answer, own: &Answer) -> Option<String> {
    if whole == own {
        return None;
    }
    if own.code != 1 {
        return Some(format!("exit code {}", own.code));
    }
    let untouched = own.file == BEFORE;
    foreign(&whole.text, &own.text).or_else(|| if untouched { None } else { foreign(&whole.file, &own.file) })
}

/// The part of a partial text that differs from the whole one and does not say that it was cut.
fn foreign(whole: &str, own: &str) -> Option<String> {
    if own.is_empty() || own == whole {
        return None;
    }
    if let Ok(part) = serde_json::from_str::<Value>(own) {
        // The large budget shows that the input is refused.
        let whole = serde_json::from_str::<Value>(whole).unwrap_or_else(|_| json!({ "schema": part["schema"] }));
        if !(part["complete"] == false && part["why"].is_string()) {
            return Some(format!("not marked as incomplete: {own:.300}"));
        }
        let schema = schema(part["schema"].as_str().unwrap().split('/').nth(1).unwrap());
        let mut found = Vec::new();
        faults(&schema, &part, &schema, "", &mut found);
        return found.pop().or_else(|| new(&whole, &part, ""));
    }
    // A picture that was cut says so in the titles of its panels.
    if own.contains("<svg") {
        return (!own.contains("(incomplete: stopped at the work limit)")).then(|| format!("a picture that does not say so: {own:.300}"));
    }
    // Lines of the large budget, lines without a value, and the check that was cut.
    let known: Vec<&str> = whole.lines().collect();
    own.lines().find(|line| !(known.contains(line) || line.contains(",,") || is_cut(line))).map(str::to_owned)
}

fn is_cut(text: &str) -> bool {
    text.contains("work limit was reached")
}

/// Class "the budget changes an answer".
#[test]
fn a_small_budget_gives_the_same_answer_a_part_of_it_or_none() {
    let whole: Vec<Answer> = COMMANDS.iter().enumerate().map(|(index, command)| answer(command, 30.0, index)).collect();
    let (mut stream, mut cut) = (Stream::new(331), 0);
    for round in 0..cases(60, 1000) {
        let index = round % COMMANDS.len();
        let budget = 10f64.powf(stream.uniform(-6.0, 0.0));
        let own = answer(COMMANDS[index], budget, COMMANDS.len() + round);
        cut += u32::from(own.code == 1 && whole[index].code != 1);
        let fault = fault(&whole[index], &own);
        assert!(fault.is_none(), "{} --budget {budget:e}: {}", COMMANDS[index], fault.unwrap());
    }
    assert!(cut > cases(10, 40), "only {cut} were cut");
}

/// Class "an output is written before the budget is checked": the commands that printed `p(r) = 0`, `f = r^2/(2*R^0)` and `f'(r) = 0` and
/// overwrote files, and further members, at budgets down to a hundredth of what they printed these with.
#[test]
fn an_answer_is_complete_before_it_is_written() {
    for (index, (command, budget)) in [
        ("derive r^2/(2*R) --set R=2", 2e-4),
        ("derive r^2/(2*R) --set R=2 --json", 2e-4),
        ("derive r^2/(2*R) --set R=2 -o FILE.json", 2e-4),
        ("derive r^2/(2*R) --json", 0.01),
        ("derive r^2/(2*R) --steps", 2e-4),
        ("invert x^2/R", 3.36e-5),
        ("invert x*atan(x/R) --json", 1e-3),
        ("derive R-sqrt(R^2-r^2) -o FILE.tex", 2e-3),
        ("derive h*ln(1+r/w) --format typst", 2e-3),
    ]
    .into_iter()
    .enumerate()
    {
        let whole = answer(command, 30.0, 9000 + index);
        assert_eq!(whole.code, 0, "{command}");
        for share in [1.0, 0.5, 0.2, 0.1, 0.03, 0.01] {
            let own = answer(command, share * budget, 9000 + index);
            let fault = fault(&whole, &own);
            assert!(fault.is_none(), "{command} --budget {:e}: {}", share * budget, fault.unwrap());
        }
    }
}

/// Class "the clock decides": the process reads tables once that count towards no budget, and the answer of a small one depended on
/// the moment at which the clock looked.
#[test]
fn the_clock_changes_no_answer() {
    let program = || Command::new(env!("CARGO_BIN_EXE_sneddon"));
    for words in [
        ["invert", "x*atanh(x/R)", "5e-3"],
        ["invert", "h*ln(1+x^2/w^2)", "3e-3"],
        ["derive", "asinh(r^12)", "1e-3"],
        ["derive", "asinh(r^12)", "0.03"],
    ] {
        let [command, profile, budget] = words;
        let once = || {
            let done = program().args([command, profile, "--json", "--budget", budget]).output().unwrap();
            assert!(!String::from_utf8_lossy(&done.stderr).contains("processor time"), "{words:?}");
            (done.status.code(), done.stdout)
        };
        let first = once();
        assert!((0..cases(3, 20)).all(|_| once() == first), "{words:?}");
    }
}

/// Class "a check that was cut gives a false verdict": the comparison keeps its verdict where the search for a fault is cut short, and both
/// are missing where the comparison is.
#[test]
fn a_validation_that_was_cut_short_says_so() {
    let place = place(9200);
    let tips = ["r^2*(1+0.2*besselj(0,9*r)^2*exp(-r))", "asinh(r^5)+r^2", "r^2*struveh(0,r)+r^2"];
    fs::write(place.join("rows.csv"), "d,F\n0.05,0.01\n0.1,0.03\n0.2,0.08\n0.4,0.2\n").unwrap();
    for tip in tips.into_iter().take(cases(1, 3)) {
        fs::write(place.join("scene.toml"), format!("[profile]\nf = \"{tip}\"\n[material]\neffective_modulus = 1\n")).unwrap();
        let own = |budget: f64| {
            let own = answered(&["validate", "scene.toml", "rows.csv", "--json"], budget, &place);
            (own.code, serde_json::from_str::<Value>(&own.text).unwrap())
        };
        let (code, whole) = own(30.0);
        assert!(code == 1 && whole["passed"] == false && whole.get("complete").is_none(), "{tip}: {whole}");
        let (mut without_search, mut without_verdict) = (0, 0);
        for budget in [1e-6, 1e-4, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 1.1] {
            let (code, part) = own(budget);
            assert_eq!(code, 1, "{tip} {budget}");
            if part.get("complete").is_none() {
                assert_eq!(part, whole, "{tip} {budget}");
                continue;
            }
            assert!(part["complete"] == false && part["why"].is_string(), "{tip} {budget}: {part}");
            if part["columns"].is_null() {
                without_verdict += 1;
            } else {
                without_search += 1;
                assert!(part["suspicion"].is_null() && part["columns"] == whole["columns"] && part["reason"].is_string(), "{tip} {budget}");
            }
        }
        assert!(without_search > 0 && without_verdict > 0, "{tip}: {without_search}, {without_verdict}");
    }
}

/// Class "a budget that is not kept": the default grows with the input, and a budget on the command line does not.
#[test]
fn a_given_budget_does_not_grow_with_the_input() {
    let list = "eval sqrt(1+r^2)-1 --quantity g --at 0.1:9:20000 --json";
    assert_eq!(answer(list, 30.0, 9201).code, 0);
    let cut = answer(list, 1e-3, 9201);
    let document: Value = serde_json::from_str(&cut.text).unwrap();
    assert!(cut.code == 1 && document["complete"] == false, "{}", cut.text);
    let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).args(list.split(' ')).output().unwrap();
    assert_eq!(done.status.code(), Some(0));
}

/// Class "a measurement that was cut exits with 0".
#[test]
fn a_tradeoff_that_was_cut_short_says_so() {
    for words in [["tradeoff", "ln(cosh(r))"], ["tradeoff", "r^2/4"], ["tradeoff", "exp(sin(r))-1"]] {
        let run = |more: &[&str]| Command::new(env!("CARGO_BIN_EXE_sneddon")).args(words).args(more).output().unwrap();
        let done = run(&["--budget", "1e-5", "--json"]);
        let document: Value = serde_json::from_slice(&done.stdout).unwrap();
        assert!(done.status.code() == Some(1) && document["complete"] == false && document["why"].is_string(), "{words:?}: {document}");
        let text = String::from_utf8(run(&["--budget", "1e-5"]).stdout).unwrap();
        assert!(text.contains("Incomplete: "), "{text}");
    }
}

/// The same for random profiles, as people type them.
#[test]
fn a_small_budget_gives_no_other_answer_for_random_profiles() {
    let (mut stream, mut cut, mut valid) = (Stream::new(337), 0, 0);
    for round in 0..cases(12, 340) {
        let profile = profiles::sample(&mut stream);
        let place = place(2000 + round);
        let template = TEMPLATES[round % TEMPLATES.len()];
        let whole = answer_for(&profile, template, 10.0, &place);
        valid += u32::from(whole.code == 0);
        for _ in 0..3 {
            let budget = 10f64.powf(stream.uniform(-6.0, 0.0));
            let own = answer_for(&profile, template, budget, &place);
            cut += u32::from(own.code == 1 && whole.code != 1);
            let fault = fault(&whole, &own);
            assert!(fault.is_none(), "{template} of {profile:?} --budget {budget:e}: {}", fault.unwrap());
        }
    }
    assert!(cut > cases(3, 100) && valid > cases(3, 100), "{cut} of {valid} were cut");
}

/// Class "finished work is thrown away": a point outside the domain or beyond the budget has no value, and the others keep theirs.
#[test]
fn points_keep_their_values_where_others_have_none() {
    let list = answer("eval struveh(0,r)*r^2 --quantity p --at 0:0.99:200 --radius 1 --csv", 3.0, 9999);
    assert!(list.code == 0 && list.text.lines().count() == 201 && !list.text.contains(",,"), "{}", list.text);
    let all = |budget: f64| answer("eval struveh(0,r)*r^2 --quantity p --at 0:0.99:40 --radius 1 --csv", budget, 9999);
    let (whole, part) = (all(30.0), all(0.1));
    assert_eq!(whole.code, 0);
    assert_eq!(part.code, 1);
    let values = |own: &Answer| own.text.lines().skip(1).filter(|line| !line.contains(",,")).map(str::to_owned).collect::<Vec<_>>();
    let (all, some) = (values(&whole), values(&part));
    assert!(all.len() == 40 && some.len() >= 5 && some.len() < 40 && some.iter().all(|line| all.contains(line)), "{some:?}");
    // What is only told about all points, here whether g decreases below the largest radius, has a part of the budget left for the answer:
    // after the search for the radius of 1e4, which does not exist, nothing was written.
    let radii = answer("eval asinh(r^5) --quantity a --at 0.3,1,1e4 --json", 0.4, 9999);
    let radii: Value = serde_json::from_str(&radii.text).unwrap();
    let values: Vec<bool> = radii["points"].as_array().unwrap().iter().map(|own| own["value"].is_f64()).collect();
    assert_eq!(values, [true, true, false]);
    // A point outside the domain is null and does not affect the other points.
    let sphere = answer("eval R-sqrt(R^2-r^2) --set R=2 --quantity F --at 1,2,3 --json", 3.0, 9999);
    let points: Value = serde_json::from_str(&sphere.text).unwrap();
    assert_eq!(sphere.code, 0);
    assert!(points["points"][0]["value"].is_f64());
    for index in [1, 2] {
        let point = &points["points"][index];
        assert!(point["value"].is_null() && point["why"].as_str().unwrap().contains("ends at r = 2"), "{point}");
    }
}

/// The same for inverted profiles: radii beyond the end of the profile.
#[test]
fn inverted_profiles_keep_their_values_where_other_radii_have_none() {
    for (equivalent, list, values) in
        [("x^2/(1-x)", "0.5,2", [true, false]), ("tan(x)", "2,1", [false, true]), ("x*atanh(x/3)", "2.5,3.5", [true, false])]
    {
        let list = answer(&format!("invert {equivalent} --at {list} --json"), 3.0, 9999);
        let document: Value = serde_json::from_str(&list.text).unwrap();
        let points = document["points"].as_array().unwrap();
        assert_eq!(points.iter().map(|own| own["value"].is_f64()).collect::<Vec<_>>(), values, "{equivalent}: {document}");
        assert!(list.code == 0 && points.iter().all(|own| own["value"].is_f64() != own["why"].is_string()), "{equivalent}: {document}");
        // Without any value, the reason of the first point is the error.
        assert_eq!(answer(&format!("invert {equivalent} --at 7 --json"), 3.0, 9999).code, 2, "{equivalent}");
    }
}

/// Class "ordinary profiles are not refused": loads without a valid contact took so much work that pictures were cut, and so did the strain
/// energies that no picture of F, a and p shows.
#[test]
fn pictures_of_waves_and_of_falling_shapes_are_whole() {
    for command in [
        "plot h*sqrt(r/w)*exp(-r/w) --set h=1 --set w=1 --radius 0.6",
        "plot R*acosh(1+r/R) --set R=1 --radius 0.6",
        "plot r*exp(-r) --radius 0.9",
        "plot 1-besselj(0,3*r) --radius 1.2",
    ] {
        let picture = answer(command, 2.0, 9999);
        assert!(picture.code == 0 && !picture.text.contains("incomplete"), "{command}: {}", picture.text);
    }
}

/// Class "the check of an ordinary profile is cut short": powers over sums of higher powers, whose hypergeometric functions have a dozen
/// parameters that no double holds.
#[test]
fn checks_of_high_powers_in_denominators_are_whole() {
    for profile in ["r^6/(1+(r^6)^2)", "r^10/((r^6/1.679)^2+2)", "r^4*3/(1+(3*r^4)^2)"].into_iter().step_by(cases(3, 1)) {
        let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).args(["derive", profile, "--json"]).output().unwrap();
        let document: Value = serde_json::from_slice(&done.stdout).unwrap();
        assert_eq!(document["check"]["verdict"], "passed", "{profile}: {}", document["check"]);
    }
}

/// Class "the clock stops real commands": large sums and powers are whole within the default budget.
#[test]
fn large_profiles_are_whole() {
    let kinks = |n: usize| (1..=n).map(|i| format!("max(0,r-{i})")).collect::<Vec<_>>().join("+");
    for words in [
        vec!["derive", "max(0,r-b)^160", "--json"],
        vec!["derive", &kinks(150), "--json"],
        vec!["eval", &kinks(419), "--quantity", "p", "--radius", "400", "--at", "10.5:390.5:20", "--json"],
        // A single g next to the axis takes up to a second. Bounds on f′ prove that none of these contact radii lies there.
        vec![
            "eval",
            "(exp(r/w)-1-r/w)/(3+(2*(4-sqrt(16-r^2)))^2)*(0.6*r^0.5)",
            "--set",
            "w=0.4",
            "--quantity",
            "a",
            "--at",
            "0.3,30,1e-9",
            "--json",
            "--budget",
            "1",
        ],
        // Every point is a kink, where the infinite pressure has the sign of the jump of f′.
        vec!["eval", &kinks(419), "--quantity", "p", "--radius", "400", "--at", "10:390:20", "--json"],
    ] {
        let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).args(&words).output().unwrap();
        let document: Value = serde_json::from_slice(&done.stdout).unwrap();
        assert!(done.status.success() && document.get("complete").is_none(), "{:.40}: {:?}", words[1], document["why"]);
        let infinite = |point: &Value| point["why"].as_str().is_some_and(|why| why.contains("infinite at a kink"));
        let points = document["points"].as_array().into_iter().flatten();
        assert!(points.clone().all(|own| own["value"].is_number() || infinite(own)), "{:.40}: {document}", words[1]);
    }
    // A truncated cone, a worn sphere and a cone with a cap on a grid of 128 points along each side.
    let place = place(9300);
    for (name, shape) in [
        ("cone", "shape = \"truncated-cone\"\nparameters = { b = \"1 um\", theta = \"12 deg\" }"),
        ("sphere", "shape = \"worn-sphere\"\nparameters = { b = \"1 um\", R = \"10 um\" }"),
        ("cap", "shape = \"cone-with-parabolic-cap\"\nparameters = { b = \"0.2 um\", theta = \"12 deg\" }"),
    ]
    .into_iter()
    .take(cases(1, 3))
    {
        let scene = format!(
            "[profile]\n{shape}\n[material]\nE = \"72 GPa\"\nnu = 0.17\n[load]\ncontact_radius = \"1.9 um\"\n[outputs]\nquantities = [\"p\"]\n\
             units = {{ length = \"um\", force = \"mN\", pressure = \"GPa\" }}\n[data]\nbox = \"8 um\"\n"
        );
        fs::write(place.join("scene.toml"), scene).unwrap();
        let run = |words: &[&str]| Command::new(env!("CARGO_BIN_EXE_sneddon")).args(words).current_dir(&place).output().unwrap();
        for more in [&[][..], &["--cells"]] {
            let made = run(&[&["reference", "scene.toml", "--grid", "128", "-o", "p.csv"], more].concat());
            assert_eq!(made.status.code(), Some(0), "{name}: {}", String::from_utf8_lossy(&made.stderr));
            let done = run(&[&["validate", "scene.toml", "p.csv", "--json"], more].concat());
            let document: Value = serde_json::from_slice(&done.stdout).unwrap();
            assert!(done.status.success() && document["passed"] == true && document.get("complete").is_none(), "{name}: {document}");
        }
    }
}

/// Class "a long list of expensive pressures is cut": one expansion computes all of them whatever the budget is, and its values agree with
/// the proven values of single points. A short list does not use it.
#[test]
fn many_expensive_pressures_come_from_one_expansion() {
    for profile in ["r^2*(1+0.2*besselj(0,9*r)^2*exp(-r))", "besselj(0,r)^2*r"].into_iter().take(cases(1, 2)) {
        let list = |places: &str, budget: f64| {
            let own = answer(&format!("eval {profile} --quantity p --at {places} --radius 0.6 --json"), budget, 9998);
            assert_eq!(own.code, 0, "{profile} {places}: {}", own.text);
            serde_json::from_str::<Value>(&own.text).unwrap()["points"].as_array().unwrap().clone()
        };
        let many = list("0:0.57:201", 30.0);
        assert_eq!(many, list("0:0.57:201", 1.5), "{profile}");
        assert!(many.iter().skip(1).all(|own| own["method"] == "curve" && own["bound"] == "estimated"), "{profile}: {many:#?}");
        for (alone, index) in [("0.057", 20), ("0.285", 100), ("0.57", 200)] {
            let one = &list(alone, 30.0)[0];
            assert!(one["bound"] == "proven", "{profile}: {one}");
            let [own, exact] = [&many[index], one].map(|own| ["value", "error_estimate"].map(|key| own[key].as_f64().unwrap()));
            assert!((own[0] - exact[0]).abs() <= own[1] + exact[1] && own[1] < 1e-12 * own[0], "{profile}: {} {one}", many[index]);
        }
        assert!(list("0:0.57:5", 30.0).iter().all(|own| own["method"] != "curve"), "{profile}");
    }
}

/// Class "a scene that was cut short exits with 0".
#[test]
fn a_scene_that_was_cut_short_says_so() {
    let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("budgets").join("scene");
    fs::create_dir_all(&place).unwrap();
    let scene = |method: &str| {
        format!(
            "[profile]\nf = \"r^2*(1+0.2*besselj(0,9*r)^2*exp(-r))\"\n[material]\neffective_modulus = 1\n[load]\ndepth = [0.4, 0.5]\n\
             [outputs]\nquantities = [\"p\"]\nat = {{ start = 0, stop = 0.4, count = 40 }}\n[method]\nname = \"{method}\"\n"
        )
    };
    let solved = |method: &str, more: &[&str]| {
        fs::write(place.join("scene.toml"), scene(method)).unwrap();
        let program = env!("CARGO_BIN_EXE_sneddon");
        let done = Command::new(program).args(["solve", "scene.toml"]).args(more).current_dir(&place).output().unwrap();
        (done.status.code().unwrap(), String::from_utf8(done.stdout).unwrap(), String::from_utf8(done.stderr).unwrap())
    };
    let (code, text, told) = solved("quadrature", &["--json", "--budget", "0.9"]);
    let document: Value = serde_json::from_str(&text).unwrap();
    assert!(code == 1 && document["complete"] == false && told.contains("some numbers are missing: stopped at the work limit"), "{told}");
    // Within the same budget the expansion answers every pressure.
    let (code, text, told) = solved("auto", &["--json", "--budget", "0.9"]);
    let document: Value = serde_json::from_str(&text).unwrap();
    let points = |index: usize| document["curves"][index]["points"].as_array().unwrap();
    assert!(code == 0 && [0, 1].iter().all(|index| points(*index).iter().all(|own| own["value"].is_f64())), "{told}");
    // The verdict on a row that was cut is not "not valid": it is missing. The budget lies between those for nothing and for everything.
    let scene =
        "[profile]\nf = \"r^6+r^9\"\n[material]\neffective_modulus = 1\n[load]\ndepth = [0.05, 0.4]\n[method]\nname = \"quadrature\"\n";
    fs::write(place.join("scene.toml"), scene).unwrap();
    let asked = |words: &[&str], budget: f64| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sneddon"));
        let done = command.args(words).args(["--json", "--budget", &format!("{budget:e}")]).current_dir(&place).output().unwrap();
        (done.status.code(), serde_json::from_slice::<Value>(&done.stdout).unwrap())
    };
    let partial = |words: &[&str], list: &str| {
        let (mut nothing, mut everything) = (1e-6, 3.0_f64);
        for _ in 0..60 {
            let budget = (nothing * everything).sqrt();
            let (code, document) = asked(words, budget);
            match (code, document[list].is_array()) {
                (Some(0), _) => everything = budget,
                (_, false) => nothing = budget,
                _ => return document,
            }
        }
        panic!("no budget cuts {words:?}")
    };
    let document = partial(&["solve", "scene.toml"], "rows");
    assert!(document["complete"] == false && document["validity"]["valid"].is_null(), "{document}");
    let is_open = |row: &Value| row["valid"].is_null() && row["verdict"].is_null() && row["why"].is_string();
    assert!(document["rows"].as_array().unwrap().iter().all(|row| row["valid"] == true || is_open(row)), "{document}");
    let document = partial(&["reference", "scene.toml", "--grid", "0:1:40"], "loads");
    assert!(document["complete"] == false && document["why"].is_string(), "{document}");
}

/// Class "finished work is thrown away": rows that were solved are kept where the budget does not suffice for later rows, for an energy or
/// for an error. Energies under a dozen kinks take nearly all of the work.
#[test]
fn rows_keep_their_values_where_others_have_none() {
    let place = place(9400);
    let kinks = (1..=12).map(|i| format!("+max(0,r-0.{i:02})^2")).collect::<String>();
    let scene = format!(
        "[profile]\nf = \"r^2{kinks}\"\n[material]\neffective_modulus = 1\n[load]\ndepth = {{ start = 0.01, stop = 1, count = 20 }}\n\
         [outputs]\nquantities = [\"d\", \"F\", \"a\", \"U\"]\n"
    );
    fs::write(place.join("scene.toml"), scene).unwrap();
    let asked = |budget: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sneddon"));
        let done = command.args(["solve", "scene.toml", "--json", "--budget", budget]).current_dir(&place).output().unwrap();
        (done.status.code(), serde_json::from_slice::<Value>(&done.stdout).unwrap())
    };
    let rows = |own: &Value| own["rows"].as_array().unwrap().clone();
    let (code, whole) = asked("5");
    assert!(code == Some(0) && rows(&whole).iter().all(|row| row["U"].is_f64()), "{whole}");
    let (code, part) = asked("0.05");
    assert!(code == Some(1) && part["complete"] == false && part["why"].is_string(), "{part}");
    let (mut energies, mut missing) = (0, 0);
    for (all, some) in rows(&whole).iter().zip(rows(&part)) {
        for quantity in ["F", "a", "U"] {
            assert!(some[quantity].is_null() || some[quantity] == all[quantity], "{quantity}: {some} instead of {all}");
        }
        energies += usize::from(some["U"].is_f64());
        missing += usize::from(some["U"].is_null());
    }
    assert!(energies > 0 && missing > 0, "{energies} energies, {missing} missing");
}

/// Class "one number without a value takes the row with it": an energy beyond the range of doubles leaves F and a.
#[test]
fn rows_keep_their_values_where_one_number_has_none() {
    let place = place(9450);
    let scene = "[profile]\nf = \"0.6*r\"\n[material]\neffective_modulus = 1\n[load]\ndepth = [1e-3, 1e110]\n\
                 [outputs]\nquantities = [\"F\", \"U\", \"a\"]\n";
    fs::write(place.join("scene.toml"), scene).unwrap();
    let done = Command::new(env!("CARGO_BIN_EXE_sneddon")).args(["solve", "scene.toml", "--json"]).current_dir(&place).output().unwrap();
    let document: Value = serde_json::from_slice(&done.stdout).unwrap();
    let row = &document["rows"][1];
    // F = 2 d²/(0.3 π)·E* and a = 2 d/(0.6 π) with E* = 1.
    let near = |key: &str, truth: f64| (row[key].as_f64().unwrap() / truth - 1.0).abs() < 1e-14;
    assert!(near("F", 1e220 / (0.3 * std::f64::consts::PI)) && near("a", 1e110 / (0.3 * std::f64::consts::PI)), "{row}");
    assert!(row["U"].is_null() && row["findings"].to_string().contains("U: the value at a ="), "{row}");
}

/// Class "finished work is thrown away": pressures under 400 kinks, after which the program still prepared the formula.
#[test]
fn pressures_under_many_kinks_are_kept() {
    let profile = (1..400).map(|i| format!("max(0,r-{i}/400)")).collect::<Vec<_>>().join("+");
    let list = |budget: f64| {
        let own = answer(&format!("eval {profile} --quantity p --at 0.0003:0.9931:501 --radius 1 --csv"), budget, 9460);
        (own.code, own.text.lines().skip(1).map(str::to_owned).collect::<Vec<_>>())
    };
    let ((code, whole), (cut, part)) = (list(5.0), list(0.4));
    assert!(code == 0 && cut == 1 && part.len() == 501, "{code}, {cut}, {} rows", part.len());
    let values: Vec<_> = part.iter().zip(&whole).filter(|(own, _)| !own.contains(",,")).collect();
    assert!(values.len() > 20 && values.len() < 500 && values.iter().all(|(own, all)| own == all), "{} values", values.len());
}

/// Class "a cut check exits with 0": a page of a scene whose formulas could not be compared within the budget.
#[test]
fn a_page_whose_check_was_cut_says_so() {
    let place = place(9500);
    let scene = "[profile]\nf = \"C*r^n\"\nparameters = { C = 1.2, n = 1.7 }\n[material]\neffective_modulus = 1\n[load]\ndepth = 0.1\n";
    fs::write(place.join("scene.toml"), scene).unwrap();
    let asked = |budget: f64| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sneddon"));
        command.args(["solve", "scene.toml", "-o", "page.html", "--budget", &format!("{budget:e}")]).current_dir(&place);
        let done = command.output().unwrap();
        let page = fs::read_to_string(place.join("page.html")).unwrap_or_default();
        (done.status.code(), page.contains("the work limit was reached"))
    };
    let answers: Vec<_> = (0..28).map(|step| asked(1e-3 * 1.25_f64.powi(step))).collect();
    assert!(answers.last() == Some(&(Some(0), false)), "{answers:?}");
    assert!(answers.iter().any(|(_, is_cut)| *is_cut), "{answers:?}");
    assert!(answers.iter().all(|(code, is_cut)| !(*code == Some(0) && *is_cut)), "{answers:?}");
}
