//! The keys of a scene for a measured tip: its file, and how to read and interpolate its points.

use crate::scene::file::document::{Entry, Table};
use crate::scene::{Dimension, DimensionedNumber, SceneError, System, Unit};
use std::ops::Range;

/// The keys of `[profile]` for measured tips.
pub(in crate::scene) const KEYS: [&str; 7] = ["interpolation", "line_scan", "invert", "apex", "noise", "smoothing", "units"];

/// Interpolation between points.
#[derive(Clone, Debug, PartialEq)]
pub enum Join {
    /// A monotone cubic through all points.
    MonotoneCubic,
    /// A smoothing spline, with its penalty from cross-validation unless it is given.
    SmoothingSpline(Smoothing),
}

/// The amount of smoothing.
#[derive(Clone, Debug, PartialEq)]
pub enum Smoothing {
    /// Determined by cross-validation.
    CrossValidation,
    /// Such that the residual equals the noise of the heights.
    Noise(DimensionedNumber),
    /// The penalty itself, a length cubed.
    Weight(DimensionedNumber),
}

/// The slope at the axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Apex {
    /// Rounded or pointed, inferred from the first points.
    Auto,
    /// f′(0) = 0.
    Rounded,
    /// f′(0) extrapolated from the points.
    Pointed,
}

/// A measured tip as specified in a scene, before its file is opened.
#[derive(Clone, Debug)]
pub struct Measured {
    pub(super) file: String,
    pub(super) place: Range<usize>,
    pub(super) join: Join,
    pub(super) line_scan: bool,
    pub(super) invert: bool,
    pub(super) apex: Apex,
    pub(super) length_unit: Option<Unit>,
    pub(super) units: [Option<Unit>; 2],
    typed: Vec<(DimensionedNumber, Range<usize>)>,
}

impl Measured {
    /// Reads the keys of a profile with points.
    ///
    /// # Errors
    /// [`SceneError`] for a key that is not applicable.
    pub(in crate::scene) fn read(profile: &Table<'_>) -> Result<Option<Self>, SceneError> {
        let Some(points) = profile.get("points") else {
            let Some(entry) = KEYS.iter().find_map(|key| profile.get(key)) else { return Ok(None) };
            let message = format!("{} requires measured points", entry.key());
            return Err(SceneError::value(message).help("expected points = \"tip.csv\" as well").at(profile.key_span(entry.key())));
        };
        let file = points.string()?.to_owned();
        if file.is_empty() {
            return Err(SceneError::value("points is empty").help("expected a file name such as \"tip.csv\"").at(points.span()));
        }
        let truth = |key: &str| profile.get(key).map_or(Ok(false), |entry| entry.boolean());
        let mut typed = Vec::new();
        let smoothing = smoothing(profile, &mut typed)?;
        let word = profile.get("interpolation").map(|entry| entry.word(&["monotone-cubic", "smoothing-spline"])).transpose()?;
        let join = match (word, smoothing) {
            (Some("smoothing-spline"), own) => Join::SmoothingSpline(own.unwrap_or(Smoothing::CrossValidation)),
            (_, None) => Join::MonotoneCubic,
            (_, Some(_)) => {
                let key = if profile.get("noise").is_some() { "noise" } else { "smoothing" };
                let message = format!("{key} requires a smoothing spline");
                return Err(SceneError::value(message)
                    .help("expected interpolation = \"smoothing-spline\" as well")
                    .at(profile.key_span(key)));
            }
        };
        let apex = match profile.get("apex").map(|entry| entry.word(&["auto", "rounded", "pointed"])).transpose()? {
            Some("rounded") => Apex::Rounded,
            Some("pointed") => Apex::Pointed,
            _ => Apex::Auto,
        };
        let mut units = [None, None];
        let own = profile.get("units");
        if let Some(both) = own.as_ref().filter(|entry| entry.string().is_ok()).map(length).transpose()? {
            units = [Some(both.clone()), Some(both)];
        } else if let Some(table) = profile.table("units")? {
            table.allow(&["r", "z"])?;
            for (key, place) in ["r", "z"].into_iter().zip(&mut units) {
                *place = table.get(key).map(|entry| length(&entry)).transpose()?;
            }
        }
        let length_unit = profile.get("length_unit").map(|entry| length(&entry)).transpose()?;
        Ok(Some(Self {
            file,
            place: points.span(),
            join,
            line_scan: truth("line_scan")?,
            invert: truth("invert")?,
            apex,
            length_unit,
            units,
            typed,
        }))
    }

