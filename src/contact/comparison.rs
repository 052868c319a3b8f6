//! Closed forms against quadrature, quantity by quantity, at seeded points.

use super::{Contact, ContactError, Explicit, Quantity, explicit};
use crate::expr::Bindings;
use crate::num::{Estimate, work};
use crate::transform::{Evaluator, Method, NO_REFERENCE, Sampler, Solution, Superposed, Tally, TransformError, Verdict, reach};
use std::borrow::Cow;

/// How one quantity fared.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// The symbol of the quantity.
    pub quantity: &'static str,
    /// The largest |closed − quadrature| relative to the size of the value; `None` if nothing could be compared.
    pub max_relative_difference: Option<f64>,
    /// The coordinate at which it is largest: x for g, a for d, F and G, r for p.
    pub at: Option<f64>,
    /// Points compared.
    pub points: u32,
    /// Passed where every difference stays within the sum of both bounds, and within the tolerance that was set.
    pub verdict: Verdict,
    /// Why nothing was compared.
    pub why: Option<Cow<'static, str>>,
}

/// Options of a comparison.
#[derive(Clone, Copy, Debug, Default)]
pub struct Setting {
    /// The contact radius; random ones without it.
    pub radius: Option<f64>,
    /// The depth of a punch with a rim.
    pub depth: Option<f64>,
    /// Largest relative difference to accept; `None` to use the error estimates alone.
    pub tolerance: Option<f64>,
}

/// The result of a comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparisons {
    /// One comparison per quantity.
    pub quantities: Vec<Comparison>,
    /// False if the budget of work ended the comparison.
    pub is_complete: bool,
}

/// Points per quantity.
const POINTS: u32 = 64;
/// Draws of the parameters among which the points are shared.
const DRAWS: u32 = 8;
/// Steps of work after which no new point is started: 64 points of an expensive profile prove no more than some of them.
const ENOUGH: u64 = 150_000_000;
/// The range of the tolerance of the quadratures.
const TIGHTEST: f64 = 1e-14;
const LOOSEST: f64 = 1e-12;

/// Compares g, d, F, p and G, and a(d) and F(d) where they are explicit, at up to 64 points each, at the set values or at seeded
/// random admissible ones.
///
/// A point counts where both values have digits enough to contradict each other; expensive profiles are compared at fewer points.
///
/// # Errors
/// [`ContactError`] if the profile cannot be evaluated at any admissible value of its parameters, or at the radius that is set.
pub fn compare(solution: &Solution, setting: &Setting) -> Result<Comparisons, ContactError> {
    work::bounded(|| {
        // The rest is for writing the answer.
        let most = work::left() - work::left() / 8;
        let (found, spent, is_complete) = work::until_deadline(|| work::apart(most, || compared(solution, setting)));
        work::spend(spent);
        let quantities = found?.into_iter().map(|own| own.outcome(setting, is_complete)).collect();
        Ok(Comparisons { quantities, is_complete })
    })
}

fn compared(solution: &Solution, setting: &Setting) -> Result<Vec<Subject>, ContactError> {
    let mut sampler = Sampler::new(0x0c0a_9a6e);
    let draws = if solution.profile.parameters().is_empty() { 1 } else { DRAWS };
    let inverse = if setting.depth.is_none() { explicit(solution) } else { None };
    let mut found = started(solution, inverse.is_some());
    let run = Run { solution, inverse, setting, enough: work::left().saturating_sub(ENOUGH) };
    let (mut done, mut trouble) = (0, None);
    // Some draws may fail: there are twice as many as are needed.
    for _ in 0..2 * draws {
        let Some(bindings) = sampler.parameters(solution) else {
            let why = ContactError::Missing { quantity: "a comparison", needs: "values of the parameters that meet the conditions" };
            found.iter_mut().for_each(|own| own.trouble = Some(why.clone()));
            break;
        };
        match run.compare_at(&bindings, POINTS / draws, &mut sampler, &mut found) {
            Ok(()) => done += 1,
            Err(error) => trouble = Some(error),
        }
        if done >= draws || run.is_over() {
            break;
        }
    }
    match trouble {
        Some(error) if done == 0 && !work::is_exhausted() => Err(error),
        _ => Ok(found),
    }
}

/// A quantity that is compared.
struct Subject {
    quantity: Quantity,
    /// The result; `None` if no closed form is known.
    tally: Option<Tally>,
    /// The first value that could not be had.
    trouble: Option<ContactError>,
}

impl Subject {
    fn outcome(self, setting: &Setting, is_complete: bool) -> Comparison {
        let Self { quantity, tally, trouble } = self;
        let verdict = tally.as_ref().map_or(Verdict::NotCompared, Tally::verdict);
        let why = match &tally {
            None => Some("no closed form gives its value, only quadrature does".into()),
            Some(_) if verdict != Verdict::NotCompared => None,
            Some(_) if !is_complete => Some("the work limit was reached".into()),
            Some(_) => Some(match trouble {
                None | Some(ContactError::Transform(TransformError::NoDigits { .. })) => NO_REFERENCE.into(),
                Some(error) => error.to_string().into(),
            }),
        };
        let tally = tally.filter(|_| why.is_none()).unwrap_or_default();
        let too_large = setting.tolerance.is_some_and(|most| tally.largest > most);
        Comparison {
            quantity: quantity.relation(),
            max_relative_difference: tally.at.map(|_| tally.largest),
            at: tally.at,
            points: tally.compared,
            verdict: if too_large { Verdict::Failed } else { verdict },
            why,
        }
    }
}

