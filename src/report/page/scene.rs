//! The page of a solved scene: the formulas of its shape, tables of the rows and of the curves, and the verdict.

use super::{Block, Page};
use crate::contact::Severity;
use crate::expr::{Expr, Number};
use crate::num::Bound;
use crate::print::{Presentation, Prose};
use crate::report::solved::bounds::Largest;
use crate::report::solved::text::{cells, columns, depth, edge_of};
use crate::report::solved::{Verdict, assumptions};
use crate::report::{Derivation, Digits};
use crate::scene::{Dimension, Point, Quantity, Run};

impl Page {
    /// Creates the page of a solved scene, with the verdict on its rows; `formulas` are those of its shape, if it has any.
    pub fn of_scene(run: &Run<'_>, formulas: Option<&Derivation<'_>>, formally: bool, digits: Digits) -> (Self, Verdict) {
        let scene = run.scene();
        let mut page = match formulas {
            Some(record) => Self::of_derivation(record),
            None => Self::new("", true, &Presentation::default()),
        };
        page.is_text = true;
        "Contact".clone_into(&mut page.title);
        page.heading(1, "Results");
        let unit = |dimension| scene.system.unit_name(dimension);
        let modulus = scene.effective_modulus * scene.system.out(Dimension::PRESSURE);
        let mut values = Prose::read("$E$ = ")
            .followed_by(&number(digits.rounded(modulus)))
            .followed_by(&Prose::words(&spaced(&unit(Dimension::PRESSURE))));
        for (name, value) in scene.parameters.iter().filter(|_| scene.symbolic.is_some()) {
            values = values.then(&format!(", ${name}$ = ")).followed_by(&Prose::words(&printed(value)));
        }
        page.sentence(values);
        if formulas.is_some()
            && scene.symbolic.is_none()
            && !unit(Dimension::LENGTH).is_empty()
            && scene.system.out(Dimension::LENGTH) == 1.0
        {
            page.sentence(Prose::words(&format!("Lengths in the formulas are in{}", spaced(&unit(Dimension::LENGTH)))));
        }
        let mut verdict = Verdict::default();
        let (mut rows, mut bounds) = (Vec::new(), Largest::default());
        for (index, row) in (0..scene.loads.len()).filter_map(|index| Some((index, run.row(index)?))) {
            verdict.take(&row);
            if row.is_valid() || formally {
                bounds.take(run, index, &row, digits);
            }
            let finding = row.indented.findings.iter().find(|own| own.severity == Severity::Error);
            let words = [edge_of(&row), finding.map_or("valid", |own| own.rule)].map(Prose::words);
            rows.push(cells(run, &row, formally, digits).into_iter().map(optional).chain(words).collect());
        }
        verdict.close(run);
        let heads = columns(run).into_iter().map(|(name, unit)| head(&name, &unit));
        page.blocks.push(Block::Table(heads.chain(["edge", "verdict"].map(Prose::words)).collect(), rows));
        page.blocks.extend(bounds.sentence().map(|own| Block::Sentence(Prose::words(&capital(&own)))));
        page.sentence(Prose::words(&format!("{}: {}", capital(&verdict.words()), assumptions(scene))));
        if let Some(own) = verdict.regime() {
            page.sentence(Prose::words(&capital(&own.sentence(&scene.system))));
        }
        for (finding, _) in verdict.findings() {
            page.sentence(Prose::words(&format!("{}: {}", capital(finding.severity.name()), finding.message)));
        }
        for curve in &scene.outputs.curves {
            page.curve(run, *curve, formally, digits);
        }
        (page, verdict)
    }

    /// Adds a table of a curve for every load, or a single one if the curve does not depend on the load.
    fn curve(&mut self, run: &Run<'_>, curve: Quantity, formally: bool, digits: Digits) {
        let scene = run.scene();
        let (length, unit) = (scene.system.unit_name(Dimension::LENGTH), scene.system.unit_name(curve.dimension()));
        let indices: Vec<Option<usize>> = if curve.needs_radius() { (0..scene.loads.len()).map(Some).collect() } else { vec![None] };
        for index in indices {
            let state = index.and_then(|index| run.state(index, formally));
            let left = format!("{}({})", curve.key(), curve.coordinate());
            let at = index.and_then(|index| depth(run, index, state.as_ref(), digits));
            self.heading(2, &at.map_or_else(|| left.clone(), |own| format!("{left} at d = {own}{}", spaced(&length))));
            let row = |point: &Point| match point.value.map(|(value, error)| digits.shown(value, error)) {
                Ok((value, bound)) => vec![number(point.at), number(value), error(bound, point.bound)],
                Err(why) => vec![number(point.at), Prose::words("–"), Prose::words(why)],
            };
            let rows = run.curve(curve, state).iter().map(|(_, point)| row(point)).collect();
            let heads = vec![head(curve.coordinate(), &length), head(curve.key(), &unit), head("error", &unit)];
            self.blocks.push(Block::Table(heads, rows));
        }
    }
}

/// The head of a column, with its unit.
fn head(name: &str, unit: &str) -> Prose {
    let own = if name == "error" { Prose::words(name) } else { Prose::read(&format!("${name}$")) };
    if unit.is_empty() { own } else { own.followed_by(&Prose::words(&format!(" /{}", spaced(unit)))) }
}

/// A number with the digits that identify it, as an author writes it.
fn number(value: f64) -> Prose {
    let magnitude = Number::parse_decimal(&format!("{:e}", value.abs()));
    match magnitude {
        Some(own) if value.is_sign_negative() && value != 0.0 => Prose::default().formula(Expr::number(-&own)),
        Some(own) => Prose::default().formula(Expr::number(own)),
        None => Prose::words("–"),
    }
}

fn optional(value: Option<f64>) -> Prose {
    value.map_or_else(|| Prose::words("–"), number)
}

/// An error with two digits, with a tilde where it is estimated.
fn error(value: f64, bound: Bound) -> Prose {
    let own = number(format!("{value:.1e}").parse().unwrap_or(value));
    if bound == Bound::Estimated { Prose::words("~").followed_by(&own) } else { own }
}

/// A unit behind a number.
fn spaced(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" {}", printed(unit)) }
}

/// A unit, or a number with a unit, as it is printed: µm for um, and signs for powers and products.
fn printed(unit: &str) -> String {
    let mut text = String::with_capacity(unit.len());
    let mut before = ' ';
    for (place, letter) in unit.char_indices() {
        let is_micro = letter == 'u'
            && !before.is_alphabetic()
            && ["um", "uN", "uPa", "uJ"].iter().any(|own| {
                let rest = unit.get(place..).unwrap_or_default();
                rest.strip_prefix(own).is_some_and(|rest| !rest.starts_with(char::is_alphabetic))
            });
        text.push(if is_micro { 'µ' } else { letter });
        before = letter;
    }
    text.replace("^2", "²").replace("^3", "³").replace('*', "·")
}

/// A sentence with a capital letter at its beginning.
fn capital(sentence: &str) -> String {
    let mut letters = sentence.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
