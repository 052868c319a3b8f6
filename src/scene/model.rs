//! The scene: the complete description of a contact problem, as numbers in one system of units.

use super::{Control, Declared, Loads, Measured, MeasuredTip, Quantity, SceneError, Simple, System};
use crate::contact::{Body, ContactError};
use crate::expr::Formula;
use crate::transform::{Method, Profile, Slopes, Solution, derive};
use std::ops::Range;
use std::sync::Arc;

/// The reference point of a depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DepthFrom {
    /// The displacement at r = 0.
    Apex,
    /// The displacement since first touch; it differs for concave shapes.
    FirstTouch,
}

/// The requested output.
#[derive(Clone, Debug, PartialEq)]
pub struct Outputs {
    /// Quantities with one value per load.
    pub data: Vec<Quantity>,
    /// Fields per load.
    pub curves: Vec<Quantity>,
    /// The radii at which fields of r or x are requested.
    pub at: Loads,
    /// The depths below the surface at which the stress on the axis is requested.
    pub depths: Loads,
}

impl Outputs {
    /// The fields that `reference` writes on a grid, those of p, u, f and g that are requested, and the requested curves that it does not
    /// write; p if no curve is requested.
    ///
    /// # Errors
    /// [`SceneError`] if there are curves, and none of them is such a field.
    pub fn fields(&self) -> Result<(Vec<Quantity>, Vec<Quantity>), SceneError> {
        const FIELDS: [Quantity; 4] = [Quantity::Pressure, Quantity::Displacement, Quantity::Profile, Quantity::Equivalent];
        let fields: Vec<Quantity> = FIELDS.into_iter().filter(|own| self.curves.contains(own)).collect();
        let others: Vec<Quantity> = self.curves.iter().copied().filter(|own| !FIELDS.contains(own)).collect();
        match others.first() {
            Some(other) if fields.is_empty() => {
                Err(SceneError::value(format!("{} is not a field on a grid; use `sneddon solve` for it", other.key()))
                    .help("expected p, u, f or g in quantities of [outputs]"))
            }
            None if fields.is_empty() => Ok((vec![Quantity::Pressure], others)),
            _ => Ok((fields, others)),
        }
    }
}

/// Loads and grids in output units, each rounded once from the typed value.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// The loads.
    pub loads: Loads,
    /// The radii of the curves.
    pub at: Loads,
    /// The depths of the curves.
    pub depths: Loads,
}

/// A contact problem: the profile of both bodies together, E*, loads and requested output.
///
/// ```
/// use sneddon::scene::{Control, Loads, Run, Scene};
/// use sneddon::{parse, transform::Profile};
/// let scene = Scene {
///     effective_modulus: 3.0,
///     loads: Loads::List(vec![0.1]),
///     ..Scene::of(Profile::new(&parse::profile("r^2/(2*10)").unwrap()).unwrap())
/// };
/// let solution = scene.solution().unwrap();
/// let row = Run::new(&scene, &solution).unwrap().row(0).unwrap();
/// assert_eq!(row.indented.state.unwrap().radius, 1.0);
/// ```
#[derive(Clone, Debug)]
pub struct Scene {
    /// f with numerical parameters.
    pub profile: Profile,
    /// The shapes of both bodies if both have one; f is their sum.
    pub bodies: Vec<Profile>,
    /// A measured tip that is added to f, before its file is read.
    pub measured: Option<Measured>,
    /// The measured tip after its file was read.
    pub tip: Option<MeasuredTip>,
    /// The radius of a vertical side.
    pub rim: Option<f64>,
    /// False for a flat punch with a non-circular cross-section, for which d, F and k are known, but no fields.
    pub round: bool,
    /// E*.
    pub effective_modulus: f64,
    /// The controlled quantity.
    pub control: Control,
    /// The values of the controlled quantity.
    pub loads: Loads,
    /// The reference point of depths.
    pub depth_from: DepthFrom,
    /// The requested output.
    pub outputs: Outputs,
    /// Loads and grids as shown in the output; if `None`, they are converted.
    pub shown: Option<Shown>,
    /// The system of units.
    pub system: System,
    /// The method of computation.
    pub method: Method,
    /// The relative tolerance of quadrature.
    pub tolerance: f64,
    /// The bytes of the profile in the scene file, for errors.
    pub place: Option<Range<usize>>,
    /// The length scale of dimensionless output with its name: R if the profile has it, else the radius of a vertical side.
    pub length: Option<(String, f64)>,
    /// The simple shapes that the profile approximates, if they follow from its name; else they are determined at its tip.
    pub relatives: Vec<Simple>,
    /// The error if the coordinates of requested curves are missing.
    pub lacking: Option<SceneError>,
    /// The parameters of the profile with their values as typed, such as `10 um`.
    pub parameters: Vec<(String, String)>,
    /// f with its parameters as symbols; `None` where their values are needed to read it, and for measured tips.
    pub symbolic: Option<Formula>,
    /// The declared properties of a solver's data.
    pub data: Option<Declared>,
}

