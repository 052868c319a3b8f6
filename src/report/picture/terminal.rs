//! Panels as text, for a terminal.

use super::Panel;
use textplots::{Chart, Plot, Shape};

/// Number of dots across and down; a character has two by four dots.
const DOTS: (u32, u32) = (140, 64);
/// Number of characters before the curves, for the numbers of the vertical axis.
const MARGIN: usize = 11;

pub(super) fn text(panels: &[Panel]) -> String {
    panels.iter().map(one).collect::<Vec<_>>().join("\n")
}

fn one(panel: &Panel) -> String {
    let (horizontal, vertical) = panel.axes();
    let share = |value: f64, low: f64, high: f64| ((value - low) / (high - low)) as f32;
    let lines: Vec<Vec<(f32, f32)>> = panel
        .lines
        .iter()
        .flat_map(|line| panel.parts(line))
        .map(|part| {
            part.iter().map(|(x, y)| (share(*x, horizontal.low, horizontal.high), share(*y, vertical.low, vertical.high))).collect()
        })
        .collect();
    let shapes: Vec<Shape<'_>> = lines.iter().map(|line| Shape::Lines(line)).collect();
    let mut chart = Chart::new_with_y_range(DOTS.0, DOTS.1, 0.0, 1.0, 0.0, 1.0);
    let chart = shapes.iter().fold(&mut chart, |chart, shape| chart.lineplot(shape));
    chart.borders();
    chart.figures();
    let frame = chart.frame();
    let rows: Vec<&str> = frame.lines().filter(|row| !row.trim().is_empty()).collect();
    let notice = Some(panel.notice()).filter(|own| !own.is_empty()).map_or(String::new(), |own| format!(", {own}"));
    let mut text = format!("{}\n{}{notice}\n", panel.title, panel.vertical);
    for (index, row) in rows.iter().enumerate() {
        let label = match index {
            0 => vertical.text(vertical.high),
            last if last + 1 == rows.len() => vertical.text(vertical.low),
            _ => String::new(),
        };
        text += &format!("{label:>MARGIN$} {row}\n");
    }
    let (left, right) = (horizontal.text(horizontal.low), horizontal.text(horizontal.high));
    let room = (DOTS.0 / 2) as usize;
    text +=
        &format!("{:MARGIN$} {left}{right:>width$}\n{:MARGIN$} {}\n", "", "", panel.horizontal, width = room.saturating_sub(left.len()));
    text
}
