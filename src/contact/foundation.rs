//! The discrete spring foundation of the method itself: an independent numeric solver of the same contact.

use super::ContactError;

/// The largest number of springs on one side.
const MOST_SPRINGS: usize = 50_000_000;

/// Independent springs of stiffness E*Δx at spacing Δx (Popov & Heß (3.3)–(3.5)), with the profile g above them.
///
/// The foundation is symmetric; springs sit at x = (i + ½)Δx on either side.
///
/// ```
/// use sneddon::contact::SpringFoundation;
/// // g = x²/R with R = 1: F = (4/3) E* R^(1/2) d^(3/2) (3.13)
/// let springs = SpringFoundation::new(|x| x * x, 1.0, 20_000, 1.0).unwrap();
/// let state = springs.indent(0.25);
/// assert!((state.force - 4.0 / 3.0 * 0.125).abs() < 1e-7);
/// ```
pub struct SpringFoundation {
    spacing: f64,
    effective_modulus: f64,
    heights: Vec<f64>,
}

/// The foundation under a given depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundationState {
    /// F = Σ E*Δx (d − g(x_i)) over the springs in contact (3.7)–(3.10).
    pub force: f64,
    /// Half the number of springs in contact times Δx.
    pub contact_radius: f64,
    /// k = Σ E*Δx over the springs in contact (3.3), which tends to 2E*a.
    pub stiffness: f64,
}

impl SpringFoundation {
    /// `springs` springs on each side over 0 ≤ x ≤ `reach` under the profile `g`.
    ///
    /// # Errors
    /// [`ContactError::Springs`] for none or too many.
    pub fn new(g: impl Fn(f64) -> f64, reach: f64, springs: usize, effective_modulus: f64) -> Result<Self, ContactError> {
        if springs == 0 || springs > MOST_SPRINGS {
            return Err(ContactError::Springs { springs, limit: MOST_SPRINGS });
        }
        let spacing = reach / springs as f64;
        let heights = (0..springs).map(|i| g((i as f64 + 0.5) * spacing)).collect();
        Ok(Self { spacing, effective_modulus, heights })
    }

    /// Presses the rigid profile to the depth d: every spring is compressed by d − g(x), or free.
    pub fn indent(&self, depth: f64) -> FoundationState {
        let stiffness = self.effective_modulus * self.spacing;
        let (mut compression, mut count) = (0.0, 0.0);
        for height in self.heights.iter().rev() {
            let own = depth - height;
            if own > 0.0 {
                compression += own;
                count += 1.0;
            }
        }
        FoundationState { force: 2.0 * stiffness * compression, contact_radius: count * self.spacing, stiffness: 2.0 * stiffness * count }
    }

    /// Δx.
    pub fn spacing(&self) -> f64 {
        self.spacing
    }
}
