//! The gate: every solved term meets quadrature of that term when it is derived, before anything uses it.

use super::engine::{SolvedChain, SolvedTerm};
use super::sample::Sampler;
use super::{Answer, Chain, NumericProfile, Pair, Profile, Segment};
use crate::eval::{BoundedAlgebra, FloatAlgebra, Tape, constant_value};
use crate::expr::{Bindings, Condition, Expr, Symbol};
use crate::num::{Bound, Bounded, work};
use std::sync::LazyLock;

/// What the gate found for the terms of a solution.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Verification {
    /// Closed forms that were given up, because a proven quadrature contradicts them.
    pub demoted: Vec<Demotion>,
    /// Terms whose closed forms agree with quadrature.
    pub compared: usize,
    /// Terms for which no comparison could be had.
    pub not_compared: usize,
}

/// A closed form that was given up.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Demotion {
    /// The rule that gave it, or `recognition` where the terms did not add up to f′.
    pub rule: &'static str,
    /// `g`, `F`, `p`, or `f'` for the terms themselves.
    pub quantity: &'static str,
}

impl Demotion {
    /// What a reader must know.
    pub fn text(&self) -> String {
        let Self { rule, quantity } = self;
        match *quantity {
            "f'" => "the terms of f' do not add up to it: they were given up, and the profile is integrated as it was typed".to_owned(),
            _ => format!("the closed {quantity} of the rule {rule} disagrees with quadrature: it was given up and is an integral here"),
        }
    }
}

/// Agreement within this share of ∫|integrand| is agreement: two independent computations do not share nine digits by chance.
const ENOUGH: f64 = 1e-9;
/// Bounds beyond this share prove nothing.
const TELLING: f64 = 1e-6;
/// What the proven quadrature is asked for.
const TOLERANCE: f64 = 1e-10;

/// Numbers for the parameters at which terms are looked at.
pub struct Place {
    bindings: Bindings,
    names: Vec<Symbol>,
    values: Vec<f64>,
    limit: f64,
}

/// Where a place lies with respect to a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Within,
    Beyond,
    /// Within, but so far out that a term need not be known there: only a contradiction counts.
    Far,
}

/// Radii with where they lie.
type Places = Vec<(f64, Part)>;

/// Agrees, contradicts, or nothing is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Verdict {
    Agrees,
    Wrong,
    Unknown,
}

impl Place {
    /// Seeded admissible values; `None` where none were found.
    pub fn draw(profile: &Profile, conditions: &[Condition]) -> Option<Self> {
        let names = profile.parameters();
        let bindings = Sampler::new(0x6a7e).admissible(&names, conditions)?;
        let number = |expr: &Expr| constant_value(expr, &bindings).map(|own| own.value).ok();
        let values = names.iter().map(|name| number(&Expr::from(name.clone()))).collect::<Option<Vec<_>>>()?;
        let limits = profile.limits().map(number).collect::<Option<Vec<_>>>()?;
        let limit = limits.into_iter().fold(f64::INFINITY, f64::min);
        Some(Self { bindings, names, values, limit })
    }

    fn number(&self, expr: &Expr) -> Option<f64> {
        if expr.is_zero() { Some(0.0) } else { constant_value(expr, &self.bindings).ok().map(|own| own.value) }
    }

    /// A tape over the named variables and the parameters.
    fn compile(&self, expressions: &[Expr], variables: &[&str]) -> Option<Tape> {
        let inputs: Vec<Symbol> = variables.iter().map(|name| Symbol::new(name)).chain(self.names.iter().cloned()).collect();
        Tape::compile(expressions, &inputs).ok()
    }

    fn bounded(&self, tape: &Tape, variables: &[f64]) -> Option<Vec<Bounded>> {
        let inputs: Vec<Bounded> = variables.iter().chain(&self.values).copied().map(Bounded::exact).collect();
        tape.run_all(&mut BoundedAlgebra, &inputs, &mut Vec::new())
    }

    /// Places within a segment and, where it ends, beyond it; where nothing ends it, one far out, where other methods of functions answer.
    fn places(&self, segment: &Segment) -> Option<(f64, Option<f64>, Places)> {
        let lower = self.number(&segment.lower)?;
        let upper = match &segment.upper {
            Some(upper) => Some(self.number(upper)?),
            None => None,
        };
        let top = upper.unwrap_or(f64::INFINITY).min(self.limit);
        let (within, far) = match (top.is_finite(), lower > 0.0) {
            (true, _) => (lower + 0.613 * (top - lower), None),
            (false, true) => (1.617 * lower, Some(23.7 * lower)),
            (false, false) => (1.093, Some(17.3)),
        };
        let beyond = upper.into_iter().flat_map(|upper| [1.21 * upper, 2.63 * upper]).filter(|x| *x < self.limit);
        let places = std::iter::once((within, Part::Within));
        Some((lower, upper, places.chain(beyond.map(|x| (x, Part::Beyond))).chain(far.map(|x| (x, Part::Far))).collect()))
    }

