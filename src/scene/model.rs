//! The scene itself: everything that is known about a contact before it is solved, as numbers of one system.

use super::{Control, Declared, Loads, Measured, MeasuredTip, Quantity, SceneError, Simple, System};
use crate::contact::{Body, ContactError};
use crate::transform::{Method, Profile, Slopes, Solution, derive};
use std::ops::Range;
use std::sync::Arc;

/// From where a depth is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DepthFrom {
    /// The displacement at r = 0.
    Apex,
    /// The displacement since the bodies first touched; it differs for concave shapes.
    FirstTouch,
}

/// What is wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct Outputs {
    /// Numbers per load.
    pub data: Vec<Quantity>,
    /// Functions per load.
    pub curves: Vec<Quantity>,
    /// The radii at which functions of r or x are wanted.
    pub at: Loads,
    /// The depths below the surface at which the stress on the axis is wanted.
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
                Err(SceneError::value(format!("{} is not a field on a grid; `sneddon solve` writes it", other.key()))
                    .help("expected p, u, f or g in quantities of [outputs]"))
            }
            None if fields.is_empty() => Ok((vec![Quantity::Pressure], others)),
            _ => Ok((fields, others)),
        }
    }
}

/// Loads and grids in the units of the answers, each rounded once from what was typed.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// The loads.
    pub loads: Loads,
    /// The radii of the curves.
    pub at: Loads,
    /// The depths of the curves.
    pub depths: Loads,
}

/// A contact: the profile of both bodies together, E*, loads and what is wanted of them.
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
    /// f, with numbers for its parameters.
    pub profile: Profile,
    /// The shapes of both bodies, where both have one; f is their sum.
    pub bodies: Vec<Profile>,
    /// A measured tip that is added to f, before its file is read.
    pub measured: Option<Measured>,
    /// The same, read.
    pub tip: Option<MeasuredTip>,
    /// The radius of a vertical side.
    pub rim: Option<f64>,
    /// False for a flat punch with a cross-section of its own, of which d, F and k are known, and no fields.
    pub round: bool,
    /// E*.
    pub effective_modulus: f64,
    /// What is controlled.
    pub control: Control,
    /// Its values.
    pub loads: Loads,
    /// From where depths are measured.
    pub depth_from: DepthFrom,
    /// What is wanted.
    pub outputs: Outputs,
    /// Loads and grids as the answers show them; without it they are converted.
    pub shown: Option<Shown>,
    /// The units of the answers.
    pub system: System,
    /// How numbers may be computed.
    pub method: Method,
    /// The relative tolerance of quadratures.
    pub tolerance: f64,
    /// The bytes of the scene file in which the profile stands, for errors.
    pub place: Option<Range<usize>>,
    /// A length of the profile with its name, in which dimensionless answers count: R where there is one, else the radius of a vertical side.
    pub length: Option<(String, f64)>,
    /// The simple shapes for which the profile may be taken, where its name tells; else they are looked for at its tip.
    pub relatives: Vec<Simple>,
    /// What the curves lack that were asked for: their places.
    pub lacking: Option<SceneError>,
    /// The names of the parameters of the profile.
    pub parameters: Vec<String>,
    /// What is said of a solver's data.
    pub data: Option<Declared>,
}

impl Scene {
    /// A scene with E* = 1, no loads, and the four numbers d, F, a, k wanted.
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
            data: None,
        }
    }

    /// The same scene with answers as d/R, F/(E* R²), p/E*.
    ///
    /// # Errors
    /// [`SceneError`] where the profile has no length to count in.
    pub fn dimensionless(self) -> Result<Self, SceneError> {
        let rim = self.rim.map(|c| ("c".to_owned(), c));
        let Some((name, length)) = self.length.clone().or(rim) else {
            let missing =
                SceneError::missing("the profile has no length to count in").help("a parameter R, or a radius, would be accepted");
            return Err(self.placed(missing));
        };
        let system = self.system.dimensionless(&name, length, self.effective_modulus);
        Ok(Self { system, shown: None, ..self })
    }

    /// The same scene with the text of its tip's file, as [`super::decoded`] gives it; a scene without points stays as it is.
    ///
    /// # Errors
    /// [`SceneError`] whose place is one in that text.
    pub fn with_points(mut self, text: &(String, bool)) -> Result<Self, SceneError> {
        if let Some(measured) = &self.measured {
            self.tip = Some(measured.tip(text, &self.system)?);
        }
        Ok(self)
    }

    /// True where the loads are depths since the first touch.
    pub fn counts_from_touch(&self) -> bool {
        self.control == Control::Depth && self.depth_from == DepthFrom::FirstTouch
    }

    /// The exact transform of the profile.
    ///
    /// # Errors
    /// [`SceneError`] where the profile has none.
    pub fn solution(&self) -> Result<Solution, SceneError> {
        derive(&self.profile).map_err(|error| self.placed(ContactError::from(error).into()))
    }

    /// Each body with a shape, where there are two of them.
    ///
    /// # Errors
    /// [`ContactError`] where a shape cannot be evaluated.
    pub fn parts(&self) -> Result<Vec<Body<'_>>, ContactError> {
        let names = ["the indenter", "the counterbody"];
        let mut parts = self.bodies.iter().zip(names).map(|(own, name)| Body::formula(name, own)).collect::<Result<Vec<_>, _>>()?;
        if let (Some(tip), false) = (&self.tip, parts.is_empty()) {
            parts.push(Body::other("the measured tip", Arc::clone(tip.profile()) as Arc<dyn Slopes>));
        }
        Ok(parts)
    }

    /// An error about the profile, with its place.
    pub(super) fn placed(&self, error: SceneError) -> SceneError {
        match &self.place {
            Some(place) => error.at(place.clone()),
            None => error,
        }
    }
}
