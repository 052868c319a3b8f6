//! The loads, outputs and method of a scene, as typed and as numbers in its units.

use crate::contact::Kind;
use crate::scene::file::dimensioned::to_double_double;
use crate::scene::file::dimensioned::to_f64;
use crate::scene::file::document::{Entry, Table};
use crate::scene::load::Steps;
use crate::scene::system::Named;
use crate::scene::{Control, DepthFrom, Dimension, DimensionedNumber, Loads, Quantity, Scene, SceneError, System, Unit};
use crate::transform::Method;
use std::ops::Range;

/// Maximum number of loads, and of points of a curve.
const MOST_LOADS: usize = 100_000_000;

/// Numbers as typed; the ends of a range are start and stop.
enum Typed {
    List(Vec<(DimensionedNumber, Range<usize>)>),
    Range { ends: Box<[(DimensionedNumber, Range<usize>); 2]>, count: usize, logarithmic: bool },
}

/// The tables `[load]`, `[outputs]` and `[method]`.
pub(in crate::scene) struct Asked {
    control: Control,
    loads: Typed,
    depth_from: DepthFrom,
    data: Vec<Quantity>,
    curves: Vec<Quantity>,
    at: Option<Typed>,
    depths: Option<Typed>,
    lacking: Option<SceneError>,
    pub(in crate::scene) units: Named,
    method: Method,
    tolerance: Option<f64>,
}

impl Asked {
    pub(in crate::scene) fn read(
        load: Option<&Table<'_>>,
        outputs: Option<&Table<'_>>,
        method: Option<&Table<'_>>,
    ) -> Result<Self, SceneError> {
        let mut own = match load {
            Some(load) => Self::loaded(load)?,
            None => Self::of(Control::Depth, Typed::List(Vec::new()), DepthFrom::Apex),
        };
        if let Some(outputs) = outputs {
            own.read_outputs(outputs)?;
        }
        if let Some(table) = method {
            table.allow(&["name", "tolerance"])?;
            own.method = match table.get("name").map(|entry| entry.word(&["auto", "exact", "quadrature"])).transpose()? {
                Some("exact") => Method::Exact,
                Some("quadrature") => Method::Quadrature,
                _ => Method::Auto,
            };
            own.tolerance = table.get("tolerance").map(|entry| tolerance(&entry)).transpose()?;
        }
        Ok(own)
    }

