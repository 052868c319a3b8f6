//! What the fuzz targets do with their bytes: plain functions, called by cargo-fuzz and by the loop in `tests/fuzz/fuzz.rs`.
//!
//! Each panics where a promise is broken; time and memory are watched by the caller.

use sneddon::contact::{Contact, ContactError, Edge, Measured, relations};
use sneddon::expr::{Bindings, Expr, Formula};
use sneddon::num::work::{Budget, Exhausted, is_exhausted, within};
use sneddon::scene::{Change, Run, Scene, decoded, scene, scene_for_data};
use sneddon::transform::{self, Evaluator, InverseNumbers, Method, Profile, Reading, TransformError};
use sneddon::validate::{Request, Source, validate};
use sneddon::{parse, print};
use std::io::{Cursor, Read};

/// A target: its name and what it does.
pub(crate) type Target = (&'static str, fn(&[u8]));

/// Every target by name; the seeds of each lie in `seeds/NAME`.
pub(crate) const TARGETS: [Target; 7] = [
    ("parse", parse),
    ("derive", derive),
    ("evaluate", evaluate),
    ("scene", solve),
    ("tip", tip),
    ("validate", compare),
    ("invert", invert),
];

/// The work that one execution may take, as a command of the program has it.
const BUDGET: Budget = Budget::steps(150_000_000);

/// Runs one execution within its budget; what is found beyond it is no answer.
fn within_budget(work: impl FnOnce()) {
    let _: Result<(), Exhausted> = within(BUDGET, || {
        work();
        Ok(())
    });
}

/// Every entry of the grammar; what one of them reads is printed, and what is printed reads back to the same print.
pub(crate) fn parse(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let read = [parse::profile(&text), parse::equivalent(&text), parse::formula(&text)];
    for error in read.iter().filter_map(|read| read.as_ref().err()) {
        let span = error.span();
        assert!(text.get(span.clone()).is_some(), "the place {span:?} of an error cuts a character or lies outside");
        assert!(!error.to_string().is_empty());
    }
    drop((parse::pressure(&text), parse::constant(&text)));
    if let [_, _, Ok(formula)] = &read {
        reads_back(formula);
    }
}

/// A profile, its formulas, and the formulas read again.
pub(crate) fn derive(data: &[u8]) {
    within_budget(|| formulas_of(data));
}

fn formulas_of(data: &[u8]) {
    let Some(profile) = profile(data) else { return };
    let Ok(solution) = transform::derive(&profile) else { return };
    reads_back(&solution.equivalent_profile().formula);
    reads_back(&solution.force().formula);
    if let Some(pressure) = solution.pressure() {
        reads_back(&pressure.formula);
    }
    drop(relations(&solution, &Edge::Smooth));
}

/// g, F, p, u and the radius of a depth, with the parameters at 1.25, 1.5, …
pub(crate) fn evaluate(data: &[u8]) {
    within_budget(|| numbers_of(data));
}

fn numbers_of(data: &[u8]) {
    let Some(profile) = profile(data) else { return };
    let values: Bindings = profile.parameters().iter().enumerate().map(|(i, name)| (name.name(), Expr::ratio(5 + i as i64, 4))).collect();
    let Ok(profile) = profile.substitute(&values) else { return };
    let Ok(solution) = transform::derive(&profile) else { return };
    let Ok(evaluator) = Evaluator::new(&solution, &Bindings::default(), Method::Auto, 1e-12) else { return };
    let contact = Contact::new(evaluator, 1.0, None, 1e-12);
    let a = 0.75;
    sound(contact.evaluator().equivalent(a));
    sound(contact.evaluator().height(0.5));
    honest(contact.force(a));
    measured(contact.pressure(0.25, a));
    honest(contact.displacement(1.5, a));
    honest(contact.contact_radius(0.125));
}

/// A scene file, and its first row.
pub(crate) fn solve(data: &[u8]) {
    within_budget(|| scene_file_of(data));
}

fn scene_file_of(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    match scene(text) {
        Err(error) => assert!(error.span().is_none_or(|span| text.get(span).is_some()), "the place of {error} lies outside"),
        Ok(scene) => first_row(&scene),
    }
}

/// The points of a measured tip.
pub(crate) fn tip(data: &[u8]) {
    within_budget(|| points_of(data));
}

fn points_of(data: &[u8]) {
    const SCENE: &str = "[profile]\npoints = \"tip.csv\"\nunits = { r = \"nm\", z = \"nm\" }\n[material]\nE = \"1 GPa\"\nnu = 0.3\n[load]\ndepth = \"0.3 nm\"\n[outputs]\nquantities = [\"F\", \"a\"]\n";
    const PLAIN: &str =
        "[profile]\npoints = \"tip.csv\"\n[material]\neffective_modulus = 1\n[load]\ndepth = 0.3\n[outputs]\nquantities = [\"F\"]\n";
    const SCAN: &str = "[profile]\npoints = \"tip.csv\"\nline_scan = true\ninterpolation = \"smoothing-spline\"\n[material]\neffective_modulus = 1\n[load]\ndepth = 0.3\n[outputs]\nquantities = [\"F\"]\n";
    let text = decoded(data.to_vec());
    for known in [SCENE, PLAIN, SCAN] {
        let Ok(scene) = scene(known) else { continue };
        if let Ok(scene) = scene.with_points(&text) {
            first_row(&scene);
        }
    }
}

/// A solver's data beside a sphere.
pub(crate) fn compare(data: &[u8]) {
    within_budget(|| data_of(data));
}

fn data_of(data: &[u8]) {
    const SCENE: &str = "[profile]\nf = \"r^2/(2*R)\"\nparameters = { R = 10 }\n[material]\neffective_modulus = 1\n[load]\ndepth = 0.1\n[outputs]\nquantities = [\"F\", \"a\"]\n";
    let Ok(scene) = scene_for_data(SCENE, &Change::None) else { panic!("the scene of this target is not read") };
    let open = || Ok(Box::new(Cursor::new(data.to_vec())) as Box<dyn Read>);
    let sources = [Source { name: "data.csv".to_owned(), open: Box::new(open) }];
    drop(validate(&Request {
        text: SCENE,
        scene: &scene,
        sources: &sources,
        tolerance: None,
        grid: &[],
        layout: &sneddon::validate::Layout::default(),
    }));
}

/// An equivalent profile, its shape, and a number of it.
pub(crate) fn invert(data: &[u8]) {
    within_budget(|| inverse_of(data));
}

fn inverse_of(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let Ok(equivalent) = parse::equivalent(&text) else { return };
    let Ok(inverse) = transform::invert(&equivalent, |text| parse::formula(text).ok()) else { return };
    reads_back(&inverse.profile().formula);
    let values: Bindings = equivalent
        .symbols()
        .iter()
        .filter(|name| name.name() != "x")
        .enumerate()
        .map(|(i, name)| (name.name(), Expr::ratio(5 + i as i64, 4)))
        .collect();
    if let Ok(numbers) = InverseNumbers::new(&inverse, &values, Method::Auto, 1e-12) {
        sound(numbers.value(0.5));
    }
}

fn profile(data: &[u8]) -> Option<Profile> {
    Profile::new(&parse::profile(&String::from_utf8_lossy(data)).ok()?).ok()
}

/// Only the first row: a file may ask for many.
fn first_row(scene: &Scene) {
    let Ok(solution) = transform::derive(&scene.profile) else { return };
    let Ok(run) = Run::new(scene, &solution) else { return };
    let Some(row) = run.row(0) else { return };
    for (datum, value) in &row.values {
        assert!(value.is_none_or_finite(), "{datum:?} is {value:?}");
    }
}

trait Answer {
    fn is_none_or_finite(&self) -> bool;
}

impl Answer for Result<f64, &'static str> {
    fn is_none_or_finite(&self) -> bool {
        self.is_ok_and(f64::is_finite) || self.is_err()
    }
}

