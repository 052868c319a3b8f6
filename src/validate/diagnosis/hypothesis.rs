//! Common mistakes: each entry is a change of the scene or of the data that corrects the mistake.

use crate::expr::{Expr, Formula, Node, Symbol};
use crate::scene::{Change, Scene};
use crate::validate::file::row::Row;
use std::f64::consts::PI;

/// The problem that the solver may have solved instead of the scene.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::validate) enum SolvedProblem {
    /// The scene itself.
    AsIs,
    /// The scene with one changed value.
    Changed(Change),
    /// The scene with E* multiplied by a number.
    Modulus(f64),
    /// The osculating paraboloid instead of f.
    Parabola,
}

/// Mistakes in the data: factors by which the true values of the columns were multiplied.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::validate) struct ColumnMistake {
    pub(in crate::validate) depth: f64,
    pub(in crate::validate) force: f64,
    pub(in crate::validate) radius: f64,
    pub(in crate::validate) distance: f64,
    pub(in crate::validate) pressure: f64,
    /// Numbers of rows by which forces and radii, or forces alone, are ahead of the depths.
    pub(in crate::validate) ahead: i32,
    pub(in crate::validate) force_ahead: i32,
    /// Columns with exchanged names.
    pub(in crate::validate) columns: Exchange,
}

/// The exchange of column names.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::validate) enum Exchange {
    Nothing,
    DepthAndForce,
    DepthAndRadius,
    ForceAndRadius,
    /// d contains F, F contains a, and a contains d.
    Forwards,
    /// d contains a, F contains d, and a contains F.
    Backwards,
    DistanceAndPressure,
}

impl Exchange {
    /// Returns the row with corrected names; `None` if a column is missing. `factors` converts the columns to computing units.
    pub(in crate::validate) fn exchanged(self, row: &Row, factors: &Row) -> Option<Row> {
        let (d, f, a) = (row.depth / factors.depth, row.force / factors.force, row.radius / factors.radius);
        let (depth, force, radius) = match self {
            Self::Nothing | Self::DistanceAndPressure => return Some(*row),
            Self::DepthAndForce => (f, d, a),
            Self::DepthAndRadius => (a, f, d),
            Self::ForceAndRadius => (d, a, f),
            Self::Forwards => (a, d, f),
            Self::Backwards => (f, a, d),
        };
        let own = Row { depth: depth * factors.depth, force: force * factors.force, radius: radius * factors.radius };
        let same = |one: f64, other: f64| one.is_nan() == other.is_nan();
        (same(own.depth, row.depth) && same(own.force, row.force) && same(own.radius, row.radius)).then_some(own)
    }
}

impl ColumnMistake {
    pub(in crate::validate) const NONE: Self =
        Self { depth: 1.0, force: 1.0, radius: 1.0, distance: 1.0, pressure: 1.0, ahead: 0, force_ahead: 0, columns: Exchange::Nothing };
}

/// A common mistake: the problem that the solver solved instead, and what is wrong in its data.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::validate) struct Fault {
    pub(in crate::validate) id: &'static str,
    pub(in crate::validate) text: String,
    pub(in crate::validate) taken: SolvedProblem,
    pub(in crate::validate) slip: ColumnMistake,
}

/// Creates a fault without a fitted number.
fn taken(id: &'static str, text: impl Into<String>, taken: SolvedProblem) -> Fault {
    Fault { id, text: text.into(), taken, slip: ColumnMistake::NONE }
}

fn slip(id: &'static str, text: impl Into<String>, slip: ColumnMistake) -> Fault {
    Fault { id, text: text.into(), taken: SolvedProblem::AsIs, slip }
}