    /// True unless the terms are proven not to add up to f′ as it was typed.
    pub fn recognition_holds(&self, chain: &Chain, slopes: &[Expr], solved: &[SolvedChain]) -> bool {
        let of = |interval: usize| {
            let own = |chain: &SolvedChain| {
                let place = if chain.breakpoints.is_empty() { 0 } else { interval };
                chain.intervals.get(place).map(|own| own.terms.iter().map(|solved| solved.term.slope()).collect::<Vec<_>>())
            };
            solved.iter().filter_map(own).flatten().collect::<Vec<_>>()
        };
        chain.intervals().zip(slopes).enumerate().all(|(index, ((lower, upper, _), slope))| {
            let terms = of(index);
            if Expr::sum(terms.iter().cloned()) == *slope {
                return true;
            }
            let Some((_, _, places)) = self.places(&Segment { lower, upper: upper.cloned() }) else { return true };
            let mut outputs = vec![slope.clone()];
            outputs.extend(terms);
            let Some(tape) = self.compile(&outputs, &["r"]) else { return true };
            // Beyond the upper end this piece is not f.
            places.first().is_none_or(|(r, _)| {
                let Some(values) = self.bounded(&tape, &[*r]) else { return true };
                let Some((typed, parts)) = values.split_first() else { return true };
                let sum = parts.iter().fold(Bounded::exact(0.0), |sum, part| sum + *part);
                // Written so that a NaN proves nothing.
                let apart = (typed.value - sum.value).abs() > typed.error + sum.error;
                !apart
            })
        })
    }

    /// Looks at a solved term and gives up what is wrong.
    pub fn judge(&self, solved: &mut SolvedTerm, found: &mut Verification) {
        let Some((rule, answer)) = &solved.answer else { return };
        let compare = || self.compare(&solved.term.slope(), &solved.term.segment, answer);
        let [slope, force] = work::share(LONGEST, compare).flatten().unwrap_or([Verdict::Unknown; 2]);
        for (verdict, quantity) in [(slope, "g"), (force, "F")] {
            if verdict == Verdict::Wrong {
                found.demoted.push(Demotion { rule: rule.id, quantity });
                solved.answer = None;
                return;
            }
        }
        let pressure = work::share(LONGEST, || self.compare_pressure(&solved.term.segment, answer)).flatten();
        if slope == Verdict::Agrees && pressure == Some(Verdict::Wrong) {
            found.demoted.push(Demotion { rule: rule.id, quantity: "p" });
            if let Some((_, answer)) = &mut solved.answer {
                answer.pressure = None;
            }
        }
        if slope == Verdict::Agrees && force == Verdict::Agrees { found.compared += 1 } else { found.not_compared += 1 }
    }

    /// g and F/(2E*) of a term at its places.
    fn compare(&self, slope: &Expr, segment: &Segment, answer: &Answer) -> Option<[Verdict; 2]> {
        let (lower, upper, places) = self.places(segment)?;
        let tape = self.compile(std::slice::from_ref(slope), &["r"])?;
        let forms = |slope: &Pair, force: &Pair| {
            self.compile(&[slope.evaluated.clone(), force.evaluated.clone(), slope.shown.clone(), force.shown.clone()], &["x", "a"])
        };
        let within = forms(&answer.slope.within, &answer.force.within)?;
        let beyond = if upper.is_some() { Some(forms(&answer.slope.beyond, &answer.force.beyond)?) } else { None };
        let mut verdicts = [Verdict::Agrees; 2];
        for (x, part) in places {
            let own = if part == Part::Beyond { beyond.as_ref()? } else { &within };
            let Some(values) = self.bounded(own, &[x, x]) else { if part == Part::Far { continue } else { return None } };
            let integrals = self.integrals(&tape, lower, upper, x);
            for (quantity, verdict) in verdicts.iter_mut().enumerate() {
                let (Some(evaluated), Some(shown), Some((value, size))) =
                    (values.get(quantity), values.get(quantity + 2), integrals.get(quantity).copied())
                else {
                    continue;
                };
                let is_telling = |own: &Bounded| own.error <= TELLING * size;
                let agrees = |own: &Bounded| is_telling(own) && (own.value - value).abs() <= ENOUGH * size + own.error;
                if agrees(evaluated) && (agrees(shown) || !is_telling(shown)) {
                    continue;
                }
                let proven = self.proven(slope, segment, quantity, x);
                let is_wrong = |own: &Bounded| proven.is_some_and(|truth| (own.value - truth.value).abs() > own.error + truth.error);
                if is_wrong(evaluated) || is_wrong(shown) {
                    *verdict = Verdict::Wrong;
                } else if *verdict == Verdict::Agrees
                    && part != Part::Far
                    && !proven.is_some_and(|truth| truth.error <= TELLING * size && is_telling(evaluated))
                {
                    *verdict = Verdict::Unknown;
                }
            }
        }
        Some(verdicts)
    }

