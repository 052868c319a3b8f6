//! The long run over estimates: `cargo run --release -p sneddon-runs --bin random_estimates -- [COUNT] [FIRST SEED]`.
//!
//! Numbers by quadrature at random tolerances, of random profiles at random points, are compared with closed forms; errors larger
//! than their estimates are printed and make the run fail. `docs/accuracy.md` contains the figures.

use sneddon_checks::estimates::{Honesty, examine};
use sneddon_checks::profiles::sample;
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::{asked, over_seeds};
use std::process::ExitCode;

fn main() -> ExitCode {
    let (count, first) = asked(5_000);
    let run = |seed| {
        let mut stream = Stream::new(seed);
        let own = examine(&sample(&mut stream), &mut stream);
        for fault in &own.faults {
            println!("seed {seed}: {fault}");
        }
        own
    };
    let total = over_seeds((count, first), run, Honesty::add);
    println!("profiles                                  {count}");
    println!("numbers judged                            {}", total.numbers);
    println!("of these within the tolerance             {}", total.met);
    println!("refused with a reason                     {}", total.refused);
    println!("closed form not sharp enough to judge     {}", total.undecided);
    println!("largest error over its estimate           {:.2}", total.largest);
    println!("errors larger than their estimate         {}", total.faults.len());
    if total.faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
