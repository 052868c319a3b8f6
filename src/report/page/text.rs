//! Pages as plain text for a terminal.

use super::{Block, Page, Style, lines};
use crate::print::Notation;
use std::io::{self, Write};

/// Writes equations with their sources below; a heading indents its content.
pub(super) fn write(page: &Page, notation: Notation, style: Style, out: &mut dyn Write) -> io::Result<()> {
    let mut indent = 0;
    for (place, block) in page.blocks.iter().enumerate() {
        let space = " ".repeat(indent);
        match block {
            Block::Equation { left, right, range, sources, .. } => {
                if place > 0 && !page.is_text {
                    writeln!(out)?;
                }
                let start = format!("{space}{} = ", notation.name(left));
                let continued = format!("\n{}", " ".repeat(start.chars().count()));
                let width = style.width.map(|width| width.saturating_sub(indent));
                writeln!(out, "{start}{}", lines(left, right, range.as_ref(), notation, width).join(&continued))?;
                if let Some(sources) = sources.line() {
                    writeln!(out, "{}{sources}", if page.is_text { &space } else { "       " })?;
                }
            }
            Block::Where(parts) => {
                for (place, (name, own)) in parts.iter().enumerate() {
                    let start = format!("{space}{} {} = ", if place == 0 { "where" } else { "     " }, notation.name(name));
                    let continued = format!("\n{}", " ".repeat(start.chars().count()));
                    let width = style.width.map(|width| width.saturating_sub(indent + 6));
                    writeln!(out, "{start}{}", lines(name, own, None, notation, width).join(&continued))?;
                }
            }
            Block::Sentence(sentence) => {
                if page.is_text {
                    let room = style.width.unwrap_or(100).saturating_sub(indent).max(20);
                    filled(&sentence.written(notation), room).iter().try_for_each(|line| writeln!(out, "{space}{line}"))?;
                } else {
                    writeln!(out, "\n{}", sentence.written(notation))?;
                }
            }
            Block::Remark(remark) => writeln!(out, "       {}", remark.written(notation))?,
            Block::Heading(level, title) => {
                let outer = " ".repeat(3 * level.saturating_sub(1));
                if place > 0 {
                    writeln!(out)?;
                }
                writeln!(out, "{outer}{title}")?;
                indent = if page.is_text { 3 * level } else { 2 };
            }
            Block::Item(_, item) => writeln!(out, "{space}{}", item.written(notation))?,
            Block::Table(heads, rows) => {
                let cells: Vec<Vec<String>> =
                    std::iter::once(heads).chain(rows).map(|row| row.iter().map(|own| own.written(notation)).collect()).collect();
                let breadth =
                    |column: usize| cells.iter().filter_map(|row| row.get(column)).map(|own| own.chars().count()).max().unwrap_or(0);
                let widths: Vec<usize> = (0..heads.len()).map(breadth).collect();
                for row in &cells {
                    let line: Vec<String> = row.iter().zip(&widths).map(|(own, width)| format!("{own:>width$}")).collect();
                    writeln!(out, "{space}{}", line.join("  "))?;
                }
            }
        }
    }
    Ok(())
}

/// Wraps text into lines of at most this many characters.
fn filled(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut().filter(|line| line.chars().count() + 1 + word.chars().count() <= width) {
            Some(line) => {
                line.push(' ');
                line.push_str(word);
            }
            None => lines.push(word.to_owned()),
        }
    }
    lines
}
