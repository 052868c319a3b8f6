//! The quantities of a contact: one entry for each, with its key, its formula and its number, for every command and for Python.
//!
//! [`Dimension`] counts lengths and forces, [`Formulas`] is what a formula is made from.

mod dimension;
mod formula;

pub use dimension::Dimension;
pub use formula::Formulas;

use super::problem::over_area;
use super::{Contact, ContactError, Measured, Reason};
use crate::num::{Bounded, Estimate};
use crate::transform::{Derived, Quantities};
use std::borrow::Cow;
use std::f64::consts::PI;

/// The arguments of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A place in the profile, without a load.
    Shape,
    /// The load alone.
    Number,
    /// The load, given by its depth or its force instead of the contact radius.
    Inverse,
    /// A place, and the contact radius.
    Field,
}

/// The properties of a quantity.
struct Record {
    /// The key in commands, scene files and JSON.
    key: &'static str,
    /// The key in the JSON of `derive` and in Python, if it differs.
    relation: Option<&'static str>,
    /// The name, for axes, help and comments.
    title: &'static str,
    /// The left side of its equation.
    left: &'static str,
    /// The symbol of the place, or of the load: r, x, z, a, d or F.
    coordinate: &'static str,
    /// Its powers of length and force.
    dimension: Dimension,
    /// What it is a function of.
    kind: Kind,
    /// Its formula; `None` if it has no explicit one.
    formula: Option<Stated>,
    /// Its value at a place or load and, for a field, a contact radius.
    number: Number,
    /// Its value from depth, force and radius of a load, if they suffice.
    of_state: Option<OfState>,
}

/// A contact of any kind of profile.
type AnyContact<'a> = Contact<'a, dyn Quantities + 'a>;

/// A load, with errors.
#[derive(Clone, Copy, Debug)]
pub struct Loaded {
    /// d.
    pub depth: Estimate,
    /// F.
    pub force: Estimate,
    /// a.
    pub radius: Estimate,
    /// E*.
    pub effective_modulus: Bounded,
}