/// One subject per quantity.
fn started(solution: &Solution, explicit: bool) -> Vec<Subject> {
    let (g, force) = (solution.has_closed(Superposed::Equivalent), solution.has_closed(Superposed::Force));
    let pressure = solution.has_closed(Superposed::Pressure) && solution.pressure().is_some();
    let inverse = if explicit { vec![(Quantity::Radius, true), (Quantity::ForceOfDepth, true)] } else { Vec::new() };
    let direct = [Quantity::Equivalent, Quantity::Depth, Quantity::Force, Quantity::Pressure, Quantity::Integral];
    direct
        .into_iter()
        .zip([g, g, force, pressure, g])
        .chain(inverse)
        .map(|(quantity, is_closed)| Subject { quantity, tally: is_closed.then(Tally::default), trouble: None })
        .collect()
}

/// The data of one call.
struct Run<'a> {
    solution: &'a Solution,
    inverse: Option<Explicit>,
    setting: &'a Setting,
    /// No further point is begun once fewer steps are left.
    enough: u64,
}

impl Run<'_> {
    fn is_over(&self) -> bool {
        work::left() < self.enough || work::is_exhausted()
    }

    fn compare_at(&self, bindings: &Bindings, points: u32, sampler: &mut Sampler, found: &mut [Subject]) -> Result<(), ContactError> {
        let tolerance = self.setting.tolerance.unwrap_or(LOOSEST).clamp(TIGHTEST, LOOSEST);
        let contact = |method| -> Result<Contact<'_>, ContactError> {
            let evaluator = Evaluator::new(self.solution, bindings, method, tolerance)?;
            Ok(Contact::new(evaluator, 1.0, self.setting.depth, tolerance))
        };
        let (closed, plain) = (contact(Method::Auto)?, contact(Method::Quadrature)?);
        // Beside terms without closed form, the closed ones are compared together with the integrals of the others.
        let contacts = [contact(Method::Exact)?, closed, plain];
        let [_, closed, plain] = &contacts;
        let end = match self.setting.radius {
            Some(radius) => closed.evaluator().equivalent(radius).map(|_| radius).map_err(TransformError::of_radius)?,
            None => reach(closed.evaluator()),
        };
        let typed = plain.evaluator().typed()?;
        let inverse = self.inverse.as_ref().and_then(|own| own.substitute(bindings));
        for a in sampler.points(end, points) {
            let radius = self.setting.radius.unwrap_or(a);
            let r = radius * sampler.fraction();
            if self.is_over() {
                break;
            }
            if !typed.is_seen(a) {
                continue;
            }
            let depth = inverse.as_ref().and_then(|_| plain.depth(a).ok()).map(|own| own.estimate);
            for own in found.iter_mut() {
                let Some(tally) = &mut own.tally else { continue };
                let (at, pair) = match own.quantity {
                    Quantity::Radius | Quantity::ForceOfDepth => match (&inverse, depth) {
                        // Under the flat part of a worn tip every radius has the depth 0.
                        (Some(inverse), Some(depth)) if depth.value > 0.0 => {
                            (depth.value, retraced(own.quantity, inverse, depth, a, plain))
                        }
                        _ => continue,
                    },
                    Quantity::Pressure => (r, pair(own.quantity, r, radius, &contacts)),
                    other => (a, pair(other, a, a, &contacts)),
                };
                match pair {
                    // What was read after the budget was exhausted is not complete.
                    _ if work::is_exhausted() => {}
                    Ok(Some([one, other])) => tally.take(at, one, other),
                    Ok(None) => {}
                    Err(error) => own.trouble = own.trouble.take().or(Some(error)),
                }
            }
        }
        Ok(())
    }
}

/// A quantity by its closed form and by quadrature; `None` if it is infinite.
fn pair(quantity: Quantity, at: f64, a: f64, [strict, closed, plain]: &[Contact<'_>; 3]) -> Result<Option<[Estimate; 2]>, ContactError> {
    let read = |contact: &Contact<'_>| quantity.number(contact, at, a);
    let (one, other) = (read(strict).or_else(|_| read(closed))?, read(plain)?);
    Ok(one.ok().zip(other.ok()).map(|(one, other)| [one.estimate, other.estimate]))
}

/// a or F from the depth that quadrature gives at a by an explicit form, and as it must come out.
fn retraced(
    quantity: Quantity,
    inverse: &Explicit,
    depth: Estimate,
    a: f64,
    plain: &Contact<'_>,
) -> Result<Option<[Estimate; 2]>, ContactError> {
    let (expr, known) = match quantity {
        Quantity::Radius => (&inverse.contact_radius, Estimate::exact(a)),
        _ => (&inverse.force, plain.force(a)?.estimate),
    };
    Ok(Some([inverse.value(expr, depth.bounded(), 1.0).map_err(TransformError::from)?, known]))
}
