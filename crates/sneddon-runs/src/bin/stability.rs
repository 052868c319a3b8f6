//! Writes `docs/stability.md`: `cargo run --release -p sneddon-runs --bin stability -- [RANDOM_SCENES.txt] > docs/stability.md`.
//!
//! RANDOM_SCENES.txt is the output of `cargo run --release -p sneddon-runs --bin random_scenes`.

use sneddon_checks::stability::cells;
use sneddon_checks::stability::page::page;
use std::error::Error;
use std::fs;

fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", page(&cells(&fs::read_to_string("tests/oracle/extremes.csv")?, 1)));
    if let Some(path) = std::env::args().nth(1) {
        println!("\n## Random scenes\n");
        println!("Scenes are drawn with a seed: named shapes and formulas, materials, loads, cylinders, units.");
        println!(
            "Every result must satisfy the laws of contact: dF/dd = 2E*a, F = 2π∫p r dr, the transform and its inverse, scaling of lengths and moduli, superposition, and the spring foundation.\n"
        );
        println!("```text\n{}\n```\n", fs::read_to_string(path)?.trim_end());
        println!("The command is `cargo run --release -p sneddon-runs --bin random_scenes -- 100000`; a sample runs with the tests.");
    }
    Ok(())
}
