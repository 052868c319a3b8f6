//! Pages in Typst: markup that compiles as a document or inside another document.

use super::{Block, COLUMN, Page, Style, lines};
use crate::print::{Notation, Prose};
use std::io::{self, Write};

const NOTATION: Notation = Notation::Typst;

/// The beginning of every document.
const PREAMBLE: &str = "#set page(margin: 3cm)\n#set text(size: 10pt)\n#set math.equation(numbering: \"(1)\")\n#show math.equation: set block(breakable: true)\n";

pub(super) fn write(page: &Page, style: Style, out: &mut dyn Write) -> io::Result<()> {
    if style.standalone {
        writeln!(out, "{PREAMBLE}\n= {}\n", page.title)?;
    }
    let width = style.width.or(style.standalone.then_some(COLUMN));
    for block in &page.blocks {
        match block {
            Block::Equation { key, left, right, range, sources } => {
                let label = if style.standalone && !key.is_empty() { format!(" <eq-{key}>") } else { String::new() };
                match lines(left, right, range.as_ref(), NOTATION, width).as_slice() {
                    [only] => writeln!(out, "$ {} = {only} ${label}", NOTATION.name(left))?,
                    many => writeln!(out, "$ {} &= {} ${label}", NOTATION.name(left), many.join(" \\\n  &quad "))?,
                }
                if let Some(sources) = sources.sentence("", |words| Prose::words(words).written(NOTATION)) {
                    writeln!(out, "{sources}\n")?;
                }
            }
            Block::Where(parts) => {
                let row = |(name, own): &(String, _)| {
                    format!("{} &= {}", NOTATION.name(name), lines(name, own, None, NOTATION, width).join(" \\\n  &quad "))
                };
                let rows = parts.iter().map(row);
                writeln!(out, "where\n#math.equation(block: true, numbering: none, $ {} $)\n", rows.collect::<Vec<_>>().join(" \\\n  "))?;
            }
            Block::Sentence(own) | Block::Remark(own) => writeln!(out, "{}.\n", own.written(NOTATION).trim_end_matches('.'))?,
            Block::Heading(level, title) => writeln!(out, "\n{} {title}", "=".repeat(level + 1))?,
            Block::Item(_, own) => writeln!(out, "- {}", own.written(NOTATION))?,
            Block::Table(heads, rows) => {
                let line = |cells: &[Prose]| cells.iter().map(|own| format!("[{}]", own.written(NOTATION))).collect::<Vec<_>>().join(", ");
                writeln!(out, "#table(columns: {}, align: right, table.header({}),", heads.len(), line(heads))?;
                rows.iter().try_for_each(|row| writeln!(out, "  {},", line(row)))?;
                writeln!(out, ")\n")?;
            }
        }
    }
    if style.standalone {
        writeln!(
            out,
            "\nEquation numbers in parentheses refer to V. L. Popov and M. Heß, _Method of Dimensionality Reduction in Contact Mechanics and Friction_, Springer, 2015, chapter 3."
        )?;
    }
    Ok(())
}
