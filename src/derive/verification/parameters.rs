//! One random set of parameters, and the comparison of a term with quadrature for these parameters.

pub(super) mod fields;

use super::Verdict;
use crate::derive::chain::Chain;
use crate::derive::rule::{Answer, Pair};
use crate::derive::sample::{Sampler, admissible};
use crate::derive::solved::SolvedChain;
use crate::derive::term::Term;
use crate::eval::{BoundedAlgebra, FloatAlgebra, Tape, constant_value};
use crate::expr::{Bindings, Condition, Expr, Symbol};
use crate::integrate::integral::NumericProfile;
use crate::integrate::segment::Segment;
use crate::num::stable::leg;
use crate::num::{Bound, Bounded, Estimate};
use std::sync::LazyLock;

/// Required agreement relative to ∫|integrand|: two independent computations do not agree to nine digits by chance.
const ENOUGH: f64 = 1e-9;
/// Larger relative bounds are inconclusive.
const TELLING: f64 = 1e-6;
/// The tolerance of the quadrature with proven bounds.
const TOLERANCE: f64 = 1e-10;

/// Numbers for the parameters at which terms are compared.
pub(super) struct ParameterDraw {
    bindings: Bindings,
    names: Vec<Symbol>,
    values: Vec<f64>,
    limit: f64,
    /// True for the first draw: the comparison at a large radius is expensive and made only once.
    first: bool,
}

/// Where a radius lies with respect to a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Within,
    Beyond,
    /// Within, but at a radius so large that an inconclusive comparison is acceptable: only a contradiction counts.
    Far,
}

impl Part {
    /// Records that a comparison at a radius of this part was conclusive.
    fn record(self, [within, beyond]: &mut [bool; 2]) {
        *within |= self == Self::Within;
        *beyond |= self == Self::Beyond;
    }
}

/// The ends of a segment, and the radii at which its term is compared.
struct Radii {
    lower: f64,
    upper: Option<f64>,
    all: Vec<(f64, Part)>,
    /// Further radii within the segment, for terms that cancel at the others, such as (r − b)²⁰ near b and r³⁰ sinh r near 0.
    spare: Vec<f64>,
}

impl ParameterDraw {
    /// Seeded admissible values; `None` if none were found.
    pub(super) fn seeded(names: Vec<Symbol>, limits: &[Expr], conditions: &[Condition], draw: u64) -> Option<Self> {
        let bindings = Sampler::new(0x6a7e + draw).admissible(&names, conditions)?;
        let number = |expr: &Expr| constant_value(expr, &bindings).map(|own| own.value).ok();
        let values = names.iter().map(|name| number(&Expr::from(name.clone()))).collect::<Option<Vec<_>>>()?;
        let limits = limits.iter().map(number).collect::<Option<Vec<_>>>()?;
        let limit = limits.into_iter().fold(f64::INFINITY, f64::min);
        Some(Self { bindings, names, values, limit, first: draw == 0 })
    }

    /// Whether conditions on the parameters hold here; conditions on radii are ignored.
    pub(super) fn admits(&self, conditions: &[Condition]) -> bool {
        conditions.iter().all(|own| admissible(&own.substitute(&self.bindings)))
    }

    fn number(&self, expr: &Expr) -> Option<f64> {
        if expr.is_zero() { Some(0.0) } else { constant_value(expr, &self.bindings).ok().map(|own| own.value) }
    }

    fn bounded(&self, tape: &Tape, variables: &[f64]) -> Option<Vec<Bounded>> {
        let inputs: Vec<Bounded> = variables.iter().chain(&self.values).copied().map(Bounded::exact).collect();
        tape.run_all(&mut BoundedAlgebra, &inputs, &mut Vec::new())
    }

