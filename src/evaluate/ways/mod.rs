//! The ways to a number: one entry each, for `--method`, for the list of `--explain` and for the tests of their bounds.
//!
//! A way computes the number, or returns `None` if it cannot. `combine` adds closed forms and integrals, asks the ways in the order of
//! their cost and returns the most accurate result; `pressure`, `height` and `energy` have what is special to these quantities.

pub(crate) mod best;
pub(crate) mod closed_slope;
pub(crate) mod combine;
pub(crate) mod energy;
pub(crate) mod height;
pub(crate) mod pressure;

use crate::derive::closed_form::{
    ClosedForm, DOUBLES, THIRTY_DIGITS, WIDE_EXPONENT, good_enough, in_30_digits, in_doubles, in_wide, rounded, total,
};
use crate::derive::superposed::Superposed;
use crate::evaluate::evaluator::{Evaluator, Reading};
use crate::evaluate::ways::combine::unless_underflown;
use crate::evaluate::ways::pressure::FIRST_DIGITS;
use crate::integrate::ask::{
    Ask, BISECTION, ELLIPTIC, GAUSS, LEGENDRE, LEGENDRE_SAMPLED, NESTED, OVER_U, OVER_U_SAMPLED, PIECES, STRAIGHT,
};
use crate::integrate::error::TransformError;
use crate::num::{Bound, Bounded, Estimate, Precise};
use std::fmt;

/// The key of the integral of the derivative of a closed g …
pub(crate) const CLOSED_SLOPE: &str = "closed-slope";
/// … of integrals over the recognition form of f′ …
pub(crate) const RECOGNISED: &str = "recognised";
/// … and of the power series at the axis.
pub(crate) const SERIES: &str = "series";

/// One way to a number.
pub struct Way {
    /// The key, as `--method` takes it.
    pub key: &'static str,
    /// A description of the method.
    pub title: &'static str,
    /// The keys of the quantities that it computes: f, g, G, F, p, u outside the contact, and the stress on the axis.
    pub quantities: &'static [&'static str],
    /// The best that its error may rest on.
    pub bound: Bound,
    /// Why it has no answer where it has none.
    pub missing: &'static str,
    /// `exact`, `quadrature`, `series` or `mixed`.
    method: &'static str,
    run: Run,
}

/// The number, found in this way; `None` if it has no answer.
type Run = fn(&Way, &Evaluator<'_>, Ask) -> Result<Option<Estimate>, TransformError>;

const OPEN: &str = "a term has no closed form";
const UNREPRESENTED: &str = "an intermediate value overflows, or has no value in these numbers";
const UNPROVEN: &str = "no rule could be proven accurate enough from enclosures of f′";
const UNMET: &str = "its rules do not reach the tolerance for this f′";

/// Every way, roughly in the order of their cost.
pub static WAYS: [Way; 17] = [
    closed(DOUBLES, "closed forms in double precision"),
    closed(THIRTY_DIGITS, "closed forms with 30 digits, rounded once"),
    closed(WIDE_EXPONENT, "closed forms with 30 digits and an exponent that does not overflow"),
    Way {
        missing: "an integral is infinite or too large for a number",
        method: "mixed",
        run: in_parts,
        ..integral(
            Estimate::SEVERAL,
            "closed forms where terms have one, and the cheapest integral for each other term",
            ALL,
            Bound::Proven,
        )
    },
    integral(GAUSS, "one Gauss rule, proven to suffice by an enclosure of f′", &["g", "F", "G"], Bound::Proven),
    Way {
        missing: "f is not straight between its kinks",
        ..integral(
            STRAIGHT,
            "the elliptic kernel and one proven integral for every kink of an f that is straight between them",
            &["p"],
            Bound::Proven,
        )
    },
    integral(LEGENDRE, "expansion of f′ in Legendre polynomials, with a number of terms proven to suffice", &["p"], Bound::Proven),
    integral(OVER_U, "∫ g′(r cosh u) du with proven rules", &["p"], Bound::Proven),
    integral(PIECES, "pieces, each with a rule proven to suffice by an enclosure", &["g", "F", "G", "p"], Bound::Proven),
    Way {
        missing: UNMET,
        ..integral(
            NESTED,
            "nested rules over the angle; the error is estimated from their differences",
            &["g", "F", "G", "u"],
            Bound::Estimated,
        )
    },
    Way {
        missing: UNMET,
        ..integral(
            LEGENDRE_SAMPLED,
            "expansion of f′ in Legendre polynomials; the error is estimated from values of f′",
            &["p"],
            Bound::Estimated,
        )
    },
    Way {
        missing: UNMET,
        ..integral(
            OVER_U_SAMPLED,
            "∫ g′(r cosh u) du with nested rules; the error is estimated from their differences",
            &["p"],
            Bound::Estimated,
        )
    },
    integral(ELLIPTIC, "∫ (r f′)′ K(r, s) dr with the elliptic kernel, by adaptive Gauss–Kronrod quadrature", &["p"], Bound::Estimated),
    integral(BISECTION, "adaptive Gauss–Kronrod quadrature", &["f", "g", "F", "G", "u", "sigma_zz"], Bound::Estimated),
    Way {
        missing: "it needs a closed g without a kink beyond r",
        run: by_closed_slope,
        ..integral(CLOSED_SLOPE, "∫ g′/√(x²−r²) dx with the derivative of the closed g", &["p"], Bound::Estimated)
    },
    Way { run: by_recognition, ..integral(RECOGNISED, "integrals of f′ in the normal form that the rules match", ALL, Bound::Proven) },
    Way {
        missing: "no power series of f is proven to give even one digit there",
        method: "series",
        run: by_series,
        ..integral(SERIES, "the power series at the axis with a proven remainder", &["f", "g", "F", "G", "p"], Bound::Proven)
    },
];

const ALL: &[&str] = &["f", "g", "F", "G", "p", "u", "sigma_zz"];

const fn closed(key: &'static str, title: &'static str) -> Way {
    Way { missing: OPEN, method: "exact", run: by_closed_forms, ..integral(key, title, ALL, Bound::Proven) }
}

const fn integral(key: &'static str, title: &'static str, quantities: &'static [&'static str], bound: Bound) -> Way {
    Way { key, title, quantities, bound, missing: UNPROVEN, method: "quadrature", run: by_integral }
}

