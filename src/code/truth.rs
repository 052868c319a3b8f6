//! Reference values for the generated code: errors in ulps, and condition numbers.

mod slopes;

use super::program::{Program, needs_modulus};
use crate::contact::{Contact, Quantity};
use crate::expr::{Bindings, Expr, Number};
use crate::num::{Bounded, work};
use crate::transform::{Evaluator, Method, Solution};
use slopes::Slopes;
use std::cell::{OnceCell, RefCell};
use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_2, PI};

/// The step of relative differences.
pub(super) const STEP: f64 = 1e-6;
/// Relative steps for condition numbers. The largest result is used, because at large radii a wave may be shorter than the first step;
/// where two results agree, the larger step was short enough. The last step reaches the next double.
const RELATIVE_STEPS: [f64; 4] = [STEP, 1e-9, 1e-12, f64::EPSILON];
/// Two changes of f that agree are those of a slope where the first one is at most this part of f.
const LINEAR: f64 = 0.1;
/// Steps of the double exponential rule for [`Truth::of_shape`] in a unit, and on both sides.
const PER_UNIT: f64 = 64.0;
const MOST_ANGLES: i32 = 220;
/// Steps of work after which a value is abandoned; the series of one with kinks takes 250,000.
const LONGEST: u64 = 270_000;
/// The tolerance of the reference values.
const TOLERANCE: f64 = 1e-13;
/// Values nearer to 0, and values above the reciprocal, are not compared.
const LEAST: f64 = 1e-280;

/// What a value is for: the quantity, and the bits of the parameters, of the coordinates and of the radius that belongs to them.
type Key = (&'static str, Vec<u64>);

/// Reference values and condition numbers that were computed before: programs for one profile are compared at the same places.
#[derive(Default)]
pub(super) struct References {
    values: RefCell<HashMap<Key, Option<Bounded>>>,
    /// Condition numbers, and whether the whole sum is computed.
    conditions: RefCell<HashMap<Key, (f64, bool)>>,
}

/// The reference values of a quantity, for one set of parameters.
pub(super) struct Truth<'a> {
    pub(super) quantity: Quantity,
    solution: &'a Solution,
    bindings: Bindings,
    pub(super) contact: Contact<'a>,
    /// The parameters in the order of the arguments.
    pub(super) values: Vec<f64>,
    names: Vec<String>,
    slopes: OnceCell<Slopes>,
    /// Contacts with one parameter increased and decreased, created when needed.
    moved: Option<Vec<Vec<Moved<'a>>>>,
    references: &'a References,
}

/// A relative step of a parameter, and the contacts on both sides.
type Moved<'a> = (f64, [Contact<'a>; 2]);

impl<'a> Truth<'a> {
    pub(super) fn new(
        solution: &'a Solution,
        quantity: Quantity,
        bindings: &Bindings,
        program: &Program,
        references: &'a References,
    ) -> Option<Self> {
        let contact = contact(solution, bindings)?;
        let value =
            |name: &str| bindings.iter().find(|(own, _)| own.name() == name).and_then(|(_, own)| own.as_number().map(|n| n.to_f64()));
        let values = program.parameters.iter().map(|(own, _)| value(own)).collect::<Option<Vec<f64>>>()?;
        let names = program.parameters.iter().map(|(own, _)| own.clone()).collect();
        Some(Self {
            quantity,
            solution,
            bindings: bindings.clone(),
            contact,
            values,
            names,
            slopes: OnceCell::new(),
            moved: None,
            references,
        })
    }

    fn key(&self, quantity: Quantity, coordinates: &[f64], place: f64) -> Key {
        (quantity.key(), self.values.iter().chain(coordinates).chain([&place]).map(|own| own.to_bits()).collect())
    }

    /// The value at coordinates that correspond to a radius near `place`.
    fn value(&self, coordinates: &[f64], place: f64) -> Option<Bounded> {
        self.known(self.quantity, coordinates, place)
    }

    fn known(&self, quantity: Quantity, coordinates: &[f64], place: f64) -> Option<Bounded> {
        let key = self.key(quantity, coordinates, place);
        if let Some(known) = self.references.values.borrow().get(&key) {
            return *known;
        }
        let found = self.computed(quantity, &self.contact, coordinates, place);
        self.references.values.borrow_mut().insert(key, found);
        found
    }

    fn computed(&self, quantity: Quantity, contact: &Contact<'_>, coordinates: &[f64], place: f64) -> Option<Bounded> {
        work::share(LONGEST, || self.value_of(quantity, contact, coordinates, place)).flatten()
    }