    /// Radii within a segment and, if it ends, beyond it; if it is unbounded, also a large radius, where functions use other
    /// methods of evaluation.
    fn radii(&self, segment: &Segment) -> Option<Radii> {
        let lower = self.number(&segment.lower)?;
        let upper = match &segment.upper {
            Some(upper) => Some(self.number(upper)?),
            None => None,
        };
        let top = upper.unwrap_or(f64::INFINITY).min(self.limit);
        let (within, far) = match (top.is_finite(), lower > 0.0) {
            (true, _) => ([lower + 0.613 * (top - lower), lower + 0.287 * (top - lower)], None),
            (false, true) => ([1.617 * lower, 1.083 * lower], Some(23.7 * lower)),
            (false, false) => ([1.093, 0.311], Some(17.3)),
        };
        let spare = match (top.is_finite(), lower > 0.0) {
            (true, _) => vec![lower + 0.937 * (top - lower)],
            (false, true) => vec![3.93 * lower, 11.3 * lower],
            (false, false) => vec![2.47, 5.13, 11.7],
        };
        let beyond = upper.into_iter().flat_map(|upper| [1.21 * upper, 2.63 * upper]).filter(|x| *x < self.limit);
        let all = within.map(|x| (x, Part::Within)).into_iter();
        let all = all.chain(beyond.map(|x| (x, Part::Beyond))).chain(far.filter(|_| self.first).map(|x| (x, Part::Far))).collect();
        Some(Radii { lower, upper, all, spare })
    }

    /// False if the terms are proven not to add up to the typed f′.
    pub(super) fn recognition_holds(&self, chain: &Chain, slopes: &[Expr], solved: &[SolvedChain]) -> bool {
        let of = |interval: usize| {
            let own = |chain: &SolvedChain| {
                let index = if chain.breakpoints.is_empty() { 0 } else { interval };
                chain.intervals.get(index).map(|own| own.terms.iter().map(|solved| solved.term.f_prime()).collect::<Vec<_>>())
            };
            solved.iter().filter_map(own).flatten().collect::<Vec<_>>()
        };
        chain.intervals().zip(slopes).enumerate().all(|(index, ((lower, upper, _), f_prime))| {
            let terms = of(index);
            if Expr::sum(terms.iter().cloned()) == *f_prime {
                return true;
            }
            let Some(radii) = self.radii(&Segment { lower, upper: upper.cloned() }) else { return true };
            let mut outputs = vec![f_prime.clone()];
            outputs.extend(terms);
            let Some(tape) = compile(&outputs, &["r"], &self.names) else { return true };
            // This piece equals f only below its upper end.
            radii.all.first().is_none_or(|(r, _)| {
                let Some(values) = self.bounded(&tape, &[*r]) else { return true };
                let Some((typed, parts)) = values.split_first() else { return true };
                let sum = parts.iter().fold(Bounded::exact(0.0), |sum, part| sum + *part);
                // The comparison is written so that NaN is inconclusive.
                let apart = (typed.value - sum.value).abs() > typed.error + sum.error;
                !apart
            })
        })
    }