/// What was printed reads back, and prints the same again.
fn reads_back(formula: &Formula) {
    let text = print::text(formula);
    if text.len() > parse::limits::TEXT_BYTES {
        return;
    }
    let again = parse::formula(&text);
    // What is built beyond the budget means nothing.
    if is_exhausted() {
        return;
    }
    match again {
        Ok(again) => {
            let second = print::text(&again);
            assert!(second == text || is_exhausted(), "{text}: a printed formula is printed as {second} after it was read");
        }
        // A formula may nest deeper than a text may, and this is said.
        Err(error) => assert!(is_limit(&error), "{text} does not read back: {error}"),
    }
    drop(print::latex(formula));
}

fn is_limit(error: &parse::ParseError) -> bool {
    let text = error.to_string();
    ["deep", "nest", "long", "large", "digits", "exponent", "many"].iter().any(|word| text.contains(word))
}

fn sound(reading: Result<Reading, TransformError>) {
    if let Ok(reading) = reading {
        number(reading);
    }
}

fn honest(reading: Result<Reading, ContactError>) {
    if let Ok(reading) = reading {
        number(reading);
    }
}

fn measured(reading: Result<Measured, ContactError>) {
    if let Ok(Ok(reading)) = reading {
        number(reading);
    }
}

fn number(reading: Reading) {
    let (value, error) = (reading.estimate.value, reading.estimate.error);
    assert!(is_exhausted() || (value.is_finite() && error >= 0.0), "an answer is {value} ± {error}");
}
