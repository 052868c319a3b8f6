//! What a program claims of its accuracy: the largest running error bound at seeded points of its domain.

use super::CodeError;
use super::accuracy::{ASSUMED, Machine};
use super::program::{Claim, Program, is_of_depth, needs_modulus, routine_name, series_of};
use super::truth::{References, Truth, beyond, spacing};
use crate::contact::{Contact, Quantity};
use crate::num::{Bounded, work};
use crate::transform::{Evaluator, Sampler, Solution, reach};

/// Sets of parameters.
const DRAWS: usize = 6;
/// Points for each of them.
const POINTS: u32 = 14;
/// Up to here a claim needs no condition number.
const PLAIN: f64 = 16.0;
/// Factor by which claims are enlarged, because errors between the points may be larger.
const ROOM: f64 = 1.25;
/// Decades from the natural length of a profile inward and outward over which a claim holds.
const DECADES: f64 = 12.0;
/// Places in each of them.
const PER_DECADE: f64 = 2.0;
/// Factors of a breakpoint that give places beside it.
const BESIDE: [f64; 7] = [1.0 - 1e-6, 1.0 - 1e-2, 1.0 + 1e-9, 1.0 + 1e-6, 1.0 + 1e-3, 1.1, 1.5];
/// The most places beside breakpoints.
const MOST_BESIDE: usize = 168;
/// Functions with a larger claim are refused.
const REFUSED: f64 = 1e4;

/// Finds the claims and writes them into the comments of the routines. The search for a claim stops where it reaches the largest claim
/// of the other program, which is then the better one.
pub(super) fn claimed(mut program: Program, solution: &Solution, references: &References, other: Option<&Program>) -> Program {
    for quantity in program.judged() {
        let before = other.and_then(|own| Some((own, own.claims.iter().find(|(of, _)| *of == quantity)?.1)));
        let of_g = program.claims.iter().find(|own| own.0 == Quantity::Equivalent && quantity == Quantity::Depth && program.depth_is_g());
        let claim = match (before, of_g) {
            (_, Some((_, claim))) => *claim,
            (Some((other, claim)), _) if program.computes_alike(other, quantity) => claim,
            _ => {
                let begin = before.and_then(|(_, claim)| Some(claim?.worst_at));
                of(&program, quantity, solution, references, begin, other.map_or(f64::INFINITY, Program::largest_claim))
            }
        };
        program.claims.push((quantity, claim));
        let lines = claim.map_or_else(Vec::new, |claim| text(&program, claim, quantity));
        if let Some(routine) = program.routines.iter_mut().find(|own| own.name == routine_name(quantity)) {
            routine.comment.extend(lines);
        }
    }
    program
}

impl Program {
    /// The quantities that claim more than [`PLAIN`] units, or that have no claim.
    pub(super) fn poor(&self) -> Vec<Quantity> {
        self.claims.iter().filter(|own| own.1.is_none_or(|claim| claim.ulps > PLAIN)).map(|own| own.0).collect()
    }

    /// The largest claim; infinite if one is unknown.
    fn largest_claim(&self) -> f64 {
        self.claims.iter().map(|(_, claim)| claim.map_or(f64::INFINITY, |own| own.ulps)).fold(0.0, f64::max)
    }

    /// Whether the largest claim among the quantities computed from this one is smaller than in another program.
    pub(super) fn has_smaller_claims(&self, other: &Self, quantity: Quantity) -> bool {
        let size = |claim: Option<Claim>| claim.map_or(f64::INFINITY, |own| own.ulps);
        let pairs = self.claims.iter().zip(&other.claims).filter(|(own, _)| series_of(own.0).contains(&quantity));
        let largest = pairs.fold((0.0_f64, 0.0_f64), |most, (own, other)| (most.0.max(size(own.1)), most.1.max(size(other.1))));
        largest.0 < largest.1
    }

    /// Refuses a function that loses its digits somewhere, and one that was compared with no value.
    pub(super) fn honest(self) -> Result<Self, CodeError> {
        if let Some((quantity, _)) = self.claims.iter().find(|(_, claim)| claim.is_none()) {
            let quantity = *quantity;
            return Err(if is_of_depth(quantity) {
                CodeError::NoDepth { quantity: quantity.key() }
            } else {
                CodeError::NoValue { quantity: quantity.key() }
            });
        }
        let lost = self.claims.iter().find_map(|(quantity, claim)| Some((*quantity, claim.filter(|own| own.ulps > REFUSED)?)));
        match lost {
            Some((quantity, claim)) => Err(CodeError::Inaccurate {
                quantity: quantity.key(),
                coordinate: if is_of_depth(quantity) { "a" } else { quantity.coordinate() },
                at: claim.worst_at,
                ulps: claim.ulps,
            }),
            None => Ok(self),
        }
    }
}