    fn value_of(&self, quantity: Quantity, contact: &Contact<'_>, coordinates: &[f64], place: f64) -> Option<Bounded> {
        let g = |x: f64| Some(contact.evaluator().equivalent(x).ok()?.estimate.bounded());
        let reading = match (quantity, coordinates) {
            (Quantity::Equivalent | Quantity::Depth, [x]) => return g(*x),
            (Quantity::Force, [a]) => contact.force(*a).ok()?.estimate,
            (Quantity::Pressure, [r, a]) => contact.pressure(*r, *a).ok()?.ok()?.estimate,
            (Quantity::ForceOfDepth, [d]) => {
                // F′(d) = 2a for E* = 1.
                let (depth, force) = (g(place)?, contact.force(place).ok()?.estimate.bounded());
                let step = d - depth.value;
                let value = force.value + 2.0 * place * step;
                return Some(Bounded::checked(value, force.error + 2.0 * place * (depth.error + STEP * step.abs()) + spacing(value)));
            }
            (Quantity::Radius, [d]) => {
                // One step of Newton's method, which is accurate to second order because `place` is near the root.
                let rise = g_prime(contact, place, g)?;
                let depth = g(place)?;
                let step = (d - depth.value) / rise;
                return Some(Bounded::checked(place + step, depth.error / rise.abs() + STEP * step.abs() + spacing(place)));
            }
            _ => return None,
        };
        Some(reading.bounded())
    }

    /// g′ at a radius.
    pub(super) fn g_prime(&self, a: f64) -> Option<f64> {
        g_prime(&self.contact, a, |x| self.exact(Quantity::Equivalent, x))
    }

    /// The reference value of g or F at a radius.
    pub(super) fn exact(&self, quantity: Quantity, a: f64) -> Option<Bounded> {
        self.known(quantity, &[a], a)
    }

    /// The error of a value of the code in ulps; `None` if unknown.
    pub(super) fn ulps(&self, own: Bounded, coordinates: &[f64], place: f64) -> Option<f64> {
        let exact = self.value(coordinates, place)?;
        // Skip numbers near the ends of the range of doubles, where ulps differ.
        if !(exact.value.abs() > LEAST && exact.value.abs() < 1.0 / LEAST) || exact.error > 1e-6 * exact.value.abs() {
            return None;
        }
        if !own.is_finite() {
            return Some(f64::INFINITY);
        }
        Some(own.error.max(beyond(own.value - exact.value, exact.error)) / spacing(exact.value))
    }

    /// [`Self::of_shape`] + Σ |v ∂q/∂v|/|q| over the coordinates, E and the parameters of the quantity q, or a part of the sum that is
    /// at least `enough`; `None` if a neighbouring value is unknown.
    pub(super) fn condition(&mut self, coordinates: &[f64], place: f64, enough: f64) -> Option<f64> {
        let key = self.key(self.quantity, coordinates, place);
        if let Some((known, is_whole)) = self.references.conditions.borrow().get(&key).copied()
            && (is_whole || known >= enough)
        {
            return Some(known);
        }
        let found = self.condition_up_to(coordinates, place, enough)?;
        self.references.conditions.borrow_mut().insert(key, (found, found < enough));
        Some(found)
    }

