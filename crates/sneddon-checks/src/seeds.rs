//! How many cases a run examines, and one examination per seed on every core.

use std::sync::atomic::{AtomicU64, Ordering};

/// The number of cases of a test: `usual`, or `long` where the environment has `SNEDDON_LONG`, as under `just long`.
pub fn cases<T>(usual: T, long: T) -> T {
    if std::env::var_os("SNEDDON_LONG").is_some() { long } else { usual }
}

/// Returns whether this run examines case `number`: every case under `just long`, one in `every` otherwise.
pub fn takes(number: usize, every: usize) -> bool {
    number.is_multiple_of(cases(every, 1))
}

/// Returns the items that this run examines: all under `just long`, otherwise one in `every`, starting at an offset given by
/// `first`.
pub fn sample<T>(list: impl IntoIterator<Item = T>, first: usize, every: usize) -> impl Iterator<Item = T> {
    list.into_iter().enumerate().filter(move |(index, _)| takes(first + index, every)).map(|own| own.1)
}

/// COUNT and FIRST SEED of the command line, or `count` and 0.
pub fn asked(count: u64) -> (u64, u64) {
    let mut numbers = std::env::args().skip(1).map(|text| text.parse::<u64>());
    (numbers.next().and_then(Result::ok).unwrap_or(count), numbers.next().and_then(Result::ok).unwrap_or(0))
}

/// The sum of the results of `examine` for `count` seeds from `first` on.
pub fn over_seeds<T: Default + Send>((count, first): (u64, u64), examine: impl Fn(u64) -> T + Sync, add: fn(&mut T, T)) -> T {
    let (next, threads) = (AtomicU64::new(first), std::thread::available_parallelism().map_or(1, usize::from));
    let run = || {
        let mut total = T::default();
        loop {
            let seed = next.fetch_add(1, Ordering::Relaxed);
            if seed >= first + count {
                return total;
            }
            add(&mut total, examine(seed));
        }
    };
    let mut total = T::default();
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(run)).collect();
        for worker in workers {
            add(&mut total, worker.join().expect("a worker stopped"));
        }
    });
    total
}
