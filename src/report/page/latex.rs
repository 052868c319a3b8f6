//! Pages in LaTeX: equations with everything else as comments, or as text, or a complete document.

use super::sources::BOOK;
use super::{Block, Page, Style, lines};
use crate::expr::Formula;
use crate::print::{self, Notation, Prose};
use std::io::{self, Write};

const NOTATION: Notation = Notation::Latex;

pub(super) fn write(page: &Page, style: Style, out: &mut dyn Write) -> io::Result<()> {
    if style.standalone {
        writeln!(out, "{PREAMBLE}\n\\begin{{document}}\n\n\\section*{{{}}}", print::latex_words(&page.title))?;
        text(page, style, out)?;
        writeln!(out, "\n{BIBLIOGRAPHY}\n\\end{{document}}")
    } else if page.is_text {
        text(page, style, out)
    } else {
        fragment(page, style, out)
    }
}

/// The preamble of every document; the fonts contain the letters of the names in the sources, and are outlines where they are installed.
const PREAMBLE: &str = "\\documentclass[10pt]{article}
\\usepackage[T1]{fontenc}
\\IfFileExists{lmodern.sty}{\\usepackage{lmodern}}{}
\\usepackage[utf8]{inputenc}
\\usepackage{amsmath,amssymb}
\\allowdisplaybreaks
\\emergencystretch=3em";

const BIBLIOGRAPHY: &str = "\\begin{thebibliography}{9}
\\bibitem{PopovHess2015} V.~L. Popov and M. He\\ss, \\emph{Method of Dimensionality Reduction in Contact Mechanics and Friction},
Springer, Berlin, Heidelberg, 2015. The numbers of equations refer to its chapter~3.
\\bibitem{sneddon} \\emph{sneddon}, a symbolic and numeric transform engine for contact mechanics.
\\end{thebibliography}
% The same for BibTeX:
% @book{PopovHess2015,
%   author = {Popov, Valentin L. and He{\\ss}, Markus},
%   title = {Method of Dimensionality Reduction in Contact Mechanics and Friction},
%   publisher = {Springer}, address = {Berlin, Heidelberg}, year = {2015}
% }
% @software{sneddon, title = {sneddon}, note = {symbolic and numeric transform engine for contact mechanics}}";

/// Behind the authors of the book.
const CITATION: &str = "~\\cite{PopovHess2015}";

/// Writes comments, then one block of aligned equations.
fn fragment(page: &Page, style: Style, out: &mut dyn Write) -> io::Result<()> {
    let (mut rows, mut tables) = (Vec::new(), Vec::new());
    let comment = |own: &Prose| own.written(NOTATION);
    for block in &page.blocks {
        match block {
            Block::Equation { left, right, range, .. } => {
                rows.push(format!(
                    "  {} &= {}",
                    NOTATION.name(left),
                    lines(left, right, range.as_ref(), NOTATION, style.width).join(CONTINUED)
                ));
            }
            Block::Where(parts) => rows.extend(parts.iter().enumerate().map(|(place, part)| {
                let lead = if place == 0 { "  \\intertext{where}\n" } else { "" };
                format!("{lead}{}", definition(part, style))
            })),
            Block::Item("check", item) => writeln!(out, "% check against quadrature: {}", comment(item))?,
            Block::Item("condition", item) => writeln!(out, "% condition: {}", comment(item))?,
            Block::Item(_, own) | Block::Sentence(own) | Block::Remark(own) => writeln!(out, "% {}", comment(own))?,
            Block::Heading(..) => {}
            Block::Table(heads, own) => tables.push((heads, own)),
        }
    }
    writeln!(out, "\\begin{{align*}}\n{}\n\\end{{align*}}", rows.join(" \\\\\n"))?;
    tables.into_iter().try_for_each(|(heads, rows)| table(heads, rows, out))
}

/// Writes a table whose columns are aligned to the right.
fn table(heads: &[Prose], rows: &[Vec<Prose>], out: &mut dyn Write) -> io::Result<()> {
    let line = |cells: &[Prose]| cells.iter().map(|own| own.written(NOTATION)).collect::<Vec<_>>().join(" & ");
    writeln!(out, "\\begin{{center}}\n\\begin{{tabular}}{{{}}}\n\\hline\n{} \\\\\n\\hline", "r".repeat(heads.len()), line(heads))?;
    rows.iter().try_for_each(|row| writeln!(out, "{} \\\\", line(row)))?;
    writeln!(out, "\\hline\n\\end{{tabular}}\n\\end{{center}}")
}

/// Between the lines of one equation.
const CONTINUED: &str = " \\\\\n  &\\quad ";

/// The row that defines the name of a part.
fn definition((name, own): &(String, Formula), style: Style) -> String {
    format!("  {} &= {}", NOTATION.name(name), lines(name, own, None, NOTATION, style.width).join(CONTINUED))
}

fn text(page: &Page, style: Style, out: &mut dyn Write) -> io::Result<()> {
    let mut in_list = false;
    for block in &page.blocks {
        if in_list && !matches!(block, Block::Item(..)) {
            writeln!(out, "\\end{{itemize}}")?;
            in_list = false;
        }
        match block {
            Block::Equation { key, left, right, range, sources } => {
                let label = if key.is_empty() { String::new() } else { format!("\\label{{eq:{}{key}}}", page.mark) };
                equation(&label, &NOTATION.name(left), &lines(left, right, range.as_ref(), NOTATION, style.width), out)?;
                // Only a complete document has the entry that is cited.
                let citation = if style.standalone { CITATION } else { "" };
                if let Some(sources) = sources.sentence(citation, print::latex_words) {
                    writeln!(out, "\\noindent{{\\footnotesize {sources}}}\\par")?;
                }
            }
            Block::Where(parts) => {
                let rows: Vec<String> = parts.iter().map(|part| definition(part, style)).collect();
                writeln!(out, "\\noindent where\n\\begin{{align*}}\n{}\n\\end{{align*}}", rows.join(" \\\\\n"))?;
            }
            Block::Sentence(own) | Block::Remark(own) => {
                let (words, book) = (own.written(NOTATION), print::latex_words(BOOK));
                let words = if style.standalone { words.replacen(&book, &format!("{book}{CITATION}"), 1) } else { words };
                writeln!(out, "\n\\noindent {}.", words.trim_end_matches('.'))?;
            }
            Block::Heading(level, title) => {
                let command = ["subsection*", "subsubsection*", "paragraph"].get(level.saturating_sub(1)).unwrap_or(&"paragraph");
                writeln!(out, "\n\\{command}{{{}}}", print::latex_words(title))?;
            }
            Block::Item(_, own) => {
                if !in_list {
                    writeln!(out, "\\begin{{itemize}}")?;
                    in_list = true;
                }
                writeln!(out, "\\item {}", own.written(NOTATION))?;
            }
            Block::Table(heads, rows) => table(heads, rows, out)?,
        }
    }
    if in_list { writeln!(out, "\\end{{itemize}}") } else { Ok(()) }
}

/// Writes an equation, numbered if it has a label.
fn equation(label: &str, left: &str, right: &[String], out: &mut dyn Write) -> io::Result<()> {
    let body = match right {
        [only] => format!("{left} = {only}"),
        many => format!("\\begin{{split}}\n{left} &= {}\n\\end{{split}}", many.join(" \\\\\n&\\quad ")),
    };
    let star = if label.is_empty() { "*" } else { "" };
    writeln!(out, "\\begin{{equation{star}}}{label}\n{body}\n\\end{{equation{star}}}")
}
