//! Axes: a range with round ends, and the ticks that a person would choose.

/// A range with its ticks.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    /// The lower end.
    pub(super) low: f64,
    /// The upper end.
    pub(super) high: f64,
    /// The ticks, in rising order.
    pub(super) ticks: Vec<f64>,
    /// The distance of two ticks.
    step: f64,
}

impl Axis {
    /// An axis over every number of a list and 0, with round ends and at most about `wanted` ticks; numbers that are not finite are ignored.
    pub(super) fn round(values: impl Iterator<Item = f64>, wanted: u32) -> Self {
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

    /// A tick with as many digits as its neighbours need.
    pub(super) fn text(&self, tick: f64) -> String {
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

/// The smallest of 1, 2 and 5 times a power of ten that is not below a positive number.
fn round_up(width: f64) -> f64 {
    let unit = 10.0_f64.powf(width.log10().floor());
    let factor = [1.0, 2.0, 5.0].into_iter().find(|factor| factor * unit >= width * (1.0 - 1e-9)).unwrap_or(10.0);
    // A quotient by a power of ten that is exact is nearer than a product.
    if unit < 1.0 { factor / (1.0 / unit).round() } else { factor * unit }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_cover_the_numbers() {
        let texts = |values: &[f64]| {
            let axis = Axis::round(values.iter().copied(), 6);
            axis.ticks.iter().map(|tick| axis.text(*tick)).collect::<Vec<_>>().join(" ")
        };
        assert_eq!(texts(&[0.0, 1.0]), "0 0.2 0.4 0.6 0.8 1.0");
        assert_eq!(texts(&[0.3, 2.9]), "0 0.5 1.0 1.5 2.0 2.5 3.0");
        assert_eq!(texts(&[-3.0, 250.0]), "-50 0 50 100 150 200 250");
        assert_eq!(texts(&[2.1e-9]), "0 0.5e-9 1.0e-9 1.5e-9 2.0e-9 2.5e-9");
        assert_eq!(texts(&[3.3e7]), "0 1e7 2e7 3e7 4e7");
        // What has no extent still gives an axis.
        assert_eq!(texts(&[]), "0 0.5 1.0");
        assert_eq!(texts(&[f64::NAN, f64::INFINITY]), "0 0.5 1.0");
        for size in (-300..300).map(|exponent| 10.0_f64.powi(exponent)) {
            let axis = Axis::round([3.7 * size].into_iter(), 6);
            assert!(axis.low == 0.0 && axis.high >= 3.7 * size && (3..9).contains(&axis.ticks.len()), "{axis:?}");
        }
    }
}
