//! The natural cubic smoothing spline, with its penalty given, from the noise, or by cross-validation.

use crate::integrate::table_error::TableError;

/// How the penalty λ of a smoothing spline is chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Penalty {
    /// λ itself, in units of r³; 0 interpolates.
    Weight(f64),
    /// The standard deviation σ of the noise, in units of z: λ is the one with Σ (z − f)² = n σ² (Reinsch 1967).
    Noise(f64),
    /// λ that minimises the generalised cross-validation score n Σ (z − f)²/(n − tr A)², A the map from z to f
    /// (Craven and Wahba 1979).
    CrossValidation,
}

/// One spline: its values and second derivatives at the points, and what judges it.
pub struct Spline {
    /// The values at the points.
    pub values: Vec<f64>,
    /// The second derivatives there.
    pub seconds: Vec<f64>,
    /// Σ (z − f)².
    pub residual: f64,
    /// n − tr A.
    pub freedom: f64,
}

/// The values and slopes of the spline at rising abscissas, which may be negative here; they make its cubics.
pub(super) fn smoothing_spline(r: &[f64], z: &[f64], penalty: Penalty) -> Result<(Vec<f64>, Vec<f64>), TableError> {
    let count = r.len() as f64;
    let (Some(first), Some(last)) = (r.first(), r.last()) else { return Err(TableError::TooFew { given: 0, needed: 3 }) };
    let spacing = (last - first) / (count - 1.0);
    // From far below to far above where smoothing sets in, which is at the cube of the spacing.
    let (low, high) = (1e-10f64.ln(), (count.powi(4) * 1e4).ln());
    let at = |log: f64| solve(r, z, log.exp() * spacing.powi(3));
    let spline = match penalty {
        Penalty::Weight(weight) if weight >= 0.0 && weight.is_finite() => solve(r, z, weight)?,
        Penalty::Weight(got) => return Err(TableError::Penalty { what: "penalty of the spline", got, accepted: "a finite λ >= 0" }),
        Penalty::Noise(sigma) if sigma >= 0.0 && sigma.is_finite() => with_noise(at, (low, high), count * sigma * sigma)?,
        Penalty::Noise(got) => return Err(TableError::Penalty { what: "noise of the heights", got, accepted: "a finite σ >= 0" }),
        Penalty::CrossValidation => cross_validated(at, (low, high), count)?,
    };
    let slopes = slopes(r, &spline);
    Ok((spline.values, slopes))
}

/// The smoothest spline within the noise: the residual rises with λ.
fn with_noise(at: impl Fn(f64) -> Result<Spline, TableError>, (mut low, mut high): (f64, f64), wanted: f64) -> Result<Spline, TableError> {
    let smoothest = at(high)?;
    if smoothest.residual <= wanted {
        return Ok(smoothest);
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if at(middle)?.residual <= wanted {
            low = middle
        } else {
            high = middle
        }
        if high - low < 1e-9 {
            break;
        }
    }
    at(low)
}

/// The lowest score of a scan, refined by golden sections.
fn cross_validated(at: impl Fn(f64) -> Result<Spline, TableError>, (low, high): (f64, f64), count: f64) -> Result<Spline, TableError> {
    const SCAN_STEPS: u32 = 30;
    let score = |log: f64| at(log).map(|own| count * own.residual / (own.freedom * own.freedom));
    let place = |step: f64| low + (high - low) * step / f64::from(SCAN_STEPS);
    let mut best = (f64::INFINITY, 0);
    for step in 0..=SCAN_STEPS {
        let own = score(place(f64::from(step)))?;
        if own < best.0 {
            best = (own, step);
        }
    }
    let (mut from, mut to) = (place(f64::from(best.1) - 1.0).max(low), place(f64::from(best.1) + 1.0).min(high));
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    for _ in 0..24 {
        let (one, two) = (to - golden * (to - from), from + golden * (to - from));
        if score(one)? < score(two)? { to = two } else { from = one }
    }
    at(0.5 * (from + to))
}