/// Returns the faults of a model: another modulus or another shape.
pub(in crate::validate) fn of_the_model(scene: &Scene, without_poisson: Option<f64>) -> Vec<Fault> {
    let mut list = Vec::new();
    if let Some(young) = without_poisson.filter(|own| (own / scene.effective_modulus - 1.0).abs() > 1e-6) {
        let factor = young / scene.effective_modulus;
        list.push(taken(
            "modulus",
            format!("E used as E*: the data fit Young's modulus E = {factor:.4} E* instead of E* = E/(1 - nu^2)"),
            SolvedProblem::Modulus(factor),
        ));
        let text = "E* used as E: the data fit E*/(1 - nu^2), so E was divided by 1 - nu^2 twice";
        list.push(taken("modulus", text, SolvedProblem::Modulus(1.0 / factor)));
    }
    let rim = scene.rim.is_some().then(|| "radius".to_owned());
    for name in scene.parameters.iter().map(|own| own.0.clone()).chain(rim) {
        for (size, ratio) in [("twice", (2, 1)), ("half", (1, 2))] {
            let change = SolvedProblem::Changed(Change::Times { name: name.clone(), ratio });
            let fits = format!("the data fit {size} the {name} of the scene");
            list.push(if is_angle(scene, &name) {
                taken("angle", format!("opening angle and half-opening angle confused: {fits}"), change)
            } else {
                taken("diameter", format!("diameter and radius confused: {fits}, so {name} may be a diameter"), change)
            });
        }
        list.push(taken(
            "angle",
            format!("half-opening angle and surface angle confused: the data fit 90 degrees minus the {name} of the scene"),
            SolvedProblem::Changed(Change::Complement { name: name.clone() }),
        ));
        for (degrees, text) in [(1, "radians were read as degrees or degrees as radians"), (-1, "degrees were read as radians")] {
            let turn = SolvedProblem::Changed(Change::Turn { name: name.clone(), degrees });
            list.push(taken("unit", format!("unit slip: {text} in {name}"), turn));
        }
    }
    for (factor, text) in [
        (0.5, "the data fit half of E*, as for two equal elastic bodies, or for a factor of 1/2 instead of 1 in E*"),
        (2.0, "the data fit twice E*"),
    ] {
        list.push(taken("modulus", text, SolvedProblem::Modulus(factor)));
    }
    list.push(taken(
        "profile",
        "paraboloid instead of the profile: the data fit the osculating paraboloid, not f itself",
        SolvedProblem::Parabola,
    ));
    list
}

/// Returns true for a parameter in the argument of a sine, cosine or tangent.
fn is_angle(scene: &Scene, name: &str) -> bool {
    let symbol = Symbol::new(name);
    let turns = |own: &Expr| match own.node() {
        Node::Function(function, arguments) => {
            matches!(function.name(), "sin" | "cos" | "tan")
                && arguments.iter().any(|own| own.contains(&symbol) && !own.contains(&Symbol::new("r")))
        }
        _ => false,
    };
    scene.symbolic.iter().flat_map(Formula::expressions).flat_map(Expr::parts).any(turns)
}

/// Returns powers of ten that may be lost in a unit conversion, those between prefixes of units first.
fn tens() -> impl Iterator<Item = (i32, f64)> {
    let powers = |is_prefix: bool| (-12..=12).filter(move |power| *power != 0 && (power % 3 == 0) == is_prefix);
    powers(true).chain(powers(false)).map(|power| (power, 10f64.powi(power)))
}

/// The symbols of the columns, how they are named in a sentence, and their units, which may be empty.
pub(in crate::validate) type Columns = Vec<(&'static str, &'static str, String)>;

/// Prefixes of units, with their powers of ten.
const PREFIXES: [(&str, i32); 8] = [("p", -12), ("n", -9), ("u", -6), ("m", -3), ("", 0), ("k", 3), ("M", 6), ("G", 9)];

/// Divides a unit by a power of ten: `smaller("mm", 3)` is um. Returns `None` if no prefix exists for the result.
fn smaller(unit: &str, power: i32) -> Option<String> {
    let base = ["Pa", "N", "m"].into_iter().find(|base| unit.ends_with(base))?;
    let prefix = unit.strip_suffix(base)?;
    let own = PREFIXES.iter().find(|own| own.0 == prefix)?.1;
    PREFIXES.iter().find(|known| known.1 == own - power).map(|(prefix, _)| format!("{prefix}{base}"))
}