    /// Compares g and F/(2E*) of a term at its radii; `None` if they have no value somewhere.
    pub(super) fn compare(&self, subject: &Subject<'_>) -> Option<[Verdict; 2]> {
        let Radii { lower, upper, all, spare } = self.radii(subject.segment)?;
        let mut verdicts = [Verdict::Agrees; 2];
        // Whether a comparison was conclusive within the segment, and beyond it if the segment ends.
        let ends = all.iter().any(|(_, part)| *part == Part::Beyond);
        let mut conclusive = [[false, !ends]; 2];
        let spare = spare.into_iter().map(|x| (x, Part::Within));
        for (index, (x, part)) in all.iter().copied().chain(spare).enumerate() {
            if index >= all.len() && conclusive.iter().all(|[within, _]| *within) {
                break;
            }
            let own = if part == Part::Beyond { subject.beyond.as_ref()? } else { &subject.within };
            let Some(values) = self.bounded(&own.equivalent_and_force, &[x, x]) else {
                if part == Part::Far { continue } else { return None }
            };
            let integrals = self.integrals(&subject.tape, lower, upper, x);
            for (quantity, (verdict, conclusive)) in verdicts.iter_mut().zip(&mut conclusive).enumerate() {
                let (Some(evaluated), Some(shown), Some((value, size))) =
                    (values.get(quantity), values.get(quantity + 2), integrals.get(quantity).copied())
                else {
                    continue;
                };
                let is_telling = |own: &Bounded| own.error <= TELLING * size;
                let agrees = |own: &Bounded| is_telling(own) && (own.value - value).abs() <= ENOUGH * size + own.error;
                if agrees(evaluated) && (agrees(shown) || !is_telling(shown)) {
                    part.record(conclusive);
                    continue;
                }
                if part == Part::Far && !(is_telling(evaluated) && value.is_finite()) {
                    continue;
                }
                let proven = self.proven(subject, quantity, x);
                let is_wrong = |own: &Bounded| proven.is_some_and(|truth| (own.value - truth.value).abs() > own.error + truth.error);
                let is_known = proven.is_some_and(|truth| truth.error <= TELLING * size);
                if is_wrong(evaluated) || is_wrong(shown) {
                    *verdict = Verdict::Wrong;
                } else if part != Part::Far && is_telling(evaluated) {
                    // A form without accurate digits, as next to a kink or after underflow, is compared at the other radii only.
                    if is_known {
                        part.record(conclusive);
                    } else if *verdict == Verdict::Agrees && self.has_digits(&subject.tape, 0.5 * (lower + x)) {
                        *verdict = Verdict::Unknown;
                    }
                }
            }
        }
        for (verdict, conclusive) in verdicts.iter_mut().zip(conclusive) {
            if *verdict == Verdict::Agrees && conclusive != [true; 2] {
                *verdict = Verdict::Unknown;
            }
        }
        Some(verdicts)
    }

    /// x ∫ f′ dt and ∫ r² f′ dt with their sizes, r = x sin t, by one double exponential rule in plain doubles.
    fn integrals(&self, tape: &Tape, lower: f64, upper: Option<f64>, x: f64) -> [(f64, f64); 2] {
        let angle = |end: f64| if end < x { end.atan2(leg(x, end)) } else { std::f64::consts::FRAC_PI_2 };
        let (from, to) = (angle(lower), angle(upper.unwrap_or(f64::INFINITY)));
        let mut found = [(0.0, 0.0); 2];
        let (mut slots, mut inputs) = (Vec::new(), Vec::with_capacity(1 + self.values.len()));
        inputs.push(0.0);
        inputs.extend(&self.values);
        for half in RULE.iter() {
            let mut negligible = 0;
            for (u, weight) in half {
                let r = x * (from + (to - from) * u).sin();
                if let Some(first) = inputs.first_mut() {
                    *first = r;
                }
                let f_prime = tape.run(&mut FloatAlgebra, &inputs, &mut slots).unwrap_or(f64::NAN) * weight * (to - from);
                let mut grows = false;
                for ((sum, size), factor) in found.iter_mut().zip([x, r * r]) {
                    let part = f_prime * factor;
                    *sum += part;
                    *size += part.abs();
                    // The comparison is written so that NaN ends the loop.
                    grows |= part.abs() > f64::EPSILON * *size;
                }
                negligible = if grows { 0 } else { negligible + 1 };
                if negligible == ENDED {
                    break;
                }
            }
        }
        found
    }

    /// Returns true if f′ of the term is accurate at this radius; if its terms cancel, plain quadrature of f′ is inconclusive.
    fn has_digits(&self, tape: &Tape, r: f64) -> bool {
        self.bounded(tape, &[r]).is_some_and(|own| own.iter().all(|own| own.error <= ENOUGH * own.value.abs()))
    }

    /// g or F/(2E*) of a term by quadrature with a proven bound.
    fn proven(&self, subject: &Subject<'_>, quantity: usize, x: f64) -> Option<Bounded> {
        self.proven_by(
            subject,
            x,
            |profile| {
                if quantity == 0 { profile.equivalent(x, TOLERANCE).ok() } else { profile.force(x, TOLERANCE).ok() }
            },
        )
    }

