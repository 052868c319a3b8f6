//! `(q+1)Fq` along the negative axis, where the series itself ends at -1, and `qFq` far out there.

use crate::special::ball::{Ball, UNIT};
use crate::special::gamma::gamma_ratio;
use crate::special::hypergeometric::series::series;
use crate::{DoubleDouble, work};
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

/// `(q+1)Fq(upper; lower; z)` for `z < 0`, no polynomial.
///
/// Method: the power series in `w = z/(z-1)`, which converges for every negative `z`; for large `-z` the connection to
/// `1/z`, and where upper parameters differ by whole numbers its limit by interpolation in the parameters.
/// Source: DLMF 16.3.1 (the differential equation, rewritten in `w`), 16.8.8.
pub(crate) fn continued(upper: &[Ball], lower: &[Ball], z: Ball) -> Ball {
    let near = if z.hi() > -30.0 { pfaff_series(upper, lower, z) } else { Ball::NONE };
    if near.relative() < 1e-24 || z.hi() > -1.5 {
        return near;
    }
    if are_apart(upper) { near.better(far(upper, lower, z)) } else { near.better(between(upper, lower, z)) }
}

fn from_whole(x: Ball) -> f64 {
    ((x.hi() - x.hi().round()) + x.value.lo).abs()
}

/// `Σ f_n w^n`, with `f` from the differential equation: in `w` the operator `z d/dz` is `(1-w) w d/dw`.
pub(crate) fn pfaff_series(upper: &[Ball], lower: &[Ball], z: Ball) -> Ball {
    transformed(upper, lower, z / (z - 1.0), false)
}

/// `qFq` for `z < 0` as `e^z Σ g_n z^n`, as Kummer does for `1F1`: in `g` the operator `z d/dz` is the same plus `z`.
pub(crate) fn kummer_series(upper: &[Ball], lower: &[Ball], z: Ball) -> Ball {
    transformed(upper, lower, z, true) * z.exp()
}

/// The series in `w` that solves the transformed differential equation; exponential: `U = w V` with `θ + w` for `θ`.
fn transformed(upper: &[Ball], lower: &[Ball], w: Ball, exponential: bool) -> Ball {
    // Left, U: the factors θ + β with β = 0 and b - 1; right, V: θ + a. Then (w-1) U = w V.
    let shifts: Vec<DoubleDouble> = std::iter::once(Ball::ZERO).chain(lower.iter().map(|b| *b - 1.0)).map(|b| b.value).collect();
    let nothing = DoubleDouble::from(0.0);
    let mut left = vec![nothing; shifts.len() + 1];
    let mut right = vec![nothing; upper.len() + 1];
    let (mut power, mut sum) = (DoubleDouble::ONE, nothing);
    let (mut local, mut error) = (0.0_f64, 0.0_f64);
    let mut before = nothing;
    let operations = UNIT * 2.0 * (upper.len() + lower.len() + 2) as f64;
    let each = 2 * (upper.len() + lower.len()) as u64 + 5;
    for step in 0..MAX_TERMS {
        work::spend(each);
        if work::is_exhausted() {
            return Ball::NONE;
        }
        let n = f64::from(step);
        let back = DoubleDouble::from(if exponential { -1.0 } else { n - 1.0 });
        // U_n with f_n = 0, and the factor of f_n.
        let (mut known, mut factor) = (nothing, DoubleDouble::ONE);
        for (shift, previous) in shifts.iter().zip(&left) {
            let diagonal = shift.add(n.into());
            known = known.mul(diagonal).sub(back.mul(*previous));
            factor = factor.mul(diagonal);
        }
        let coefficient = if step == 0 { DoubleDouble::ONE } else { before.sub(known).div(factor) };
        if step > 0 {
            // Coefficients that fall like 1/n! keep their relative error, others pass on the absolute one.
            let scale = if exponential { coefficient.hi.abs() } else { 1.0 };
            local += operations * (before.hi.abs() + known.hi.abs()) / (factor.hi.abs() * scale);
        }
        descend(&mut left, coefficient, back, n, shifts.iter().copied());
        descend(&mut right, coefficient, back, n, upper.iter().map(|a| a.value));
        before = match (left.last(), right.last()) {
            (Some(_), Some(v)) if exponential => *v,
            (Some(u), Some(v)) => u.sub(*v),
            _ => nothing,
        };
        let term = coefficient.mul(power);
        sum = sum.add(term);
        let size = term.hi.abs();
        let reach = if exponential { size } else { power.hi.abs() };
        error += reach * local * (1.0 + n.sqrt()) + size * UNIT * (n + 4.0) + sum.hi.abs() * UNIT;
        if !size.is_finite() {
            return Ball::NONE;
        }
        let (least, room) = if exponential { (20.0 - 2.0 * w.hi(), 0.5) } else { (20.0, 1.0 - w.hi()) };
        if n > least && size < 0.01 * UNIT * sum.hi.abs() * room {
            return Ball { value: sum, error: error + 4.0 * size / room };
        }
        power = power.mul(w.value);
    }
    Ball::NONE
}

