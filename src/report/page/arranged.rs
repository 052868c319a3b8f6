//! Equations as an author sets them: a range in place of a piece that is 0, and names for the parts of formulas that are too wide.

use super::{Block, Page, Range, room};
use crate::expr::Formula;
use crate::print::{Names, Notation};

/// Letters that have a meaning in every answer.
const RESERVED: [&str; 16] = ["r", "x", "a", "d", "e", "E", "f", "g", "p", "k", "u", "A", "F", "G", "K", "U"];

impl Page {
    /// The page for a notation that is not parsed: equations without pieces that are 0, and with names for parts of equations that
    /// are wider than `width` letters, which are defined below the last equation, or in a list of steps below the first that contains
    /// them.
    pub(super) fn arranged(&self, notation: Notation, width: usize) -> Self {
        let mut names = Names::avoiding(RESERVED);
        for block in &self.blocks {
            if let Block::Equation { left, right, .. } = block {
                left.split(|c: char| !c.is_alphanumeric() && c != '_').for_each(|own| names.avoid(own));
                names.avoid_symbols(right);
            }
        }
        let unused = names.clone();
        let mut blocks = Vec::with_capacity(self.blocks.len());
        let mut defined = Vec::new();
        for block in &self.blocks {
            let Block::Equation { key, left, right, sources, .. } = block else {
                if self.has_separate_sections && matches!(block, Block::Heading(..)) {
                    names = unused.clone();
                }
                blocks.push(block.clone());
                continue;
            };
            let (right, range) = without_empty_piece(right, &self.radius);
            let (right, parts) = names.shortened(&right, notation, room(left, range.as_ref(), notation, width));
            blocks.push(Block::Equation { key: key.clone(), left: left.clone(), right, range, sources: sources.clone() });
            // One list for all equations, unless they are apart from each other.
            if self.is_text && !parts.is_empty() {
                blocks.push(Block::Where(parts));
            } else {
                defined.extend(parts);
            }
        }
        if !defined.is_empty() {
            let last = blocks.iter().rposition(|own| matches!(own, Block::Equation { .. })).map_or(0, |place| place + 1);
            let uses = |formula: &Formula| formula.symbols().iter().map(|own| own.name().to_owned()).collect::<Vec<_>>();
            let rights = blocks.iter().filter_map(|own| if let Block::Equation { right, .. } = own { Some(right) } else { None });
            let parts = in_order_of_use(rights.flat_map(uses).collect(), defined, uses);
            blocks.insert(last, Block::Where(parts));
        }
        Self { blocks, ..self.clone() }
    }
}

/// Definitions in the order in which the equations, and then the definitions before, use their names.
fn in_order_of_use(
    mut used: Vec<String>,
    mut parts: Vec<(String, Formula)>,
    uses: impl Fn(&Formula) -> Vec<String>,
) -> Vec<(String, Formula)> {
    let mut ordered: Vec<(String, Formula)> = Vec::with_capacity(parts.len());
    loop {
        let (now, later): (Vec<_>, Vec<_>) = parts.into_iter().partition(|own| used.contains(&own.0));
        if now.is_empty() {
            return ordered.into_iter().chain(later).collect();
        }
        used = now.iter().flat_map(|own| uses(&own.1)).collect();
        ordered.extend(now);
        parts = later;
    }
}

/// The last of two pieces over the contact radius with its range, if the first one is 0: a contact is not smaller than a flat end.
fn without_empty_piece(right: &Formula, radius: &str) -> (Formula, Option<Range>) {
    match right {
        Formula::Piecewise { variable, pieces, last } if variable.name() == radius => match pieces.as_slice() {
            [(zero, end)] if zero.is_zero() => {
                let range = Range { variable: variable.name().to_owned(), from: end.clone() };
                (last.as_ref().clone(), Some(range))
            }
            _ => (right.clone(), None),
        },
        _ => (right.clone(), None),
    }
}
