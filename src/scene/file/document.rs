//! A scene file as TOML with positions: tables whose keys are checked, and values whose types are checked.

use crate::scene::error::Reason;
use crate::scene::{DimensionedNumber, SceneError};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Maximum size of a scene file, in bytes.
pub const LONGEST: usize = 1 << 24;

/// The tables of a scene.
pub(in crate::scene) const TABLES: [&str; 7] = ["profile", "material", "counterbody", "load", "outputs", "method", "data"];

/// Parses the text of a scene file.
///
/// # Errors
/// [`SceneError`] with the position if it is not valid TOML.
pub(in crate::scene) fn parsed(text: &str) -> Result<Spanned<DeTable<'_>>, SceneError> {
    if text.len() > LONGEST {
        return Err(SceneError::value(format!("the scene has {} bytes, the limit is {LONGEST}", text.len())));
    }
    DeTable::parse(text).map_err(|error| {
        let message = error.message().trim().replace('\n', "; ");
        let fault = |message: String, help: &str| SceneError::new(Reason::Syntax(message)).help(help);
        let example = "expected a scene file, and data only after it; `sneddon scene new sphere` creates an example";
        let quoted = "put formulas and numbers with units in quotes, as in R = \"5 um\"";
        // Do not quote a file that is not a scene; it may be confidential.
        let opens = |line: &str, table: &str| {
            let rest = line.trim_start().strip_prefix('[').and_then(|own| own.strip_prefix(table));
            rest.is_some_and(|own| own.trim_start().is_empty() || own.trim_start().starts_with(']'))
        };
        let is_scene = text.lines().any(|line| TABLES.iter().any(|table| opens(line, table)));
        match error.span() {
            Some(span) if is_scene => fault(message.clone(), if message.contains("quoted") { quoted } else { example }).at(span),
            Some(span) => {
                let line = text.get(..span.start).unwrap_or(text).matches('\n').count() + 1;
                fault(format!("{message}, in line {line}"), example)
            }
            None => fault(message, example),
        }
    })
}

/// A table of the file with its name.
pub(in crate::scene) struct Table<'t> {
    name: String,
    entries: &'t DeTable<'t>,
    span: Range<usize>,
    text: &'t str,
}

/// A value with its key.
pub(in crate::scene) struct Entry<'t> {
    key: String,
    value: &'t Spanned<DeValue<'t>>,
    text: &'t str,
}

impl<'t> Table<'t> {
    /// Returns the whole file as a table.
    pub(in crate::scene) fn root(document: &'t Spanned<DeTable<'t>>, text: &'t str) -> Self {
        Self { name: "the scene".to_owned(), entries: document.get_ref(), span: 0..0, text }
    }

    /// Returns an error for the first unknown key, with the nearest known key.
    pub(in crate::scene) fn allow(&self, known: &[&str]) -> Result<(), SceneError> {
        for key in self.entries.keys() {
            let own: &str = key.get_ref();
            if known.contains(&own) {
                continue;
            }
            let error = SceneError::new(Reason::UnknownKey { key: own.chars().take(60).collect(), table: self.name.clone() });
            let nearest = nearest(own, known);
            let help = match nearest {
                Some(near) => format!("did you mean {near}? expected one of {}", known.join(", ")),
                None => format!("expected one of {}", known.join(", ")),
            };
            return Err(error.help(help).at(key.span()));
        }
        Ok(())
    }

    /// Returns the value of a key.
    pub(in crate::scene) fn get(&self, key: &str) -> Option<Entry<'t>> {
        let value = self.entries.get(key)?;
        Some(Entry { key: key.to_owned(), value, text: self.text })
    }

    /// Returns the value of a required key.
    pub(in crate::scene) fn demand(&self, key: &str, help: &str) -> Result<Entry<'t>, SceneError> {
        let missing = || SceneError::missing(format!("{} has no {key}", self.name)).help(help).at(self.span.clone());
        self.get(key).ok_or_else(missing)
    }

    /// Returns the table of a key.
    pub(in crate::scene) fn table(&self, key: &str) -> Result<Option<Table<'t>>, SceneError> {
        self.get(key).map(|entry| entry.table(format!("[{key}]"))).transpose()
    }

    /// Returns all keys with their values.
    pub(in crate::scene) fn entries(&self) -> impl Iterator<Item = Entry<'t>> {
        self.entries.iter().map(|(key, value)| Entry { key: key.get_ref().to_string(), value, text: self.text })
    }

    /// Returns the position of the table.
    pub(in crate::scene) fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// Returns the position of the key itself.
    pub(in crate::scene) fn key_span(&self, key: &str) -> Range<usize> {
        self.entries.keys().find(|own| own.get_ref() == key).map_or(self.span.clone(), Spanned::span)
    }

    /// Returns the name of the table in error messages.
    pub(in crate::scene) fn name(&self) -> &str {
        &self.name
    }
}

