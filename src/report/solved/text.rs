//! A solved scene as a table for the terminal, and as CSV.

use crate::contact::Severity;
use crate::report::digits::Digits;
use crate::report::solved::bounds;
use crate::report::solved::bounds::{Largest, named};
use crate::report::solved::tip;
use crate::report::solved::tip::Changes;
use crate::report::solved::{Verdict, assumptions, edge};
use crate::report::text::marked;
use crate::scene::{Dimension, Quantity, Row, Run};
use std::io::{self, Write};

/// Writes a table of rows, a table of points per curve, and the verdict.
///
/// # Errors
/// Returns the errors of the writer.
pub fn table(run: &Run<'_>, formally: bool, digits: Digits, out: &mut dyn Write) -> io::Result<Verdict> {
    let scene = run.scene();
    let modulus = scene.effective_modulus * scene.system.out(Dimension::PRESSURE);
    writeln!(out, "E* = {modulus:?} {}", scene.system.unit_name(Dimension::PRESSURE))?;
    tip::introduction(run, out)?;
    writeln!(out)?;
    for (name, unit) in columns(run) {
        let title = if unit.is_empty() { name } else { format!("{name} / {unit}") };
        write!(out, "{title:>24}")?;
    }
    writeln!(out, "  edge")?;
    let mut verdict = Verdict::default();
    let mut changes = Changes::default();
    let (mut lacking, mut bounds) = (Vec::new(), Largest::default());
    for (index, row) in (0..scene.loads.len()).filter_map(|index| Some((index, run.row(index)?))) {
        verdict.take(&row);
        if row.is_valid() {
            let reasons = row.values.iter().filter_map(|(datum, value)| Some((*datum, value.err()?)));
            lacking.extend(reasons.filter(|own| !lacking.contains(own)).collect::<Vec<_>>());
        }
        if row.is_valid() || formally {
            bounds.take(run, index, &row, digits);
        }
        let state = row.indented.state.filter(|_| row.is_valid());
        changes.take(run.row_model_errors(index, state.as_ref()), |datum| row.value(datum));
        for cell in cells(run, &row, formally, digits) {
            write!(out, "{:>24}", cell.map_or_else(|| "-".to_owned(), |value| format!("{value:?}")))?;
        }
        write!(out, "  {}", edge_of(&row))?;
        if let Some(first) = row.indented.findings.iter().find(|own| own.severity == Severity::Error) {
            let word = if row.validity().is_some() { "invalid: " } else { "" };
            write!(out, "  {word}{}", first.rule)?;
        }
        writeln!(out)?;
    }
    for curve in scene.outputs.curves.iter().copied() {
        curve_table(run, curve, formally, digits, out)?;
    }
    verdict.close(run);
    writeln!(out)?;
    if let Some(own) = bounds.sentence() {
        writeln!(out, "{own}")?;
    }
    changes.write(run, out)?;
    writeln!(out, "{} (model: {})", verdict.words(), assumptions(scene))?;
    if let Some(own) = verdict.regime() {
        writeln!(out, "{}", own.sentence(&scene.system))?;
    }
    for (finding, _) in verdict.findings() {
        writeln!(out, "{}: {}: {}", finding.severity.name(), finding.rule, finding.message)?;
    }
    for (datum, why) in lacking {
        writeln!(out, "{}: no value in some rows: {why}", datum.key())?;
    }
    Ok(verdict)
}

pub(in crate::report) fn edge_of(row: &Row) -> &'static str {
    row.indented.state.map_or("-", |state| edge(state.boundary))
}

/// Returns the names and units of the columns.
pub(in crate::report) fn columns(run: &Run<'_>) -> Vec<(String, String)> {
    let scene = run.scene();
    let mut list: Vec<_> = scene.outputs.data.iter().map(|own| (own.key().to_owned(), scene.system.unit_name(own.dimension()))).collect();
    if scene.counts_from_touch() {
        list.insert(0, ("d_first_touch".to_owned(), scene.system.unit_name(Dimension::LENGTH)));
    } else if run.touches_beside_the_axis() {
        list.push(("d_first_touch".to_owned(), scene.system.unit_name(Dimension::LENGTH)));
    }
    list
}

/// Returns the values of a row; an invalid row still contains its load.
pub(in crate::report) fn cells(run: &Run<'_>, row: &Row, formally: bool, digits: Digits) -> Vec<Option<f64>> {
    let scene = run.scene();
    let touch = scene.counts_from_touch();
    let mut list = if touch { vec![Some(row.load)] } else { Vec::new() };
    let shown = formally || row.is_valid();
    list.extend(row.values.iter().map(|(datum, value)| match value {
        _ if !touch && *datum == scene.control.datum() => Some(row.load),
        Ok(value) if shown => Some(digits.rounded(*value)),
        _ => None,
    }));
    if !touch && run.touches_beside_the_axis() {
        list.push(row.depth_from_touch.filter(|_| shown).map(|own| digits.rounded(own)));
    }
    list
}