/// Creates the fault of numbers that are too large or too small by a power of ten, with the unit that they have instead of their own.
fn power_of_ten(symbols: &[&str], columns: &Columns, (power, factor): (i32, f64), of: fn(f64) -> ColumnMistake) -> Fault {
    let known = |symbol: &&str| columns.iter().find(|own| own.0 == *symbol);
    let names: Vec<&str> = symbols.iter().map(|symbol| known(symbol).map_or(*symbol, |own| own.1)).collect();
    let are = if names.len() > 1 { "are" } else { "is" };
    let size = if power > 0 { "large" } else { "small" };
    let unit = symbols.first().and_then(known).map_or("", |own| own.2.as_str());
    let meant = smaller(unit, power).map_or_else(String::new, |own| format!(": the numbers are in {own}, but were read as {unit}"));
    let text = format!("unit slip: {} {are} 10^{} times too {size}{meant}", names.join(" and "), power.abs());
    slip("unit", text, of(factor))
}

/// Creates the faults of numbers that are too large or too small by the ratio of two units.
fn ratio_of_units(symbol: &str, (factor, names): (f64, &str), of: fn(f64) -> ColumnMistake) -> [Fault; 2] {
    [("large", factor), ("small", 1.0 / factor)]
        .map(|(size, own)| slip("unit", format!("unit slip: {symbol} is {factor} times too {size}, the ratio of {names}"), of(own)))
}

/// Factors of a force or a pressure for common mistakes.
const FACTORS: [(&str, f64, &str); 10] = [
    ("sign", -1.0, "tension and compression confused: the sign of"),
    ("model", 0.5, "half model: half of"),
    ("model", 2.0, "half model doubled twice: twice"),
    ("model", 0.25, "quarter model: a quarter of"),
    ("model", 4.0, "quarter model multiplied twice: 4 times"),
    ("pi", PI, "a missing pi: pi times"),
    ("pi", 1.0 / PI, "a missing pi: 1/pi times"),
    ("pi", 2.0 * PI, "a missing 2 pi: 2 pi times"),
    ("pi", 0.5 / PI, "a missing 2 pi, as for a force per radian: 1/(2 pi) times"),
    ("pi", 1.0 / (PI * PI), "a missing pi^2: 1/pi^2 times"),
];

