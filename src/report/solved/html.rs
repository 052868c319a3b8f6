//! A solved scene as one self-contained page: verdict, values, plots, formulas, derivation, and how to reproduce it.

use crate::contact::{Severity, Step};
use crate::print::escaped;
use crate::report::Derivation;
use crate::report::digits::Digits;
use crate::report::page::{Format, Page, Style};
use crate::report::picture::{Picture, Pictured};
use crate::report::sheet::SHEET;
use crate::report::solved::bounds::Largest;
use crate::report::solved::text::{cells, columns, edge_of};
use crate::report::solved::{Verdict, assumptions};
use crate::scene::{Dimension, Quantity, Run, Scene};
use std::io::{self, Write};

/// The content of the page.
pub struct Sheet<'a> {
    /// The text of the scene file.
    pub text: &'a str,
    /// The name of the scene file.
    pub name: &'a str,
    /// The solved scene.
    pub run: &'a Run<'a>,
    /// The same scene with loads from 0 to the largest one, for plots.
    pub swept: &'a Run<'a>,
    /// The formulas with their steps, if the profile has any.
    pub formulas: Option<(&'a Derivation<'a>, &'a [Step])>,
}

/// Writes the page.
///
/// # Errors
/// Returns the errors of the writer, and an error if a plot cannot be drawn.
pub fn html(sheet: &Sheet<'_>, formally: bool, out: &mut dyn Write) -> io::Result<Verdict> {
    let run = sheet.run;
    let scene = run.scene();
    let mut verdict = Verdict::default();
    let (mut rows, mut bounds) = (Vec::new(), Largest::default());
    for (index, row) in (0..scene.loads.len()).filter_map(|index| Some((index, run.row(index)?))) {
        verdict.take(&row);
        if row.is_valid() || formally {
            bounds.take(run, index, &row, Digits::default());
        }
        let numbers = cells(run, &row, formally, Digits::default())
            .into_iter()
            .map(|own| own.map_or_else(|| "–".to_owned(), |own| format!("{own:?}")));
        let finding = row.indented.findings.iter().find(|own| own.severity == Severity::Error);
        rows.push((numbers.collect::<Vec<_>>(), edge_of(&row), finding.map_or("valid", |own| own.rule)));
    }
    verdict.close(run);
    let title = format!("Contact of {}", sheet.name);
    writeln!(
        out,
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width\">\n\
         <title>{0}</title>\n<style>{SHEET}</style>\n</head>\n<body>\n<h1>{0}</h1>",
        escaped(&title)
    )?;
    judged(&verdict, run, out)?;
    writeln!(out, "<h2>Numbers</h2>\n<table>\n<thead><tr>")?;
    for (name, unit) in columns(run) {
        let unit = if unit.is_empty() { String::new() } else { format!(" ({})", escaped(&unit)) };
        write!(out, "<th scope=\"col\">{}{unit}</th>", escaped(&name))?;
    }
    writeln!(out, "<th scope=\"col\">edge</th><th scope=\"col\">verdict</th></tr></thead>\n<tbody>")?;
    for (numbers, edge, word) in rows {
        let numbers: String = numbers.iter().map(|own| format!("<td>{own}</td>")).collect();
        writeln!(out, "<tr>{numbers}<td>{edge}</td><td>{word}</td></tr>")?;
    }
    writeln!(out, "</tbody>\n</table>")?;
    if let Some(own) = bounds.sentence() {
        writeln!(out, "<p>{}</p>", escaped(&own))?;
    }
    pictures(sheet.swept, out)?;
    if let Some((record, steps)) = sheet.formulas {
        writeln!(out, "<h2>Formulas</h2>")?;
        Page::of_derivation(record).write(Format::Mathml, Style::default(), out)?;
        writeln!(out, "<details>\n<summary>Derivation, step by step</summary>")?;
        Page::of_steps(record, steps).write(Format::Mathml, Style::default(), out)?;
        writeln!(out, "</details>")?;
    }
    writeln!(out, "<h2>How to reproduce this page</h2>\n<p>The scene:</p>\n<pre>{}</pre>", escaped(sheet.text))?;
    writeln!(
        out,
        "<p><code>sneddon solve {} -o report.html</code>, version {}.</p>\n</body>\n</html>",
        escaped(sheet.name),
        env!("CARGO_PKG_VERSION")
    )?;
    Ok(verdict)
}

/// Writes the verdict with its findings.
fn judged(verdict: &Verdict, run: &Run<'_>, out: &mut dyn Write) -> io::Result<()> {
    let scene = run.scene();
    let modulus = scene.effective_modulus * scene.system.out(Dimension::PRESSURE);
    let word = if verdict.validity() == Some(true) { "passed" } else { "failed" };
    writeln!(out, "<p><strong class=\"{word}\">{}</strong>: {}.</p>", escaped(&verdict.words()), escaped(assumptions(scene)))?;
    writeln!(out, "<p>Effective modulus E* = {modulus:?} {}.</p>", escaped(&scene.system.unit_name(Dimension::PRESSURE)))?;
    if let Some(own) = verdict.regime() {
        writeln!(out, "<p>{}.</p>", escaped(own.sentence(&scene.system).trim_end_matches('.')))?;
    }
    if !verdict.findings().is_empty() {
        writeln!(out, "<ul>")?;
        for (finding, _) in verdict.findings() {
            writeln!(out, "<li>{}: {}</li>", finding.severity.name(), escaped(&finding.message))?;
        }
        writeln!(out, "</ul>")?;
    }
    Ok(())
}

/// What the page of a scene shows: the tip in the surface, the pressure, F(d) and a(d), of which a punch with a cross-section has F(d).
pub fn pictured(scene: &Scene) -> &'static [Pictured] {
    if !scene.round {
        return &[Pictured::Quantity(Quantity::Force)];
    }
    &[Pictured::Section, Pictured::Quantity(Quantity::Pressure), Pictured::Quantity(Quantity::Force), Pictured::Quantity(Quantity::Radius)]
}

fn pictures(swept: &Run<'_>, out: &mut dyn Write) -> io::Result<()> {
    let picture = Picture::of_contacts(&[("", swept)], pictured(swept.scene()));
    writeln!(out, "<h2>Pictures</h2>")?;
    if picture.is_empty() {
        return writeln!(out, "<p>No load has a valid contact, and there is nothing to draw.</p>");
    }
    for svg in picture.svgs().map_err(io::Error::other)? {
        writeln!(out, "<figure>{svg}</figure>")?;
    }
    Ok(())
}