macro_rules! quantities {
    ($($(#[$text:meta])* $name:ident => $record:expr),+ $(,)?) => {
        /// A quantity of a contact.
        ///
        /// ```
        /// use sneddon::contact::Quantity;
        /// assert_eq!(Quantity::of("p_mean"), Some(Quantity::MeanPressure));
        /// assert_eq!(Quantity::MeanPressure.title(), "mean pressure");
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Quantity {
            $($(#[$text])* $name),+
        }

        impl Quantity {
            /// Every quantity, in the order in which answers list them.
            pub const ALL: &'static [Self] = &[$(Self::$name),+];

            fn record(self) -> &'static Record {
                match self {
                    $(Self::$name => {
                        static RECORD: Record = $record;
                        &RECORD
                    })+
                }
            }
        }
    };
}

quantities! {
    /// f(r), shifted so that f(0) = 0.
    Profile => Record {
        title: "profile",
        formula: Some(|all| Some(all.profile())),
        ..shape("f", "f(r)", "r", Dimension::LENGTH, |contact, r, _| contact.profile(r).map(Ok))
    },
    /// g(x).
    Equivalent => Record {
        title: "equivalent profile",
        formula: Some(|all| Some(Cow::Borrowed(&all.relations.g))),
        ..shape("g", "g(x)", "x", Dimension::LENGTH, |contact, x, _| Ok(Ok(contact.evaluator().equivalent(x)?)))
    },
    /// G(x) = ∫₀ˣ g.
    Integral => Record {
        title: "integral of the equivalent profile",
        formula: Some(|all| Some(all.integral())),
        ..shape("G", "G(x)", "x", Dimension::AREA, |contact, x, _| contact.integral(x).map(Ok))
    },
    /// d(a), the displacement at r = 0.
    Depth => Record {
        title: "indentation depth",
        formula: Some(|all| Some(Cow::Borrowed(&all.relations.d))),
        of_state: Some(|load| Ok(load.depth)),
        ..number("d", "d(a)", "a", Dimension::LENGTH, |contact, a, _| contact.depth(a).map(Ok))
    },
    /// F(a), the normal force.
    Force => Record {
        title: "normal force",
        formula: Some(|all| Some(Cow::Borrowed(&all.relations.force))),
        of_state: Some(|load| Ok(load.force)),
        ..number("F", "F(a)", "a", Dimension::FORCE, |contact, a, _| contact.force(a).map(Ok))
    },
    /// a(d), the contact radius.
    Radius => Record {
        relation: Some("a_of_d"),
        title: "contact radius",
        formula: Some(|all| all.relations.contact_radius_of_depth.as_ref().map(Cow::Borrowed)),
        of_state: Some(|load| Ok(load.radius)),
        ..number("a", "a(d)", "d", Dimension::LENGTH, |contact, d, _| contact.contact_radius(d).map(Ok))
    },
    /// F(d).
    ForceOfDepth => Record {
        title: "normal force",
        formula: Some(|all| all.relations.force_of_depth.as_ref().map(Cow::Borrowed)),
        of_state: Some(|load| Ok(load.force)),
        ..inverse("F_of_d", "F(d)", "d", Dimension::FORCE, |contact, d, _| contact.force_of_depth(d).map(Ok))
    },
    /// k(a) = dF/dd = 2E*a.
    Stiffness => Record {
        title: "stiffness",
        formula: Some(|all| Some(Cow::Borrowed(&all.relations.stiffness))),
        of_state: Some(|load| Ok(load.radius.times(Bounded::exact(2.0) * load.effective_modulus))),
        ..number("k", "k(a)", "a", Dimension::STIFFNESS, |contact, a, _| contact.stiffness(a).map(Ok))
    },
    /// A(a) = πa².
    Area => Record {
        title: "contact area",
        formula: Some(|all| Some(all.area())),
        of_state: Some(|load| Ok(load.radius.times(load.radius.bounded()).times(Bounded::rounded(PI)))),
        ..number("A", "A(a)", "a", Dimension::AREA, |contact, a, _| contact.area(a).map(Ok))
    },
    /// F/(πa²).
    MeanPressure => Record {
        title: "mean pressure",
        formula: Some(|all| Some(all.mean_pressure())),
        of_state: Some(mean_pressure),
        ..number("p_mean", "p_m(a)", "a", Dimension::PRESSURE, |contact, a, _| contact.mean_pressure(a))
    },
    /// U(a), the strain energy.
    Energy => Record {
        title: "strain energy",
        formula: Some(|all| all.energy()),
        ..number("U", "U(a)", "a", Dimension::ENERGY, |contact, a, _| contact.energy(a).map(Ok))
    },
    /// p(r), positive in compression.
    Pressure => Record {
        title: "pressure",
        formula: Some(|all| all.relations.pressure.as_ref().map(Cow::Borrowed)),
        ..field("p", "p(r)", "r", Dimension::PRESSURE, |contact, r, a| contact.pressure(r, a))
    },
    /// u(r), the displacement of the surface, positive inwards.
    Displacement => Record {
        title: "surface displacement",
        formula: Some(|all| all.displacement()),
        ..field("u", "u(r)", "r", Dimension::LENGTH, |contact, r, a| contact.displacement(r, a).map(Ok))
    },
    /// σ_zz(z) on the axis below the surface, negative in compression.
    AxialStress => Record {
        title: "normal stress on the axis",
        formula: Some(|all| all.axial_stress()),
        ..field("sigma_zz", "sigma_zz(z)", "z", Dimension::PRESSURE, |contact, z, a| contact.axial_stress(z, a))
    },
    /// q(x) = E*(d − g(x)), the line load of the one-dimensional model.
    LineLoad => Record {
        title: "line load of the one-dimensional model",
        formula: Some(|all| Some(all.line_load())),
        ..field("q", "q(x)", "x", Dimension::STIFFNESS, |contact, x, a| contact.line_load(x, a).map(Ok))
    },
    /// d − g(x), the displacement of the one-dimensional model.
    LineDisplacement => Record {
        title: "displacement of the one-dimensional model",
        formula: Some(|all| Some(all.line_displacement())),
        ..field("u_1d", "u_1d(x)", "x", Dimension::LENGTH, |contact, x, a| contact.line_displacement(x, a).map(Ok))
    },
    /// a(F).
    RadiusOfForce => Record {
        title: "contact radius",
        of_state: Some(|load| Ok(load.radius)),
        ..inverse("a_of_F", "a(F)", "F", Dimension::LENGTH, |contact, force, _| contact.radius_under_force(force).map(Ok))
    },
    /// d(F).
    DepthOfForce => Record {
        title: "indentation depth",
        of_state: Some(|load| Ok(load.depth)),
        ..inverse("d_of_F", "d(F)", "F", Dimension::LENGTH, |contact, force, _| contact.depth_of_force(force).map(Ok))
    },
}

impl Quantity {
    /// The quantities that `derive` prints by default.
    pub const USUAL: [Self; 7] =
        [Self::Equivalent, Self::Depth, Self::Force, Self::Pressure, Self::Stiffness, Self::Radius, Self::ForceOfDepth];

    /// Returns the quantity with a key, or with the key of a relation; `None` if there is none.
    pub fn of(key: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|own| own.key() == key || own.relation() == key)
    }

    /// The key in commands, scene files and JSON.
    pub fn key(self) -> &'static str {
        self.record().key
    }

    /// The key in the JSON of `derive` and in Python.
    pub fn relation(self) -> &'static str {
        self.record().relation.unwrap_or(self.record().key)
    }

    /// The name, for axes, help and comments.
    pub fn title(self) -> &'static str {
        self.record().title
    }

    /// The left side of its equation; under a rim the depth does not depend on the radius.
    pub fn left(self, has_rim: bool) -> &'static str {
        if has_rim && self == Self::Depth { self.key() } else { self.record().left }
    }

    /// The symbol of the place, or of the load: r, x, z, a, d or F.
    pub fn coordinate(self) -> &'static str {
        self.record().coordinate
    }

    /// Its powers of length and force.
    pub fn dimension(self) -> Dimension {
        self.record().dimension
    }

    /// The dimension of its coordinate.
    pub fn coordinate_dimension(self) -> Dimension {
        if self.coordinate() == "F" { Dimension::FORCE } else { Dimension::LENGTH }
    }

    /// What it is a function of.
    pub fn kind(self) -> Kind {
        self.record().kind
    }

    /// True if its values belong to a place and a contact radius.
    pub fn needs_radius(self) -> bool {
        self.kind() == Kind::Field
    }

    /// False if the quantity has a value without a contact: of the shape, or of a radius alone.
    pub fn needs_contact(self) -> bool {
        self.kind() != Kind::Shape && !matches!(self, Self::Stiffness | Self::Area)
    }

    /// True if `derive` can state a formula for some profiles.
    pub fn has_formula(self) -> bool {
        self.record().formula.is_some()
    }

    /// Its formula; `None` if it has no explicit one.
    pub fn formula<'a>(self, all: &Formulas<'a>) -> Option<Cow<'a, Derived>> {
        self.record().formula.and_then(|formula| formula(all))
    }

    /// Its value at a place or load and, for a field, under a contact of the radius `a`.
    ///
    /// # Errors
    /// Those of the method of [`Contact`] of the same name.
    pub fn number<P: Quantities>(self, contact: &Contact<'_, P>, at: f64, a: f64) -> Result<Measured, ContactError> {
        (self.record().number)(&contact.erased(), at, a)
    }

    /// Its value from depth, force and radius of a load; `None` if they do not suffice.
    pub fn of_state(self, load: &Loaded) -> Option<Result<Estimate, Reason>> {
        self.record().of_state.map(|own| own(load))
    }
}

