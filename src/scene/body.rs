//! The materials of a scene: isotropic, transversely isotropic, given by E* alone, or rigid.

use super::system::System;
use super::{Dimension, DimensionedNumber, SceneError};
use crate::contact::{self, ElasticBody, TransverselyIsotropic};
use crate::scene::file::document::Table;
use std::ops::Range;

/// The keys of a material.
pub(super) const KEYS: [&str; 9] = ["E", "nu", "effective_modulus", "C11", "C12", "C13", "C33", "C44", "rigid"];

/// A number with its key and its position in the file.
pub(super) struct Typed {
    key: &'static str,
    quantity: DimensionedNumber,
    span: Range<usize>,
}

/// The material of one body as typed.
pub(super) struct Body {
    pub(super) numbers: Vec<Typed>,
    rigid: bool,
    span: Range<usize>,
    name: String,
}

impl Body {
    /// Creates a body that does not deform.
    pub(super) fn rigid() -> Self {
        Self { numbers: Vec::new(), rigid: true, span: 0..0, name: String::new() }
    }

    /// Reads a material from a table.
    pub(super) fn read(table: &Table<'_>, rigid_unless_given: bool) -> Result<Self, SceneError> {
        let rigid = table.get("rigid").map(|entry| entry.boolean()).transpose()?.unwrap_or(false);
        let mut numbers = Vec::new();
        for key in KEYS.into_iter().filter(|key| *key != "rigid") {
            if let Some(entry) = table.get(key) {
                numbers.push(Typed { key, quantity: entry.quantity()?, span: entry.span() });
            }
        }
        let name = table.name().to_owned();
        let has = |key: &str| numbers.iter().any(|own: &Typed| own.key == key);
        let ways = [rigid, has("E") || has("nu"), has("effective_modulus"), numbers.iter().any(|own| own.key.starts_with('C'))];
        let help = "expected E and nu, or effective_modulus, or C11, C12, C13, C33 and C44, or rigid = true";
        match ways.iter().filter(|way| **way).count() {
            0 if rigid_unless_given => return Ok(Self { numbers, rigid: true, span: table.span(), name }),
            0 => return Err(SceneError::missing(format!("{name} has no elastic constants")).help(help).at(table.span())),
            1 => {}
            _ => return Err(SceneError::value(format!("{name} specifies its elastic constants in two ways")).help(help).at(table.span())),
        }
        let wanted: &[&str] = if ways[1] {
            &["E", "nu"]
        } else if ways[3] {
            &["C11", "C12", "C13", "C33", "C44"]
        } else {
            &[]
        };
        if let Some(missing) = wanted.iter().find(|key| !has(key)) {
            return Err(SceneError::missing(format!("{name} does not specify {missing}")).help(help).at(table.span()));
        }
        Ok(Self { numbers, rigid, span: table.span(), name })
    }

    /// Returns the contribution of this body to E*; infinite if it is rigid.
    pub(super) fn modulus(&self, system: &System) -> Result<f64, SceneError> {
        let number = |key: &str| -> Result<f64, SceneError> {
            let Some(own) = self.numbers.iter().find(|own| own.key == key) else { return Ok(f64::NAN) };
            let dimension = if key == "nu" { Dimension::NONE } else { Dimension::PRESSURE };
            system.number(&own.quantity, dimension, key).map_err(|error| error.at(own.span.clone()))
        };
        let failed = |error: contact::ContactError| match &error {
            contact::ContactError::Material { name, accepted, .. } => {
                let key = name.rsplit(' ').next().unwrap_or(name);
                let typed = self.numbers.iter().find(|own| own.key == key).map_or("", |own| own.quantity.text());
                SceneError::value(format!("{key} = {typed} is out of range")).help(*accepted).at(self.span_of(key))
            }
            _ => SceneError::value(format!("{}: {error}", self.name)).at(self.span.clone()),
        };
        if self.rigid {
            return Ok(f64::INFINITY);
        }
        match self.numbers.first().map(|own| own.key) {
            Some("E") => {
                let body = ElasticBody { young_modulus: number("E")?, poisson_ratio: number("nu")? };
                contact::effective_modulus(body, ElasticBody::RIGID).map_err(failed)
            }
            Some("effective_modulus") => {
                let own = number("effective_modulus")?;
                if own > 0.0 {
                    return Ok(own);
                }
                Err(SceneError::value(format!(
                    "effective_modulus = {} is not positive",
                    self.numbers.first().map_or("", |own| own.quantity.text())
                ))
                .help("expected a positive pressure")
                .at(self.span_of("effective_modulus")))
            }
            _ => {
                let (c11, c12, c13, c33, c44) = (number("C11")?, number("C12")?, number("C13")?, number("C33")?, number("C44")?);
                TransverselyIsotropic { c11, c12, c13, c33, c44 }.effective_modulus().map_err(failed)
            }
        }
    }

    /// Returns false if the body is given by the constants of transverse isotropy.
    pub(super) fn is_isotropic(&self) -> bool {
        self.numbers.iter().all(|own| !own.key.starts_with('C'))
    }

    /// Returns the position of the material, or of its first constant.
    pub(super) fn span(&self) -> Range<usize> {
        self.numbers.first().map_or(self.span.clone(), |own| own.span.clone())
    }

    /// Sets ν to 0, as if E were used in place of E*.
    pub(super) fn forget_poisson(&mut self) -> Result<(), SceneError> {
        for own in self.numbers.iter_mut().filter(|own| own.key == "nu") {
            own.quantity = DimensionedNumber::plain("0")?;
        }
        Ok(())
    }

    fn span_of(&self, key: &str) -> Range<usize> {
        self.numbers.iter().find(|own| own.key == key).map_or(self.span.clone(), |own| own.span.clone())
    }

    /// Returns all numbers with their units.
    pub(super) fn quantities(&self) -> impl Iterator<Item = &DimensionedNumber> {
        self.numbers.iter().map(|own| &own.quantity)
    }
}

/// Returns E* of two bodies, whose compliances add.
pub(super) fn together(one: f64, other: f64, place: Range<usize>) -> Result<f64, SceneError> {
    match (one.is_finite(), other.is_finite()) {
        (true, true) => Ok(1.0 / (1.0 / one + 1.0 / other)),
        (true, false) => Ok(one),
        (false, true) => Ok(other),
        (false, false) => Err(SceneError::value("both bodies are rigid").help("make at least one of the two bodies elastic").at(place)),
    }
}