    fn loaded(load: &Table<'_>) -> Result<Self, SceneError> {
        load.allow(&["depth", "force", "contact_radius", "depth_from"])?;
        let controls = [Control::Depth, Control::Force, Control::ContactRadius];
        let given: Vec<(Control, Entry<'_>)> = controls.into_iter().filter_map(|own| Some((own, load.get(own.name())?))).collect();
        let help = "expected one of depth, force and contact_radius: a number, a list, or { start, stop, count }";
        let (control, entry) = match given.as_slice() {
            [only] => only,
            [] => return Err(SceneError::missing("[load] has no load").help(help).at(load.span())),
            [_, second, ..] => {
                return Err(SceneError::value("[load] contains more than one load").help(help).at(load.key_span(second.0.name())));
            }
        };
        let depth_from = match load.get("depth_from") {
            None => DepthFrom::Apex,
            Some(entry) if entry.word(&["apex", "first_touch"])? == "apex" => DepthFrom::Apex,
            Some(entry) if *control != Control::Depth => {
                return Err(SceneError::value("depth_from requires a load by depth").at(entry.span()));
            }
            Some(_) => DepthFrom::FirstTouch,
        };
        Ok(Self::of(*control, numbers(entry)?, depth_from))
    }

    /// Creates a request for d, F, a and k under these loads.
    fn of(control: Control, loads: Typed, depth_from: DepthFrom) -> Self {
        Self {
            control,
            loads,
            depth_from,
            data: vec![Quantity::Depth, Quantity::Force, Quantity::Radius, Quantity::Stiffness],
            curves: Vec::new(),
            at: None,
            depths: None,
            lacking: None,
            units: Named::default(),
            method: Method::Auto,
            tolerance: None,
        }
    }

    fn read_outputs(&mut self, outputs: &Table<'_>) -> Result<(), SceneError> {
        outputs.allow(&["quantities", "at", "depths", "units"])?;
        if let Some(entry) = outputs.get("quantities") {
            (self.data, self.curves) = quantities(&entry)?;
        }
        self.at = outputs.get("at").map(|entry| numbers(&entry)).transpose()?;
        self.depths = outputs.get("depths").map(|entry| numbers(&entry)).transpose()?;
        if self.depths.is_none() && self.curves.iter().any(|own| own.coordinate() == "z") {
            let missing = SceneError::missing("[outputs] has no depths: sigma_zz requires depths below the surface");
            let help = "expected depths = { start = \"0 um\", stop = \"5 um\", count = 101 }";
            self.lacking = Some(missing.help(help).at(outputs.span()));
        }
        let names: Vec<&str> = self.curves.iter().filter(|own| own.coordinate() != "z").map(|own| own.key()).collect();
        if self.at.is_none() && !names.is_empty() {
            let message = format!("[outputs] has no radii `at` for {}", names.join(", "));
            let help = "expected at = { start = \"0 um\", stop = \"2 um\", count = 101 }";
            self.lacking = Some(SceneError::missing(message).help(help).at(outputs.span()));
        }
        let Some(entry) = outputs.get("units") else { return Ok(()) };
        let table = entry.table("units".to_owned())?;
        table.allow(&["length", "force", "pressure"])?;
        for (key, dimension, place) in [
            ("length", Dimension::LENGTH, &mut self.units.length),
            ("force", Dimension::FORCE, &mut self.units.force),
            ("pressure", Dimension::PRESSURE, &mut self.units.pressure),
        ] {
            let Some(entry) = table.get(key) else { continue };
            let unit = Unit::parse(entry.string()?).map_err(|error| error.at(entry.span()))?;
            if unit.dimension() != dimension {
                return Err(SceneError::unit(format!("{} is {}, not {dimension}", unit.name(), unit.dimension())).at(entry.span()));
            }
            *place = Some((unit, entry.span()));
        }
        Ok(())
    }

    /// Returns all numbers with their units.
    pub(in crate::scene) fn quantities(&self) -> impl Iterator<Item = &DimensionedNumber> {
        std::iter::once(&self.loads)
            .chain(self.at.as_ref())
            .chain(self.depths.as_ref())
            .flat_map(|typed| typed.typed().into_iter().map(|own| &own.0))
    }

    /// Returns an error for loads without a contact: negative forces and radii, and the radius of the indenter itself.
    fn refuse(&self, loads: &Loads, rim: Option<f64>) -> Result<(), SceneError> {
        if self.control == Control::Depth {
            return Ok(());
        }
        let name = self.control.name();
        for (typed, value) in self.loads.typed().into_iter().zip(loads.ends()) {
            let fault = |message: String, help: &str| Err(SceneError::value(message).help(help).at(typed.1.clone()));
            let text = typed.0.text();
            if value < 0.0 {
                let reason = if self.control == Control::Force { ": adhesion is not supported" } else { "" };
                return fault(format!("{name} = {text} is negative{reason}"), "expected 0 or a positive number");
            }
            if self.control == Control::ContactRadius && rim == Some(value) {
                let message = format!("{name} = {text} is the radius of the indenter, which the contact has at every depth above g(c)");
                return fault(message, "expected a load by depth or force");
            }
        }
        Ok(())
    }

    /// Completes a scene.
    pub(in crate::scene) fn scene(self, scene: Scene) -> Result<Scene, SceneError> {
        let dimension = if self.control == Control::Force { Dimension::FORCE } else { Dimension::LENGTH };
        let loads = self.loads.numbers(&scene.system, dimension, self.control.name())?;
        self.refuse(&loads, scene.rim)?;
        let grid = |typed: &Option<Typed>, key: &str, place: &str| match typed {
            None => Ok((Loads::List(Vec::new()), Loads::List(Vec::new()))),
            Some(typed) => {
                let at = typed.numbers(&scene.system, Dimension::LENGTH, key)?;
                if at.extremes().is_some_and(|(low, _)| low < 0.0) {
                    let message = format!("{key} contains a negative {place}");
                    return Err(SceneError::value(message).help("expected 0 or a positive number").at(typed.span()));
                }
                Ok((at, typed.shown(&scene.system, Dimension::LENGTH)?))
            }
        };
        let ((at, shown_at), (depths, shown_depths)) = (grid(&self.at, "at", "radius")?, grid(&self.depths, "depths", "depth")?);
        let shown = crate::scene::Shown { loads: self.loads.shown(&scene.system, dimension)?, at: shown_at, depths: shown_depths };
        let mut data = self.data;
        // A row always contains its load.
        let own = self.control.datum();
        if !data.contains(&own) {
            data.push(own);
        }
        data.sort_by_key(|own| Quantity::ALL.iter().position(|other| other == own));
        let outputs = crate::scene::Outputs { data, curves: self.curves, at, depths };
        let tolerance = self.tolerance.unwrap_or(scene.tolerance);
        Ok(Scene {
            control: self.control,
            loads,
            depth_from: self.depth_from,
            outputs,
            shown: Some(shown),
            lacking: self.lacking,
            method: self.method,
            tolerance,
            ..scene
        })
    }
}

impl Typed {
    fn numbers(&self, system: &System, dimension: Dimension, what: &str) -> Result<Loads, SceneError> {
        let number =
            |own: &(DimensionedNumber, Range<usize>)| system.number(&own.0, dimension, what).map_err(|error| error.at(own.1.clone()));
        Ok(match self {
            Self::List(list) => Loads::List(list.iter().map(number).collect::<Result<_, _>>()?),
            Self::Range { ends, count, logarithmic } => {
                let [start, stop] = ends.as_ref();
                let (first, last) = (number(start)?, number(stop)?);
                if *logarithmic && (first <= 0.0 || last <= 0.0) {
                    let bad = if first <= 0.0 { start } else { stop };
                    return Err(SceneError::value("both ends of a logarithmic range must be positive").at(bad.1.clone()));
                }
                let end = |own: &(DimensionedNumber, Range<usize>)| to_double_double(&system.exact(&own.0, dimension, what)?);
                Loads::Range(Steps::new(end(start)?, end(stop)?, *count, *logarithmic))
            }
        })
    }