/// Returns the faults of files with loads.
pub(in crate::validate) fn of_loads(columns: &Columns) -> Vec<Fault> {
    let mut list = Vec::new();
    let none = ColumnMistake::NONE;
    for (id, force, text) in FACTORS {
        let what = if id == "sign" { "F is reversed" } else { "the exact force is in column F" };
        list.push(slip(id, format!("{text} {what}"), ColumnMistake { force, ..none }));
    }
    list.push(slip(
        "sign",
        "tension and compression confused: depths and forces have the opposite sign",
        ColumnMistake { force: -1.0, depth: -1.0, ..none },
    ));
    list.push(slip("sign", "the depths have the opposite sign", ColumnMistake { depth: -1.0, ..none }));
    for ten in tens() {
        list.push(power_of_ten(&["F"], columns, ten, |force| ColumnMistake { force, ..ColumnMistake::NONE }));
        list.push(power_of_ten(&["d"], columns, ten, |depth| ColumnMistake { depth, ..ColumnMistake::NONE }));
        list.push(power_of_ten(&["a"], columns, ten, |radius| ColumnMistake { radius, ..ColumnMistake::NONE }));
        list.push(power_of_ten(&["d", "a"], columns, ten, |own| ColumnMistake { depth: own, radius: own, ..ColumnMistake::NONE }));
    }
    for units in [(9.806_65, "kgf and N"), (4.448_221_615_260_5, "lbf and N")] {
        list.extend(ratio_of_units("F", units, |force| ColumnMistake { force, ..ColumnMistake::NONE }));
    }
    for (depth, text) in [(2.0, "column d contains twice the depth"), (0.5, "column d contains half of the depth")] {
        list.push(slip(
            "reference",
            format!("another reference for depth: {text}, as for one of two equal bodies"),
            ColumnMistake { depth, ..none },
        ));
    }
    for (id, radius, text) in [
        ("diameter", 2.0, "diameter and radius confused: column a contains the diameter of the contact"),
        ("diameter", 0.5, "diameter and radius confused: column a contains half of the contact radius"),
        ("pi", PI.sqrt(), "a missing pi: column a contains the square root of the contact area"),
        ("pi", 1.0 / PI.sqrt(), "a missing pi: column a contains a/sqrt(pi)"),
    ] {
        list.push(slip(id, text, ColumnMistake { radius, ..none }));
    }
    for (columns, text) in [
        (Exchange::DepthAndForce, "d contains the forces and F the depths"),
        (Exchange::DepthAndRadius, "d contains the contact radii and a the depths"),
        (Exchange::ForceAndRadius, "F contains the contact radii and a the forces"),
        (Exchange::Forwards, "d contains the forces, F the contact radii and a the depths"),
        (Exchange::Backwards, "d contains the contact radii, F the depths and a the forces"),
    ] {
        list.push(slip("swapped-columns", format!("swapped columns: {text}"), ColumnMistake { columns, ..none }));
    }
    for (ahead, text) in [(1, "next"), (-1, "previous")] {
        let what = "another load level: F and a belong to the depth of the";
        list.push(slip("level", format!("{what} {text} row"), ColumnMistake { ahead, ..none }));
        list.push(slip(
            "level",
            format!("another load level: F belongs to the depth of the {text} row"),
            ColumnMistake { force_ahead: ahead, ..none },
        ));
    }
    list
}

/// Returns the faults of files with pressures; the pixel is optional, and `factors` converts the columns r and p to computing units.
pub(in crate::validate) fn of_field(columns: &Columns, pixel: Option<f64>, (length, pressure): (f64, f64)) -> Vec<Fault> {
    let mut list = Vec::new();
    let none = ColumnMistake::NONE;
    if let Some(pixel) = pixel {
        // A force per pixel in computing units, in units of the column, or in computing units in a column with another unit.
        for area in [pixel * pixel, (pixel / length).powi(2), pixel * pixel * pressure] {
            let text = "force per pixel instead of pressure: column p contains p times the area of a pixel";
            list.push(slip("force-per-pixel", text, ColumnMistake { pressure: area, ..none }));
        }
    }
    for (id, pressure, text) in FACTORS {
        let what = if id == "sign" { "p is reversed" } else { "the exact pressure is in column p" };
        list.push(slip(id, format!("{text} {what}"), ColumnMistake { pressure, ..none }));
    }
    for ten in tens() {
        list.push(power_of_ten(&["p"], columns, ten, |pressure| ColumnMistake { pressure, ..ColumnMistake::NONE }));
        list.push(power_of_ten(&["r"], columns, ten, |distance| ColumnMistake { distance, ..ColumnMistake::NONE }));
    }
    for units in [(6_894.757_293_168, "psi and Pa"), (9.806_65, "kgf and N"), (1e6 / 98_066.5, "MPa and kgf/cm^2")] {
        list.extend(ratio_of_units("p", units, |pressure| ColumnMistake { pressure, ..ColumnMistake::NONE }));
    }
    for (distance, text) in [(2.0, "column r contains twice the distance"), (0.5, "column r contains half of the distance")] {
        list.push(slip("diameter", format!("diameter and radius confused: {text}"), ColumnMistake { distance, ..none }));
    }
    let text = "swapped columns: r contains the pressures and p the distances";
    list.push(slip("swapped-columns", text, ColumnMistake { columns: Exchange::DistanceAndPressure, ..none }));
    list
}
