//! Generates `docs/side-by-side.md`: the formulas of the source's chapter 3 beside the program's, their sizes and differences.

use crate::chapter::{DERIVATION_STEPS, EQUATIONS, Equation, Ours};
use crate::formulas::{formula, number, relative, typed, value};
use crate::random::Stream;
use sneddon::contact::{Edge, Quantity, TransverselyIsotropic, relations, rim_radius};
use sneddon::expr::{Bindings, Expr, Formula, shown_as_mathematics};
use sneddon::parse;
use sneddon::print::{Presentation, Renaming};
use sneddon::report::Derivation;
use sneddon::report::page::{Format, Page, Style};
use sneddon::transform::{self, Profile};
use std::fmt::Write;

/// The number of points at which two formulas are compared.
const POINTS: usize = 20;

/// Intervals for the names in the formulas; a, b, r and x are drawn inside R.
const RANGES: [(&str, f64, f64); 13] = [
    ("E", 0.5, 9.0),
    ("R", 0.5, 5.0),
    ("theta", 0.3, 1.2),
    ("C", 0.2, 3.0),
    ("n", 0.5, 5.0),
    ("h", 0.05, 0.25),
    ("d", 0.6, 3.0),
    ("C_11", 100.0, 200.0),
    ("C_12", 10.0, 60.0),
    ("C_13", 10.0, 60.0),
    ("C_33", 100.0, 200.0),
    ("C_44", 5.0, 18.0),
    ("d_o", 0.6, 3.0),
];

/// The scene whose modulus (3.65) and (3.70) state; the stiffnesses are those of cobalt.
const SCENE: &str = r#"printf '[profile]\nf = "r^2/(2*R)"\nparameters = { R = "1 mm" }\n[material]\nC11 = "307 GPa"\nC12 = "165 GPa"\nC13 = "103 GPa"\nC33 = "358 GPa"\nC44 = "75 GPa"\n[load]\nforce = "1 N"\n' | sneddon solve -"#;

/// An equation beside its counterpart.
pub struct Compared {
    /// The equation.
    pub equation: &'static Equation,
    /// The command for the counterpart.
    pub command: String,
    /// The counterpart as the program writes it: the equation in LaTeX, then definitions in it; empty for a number.
    pub printed: Vec<String>,
    /// The numbers of leaves and operators, of the chapter's right side and of the program's; `None` for a number.
    pub sizes: Option<[usize; 2]>,
    /// The largest relative difference.
    pub difference: f64,
}

impl Compared {
    /// The program's size over the chapter's.
    fn ratio(&self) -> Option<f64> {
        self.sizes.map(|[theirs, ours]| ours as f64 / theirs as f64)
    }
}

/// Derives and compares every equation.
pub fn compared() -> Vec<Compared> {
    EQUATIONS.iter().map(of_equation).collect()
}

fn of_equation(equation: &'static Equation) -> Compared {
    let theirs = formula(equation.typed);
    let (ours, printed, command) = match &equation.ours {
        Ours::Formula { profile, depth, quantity, logarithms } => {
            let (ours, printed) = derived(profile, *depth, *quantity, *logarithms);
            (Some(ours), printed, command(profile, *depth, *quantity, *logarithms))
        }
        Ours::Modulus => (None, Vec::new(), SCENE.to_owned()),
    };
    let mut stream = Stream::new(equation.number.bytes().map(u64::from).sum());
    let mut difference = 0.0f64;
    for _ in 0..POINTS {
        let mut values = draw(&mut stream);
        let own = ours.as_ref().map_or_else(|| modulus(&values), |ours| value(ours, &values));
        for (name, text) in equation.given {
            values.push((name, typed(text, &values)));
        }
        let found = relative(own, value(&theirs, &values));
        assert!(!found.is_nan(), "{}: not a number at {values:?}", equation.number);
        difference = difference.max(found);
    }
    Compared { equation, command, printed, sizes: ours.map(|ours| [size(&theirs), size(&ours)]), difference }
}

