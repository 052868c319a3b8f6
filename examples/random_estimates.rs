//! The long run over estimates: `cargo run --release --example random_estimates -- [COUNT] [FIRST SEED]`.
//!
//! Numbers by quadrature at random tolerances, of random profiles at random places, are compared with closed forms; what
//! is further from the truth than it claims is printed, and the run fails. The figures stand in `docs/accuracy.md`.

#[path = "../tests/common/mod.rs"]
mod common;

use common::estimates::{Honesty, examine};
use common::profiles::sample;
use common::random::Stream;
use std::process::ExitCode;
use std::sync::atomic::{AtomicU64, Ordering};

fn main() -> ExitCode {
    let mut numbers = std::env::args().skip(1).map(|text| text.parse::<u64>());
    let count = numbers.next().and_then(Result::ok).unwrap_or(5_000);
    let first = numbers.next().and_then(Result::ok).unwrap_or(0);
    let (next, threads) = (AtomicU64::new(first), std::thread::available_parallelism().map_or(1, usize::from));
    let run = || {
        let mut total = Honesty::default();
        loop {
            let seed = next.fetch_add(1, Ordering::Relaxed);
            if seed >= first + count {
                return total;
            }
            let mut stream = Stream::new(seed);
            let own = examine(&sample(&mut stream), &mut stream);
            for fault in &own.faults {
                println!("seed {seed}: {fault}");
            }
            total.add(own);
        }
    };
    let mut total = Honesty::default();
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(run)).collect();
        for worker in workers {
            match worker.join() {
                Ok(own) => total.add(own),
                Err(_) => total.faults.push("a worker stopped".to_owned()),
            }
        }
    });
    println!("profiles                                  {count}");
    println!("numbers judged                            {}", total.numbers);
    println!("of these within the tolerance             {}", total.met);
    println!("refused with a reason                     {}", total.refused);
    println!("closed form not sharp enough to judge     {}", total.undecided);
    println!("largest error over its estimate           {:.2}", total.largest);
    println!("errors larger than their estimate         {}", total.faults.len());
    if total.faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
