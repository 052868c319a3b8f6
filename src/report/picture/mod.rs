//! Plots of curves: panels with axes and lines, drawn as SVG, as PNG, or in a terminal.

pub(super) mod axis;
mod contact;
mod raster;
mod terminal;
mod vector;

pub use contact::Pictured;

use axis::Axis;

/// Panels, arranged vertically.
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
    /// The coordinates at which a line is infinite, in increasing order, and whether the value is plus infinity.
    infinite: Vec<(f64, bool)>,
    /// The largest magnitude that is shown, if values are unbounded.
    most: Option<f64>,
}

/// A line through points; NaN interrupts it, and an infinite value is drawn to the end of the axis.
#[derive(Clone, Debug)]
struct Line {
    name: String,
    points: Vec<(f64, f64)>,
}

/// Approximate number of ticks of a vertical axis.
const TICKS: u32 = 6;
/// Width of a picture and height of a panel in pixels.
const PANEL: (u32, u32) = (860, 380);
/// Points closer to an infinite value than this fraction of the width do not affect the height of the axis.
const CLOSE: f64 = 0.04;
/// Height of an axis with infinite values, relative to the largest value far from them.
const ROOM: f64 = 1.2;
/// Curves are clipped above this multiple of their typical value.
const PEAK: f64 = 6.0;

impl Panel {
    fn new(title: &str, horizontal: String, vertical: String, lines: Vec<Line>) -> Self {
        let places = lines.iter().flat_map(|line| &line.points).filter(|(_, y)| y.is_infinite());
        let mut infinite: Vec<(f64, bool)> = places.map(|(x, y)| (*x, *y > 0.0)).collect();
        infinite.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
        infinite.dedup();
        let mut panel = Self { title: title.to_owned(), horizontal, vertical, lines, infinite, most: None };
        panel.most = panel.highest();
        panel
    }