    /// A value of a term up to x with a proven bound; beyond an upper end, the difference of two unbounded terms.
    fn proven_by(&self, subject: &Subject<'_>, x: f64, number: impl Fn(&NumericProfile) -> Option<Estimate>) -> Option<Bounded> {
        let from = |lower: &Expr| {
            let endless = Segment { lower: lower.clone(), upper: None };
            let profile = NumericProfile::new(&[(endless, subject.f_prime.clone())], &self.bindings).ok()?;
            let found = number(&profile)?;
            (found.bound == Bound::Proven && found.error.is_finite()).then(|| found.bounded())
        };
        let whole = from(&subject.segment.lower)?;
        match &subject.segment.upper {
            Some(upper) if self.number(upper)? < x => Some(whole - from(upper)?),
            _ => Some(whole),
        }
    }

    /// Compares p·π/E* of a term, within its segment and beyond it, with ∫ g′/√(x²−r²) dx over its closed g, which has been
    /// compared before; only a proven quadrature of f′ contradicts.
    pub(super) fn compare_pressure(&self, subject: &Subject<'_>) -> Option<Verdict> {
        let radii = self.radii(subject.segment)?;
        let within = &subject.within;
        let (end, _) = *radii.all.first()?;
        let begin = radii.lower + 0.7 * (end - radii.lower);
        // P vanishes at the edge of the contact and at the beginning of the segment.
        let mut verdict = Verdict::Agrees;
        for r in [0.57 * begin, 0.11 * begin] {
            let start = self.bounded(within.pressure.as_ref()?, &[r, r.max(radii.lower) * (1.0 + 1e-12)])?;
            let start = start.into_iter().map(|own| (own, 0.0)).collect();
            verdict = verdict.and(self.pressure_at(r, within, start, [begin, end], subject)?);
        }
        if let (Some(upper), Some((end, _))) = (radii.upper, radii.all.iter().find(|(_, part)| *part == Part::Beyond)) {
            let beyond = subject.beyond.as_ref()?;
            let (below, above) = (upper * (1.0 - 1e-12), upper * (1.0 + 1e-12));
            let r = 0.57 * begin;
            // P is continuous at the end of the segment except for a jump of g.
            let jump = (self.plain(&beyond.equivalent, above)? - self.plain(&within.equivalent, below)?) / leg(upper, r);
            let before = self.bounded(within.pressure.as_ref()?, &[r, below])?;
            let after = self.bounded(beyond.pressure.as_ref()?, &[r, above])?;
            let start = after.into_iter().zip(before).map(|(after, before)| (after, before.value + jump)).collect();
            verdict = verdict.and(self.pressure_at(r, beyond, start, [1.05 * upper, *end], subject)?);
        }
        Some(verdict)
    }

    /// Compares P(r; a₂) − P(r; a₁) with the integral from a₁ to a₂, by parts over g, and checks the initial value of P.
    fn pressure_at(
        &self,
        r: f64,
        forms: &Side,
        start: Vec<(Bounded, f64)>,
        [begin, end]: [f64; 2],
        subject: &Subject<'_>,
    ) -> Option<Verdict> {
        let root = |x: f64| leg(x, r);
        let g = |x: f64| self.plain(&forms.equivalent, x);
        let mut rise = g(end)? / root(end) - g(begin)? / root(begin);
        for (u, weight) in RULE.iter().flatten().filter(|(_, weight)| *weight > f64::EPSILON) {
            let x = begin + (end - begin) * u;
            rise += weight * (end - begin) * g(x)? * x / root(x).powi(3);
        }
        let pressure = forms.pressure.as_ref()?;
        let (far, near) = (self.bounded(pressure, &[r, end])?, self.bounded(pressure, &[r, begin])?);
        let mut proven = None;
        let mut verdict = Verdict::Agrees;
        for ((far, near), (first, expected)) in far.iter().zip(&near).zip(&start) {
            let size = far.value.abs().max(near.value.abs()).max(rise.abs());
            let error = far.error + near.error;
            let is_telling = error + first.error <= TELLING * size;
            // The integral from the beginning is of the order of the root of the distance.
            let agrees = (far.value - near.value - rise).abs() <= ENOUGH * size + error
                && (first.value - expected).abs() <= 1e-3 * size + first.error;
            if is_telling && agrees {
                continue;
            }
            let truth =
                *proven.get_or_insert_with(|| self.proven_by(subject, end, |profile| profile.pressure(r, end, TOLERANCE).ok().flatten()));
            verdict = verdict.and(match truth {
                Some(truth) if (far.value - truth.value).abs() > far.error + truth.error => Verdict::Wrong,
                Some(truth) if truth.error + far.error <= TELLING * size => Verdict::Agrees,
                _ => Verdict::Unknown,
            });
        }
        Some(verdict)
    }

