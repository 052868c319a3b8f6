//! Exact fields of a contact on the grid of a solver: values at points, or means of the pressure over cells.

use super::load::Steps;
use super::{Dimension, DimensionedNumber, Loads, Point, Quantity, Run, Scene, SceneError};
use crate::contact::{ContactError, PartialForce, State};
use crate::num::{Bound, Estimate, work};
use crate::scene::file::dimensioned::to_double_double;
use std::cell::Cell;
use std::f64::consts::PI;

/// Places of a solver's values, in computed units.
#[derive(Clone, Debug, PartialEq)]
pub enum Grid {
    /// Radii.
    Radial(Loads),
    /// A square of count × count points about the axis, side/count apart.
    Square {
        /// The side of the square.
        side: f64,
        /// Points along it.
        count: usize,
        /// True where the axis lies between four points, not at the point of index count/2.
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

/// A field of one load: value and error in the units of the answers, or why there is none.
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
    /// How many steps a row or column lies from the axis.
    fn steps(self, index: usize) -> usize {
        let half = self.count / 2;
        if self.between && index < half { half - 1 - index } else { index.abs_diff(half) }
    }

    /// The distance of that many steps, in steps.
    fn distance(self, steps: usize) -> f64 {
        steps as f64 + if self.between { 0.5 } else { 0.0 }
    }

    /// The largest number of steps.
    fn reach(self) -> usize {
        if self.count == 0 { 0 } else { self.steps(0).max(self.steps(self.count - 1)) }
    }
}

impl Grid {
    /// Refuses a grid that is empty or too large.
    ///
    /// # Errors
    /// [`SceneError`] with what would be accepted.
    pub fn checked(self) -> Result<Self, SceneError> {
        let fault = |message: String, help: &str| Err(SceneError::value(message).help(help));
        match &self {
            Self::Radial(r) if r.is_empty() || r.len() > MOST_RADII => {
                fault(format!("a grid of {} radii is not possible", r.len()), "1 to 10000000 radii would be accepted")
            }
            Self::Radial(r) if r.extremes().is_some_and(|(low, high)| low < 0.0 || !high.is_finite()) => {
                fault("the grid has a negative radius".to_owned(), "radii from 0 on would be accepted")
            }
            Self::Radial(r) if r.iter().zip(r.iter().skip(1)).any(|(one, next)| next <= one) => {
                fault("the radii of the grid do not rise".to_owned(), "rising radii would be accepted")
            }
            Self::Points { x, .. } if x.is_empty() || x.len() > MOST_RADII => {
                fault(format!("the list contains {} points", x.len()), "expected 1 to 10000000 points")
            }
            Self::Points { x, y: None } if x.iter().any(|own| *own < 0.0) => {
                fault("the list contains a negative radius".to_owned(), "expected radii of at least 0, or columns x and y")
            }
            Self::Square { count, .. } if *count == 0 || *count > LARGEST_GRID => {
                fault(format!("a grid of {count} points along a side is not possible"), "1 to 8192 points would be accepted")
            }
            Self::Square { count, between: true, .. } if count % 2 == 1 => {
                fault(format!("the axis of {count} points along a side is a point"), "an even number of points would be accepted")
            }
            Self::Square { side, .. } if !(*side > 0.0 && side.is_finite()) => {
                fault("the side of the grid is not positive".to_owned(), "a length above 0 would be accepted")
            }
            _ => Ok(self),
        }
    }

    /// A grid as typed: `64`, the number of points along the side of a box, or `0:2 um:101`, radii from, to and how many.
    ///
    /// # Errors
    /// [`SceneError`] with what would be accepted.
    pub fn parse(text: &str, side: Option<&str>, between: bool, scene: &Scene) -> Result<Self, SceneError> {
        let help = "64 with a box, or start:stop:count such as \"0:2 um:101\", would be accepted";
        let fault = || SceneError::value(format!("the grid {text:?} is not understood")).help(help);
        let length = |own: &str| {
            let quantity = DimensionedNumber::parse(own)?;
            if !scene.system.has_units() && quantity.unit().is_some() {
                return Err(SceneError::unit(format!("{} has a unit, and the numbers of the scene have none", own.trim()))
                    .help("a bare number would be accepted: it counts in the scene's length"));
            }
            to_double_double(&scene.system.exact(&quantity, Dimension::LENGTH, "the grid")?)
        };
        let count = |own: &str| own.trim().parse::<usize>().map_err(|_| fault());
        let grid = match text.split(':').collect::<Vec<_>>().as_slice() {
            [only] => {
                let count = count(only)?;
                let declared = scene.data.as_ref().and_then(|own| own.side);
                let side = side.map(length).transpose()?.map(|own| own.value()).or(declared);
                let missing =
                    || SceneError::missing("the grid has no box").help("--box \"8 um\", the side of the domain, would be accepted");
                Self::Square { side: side.ok_or_else(missing)?, count, between }
            }
            [start, stop, number] => Self::Radial(Loads::Range(Steps::new(length(start)?, length(stop)?, count(number)?, false))),
            _ => return Err(fault()),
        };
        grid.checked()
    }

    /// The finest grid that the scene declares of a solver's data.
    pub fn declared(scene: &Scene, between: bool) -> Option<Self> {
        let data = scene.data.as_ref()?;
        let count = data.grid.iter().copied().max_by(f64::total_cmp)? as usize;
        Some(Self::Square { side: data.side?, count, between })
    }

    /// The numbers of points along each direction.
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