/// One draw of every parameter, with b < a < R and r, x < a.
fn draw(stream: &mut Stream) -> Vec<(&'static str, f64)> {
    let mut values: Vec<_> = RANGES.iter().map(|(name, low, high)| (*name, stream.uniform(*low, *high))).collect();
    let a = number(&Expr::symbol("R"), &values) * stream.uniform(0.3, 0.95);
    let mut inside = |low: f64, high: f64| a * stream.uniform(low, high);
    values.extend([("b", inside(0.1, 0.8)), ("r", inside(0.05, 0.95)), ("x", inside(0.3, 0.99)), ("a", a)]);
    values
}

/// The program's E* of the stiffnesses.
fn modulus(values: &[(&'static str, f64)]) -> f64 {
    let [c11, c12, c13, c33, c44] = ["C_11", "C_12", "C_13", "C_33", "C_44"].map(|name| number(&Expr::symbol(name), values));
    TransverselyIsotropic { c11, c12, c13, c33, c44 }.effective_modulus().unwrap()
}

/// The formula of a quantity as the program shows it, and the equations of `derive --format markdown`.
fn derived(profile: &str, depth: Option<&str>, quantity: Quantity, logarithms: bool) -> (Formula, Vec<String>) {
    let rim = rim_radius();
    let read = if depth.is_some() { parse::punch(profile) } else { parse::profile(profile) };
    let own = read.unwrap().substitute(&Bindings::one("a", Expr::from(rim.clone())));
    let shown = own.substitute(&Bindings::one(rim.name(), Expr::symbol("a")));
    let solution = transform::derive(&Profile::new(&own).unwrap()).unwrap();
    let edge = if depth.is_some() { Edge::Rim(Expr::symbol("d")) } else { Edge::Smooth };
    let relations = relations(&solution, &edge).unwrap();
    let renamed = depth.filter(|name| *name != "d").map(|name| ("d".to_owned(), name.to_owned()));
    let names = Renaming::new(renamed.into_iter().collect());
    let presentation = Presentation { names, logarithms, ..Presentation::of(&shown) };
    let check = transform::check(&solution).map_err(Into::into);
    let asked = [quantity];
    let record = Derivation {
        solution: &solution,
        typed: &shown,
        edge: &edge,
        relations: &relations,
        asked: &asked,
        presentation: &presentation,
        check,
    };
    let mut page = Vec::new();
    Page::of_derivation(&record).write(Format::Markdown, Style::default(), &mut page).unwrap();
    let page = String::from_utf8(page).unwrap();
    // The first equation is f(r).
    let blocks = page.split("```math\n").skip(2).filter_map(|rest| rest.split("\n```").next());
    let formula = record.entries()[0].derived.as_ref().unwrap().formula.clone();
    // The values are drawn for the names that are shown.
    (presentation.formula(&formula), blocks.map(str::to_owned).collect())
}

/// The command that answers with the formula.
fn command(profile: &str, depth: Option<&str>, quantity: Quantity, logarithms: bool) -> String {
    let mut text = format!("sneddon derive '{profile}'");
    if let Some(name) = depth {
        text.push_str(" --depth d");
        if name != "d" {
            let _ = write!(text, " --symbols d={name}");
        }
    }
    if logarithms {
        text.push_str(" --inverse-hyperbolic log");
    }
    let _ = write!(text, " --quantity {} --format markdown", quantity.key());
    text
}

/// The number of leaves and operators in what is printed: of a contact with a flat end only the piece beyond that.
fn size(formula: &Formula) -> usize {
    let printed = match formula {
        Formula::Piecewise { variable, pieces, last } if variable.name() == "a" && matches!(&pieces[..], [(zero, _)] if zero.is_zero()) => {
            last
        }
        other => other,
    };
    printed.expressions().into_iter().map(|own| shown_as_mathematics(own).size_up_to(usize::MAX)).sum()
}

/// The whole document.
pub fn page(compared: &[Compared]) -> String {
    let mut text = String::from("# The chapter's formulas and the program's, side by side\n\n");
    text.push_str(
        "This document is written by `cargo run --release -p sneddon-runs --bin side_by_side > docs/side-by-side.md`; a test checks that it is up to date.\n\n",
    );
    text.push_str("It shows equations of chapter 3 of Popov & Heß as the book prints them, each followed by the command for the program's counterpart and by the formula in its answer.\n");
    text.push_str(
        "[sources.md](sources.md) names the book and lists its misprints, and [theory.md](theory.md) explains the equations.\n\n",
    );
    let worst = compared.iter().map(|own| own.difference).fold(0.0, f64::max);
    let _ = writeln!(
        text,
        "For the comparison the right side of the chapter's equation was typed in the [grammar](grammar.md) of the program, and both formulas were evaluated in double precision at {POINTS} random points.\n\
         The difference is relative to the larger of the two values, and the largest one of all points and equations is {}.\n\
         The points avoid the limits in which the chapter's forms lose their digits: $d$ and $a$ are comparable with $R$.\n",
        short(worst)
    );
    let ratios: Vec<f64> = compared.iter().filter_map(Compared::ratio).collect();
    let longer = ratios.iter().filter(|own| **own > 1.0).count();
    let _ = writeln!(
        text,
        "The size of a formula is the number of leaves and operators on its right side: each number, constant, symbol, sum, product, power and function counts 1 wherever it stands, and a root or a quotient is a power.\n\
         Numeric factors are joined before they are counted, for both formulas in the same way.\n\
         The median of the ratio of the program's size to the chapter's is {:.2} over {} formulas; the program's is larger for {longer} of them.\n",
        median(&ratios),
        ratios.len()
    );
    text.push_str("The names differ in three places: the program writes $F$ for $F_N$, $p = -\\sigma_{zz}$ for the stress, and formulas in $x$ for $x \\ge 0$.\n\n");
    text.push_str("| equation | what it states | size in the chapter | size in the program | ratio | largest difference |\n|---|---|---|---|---|---|\n");
    for own in compared {
        let Equation { number, title, .. } = own.equation;
        let sizes = own
            .sizes
            .map_or_else(|| "— | — | —".to_owned(), |[theirs, ours]| format!("{theirs} | {ours} | {:.2}", ours as f64 / theirs as f64));
        let _ = writeln!(text, "| {number} | {title} | {sizes} | {} |", short(own.difference));
    }
    compared.iter().for_each(|own| section(own, &mut text));
    text.push_str("\n## Definitions and intermediate steps\n");
    for (number, latex, sentence) in DERIVATION_STEPS {
        let _ = writeln!(text, "\n### {number}\n\n```math\n{latex}\n```\n\n{sentence}");
    }
    text
}

fn section(own: &Compared, text: &mut String) {
    let Equation { number, title, latex, note, .. } = own.equation;
    let _ = writeln!(
        text,
        "\n## {number}: {title}\n\nThe chapter:\n\n```math\n{latex}\n```\n\nThe program:\n\n```console\n$ {}\n```\n",
        own.command
    );
    match own.printed.split_first() {
        None => text.push_str("The program has a number here and no formula; $E^{*}$ is the first line of this answer.\n"),
        Some((first, definitions)) => {
            let _ = writeln!(text, "```math\n{first}\n```");
            for block in definitions {
                let _ = writeln!(text, "\nwhere\n\n```math\n{block}\n```");
            }
        }
    }
    if !note.is_empty() {
        let _ = write!(text, "\n{note}\n");
    }
}

fn median(ratios: &[f64]) -> f64 {
    let mut sorted = ratios.to_vec();
    sorted.sort_by(f64::total_cmp);
    let middle = sorted.len() / 2;
    if sorted.len() % 2 == 1 { sorted[middle] } else { (sorted[middle - 1] + sorted[middle]) / 2.0 }
}

fn short(difference: f64) -> String {
    if difference == 0.0 { "0".to_owned() } else { format!("{difference:.0e}") }
}

/// The document without the differences, which depend on the elementary functions of the machine.
pub fn skeleton(page: &str) -> Vec<&str> {
    let is_row = |line: &str| line.starts_with("| (3.");
    page.lines()
        .filter(|line| !line.starts_with("The difference is relative"))
        .map(|line| if is_row(line) { line.trim_end_matches(" |").rsplit_once(" | ").map_or(line, |(rest, _)| rest) } else { line })
        .collect()
}
