//! A function as low-degree polynomials over parts of octaves, each computed from 30-digit values when it is first needed.

use super::super::double_double::{DoubleDouble, Precise};
use super::super::work;
use super::local::{LOCAL, Local, local_nodes};
use std::sync::OnceLock;

/// An octave has 2^BITS parts of equal length, and so has each part that is divided again.
const BITS: u32 = 4;
const PARTS: usize = 1 << BITS;
/// How often a range is divided.
const DEEPEST: u32 = 3;
/// Bits of a double's mantissa, and the number of their values.
const MANTISSA: u32 = f64::MANTISSA_DIGITS - 1;
const EXPONENTS: usize = 2048;
const BELOW_ONE: u64 = (1 << MANTISSA) - 1;
const ONE: u64 = 1.0_f64.to_bits();
/// Truncation error allowed for polynomials, relative to the value: an eighth of the rounding error of a double.
const LEFT_OUT: f64 = f64::EPSILON / 16.0;
/// Uncertainty of the values.
const KNOWN: f64 = f64::EPSILON / 64.0;
/// Largest relative change of a value from the middle of its part to the ends; the correction added to the middle value is
/// rounded in its last place.
const CHANGE: f64 = 0.125;
/// Points between the nodes at which a polynomial is tested.
const TRIED: [f64; 2] = [-0.8125, 0.375];

/// Sixteenths of octaves that positive doubles have.
const KEYS: usize = EXPONENTS * PARTS;
/// Points processed together.
const LANES: usize = 8;

/// The sixteenth of an octave in which a number lies; beyond [`KEYS`] for a negative one.
#[inline(always)]
fn key(x: f64) -> usize {
    (x.to_bits() >> (MANTISSA - BITS)) as usize
}

/// The function from which the polynomials are computed.
pub trait Exact {
    /// The value with its uncertainty.
    fn exact(&self, x: f64) -> Precise;
    /// False if a kink or an end lies in the range.
    fn is_smooth(&self, from: f64, to: f64) -> bool;
}

/// The parts of every requested octave: 2 kB for a dense octave, half a megabyte if all of it is divided twice.
pub struct Dense {
    octaves: Vec<OnceLock<Box<Divided>>>,
}

type Divided = [OnceLock<Part>; PARTS];

enum Part {
    Short(Box<Short>),
    Divided(Box<Divided>),
    /// No polynomial is accurate enough here.
    Other,
}

/// The value in the middle, and a polynomial for the correction added to it.
#[derive(Clone, Copy)]
struct Short {
    middle: f64,
    change: Local,
}

/// The parts where a slice is dense, and their polynomials.
pub struct Plan {
    /// For each sixteenth of an octave: [`SPARSE`], the index of a polynomial, or [`DIVIDED`] plus an index of a divided part.
    codes: Vec<u32>,
    /// The same codes for the parts of each divided part.
    divided: Vec<[u32; PARTS]>,
    polynomials: Vec<Short>,
}

const SPARSE: u32 = u32::MAX;
const DIVIDED: u32 = 1 << 31;

impl Default for Dense {
    /// Creates a form without expanded parts.
    fn default() -> Self {
        Self { octaves: std::iter::repeat_with(OnceLock::new).take(EXPONENTS).collect() }
    }
}

impl Dense {
    /// Computes the missing parts for a slice wherever a part contains at least `least` of its points; `None` if no part does.
    pub fn plan(&self, source: &impl Exact, points: &[f64], least: u32) -> Option<Plan> {
        let mut codes = vec![0u32; KEYS];
        for x in points {
            if let Some(count) = codes.get_mut(key(*x)) {
                *count = count.saturating_add(1);
            }
        }
        let mut plan = Plan { codes: Vec::new(), divided: Vec::new(), polynomials: Vec::new() };
        let mut fresh = Vec::new();
        for (own, code) in codes.iter_mut().enumerate() {
            // Exclude tiny and infinite values.
            let is_number = (1..EXPONENTS - 1).contains(&(own / PARTS));
            let part = (*code >= least && is_number).then(|| self.first(source, own)).flatten();
            *code = plan.code(part, &mut fresh);
        }
        plan.codes = codes;
        for depth in 2..=DEEPEST {
            if fresh.is_empty() {
                break;
            }
            self.divide(source, &mut plan, &mut fresh, depth, points, least);
        }
        (!plan.polynomials.is_empty()).then_some(plan)
    }