/// (R + λ QᵀQ) γ = Qᵀz and f = z − λ Q γ (Reinsch 1967; Green and Silverman 1994, section 2.3), by LDLᵀ with two bands below the diagonal.
pub fn solve(r: &[f64], z: &[f64], penalty: f64) -> Result<Spline, TableError> {
    let n = r.len();
    let inner = n - 2;
    let h: Vec<f64> = r.windows(2).map(|r| r[1] - r[0]).collect();
    // Column j of Q has these entries at rows j, j+1, j+2.
    let q = |j: usize| [1.0 / h[j], -1.0 / h[j] - 1.0 / h[j + 1], 1.0 / h[j + 1]];
    let band = |j: usize, k: usize| -> f64 {
        if j + k >= inner {
            return 0.0;
        }
        let (own, other) = (q(j), q(j + k));
        let overlap: f64 = (k..3).map(|i| own[i] * other[i - k]).sum();
        let gram = match k {
            0 => (h[j] + h[j + 1]) / 3.0,
            1 => h[j + 1] / 6.0,
            _ => 0.0,
        };
        gram + penalty * overlap
    };
    let (mut d, mut l1, mut l2) = (vec![0.0; inner], vec![0.0; inner], vec![0.0; inner]);
    let mut x = vec![0.0; inner];
    for j in 0..inner {
        let (e1, d1) = if j >= 1 { (l1[j - 1], d[j - 1]) } else { (0.0, 0.0) };
        let (e2, d2) = if j >= 2 { (l2[j - 2], d[j - 2]) } else { (0.0, 0.0) };
        d[j] = band(j, 0) - e1 * e1 * d1 - e2 * e2 * d2;
        let cross = if j >= 1 { l2[j - 1] * e1 * d1 } else { 0.0 };
        l1[j] = (band(j, 1) - cross) / d[j];
        l2[j] = band(j, 2) / d[j];
        let rise = |i: usize| (z[i + 1] - z[i]) / h[i];
        let back1 = if j >= 1 { e1 * x[j - 1] } else { 0.0 };
        let back2 = if j >= 2 { e2 * x[j - 2] } else { 0.0 };
        x[j] = rise(j + 1) - rise(j) - back1 - back2;
    }
    for j in (0..inner).rev() {
        let next = if j + 1 < inner { l1[j] * x[j + 1] } else { 0.0 };
        let after = if j + 2 < inner { l2[j] * x[j + 2] } else { 0.0 };
        x[j] = x[j] / d[j] - next - after;
    }
    if x.iter().chain(&d).any(|v| !v.is_finite()) || d.iter().any(|d| *d <= 0.0) {
        return Err(TableError::OutOfRange);
    }
    let mut seconds = vec![0.0; n];
    seconds[1..=inner].copy_from_slice(&x);
    let mut shifts = vec![0.0; n];
    for (j, gamma) in x.iter().enumerate() {
        for (i, q) in q(j).into_iter().enumerate() {
            shifts[j + i] += penalty * q * gamma;
        }
    }
    let residual = shifts.iter().map(|s| s * s).sum();
    let values = z.iter().zip(&shifts).map(|(z, s)| z - s).collect();
    // tr(I − A) = λ tr(QᵀQ B), B the inverse, whose bands follow from the factors (Hutchinson and de Hoog 1985).
    let (mut b0, mut b1, mut b2) = (vec![0.0; inner + 2], vec![0.0; inner + 2], vec![0.0; inner + 2]);
    let mut freedom = 0.0;
    for j in (0..inner).rev() {
        let (e1, e2) = (if j + 1 < inner { l1[j] } else { 0.0 }, if j + 2 < inner { l2[j] } else { 0.0 });
        b1[j] = -e1 * b0[j + 1] - e2 * b1[j + 1];
        b2[j] = -e1 * b1[j + 1] - e2 * b0[j + 2];
        b0[j] = 1.0 / d[j] - e1 * b1[j] - e2 * b2[j];
        let own = q(j);
        let overlap = |k: usize| if j + k < inner { (k..3).map(|i| own[i] * q(j + k)[i - k]).sum::<f64>() } else { 0.0 };
        freedom += penalty * (overlap(0) * b0[j] + 2.0 * overlap(1) * b1[j] + 2.0 * overlap(2) * b2[j]);
    }
    Ok(Spline { values, seconds, residual, freedom })
}

/// The slopes at the points, each from the piece beyond it, the last from the one before.
fn slopes(r: &[f64], Spline { values, seconds, .. }: &Spline) -> Vec<f64> {
    let rise = |i: usize| (r[i + 1] - r[i], (values[i + 1] - values[i]) / (r[i + 1] - r[i]));
    let own = |i: usize| {
        let (h, rise) = rise(i);
        rise - h * (2.0 * seconds[i] + seconds[i + 1]) / 6.0
    };
    let last = r.len() - 1;
    let (h, rise) = rise(last - 1);
    (0..last).map(own).chain([rise + h * (seconds[last - 1] + 2.0 * seconds[last]) / 6.0]).collect()
}
