//! A study as a log–log plot: time per point against true error, one colour per method, the Pareto front as a line.

use super::Tradeoff;
use crate::print;
use crate::report::palette::{colour, prepare_letters};
use crate::tradeoff::Row;
use plotters::prelude::*;
use std::error::Error;

/// Width and height in pixels.
const SIZE: (u32, u32) = (860, 560);
/// Smaller errors are drawn at this value, close to the precision of a double.
const FLOOR: f64 = 1e-17;
/// Larger errors are drawn at this value.
const CEILING: f64 = 10.0;
/// Maximum number of characters of the profile in the title.
const TITLE: usize = 60;

/// Returns the plot as the text of an SVG file.
///
/// # Errors
/// Returns a sentence if nothing can be drawn.
pub fn svg(record: &Tradeoff<'_>) -> Result<String, String> {
    let mut text = String::new();
    draw(record, &mut text).map_err(|error| format!("cannot draw the plot: {error}"))?;
    Ok(text)
}

fn draw(record: &Tradeoff<'_>, text: &mut String) -> Result<(), Box<dyn Error>> {
    let rows: Vec<&Row> = record.rows().collect();
    if rows.is_empty() {
        return Err("no method was measured within the time limit; use a larger budget".into());
    }
    let times = rows.iter().map(|row| row.time.median);
    let (low, high) = times.fold((f64::INFINITY, 1.0_f64), |(low, high), t| (low.min(t), high.max(t)));
    let decade = |t: f64, round: fn(f64) -> f64| 10.0_f64.powf(round(t.log10()));
    let (left, right) = (decade(low * 0.9, f64::floor), decade(high * 1.1, f64::ceil));
    prepare_letters();
    let area = SVGBackend::with_string(text, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let quantity = record.study.problem.quantity;
    let profile: String = print::text(record.profile).chars().take(TITLE).collect();
    let title = format!("{}({}) of f(r) = {profile}", quantity.key(), quantity.coordinate());
    let mut chart = ChartBuilder::on(&area)
        .caption(title, ("sans-serif", 18))
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d((left..right).log_scale(), (FLOOR..CEILING).log_scale())?;
    chart
        .configure_mesh()
        .max_light_lines(0)
        .bold_line_style(RGBColor(215, 215, 215))
        .x_desc("time per point, ns")
        .y_desc("largest relative error")
        .x_label_formatter(&|t| power_of_ten(*t))
        .y_label_formatter(&|error| power_of_ten(*error))
        .x_labels(10)
        .y_labels(10)
        .draw()?;
    let place = |row: &Row| (row.time.median, row.error.clamp(FLOOR, CEILING));
    let mut front: Vec<(f64, f64)> = rows.iter().filter(|row| row.front).map(|row| place(row)).collect();
    front.sort_by(|one, other| one.0.total_cmp(&other.0));
    chart
        .draw_series(LineSeries::new(stairs(&front), RGBColor(60, 60, 60).stroke_width(1)))?
        .label("Pareto front")
        .legend(|(x, y)| PathElement::new([(x, y), (x + 14, y)], RGBColor(60, 60, 60)));
    let mut methods: Vec<&str> = rows.iter().map(|row| row.method).collect();
    methods.dedup();
    for (index, method) in methods.iter().enumerate() {
        let colour = colour(index);
        let own: Vec<&&Row> = rows.iter().filter(|row| row.method == *method).collect();
        chart.draw_series(LineSeries::new(own.iter().map(|row| place(row)), colour.mix(0.4)))?;
        let spots =
            own.iter().map(|row| Circle::new(place(row), 4, ShapeStyle { color: colour.to_rgba(), filled: row.front, stroke_width: 2 }));
        chart.draw_series(spots)?.label(*method).legend(move |(x, y)| Circle::new((x + 7, y), 4, colour.filled()));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.85))
        .border_style(RGBColor(200, 200, 200))
        .draw()?;
    area.present()?;
    drop(chart);
    drop(area);
    Ok(())
}

/// Returns the front as steps: between two of its points, the more expensive one is required.
fn stairs(front: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut path = Vec::new();
    for (index, (time, error)) in front.iter().enumerate() {
        if let Some((_, before)) = index.checked_sub(1).and_then(|i| front.get(i)) {
            path.push((*time, *before));
        }
        path.push((*time, *error));
    }
    path
}

fn power_of_ten(value: f64) -> String {
    format!("1e{:.0}", value.log10())
}
