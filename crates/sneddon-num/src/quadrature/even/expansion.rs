//! Chebyshev expansions of even functions, and the smallest sufficient number of nodes on the full range and on shorter ranges.

use super::super::super::bounded::UNIT;
use super::super::super::chebyshev;
use super::gauss::Known;
use super::nodes::Lists;
use super::{EvenIntegrand, Nodes};
use std::sync::LazyLock;

/// Numbers of values to try, in this order.
const COUNTS: [usize; 2] = [64, 128];
/// Coefficients beyond this fraction of their number must be noise.
const SEEN: f64 = 0.75;
/// Noise in the coefficients relative to the error bound of the values; about sixty errors of both signs are averaged.
const AVERAGED: f64 = 0.25;
/// Test points between the last node and the end z = 1, as fractions of √(1 − z²) at the last node; they detect features that are
/// confined to the end.
const NEXT_TO_THE_END: [f64; 7] = [0.5, 0.2, 0.07, 0.02, 1e-3, 1e-5, 1e-7];
/// Number of test points off the grid: multiples of the golden ratio modulo 1.
const AMONG_NODES: usize = 9;
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// f(z) = Σ c_m T_2m(z).
pub(crate) struct Expansion {
    coefficients: Vec<f64>,
    /// The sum of the magnitudes of the noise coefficients, which estimates the truncation error.
    beyond: f64,
}

/// Nodes of a series, and its test points.
struct Grid {
    nodes: Lists,
    tests: Lists,
    cosines: Vec<f64>,
}

/// Chebyshev cosines for resampling a known series, by the number of values.
static PARTS: [(usize, LazyLock<Vec<f64>>); 4] = [
    (16, LazyLock::new(|| chebyshev::cosines(16))),
    (32, LazyLock::new(|| chebyshev::cosines(32))),
    (64, LazyLock::new(|| chebyshev::cosines(64))),
    (128, LazyLock::new(|| chebyshev::cosines(128))),
];

static GRIDS: [LazyLock<Grid>; COUNTS.len()] = [LazyLock::new(|| Grid::new(COUNTS[0])), LazyLock::new(|| Grid::new(COUNTS[1]))];

impl Grid {
    fn new(count: usize) -> Self {
        let (mut nodes, mut tests) = (Lists::default(), Lists::default());
        let place = |lists: &mut Lists, cosine: f64| lists.push(((1.0 - cosine) * (1.0 + cosine)).sqrt(), cosine);
        for i in 0..count {
            // Half of the angle of a node of T_count: T_2m(z) = T_m(2z² − 1).
            let at = |m| chebyshev::cosine(m, 2 * count);
            nodes.push(at(2 * i + 1), at(2 * count - (2 * i + 1)));
        }
        let last = chebyshev::cosine(2 * count - 1, 2 * count);
        NEXT_TO_THE_END.iter().for_each(|share| place(&mut tests, share * last));
        (1..=AMONG_NODES).for_each(|i| place(&mut tests, (GOLDEN * i as f64).fract()));
        Self { nodes, tests, cosines: chebyshev::cosines(count) }
    }
}

impl Expansion {
    /// The series of an integrand, and the evaluations spent, at most `most`. `None` if the coefficients do not decrease to
    /// rounding noise, the series disagrees with the function at the test points, or the function is not finite.
    pub(crate) fn of<I: EvenIntegrand>(integrand: &mut I, most: u64) -> (Option<Self>, u64) {
        let mut evaluations = 0;
        for grid in &GRIDS {
            let grid: &Grid = grid;
            let tests = grid.tests.all();
            if evaluations + (grid.nodes.all().z.len() + tests.z.len()) as u64 > most {
                break;
            }
            let values = asked(integrand, grid.nodes.all());
            evaluations += values.len() as u64;
            let largest = values.iter().fold(0.0f64, |most, v| most.max(v.abs()));
            let noise = (integrand.relative() + 2.0 * UNIT) * largest;
            let mut coefficients = vec![0.0; values.len()];
            chebyshev::coefficients(&values, &grid.cosines, &mut coefficients);
            let last = coefficients.iter().skip((SEEN * values.len() as f64) as usize);
            // The comparisons also reject NaN.
            if !(largest > 0.0 && largest.is_finite() && last.clone().all(|c| c.abs() <= AVERAGED * noise)) {
                continue;
            }
            let floor = last.fold(0.0f64, |most, c| most.max(c.abs()));
            let own = Self::cut(coefficients, 2.0 * floor);
            let seen = asked(integrand, tests);
            evaluations += seen.len() as u64;
            // Rounding noise of the values and of the sum.
            let doubt = 2.0 * noise + own.beyond + 16.0 * UNIT * own.coefficients.iter().map(|c| c.abs()).sum::<f64>();
            let agree = seen.iter().zip(tests.cosine).all(|(v, cosine)| (v - own.at(cosine * cosine)).abs() <= doubt);
            return (agree.then_some(own), evaluations);
        }
        (None, evaluations)
    }

