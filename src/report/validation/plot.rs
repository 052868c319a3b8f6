//! Plots of the data with the exact curve, and of the error, as SVG.

use crate::report::palette::prepare_letters;
use crate::validate::Plot;
use plotters::prelude::*;
use std::error::Error;

const SIZE: (u32, u32) = (720, 320);
const EXACT: RGBColor = RGBColor(0, 114, 178);
const DATA: RGBColor = RGBColor(213, 94, 0);

/// Draws two plots of one column: values, and errors relative to the largest exact value.
///
/// # Errors
/// Returns a sentence if nothing can be drawn.
pub(super) fn svg(plot: &Plot) -> Result<[String; 2], String> {
    let mut points: Vec<(f64, f64, f64)> =
        plot.points.iter().copied().filter(|(x, data, exact)| x.is_finite() && data.is_finite() && exact.is_finite()).collect();
    points.sort_by(|one, other| one.0.total_cmp(&other.0));
    let (mut values, mut errors) = (String::new(), String::new());
    draw(plot, &points, &mut values).map_err(|error| format!("cannot draw the plot: {error}"))?;
    draw_errors(plot, &points, &mut errors).map_err(|error| format!("cannot draw the plot: {error}"))?;
    Ok([values, errors])
}

/// Returns a nonempty range that contains all numbers.
fn range(numbers: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let (low, high) = numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), own| (low.min(own), high.max(own)));
    if !(low.is_finite() && high.is_finite()) {
        return 0.0..1.0;
    }
    let room = 0.05 * (high - low).max(1e-3 * high.abs().max(low.abs()));
    if room > 0.0 && (high - low + 2.0 * room).is_finite() { low - room..high + room } else { low - 1.0..high + 1.0 }
}

fn draw(plot: &Plot, points: &[(f64, f64, f64)], text: &mut String) -> Result<(), Box<dyn Error>> {
    prepare_letters();
    let area = SVGBackend::with_string(text, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .margin(10)
        .x_label_area_size(40)
        .y_label_area_size(84)
        .build_cartesian_2d(range(points.iter().map(|own| own.0)), range(points.iter().flat_map(|own| [own.1, own.2])))?;
    let short = |value: &f64| format!("{value:.3e}");
    chart
        .configure_mesh()
        .max_light_lines(0)
        .x_desc(&plot.across)
        .y_desc(&plot.title)
        .x_label_formatter(&short)
        .y_label_formatter(&short)
        .x_labels(6)
        .y_labels(6)
        .draw()?;
    chart
        .draw_series(LineSeries::new(points.iter().map(|own| (own.0, own.2)), EXACT.stroke_width(2)))?
        .label("exact")
        .legend(|(x, y)| PathElement::new([(x, y), (x + 14, y)], EXACT.stroke_width(2)));
    chart
        .draw_series(points.iter().map(|own| Circle::new((own.0, own.1), 3, DATA)))?
        .label("data")
        .legend(|(x, y)| Circle::new((x + 7, y), 3, DATA));
    chart.configure_series_labels().background_style(WHITE.mix(0.85)).border_style(RGBColor(200, 200, 200)).draw()?;
    area.present()?;
    drop(chart);
    drop(area);
    Ok(())
}

fn draw_errors(plot: &Plot, points: &[(f64, f64, f64)], text: &mut String) -> Result<(), Box<dyn Error>> {
    let scale = points.iter().map(|own| own.2.abs()).fold(f64::MIN_POSITIVE, f64::max);
    let errors: Vec<(f64, f64)> = points.iter().map(|own| (own.0, (own.1 - own.2) / scale)).filter(|own| own.1.is_finite()).collect();
    prepare_letters();
    let area = SVGBackend::with_string(text, (SIZE.0, 200)).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .margin(10)
        .x_label_area_size(40)
        .y_label_area_size(84)
        .build_cartesian_2d(range(points.iter().map(|own| own.0)), range(errors.iter().map(|own| own.1).chain([0.0])))?;
    let short = |value: &f64| format!("{value:.2e}");
    chart
        .configure_mesh()
        .max_light_lines(0)
        .x_desc(&plot.across)
        .y_desc("error / largest")
        .x_label_formatter(&short)
        .y_label_formatter(&short)
        .x_labels(6)
        .y_labels(5)
        .draw()?;
    chart.draw_series(errors.iter().map(|own| Circle::new(*own, 2, DATA)))?;
    area.present()?;
    drop(chart);
    drop(area);
    Ok(())
}
