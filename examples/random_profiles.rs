//! The long run over random profiles: `cargo run --release --example random_profiles -- [COUNT] [FIRST SEED]`.
//!
//! Every formula with a closed part is compared with quadrature of the profile as typed; what disagrees is printed, and
//! the run fails. The figures of a run over 10⁵ profiles stand in `docs/accuracy.md`.

#[path = "../tests/common/mod.rs"]
mod common;

use common::profiles::{Outcome, compare, sample};
use common::random::Stream;
use std::process::ExitCode;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

fn main() -> ExitCode {
    let mut numbers = std::env::args().skip(1).map(|text| text.parse::<u64>());
    let count = numbers.next().and_then(Result::ok).unwrap_or(10_000);
    let first = numbers.next().and_then(Result::ok).unwrap_or(0);
    let (next, threads) = (AtomicU64::new(first), std::thread::available_parallelism().map_or(1, usize::from));
    let run = || {
        let mut total = Outcome::default();
        loop {
            let seed = next.fetch_add(1, Ordering::Relaxed);
            if seed >= first + count {
                return total;
            }
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
            total.add(own);
        }
    };
    let mut total = Outcome::default();
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(run)).collect();
        for worker in workers {
            match worker.join() {
                Ok(own) => total.add(own),
                Err(_) => total.faults.push("a worker stopped".to_owned()),
            }
        }
    });
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
