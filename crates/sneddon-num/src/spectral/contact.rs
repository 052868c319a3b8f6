//! The pressure under f′ = r P_k(2r²/a² − 1), for all k at one place.

/// Φ_k(s) = (1/a) ∫_s^a g′(x)/√(x² − s²) dx for f′ = r P_k(2r²/a² − 1), with bounds on what its computation adds up.
///
/// g = a² y T_{2k+1}(y)/(2k+1), y = x/a, so that dg/dx² = ((k+1) U_k + k U_{k−1})/(2k+1) in 2y² − 1; the U_m are sums of Legendre
/// polynomials with positive coefficients (DLMF 18.18.16), each of which gives 2 sin((2j+1)φ)/(2j+1), sin φ = √(1 − s²/a²).
/// |Φ_k| stays near Φ_0 = 2 sin φ in the middle of the contact and grows to (2k+1)Φ_0 next to its edge.
///
/// Domain: `cosine` = s/a and `sine` = √((a−s)(a+s))/a, both in [0, 1]. Accuracy: about 8(k+2) units of 2⁻⁵³ of the second sum.
pub fn pressures(count: usize, cosine: f64, sine: f64) -> Pressures {
    // sin((2j+1)φ) by rotation through 2φ; next to the edge φ is small, and no digit is lost.
    let (mut own, mut other) = (sine, cosine);
    let (turn_sine, turn_cosine) = (2.0 * sine * cosine, (cosine - sine) * (cosine + sine));
    let mut waves = Vec::with_capacity(count);
    for _ in 0..count {
        waves.push(own);
        (own, other) = (own * turn_cosine + other * turn_sine, other * turn_cosine - own * turn_sine);
    }
    let (rising, falling) = connection(count);
    let sums: Vec<(f64, f64)> = (0..count)
        .map(|m| {
            let (mut sum, mut size) = (0.0, 0.0);
            // j = m − 2i, so that (m + j)/2 = m − i.
            let waves = waves.get(..=m).unwrap_or_default().iter().rev().step_by(2);
            let betas = falling.get(..=m).unwrap_or_default().iter().rev();
            for ((wave, alpha), beta) in waves.zip(&rising).zip(betas) {
                let own = alpha * beta * wave;
                sum += own;
                size += own.abs();
            }
            (sum, size)
        })
        .collect();
    let (mut values, mut sizes) = (Vec::with_capacity(count), Vec::with_capacity(count));
    let mut before = (0.0, 0.0);
    for (k, own) in sums.into_iter().enumerate() {
        let k = k as f64;
        let of = |now: f64, last: f64| 2.0 * ((k + 1.0) * now + k * last) / (2.0 * k + 1.0);
        values.push(of(own.0, before.0));
        sizes.push(of(own.1, before.1));
        before = own;
    }
    Pressures { values, sizes }
}

/// b_j with dg/dx² = Σ b_j P_j(2y² − 1) for f′ = r Σ c_k P_k(2r²/a² − 1), y = x/a.
pub fn rise(coefficients: &[f64]) -> Vec<f64> {
    let count = coefficients.len();
    let (rising, falling) = connection(count);
    let mut out = vec![0.0; count];
    // The factor of U_m, from k = m and k = m + 1.
    let share = |k: usize, by: usize| coefficients.get(k).map_or(0.0, |c| c * by as f64 / (2 * k + 1) as f64);
    for m in 0..count {
        let own = share(m, m + 1) + share(m + 1, m + 1);
        let slots = out.get_mut(..=m).unwrap_or_default().iter_mut().enumerate().rev().step_by(2);
        let betas = falling.get(..=m).unwrap_or_default().iter().rev();
        for (((j, slot), alpha), beta) in slots.zip(&rising).zip(betas) {
            *slot += own * (2 * j + 1) as f64 * alpha * beta;
        }
    }
    out
}

/// α_i = (1/2)_i/i! and β_l = l!/(3/2)_l: U_m = Σ_i (2(m−2i)+1) β_{m−i} α_i P_{m−2i}.
fn connection(count: usize) -> (Vec<f64>, Vec<f64>) {
    let (mut rising, mut falling) = (Vec::with_capacity(count), Vec::with_capacity(count));
    let (mut alpha, mut beta) = (1.0, 1.0);
    for i in 0..count {
        rising.push(alpha);
        falling.push(beta);
        let i = i as f64;
        alpha *= (i + 0.5) / (i + 1.0);
        beta *= (i + 1.0) / (i + 1.5);
    }
    (rising, falling)
}

/// The result of [`pressures`].
pub struct Pressures {
    /// Φ_k.
    pub values: Vec<f64>,
    /// The same sums with magnitudes.
    pub sizes: Vec<f64>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_have_their_known_pressures() {
        // f′ = r: p = 2√(a² − s²); f′ = r³: p = (8/9)(a² + 2s²)√(a² − s²), r² = (1 + P_1)/2 at a = 1.
        for s in [0.0, 1e-9, 0.3, 0.6, 0.999_999_f64] {
            let sine = ((1.0 - s) * (1.0 + s)).sqrt();
            let own = pressures(3, s, sine).values;
            assert!((own[0] / (2.0 * sine) - 1.0).abs() < 4e-16, "{s}: {own:?}");
            let cubic = 0.5 * (own[0] + own[1]);
            let exact = 8.0 / 9.0 * (1.0 + 2.0 * s * s) * sine;
            assert!((cubic / exact - 1.0).abs() < 2e-15, "{s}: {cubic} {exact}");
        }
    }

    #[test]
    fn the_rise_has_the_same_pressure() {
        let coefficients: Vec<f64> = (0..20).map(|k| (f64::from(k) * 0.7).cos() / f64::from(k + 1)).collect();
        let rise = rise(&coefficients);
        for s in [0.0, 0.2, 0.8, 0.99_f64] {
            let square = (1.0 - s) * (1.0 + s);
            let own = pressures(20, s, square.sqrt());
            let total: f64 = own.values.iter().zip(&coefficients).map(|(p, c)| p * c).sum();
            let divided: Vec<f64> = rise.iter().enumerate().map(|(j, b)| b / (2 * j + 1) as f64).collect();
            let other = super::super::right_sided(&divided, square, 1.0);
            assert!((other - total).abs() < 1e-13, "{s}: {other} {total}");
        }
    }

    #[test]
    fn gauss_and_quadrature_agree_for_every_degree() {
        // The definition by Gauss's rule over φ: x = √(s² + w² v²), dg/dx² from U.
        let (s, count) = (0.37_f64, 40);
        let square = (1.0 - s) * (1.0 + s);
        let own = pressures(count, s, square.sqrt());
        let rule = super::super::rule(64, -0.5);
        for k in [0, 1, 7, 20, 39] {
            let total: f64 = rule
                .nodes()
                .iter()
                .map(|node| {
                    let t = 2.0 * (s * s + square * node.unit) - 1.0;
                    let (mut last, mut now) = (0.0, 1.0);
                    for _ in 0..k {
                        (last, now) = (now, 2.0 * t * now - last);
                    }
                    let k = f64::from(k);
                    node.share * ((k + 1.0) * now + k * last) / (2.0 * k + 1.0)
                })
                .sum::<f64>()
                * square.sqrt();
            let found = own.values[k as usize];
            assert!((found - total).abs() < 1e-13, "k = {k}: {found} {total}");
        }
    }
}