fn text(program: &Program, claim: Claim, quantity: Quantity) -> Vec<String> {
    let mut assumed = vec![ASSUMED.to_owned()];
    for name in &program.library {
        if let Some((written, ulps)) = program.language.target().library(name) {
            assumed.push(format!("{written} accurate to {ulps} ulp"));
        }
    }
    let times = match claim.conditional {
        Some(_) => " times the condition number",
        None => "",
    };
    let (from, to) = claim.range;
    let coordinate = if quantity == Quantity::Pressure || is_of_depth(quantity) { "a" } else { quantity.coordinate() };
    let to = if to.is_finite() { at_most(to) } else { "the end of the domain".to_owned() };
    let parameters =
        if program.parameters.is_empty() { "" } else { " and parameters between 1/4 and 4, all in one unit of length, which may be any" };
    let mut lines = vec![format!(
        "Accuracy: at most {} ulp{times} for {coordinate} from {from:.0e} to {to}{parameters}, for {}.",
        claim.ulps,
        assumed.join(" and ")
    )];
    if let Some(largest) = claim.conditional {
        lines.push(format!(
            "The condition number is k + the sum of |v dq/dv|/|q| over the arguments v of the result q and over the coefficients of f(r) that are rounded to doubles. Here k is the largest relative change of q per relative change of f'(r), whose sign may differ from one r to the next, and at least 1. Where it is large, the bound was up to {} ulp.",
            if largest < 1e6 { format!("{largest:.0}") } else { format!("{largest:.0e}") }
        ));
    }
    let what = match quantity {
        Quantity::Radius | Quantity::ForceOfDepth => "depths g(a) of radii a",
        Quantity::Pressure => "radii r < a",
        _ => "points",
    };
    lines.push(format!(
        "This is the largest running error bound, or the largest difference from the values of sneddon, at {} pseudo-random {what}, increased by a quarter.",
        claim.points
    ));
    lines
}

/// A number with one digit, rounded downward.
fn at_most(value: f64) -> String {
    let nearest = format!("{value:.0e}");
    let is_above = nearest.parse().is_ok_and(|own: f64| own > value);
    if is_above { format!("{:.0e}", value - 0.5 * 10f64.powf(value.log10().floor())) } else { nearest }
}

/// An error at one point, in ulps.
struct PointError {
    /// The running bound, or the one to first order.
    ulps: f64,
    is_refined: bool,
    place: f64,
    coordinates: Vec<f64>,
    /// The set of parameters.
    draw: usize,
}