/// Returns the known word closest to the given one: one edit away, or mostly equal.
pub(in crate::scene) fn nearest<'k>(word: &str, known: &[&'k str]) -> Option<&'k str> {
    let word: String = word.chars().take(60).collect::<String>().to_lowercase();
    let likeness = |own: &str| {
        let own = own.to_lowercase();
        let slips = strsim::damerau_levenshtein(&word, &own);
        let alike = strsim::jaro_winkler(&word, &own);
        if slips <= 1 && word.len().max(own.len()) > 1 { 1.0 + alike } else { alike }
    };
    let rated = known.iter().map(|own| (*own, likeness(own))).filter(|(_, own)| *own > 0.75);
    rated.max_by(|one, other| one.1.total_cmp(&other.1)).map(|(own, _)| own)
}

impl<'t> Entry<'t> {
    /// Returns the key.
    pub(in crate::scene) fn key(&self) -> &str {
        &self.key
    }

    /// Returns the bytes of the value.
    pub(in crate::scene) fn span(&self) -> Range<usize> {
        self.value.span()
    }

    fn kind(&self, expected: &'static str) -> SceneError {
        let found = match self.value.get_ref() {
            DeValue::String(_) => "a string",
            DeValue::Integer(_) | DeValue::Float(_) => "a number",
            DeValue::Boolean(_) => "true or false",
            DeValue::Datetime(_) => "a date",
            DeValue::Array(_) => "a list",
            DeValue::Table(_) => "a table",
        };
        SceneError::new(Reason::Kind { key: self.key.clone(), found, expected }).at(self.span())
    }

    /// Reads a string.
    pub(in crate::scene) fn string(&self) -> Result<&'t str, SceneError> {
        self.value.get_ref().as_str().ok_or_else(|| self.kind("a string"))
    }

    /// Returns the position of a part of a string, or of the whole value if the string contains escapes.
    pub(in crate::scene) fn part(&self, part: Range<usize>) -> Range<usize> {
        let own = self.span();
        let inner = own.start + 1..own.end.saturating_sub(1);
        match (self.text.get(inner.clone()), self.value.get_ref().as_str()) {
            (Some(typed), Some(read)) if typed == read => inner.start + part.start..inner.start + part.end,
            _ => own,
        }
    }

    /// Reads a boolean.
    pub(in crate::scene) fn boolean(&self) -> Result<bool, SceneError> {
        self.value.get_ref().as_bool().ok_or_else(|| self.kind("true or false"))
    }

    /// Reads a table, with the name to use in error messages.
    pub(in crate::scene) fn table(&self, name: String) -> Result<Table<'t>, SceneError> {
        let entries = self.value.get_ref().as_table().ok_or_else(|| self.kind("a table"))?;
        Ok(Table { name, entries, span: self.span(), text: self.text })
    }

    /// Returns true if the value is a table.
    pub(in crate::scene) fn is_table(&self) -> bool {
        self.value.get_ref().is_table()
    }

    /// Returns the values of a list.
    pub(in crate::scene) fn list(&self) -> Option<impl ExactSizeIterator<Item = Entry<'t>>> {
        let array = self.value.get_ref().as_array()?;
        let (key, text) = (self.key.clone(), self.text);
        Some(array.iter().map(move |value| Entry { key: key.clone(), value, text }))
    }

    /// Reads a number, either bare or in a string with its unit.
    pub(in crate::scene) fn quantity(&self) -> Result<DimensionedNumber, SceneError> {
        let read = match self.value.get_ref() {
            DeValue::String(text) => DimensionedNumber::parse(text),
            DeValue::Integer(number) if number.radix() == 10 => DimensionedNumber::plain(number.as_str()),
            DeValue::Float(number) => DimensionedNumber::plain(number.as_str()),
            _ => return Err(self.kind("a number, or a string with a number and its unit")),
        };
        read.map_err(|error| error.at(self.span()))
    }

    /// Reads a whole number from 1 to `most`.
    pub(in crate::scene) fn count(&self, most: usize) -> Result<usize, SceneError> {
        let number = self.value.get_ref().as_integer().ok_or_else(|| self.kind("a whole number"))?;
        let read: Option<usize> = (number.radix() == 10).then(|| number.as_str().parse().ok()).flatten();
        match read {
            Some(count) if count >= 1 && count <= most => Ok(count),
            _ => {
                Err(SceneError::value(format!("{} = {} is not a whole number from 1 to {most}", self.key, number.as_str())).at(self.span()))
            }
        }
    }

    /// Reads one of the known words.
    pub(in crate::scene) fn word(&self, known: &[&'static str]) -> Result<&'static str, SceneError> {
        let own = self.string()?;
        known.iter().copied().find(|word| *word == own).ok_or_else(|| {
            let near = nearest(own, known).map_or(String::new(), |near| format!("did you mean {near}? "));
            let shown: String = own.chars().take(60).collect();
            SceneError::value(format!("{} = {shown:?} is not known", self.key))
                .help(format!("{near}expected one of {}", known.join(", ")))
                .at(self.span())
        })
    }
}