    /// The series up to the last coefficient that is above the noise.
    fn cut(mut coefficients: Vec<f64>, floor: f64) -> Self {
        let kept = coefficients.iter().rposition(|c| c.abs() > floor).map_or(1, |last| last + 1);
        let beyond = coefficients.iter().skip(kept).map(|c| c.abs()).sum();
        coefficients.truncate(kept);
        Self { coefficients, beyond }
    }

    /// The value at 1 − z² = `share`.
    fn at(&self, share: f64) -> f64 {
        chebyshev::sum(&self.coefficients, 1.0 - 2.0 * share)
    }

    /// `share` times the function restricted to √(1 − z²) ≤ `share`, and times the new 1 − z² if `weighted`: for x f′(r)/r, the
    /// same function with x·share for x.
    ///
    /// Restriction preserves polynomials below degree 2N, which a rule of N nodes integrates exactly, so its truncation error is
    /// a sum over the same coefficients.
    pub(crate) fn part(&self, share: f64, weighted: bool) -> Self {
        let needed = self.coefficients.len() + usize::from(weighted);
        let (count, cosines) = PARTS.iter().find(|(count, _)| *count >= needed).unwrap_or(&PARTS[PARTS.len() - 1]);
        let own = cosines.iter().skip(1).step_by(2).take(*count).map(|cosine| 0.5 * (1.0 - cosine));
        let values: Vec<f64> = own.map(|own| self.at(share * share * own) * if weighted { share * own } else { share }).collect();
        let mut coefficients = vec![0.0; needed.min(*count)];
        chebyshev::coefficients(&values, cosines, &mut coefficients);
        // The rounding errors of the sums are averaged, like those of the values.
        let rounding = 16.0 * AVERAGED * UNIT * self.coefficients.iter().map(|c| c.abs()).sum::<f64>();
        Self { coefficients, beyond: self.beyond + rounding }
    }

    /// The mean over [−1, 1].
    pub(crate) fn mean(&self) -> f64 {
        let term = |(m, c): (usize, &f64)| c / (1.0 - 4.0 * (m * m) as f64);
        self.coefficients.iter().enumerate().map(term).sum()
    }

    /// The smallest rule with a truncation error of at most `wanted`, on this range and on ranges shorter by up to a sixteenth;
    /// `None` if there is none.
    ///
    /// The rule's mean of T_2m is at most 1 and the exact mean at most 1/(4m² − 1) in magnitude, so twice the sum of the
    /// coefficients is a bound, with a margin for ranges shorter by a sixteenth, where the weight may grow by as much.
    pub(crate) fn fewest(&self, wanted: f64) -> Option<Known> {
        Known::smallest(|half| {
            let from = self.coefficients.get(2 * half..).unwrap_or_default();
            let left_out = 2.0 * (from.iter().map(|c| c.abs()).sum::<f64>() + self.beyond);
            (left_out <= wanted).then_some(left_out)
        })
    }
}

/// The values at nodes.
fn asked<I: EvenIntegrand>(integrand: &mut I, nodes: Nodes<'_>) -> Vec<f64> {
    let count = nodes.z.len();
    let (mut values, mut errors) = (vec![0.0; count], vec![0.0; count]);
    let mut from = 0;
    for (values, errors) in values.chunks_mut(I::BLOCK).zip(errors.chunks_mut(I::BLOCK)) {
        let Some(part) = nodes.part(from, from + values.len()) else { break };
        integrand.fill(part, values, errors);
        from += values.len();
    }
    values
}