    /// Returns the largest magnitude that is shown; `None` if all values are.
    fn highest(&self) -> Option<f64> {
        let points = || self.lines.iter().flat_map(|line| &line.points).filter(|(x, y)| x.is_finite() && y.is_finite());
        if !self.infinite.is_empty() {
            let (low, high) = points().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (x, _)| (low.min(*x), high.max(*x)));
            let is_far = |x: f64| self.infinite.iter().all(|(at, _)| (x - at).abs() > CLOSE * (high - low));
            let far = points().filter(|(x, _)| is_far(*x)).map(|(_, y)| y.abs()).fold(0.0, f64::max);
            let axis = Axis::round(points().map(|(_, y)| y.clamp(-ROOM * far, ROOM * far)), TICKS);
            // The line ends at the end of the axis, not below it.
            return Some(axis.high.max(-axis.low));
        }
        let mut sizes: Vec<f64> = points().map(|(_, y)| y.abs()).collect();
        sizes.sort_by(f64::total_cmp);
        let usual = sizes.get(sizes.len() * 19 / 20).copied().unwrap_or(0.0);
        sizes.last().filter(|largest| **largest > PEAK * usual && usual > 0.0).map(|_| 1.5 * usual)
    }

    /// Returns the parts of a line between gaps, within the visible range.
    fn parts(&self, line: &Line) -> Vec<Vec<(f64, f64)>> {
        let most = self.most.unwrap_or(f64::INFINITY);
        if self.infinite.is_empty() {
            let parts = line.points.split(|(x, y)| !(x.is_finite() && y.abs() <= most));
            return parts.filter(|part| !part.is_empty()).map(<[_]>::to_vec).collect();
        }
        let is_shown = |(x, y): &(f64, f64)| x.is_finite() && y.abs() <= most;
        let mut parts = Vec::new();
        for (at, own) in line.points.iter().enumerate().filter(|(_, own)| is_shown(own)) {
            let before = at.checked_sub(1).and_then(|index| line.points.get(index));
            let after = line.points.get(at + 1);
            if !before.is_some_and(is_shown) {
                parts.push(before.and_then(|other| leaving(*own, *other, most)).into_iter().collect::<Vec<_>>());
            }
            if let Some(part) = parts.last_mut() {
                part.push(*own);
                part.extend(after.filter(|other| !is_shown(other)).and_then(|other| leaving(*own, *other, most)));
            }
        }
        parts
    }

    /// Describes the coordinates at which the lines are infinite; empty if there are none.
    fn notice(&self) -> String {
        let (coordinate, unit) = self.horizontal.split_once(" (").map_or((self.horizontal.as_str(), ""), |(name, unit)| (name, unit));
        let notice = |(wanted, word): (bool, &str)| {
            let places = self.infinite.iter().filter(|own| own.1 == wanted);
            let places: Vec<String> =
                places.map(|own| format!("{:.6}", own.0).trim_end_matches('0').trim_end_matches('.').to_owned()).collect();
            let all = format!("{word} at {coordinate} = {} {}", places.join(", "), unit.trim_end_matches(')')).trim_end().to_owned();
            (!places.is_empty()).then_some(all)
        };
        [(true, "infinite"), (false, "minus infinity")].into_iter().filter_map(notice).collect::<Vec<_>>().join("; ")
    }

    fn axes(&self) -> (Axis, Axis) {
        let shown: Vec<(f64, f64)> = self.lines.iter().flat_map(|line| self.parts(line)).flatten().collect();
        // Stay slightly inside, so that rounding of a chosen end adds no tick.
        let within = if self.infinite.is_empty() { 1.0 } else { 1.0 - 1e-9 };
        (Axis::round(shown.iter().map(|(x, _)| *x), 8), Axis::round(shown.iter().map(|(_, y)| within * *y), TICKS))
    }

    /// Returns true if the lines are higher at their beginning than at their end, so that the legend fits better on the right.
    fn falls(&self) -> bool {
        let ends = self.lines.iter().filter_map(|line| {
            let parts = self.parts(line);
            Some((parts.first()?.first()?.1, parts.last()?.last()?.1))
        });
        let (first, last) =
            ends.fold((f64::NEG_INFINITY, f64::NEG_INFINITY), |(first, last), (one, other)| (one.max(first), other.max(last)));
        first > last
    }

    /// Returns a description of the picture for screen readers.
    fn description(&self) -> String {
        let names: Vec<&str> = self.lines.iter().map(|line| line.name.as_str()).filter(|name| !name.is_empty()).collect();
        let of = if names.is_empty() { String::new() } else { format!(": {}", names.join(", ")) };
        let infinite = Some(self.notice()).filter(|own| !own.is_empty()).map_or(String::new(), |own| format!("; {own}"));
        format!("{}, {} over {}{of}{infinite}", self.title, self.vertical, self.horizontal)
    }
}

/// Returns the point at which a line leaves the picture between a point inside and a point outside; `None` towards a gap.
fn leaving((x, y): (f64, f64), (other, beyond): (f64, f64), most: f64) -> Option<(f64, f64)> {
    if beyond.is_nan() || !other.is_finite() {
        return None;
    }
    // An infinite value has the sign of its neighbour.
    let end = if beyond.is_infinite() { most.copysign(y) } else { most.copysign(beyond) };
    let share = if beyond.is_infinite() { 1.0 } else { (end - y) / (beyond - y) };
    Some((x + share * (other - x), end))
}

impl Picture {
    /// Returns true if there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.panels.iter().all(|panel| panel.lines.iter().all(|line| panel.parts(line).is_empty()))
    }

    /// Returns the picture as the text of an SVG file.
    ///
    /// # Errors
    /// Returns a sentence if the picture cannot be drawn.
    pub fn svg(&self) -> Result<String, String> {
        vector::svg(&self.panels)
    }

    /// Returns one SVG per panel, for pages.
    ///
    /// # Errors
    /// Returns a sentence if a panel cannot be drawn.
    pub fn svgs(&self) -> Result<Vec<String>, String> {
        self.panels.iter().map(|panel| vector::svg(std::slice::from_ref(panel))).collect()
    }

    /// Returns the picture as the bytes of a PNG file.
    ///
    /// # Errors
    /// Returns a sentence if the picture cannot be drawn.
    pub fn png(&self) -> Result<Vec<u8>, String> {
        raster::png(&self.panels)
    }

    /// Returns the picture as text for a terminal.
    pub fn text(&self) -> String {
        terminal::text(&self.panels)
    }
}
