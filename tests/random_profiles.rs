//! Random profiles over the whole grammar: no closed form is ever wrong.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use common::profiles::{Outcome, compare, sample};
use common::random::Stream;

/// A sample; the long run is `cargo run --release --example random_profiles`, and its figures stand in docs/accuracy.md.
const PROFILES: u64 = 300;

#[test]
fn closed_forms_are_never_wrong() {
    let mut total = Outcome::default();
    for seed in 0..PROFILES {
        let mut stream = Stream::new(1_000_000 + seed);
        let profile = sample(&mut stream);
        total.add(compare(&profile, &mut stream));
    }
    assert!(total.faults.is_empty(), "{}", total.faults.join("\n"));
    println!("{total:?}");
    assert!(total.refused < total.profiles / 4, "{total:?}");
    assert!(total.sharp > 300 && total.printed > 100, "{total:?}");
}
