//! Closed forms against quadrature, quantity by quantity, at seeded points.

use super::{Contact, ContactError, Explicit, Measured, explicit};
use crate::expr::Bindings;
use crate::num::{Estimate, work};
use crate::transform::{Evaluator, Method, Sampler, Solution, Status, TransformError, Verdict, reach};

/// How one quantity fared.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// The symbol of the quantity.
    pub quantity: &'static str,
    /// The largest |closed − quadrature| relative to the size of the value; `None` where nothing could be compared.
    pub max_relative_difference: Option<f64>,
    /// The coordinate at which it is largest: x for g, a for d, F and G, r for p.
    pub at: Option<f64>,
    /// Points compared.
    pub points: u32,
    /// Passed where every difference stays within the sum of both error estimates, and within the tolerance that was set.
    pub verdict: Verdict,
    /// Why nothing was compared.
    pub why: Option<String>,
}

/// What is compared, and how.
#[derive(Clone, Copy, Debug, Default)]
pub struct Setting {
    /// The contact radius; random ones without it.
    pub radius: Option<f64>,
    /// The depth of a punch with a rim.
    pub depth: Option<f64>,
    /// The largest relative difference that may stand; only the error estimates judge without it.
    pub tolerance: Option<f64>,
}

/// Points per quantity.
const POINTS: u32 = 64;
/// Draws of the parameters among which the points are shared.
const DRAWS: u32 = 8;
/// The range of the tolerance that the quadratures are asked for.
const TIGHTEST: f64 = 1e-14;
const LOOSEST: f64 = 1e-12;

/// Compares g, d, F, p and G, and a(d) and F(d) where they are explicit, at 64 points each, at the set values or at seeded random admissible ones.
///
/// # Errors
/// [`ContactError`] where the profile cannot be evaluated at any admissible value of its parameters.
pub fn compare(solution: &Solution, setting: &Setting) -> Result<Vec<Comparison>, ContactError> {
    work::bounded(|| compared(solution, setting))
}

fn compared(solution: &Solution, setting: &Setting) -> Result<Vec<Comparison>, ContactError> {
    let mut sampler = Sampler::new(0x0c0a_9a6e);
    let draws = if solution.profile.parameters().is_empty() { 1 } else { DRAWS };
    let inverse = if setting.depth.is_none() { explicit(solution) } else { None };
    let mut found = started(solution, inverse.is_some());
    let (mut done, mut trouble) = (0, None);
    // Some draws may fail: there are twice as many as are needed.
    for _ in 0..2 * draws {
        let Some(bindings) = sampler.parameters(solution) else { break };
        let mut own = found.clone();
        let inverse = inverse.as_ref().and_then(|own| own.substitute(&bindings));
        match compare_at(solution, &bindings, inverse.as_ref(), setting, POINTS / draws, &mut sampler, &mut own) {
            Ok(()) => (found, done) = (own, done + 1),
            Err(error) => trouble = Some(error),
        }
        if done >= draws {
            break;
        }
    }
    if let (0, Some(error)) = (done, trouble) {
        return Err(error);
    }
    for own in found.iter_mut().filter(|own| own.why.is_none()) {
        if own.points == 0 {
            own.why = Some("no point could be compared".to_owned());
        } else if setting.tolerance.is_some_and(|most| !own.max_relative_difference.is_some_and(|own| own <= most)) {
            own.verdict = Verdict::Failed;
        }
    }
    Ok(found)
}

/// One empty comparison per quantity; those without a closed form say so.
fn started(solution: &Solution, explicit: bool) -> Vec<Comparison> {
    let (g, force) = (solution.equivalent_profile().status, solution.force().status);
    let pressure = solution.pressure().map_or(Status::Numeric, |own| own.status);
    let inverse = if explicit { vec![("a_of_d", Status::Exact), ("F_of_d", Status::Exact)] } else { Vec::new() };
    [("g", g), ("d", g), ("F", force), ("p", pressure), ("G", g)]
        .into_iter()
        .chain(inverse)
        .map(|(quantity, status)| Comparison {
            quantity,
            max_relative_difference: None,
            at: None,
            points: 0,
            verdict: Verdict::NotCompared,
            why: (status == Status::Numeric).then(|| "no closed form is known, only quadrature answers".to_owned()),
        })
        .collect()
}

fn compare_at(
    solution: &Solution,
    bindings: &Bindings,
    inverse: Option<&Explicit>,
    setting: &Setting,
    points: u32,
    sampler: &mut Sampler,
    found: &mut [Comparison],
) -> Result<(), ContactError> {
    let tolerance = setting.tolerance.unwrap_or(LOOSEST).clamp(TIGHTEST, LOOSEST);
    let contact = |method| -> Result<Contact<'_>, ContactError> {
        Ok(Contact::new(Evaluator::new(solution, bindings, method, tolerance)?, 1.0, setting.depth, tolerance))
    };
    let (closed, plain) = (contact(Method::Auto)?, contact(Method::Quadrature)?);
    // Beside terms without closed form, the closed ones are compared together with the integrals of the others.
    let strict = contact(Method::Exact)?;
    let end = setting.radius.unwrap_or_else(|| reach(closed.evaluator()));
    for a in sampler.points(end, points) {
        let radius = setting.radius.unwrap_or(a);
        let r = radius * sampler.fraction();
        if let Some(inverse) = inverse {
            // d and F by quadrature at a; the explicit forms must lead from d back to a, and on to F.
            let depth = plain.depth(a)?.estimate;
            // Under the flat part of a worn tip every radius has the depth 0.
            for own in found.iter_mut().filter(|_| depth.value > 0.0) {
                let (expr, known) = match own.quantity {
                    "a_of_d" => (&inverse.contact_radius, Estimate::exact(a)),
                    "F_of_d" => (&inverse.force, plain.force(a)?.estimate),
                    _ => continue,
                };
                own.take(depth.value, inverse.value(expr, depth.bounded(), 1.0).map_err(TransformError::from)?, known);
            }
        }
        for own in found.iter_mut().filter(|own| own.why.is_none() && !own.quantity.ends_with("_of_d")) {
            let at = if own.quantity == "p" { r } else { a };
            let read = |contact: &Contact<'_>| -> Result<Measured, ContactError> {
                Ok(match own.quantity {
                    "g" => Ok(contact.evaluator().slope(a)?),
                    "d" => Ok(contact.depth(a)?),
                    "F" => Ok(contact.force(a)?),
                    "p" => contact.pressure(r, radius)?,
                    _ => Ok(contact.integral(a)?),
                })
            };
            let one = match read(&strict) {
                Err(ContactError::Transform(
                    TransformError::NoClosedForm { .. } | TransformError::OutOfDomain { .. } | TransformError::Overflow { .. },
                )) => read(&closed)?,
                other => other?,
            };
            if let (Ok(one), Ok(other)) = (one, read(&plain)?) {
                own.take(at, one.estimate, other.estimate);
            }
        }
    }
    Ok(())
}

impl Comparison {
    fn take(&mut self, at: f64, one: Estimate, other: Estimate) {
        let difference = (one.value - other.value).abs();
        let size = one.value.abs().max(other.value.abs());
        let relative = if size > 0.0 { difference / size } else { 0.0 };
        if self.max_relative_difference.is_none_or(|largest| relative.is_nan() || relative > largest) {
            (self.max_relative_difference, self.at) = (Some(relative), Some(at));
        }
        // Written so that a NaN fails.
        let agrees = difference <= one.error + other.error;
        self.verdict = if agrees && self.verdict != Verdict::Failed { Verdict::Passed } else { Verdict::Failed };
        self.points += 1;
    }
}
