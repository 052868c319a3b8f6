//! Numbers by quadrature at random tolerances: never further from the truth than they claim.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use common::estimates::{Honesty, examine};
use common::profiles::sample;
use common::random::Stream;

/// A sample; the long run is `cargo run --release --example random_estimates`, and its figures stand in docs/accuracy.md.
const PROFILES: u64 = 200;

#[test]
fn no_estimate_is_below_the_true_error() {
    let mut total = Honesty::default();
    for seed in 0..PROFILES {
        let mut stream = Stream::new(2_000_000 + seed);
        let profile = sample(&mut stream);
        total.add(examine(&profile, &mut stream));
    }
    assert!(total.faults.is_empty(), "{}", total.faults.join("\n"));
    println!("{total:?}");
    assert!(total.numbers > 350 && total.undecided < 30, "{total:?}");
    // An estimate that is always huge would be honest and useless.
    assert!(total.met > total.numbers * 9 / 10, "{total:?}");
}
