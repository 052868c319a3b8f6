//! Numbers by quadrature at random tolerances: never further from the truth than they claim.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sneddon_checks::estimates::{Honesty, examine};
use sneddon_checks::profiles::sample;
use sneddon_checks::random::Stream;
use sneddon_checks::seeds::cases;

/// A sample; the long run is `cargo run --release -p sneddon-runs --bin random_estimates`, and its figures stand in docs/accuracy.md.
const PROFILES: u64 = 200;

#[test]
fn no_estimate_is_below_the_true_error() {
    let mut total = Honesty::default();
    for seed in 0..cases(PROFILES / 3, PROFILES) {
        let mut stream = Stream::new(2_000_000 + seed);
        let profile = sample(&mut stream);
        total.add(examine(&profile, &mut stream));
    }
    assert!(total.faults.is_empty(), "{}", total.faults.join("\n"));
    println!("{total:?}");
    assert!(total.numbers > cases(110, 350) && total.undecided < cases(4, 30), "{total:?}");
    // An estimate that is always huge would be honest and useless.
    assert!(total.met > total.numbers * 9 / 10, "{total:?}");
}
