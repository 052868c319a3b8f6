//! Surface displacements of a file beside the exact ones: their errors, a free constant, and the faults that displacements have.

use crate::validate::norms::Norms;
use crate::validate::record::Suspicion;

/// Displacements at evenly drawn rows; computed units, positive into the surface.
pub struct Displacements {
    rows: Vec<Reading>,
    /// True where the data are known up to a constant only.
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

/// The error must fall by this much, and to this many times what the grid excuses, for a fault to be named.
const FALL: f64 = 6.0;
const SHARE: f64 = 2.0;
/// A free number follows any small error, so the error must exceed this many times what the grid excuses before it is fitted.
const CLEAR: f64 = 3.0;
/// A mean of this share of the constant is one that was removed.
const NO_MEAN: f64 = 0.05;

impl Displacements {
    /// None yet.
    pub fn new(free_constant: bool) -> Self {
        Self { rows: Vec::new(), free_constant }
    }

    /// Takes one displacement with the exact one and its distance to the axis.
    pub fn push(&mut self, at: f64, u: f64, exact: f64) {
        self.rows.push(Reading { at, u, exact });
    }

    pub(in crate::validate) fn len(&self) -> usize {
        self.rows.len()
    }

    /// The mean difference of data and exact values.
    pub(in crate::validate) fn constant(&self) -> f64 {
        self.mean(|own| own.u - own.exact)
    }

    /// The errors, of u − c where the data are known up to a constant c.
    pub(in crate::validate) fn norms(&self, allowed: f64) -> Norms {
        let constant = if self.free_constant { self.constant() } else { 0.0 };
        let mut norms = Norms::new(false);
        self.rows.iter().for_each(|own| norms.add(own.at, 0.0, own.u - constant, own.exact, allowed));
        norms
    }

    /// Names the one fault that explains the data; `young` is E/E* where the scene has Poisson's ratio.
    ///
    /// `length` writes a length with its unit.
    pub fn suspicion(&self, allowed: f64, young: Option<f64>, length: &dyn Fn(f64) -> String) -> Option<Suspicion> {
        let before = self.error(|own| own.u);
        let mut found: Option<Suspicion> = None;
        let mut try_one = |id: &'static str, text: String, free: bool, change: &dyn Fn(&Reading) -> f64| {
            let after = self.error(change);
            let explains = FALL * after <= before && after <= SHARE * allowed && before >= if free { CLEAR } else { 1.0 } * allowed;
            // The first of the list is named among those that no grid can tell apart, and a free number only where it alone fits.
            let better =
                |own: &Suspicion| if free { 3.0 * after < own.after && own.after > 0.7 * allowed } else { 1.3 * after < own.after };
            if explains && found.as_ref().is_none_or(better) {
                found = Some(Suspicion { id, text, before, after });
            }
        };
        let plain = |own: &Reading| own.u;
        try_one("u-sign", "the displacements have the opposite sign: u is positive into the surface".to_owned(), false, &|own| -own.u);
        for (factor, text) in
            young.iter().flat_map(|ratio| [(1.0 / ratio, "E in the place of E*"), (*ratio, "E* divided twice by 1 - nu^2")])
        {
            let text = format!("another modulus: u is {factor:.4} times the exact one, as for {text} at the same force");
            try_one("modulus", text, false, &|own| own.u / factor);
        }
        for (factor, text) in [(2.0, "twice"), (0.5, "half of")] {
            let text =
                format!("{text} the exact displacement is in u, as for E* {} times that of the scene at the same force", 1.0 / factor);
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
        let advice = "; a column that is named u+c, by --map or in its file, is compared up to a constant";
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
                "another scale: all displacements are {scale:.4} times the exact ones, as for an E* {:.4} times that of the scene at the same force",
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

    /// ‖change(u) − exact‖₂/‖exact‖₂, up to a constant where the data are.
    fn error(&self, change: impl Fn(&Reading) -> f64) -> f64 {
        let constant = if self.free_constant { self.mean(|own| change(own) - own.exact) } else { 0.0 };
        let mut norms = Norms::new(false);
        self.rows.iter().for_each(|own| norms.add(own.at, 0.0, change(own) - constant, own.exact, 0.0));
        norms.l2()
    }
}
