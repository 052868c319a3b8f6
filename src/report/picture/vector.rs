//! Panels drawn with plotters, and as SVG.

use super::{PANEL, Panel};
use crate::print;
use crate::report::palette::{LETTERS, colour, prepare_letters};
use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;

/// Returns the text of an SVG file, with a description.
pub(super) fn svg(panels: &[Panel]) -> Result<String, String> {
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, size(panels)).into_drawing_area();
        draw(panels, &area).map_err(|error| format!("cannot draw the picture: {error}"))?;
    }
    let description: Vec<String> = panels.iter().map(Panel::description).collect();
    let title = format!("<title>{}</title>", print::escaped(&description.join("; ")));
    let Some((head, rest)) = text.split_once("<svg ") else { return Ok(text) };
    let Some((attributes, rest)) = rest.split_once('>') else { return Ok(text) };
    Ok(format!("{head}<svg role=\"img\" {attributes}>\n{title}{rest}"))
}

pub(super) fn size(panels: &[Panel]) -> (u32, u32) {
    (PANEL.0, PANEL.1 * u32::try_from(panels.len().max(1)).unwrap_or(1))
}

/// Draws panels below each other.
pub(super) fn draw<B>(panels: &[Panel], area: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
where
    B: DrawingBackend,
    B::ErrorType: 'static,
{
    prepare_letters();
    area.fill(&WHITE)?;
    for (own, panel) in area.split_evenly((panels.len().max(1), 1)).iter().zip(panels) {
        one(panel, own)?;
    }
    area.present()?;
    Ok(())
}

fn one<B>(panel: &Panel, area: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
where
    B: DrawingBackend,
    B::ErrorType: 'static,
{
    let (horizontal, vertical) = panel.axes();
    let mut chart = ChartBuilder::on(area)
        .caption(&panel.title, (LETTERS, 17))
        .margin(12)
        .margin_right(26)
        .x_label_area_size(46)
        .y_label_area_size(84)
        .build_cartesian_2d(horizontal.low..horizontal.high, vertical.low..vertical.high)?;
    chart
        .configure_mesh()
        .max_light_lines(0)
        .bold_line_style(RGBColor(225, 225, 225))
        .label_style((LETTERS, 13))
        .axis_desc_style((LETTERS, 14))
        .x_desc(format!("{}{}", panel.horizontal, marks(panel)))
        .y_desc(&panel.vertical)
        .x_labels(horizontal.ticks.len())
        .y_labels(vertical.ticks.len())
        .x_label_formatter(&|tick| horizontal.text(*tick))
        .y_label_formatter(&|tick| vertical.text(*tick))
        .draw()?;
    for (index, line) in panel.lines.iter().enumerate() {
        let colour = colour(index);
        for (at, part) in panel.parts(line).into_iter().enumerate() {
            let series = chart.draw_series(LineSeries::new(part, colour.stroke_width(2)))?;
            if at == 0 && !line.name.is_empty() {
                series.label(&line.name).legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], colour.stroke_width(2)));
            }
        }
    }
    let (low, high) = (vertical.low, vertical.high);
    // A marker of negative size points down.
    let ends = panel
        .infinite
        .iter()
        .map(|(at, up)| TriangleMarker::new((*at, if *up { high } else { low }), if *up { 7 } else { -7 }, BLACK.filled()));
    chart.draw_series(ends)?;
    if panel.lines.iter().any(|line| !line.name.is_empty()) {
        chart
            .configure_series_labels()
            .position(if panel.falls() { SeriesLabelPosition::UpperRight } else { SeriesLabelPosition::UpperLeft })
            .label_font((LETTERS, 13))
            .background_style(WHITE.mix(0.85))
            .border_style(RGBColor(200, 200, 200))
            .draw()?;
    }
    Ok(())
}

/// Returns the legend of the markers, which follows the title of an axis.
fn marks(panel: &Panel) -> &'static str {
    match (panel.infinite.iter().any(|own| own.1), panel.infinite.iter().any(|own| !own.1)) {
        (false, false) => "",
        (true, false) => " (▲ infinite)",
        (false, true) => " (▼ minus infinity)",
        (true, true) => " (▲ infinite, ▼ minus infinity)",
    }
}
