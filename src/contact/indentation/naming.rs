//! Units in which findings name lengths and forces: what is computed stays free of them.

/// The factor from computed numbers to named ones, and the name; without a name the numbers have no unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Naming {
    /// That of lengths.
    pub length: (f64, String),
    /// That of forces.
    pub force: (f64, String),
}

impl Default for Naming {
    fn default() -> Self {
        Self { length: (1.0, String::new()), force: (1.0, String::new()) }
    }
}

impl Naming {
    /// A length.
    pub(super) fn length(&self, own: f64) -> String {
        in_unit(own, &self.length)
    }

    /// A force.
    pub(super) fn force(&self, own: f64) -> String {
        in_unit(own, &self.force)
    }
}

/// A number times the factor of its unit, with its name.
pub fn in_unit(own: f64, (factor, name): &(f64, String)) -> String {
    let value = own * factor;
    if name.is_empty() { format!("{value:?}") } else { format!("{value:?} {name}") }
}