impl Way {
    /// The way of a key.
    ///
    /// ```
    /// use sneddon::transform::Way;
    /// assert_eq!(Way::of("nested").unwrap().quantities, ["g", "F", "G", "u"]);
    /// ```
    pub fn of(key: &str) -> Option<&'static Self> {
        WAYS.iter().find(|own| own.key == key)
    }

    /// Refuses a quantity that this way does not compute.
    pub(crate) fn check(&self, ask: Ask) -> Result<(), TransformError> {
        if self.quantities.contains(&ask.key()) { Ok(()) } else { Err(TransformError::NoSuchWay { way: self.key, quantity: ask.key() }) }
    }

    /// The requested number, computed by this way alone; `None` if it is theoretically infinite.
    ///
    /// # Errors
    /// [`TransformError::NoSuchWay`] for another quantity, [`TransformError::NotThisWay`] if the way has no answer, and what
    /// [`Evaluator::equivalent`] has.
    pub(crate) fn answer(&'static self, evaluator: &Evaluator<'_>, ask: Ask) -> Result<Option<Reading>, TransformError> {
        self.check(ask)?;
        let none = |reason| TransformError::NotThisWay { way: self.key, reason };
        match (self.run)(self, evaluator, ask) {
            Ok(Some(own)) if own.value.is_finite() && own.error.is_finite() => {
                Ok(Some(Reading { estimate: own.by(self.key), method: self.method }))
            }
            Ok(Some(_)) => Err(none(UNREPRESENTED)),
            Ok(None) | Err(TransformError::NotThisWay { .. }) => Err(none(self.missing)),
            Err(other) => Err(other),
        }
    }
}

impl PartialEq for Way {
    fn eq(&self, other: &Self) -> bool {
        self.key == other.key
    }
}

impl Eq for Way {}

impl fmt::Debug for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.key)
    }
}

/// The quantity whose terms have closed forms.
fn superposed(ask: Ask) -> Option<Superposed> {
    match ask {
        Ask::Equivalent(_) => Some(Superposed::Equivalent),
        Ask::Force(_) => Some(Superposed::Force),
        Ask::Pressure { .. } => Some(Superposed::Pressure),
        Ask::Outside { .. } => Some(Superposed::Outside),
        Ask::Axial { .. } => Some(Superposed::Axial),
        Ask::Integral(_) | Ask::Height(_) => None,
    }
}

