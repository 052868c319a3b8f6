//! What a program claims of its accuracy: the largest running error bound at seeded points of its domain.

use super::CodeError;
use super::accuracy::{ELEMENTARY_ULPS, Machine};
use super::program::{Claim, Program, needs_modulus, routine_name};
use crate::contact::{Contact, Quantity};
use crate::expr::{Bindings, Expr, Number};
use crate::num::{Bounded, work};
use crate::transform::{Evaluator, Method, Sampler, Solution, reach};

/// Sets of parameters.
const DRAWS: usize = 6;
/// Points for each of them.
const POINTS: u32 = 14;
/// Up to here a claim needs no condition number.
const PLAIN: f64 = 16.0;
/// Bounds between the points may be larger.
const ROOM: f64 = 1.25;
/// The step of relative differences.
const STEP: f64 = 1e-6;
/// Those of condition numbers, of which the largest counts: far out, waves are shorter than the first one.
const STEPS: [f64; 3] = [STEP, 1e-9, 1e-12];
/// Steps of work after which a value is given up.
const LONGEST: u64 = 200_000;
/// The tolerance of the values that are compared.
const TOLERANCE: f64 = 1e-13;
/// Values nearer to 0, and their inverses, are not compared.
const LEAST: f64 = 1e-280;

/// Decades from the natural length of a profile inward and outward over which a claim holds.
const DECADES: f64 = 12.0;
/// Places in each of them.
const PER_DECADE: f64 = 2.0;
/// Functions with a larger claim are refused.
const REFUSED: f64 = 1e4;

/// Finds the claims and writes them into the comments of the routines.
pub(super) fn claimed(mut program: Program, solution: &Solution) -> Program {
    for quantity in program.quantities.clone() {
        let claim = of(&program, quantity, solution);
        program.claims.push((quantity, claim));
        let lines = text(&program, claim, quantity);
        if let Some(routine) = program.routines.iter_mut().find(|own| own.name == routine_name(quantity)) {
            routine.comment.extend(lines);
        }
    }
    program
}

impl Program {
    /// The quantities that claim more than [`PLAIN`] units, or nothing.
    pub(super) fn poor(&self) -> Vec<Quantity> {
        self.claims.iter().filter(|own| own.1.is_none_or(|claim| claim.ulps > PLAIN)).map(|own| own.0).collect()
    }

    /// The largest claim; infinite where nothing is claimed.
    pub(super) fn largest_claim(&self) -> f64 {
        self.claims.iter().map(|own| own.1.map_or(f64::INFINITY, |claim| claim.ulps)).fold(0.0, f64::max)
    }

    /// Refuses a function that loses its digits somewhere.
    pub(super) fn honest(self) -> Result<Self, CodeError> {
        let lost = self.claims.iter().find_map(|(quantity, claim)| Some((*quantity, claim.filter(|own| own.ulps > REFUSED)?)));
        match lost {
            Some((quantity, claim)) => Err(CodeError::Inaccurate {
                quantity: quantity.key(),
                coordinate: if quantity == Quantity::Radius { "a" } else { quantity.coordinate() },
                at: claim.worst_at,
                ulps: claim.ulps,
            }),
            None => Ok(self),
        }
    }
}

fn text(program: &Program, claim: Option<Claim>, quantity: Quantity) -> Vec<String> {
    let Some(claim) = claim else {
        return vec!["Accuracy: nothing is claimed, because no point with a bound was found.".to_owned()];
    };
    let mut assumed = vec![format!("elementary functions right to {ELEMENTARY_ULPS} ulp")];
    for name in &program.library {
        if let Some((written, ulps)) = program.language.target().library(name) {
            assumed.push(format!("{written} right to {ulps} ulp"));
        }
    }
    let times = match claim.condition {
        Some(_) => " times the condition number",
        None => "",
    };
    let (from, to) = claim.range;
    let coordinate = if matches!(quantity, Quantity::Pressure | Quantity::Radius) { "a" } else { quantity.coordinate() };
    let to = if to.is_finite() { format!("{to:.0e}") } else { "the end of the domain".to_owned() };
    let parameters = if program.parameters.is_empty() { "" } else { " and parameters between 1/4 and 4" };
    let mut lines = vec![format!(
        "Accuracy: at most {} ulp{times} for {coordinate} from {from:.0e} to {to}{parameters}, for {}.",
        claim.ulps,
        assumed.join(" and ")
    )];
    if let Some(condition) = claim.condition {
        lines.push(format!(
            "The condition number is 1 + the sum of |v df/dv|/|f| over the arguments v; it was {} at most.",
            if condition < 1e6 { format!("{condition:.0}") } else { format!("{condition:.0e}") }
        ));
    }
    let what = match quantity {
        Quantity::Radius => "depths that belong to radii",
        Quantity::Pressure => "radii r < a",
        _ => "points",
    };
    lines.push(format!(
        "The largest bound of the running error, and difference from the values of sneddon, at {} seeded {what}, and a quarter more.",
        claim.points
    ));
    lines
}

