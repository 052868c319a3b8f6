//! Values of a scene that are given beside its file: the side of a box, a load.

use crate::scene::file::dimensioned::to_double_double;
use crate::scene::{Control, Dimension, DimensionedNumber, Loads, Scene, SceneError};

impl Scene {
    /// A length above 0 as typed, in computed units; `name` is that of the argument, for errors.
    ///
    /// # Errors
    /// [`SceneError`] where the text is not such a length, or has a unit where the scene has none.
    pub fn length(&self, name: &str, text: &str) -> Result<f64, SceneError> {
        self.positive(name, text, Dimension::LENGTH)
    }

    /// The same scene under one load as typed: `d=0.4`, `F=2 mN` or `a=1 um`.
    ///
    /// ```
    /// # let text = "[profile]\nf = \"r^2/(2*R)\"\nparameters = { R = \"1 um\" }\n[material]\neffective_modulus = \"1 GPa\"\n[load]\ndepth = \"1 nm\"";
    /// let scene = sneddon::scene::scene(text)?.under("a=100 nm")?;
    /// assert_eq!(scene.control.name(), "contact_radius");
    /// # Ok::<(), sneddon::scene::SceneError>(())
    /// ```
    ///
    /// # Errors
    /// [`SceneError`] where the text is not a load.
    pub fn under(self, text: &str) -> Result<Self, SceneError> {
        let unknown =
            || SceneError::value(format!("load {text:?} is not a load")).help("d=0.4, F=2 or a=1, with the scene's units, is accepted");
        let (name, value) = text.split_once('=').ok_or_else(unknown)?;
        let (control, dimension) = match name.trim() {
            "d" | "depth" => (Control::Depth, Dimension::LENGTH),
            "F" | "force" => (Control::Force, Dimension::FORCE),
            "a" | "contact_radius" => (Control::ContactRadius, Dimension::LENGTH),
            _ => return Err(unknown()),
        };
        let value = self.positive("load", value, dimension)?;
        Ok(Self { control, loads: Loads::List(vec![value]), ..self })
    }

    fn positive(&self, name: &str, text: &str, dimension: Dimension) -> Result<f64, SceneError> {
        let quantity = DimensionedNumber::parse(text)?;
        if !self.system.has_units() && quantity.unit().is_some() {
            return Err(SceneError::unit(format!("{name} = {} has a unit, and the numbers of the scene have none", text.trim()))
                .help("a bare number is accepted, which counts in the scene's unit"));
        }
        let value = to_double_double(&self.system.exact(&quantity, dimension, name)?)?.value();
        if value > 0.0 && value.is_finite() {
            return Ok(value);
        }
        Err(SceneError::value(format!("{name} = {} is not positive", text.trim())).help("a number above 0 is accepted"))
    }
}
