//! Exact fields of a contact on the grid of a solver: values at points, or means of the pressure over cells.

mod cells;

use super::load::Steps;
use super::{Dimension, DimensionedNumber, Loads, Quantity, Run, Scene, SceneError};
use crate::contact::State;
use crate::num::Bound;
use crate::scene::file::dimensioned::to_double_double;
use cells::Means;
use std::cell::Cell;

/// The points at which a solver has values, in computing units.
#[derive(Clone, Debug, PartialEq)]
pub enum Grid {
    /// Radii.
    Radial(Loads),
    /// A square of count × count points centred on the axis, with spacing side/count.
    Square {
        /// The side of the square.
        side: f64,
        /// Number of points along the side.
        count: usize,
        /// True if the axis is between four points, false if it is at the point with index count/2.
        between: bool,
    },
    /// A list of points, in any order.
    Points {
        /// The x coordinates, or the radii if `y` is `None`.
        x: Vec<f64>,
        /// The y coordinates; as many as in `x`.
        y: Option<Vec<f64>>,
    },
}

/// Maximum number of points along a side of the square.
pub const LARGEST_GRID: usize = 1 << 13;
/// Maximum number of radii, and of points in a list.
const MOST_RADII: usize = 10_000_000;
/// Number of points computed before their values are kept, which limits the scratch memory.
const PART: usize = 1 << 16;

/// The field under one load: values and errors in output units, or the reason for a missing value.
pub struct Field {
    values: Vec<Result<(f64, f64), &'static str>>,
    square: Option<Square>,
    bound: Bound,
}

/// Index arithmetic of a square grid.
#[derive(Clone, Copy, Debug)]
struct Square {
    count: usize,
    between: bool,
}

impl Square {
    /// Returns the number of steps between a row or column and the axis.
    fn steps(self, index: usize) -> usize {
        let half = self.count / 2;
        if self.between && index < half { half - 1 - index } else { index.abs_diff(half) }
    }

    /// Returns the distance of that many steps, in units of the spacing.
    fn distance(self, steps: usize) -> f64 {
        steps as f64 + if self.between { 0.5 } else { 0.0 }
    }

    /// Returns the largest number of steps.
    fn reach(self) -> usize {
        if self.count == 0 { 0 } else { self.steps(0).max(self.steps(self.count - 1)) }
    }
}

impl Grid {
    /// Returns an error for a grid that is empty or too large.
    ///
    /// # Errors
    /// [`SceneError`] with the expected range.
    pub fn checked(self) -> Result<Self, SceneError> {
        let fault = |message: String, help: &str| Err(SceneError::value(message).help(help));
        match &self {
            Self::Radial(r) if r.is_empty() || r.len() > MOST_RADII => {
                fault(format!("the grid has {} radii", r.len()), "expected 1 to 10000000 radii")
            }
            Self::Radial(r) if r.extremes().is_some_and(|(low, high)| low < 0.0 || !high.is_finite()) => {
                fault("the grid contains a negative or infinite radius".to_owned(), "expected finite radii of at least 0")
            }
            Self::Radial(r) if r.iter().zip(r.iter().skip(1)).any(|(one, next)| next <= one) => {
                fault("the radii of the grid are not increasing".to_owned(), "expected increasing radii")
            }
            Self::Points { x, .. } if x.is_empty() || x.len() > MOST_RADII => {
                fault(format!("the list contains {} points", x.len()), "expected 1 to 10000000 points")
            }
            Self::Points { x, y: None } if x.iter().any(|own| *own < 0.0) => {
                fault("the list contains a negative radius".to_owned(), "expected radii of at least 0, or columns x and y")
            }
            Self::Square { count, .. } if *count == 0 || *count > LARGEST_GRID => {
                fault(format!("the grid has {count} points along a side"), "expected 1 to 8192 points")
            }
            Self::Square { count, between: true, .. } if count % 2 == 1 => {
                fault(format!("{count} points along a side cannot be placed around the axis"), "expected an even number of points")
            }
            Self::Square { side, .. } if !(*side > 0.0 && side.is_finite()) => {
                fault("the side of the grid is not positive".to_owned(), "expected a positive length")
            }
            _ => Ok(self),
        }
    }