/// An error at one point, in ulps.
struct Found {
    ulps: f64,
    place: f64,
    coordinates: Vec<f64>,
    /// The set of parameters.
    draw: usize,
    /// Where the error itself tells it.
    condition: Option<f64>,
}

/// The claim of a quantity; `None` where no point gives a bound.
fn of(program: &Program, quantity: Quantity, solution: &Solution) -> Option<Claim> {
    let library = |name: &str| program.language.target().library(name).map(|(_, ulps)| ulps);
    let mut machine = Machine::new(&program.routines, &library);
    let searched = program.searches(quantity);
    let mut sampler = Sampler::new(0x5eed);
    let (mut found, mut truths): (Vec<Found>, Vec<Truth<'_>>) = (Vec::new(), Vec::new());
    // Of all draws; infinite where the profile ends.
    let mut range = (0.0_f64, f64::INFINITY);
    for _ in 0..if program.parameters.is_empty() { 1 } else { DRAWS } {
        let Some(truth) = sampler.parameters(solution).and_then(|own| Truth::new(solution, quantity, &own, program)) else { continue };
        let (mut list, ends) = places(&mut sampler, truth.contact.evaluator());
        if quantity == Quantity::Radius {
            list = rising(list, truth.contact.evaluator());
        }
        range = (range.0.max(ends.0), range.1.min(ends.1));
        for place in list {
            for coordinates in arguments_at(quantity, place, truth.contact.evaluator()) {
                let seen = if searched {
                    root(&mut machine, place, &truth.values).map(|(ulps, condition)| (ulps, Some(condition)))
                } else {
                    let modulus: &[f64] = if needs_modulus(quantity) { &[1.0] } else { &[] };
                    let arguments = [&coordinates, modulus, &truth.values].concat();
                    let own = machine.run(&routine_name(quantity), &arguments);
                    own.and_then(|own| truth.ulps(own, &coordinates, place)).map(|ulps| (ulps, None))
                };
                let Some((ulps, condition)) = seen else { continue };
                found.push(Found { ulps, place, coordinates, draw: truths.len(), condition });
            }
        }
        truths.push(truth);
    }
    let whole = |ulps: f64| (ulps * ROOM).ceil();
    found.sort_by(|one, other| other.ulps.total_cmp(&one.ulps));
    let worst = found.first()?;
    let claim = Claim { ulps: whole(worst.ulps), condition: None, points: found.len(), range, worst_at: worst.place };
    if claim.ulps <= PLAIN {
        return Some(claim);
    }
    let (mut relative, mut largest, mut worst_at) = (0.0_f64, 1.0_f64, worst.place);
    for own in &found {
        // Condition numbers are 1 or more.
        if own.ulps <= relative {
            break;
        }
        let truth = truths.get_mut(own.draw)?;
        let Some(condition) = own.condition.or_else(|| truth.condition(&own.coordinates, own.place)) else { continue };
        largest = largest.max(condition);
        if own.ulps / condition > relative {
            (relative, worst_at) = (own.ulps / condition, own.place);
        }
    }
    Some(Claim { ulps: whole(relative), condition: Some(largest), worst_at, ..claim })
}

/// The values of a quantity as the program computes them, for one set of parameters.
struct Truth<'a> {
    quantity: Quantity,
    solution: &'a Solution,
    bindings: Bindings,
    contact: Contact<'a>,
    /// The parameters in the order of the arguments.
    values: Vec<f64>,
    names: Vec<String>,
    /// Contacts with one parameter more, and less; made where they are needed.
    moved: Option<Vec<Vec<Moved<'a>>>>,
}