/// The claim of a quantity, or a smaller number that is at least `enough`, or too large to be accepted; `None` if no point gives a bound.
/// The place `begin` is judged first.
fn of(
    program: &Program,
    quantity: Quantity,
    solution: &Solution,
    references: &References,
    begin: Option<f64>,
    enough: f64,
) -> Option<Claim> {
    let library = |name: &str| program.language.target().library(name).map(|(_, ulps)| ulps);
    let mut machine = Machine::new(&program.routines, &library);
    let is_solved = program.is_solved(quantity);
    let mut sampler = Sampler::new(0x5eed);
    let (mut found, mut truths): (Vec<PointError>, Vec<Truth<'_>>) = (Vec::new(), Vec::new());
    // Of all draws; infinite if the profile ends.
    let mut range = (0.0_f64, f64::INFINITY);
    for _ in 0..if program.parameters.is_empty() { 1 } else { DRAWS } {
        let Some(truth) = sampler.parameters(solution).and_then(|own| Truth::new(solution, quantity, &own, program, references)) else {
            continue;
        };
        let (mut list, mut ends) = places(&mut sampler, truth.contact.evaluator());
        if is_of_depth(quantity) {
            let furthest = list.iter().copied().fold(0.0, f64::max);
            list = rising(list, &truth.contact);
            // Beyond a maximum of g no depth has its first root.
            ends.1 = list.last().copied().filter(|last| *last < furthest).unwrap_or(ends.1);
        }
        range = (range.0.max(ends.0), range.1.min(ends.1));
        for (index, place) in list.into_iter().enumerate() {
            let Some(coordinates) = arguments_at(quantity, place, index, truth.contact.evaluator()) else { continue };
            let Some(ulps) = error_at(&mut machine, &truth, is_solved, &coordinates, place) else { continue };
            found.push(PointError { ulps, is_refined: false, place, coordinates, draw: truths.len() });
        }
        truths.push(truth);
    }
    found.sort_by(|one, other| other.ulps.total_cmp(&one.ulps));
    let mut refined = |own: &mut PointError, truth: &Truth<'_>| {
        if !std::mem::replace(&mut own.is_refined, true) {
            machine.start_record();
            let ulps = error_at(&mut machine, truth, is_solved, &own.coordinates, own.place);
            own.ulps = ulps.map_or(own.ulps, |ulps| ulps.min(own.ulps));
        }
        own.ulps
    };
    let whole = |ulps: f64| (ulps * ROOM).ceil();
    let mut claim = Claim { ulps: 0.0, conditional: None, points: found.len(), range, worst_at: found.first()?.place };
    for own in &mut found {
        // The running bounds fall from here on.
        let is_last = whole(own.ulps) <= PLAIN;
        let ulps = if is_last { own.ulps } else { refined(own, truths.get(own.draw)?) };
        if whole(ulps) > claim.ulps {
            claim = Claim { ulps: whole(ulps), worst_at: own.place, ..claim };
        }
        if is_last || claim.ulps > PLAIN {
            break;
        }
    }
    if claim.ulps <= PLAIN {
        return Some(claim);
    }
    let (mut relative, mut largest, mut worst_at) = (0.0_f64, 0.0_f64, claim.worst_at);
    if let Some(first) = begin.and_then(|begin| found.iter().position(|own| own.place == begin)) {
        found[..=first].rotate_right(1);
    }
    for own in &mut found {
        // Condition numbers are 1 or more.
        if !own.is_refined && own.ulps <= relative {
            break;
        }
        let truth = truths.get_mut(own.draw)?;
        // A larger condition number changes nothing.
        let Some(condition) = truth.condition(&own.coordinates, own.place, own.ulps / relative) else { continue };
        // The bound to first order takes longer.
        let ulps = if own.ulps <= relative * condition { own.ulps } else { refined(own, truth) };
        largest = largest.max(ulps);
        if ulps / condition > relative {
            (relative, worst_at) = (ulps / condition, own.place);
        }
        if whole(relative) >= enough || whole(relative) > REFUSED {
            break;
        }
    }
    Some(Claim { ulps: whole(relative), conditional: Some(whole(largest)), worst_at, ..claim })
}

/// The error in ulps at a point: the running bound, or the one to first order if the machine keeps a record.
fn error_at(machine: &mut Machine<'_>, truth: &Truth<'_>, is_solved: bool, coordinates: &[f64], place: f64) -> Option<f64> {
    if is_solved {
        return solved(machine, truth, place);
    }
    let modulus: &[f64] = if needs_modulus(truth.quantity) { &[1.0] } else { &[] };
    let own = machine.traced(&routine_name(truth.quantity), &[coordinates, modulus, &truth.values].concat())?;
    let error = machine.error(&[(own, 1.0)]);
    truth.ulps(Bounded { value: own.bounded.value, error }, coordinates, place)
}

/// Radii over the decades of a claim and their ends, next to breakpoints, and next to the end of the profile.
fn places(sampler: &mut Sampler, evaluator: &Evaluator<'_>) -> (Vec<f64>, (f64, f64)) {
    let (end, limit) = (reach(evaluator), evaluator.limit());
    let count = 2.0 * DECADES * PER_DECADE;
    let inward = sampler.points(count, count as u32).into_iter().map(|own| end * 10f64.powf(own / PER_DECADE - DECADES));
    let mut list: Vec<f64> = inward.collect();
    list.extend(sampler.points(end, POINTS));
    let breakpoints = evaluator.breakpoints_below(end);
    let beside = breakpoints.iter().flat_map(|place| BESIDE.map(|factor| place * factor));
    // With many breakpoints, only every n-th place is used. If n were a multiple of the number of factors, all of these places would have
    // the same factor.
    let n = (BESIDE.len() * breakpoints.len()).div_ceil(MOST_BESIDE).max(1);
    list.extend(beside.step_by(if n.is_multiple_of(BESIDE.len()) { n + 1 } else { n }));
    if limit.is_finite() {
        list.extend([1e-2, 1e-4, 1e-8].map(|gap| limit * (1.0 - gap)));
    }
    list.retain(|place| *place < limit);
    (list, (end * 10f64.powf(-DECADES), if limit.is_finite() { f64::INFINITY } else { end * 10f64.powf(DECADES) }))
}

