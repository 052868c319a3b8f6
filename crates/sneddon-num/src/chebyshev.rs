//! Chebyshev polynomials: the cosines of their nodes, coefficients from values there, and sums of them.

use std::f64::consts::FRAC_PI_2;

/// cos(π m/(2·`quarter`)) with the angle reduced as an integer: to the last bit as symmetric as the cosine.
pub fn cosine(m: usize, quarter: usize) -> f64 {
    let full = 4 * quarter;
    let m = m % full;
    let m = if m > full / 2 { full - m } else { m };
    let angle = |m: usize| FRAC_PI_2 * m as f64 / quarter as f64;
    // Below an eighth of the circle cos, above it sin: both from the nearer axis.
    let positive = |m: usize| if 2 * m <= quarter { angle(m).cos() } else { angle(quarter - m).sin() };
    if m <= quarter { positive(m) } else { -positive(2 * quarter - m) }
}

/// All the cosines that N nodes need: entry m is cos(π m/(2N)), for m below 4N.
///
/// The nodes, falling, are the odd entries 1, 3, 5, … below 2N.
pub fn cosines(count: usize) -> Vec<f64> {
    (0..4 * count).map(|m| cosine(m, count)).collect()
}

/// Coefficients of T₀, T₁, … of the polynomial through values at the falling nodes, no more than values, `cosines` being those of their number.
pub fn coefficients(values: &[f64], cosines: &[f64], out: &mut [f64]) {
    let count = values.len();
    let turn = 4 * count;
    for (k, slot) in out.iter_mut().enumerate() {
        let factor = if k == 0 { 1.0 } else { 2.0 } / count as f64;
        let mut place = k;
        let mut sum = 0.0;
        for value in values {
            sum += value * cosines.get(place).copied().unwrap_or(f64::NAN);
            // The angle of the next node, twice k further; k is below the number of values.
            place += 2 * k;
            if place >= turn {
                place -= turn;
            }
        }
        *slot = factor * sum;
    }
}

/// Σ c_k T_k(x), by Clenshaw's recurrence.
pub fn sum(list: &[f64], x: f64) -> f64 {
    let Some((first, others)) = list.split_first() else { return 0.0 };
    let (mut last, mut before) = (0.0, 0.0);
    for c in others.iter().rev() {
        (last, before) = (c + 2.0 * x * last - before, last);
    }
    first + x * last - before
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_of_a_product_and_its_sum() {
        for count in [12, 20, 64] {
            let table = cosines(count);
            assert!(table.iter().enumerate().all(|(m, c)| (c - (FRAC_PI_2 * m as f64 / count as f64).cos()).abs() < 1e-15));
            // 4 T₂ T₃ = 2 T₁ + 2 T₅.
            let product = |x: f64| 4.0 * (2.0 * x * x - 1.0) * (4.0 * x * x * x - 3.0 * x);
            let values: Vec<f64> = (0..count).map(|j| product(table[2 * j + 1])).collect();
            let mut found = vec![0.0; count];
            coefficients(&values, &table, &mut found);
            for (k, c) in found.iter().enumerate() {
                let truth = if k == 1 || k == 5 { 2.0 } else { 0.0 };
                assert!((c - truth).abs() < 4e-15, "{count}: T_{k} {c}");
            }
            for x in [-1.0, -0.37, 0.0, 0.9, 1.0] {
                assert!((sum(&found, x) - product(x)).abs() < 1e-13, "{count}: {x}");
            }
        }
        assert_eq!(sum(&[], 0.3), 0.0);
    }
}
