//! Seeded random places for comparisons: admissible values of the parameters, and points within the profile's reach.

use crate::derive::domain::decided::decided_for_all;
use crate::derive::engine::Solution;
use crate::derive::stream::Stream;
use crate::expr::{Bindings, Condition, Expr, Node, Number, Relation, Symbol};
use std::collections::BTreeMap;

/// A seeded source of admissible parameters and points; the same on every machine.
pub struct Sampler {
    stream: Stream,
}

/// Draws of parameters before a profile counts as one without admissible values.
const TRIES: u32 = 40;
/// Changes of drawn values, in addition to one for each pair of parameters.
const MOST_CHANGES: usize = 40;

impl Sampler {
    /// A source that depends on the seed alone.
    pub fn new(seed: u64) -> Self {
        Self { stream: Stream::new(seed) }
    }

    /// Values for every parameter that the conditions of the solution admit; `None` if none was found.
    pub fn parameters(&mut self, solution: &Solution) -> Option<Bindings> {
        self.admissible(&solution.profile.parameters(), &solution.conditions)
    }

    /// The same for a list of parameters and conditions.
    pub(crate) fn admissible(&mut self, parameters: &[Symbol], conditions: &[Condition]) -> Option<Bindings> {
        for _ in 0..TRIES {
            let mut values: BTreeMap<Symbol, Number> = parameters.iter().map(|s| (s.clone(), self.stream.dyadic())).collect();
            put_in_order(&mut values, conditions);
            let bindings: Bindings = values.iter().map(|(s, value)| (s.name(), Expr::number(value.clone()))).collect();
            if conditions.iter().all(|condition| admissible(&condition.substitute(&bindings))) {
                return Some(bindings);
            }
        }
        None
    }

    /// So many points of (0, end), one in each of as many equal parts.
    pub fn points(&mut self, end: f64, count: u32) -> Vec<f64> {
        (0..count).map(|index| end * (f64::from(index) + self.stream.uniform()) / f64::from(count)).collect()
    }

    /// A number of (0, 1) that keeps away from both ends.
    pub fn fraction(&mut self) -> f64 {
        0.05 + 0.9 * self.stream.uniform()
    }
}

/// Exchanges values until what the conditions say of two parameters holds: drawn freely, seven breakpoints rise once in 5040
/// draws. Where the sides are not single parameters, what stands on one side only is halved or doubled.
fn put_in_order(values: &mut BTreeMap<Symbol, Number>, conditions: &[Condition]) {
    let ordering: Vec<&Condition> = conditions.iter().filter(|own| own.relation != Relation::Equal).collect();
    for _ in 0..values.len() * values.len() + MOST_CHANGES {
        let bindings: Bindings = values.iter().map(|(s, value)| (s.name(), Expr::number(value.clone()))).collect();
        let Some(broken) = ordering.iter().find(|own| own.substitute(&bindings).decided() == Some(false)) else { return };
        if let (Node::Symbol(left), Node::Symbol(right)) = (broken.left.node(), broken.right.node())
            && let (Some(one), Some(other)) = (values.get(left).cloned(), values.get(right).cloned())
            && one != other
        {
            values.insert(left.clone(), other);
            values.insert(right.clone(), one);
            continue;
        }
        for (symbol, value) in values.iter_mut() {
            let factor = match (broken.left.contains(symbol), broken.right.contains(symbol)) {
                (true, false) => Number::ratio(1, 2),
                (false, true) => Number::integer(2),
                _ => continue,
            };
            *value = &*value * &factor;
        }
    }
}

/// Conditions on parameters alone decide; those on r are met by the choice of points.
pub(crate) fn admissible(condition: &Condition) -> bool {
    decided_for_all(condition).unwrap_or(true)
}