/// Returns the places from the first one with g > 0 up to the first maximum of g: each is the contact radius of its depth.
fn rising(mut list: Vec<f64>, contact: &Contact<'_>) -> Vec<f64> {
    list.sort_by(f64::total_cmp);
    let depth = |place: f64| contact.evaluator().equivalent(place).map_or(f64::NAN, |own| own.estimate.value);
    let mut before = 0.0;
    let mut places: Vec<f64> = list
        .into_iter()
        .map(|place| (place, depth(place)))
        .skip_while(|(_, own)| *own <= 0.0)
        .take_while(|(_, own)| *own >= std::mem::replace(&mut before, *own))
        .map(|(place, _)| place)
        .collect();
    // A maximum between two places hides where g is larger at the second one: waves show between them, and a search finds the rest.
    let is_first = |place: &f64| {
        let found = work::share(SEARCH, || contact.contact_radius(depth(*place)));
        // A search that takes too long shows nothing.
        found.is_none_or(|own| own.is_ok_and(|own| own.estimate.value >= place * (1.0 - APART)))
    };
    let falls = |pair: &[f64]| {
        let [from, to] = pair else { return false };
        let at = |i: u32| depth(from + (to - from) * f64::from(i) / f64::from(BETWEEN));
        work::share(SEARCH / 5, || (0..BETWEEN).any(|i| at(i + 1) < at(i))).unwrap_or(false)
    };
    places.truncate(places.windows(2).position(falls).map_or(places.len(), |before| before + 1));
    places.truncate(places.partition_point(is_first));
    places
}

/// Intervals between two places in which g is compared.
const BETWEEN: u32 = 32;
/// Steps of work after which a search for the first root is abandoned.
const SEARCH: u64 = 500_000;
/// A root is another one if it lies nearer to the axis by this part: far out, the waves of g are short beside the radius.
const APART: f64 = 1e-9;

/// The parts of the contact radius at which pressures are compared, by turns.
const PARTS: [f64; 6] = [1e-4, 0.7, 0.1, 0.95, 0.4, 0.9999];

/// The arguments that belong to the radius with this index; `None` if there are none.
fn arguments_at(quantity: Quantity, place: f64, index: usize, evaluator: &Evaluator<'_>) -> Option<Vec<f64>> {
    match quantity {
        Quantity::Pressure => PARTS.get(index % PARTS.len()).map(|part| vec![place * part, place]),
        Quantity::Radius | Quantity::ForceOfDepth => match evaluator.equivalent(place) {
            Ok(depth) if depth.estimate.value > 0.0 => Some(vec![depth.estimate.value]),
            _ => None,
        },
        _ => Some(vec![place]),
    }
}

/// The error in ulps of the radius a with g(a) = d, which an error of g moves by that error over g′. For F(a) + 2a (d − g(a)), the
/// error of the root counts in second order only. Errors of g and F are their bounds, or their differences from the values of the
/// program.
fn solved(machine: &mut Machine<'_>, truth: &Truth<'_>, a: f64) -> Option<f64> {
    let g_prime = truth.g_prime(a)?;
    let mut at = |routine: &str, arguments: &[f64]| machine.traced(routine, &[arguments, &truth.values].concat());
    let own = at("sneddon_g", &[a])?;
    if !(g_prime > 0.0 && own.bounded.value > 0.0) {
        return None;
    }
    let force = if truth.quantity == Quantity::Radius { None } else { Some(at("sneddon_F", &[a, 1.0])?) };
    let exact = truth.exact(Quantity::Equivalent, a)?;
    let of_g = machine.error(&[(own, 1.0)]).max(beyond(own.bounded.value - exact.value, exact.error)) + spacing(exact.value);
    let of_root = of_g / g_prime + 2.0 * spacing(a);
    let Some(force) = force else { return Some(of_root / spacing(a)) };
    let exact_force = truth.exact(Quantity::Force, a)?;
    // The depth is the same for the code and for the truth, so that only g and F differ.
    let difference = (force.bounded.value - exact_force.value) - 2.0 * a * (own.bounded.value - exact.value);
    let bound = machine.error(&[(force, 1.0), (own, -2.0 * a)]).max(beyond(difference, exact_force.error + 2.0 * a * exact.error));
    // Next to the root d - g(a) is exact; the rest are the roundings of its product and of the sum.
    Some((bound + g_prime * of_root * of_root) / spacing(exact_force.value) + 2.0)
}
