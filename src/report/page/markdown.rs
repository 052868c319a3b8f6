//! Pages in Markdown; every formula is a block of mathematics, followed by its sources.

use super::{Block, Page, Style, lines};
use crate::print::{Notation, Prose};
use std::io::{self, Write};

const NOTATION: Notation = Notation::Latex;

pub(super) fn write(page: &Page, style: Style, out: &mut dyn Write) -> io::Result<()> {
    if style.standalone {
        writeln!(out, "# {}\n", page.title)?;
    }
    let mut in_list = false;
    for (place, block) in page.blocks.iter().enumerate() {
        if place > 0 && !(in_list && matches!(block, Block::Item(..))) {
            writeln!(out)?;
        }
        in_list = matches!(block, Block::Item(..));
        match block {
            Block::Equation { left, right, range, sources, .. } => {
                let body = match lines(left, right, range.as_ref(), NOTATION, style.width).as_slice() {
                    [only] => format!("{} = {only}", NOTATION.name(left)),
                    many => {
                        format!("\\begin{{aligned}}\n{} &= {}\n\\end{{aligned}}", NOTATION.name(left), many.join(" \\\\\n&\\quad "))
                    }
                };
                writeln!(out, "```math\n{body}\n```")?;
                if let Some(sources) = sources.sentence("", str::to_owned) {
                    writeln!(out, "\n{sources}")?;
                }
            }
            Block::Where(parts) => {
                let row = |(name, own): &(String, _)| {
                    let own = lines(name, own, None, NOTATION, style.width);
                    format!("{} &= {}", NOTATION.name(name), own.join(" \\\\\n&\\quad "))
                };
                let rows = parts.iter().map(row);
                let rows = rows.collect::<Vec<_>>().join(" \\\\\n");
                writeln!(out, "where\n\n```math\n\\begin{{aligned}}\n{rows}\n\\end{{aligned}}\n```")?;
            }
            Block::Sentence(own) | Block::Remark(own) => writeln!(out, "{}.", markdown(own).trim_end_matches('.'))?,
            Block::Heading(level, title) => writeln!(out, "{} {title}", "#".repeat(level + 1))?,
            Block::Item(_, own) => writeln!(out, "- {}", markdown(own))?,
            Block::Table(heads, rows) => {
                let line = |cells: &[Prose]| {
                    // GitHub reads a vertical line as the end of a cell, also in a formula.
                    let cell = |own: &Prose| own.written_with(NOTATION, escaped).replace("\\mid ", "\\vert ").replace('|', "\\vert ");
                    format!("| {} |", cells.iter().map(cell).collect::<Vec<_>>().join(" | "))
                };
                writeln!(out, "{}\n|{}", line(heads), "---|".repeat(heads.len()))?;
                rows.iter().try_for_each(|row| writeln!(out, "{}", line(row)))?;
            }
        }
    }
    Ok(())
}

/// Returns text with formulas between dollar signs.
fn markdown(prose: &Prose) -> String {
    prose.written_with(NOTATION, escaped)
}

fn escaped(words: &str) -> String {
    words.chars().fold(String::new(), |mut text, letter| {
        if matches!(letter, '\\' | '`' | '*' | '_' | '|' | '<' | '>' | '[' | ']' | '$') {
            text.push('\\');
        }
        text.push(letter);
        text
    })
}