/// The chain `u ↦ (θ + β) u` at index n: every member of the row becomes its coefficient there.
fn descend(row: &mut [DoubleDouble], top: DoubleDouble, back: DoubleDouble, n: f64, shifts: impl Iterator<Item = DoubleDouble>) {
    let mut value = top;
    let mut members = row.iter_mut();
    let Some(mut place) = members.next() else { return };
    for (shift, next) in shifts.zip(members) {
        let moved = value.mul(shift.add(n.into())).sub(back.mul(*place));
        *place = value;
        value = moved;
        place = next;
    }
    *place = value;
}

/// `qFq` far out on the negative axis: the algebraic part of its asymptotic expansion; the other is of relative size `e^z`.
///
/// Source: DLMF 16.11.7; its series are cut at their smallest terms.
pub(crate) fn asymptotic(upper: &[Ball], lower: &[Ball], z: Ball) -> Ball {
    let value = if are_apart(upper) { far(upper, lower, z) } else { between(upper, lower, z) };
    // The exponential part is e^z (-z)^(Σa - Σb) Π Γ(b)/Π Γ(a).
    let excess: f64 = upper.iter().map(|p| p.hi()).sum::<f64>() - lower.iter().map(|p| p.hi()).sum::<f64>();
    let other = (z.hi() + excess * z.hi().abs().ln()).exp() * gamma_ratio(lower, upper).hi().abs();
    value.widened(4.0 * other)
}

/// A series that diverges, up to its smallest term.
fn cut(upper: &[Ball], lower: &[Ball], z: Ball) -> Ball {
    let largest = upper.iter().chain(lower).fold(0.0_f64, |most, p| most.max(p.hi().abs()));
    let (mut sum, mut term, mut last) = (Ball::ONE, Ball::ONE, f64::INFINITY);
    let each = 2 * (upper.len() + lower.len()) as u64 + 5;
    for k in 0..400_u32 {
        work::spend(each);
        if work::is_exhausted() {
            return Ball::NONE;
        }
        let k = f64::from(k);
        let above = upper.iter().fold(term * z, |product, p| product * (*p + k));
        term = lower.iter().fold(above / (k + 1.0), |quotient, p| quotient / (*p + k));
        let size = term.hi().abs();
        if size == 0.0 {
            return sum;
        }
        if k > largest && (size >= last || size < 0.01 * UNIT * sum.hi().abs()) {
            return sum.widened(4.0 * last.min(size));
        }
        last = size;
        sum = sum + term;
    }
    Ball::NONE
}

fn are_apart(upper: &[Ball]) -> bool {
    upper.iter().enumerate().all(|(i, p)| upper.iter().skip(i + 1).all(|q| from_whole(*p - *q) > 1e-3))
}

/// The connection to `1/z` for one set of upper parameters, none of which differ by whole numbers.
struct Connection {
    upper: Vec<Ball>,
    /// The factor before each power of `1/z`.
    scales: Vec<Ball>,
}

impl Connection {
    fn new(upper: Vec<Ball>, lower: &[Ball]) -> Self {
        let scale = |(i, own): (usize, &Ball)| {
            let others = || upper.iter().enumerate().filter(move |(k, _)| *k != i).map(|(_, p)| *p);
            let above: Vec<Ball> = lower.iter().copied().chain(others().map(|p| p - *own)).collect();
            let below: Vec<Ball> = others().chain(lower.iter().map(|q| *q - *own)).collect();
            gamma_ratio(&above, &below)
        };
        let scales = upper.iter().enumerate().map(scale).collect();
        Self { upper, scales }
    }

