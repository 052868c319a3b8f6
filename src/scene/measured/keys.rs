//! What a scene says of a measured tip: its file, and how its points are to be read and joined.

use crate::scene::file::document::{Entry, Table};
use crate::scene::{Dimension, DimensionedNumber, SceneError, System, Unit};
use std::ops::Range;

/// The keys of `[profile]` that only measured tips have.
pub(in crate::scene) const KEYS: [&str; 7] = ["interpolation", "line_scan", "invert", "apex", "noise", "smoothing", "units"];

/// How points are joined.
#[derive(Clone, Debug, PartialEq)]
pub enum Join {
    /// A monotone cubic through all of them.
    MonotoneCubic,
    /// A smoothing spline between them, its penalty by cross-validation unless it is given.
    SmoothingSpline(Smoothing),
}

/// How much a spline may smooth.
#[derive(Clone, Debug, PartialEq)]
pub enum Smoothing {
    /// As cross-validation finds.
    CrossValidation,
    /// So much that the residual is the noise of the heights.
    Noise(DimensionedNumber),
    /// The penalty itself, in units of a length cubed.
    Weight(DimensionedNumber),
}

/// The slope at the axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Apex {
    /// Rounded or pointed, as the first points tell.
    Auto,
    /// f′(0) = 0.
    Rounded,
    /// f′(0) as the points have it.
    Pointed,
}

/// A measured tip as a scene asks for it; no file is opened yet.
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
    /// Reads the keys of a profile that has points.
    ///
    /// # Errors
    /// [`SceneError`] for a key that does not fit.
    pub(in crate::scene) fn read(profile: &Table<'_>) -> Result<Option<Self>, SceneError> {
        let Some(points) = profile.get("points") else {
            let Some(entry) = KEYS.iter().find_map(|key| profile.get(key)) else { return Ok(None) };
            let message = format!("{} has a meaning for measured points only", entry.key());
            return Err(SceneError::value(message)
                .help("points = \"tip.csv\" beside it would be accepted")
                .at(profile.key_span(entry.key())));
        };
        let file = points.string()?.to_owned();
        if file.is_empty() {
            return Err(SceneError::value("points is empty")
                .help("the name of a file such as \"tip.csv\" would be accepted")
                .at(points.span()));
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
                let message = format!("{key} has a meaning for a smoothing spline only");
                return Err(SceneError::value(message)
                    .help("interpolation = \"smoothing-spline\" beside it would be accepted")
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

    /// The file as it was typed.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Where it stands in the scene file.
    pub fn place(&self) -> Range<usize> {
        self.place.clone()
    }

    /// Every number with its unit.
    pub(in crate::scene) fn quantities(&self) -> impl Iterator<Item = &DimensionedNumber> {
        self.typed.iter().map(|own| &own.0)
    }

    /// True where a unit is named for a column.
    pub(in crate::scene) fn names_units(&self) -> bool {
        self.units.iter().any(Option::is_some)
    }

    /// Refuses numbers whose unit is not what it must be, before any file is opened.
    pub(in crate::scene) fn check(&self, system: &System) -> Result<(), SceneError> {
        let (Join::SmoothingSpline(Smoothing::Noise(_) | Smoothing::Weight(_)), Some((quantity, span))) = (&self.join, self.typed.first())
        else {
            return Ok(());
        };
        let value = self.penalty_number(system).map_err(|error| error.at(span.clone()))?;
        if value.is_none_or(|own| own >= 0.0) {
            return Ok(());
        }
        Err(SceneError::value(format!("{} is negative", quantity.text())).help("a number from 0 on would be accepted").at(span.clone()))
    }

    /// Noise or penalty in computed units.
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
            let message = "noise and smoothing say the same in two ways";
            Err(SceneError::value(message).help("one of the two would be accepted").at(profile.key_span("smoothing")))
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
