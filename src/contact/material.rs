//! The effective modulus E* of a contact, from the elastic constants of its bodies.

use super::ContactError;

/// A linearly elastic isotropic body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticBody {
    /// Young's modulus E > 0, in any unit of pressure; infinite for a rigid body.
    pub young_modulus: f64,
    /// Poisson's ratio, −1 < ν ≤ 1/2.
    pub poisson_ratio: f64,
}

impl ElasticBody {
    /// A body that does not deform.
    pub const RIGID: Self = Self { young_modulus: f64::INFINITY, poisson_ratio: 0.0 };
}

/// E* of two bodies: 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂ (Popov & Heß (3.2); ν are Poisson's ratios).
///
/// # Errors
/// [`ContactError::Material`] for constants out of range, or two rigid bodies.
///
/// ```
/// use sneddon::contact::{effective_modulus, ElasticBody};
/// let steel = ElasticBody { young_modulus: 210e9, poisson_ratio: 0.3 };
/// let e = effective_modulus(steel, ElasticBody::RIGID).unwrap();
/// assert!((e / 1e9 - 230.769_230_769).abs() < 1e-6);
/// ```
pub fn effective_modulus(first: ElasticBody, second: ElasticBody) -> Result<f64, ContactError> {
    let compliance = |body: ElasticBody| {
        let ElasticBody { young_modulus: e, poisson_ratio: nu } = body;
        if e.is_nan() || e <= 0.0 {
            return Err(ContactError::Material { name: "Young's modulus E", value: e, accepted: "expected a positive number" });
        }
        if !(nu > -1.0 && nu <= 0.5) {
            return Err(ContactError::Material {
                name: "Poisson's ratio nu",
                value: nu,
                accepted: "expected a number with -1 < nu <= 0.5",
            });
        }
        Ok((1.0 - nu) * (1.0 + nu) / e)
    };
    let total = compliance(first)? + compliance(second)?;
    if total > 0.0 && total.is_finite() {
        Ok(1.0 / total)
    } else {
        Err(ContactError::Material {
            name: "Young's modulus E",
            value: f64::INFINITY,
            accepted: "at least one of the two bodies must be elastic",
        })
    }
}

/// A transversely isotropic half-space whose axis of symmetry is normal to the surface.
///
/// The stiffnesses C₁₁, C₁₂, C₁₃, C₃₃, C₄₄ of Popov & Heß (3.64), in any unit of pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransverselyIsotropic {
    /// C₁₁.
    pub c11: f64,
    /// C₁₂.
    pub c12: f64,
    /// C₁₃.
    pub c13: f64,
    /// C₃₃.
    pub c33: f64,
    /// C₄₄.
    pub c44: f64,
}

impl TransverselyIsotropic {
    /// E* = 2√C₄₄ (C₁₁C₃₃ − C₁₃²) / (√C₁₁ √((√(C₁₁C₃₃) − C₁₃)(C₁₃ + 2C₄₄ + √(C₁₁C₃₃)))) (Popov & Heß (3.70)).
    ///
    /// The form (3.65)–(3.69) equals it and needs complex square roots where I₀ < 0; this one is real throughout.
    ///
    /// # Errors
    /// [`ContactError::Material`] if the material would not be stable.
    pub fn effective_modulus(self) -> Result<f64, ContactError> {
        let Self { c11, c12, c13, c33, c44 } = self;
        let demand = |ok: bool, name, value, accepted| if ok { Ok(()) } else { Err(ContactError::Material { name, value, accepted }) };
        demand(c44 > 0.0, "C44", c44, "expected a positive number")?;
        demand(c33 > 0.0, "C33", c33, "expected a positive number")?;
        demand(c11 > c12.abs(), "C11", c11, "a stable material has C11 > |C12|")?;
        demand((c11 + c12) * c33 > 2.0 * c13 * c13, "C13", c13, "a stable material has (C11 + C12) C33 > 2 C13^2")?;
        let mean = c11.sqrt() * c33.sqrt();
        // (C₁₁C₃₃ − C₁₃²)/√(√(C₁₁C₃₃) − C₁₃) without the difference: √(mean − C₁₃)·(mean + C₁₃).
        Ok(2.0 * (c44 / c11).sqrt() * (mean - c13).sqrt() * (mean + c13) / (c13 + 2.0 * c44 + mean).sqrt())
    }

    /// The constants of an isotropic body, for which E* = E/(1 − ν²).
    pub fn isotropic(body: ElasticBody) -> Self {
        let ElasticBody { young_modulus: e, poisson_ratio: nu } = body;
        let lame = e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
        let shear = e / (2.0 * (1.0 + nu));
        Self { c11: lame + 2.0 * shear, c12: lame, c13: lame, c33: lame + 2.0 * shear, c44: shear }
    }
}
