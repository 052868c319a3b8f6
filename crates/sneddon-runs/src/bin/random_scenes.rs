//! The long run over random scenes: `cargo run --release -p sneddon-runs --bin random_scenes -- [COUNT] [FIRST SEED]`.
//!
//! Violations of a law are printed and make the run fail; `docs/stability.md` contains the figures of a long run.

use sneddon_checks::laws::{LAWS, Tally, examine};
use sneddon_checks::seeds::{asked, over_seeds};
use std::process::ExitCode;

fn main() -> ExitCode {
    let (count, first) = asked(1_000);
    let run = |seed| {
        let own = examine(seed);
        for fault in &own.faults {
            println!("seed {seed}: {fault}");
        }
        own
    };
    let total = over_seeds((count, first), run, Tally::add);
    println!("{:<34}{first} to {}", "seeds", first + count - 1);
    println!("{:<34}{}", "scenes", total.scenes);
    println!("{:<34}{}", "rows with a finding", total.invalid);
    println!("{:<34}{}", "without a state or digits", total.refused);
    for ((law, tolerance), (tests, largest)) in LAWS.iter().zip(total.laws) {
        println!("{law:<34}{tests} times, largest deviation {largest:.1e}, accepted {tolerance:.0e}");
    }
    println!("{:<34}{}", "faults", total.faults.len());
    if total.faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