    /// Parses a grid: `64`, the number of points along the side of a box in computing units (that of `[data]` by default), or radii such as `0:2 um:101`, as start:stop:count.
    ///
    /// # Errors
    /// [`SceneError`] with the expected form.
    pub fn parse(text: &str, side: Option<f64>, between: bool, scene: &Scene) -> Result<Self, SceneError> {
        let help = "expected 64 with a box, or start:stop:count such as \"0:2 um:101\"";
        let fault = || SceneError::value(format!("cannot parse the grid {text:?}")).help(help);
        let length = |own: &str| {
            let quantity = DimensionedNumber::parse(own)?;
            if !scene.system.has_units() && quantity.unit().is_some() {
                return Err(SceneError::unit(format!("{} has a unit, but the numbers of the scene have none", own.trim()))
                    .help("expected a number without a unit, in the length unit of the scene"));
            }
            to_double_double(&scene.system.exact(&quantity, Dimension::LENGTH, own.trim())?)
        };
        let count = |own: &str| own.trim().parse::<usize>().map_err(|_| fault());
        let grid = match text.split(':').collect::<Vec<_>>().as_slice() {
            [only] => {
                let count = count(only)?;
                let declared = scene.data.as_ref().and_then(|own| own.side);
                let missing = || SceneError::missing("the grid has no box").help("expected the side of the domain, such as \"8 um\"");
                Self::Square { side: side.or(declared).ok_or_else(missing)?, count, between }
            }
            [start, stop, number] => Self::Radial(Loads::Range(Steps::new(length(start)?, length(stop)?, count(number)?, false))),
            _ => return Err(fault()),
        };
        grid.checked()
    }

    /// Returns the finest grid that the scene declares for a solver's data.
    pub fn declared(scene: &Scene, between: bool) -> Option<Self> {
        let data = scene.data.as_ref()?;
        let count = data.grid.iter().copied().max_by(f64::total_cmp)? as usize;
        Some(Self::Square { side: data.side?, count, between })
    }

    /// Returns the number of points along each direction.
    pub fn shape(&self) -> Vec<usize> {
        match self {
            Self::Radial(r) => vec![r.len()],
            Self::Points { x, .. } => vec![x.len()],
            Self::Square { count, .. } => vec![*count, *count],
        }
    }

    /// Returns the radius of the point with this index.
    fn radius(&self, index: usize) -> f64 {
        match self {
            Self::Points { y: Some(y), .. } => self.coordinate(index).hypot(y.get(index).copied().unwrap_or(f64::NAN)),
            _ => self.coordinate(index),
        }
    }

    /// Returns x, y and r of the point with this index in a list, or its radius if only radii are known.
    pub fn place(&self, index: usize) -> Vec<f64> {
        let own = self.coordinate(index);
        match self {
            Self::Points { y: Some(y), .. } => vec![own, y.get(index).copied().unwrap_or(f64::NAN), self.radius(index)],
            _ => vec![own],
        }
    }

    /// Returns the coordinate of a row or column, or x of a listed point, or the radius with this index.
    pub fn coordinate(&self, index: usize) -> f64 {
        match self {
            Self::Radial(r) => r.get(index).unwrap_or(f64::NAN),
            Self::Points { x, .. } => x.get(index).copied().unwrap_or(f64::NAN),
            Self::Square { side, count, between } => {
                let steps = index as f64 - (count / 2) as f64 + if *between { 0.5 } else { 0.0 };
                steps * (side / *count as f64)
            }
        }
    }

    /// The side of a cell of the square, or the width of the ring around the radius of an index; 0 for a list of points, which have no cells.
    pub fn cell_width(&self, index: usize) -> f64 {
        match self {
            Self::Points { .. } => 0.0,
            Self::Radial(radii) => {
                let [inner, outer] = ring(radii, index);
                outer - inner
            }
            Self::Square { side, count, .. } => side / *count as f64,
        }
    }

    /// Returns the number of points to compute; for a square, they are in one octant.
    pub fn distinct(&self) -> usize {
        match (self, self.square()) {
            (_, Some(square)) => triangle(square.reach(), square.reach()) + 1,
            (Self::Radial(r), None) => r.len(),
            (Self::Points { x, .. }, None) => x.len(),
            _ => 0,
        }
    }

    /// The points x ≥ y ≥ 0 of a square in units of its spacing, in the order of [`triangle`]; none for other grids.
    fn octant(&self) -> impl Iterator<Item = [f64; 2]> {
        let rows = self.square().into_iter().flat_map(|own| (0..=own.reach()).map(move |i| (own, i)));
        rows.flat_map(|(own, i)| (0..=i).map(move |j| [i, j].map(|steps| own.distance(steps))))
    }