    fn condition_up_to(&mut self, coordinates: &[f64], place: f64, enough: f64) -> Option<f64> {
        let Bounded { value, error } = self.value(coordinates, place)?;
        let mut total = self.of_shape(value, place) + if needs_modulus(self.quantity) { 1.0 } else { 0.0 };
        // Use the larger change: at the crest of a short wave, one side may show none. What errors of the values explain does not count.
        let share = |step: f64, pair: [Option<Bounded>; 2]| {
            let changes = pair.into_iter().flatten().map(|own| beyond(own.value - value, own.error + error) / (step * value.abs()));
            changes.filter(|own| own.is_finite()).reduce(f64::max)
        };
        for index in 0..coordinates.len() {
            let at = |factor: f64| -> Vec<f64> {
                coordinates.iter().enumerate().map(|(i, own)| if i == index { own * factor } else { *own }).collect()
            };
            let change = |step: f64| share(step, [1.0 + step, 1.0 - step].map(|factor| self.value(&at(factor), place)));
            total += steepest(RELATIVE_STEPS.into_iter(), change)?;
        }
        if total >= enough {
            return Some(total);
        }
        if self.moved.is_none() {
            self.moved = Some(self.moved_parameters());
        }
        for moved in self.moved.iter().flatten() {
            let at = |pair: &[Contact<'a>; 2]| pair.each_ref().map(|own| self.computed(self.quantity, own, coordinates, place));
            let change = |wanted: f64| moved.iter().find(|(step, _)| *step == wanted).and_then(|(step, pair)| share(*step, at(pair)));
            total += steepest(moved.iter().map(|own| own.0), change)?;
            if total >= enough {
                break;
            }
        }
        Some(total)
    }

    /// k + the part of the sum over the coefficients of terms of f(r) that are rounded to doubles; 1 for pressures.
    ///
    /// k is the largest relative change of the value per relative change of f′(r), whose sign may differ from one r to the next, and at
    /// least 1. With r = a sin θ, changes are integrals over θ like the value itself, of which a few digits are enough.
    fn of_shape(&self, value: f64, place: f64) -> f64 {
        if self.quantity == Quantity::Pressure {
            return 1.0;
        }
        let front = match self.quantity {
            Quantity::Force | Quantity::ForceOfDepth => 2.0 * place * place,
            Quantity::Radius => place / self.g_prime(place).unwrap_or(f64::INFINITY),
            _ => place,
        };
        let weight = |sine: f64| match self.quantity {
            Quantity::Force => sine * sine,
            // At the depth d, a change of g moves the radius.
            Quantity::ForceOfDepth => 1.0 - sine * sine,
            _ => 1.0,
        };
        let slopes = self.slopes.get_or_init(|| Slopes::new(self.solution, &self.bindings));
        // A double exponential rule: the angles lie densely at both ends.
        let (mut magnitude, mut parts) = (0.0, vec![0.0; slopes.terms.len()]);
        for step in -MOST_ANGLES..=MOST_ANGLES {
            let at = f64::from(step) / PER_UNIT;
            let part = 1.0 / (1.0 + (-PI * at.sinh()).exp());
            let sine = (FRAC_PI_2 * part).sin();
            let factor = FRAC_PI_2 * PI / PER_UNIT * part * (1.0 - part) * at.cosh() * weight(sine);
            let finite = |own: f64| if own.is_finite() { own * factor } else { 0.0 };
            magnitude += finite(slopes.at(place * sine).abs());
            parts.iter_mut().zip(&slopes.terms).for_each(|(sum, term)| *sum += finite(term.at(place * sine)));
        }
        let change = |own: f64| Some((front * own / value).abs()).filter(|own| own.is_finite()).unwrap_or(0.0);
        change(magnitude).max(1.0) + parts.into_iter().map(change).sum::<f64>()
    }

    fn moved_parameters(&self) -> Vec<Vec<Moved<'a>>> {
        let with = |name: &str, value: f64| {
            let changed: Bindings = self
                .bindings
                .iter()
                .filter_map(|(own, number)| {
                    Some((own.name(), if own.name() == name { Expr::number(Number::from_f64(value)?) } else { number.clone() }))
                })
                .collect();
            contact(self.solution, &changed)
        };
        let moved = |(name, value): (&String, &f64)| {
            let pair = |step: f64| Some((step, [with(name, value * (1.0 + step))?, with(name, value * (1.0 - step))?]));
            RELATIVE_STEPS.into_iter().filter_map(pair).collect()
        };
        self.names.iter().zip(&self.values).map(moved).collect()
    }
}

/// g′ at a radius by a difference, which does not reach beyond a kink: next to it, g may be steep.
fn g_prime(contact: &Contact<'_>, a: f64, g: impl Fn(f64) -> Option<Bounded>) -> Option<f64> {
    let kinks = contact.evaluator().breakpoints_below(a * (1.0 + STEP));
    let step = kinks.into_iter().map(|kink| 0.25 * (a - kink).abs()).filter(|gap| *gap > 0.0).fold(STEP * a, f64::min);
    let (above, below) = (a + step, a - step);
    Some((g(above)?.value - g(below)?.value) / (above - below))
}

/// The largest of the changes over the steps, up to two that agree; `None` if it is unknown.
fn steepest(steps: impl Iterator<Item = f64>, change: impl Fn(f64) -> Option<f64>) -> Option<f64> {
    let mut most: Option<f64> = None;
    let mut before = f64::INFINITY;
    for step in steps {
        let Some(own) = change(step) else { continue };
        // Steps longer than a wave may agree by accident.
        if most.is_some_and(|most| own < 2.0 * most && most < 2.0 * own && most * before < LINEAR) {
            return most.map(|most| most.max(own));
        }
        most = Some(most.map_or(own, |most| most.max(own)));
        before = step;
    }
    most
}

fn contact<'a>(solution: &'a Solution, bindings: &Bindings) -> Option<Contact<'a>> {
    Some(Contact::new(Evaluator::new(solution, bindings, Method::Auto, TOLERANCE).ok()?, 1.0, None, TOLERANCE))
}

/// The part of a difference from a reference value that exceeds the error of that value.
pub(super) fn beyond(difference: f64, error: f64) -> f64 {
    (difference.abs() - error).max(0.0)
}

/// The distance between neighbouring doubles.
pub(super) fn spacing(value: f64) -> f64 {
    value.abs().next_up() - value.abs()
}