    /// How many places are computed: those of an octant of a square.
    pub fn distinct(&self) -> usize {
        match (self, self.square()) {
            (_, Some(square)) => triangle(square.reach(), square.reach()) + 1,
            (Self::Radial(r), None) => r.len(),
            (Self::Points { x, .. }, None) => x.len(),
            _ => 0,
        }
    }

    fn square(&self) -> Option<Square> {
        match self {
            Self::Radial(_) | Self::Points { .. } => None,
            Self::Square { count, between, .. } => Some(Square { count: *count, between: *between }),
        }
    }
}

impl Field {
    /// The value of a radius, or of a row (y) and column (x) of a square.
    pub fn at(&self, place: &[usize]) -> Result<(f64, f64), &'static str> {
        let index = match (self.square, place) {
            (None, [index]) => *index,
            (Some(square), [row, column]) => {
                let (one, other) = (square.steps(*row), square.steps(*column));
                triangle(one.max(other), one.min(other))
            }
            _ => return Err("there is no such place"),
        };
        self.values.get(index).copied().unwrap_or(Err("there is no such place"))
    }

    /// What the errors rest on: they are proven where all of them are.
    pub fn bound(&self) -> Bound {
        self.bound
    }
}

/// The index of the pair i ≥ j ≥ 0 in the octant.
fn triangle(i: usize, j: usize) -> usize {
    i * (i + 1) / 2 + j
}

impl Run<'_> {
    /// g, f, p or u of a state on a grid; with `cells` the pressure is the mean over the cell around each point.
    ///
    /// The cells of a square are squares; those of radii are rings that end halfway between them, the first one at the axis.
    /// What lies symmetrically to the axes and the diagonals is computed once.
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
        let length = self.scene().system.out(Dimension::LENGTH);
        let means = if cells && curve == Quantity::Pressure { state.filter(|own| own.radius > 0.0) } else { None };
        let means = means.map(|state| {
            (PartialForce::new(&self.contact(state), state.radius, self.kinks().into_iter().map(|own| own.0 / length)), state)
        });
        let factor = self.scene().system.out(Dimension::PRESSURE);
        let bound = Cell::new(Bound::Proven);
        let seen = |point: Point| {
            bound.set(bound.get().and(point.bound));
            point.value
        };
        let doubt = means.as_ref().and_then(|(_, state)| self.doubt(state));
        let mean = |force: Result<Estimate, ContactError>, area: f64, ends: [f64; 2], diagonal: Option<f64>| match (force, doubt) {
            (Ok(own), Some(doubt)) if own.value.is_finite() && own.error.is_finite() => {
                self.told();
                bound.set(bound.get().and(own.bound).and(doubt.bound));
                let value = own.value / area;
                let inherited = doubt.of_mean(ends, diagonal, area, value);
                Ok((value * factor, (own.error / area + 2.0 * f64::EPSILON * value.abs() + inherited) * factor.abs()))
            }
            _ => Err("it cannot be computed to any digit"),
        };
        let mut values = Vec::new();
        match grid.square() {
            None => {
                for index in 0..grid.distinct() {
                    values.push(match (&means, grid) {
                        _ if work::is_exhausted() => Err(self.point_is_cut()),
                        (Some((Err(_), _)), _) => Err("it cannot be computed to any digit"),
                        (Some((Ok(force), _)), Grid::Radial(radii)) => {
                            let [inner, outer] = ring(radii, index);
                            mean(force.on_ring(inner, outer), PI * (outer - inner) * (outer + inner), [inner, outer], None)
                        }
                        _ => seen(self.point(curve, state, grid.radius(index))),
                    });
                }
                Field { values, square: None, bound: bound.get() }
            }
            Some(square) => {
                let Grid::Square { side, count, .. } = grid else { return Field { values, square: None, bound: bound.get() } };
                let step = side / *count as f64;
                for i in 0..=square.reach() {
                    for j in 0..=i {
                        let (x, y) = (square.distance(i), square.distance(j));
                        values.push(match &means {
                            _ if work::is_exhausted() => Err(self.point_is_cut()),
                            None => seen(self.point(curve, state, (x * step).hypot(y * step))),
                            Some((Err(_), _)) => Err("it cannot be computed to any digit"),
                            // A cell on an axis is twice its half.
                            Some((Ok(_), state)) if (x - 0.5).max(0.0).hypot((y - 0.5).max(0.0)) * step >= state.radius => Ok((0.0, 0.0)),
                            Some((Ok(force), _)) => {
                                let half = |own: f64| [(own - 0.5).max(0.0) * step, (own + 0.5) * step];
                                let ([x0, x1], [y0, y1]) = (half(x), half(y));
                                let (ends, diagonal) = ([x0.hypot(y0), x1.hypot(y1)], (x1 - x0).hypot(y1 - y0));
                                mean(force.on_rectangle([x0, x1], [y0, y1]), (x1 - x0) * (y1 - y0), ends, Some(diagonal))
                            }
                        });
                    }
                }
                Field { values, square: Some(square), bound: bound.get() }
            }
        }
    }
}

/// The ring of a radius: halfway to its neighbours; the first one begins at the axis, the last one ends as far beyond as before.
fn ring(radii: &Loads, index: usize) -> [f64; 2] {
    let own = radii.get(index).unwrap_or(0.0);
    let halfway = |other: Option<f64>| other.map(|other| 0.5 * (own + other));
    let before = index.checked_sub(1).and_then(|index| halfway(radii.get(index)));
    let after = halfway(radii.get(index + 1));
    let inner = before.unwrap_or(0.0);
    let outer = after.unwrap_or(if index == 0 { 2.0 * own } else { 2.0 * own - inner });
    [inner, outer]
}