/// F/(πa²) of a load.
fn mean_pressure(load: &Loaded) -> Result<Estimate, Reason> {
    if load.radius.value == 0.0 {
        return Err(Reason::NoArea);
    }
    let mean = over_area(load.force, load.radius.bounded());
    Ok(mean.resting_on(load.radius.bound))
}

type Stated = for<'a> fn(&Formulas<'a>) -> Option<Cow<'a, Derived>>;
type OfState = fn(&Loaded) -> Result<Estimate, Reason>;
type Number = fn(&AnyContact<'_>, f64, f64) -> Result<Measured, ContactError>;

const fn shape(key: &'static str, left: &'static str, coordinate: &'static str, dimension: Dimension, number: Number) -> Record {
    Record { key, relation: None, title: key, left, coordinate, dimension, kind: Kind::Shape, formula: None, number, of_state: None }
}

const fn number(key: &'static str, left: &'static str, coordinate: &'static str, dimension: Dimension, number: Number) -> Record {
    Record { kind: Kind::Number, ..shape(key, left, coordinate, dimension, number) }
}

const fn field(key: &'static str, left: &'static str, coordinate: &'static str, dimension: Dimension, number: Number) -> Record {
    Record { kind: Kind::Field, ..shape(key, left, coordinate, dimension, number) }
}

const fn inverse(key: &'static str, left: &'static str, coordinate: &'static str, dimension: Dimension, number: Number) -> Record {
    Record { kind: Kind::Inverse, ..shape(key, left, coordinate, dimension, number) }
}
