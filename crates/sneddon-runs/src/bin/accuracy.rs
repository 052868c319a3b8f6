//! Writes `docs/accuracy.md`: `cargo run --release -p sneddon-runs --bin accuracy -- [STATEMENTS.csv] [PROFILES.txt]
//! [ESTIMATES.txt] > docs/accuracy.md`.
//!
//! STATEMENTS.csv is the output of `tests/oracle/statements.py`, with any number of points per rule (default: the committed
//! table); PROFILES.txt and ESTIMATES.txt are the outputs of `cargo run --release -p sneddon-runs --bin random_profiles` and
//! `--bin random_estimates`.

use sneddon::expr::{Function, function::Accuracy};
use sneddon_checks::accuracy::{measure, tally};
use sneddon_checks::functions::measure as measured_functions;
use std::error::Error;
use std::fs;

fn main() -> Result<(), Box<dyn Error>> {
    let mut paths = std::env::args().skip(1);
    let statements = paths.next().unwrap_or_else(|| "tests/oracle/statements.csv".to_owned());
    println!("# Accuracy\n");
    println!("This document is written by `cargo run --release -p sneddon-runs --bin accuracy`; its figures are measured, not promised.\n");
    println!("An ulp is the distance from the true value to the next double.\n");
    rules(&fs::read_to_string(statements)?);
    functions()?;
    if let Some(path) = paths.next() {
        println!("\n## Random profiles\n");
        println!("Profiles are drawn over the whole grammar: sums, products, nested kernels, segments, odd parameters.");
        println!(
            "Every formula that is closed, wholly or in part, is compared with quadrature of the profile as typed, and what is printed is read back and compared too."
        );
        println!("They agree where the difference is within the sum of both estimates and 1e-12 of the value.\n");
        println!("```text\n{}\n```\n", fs::read_to_string(path)?.trim_end());
        println!("The command is `cargo run --release -p sneddon-runs --bin random_profiles -- 100000`; a sample runs with the tests.\n");
        println!(
            "Slices with many points close together: `PROFILES=20000 cargo test --release --test values dense_slices` finds no value by polynomials that is off by more than 0.75 units in the last place."
        );
    }
    if let Some(path) = paths.next() {
        println!("\n## Estimates of quadrature\n");
        println!(
            "The same random profiles, wherever they have a closed form: f, g, G, F, p and u at random places, by quadrature at random tolerances from 1e-2 to 1e-14."
        );
        println!("The places are ordinary ones, tiny ones, ones just beyond a breakpoint and ones next to the end of the profile.\n");
        println!("```text\n{}\n```\n", fs::read_to_string(path)?.trim_end());
        println!(
            "The command is `cargo run --release -p sneddon-runs --bin random_estimates -- 60000 14000000`; a sample runs with the tests.\n"
        );
        println!(
            "Closures of eight families with known g, by `abel` and by `AbelTransform`: `CASES=1000000 cargo test --release --test values the_estimate` finds no error larger than its estimate."
        );
    }
    Ok(())
}

/// The table of the rules.
fn rules(text: &str) {
    let figures = tally(&measure(text));
    let places: usize = figures.values().map(|own| own.count).sum();
    println!("## Rules\n");
    println!("{places} random places: ordinary ones, radii from 1e-8 up to sixty, radii within 1e-6 of a breakpoint.");
    println!("References have 30 digits: the rule's stated formula at 50 and at 75 digits, after it was checked against its definition.");
    println!("*Largest* and *mean* are errors in ulps over the condition number of the place, where that exceeds 1;");
    println!("*unscaled* is the largest error in ulps; *estimate* is the largest ratio of the error to its estimate;");
    println!("*integrated* counts places where the closed form lost too many digits and quadrature was used.\n");
    println!("| rule | quantity | places | largest | mean | unscaled | estimate | integrated |\n|---|---|---|---|---|---|---|---|");
    for ((rule, quantity), own) in &figures {
        println!(
            "| {rule} | {quantity} | {} | {:.2} | {:.2} | {:.1} | {:.2} | {} |",
            own.count, own.largest, own.mean, own.plain, own.honesty, own.integrated
        );
    }
}

/// The table of the functions.
fn functions() -> Result<(), Box<dyn Error>> {
    let tables = ["special", "waves", "hypergeometric", "functions", "forms"];
    let texts = tables.map(|table| fs::read_to_string(format!("tests/oracle/{table}.csv"))).into_iter().collect::<Result<Vec<_>, _>>()?;
    let figures = measured_functions(texts.iter().map(String::as_str))?;
    println!("\n## Functions\n");
    println!("Doubles against references of 30 digits or more, extremes of the domain included.\n");
    println!("The last column gives the ground of the bound: *measured* is twice the largest error found, which this table records;");
    println!(
        "*bounded* is a rounded 30-digit value with a bound that includes cancellation, refused if it exceeds the bound in the table.\n"
    );
    println!("| function | places | largest error, ulp | mean error, ulp | bound, ulp | ground |\n|---|---|---|---|---|---|");
    for (name, own) in figures {
        let row = Function::named(name).ok_or("no such function")?.row();
        let ground = match row.accuracy {
            Accuracy::Exact => "exact",
            Accuracy::Bounded(_) => "bounded",
            Accuracy::Measured(_) => "measured",
            Accuracy::Defined(_) => "defined",
        };
        println!("| `{name}` | {} | {:.2} | {:.2} | {} | {ground} |", own.count, own.largest, own.mean, row.ulps());
    }
    Ok(())
}
