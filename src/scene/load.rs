//! Loads: a number, a list or a range, of depth, force or contact radius.

use super::Quantity;
use crate::contact;
use crate::num::DoubleDouble;
use crate::num::precise::{exp, ln};

/// The controlled quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Control {
    /// The displacement of the indenter.
    Depth,
    /// The normal force.
    Force,
    /// The contact radius.
    ContactRadius,
}

impl Control {
    /// Returns the key in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Depth => "depth",
            Self::Force => "force",
            Self::ContactRadius => "contact_radius",
        }
    }

    /// Returns the value of the controlled quantity in a row.
    pub fn datum(self) -> Quantity {
        match self {
            Self::Depth => Quantity::Depth,
            Self::Force => Quantity::Force,
            Self::ContactRadius => Quantity::Radius,
        }
    }

    /// Returns the load with this value.
    pub fn load(self, value: f64) -> contact::Load {
        match self {
            Self::Depth => contact::Load::Depth(value),
            Self::Force => contact::Load::Force(value),
            Self::ContactRadius => contact::Load::Radius(value),
        }
    }
}

/// A list of numbers, or a range that is not stored element by element.
///
/// ```
/// use sneddon::scene::{Loads, Steps};
/// let range = Loads::Range(Steps::new(0.0.into(), 1.0.into(), 5, false));
/// assert_eq!(range.iter().collect::<Vec<_>>(), [0.0, 0.25, 0.5, 0.75, 1.0]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Loads {
    /// Explicit numbers.
    List(Vec<f64>),
    /// Evenly or logarithmically spaced numbers.
    Range(Steps),
}

/// A range whose values are rounded only once: its ends have 31 digits, so that two steps of 0.05 from 0.05 give 0.15.
#[derive(Clone, Debug, PartialEq)]
pub struct Steps {
    ends: (f64, f64),
    /// The ends, or their logarithms.
    from: DoubleDouble,
    to: DoubleDouble,
    count: usize,
    logarithmic: bool,
}

impl Steps {
    /// Creates a range of `count` numbers; both ends of a logarithmic range must be positive.
    pub fn new(start: DoubleDouble, stop: DoubleDouble, count: usize, logarithmic: bool) -> Self {
        let (from, to) = if logarithmic { (ln(start), ln(stop)) } else { (start, stop) };
        Self { ends: (start.value(), stop.value()), from, to, count, logarithmic }
    }

    fn get(&self, index: usize) -> Option<f64> {
        if index >= self.count {
            return None;
        }
        if index == 0 {
            return Some(self.ends.0);
        }
        let last = self.count - 1;
        if index == last {
            return Some(self.ends.1);
        }
        // Weight both ends, so that a range from −x to x contains 0.
        let share = |end: DoubleDouble, steps: usize| end.mul((steps as f64).into());
        let between = share(self.from, last - index).add(share(self.to, index)).over(last as f64);
        let value = if self.logarithmic { exp(between).value() } else { between.value() };
        if value.is_finite() {
            let nothing = 1e-30 * self.ends.0.abs().max(self.ends.1.abs());
            return Some(if !self.logarithmic && value.abs() < nothing { 0.0 } else { value });
        }
        // Near the largest numbers, 31 digits would overflow.
        let t = index as f64 / last as f64;
        Some(if self.logarithmic {
            (self.ends.0.ln() * (1.0 - t) + t * self.ends.1.ln()).exp()
        } else {
            self.ends.0 * (1.0 - t) + t * self.ends.1
        })
    }
}

impl Loads {
    /// Returns the number of values.
    pub fn len(&self) -> usize {
        match self {
            Self::List(list) => list.len(),
            Self::Range(steps) => steps.count,
        }
    }

    /// Returns `true` if the list contains no values.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns the value with this index; both ends of a range are exact.
    pub fn get(&self, index: usize) -> Option<f64> {
        match self {
            Self::List(list) => list.get(index).copied(),
            Self::Range(steps) => steps.get(index),
        }
    }

    /// Returns all values in order.
    pub fn iter(&self) -> impl Iterator<Item = f64> + '_ {
        (0..self.len()).filter_map(|index| self.get(index))
    }

    /// Returns the numbers of a list, or the two ends of a range.
    pub(super) fn ends(&self) -> Vec<f64> {
        match self {
            Self::List(list) => list.clone(),
            Self::Range(steps) => vec![steps.ends.0, steps.ends.1],
        }
    }

    /// Returns the smallest and the largest value.
    pub fn extremes(&self) -> Option<(f64, f64)> {
        match self {
            Self::List(list) => {
                let low = list.iter().copied().min_by(f64::total_cmp)?;
                Some((low, list.iter().copied().max_by(f64::total_cmp)?))
            }
            Self::Range(steps) if steps.count > 1 => Some((steps.ends.0.min(steps.ends.1), steps.ends.0.max(steps.ends.1))),
            Self::Range(steps) => Some((steps.ends.0, steps.ends.0)),
        }
    }
}