    /// x ∫ f′ dt and ∫ r² f′ dt with their sizes, r = x sin t, by one double exponential rule in plain doubles.
    fn integrals(&self, tape: &Tape, lower: f64, upper: Option<f64>, x: f64) -> [(f64, f64); 2] {
        let angle = |end: f64| if end < x { end.atan2(((x - end) * (x + end)).sqrt()) } else { std::f64::consts::FRAC_PI_2 };
        let (from, to) = (angle(lower), angle(upper.unwrap_or(f64::INFINITY)));
        let mut found = [(0.0, 0.0); 2];
        let (mut slots, mut inputs) = (Vec::new(), Vec::with_capacity(1 + self.values.len()));
        inputs.push(0.0);
        inputs.extend(&self.values);
        for (u, weight) in RULE.iter() {
            let r = x * (from + (to - from) * u).sin();
            if let Some(first) = inputs.first_mut() {
                *first = r;
            }
            let slope = tape.run(&mut FloatAlgebra, &inputs, &mut slots).unwrap_or(f64::NAN) * weight * (to - from);
            for ((sum, size), factor) in found.iter_mut().zip([x, r * r]) {
                *sum += slope * factor;
                *size += (slope * factor).abs();
            }
        }
        found
    }

    /// g or F/(2E*) of a term by quadrature whose bound is proven; beyond an upper end as a difference.
    fn proven(&self, slope: &Expr, segment: &Segment, quantity: usize, x: f64) -> Option<Bounded> {
        let from = |lower: &Expr| {
            let endless = Segment { lower: lower.clone(), upper: None };
            let profile = NumericProfile::new(&[(endless, slope.clone())], &self.bindings).ok()?;
            let found = if quantity == 0 { profile.slope(x, TOLERANCE) } else { profile.force(x, TOLERANCE) };
            found.ok().filter(|own| own.bound == Bound::Proven && own.error.is_finite()).map(|own| own.bounded())
        };
        let whole = from(&segment.lower)?;
        match &segment.upper {
            Some(upper) if self.number(upper)? < x => Some(whole - from(upper)?),
            _ => Some(whole),
        }
    }

    /// ∫ g′/√(x²−r²) dx from the closed g, which has been compared before: P(r; a₂) − P(r; a₁) is that integral from a₁ to a₂,
    /// by parts over g, and P is 0 where the contact or the segment begins.
    fn compare_pressure(&self, segment: &Segment, answer: &Answer) -> Option<Verdict> {
        let pressure = answer.pressure.as_ref()?;
        let (lower, _, places) = self.places(segment)?;
        let (end, _) = *places.first()?;
        let begin = lower + 0.7 * (end - lower);
        let r = 0.57 * begin;
        let forms = self.compile(&[pressure.within.evaluated.clone(), pressure.within.shown.clone()], &["r", "a"])?;
        let slope = self.compile(std::slice::from_ref(&answer.slope.within.evaluated), &["x"])?;
        let g = |x: f64| self.bounded(&slope, &[x]).and_then(|own| own.first().copied()).filter(|own| own.error.is_finite());
        let root = |x: f64| ((x - r) * (x + r)).sqrt();
        let mut truth = g(end)?.value / root(end) - g(begin)?.value / root(begin);
        for (z, weight) in GAUSS.iter().flat_map(|(z, weight)| [(*z, *weight), (-*z, *weight)]) {
            let x = 0.5 * (end + begin) + 0.5 * (end - begin) * z;
            truth += 0.5 * (end - begin) * weight * g(x)?.value * x / root(x).powi(3);
        }
        let start = r.max(lower) * (1.0 + 1e-12);
        let [far, near, none] = [end, begin, start].map(|a| self.bounded(&forms, &[r, a]));
        let (far, near, none) = (far?, near?, none?);
        let mut verdict = Verdict::Agrees;
        for ((far, near), none) in far.iter().zip(&near).zip(&none) {
            let size = far.value.abs().max(near.value.abs()).max(truth.abs());
            let error = far.error + near.error;
            if !(error + none.error).is_finite() || error > TELLING * size {
                verdict = Verdict::Unknown;
                continue;
            }
            // The part from the beginning on is of the order of the root of the distance.
            let wrong = (far.value - near.value - truth).abs() > TELLING * size + error || none.value.abs() > 1e-3 * size + none.error;
            if wrong {
                return Some(Verdict::Wrong);
            }
        }
        Some(verdict)
    }
}

/// Steps of work after which a term counts as not compared: special functions far out may take seconds.
const LONGEST: u64 = 5_000_000;

/// Nodes in (0, 1) and weights of the double exponential rule.
static RULE: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| {
    const STEPS: i32 = 24;
    const STEP: f64 = 0.13;
    let half_pi = std::f64::consts::FRAC_PI_2;
    (-STEPS..=STEPS)
        .map(|k| {
            let t = STEP * f64::from(k);
            let (inner, slope) = (half_pi * t.sinh(), half_pi * t.cosh());
            (1.0 / (1.0 + (-2.0 * inner).exp()), 0.5 * STEP * slope / inner.cosh().powi(2))
        })
        .collect()
});

/// The positive nodes and the weights of the Gauss rule with eight nodes.
static GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_2, 0.101_228_536_290_376_26),
];
