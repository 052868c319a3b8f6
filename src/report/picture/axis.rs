//! Axes: a range with round ends and ticks at round numbers.

/// A range with its ticks.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// The ticks, in increasing order.
    pub ticks: Vec<f64>,
    /// The distance between two ticks.
    step: f64,
}

impl Axis {
    /// Creates an axis for the numbers in a list and 0, with round ends and about `wanted` ticks at most; infinite and NaN values are ignored.
    pub fn round(values: impl Iterator<Item = f64>, wanted: u32) -> Self {
        let (low, high) = values.filter(|v| v.is_finite()).fold((0.0_f64, 0.0_f64), |(low, high), v| (low.min(v), high.max(v)));
        let width = (high - low) / f64::from(wanted.max(1));
        let step = if width.is_finite() && width > 0.0 { round_up(width) } else { 0.0 };
        let (first, last) = ((low / step).floor(), (high / step).ceil());
        if !(step.is_normal() && first.is_finite() && last.is_finite() && (last * step).is_finite() && (first * step).is_finite()) {
            return Self { low: 0.0, high: 1.0, ticks: vec![0.0, 0.5, 1.0], step: 0.5 };
        }
        let mut ticks = Vec::new();
        let mut index = first;
        while index <= last {
            ticks.push(index * step);
            index += 1.0;
        }
        Self { low: first * step, high: last * step, ticks, step }
    }

    /// Formats a tick with as many digits as its neighbours need.
    pub fn text(&self, tick: f64) -> String {
        let size = self.low.abs().max(self.high.abs());
        if tick.abs() < 1e-6 * self.step {
            return "0".to_owned();
        }
        let (exponent, finest) = (size.log10().floor(), self.step.log10().floor());
        let digits = |exponent: f64| (exponent - finest).clamp(0.0, 12.0) as usize;
        if (-3.0..5.0).contains(&exponent) {
            return format!("{tick:.*}", digits(0.0));
        }
        let unit = 10.0_f64.powf(exponent);
        if !unit.is_normal() {
            return format!("{tick:.1e}");
        }
        format!("{:.*}e{exponent}", digits(exponent), tick / unit)
    }
}

/// Returns the smallest of 1, 2 and 5 times a power of ten that is at least as large as a positive number.
fn round_up(width: f64) -> f64 {
    let unit = 10.0_f64.powf(width.log10().floor());
    let factor = [1.0, 2.0, 5.0].into_iter().find(|factor| factor * unit >= width * (1.0 - 1e-9)).unwrap_or(10.0);
    // Dividing by an exact power of ten is more accurate than multiplying by its inverse.
    if unit < 1.0 { factor / (1.0 / unit).round() } else { factor * unit }
}