    /// Counts the points in the parts of the most recently divided parts, `fresh`, and computes the parts with enough points.
    fn divide<'d>(&'d self, source: &impl Exact, plan: &mut Plan, fresh: &mut Vec<&'d Divided>, depth: u32, points: &[f64], least: u32) {
        let first = plan.divided.len() - fresh.len();
        let mut prefixes = vec![0; fresh.len()];
        for x in points {
            let Some(place) = plan.divided_at(*x, depth).and_then(|place| place.checked_sub(first)) else { continue };
            let prefix = x.to_bits() >> (MANTISSA - depth * BITS);
            if let (Some(counts), Some(own)) = (plan.divided.get_mut(first + place), prefixes.get_mut(place)) {
                *own = prefix - prefix % PARTS as u64;
                if let Some(count) = counts.get_mut(prefix as usize % PARTS) {
                    *count = count.saturating_add(1);
                }
            }
        }
        let before = std::mem::take(fresh);
        for ((place, parts), prefix) in before.iter().enumerate().zip(prefixes) {
            let Some(counts) = plan.divided.get(first + place) else { continue };
            let mut codes = *counts;
            for ((code, part), index) in codes.iter_mut().zip(parts.iter()).zip(0..) {
                let part = (*code >= least).then(|| part.get_or_init(|| work::finished(|| Part::new(source, prefix + index, depth))));
                *code = plan.code(part, fresh);
            }
            if let Some(own) = plan.divided.get_mut(first + place) {
                *own = codes;
            }
        }
    }

    /// A sixteenth of an octave.
    fn first(&self, source: &impl Exact, own: usize) -> Option<&Part> {
        let parts = self.octaves.get(own / PARTS)?.get_or_init(|| Box::new(divided()));
        Some(parts.get(own % PARTS)?.get_or_init(|| work::finished(|| Part::new(source, own as u64, 1))))
    }
}

impl Plan {
    /// The code of a part.
    fn code<'d>(&mut self, part: Option<&'d Part>, fresh: &mut Vec<&'d Divided>) -> u32 {
        match part {
            Some(Part::Short(short)) => {
                self.polynomials.push(**short);
                self.polynomials.len() as u32 - 1
            }
            Some(Part::Divided(parts)) => {
                fresh.push(parts);
                self.divided.push([0; PARTS]);
                DIVIDED + self.divided.len() as u32 - 1
            }
            _ => SPARSE,
        }
    }

    /// The index of the part at division level `depth` that contains `x`.
    fn divided_at(&self, x: f64, depth: u32) -> Option<usize> {
        let mut code = *self.codes.get(key(x))?;
        for depth in 2..depth {
            let parts = self.divided.get(code.checked_sub(DIVIDED)? as usize)?;
            code = *parts.get((x.to_bits() >> (MANTISSA - depth * BITS)) as usize % PARTS)?;
        }
        (code != SPARSE).then(|| code.checked_sub(DIVIDED)).flatten().map(|place| place as usize)
    }

    /// The values at the points of dense parts; the indices of the other points are added to `others`.
    ///
    /// Values are accurate to 0.75 units in the last place, measured: one rounding, and the rounding of the correction.
    pub fn fill(&self, points: &[f64], out: &mut [f64], others: &mut Vec<usize>) {
        let (whole, rest) = points.as_chunks::<LANES>();
        let (filled, last) = out.as_chunks_mut::<LANES>();
        for (block, (x, out)) in whole.iter().zip(filled).enumerate() {
            let keys = x.map(key);
            if keys == [keys[0]; LANES]
                && let Some(short) = self.polynomial(keys[0])
            {
                for i in 0..LANES {
                    out[i] = short.at(x[i], 1);
                }
            } else {
                self.each(block * LANES, x, out, others);
            }
        }
        self.each(whole.len() * LANES, rest, last, others);
    }

    /// One point after the other.
    #[inline(always)]
    fn each(&self, from: usize, points: &[f64], out: &mut [f64], others: &mut Vec<usize>) {
        for (place, (x, out)) in points.iter().zip(out).enumerate() {
            match self.polynomial(key(*x)) {
                Some(short) => *out = short.at(*x, 1),
                None => match self.deeper(*x) {
                    Some(value) => *out = value,
                    None => others.push(from + place),
                },
            }
        }
    }

    #[inline(always)]
    fn polynomial(&self, own: usize) -> Option<&Short> {
        self.polynomials.get(*self.codes.get(own)? as usize)
    }

    /// The value in a divided sixteenth of an octave.
    #[inline(never)]
    fn deeper(&self, x: f64) -> Option<f64> {
        let (mut code, mut depth) = (*self.codes.get(key(x))?, 1);
        while (DIVIDED..SPARSE).contains(&code) {
            depth += 1;
            let parts = self.divided.get((code - DIVIDED) as usize)?;
            code = *parts.get((x.to_bits() >> (MANTISSA - depth * BITS)) as usize % PARTS)?;
        }
        self.polynomials.get(code as usize).map(|short| short.at(x, depth))
    }
}

fn divided() -> Divided {
    std::array::from_fn(|_| OnceLock::new())
}

impl Part {
    fn new(source: &impl Exact, prefix: u64, depth: u32) -> Self {
        let shift = MANTISSA - depth * BITS;
        let (from, to) = (f64::from_bits(prefix << shift), f64::from_bits((prefix + 1) << shift));
        let found = if source.is_smooth(from, to) { Short::find(source, from, to, depth) } else { Expanded::Rough };
        match found {
            Expanded::Short(short) => Self::Short(Box::new(short)),
            Expanded::Rough if depth < DEEPEST => Self::Divided(Box::new(divided())),
            _ => Self::Other,
        }
    }
}

