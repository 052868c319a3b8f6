//! Values of a scene that are given in addition to its file: the side of a box, a load.

use crate::scene::file::dimensioned::to_double_double;
use crate::scene::{Control, Dimension, DimensionedNumber, Loads, Scene, SceneError};

impl Scene {
    /// Parses a positive length in the computing units; `name` is the name of the argument in errors.
    ///
    /// # Errors
    /// [`SceneError`] unless the text is such a length; it must not have a unit if the numbers of the scene have none.
    pub fn length(&self, name: &str, text: &str) -> Result<f64, SceneError> {
        self.positive(name, text, Dimension::LENGTH)
    }

    /// Returns the same scene under one load, given as text: `d=0.4`, `F=2 mN` or `a=1 um`.
    ///
    /// ```
    /// # let text = "[profile]\nf = \"r^2/(2*R)\"\nparameters = { R = \"1 um\" }\n[material]\neffective_modulus = \"1 GPa\"\n[load]\ndepth = \"1 nm\"";
    /// let scene = sneddon::scene::scene(text)?.under("a=100 nm")?;
    /// assert_eq!(scene.control.name(), "contact_radius");
    /// # Ok::<(), sneddon::scene::SceneError>(())
    /// ```
    ///
    /// # Errors
    /// [`SceneError`] if the text is not a load.
    pub fn under(self, text: &str) -> Result<Self, SceneError> {
        let help = if self.system.has_units() {
            "expected d, F or a with its value, such as d=\"0.4 um\", F=\"2 mN\" or a=\"250 nm\""
        } else {
            "expected d, F or a with its value, such as d=0.4, F=2 or a=1"
        };
        let unknown = || SceneError::value(format!("{text:?} is not a load")).help(help);
        let (name, value) = text.split_once('=').ok_or_else(unknown)?;
        let (control, dimension) = match name.trim() {
            "d" | "depth" => (Control::Depth, Dimension::LENGTH),
            "F" | "force" => (Control::Force, Dimension::FORCE),
            "a" | "contact_radius" => (Control::ContactRadius, Dimension::LENGTH),
            _ => return Err(unknown()),
        };
        let value = self.positive(name.trim(), value, dimension)?;
        Ok(Self { control, loads: Loads::List(vec![value]), ..self })
    }

    fn positive(&self, name: &str, text: &str, dimension: Dimension) -> Result<f64, SceneError> {
        let quantity = DimensionedNumber::parse(text)?;
        if !self.system.has_units() && quantity.unit().is_some() {
            return Err(SceneError::unit(format!("{name} = {} has a unit, but the numbers of the scene have none", text.trim()))
                .help("expected a number without a unit, in the units of the scene"));
        }
        let value = to_double_double(&self.system.exact(&quantity, dimension, name)?)?.value();
        if value > 0.0 && value.is_finite() {
            return Ok(value);
        }
        Err(SceneError::value(format!("{name} = {} is not positive", text.trim())).help("expected a positive number"))
    }
}