    /// DLMF 16.8.8 or 16.11.7.
    fn at(&self, lower: &[Ball], z: Ball) -> Ball {
        let logarithm = (-z).ln();
        let converges = self.upper.len() > lower.len();
        let inverse = if converges { z.recip() } else { -z.recip() };
        let mut sum = Ball::ZERO;
        for (i, (own, scale)) in self.upper.iter().zip(&self.scales).enumerate() {
            // A pole below; what merely underflows has an error.
            if scale.is(0.0) && scale.error == 0.0 {
                continue;
            }
            work::spend(EXPONENTIAL);
            let others = self.upper.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, p)| *p);
            let first: Vec<Ball> = std::iter::once(*own).chain(lower.iter().map(|q| *own - *q + 1.0)).collect();
            let second: Vec<Ball> = others.map(|p| *own - p + 1.0).collect();
            let part = if converges { series(&first, &second, inverse) } else { cut(&first, &second, inverse) };
            sum = sum + *scale * (-(logarithm * *own)).exp() * part;
        }
        sum
    }
}

/// The connections for a list of directions in which the upper parameters are moved apart by steps.
type Connections = Rc<[Connection]>;

/// Maximum number of parameter lists whose connections are kept.
const KEPT: usize = 512;
/// Steps of work that an exponential function of a ball is.
const EXPONENTIAL: u64 = 60;

thread_local! {
    static KNOWN: RefCell<HashMap<Vec<u64>, Connections>> = RefCell::new(HashMap::new());
}

/// The connections of upper parameters moved by `SPREAD` times each of the numbers; kept, because a formula asks for those of its parameters
/// at every place, and they are all gamma functions.
fn connections(upper: &[Ball], lower: &[Ball], moves: &[f64]) -> Connections {
    let bits = |own: &Ball| [own.value.hi, own.value.lo, own.error].map(f64::to_bits);
    let key: Vec<u64> =
        upper.iter().chain(lower).flat_map(bits).chain([upper.len() as u64]).chain(moves.iter().map(|own| own.to_bits())).collect();
    if let Some(known) = KNOWN.with_borrow(|known| known.get(&key).cloned()) {
        return known;
    }
    if work::is_exhausted() {
        return Rc::new([]);
    }
    let moved = |by: &f64| (0_usize..).zip(upper).map(|(i, p)| *p + SPREAD[i % SPREAD.len()] * *by).collect::<Vec<_>>();
    let made: Connections = work::unbroken(|| moves.iter().map(|by| Connection::new(moved(by), lower)).collect());
    KNOWN.with_borrow_mut(|known| {
        if known.len() >= KEPT {
            known.clear();
        }
        known.insert(key, Rc::clone(&made));
    });
    made
}

/// DLMF 16.8.8 or 16.11.7, upper parameters that do not differ by whole numbers.
fn far(upper: &[Ball], lower: &[Ball], z: Ball) -> Ball {
    connections(upper, lower, &[0.0]).first().map_or(Ball::NONE, |own| own.at(lower, z))
}

/// The limit of [`far`] at coinciding parameters: they are moved apart by ±h, …, ±7h, and the even part is extrapolated.
fn between(upper: &[Ball], lower: &[Ball], z: Ball) -> Ball {
    let step = 2.0_f64.powi(-5) / (1.0 + z.hi().abs().ln()).log2().ceil().exp2();
    let moves: Vec<f64> = (1_u32..).zip(EXTRAPOLATION).flat_map(|(k, _)| [f64::from(k) * step, -f64::from(k) * step]).collect();
    let (mut fine, mut coarse) = (Ball::ZERO, Ball::ZERO);
    for (pair, (seven, six)) in connections(upper, lower, &moves).chunks(2).zip(EXTRAPOLATION) {
        let pair = pair.iter().fold(Ball::ZERO, |sum, own| sum + own.at(lower, z)).scale(0.5);
        fine = fine + pair * seven / 1716.0;
        coarse = coarse + pair * six / 462.0;
    }
    let doubt = (fine - coarse).hi().abs();
    fine.widened(doubt)
}

/// Directions in which parameters move; no two differ by a small fraction.
const SPREAD: [f64; 6] = [0.0, 1.0, -0.625, 0.40625, -1.4375, 1.75];
/// Weights of the pairs ±h … ±7h, times 1716 = C(14, 7)/2, and of ±h … ±6h, times 462.
const EXTRAPOLATION: [(f64, f64); 7] =
    [(3003.0, 792.0), (-2002.0, -495.0), (1001.0, 220.0), (-364.0, -66.0), (91.0, 12.0), (-14.0, -1.0), (1.0, 0.0)];
const MAX_TERMS: u32 = 4000;