fn curve_table(run: &Run<'_>, curve: Quantity, formally: bool, digits: Digits, out: &mut dyn Write) -> io::Result<()> {
    let scene = run.scene();
    let indices: Vec<Option<usize>> = if curve.needs_radius() { (0..scene.loads.len()).map(Some).collect() } else { vec![None] };
    let (length, unit) = (scene.system.unit_name(Dimension::LENGTH), scene.system.unit_name(curve.dimension()));
    for index in indices {
        let state = index.and_then(|index| run.state(index, formally));
        writeln!(out)?;
        match index {
            Some(index) => {
                writeln!(out, "{} at d = {}", curve.key(), depth(run, index, state.as_ref(), digits).unwrap_or_else(|| "-".to_owned()))?
            }
            None => writeln!(out, "{}", curve.key())?,
        }
        let with = |name: &str, unit: &str| if unit.is_empty() { name.to_owned() } else { format!("{name} / {unit}") };
        let measured = scene.tip.is_some();
        let more = if measured { format!("{:>16}", "model error") } else { String::new() };
        let place = if curve.coordinate() == "z" { "z" } else { "at" };
        writeln!(out, "{:>24}{:>24}{:>16}{more}", with(place, &length), with(curve.key(), &unit), "error")?;
        let second = index.and_then(|index| run.second_state(index));
        for (at, point) in run.curve(curve, state) {
            let change = run.point_model_error(curve, state.as_ref().zip(second.as_ref()), at);
            let more = match change {
                _ if !measured => String::new(),
                Some(own) => format!("{own:>16.1e}"),
                None => format!("{:>16}", "-"),
            };
            match point.value.map(|(value, error)| digits.shown(value, error)) {
                Ok((value, error)) => {
                    writeln!(out, "{:>24}{value:>24?}{:>16}{more}", format!("{:?}", point.at), marked(format!("{error:.1e}"), point.bound))?
                }
                Err(why) => writeln!(out, "{:>24}{:>24}  {why}", format!("{:?}", point.at), "-")?,
            }
        }
    }
    Ok(())
}

/// Formats the depth of a load, with all digits if it is the load itself.
pub(in crate::report) fn depth(run: &Run<'_>, index: usize, state: Option<&crate::contact::State>, digits: Digits) -> Option<String> {
    let shown = run.shown_depth(index, state?);
    let is_input = run.scene().control.datum() == Quantity::Depth;
    Some(format!("{:?}", if is_input { shown } else { digits.rounded(shown) }))
}

/// Writes the rows as CSV, and the points if the scene requests curves.
///
/// Columns are named quantity_unit, as in `d_um,F_mN`; the field of a missing value is empty.
/// The last columns are the error bounds, as in `F_error_mN,F_bound`. If both rows and curves
/// are requested, an empty line separates the two tables.
///
/// # Errors
/// Returns the errors of the writer.
pub fn csv(run: &Run<'_>, formally: bool, digits: Digits, out: &mut dyn Write) -> io::Result<Verdict> {
    let scene = run.scene();
    let curves = &scene.outputs.curves;
    // Every point contains its load; other quantities require rows.
    let rows = curves.is_empty() || scene.outputs.data.iter().any(|own| *own != scene.control.datum());
    let mut verdict = Verdict::default();
    if rows {
        let mut header: Vec<String> = columns(run).iter().map(|(name, unit)| named(name, unit)).collect();
        header.extend(["edge".to_owned(), "valid".to_owned(), "rule".to_owned()]);
        header.extend(bounds::header(run));
        writeln!(out, "{}", header.join(","))?;
    }
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:?}"));
    for (index, row) in (0..scene.loads.len()).filter_map(|index| Some((index, run.row(index)?))) {
        verdict.take(&row);
        if rows {
            let numbers: Vec<String> = cells(run, &row, formally, digits).into_iter().map(number).collect();
            let rule = row.indented.findings.iter().find(|own| own.severity == Severity::Error).map_or("", |own| own.rule);
            let bounds = if formally || row.is_valid() {
                bounds::fields(run, index, &row, digits)
            } else {
                vec![String::new(); 2 * scene.outputs.data.len()]
            };
            let valid = row.validity().map_or_else(String::new, |own| own.to_string());
            writeln!(out, "{},{},{valid},{rule},{}", numbers.join(","), edge_of(&row), bounds.join(","))?;
        }
    }
    if !curves.is_empty() {
        let length = scene.system.unit_name(Dimension::LENGTH);
        if rows {
            writeln!(out)?;
        }
        writeln!(out, "quantity,{},{},value,error,unit,bound", named("d", &length), named("at", &length))?;
        for curve in curves.iter().filter(|own| !own.needs_radius()) {
            points(run, *curve, None, formally, digits, out)?;
        }
        for index in 0..scene.loads.len() {
            for curve in curves.iter().filter(|own| own.needs_radius()) {
                points(run, *curve, Some(index), formally, digits, out)?;
            }
        }
    }
    verdict.close(run);
    Ok(verdict)
}

fn points(run: &Run<'_>, curve: Quantity, index: Option<usize>, formally: bool, digits: Digits, out: &mut dyn Write) -> io::Result<()> {
    let state = index.and_then(|index| run.state(index, formally));
    let depth = index.and_then(|index| depth(run, index, state.as_ref(), digits)).unwrap_or_default();
    let unit = run.scene().system.unit_name(curve.dimension());
    for (_, point) in run.curve(curve, state) {
        let shown = point.value.map(|(value, error)| digits.shown(value, error));
        let (value, error) = shown.map_or_else(|_| Default::default(), |(value, error)| (format!("{value:?}"), format!("{error:?}")));
        let bound = point.value.map_or("", |_| point.bound.name());
        writeln!(out, "{},{depth},{:?},{value},{error},{unit},{bound}", curve.key(), point.at)?;
    }
    Ok(())
}