/// A relative step of a parameter, and the contacts on both sides.
type Moved<'a> = (f64, [Contact<'a>; 2]);

impl<'a> Truth<'a> {
    fn new(solution: &'a Solution, quantity: Quantity, bindings: &Bindings, program: &Program) -> Option<Self> {
        let contact = contact(solution, bindings)?;
        let value =
            |name: &str| bindings.iter().find(|(own, _)| own.name() == name).and_then(|(_, own)| own.as_number().map(|n| n.to_f64()));
        let values = program.parameters.iter().map(|(own, _)| value(own)).collect::<Option<Vec<f64>>>()?;
        let names = program.parameters.iter().map(|(own, _)| own.clone()).collect();
        Some(Self { quantity, solution, bindings: bindings.clone(), contact, values, names, moved: None })
    }

    /// The value at coordinates that belong to a radius next to `place`.
    fn value(&self, contact: &Contact<'_>, coordinates: &[f64], place: f64) -> Option<Bounded> {
        work::share(LONGEST, || self.value_of(contact, coordinates, place)).flatten()
    }

    fn value_of(&self, contact: &Contact<'_>, coordinates: &[f64], place: f64) -> Option<Bounded> {
        let g = |x: f64| Some(contact.evaluator().slope(x).ok()?.estimate.bounded());
        let reading = match (self.quantity, coordinates) {
            (Quantity::Equivalent | Quantity::Depth, [x]) => return g(*x),
            (Quantity::Force, [a]) => contact.force(*a).ok()?.estimate,
            (Quantity::Pressure, [r, a]) => contact.pressure(*r, *a).ok()?.ok()?.estimate,
            (Quantity::Radius, [d]) => {
                // A step of Newton's method, which the nearness of the place makes right to second order.
                let rise = (g(place * (1.0 + STEP))?.value - g(place * (1.0 - STEP))?.value) / (2.0 * STEP * place);
                let depth = g(place)?;
                let step = (d - depth.value) / rise;
                return Some(Bounded::checked(place + step, depth.error / rise.abs() + STEP * step.abs() + spacing(place)));
            }
            _ => return None,
        };
        Some(reading.bounded())
    }

    /// The error of a value of the code in ulps; `None` where nothing can be said.
    fn ulps(&self, own: Bounded, coordinates: &[f64], place: f64) -> Option<f64> {
        let exact = self.value(&self.contact, coordinates, place)?;
        // Numbers next to the ends of the range of doubles have digits that are counted otherwise.
        if !(exact.value.abs() > LEAST && exact.value.abs() < 1.0 / LEAST) || exact.error > 1e-6 * exact.value.abs() {
            return None;
        }
        if !own.is_finite() {
            return Some(f64::INFINITY);
        }
        let difference = ((own.value - exact.value).abs() - exact.error).max(0.0);
        Some(own.error.max(difference) / spacing(exact.value))
    }

    /// 1 + Σ |v ∂f/∂v|/|f| over the coordinates, E and the parameters; `None` where a value next to the point is not known.
    fn condition(&mut self, coordinates: &[f64], place: f64) -> Option<f64> {
        let mut total = if needs_modulus(self.quantity) { 2.0 } else { 1.0 };
        let Bounded { value, .. } = self.value(&self.contact, coordinates, place)?;
        // The larger change on either side: at the crest of a short wave both have one sign.
        let share = |step: f64, pair: [Option<Bounded>; 2]| {
            let changes = pair.into_iter().flatten().map(|own| (own.value - value).abs() / (step * value.abs()));
            changes.filter(|own| own.is_finite()).reduce(f64::max)
        };
        for index in 0..coordinates.len() {
            let at = |factor: f64| -> Vec<f64> {
                coordinates.iter().enumerate().map(|(i, own)| if i == index { own * factor } else { *own }).collect()
            };
            let shares = STEPS
                .into_iter()
                .filter_map(|step| share(step, [1.0 + step, 1.0 - step].map(|factor| self.value(&self.contact, &at(factor), place))));
            total += shares.reduce(f64::max)?;
        }
        if self.moved.is_none() {
            self.moved = Some(self.moved_parameters());
        }
        for moved in self.moved.iter().flatten() {
            let shares =
                moved.iter().filter_map(|(step, pair)| share(*step, pair.each_ref().map(|own| self.value(own, coordinates, place))));
            total += shares.reduce(f64::max)?;
        }
        Some(total)
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
            STEPS.into_iter().filter_map(pair).collect()
        };
        self.names.iter().zip(&self.values).map(moved).collect()
    }
}