/// The result of expanding a part.
enum Expanded {
    Short(Short),
    /// Shorter parts may help.
    Rough,
    /// Shorter parts will not help: the values are not accurate enough.
    Unknown,
}

/// The position of a number in its part, in [−1, 1), computed exactly from its bits.
#[inline(always)]
fn place(x: f64, depth: u32) -> f64 {
    2.0 * f64::from_bits(((x.to_bits() << (depth * BITS)) & BELOW_ONE) | ONE) - 3.0
}

impl Short {
    fn find(source: &impl Exact, from: f64, to: f64, depth: u32) -> Expanded {
        let at = |u: f64| from + (to - from) * (0.5 * (u + 1.0));
        let exact = |x: f64| Some(source.exact(x)).filter(|own| own.error <= KNOWN * own.value.hi.abs() && own.value.hi.is_normal());
        let Some(middle) = exact(at(0.0)).map(|own| own.value) else { return Expanded::Unknown };
        let size = middle.hi.abs();
        let change = |x: f64| exact(x).map(|own| own.value.sub(middle));
        let (mut changes, mut displaced) = ([DoubleDouble::from(0.0); LOCAL], [0.0; LOCAL]);
        for ((own, moved), u) in changes.iter_mut().zip(&mut displaced).zip(local_nodes()) {
            let x = at(*u);
            let Some(found) = change(x) else { return Expanded::Unknown };
            (*own, *moved) = (found, u - place(x, depth));
        }
        let largest = changes.iter().fold(0.0f64, |most, own| most.max(own.hi.abs()));
        if largest > CHANGE * size {
            return Expanded::Rough;
        }
        // The doubles next to the nodes are not the nodes: the values there follow from the slope.
        let noise = f64::EPSILON * largest;
        let (first, _) = Local::fit_precise(&changes, noise);
        for ((own, moved), u) in changes.iter_mut().zip(&displaced).zip(local_nodes()) {
            *own = own.add((first.slope(*u) * moved).into());
        }
        let (polynomial, tail) = Local::fit_precise(&changes, noise);
        let mut off = 0.0f64;
        for x in TRIED.map(at) {
            let Some(found) = change(x) else { return Expanded::Unknown };
            off = off.max((polynomial.at(place(x, depth)) - found.value()).abs());
        }
        if !(tail <= LEFT_OUT * size && off <= LEFT_OUT * size + noise) {
            return Expanded::Rough;
        }
        Expanded::Short(Self { middle: middle.hi, change: polynomial.raised(middle.lo) })
    }

    #[inline(always)]
    fn at(&self, x: f64, depth: u32) -> f64 {
        self.middle + self.change.at(place(x, depth))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::double_double::two_sum;

    /// x² + 1/x by parts that are exact, and nothing at 3.
    struct Sum;

    impl Exact for Sum {
        fn exact(&self, x: f64) -> Precise {
            let x = DoubleDouble::from(x);
            let value = x.mul(x).add(DoubleDouble::ONE.div(x));
            Precise { value, error: 1e-29 * value.hi }
        }

        fn is_smooth(&self, from: f64, to: f64) -> bool {
            !(from..=to).contains(&3.0)
        }
    }

    #[test]
    fn values_are_within_seven_tenths_of_a_unit() {
        let dense = Dense::default();
        let points: Vec<f64> = (0..40_000).map(|i| 1.1_f64.powf(f64::from(i) / 100.0 - 150.0)).chain([0.0, -1.0, f64::NAN, 3.0]).collect();
        let (mut out, mut others) = (vec![f64::NAN; points.len()], Vec::new());
        dense.plan(&Sum, &points, 1).unwrap().fill(&points, &mut out, &mut others);
        let (mut worst, mut left) = (0.0f64, 0);
        for (place, (x, value)) in points.iter().zip(&out).enumerate() {
            if others.contains(&place) {
                left += 1;
                // A part of 1/4096 of an octave on both sides of 3.
                assert!(*x <= 0.0 || x.is_nan() || (x - 3.0).abs() <= 2.0 / 4096.0, "{x}");
                continue;
            }
            let truth = Sum.exact(*x).value;
            let unit = f64::from_bits(value.to_bits() + 1) - value;
            worst = worst.max((two_sum(*value, -truth.hi).value() - truth.lo).abs() / unit);
        }
        assert!(worst < 0.7 && (4..20).contains(&left), "{worst} units, {left} left");
    }

    #[test]
    fn sparse_points_are_left() {
        let (mut out, mut others) = ([0.0; 4], Vec::new());
        let (dense, points) = (Dense::default(), [1.0, 1.5, 3.01, 1.51]);
        assert!(dense.plan(&Sum, &points, 3).is_none());
        dense.plan(&Sum, &points, 2).unwrap().fill(&points, &mut out, &mut others);
        assert!(others == [0, 2] && (out[1] - 2.916_666_666_666_666_5).abs() < 1e-15);
    }
}