    /// Converts the numbers to output units.
    fn shown(&self, system: &System, dimension: Dimension) -> Result<Loads, SceneError> {
        let number = |own: &(DimensionedNumber, Range<usize>)| {
            to_double_double(&system.shown(&own.0, dimension)).map_err(|error| error.at(own.1.clone()))
        };
        Ok(match self {
            Self::List(list) => Loads::List(list.iter().map(|own| Ok(number(own)?.value())).collect::<Result<_, SceneError>>()?),
            Self::Range { ends, count, logarithmic } => {
                let [start, stop] = ends.as_ref();
                Loads::Range(Steps::new(number(start)?, number(stop)?, *count, *logarithmic))
            }
        })
    }

    /// Returns the numbers of a list, or the two ends of a range.
    fn typed(&self) -> Vec<&(DimensionedNumber, Range<usize>)> {
        match self {
            Self::List(list) => list.iter().collect(),
            Self::Range { ends, .. } => ends.iter().collect(),
        }
    }

    fn span(&self) -> Range<usize> {
        match self {
            Self::List(list) => list.first().map_or(0..0, |own| own.1.clone()),
            Self::Range { ends, .. } => ends[0].1.clone(),
        }
    }
}

/// Reads a number, a list of numbers, or a range.
fn numbers(entry: &Entry<'_>) -> Result<Typed, SceneError> {
    if entry.is_table() {
        let table = entry.table(entry.key().to_owned())?;
        table.allow(&["start", "stop", "count", "spacing"])?;
        let help = "expected { start = \"0.05 um\", stop = \"0.4 um\", count = 8 }";
        let end = |key: &str| -> Result<_, SceneError> {
            let own = table.demand(key, help)?;
            Ok((own.quantity()?, own.span()))
        };
        let (start, stop, count) = (end("start")?, end("stop")?, table.demand("count", help)?.count(MOST_LOADS)?);
        let spacing = table.get("spacing").map(|entry| entry.word(&["linear", "log"])).transpose()?;
        return Ok(Typed::Range { ends: Box::new([start, stop]), count, logarithmic: spacing == Some("log") });
    }
    let Some(list) = entry.list() else { return Ok(Typed::List(vec![(entry.quantity()?, entry.span())])) };
    if list.len() == 0 {
        return Err(SceneError::value(format!("{} is an empty list", entry.key())).help("expected at least one number").at(entry.span()));
    }
    Ok(Typed::List(list.map(|own| Ok((own.quantity()?, own.span()))).collect::<Result<_, SceneError>>()?))
}

/// Reads the requested quantities without duplicates.
fn quantities(entry: &Entry<'_>) -> Result<(Vec<Quantity>, Vec<Quantity>), SceneError> {
    let known: Vec<Quantity> = Quantity::ALL.iter().copied().filter(|own| own.kind() != Kind::Inverse).collect();
    let words: Vec<&str> = known.iter().map(|own| own.key()).collect();
    let help = format!("expected a list of {}", words.join(", "));
    let list = entry.list().ok_or_else(|| SceneError::value("quantities is not a list").help(&help).at(entry.span()))?;
    let (mut data, mut curves) = (Vec::new(), Vec::new());
    let mut any = false;
    for own in list {
        any = true;
        let word = own.word(&words)?;
        let Some(quantity) = known.iter().copied().find(|own| own.key() == word) else { continue };
        let list = if quantity.kind() == Kind::Number { &mut data } else { &mut curves };
        let seen = list.contains(&quantity);
        list.push(quantity);
        if seen {
            return Err(SceneError::value(format!("{word} is requested twice")).at(own.span()));
        }
    }
    if any { Ok((data, curves)) } else { Err(SceneError::value("quantities is an empty list").help(help).at(entry.span())) }
}

fn tolerance(entry: &Entry<'_>) -> Result<f64, SceneError> {
    let value = to_f64(&entry.quantity()?.in_base()).map_err(|error| error.at(entry.span()))?;
    if value > 0.0 && value < 1.0 {
        return Ok(value);
    }
    Err(SceneError::value(format!("tolerance = {value:?} is not between 0 and 1"))
        .help("expected a relative tolerance such as 1e-12")
        .at(entry.span()))
}
