//! Pages as HTML with MathML: an `article` element, or a complete page.

use super::{Block, Page, Style};
use crate::print::{Notation, Prose, escaped, mathml_equation};
use crate::report::sheet::SHEET;
use std::io::{self, Write};

const NOTATION: Notation = Notation::Mathml;

pub(super) fn write(page: &Page, style: Style, out: &mut dyn Write) -> io::Result<()> {
    if style.standalone {
        writeln!(
            out,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width\">\n\
<title>{0}</title>\n<style>{SHEET}</style>\n</head>\n<body>\n<h1>{0}</h1>",
            escaped(&page.title)
        )?;
    }
    article(page, out)?;
    if style.standalone { writeln!(out, "</body>\n</html>") } else { Ok(()) }
}

fn article(page: &Page, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "<article>")?;
    let mut in_list = false;
    for block in &page.blocks {
        if in_list && !matches!(block, Block::Item(..)) {
            writeln!(out, "</ul>")?;
            in_list = false;
        }
        match block {
            Block::Equation { left, right, range, sources, .. } => {
                writeln!(out, "{}", mathml_equation(left, right, range.as_ref().map(|own| (own.variable.as_str(), &own.from))))?;
                if let Some(sources) = sources.sentence("", escaped) {
                    writeln!(out, "<p class=\"sources\">{}</p>", sources)?;
                }
            }
            Block::Where(parts) => {
                writeln!(out, "<p>where</p>")?;
                for (name, own) in parts {
                    writeln!(out, "{}", mathml_equation(name, own, None))?;
                }
            }
            Block::Sentence(own) | Block::Remark(own) => writeln!(out, "<p>{}.</p>", own.written(NOTATION).trim_end_matches('.'))?,
            Block::Heading(level, title) => {
                let tag = (level + 1).min(6);
                writeln!(out, "<h{tag}>{}</h{tag}>", escaped(title))?;
            }
            Block::Item(_, own) => {
                if !in_list {
                    writeln!(out, "<ul>")?;
                    in_list = true;
                }
                writeln!(out, "<li>{}</li>", own.written(NOTATION))?;
            }
            Block::Table(heads, rows) => {
                let cells = |cells: &[Prose], tag: &str| {
                    cells.iter().map(|own| format!("<{tag}>{}</{tag}>", own.written(NOTATION))).collect::<String>()
                };
                writeln!(out, "<table>\n<thead><tr>{}</tr></thead>\n<tbody>", cells(heads, "th"))?;
                rows.iter().try_for_each(|row| writeln!(out, "<tr>{}</tr>", cells(row, "td")))?;
                writeln!(out, "</tbody>\n</table>")?;
            }
        }
    }
    if in_list {
        writeln!(out, "</ul>")?;
    }
    writeln!(out, "</article>")
}