    /// Returns the file name as typed.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Returns the position of the file name in the scene file.
    pub fn place(&self) -> Range<usize> {
        self.place.clone()
    }

    /// Returns all numbers with their units.
    pub(in crate::scene) fn quantities(&self) -> impl Iterator<Item = &DimensionedNumber> {
        self.typed.iter().map(|own| &own.0)
    }

    /// Returns true if a unit is given for a column.
    pub(in crate::scene) fn names_units(&self) -> bool {
        self.units.iter().any(Option::is_some)
    }

    /// Checks the units of all numbers before any file is opened.
    pub(in crate::scene) fn check(&self, system: &System) -> Result<(), SceneError> {
        let (Join::SmoothingSpline(Smoothing::Noise(_) | Smoothing::Weight(_)), Some((quantity, span))) = (&self.join, self.typed.first())
        else {
            return Ok(());
        };
        let value = self.penalty_number(system).map_err(|error| error.at(span.clone()))?;
        if value.is_none_or(|own| own >= 0.0) {
            return Ok(());
        }
        Err(SceneError::value(format!("{} is negative", quantity.text())).help("expected a number of at least 0").at(span.clone()))
    }

    /// Converts noise or penalty to computing units.
    pub(super) fn penalty_number(&self, system: &System) -> Result<Option<f64>, SceneError> {
        let cubed = || Dimension::LENGTH.power(3.into()).unwrap_or(Dimension::LENGTH);
        match &self.join {
            Join::SmoothingSpline(Smoothing::Noise(own)) => system.number(own, Dimension::LENGTH, "noise").map(Some),
            Join::SmoothingSpline(Smoothing::Weight(own)) => system.number(own, cubed(), "smoothing").map(Some),
            _ => Ok(None),
        }
    }
}

fn smoothing(profile: &Table<'_>, typed: &mut Vec<(DimensionedNumber, Range<usize>)>) -> Result<Option<Smoothing>, SceneError> {
    let (noise, weight) = (profile.get("noise"), profile.get("smoothing"));
    let mut quantity = |entry: &Entry<'_>| -> Result<DimensionedNumber, SceneError> {
        let own = entry.quantity()?;
        typed.push((own.clone(), entry.span()));
        Ok(own)
    };
    match (noise, weight) {
        (Some(_), Some(_)) => {
            let message = "noise and smoothing cannot be combined";
            Err(SceneError::value(message).help("expected only one of them").at(profile.key_span("smoothing")))
        }
        (Some(entry), None) => Ok(Some(Smoothing::Noise(quantity(&entry)?))),
        (None, Some(entry)) if entry.string().is_ok_and(|word| word == "cross-validation") => Ok(Some(Smoothing::CrossValidation)),
        (None, Some(entry)) => Ok(Some(Smoothing::Weight(quantity(&entry)?))),
        (None, None) => Ok(None),
    }
}

fn length(entry: &Entry<'_>) -> Result<Unit, SceneError> {
    let unit = Unit::parse(entry.string()?).map_err(|error| error.at(entry.span()))?;
    if unit.dimension() == Dimension::LENGTH {
        return Ok(unit);
    }
    Err(SceneError::unit(format!("{} is {}, not a length", unit.name(), unit.dimension())).at(entry.span()))
}
