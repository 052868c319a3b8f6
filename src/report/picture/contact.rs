//! The curves of contacts: quantities against the load, and fields against the radius at the largest load.

use super::{Line, Panel, Picture};
use crate::contact::{Kind, Quantity, State};
use crate::scene::{Dimension, Point, Row, Run, infinite_value};
use std::f64::consts::FRAC_PI_2;

/// The items that can be plotted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pictured {
    /// A quantity against the depth, or the depth against the contact radius, or a field at the largest load.
    Quantity(Quantity),
    /// The tip in the deformed surface.
    Section,
}

/// Number of points of a curve.
const POINTS: u32 = 160;
/// Relative distances to a kink, and to the axis in contact radii, at which pressures are plotted.
const NEAR_A_KINK: [f64; 5] = [1e-5, 1e-4, 1e-3, 4e-3, 1.2e-2];
/// Extent of the plotted surfaces, in contact radii.
const BEYOND: f64 = 1.8;

impl Picture {
    /// Creates one panel per quantity with one line per contact; the loads of every run increase to its largest load, as in `Scene::swept`,
    /// and have the quantities of [`Pictured::data`].
    pub fn of_contacts(contacts: &[(&str, &Run<'_>)], quantities: &[Pictured]) -> Self {
        let Some((_, first)) = contacts.first() else { return Self::default() };
        let has_rows = quantities.iter().any(|own| matches!(own, Pictured::Quantity(own) if own.kind() == Kind::Number));
        let rows = |run: &Run<'_>| (0..if has_rows { run.scene().loads.len() } else { 0 }).filter_map(|index| run.row(index)).collect();
        let rows: Vec<Vec<Row>> = contacts.iter().map(|(_, run)| rows(run)).collect();
        let panels = quantities.iter().map(|quantity| {
            let solved = contacts.iter().zip(&rows);
            let lines: Vec<Line> = solved.flat_map(|((name, run), rows)| quantity.lines(name, run, rows)).collect();
            let unit = |dimension| first.scene().system.unit_name(dimension);
            let titled = |name: &str, dimension| {
                let unit = unit(dimension);
                if unit.is_empty() { name.to_owned() } else { format!("{name} ({unit})") }
            };
            let (mut title, horizontal, vertical) = quantity.labels();
            if let Some(why) = contacts.iter().find_map(|(_, run)| run.cut_short()) {
                title = format!("{title} (incomplete: {why})");
            }
            Panel::new(&title, titled(horizontal, Dimension::LENGTH), titled(&vertical.0, vertical.1), lines)
        });
        Self { panels: panels.collect() }
    }
}

impl Pictured {
    /// Returns the quantities per load that pictures of these need.
    pub fn data(all: &[Self]) -> Vec<Quantity> {
        let numbers = all.iter().filter_map(|own| if let Self::Quantity(own) = own { Some(*own) } else { None });
        let coordinates = [Quantity::Depth, Quantity::Radius];
        let needed = |own: &Quantity| own.kind() == Kind::Number && !coordinates.contains(own);
        coordinates.into_iter().chain(numbers.filter(needed)).collect()
    }

    /// Returns the title, the name of the coordinate, and the name and dimension of the values.
    fn labels(self) -> (String, &'static str, (String, Dimension)) {
        let Self::Quantity(own) = self else {
            return ("Tip and surface at the largest load".to_owned(), "radius r", ("height".to_owned(), Dimension::LENGTH));
        };
        let horizontal = match (own.kind(), own.coordinate()) {
            (Kind::Shape | Kind::Field, "r") => "radius r",
            (Kind::Shape | Kind::Field, "z") => "depth below the surface z",
            (Kind::Shape | Kind::Field, _) => "x",
            _ if own == Quantity::Depth => "contact radius a",
            _ => "depth d",
        };
        let mut title = own.title().to_owned();
        let vertical = format!("{title} {}", own.key());
        if own.needs_radius() {
            title.push_str(" at the largest load");
        }
        if let Some(first) = title.get_mut(..1) {
            first.make_ascii_uppercase();
        }
        (title, horizontal, (vertical, own.dimension()))
    }

    fn lines(self, name: &str, run: &Run<'_>, rows: &[Row]) -> Vec<Line> {
        let line = |name: String, points| Line { name, points };
        let last = run.scene().loads.len().saturating_sub(1);
        let state = run.state(last, false);
        let length = run.scene().system.out(Dimension::LENGTH);
        match self {
            Self::Quantity(own) if own.kind() == Kind::Number => vec![line(name.to_owned(), over_loads(rows, own))],
            Self::Quantity(own) => vec![line(name.to_owned(), over_radius(run, own, state.as_ref()))],
            Self::Section => {
                let Some(state) = state else { return Vec::new() };
                let named = |what: &str| if name.is_empty() { what.to_owned() } else { format!("{name}, {what}") };
                let depth = state.depth * length;
                let places = radii(run, Quantity::Displacement, Some(&state));
                let tip = values(run, Quantity::Profile, Some(&state), &places).into_iter().map(|(at, f)| (at, f - depth));
                let surface = values(run, Quantity::Displacement, Some(&state), &places).into_iter().map(|(at, u)| (at, -u));
                vec![line(named("tip"), tip.collect()), line(named("surface"), surface.collect())]
            }
        }
    }
}

/// Returns a quantity against the depth, or the depth against the contact radius, for the valid loads.
fn over_loads(rows: &[Row], datum: Quantity) -> Vec<(f64, f64)> {
    let abscissa = if datum == Quantity::Depth { Quantity::Radius } else { Quantity::Depth };
    let point = |row: &Row| {
        let valid = row.is_valid();
        let number = |own| row.value(own).filter(|_| valid).unwrap_or(f64::NAN);
        (number(abscissa), number(datum))
    };
    rows.iter().map(point).collect()
}

fn over_radius(run: &Run<'_>, curve: Quantity, state: Option<&State>) -> Vec<(f64, f64)> {
    values(run, curve, state, &radii(run, curve, state))
}

/// Returns the coordinates in output units with the values there; NaN where there is none.
fn values(run: &Run<'_>, curve: Quantity, state: Option<&State>, at: &[f64]) -> Vec<(f64, f64)> {
    let number = |own: Point| match own.value {
        Ok((value, _)) => value,
        Err(why) => infinite_value(curve, why).unwrap_or(f64::NAN),
    };
    run.points(curve, state, at).into_iter().map(|own| (own.at, number(own))).collect()
}

/// Returns coordinates in computing units: for a pressure inside the contact and close to its edge, otherwise also beyond it.
fn radii(run: &Run<'_>, curve: Quantity, state: Option<&State>) -> Vec<f64> {
    let a = state.map_or(1.0, |state| state.radius);
    let share = |index: u32| f64::from(index) / f64::from(POINTS);
    let kinks = run.kinks().into_iter().map(|(at, _)| at / run.scene().system.out(Dimension::LENGTH));
    match curve {
        Quantity::Pressure => {
            // The pressure is infinite at a kink or an apex; the points next to it show how it increases.
            let near = |at: f64| NEAR_A_KINK.into_iter().flat_map(move |part| [at * (1.0 - part), at * (1.0 + part)]).chain([at]);
            let even = (0..=POINTS).map(|index| a * (FRAC_PI_2 * share(index)).sin());
            let beside = kinks.filter(|at| *at < a).flat_map(near).filter(|at| *at < a).chain(NEAR_A_KINK.map(|part| part * a));
            let mut all: Vec<f64> = even.chain(beside).collect();
            all.sort_by(f64::total_cmp);
            all
        }
        _ if curve.coordinate() == "x" => (0..=POINTS).map(|index| a * share(index)).collect(),
        _ => {
            let mut all: Vec<f64> =
                (0..=POINTS).map(|index| BEYOND * a * share(index)).chain([a]).chain(kinks.filter(|at| *at < BEYOND * a)).collect();
            all.sort_by(f64::total_cmp);
            all
        }
    }
}
