//! The long run over random profiles: `cargo run --release -p sneddon-runs --bin random_profiles -- [COUNT] [FIRST SEED]`.
//!
//! Every formula with a closed part is compared with quadrature of the profile as typed; disagreements are printed and
//! make the run fail. `docs/accuracy.md` contains the figures of a run over 10⁵ profiles.

use sneddon_checks::profiles::{Outcome, compare, sample};
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::{asked, over_seeds};
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    let run = |seed| {
        let mut stream = Stream::new(seed);
        let profile = sample(&mut stream);
        let begin = Instant::now();
        let own = compare(&profile, &mut stream);
        for fault in &own.faults {
            println!("seed {seed}: {fault}");
        }
        if begin.elapsed().as_secs() >= 5 {
            println!("seed {seed}: {:.0} s for {profile:?}", begin.elapsed().as_secs_f64());
        }
        own
    };
    let total = over_seeds(asked(10_000), run, Outcome::add);
    println!("profiles                      {}", total.profiles);
    println!("refused with a reason         {}", total.refused);
    println!("formulas exact                {}", total.exact);
    println!("formulas partial              {}", total.partial);
    println!("formulas numeric              {}", total.numeric);
    println!("numbers compared              {}", total.compared);
    println!("of these to 1e-8 or better    {}", total.sharp);
    println!("printed formulas read back    {}", total.printed);
    println!("disagreements                 {}", total.faults.len());
    if total.faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
