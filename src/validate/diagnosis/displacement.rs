//! Surface displacements compared with exact values: errors, a free constant, and common mistakes.

use crate::validate::norms::Norms;
use crate::validate::record::Suspicion;

/// Displacements at evenly sampled rows, in computing units and positive into the surface.
pub struct Displacements {
    rows: Vec<Reading>,
    /// True if the data are known only up to a constant.
    free_constant: bool,
}

/// One displacement.
#[derive(Clone, Copy)]
struct Reading {
    /// The distance to the axis in the unit of the data.
    at: f64,
    u: f64,
    exact: f64,
}

/// To report a fault, the error must decrease by this factor, and to this multiple of the discretization error.
const FALL: f64 = 6.0;
const SHARE: f64 = 2.0;
/// A fitted number can reproduce any small error, so the error must exceed this multiple of the discretization error before fitting.
const CLEAR: f64 = 3.0;
/// If the mean is below this fraction of the constant, the mean was removed.
const NO_MEAN: f64 = 0.05;

impl Displacements {
    /// Creates an empty list.
    pub fn new(free_constant: bool) -> Self {
        Self { rows: Vec::new(), free_constant }
    }

    /// Adds a displacement with its exact value and its distance to the axis.
    pub fn push(&mut self, at: f64, u: f64, exact: f64) {
        self.rows.push(Reading { at, u, exact });
    }

    pub(in crate::validate) fn len(&self) -> usize {
        self.rows.len()
    }

    /// Returns the mean difference between data and exact values.
    pub(in crate::validate) fn constant(&self) -> f64 {
        self.mean(|own| own.u - own.exact)
    }

    /// Returns the errors; if the data are known only up to a constant c, of u − c.
    pub(in crate::validate) fn norms(&self, allowed: f64) -> Norms {
        let constant = if self.free_constant { self.constant() } else { 0.0 };
        let mut norms = Norms::new(false);
        self.rows.iter().for_each(|own| norms.add(own.at, 0.0, own.u - constant, own.exact, allowed));
        norms
    }

    /// Finds the fault that explains the data; `young` is E/E* if the scene has a Poisson's ratio.
    ///
    /// `length` formats a length with its unit.
    pub fn suspicion(&self, allowed: f64, young: Option<f64>, length: &dyn Fn(f64) -> String) -> Option<Suspicion> {
        let before = self.error(|own| own.u);
        let mut found: Option<Suspicion> = None;
        let mut try_one = |id: &'static str, text: String, free: bool, change: &dyn Fn(&Reading) -> f64| {
            let after = self.error(change);
            let explains = FALL * after <= before && after <= SHARE * allowed && before >= if free { CLEAR } else { 1.0 } * allowed;
            // Among faults that cannot be distinguished, the first is reported; a fitted number is reported only if no other fault fits.
            let better =
                |own: &Suspicion| if free { 3.0 * after < own.after && own.after > 0.7 * allowed } else { 1.3 * after < own.after };
            if explains && found.as_ref().is_none_or(better) {
                found = Some(Suspicion { id, text, before, after });
            }
        };
        let plain = |own: &Reading| own.u;
        try_one("u-sign", "the displacements have the opposite sign: u is positive into the surface".to_owned(), false, &|own| -own.u);
        for (factor, text) in young.iter().flat_map(|ratio| [(1.0 / ratio, "E used as E*"), (*ratio, "E* divided by 1 - nu^2 twice")]) {
            let text = format!("another modulus: u is {factor:.4} times the exact value, as for {text} at the same force");
            try_one("modulus", text, false, &|own| own.u / factor);
        }
        for (factor, text) in [(2.0, "twice"), (0.5, "half of")] {
            let text = format!("u is {text} the exact displacement, as for {} times the E* of the scene at the same force", 1.0 / factor);
            try_one("u-scale", text, false, &|own| own.u / factor);
        }
        for power in (-12..=12).filter(|power| *power != 0) {
            let factor = 10f64.powi(power);
            let text = format!("unit slip: u is 10^{power} times the exact displacement");
            try_one("u-scale", text, false, &|own| own.u / factor);
        }
        let constant = self.constant();
        let mean = self.mean(plain);
        let text = if mean.abs() <= NO_MEAN * constant.abs() {
            format!("a free constant: the mean of u has been removed; u + {} is exact", length(-constant))
        } else {
            format!("a free constant: every u is too large by {}", length(constant))
        };
        let advice = "; a column with the name u+c in the file or in the map is compared up to a constant";
        try_one("u-constant", format!("{text}{advice}"), true, &|own| own.u - constant);
        let turned = self.mean(|own| -own.u - own.exact);
        let text = format!("the displacements have the opposite sign and a free constant: -u - ({}) is exact", length(turned));
        try_one("u-sign", text, true, &|own| -own.u - turned);
        let centre = if self.free_constant { (mean, self.mean(|own| own.exact)) } else { (0.0, 0.0) };
        let product = |own: &Reading| (own.u - centre.0) * (own.exact - centre.1);
        let (above, below) = self.rows.iter().fold((0.0, 0.0), |sum, own| (sum.0 + product(own), sum.1 + (own.exact - centre.1).powi(2)));
        let scale = above / below;
        if scale.is_finite() && scale != 0.0 {
            let text = format!(
                "another scale: all displacements are {scale:.4} times the exact values, as for {:.4} times the E* of the scene at the same force",
                1.0 / scale
            );
            try_one("u-scale", text, true, &|own| own.u / scale);
        }
        found
    }

    fn mean(&self, value: impl Fn(&Reading) -> f64) -> f64 {
        let sum: f64 = self.rows.iter().map(value).sum();
        if self.rows.is_empty() { 0.0 } else { sum / self.rows.len() as f64 }
    }

    /// Returns ‖change(u) − exact‖₂/‖exact‖₂, up to a constant if the data are.
    fn error(&self, change: impl Fn(&Reading) -> f64) -> f64 {
        let constant = if self.free_constant { self.mean(|own| change(own) - own.exact) } else { 0.0 };
        let mut norms = Norms::new(false);
        self.rows.iter().for_each(|own| norms.add(own.at, 0.0, change(own) - constant, own.exact, 0.0));
        norms.l2()
    }
}