fn by_closed_forms(way: &Way, evaluator: &Evaluator<'_>, ask: Ask) -> Result<Option<Estimate>, TransformError> {
    let coordinates = ask.coordinates();
    if let Ask::Integral(a) = ask {
        let forms = |quantity| evaluator.closed_forms(quantity, a);
        let (Some(equivalent), Some(force)) = (forms(Superposed::Equivalent)?, forms(Superposed::Force)?) else { return Ok(None) };
        let precise = |sum: fn(&[&_], &[f64]) -> Precise| rounded(Precise::exact(a).mul(sum(&equivalent, &[a])).sub(sum(&force, &[a])));
        let found = match way.key {
            DOUBLES => Bounded::exact(a) * in_doubles(&equivalent, &[a]) - in_doubles(&force, &[a]),
            THIRTY_DIGITS => precise(in_30_digits),
            _ => precise(in_wide),
        };
        return Ok(Some(Estimate::from_bounded(found, 0)));
    }
    let (forms, inputs) = match superposed(ask) {
        Some(quantity) => match evaluator.closed_forms(quantity, ask.reach())? {
            Some(forms) => (forms, quantity.inputs(&coordinates)),
            None => return Ok(None),
        },
        None => (evaluator.forms_of_height(ask.reach())?, coordinates.split_at(1).1),
    };
    let found = match way.key {
        DOUBLES => in_doubles(&forms, inputs),
        THIRTY_DIGITS => rounded(in_30_digits(&forms, inputs)),
        _ => rounded(in_wide(&forms, inputs)),
    };
    Ok(Some(Estimate::from_bounded(found, 0)))
}

fn by_integral(way: &Way, evaluator: &Evaluator<'_>, ask: Ask) -> Result<Option<Estimate>, TransformError> {
    let profile = evaluator.typed()?;
    unless_underflown(profile, ask, profile.in_the_way(way.key, ask, evaluator.tolerance))
}

fn by_recognition(_: &Way, evaluator: &Evaluator<'_>, ask: Ask) -> Result<Option<Estimate>, TransformError> {
    let profile = evaluator.recognised()?;
    unless_underflown(profile, ask, profile.answer(ask, evaluator.tolerance))
}

fn by_closed_slope(_: &Way, evaluator: &Evaluator<'_>, ask: Ask) -> Result<Option<Estimate>, TransformError> {
    let [r, a] = ask.coordinates();
    Ok(evaluator.pressure_by_closed_slope(r, a, FIRST_DIGITS))
}

fn by_series(_: &Way, evaluator: &Evaluator<'_>, ask: Ask) -> Result<Option<Estimate>, TransformError> {
    Ok(evaluator.by_series(ask).ok().flatten().map(|own| own.estimate))
}

/// Closed terms and the integrals of the others; where no term is closed, f′ interval by interval.
fn in_parts(_: &Way, evaluator: &Evaluator<'_>, ask: Ask) -> Result<Option<Estimate>, TransformError> {
    let coordinates = ask.coordinates();
    let sum = |forms: &[&ClosedForm], inputs: &[f64]| total(forms, inputs, good_enough(evaluator.tolerance));
    let Some(quantity) = superposed(ask) else {
        return match ask {
            Ask::Height(r) => Ok(Some(sum(&evaluator.forms_of_height(r)?, &[r]))),
            Ask::Integral(a) => evaluator.integral_of_parts(a).map(|own| Some(own.estimate)),
            _ => by_intervals(evaluator, ask),
        };
    };
    let (mut open, mut forms) = (Estimate::exact(0.0), Vec::new());
    for index in 0..evaluator.chains.len() {
        let part = evaluator.part(index, quantity)?;
        forms.extend(evaluator.closed_form(index, evaluator.interval(index, ask.reach()), quantity)?);
        if !part.open.is_empty() {
            let Some(found) = part.open.answer(ask, evaluator.tolerance)? else { return Ok(None) };
            open = open + found;
        }
    }
    if forms.is_empty() { by_intervals(evaluator, ask) } else { Ok(Some(sum(&forms, quantity.inputs(&coordinates)) + open)) }
}

/// f′ as typed, interval by interval.
fn by_intervals(evaluator: &Evaluator<'_>, ask: Ask) -> Result<Option<Estimate>, TransformError> {
    let profile = evaluator.typed()?;
    unless_underflown(profile, ask, profile.answer(ask, evaluator.tolerance))
}
