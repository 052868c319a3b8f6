//! States under many loads: where a table has many rows in a narrow range of loads, they come from polynomials over that range.

use super::Exact;
use crate::contact::{Load, State};
use crate::transform::Quantities;
use std::collections::HashMap;

/// The states under depths and under forces.
pub(in crate::validate) struct States<'a> {
    exact: &'a Exact<'a>,
    /// False if every state is solved on its own, because the tolerance is as small as the error of the polynomials.
    may_interpolate: bool,
    depths: HashMap<u64, Cell>,
    forces: HashMap<u64, Cell>,
}

/// A range of loads, 1/16 of an octave.
enum Cell {
    /// The number of states that were solved in it.
    Solved(usize),
    /// A polynomial does not represent the states.
    Uneven,
    Smooth(Box<Smooth>),
}

/// The states at the nodes of a polynomial in the load.
struct Smooth {
    loads: [f64; NODES],
    states: [State; NODES],
}

/// Number of nodes: the points of Chebyshev of the second kind.
const NODES: usize = 9;
/// Number of states that are solved in a range before a polynomial costs less.
const FEW: usize = 12;
/// Bits of the significand that tell a range.
const BITS: u32 = 4;
/// Largest relative difference between the polynomial and solved states, …
const SAME: f64 = 1e-12;
/// … and the tolerance below which every state is solved.
const DEMANDING: f64 = 1e-7;

impl<'a> States<'a> {
    pub(in crate::validate) fn new(exact: &'a Exact<'a>, tolerance: Option<f64>) -> Self {
        let may_interpolate = tolerance.is_none_or(|own| own >= DEMANDING);
        Self { exact, may_interpolate, depths: HashMap::new(), forces: HashMap::new() }
    }

    /// The state under a load, as [`Exact::state`].
    pub(in crate::validate) fn at(&mut self, load: Load) -> Option<State> {
        let (cells, value, kind): (_, _, fn(f64) -> Load) = match load {
            Load::Depth(own) => (&mut self.depths, own, Load::Depth),
            Load::Force(own) => (&mut self.forces, own, Load::Force),
            Load::Radius(_) => return self.exact.state(load),
        };
        if !self.may_interpolate || !value.is_normal() || value < 0.0 {
            return self.exact.state(load);
        }
        let key = value.to_bits() >> (f64::MANTISSA_DIGITS - 1 - BITS);
        match cells.entry(key).or_insert(Cell::Solved(0)) {
            Cell::Uneven => self.exact.state(load),
            Cell::Smooth(own) => Some(own.at(value)),
            Cell::Solved(count) if *count < FEW => {
                *count += 1;
                self.exact.state(load)
            }
            cell => {
                *cell = self.exact.smooth(kind, key).map_or(Cell::Uneven, |own| Cell::Smooth(Box::new(own)));
                if let Cell::Smooth(own) = cell { Some(own.at(value)) } else { self.exact.state(load) }
            }
        }
    }
}

impl Exact<'_> {
    /// The polynomials over a range of loads, if they agree with solved states between their nodes and no breakpoint lies within.
    fn smooth(&self, load: fn(f64) -> Load, key: u64) -> Option<Smooth> {
        let [from, to] = [key, key + 1].map(|own| f64::from_bits(own << (f64::MANTISSA_DIGITS - 1 - BITS)));
        let node = |place: usize| (std::f64::consts::PI * place as f64 / (NODES - 1) as f64).cos();
        let loads: [f64; NODES] = std::array::from_fn(|place| 0.5 * (from + to) - 0.5 * (to - from) * node(place));
        let mut states = Vec::with_capacity(NODES);
        for own in loads {
            states.push(self.state(load(own))?);
        }
        let states: [State; NODES] = states.try_into().ok()?;
        let [first, .., last] = &states;
        let breakpoints = |own: &State| self.shape().evaluator().breakpoints_below(own.radius).len();
        if states.iter().any(|own| own.boundary != first.boundary) || breakpoints(first) != breakpoints(last) {
            return None;
        }
        let smooth = Smooth { loads, states };
        let agrees = |share: f64| {
            let at = from + share * (to - from);
            let (own, solved) = (smooth.at(at), self.state(load(at))?);
            let close = |own: f64, solved: f64| (own - solved).abs() <= SAME * solved.abs();
            let same = close(own.depth, solved.depth) && close(own.force, solved.force) && close(own.radius, solved.radius);
            (same && own.boundary == solved.boundary).then_some(())
        };
        [0.13, 0.41, 0.77].into_iter().try_for_each(agrees)?;
        Some(smooth)
    }
}

impl Smooth {
    /// The barycentric form of the interpolating polynomials.
    fn at(&self, load: f64) -> State {
        let (mut sum, mut total) = ([0.0; 3], 0.0);
        for (place, (node, state)) in self.loads.iter().zip(&self.states).enumerate() {
            if *node == load {
                return *state;
            }
            let weight = if place == 0 || place == NODES - 1 { 0.5 } else { 1.0 };
            let weight = if place % 2 == 0 { weight } else { -weight } / (load - node);
            total += weight;
            for (sum, own) in sum.iter_mut().zip([state.depth, state.force, state.radius]) {
                *sum += weight * own;
            }
        }
        let [depth, force, radius] = sum.map(|own| own / total);
        let [State { boundary, .. }, ..] = self.states;
        State { depth, force, radius, boundary }
    }
}