fn contact<'a>(solution: &'a Solution, bindings: &Bindings) -> Option<Contact<'a>> {
    Some(Contact::new(Evaluator::new(solution, bindings, Method::Auto, TOLERANCE).ok()?, 1.0, None, TOLERANCE))
}

/// Radii over the decades of a claim and their ends, next to breakpoints, and next to the end of the profile.
fn places(sampler: &mut Sampler, evaluator: &Evaluator<'_>) -> (Vec<f64>, (f64, f64)) {
    let (end, limit) = (reach(evaluator), evaluator.limit());
    let count = 2.0 * DECADES * PER_DECADE;
    let inward = sampler.points(count, count as u32).into_iter().map(|own| end * 10f64.powf(own / PER_DECADE - DECADES));
    let mut list: Vec<f64> = inward.collect();
    list.extend(sampler.points(end, POINTS));
    for place in evaluator.breakpoints_below(end) {
        list.extend([1.0 - 1e-6, 1.0 - 1e-2, 1.0 + 1e-9, 1.0 + 1e-6, 1.0 + 1e-3, 1.1, 1.5].map(|factor| place * factor));
    }
    if limit.is_finite() {
        list.extend([1e-2, 1e-4, 1e-8].map(|gap| limit * (1.0 - gap)));
    }
    list.retain(|place| *place < limit);
    (list, (end * 10f64.powf(-DECADES), if limit.is_finite() { f64::INFINITY } else { end * 10f64.powf(DECADES) }))
}

/// The places up to which g rises: a contact radius belongs to them.
fn rising(mut list: Vec<f64>, evaluator: &Evaluator<'_>) -> Vec<f64> {
    list.sort_by(f64::total_cmp);
    let mut before = 0.0;
    let rises = |place: &f64| {
        let own = evaluator.slope(*place).map_or(f64::NAN, |own| own.estimate.value);
        own >= std::mem::replace(&mut before, own)
    };
    list.into_iter().take_while(rises).collect()
}

fn arguments_at(quantity: Quantity, place: f64, evaluator: &Evaluator<'_>) -> Vec<Vec<f64>> {
    match quantity {
        Quantity::Pressure => [1e-4, 0.1, 0.4, 0.7, 0.95, 0.9999].map(|part| vec![place * part, place]).to_vec(),
        Quantity::Radius => match evaluator.slope(place) {
            Ok(depth) if depth.estimate.value > 0.0 => vec![vec![depth.estimate.value]],
            _ => Vec::new(),
        },
        _ => vec![vec![place]],
    }
}

/// The error in ulps of the radius a with g(a) = d, and its condition number: an error of g moves the root by itself over g′.
fn root(machine: &mut Machine<'_>, a: f64, values: &[f64]) -> Option<(f64, f64)> {
    let mut at = |a: f64| machine.run("sneddon_g", &[&[a], values].concat());
    let (own, more, less) = (at(a)?, at(a * (1.0 + STEP))?, at(a * (1.0 - STEP))?);
    let slope = (more.value - less.value) / (2.0 * STEP * a);
    let positive = slope > 0.0 && own.value > 0.0;
    let error = (own.error + spacing(own.value)) / slope + 2.0 * spacing(a);
    positive.then(|| (error / spacing(a), 1.0 + own.value / (slope * a)))
}

/// The distance of neighbouring doubles.
fn spacing(value: f64) -> f64 {
    value.abs().next_up() - value.abs()
}