impl Scene {
    /// Creates a scene with E* = 1, no loads, and the requested output d, F, a and k.
    pub fn of(profile: Profile) -> Self {
        Self {
            profile,
            bodies: Vec::new(),
            measured: None,
            tip: None,
            rim: None,
            round: true,
            effective_modulus: 1.0,
            control: Control::Depth,
            loads: Loads::List(Vec::new()),
            depth_from: DepthFrom::Apex,
            outputs: Outputs {
                data: vec![Quantity::Depth, Quantity::Force, Quantity::Radius, Quantity::Stiffness],
                curves: Vec::new(),
                at: Loads::List(Vec::new()),
                depths: Loads::List(Vec::new()),
            },
            shown: None,
            system: System::bare(),
            method: Method::Auto,
            tolerance: 1e-12,
            place: None,
            length: None,
            relatives: Vec::new(),
            lacking: None,
            parameters: Vec::new(),
            symbolic: None,
            data: None,
        }
    }

    /// Returns the same scene with the output d/R, F/(E* R²), p/E*.
    ///
    /// # Errors
    /// [`SceneError`] if the profile has no length scale.
    pub fn dimensionless(self) -> Result<Self, SceneError> {
        let rim = self.rim.map(|c| ("c".to_owned(), c));
        let Some((name, length)) = self.length.clone().or(rim) else {
            let missing = SceneError::missing("the profile has no length scale").help("expected a parameter R, or a radius");
            return Err(self.placed(missing));
        };
        let system = self.system.dimensionless(&name, length, self.effective_modulus);
        Ok(Self { system, shown: None, ..self })
    }

    /// Returns the same scene with the text of its tip's file, as returned by [`super::decoded`]; a scene without points is unchanged.
    ///
    /// # Errors
    /// [`SceneError`] with a position in that text.
    pub fn with_points(mut self, text: &(String, bool)) -> Result<Self, SceneError> {
        if let Some(measured) = &self.measured {
            self.tip = Some(measured.tip(text, &self.system)?);
        }
        Ok(self)
    }

    /// Returns true if the loads are depths since first touch.
    pub fn counts_from_touch(&self) -> bool {
        self.control == Control::Depth && self.depth_from == DepthFrom::FirstTouch
    }

    /// Returns the exact transform of the profile.
    ///
    /// # Errors
    /// [`SceneError`] if the profile has no transform.
    pub fn solution(&self) -> Result<Solution, SceneError> {
        derive(&self.profile).map_err(|error| self.placed(ContactError::from(error).into()))
    }

    /// Returns both bodies if each has a shape.
    ///
    /// # Errors
    /// [`ContactError`] if a shape cannot be evaluated.
    pub fn parts(&self) -> Result<Vec<Body<'_>>, ContactError> {
        let names = ["the indenter", "the counterbody"];
        let mut parts = self.bodies.iter().zip(names).map(|(own, name)| Body::formula(name, own)).collect::<Result<Vec<_>, _>>()?;
        if let (Some(tip), false) = (&self.tip, parts.is_empty()) {
            parts.push(Body::other("the measured tip", Arc::clone(tip.profile()) as Arc<dyn Slopes>));
        }
        Ok(parts)
    }

    /// Adds the position of the profile to an error.
    pub(super) fn placed(&self, error: SceneError) -> SceneError {
        match &self.place {
            Some(place) => error.at(place.clone()),
            None => error,
        }
    }
}