    fn square(&self) -> Option<Square> {
        match self {
            Self::Radial(_) | Self::Points { .. } => None,
            Self::Square { count, between, .. } => Some(Square { count: *count, between: *between }),
        }
    }
}

impl Field {
    /// Returns the value at a radius, or at a row (y) and column (x) of a square.
    pub fn at(&self, place: &[usize]) -> Result<(f64, f64), &'static str> {
        let index = match (self.square, place) {
            (None, [index]) => *index,
            (Some(square), [row, column]) => {
                let (one, other) = (square.steps(*row), square.steps(*column));
                triangle(one.max(other), one.min(other))
            }
            _ => return Err("the index is out of range"),
        };
        self.values.get(index).copied().unwrap_or(Err("the index is out of range"))
    }

    /// Returns whether the errors are proven; they are if all of them are.
    pub fn bound(&self) -> Bound {
        self.bound
    }
}

const NO_DIGITS: &str = "no digit of the value is reliable";
/// Returns the index of the pair i ≥ j ≥ 0 in the octant.
fn triangle(i: usize, j: usize) -> usize {
    i * (i + 1) / 2 + j
}

impl Run<'_> {
    /// Computes g, f, p or u of a state on a grid; with `cells` the pressure is the mean over the cell around each point.
    ///
    /// The cells of a square are squares; the cells of radii are rings that end halfway between them, the first one at the axis.
    /// Points that are equivalent by symmetry are computed once.
    ///
    /// ```
    /// use sneddon::scene::{Quantity, Grid, Loads, Run, Scene};
    /// use sneddon::{parse, transform::Profile};
    /// let tip = Profile::new(&parse::profile("r^2/(2*10)").unwrap()).unwrap();
    /// let scene = Scene { effective_modulus: 3.0, loads: Loads::List(vec![0.1]), ..Scene::of(tip) };
    /// let solution = scene.solution().unwrap();
    /// let run = Run::new(&scene, &solution).unwrap();
    /// let grid = Grid::Square { side: 4.0, count: 64, between: false };
    /// let field = run.field(&grid, Quantity::Pressure, run.state(0, false).as_ref(), true);
    /// let (mean, error) = field.at(&[32, 40]).unwrap();
    /// assert!(mean > 0.0 && error < 1e-10 * mean);
    /// ```
    pub fn field(&self, grid: &Grid, curve: Quantity, state: Option<&State>, cells: bool) -> Field {
        let bound = Cell::new(Bound::Proven);
        let has_cells = cells && curve == Quantity::Pressure && !matches!(grid, Grid::Points { .. });
        let pressed = state.filter(|own| has_cells && own.radius > 0.0);
        let means = pressed.map(|state| Means::new(self, state, grid.distinct(), &bound));
        let step = grid.cell_width(0);
        let values = match (&means, grid) {
            (Some(means), Grid::Radial(radii)) => (0..grid.distinct()).map(|index| means.on_ring(ring(radii, index))).collect(),
            (Some(means), _) => {
                // A cell on an axis consists of two equal halves.
                let sides = |steps: f64| [(steps - 0.5).max(0.0) * step, (steps + 0.5) * step];
                grid.octant().map(|[x, y]| means.on_rectangle(sides(x), sides(y))).collect()
            }
            (None, _) => {
                self.expect(grid.distinct());
                let radii: Vec<f64> = match grid {
                    Grid::Square { .. } => grid.octant().map(|[x, y]| (x * step).hypot(y * step)).collect(),
                    _ => (0..grid.distinct()).map(|index| grid.radius(index)).collect(),
                };
                let points = radii.chunks(PART).flat_map(|part| self.points(curve, state, part));
                points.inspect(|own| bound.set(bound.get().and(own.bound))).map(|own| own.value).collect()
            }
        };
        Field { values, square: grid.square(), bound: bound.get() }
    }
}

/// Returns the ring around a radius, which ends halfway to its neighbours; the first ring begins at the axis, the last one is symmetric.
fn ring(radii: &Loads, index: usize) -> [f64; 2] {
    let own = radii.get(index).unwrap_or(0.0);
    let halfway = |other: Option<f64>| other.map(|other| 0.5 * (own + other));
    let before = index.checked_sub(1).and_then(|index| halfway(radii.get(index)));
    let after = halfway(radii.get(index + 1));
    let inner = before.unwrap_or(0.0);
    let outer = after.unwrap_or(if index == 0 { 2.0 * own } else { 2.0 * own - inner });
    [inner, outer]
}
