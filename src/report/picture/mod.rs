//! Pictures of curves: panels with axes and lines, drawn as SVG, as PNG, or in a terminal.

pub(super) mod axis;
mod contact;
mod raster;
mod terminal;
mod vector;

pub use contact::Pictured;

use axis::Axis;

/// Panels below each other.
#[derive(Clone, Debug, Default)]
pub struct Picture {
    panels: Vec<Panel>,
}

/// One pair of axes with its lines.
#[derive(Clone, Debug)]
struct Panel {
    title: String,
    horizontal: String,
    vertical: String,
    lines: Vec<Line>,
    /// The largest magnitude that is shown, where values grow without bound.
    most: Option<f64>,
}

/// A line through points; NaN interrupts it.
#[derive(Clone, Debug)]
struct Line {
    name: String,
    points: Vec<(f64, f64)>,
}

/// Width of a picture and height of a panel in pixels.
const PANEL: (u32, u32) = (860, 380);
/// Curves that rise to more than this many times their usual size are cut.
const PEAK: f64 = 6.0;

impl Panel {
    fn new(title: &str, horizontal: String, vertical: String, lines: Vec<Line>) -> Self {
        let mut sizes: Vec<f64> = lines.iter().flat_map(|line| &line.points).map(|(_, y)| y.abs()).filter(|y| y.is_finite()).collect();
        sizes.sort_by(f64::total_cmp);
        let usual = sizes.get(sizes.len() * 19 / 20).copied().unwrap_or(0.0);
        let most = sizes.last().filter(|largest| **largest > PEAK * usual && usual > 0.0).map(|_| 1.5 * usual);
        Self { title: title.to_owned(), horizontal, vertical, lines, most }
    }

    /// The parts of a line between gaps, within what is shown.
    fn parts(&self, line: &Line) -> Vec<Vec<(f64, f64)>> {
        let most = self.most.unwrap_or(f64::INFINITY);
        let parts = line.points.split(|(x, y)| !(x.is_finite() && y.abs() <= most));
        parts.filter(|part| !part.is_empty()).map(<[_]>::to_vec).collect()
    }

    fn axes(&self) -> (Axis, Axis) {
        let shown: Vec<(f64, f64)> = self.lines.iter().flat_map(|line| self.parts(line)).flatten().collect();
        (Axis::round(shown.iter().map(|(x, _)| *x), 8), Axis::round(shown.iter().map(|(_, y)| *y), 6))
    }

    /// True where the lines are higher at their beginning than at their end, so that names are better on the right.
    fn falls(&self) -> bool {
        let ends = self.lines.iter().filter_map(|line| {
            let parts = self.parts(line);
            Some((parts.first()?.first()?.1, parts.last()?.last()?.1))
        });
        let (first, last) =
            ends.fold((f64::NEG_INFINITY, f64::NEG_INFINITY), |(first, last), (one, other)| (one.max(first), other.max(last)));
        first > last
    }

    /// What the picture says, for those who do not see it.
    fn description(&self) -> String {
        let names: Vec<&str> = self.lines.iter().map(|line| line.name.as_str()).filter(|name| !name.is_empty()).collect();
        let of = if names.is_empty() { String::new() } else { format!(": {}", names.join(", ")) };
        format!("{}, {} over {}{of}", self.title, self.vertical, self.horizontal)
    }
}

impl Picture {
    /// True where there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.panels.iter().all(|panel| panel.lines.iter().all(|line| panel.parts(line).is_empty()))
    }

    /// The picture as the text of an SVG file.
    ///
    /// # Errors
    /// A sentence, where it cannot be drawn.
    pub fn svg(&self) -> Result<String, String> {
        vector::svg(&self.panels)
    }

    /// One SVG per panel, for pages.
    ///
    /// # Errors
    /// A sentence, where one cannot be drawn.
    pub fn svgs(&self) -> Result<Vec<String>, String> {
        self.panels.iter().map(|panel| vector::svg(std::slice::from_ref(panel))).collect()
    }

    /// The picture as the bytes of a PNG file.
    ///
    /// # Errors
    /// A sentence, where it cannot be drawn.
    pub fn png(&self) -> Result<Vec<u8>, String> {
        raster::png(&self.panels)
    }

    /// The picture in letters, for a terminal.
    pub fn text(&self) -> String {
        terminal::text(&self.panels)
    }
}