    /// An expression over one variable in plain doubles; `None` if it is not finite.
    fn plain(&self, tape: &Tape, x: f64) -> Option<f64> {
        let inputs: Vec<f64> = std::iter::once(x).chain(self.values.iter().copied()).collect();
        tape.run(&mut FloatAlgebra, &inputs, &mut Vec::new()).filter(|own| own.is_finite())
    }
}

/// A solved term, compiled over the parameters of its profile.
pub(super) struct Subject<'a> {
    f_prime: Expr,
    segment: &'a Segment,
    tape: Tape,
    within: Side,
    beyond: Option<Side>,
}

/// The closed forms on one side of the end of a segment.
struct Side {
    /// g, F/(2E*) as evaluated, then as shown, over x and a.
    equivalent_and_force: Tape,
    /// g as evaluated, over x.
    equivalent: Tape,
    /// p·π/E* as evaluated, then as shown, over r and a; `None` if it remains an integral.
    pressure: Option<Tape>,
}

impl<'a> Subject<'a> {
    /// Compiles f′ and the solution of a term; `None` if a symbol is not a parameter of the profile.
    pub(super) fn new(term: &'a Term, answer: &Answer, names: &[Symbol]) -> Option<Self> {
        let side = |equivalent: &Pair, force: &Pair, pressure: Option<&Pair>| {
            let both = [&equivalent.evaluated, &force.evaluated, &equivalent.shown, &force.shown].map(Expr::clone);
            Some(Side {
                equivalent_and_force: compile(&both, &["x", "a"], names)?,
                equivalent: compile(std::slice::from_ref(&equivalent.evaluated), &["x"], names)?,
                pressure: match pressure {
                    Some(own) => Some(compile(&[own.evaluated.clone(), own.shown.clone()], &["r", "a"], names)?),
                    None => None,
                },
            })
        };
        let (own, pressure) = (answer, answer.pressure.as_ref());
        let f_prime = term.f_prime();
        Some(Self {
            tape: compile(std::slice::from_ref(&f_prime), &["r"], names)?,
            f_prime,
            segment: &term.segment,
            within: side(&own.equivalent.within, &own.force.within, pressure.map(|own| &own.within))?,
            beyond: match &term.segment.upper {
                Some(_) => Some(side(&own.equivalent.beyond, &own.force.beyond, pressure.map(|own| &own.beyond))?),
                None => None,
            },
        })
    }
}

/// A tape over the named variables and the parameters.
fn compile(expressions: &[Expr], variables: &[&str], names: &[Symbol]) -> Option<Tape> {
    let inputs: Vec<Symbol> = variables.iter().map(|name| Symbol::new(name)).chain(names.iter().cloned()).collect();
    Tape::compile(expressions, &inputs).ok()
}

/// Number of consecutive negligible nodes after which one half of the double exponential rule ends.
const ENDED: usize = 3;

/// Nodes in (0, 1) and weights of the double exponential rule, from the middle to 0 and from the middle to 1; the nodes extend
/// down to 1e-300, because f′ may be a power just above −1 at 0.
static RULE: LazyLock<[Vec<(f64, f64)>; 2]> = LazyLock::new(|| {
    const STEP: f64 = 0.13;
    let half_pi = std::f64::consts::FRAC_PI_2;
    let node = |k: i32| {
        let t = STEP * f64::from(k);
        let inner = half_pi * t.sinh();
        let small = (-2.0 * inner.abs()).exp();
        let distance = small / (1.0 + small);
        let u = if k < 0 { distance } else { 1.0 - distance };
        (u, STEP * half_pi * t.cosh() * 2.0 * small / (1.0 + small).powi(2))
    };
    [(-46..=0).rev().map(node).collect(), (1..=24).map(node).collect()]
});
