//! Loads: a number, a list or a range, of depth, force or contact radius.

use super::Datum;
use crate::contact;

/// What is controlled.
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
    /// The key in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Depth => "depth",
            Self::Force => "force",
            Self::ContactRadius => "contact_radius",
        }
    }

    /// The number of a row that it is.
    pub fn datum(self) -> Datum {
        match self {
            Self::Depth => Datum::Depth,
            Self::Force => Datum::Force,
            Self::ContactRadius => Datum::Radius,
        }
    }

    /// The load of a value.
    pub fn load(self, value: f64) -> contact::Load {
        match self {
            Self::Depth => contact::Load::Depth(value),
            Self::Force => contact::Load::Force(value),
            Self::ContactRadius => contact::Load::Radius(value),
        }
    }
}

/// Many numbers, of which a range needs no memory.
///
/// ```
/// use sneddon::scene::Loads;
/// let range = Loads::Range { start: 0.0, stop: 1.0, count: 5, logarithmic: false };
/// assert_eq!(range.iter().collect::<Vec<_>>(), [0.0, 0.25, 0.5, 0.75, 1.0]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Loads {
    /// Numbers one by one.
    List(Vec<f64>),
    /// Evenly or logarithmically spaced numbers.
    Range {
        /// The first one.
        start: f64,
        /// The last one.
        stop: f64,
        /// How many.
        count: usize,
        /// Whether their logarithms are evenly spaced.
        logarithmic: bool,
    },
}

impl Loads {
    /// How many there are.
    pub fn len(&self) -> usize {
        match self {
            Self::List(list) => list.len(),
            Self::Range { count, .. } => *count,
        }
    }

    /// True where there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The number of an index; both ends of a range exactly.
    pub fn get(&self, index: usize) -> Option<f64> {
        match self {
            Self::List(list) => list.get(index).copied(),
            Self::Range { count, .. } if index >= *count => None,
            Self::Range { start, .. } if index == 0 => Some(*start),
            Self::Range { stop, count, .. } if index + 1 == *count => Some(*stop),
            Self::Range { start, stop, count, logarithmic } => {
                let t = index as f64 / (*count - 1) as f64;
                Some(if *logarithmic { (start.ln() + t * (stop.ln() - start.ln())).exp() } else { start + t * (stop - start) })
            }
        }
    }

    /// All of them in order.
    pub fn iter(&self) -> impl Iterator<Item = f64> + '_ {
        (0..self.len()).filter_map(|index| self.get(index))
    }

    /// The numbers of a list, or the two ends of a range.
    pub(super) fn ends(&self) -> Vec<f64> {
        match self {
            Self::List(list) => list.clone(),
            Self::Range { start, stop, .. } => vec![*start, *stop],
        }
    }

    /// The smallest and the largest one.
    pub fn extremes(&self) -> Option<(f64, f64)> {
        match self {
            Self::List(list) => {
                let low = list.iter().copied().min_by(f64::total_cmp)?;
                Some((low, list.iter().copied().max_by(f64::total_cmp)?))
            }
            Self::Range { start, stop, count, .. } if *count > 1 => Some((start.min(*stop), start.max(*stop))),
            Self::Range { start, .. } => Some((*start, *start)),
        }
    }
}
